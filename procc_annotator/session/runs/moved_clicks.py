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
        px: standard deviation along x and along y, px of the evaluation size.
        repeats: how often the whole evaluation is repeated.
        seed: the same one moves the same points of a frame alike, for every source.
    """

    px: float
    repeats: int = REPEATS
    seed: int = 1


def moved_jac(
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
    rng = np.random.default_rng((noise.seed, zlib.crc32(frame.encode())))
    taus = np.asarray(thresholds, dtype=np.float64)
    found = np.empty((noise.repeats, len(taus)), dtype=np.float32)
    for repeat in range(noise.repeats):
        moved = _moved(annotation, measurement.setup.size, noise.px, rng)
        again = measure_projected(moved, measurement.projected, measurement.setup)
        found[repeat] = jac_curve(again, taus)
    return found


def _moved(
    annotation: FrameAnnotation, size: tuple[int, int], px: float, rng: np.random.Generator
) -> FrameAnnotation:
    return replace(
        annotation, polylines=tuple(_moved_line(p, size, px, rng) for p in annotation.polylines)
    )


def _moved_line(
    polyline: Polyline, size: tuple[int, int], px: float, rng: np.random.Generator
) -> Polyline:
    points = points_px(polyline, size)
    points += px * rng.standard_normal(points.shape)
    return replace(polyline, points=tuple(point_from_px(x, y, size) for x, y in points.tolist()))
