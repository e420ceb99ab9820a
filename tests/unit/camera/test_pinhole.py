"""The pinhole model against OpenCV, and its conventions."""

import math
from dataclasses import replace

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import projects_only_ground
from procc_annotator.camera.matrices import pose_from_rt
from procc_annotator.camera.models import FisheyeCamera, HomographyCamera, PinholeCamera, model_name

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
def test_projection_is_opencvs(pan, tilt, roll, radial, tangential, thin_prism, seed):
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


def test_a_camera_at_the_main_stand_sees_the_far_side_above_the_near_side():
    camera = PinholeCamera(0, math.radians(75), 0, (0, 60, -15), (1000, 1000), (479.5, 269.5))
    px, in_front = camera.project(np.array([[0, -34.0, 0], [0, 30.0, 0], [5, 0, 0], [-5, 0, 0]]))
    assert in_front.all()
    assert px[0, 1] < px[1, 1]
    assert px[3, 0] < px[2, 0]


def test_pan_turns_right_tilt_looks_down_from_the_zenith_and_roll_turns_the_picture():
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


def test_points_behind_the_camera_have_no_projection():
    _, in_front = MAIN.project(np.array([[0.0, 0, 0], [0.0, 120, 0], list(MAIN.position_world)]))
    assert in_front.tolist() == [True, False, False]


def test_what_a_lens_folds_back_has_no_projection():
    """r (1 - 0.3 r^2) grows up to r = 1.054."""
    barrel = replace(MAIN, radial=(-0.3, 0.0, 0.0, 0.0, 0.0, 0.0))
    points_cam = np.array([[1.05, 0, 1], [0, 1.06, 1], [2.0, 0, 1], [0.3, 0, 1]]) * 20
    points = points_cam @ MAIN.rotation_cam_from_world + MAIN.position_world
    assert barrel.project(points)[1].tolist() == [True, False, False, True]
    # The official evaluation shows it all the same.
    assert barrel.project_float32(points)[1].all()
    assert MAIN.project(points)[1].all()


def test_a_lens_folds_where_radii_stop_growing():
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


def test_single_precision_differs_by_less_than_the_specified_amount():
    points = np.random.default_rng(1).uniform((-50, -34, -2), (50, 34, 0), (500, 3))
    exact, _ = MAIN.project(points)
    rounded, _ = MAIN.project_float32(points)
    in_picture = (np.abs(exact) < 1000).all(axis=1)
    assert 0 < np.abs(exact - rounded)[in_picture].max() < 1.5e-4


def test_scaling_keeps_what_is_seen():
    points = np.random.default_rng(2).uniform((-30, -34, -2), (30, 20, 0), (50, 3))
    small, _ = MAIN.project(points)
    large, _ = MAIN.scaled((960, 540), (1280, 720)).project(points)
    np.testing.assert_allclose(large, small * (1279 / 959, 719 / 539), rtol=1e-12)


@given(pan=st.floats(-3, 3), tilt=st.floats(-3, 3), roll=st.floats(-3, 3))
def test_the_rotation_is_one(pan, tilt, roll):
    rotation = PinholeCamera(pan, tilt, roll, (0, 0, 0), (1, 1), (0, 0)).rotation_cam_from_world
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(rotation) > 0


# The fisheye model against OpenCV, and where it ends.

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
def test_fisheye_projection_is_opencvs(turn, coefficients, seed):
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


def test_points_behind_the_camera_and_beyond_the_fold_have_no_projection():
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
def test_no_coefficients_that_a_file_can_say_break_it(coefficients):
    camera = camera_of(coefficients)
    points = np.random.default_rng(0).uniform((-52, -34, -3), (52, 34, 0), (50, 3))
    px, valid = camera.project(points)
    assert px.shape == (50, 2)
    assert valid.dtype == bool
    assert 0 <= camera.largest_angle_rad <= math.pi / 2


def test_a_scaled_fisheye_keeps_what_is_seen():
    camera = camera_of((0.02, -0.01, 0.003, -0.001))
    points = np.random.default_rng(2).uniform((-30, -34, -2), (30, 20, 0), (50, 3))
    small, _ = camera.project(points)
    large, _ = camera.scaled((1280, 720), (1920, 1080)).project(points)
    np.testing.assert_allclose(large, small * (1919 / 1279, 1079 / 719), rtol=1e-12)


# Homographies as cameras, and the way back from pixels to the ground.

PINHOLE = PinholeCamera(
    math.radians(8), math.radians(78), 0.01, (2, 60, -15), (1400, 1400), (479.5, 269.5)
)


def homography_of(camera: PinholeCamera) -> np.ndarray:
    """The exact image-from-ground matrix of an undistorted pinhole camera."""
    rotation = camera.rotation_cam_from_world
    translation = -rotation @ np.array(camera.position_world)
    fx, fy = camera.focal_px
    cx, cy = camera.principal_point_px
    matrix = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
    return matrix @ np.column_stack([rotation[:, 0], rotation[:, 1], translation])


