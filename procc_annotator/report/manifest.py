"""Run manifests: options, versions, hashes of inputs, and the metrics that came out."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from procc_annotator.errors import InputError
from procc_annotator.formats.file_source import read_file
from procc_annotator.formats.strict_json import decode_as
from procc_annotator.report.tables.data_files import json_bytes
from procc_annotator.version import __version__

FORMAT = "procc-annotator manifest 1"
_TOLERANCE = 1e-12  # relative: the last digit of a metric that is written
# Names of folders differ elsewhere, and notes and failures hold paths of the machine.
_LEFT_OUT = frozenset({"set", "dataset", "folder", "failures", "notes"})


def _versions() -> dict[str, str]:
    return {"procc-annotator": __version__, "numpy": np.__version__, "opencv": cv2.__version__}


@dataclass(frozen=True, kw_only=True)
class Manifest:
    """A run: enough to run it again and to compare its metrics.

    Attributes:
        options: by parameter name, as typed; paths are relative to the folder of all inputs.
        inputs: relative path -> SHA-256 and size in bytes.
        fields: set -> SHA-256 of the elements of its field, see `field.load`.
        metrics: what the command writes as JSON, without single frames.
    """

    format: str = FORMAT
    command: str
    options: dict[str, Any]
    versions: dict[str, str] = field(default_factory=_versions)
    inputs: dict[str, tuple[str, int]]
    fields: dict[str, str]
    metrics: dict[str, Any]

    def encoded(self) -> bytes:
        """Return the content of the file."""
        return json_bytes(self)


def read_manifest(path: Path) -> Manifest:
    """Read a manifest.

    Raises:
        InputError: it cannot be read, or is none.
    """
    data = read_file(path)
    kind = decode_as(data, dict[str, Any], "manifest", path=path).get("format")
    if kind != FORMAT:
        expected = f"expected {FORMAT!r}: run its command again with --manifest"
        raise InputError(path, f"is of format {str(kind)[:60]!r}, {expected}")
    return decode_as(data, Manifest, "manifest", path=path)


def hashes(files: Iterable[Path], root: Path) -> dict[str, tuple[str, int]]:
    """Return SHA-256 and size of files by their path below a folder; unreadable ones have none."""
    found = {}
    for path in sorted(set(files)):
        try:
            data = path.read_bytes()
        except OSError:  # the command lists it
            continue
        found[relative(path, root)] = (hashlib.sha256(data).hexdigest(), len(data))
    return found


def relative(path: Path, root: Path) -> str:
    """Return a path relative to a folder, with forward slashes."""
    return Path(os.path.relpath(path.absolute(), root)).as_posix()


def of_sets(metrics: Any) -> Any:
    """Return metrics without the entries of single frames and without names of folders."""
    if isinstance(metrics, list):
        return [of_sets(one) for one in metrics]
    if not isinstance(metrics, dict):
        return metrics
    return {
        key: of_sets(value)
        for key, value in metrics.items()
        if key not in _LEFT_OUT and not (key == "images" and isinstance(value, list))
    }


def differences(was: Manifest, now: Manifest) -> Iterator[str]:
    """Compare two runs, one line for each difference."""
    for name, version in now.versions.items():
        if version != (before := was.versions.get(name)):
            yield f"other version: {name} {version}, was {before}"
    for path in {**was.inputs, **now.inputs}:
        if path not in now.inputs:
            yield f"missing: {path}"
        elif path not in was.inputs:
            yield f"not in the manifest: {path}"
        elif was.inputs[path] != now.inputs[path]:
            yield f"other content: {path}"
    # By order: sets may be called after their folder.
    for (name, before), own in zip(was.fields.items(), now.fields.values(), strict=False):
        if before != own:
            yield f"other field: {name}"
    yield from _other_metrics("", was.metrics, now.metrics)


def _other_metrics(place: str, was: Any, now: Any) -> Iterator[str]:
    if isinstance(was, dict) and isinstance(now, dict):
        for key in {**was, **now}:
            yield from _other_metrics(f"{place} {key}", was.get(key), now.get(key))
    elif isinstance(was, list) and isinstance(now, list) and len(was) == len(now):
        for number, (one, other) in enumerate(zip(was, now, strict=True), 1):
            yield from _other_metrics(f"{place} {_name(one) or number}", one, other)
    elif not _same(was, now):
        shown = [f"{len(v)} entries" if isinstance(v, dict | list) else str(v) for v in (now, was)]
        yield f"other metric:{place}: {shown[0]}, was {shown[1]}"


def _name(row: Any) -> str:
    """Name a row of a table by its first words and its threshold."""
    if not isinstance(row, dict):
        return ""
    words = [value for value in row.values() if isinstance(value, str) and len(value) < 40]
    return " ".join(words[:3]) + (f"@{row['threshold']}" if "threshold" in row else "")


def _same(was: Any, now: Any) -> bool:
    if isinstance(was, float | int) and isinstance(now, float | int):
        return abs(was - now) <= _TOLERANCE * max(1.0, abs(was))
    return bool(was == now)
