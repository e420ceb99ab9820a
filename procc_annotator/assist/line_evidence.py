"""Expected appearance of field lines in a picture, and line evidence along an annotation."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline, points_px
from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.assist.curves import hermite_curve
from procc_annotator.calibration.label_check.evidence import LineEvidence
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.prediction.visible_elements import steps_to_image_edge
from procc_annotator.camera.base import Camera, projects_only_ground
from procc_annotator.field.geometry import Chain
from procc_annotator.field.model import ANY, ANY_LINE, BAR, EDGE, LINE, NOTHING, Element, Field
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.image.line_profiles import LineTarget, straighten_curve
from procc_annotator.image.line_snapping import SNAP_RADIUS_PX, snap_points_to_lines
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.polylines import arc_lengths, points_at_arc_lengths

Place = tuple[float, float]

_EVERY_M = 0.5
_NEAR_PX = 30.0  # a camera that shows an element farther from a click does not know it
_STEP_M = 0.05  # of the finite difference across a line, half its width


class ExpectedLines:
    """Expected look of each element in one picture.

    Args:
        camera: in px of the picture; None if unknown or hidden.
        edges: whether lines of any tone are edges between two areas, without paint.
    """

    def __init__(
        self, field: Field, width_px: int, camera: Camera | None = None, *, edges: bool = False
    ) -> None:
        self._field = field
        self._edges = edges
        self._width_px = width_px
        self._camera = camera
        looks = Counter(e.appearance for e in field.elements if e.appearance.kind == LINE)
        self._usual = looks.most_common(1)[0][0] if looks else ANY_LINE
        self._course = cache(self._projected)

    def of(self, class_name: str) -> LineTarget:
        """Return what to look for of a class, wherever it is; of one without a place what most
        elements look like."""
        element = self._field.element(class_name)
        looks = element.appearance if element is not None else self._usual
        if self._edges and looks.kind == LINE and looks.tone == ANY:
            looks = replace(looks, kind=EDGE, width_m=0.0)
        bends = element is None or element.is_curved
        return replace(LineTarget.of(looks, self._width_px), bends=bends)

    def at(self, class_name: str, place: Place) -> tuple[LineTarget, Place | None]:
        """Return what to look for of a class near a place in the picture, and in which direction.

        The direction is a unit vector, None where no camera gives it.
        """
        element = self._field.element(class_name)
        course = self._course(class_name)
        if element is None or course is None:
            return self.of(class_name), None
        points, along, scales = course
        apart = np.hypot(*(points - place).T)
        nearest = int(apart.argmin())
        if apart[nearest] > _NEAR_PX:
            return self.of(class_name), None
        x, y = along[nearest].tolist()
        sought = LineTarget.of(element.appearance, self._width_px, float(scales[nearest]))
        return replace(sought, bends=element.is_curved), (x, y)

    def _projected(self, class_name: str) -> tuple[FloatArray, FloatArray, FloatArray] | None:
        """Of places along an element: (n, 2) px, (n, 2) unit directions, (n,) px a metre across."""
        element, camera = self._field.element(class_name), self._camera
        if element is None or camera is None or element.is_spot:
            return None
        if projects_only_ground(camera) and not element.on_ground:
            return None
        samples = sample_evenly(self._field, _EVERY_M).of(self._field.index[class_name])
        points, along, scales = _seen(camera, samples, _across_directions(element, samples))
        known = np.isfinite(scales) & np.isfinite(points).all(axis=1)
        return (points[known], along[known], scales[known]) if known.any() else None


def _across_directions(element: Element, samples: FloatArray) -> tuple[FloatArray, ...]:
    """(n, 3) unit vectors across an element: in the ground, or both ways from a bar."""
    along = np.gradient(samples, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1), 1e-9)[:, None]
    if element.on_ground:
        return (np.column_stack([-along[:, 1], along[:, 0], np.zeros(len(along))]),)
    return tuple(axis - (along @ axis)[:, None] * along for axis in np.eye(3))


def _seen(
    camera: Camera, samples: FloatArray, asides: tuple[FloatArray, ...]
) -> tuple[FloatArray, FloatArray, FloatArray]:
    points, visible = camera.project(samples)
    points = np.where(visible[:, None], points, np.nan)
    along = np.gradient(points, axis=0)
    along /= np.maximum(np.hypot(*along.T), 1e-9)[:, None]
    across = np.column_stack([-along[:, 1], along[:, 0]])
    scales = np.zeros(len(points))
    for aside in asides:
        beside, seen = camera.project(samples + _STEP_M * aside)
        apart = np.abs(((beside - points) * across).sum(axis=1)) / _STEP_M
        scales = np.fmax(scales, np.where(seen, apart, np.nan))
    return points, along, np.where(visible & (scales > 0), scales, np.nan)


# Px at 960 px width.
_EVERY_PX, _AHEAD_PX = 16.0, 40.0
_PLACES = (3, 12)  # of a stretch between two clicks
_CURVE_STEPS = 12


def line_evidence(
    annotation: FrameAnnotation,
    picture: PixelArray,
    field: Field,
    known: Mapping[Polyline, LineEvidence] | None = None,
    go_on: Callable[[], None] = lambda: None,
) -> dict[Polyline, LineEvidence]:
    """Return what the picture shows along each element; safe from any thread.

    Args:
        annotation: of the frame; unconfirmed elements are examined too.
        picture: (H, W, 4) BGRA.
        field: says what elements look like; spots and classes it does not place are left out.
        known: of the same picture and field, from before: what did not change is not examined
            again.
        go_on: called between elements; raises whatever it likes when no one wants the rest.
    """
    paint, found = ExpectedLines(field, picture.shape[1]), {}
    for polyline in (*annotation.polylines, *annotation.unconfirmed):
        element = field.element(polyline.class_name)
        if element is None or element.is_spot or len(polyline.points) < 2:
            continue
        sought = paint.of(polyline.class_name)
        if sought.looks.kind == NOTHING:
            continue
        seen = known.get(polyline) if known is not None else None
        if seen is None:
            go_on()
            smooth = element.is_curved and not isinstance(element.geometry, Chain)
            seen = _along(polyline, picture, sought, smooth=smooth)
        if seen is not None:
            found[polyline] = seen
    return found


def line_evidence_by_class(
    annotation: FrameAnnotation, picture: PixelArray, field: Field
) -> dict[str, LineEvidence]:
    """The same of the confirmed elements, by class."""
    confirmed = replace(annotation, unconfirmed=())
    return confirmed_evidence(annotation, line_evidence(confirmed, picture, field))


def confirmed_evidence(
    annotation: FrameAnnotation, evidence: Mapping[Polyline, LineEvidence]
) -> dict[str, LineEvidence]:
    """Class -> what is seen along the confirmed element."""
    return {p.class_name: evidence[p] for p in annotation.polylines if p in evidence}


def _along(
    polyline: Polyline, picture: PixelArray, sought: LineTarget, *, smooth: bool
) -> LineEvidence | None:
    size = (picture.shape[1], picture.shape[0])
    per_px = 1 / ImageFrame(size).scale
    limits = np.array(size) - 1.0
    every = points_px(polyline, size)
    kept = np.flatnonzero(np.isfinite(every).all(axis=1))
    kept = kept[np.concatenate([[True], (np.diff(every[kept], axis=0) != 0).any(axis=1)])]
    clicks = every[kept]
    if len(clicks) < 2:
        return None
    places, along, segments, lengths = _places(clicks, per_px, smooth=smooth)
    inside = ((places >= 0) & (places <= limits)).all(axis=1)
    if inside.sum() < 2:
        return None
    places, along, lengths = places[inside], along[inside], lengths[inside]
    reach = SNAP_RADIUS_PX * (1.0 if sought.is_pale_line else min(max(per_px, 1.0), 2.0))

    def offsets(at: FloatArray, directions: FloatArray) -> FloatArray:
        found = snap_points_to_lines(picture, at, directions, sought, reach_px=reach)
        across = np.column_stack([-directions[:, 1], directions[:, 0]])
        return np.asarray(((found - at) * across).sum(axis=1))

    ahead = []
    for end, inner in ((clicks[0], clicks[1]), (clicks[-1], clicks[-2])):
        step = (end - inner) / np.hypot(*(end - inner))
        most = 0.0
        if not smooth and ((end >= 0) & (end <= limits)).all():
            most = min(_AHEAD_PX * per_px, steps_to_image_edge(end, step, limits))
        distances = np.arange(_EVERY_PX * per_px / 2, most, _EVERY_PX * per_px / 2)
        beyond = end + distances[:, None] * step
        ahead.append((distances, offsets(beyond, np.tile(step, (len(distances), 1)))))
    found = offsets(places, along)
    segments, ends = segments[inside], (ahead[0], ahead[1])
    shown = ~np.isnan(found) if sought.looks.kind == BAR else None
    empty = _emptiness(picture, places, along, shown)
    at_clicks = np.full(len(every), np.nan)
    bases, directions = _expected_clicks(clicks, smooth=smooth)
    across = np.column_stack([-directions[:, 1], directions[:, 0]])
    at_clicks[kept] = offsets(clicks, directions)
    if shown is None:  # on bare ground clicks may be farther off than lines are looked for
        expected = offsets(bases, directions) + ((bases - clicks) * across).sum(axis=1)
        bare = _emptiness(picture, clicks, directions, None) == 1.0
        at_clicks[kept] = np.where(np.isnan(at_clicks[kept]) & bare, expected, at_clicks[kept])
    return LineEvidence(size, places, found, segments, lengths, ends, empty, at_clicks)


def _expected_clicks(clicks: FloatArray, *, smooth: bool) -> tuple[FloatArray, FloatArray]:
    """(n, 2) px where the clicks around each one (n, 2) expect it, and (n, 2) unit directions of
    the element there; both ends as they are."""
    bases, directions = clicks.copy(), np.gradient(clicks, axis=0)
    for i in range(1, len(clicks) - 1):
        others = np.delete(clicks, i, axis=0)
        ends = np.stack([clicks[i - 1], clicks[i + 1]])
        course = _course(others, i - 1) if smooth else ends
        steps = np.diff(course, axis=0)
        lengths = np.maximum((steps * steps).sum(axis=1), 1e-9)
        along = np.clip(((clicks[i] - course[:-1]) * steps).sum(axis=1) / lengths, 0.0, 1.0)
        closest = course[:-1] + along[:, None] * steps
        nearest = np.hypot(*(closest - clicks[i]).T).argmin()
        bases[i], directions[i] = closest[nearest], steps[nearest]
    return bases, directions / np.maximum(np.hypot(*directions.T), 1e-9)[:, None]


# Px of the picture: what is averaged along an element, the line across it, and its sides.
_ALONG_PX, _LINE_PX, _SIDE_PX = 6, 1.0, (3.5, 8.0)
# Grey levels and colour differences of 255 after averaging, on shots with compression: worn paint
# stands out by 5 or more, grass by less than 2; on grass the line differs from its sides by less
# than 6 at 8 places of 10.
_FAINT_LINE, _SAME_COLOUR = 4.0, 6.0
_BAR_COLOUR = 60.0  # white in light and shadow
_HIDDEN = 0.5  # something is in sight there, which may hide the line


def _emptiness(
    picture: PixelArray, places: FloatArray, along: FloatArray, bar_shown: BoolArray | None
) -> FloatArray:
    """(n,) how surely there is no lighter line at places (n, 2) px with unit directions (n, 2), by
    what stands out over some px only: 1 on bare ground, 0 where something lighter is seen.

    Of a bar (n,) where it is shown: what is behind it may be as white, and is never ground.
    """
    steps = np.arange(-_ALONG_PX, _ALONG_PX + 1.0)[:, None]
    course = (places[:, None] + steps * along[:, None]).reshape(-1, 2)
    across = np.repeat(np.column_stack([-along[:, 1], along[:, 0]]), len(steps), axis=0)
    strip = straighten_curve(picture, course, across, _SIDE_PX[1])
    profiles = strip.colours.reshape(len(places), len(steps), -1, 3).mean(axis=1)
    near, far = _SIDE_PX
    zones = (-_LINE_PX, _LINE_PX), (-far, -near), (near, far)
    line, *sides = (profiles[:, strip.columns(*zone)].mean(axis=1) for zone in zones)
    differences = [line - side for side in sides]
    is_line = np.minimum(*(own.mean(axis=1) for own in differences)) >= _FAINT_LINE
    is_bare = np.minimum(*(np.linalg.norm(own, axis=1) for own in differences)) < _SAME_COLOUR
    if bar_shown is not None:
        usual = np.median(line[bar_shown], axis=0) if bar_shown.any() else np.inf
        is_bare = ~(np.linalg.norm(line - usual, axis=1) < _BAR_COLOUR)
    return np.where(is_line, 0.0, np.where(is_bare, 1.0, _HIDDEN))


def _places(
    clicks: FloatArray, per_px: float, *, smooth: bool
) -> tuple[FloatArray, FloatArray, IntArray, FloatArray]:
    """(n, 2) px evenly between clicks, (n, 2) directions, (n,) segments, (n,) px of length."""
    found = []
    for segment in range(len(clicks) - 1):
        course = _course(clicks, segment) if smooth else clicks[segment : segment + 2]
        at = arc_lengths(course)
        steps = np.diff(at)
        count = int(np.clip(round(at[-1] / (_EVERY_PX * per_px)), *_PLACES))
        middles = (np.arange(count) + 0.5) * at[-1] / count
        places = points_at_arc_lengths(course, middles, at)
        row = np.clip(np.searchsorted(at, middles) - 1, 0, len(steps) - 1)
        along = np.diff(course, axis=0)[row] / np.maximum(steps[row], 1e-9)[:, None]
        found.append((places, along, np.full(count, segment), np.full(count, at[-1] / count)))
    places, along, segments, lengths = (np.concatenate(part) for part in zip(*found, strict=True))
    return places, along, segments, lengths


def _course(clicks: FloatArray, segment: int) -> FloatArray:
    """(n, 2) px of a smooth curve between two clicks, by those around them (Catmull-Rom)."""
    begin, end = clicks[segment], clicks[segment + 1]
    first, last = max(segment - 1, 0), min(segment + 2, len(clicks) - 1)
    before, after = (end - clicks[first]) / 2, (clicks[last] - begin) / 2
    return hermite_curve(begin, end, before, after, _CURVE_STEPS)
