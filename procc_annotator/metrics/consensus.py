"""Consensus of several annotators: the median curve of each element.

An element is agreed on if more than half of the annotators have it. Its course is walked along one
of theirs; at each place the others' offsets across are taken, and the consensus lies at their
median, where more than half of the courses run. So of three and more one who strays moves it
little, and one who bears another line's name not at all (`overlap`). The result is an annotation,
with points where points were clicked, and is compared as one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.arrays import FloatArray, true_runs
from procc_annotator.field.geometry import Line
from procc_annotator.field.model import Element, Field
from procc_annotator.metrics.agreement import (
    MIN_OVERLAP,
    AnnotatedCurve,
    FrameAgreement,
    annotated_curves,
    closest_arc_lengths,
    compare_annotations,
    curve_overlap,
)
from procc_annotator.metrics.clicked_curve import ClickedCurve
from procc_annotator.metrics.polylines import arc_lengths, points_at_arc_lengths, polyline_normals

_CURVE_SAMPLES = 100  # a course is walked in so many
_SMOOTHING_SAMPLES = 3  # steps to either side that a direction across is taken over
_ITERATIONS = 2  # the second one walks along the middle that the first one found
_CURVE_CLICKS = 8  # no fewer tell all round a circle where it runs


@dataclass(frozen=True)
class Consensus:
    """Consensus of several in one frame.

    Attributes:
        annotation: the elements that more than half have, at the middle of their courses.
        undecided: names of those that exactly half have, or that more than half have without any
            stretch where more than half run.
    """

    annotation: FrameAnnotation
    undecided: tuple[str, ...]


def build_consensus(
    annotations: Sequence[FrameAnnotation], field: Field, size: tuple[int, int]
) -> tuple[Consensus, list[Consensus]]:
    """The consensus of annotations of one frame; and, for each, that of all the others, so that
    no one is compared with himself.

    Args:
        annotations: at least two; one without any element counts as a voice against all.
        field: classes without geometry do not count.
        size: (width, height) px of the picture in which they are compared.
    """
    several = [annotated_curves(one, field, size) for one in annotations]
    overlaps = _OverlapCache()
    others = [[*several[:at], *several[at + 1 :]] for at in range(len(several))]
    of_all, *of_others = (
        _consensus_annotation(some, field, size, overlaps) for some in (several, *others)
    )
    return of_all, of_others


def compare_to_consensus(
    annotation: FrameAnnotation, consensus: Consensus, field: Field, size: tuple[int, int]
) -> FrameAgreement:
    """An annotation against a consensus: ``only_a`` are elements that it has beyond it, ``only_b``
    those that it lacks; what is undecided counts for nothing."""
    kept = tuple(p for p in annotation if p.class_name not in consensus.undecided)
    own = replace(annotation, polylines=kept)
    return compare_annotations(own, consensus.annotation, field, size)


class _OverlapCache:
    """Shared length of two courses, each two examined once."""

    def __init__(self) -> None:
        self._known: dict[frozenset[AnnotatedCurve], float] = {}

    def of(self, a: AnnotatedCurve, b: AnnotatedCurve) -> float:
        key = frozenset((a, b))
        if key not in self._known:
            self._known[key] = curve_overlap(a.trace, a.points, b.trace, b.points)
        return self._known[key]


def _consensus_annotation(
    several: Sequence[Mapping[str, AnnotatedCurve]],
    field: Field,
    size: tuple[int, int],
    overlaps: _OverlapCache,
) -> Consensus:
    agreed, undecided = [], []
    for name in dict.fromkeys(name for one in several for name in one):
        votes = [one[name] for one in several if name in one]
        element = field.element(name)
        if element is None or 2 * len(votes) < len(several):
            continue
        middle = None
        if 2 * len(votes) > len(several):
            middle = _median_curve(votes, element, overlaps)
        if middle is None:
            undecided.append(name)
        else:
            points = tuple(point_from_px(x, y, size) for x, y in middle.tolist())
            agreed.append(Polyline(name, points))
    return Consensus(FrameAnnotation(tuple(agreed)), tuple(undecided))


def _median_curve(
    votes: Sequence[AnnotatedCurve], element: Element, overlaps: _OverlapCache
) -> FloatArray | None:
    """(n, 2) px along the middle of courses; None where more than half share no stretch."""
    if len(votes) == 1:
        return votes[0].points
    reliable = _reliable_votes(votes)
    if not reliable:
        centres = np.array([vote.points.mean(axis=0) for vote in votes])
        return np.asarray(np.median(centres, axis=0, keepdims=True))
    walked = _median_along_reference(reliable, len(votes), overlaps)
    if walked is None:
        return None
    course, closed = walked
    fewest = 2 if isinstance(element.geometry, Line) else _CURVE_CLICKS
    count = max(fewest, *(len(vote.points) for vote in reliable))
    return _resample_like_clicks(ClickedCurve(course, closed), reliable, count)


def _resample_like_clicks(
    course: ClickedCurve, reliable: Sequence[AnnotatedCurve], count: int
) -> FloatArray:
    """(n, 2) px: at most so many places on a course, as clicks are spread along it. Between clicks
    that are far apart, as where a circle leaves the picture, no one knows where it runs."""
    lengths = arc_lengths(course.vertices)
    at = np.concatenate([closest_arc_lengths(course, vote.points) for vote in reliable])
    at = at[(at > 0) & (at < lengths[-1])]
    if not course.closed:
        at = np.concatenate((at, (0.0, lengths[-1])))
    chosen = np.quantile(at, np.linspace(0, 1, count), method="nearest")
    return points_at_arc_lengths(course.vertices, np.unique(chosen), lengths)


def _reliable_votes(votes: Sequence[AnnotatedCurve]) -> list[AnnotatedCurve]:
    """Those whose course is known well, or coarsely where they are no more than half; none where
    most know only a place."""
    for rank in (2, 1):
        reliable = [vote for vote in votes if vote.trace.rank >= rank]
        if 2 * len(reliable) > len(votes):
            return reliable
    return []


def _median_along_reference(
    reliable: Sequence[AnnotatedCurve], voters: int, overlaps: _OverlapCache
) -> tuple[FloatArray, bool] | None:
    """The middle of courses along the one that shares most with the others, the longest stretch on
    which more than half of the voters run; and whether that goes all round."""
    shared_px = {
        own: [
            overlaps.of(own, other) * min(_clicked_length(own), _clicked_length(other))
            if overlaps.of(own, other) >= MIN_OVERLAP
            else 0.0
            for other in reliable
            if other is not own
        ]
        for own in reliable
    }
    own = max(reliable, key=lambda one: sum(shared_px[one]))
    others = [other for other in reliable if other is not own]
    beside = [other for other, px in zip(others, shared_px[own], strict=True) if px > 0]
    if not own.extent[1] > own.extent[0]:
        return None
    places = points_at_arc_lengths(own.trace.vertices, np.linspace(*own.extent, _CURVE_SAMPLES + 1))
    middle = places
    for _ in range(_ITERATIONS):
        across = polyline_normals(middle, _SMOOTHING_SAMPLES)
        table = np.array(
            [((places - middle) * across).sum(axis=1)]
            + [_signed_offsets(vote, middle, across) for vote in beside]
        )
        shared = 2 * (~np.isnan(table)).sum(axis=0) > voters
        if not shared.any():
            return None
        moved = np.zeros(len(middle))
        moved[shared] = _nan_medians(table[:, shared])
        middle = middle + moved[:, None] * across
    if own.trace.closed and shared.all():
        return middle, True
    stretch = middle[slice(*max(true_runs(shared), key=lambda run: run[1] - run[0]))]
    return (stretch, False) if len(stretch) > 1 else None


def _nan_medians(table: FloatArray) -> FloatArray:
    """(n,) of the columns of a table (m, n), NaN left out; numpy's own takes ten times as long."""
    ascending = np.sort(table, axis=0)  # NaN last
    last = (~np.isnan(table)).sum(axis=0) - 1
    columns = np.arange(table.shape[1])
    return np.asarray((ascending[last // 2, columns] + ascending[(last + 1) // 2, columns]) / 2)


def _clicked_length(clicked: AnnotatedCurve) -> float:
    return clicked.extent[1] - clicked.extent[0]


def _signed_offsets(vote: AnnotatedCurve, places: FloatArray, across: FloatArray) -> FloatArray:
    """(n,) px from places to a course along the directions across; NaN where it does not run."""
    lengths = arc_lengths(vote.trace.vertices)
    at = closest_arc_lengths(vote.trace, places)
    off = points_at_arc_lengths(vote.trace.vertices, at, lengths) - places
    # As far as it reaches beyond its clicks: no one clicks the same extent as another.
    runs = (at > 0) & (at < lengths[-1]) if not vote.trace.closed else np.ones(len(at), dtype=bool)
    return np.where(runs, (off * across).sum(axis=1), np.nan)
