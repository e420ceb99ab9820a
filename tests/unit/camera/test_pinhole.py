"""The pinhole model against OpenCV, and its conventions."""

from __future__ import annotations

import math
from dataclasses import replace

import cv2
import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.camera.models import PinholeCamera

MAIN = PinholeCamera(
    math.radians(10),
    math.radians(78),
    math.radians(1),
    (0.0, 60.0, -15.0),
    (2000.0, 1990.0),
    (479.5, 269.5),
)


def coefficients(limit: float, count: int) -> st.SearchStrategy[tuple[float, ...]]:
    return st.tuples(*[st.floats(-limit, limit)] * count)


@given(
    pan=st.floats(-math.pi, math.pi),
    tilt=st.floats(0.2, 2.0),
    roll=st.floats(-0.3, 0.3),
    radial=coefficients(0.3, 6),
    tangential=coefficients(0.02, 2),
    thin_prism=coefficients(0.02, 4),
    seed=st.integers(0, 1000),
)
def test_projection_is_opencvs(pan, tilt, roll, radial, tangential, thin_prism, seed) -> None:
    camera = PinholeCamera(
        pan, tilt, roll, (3.0, 60.0, -15.0), (1500.0, 1400.0), (470.0, 260.0),
        radial, tangential, thin_prism,
    )  # fmt: skip
    rotation = camera.rotation_cam_from_world
    points_cam = np.random.default_rng(seed).uniform((-20, -10, 30), (20, 10, 90), (40, 3))
    points_world = points_cam @ rotation + camera.position_world
    px, in_front = camera.project(points_world)
    assert in_front.all()
    matrix = np.array([[1500.0, 0, 470.0], [0, 1400.0, 260.0], [0, 0, 1]])
    distortion = np.array([*radial[:2], *tangential, *radial[2:], *thin_prism])
    expected, _ = cv2.projectPoints(
        points_world,
        cv2.Rodrigues(rotation)[0],
        -rotation @ np.array(camera.position_world),
        matrix,
        distortion,
    )
    np.testing.assert_allclose(px, expected[:, 0], atol=1e-6)


def test_a_camera_at_the_main_stand_sees_the_far_side_above_the_near_side() -> None:
    camera = PinholeCamera(0, math.radians(75), 0, (0, 60, -15), (1000, 1000), (479.5, 269.5))
    px, in_front = camera.project(np.array([[0, -34.0, 0], [0, 30.0, 0], [5, 0, 0], [-5, 0, 0]]))
    assert in_front.all()
    assert px[0, 1] < px[1, 1]
    assert px[3, 0] < px[2, 0]


def test_pan_turns_right_tilt_looks_down_from_the_zenith_and_roll_turns_the_picture() -> None:
    def axis(pan: float, tilt: float) -> list[float]:
        """Where the camera looks, in the world."""
        camera = PinholeCamera(math.radians(pan), math.radians(tilt), 0, (0, 0, 0), (1, 1), (0, 0))
        return [round(float(v), 9) + 0.0 for v in camera.rotation_cam_from_world[2]]

    assert axis(0, 90) == [0, -1, 0]  # level, from the main stand across the field
    assert axis(90, 90) == [1, 0, 0]  # towards the right goal
    assert axis(-90, 90) == [-1, 0, 0]
    assert axis(180, 90) == [0, 1, 0]
    assert axis(0, 0) == [0, 0, 1]  # straight down
    assert axis(0, 60)[2] > 0  # less than 90 looks down at the field
    rolled = PinholeCamera(0, math.pi / 2, math.radians(10), (0, 0, 0), (100, 100), (0, 0))
    px, _ = rolled.project(np.array([[10.0, -10, 0]]))
    np.testing.assert_allclose(
        px, [[100 * math.cos(math.radians(10)), -100 * math.sin(math.radians(10))]]
    )


def test_points_behind_the_camera_have_no_projection() -> None:
    _, in_front = MAIN.project(np.array([[0.0, 0, 0], [0.0, 120, 0], list(MAIN.position_world)]))
    assert in_front.tolist() == [True, False, False]


def test_what_a_lens_folds_back_has_no_projection() -> None:
    """r (1 - 0.3 r^2) grows up to r = 1.054."""
    barrel = replace(MAIN, radial=(-0.3, 0.0, 0.0, 0.0, 0.0, 0.0))
    points_cam = np.array([[1.05, 0, 1], [0, 1.06, 1], [2.0, 0, 1], [0.3, 0, 1]]) * 20
    points = points_cam @ MAIN.rotation_cam_from_world + MAIN.position_world
    assert barrel.project(points)[1].tolist() == [True, False, False, True]
    # The official evaluation shows it all the same.
    assert barrel.project_float32(points)[1].all()
    assert MAIN.project(points)[1].all()


def test_a_lens_folds_where_radii_stop_growing() -> None:
    rng = np.random.default_rng(3)
    r = np.linspace(0, 4, 20001)
    s = r * r
    folding = 0
    for _ in range(60):
        radial = rng.uniform(-0.4, 0.4, 6) * (rng.uniform(size=6) < 0.6)
        k1, k2, k3, k4, k5, k6 = radial.tolist()
        under = 1 + s * (k4 + s * (k5 + s * k6))
        shown = r * (1 + s * (k1 + s * (k2 + s * k3))) / np.where(under > 0, under, np.nan)
        grows = np.diff(shown) > 0  # False for NaN
        found = replace(MAIN, radial=(k1, k2, k3, k4, k5, k6)).fold_radius
        if grows.all():
            assert found > 3.999
        else:
            folding += 1
            assert abs(found - r[np.argmin(grows)]) < 5e-4
    assert 20 < folding < 55


def test_single_precision_differs_by_less_than_the_specified_amount() -> None:
    points = np.random.default_rng(1).uniform((-50, -34, -2), (50, 34, 0), (500, 3))
    exact, _ = MAIN.project(points)
    rounded, _ = MAIN.project_float32(points)
    in_picture = (np.abs(exact) < 1000).all(axis=1)
    assert 0 < np.abs(exact - rounded)[in_picture].max() < 1.5e-4


def test_scaling_keeps_what_is_seen() -> None:
    points = np.random.default_rng(2).uniform((-30, -34, -2), (30, 20, 0), (50, 3))
    small, _ = MAIN.project(points)
    large, _ = MAIN.scaled((960, 540), (1280, 720)).project(points)
    np.testing.assert_allclose(large, small * (1279 / 959, 719 / 539), rtol=1e-12)


@given(pan=st.floats(-3, 3), tilt=st.floats(-3, 3), roll=st.floats(-3, 3))
def test_the_rotation_is_one(pan, tilt, roll) -> None:
    rotation = PinholeCamera(pan, tilt, roll, (0, 0, 0), (1, 1), (0, 0)).rotation_cam_from_world
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(rotation) > 0
