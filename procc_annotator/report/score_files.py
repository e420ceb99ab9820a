"""Scores as files: JSON and CSV, written frame by frame, in place only when complete.

A frame is encoded where it was scored (`json_fragment`, `csv_fragment`: bytes that travel cheaply
between processes); a `ScoreWriter` strings the fragments together.
"""

from __future__ import annotations

import csv
import io
import math
import os
import secrets
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO, Any, Protocol

import msgspec

from procc_annotator.errors import SaveError, UsageError
from procc_annotator.metric.measure import Labelling
from procc_annotator.metric.score import FrameScore, Status
from procc_annotator.metric.sets import SetSummary
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.evaluation_run import FrameResult

SCORE_SUFFIXES = (".json", ".csv")

CSV_COLUMNS = (
    "name", "protocol", "options", "width", "height", "threshold",
    "jac", "tp", "fp", "fn", "mirrored", "precision", "recall", "mean_reprojection_error",
    "camera", "error",
)  # fmt: skip


def threshold_key(threshold: float) -> str:
    """How a threshold is written as a key, short and exact: ``5``, ``2.5``."""
    short = f"{threshold:g}"
    return short if float(short) == threshold and "e" not in short else repr(threshold)


class ScoreWriter(Protocol):
    """Writes a set's scores to an open file, frame by frame."""

    def begin(self) -> None: ...

    def add(self, fragment: bytes) -> None: ...

    def end(self, summary: Mapping[float, SetSummary] | None, *, ground_only: bool) -> None: ...


# ---------------------------------------------------------------------------------------- JSON


def json_fragment(result: FrameResult) -> bytes:
    """One entry of ``images``. Undefined figures are null; NaN never reaches a file."""
    encoded: dict[int, _Elements] = {}  # by labelling, of which a frame has two at most
    entries = {}
    for threshold, score in result.scores.items():
        key = id(score.labelling)
        if key not in encoded:
            encoded[key] = _Elements(score.labelling)
        entries[threshold_key(threshold)] = _frame_entry(score, encoded[key])
    return msgspec.json.encode(
        {"name": result.name, "camera": result.camera, "error": result.error, "results": entries}
    )


def _frame_entry(score: FrameScore, elements: _Elements) -> dict[str, Any]:
    return {
        "tp": score.tp,
        "fp": score.fp,
        "fn": score.fn,
        "jac": score.jac,
        "mirrored": score.mirrored,
        "precision": score.precision,
        "recall": score.recall,
        "mean_reprojection_error": score.mean_error,
        "elements": elements.entries(score.threshold),
    }


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
        for name in labelling.hallucinated:
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
    return {
        "mean_jac": summary.mean_jac,
        "sd_jac": summary.sd_jac,
        "median_jac": summary.median_jac,
        "completeness": summary.completeness,
        "final_score": summary.final_score,
        "mean_precision": summary.mean_precision,
        "mean_recall": summary.mean_recall,
        "mean_reprojection_error": summary.mean_reprojection_error,
        "per_class": {
            name: {
                "tp": figures.tp,
                "fp": figures.fp,
                "fn": figures.fn,
                "jac": figures.jac,
                "precision": figures.precision,
                "recall": figures.recall,
            }
            for name, figures in summary.per_class.items()
        },
    }


class JsonScores:
    """``{"protocol", "field", "size", "thresholds", "images": [...], "summary": {...}}``.

    Options without which the numbers mean nothing follow, only where they count: ``"off_plane"``
    for cameras that know only the ground, ``"planar_only"`` where elements off it took no part,
    ``"mirrored_labels"`` where ``procc`` allowed them.
    """

    def __init__(
        self, stream: IO[bytes], setup: EvaluationSetup, thresholds: Iterable[float]
    ) -> None:
        self._stream = stream
        self._setup = setup
        self._thresholds = list(thresholds)
        self._separator = b"\n"

    def begin(self) -> None:
        head = msgspec.json.encode(
            {
                "protocol": self._setup.protocol,
                "field": self._setup.field.name,
                "size": list(self._setup.size),
                "thresholds": self._thresholds,
            }
        )
        self._stream.write(head[:-1] + b',"images":[')

    def add(self, fragment: bytes) -> None:
        self._stream.write(self._separator)
        self._stream.write(fragment)
        self._separator = b",\n"

    def end(self, summary: Mapping[float, SetSummary] | None, *, ground_only: bool) -> None:
        entries = None
        if summary is not None:
            entries = {threshold_key(t): summary_entry(s) for t, s in summary.items()}
        self._stream.write(b'\n],"summary":' + msgspec.json.encode(entries))
        if self._setup.planar_only:
            self._stream.write(b',"planar_only":true')
        elif ground_only:
            self._stream.write(b',"off_plane":' + msgspec.json.encode(self._setup.off_plane))
        if self._setup.protocol == "procc" and self._setup.allow_mirrored:
            self._stream.write(b',"mirrored_labels":true')
        self._stream.write(b"}\n")


# ----------------------------------------------------------------------------------------- CSV


def csv_fragment(
    result: FrameResult, setup: EvaluationSetup, thresholds: tuple[float, ...]
) -> bytes:
    """One row a threshold; figures of a frame without scores are empty."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    for threshold in thresholds:
        rows.writerow(_csv_row(result, setup, threshold))
    return text.getvalue().encode()


def _csv_row(result: FrameResult, setup: EvaluationSetup, threshold: float) -> list[Any]:
    chosen = [f"off-plane {setup.off_plane}"] if result.ground_only else []
    if setup.planar_only:
        chosen = ["planar elements only"]
    if setup.protocol == "procc" and setup.allow_mirrored:
        chosen.append("mirrored labels allowed")
    terms = [setup.protocol, "; ".join(chosen), *setup.size]
    start = [result.name, *terms, threshold_key(threshold)]
    score = result.scores.get(threshold)
    if score is None:
        return [*start, *[""] * 8, "", result.error or "no camera"]
    figures: list[Any] = [score.jac, score.tp, score.fp, score.fn, str(score.mirrored).lower()]
    figures += [score.precision, score.recall, score.mean_error]
    return [*start, *figures, result.camera, result.error]


class CsvScores:
    """A header, then one row an image and threshold."""

    def __init__(self, stream: IO[bytes]) -> None:
        self._stream = stream

    def begin(self) -> None:
        self._stream.write((",".join(CSV_COLUMNS) + "\n").encode())

    def add(self, fragment: bytes) -> None:
        self._stream.write(fragment)

    def end(self, summary: Mapping[float, SetSummary] | None, *, ground_only: bool) -> None:
        """Nothing: a set's figures have no row of their own."""


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


@contextmanager
def replacing(path: Path) -> Iterator[IO[bytes]]:
    """A file that takes its place only when the block ends well; else whatever was there stays.

    For files too long to hold in memory (`write_atomic` is for the others).

    Raises:
        SaveError: the folder cannot be written, the disk is full.
    """
    temporary = path.with_name(f".{path.name}.{secrets.token_hex(4)}.tmp")
    try:
        with open(temporary, "xb", buffering=1 << 20) as stream:
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
        os.replace(temporary, path)
    except OSError as error:
        raise SaveError(f"{path}: not written: {error.strerror or error}") from error
    finally:
        with suppress(OSError):  # gone already when all went well
            temporary.unlink()
