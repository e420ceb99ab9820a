"""Score files as JSON and CSV, written frame by frame."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import IO, Any

from procc_annotator.batch.evaluation import GroupSummary
from procc_annotator.batch.scoring import FrameResult
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.fit_record import FRAME_KEYS
from procc_annotator.metrics.measurement import Labelling
from procc_annotator.metrics.score import FrameScore, Status
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.data_files import csv_header, csv_rows, encoded, metric_entry
from procc_annotator.report.tables.table import (
    TAU,
    Column,
    Row,
    Value,
    count_column,
    metric_column,
    metric_values,
    shortest_number,
)


def field_terms(field: Field) -> dict[str, Any]:
    """``field`` in words for people; ``field_name``, ``field_dimensions`` (metres, by name) and
    ``field_lines`` (``measured`` or ``middle``) for programs, which need not take the words apart;
    ``field_file`` where a file of the user's own describes another field than the shipped one of
    its name; ``field_stadiums`` (stadium -> its own dimensions) where frames have such.
    """
    own: dict[str, Any] = {"field_file": field.own_file} if field.own_file else {}
    if field.stadiums is not None:
        own["field_stadiums"] = {s: dict(v) for s, v in field.stadiums.dimensions.items()}
    return {
        "field": field.described,
        "field_name": field.name,
        **own,
        "field_dimensions": {d.name: d.value for d in field.dimensions},
        "field_lines": field.lines,
    }


COUNTS = (metrics.TP, metrics.FP, metrics.FN)

FRAME_COLUMNS = (
    metric_column(metrics.JAC),
    *(count_column(count.key) for count in COUNTS),
    Column("mirrored", kind="yes_no"),
    *map(metric_column, metrics.OF_FRAME),
)

# Whether the camera was fitted to the annotation it is judged by, or to another version of it.
FITTED_COLUMNS = (
    *(Column(key, kind="yes_no") for key in FRAME_KEYS[:2]),
    Column(FRAME_KEYS[2], kind="number", written=".4f"),
)


def frame_values(score: FrameScore | None) -> tuple[Value, ...]:
    """A frame's figures at a threshold, a value for each of `FRAME_COLUMNS`."""
    if score is None:
        return (None,) * len(FRAME_COLUMNS)
    return (
        *metric_values((metrics.JAC, *COUNTS), score),
        score.mirrored,
        *metric_values(metrics.OF_FRAME, score),
    )


_COLUMNS = (
    Column("name"),
    Column("protocol"),
    Column("options"),
    count_column("width"),
    count_column("height"),
    TAU,
    *FRAME_COLUMNS,
    Column("camera"),
    Column("error"),
    *FITTED_COLUMNS,
    Column("model"),
    *map(metric_column, metrics.OF_ANNOTATION),
)


def csv_columns(names: Iterable[str] = (), by: Iterable[str] = ()) -> tuple[Column, ...]:
    """The columns of a file of scores: first names, e.g. set and method, last what the set is
    grouped by."""
    return (*map(Column, names), *_COLUMNS, *(Column(f"by_{name}") for name in by))


def csv_fragment(
    result: FrameResult,
    setup: EvaluationSetup,
    thresholds: tuple[float, ...],
    names: Sequence[str] = (),
) -> bytes:
    """One row a threshold; figures of a frame without scores are empty. The names of set and method
    come first, where several evaluations share a file."""
    columns = csv_columns(names, map(str, range(len(result.groups))))
    return csv_rows(
        columns, ((*names, *_row(result, setup, tau), *result.groups) for tau in thresholds)
    )


def _row(result: FrameResult, setup: EvaluationSetup, threshold: float) -> Row:
    chosen = [f"off-plane {setup.off_plane}"] if result.ground_only else []
    if setup.planar_only:
        chosen = ["planar elements only"]
    if setup.protocol == "procc" and setup.allow_mirrored:
        chosen.append("mirrored labels allowed")
    score = result.scores.get(threshold)
    camera, error = result.camera, result.error
    if score is None:
        camera, error = None, error or "no camera"
    terms = (setup.protocol, "; ".join(chosen), *setup.size)
    more = (
        *result.fitted.of_frame,
        result.model or None,
        *metric_values(metrics.OF_ANNOTATION, result.clicked),
    )
    return (result.name, *terms, threshold, *frame_values(score), camera, error, *more)


