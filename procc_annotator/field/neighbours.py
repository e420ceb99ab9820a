"""Which elements of a field meet, and how far apart elements are."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.geometry import Line, Part, Spot, angles_of, at_angles, parts_of
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sample import sample_every

FloatArray = NDArray[np.float64]

_SPACING_M = 0.25
_MEET_M = 0.2  # samples of an element that crosses another are at most this far from it
_SAGITTA_M = 0.02


def distances_between(field: Field) -> FloatArray:
    """(E, E) smallest distance between each two elements, metres, to about a quarter of a metre."""
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
    samples = sample_every(Field("", "", (), elements), _SPACING_M)
    found = np.array(
        [distances_to(elements, samples.of(i)).min(axis=0) for i in range(len(elements))]
    )
    found.setflags(write=False)
    return found


def distances_to(elements: tuple[Element, ...], points: FloatArray) -> FloatArray:
    """(n, E) metres from places (n, 3) to the nearest place of each element.

    Args:
        elements: of a field; curves are taken for chords that leave them by at most 2 cm.
        points: metres, world frame.
    """
    begin, span, first = _chords(elements)
    squares = np.maximum((span**2).sum(axis=1), 1e-12)
    # Products of matrices instead of (n, S, 3) arrays, which take ten times as long.
    along = points @ span.T - (begin * span).sum(axis=1)
    offset = (points**2).sum(axis=1)[:, None] - 2 * points @ begin.T + (begin**2).sum(axis=1)
    share = np.clip(along / squares, 0.0, 1.0)
    apart = offset - share * (2 * along - share * squares)
    return np.asarray(np.sqrt(np.maximum(np.minimum.reduceat(apart, first, axis=1), 0.0)))


@lru_cache(maxsize=4)
def _chords(elements: tuple[Element, ...]) -> tuple[FloatArray, FloatArray, NDArray[np.intp]]:
    """(S, 3) first ends of all elements' chords, (S, 3) their spans, (E,) first of each element."""
    ends: list[tuple[FloatArray, FloatArray]] = []
    counts = []
    for element in elements:
        own = [_course(part) for part in parts_of(element.geometry)]
        ends += [(course[:-1], course[1:]) for course in own]
        counts.append(sum(len(course) - 1 for course in own))
    begin = np.concatenate([one for one, _ in ends])
    span = np.concatenate([other for _, other in ends]) - begin
    return begin, span, np.cumsum([0, *counts[:-1]])


def _course(part: Part) -> FloatArray:
    """(n, 3) metres, n >= 2: what a part is taken for."""
    if isinstance(part, Line):
        return np.array([part.start, part.end])
    if isinstance(part, Spot):
        return np.array([part.position, part.position])
    first, last = angles_of(part)
    widest = 2 * np.arccos(max(1 - _SAGITTA_M / part.radius, 0.0))
    return at_angles(part, np.linspace(first, last, int(np.ceil((last - first) / widest)) + 1))
