"""Annotated points and the primitives (lines, arcs, spots) they lie on, as solver arrays."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation, Polyline, points_px
from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.field.geometry import (
    Arc,
    Chain,
    Circle,
    Line,
    Part,
    Spot,
    angles_of,
    parts_of,
)
from procc_annotator.field.landmarks import landmark_covariances
from procc_annotator.field.model import Element, Field


@dataclass(frozen=True, eq=False)
class Primitives:
    """Primitives of E elements: L lines, C curves and S spots, numbered in this order.

    Attributes:
        line_ends: (3, 2 L) metres: the first ends of the lines, then their second.
        curve_frames: (3, 3 C) metres: centres of the curves, then from there to the middle of each
            arc, then to the point a quarter turn further.
        curve_half: (C,) rad: half of each arc's angle; infinite for a circle, which has no ends.
        spots: (3, S) metres.
        of_element: E arrays of numbers: the parts of each element.
    """

    line_ends: FloatArray
    curve_frames: FloatArray
    curve_half: FloatArray
    spots: FloatArray
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
        return cls(
            _as_columns([*(g.start for g in lines), *(g.end for g in lines)]),
            _as_columns(
                [g.centre for g in curves]
                + [_vector_from_centre(g, 0.0) for g in curves]
                + [_vector_from_centre(g, math.pi / 2) for g in curves]
            ),
            np.array(half, dtype=np.float64),
            _as_columns([part.position for part in flat if isinstance(part, Spot)]),
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


AnyArray = TypeVar("AnyArray", FloatArray, NDArray[np.bool_])

REFERENCE_WIDTH = 960
# No lens shows a point this far outside the picture; squares of larger numbers only do harm.
_MAX_COORDINATE_PX = 20000.0
_SAME_POINT_PX = 0.5
# More points on an element give a camera nothing more, but take their time.
MAX_POINTS = 64


@dataclass(frozen=True)
class ImageFrame:
    """The picture: its size, (width, height) px, the width of its pixels over their height, and the
    scale between them and those of the solver, which are square."""

    size: tuple[int, int]
    pixel_aspect: float = 1.0

    @property
    def scale(self) -> float:
        """Solver pixels per height of a picture pixel."""
        return (REFERENCE_WIDTH - 1) / (self.size[0] - 1) / self.pixel_aspect

    @property
    def scales(self) -> FloatArray:
        """(2,) solver pixels per picture pixel in x and y."""
        return np.array([self.scale * self.pixel_aspect, self.scale])

    @property
    def centre_px(self) -> tuple[float, float]:
        """Centre of the picture, px of the picture."""
        return (self.size[0] - 1) / 2, (self.size[1] - 1) / 2

    @cached_property
    def half_diagonal(self) -> float:
        """Half the picture's diagonal, solver px."""
        x, y = self.centre_px
        return float(np.hypot(x * self.pixel_aspect, y)) * self.scale


