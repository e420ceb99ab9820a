"""Cameras from K, R, t and OpenCV's distortion vectors."""

import math

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.camera.matrices import (
    angles_from_rotation,
    calibration_matrix,
    distortion_vector,
    fisheye_from_parts,
    intrinsics_from_matrix,
    pinhole_from_parts,
    pose_from_rt,
    translation,
)
from procc_annotator.camera.models import rotation_cam_from_world

K = np.array([[1500.0, 0, 470.0], [0, 1400.0, 260.0], [0, 0, 1]])
R = rotation_cam_from_world(0.2, 1.3, 0.05)
T = np.array([1.0, -2.0, 60.0])


@given(
    st.floats(-math.pi, math.pi),
    st.one_of(st.floats(0, math.pi), st.sampled_from([0.0, 1e-13, 1e-9, 1e-5, math.pi])),
    st.floats(-math.pi, math.pi),
)
def test_the_angles_are_those_of_the_rotation(pan, tilt, roll):
    rotation = rotation_cam_from_world(pan, tilt, roll)
    found = angles_from_rotation(rotation)
    np.testing.assert_allclose(rotation_cam_from_world(*found), rotation, atol=3e-12)
    assert 0 <= found[1] <= math.pi


@given(st.integers(0, 10_000), st.sampled_from([0, 4, 5, 8, 12, 14]))
def test_a_camera_of_matrices_projects_as_opencv_does(seed, count):
    random = np.random.default_rng(seed)
    turn = random.uniform(-2, 2, 3)
    rotation = np.asarray(cv2.Rodrigues(turn)[0], dtype=np.float64)
    limits = [0.3, 0.3, 0.02, 0.02, 0.2, 0.2, 0.2, 0.2, 0.02, 0.02, 0.02, 0.02, 0, 0]
    distortion = random.uniform(-1, 1, 14) * limits
    points_cam = random.uniform((-20, -10, 30), (20, 10, 90), (60, 3))
    points = (points_cam - T) @ rotation
    camera = pinhole_from_parts(
        intrinsics_from_matrix(K), pose_from_rt(rotation, T), distortion[:count].tolist()
    )
    px, valid = camera.project(points)
    assert valid.all()
    given_ = distortion[:count] if count else None
    expected, _ = cv2.projectPoints(points, turn, T, K, given_)
    np.testing.assert_allclose(px, expected[:, 0], atol=1e-6)
    again = pinhole_from_parts(
        intrinsics_from_matrix(calibration_matrix(camera)),
        pose_from_rt(camera.rotation_cam_from_world, translation(camera)),
        distortion_vector(camera),
    )
    np.testing.assert_allclose(again.project(points)[0], px, atol=1e-8)


def test_a_rounded_rotation_becomes_the_nearest_one_and_larger_flaws_are_refused():
    fine = pose_from_rt(R.round(6), T)
    assert not fine.notices
    rough = pose_from_rt(R.round(4), T)
    assert [n.split(";")[0] for n in rough.notices] == ["R is not exactly a rotation"]
    angles = fine.pan_rad, fine.tilt_rad, fine.roll_rad
    np.testing.assert_allclose(rotation_cam_from_world(*angles), R, atol=1e-6)
    for flawed, said in (
        (R * 1.01, "is no rotation"),
        (np.diag([1.0, 1.0, -1.0]) @ R, "mirrors"),
        (np.zeros((3, 3)), "is no rotation"),
        (R * 1e200, "is no rotation"),
        (np.full((3, 3), np.nan), "3 x 3 finite"),
        (R[:2], "3 x 3 finite"),
    ):
        with pytest.raises(ValueError, match=said):
            pose_from_rt(flawed, T)
    with pytest.raises(ValueError, match="t is not 3 finite"):
        pose_from_rt(R, np.array([1.0, np.inf, 0]))


def test_a_skew_is_left_out_where_it_moves_nothing_and_refused_where_it_does():
    for skew, moves in ((0.0, False), (0.05, False), (0.06, True)):
        skewed = K.copy()
        skewed[0, 1] = skew  # the lowest row of 540 is 279 px from 260: 279 / 1400 * 0.05 = 0.00996
        if moves:
            with pytest.raises(ValueError, match=r"skew, which moves pixels by up to 0\.012"):
                intrinsics_from_matrix(skewed, (960, 540))
        else:
            assert bool(intrinsics_from_matrix(skewed, (960, 540)).notices) == (skew > 0)
    assert intrinsics_from_matrix(2 * K).focal_px == (1500.0, 1400.0)


@pytest.mark.parametrize(
    "k",
    [
        np.eye(3)[[1, 0, 2]],
        np.diag([1500.0, 0, 1]),
        np.diag([1500.0, 1400.0, 0]),
        np.full((3, 3), np.nan),
        np.eye(2),
        np.array([[1500.0, 0, 470], [5.0, 1400, 260], [0, 0, 1]]),
    ],
)
def test_what_is_no_calibration_matrix_is_refused(k):
    with pytest.raises(ValueError, match="K"):
        intrinsics_from_matrix(k)


def test_distortions_nobody_here_models_are_refused():
    inside, pose = intrinsics_from_matrix(K), pose_from_rt(R, T)
    with pytest.raises(ValueError, match="6 entries, expected 4, 5, 8, 12 or 14"):
        pinhole_from_parts(inside, pose, [0.0] * 6)
    with pytest.raises(ValueError, match="tilts the sensor"):
        pinhole_from_parts(inside, pose, [0.0] * 12 + [0.01, 0])
    with pytest.raises(ValueError, match="4 entries, found 5"):
        fisheye_from_parts(inside, pose, [0.0] * 5)
    assert fisheye_from_parts(inside, pose, [0.1, 0.2, 0.3, 0.4]).coefficients == (
        0.1,
        0.2,
        0.3,
        0.4,
    )