@pytest.mark.parametrize("factor", [1.0, -1.0, 1e-3, -250.0])
def test_it_sees_the_ground_where_the_pinhole_does_whatever_its_scale(factor):
    world_from_image = np.linalg.inv(homography_of(PINHOLE)) * factor
    camera = HomographyCamera.from_world_from_image(world_from_image, (960, 540))
    points = np.random.default_rng(0).uniform((-52, -34, 0), (52, 120, 0), (200, 3))
    expected, in_front = PINHOLE.project(points)
    px, valid = camera.project(points)
    assert (valid == in_front).all()
    assert not valid.all()
    np.testing.assert_allclose(px[valid], expected[valid], atol=1e-6)


def test_it_knows_the_ground_only():
    camera = HomographyCamera.from_world_from_image(np.eye(3), (960, 540))
    _, valid = camera.project(np.array([[1.0, 2, 0], [1.0, 2, -2.44]]))
    assert valid.tolist() == [True, False]
    assert projects_only_ground(camera)
    assert not projects_only_ground(PINHOLE)


@pytest.mark.parametrize(
    "matrix",
    [np.zeros((3, 3)), np.ones((3, 3)), np.eye(2), np.full((3, 3), np.nan), np.diag([1, 1, 0.0])],
)
def test_what_is_no_homography_is_refused(matrix):
    with pytest.raises(ValueError, match=r"3 x 3 finite|inverted"):
        HomographyCamera.from_world_from_image(matrix, (960, 540))


def test_a_scaled_homography_keeps_what_is_seen():
    camera = HomographyCamera.from_world_from_image(
        np.linalg.inv(homography_of(PINHOLE)), (960, 540)
    )
    points = np.array([[0.0, 0, 0], [10, -20, 0]])
    small, _ = camera.project(points)
    large, _ = camera.scaled((960, 540), (1920, 1080)).project(points)
    np.testing.assert_allclose(large, small * (1919 / 959, 1079 / 539))


@given(k1=st.floats(0, 0.3), x=st.floats(-40, 40), y=st.floats(-34, 34))
def test_pixel_to_ground_is_the_way_back(k1, x, y):
    camera = PinholeCamera(
        0.1, 1.3, 0.0, (2, 60, -15), (800, 810), (479.5, 269.5), (k1, 0, 0, 0, 0, 0)
    )
    px, _ = camera.project(np.array([[x, y, 0.0]]))
    ground = ground_from_px(camera, px)
    np.testing.assert_allclose(ground, [[x, y]], atol=1e-6)


def test_pixels_above_the_horizon_show_no_ground():
    for camera in (
        PINHOLE,
        HomographyCamera.from_world_from_image(np.linalg.inv(homography_of(PINHOLE)), (960, 540)),
    ):
        ground = ground_from_px(camera, np.array([[480.0, -2000.0], [480.0, 400.0]]))
        assert np.isnan(ground[0]).all()
        assert np.isfinite(ground[1]).all()


def test_an_unknown_model_finds_its_way_back_too():
    class Flat:
        def project(self, points_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            return points_world[:, :2], np.ones(len(points_world), dtype=bool)

    ground = ground_from_px(Flat(), np.array([[0.0, 0.0], [12.5, -7.25], [1e6, 0.0]]))
    np.testing.assert_allclose(ground[:2], [[0.0, 0.0], [12.5, -7.25]], atol=1e-9)
    assert np.isnan(ground[2]).all()


# Pinholes are told apart by what is free in them.

SIZE = (960, 540)
PLAIN = PinholeCamera(0.1, 1.3, 0.0, (0.0, 60.0, -15.0), (1200.0, 1200.0), (479.5, 269.5))


@pytest.mark.parametrize(
    ("changes", "name"),
    [
        ({}, "pinhole P"),
        ({"principal_point_px": (480.0, 270.0)}, "pinhole P"),
        ({"radial": (0.1, 0.0, 0.0, 0.0, 0.0, 0.0)}, "pinhole R"),
        ({"focal_px": (1200.0, 1210.0)}, "pinhole R+"),
        ({"principal_point_px": (490.0, 269.5)}, "pinhole R+"),
        ({"radial": (0.1, 0.02, 0.0, 0.0, 0.0, 0.0)}, "pinhole R2"),
        ({"tangential": (0.001, 0.0)}, "pinhole full"),
        ({"radial": (0.1, 0.0, 0.0, 0.01, 0.0, 0.0)}, "pinhole full"),
    ],
)
def test_pinholes_are_named_as_fits_are(changes, name):
    assert model_name(replace(PLAIN, **changes), "pinhole", SIZE) == name


def test_the_name_is_the_same_at_another_size():
    camera = replace(PLAIN, principal_point_px=(639.5, 359.5))
    assert model_name(camera.scaled((1280, 720), SIZE), "pinhole", SIZE) == "pinhole P"


def test_other_models_keep_their_names():
    flat = HomographyCamera([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    assert model_name(flat, "homography", SIZE) == "homography"
