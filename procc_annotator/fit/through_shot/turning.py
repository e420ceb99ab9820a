"""How a camera turned and zoomed between two frames, by what stands still around the field.

Corners are followed in much reduced pictures; pan, tilt, roll and focal length are what most of
them agree on. It takes a few milliseconds, needs no paint, and drifts: by a fraction of a pixel a
frame.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.jacobian import Lens, project
from procc_annotator.fit.solving.models import CENTRE, LOG_FOCAL, PAN, ROLL, TILT
from procc_annotator.fit.solving.observations import FloatArray, PictureFrame
from procc_annotator.image.pixels import PixelArray

OWN = np.array([PAN, TILT, ROLL, LOG_FOCAL])  # what may change from frame to frame

WIDTH = 320  # of the reduced pictures
_CORNERS, _QUALITY, _APART_PX = 200, 0.004, 6.0
_WINDOW = (15, 15)
_LEVELS = 3
_FEWEST = 16
_STILL_PX, _MOVES_PX = 0.05, 0.2  # of the reduced picture, from frame to frame
_LEAST_SHARE = 0.3  # of the corners that could be followed, for a motion to be believed
_SCALES_PX = (12.0, 5.0, 2.0, 1.5)  # of the robust steps, solver px
# Standard deviations of what changes in a frame before anything is seen of it; and of what one
# followed corner is off by at least.
_ROLL_SD, _LOG_FOCAL_SD = np.deg2rad(0.05), 0.03
_LEAST_ERROR_PX = 0.3
_TOGETHER = 4.0  # corners that are worth one: people and stands err together
_DRIFT_PX = 0.4  # what a frame's motion is off by, however many corners agree
_FAR_M = 1000.0


@dataclass(frozen=True, eq=False)
class Turn:
    """How a camera turned and zoomed.

    Attributes:
        step: (4,) change of the parameters `OWN`.
        covariance: (4, 4) of it.
    """

    step: FloatArray
    covariance: FloatArray

    def backwards(self) -> Turn:
        """The way back."""
        return Turn(-self.step, self.covariance)


@dataclass(frozen=True, eq=False)
class SmallPicture:
    """What is looked at of a picture.

    Attributes:
        grey: (h, `WIDTH`) the picture much reduced.
        corners: (n, 2) px of it, what can be followed.
    """

    grey: PixelArray
    corners: NDArray[np.float32]


NOTHING_SEEN = SmallPicture(np.zeros((1, 1), np.uint8), np.zeros((0, 2), np.float32))


def small_of(picture: PixelArray) -> SmallPicture:
    """What `turn_between` looks at of a picture (H, W, 4) BGRA."""
    height = max(1, round(picture.shape[0] * WIDTH / picture.shape[1]))
    small = cv2.resize(picture, (WIDTH, height), interpolation=cv2.INTER_AREA)
    grey = np.asarray(cv2.cvtColor(small, cv2.COLOR_BGRA2GRAY), dtype=np.uint8)
    corners = cv2.goodFeaturesToTrack(grey, _CORNERS, _QUALITY, _APART_PX)
    found = NOTHING_SEEN.corners if corners is None else np.asarray(corners, dtype=np.float32)
    return SmallPicture(grey, found.reshape(-1, 2))


def turn_between(
    before: SmallPicture,
    now: SmallPicture,
    vector: FloatArray,
    expected: FloatArray,
    frame: PictureFrame,
) -> Turn | None:
    """How the camera moved from one frame to the next.

    Args:
        before, now: both frames.
        vector: (11,) of the camera before.
        expected: (4,) change of `OWN` that is likely, as in the step before.
        frame: the picture.

    Returns:
        None where too few corners agree on a motion.
    """
    if len(before.corners) < _FEWEST:
        return None
    start = before.corners.astype(np.float64)
    rays = _rays(_to_solver(start, frame), vector, frame)
    likely, _ = _shown(rays, vector, expected, frame)
    guess = np.array(_from_solver(likely, frame), dtype=np.float32, order="C")
    after, done, _ = cv2.calcOpticalFlowPyrLK(
        before.grey,
        now.grey,
        before.corners,
        guess,
        winSize=_WINDOW,
        maxLevel=_LEVELS,
        flags=cv2.OPTFLOW_USE_INITIAL_FLOW,
    )
    followed = np.asarray(done).ravel() == 1
    after = np.asarray(after, dtype=np.float64).reshape(-1, 2)
    followed &= ((after >= 0) & (after <= np.array(now.grey.shape[::-1]) - 1)).all(axis=1)
    followed &= ~_laid_over(np.hypot(*(after - start).T), followed)
    if followed.sum() < _FEWEST:
        return None
    return _agreed(rays[:, followed], _to_solver(after[followed], frame), vector, expected, frame)


def _laid_over(moved_px: FloatArray, followed: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which corners are of banners and scores laid over the picture: they stand where they were to
    a hundredth of a pixel while the picture moves behind them."""
    still = followed & (moved_px < _STILL_PX)
    moving = followed & ~still
    if not moving.any() or np.median(moved_px[moving]) < _MOVES_PX:
        return np.zeros_like(still)
    return still


