"""Inter-frame rotation and zoom from background corners, and the process noise of tripod and
moving cameras.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.line_alignment.gaussian_state import PARAMETERS_FREE
from procc_annotator.calibration.optimization.camera_parameters import (
    KAPPA,
    LOG_FOCAL,
    PAN,
    POSITION_SLICE,
    ROLL,
    TILT,
    X,
    Z,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.projection import Lens, project
from procc_annotator.image.pixels import PixelArray

MOTION_PARAMETERS = np.array([PAN, TILT, ROLL, LOG_FOCAL])  # what may change from frame to frame

WORKING_WIDTH_PX = 320  # of the reduced pictures
_MAX_CORNERS, _CORNER_QUALITY, _CORNER_DISTANCE_PX = 200, 0.004, 6.0
_FLOW_WINDOW = (15, 15)
_PYRAMID_LEVELS = 3
_MIN_CORNERS = 16
_OVERLAY_STATIC_PX, _OVERLAY_MOTION_PX = 0.05, 0.2  # of the reduced picture, from frame to frame
_MIN_SHARE = 0.3  # of the corners that could be followed, for a motion to be believed
_SCALES_PX = (12.0, 5.0, 2.0, 1.5)  # of the robust steps, solver px
# Standard deviations of what changes in a frame before anything is seen of it; and of what one
# followed corner is off by at least.
_ROLL_SD, _LOG_FOCAL_SD = np.deg2rad(0.05), 0.03
_MIN_ERROR_PX = 0.3
_CORRELATED_CORNERS = 4.0  # corners that are worth one: people and stands err together
_DRIFT_PX = 0.4  # what a frame's motion is off by, however many corners agree
_BACKGROUND_DISTANCE_M = 1000.0


@dataclass(frozen=True, eq=False)
class InterFrameMotion:
    """Turn and zoom of a camera: (4,) change of the parameters `OWN`, and its (4, 4) covariance."""

    step: FloatArray
    covariance: FloatArray

    def backwards(self) -> InterFrameMotion:
        """The way back."""
        return InterFrameMotion(-self.step, self.covariance)


@dataclass(frozen=True, eq=False)
class MotionImage:
    """A picture much reduced, (h, `WIDTH`) grey, and the corners (n, 2), px of it, that can be
    followed."""

    grey: PixelArray
    corners: NDArray[np.float32]


EMPTY_MOTION_IMAGE = MotionImage(np.zeros((1, 1), np.uint8), np.zeros((0, 2), np.float32))


def motion_image(picture: PixelArray) -> MotionImage:
    """Return what `estimate_inter_frame_motion` looks at of a picture (H, W, 4) BGRA."""
    height = max(1, round(picture.shape[0] * WORKING_WIDTH_PX / picture.shape[1]))
    small = cv2.resize(picture, (WORKING_WIDTH_PX, height), interpolation=cv2.INTER_AREA)
    grey = np.asarray(cv2.cvtColor(small, cv2.COLOR_BGRA2GRAY), dtype=np.uint8)
    corners = cv2.goodFeaturesToTrack(grey, _MAX_CORNERS, _CORNER_QUALITY, _CORNER_DISTANCE_PX)
    found = EMPTY_MOTION_IMAGE.corners if corners is None else np.asarray(corners, dtype=np.float32)
    return MotionImage(grey, found.reshape(-1, 2))


def estimate_inter_frame_motion(
    before: MotionImage,
    now: MotionImage,
    vector: FloatArray,
    expected: FloatArray,
    frame: ImageFrame,
) -> InterFrameMotion | None:
    """Return how the camera moved from one frame to the next.

    Args:
        vector: (11,) of the camera before.
        expected: (4,) change of `OWN` that is likely, as in the step before.

    Returns:
        None where too few corners agree on a motion.
    """
    if len(before.corners) < _MIN_CORNERS:
        return None
    start = before.corners.astype(np.float64)
    rays = _background_points(_to_solver_px(start, frame), vector, frame)
    likely, _ = _project_after_motion(rays, vector, expected, frame)
    guess = np.array(_from_solver_px(likely, frame), dtype=np.float32, order="C")
    after, done, _ = cv2.calcOpticalFlowPyrLK(
        before.grey,
        now.grey,
        before.corners,
        guess,
        winSize=_FLOW_WINDOW,
        maxLevel=_PYRAMID_LEVELS,
        flags=cv2.OPTFLOW_USE_INITIAL_FLOW,
    )
    followed = np.asarray(done).ravel() == 1
    after = np.asarray(after, dtype=np.float64).reshape(-1, 2)
    followed &= ((after >= 0) & (after <= np.array(now.grey.shape[::-1]) - 1)).all(axis=1)
    followed &= ~_is_overlay_graphic(np.hypot(*(after - start).T), followed)
    if followed.sum() < _MIN_CORNERS:
        return None
    return _robust_motion(
        rays[:, followed], _to_solver_px(after[followed], frame), vector, expected, frame
    )


def _is_overlay_graphic(moved_px: FloatArray, followed: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which corners are of banners and scores laid over the picture: they stand where they were to
    a hundredth of a pixel while the picture moves behind them."""
    still = followed & (moved_px < _OVERLAY_STATIC_PX)
    moving = followed & ~still
    if not moving.any() or np.median(moved_px[moving]) < _OVERLAY_MOTION_PX:
        return np.zeros_like(still)
    return still


