"""Rules on single elements and pairs: shape, number and order of points, unknown class, overlap."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import combinations

import numpy as np

from procc_annotator.annotation import FrameAnnotation, pixel_like
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.fitting import pixel_coordinates_error
from procc_annotator.calibration.label_check.evidence import (
    STRAIGHT_TOLERANCE_PX,
    SUSPECT_LIMIT_PX,
    AnnotatedElement,
    FrameEvidence,
    in_image_px,
    line_residuals,
    min_line_residuals,
)
from procc_annotator.calibration.label_check.finding import (
    LOOK,
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
    error_classes,
)
from procc_annotator.calibration.optimization.observations import ImageFrame, evenly_spaced_indices
from procc_annotator.field.geometry import Chain, Circle, Line
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sampling import distances_to, sample_evenly
from procc_annotator.metrics.polylines import arc_lengths, points_at_arc_lengths
from procc_annotator.translation import translatable, translatable_count, translatable_joined

# So many points of an element, more than anyone clicks, are examined if all are compared with all.
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
        remove = Remedy(
            RemedyKind.REMOVE_POINT, translatable("remove point {number}", number=number)
        )
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
    """Fewer points than say where the element runs."""
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
            "{title} has {n} point: {least} points needed for a curve",
            "{title} has {n} points: {least} points needed for a curve",
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
        translatable(
            "the points of {title} go back and forth instead of along it", title=clicked.title
        ),
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
    """Return how many of (n, 2) points are apart from all before them; of very many as far as it
    takes."""
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


def shape_findings(evidence: FrameEvidence, known: Sequence[Finding]) -> Iterator[Finding]:
    """All there is to say about each element alone; a camera that explains it knows what a lens
    does to it."""
    explained = evidence.explained | error_classes(known)
    for clicked in evidence.clicked:
        for found in (
            None if clicked.name in explained else bent_line_finding(clicked, evidence.frame),
            few_points_finding(clicked),
            many_points_finding(clicked, evidence.frame),
            retraced_finding(clicked),
        ):
            if found is not None:
                yield found


# Of two spellings this alike one is a slip of the pen; 1 is the same.
_MIN_NAME_SIMILARITY = 0.75


def unknown_class_findings(
    evidence: FrameEvidence, known: Sequence[Finding]
) -> tuple[Finding, ...]:
    """Annotated classes that the field does not know (those without geometry are known): an error
    where a class is nearly called so, with the right name if it is free; else a warning, for no fit
    uses the element and no camera can show it."""
    annotation, field = evidence.annotation, evidence.field
    return tuple(
        _unknown_class_finding(name, annotation, field)
        for name in annotation.annotated
        if not field.knows(field.canonical_name(name))
    )


def pixel_coordinate_findings(
    evidence: FrameEvidence, known: Sequence[Finding]
) -> tuple[Finding, ...]:
    """One error if the coordinates look like pixels; then no other rule has anything to say."""
    annotation = evidence.annotation
    strange = pixel_like(annotation)
    if strange is None:
        return ()
    return (
        Finding(
            Rule.PIXELS,
            Severity.ERROR,
            annotation.annotated,
            pixel_coordinates_error(strange),
            (LOOK,),
        ),
    )


def _unknown_class_finding(name: str, annotation: FrameAnnotation, field: Field) -> Finding:
    meant = _most_similar_class(name, field)
    shown = name.strip()
    if meant is None:
        reason = translatable(
            "no such class: {name!r} fits no camera, and counts as missed where it is scored",
            name=shown,
        )
        return Finding(Rule.UNKNOWN_CLASS, Severity.WARNING, (name,), reason, (LOOK,))
    title = translatable(field.title_of(meant))
    words = (
        title if title == meant.strip() else translatable_joined("", (title, f" ({meant.strip()})"))
    )
    reason = translatable("no such class: {name!r}, did you mean {title}?", name=shown, title=words)
    remedies: tuple[Remedy, ...] = (LOOK,)
    if meant in annotation.annotated:
        reason = translatable_joined(" ", (reason, translatable("That is annotated already")))
    else:
        text = translatable("relabel to {title}", title=title)
        relabel = Remedy(RemedyKind.RELABEL, text, ((name, meant),))
        remedies = (relabel, LOOK)
    return Finding(Rule.UNKNOWN_CLASS, Severity.ERROR, (name,), reason, remedies)


def _most_similar_class(name: str, field: Field) -> str | None:
    names = [*(e.name for e in field.elements), *field.classes_without_geometry]
    spellings = {e.title.casefold(): e.name for e in field.elements}
    spellings |= {known.strip().casefold(): known for known in names}
    close = difflib.get_close_matches(
        name.strip().casefold(), spellings, n=1, cutoff=_MIN_NAME_SIMILARITY
    )
    return spellings[close[0]] if close else None


# Clicks along one line lie so near to those of another person along it.
_OVERLAP_PX = 3.0
_MIN_OVERLAP_SHARE = 0.8
_MIN_OVERLAP_LENGTH_PX = 20.0
_OVERLAP_SAMPLES = 12
_OVERLAP_SPACING_M = 0.5
# Elements nearer than this on the field itself may well be on top of each other in the picture.
_COINCIDENT_M = 0.5


def overlap_findings(evidence: FrameEvidence, known: Sequence[Finding]) -> Iterator[Finding]:
    """Pairs of elements whose clicks run along the same stretch; nothing in a reflected frame.

    Only of elements on the ground, which lie apart in every picture taken from well above it: a
    crossbar seen from far away hides the goal line behind it, and posts hide each other. Two that
    a camera explains are where they should be.
    """
    if any(f.rule is Rule.REFLECTED for f in known):
        return
    explained, sure = evidence.explained, error_classes(known)
    ground = [
        c
        for c in evidence.clicked
        if c.element.on_ground and _bounding_box(c.points) >= _MIN_OVERLAP_LENGTH_PX
    ]
    for one, other in combinations(ground, 2):
        if explained.issuperset((one.name, other.name)) or not sure.isdisjoint(
            (one.name, other.name)
        ):
            continue
        if _boxes_disjoint(one.points, other.points):
            continue
        if _polylines_overlap(one.points, other.points) and not _coincide_on_field(
            evidence.field, one.name, other.name
        ):
            yield _overlap_finding(one, other, evidence.frame)


def _overlap_finding(one: AnnotatedElement, other: AnnotatedElement, frame: ImageFrame) -> Finding:
    near = in_image_px(_OVERLAP_PX, frame)
    return Finding(
        Rule.COINCIDENT,
        Severity.WARNING,
        (one.name, other.name),
        translatable(
            "{a} and {b} lie on top of each other, less than {px:.0f} px apart: one line under two"
            " names?",
            a=one.title,
            b=other.title,
            px=near,
        ),
        (LOOK,),
    )


def _bounding_box(points: FloatArray) -> float:
    return float(np.hypot(*np.ptp(points, axis=0)))


def _boxes_disjoint(one: FloatArray, other: FloatArray) -> bool:
    return bool(
        (one.min(axis=0) > other.max(axis=0) + _OVERLAP_PX).any()
        or (other.min(axis=0) > one.max(axis=0) + _OVERLAP_PX).any()
    )


def _polylines_overlap(one: FloatArray, other: FloatArray) -> bool:
    short, long = sorted((one, other), key=_bounding_box)
    return bool(
        (_polyline_distances(_resample(short), long) < _OVERLAP_PX).mean() >= _MIN_OVERLAP_SHARE
    )


def _resample(points: FloatArray) -> FloatArray:
    along = arc_lengths(points)
    places = np.linspace(0.0, along[-1], _OVERLAP_SAMPLES)
    return points_at_arc_lengths(points, places, along)


def _polyline_distances(points: FloatArray, polyline: FloatArray) -> FloatArray:
    """(n,) distance of each point from a polyline."""
    begin, span = polyline[:-1], np.diff(polyline, axis=0)
    squares = np.maximum((span**2).sum(axis=1), 1e-12)
    offset = points[:, None] - begin[None]
    share = np.clip((offset * span[None]).sum(axis=2) / squares, 0.0, 1.0)
    apart = offset - share[:, :, None] * span[None]
    return np.asarray(np.sqrt((apart**2).sum(axis=2)).min(axis=1))


def _coincide_on_field(field: Field, one: str, other: str) -> bool:
    """Return whether most of one of two elements lies on the other on the field itself."""
    on = _coincidence_matrix(field.elements)
    i, j = field.index[one], field.index[other]
    return bool(max(on[i, j], on[j, i]) >= _MIN_OVERLAP_SHARE / 2)


@lru_cache(maxsize=4)
def _coincidence_matrix(elements: tuple[Element, ...]) -> FloatArray:
    """(E, E) share of each element that lies on each other one."""
    samples = sample_evenly(Field("", "", (), elements), _OVERLAP_SPACING_M)
    found = np.array(
        [
            (distances_to(elements, samples.of(i)) < _COINCIDENT_M).mean(axis=0)
            for i in range(len(elements))
        ]
    )
    found.setflags(write=False)
    return found