def _agreed(
    rays: FloatArray,
    seen: FloatArray,
    vector: FloatArray,
    expected: FloatArray,
    frame: PictureFrame,
) -> Turn | None:
    """The motion that most rays (3, n) agree on, which are seen at (2, n) solver px now."""
    prior = np.diag([0.0, 0.0, _ROLL_SD**-2, _LOG_FOCAL_SD**-2])
    step = expected.copy()
    begin = step * [1, 1, 0, 1]
    for scale in _SCALES_PX:
        shown, by = _shown(rays, vector, step, frame)
        off = seen - shown
        weights = (1 / (1 + (off * off).sum(axis=0) / scale**2)) ** 2
        rows = (by * weights).reshape(len(OWN), -1)
        normal = rows @ by.reshape(len(OWN), -1).T
        gradient = rows @ off.reshape(-1) - prior @ (step - begin)
        step = step + np.linalg.solve(normal + prior + 1e-9 * np.eye(len(OWN)), gradient)
    counted = weights > 0.25
    if counted.sum() < max(_FEWEST, _LEAST_SHARE * len(weights)):
        return None
    squares = (off[:, counted] ** 2).sum(axis=0)
    error = max(float(np.sqrt(squares.mean() / 2)), _LEAST_ERROR_PX)
    covariance = np.linalg.inv(normal / (error**2 * _TOGETHER) + prior)
    focal = float(np.exp(vector[LOG_FOCAL]))
    drift = np.array([_DRIFT_PX / focal, _DRIFT_PX / focal, 2e-5, _DRIFT_PX / 400]) ** 2
    return Turn(step, covariance + np.diag(drift))


def _to_solver(points: FloatArray, frame: PictureFrame) -> FloatArray:
    """(n, 2) px of a reduced picture -> (2, n) solver px."""
    size = np.array([WIDTH, max(1, round(frame.size[1] * WIDTH / frame.size[0]))])
    full = (points + 0.5) * (np.array(frame.size) / size) - 0.5
    return np.asarray(((full - frame.centre_px) * frame.scale).T)


def _from_solver(points: FloatArray, frame: PictureFrame) -> FloatArray:
    size = np.array([WIDTH, max(1, round(frame.size[1] * WIDTH / frame.size[0]))])
    full = points.T / frame.scale + frame.centre_px
    return np.asarray((full + 0.5) * (size / np.array(frame.size)) - 0.5)


def _rays(points: FloatArray, vector: FloatArray, frame: PictureFrame) -> FloatArray:
    """(2, n) solver px -> (3, n) places far away in the world that a camera shows there."""
    lens = Lens.of(vector[None], frame.half_diagonal)
    plain = lens.undistorted(points)[0] / np.exp(vector[LOG_FOCAL])
    ways = lens.rotation[0].T @ np.vstack([plain, np.ones(plain.shape[1])])
    return np.asarray(vector[CENTRE, None] + _FAR_M * ways)


def _shown(
    rays: FloatArray, vector: FloatArray, step: FloatArray, frame: PictureFrame
) -> tuple[FloatArray, FloatArray]:
    """(2, n) where the camera shows them after a step, and (4, 2, n) derivatives by it."""
    turned = vector.copy()
    turned[OWN] += step
    lens = Lens.of(turned[None], frame.half_diagonal)
    px, _, by = project(lens, rays[None], np.zeros((1, *rays.shape)), LOG_FOCAL + 1)
    return px[0], by[0, OWN]
