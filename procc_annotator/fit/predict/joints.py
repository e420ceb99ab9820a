"""How a straight element ends that is expected in a picture: how surely, and at which others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.field.geometry import Line
from procc_annotator.field.model import Field
from procc_annotator.field.neighbours import distances_to
from procc_annotator.fit.predict.sight import VisibleStretch, visible_stretches
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.observations import FloatArray
from procc_annotator.metric.course import arc_lengths, points_at_arc_lengths

_JOINT_TOLERANCE_M = 0.2  # paint has a width, and some lines end at another one's edge
_JOINT_WINDOW_PX = 80.0
_BAR_WINDOW_PX = 240.0  # of one: letters and boards behind it are shorter than it
_MIN_JOINT_LENGTH_PX = 15.0


@dataclass(frozen=True, eq=False)
class ElementJoint:
    """Another element at an end of an element.

    Attributes:
        name: the other class.
        course_px: (n, 2) px around that end, where the camera expects the other element, n >= 2.
    """

    name: str
    course_px: FloatArray


@dataclass(frozen=True, eq=False)
class ExpectedEnd:
    """An end that the field gives an element.

    Attributes:
        place_px: (2,) px, where the camera expects it.
        sd_px: its standard deviation along the element, px.
        joints: the elements that it lies at.
    """

    place_px: FloatArray
    sd_px: float
    joints: tuple[ElementJoint, ...] = ()


# An element's first and its last end; None where the picture's edge cuts it off.
ExpectedEnds = tuple[ExpectedEnd | None, ExpectedEnd | None]


def expected_ends(stretches: Sequence[VisibleStretch], field: Field, fit: FitResult) -> dict[str, ExpectedEnds]:
    """The ends of straight elements, by class.

    Args:
        stretches: of any elements in the picture of the fit's camera.
        field: the elements, metres.
        fit: with a camera.
    """
    lines = {e.name: e.geometry for e in field.elements if isinstance(e.geometry, Line)}
    straight = [s for s in stretches if s.name in lines]
    if not straight or fit.camera is None:
        return {}
    world = np.concatenate([s.points_world[[0, -1]] for s in straight])
    apart = distances_to(field.elements, world).reshape(len(straight), 2, -1)
    along = np.concatenate([_outward_directions(s.points_px) for s in straight])
    sd = np.hypot(fit.projected_sd(world, along), fit.offset_px).reshape(-1, 2)
    shown: dict[str, list[FloatArray]] = {}
    for stretch in visible_stretches(field, fit.camera, fit.size):
        shown.setdefault(stretch.name, []).append(stretch.points_px)
    found: dict[str, ExpectedEnds] = {}
    for row, stretch in enumerate(straight):
        line = lines[stretch.name]
        corners = np.array([line.start, line.end])
        ends: list[ExpectedEnd | None] = []
        for k, end in enumerate((0, -1)):
            off = np.linalg.norm(corners - stretch.points_world[end], axis=1)
            if off.min() > 1e-6:
                ends.append(None)
                continue
            others = [field.elements[i] for i in np.flatnonzero(apart[row, k] <= _JOINT_TOLERANCE_M)]
            place = stretch.points_px[end]
            joints = (
                ElementJoint(other.name, around)
                for other in others
                for course in (shown.get(other.name, ()) if other.name != stretch.name else ())
                if (around := _curve_near(course, place, on_ground=other.on_ground)) is not None
            )
            ends.append(ExpectedEnd(place, float(sd[row, k]), tuple(joints)))
        found[stretch.name] = ends[0], ends[1]
    return found


def _outward_directions(course: FloatArray) -> FloatArray:
    """(2, 2) unit vectors along a course at both of its ends."""
    steps = np.array([course[0] - course[1], course[-1] - course[-2]])
    return np.asarray(steps / np.maximum(np.hypot(*steps.T), 1e-12)[:, None])


def _curve_near(course: FloatArray, place: FloatArray, *, on_ground: bool) -> FloatArray | None:
    """What of a course lies around a place, every pixel; None: too little."""
    lengths = arc_lengths(course)
    nearest = lengths[np.hypot(*(course - place).T).argmin()]
    reach = _JOINT_WINDOW_PX if on_ground else _BAR_WINDOW_PX
    begin = max(0.0, nearest - reach)
    end = min(float(lengths[-1]), nearest + reach)
    if end - begin < _MIN_JOINT_LENGTH_PX:
        return None
    at = np.linspace(begin, end, round(end - begin) + 1)
    return points_at_arc_lengths(course, at, lengths)