class CsvScores:
    """A header, none if ``headless`` (after another evaluation), then one row an image and
    threshold, with the columns of `csv_columns`."""

    def __init__(
        self,
        stream: IO[bytes],
        names: Iterable[str] = (),
        by: Iterable[str] = (),
        *,
        headless: bool = False,
    ) -> None:
        self._stream = stream
        self._header = b"" if headless else csv_header(csv_columns(names, by))

    def begin(self) -> None:
        self._stream.write(self._header)

    def add(self, fragment: bytes) -> None:
        self._stream.write(fragment)

    def end(self, *_summary: object, **_more: object) -> None:
        """Nothing: a set's figures have no row of their own."""


SCORE_SUFFIXES = (".json", ".csv")


# ---------------------------------------------------------------------------------------- JSON


def json_fragment(result: FrameResult, by: Sequence[str] = ()) -> bytes:
    """One entry of ``images``, with the values that the set is grouped ``by`` as ``groups``.
    Undefined figures are null; NaN never reaches a file."""
    known: dict[int, _Elements] = {}  # by labelling, of which a frame has two at most
    entries = {}
    for threshold, score in result.scores.items():
        key = id(score.labelling)
        if key not in known:
            known[key] = _Elements(score.labelling)
        entries[shortest_number(threshold)] = frame_entry(score) | {
            "elements": known[key].entries(threshold)
        }
    image: dict[str, Any] = {"name": result.name, "camera": result.camera, "error": result.error}
    image["model"] = result.model or None
    if result.clicked is not None:
        image |= metric_entry(metrics.OF_ANNOTATION, result.clicked)
    image["results"] = entries
    image |= result.fitted.entry(frame=True)
    if by:
        image["groups"] = dict(zip(by, result.groups, strict=True))
    return encoded(image)


def frame_entry(score: Any) -> dict[str, Any]:
    """The figures of a `FrameScore`, or of whatever has them."""
    counts = metric_entry((*COUNTS, metrics.JAC), score)
    mirrored = {"mirrored": score.mirrored}
    return counts | mirrored | metric_entry(metrics.OF_FRAME, score)


class _Elements:
    """The elements of one labelling, which differ between thresholds by their status only.

    The same as ``FrameScore.elements``, straight from the arrays: a large set spends its time here.
    """

    def __init__(self, labelling: Labelling) -> None:
        flat = labelling.all_distances.tolist()
        self._judged: list[tuple[str, float, list[float]]] = []
        self._others: dict[str, dict[str, Any]] = {}
        end = 0
        for name, count, projected in zip(
            labelling.names, labelling.point_counts, labelling.projected, strict=True
        ):
            if projected:
                begin, end = end, end + count
                distances = flat[begin:end]
                self._judged.append((name, _largest(distances), distances))
            else:
                self._others[name] = _without_distances("missed")
        for name in labelling.not_annotated:
            self._others[name] = _without_distances("not_annotated")

    def entries(self, threshold: float) -> dict[str, Any]:
        entries: dict[str, Any] = {
            name: {
                "status": "tp" if largest < threshold else "too_far",
                "max_distance": largest,
                "distances": distances,
            }
            for name, largest, distances in self._judged
        }
        entries.update(self._others)
        return entries


def _largest(distances: list[float]) -> float:
    # NaN (encoded as null) wins wherever it stands, as in the official evaluation; max() alone
    # would find it only in front.
    largest = max(distances)
    return largest if math.isfinite(sum(distances)) else math.nan


def _without_distances(status: Status) -> dict[str, Any]:
    return {"status": status, "max_distance": None, "distances": []}