def _robust_motion(
    rays: FloatArray,
    seen: FloatArray,
    vector: FloatArray,
    expected: FloatArray,
    frame: ImageFrame,
) -> InterFrameMotion | None:
    """The motion that most rays (3, n) agree on, which are seen at (2, n) solver px now."""
    prior = np.diag([0.0, 0.0, _ROLL_SD**-2, _LOG_FOCAL_SD**-2])
    step = expected.copy()
    begin = step * [1, 1, 0, 1]
    for scale in _SCALES_PX:
        shown, by = _project_after_motion(rays, vector, step, frame)
        off = seen - shown
        weights = (1 / (1 + (off * off).sum(axis=0) / scale**2)) ** 2
        rows = (by * weights).reshape(len(MOTION_PARAMETERS), -1)
        normal = rows @ by.reshape(len(MOTION_PARAMETERS), -1).T
        gradient = rows @ off.reshape(-1) - prior @ (step - begin)
        step = step + np.linalg.solve(
            normal + prior + 1e-9 * np.eye(len(MOTION_PARAMETERS)), gradient
        )
    counted = weights > 0.25
    if counted.sum() < max(_MIN_CORNERS, _MIN_SHARE * len(weights)):
        return None
    squares = (off[:, counted] ** 2).sum(axis=0)
    error = max(float(np.sqrt(squares.mean() / 2)), _MIN_ERROR_PX)
    covariance = np.linalg.inv(normal / (error**2 * _CORRELATED_CORNERS) + prior)
    focal = float(np.exp(vector[LOG_FOCAL]))
    drift = np.array([_DRIFT_PX / focal, _DRIFT_PX / focal, 2e-5, _DRIFT_PX / 400]) ** 2
    return InterFrameMotion(step, covariance + np.diag(drift))


def _to_solver_px(points: FloatArray, frame: ImageFrame) -> FloatArray:
    """(n, 2) px of a reduced picture -> (2, n) solver px."""
    size = np.array(
        [WORKING_WIDTH_PX, max(1, round(frame.size[1] * WORKING_WIDTH_PX / frame.size[0]))]
    )
    full = (points + 0.5) * (np.array(frame.size) / size) - 0.5
    return np.asarray(((full - frame.centre_px) * frame.scale).T)


def _from_solver_px(points: FloatArray, frame: ImageFrame) -> FloatArray:
    size = np.array(
        [WORKING_WIDTH_PX, max(1, round(frame.size[1] * WORKING_WIDTH_PX / frame.size[0]))]
    )
    full = points.T / frame.scale + frame.centre_px
    return np.asarray((full + 0.5) * (size / np.array(frame.size)) - 0.5)


def _background_points(points: FloatArray, vector: FloatArray, frame: ImageFrame) -> FloatArray:
    """(2, n) solver px -> (3, n) places far away in the world that a camera shows there."""
    lens = Lens.of(vector[None], frame.half_diagonal)
    plain = lens.undistorted(points)[0] / np.exp(vector[LOG_FOCAL])
    ways = lens.rotation[0].T @ np.vstack([plain, np.ones(plain.shape[1])])
    return np.asarray(vector[POSITION_SLICE, None] + _BACKGROUND_DISTANCE_M * ways)


def _project_after_motion(
    rays: FloatArray, vector: FloatArray, step: FloatArray, frame: ImageFrame
) -> tuple[FloatArray, FloatArray]:
    """(2, n) where the camera shows them after a step, and (4, 2, n) derivatives by it."""
    turned = vector.copy()
    turned[MOTION_PARAMETERS] += step
    lens = Lens.of(turned[None], frame.half_diagonal)
    px, _, by = project(lens, rays[None], np.zeros((1, *rays.shape)), LOG_FOCAL + 1)
    return px[0], by[0, MOTION_PARAMETERS]


@dataclass(frozen=True, eq=False)
class ProcessNoise:
    """Parameters that may change from frame to frame, and how much.

    Attributes:
        own: parameters that each frame has of its own.
        shared: those that all frames of a shot have in common.
        position_m: standard deviation of the position's change from one frame to the next.
        apparent: (4,) by how much a turn that is seen may be no turn, standard deviations of pan,
            tilt, roll and the logarithm of the focal length: what is near moves past a camera that
            moves.
    """

    own: IntArray
    shared: IntArray
    position_m: float
    apparent: FloatArray


