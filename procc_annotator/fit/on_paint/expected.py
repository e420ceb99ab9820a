"""Where a camera shows the paint of a field: places in the picture, normals and widths."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.on_paint.painted import MarkingPoints
from procc_annotator.fit.solving.feet import MIN_DEPTH_M
from procc_annotator.fit.solving.jacobian import Lens
from procc_annotator.fit.solving.observations import FloatArray, IntArray, ImageFrame

_IMAGE_MARGIN_PX = 3.0  # a cut any nearer to the picture's edge has but one flank


@dataclass(frozen=True, eq=False)
class ExpectedLinePoints:
    """n places where paint should be.

    Attributes:
        rows: (n,) of `MarkingPoints`.
        px: (2, n) solver px.
        normal: (2, n) unit vectors across the element in the picture.
        width_px: (n,) solver px of the band, across it; 0 where nobody knows.
        run: (n,) which unbroken stretch in sight it is on, ascending.
        length_px: (n,) solver px of the stretch that a place stands for.
    """

    rows: IntArray
    px: FloatArray
    normal: FloatArray
    width_px: FloatArray
    run: IntArray
    length_px: FloatArray

    def chosen(self, places: IntArray) -> ExpectedLinePoints:
        """Some of them, in order."""
        return ExpectedLinePoints(
            self.rows[places],
            self.px[:, places],
            self.normal[:, places],
            self.width_px[places],
            self.run[places],
            self.length_px[places],
        )


def expected_line_points(
    vector: FloatArray, painted: MarkingPoints, frame: ImageFrame, spacing_px: float
) -> ExpectedLinePoints:
    """What of the paint a camera has in its picture.

    Args:
        vector: (11,) of the camera.
        painted: the field's paint.
        frame: the picture.
        spacing_px: between two places, solver px; where the paint's places are farther apart, those
            are taken.
    """
    lens = Lens.of(vector[None], frame.half_diagonal)
    px, shown = project_points(lens, painted.world)
    limit = (np.array(frame.size)[:, None] - 1) / 2 * frame.scale - _IMAGE_MARGIN_PX
    inside = np.flatnonzero(shown & (np.abs(px) <= limit).all(axis=0))
    if not len(inside):
        nothing = np.zeros((2, 0))
        return ExpectedLinePoints(inside, nothing, nothing, np.zeros(0), inside, np.zeros(0))
    seen = px[:, inside]
    begins = np.empty(len(inside), dtype=bool)
    begins[0] = True
    begins[1:] = (np.diff(inside) > 1) | (np.diff(painted.run[inside]) > 0)
    steps = np.zeros(len(inside))
    steps[1:] = np.hypot(*np.diff(seen, axis=1))
    steps[begins] = 0.0
    run = np.cumsum(begins) - 1
    gone = np.cumsum(steps)
    within = np.floor((gone - gone[np.flatnonzero(begins)][run]) / spacing_px)
    kept = begins | (np.diff(within, prepend=-1.0) > 0)
    rows, chosen = inside[kept], run[kept]
    normal, width = _normals_and_widths(lens, painted, rows, seen[:, kept])
    length = np.diff(gone[kept], append=gone[-1])
    length[np.diff(chosen, append=-1) != 0] = spacing_px
    return ExpectedLinePoints(rows, seen[:, kept], normal, width, chosen, length)


def project_points(lens: Lens, world: FloatArray) -> tuple[FloatArray, np.ndarray]:
    """(3, N) metres -> (2, N) solver px of one camera, and (N,) whether it shows them."""
    place = lens.linear[0, :, :3] @ world + lens.linear[0, :, 3:]
    ahead = place[2] > MIN_DEPTH_M
    v = place[:2] / np.where(ahead, place[2], 1.0)
    squares = (v * v).sum(axis=0)
    bend = float(lens.bend[0, 0])
    if bend < 0:  # what lies beyond the fold is shown by no lens
        ahead &= -3 * bend * squares < 1
    vector = lens.vectors[0]
    px = v * (1 + bend * squares)
    px[0] *= 1 + vector[8]
    px += vector[9:11, None]
    return px, ahead


def _normals_and_widths(
    lens: Lens, painted: MarkingPoints, rows: IntArray, px: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """(2, n) unit normals in the picture, and (n,) solver px of the bands' widths."""
    world = painted.world[:, rows]
    linear = lens.linear[0]
    depth = linear[2, :3] @ world + linear[2, 3]
    v = (linear[:2, :3] @ world + linear[:2, 3:]) / depth
    grown = 1 + lens.bend[0, 0] * (v * v).sum(axis=0)

    def moved(way: FloatArray) -> FloatArray:
        toward = linear[:, :3] @ way
        plain = (toward[:2] - v * toward[2]) / depth
        return np.asarray(plain * grown + 2 * lens.bend[0, 0] * v * (v * plain).sum(axis=0))

    along = moved(painted.along[:, rows])
    along /= np.maximum(np.hypot(*along), 1e-12)
    normal = np.stack([-along[1], along[0]])
    is_bar = ~painted.across[:, rows].any(axis=0)
    aside = np.abs((moved(painted.across[:, rows]) * normal).sum(axis=0))
    focal = float(np.exp(lens.vectors[0, 6]))
    scale = np.where(is_bar, focal / depth, aside)
    return normal, painted.width_m[rows] * scale
