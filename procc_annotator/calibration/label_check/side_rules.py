"""Elements on the wrong side of others, without a camera: relations that hold in every image.

Seen from above the ground, three of its points that go round clockwise do so in every picture: with
homogeneous coordinates the determinant of three projected points is that of the field's points,
times that of the homography, over three depths that are positive for what is seen. So two things
hold whatever the camera:

- three things keep their orientation, if all choices of a point on each of them have the same one,
  i.e. if no straight line meets all three;
- two things on the same side of a line stay on the same side of it.

Half a turn of the field changes neither.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.label_check.candidate_classes import (
    MIRROR_REMEDY_TEXTS,
    MIRROR_X,
    MIRROR_Y,
    mirrored_names,
)
from procc_annotator.calibration.label_check.evidence import (
    AnnotatedElement,
    FrameEvidence,
    extreme_points,
    undistort_points,
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
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.field.geometry import Line, outline_of
from procc_annotator.field.landmarks import landmark_covariances
from procc_annotator.field.model import Element, Field
from procc_annotator.translation import translatable, translatable_all

Corner = tuple[int, int]  # two straight elements that meet

# A triangle this flat on the field says nothing.
_MIN_ALTITUDE_M = 0.1
_TOUCH_TOLERANCE_M = 0.05


@dataclass(frozen=True, eq=False)
class OrientationRelations:
    """The relations of a field's things: its E ground elements, then the corners of two lines.

    Attributes:
        rows: (E,) names of the ground elements.
        corners: (C,) pairs of rows: straight elements that touch or cross.
        triples: (E + C, E + C, E + C) orientation of three things, 0 where it is not fixed.
        sides: (E, E + C) side of a straight element, walked from its start to its end, that a thing
            lies on; 0 where it lies on both, and for curves.
    """

    rows: tuple[str, ...]
    corners: tuple[Corner, ...]
    triples: NDArray[np.int8]
    sides: NDArray[np.int8]


@lru_cache(maxsize=4)
def orientation_relations(elements: tuple[Element, ...]) -> OrientationRelations:
    """The relations of a field's elements; those off the ground are left out."""
    ground = [element for element in elements if element.on_ground]
    things = [outline_of(element.geometry)[:, :2] for element in ground]
    corners: list[Corner] = []
    for i, one in enumerate(ground):
        for j in range(i + 1, len(ground)):
            place = _intersection_point(one, ground[j])
            if place is not None:
                corners.append((i, j))
                things.append(place[None])
    owner = np.repeat(np.arange(len(things)), [len(thing) for thing in things])
    points = np.concatenate(things) if things else np.zeros((0, 2))
    starts = np.searchsorted(owner, np.arange(len(things)))
    count = len(things)
    triples = np.zeros((count, count, count), dtype=np.int8)
    sides = np.zeros((len(ground), count), dtype=np.int8)
    for i, thing in enumerate(things):
        begin = starts[i] + len(thing)
        later = _orientations_with(thing, points[begin:], starts[i + 1 :] - begin)
        # The same three things in another order: turned by an odd one.
        triples[i, i + 1 :, i + 1 :] = triples[i + 1 :, i + 1 :, i] = later
        triples[i + 1 :, i, i + 1 :] = -later
        if i < len(ground) and isinstance(ground[i].geometry, Line):
            first, second = thing[0], thing[-1]
            across = _cross_2d(second - first, points - first) / np.hypot(*(second - first))
            sides[i] = _definite_sign(
                np.minimum.reduceat(across, starts), np.maximum.reduceat(across, starts)
            )
    for array in (triples, sides):
        array.setflags(write=False)
    return OrientationRelations(tuple(e.name for e in ground), tuple(corners), triples, sides)


def _orientations_with(
    thing: FloatArray, points: FloatArray, starts: NDArray[np.intp]
) -> NDArray[np.int8]:
    """(T, T) orientation of one thing with each two others."""
    if not len(starts):
        return np.zeros((0, 0), dtype=np.int8)
    least = np.full((len(starts), len(starts)), np.inf)
    most = -least
    for own in thing:
        flat = signed_altitudes(own, points[:, None], points[None])
        low = np.minimum.reduceat(np.minimum.reduceat(flat, starts, axis=0), starts, axis=1)
        high = np.maximum.reduceat(np.maximum.reduceat(flat, starts, axis=0), starts, axis=1)
        least, most = np.minimum(least, low), np.maximum(most, high)
    return _definite_sign(least, most)


def _definite_sign(least: FloatArray, most: FloatArray) -> NDArray[np.int8]:
    return ((least > _MIN_ALTITUDE_M).astype(np.int8) - (most < -_MIN_ALTITUDE_M)).astype(np.int8)


