"""Scores as files, written frame by frame, in place only when complete; here as JSON.

A frame is encoded where it was scored (`json_fragment`, `score_csv.csv_fragment`: bytes that travel
cheaply between processes); a `ScoreWriter` strings the fragments together.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import IO, Any, Protocol

from procc_annotator.errors import UsageError
from procc_annotator.metric.measure import Labelling
from procc_annotator.metric.score import Status
from procc_annotator.metric.sets import SetSummary
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report.field_terms import field_terms
from procc_annotator.report.scores.score_columns import COUNTS
from procc_annotator.report.sheet.as_json import encoded, metric_entry
from procc_annotator.report.sheet.figure import shortest_number
from procc_annotator.report.sheet.figures import JAC, OF_ANNOTATION, OF_CLASS, OF_FRAME, OF_SET
from procc_annotator.session.runs.evaluation_run import FrameResult, GroupSummary

SCORE_SUFFIXES = (".json", ".csv")


class ScoreWriter(Protocol):
    """Writes a set's scores to an open file, frame by frame."""

    def begin(self) -> None: ...

    def add(self, fragment: bytes) -> None: ...

    def end(
        self,
        summary: Mapping[float, SetSummary] | None,
        *,
        ground_only: bool,
        groups: Sequence[GroupSummary] = (),
        more: Mapping[str, Any] | None = None,
    ) -> None: ...


# ---------------------------------------------------------------------------------------- JSON


def json_fragment(result: FrameResult, by: Sequence[str] = ()) -> bytes:
    """One entry of ``images``. Undefined figures are null; NaN never reaches a file.

    Args:
        by: what the set is grouped by; the frame's values then follow as ``groups``.
    """
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
        image |= metric_entry(OF_ANNOTATION, result.clicked)
    image["results"] = entries
    image |= result.fitted.entry(bool)
    if by:
        image["groups"] = dict(zip(by, result.groups, strict=True))
    return encoded(image)


def frame_entry(score: Any) -> dict[str, Any]:
    """A frame's figures at one threshold.

    Args:
        score: a `FrameScore`, or whatever has its figures.
    """
    counts = metric_entry((*COUNTS, JAC), score)
    mirrored = {"mirrored": score.mirrored}
    return counts | mirrored | metric_entry(OF_FRAME, score)


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
        name: metric_entry(OF_CLASS, figures) for name, figures in summary.per_class.items()
    }
    return metric_entry(OF_SET, summary) | {"per_class": per_class}


class JsonScores:
    """``{"protocol", "field", "size", "thresholds", "images": [...], "summary": {...}}``.

    The field is told by `field_terms`.

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
        """That was all, but for what is told of the evaluations together."""
        self._stream.write(b"]" + _more(more) + b"}\n")


def _more(entries: Mapping[str, Any] | None) -> bytes:
    """More keys of an object that has some."""
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
    """``json`` or ``csv``, by suffix.

    Raises:
        UsageError: another suffix.
    """
    suffix = path.suffix.lower()
    if suffix not in SCORE_SUFFIXES:
        raise UsageError(f"{path}: scores are written as .json or .csv, end the name so")
    return suffix[1:]
