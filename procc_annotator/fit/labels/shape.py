"""Rules about one element alone: its shape, its number of points, their order."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from procc_annotator.field.geometry import Chain, Circle, Line
from procc_annotator.fit.labels.clicked import STRAIGHT_TOLERANCE_PX, SUSPECT_LIMIT_PX, AnnotatedElement, FrameEvidence, in_image_px
from procc_annotator.fit.labels.finding import (
    LOOK,
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
    error_classes,
)
from procc_annotator.fit.labels.lens import line_residuals, min_line_residuals
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame, evenly_spaced_indices
from procc_annotator.language import translatable, translatable_count

# So many points of an element, more than anybody clicks, are looked at if all are compared with
# all.
_MAX_POINTS = 1000
# A conic has five unknowns; three points say next to nothing about a circle seen in perspective.
_ELLIPSE_POINTS = 5
_MIN_CIRCLE_POINTS = 4
_MIN_ARC_POINTS = 3
# Clicks on one place that lie farther apart than this are two places.
_SAME_SPOT_PX = 3.0
# How much longer the way along the points is than the shortest net between them.
_RETRACED_RATIO = 1.9
_DISORDER_RATIO = 1.4
_SAME_PLACE_PX = 1.0
_MIN_CURVE_HEIGHT_PX = 4.0


def bent_line_finding(clicked: AnnotatedElement, frame: ImageFrame) -> Finding | None:
    """A straight element that no plausible lens makes straight."""
    points = clicked.points
    if not isinstance(clicked.element.geometry, Line) or len(points) < 3:
        return None
    if np.abs(line_residuals(points)).max() <= STRAIGHT_TOLERANCE_PX:
        return None
    off = min_line_residuals(points, frame)
    if off <= STRAIGHT_TOLERANCE_PX:
        return None
    bad = _single_outlier(points, frame)
    index = None if bad is None else clicked.indices[bad]
    remedies: tuple[Remedy, ...] = (LOOK,)
    if index is not None:
        number = index + 1
        remove = Remedy(RemedyKind.REMOVE_POINT, translatable("remove point {number}", number=number))
        look = Remedy(RemedyKind.LOOK, translatable("look at point {number}", number=number))
        remedies = (remove, look)
    shown = in_image_px(off, frame)
    return Finding(
        Rule.BENT,
        Severity.ERROR if off > SUSPECT_LIMIT_PX else Severity.WARNING,
        (clicked.name,),
        translatable(
            "{title} is straight on the field, its points lie up to {px:.0f} px beside a line, more"
            " than any lens bends it",
            title=clicked.title,
            px=shown,
        ),
        remedies,
        point=index,
    )


def _single_outlier(points: FloatArray, frame: ImageFrame) -> int | None:
    """The point without which the others are straight; three points leave open which it is."""
    if len(points) < 4:
        return None
    places = [*range(len(points))]
    if len(points) > _MAX_POINTS:
        places = [int(np.abs(line_residuals(points)).argmax())]
    without = [min_line_residuals(np.delete(points, i, axis=0), frame) for i in places]
    best = int(np.argmin(without))
    return places[best] if without[best] <= STRAIGHT_TOLERANCE_PX else None


def few_points_finding(clicked: AnnotatedElement) -> Finding | None:
    """Fewer points than tell where the element runs."""
    count = _count_distinct(clicked.points)
    shape = clicked.element.geometry
    if clicked.element.is_spot:
        return None
    if isinstance(shape, Line | Chain):
        if count > 1:
            return None
        reason = translatable_count(
            count,
            "{title} has {n} point, a line takes two",
            "{title} has {n} points, a line takes two",
            title=clicked.title,
        )
        return _few_points_finding(clicked, Severity.WARNING, reason)
    fewest = _MIN_CIRCLE_POINTS if isinstance(shape, Circle) else _MIN_ARC_POINTS
    if count < fewest:
        reason = translatable_count(
            count,
            "{title} has {n} point; a curve takes at least {least}",
            "{title} has {n} points; a curve takes at least {least}",
            title=clicked.title,
            least=_ELLIPSE_POINTS,
        )
        return _few_points_finding(clicked, Severity.WARNING, reason)
    if count < _ELLIPSE_POINTS:
        reason = translatable_count(
            count,
            "{title} has {n} point; fewer than {least} determine no ellipse",
            "{title} has {n} points; fewer than {least} determine no ellipse",
            title=clicked.title,
            least=_ELLIPSE_POINTS,
        )
        return _few_points_finding(clicked, Severity.HINT, reason)
    return None


def many_points_finding(clicked: AnnotatedElement, frame: ImageFrame) -> Finding | None:
    """Several places for what is one."""
    if not clicked.element.is_spot or len(clicked.points) < 2:
        return None
    reach = float(np.hypot(*np.ptp(clicked.points, axis=0)))
    if reach <= _SAME_SPOT_PX:
        return None
    return Finding(
        Rule.MANY_POINTS,
        Severity.WARNING,
        (clicked.name,),
        translatable(
            "{title} is a single place, it has {count} points up to {px:.0f} px apart",
            title=clicked.title,
            count=len(clicked.points),
            px=in_image_px(reach, frame),
        ),
        (LOOK,),
    )


def _few_points_finding(clicked: AnnotatedElement, severity: Severity, reason: str) -> Finding:
    return Finding(Rule.FEW_POINTS, severity, (clicked.name,), reason, (LOOK,))


def retraced_finding(clicked: AnnotatedElement) -> Finding | None:
    """Points that go over the same stretch again, or back and forth along it.

    Nothing is said of chains: round three sides of a rectangle the way is long and a net short.
    """
    points = clicked.points[evenly_spaced_indices(len(clicked.points), _MAX_POINTS)]
    points = _distinct_neighbours(points)
    if len(points) < 3 or clicked.element.is_spot or isinstance(clicked.element.geometry, Chain):
        return None
    if not isinstance(clicked.element.geometry, Line):
        rounded = _rectified_curve(points)
        if rounded is None:
            return None
        points = rounded
    way = float(np.hypot(*np.diff(points, axis=0).T).sum())
    net = _minimum_spanning_length(points)
    if way <= _DISORDER_RATIO * net or way - net < 10 * _SAME_PLACE_PX:
        return None
    if way >= _RETRACED_RATIO * net:
        return Finding(
            Rule.REPEATED,
            Severity.WARNING,
            (clicked.name,),
            translatable(
                "the points of {title} go over the same stretch more than once: their course is"
                " {times:.1f} times as long as it need be",
                title=clicked.title,
                times=way / net,
            ),
            (LOOK,),
        )
    return Finding(
        Rule.REPEATED,
        Severity.HINT,
        (clicked.name,),
        translatable("the points of {title} go back and forth instead of along it", title=clicked.title),
        (LOOK,),
    )


def _rectified_curve(points: FloatArray) -> FloatArray | None:
    """A curve's points stretched as if seen from above; None where it is seen edge-on.

    Its near and far side then lie on top of each other, and once round looks like there and back.
    """
    centred = points - points.mean(axis=0)
    left, spread, _ = np.linalg.svd(centred, full_matrices=False)
    if spread[1] / np.sqrt(len(points)) < _MIN_CURVE_HEIGHT_PX:
        return None
    return np.asarray(left * spread[0])


def _distinct_neighbours(points: FloatArray) -> FloatArray:
    steps = np.hypot(*np.diff(points, axis=0).T)
    return np.asarray(points[np.r_[True, steps > _SAME_PLACE_PX]])


def _count_distinct(points: FloatArray) -> int:
    """How many of (n, 2) points are apart from all before them; of very many as far as it takes."""
    if len(points) <= _MAX_POINTS:
        apart = np.hypot(*(points[:, None] - points[None]).transpose(2, 0, 1))
        return int((~np.tril(apart < _SAME_PLACE_PX, -1).any(axis=1)).sum())
    count = 0
    while len(points) and count < _ELLIPSE_POINTS:
        points = points[np.hypot(*(points - points[0]).T) >= _SAME_PLACE_PX]
        count += 1
    return count


def _minimum_spanning_length(points: FloatArray) -> float:
    """Length of the shortest net that connects (n, 2) points (Prim's algorithm)."""
    apart = np.hypot(*(points[:, None] - points[None]).transpose(2, 0, 1))
    nearest = apart[0].copy()
    nearest[0] = np.inf
    joined = np.zeros(len(points), dtype=bool)
    joined[0] = True
    total = 0.0
    for _ in range(len(points) - 1):
        index = int(nearest.argmin())
        total += float(nearest[index])
        joined[index] = True
        nearest = np.where(joined, np.inf, np.minimum(nearest, apart[index]))
    return max(total, _SAME_PLACE_PX)


def shape_findings(looked_at: FrameEvidence, known: Sequence[Finding]) -> Iterator[Finding]:
    """All there is to say about each element alone; a camera that explains it knows what a lens
    does to it."""
    explained = looked_at.explained | error_classes(known)
    for clicked in looked_at.clicked:
        for found in (
            None if clicked.name in explained else bent_line_finding(clicked, looked_at.frame),
            few_points_finding(clicked),
            many_points_finding(clicked, looked_at.frame),
            retraced_finding(clicked),
        ):
            if found is not None:
                yield found
