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

_THUMBNAIL_SIZE = (48, 27)
_HISTOGRAM_BINS = 6  # per colour channel
_MIN_CUT_DIFFERENCE = 0.055  # a pan by 1.5 % of the width stays below 0.05, cuts between views start at 0.06
_CUT_RATIO = 2.5  # a cut stands out of the motion before and after it
_CUT_WINDOW = 6


@dataclass(frozen=True, eq=False)
class FrameSignature:
    """What is kept of a picture: its layout in small, and its colours."""

    layout: FloatArray  # (27, 48, 3), 0 to 1
    colours: FloatArray  # (216,) shares


def frame_signature(pixels: PixelArray) -> FrameSignature:
    """The look of a (H, W, 3) BGR picture."""
    stride = max(1, min(pixels.shape[0] // 180, pixels.shape[1] // 320))
    fewer = np.ascontiguousarray(pixels[::stride, ::stride])
    small = cv2.resize(fewer, _THUMBNAIL_SIZE, interpolation=cv2.INTER_AREA)
    step = 256 / _HISTOGRAM_BINS
    bins = (small / step).astype(np.int64) @ np.array([1, _HISTOGRAM_BINS, _HISTOGRAM_BINS * _HISTOGRAM_BINS])
    shares = np.bincount(bins.ravel(), minlength=_HISTOGRAM_BINS**3) / bins.size
    return FrameSignature(small.astype(np.float64) / 255, shares)


def signature_distance(a: FrameSignature, b: FrameSignature) -> float:
    """0 for the same picture, 0.06 to 0.4 for another camera's."""
    layout = float(np.abs(a.layout - b.layout).mean())
    colours = float(np.abs(a.colours - b.colours).sum()) / 2
    return layout + colours / 4


def is_same_scene(a: FrameSignature, b: FrameSignature) -> bool:
    """Whether two pictures, one right after the other, may be of one camera that moves."""
    return signature_distance(a, b) < _MIN_CUT_DIFFERENCE


def frame_differences(looks: Iterable[FrameSignature]) -> tuple[FloatArray, FloatArray]:
    """How much each picture of a row differs from those around it, as `cut_indices` takes it.

    Returns:
        (N,) difference to the one before it, and (N,) least difference among pictures shortly
        before and after.
    """
    recent: deque[FrameSignature] = deque(maxlen=4)
    steps: list[float] = []
    lasting: list[float] = []
    for look in looks:
        past = list(recent)[1:-1]
        steps.append(signature_distance(recent[-1], look) if recent else 0.0)
        recent.append(look)
        # Small where a flash ends...
        lasting.append(min((signature_distance(old, look) for old in past), default=1.0))
        if len(recent) == 4:  # ... and where it begins
            lasting[-3] = min(lasting[-3], signature_distance(recent[0], look))
    return np.array(steps), np.array(lasting)


def cut_indices(steps: FloatArray, lasting: FloatArray) -> list[int]:
    """The first picture of each scene, 0 included.

    Args:
        steps: (N,) difference of each picture to the one before it; the first is ignored.
        lasting: (N,) least difference among pictures shortly before and after: small where a
            flash begins or ends, which is no cut.
    """
    cuts = [0]
    for n in range(1, len(steps)):
        if steps[n] < _MIN_CUT_DIFFERENCE or lasting[n] < max(_MIN_CUT_DIFFERENCE, steps[n] / 2):
            continue
        around = steps[max(1, n - _CUT_WINDOW) : n + _CUT_WINDOW + 1]
        usual = float(np.median(around)) if len(around) > 2 else 0.0
        near = steps[max(1, n - 2) : n + 3]
        if steps[n] >= near.max() and steps[n] > _CUT_RATIO * usual:
            cuts.append(n)
    return cuts
