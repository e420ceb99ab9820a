"""Elements on the wrong side of others, without a camera."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

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
from procc_annotator.calibration.label_check.orientation import (
    OrientationRelations,
    orientation_relations,
    signed_altitudes,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.field.landmarks import landmark_covariances
from procc_annotator.field.model import Field
from procc_annotator.translation import translatable, translatable_all

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
    """Return what in a picture contradicts the field, whatever the camera and the lens.

    Args:
        clicked: annotated elements; those off the ground take no part.
        field: the elements.
        frame: the picture.
    """
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


def side_findings(looked_at: FrameEvidence, known: Sequence[Finding]) -> tuple[Finding, ...]:
    """Return what is on the wrong side of others, where no camera explains everything and nothing
    is surely wrong already; nothing of what another finding would fix."""
    if looked_at.is_whole or error_classes(known):
        return ()
    mended = {name for f in known for r in f.remedies for name, _ in r.renamed}
    # Which side something lies on is known of what is known exactly.
    uncertain = landmark_covariances(looked_at.field)
    exact = [one for one in looked_at.clicked if one.name not in uncertain]
    found = wrong_side_findings(exact, looked_at.field, looked_at.frame)
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
        if not contradictions(
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