# Radial coefficients: of a lens at rest, from frame to frame, and of one that zooms e times.
_KAPPA_SD, _KAPPA_SD_PER_ZOOM = 0.0003, 0.02
_POSITION_PARAMETERS = (X, X + 1, Z)
# Tripods give a little, and no field is quite what it should be.
TRIPOD_NOISE = ProcessNoise(
    np.array([PAN, TILT, ROLL, LOG_FOCAL, KAPPA]),
    np.array(_POSITION_PARAMETERS),
    0.015,
    np.zeros(4),
)
# Rails, cranes and cameras on ropes: some metres a second, 60 m from what they film.
MOVING_NOISE = ProcessNoise(
    np.array([PAN, TILT, ROLL, *_POSITION_PARAMETERS, LOG_FOCAL, KAPPA]),
    np.array([], dtype=np.intp),
    0.15,
    np.array([0.004, 0.004, 0.0005, 0.004]),
)


def kappa_change_sd(log_focal: FloatArray | float) -> FloatArray:
    """Standard deviation of the radial coefficient's change while the logarithm of the focal length
    changes by so much: lenses distort otherwise when they zoom."""
    return np.asarray(np.sqrt(_KAPPA_SD**2 + _KAPPA_SD_PER_ZOOM**2 * np.abs(log_focal)))


# Of a step that nothing foretells, standard deviations: pan, tilt, roll, logarithm of the focal
# length.
_UNKNOWN_MOTION = InterFrameMotion(np.zeros(4), np.diag(np.array([0.02, 0.01, 0.002, 0.05]) ** 2))


@dataclass(frozen=True, eq=False)
class MotionConstraints:
    """Between each of K frames and the next one.

    Attributes:
        step: (K - 1, 4) change of the parameters `OWN`.
        stiffness: (K - 1, 4, 4) how surely: inverse covariances.
    """

    step: FloatArray
    stiffness: FloatArray
    stand: ProcessNoise

    def add_to(
        self, information: FloatArray, pull: FloatArray, rows: slice, vectors: FloatArray
    ) -> FloatArray:
        """Add them to the normal equations of some frames.

        Args:
            information, pull: (b, 8, 8) and (b, 8).
            rows: which frames, in the order of all.
            vectors: (K, 11) of all.

        Returns:
            (b, 8, 8) stiffness between each of these frames and its next; one fewer at the end.
        """
        first = max(rows.start - 1, 0)
        last = min(rows.stop, len(self.step))
        stiff = self._between(slice(first, last), vectors)
        off = (
            vectors[first:last, :PARAMETERS_FREE] - vectors[first + 1 : last + 1, :PARAMETERS_FREE]
        )
        off[:, MOTION_PARAMETERS] += self.step[first:last]
        pulled = (stiff @ off[:, :, None])[:, :, 0]
        ahead = stiff[rows.start - first :]
        information[: len(ahead)] += ahead
        pull[: len(ahead)] -= pulled[rows.start - first :]
        begin, count = first + 1 - rows.start, rows.stop - 1 - first
        information[begin:] += stiff[:count]
        pull[begin:] += pulled[:count]
        return ahead

    def _between(self, pairs: slice, vectors: FloatArray) -> FloatArray:
        """(n, 8, 8) how stiff some of them are."""
        count = pairs.stop - pairs.start
        stiff = np.zeros((count, PARAMETERS_FREE, PARAMETERS_FREE))
        stiff[:, range(X, Z + 1), range(X, Z + 1)] = self.stand.position_m**-2
        stiff[:, MOTION_PARAMETERS[:, None], MOTION_PARAMETERS] = self.stiffness[pairs]
        zoomed = np.diff(vectors[pairs.start : pairs.stop + 1, LOG_FOCAL])
        stiff[:, KAPPA, KAPPA] = kappa_change_sd(zoomed) ** -2.0
        return stiff


def motion_constraints(
    turns: Sequence[InterFrameMotion | None], stand: ProcessNoise
) -> MotionConstraints:
    """The ties of frames between which the picture turned so; None where nothing decides."""
    motions = [turn or _UNKNOWN_MOTION for turn in turns]
    apparent = np.diag(stand.apparent**2)
    return MotionConstraints(
        np.array([turn.step for turn in motions]).reshape(-1, len(MOTION_PARAMETERS)),
        np.array([np.linalg.inv(turn.covariance + apparent) for turn in motions]).reshape(
            -1, len(MOTION_PARAMETERS), len(MOTION_PARAMETERS)
        ),
        stand,
    )
