"""Pictures whose pixels are not square: how wide they are, and cameras of such pictures.

Training pipelines squeeze frames to squares, and some video formats store wide pictures in narrow
ones. With the wrong pixels another camera, higher or nearer, agrees with most of the lines as well;
but frames of one tripod then give different positions when they look in different directions.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.probability import (
    ProposalEvidence,
    probability_right,
)
from procc_annotator.field.model import PixelAspect
from procc_annotator.image.pixels import PixelArray

_WIDE, _NARROW = 16 / 9, 4 / 3  # shapes of pictures as they are shown
_SAME_SHAPE = 0.03
# Longer by shorter side of the narrowest pictures that cameras make (5:4).
_MIN_VIEW_FACTOR = 1.25
# Nobody films squares: nearly all are made from wide pictures, few are cut out.
_SQUEEZED_PRIORS = {_WIDE: 0.75, _NARROW: 0.15, 1.0: 0.1}
# Sizes that video formats store 4:3 and 16:9 pictures in (Rec. 601, DV, HDV, DVCPRO HD).
_STORED_SIZES = {
    (720, 576), (704, 576), (720, 480), (704, 480), (1440, 1080), (1280, 1080), (960, 720),
}  # fmt: skip
_WRONG_CAMERA = 0.01  # a picture in which no camera is found tells no more than this
_TRIPOD_SD_M = 0.5  # cameras that are found at one tripod agree to about this


SQUARE_PIXELS = PixelAspect(1.0, 1.0)


def possible_pixel_aspects(size: tuple[int, int]) -> tuple[PixelAspect, ...]:
    """What the pixels of a picture (width, height) may be, with the probabilities before it is
    examined; one alone for shapes that cameras make."""
    shape = size[0] / size[1]
    if size in _STORED_SIZES:
        shapes = {_WIDE: 0.5, _NARROW: 0.5}
    elif 1 / _MIN_VIEW_FACTOR < shape < _MIN_VIEW_FACTOR:
        shapes = {shape if way == 1.0 else way: prior for way, prior in _SQUEEZED_PRIORS.items()}
    else:
        return (SQUARE_PIXELS,)
    return tuple(
        PixelAspect(1.0 if abs(way / shape - 1) < _SAME_SHAPE else way / shape, prior)
        for way, prior in shapes.items()
    )


@dataclass(frozen=True, eq=False)
class AspectSample:
    """The best camera of a picture with some pixel aspect; positions are (3,) metres."""

    evidence: ProposalEvidence
    position_m: FloatArray


def most_probable_aspect(
    possible: Sequence[PixelAspect], samples: Sequence[Sequence[AspectSample | None]]
) -> PixelAspect:
    """The one of the possible pixels that explains pictures of one source best: for each of them
    the best camera of each picture, None without one."""
    log_odds = [
        math.log(one.probability) + _log_likelihood(of_pictures)
        for one, of_pictures in zip(possible, samples, strict=True)
    ]
    weights = np.exp(np.array(log_odds) - max(log_odds))
    best = int(weights.argmax())
    return PixelAspect(possible[best].value, float(weights[best] / weights.sum()))


def _log_likelihood(samples: Sequence[AspectSample | None]) -> float:
    """How probable cameras are right, and stand where cameras do, which counts once; and how well
    each agrees with the nearest other one on a position (Cauchy: there may be several tripods)."""
    cameras = [one for one in samples if one is not None]
    right = [probability_right(one.evidence) for one in cameras]
    found = sum(math.log(max(one, _WRONG_CAMERA)) for one in right)
    found += (len(samples) - len(cameras)) * math.log(_WRONG_CAMERA)
    if not cameras:
        return found
    found -= float(np.mean([one.evidence.unlikeliness for one in cameras]))
    places = np.array([one.position_m for one in cameras])
    apart = np.linalg.norm(places[:, None] - places, axis=2) + np.diag([np.inf] * len(places))
    if len(cameras) > 1:
        found -= float(np.log1p((apart.min(axis=1) / _TRIPOD_SD_M) ** 2).sum())
    return found


def stretched_size(size: tuple[int, int], aspect: float) -> tuple[int, int]:
    """The size (width, height) of a picture once its pixels are square."""
    return round(size[0] * max(aspect, 1.0)), round(size[1] / min(aspect, 1.0))


def with_square_pixels(picture: PixelArray, aspect: float) -> PixelArray:
    """A picture (H, W, 4) stretched so that its pixels are square."""
    if aspect == 1:
        return picture
    size = stretched_size((picture.shape[1], picture.shape[0]), aspect)
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_CUBIC), dtype=np.uint8)


def fit_in_picture(fit: FitResult, size: tuple[int, int]) -> FitResult:
    """A fit to a stretched picture, in px of the picture (width, height) as it is; its parameters
    are the same."""
    if fit.size == size or fit.camera is None:
        return replace(fit, size=size)
    by_x, by_y = ((own - 1) / (old - 1) for own, old in zip(size, fit.size, strict=True))
    deviations = fit.deviations
    if deviations is not None:
        deviations = replace(deviations, focal_px=deviations.focal_px * by_y)
    return replace(
        fit,
        size=size,
        camera=fit.camera.scaled(fit.size, size),
        deviations=deviations,
        error_px=None if fit.error_px is None else fit.error_px * by_y,
        pixel_aspect=by_y / by_x,
    )
