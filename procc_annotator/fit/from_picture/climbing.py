"""Many cameras at once led to where their lines lie on the picture's paint, and judged there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from procc_annotator.fit.from_picture.field_lines import FieldLinePoints
from procc_annotator.fit.from_picture.in_view import visible_line_points
from procc_annotator.fit.from_picture.pulls import Correspondences, match_lines_to_pixels, match_pixels_to_lines
from procc_annotator.fit.from_picture.seen_paint import ImageLinePixels
from procc_annotator.fit.solving.models import FREE_PARAMETERS, Z
from procc_annotator.fit.solving.observations import FloatArray, IntArray
from procc_annotator.fit.solving.solver import GaussianPrior
from procc_annotator.fit.solving.starts import side_costs, camera_side, wide_prior

# How far a step may lead: rad, metres, shares.
_MAX_STEP = np.array([0.15, 0.1, 0.03, 8.0, 8.0, 5.0, 0.15, 0.05])
_MIN_HEIGHT_M = 1.0
_REACH_SCALES = 4.0  # times the scale: farther paint is another line's
_LINE_WEIGHT = 40.0  # independent places that all of a picture's paint is worth
_POINT_SCALE = 2.0  # times the scale: what a place's error is taken for
_DAMPING_FACTOR = 1.02


@dataclass(frozen=True, eq=False)
class SearchScene:
    """What a search goes by.

    Attributes:
        lines: of the field.
        paint: of the picture.
        known: where its camera stands, (1, 8) means and inverse standard deviations; None if it
            may stand anywhere.
    """

    lines: FieldLinePoints
    paint: ImageLinePixels
    known: GaussianPrior | None = None

    def prior(self, vectors: FloatArray, free: int) -> GaussianPrior:
        """Where cameras (B, 11) are expected, by the side of the field each one stands on."""
        if self.known is not None:
            return GaussianPrior(self.known.mean[:, :free], self.known.inverse_sd[:, :free])
        return wide_prior(self._sides(vectors), self.lines.around, free)

    def unlikeliness(self, vectors: FloatArray) -> FloatArray:
        """(B,) half the squared deviations from where cameras are expected, lens left out; more on
        another side than the main camera's."""
        prior = self.prior(vectors, FREE_PARAMETERS["P"])
        off = (vectors[:, : FREE_PARAMETERS["P"]] - prior.mean) * prior.inverse_sd
        cost = np.asarray((off**2).sum(axis=1) / 2)
        if self.known is None:
            cost += side_costs(self._sides(vectors), self.lines.around)
        return cost

    def _sides(self, vectors: FloatArray) -> IntArray:
        around = self.lines.around
        return np.array([camera_side(vector, around) for vector in vectors], dtype=np.intp)


def refine_by_icp(
    scene: SearchScene,
    vectors: FloatArray,
    scales_px: Sequence[float],
    *,
    places: int,
    paint: int = 0,
    model: str = "P",
) -> FloatArray:
    """Lead cameras to the paint, one step for each scale.

    Args:
        scene: field and picture.
        vectors: (B, 11) where they are.
        scales_px: solver px; paint farther off counts less and less.
        places: so many on the lines of each camera.
        paint: so many places of the paint are pulled to lines as well.
        model: P or R.

    Returns:
        (B, 11).
    """
    free = FREE_PARAMETERS[model]
    vectors = vectors.copy()
    half_height = scene.paint.half_height
    chosen = visible_line_points(vectors, scene.lines.coarse, half_height, places).places
    some = scene.paint.some(paint)
    prior = scene.prior(vectors, free)
    mean, inverse = prior.mean, prior.inverse_sd
    diagonal = np.arange(free)
    for scale in scales_px:
        pulls = match_lines_to_pixels(vectors, chosen, scene.lines.coarse, scene.paint, free)
        normal, gradient = _normal_equations(pulls, scale)
        if len(some):
            pulls = match_pixels_to_lines(vectors, some, scene.lines, scene.paint, free)
            more = _normal_equations(pulls, scale)
            normal, gradient = normal + more[0], gradient + more[1]
        gradient -= (vectors[:, :free] - mean) * inverse**2
        normal[:, diagonal, diagonal] += inverse**2 + 1e-9
        normal[:, diagonal, diagonal] *= _DAMPING_FACTOR
        step = np.linalg.solve(normal, gradient[:, :, None])[:, :, 0]
        step /= np.maximum(np.abs(step / _MAX_STEP[:free]).max(axis=1), 1.0)[:, None]
        vectors[:, :free] += step
        vectors[:, Z] = np.minimum(vectors[:, Z], -_MIN_HEIGHT_M)
    return vectors


def _normal_equations(pulls: Correspondences, scale: float) -> tuple[FloatArray, FloatArray]:
    counted = pulls.known & (pulls.away < _REACH_SCALES * scale)
    off = np.where(counted, pulls.off, 0.0)
    weight = counted / (1 + (off / scale) ** 2) ** 2
    weight *= _LINE_WEIGHT / off.shape[1] * (_POINT_SCALE / scale) ** 2
    weighted = pulls.by * weight[:, None]
    normal = weighted @ pulls.by.transpose(0, 2, 1)
    return normal, (weighted @ off[:, :, None])[:, :, 0]


@dataclass(frozen=True, eq=False)
class ChamferAgreement:
    """How well B cameras and a picture agree.

    Attributes:
        coverage: (B,) share of the lines in sight that lie on paint.
        explained: (B,) share of the paint on the ground that lies on lines.
    """

    coverage: FloatArray
    explained: FloatArray

    @property
    def both(self) -> FloatArray:
        """(B,) their harmonic mean: 1 only if nothing is missing on either side."""
        return np.asarray(harmonic_mean(self.coverage, self.explained))


def harmonic_mean(one: Any, other: Any) -> Any:
    """The harmonic mean of shares; 0 where both are."""
    return 2 * one * other / np.maximum(one + other, 1e-9)


def chamfer_agreement(
    scene: SearchScene, vectors: FloatArray, within_px: float, *, places: int, paint: int
) -> ChamferAgreement:
    """Judge cameras (B, 11) by so many places on lines, and of the paint."""
    chosen = visible_line_points(vectors, scene.lines.coarse, scene.paint.half_height, places).places
    pulls = match_lines_to_pixels(vectors, chosen, scene.lines.coarse, scene.paint, 0)
    on_paint = pulls.known & (np.abs(pulls.off) < within_px) & (pulls.away < 3 * within_px)
    coverage = on_paint.sum(axis=1) / np.maximum(pulls.in_view.sum(axis=1), 1)
    some = scene.paint.some(paint)
    pulls = match_pixels_to_lines(vectors, some, scene.lines, scene.paint, 0)
    explained = (pulls.known & (np.abs(pulls.off) < within_px)).mean(axis=1)
    return ChamferAgreement(coverage, explained)
