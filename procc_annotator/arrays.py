"""Array types that every package uses, runs of a mask, short texts of values with arrays."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import fields
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.intp]
BoolArray = NDArray[np.bool_]


def true_runs(mask: BoolArray) -> list[tuple[int, int]]:
    """First and one past the last index of each run of True in (n,)."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], mask, [False]))))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


class BriefRepr:
    """Mixin of dataclasses (``repr=False``) whose values are large: one short line."""

    def __repr__(self) -> str:
        shown = ((one.name, getattr(self, one.name)) for one in fields(cast(Any, self)) if one.repr)
        return f"{type(self).__name__}({', '.join(f'{n}={_brief(v)}' for n, v in shown)})"


def _brief(value: object) -> str:
    if isinstance(value, np.ndarray):
        return f"<{value.shape} {value.dtype}>"
    if isinstance(value, Collection) and not isinstance(value, str) and len(value) > 3:
        return f"<{len(value)} items>"
    text = repr(value)
    return text if len(text) <= 80 else f"{text[:77]}..."
