"""The fisheye model against OpenCV, and where it ends."""

from __future__ import annotations

import math

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.camera.matrices import pose_from_rt
from procc_annotator.camera.models import FisheyeCamera

coefficient = st.floats(-0.05, 0.05)


def camera_of(coefficients: tuple[float, ...], **changes: object) -> FisheyeCamera:
    values = {
        "pan_rad": 0.3,
        "tilt_rad": 1.25,
        "roll_rad": 0.02,
        "position_world": (3.0, 50.0, -12.0),
        "focal_px": (600.0, 590.0),
        "principal_point_px": (640.0, 350.0),
        "coefficients": coefficients,
    }
    return FisheyeCamera(**(values | changes))


@given(
    turn=st.tuples(*[st.floats(-2.5, 2.5)] * 3),
    coefficients=st.tuples(coefficient, coefficient, coefficient, coefficient),
    seed=st.integers(0, 1000),
)
def test_projection_is_opencvs(turn, coefficients, seed) -> None:
    # From the vector to the matrix: OpenCV's way back takes turns below 1e-5 for none at all.
    rotation = np.asarray(cv2.Rodrigues(np.array(turn))[0], dtype=np.float64)
    t = np.array([1.0, -2.0, 40.0])
    pose = pose_from_rt(rotation, t)
    camera = camera_of(
        coefficients,
        pan_rad=pose.pan_rad,
        tilt_rad=pose.tilt_rad,
        roll_rad=pose.roll_rad,
        position_world=pose.position_world,
    )
    points_cam = np.random.default_rng(seed).uniform((-60, -40, 1), (60, 40, 60), (300, 3))
    points_cam[0] = (0, 0, 10)  # on the axis
    points_world = (points_cam - t) @ rotation
    px, valid = camera.project(points_world)
    expected, _ = cv2.fisheye.projectPoints(
        points_world[:, None],
        np.array(turn),
        t,
        np.array([[600.0, 0, 640.0], [0, 590.0, 350.0], [0, 0, 1]]),
        np.array(coefficients),
    )
    assert valid.any()
    np.testing.assert_allclose(px[valid], expected[valid, 0], rtol=1e-12, atol=1e-6)


def test_points_behind_the_camera_and_beyond_the_fold_have_no_projection() -> None:
    # theta - 0.3 theta^3 grows up to theta = sqrt(1 / 0.9) = 60.4 degrees, and then folds back.
    camera = camera_of((-0.3, 0, 0, 0), position_world=(0, 0, 0), pan_rad=0, tilt_rad=0)
    assert camera.largest_angle_rad == pytest.approx(math.sqrt(1 / 0.9), rel=1e-12)
    angles = np.radians([0, 30, 60, 61, 80, 89, 91, 180])
    points = np.column_stack((np.sin(angles), 0 * angles, np.cos(angles))) * 5
    _, valid = camera.project(points)
    assert valid.tolist() == [True, True, True, False, False, False, False, False]
    straight = camera_of((0, 0, 0, 0), position_world=(0, 0, 0), pan_rad=0, tilt_rad=0)
    assert straight.largest_angle_rad == math.pi / 2
    assert straight.project(points)[1].tolist() == [True] * 6 + [False] * 2


@given(st.tuples(*[st.floats(allow_nan=False, allow_infinity=False)] * 4))
def test_no_coefficients_that_a_file_can_say_break_it(coefficients) -> None:
    camera = camera_of(coefficients)
    points = np.random.default_rng(0).uniform((-52, -34, -3), (52, 34, 0), (50, 3))
    px, valid = camera.project(points)
    assert px.shape == (50, 2)
    assert valid.dtype == bool
    assert 0 <= camera.largest_angle_rad <= math.pi / 2


def test_scaling_keeps_what_is_seen() -> None:
    camera = camera_of((0.02, -0.01, 0.003, -0.001))
    points = np.random.default_rng(2).uniform((-30, -34, -2), (30, 20, 0), (50, 3))
    small, _ = camera.project(points)
    large, _ = camera.scaled((1280, 720), (1920, 1080)).project(points)
    np.testing.assert_allclose(large, small * (1919 / 1279, 1079 / 719), rtol=1e-12)
