"""What says where a straight element ends that is expected in a picture: those it ends at."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.base import Camera
from procc_annotator.field.geometry import Line
from procc_annotator.field.model import Field
from procc_annotator.field.neighbours import distances_to
from procc_annotator.fit.predict.sight import Stretch, stretches_in_sight
from procc_annotator.fit.solving.observations import FloatArray

_MEET_M = 0.2  # paint has a width, and some lines end at another one's edge
_AROUND_PX = 80.0
_LEAST_PX = 15.0


@dataclass(frozen=True, eq=False)
class Joint:
    """Another element at one end of an element.

    Attributes:
        last: whether it is at the last point of its stretch, or at the first.
        name: the other class.
        course_px: (n, 2) px around that end, where the camera expects the other element, n >= 2.
        end_px: (2,) px, that end.
    """

    last: bool
    name: str
    course_px: FloatArray
    end_px: FloatArray


def joints_of(
    stretches: Sequence[Stretch], field: Field, camera: Camera, size: tuple[int, int]
) -> dict[str, tuple[Joint, ...]]:
    """The joints of straight elements, of those ends that the field gives them.

    Args:
        stretches: of any elements in the camera's picture; an end at the picture's edge has none.
        field: the elements, metres.
        camera: in px of the picture.
        size: (width, height) px.
    """
    lines = {e.name: e.geometry for e in field.elements if isinstance(e.geometry, Line)}
    straight = [s for s in stretches if s.name in lines]
    if not straight:
        return {}
    ends = np.concatenate([s.points_world[[0, -1]] for s in straight])
    apart = distances_to(field.elements, ends).reshape(len(straight), 2, -1)
    shown: dict[str, list[FloatArray]] = {}
    for stretch in stretches_in_sight(field, camera, size):
        shown.setdefault(stretch.name, []).append(stretch.points_px)
    found: dict[str, list[Joint]] = {}
    for stretch, near in zip(straight, apart <= _MEET_M, strict=True):
        line = lines[stretch.name]
        corners = np.array([line.start, line.end])
        for end in (0, -1):
            off = np.linalg.norm(corners - stretch.points_world[end], axis=1)
            if off.min() > 1e-6:
                continue  # cut by the picture's edge
            for index in np.flatnonzero(near[end]).tolist():
                name = field.elements[index].name
                for course in shown.get(name, ()) if name != stretch.name else ():
                    around = _around(course, stretch.points_px[end])
                    if around is not None:
                        joint = Joint(end == -1, name, around, stretch.points_px[end])
                        found.setdefault(stretch.name, []).append(joint)
    return {name: tuple(joints) for name, joints in found.items()}


def _around(course: FloatArray, place: FloatArray) -> FloatArray | None:
    """What of a course lies around a place, every pixel; None: too little."""
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(course, axis=0).T))])
    nearest = lengths[np.hypot(*(course - place).T).argmin()]
    begin = max(0.0, nearest - _AROUND_PX)
    end = min(float(lengths[-1]), nearest + _AROUND_PX)
    if end - begin < _LEAST_PX:
        return None
    at = np.linspace(begin, end, round(end - begin) + 1)
    return np.column_stack([np.interp(at, lengths, course[:, k]) for k in (0, 1)])
