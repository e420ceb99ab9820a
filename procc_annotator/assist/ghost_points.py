"""Turn ghosts into annotation points on visible line markings."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px
from procc_annotator.assist.curves import regular_parameters
from procc_annotator.assist.ghost_ends import locate_line_ends, reach_of
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.assist.visible_line import VisibleLine, find_line
from procc_annotator.calibration.prediction.ghosts import Ghost, GhostPiece
from procc_annotator.field.model import ANY, EDGE, LINE, Field
from procc_annotator.image.pixels import PixelArray

# The share of a ghost that must be seen as a line for it to be accepted with all others.
LEAST_SUPPORT = 0.5
_FEWEST_POINTS = 2
_FEWEST_CURVE_POINTS = 5  # which determine an ellipse
_MOSTLY_SEEN = 0.5  # of a line as its paint: it is no edge between two areas
_ONE_PLACE_PX = 3.0
_SMALL_GAP = 1 / 80  # of the width, as points of a curve are apart at least


@dataclass(frozen=True, slots=True)
class GhostPoints:
    """Points that accepting a ghost would add.

    Attributes:
        points: normalised, in the element's direction; empty where nothing of it can be seen. A
            polyline is one line: stretches hidden in between are bridged by a chord without points.
            At a corner of a chain there is one point.
        support: the share of the ghost's length along which the picture shows its line, 0 to 1.
        unsure_ends: of a straight one, how many of the ends that the camera expects in the picture
            the paint that they lie at does not confirm; the points stop before them.
    """

    name: str
    points: tuple[Point, ...]
    support: float
    unsure_ends: int = 0


@dataclass(frozen=True, slots=True)
class AcceptedGhosts:
    """Points that accepting all ghosts would add.

    Attributes:
        annotation: with those that were accepted.
        accepted: ghosts with lines that are seen well enough.
    """

    annotation: FrameAnnotation
    accepted: tuple[GhostPoints, ...]
    left: tuple[GhostPoints, ...]


def find_points(
    ghost: Ghost, picture: PixelArray, field: Field, size: tuple[int, int]
) -> GhostPoints:
    """Regular points along what can be seen of a ghost, on the centre of its painted line.

    The first and the last point are where the line begins and ends to be seen: at the picture's
    edge, at the element's end, or where something stands in front of it. Safe from any thread.

    The ghost is in px of the picture (H, W, 4) BGRA of this (width, height).
    """
    found = _find_points(ghost, picture, field, size, ExpectedLines(field, size[0]))
    element = field.element(ghost.name)
    looks = None if element is None else element.appearance
    if looks is None or looks.kind != LINE or looks.tone != ANY or found.support >= _MOSTLY_SEEN:
        return found
    edges = ExpectedLines(field, size[0], edges=True)
    return max(found, _find_points(ghost, picture, field, size, edges), key=lambda f: f.support)


def _find_points(
    ghost: Ghost, picture: PixelArray, field: Field, size: tuple[int, int], paint: ExpectedLines
) -> GhostPoints:
    element = field.element(ghost.name)
    curved = element is not None and element.is_curved
    sought = replace(paint.of(ghost.name), is_expected=True)
    on_ground = element is not None and element.on_ground and sought.looks.kind != EDGE

    straight = len(ghost.pieces) == 1 and element is not None and element.is_straight
    beyond = (reach_of(ghost.ends[0]), reach_of(ghost.ends[1])) if straight else (0.0, 0.0)

    def find(piece: GhostPiece) -> VisibleLine:
        return find_line(
            picture,
            piece.points_px,
            piece.sd_px,
            sought,
            curved=curved,
            on_ground=on_ground,
            beyond_px=beyond,
        )

    lines, unsure = [find(piece) for piece in ghost.pieces], 0
    if straight:
        line, unsure = locate_line_ends(lines[0], ghost, picture, paint, on_ground=on_ground)
        lines = [line]
    places = _without_repetitions(
        [place for line in lines for place in _regular(line, size, curved=curved)]
    )
    whole = sum(line.expected[1] - line.expected[0] + 1 for line in lines)
    support = min(1.0, sum(line.seen for line in lines) / whole) if whole else 0.0
    points = tuple(point_from_px(x, y, size) for x, y in places)
    if len(points) < _FEWEST_POINTS:
        return GhostPoints(ghost.name, (), support)
    return GhostPoints(ghost.name, points, support, unsure)


def _without_repetitions(places: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Without the second of two in one place: at a corner of a chain both pieces have one."""
    kept = places[:1]
    for place in places[1:]:
        if math.dist(place, kept[-1]) > _ONE_PLACE_PX:
            kept.append(place)
    return kept


def _regular(
    line: VisibleLine, size: tuple[int, int], *, curved: bool
) -> list[tuple[float, float]]:
    """Places from the first that is seen to the last, regular, without those that are hidden; a
    curve is sampled from end to end of each stretch, so that its bends are kept."""
    if not line.runs:
        return []
    closes = _SMALL_GAP * size[0] if curved else math.inf
    stretches = [line.runs[0]]
    for first, past in line.runs[1:]:
        if first - stretches[-1][1] <= closes:
            first = stretches.pop()[0]
        stretches.append((first, past))
    least = math.ceil((_FEWEST_CURVE_POINTS - 1) / len(stretches)) if curved else 1
    parts = [
        regular_parameters(
            np.arange(first, past, dtype=np.float64),
            line.course_px[first:past],
            line.directions[first:past],
            size[0],
            least=least,
        )
        for first, past in stretches
    ]
    wanted = np.concatenate(parts)
    chosen: list[float] = []
    for first, past in line.runs:
        own = wanted[(wanted >= first) & (wanted <= past - 1)].tolist()
        chosen.extend(own or [(first + past - 1) / 2])
    every = np.arange(line.length)
    at = np.column_stack([np.interp(chosen, every, line.course_px[:, k]) for k in (0, 1)])
    return [(x, y) for x, y in np.clip(at, 0.0, np.array(size) - 1).tolist()]


def accept(annotation: FrameAnnotation, found: Sequence[GhostPoints]) -> FrameAnnotation:
    """The annotation with ghosts made elements; those without points are passed over.

    An element that has got points meanwhile keeps them.
    """
    for ghost in found:
        present = annotation.get(ghost.name)
        if ghost.points and (present is None or not present.points):
            annotation = annotation.with_polyline(Polyline(ghost.name, ghost.points))
    return annotation


def accept_all(
    annotation: FrameAnnotation,
    found: Sequence[GhostPoints],
    least_support: float = LEAST_SUPPORT,
) -> AcceptedGhosts:
    """Accept all ghosts of an annotation with lines that the picture shows well enough.

    One round: what the ghosts that are shown become. The better camera that follows from them may
    show further ones, which the annotator sees before accepting them.

    Args:
        annotation: what the ghosts were predicted from.
        least_support: the share of a ghost along which its line must be seen.
    """
    good = tuple(f for f in found if f.points and f.support >= least_support)
    left = tuple(f for f in found if f not in good)
    return AcceptedGhosts(accept(annotation, good), good, left)
