"""Where one camera hands over to another: pictures that differ much, and stay different."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.image.pixels import PixelArray

FloatArray = NDArray[np.float64]

_SMALL = (48, 27)
_BINS = 6  # per colour channel
_LEAST = 0.055  # a pan by 1.5 % of the width stays below 0.05, cuts between views start at 0.06
_TIMES_AROUND = 2.5  # a cut stands out of the motion before and after it
_AROUND = 6


@dataclass(frozen=True, eq=False)
class SceneLook:
    """What is kept of a picture: its layout in small, and its colours."""

    layout: FloatArray  # (27, 48, 3), 0 to 1
    colours: FloatArray  # (216,) shares


def look_of(pixels: PixelArray) -> SceneLook:
    """The look of a (H, W, 3) BGR picture."""
    stride = max(1, min(pixels.shape[0] // 180, pixels.shape[1] // 320))
    fewer = np.ascontiguousarray(pixels[::stride, ::stride])
    small = cv2.resize(fewer, _SMALL, interpolation=cv2.INTER_AREA)
    step = 256 / _BINS
    bins = (small / step).astype(np.int64) @ np.array([1, _BINS, _BINS * _BINS])
    shares = np.bincount(bins.ravel(), minlength=_BINS**3) / bins.size
    return SceneLook(small.astype(np.float64) / 255, shares)


def look_difference(a: SceneLook, b: SceneLook) -> float:
    """0 for the same picture, 0.06 to 0.4 for another camera's."""
    layout = float(np.abs(a.layout - b.layout).mean())
    colours = float(np.abs(a.colours - b.colours).sum()) / 2
    return layout + colours / 4


def same_scene(a: SceneLook, b: SceneLook) -> bool:
    """Whether two pictures, one right after the other, may be of one camera that moves."""
    return look_difference(a, b) < _LEAST


def steps_of(looks: Iterable[SceneLook]) -> tuple[FloatArray, FloatArray]:
    """How much each picture of a row differs from those around it, as `cuts_among` takes it.

    Returns:
        (N,) difference to the one before it, and (N,) least difference among pictures shortly
        before and after.
    """
    recent: deque[SceneLook] = deque(maxlen=4)
    steps: list[float] = []
    lasting: list[float] = []
    for look in looks:
        past = list(recent)[1:-1]
        steps.append(look_difference(recent[-1], look) if recent else 0.0)
        recent.append(look)
        # Small where a flash ends...
        lasting.append(min((look_difference(old, look) for old in past), default=1.0))
        if len(recent) == 4:  # ... and where it begins
            lasting[-3] = min(lasting[-3], look_difference(recent[0], look))
    return np.array(steps), np.array(lasting)


def cuts_among(steps: FloatArray, lasting: FloatArray) -> list[int]:
    """The first picture of each scene, 0 included.

    Args:
        steps: (N,) difference of each picture to the one before it; the first is ignored.
        lasting: (N,) least difference among pictures shortly before and after: small where a
            flash begins or ends, which is no cut.
    """
    cuts = [0]
    for n in range(1, len(steps)):
        if steps[n] < _LEAST or lasting[n] < max(_LEAST, steps[n] / 2):
            continue
        around = steps[max(1, n - _AROUND) : n + _AROUND + 1]
        usual = float(np.median(around)) if len(around) > 2 else 0.0
        near = steps[max(1, n - 2) : n + 3]
        if steps[n] >= near.max() and steps[n] > _TIMES_AROUND * usual:
            cuts.append(n)
    return cuts
