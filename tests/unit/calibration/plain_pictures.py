"""Plain pictures of a field, quickly drawn: lines of the right width on a ground with grain that
stays where it is."""

from functools import lru_cache

import cv2
import numpy as np

from procc_annotator.calibration.optimization.camera_parameters import camera_from_vector
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.image.pixels import PixelArray

SIZE = (640, 360)
FIELD = load_field("soccer")
FRAME = ImageFrame(SIZE)
_FINER = 4
_GROUND, _PAINT = (40, 110, 50), (225, 235, 230)


def camera(
    pan_rad: float = 0.45,
    tilt_rad: float = 1.33,
    focal: float = 1500.0,
    position: tuple[float, float, float] = (0.0, 62.0, -17.0),
) -> PinholeCamera:
    """A main camera that looks at the right penalty area; focal length in solver px."""
    vector = np.array([pan_rad, tilt_rad, 0.0, *position, np.log(focal), 0.02, 0.0, 0.0, 0.0])
    return camera_from_vector(vector, FRAME)


@lru_cache(maxsize=1)
def _grain() -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(4)
    places = random.uniform((-60, -75, 0), (60, 40, 0), (2500, 3))
    places[places[:, 1] < -40, 2] = random.uniform(-12, 0, int((places[:, 1] < -40).sum()))
    return places, random.integers(-28, 28, len(places))


def draw(
    shown: PinholeCamera, *, lines: bool = True, noise: float = 2.0, seed: int = 0
) -> PixelArray:
    """(360, 640, 4) BGRA of what a camera shows."""
    large = np.empty((SIZE[1] * _FINER, SIZE[0] * _FINER, 3), dtype=np.uint8)
    large[:] = _GROUND
    places, tones = _grain()
    px, seen = shown.project(places)
    seen &= ((px >= 0) & (px < SIZE)).all(axis=1)
    for (x, y), tone in zip(_large(px[seen]), tones[seen].tolist(), strict=True):
        colour = tuple(int(c + tone) for c in _GROUND)
        cv2.circle(large, (int(x), int(y)), 2 * _FINER, colour, -1)
    if lines:
        for points, width in _strokes(shown):
            cv2.polylines(large, [points], False, _PAINT, width, cv2.LINE_AA)
    picture = cv2.resize(large, SIZE, interpolation=cv2.INTER_AREA).astype(np.float64)
    picture += np.random.default_rng(seed).normal(0, noise, picture.shape)
    opaque = np.full((*picture.shape[:2], 1), 255.0)
    return np.concatenate([picture, opaque], axis=2).clip(0, 255).astype(np.uint8)


def apart_px(one: PinholeCamera, other: PinholeCamera) -> float:
    """Largest distance, px, between where two cameras show the ground around what one looks at."""
    x, y = np.meshgrid(np.linspace(-50, 50, 41), np.linspace(-33, 33, 25))
    ground = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    (a, seen), (b, also) = one.project(ground), other.project(ground)
    inside = seen & also & (a >= 0).all(axis=1) & (a <= np.array(SIZE) - 1.0).all(axis=1)
    return float(np.hypot(*(a - b)[inside].T).max())


def _strokes(shown: PinholeCamera) -> list[tuple[np.ndarray, int]]:
    found = []
    samples = sample_evenly(FIELD, 0.5)
    for row, element in enumerate(FIELD.elements):
        if element.is_spot or element.optional:
            continue
        px, seen = shown.project(samples.of(row))
        inside = seen & (np.abs(px - np.array(SIZE) / 2) < 2.0 * np.array(SIZE)).all(axis=1)
        edges = np.flatnonzero(np.diff(np.concatenate([[0], inside.astype(int), [0]])))
        for begin, end in zip(edges[::2], edges[1::2], strict=True):
            found.append((_large(px[begin:end]).round().astype(np.int32), _FINER + 3))
    return found


def _large(px: np.ndarray) -> np.ndarray:
    return (px + 0.5) * _FINER - 0.5
