"""Which elements of a field meet, and how far apart elements are."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.model import Element, Field
from procc_annotator.field.sample import sample_every

FloatArray = NDArray[np.float64]

_SPACING_M = 0.25
_MEET_M = 0.2  # samples of elements that cross are at most this far apart


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
    points = [samples.of(i) for i in range(len(elements))]
    starts = np.cumsum([0, *(len(p) for p in points[:-1])])
    every = np.concatenate(points)
    squares = (every**2).sum(axis=1)
    found = np.zeros((len(elements), len(elements)))
    for i, own in enumerate(points):
        # |a - b|^2 by one product of matrices: all pairs at once would take a tenth of a second.
        apart = squares - 2 * own @ every.T
        nearest = (apart + (own**2).sum(axis=1)[:, None]).min(axis=0)
        found[i] = np.sqrt(np.maximum(np.minimum.reduceat(nearest, starts), 0.0))
    found.setflags(write=False)
    return found