def signed_altitudes(a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
    """Signed smallest altitude (...) of triangles with corners (..., 2): no corner moved by less
    than half of it turns them. Positive where a, b, c go from the x axis towards the y axis."""
    doubled = _cross_2d(b - a, c - a)
    longest = np.maximum(
        np.maximum(((b - a) ** 2).sum(axis=-1), ((c - a) ** 2).sum(axis=-1)),
        ((c - b) ** 2).sum(axis=-1),
    )
    return np.asarray(doubled / np.sqrt(np.maximum(longest, 1e-12)))


def _cross_2d(a: FloatArray, b: FloatArray) -> FloatArray:
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def _intersection_point(one: Element, other: Element) -> FloatArray | None:
    """(2,) metres: where two straight elements touch or cross."""
    if not isinstance(one.geometry, Line) or not isinstance(other.geometry, Line):
        return None
    p, q = np.array(one.geometry.start[:2]), np.array(other.geometry.start[:2])
    r, s = np.array(one.geometry.end[:2]) - p, np.array(other.geometry.end[:2]) - q
    turn = float(_cross_2d(r, s))
    if abs(turn) < 1e-6 * float(np.hypot(*r) * np.hypot(*s)):
        return None
    along, also = float(_cross_2d(q - p, s)) / turn, float(_cross_2d(q - p, r)) / turn
    slack = _TOUCH_TOLERANCE_M / float(np.hypot(*r)), _TOUCH_TOLERANCE_M / float(np.hypot(*s))
    if not (-slack[0] <= along <= 1 + slack[0] and -slack[1] <= also <= 1 + slack[1]):
        return None
    return np.asarray(p + along * r)


# A triangle in the picture whose smallest altitude is less may be turned by the clicks' errors.
_MIN_ALTITUDE_PX = 8.0
# Straight through no lens, or through a strong one: what is wrong is so through both.
_TRIAL_KAPPAS = (0.0, 0.1, 0.25)
_CURVE_POINTS = 6
# A corner of two lines is used if it lies at most this share of a line's length beyond its clicks.
_CORNER_EXTENSION_SHARE = 0.25
_PARALLEL_SINE = 0.1
_MAX_NAMED = 3
# A reflection turns everything; by chance so many things do not.
_MIN_REVERSED = 3


@dataclass(frozen=True)
class Contradictions:
    """Relations of labels in one picture: each is the set of classes it needs.

    Attributes:
        turned: three things the wrong way round.
        across: things on the wrong sides of a line.
        kept: number of oriented relations that are as they should be.
    """

    turned: tuple[frozenset[str], ...]
    across: tuple[frozenset[str], ...]
    kept: int

    @property
    def all(self) -> tuple[frozenset[str], ...]:
        """Both kinds."""
        return (*self.turned, *self.across)


def contradictions(
    clicked: Sequence[AnnotatedElement], field: Field, frame: ImageFrame
) -> Contradictions:
    """Return what in a picture contradicts the field, whatever the camera and the lens; elements
    off the ground take no part."""
    found = [
        _contradictions_at(clicked, orientation_relations(field.elements), k, frame)
        for k in _TRIAL_KAPPAS
    ]
    first, *others = found
    return Contradictions(
        tuple(r for r in first.turned if all(r in other.turned for other in others)),
        tuple(r for r in first.across if all(r in other.across for other in others)),
        first.kept,
    )


def _contradictions_at(
    clicked: Sequence[AnnotatedElement],
    known: OrientationRelations,
    kappa: float,
    frame: ImageFrame,
) -> Contradictions:
    rows = {name: row for row, name in enumerate(known.rows)}
    used = [one for one in clicked if one.name in rows]
    things = [_hull_points(one, undistort_points(one.points, kappa, frame)) for one in used]
    names = [frozenset((one.name,)) for one in used]
    index = [rows[one.name] for one in used]
    straight = [i for i, one in enumerate(used) if one.element.is_straight and len(things[i]) == 2]
    number = {corner: len(known.rows) + i for i, corner in enumerate(known.corners)}
    for i, j in combinations(straight, 2):
        corner = number.get((min(index[i], index[j]), max(index[i], index[j])))
        place = None if corner is None else _line_corner(things[i], things[j])
        if corner is not None and place is not None:
            things.append(place[None])
            names.append(names[i] | names[j])
            index.append(corner)
    if len(used) < 3:
        return Contradictions((), (), 0)
    owner = np.repeat(np.arange(len(things)), [len(thing) for thing in things])
    points = np.concatenate(things)
    starts = np.searchsorted(owner, np.arange(len(things)))
    turned, kept = _reversed_triples(
        points, starts, known.triples[np.ix_(index, index, index)], names
    )
    across: list[frozenset[str]] = []
    for i in straight:
        sides = _sides_of_line(things[i], points, starts) * known.sides[index[i]][index]
        across += [
            names[i] | names[a] | names[b]
            for a in np.flatnonzero(sides > 0).tolist()
            for b in np.flatnonzero(sides < 0).tolist()
        ]
    return Contradictions(turned, tuple(dict.fromkeys(across)), kept)


def _reversed_triples(
    points: FloatArray,
    starts: np.ndarray[tuple[int], np.dtype[np.intp]],
    wanted: np.ndarray[tuple[int, int, int], np.dtype[np.int8]],
    names: Sequence[frozenset[str]],
) -> tuple[tuple[frozenset[str], ...], int]:
    """Triples of things the wrong way round, and the number of those the right way round."""
    found: dict[frozenset[str], None] = {}
    kept = 0
    ends = [*starts[1:].tolist(), len(points)]
    for i in range(len(starts)):
        if not wanted[i, i + 1 :, i + 1 :].any():
            continue
        rest = points[ends[i] :]
        after = starts[i + 1 :] - ends[i]
        own = points[starts[i] : ends[i]]
        flat = signed_altitudes(own[:, None, None], rest[None, :, None], rest[None, None, :])
        low = np.minimum.reduceat(np.minimum.reduceat(flat.min(axis=0), after), after, axis=1)
        high = np.maximum.reduceat(np.maximum.reduceat(flat.max(axis=0), after), after, axis=1)
        is_now = (low > _MIN_ALTITUDE_PX).astype(int) - (high < -_MIN_ALTITUDE_PX)
        product = np.triu(is_now * wanted[i, i + 1 :, i + 1 :], 1)
        kept += int((product > 0).sum())
        for j, k in np.argwhere(product < 0).tolist():
            found[names[i] | names[i + 1 + j] | names[i + 1 + k]] = None
    return tuple(found), kept


def _sides_of_line(
    line: FloatArray, points: FloatArray, starts: np.ndarray[tuple[int], np.dtype[np.intp]]
) -> np.ndarray[tuple[int], np.dtype[np.intp]]:
    """Side of a line that each thing is on as a whole; 0 for neither."""
    flat = signed_altitudes(line[0], line[1], points)
    low, high = np.minimum.reduceat(flat, starts), np.maximum.reduceat(flat, starts)
    return np.asarray((low > _MIN_ALTITUDE_PX).astype(np.intp) - (high < -_MIN_ALTITUDE_PX))


def _hull_points(clicked: AnnotatedElement, points: FloatArray) -> FloatArray:
    if clicked.element.is_straight:
        return np.array(extreme_points(points)) if len(points) > 1 else points
    chosen = np.linspace(0, len(points) - 1, min(len(points), _CURVE_POINTS)).round()
    return np.asarray(points[chosen.astype(int)])


def _line_corner(one: FloatArray, other: FloatArray) -> FloatArray | None:
    """Return where two lines meet, if that is on what was clicked of them or just beyond."""
    r, s, apart = one[1] - one[0], other[1] - other[0], other[0] - one[0]
    turn = r[0] * s[1] - r[1] * s[0]
    if abs(turn) <= _PARALLEL_SINE * np.hypot(*r) * np.hypot(*s):
        return None
    along = (apart[0] * s[1] - apart[1] * s[0]) / turn
    also = (apart[0] * r[1] - apart[1] * r[0]) / turn
    if not all(
        -_CORNER_EXTENSION_SHARE <= share <= 1 + _CORNER_EXTENSION_SHARE for share in (along, also)
    ):
        return None
    return np.asarray(one[0] + along * r)


def side_findings(evidence: FrameEvidence, known: Sequence[Finding]) -> tuple[Finding, ...]:
    """Return what is on the wrong side of others, where no camera explains everything and nothing
    is surely wrong already; nothing of what another finding would fix."""
    if evidence.is_whole or error_classes(known):
        return ()
    mended = {name for f in known for r in f.remedies for name, _ in r.renamed}
    # Which side something lies on is known of what is known exactly.
    uncertain = landmark_covariances(evidence.field)
    exact = [one for one in evidence.clicked if one.name not in uncertain]
    found = wrong_side_findings(exact, evidence.field, evidence.frame)
    return tuple(f for f in found if mended.isdisjoint(f.elements))


def wrong_side_findings(
    clicked: Sequence[AnnotatedElement], field: Field, frame: ImageFrame
) -> tuple[Finding, ...]:
    """The elements that lie on the wrong side of others, with what would put it right."""
    found = contradictions(clicked, field, frame)
    if not found.all:
        return ()
    names = [one.name for one in clicked]
    reversed_frame = _mirror_finding(clicked, names, found, field, frame)
    if reversed_frame is not None:
        return (reversed_frame,)
    common = frozenset.intersection(*found.all)
    if len(common) == 1:
        return (_single_element_finding(next(iter(common)), found, field),)
    swaps = [
        pair
        for pair in combinations(sorted(frozenset.union(*found.all), key=names.index), 2)
        if not any(some.isdisjoint(pair) for some in found.all)  # or contradictions would remain
        and not contradictions(
            _relabelled_elements(clicked, dict((pair, pair[::-1])), field), field, frame
        ).all
    ]
    return (_several_elements_finding(common, swaps, found, field, names),)


def _relabelled_elements(
    clicked: Sequence[AnnotatedElement], names: Mapping[str, str], field: Field
) -> list[AnnotatedElement]:
    renamed = []
    for one in clicked:
        element = field.element(names.get(one.name, one.name))
        assert element is not None  # classes of the field become classes of the field
        renamed.append(replace(one, element=element))
    return renamed


def _mirror_finding(
    clicked: Sequence[AnnotatedElement],
    names: Sequence[str],
    found: Contradictions,
    field: Field,
    frame: ImageFrame,
) -> Finding | None:
    if found.across or found.kept or len(found.turned) < _MIN_REVERSED:
        return None
    remedies = {}
    for signs, exchange in MIRROR_REMEDY_TEXTS.items():
        becomes = mirrored_names(field, signs, names)
        if becomes is None:
            continue
        if contradictions(_relabelled_elements(clicked, becomes, field), field, frame).all:
            return None
        pairs = tuple((name, becomes[name]) for name in names if becomes[name] != name)
        remedies[signs] = Remedy(RemedyKind.RELABEL, exchange, pairs)
    if not remedies:
        return None
    wrong = (
        translatable(
            "everything lies the wrong way round: far and near, or left and right, are exchanged"
        )
        if len(remedies) > 1
        else _MIRROR_REASONS[next(iter(remedies))]
    )
    return Finding(
        Rule.REFLECTED,
        Severity.ERROR,
        tuple(names),
        wrong,
        tuple(remedies.values()),
    )


_MIRROR_REASONS = {
    MIRROR_Y: translatable("everything lies the wrong way round: far and near, are exchanged"),
    MIRROR_X: translatable("everything lies the wrong way round: left and right, are exchanged"),
}


def _single_element_finding(name: str, found: Contradictions, field: Field) -> Finding:
    """All contradictions are with one element."""
    others = sorted(frozenset.union(*found.all) - {name}, key=field.index.__getitem__)
    sure = len(found.all) > 1
    titles = [translatable(field.title_of(other)) for other in others[:_MAX_NAMED]]
    return Finding(
        Rule.SIDE,
        Severity.ERROR if sure else Severity.WARNING,
        (name,),
        translatable(
            "{title} is on the wrong side of {others}",
            title=translatable(field.title_of(name)),
            others=translatable_all(titles),
        ),
        (LOOK,),
    )


def _several_elements_finding(
    common: frozenset[str],
    swaps: Sequence[tuple[str, str]],
    found: Contradictions,
    field: Field,
    names: Sequence[str],
) -> Finding:
    concerned = common or frozenset.union(*found.all)
    if len(swaps) == 1:
        concerned = frozenset(swaps[0])
    ordered = tuple(name for name in names if name in concerned)
    titles = translatable_all([translatable(field.title_of(name)) for name in ordered])
    remedies = [
        Remedy(
            RemedyKind.SWAP,
            translatable(
                "swap {a} and {b}",
                a=translatable(field.title_of(a)),
                b=translatable(field.title_of(b)),
            ),
            ((a, b), (b, a)),
        )
        for a, b in swaps[:_MAX_NAMED]
    ]
    if len(swaps) == 1:
        reason = translatable(
            "{titles} lie on each other's side of the elements around them", titles=titles
        )
    else:
        reason = translatable(
            "{titles} cannot lie this way round to each other, whatever the camera", titles=titles
        )
    return Finding(
        Rule.SIDE,
        Severity.ERROR if len(swaps) == 1 and len(found.all) > 1 else Severity.WARNING,
        ordered,
        reason,
        (*remedies, LOOK),
    )
