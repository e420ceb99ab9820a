"""The agreement of two annotators: tables for the terminal, JSON and CSV for the rest."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any, Protocol

from procc_annotator.errors import UsageError
from procc_annotator.io.atomic import replacing
from procc_annotator.metric.agreement import (
    AgreementSummary,
    ClassAgreement,
    FrameAgreement,
    quantile,
)
from procc_annotator.metric.chance.sampling import Draws
from procc_annotator.report.agreement_figures import floor_entry, intervals_described
from procc_annotator.report.field_terms import field_terms
from procc_annotator.report.scores.score_files import score_format
from procc_annotator.report.scores.tables import pixels, worst_words
from procc_annotator.report.sheet.as_csv import csv_header, csv_rows
from procc_annotator.report.sheet.as_json import encoded, figure_entry
from procc_annotator.report.sheet.figure import shortest, values_of
from procc_annotator.report.sheet.figures import (
    APART,
    COMMON,
    DISTANCES,
    JAC,
    LARGEST_PX,
    LEFT_OUT,
    MEDIAN_PX,
    OF_AGREEMENT,
    ONLY_A,
    ONLY_B,
    POINTS,
)  # fmt: skip
from procc_annotator.report.sheet.sheet import TAU, Column, Row, Sheet, of, whole
from procc_annotator.session.runs.agreement_run import AgreementResult, AgreementRun
from procc_annotator.session.runs.clusters import Clusters, clusters_of
from procc_annotator.session.runs.sure_agreement import SureAgreement, sure_agreement
from procc_annotator.words import count_of

WORST = 10

_COLUMNS = (
    Column("name"), Column("field"), whole("width"), whole("height"), Column("class"),
    Column("status"), whole("points"), whole("left_out"), *map(of, DISTANCES),
    Column("mirrored_hint", kind="yes_no"), Column("error"),
)  # fmt: skip

ClustersOf = Callable[[Sequence[str]], Clusters]
Progress = Callable[[Iterable[AgreementResult], int, str], Iterator[AgreementResult]]


@dataclass(frozen=True, slots=True)
class AgreementRow:
    """What the table of worst frames says about one frame at one threshold."""

    name: str
    jac: float
    common: int
    only_a: int
    only_b: int
    median: float | None
    largest: float | None
    farthest: str
    mirrored_hint: bool

    @classmethod
    def of(cls, name: str, frame: FrameAgreement, tau: float) -> AgreementRow:
        """The row of a frame; its farthest element is the one with the largest distance."""
        by_size = [(c.largest, n) for n, c in frame.by_class.items() if c.largest is not None]
        largest, farthest = max(by_size, default=(None, ""))
        distances = frame.distances.copy()
        distances.sort()
        return cls(
            name,
            frame.jac(tau),
            len(frame.by_class),
            len(frame.only_a),
            len(frame.only_b),
            quantile(distances, 0.5),
            largest,
            farthest.strip(),
            frame.mirrored_hint,
        )


@dataclass(frozen=True)
class Agreed:
    """A set's agreement and what has to be said about it.

    Attributes:
        floor: the same with intervals; known: what these rest on.
    """

    summary: AgreementSummary
    described: str
    worst: list[AgreementRow]
    errors: list[str]
    floor: SureAgreement
    known: str


def _no_progress(
    items: Iterable[AgreementResult], _total: int, _what: str
) -> Iterator[AgreementResult]:
    return iter(items)


def agree_sets(
    run: AgreementRun,
    *,
    outputs: Sequence[Path] = (),
    progress: Progress = _no_progress,
    clusters: ClustersOf = lambda frames: clusters_of(frames, None, {}),
) -> Agreed:
    """Compare two annotators' files and write what is found, frame by frame.

    Args:
        run: not yet iterated.
        outputs: ``.json`` or ``.csv`` files; they appear when they are complete.
        progress: wraps the frames as they come, given their number and a word for the work.
        clusters: which of some frames are alike, for intervals.

    Raises:
        UsageError: frames that cannot be clustered; no frame of which both files can be
            read; an output of another kind.
        SaveError: an output cannot be written.
    """
    worst: list[tuple[tuple[float, float], int, AgreementRow]] = []
    errors: list[str] = []
    found: list[tuple[str, FrameAgreement]] = []
    with ExitStack() as files:
        writers: list[_Writer] = []
        for output in outputs:
            kind = _JsonWriter if score_format(output) == "json" else _CsvWriter
            writers.append(kind(files.enter_context(replacing(output)), run))
        for count, result in enumerate(progress(run, run.total, "comparing")):
            errors += result.errors
            for writer in writers:
                writer.add(result)
            if result.agreement is not None:
                found.append((result.name, result.agreement))
            if result.agreement is not None and result.agreement.element_count:
                row = AgreementRow.of(result.name, result.agreement, run.thresholds[0])
                entry = ((-row.jac, row.largest or 0.0), -count, row)
                (heapq.heappush if len(worst) < WORST else heapq.heappushpop)(worst, entry)
        summary = run.summary()
        if not summary.frames:
            raise UsageError(
                f"of none of the {run.total} frames both annotations can be read;"
                f" the first: {errors[0]}"
            )
        names = [name for name, _ in found]
        alike, draws = clusters(names), Draws()
        floor = sure_agreement(names, found, run.thresholds, alike, draws)
        known = intervals_described(draws, alike)
        for writer in writers:
            writer.end(summary, floor_entry(floor, known))
    rows = [row for _, _, row in sorted(worst, reverse=True)]
    return Agreed(summary, run.describe(), rows, errors, floor, known)


# ---------------------------------------------------------------------------------------- tables


def noise_floor_line(agreed: Agreed) -> str:
    """The one line a paper would quote."""
    found = agreed.summary.overall
    return (
        f"Noise floor: median {pixels(found.median)} px, 95 % {pixels(found.p95)} px,"
        f" max {pixels(found.largest)} px, over {count_of(found.points, 'distance')}"
        f" of {count_of(found.common, 'element')} ({agreed.described})"
    )


def jac_table(agreed: Agreed) -> Sheet:
    """One row a threshold: the JaC one annotator would score if the other were a camera."""
    summary = agreed.summary
    counts = (COMMON, ONLY_A, ONLY_B)
    columns = (TAU, of(JAC), *(whole(figure.key, figure.title) for figure in counts))
    found = values_of(counts, summary.overall)
    rows = tuple((tau, jac, *found) for tau, jac in summary.mean_jac.items())
    title = f"Agreement of {count_of(summary.frames, 'frame')} both annotated"
    return Sheet("agreement", title, columns, rows, agreed.described)


def agreement_classes_table(agreed: Agreed) -> Sheet:
    """Per class and, last, all classes together."""
    per_class, overall = agreed.summary.per_class, agreed.summary.overall
    told = (POINTS, LEFT_OUT, COMMON, APART, ONLY_A, ONLY_B)
    columns = (
        Column("class", "class"), *(whole(count.key, count.title) for count in told),
        *map(of, DISTANCES),
    )  # fmt: skip
    rows = tuple(
        (name, *values_of((*told, *DISTANCES), figures))
        for name, figures in [*((n.strip(), f) for n, f in per_class.items()), ("all", overall)]
    )
    title, parts = "Distances between A and B", (len(per_class),)
    return Sheet("classes", title, columns, rows, agreed.described, parts=parts)


def worst_agreement_table(agreed: Agreed) -> Sheet:
    """The frames to look at first: lowest JaC, then largest distance."""
    tau = next(iter(agreed.summary.mean_jac))
    columns = (
        Column("frame", "frame"), of(JAC), whole("common", "in common"), whole("only_a", "only A"),
        whole("only_b", "only B"), of(MEDIAN_PX), of(LARGEST_PX),
        Column("farthest", "farthest element"), Column("labels", "labels"),
    )  # fmt: skip
    rows = tuple(
        (
            row.name, row.jac, row.common, row.only_a, row.only_b, row.median, row.largest,
            row.farthest, "mirrored?" if row.mirrored_hint else None,
        )
        for row in agreed.worst
    )  # fmt: skip
    title = f"{worst_words(len(agreed.worst))} at {tau:g} px"
    return Sheet("worst_frames", title, columns, rows, agreed.described)


# ----------------------------------------------------------------------------------------- files


class _Writer(Protocol):
    def __init__(self, stream: IO[bytes], run: AgreementRun) -> None: ...

    def add(self, result: AgreementResult) -> None: ...

    def end(self, summary: AgreementSummary, floor: dict[str, Any]) -> None: ...


class _JsonWriter:
    """The terms of the field, then ``"size", "thresholds", "a", "b", "images", "summary"``."""

    def __init__(self, stream: IO[bytes], run: AgreementRun) -> None:
        self._stream = stream
        self._thresholds = run.thresholds
        self._separator = b"\n"
        head = encoded(
            {
                **field_terms(run.field),
                "size": list(run.size),
                "thresholds": list(run.thresholds),
                "a": str(run.a.path),
                "b": str(run.b.path),
            }
        )
        stream.write(head[:-1] + b',"images":[')

    def add(self, result: AgreementResult) -> None:
        frame = result.agreement
        entry: dict[str, Any] = {"name": result.name, "errors": list(result.errors)}
        if frame is not None:
            entry |= {
                "jac": {shortest(tau): frame.jac(tau) for tau in self._thresholds},
                "only_a": list(frame.only_a),
                "only_b": list(frame.only_b),
                "mirrored_hint": frame.mirrored_hint,
                "elements": {name: _element_entry(c) for name, c in frame.by_class.items()},
            }
        self._stream.write(self._separator + encoded(entry))
        self._separator = b",\n"

    def end(self, summary: AgreementSummary, floor: dict[str, Any]) -> None:
        entry = _summary_entry(summary) | {"noise_floor": floor}
        self._stream.write(b'\n],"summary":' + encoded(entry) + b"}\n")


def _element_entry(found: ClassAgreement) -> dict[str, Any]:
    counts = {"left_out": found.left_out, "distances": found.distances.tolist()}
    return figure_entry(DISTANCES, found) | counts


def _summary_entry(summary: AgreementSummary) -> dict[str, Any]:
    return {
        "frames": summary.frames,
        "frames_only_a": list(summary.frames_only_a),
        "frames_only_b": list(summary.frames_only_b),
        "mirrored_hint": list(summary.mirrored),
        "mean_jac": {shortest(tau): jac for tau, jac in summary.mean_jac.items()},
        "per_class": {n: figure_entry(OF_AGREEMENT, f) for n, f in summary.per_class.items()},
    }


class _CsvWriter:
    """A header, one row a frame and class; a frame with nothing to show has a row without class.

    The status of a class is ``common``, ``apart``, ``only_a`` or ``only_b``; that of a row without
    class ``empty``, ``unreadable``, ``frame_only_a`` or ``frame_only_b``.
    """

    def __init__(self, stream: IO[bytes], run: AgreementRun) -> None:
        self._stream = stream
        self._terms = (run.field.described, *run.size)
        stream.write(csv_header(_COLUMNS))

    def add(self, result: AgreementResult) -> None:
        frame = result.agreement
        if frame is None:
            rows = [self._row(result.name, None, "unreadable", error="; ".join(result.errors))]
        else:
            hint = frame.mirrored_hint
            rows = [self._class_row(result.name, c, hint) for c in frame.by_class.values()]
            for status, names in (("only_a", frame.only_a), ("only_b", frame.only_b)):
                rows += [self._row(result.name, n, status, hint=hint) for n in names]
        self._stream.write(csv_rows(_COLUMNS, rows or [self._row(result.name, None, "empty")]))

    def end(self, summary: AgreementSummary, floor: dict[str, Any]) -> None:
        """Frames of one annotator only; the figures of the set have no row of their own."""
        for status, names in (
            ("frame_only_a", summary.frames_only_a),
            ("frame_only_b", summary.frames_only_b),
        ):
            self._stream.write(csv_rows(_COLUMNS, (self._row(n, None, status) for n in names)))

    def _class_row(self, name: str, found: ClassAgreement, hint: bool) -> Row:
        figures = (len(found.distances), found.left_out, *values_of(DISTANCES, found))
        status = "apart" if found.apart else "common"
        return self._row(name, found.class_name, status, figures, hint)

    def _row(
        self,
        name: str,
        class_name: str | None,
        status: str,
        figures: tuple[float | None, ...] = (None,) * 5,
        hint: bool | None = None,
        error: str | None = None,
    ) -> Row:
        return (name, *self._terms, class_name, status, *figures, hint, error)
