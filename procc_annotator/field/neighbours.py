"""Which elements of a field meet, and how far apart elements are."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.geometry import Geometry, Line, Spot, angles_of, at_angles, parts_of
from procc_annotator.field.model import Element, Field

FloatArray = NDArray[np.float64]

# By how much a curve leaves the chords that stand for it: metres at most, and of its radius.
_SAGITTA_M, _SAGITTA_SHARE = 0.02, 0.02
_MEET_M = 0.2  # paint has a width, and some lines end at another one's edge


def distances_between(field: Field) -> FloatArray:
    """(E, E) smallest distance between each two elements, metres, curves to a few centimetres."""
    return _distances(field.elements)


def meeting(field: Field, class_name: str) -> tuple[str, ...]:
    """The elements that touch or cross this one, in the field's order; () for an unknown class."""
    index = field.index.get(class_name)
    if index is None:
        return ()
    near = distances_between(field)[index] <= _MEET_M
    return tuple(e.name for i, e in enumerate(field.elements) if near[i] and i != index)


@lru_cache(maxsize=4)
def _distances(elements: tuple[Element, ...]) -> FloatArray:
    every, starts = _all_segments(elements)
    found = np.zeros((len(elements), len(elements)))
    for i, own in enumerate(np.split(every, starts[1:])):
        nearest = _apart(own, every).min(axis=0)
        found[i] = np.minimum.reduceat(nearest, starts)
    found.setflags(write=False)
    return found


def distances_to(elements: tuple[Element, ...], points: FloatArray) -> FloatArray:
    """(n, E) metres from places (n, 3) to the nearest place of each of some elements, to 2 cm."""
    every, starts = _all_segments(elements)
    begin, span = every[:, 0], every[:, 1] - every[:, 0]
    squares = np.maximum((span**2).sum(axis=1), 1e-12)
    # Products of matrices instead of (n, S, 3) arrays, which take ten times as long.
    along = points @ span.T - (begin * span).sum(axis=1)
    apart = (points**2).sum(axis=1)[:, None] - 2 * points @ begin.T + (begin**2).sum(axis=1)
    share = np.clip(along / squares, 0.0, 1.0)
    apart -= share * (2 * along - share * squares)
    return np.asarray(np.sqrt(np.maximum(np.minimum.reduceat(apart, starts, axis=1), 0.0)))


@lru_cache(maxsize=4)
def _all_segments(elements: tuple[Element, ...]) -> tuple[FloatArray, NDArray[np.intp]]:
    """(S, 2, 3) the segments of all elements, (E,) the first of each."""
    pieces = [_segments(e.geometry) for e in elements]
    return np.concatenate(pieces), np.cumsum([0, *(len(p) for p in pieces[:-1])])


def _segments(geometry: Geometry) -> FloatArray:
    """(n, 2, 3) both ends of segments that stand for a geometry; a spot is one without length."""
    found = []
    for part in parts_of(geometry):
        if isinstance(part, Line):
            points = np.array([part.start, part.end])
        elif isinstance(part, Spot):
            points = np.array([part.position, part.position])
        else:
            first, last = angles_of(part)
            step = 2 * math.acos(1 - min(_SAGITTA_M / part.radius, _SAGITTA_SHARE))
            points = at_angles(part, np.linspace(first, last, math.ceil((last - first) / step) + 1))
        found.append(np.stack([points[:-1], points[1:]], axis=1))
    return np.concatenate(found)


def _apart(one: FloatArray, other: FloatArray) -> FloatArray:
    """(n, m) smallest distances between segments (n, 2, 3) and (m, 2, 3).

    The nearest places of both lines, then the one on each segment nearest to the other's; see
    C. Ericson, Real-Time Collision Detection, 5.1.9.
    """
    along, across = one[:, 1] - one[:, 0], other[:, 1] - other[:, 0]
    between = one[:, None, 0] - other[None, :, 0]
    a = (along**2).sum(axis=1)[:, None]
    e = (across**2).sum(axis=1)[None]
    b = along @ across.T
    c = np.einsum("nmk,nk->nm", between, along)
    f = np.einsum("nmk,mk->nm", between, across)
    rise = a * e - b * b
    slanted = rise > 1e-12 * a * e
    s = np.where(slanted, (b * f - c * e) / np.where(slanted, rise, 1.0), 0.0).clip(0.0, 1.0)
    t = ((b * s + f) / np.where(e > 0, e, 1.0)).clip(0.0, 1.0)
    s = ((b * t - c) / np.where(a > 0, a, 1.0)).clip(0.0, 1.0)
    gap = between + s[..., None] * along[:, None] - t[..., None] * across[None]
    return np.asarray(np.sqrt((gap**2).sum(axis=2)))
