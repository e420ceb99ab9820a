"""The field laid flat: every element as a line on the map, and which one is under the cursor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.model import Field
from procc_annotator.field.sample import sample_every

FloatArray = NDArray[np.float64]

# Goals are unfolded larger than life: at true scale a crossbar would lie 7 px behind the goal line
# on a map 300 px wide, too near to be clicked.
_UNFOLD = 2.4
_SPACING_M = 1.0


@dataclass(frozen=True, eq=False)
class FieldShape:
    """Elements as polylines on the map.

    Attributes:
        names: (E,) element names.
        lines: (E,) arrays (n, 2) of map metres: x along the field, y across, the main camera's side
            down; what stands upright is laid outwards behind its end of the field.
        lengths: (E,) metres on the map.
        bounds: (left, top, right, bottom) in map metres.
        ground: the same of the elements on the ground.
    """

    names: tuple[str, ...]
    lines: tuple[FloatArray, ...]
    lengths: FloatArray
    bounds: tuple[float, float, float, float]
    ground: tuple[float, float, float, float]

    @classmethod
    def of(cls, field: Field) -> FieldShape:
        samples = sample_every(field, _SPACING_M)
        flat = unfold(samples.points_world)
        lines = []
        for i, element in enumerate(field.elements):
            line = flat[samples.offsets[i] : samples.offsets[i + 1]]
            lines.append(line[[0, -1]] if element.is_straight else line)
        lengths = np.array([np.linalg.norm(np.diff(p, axis=0), axis=1).sum() for p in lines])
        ground = np.concatenate(
            [p for p, e in zip(lines, field.elements, strict=True) if e.on_ground]
        )
        return cls(samples.names, tuple(lines), lengths, _bounds(flat), _bounds(ground))

    def pick(self, x: float, y: float, tolerance: float) -> str | None:
        """The element nearest to a map position, within a tolerance (metres on the map).

        Where two are about equally near (a post on its goal line) the shorter one is meant: the
        longer one can be picked elsewhere.
        """
        distances = np.array([_distance(line, x, y) for line in self.lines])
        near = np.flatnonzero(distances <= min(tolerance, distances.min() + tolerance / 4))
        if not near.size:
            return None
        return self.names[int(near[np.argmin(self.lengths[near])])]


def unfold(points_world: FloatArray) -> FloatArray:
    """(n, 2) map metres of points of elements, (n, 3) metres."""
    flat = points_world[:, :2].copy()
    height = -points_world[:, 2]
    flat[:, 0] += np.sign(flat[:, 0]) * height * _UNFOLD
    return flat


def _bounds(points: FloatArray) -> tuple[float, float, float, float]:
    left, top = points.min(axis=0)
    right, bottom = points.max(axis=0)
    return float(left), float(top), float(right), float(bottom)


def _distance(line: FloatArray, x: float, y: float) -> float:
    a, d = line[:-1], np.diff(line, axis=0)
    v = np.array([x, y]) - a
    k = np.clip((v * d).sum(axis=1) / np.maximum((d * d).sum(axis=1), 1e-12), 0, 1)
    return float(np.hypot(*(v - k[:, None] * d).T).min())
