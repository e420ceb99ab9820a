"""Copy elements to another frame by camera motion, aligned to its lines."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px, points_px
from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.assist.ghost_points import find_points
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.calibration.prediction.ghosts import find_ghosts
from procc_annotator.calibration.prediction.visible_elements import (
    image_edge_point,
    steps_to_image_edge,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.records import PointKey
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError
from procc_annotator.field.model import Field
from procc_annotator.image.line_profiles import LineTarget
from procc_annotator.image.line_snapping import snap_points_to_lines
from procc_annotator.image.motion import CameraMotion, estimate_motion, transfer_points
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.polylines import arc_lengths

Size = tuple[int, int]

_AT_EDGE_PX = 12.0  # along the line
_FARTHEST_BACK = 200  # frames: eight seconds at 25 per second
_REACH_PX = 4.0  # the motion is known better
_AGREE_PX = 1.2  # across: points so near to where the others of their element say show its paint
_FEWEST_AGREED = 3  # two may agree by chance
_ONWARDS = 12  # places at which a line is looked for that goes on to the edge; half must show it


@dataclass(frozen=True)
class Copied:
    """Elements copied to another picture.

    Attributes:
        polylines: normalised to the new picture.
        moved: whether the camera's motion was found; else nothing moved.
        unseen: the points at which the new picture shows no paint of theirs, as (u, v).
    """

    polylines: tuple[Polyline, ...]
    moved: bool
    unseen: frozenset[PointKey] = frozenset()


def annotated_before(workspace: Workspace, index: int) -> tuple[Frame, FrameAnnotation] | None:
    """The nearest annotated one of the 200 frames before a frame, with its annotation."""
    for i in range(index - 1, max(-1, index - 1 - _FARTHEST_BACK), -1):
        try:
            annotation = workspace.read(i)
        except InputError:
            continue  # told when that frame is opened; look further back
        if annotation.annotated:
            return workspace.frames[i], annotation
    return None


def copy_moved(
    polylines: tuple[Polyline, ...],
    previous: PixelArray,
    current: PixelArray,
    curved: frozenset[str],
    paint: ExpectedLines,
    spots: frozenset[str] = frozenset(),
) -> Copied:
    """Carry polylines from one picture to another of the same camera.

    Each point is moved by the camera's motion and put on its line's centre where its element shows
    paint as at its other points; one that does not goes with the others, and is reported. What
    leaves the picture is cut off at its edge; a straight element that ended at the edge before is
    continued to the edge, since the camera has turned to see more of it. Without a trustworthy
    motion (a cut) the polylines come back as they are.

    Args:
        polylines: normalised to ``previous``.
        previous, current: (H, W, 4) pictures; they may differ in size.
        curved: classes that change their direction along them.
        paint: what each class looks like in ``current``.
        spots: classes that are single places, on no line.
    """
    motion = estimate_motion(previous, current)
    if motion is None:
        return Copied(polylines, False)
    size_before = previous.shape[1], previous.shape[0]
    size = current.shape[1], current.shape[0]
    carried: list[Polyline] = []
    unseen: set[PointKey] = set()
    for polyline in polylines:
        straight = polyline.class_name not in curved
        before = points_px(polyline, size_before)
        sought = paint.of(polyline.class_name)
        is_seen = partial(_is_seen, current, sought) if straight else None
        points = _move_points(before, size_before, motion, size, is_seen)
        if not len(points):
            continue
        seen = np.ones(len(points), dtype=bool)
        if polyline.class_name not in spots:
            points, seen = _on_line(points, current, sought, straight=straight)
        placed = [point_from_px(x, y, size) for x, y in points.tolist()]
        unseen |= {(p.u, p.v) for p, shown in zip(placed, seen, strict=True) if not shown}
        carried.append(Polyline(polyline.class_name, tuple(placed)))
    return Copied(tuple(carried), True, frozenset(unseen))


def copy_along_track(
    polylines: tuple[Polyline, ...],
    annotation: FrameAnnotation,
    picture: PixelArray,
    field: Field,
    fit: FitResult,
) -> Copied:
    """The same elements where the camera of a track shows them in this frame (H, W, 4), on their
    paint; its annotation has none of them.

    Elements out of sight, and those without visible paint, do not come along.
    """
    size = picture.shape[1], picture.shape[0]
    wanted = {polyline.class_name for polyline in polylines}
    others = [element.name for element in field.elements if element.name not in wanted]
    ghosts = find_ghosts(annotation, field, fit, without=others)
    found = [find_points(ghost, picture, field, size) for ghost in ghosts]
    return Copied(tuple(Polyline(f.name, f.points) for f in found if f.points), True)


def _move_points(
    before: FloatArray,
    size_before: Size,
    motion: CameraMotion,
    size: Size,
    is_seen: Callable[[FloatArray, FloatArray], bool] | None,
) -> FloatArray:
    """(n, 2) px in the new picture, cut off and, where more of it is seen, continued at its edges;
    ``is_seen``: between two places; None of what is not straight."""
    points = transfer_points(motion, before)
    for end, inner in ((0, 1), (-1, -2)) if is_seen and len(points) >= 2 else ():
        if _leaves(before[end], before[inner], size_before):
            further = _continued(points[end], points[inner], size)
            if is_seen is not None and is_seen(points[end], further):
                points[end] = further
    return _cut_off(points, size)


def _is_seen(picture: PixelArray, sought: LineTarget, begin: FloatArray, end: FloatArray) -> bool:
    """Return whether a line is seen to go on, also near where it should end: its own end may be in
    sight by now."""
    length = float(np.hypot(*(end - begin)))
    if length <= _AT_EDGE_PX:
        return True
    places = begin + np.linspace(0.0, 1.0, _ONWARDS + 1)[1:, None] * (end - begin)
    along = np.tile((end - begin) / length, (_ONWARDS, 1))
    seen = ~np.isnan(snap_points_to_lines(picture, places, along, sought, reach_px=_REACH_PX)[:, 0])
    return bool(2 * seen.sum() >= _ONWARDS and 2 * seen[_ONWARDS // 2 :].sum() >= _ONWARDS // 2)


def _leaves(end: FloatArray, inner: FloatArray, size: Size) -> bool:
    """Return whether a line ends where it leaves the picture; one along the edge does not leave
    there."""
    way_out = _continued(end, inner, size) - end
    return bool(np.hypot(way_out[0], way_out[1]) <= _AT_EDGE_PX)


def _continued(end: FloatArray, inner: FloatArray, size: Size) -> FloatArray:
    """Return where the line through an end leaves the picture; the end itself if that is
    outside."""
    found = image_edge_point(end, end - inner, size) if (end != inner).any() else None
    return end if found is None else found


def _cut_off(points: FloatArray, size: Size) -> FloatArray:
    """The points inside the picture, and where the polyline crosses its edge."""
    limits = np.array(size, dtype=np.float64) - 1
    inside = [bool(((p >= 0) & (p <= limits)).all()) for p in points]
    kept: list[FloatArray] = []
    for i, point in enumerate(points):
        if inside[i]:
            kept.append(point)
        if i + 1 < len(points) and inside[i] != inside[i + 1]:
            inner, outer = (point, points[i + 1]) if inside[i] else (points[i + 1], point)
            kept.append(_crossing(inner, outer, limits))
    return np.array(kept).reshape(-1, 2)


def _crossing(inner: FloatArray, outer: FloatArray, limits: FloatArray) -> FloatArray:
    step = outer - inner
    return np.clip(inner + steps_to_image_edge(inner, step, limits) * step, 0.0, limits)


def _on_line(
    points: FloatArray, picture: PixelArray, sought: LineTarget, *, straight: bool
) -> tuple[FloatArray, BoolArray]:
    """(n, 2) px, each on its line's centre where one was found, and (n,) whether it was.

    What is off is the camera's motion, by nearly the same all along an element: a point that would
    be moved otherwise has found something else, a player or another line. It goes with the others.
    """
    unseen = np.zeros(len(points), dtype=bool)
    if len(points) < 2:
        return points, unseen
    steps = np.gradient(points, axis=0)
    if straight:
        steps[:] = points[-1] - points[0]
    lengths = np.hypot(steps[:, 0], steps[:, 1])
    if (lengths < 1e-6).any():
        return points, unseen
    along = steps / lengths[:, None]
    across = np.column_stack([-along[:, 1], along[:, 0]])
    found = snap_points_to_lines(picture, points, along, sought, reach_px=_REACH_PX)
    offsets = ((found - points) * across).sum(axis=1)
    shifts = _common_shifts(points, across, offsets)
    seen = np.abs((shifts * across).sum(axis=1) - offsets) <= _AGREE_PX  # False where NaN
    if seen.sum() < min(_FEWEST_AGREED, len(points)):
        return points, unseen
    return np.where(seen[:, None], found, points + shifts), seen


def _common_shifts(points: FloatArray, across: FloatArray, offsets: FloatArray) -> FloatArray:
    """(n, 2) px: the shift, changing steadily along the element, that most offsets agree with."""
    lengths = arc_lengths(points)
    place = 2.0 * lengths / lengths[-1] - 1.0
    known = np.flatnonzero(~np.isnan(offsets))
    terms = np.hstack([across, across * place[:, None]])
    shift = np.zeros(4)
    if len(known):
        level = float(np.median(offsets[known]))  # of a straight element, where most of them are
        shift[:2] = level * across[known].mean(axis=0)
    for scale in (3.0, 2.0, 1.0, 0.7, 0.5):
        apart = offsets[known] - terms[known] @ shift
        weights = 1.0 / (1.0 + (apart / scale) ** 2)
        weighted = terms[known] * weights[:, None]
        normal = weighted.T @ terms[known] + np.diag([0.02, 0.02, 0.2, 0.2])
        shift = np.linalg.solve(normal, weighted.T @ offsets[known])
    return np.asarray(shift[:2] + place[:, None] * shift[2:])