def summary_entry(summary: SetSummary) -> dict[str, Any]:
    """A set's figures at one threshold, as ``out.json`` holds them."""
    per_class = {
        name: metric_entry(metrics.OF_CLASS, figures) for name, figures in summary.per_class.items()
    }
    return metric_entry(metrics.OF_SET, summary) | {"per_class": per_class}


class JsonScores:
    """``{"protocol", "field", "size", "thresholds", "images": [...], "summary": {...}}``.

    The field is given by `field_terms`.

    Where several evaluations share a file, each begins with its ``names``: set and method.

    Options without which the numbers mean nothing follow, only where they count: ``"off_plane"``
    for cameras that know only the ground, ``"planar_only"`` where elements off it took no part,
    ``"mirrored_labels"`` where ``procc`` allowed them.
    """

    def __init__(
        self,
        stream: IO[bytes],
        setup: EvaluationSetup,
        thresholds: Iterable[float],
        names: Mapping[str, str] | None = None,
    ) -> None:
        self._stream = stream
        self._setup = setup
        self._names = names or {}
        self._thresholds = list(thresholds)
        self._separator = b"\n"

    def begin(self) -> None:
        head = encoded(
            {
                **self._names,
                "protocol": self._setup.protocol,
                **field_terms(self._setup.field),
                "size": list(self._setup.size),
                "thresholds": self._thresholds,
            }
        )
        self._stream.write(head[:-1] + b',"images":[')

    def add(self, fragment: bytes) -> None:
        self._stream.write(self._separator)
        self._stream.write(fragment)
        self._separator = b",\n"

    def end(
        self,
        summary: Mapping[float, SetSummary] | None,
        *,
        ground_only: bool,
        groups: Sequence[GroupSummary] = (),
        more: Mapping[str, Any] | None = None,
    ) -> None:
        entries = None
        if summary is not None:
            entries = _summary_entries(summary)
        self._stream.write(b'\n],"summary":' + encoded(entries))
        if self._setup.planar_only:
            self._stream.write(b',"planar_only":true')
        elif ground_only:
            self._stream.write(b',"off_plane":' + encoded(self._setup.off_plane))
        if self._setup.protocol == "procc" and self._setup.allow_mirrored:
            self._stream.write(b',"mirrored_labels":true')
        if groups:
            self._stream.write(b',"groups":' + encoded(_group_entries(groups)))
        self._stream.write(_more(more) + b"}\n")


class JsonList:
    """``{"evaluations": [...]}``: several evaluations in one file, each as `JsonScores` has it."""

    def __init__(self, stream: IO[bytes]) -> None:
        self._stream = stream
        self._separator = b'{"evaluations":[\n'

    def next(self) -> None:
        """Another evaluation follows."""
        self._stream.write(self._separator)
        self._separator = b","

    def end(self, more: Mapping[str, Any] | None = None) -> None:
        """That was all, but for what is reported of the evaluations together."""
        self._stream.write(b"]" + _more(more) + b"}\n")


def _more(entries: Mapping[str, Any] | None) -> bytes:
    return b"," + encoded(entries)[1:-1] if entries else b""


def _summary_entries(summaries: Mapping[float, SetSummary]) -> dict[str, Any]:
    return {shortest_number(t): summary_entry(s) for t, s in summaries.items()}


def _group_entries(groups: Sequence[GroupSummary]) -> list[dict[str, Any]]:
    entries = []
    for group in groups:
        first = next(iter(group.summaries.values()))
        entries.append(
            {
                "by": group.by,
                "value": group.value,
                "images": first.images,
                "evaluated": first.evaluated,
                "summary": _summary_entries(group.summaries),
            }
        )
    return entries


# ----------------------------------------------------------------------------------------- files


def score_format(path: Path) -> str:
    """``json`` or ``csv``, by suffix. `UsageError` for another suffix."""
    suffix = path.suffix.lower()
    if suffix not in SCORE_SUFFIXES:
        raise UsageError(f"{path}: scores are written as .json or .csv, end the name so")
    return suffix[1:]
