"""The geometry of annotated elements as arrays: every line, curve and spot they are made of.

Most elements are one such part. A chain has several; a point of it belongs to the nearest one.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.geometry import (
    SAME_PLACE_M,
    Arc,
    Chain,
    Circle,
    Line,
    Part,
    Spot,
    angles_of,
    points_at_angles,
    ends_of,
    parts_of,
)
from procc_annotator.field.model import Element

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.intp]
BoolArray = NDArray[np.bool_]

# A chain that turns by less at a joint goes on smoothly: a point off it lies across one part.
_SMOOTH_JOINT_COSINE = math.cos(math.radians(10))


@dataclass(frozen=True, eq=False)
class Primitives:
    """What E elements are made of: L lines, C curves and S spots, numbered in this order.

    Attributes:
        line_ends: (3, 2 L) metres: the first ends of the lines, then their second.
        curve_frames: (3, 3 C) metres: centres of the curves, then from there to the middle of each
            arc, then to the point a quarter turn further.
        curve_half: (C,) rad: half of each arc's angle; infinite for a circle, which has no ends.
        spots: (3, S) metres.
        ends: (2, L + C + S) whether a part ends there, at its first and at its second end: not
            where the next part of its chain goes on smoothly.
        of_element: E arrays of numbers: the parts of each element.
    """

    line_ends: FloatArray
    curve_frames: FloatArray
    curve_half: FloatArray
    spots: FloatArray
    ends: BoolArray
    of_element: tuple[IntArray, ...]

    @classmethod
    def of(cls, elements: Sequence[Element]) -> Primitives:
        """Take elements apart."""
        shapes = [parts_of(e.geometry) for e in elements]
        flat = [part for own in shapes for part in own]
        kinds = np.array([_primitive_order(part) for part in flat], dtype=np.intp)
        order = np.argsort(kinds, kind="stable")
        number = np.empty_like(order)
        number[order] = np.arange(len(order))
        until = np.cumsum([len(own) for own in shapes])
        lines = [part for part in flat if isinstance(part, Line)]
        curves = [part for part in flat if isinstance(part, Arc | Circle)]
        half = [(g.end_rad - g.start_rad) / 2 if isinstance(g, Arc) else np.inf for g in curves]
        ends = np.concatenate([_end_flags(e) for e in elements], axis=1)
        return cls(
            _as_columns([*(g.start for g in lines), *(g.end for g in lines)]),
            _as_columns(
                [g.centre for g in curves]
                + [_vector_from_centre(g, 0.0) for g in curves]
                + [_vector_from_centre(g, math.pi / 2) for g in curves]
            ),
            np.array(half, dtype=np.float64),
            _as_columns([part.position for part in flat if isinstance(part, Spot)]),
            ends[:, order],
            tuple(np.split(number, until[:-1])),
        )

    @property
    def lines(self) -> int:
        """Number of lines."""
        return int(self.line_ends.shape[-1]) // 2

    @property
    def curves(self) -> int:
        """Number of arcs and circles."""
        return int(self.curve_half.shape[-1])

    @cached_property
    def all_have_ends(self) -> bool:
        """Whether all parts end at their ends: without smooth chains they do."""
        return bool(self.ends.all())


@dataclass(frozen=True, eq=False)
class PrimitiveCandidates:
    """The parts that the feet of N points may lie on: K pairs of a point and a part.

    Attributes:
        point: (K,) point of each pair; None where every point has one part: pair i is of point i.
        part: (K,) its part; in rising order, so those on lines come first, then those on curves.
        of_point: (N, most) the pairs of each point, its first one again where it has fewer; None
            where every point has one part.
    """

    point: IntArray | None
    part: IntArray
    of_point: IntArray | None

    @classmethod
    def of(cls, parts: Primitives, element_of_point: IntArray) -> PrimitiveCandidates:
        """All pairs; the elements that have one part each come in the order of these parts."""
        counts = np.array([len(own) for own in parts.of_element])
        if (counts == 1).all():
            return cls(None, np.concatenate(parts.of_element)[element_of_point], None)
        per_point = counts[element_of_point]
        point = np.repeat(np.arange(len(element_of_point)), per_point)
        part = np.concatenate([parts.of_element[e] for e in element_of_point])
        order = np.argsort(part, kind="stable")
        place = np.empty_like(order)
        place[order] = np.arange(len(order))
        first = np.cumsum(per_point) - per_point
        step = np.arange(per_point.max())
        within = np.where(step < per_point[:, None], step, 0)
        return cls(point[order], part[order], place[first[:, None] + within])


def _primitive_order(part: Part) -> int:
    return 0 if isinstance(part, Line) else 2 if isinstance(part, Spot) else 1


def _as_columns(vectors: Iterable[Sequence[float]]) -> FloatArray:
    return np.array(list(vectors), dtype=np.float64).reshape(-1, 3).T.copy()


def _vector_from_centre(curve: Arc | Circle, further_rad: float) -> Sequence[float]:
    """From a curve's centre to the middle of its arc, or so much further round."""
    middle = sum(angles_of(curve)) / 2 if isinstance(curve, Arc) else 0.0
    along, across = math.cos(middle + further_rad), math.sin(middle + further_rad)
    both = zip(curve.ahead, curve.aside, strict=True)
    return [curve.radius * (along * a + across * b) for a, b in both]


def _end_flags(element: Element) -> BoolArray:
    """(2, parts) whether the parts of an element end at their first and their second end."""
    shape = element.geometry
    if not isinstance(shape, Chain):
        return np.ones((2, 1), dtype=bool)
    count = len(shape.parts)
    found = np.ones((2, count), dtype=bool)
    followers = range(count if ends_of(shape) is None else count - 1)
    for one in followers:
        other = (one + 1) % count
        if _continues_smoothly(shape.parts[one], shape.parts[other]):
            found[1, one] = found[0, other] = False
    return found


def _continues_smoothly(one: Line | Arc, other: Line | Arc) -> bool:
    return bool(_end_direction(one, 1) @ _end_direction(other, 0) > _SMOOTH_JOINT_COSINE)


def _end_direction(part: Line | Arc, end: int) -> FloatArray:
    """(3,) unit vector: where a part leads at its first or second end."""
    if isinstance(part, Line):
        span = np.subtract(part.end, part.start)
        return np.asarray(span / max(float(np.linalg.norm(span)), SAME_PLACE_M))
    angle = np.array([angles_of(part)[end] + math.pi / 2])
    return np.asarray((points_at_angles(part, angle)[0] - part.centre) / part.radius)
