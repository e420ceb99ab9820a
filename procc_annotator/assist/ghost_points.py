"""Turn ghosts into annotation points on visible line markings."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import cv2
import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px
from procc_annotator.assist.curves import regular_parameters
from procc_annotator.assist.ghost_ends import locate_line_ends, reach_of
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.assist.visible_line import VisibleLine, find_line
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.prediction.ghosts import Ghost, GhostPiece, find_ghosts
from procc_annotator.field.model import ANY, EDGE, LINE, Field
from procc_annotator.image.pixels import PixelArray

# The share of a ghost that must be seen as a line for it to be accepted with all others.
LEAST_SUPPORT = 0.5
_FEWEST_POINTS = 2
_FEWEST_CURVE_POINTS = 5  # which determine an ellipse
_MOSTLY_SEEN = 0.5  # of a line as its paint: it is no edge between two areas
_ONE_PLACE_PX = 3.0
_MOST_CHORD, _FOLLOWED_GAP = 1 / 480, 1 / 16  # of the width: off a curve; a hidden bend of it
_SMALL_GAP = 1 / 80  # of the width, as points of a curve are apart at least


@dataclass(frozen=True, slots=True)
class GhostPoints:
    """Points that accepting a ghost would add.

    Attributes:
        points: normalised, in the element's direction; empty where nothing of it can be seen. A
            polyline is one line: stretches hidden in between are bridged by a chord without points,
            but for bends of a curve. At a corner of a chain there is one point.
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

    seek = partial(find_line, curved=curved, on_ground=on_ground)

    def find(piece: GhostPiece) -> VisibleLine:
        line = seek(picture, piece.points_px, piece.sd_px, sought, beyond_px=beyond)
        if not sought.is_pale_line or line.seen == line.length:
            return line
        half = max(1, size[0] // 2), max(1, size[1] // 2)
        small = np.asarray(cv2.resize(picture, half, interpolation=cv2.INTER_AREA), np.uint8)
        sd = np.full(line.length, 0.5 if line.runs else ghost.sd_px / 2)
        blurred = sought.blurred(size[0], shrink=2)
        wider = seek(small, line.course_px / 2 - 0.25, sd, blurred)
        return line.with_wider(wider) if wider.runs else line

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
    runs = _without_chords(line, size[0]) if curved else line.runs
    stretches = runs if curved else ((runs[0][0], runs[-1][1]),)
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
    for first, past in runs:
        own = wanted[(wanted >= first) & (wanted <= past - 1)].tolist()
        chosen.extend(own or [(first + past - 1) / 2])
    every = np.arange(line.length)
    at = np.column_stack([np.interp(chosen, every, line.course_px[:, k]) for k in (0, 1)])
    return [(x, y) for x, y in np.clip(at, 0.0, np.array(size) - 1).tolist()]


def _without_chords(line: VisibleLine, width_px: int) -> tuple[tuple[int, int], ...]:
    """The runs of a curve without gaps that a chord would bridge across a bend: at a short one the
    line is followed, at a long one it ends, and the longest part remains if it is most of it."""
    parts = [[line.runs[0]]]
    for run in line.runs[1:]:
        before = parts[-1][-1]
        gap = line.course_px[before[1] - 1 : run[0] + 1]
        across = np.array([[-1], [1]]) * (gap[-1] - gap[0])[::-1, None] / len(gap)
        bends = float(np.abs((gap - gap[0]) @ across).max()) > _MOST_CHORD * width_px
        if len(gap) <= (_FOLLOWED_GAP if bends else _SMALL_GAP) * width_px:
            parts[-1][-1] = before[0], run[1]
        elif not bends:
            parts[-1].append(run)
        else:
            parts.append([run])
    if len(parts) > 1 and math.dist(line.course_px[0], line.course_px[-1]) <= _ONE_PLACE_PX:
        parts[0] = [*parts.pop(), *parts[0]]  # of a circle, which may begin anywhere
    longest = max(parts, key=_length)
    return tuple(longest) if 2 * _length(longest) > _length(line.runs) else line.runs


def _length(runs: Iterable[tuple[int, int]]) -> int:
    return sum(past - first for first, past in runs)


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


def retry(
    annotation: FrameAnnotation,
    found: tuple[GhostPoints, ...],
    picture: PixelArray,
    field: Field,
    size: tuple[int, int],
    least_support: float = LEAST_SUPPORT,
) -> tuple[GhostPoints, ...]:
    """Look again for the lines that are not seen well enough, where the camera that follows from
    the others shows them. Returns all ghosts; arguments as of `find_points` and `accept_all`."""
    done = accept_all(annotation, found, least_support)
    if not (done.accepted and done.left):
        return found
    fit, left = fit_camera(done.annotation, field, size=size), {f.name for f in done.left}
    ghosts = [g for g in find_ghosts(done.annotation, field, fit) if g.name in left]
    again = {ghost.name: find_points(ghost, picture, field, size) for ghost in ghosts}
    return tuple(max(f, again.get(f.name, f), key=lambda f: f.support) for f in found)
