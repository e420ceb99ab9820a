"""Move a camera so that field points appear at given pixels, then align it with the lines."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.line_alignment.gaussian_state import (
    PARAMETERS_FREE,
    GaussianState,
    default_state,
)
from procc_annotator.calibration.line_alignment.refinement import LineAlignment, align_with_lines
from procc_annotator.calibration.optimization.camera_parameters import (
    POSITION_SLICE,
    vector_from_camera,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.projection import Lens, project
from procc_annotator.camera.models import NEAREST_DEPTH_M, PinholeCamera, rotation_cam_from_world
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import translatable

Vector = tuple[float, float, float]

_ITERATIONS = 30
_SOLVER_CONVERGED_PX = 1e-3
_MAX_STEP = 0.5  # rad, and of the logarithm of the focal length
_DIRECTION_STEP_M = 1e-3
# Standard deviations that leave a peg where it was put, and of what else turns or zooms, where
# pegs do not say.
_CONTROL_POINT_SD_PX = 0.03
_ROTATION_PRIOR_RAD, _ZOOM_PRIOR, _ROLL_PRIOR_RAD = 10.0, 0.3, 0.03
_MAX_ZOOM = 3.0  # of the logarithm of the focal length, from what it began with
_ROTATION_ROWS, _ZOOM_ROW = [0, 1, 3], 2
_OPTICAL_AXIS = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True)
class ControlPoint:
    """A place of the field that a person put where it belongs in the picture.

    Attributes:
        world: metres.
        px: where it is in the picture.
        along: the direction of its line, (3,) metres, of a place that nothing decides from others
            on it: only the distance across the line counts. None for a corner, an end, a spot.
        sd_px: how exactly it could be put there.
    """

    world: Vector
    px: tuple[float, float]
    along: Vector | None = None
    sd_px: float = 1.0


def fit_control_points(
    camera: PinholeCamera, pegs: Sequence[ControlPoint], hand: ControlPoint | None = None
) -> PinholeCamera:
    """The camera nearest to one that shows all pegs where they are.

    Args:
        camera: to begin with, px of the picture.
        pegs: that were put down before.
        hand: the one that is being put: it is met exactly, and in both directions; the others as
            well as they can be. None: all are met as well as they can be.

    Returns:
        The camera turned and, where there is more than one peg, zoomed; the one to begin with where
        no camera that stands there shows them so.
    """
    every = [*pegs, hand] if hand is not None else list(pegs)
    if not every:
        return camera
    seen = _ControlPointArrays.of(camera, every, with_hand=hand is not None)
    free = 2 if len(every) == 1 else 4
    change = np.zeros(4)
    inverse_sd = (
        1
        / np.array([_ROTATION_PRIOR_RAD, _ROTATION_PRIOR_RAD, _ZOOM_PRIOR, _ROLL_PRIOR_RAD])[:free]
    )
    for _ in range(_ITERATIONS):
        found = seen.residuals(camera, change)
        if found is None or not np.isfinite(found[0]).all():
            return camera
        off, by = found[0], found[1][:, :free]
        step = _constrained_step(off, by, seen.exact, inverse_sd, change[:free])
        # A hand that pulls far is followed by and by: turns and zoom are not linear.
        step /= max(1.0, float(np.abs(step).max()) / _MAX_STEP)
        change[:free] += step
        if abs(change[2]) > _MAX_ZOOM:
            return camera
        if float(np.abs(by @ step).max()) < _SOLVER_CONVERGED_PX:
            return rotated_camera(camera, change)
    return camera


def control_point_errors(camera: PinholeCamera, pegs: Sequence[ControlPoint]) -> FloatArray:
    """(n,) px that a camera shows pegs next to their places; infinite where it does not show
    one."""
    world = np.array([peg.world for peg in pegs])
    along = np.array([peg.along or (0.0, 0.0, 0.0) for peg in pegs])
    px, shown = camera.project(np.concatenate([world, world + _DIRECTION_STEP_M * along]))
    count = len(pegs)
    off = np.array([peg.px for peg in pegs]) - px[:count]
    ahead = (px[count:] - px[:count]).T
    across = np.abs(ahead[0] * off[:, 1] - ahead[1] * off[:, 0])
    across /= np.maximum(np.hypot(*ahead), 1e-12)
    lines = np.array([peg.along is not None for peg in pegs])
    away = np.where(lines, across, np.hypot(*off.T))
    return np.asarray(np.where(shown[:count], away, np.inf))


def rotated_camera(camera: PinholeCamera, change: FloatArray) -> PinholeCamera:
    """A camera turned and zoomed where it stands by a change (4,) of pan, tilt, rad; of the
    logarithm of the focal length; of roll, rad. Its lens bends the picture as before."""
    pan, tilt, zoom, roll = change.tolist()
    times = float(np.exp(zoom))
    k1, k2, k3, k4, k5, k6 = camera.radial
    s1, s2, s3, s4 = camera.thin_prism
    # Coefficients are of directions, which a longer lens spreads wider over the same picture.
    two, four, six = times**2, times**4, times**6
    return replace(
        camera,
        pan_rad=camera.pan_rad + pan,
        tilt_rad=camera.tilt_rad + tilt,
        roll_rad=camera.roll_rad + roll,
        focal_px=(camera.focal_px[0] * times, camera.focal_px[1] * times),
        radial=(k1 * two, k2 * four, k3 * six, k4 * two, k5 * four, k6 * six),
        tangential=(camera.tangential[0] * times, camera.tangential[1] * times),
        thin_prism=(s1 * times, s2 * times**3, s3 * times, s4 * times**3),
    )


@dataclass(frozen=True, eq=False)
class _ControlPointArrays:
    """n pegs as arrays. A lens bends the picture the same way however far it is zoomed in: so pegs
    are compared where a lens without distortion would show them.

    Attributes:
        world: (3, 2 n) metres from where the camera stands: the places, then places a little
            farther along their lines.
        px: (n, 2) undistorted, from the principal point.
        across: rows of those of which only the distance across the line counts.
        both: rows of the others.
        exact: how many of the last residuals are to be met exactly.
    """

    world: FloatArray
    px: FloatArray
    across: IntArray
    both: IntArray
    exact: int

    @classmethod
    def of(
        cls, camera: PinholeCamera, pegs: Sequence[ControlPoint], *, with_hand: bool
    ) -> _ControlPointArrays:
        places = np.array([peg.world for peg in pegs]) - camera.position_world
        along = np.array([peg.along or (0.0, 0.0, 0.0) for peg in pegs])
        lines = np.array([peg.along is not None for peg in pegs])
        if with_hand:
            lines[-1] = False
        rays = camera.rays_cam(np.array([peg.px for peg in pegs], dtype=np.float64))
        world = np.concatenate([places, places + _DIRECTION_STEP_M * along]).T
        px = (rays[:2] / rays[2]).T * camera.focal_px
        across, both = np.flatnonzero(lines), np.flatnonzero(~lines)
        return cls(world, px, across, both, 2 if with_hand else 0)

    def residuals(
        self, camera: PinholeCamera, change: FloatArray
    ) -> tuple[FloatArray, FloatArray] | None:
        """(m,) px that the pegs are off, and (m, 4) derivatives; None where one is not shown."""
        pan, tilt, zoom, roll = change.tolist()
        turn = rotation_cam_from_world(
            camera.pan_rad + pan, camera.tilt_rad + tilt, camera.roll_rad + roll
        )
        place = turn @ self.world
        count = len(self.px)
        depth = place[2]
        if (depth <= NEAREST_DEPTH_M).any():
            return None
        focal = np.array(camera.focal_px)[:, None] * np.exp(zoom)
        shown = focal * place[:2] / depth
        # Each angle turns the camera about an axis; places turn the other way.
        rolled = camera.roll_rad + roll
        level = np.array([np.cos(rolled), -np.sin(rolled), 0.0])
        axes = np.stack([turn[:, 2], level, _OPTICAL_AXIS])[:, :, None]
        at = place[:, :count] / depth[:count]
        moved = np.empty((4, 2, count))
        turns = moved[_ROTATION_ROWS]  # what (at x axis) does, less what it does to the depth
        turns[:, 0] = at[1] * axes[:, 2] - axes[:, 1]
        turns[:, 1] = axes[:, 0] - at[0] * axes[:, 2]
        turns -= at[:2] * (at[0] * axes[:, 1] - at[1] * axes[:, 0])[:, None]
        moved[_ROTATION_ROWS] = focal * turns
        moved[_ZOOM_ROW] = shown[:, :count]
        off = self.px - shown[:, :count].T
        ahead = (shown[:, count:] - shown[:, :count])[:, self.across]
        normal = np.stack([-ahead[1], ahead[0]]) / np.maximum(np.hypot(*ahead), 1e-12)
        across = (off[self.across].T * normal).sum(axis=0)
        by_across = (moved[:, :, self.across] * normal).sum(axis=1).T
        by_both = moved[:, :, self.both].transpose(2, 1, 0).reshape(-1, 4)
        return (
            np.concatenate([across, off[self.both].reshape(-1)]),
            np.concatenate([by_across, by_both]),
        )


def _constrained_step(
    off: FloatArray, by: FloatArray, exact: int, inverse_sd: FloatArray, change: FloatArray
) -> FloatArray:
    """The step that takes the pegs to their places, and the rest back to where it began."""
    free, soft = len(inverse_sd), len(off) - exact
    weighted, pull = by[:soft] / _CONTROL_POINT_SD_PX, off[:soft] / _CONTROL_POINT_SD_PX
    system = np.zeros((free + exact, free + exact))
    system[:free, :free] = weighted.T @ weighted + np.diag(inverse_sd**2)
    system[:free, free:], system[free:, :free] = by[soft:].T, by[soft:]
    right = np.concatenate([weighted.T @ pull - inverse_sd**2 * change, off[soft:]])
    try:
        return np.asarray(np.linalg.solve(system, right)[:free])
    except np.linalg.LinAlgError:  # straight down pan and roll are the same
        return np.asarray(np.linalg.lstsq(system, right, rcond=None)[0][:free])


# A person who drags lines to where they belong saw them about right; a camera stands where it was
# found to stand, to a metre or two.
_POINT_PRIOR_M = 2.0
_MAX_DEVIATION_SD, _MIN_TOLERANCE_SHARE = (
    3.0,
    2.0 / 960,
)  # that paint may move a peg: by its own deviation, of width
_MIN_COVERAGE, _CLEAR_COVERAGE = 0.5, 0.8
_TRIAL_ZOOMS = (-0.05, 0.05, -0.1, 0.1, -0.15, 0.15)  # of the logarithm of the focal length


def align_with_control_points(
    picture: PixelArray,
    field: Field,
    camera: PinholeCamera,
    pegs: Sequence[ControlPoint],
    *,
    go_on: Callable[[], None] = lambda: None,
) -> tuple[LineAlignment | None, str]:
    """The same camera on the paint near its lines, the pegs within the precision of a hand.

    One peg says nothing of the zoom: others near it are tried, and the one counts whose lines are
    on paint.

    Args:
        picture: (H, W, 4) BGRA.
        camera: that shows the pegs where they are, px of the picture.
        pegs: at least one.
        go_on: called between the tries; raises whatever it likes when no one wants the rest.

    Returns:
        What was found, or None and why the paint does not say: too little of it is seen, or it
        would take a peg from its place.
    """
    best, why = _align_at_zoom(picture, field, camera, pegs)
    if len(pegs) > 1 or (best is not None and best.coverage >= _CLEAR_COVERAGE):
        return best, why
    for zoom in _TRIAL_ZOOMS:
        go_on()
        zoomed = fit_control_points(rotated_camera(camera, np.array([0.0, 0.0, zoom, 0.0])), pegs)
        found, _ = _align_at_zoom(picture, field, zoomed, pegs)
        if found is not None and (best is None or found.coverage > best.coverage):
            best = found
    return best, "" if best is not None else why


def _align_at_zoom(
    picture: PixelArray, field: Field, camera: PinholeCamera, pegs: Sequence[ControlPoint]
) -> tuple[LineAlignment | None, str]:
    frame = ImageFrame((picture.shape[1], picture.shape[0]))
    vector = vector_from_camera(camera, frame)
    information = default_state(vector, field).information + _control_point_information(
        pegs, vector, frame
    )
    information[POSITION_SLICE, POSITION_SLICE] += np.eye(3) / _POINT_PRIOR_M**2
    found = align_with_lines(picture, field, camera, belief=GaussianState(vector, information))
    refined = found.fit.camera
    if not isinstance(refined, PinholeCamera):
        return None, found.fit.failure or translatable("there is too little paint")
    if found.coverage < _MIN_COVERAGE:
        return None, translatable(
            "only {share:.0%} of the lines in sight are on paint", share=found.coverage
        )
    for off, peg in zip(control_point_errors(refined, pegs).tolist(), pegs, strict=True):
        if not off <= max(_MAX_DEVIATION_SD * peg.sd_px, _MIN_TOLERANCE_SHARE * frame.size[0]):
            return None, translatable("the paint nearby would take a peg from its place")
    return found, ""


def _control_point_information(
    pegs: Sequence[ControlPoint], vector: FloatArray, frame: ImageFrame
) -> FloatArray:
    """(8, 8) information of pegs that a camera (11,) shows where they are."""
    world = np.array([peg.world for peg in pegs]).T[None]
    along = np.array([peg.along or (0.0, 0.0, 0.0) for peg in pegs]).T[None]
    lens = Lens.of(vector[None], frame.half_diagonal)
    _, moved, by = project(lens, world, along, PARAMETERS_FREE)
    found = np.zeros((PARAMETERS_FREE, PARAMETERS_FREE))
    for row, peg in enumerate(pegs):
        own = by[0, :, :, row] / (peg.sd_px * frame.scale)
        if peg.along is not None:
            x, y = moved[0, :, row]
            own = own @ (np.array([[-y], [x]]) / max(float(np.hypot(x, y)), 1e-12))
        found += own @ own.T
    return found
