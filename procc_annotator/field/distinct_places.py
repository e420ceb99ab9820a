"""Places of a field that can be told from all others on their lines: ends, corners, crossings."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.geometry import (
    Arc,
    Chain,
    Circle,
    Spot,
    angles_of,
    points_at_angles,
    ends_of,
    parts_of,
)
from procc_annotator.field.model import Element

FloatArray = NDArray[np.float64]

_CROSSING_CHORD_M = 0.25
_SAME_POINT_M = 0.05
_PARALLEL = 1e-6


@lru_cache(maxsize=16)
def distinctive_points(elements: tuple[Element, ...]) -> tuple[tuple[str, ...], FloatArray]:
    """Ends, corners of chains, spots, and where elements on the ground cross.

    Args:
        elements: of a field.

    Returns:
        The class that each is on, of those that share it the first; and (n, 3) metres.
    """
    names: list[str] = []
    places: list[FloatArray] = []
    for element in elements:
        own = [np.array(place) for place in _end_points(element)]
        names += [element.name] * len(own)
        places += own
    crossing_names, crossings = _crossings(elements)
    names += crossing_names
    every = np.array([*places, *crossings]).reshape(-1, 3)
    kept: list[int] = []
    for row, place in enumerate(every):
        if not kept or np.linalg.norm(every[kept] - place, axis=1).min() > _SAME_POINT_M:
            kept.append(row)
    return tuple(names[row] for row in kept), every[kept]


def _end_points(element: Element) -> list[tuple[float, float, float]]:
    """The ends of an element and of its parts."""
    geometry = element.geometry
    if isinstance(geometry, Spot):
        return [geometry.position]
    parts = parts_of(geometry) if isinstance(geometry, Chain) else (geometry,)
    return [end for part in parts for end in ends_of(part) or ()]


def _crossings(elements: tuple[Element, ...]) -> tuple[list[str], FloatArray]:
    """Where chords of elements on the ground cross those of others; (n, 3) metres."""
    flat = [e for e in elements if e.on_ground and not isinstance(e.geometry, Spot)]
    chords = [_element_chords(e) for e in flat]
    if not chords:
        return [], np.empty((0, 3))
    owner = np.repeat(np.arange(len(flat)), [len(c) for c in chords])
    every = np.concatenate(chords)
    begin, step = every[:, 0], every[:, 1] - every[:, 0]
    turn = step[:, None, 0] * step[None, :, 1] - step[:, None, 1] * step[None, :, 0]
    apart = begin[None] - begin[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        along = (apart[..., 0] * step[None, :, 1] - apart[..., 1] * step[None, :, 0]) / turn
    inside = (along >= 0) & (along <= 1) & (np.abs(turn) > _PARALLEL)
    first, second = np.nonzero(inside & inside.T & (owner[:, None] < owner[None]))
    places = begin[first] + along[first, second][:, None] * step[first]
    names = [flat[owner[row]].name for row in first.tolist()]
    return names, np.column_stack([places, np.zeros(len(places))])


def _element_chords(element: Element) -> FloatArray:
    """(n, 2, 2) metres: begin and end of what stands for an element on the ground."""
    found = []
    for part in parts_of(element.geometry):
        if isinstance(part, Arc | Circle):
            begin, end = angles_of(part)
            count = max(2, int(abs(end - begin) * part.radius / _CROSSING_CHORD_M))
            course = points_at_angles(part, np.linspace(begin, end, count + 1))[:, :2]
        else:
            course = np.array([end[:2] for end in ends_of(part) or ()])
        found.append(np.stack([course[:-1], course[1:]], axis=1))
    return np.concatenate(found)
