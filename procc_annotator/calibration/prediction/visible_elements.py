"""Stretches of field elements inside the image, and where their ends are expected."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, true_runs
from procc_annotator.camera.base import Camera
from procc_annotator.field.geometry import Spot, Vector
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sampling import FieldSamples, sample_evenly

ImageSize = tuple[int, int]

# Lines at less than about six degrees have no corner that two clicks could determine.
_MIN_CROSSING_SINE = 0.1


def expected_line_end(
    end: FloatArray,
    inner: FloatArray,
    lines: Sequence[FloatArray],
    size: ImageSize | None,
    reach_px: float,
) -> FloatArray | None:
    """Return where the end of a straight element belongs.

    Args:
        end: (2,) px, its last point.
        inner: (2,) px, the point before.
        lines: (n, 2) px each: the clicks of annotated straight elements that it meets.
        size: (width, height) px of the picture; None for corners alone.
        reach_px: how far the end may be moved, along its own line.

    Returns:
        (2,) px: the nearest corner within reach, else the picture's edge; None where neither is.
    """
    along = end - inner
    length = float(np.hypot(*along))
    if length < 1e-6:
        return None
    along = along / length
    corners = [
        corner for line in lines if (corner := _segment_intersection(end, along, line)) is not None
    ]
    near = [c for c in corners if np.hypot(*(c - end)) <= reach_px]
    if near:
        return min(near, key=lambda c: float(np.hypot(*(c - end))))
    edge = None if size is None else image_edge_point(end, along, size)
    return edge if edge is not None and np.hypot(*(edge - end)) <= reach_px else None


def _segment_intersection(
    end: FloatArray, along: FloatArray, line: FloatArray
) -> FloatArray | None:
    """Return where the ray's line meets the end segment of another polyline that is nearer, px."""
    first = np.hypot(*(line[0] - end)) <= np.hypot(*(line[-1] - end))
    begin, other = (line[0], line[1]) if first else (line[-1], line[-2])
    across = other - begin
    determinant = along[0] * -across[1] + along[1] * across[0]
    # Not "<": two clicks in one place have no direction.
    if abs(determinant) <= _MIN_CROSSING_SINE * float(np.hypot(*across)):
        return None
    offset = begin - end
    distance = (offset[0] * -across[1] + offset[1] * across[0]) / determinant
    found: FloatArray = end + distance * along
    return found


def image_edge_point(end: FloatArray, along: FloatArray, size: ImageSize) -> FloatArray | None:
    """Return where the ray from a place (2,) px in the picture in a direction (2,) leaves it; None
    from outside."""
    limits = np.array(size, dtype=np.float64) - 1
    if (end < 0).any() or (end > limits).any():
        return None
    found: FloatArray = end + steps_to_image_edge(end, along, limits) * along
    return np.clip(found, 0.0, limits)


def steps_to_image_edge(place: FloatArray, step: FloatArray, limits: FloatArray) -> float:
    """Return how many steps (2,) lead from a place (2,) px inside the picture to its edge; infinity
    for a step of no length. Limits (2,): the last column and row; the first ones are 0."""
    with np.errstate(divide="ignore", invalid="ignore"):
        steps = np.where(
            step > 0, (limits - place) / step, np.where(step < 0, -place / step, np.inf)
        )
    return float(steps.min())


_SAMPLE_SPACING_M = 0.25
# Neighbouring samples of what is smooth turn by 15 degrees at most.
_CORNER_COSINE = math.cos(math.radians(25.0))


@dataclass(frozen=True, eq=False)
class VisibleStretch:
    """A stretch of an element inside the picture, in the element's direction.

    Attributes:
        points_px: (n, 2) px of the picture, dense, n >= 2.
        points_world: (n, 3) the same points, metres.
        length_px: along it.
    """

    name: str
    points_px: FloatArray
    points_world: FloatArray
    length_px: float


def split_at_corners(stretch: VisibleStretch) -> tuple[VisibleStretch, ...]:
    """A stretch of a chain in the parts that its corners cut it into; any other one as it is."""
    steps = np.diff(stretch.points_world, axis=0)
    steps /= np.maximum(np.linalg.norm(steps, axis=1, keepdims=True), 1e-12)
    corners = np.flatnonzero((steps[1:] * steps[:-1]).sum(axis=1) < _CORNER_COSINE) + 1
    if not len(corners):
        return (stretch,)
    bounds = [0, *corners.tolist(), len(stretch.points_px) - 1]
    found = []
    for begin, last in pairwise(bounds):
        px, world = stretch.points_px[begin : last + 1], stretch.points_world[begin : last + 1]
        length = float(np.hypot(*np.diff(px, axis=0).T).sum())
        found.append(VisibleStretch(stretch.name, px, world, length))
    return tuple(found)