@dataclass(frozen=True, eq=False)
class Observations:
    """Annotated points of E elements; those on straight elements come first, on chains last.

    Attributes:
        elements: (E,) the field's elements: straight ones, arcs and circles, spots, chains.
        points: (2, N) solver px, origin at the picture's centre.
        element_of_point: (N,) index in `elements`.
        weights: (N,) weight of each point's squared distance: n^-1/2 for n points on an element,
            so that a circle of nine does not outvote a line of two; 0 leaves a point out.
        parts: what the elements are made of.
        spreads: (N, 3, 3) m^2: how surely the place of each point's spot is known, 0 for what is
            exact; None where everything is.
        soft: (2, 2, N) what the residual of each point is multiplied by, see `noise.softened`; None
            where they are taken as they are.
    """

    elements: tuple[Element, ...]
    points: FloatArray
    element_of_point: IntArray
    weights: FloatArray
    parts: Primitives
    spreads: FloatArray | None = None
    soft: FloatArray | None = None

    @cached_property
    def candidates(self) -> PrimitiveCandidates:
        """The parts that the points' feet may lie on."""
        return PrimitiveCandidates.of(self.parts, self.element_of_point)

    @cached_property
    def line_pairs(self) -> int:
        """Number of candidates on lines; they come first."""
        return int(np.searchsorted(self.candidates.part, self.parts.lines))

    @cached_property
    def curve_pairs(self) -> int:
        """Number of candidates on lines and curves; those on spots come last."""
        return int(np.searchsorted(self.candidates.part, self.parts.lines + self.parts.curves))

    @cached_property
    def line_of_pair(self) -> IntArray:
        """(candidates on lines,) line of each."""
        return self.candidates.part[: self.line_pairs]

    @cached_property
    def curve_of_pair(self) -> IntArray:
        """(candidates on curves,) curve of each."""
        return self.candidates.part[self.line_pairs : self.curve_pairs] - self.parts.lines

    @cached_property
    def spot_of_pair(self) -> IntArray:
        """(candidates on spots,) spot of each."""
        return self.candidates.part[self.curve_pairs :] - self.parts.lines - self.parts.curves

    @cached_property
    def first_spot(self) -> int:
        """Number of elements that come before the spots."""
        return sum(not e.is_spot and not isinstance(e.geometry, Chain) for e in self.elements)

    @cached_property
    def starts(self) -> IntArray:
        """(E,) first point of each element."""
        return np.searchsorted(self.element_of_point, np.arange(len(self.elements)))

    @cached_property
    def line_span(self) -> FloatArray:
        """(3, candidates on lines) metres: from the first to the second end of each one's line."""
        first, second = np.split(self.parts.line_ends, 2, axis=1)
        return np.asarray((second - first)[:, self.line_of_pair])

    @cached_property
    def line_first(self) -> FloatArray:
        """(3, candidates on lines) metres: the first end of each one's line."""
        return self.parts.line_ends[:, : self.parts.lines].take(self.line_of_pair, axis=1)

    def of_lines(self, table: AnyArray) -> AnyArray:
        """(..., B, lines) what B cameras say of lines -> (..., B, candidates on lines)."""
        return table.take(self.line_of_pair, axis=-1)

    def of_curves(self, table: AnyArray) -> AnyArray:
        """(..., B, curves) what B cameras say of curves -> (..., B, candidates on curves)."""
        return table.take(self.curve_of_pair, axis=-1)

    @cached_property
    def curve_half(self) -> FloatArray:
        """(candidates on curves,) rad: half of each one's arc."""
        return np.asarray(self.parts.curve_half[self.curve_of_pair])

    @cached_property
    def curve_frames(self) -> FloatArray:
        """(3, 3, candidates on curves) metres: of each one's curve the `Parts.curve_frames`."""
        frames = self.parts.curve_frames.reshape(3, 3, self.parts.curves)
        return frames.take(self.curve_of_pair, axis=2)

    def thinned(self, most: int) -> Observations:
        """At most so many points an element, evenly chosen, for a quick look."""
        keep = np.concatenate(
            [
                start + evenly_spaced_indices(count, most)
                for start, count in zip(self.starts, self.counts, strict=True)
            ]
        )
        return replace(
            self,
            points=self.points[:, keep],
            element_of_point=self.element_of_point[keep],
            weights=_point_weights(self.element_of_point[keep], len(self.elements)),
            spreads=None if self.spreads is None else self.spreads[keep],
            soft=None if self.soft is None else self.soft[:, :, keep],
        )

    @cached_property
    def counts(self) -> IntArray:
        """(E,) points of each element."""
        return np.bincount(self.element_of_point, minlength=len(self.elements))

    def on(self, field: Field) -> Observations:
        """The same points on the elements as another size of the same field has them."""
        elements = tuple(field.elements[field.index[e.name]] for e in self.elements)
        return replace(self, elements=elements, parts=Primitives.of(elements))

    def with_excluded(self, left_out: NDArray[np.bool_]) -> Observations:
        """The same, with weight 0 for the elements marked in ``left_out`` (E,)."""
        if not left_out.any():
            return self
        weights = np.where(left_out[self.element_of_point], 0.0, self.weights)
        return replace(self, weights=weights)

    def max_per_element(self, of_points: FloatArray) -> FloatArray:
        """(..., N) values of the points -> (..., E) the largest of each element."""
        return np.asarray(np.maximum.reduceat(of_points, self.starts, axis=-1))

    def mean_per_element(self, of_points: FloatArray) -> FloatArray:
        """(..., N) values of the points -> (..., E) the mean of each element."""
        return np.asarray(np.add.reduceat(of_points, self.starts, axis=-1) / self.counts)


