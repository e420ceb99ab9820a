"""Run manifest: inputs with hashes, options and metrics of a command, to repeat it."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import msgspec

from procc_annotator.batch.frame_sums import ClickNoise
from procc_annotator.errors import InputError
from procc_annotator.field.load import field_fingerprint
from procc_annotator.field.model import Field
from procc_annotator.formats.file_source import read_file
from procc_annotator.formats.strict_json import decode_as
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.metrics.statistics.bootstrap import BootstrapSettings
from procc_annotator.report.scores.inference import InferenceSettings, StatisticalResult
from procc_annotator.report.tables.data_files import json_bytes, metric_entry
from procc_annotator.report.tables.metrics import OF_SET
from procc_annotator.report.tables.table import MetricTable, records, shortest_number
from procc_annotator.report.temporal import TemporalMetrics, shots_over_time_table
from procc_annotator.version import __version__

SAME = 1e-12  # of a figure: the last digit that is written
Rows = list[dict[str, Any]]


@dataclass(frozen=True)
class ManifestInference:
    """What was asked of chance, and what it said.

    Attributes:
        cluster, by, method, draws, power, noise: as of `InferenceSettings`.
        tags, shots: paths of inputs, where such files were given.
        told: for each set and size, sheet -> its rows.
    """

    cluster: str | None
    by: tuple[str, ...]
    method: str
    draws: BootstrapSettings
    power: bool
    noise: ClickNoise | None
    tags: str | None
    shots: str | None
    told: list[dict[str, Rows]]


@dataclass(frozen=True)
class ManifestTemporal:
    """What was asked over the shots of the sets, and the figures of each shot.

    Attributes:
        threshold: px.
        shots: path of an input, where a table of frames was given.
        pictures: folder or video that cuts were found in, relative as inputs are.
    """

    threshold: float
    shots: str | None
    pictures: str | None
    rows: Rows


def manifest_inference(
    terms: InferenceSettings, told: Sequence[StatisticalResult], tags: str | None, shots: str | None
) -> ManifestInference:
    """What a recipe holds of chance; tags, shots: paths of inputs."""
    return ManifestInference(
        terms.cluster, terms.by, terms.method, terms.draws, terms.power, terms.noise, tags, shots,
        inference_rows(told),
    )  # fmt: skip


def inference_rows(told: Sequence[StatisticalResult]) -> list[dict[str, Rows]]:
    """The rows of every sheet, for each set and size."""
    return [{sheet.name: _rows(sheet) for sheet in one.sheets} for one in told]


def over_time_rows(found: Sequence[TemporalMetrics]) -> Rows:
    """The figures of every shot."""
    return _rows(shots_over_time_table(found))


def differing_inference(was: ManifestInference, told: Sequence[StatisticalResult]) -> Iterator[str]:
    """Which figures are others, one line each."""
    now = inference_rows(told)
    for at, sheets in enumerate(was.told):
        here = now[at] if at < len(now) else {}
        of = f"set {at + 1}, " if len(was.told) > 1 else ""
        for name, rows in sheets.items():
            yield from _differing_rows(f"{of}{name}", rows, here.get(name, []))


def differing_over_time(was: ManifestTemporal, found: Sequence[TemporalMetrics]) -> Iterator[str]:
    """Which figures of which shot are others, one line each."""
    yield from _differing_rows("over time", was.rows, over_time_rows(found))


def _rows(sheet: MetricTable) -> Rows:
    # As JSON has them: what is undefined is null.
    return [
        {key: None if value != value else value for key, value in row.items()}
        for row in records(sheet)
    ]


def _differing_rows(of: str, was: Rows, now: Rows) -> Iterator[str]:
    if len(was) != len(now):
        yield f"other figures: {of}: {len(now)} rows, were {len(was)}"
        return
    for number, (before, after) in enumerate(zip(was, now, strict=True), 1):
        for key, value in before.items():
            here = after.get(key)
            if not same_value(value, here):
                yield f"other figure: {of}, {_named(before, number)}: {key} {here}, was {value}"


def _named(row: Mapping[str, Any], number: int) -> str:
    """A row by its words, or else by its number."""
    words = [value for value in row.values() if isinstance(value, str) and len(value) < 40]
    tau = row.get("threshold")
    return (" ".join(words[:3]) or f"row {number}") + (f"@{tau:g}" if tau is not None else "")


def same_value(before: Any, after: Any) -> bool:
    """Whether two values are the same to the last digit that is written."""
    numbers = all(isinstance(v, int | float) and type(v) is not bool for v in (before, after))
    if not numbers:
        return bool(before == after)
    return bool(abs(before - after) <= SAME * max(1.0, abs(before)))


FORMAT = "procc-annotator recipe 1"
_COUNTS = ("images", "evaluated")

CITATION = {
    "protocol": (
        "@inproceedings{magera2024procc,\n"
        "  title = {A Universal Protocol to Benchmark Camera Calibration for Sports},\n"
        "  author = {Magera, Floriane and Hoyoux, Thomas and Barnich, Olivier and"
        " Van Droogenbroeck, Marc},\n"
        "  booktitle = {CVSports at CVPR},\n  year = {2024}\n}"
    ),
    "program": (
        "@software{procc_annotator,\n  title = {ProCC Annotator},\n"
        "  author = {{The ProCC Annotator authors}},\n"
        f"  version = {{{__version__}}}\n}}"
    ),
}


@dataclass(frozen=True)
class ManifestFile:
    """A file that was read: its name within the input, and what was in it."""

    name: str
    sha256: str
    bytes: int


@dataclass(frozen=True)
class ManifestInput:
    """A folder, archive or file that was read.

    Attributes:
        role: ``annotations``, ``cameras``, ``field``, ``tags``, ``labels`` (names of others),
            ``stadiums``, ``landmarks``, ``views`` or ``click noise`` (what `agree` measured).
        path: relative to the folder of all inputs.
        files: what was read of a folder, by name; of an archive or file itself, called ``.``.
    """

    role: str
    path: str
    files: tuple[ManifestFile, ...]


@dataclass(frozen=True)
class ManifestField:
    """The elements that were evaluated.

    Attributes:
        given: what was asked for by name or file (relative as other paths); None for the set's own.
        lines: where lines lie, if that was asked for.
        described: name and dimensions, for people.
        sha256: see `field.load`.
        name, dimensions, at: of a set's own field its name, its metres by name, and where its lines
            lie: what a workspace keeps stays behind where a folder is handed on.
    """

    given: str | None
    lines: str | None
    described: str
    sha256: str
    name: str = ""
    dimensions: dict[str, float] = field(default_factory=dict)
    at: str = ""


@dataclass(frozen=True)
class ManifestEvaluation:
    """One set under one source at one size, and its figures by threshold.

    Attributes:
        annotations, cameras: paths of inputs.
        camera_size, unsized: see `fit_to_size`.
        picture_sizes: ``1920x1080`` -> how many pictures beside the annotations have it.
    """

    set: str
    source: str
    annotations: str
    cameras: str
    format: str
    field: ManifestField
    size: tuple[int, int]
    protocol: str
    off_plane: str
    mirrored: bool
    planar_only: bool
    thresholds: tuple[float, ...]
    camera_size: tuple[int, int] | None
    unsized: tuple[int, int] | None
    picture_sizes: dict[str, int]
    figures: dict[str, dict[str, float | int | None]]

    @property
    def named(self) -> str:
        """For people: ``wc14, pnlcalib, 960x540``."""
        return f"{self.set}, {self.source}, {self.size[0]}x{self.size[1]}"


@dataclass(frozen=True)
class RunManifest:
    """Everything.

    Attributes:
        options: what was typed, without paths of the machine: seeds, tags, choices of pictures.
        chance, over_time: figures besides those of each set, where they were asked for.
        citation: BibTeX of the protocol's paper and of the program.
    """

    format: str
    version: str
    command: str
    options: dict[str, Any]
    inputs: tuple[ManifestInput, ...]
    evaluations: tuple[ManifestEvaluation, ...]
    chance: ManifestInference | None = None
    over_time: ManifestTemporal | None = None
    citation: dict[str, str] = field(default_factory=lambda: dict(CITATION))

    def encoded(self) -> bytes:
        """As a file."""
        return json_bytes(msgspec.to_builtins(self))


def read_manifest(path: Path) -> RunManifest:
    """Read a recipe.

    Raises:
        InputError: it cannot be read, or is none.
    """
    found = decode_as(read_file(path), RunManifest, "recipe", path=path)
    if found.format != FORMAT:
        raise InputError(path, f"is of format {found.format[:60]!r}, expected {FORMAT!r}")
    return found


def set_figures(
    summaries: Mapping[float, SetSummary],
) -> dict[str, dict[str, float | int | None]]:
    """The figures of a set by threshold, with how many frames there are and were evaluated."""
    return {
        shortest_number(tau): {
            **{count: getattr(summary, count) for count in _COUNTS},
            **metric_entry(OF_SET, summary),
        }
        for tau, summary in summaries.items()
    }


def manifest_field(shown: Field, given: str | None, lines: str | None) -> ManifestField:
    """What identifies a field: names and places of all that is evaluated."""
    own = {d.name: d.value for d in shown.dimensions if d.value != d.nominal}
    sha256 = field_fingerprint(shown)
    return ManifestField(given, lines, shown.described, sha256, shown.name, own, shown.lines)


def setup_of(evaluation: ManifestEvaluation, shown: Field) -> EvaluationSetup:
    """What an evaluation was made with, on a field.

    Raises:
        UsageError: a choice that there is not.
    """
    return EvaluationSetup(
        shown, evaluation.size, evaluation.protocol, evaluation.mirrored, evaluation.off_plane,
        evaluation.planar_only, evaluation.unsized,
    )  # fmt: skip


# --- what differs ---------------------------------------------------------------------------------


def differing_files(recipe: ManifestInput, here: ManifestInput) -> Iterator[str]:
    """What is missing, more or another one among the files of an input, one line each."""
    was = {file.name: file.sha256 for file in recipe.files}
    now = {file.name: file.sha256 for file in here.files}
    for name in {**was, **now}:
        shown = recipe.path if name == "." else f"{recipe.path}/{name}"
        if name not in now:
            yield f"missing: {shown}"
        elif name not in was:
            yield f"not in the recipe: {shown}"
        elif was[name] != now[name]:
            yield f"other content: {shown}"


def differing_figures(was: ManifestEvaluation, now: ManifestEvaluation) -> Iterator[str]:
    """Which figures are others, one line each."""
    if was.field.sha256 != now.field.sha256:
        yield f"other field: {was.named}: {now.field.described}, was {was.field.described}"
    if was.picture_sizes and now.picture_sizes and was.picture_sizes != now.picture_sizes:
        sizes = [", ".join(found.picture_sizes) for found in (now, was)]
        yield f"other picture sizes: {was.named}: {sizes[0]}, were {sizes[1]}"
    for tau, figures in was.figures.items():
        for key, before in figures.items():
            after = now.figures.get(tau, {}).get(key)
            if not same_value(before, after):
                of = f"{was.named}: {key}@{tau}"
                yield f"other figure: {of}: {_shown(after)}, was {_shown(before)}"


def _shown(value: float | None) -> str:
    return "none" if value is None else f"{value:.10g}"


def sha256_of(data: bytes) -> str:
    """In hexadecimal."""
    return hashlib.sha256(data).hexdigest()


def hashed(name: str, data: bytes) -> ManifestFile:
    """A file by its content."""
    return ManifestFile(name, sha256_of(data), len(data))
