"""A frame judged again and again with every point moved at random, as other clicks would lie."""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px, points_px
from procc_annotator.metric.measure import Measurement, measure_projected
from procc_annotator.metric.score import jac_curve

REPEATS = 20


@dataclass(frozen=True)
class ClickNoise:
    """How points are moved.

    Attributes:
        px: standard deviation along x and along y, px of the evaluation size or of ``of_size``.
        repeats: how often the whole evaluation is repeated.
        seed: the same one moves the same points of a frame alike, for every source.
        of_size: (width, height) of the picture in whose px it was measured.
        told_by: what it was measured by.
    """

    px: float
    repeats: int = REPEATS
    seed: int = 1
    of_size: tuple[int, int] | None = None
    told_by: str = ""

    def at(self, size: tuple[int, int]) -> tuple[float, float]:
        """The deviations along x and y, px of a picture of this (width, height)."""
        if self.of_size is None:
            return self.px, self.px
        along, down = ((n - 1) / (m - 1) for n, m in zip(size, self.of_size, strict=True))
        return self.px * along, self.px * down

    @property
    def described(self) -> str:
        """How points are moved, in words."""
        of, told_by = "", ""
        if self.of_size is not None:
            of, told_by = f" of {self.of_size[0]}x{self.of_size[1]}", f", from {self.told_by}"
        return (
            f"Every point moved by {self.px:.3g} px{of} (standard deviation along x and y"
            f"{told_by}), {self.repeats} times, seed {self.seed}."
        )


def perturbed_jac(
    frame: str,
    annotation: FrameAnnotation,
    measurement: Measurement,
    noise: ClickNoise,
    thresholds: Sequence[float],
) -> NDArray[np.float32]:
    """(R, T) JaC of a frame at some thresholds, in each repeat.

    Args:
        frame: its name; it decides, with the seed, how its points are moved.
        annotation: what was clicked. measurement: of it.
    """
    rng = np.random.default_rng((noise.seed, zlib.crc32(frame.encode("utf-8", "surrogatepass"))))
    taus = np.asarray(thresholds, dtype=np.float64)
    size = measurement.setup.size
    found = np.empty((noise.repeats, len(taus)), dtype=np.float32)
    for repeat in range(noise.repeats):
        moved = _perturbed(annotation, size, noise.at(size), rng)
        again = measure_projected(moved, measurement.projected, measurement.setup)
        found[repeat] = jac_curve(again, taus)
    return found


def _perturbed(
    annotation: FrameAnnotation,
    size: tuple[int, int],
    px: tuple[float, float],
    rng: np.random.Generator,
) -> FrameAnnotation:
    return replace(
        annotation, polylines=tuple(_perturbed_polyline(p, size, px, rng) for p in annotation.polylines)
    )


def _perturbed_polyline(
    polyline: Polyline, size: tuple[int, int], px: tuple[float, float], rng: np.random.Generator
) -> Polyline:
    points = points_px(polyline, size)
    points += np.array(px) * rng.standard_normal(points.shape)
    return replace(polyline, points=tuple(point_from_px(x, y, size) for x, y in points.tolist()))