def build_observations(
    annotation: FrameAnnotation,
    field: Field,
    frame: ImageFrame,
    *,
    ground_only: bool = False,
) -> Observations | None:
    """The points of an annotation on elements whose place on the field is known; None when there is
    nothing. If ``ground_only``, what is not on the ground is left out.

    Points that repeat another one of their element say nothing new and are left out, as are
    unconfirmed elements. Of an element with more than `MAX_POINTS` points so many are taken,
    evenly, its ends among them.
    """
    found: dict[int, FloatArray] = {}
    centre = np.array(frame.centre_px)
    for polyline in annotation:
        row = field.index.get(polyline.class_name)
        if row is None or not polyline.points:
            continue
        if ground_only and not field.elements[row].on_ground:
            continue
        px = (points_px(polyline, frame.size) - centre) * frame.scales
        used = _usable_points(px)
        if len(used):
            found[row] = px[used].clip(-_MAX_COORDINATE_PX, _MAX_COORDINATE_PX)
    if not found:
        return None
    # In the field's order, so that the result does not depend on the order in the file.
    order = sorted(found, key=lambda row: (_element_order(field.elements[row]), row))
    seen = _build_arrays([field.elements[row] for row in order], [found[row] for row in order])
    known = landmark_covariances(field) if field.landmarks else {}
    exact = np.zeros((3, 3))
    spreads = np.array([known.get(element.name, exact) for element in seen.elements])
    if not spreads.any():
        return seen
    return replace(seen, spreads=spreads[seen.element_of_point])


def used_point_indices(polyline: Polyline, frame: ImageFrame) -> IntArray:
    """(n,) places in a polyline of the points that `observe` takes, in its order."""
    if not polyline.points:
        return np.empty(0, dtype=np.intp)
    return _usable_points(
        (points_px(polyline, frame.size) - np.array(frame.centre_px)) * frame.scales
    )


def _usable_points(px: FloatArray) -> IntArray:
    finite = np.flatnonzero(np.isfinite(px).all(axis=1))
    if not len(finite):
        return finite
    chosen = finite[evenly_spaced_indices(len(finite), MAX_POINTS)]
    return chosen[_is_first_occurrence(px[chosen].clip(-_MAX_COORDINATE_PX, _MAX_COORDINATE_PX))]


def _build_arrays(elements: list[Element], points: list[FloatArray]) -> Observations:
    element_of_point = np.repeat(np.arange(len(elements)), [len(p) for p in points])
    return Observations(
        tuple(elements),
        np.ascontiguousarray(np.concatenate(points).T),
        element_of_point,
        _point_weights(element_of_point, len(elements)),
        Primitives.of(elements),
    )


def _element_order(element: Element) -> int:
    if isinstance(element.geometry, Chain):
        return 3
    return 0 if element.is_straight else 2 if element.is_spot else 1


def _point_weights(element_of_point: IntArray, elements: int) -> FloatArray:
    counts = np.bincount(element_of_point, minlength=elements)
    return np.asarray(1.0 / np.sqrt(counts[element_of_point]))


def evenly_spaced_indices(count: int, most: int) -> IntArray:
    """Evenly spread places among so many, the first and the last among them; all if not many."""
    if count <= most:
        return np.arange(count)
    return np.unique(np.linspace(0, count - 1, most).round().astype(np.intp))


def _is_first_occurrence(px: FloatArray) -> NDArray[np.bool_]:
    """(n,) whether each point is at another place than all earlier ones."""
    squares = ((px[:, None] - px[None]) ** 2).sum(axis=-1)
    return np.asarray(~np.tril(squares < _SAME_POINT_PX**2, -1).any(axis=1))


HALF_WIDTH_PX = REFERENCE_WIDTH / 2
