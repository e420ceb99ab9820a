"""From pixels back to the ground: every model inverts its own projection."""

import math
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import Camera, ElementProjections, scaled_camera
from procc_annotator.camera.custom import validated_camera
from procc_annotator.camera.models import FisheyeCamera, MatrixCamera, PinholeCamera
from procc_annotator.errors import UsageError

SIZE = (1280, 720)
BASE = {
    "pan_rad": 0.1,
    "tilt_rad": 1.28,
    "roll_rad": 0.01,
    "position_world": (2.0, 60.0, -15.0),
    "focal_px": (1400.0, 1410.0),
    "principal_point_px": (640.0, 360.0),
}


@dataclass(frozen=True)
class Unknown:
    """A model of which nothing is known but its projection."""

    camera: Camera

    def project(self, points_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return self.camera.project(points_world)


def pinhole(**changes: object) -> PinholeCamera:
    return PinholeCamera(**(BASE | changes))


def fisheye(*coefficients: float, **changes: object) -> FisheyeCamera:
    values = BASE | {"focal_px": (600.0, 610.0)} | changes
    return FisheyeCamera(**values, coefficients=coefficients)


def grid(columns: int = 64, rows: int = 36) -> np.ndarray:
    x, y = np.meshgrid(np.linspace(0, SIZE[0] - 1, columns), np.linspace(0, SIZE[1] - 1, rows))
    return np.column_stack((x.ravel(), y.ravel()))


CAMERAS = {
    "plain": pinhole(),
    "one coefficient": pinhole(radial=(0.25, 0, 0, 0, 0, 0)),
    "strong barrel": pinhole(focal_px=(700.0, 700.0), radial=(-0.3, 0.06, 0, 0, 0, 0)),
    "pincushion": pinhole(focal_px=(900.0, 900.0), radial=(0.4, 0.2, 0, 0, 0, 0)),
    "tangential": pinhole(radial=(-0.2, 0.05, 0, 0, 0, 0), tangential=(0.004, -0.003)),
    "everything": pinhole(
        focal_px=(900.0, 890.0),
        radial=(-0.3, 0.1, -0.01, 0.02, 0.01, 0.001),
        tangential=(0.01, -0.02),
        thin_prism=(0.01, 0.002, -0.01, 0.001),
    ),
    "fisheye": fisheye(0.02, -0.01, 0.003, -0.001),
    "folding fisheye": fisheye(-0.12, 0.0, 0.0, 0.0),
    "straight down": pinhole(pan_rad=0.0, tilt_rad=0.0, position_world=(3.0, -4.0, -70.0)),
}


@pytest.mark.parametrize("name", CAMERAS)
def test_every_ground_point_in_the_picture_comes_back(name):
    camera = CAMERAS[name]
    random = np.random.default_rng(3)
    ground = random.uniform((-60, -40), (60, 40), (4000, 2))
    px, valid = camera.project(np.column_stack((ground, np.zeros(len(ground)))))
    inside = valid & (px >= 0).all(axis=1) & (px <= np.array(SIZE) - 1).all(axis=1)
    inside &= _before_the_fold(camera, ground)
    assert inside.sum() > 100
    found = ground_from_px(camera, px[inside])
    np.testing.assert_allclose(found, ground[inside], atol=1e-6)


@pytest.mark.parametrize("name", CAMERAS)
def test_every_pixel_that_shows_ground_projects_onto_itself(name):
    camera = CAMERAS[name]
    px = grid()
    ground = ground_from_px(camera, px)
    known = np.isfinite(ground).all(axis=1)
    assert known.mean() > 0.4
    back, valid = camera.project(np.column_stack((ground[known], np.zeros(known.sum()))))
    assert valid.all()
    np.testing.assert_allclose(back, px[known], atol=1e-7)


@pytest.mark.parametrize("name", [n for n in CAMERAS if n != "everything"])
def test_a_model_nobody_knows_comes_to_the_same_ground(name):
    camera = CAMERAS[name]
    px = grid(48, 27)
    exact = ground_from_px(camera, px)
    on_field = np.isfinite(exact).all(axis=1) & (np.abs(exact) < 150).all(axis=1)
    found = ground_from_px(Unknown(camera), px)
    np.testing.assert_allclose(found[on_field], exact[on_field], atol=1e-6)
    # Nothing is made up where there is no ground.
    nowhere = ~np.isfinite(exact).all(axis=1)
    assert np.isnan(found[nowhere]).all()


@given(
    k1=st.floats(-0.3, 0.4),
    k2=st.floats(-0.1, 0.1),
    p1=st.floats(-0.01, 0.01),
    tilt=st.floats(0.6, 1.45),
    focal=st.floats(800, 4000),
    x=st.floats(-50, 50),
    y=st.floats(-34, 34),
)
def test_random_cameras(k1, k2, p1, tilt, focal, x, y):
    camera = pinhole(
        tilt_rad=tilt, focal_px=(focal, focal), radial=(k1, k2, 0, 0, 0, 0), tangential=(p1, 0)
    )
    px, valid = camera.project(np.array([[x, y, 0.0]]))
    seen = valid[0] and (px >= 0).all() and (px <= np.array(SIZE) - 1).all()
    if seen and _before_the_fold(camera, np.array([[x, y]]))[0]:
        np.testing.assert_allclose(ground_from_px(camera, px), [[x, y]], atol=1e-6)


def test_the_sky_and_what_a_folding_lens_never_shows_are_no_ground():
    level = pinhole(tilt_rad=math.pi / 2)
    above, below = np.array([[640.0, 100.0]]), np.array([[640.0, 500.0]])
    for camera in (level, Unknown(level)):
        assert np.isnan(ground_from_px(camera, above)).all()
        assert np.isfinite(ground_from_px(camera, below)).all()
    folding = pinhole(focal_px=(400.0, 400.0), radial=(-0.3, 0, 0, 0, 0, 0))
    # r - 0.3 r^3 never exceeds 0.703: nothing is seen farther than 281 px from the middle.
    assert np.isnan(ground_from_px(folding, np.array([[640.0 + 290, 360.0]]))).all()
    assert np.isfinite(ground_from_px(folding, np.array([[640.0 + 200, 460.0]]))).all()
    assert np.isnan(ground_from_px(pinhole(position_world=(0, 60.0, 15.0)), below)).all()
    assert np.isnan(ground_from_px(level, np.array([[np.nan, 1.0], [np.inf, 1.0]]))).all()
    assert ground_from_px(level, np.empty((0, 2))).shape == (0, 2)
    assert ground_from_px(Unknown(level), np.empty((0, 2))).shape == (0, 2)


def test_projections_alone_have_no_ground():
    assert np.isnan(ground_from_px(ElementProjections({}), grid(3, 3))).all()


@pytest.mark.parametrize("wrong", [[1, 2], [[1, 2, 3]], None, "x", [["a", "b"]], [[1, 2], [3]]])
def test_pixels_that_are_no_pairs_are_refused_by_every_model(wrong):
    matrix, plain = np.hstack((np.eye(3), np.ones((3, 1)))), CAMERAS["plain"]
    others = (validated_camera(Unknown(plain)), FitResult("P", SIZE, None))
    for camera in (plain, CAMERAS["fisheye"], MatrixCamera.of(matrix), *others):
        assert camera.ground_from_px([]).shape == (0, 2)
        with pytest.raises(UsageError, match=r"expected pixels as \(N, 2\) numbers"):
            camera.ground_from_px(wrong)


def test_a_model_that_cannot_be_scaled_is_scaled_from_outside():
    camera = scaled_camera(Unknown(CAMERAS["tangential"]), SIZE, (960, 540))
    points = np.random.default_rng(0).uniform((-30, -30, -2), (30, 30, 0), (40, 3))
    own = CAMERAS["tangential"].scaled(SIZE, (960, 540))
    np.testing.assert_allclose(camera.project(points)[0], own.project(points)[0], atol=1e-9)
    twice = camera.scaled((960, 540), SIZE)
    np.testing.assert_allclose(
        twice.project(points)[0], CAMERAS["tangential"].project(points)[0], atol=1e-9
    )
    px = grid(8, 5)[8:] * (959 / 1279, 539 / 719)  # without the upper edge, next to the horizon
    np.testing.assert_allclose(ground_from_px(camera, px), ground_from_px(own, px), atol=1e-6)


def _before_the_fold(camera: PinholeCamera | FisheyeCamera, ground: np.ndarray) -> np.ndarray:
    """Whether points appear where the lens model still grows with the angle off the axis.

    A point beyond shares its pixel with one nearer to the axis, which the pixel means.
    """
    if isinstance(camera, FisheyeCamera) or not camera.is_distorted:
        return np.ones(len(ground), dtype=bool)
    points = np.column_stack((ground, np.zeros(len(ground))))
    cam = (points - np.array(camera.position_world)) @ camera.rotation_cam_from_world.T
    good = cam[:, 2] > 0.1
    radius = np.hypot(cam[:, 0], cam[:, 1]) / np.where(good, cam[:, 2], 1.0)
    r = np.linspace(0, 3, 3001)[1:]
    k1, k2, k3, k4, k5, k6 = camera.radial
    under = 1 + k4 * r**2 + k5 * r**4 + k6 * r**6
    seen = r * (1 + k1 * r**2 + k2 * r**4 + k3 * r**6) / under
    turns = np.flatnonzero(np.diff(seen) <= 0)
    limit = r[turns[0]] * 0.9 if len(turns) else 3.0
    return good & (radius < limit)
