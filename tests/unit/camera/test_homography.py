"""Homographies as cameras, and the way back from pixels to the ground."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import Camera, projects_only_ground
from procc_annotator.camera.models import HomographyCamera, PinholeCamera

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
def test_it_sees_the_ground_where_the_pinhole_does_whatever_its_scale(factor) -> None:
    world_from_image = np.linalg.inv(homography_of(PINHOLE)) * factor
    camera = HomographyCamera.from_world_from_image(world_from_image, (960, 540))
    points = np.random.default_rng(0).uniform((-52, -34, 0), (52, 120, 0), (200, 3))
    expected, in_front = PINHOLE.project(points)
    px, valid = camera.project(points)
    assert (valid == in_front).all()
    assert not valid.all()
    np.testing.assert_allclose(px[valid], expected[valid], atol=1e-6)


def test_it_knows_the_ground_only() -> None:
    camera = HomographyCamera.from_world_from_image(np.eye(3), (960, 540))
    _, valid = camera.project(np.array([[1.0, 2, 0], [1.0, 2, -2.44]]))
    assert valid.tolist() == [True, False]
    assert isinstance(camera, Camera)
    assert projects_only_ground(camera)
    assert not projects_only_ground(PINHOLE)


@pytest.mark.parametrize(
    "matrix",
    [np.zeros((3, 3)), np.ones((3, 3)), np.eye(2), np.full((3, 3), np.nan), np.diag([1, 1, 0.0])],
)
def test_what_is_no_homography_is_refused(matrix) -> None:
    with pytest.raises(ValueError, match=r"3 x 3 finite|inverted"):
        HomographyCamera.from_world_from_image(matrix, (960, 540))


def test_scaling_keeps_what_is_seen() -> None:
    camera = HomographyCamera.from_world_from_image(
        np.linalg.inv(homography_of(PINHOLE)), (960, 540)
    )
    points = np.array([[0.0, 0, 0], [10, -20, 0]])
    small, _ = camera.project(points)
    large, _ = camera.scaled((960, 540), (1920, 1080)).project(points)
    np.testing.assert_allclose(large, small * (1919 / 959, 1079 / 539))


@given(k1=st.floats(0, 0.3), x=st.floats(-40, 40), y=st.floats(-34, 34))
def test_pixel_to_ground_is_the_way_back(k1, x, y) -> None:
    camera = PinholeCamera(
        0.1, 1.3, 0.0, (2, 60, -15), (800, 810), (479.5, 269.5), (k1, 0, 0, 0, 0, 0)
    )
    px, _ = camera.project(np.array([[x, y, 0.0]]))
    ground = ground_from_px(camera, px)
    np.testing.assert_allclose(ground, [[x, y]], atol=1e-6)


def test_pixels_above_the_horizon_show_no_ground() -> None:
    for camera in (
        PINHOLE,
        HomographyCamera.from_world_from_image(np.linalg.inv(homography_of(PINHOLE)), (960, 540)),
    ):
        ground = ground_from_px(camera, np.array([[480.0, -2000.0], [480.0, 400.0]]))
        assert np.isnan(ground[0]).all()
        assert np.isfinite(ground[1]).all()


def test_an_unknown_model_finds_its_way_back_too() -> None:
    class Flat:
        def project(self, points_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            return points_world[:, :2], np.ones(len(points_world), dtype=bool)

    ground = ground_from_px(Flat(), np.array([[0.0, 0.0], [12.5, -7.25], [1e6, 0.0]]))
    np.testing.assert_allclose(ground[:2], [[0.0, 0.0], [12.5, -7.25]], atol=1e-9)
    assert np.isnan(ground[2]).all()