def visible_spots(
    field: Field, camera: Camera, size: tuple[int, int], without: Collection[str] = ()
) -> dict[str, Vector]:
    """The spots that lie inside the picture, by geometry alone: name -> metres; see
    `visible_stretches`."""
    spots = {
        e.name: e.geometry.position
        for e in field.elements
        if isinstance(e.geometry, Spot) and e.name not in without
    }
    if not spots:
        return {}
    px, shown = camera.project(np.array(list(spots.values())))
    limits = np.array(size, dtype=np.float64) - 1
    inside = shown & ((px >= 0) & (px <= limits)).all(axis=1)
    return {name: spots[name] for name, seen in zip(spots, inside.tolist(), strict=True) if seen}


def visible_stretches(
    field: Field, camera: Camera, size: tuple[int, int], without: Collection[str] = ()
) -> tuple[VisibleStretch, ...]:
    """The stretches of the field's elements that lie inside the picture, by geometry alone; spots,
    and classes ``without``, have none.

    Nothing is known of what stands in front of them. An element that leaves the picture and comes
    back has several stretches; they end exactly at the picture's edge. A circle's stretches begin
    after its longest one outside.
    """
    samples = _element_samples(field.elements)
    world = samples.points_world
    px, shown = camera.project(world)
    limits = np.array(size, dtype=np.float64) - 1
    inside = shown & ((px >= 0) & (px <= limits)).all(axis=1)
    found: list[VisibleStretch] = []
    for row in np.unique(
        np.searchsorted(samples.offsets, np.flatnonzero(inside), side="right") - 1
    ):
        name = samples.names[row]
        if name in without:
            continue
        rows = np.arange(samples.offsets[row], samples.offsets[row + 1])
        if samples.closed[row]:
            rows = _rotate_circle_start(rows, inside)
        found.extend(_clip_stretch(name, px[rows], world[rows], shown[rows], inside[rows], limits))
    return tuple(found)


@lru_cache(maxsize=16)
def _element_samples(elements: tuple[Element, ...]) -> FieldSamples:
    return sample_evenly(Field("", "", (), elements), _SAMPLE_SPACING_M)


def _rotate_circle_start(rows: NDArray[np.intp], inside: NDArray[np.bool_]) -> NDArray[np.intp]:
    """The rows of a circle, begun in the middle of the longest stretch outside the picture."""
    around = rows[:-1]
    out = ~inside[around]
    if not out.any():
        return rows
    runs = true_runs(np.concatenate([out, out]))
    begin, end = max(runs, key=lambda run: run[1] - run[0])
    middle = ((begin + end) // 2) % len(around)
    turned = np.roll(around, -middle)
    return np.append(turned, turned[0])


def _clip_stretch(
    name: str,
    px: FloatArray,
    world: FloatArray,
    shown: NDArray[np.bool_],
    inside: NDArray[np.bool_],
    limits: FloatArray,
) -> list[VisibleStretch]:
    stretches = []
    for begin, end in true_runs(inside):
        rows = np.arange(begin, end)
        course, places = px[rows], world[rows]
        if begin > 0 and shown[begin - 1]:
            share = _exit_share(px[begin], px[begin - 1], limits)
            course = np.vstack([px[begin] + share * (px[begin - 1] - px[begin]), course])
            places = np.vstack([world[begin] + share * (world[begin - 1] - world[begin]), places])
        if end < len(px) and shown[end]:
            last = end - 1
            share = _exit_share(px[last], px[end], limits)
            course = np.vstack([course, px[last] + share * (px[end] - px[last])])
            places = np.vstack([places, world[last] + share * (world[end] - world[last])])
        steps = np.hypot(*np.diff(course, axis=0).T)
        kept = np.concatenate([[True], steps > 1e-9])
        if kept.sum() >= 2:
            stretches.append(VisibleStretch(name, course[kept], places[kept], float(steps.sum())))
    return stretches


def _exit_share(inner: FloatArray, outer: FloatArray, limits: FloatArray) -> float:
    """The share of the way from inside to outside at which the picture's edge is reached."""
    return min(max(steps_to_image_edge(inner, outer - inner, limits), 0.0), 1.0)
