"""Run manifests: options, versions, hashes of inputs and metrics of a run, for `repeat`."""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Any

import cv2
import numpy as np
import typer

from procc_annotator.cli import outputs
from procc_annotator.cli.inference_options import noise_file
from procc_annotator.dataset import layout as folders
from procc_annotator.errors import InputError
from procc_annotator.field.load import field_fingerprint, named_field
from procc_annotator.formats.annotations.label_map import LABELS_FILE
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import read_file
from procc_annotator.formats.landmark_file import LANDMARKS_FILE
from procc_annotator.formats.strict_json import decode_as
from procc_annotator.report.scores.scoring import EvaluationRequest
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
    """Read a manifest; InputError if it cannot be read, or is none."""
    data = read_file(path)
    kind = decode_as(data, dict[str, Any], "manifest", path=path).get("format")
    if kind != FORMAT:
        older = isinstance(kind, str) and kind.startswith("procc-annotator")
        raise InputError(
            path,
            f"is not a manifest (format {FORMAT!r})",
            advice="run its command again with --manifest" if older else "--manifest writes one",
        )
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


# Options that write files or say who does the work: no part of what is repeated.
DROPPED = frozenset({"output", "over_time_output", "manifest", "workers", "dask"})
_OF_DATASET = (
    folders.FIELD_FILE, folders.FRAMES_FILE, folders.STADIUMS_FILE, folders.VIEWS_FILE,
    LABELS_FILE, LANDMARKS_FILE,
)  # fmt: skip

ManifestFile = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE.json",
        help="Write options, versions, the SHA-256 of every input file and the metrics, so that"
        " `procc-annotator repeat` can run it again and compare.",
    ),
]


@dataclass(frozen=True)
class ManifestOfRun:
    """The manifest of a run in progress; the command writes its metrics to a temporary file."""

    path: Path
    context: typer.Context
    metrics: Path

    @classmethod
    def of(cls, context: typer.Context, path: Path | None) -> ManifestOfRun | None:
        """Prepare the file that was asked for, if one was; UsageError or SaveError if it cannot be
        written there."""
        if path is None:
            return None
        outputs.check_output_folder(path)
        folder = context.with_resource(TemporaryDirectory(prefix="procc-manifest-"))
        return cls(path, context, Path(folder) / "metrics.json")

    def write(
        self, runs: Sequence[EvaluationRequest], over_time: Mapping[str, Any] | None = None
    ) -> None:
        """Write the file, with metrics that the temporary file does not hold; the inputs are still
        open. InputError if the metrics were not written, SaveError if the manifest cannot be."""
        metrics = decode_as(read_file(self.metrics), dict[str, Any], "metrics", path=self.path)
        if over_time:
            own = json_bytes(over_time)
            metrics["over_time"] = decode_as(own, dict[str, Any], "metrics", path=self.path)
        files = [*self._named_files(), *(path for one in runs for path in _files(one))]
        root = self.context.obj or Path(os.path.commonpath([file.parent for file in files]))
        manifest = Manifest(
            command=str(self.context.info_name),
            options=self._options(root),
            inputs=hashes(files, root),
            fields={one.set_name: field_fingerprint(one.setup.field) for one in runs},
            metrics=of_sets(metrics),
        )
        write_atomic(self.path, manifest.encoded())

    def _typed(self) -> Iterator[tuple[str, Any]]:
        for parameter in self.context.command.params:
            name = str(parameter.name)
            source = self.context.get_parameter_source(name)
            if source is not None and source.name == "COMMANDLINE" and name not in DROPPED:
                value = self.context.params[name]
                yield name, Path(value) if parameter.type.name == "path" else value

    def _named_files(self) -> Iterator[Path]:
        paths = (_path_in(name, value) for name, value in self._typed())
        yield from (path.absolute() for path in paths if path is not None and path.is_file())

    def _options(self, root: Path) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for name, value in self._typed():
            if name in ("sources", "cameras", "sets") and isinstance(value, list | tuple):
                parts = [re.fullmatch("([^=]*=)?(.*)", one, re.DOTALL) for one in value]
                found[name] = [f"{m[1] or ''}{relative(Path(m[2]), root)}" for m in parts if m]
            elif (path := _path_in(name, value)) is not None:
                found[name] = str(value).replace(str(path), relative(path, root), 1)
            else:
                found[name] = value
        return found


def _path_in(name: str, value: Any) -> Path | None:
    if isinstance(value, Path):
        return value
    if name == "field":
        file = Path(named_field(value)[0])
        return file if file.is_file() else None
    return noise_file(value) if name == "click_noise" else None


def _files(one: EvaluationRequest) -> Iterator[Path]:
    place, cameras = one.annotations.path.absolute(), one.cameras.path.absolute()
    if place.is_dir():
        names = one.annotations.decoded or list_annotations(one.annotations).values()
        yield from (place / name for name in names)
    else:
        yield place
    if cameras.is_dir():
        yield from (Path(file).absolute() for file in one.cameras.files())
        yield from (cameras / name for name in one.cameras.beside())
    else:
        yield cameras
    if (dataset := folders.folder_of_dataset(place)) is not None:
        yield from (path for name in _OF_DATASET if (path := dataset / name).is_file())
