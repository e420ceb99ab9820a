"""The metrics of earlier papers, against hand-made cases and an independent raster."""

import math
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.camera.base import ElementProjections
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.errors import UsageError
from procc_annotator.metrics.ground_plane import (
    GroundRectangle,
    clip_by_half_planes,
    convex_intersection,
    field_rectangle,
    ground_homography_of,
    polygon_area,
)
from procc_annotator.metrics.legacy import MetricAverage, legacy_averages, legacy_metrics

SIZE = (960, 540)
LENGTH, WIDTH = 105.0, 68.0
MAIN = PinholeCamera(
    math.radians(-8.0),
    math.radians(77.0),
    0.0,
    (0.0, 60.0, -15.0),
    (1150.0, 1150.0),
    (479.5, 269.5),
)


def moved(camera: PinholeCamera, dx: float, dy: float) -> PinholeCamera:
    x, y, z = camera.position_world
    return replace(camera, position_world=(x + dx, y + dy, z))


def matrix_of(camera) -> np.ndarray:
    """Ground to picture, from the projections of four points and nothing else."""
    if isinstance(camera, HomographyCamera):
        return camera.image_from_world
    ground = np.array([(-3.0, -5.0), (4.0, -6.0), (5.0, 8.0), (-6.0, 9.0)])
    px, valid = camera.project(np.column_stack((ground, np.zeros(4))))
    assert valid.all()
    return cv2.getPerspectiveTransform(ground.astype(np.float32), px.astype(np.float32))


def raster_ious(camera, reference, size=SIZE, cell=0.1) -> tuple[float, float]:
    """IoU_whole and IoU_part by warping masks, as the papers' code does, only finer.

    The canvas is the field and eighty metres around it.
    """
    margin = 80.0
    shape = (round((LENGTH + 2 * margin) / cell), round((WIDTH + 2 * margin) / cell))
    canvas_from_ground = np.array(
        [
            [1 / cell, 0, (LENGTH / 2 + margin) / cell - 0.5],
            [0, 1 / cell, (WIDTH / 2 + margin) / cell - 0.5],
            [0, 0, 1],
        ]
    )
    field = np.zeros((shape[1], shape[0]), np.uint8)
    border = round(margin / cell)
    field[border:-border, border:-border] = 1
    ours, theirs = matrix_of(camera), matrix_of(reference)
    through = canvas_from_ground @ np.linalg.inv(ours) @ theirs @ np.linalg.inv(canvas_from_ground)
    turned = cv2.warpPerspective(field, through, shape, flags=cv2.INTER_NEAREST)
    whole = (field & turned).sum() / (field | turned).sum()
    picture = np.ones((size[1], size[0]), np.uint8)
    shown = [
        field
        & cv2.warpPerspective(
            picture, canvas_from_ground @ np.linalg.inv(m), shape, flags=cv2.INTER_NEAREST
        )
        for m in (ours, theirs)
    ]
    return float(whole), float((shown[0] & shown[1]).sum() / (shown[0] | shown[1]).sum())


def test_a_camera_agrees_with_itself(soccer):
    for camera in (
        MAIN,
        HomographyCamera(matrix_of(MAIN)),
        replace(MAIN, radial=(0.05, *[0.0] * 5)),
    ):
        found = legacy_metrics(camera, camera, soccer, SIZE)
        assert found.iou_whole == pytest.approx(1.0)
        assert found.iou_part == pytest.approx(1.0)
        assert found.projection_m == pytest.approx(0.0, abs=1e-9)
        assert found.reprojection == pytest.approx(0.0, abs=1e-12)
        assert found.projection_lost == found.reprojection_lost == 0.0
        assert found.six_point_rmse_cm == pytest.approx(0.0, abs=1e-6)


def test_a_camera_moved_along_the_ground(soccer):
    """The whole ground moves with it, so everything can be reckoned by hand."""
    dx, dy = 3.0, -4.0
    found = legacy_metrics(moved(MAIN, dx, dy), MAIN, soccer, SIZE)
    both = (LENGTH - abs(dx)) * (WIDTH - abs(dy))
    assert found.iou_whole == pytest.approx(both / (2 * LENGTH * WIDTH - both))
    assert found.projection_m == pytest.approx(5.0)
    # Six points, each (3, 4, 0) m off, over eighteen coordinates.
    assert found.six_point_mse_cm2 == pytest.approx(1e4 * 6 * 25.0 / 18)
    assert found.six_point_rmse_cm == pytest.approx(100 * math.sqrt(6 * 25.0 / 18))


def test_reprojection_is_a_share_of_the_height(soccer):
    cx, cy = MAIN.principal_point_px
    shifted = replace(MAIN, principal_point_px=(cx + 6.0, cy - 8.0))
    found = legacy_metrics(shifted, MAIN, soccer, SIZE)
    assert found.reprojection == pytest.approx(10.0 / 540)
    doubled = [c.scaled(SIZE, (1919, 1079)) for c in (shifted, MAIN)]
    larger = legacy_metrics(doubled[0], doubled[1], soccer, (1919, 1079))
    assert larger.reprojection == pytest.approx(20.0 / 1079)


@pytest.mark.parametrize(
    "change",
    [
        {"pan_rad": math.radians(-7.0)},
        {"tilt_rad": math.radians(76.6), "roll_rad": math.radians(0.4)},
        {"focal_px": (1100.0, 1090.0)},
        {"position_world": (4.0, 55.0, -13.0)},
    ],
)
def test_polygons_against_a_raster(soccer, change):
    camera = replace(MAIN, **change)
    found = legacy_metrics(camera, MAIN, soccer, SIZE)
    whole, part = raster_ious(camera, MAIN)
    assert 0.5 < whole < 0.999
    assert found.iou_whole == pytest.approx(whole, abs=2e-3)
    assert found.iou_part == pytest.approx(part, abs=2e-3)


def test_any_model_is_reduced_to_what_it_shows(soccer):
    """A model that is not known to be a homography gives what the homography gives."""

    nearly = replace(MAIN, pan_rad=MAIN.pan_rad + 0.01, radial=(1e-9, 0, 0, 0, 0, 0))
    exact = replace(nearly, radial=(0.0,) * 6)
    assert not ground_homography_of(nearly, field_rectangle(soccer), SIZE).is_exact
    one, two = (legacy_metrics(c, MAIN, soccer, SIZE) for c in (nearly, exact))
    assert one.iou_whole == pytest.approx(two.iou_whole, abs=1e-5)
    assert one.iou_part == pytest.approx(two.iou_part, abs=2e-3)
    assert one.projection_m == pytest.approx(two.projection_m, abs=1e-5)
    assert one.reprojection == pytest.approx(two.reprojection, abs=1e-7)


def test_a_fitted_homography_is_the_nearest_one(soccer):
    """Of a distorted camera; moving it a little in any direction makes it worse in the picture."""
    bent = replace(MAIN, radial=(-0.1, 0.02, 0, 0, 0, 0))
    rectangle = field_rectangle(soccer)
    fitted = ground_homography_of(bent, rectangle, SIZE).image_from_ground
    straight = ground_homography_of(replace(bent, radial=(0.0,) * 6), rectangle, SIZE)
    x, y = np.meshgrid(np.linspace(0, 959, 48), np.linspace(0, 539, 27))
    px = np.column_stack((x.ravel(), y.ravel()))
    from procc_annotator.camera.backprojection import ground_from_px

    ground = ground_from_px(bent, px)
    seen = rectangle.holds(ground)

    def misfit(matrix):
        q = np.column_stack((ground[seen], np.ones(seen.sum()))) @ matrix.T
        return float(np.square(q[:, :2] / q[:, 2:] - px[seen]).sum())

    assert misfit(fitted) < misfit(straight.image_from_ground)
    for i in range(9):
        for sign in (-1e-4, 1e-4):
            other = fitted / fitted[2, 2]
            other.flat[i] *= 1 + sign
            assert misfit(other) >= misfit(fitted) * (1 - 1e-6)


def test_a_field_that_reaches_our_horizon_has_no_overlap(soccer):
    """A camera that looks up: what the reference shows of the field is above its horizon."""
    up = replace(MAIN, tilt_rad=math.radians(91.0))
    found = legacy_metrics(up, MAIN, soccer, SIZE)
    assert found.iou_whole == 0.0
    assert 0.0 < found.projection_lost < 1.0
    assert found.six_point_mse_cm2 is None
    assert found.six_point_rmse_cm is None


def test_a_reference_that_shows_no_field_leaves_nothing_to_measure(soccer):
    away = replace(MAIN, tilt_rad=math.radians(120.0))
    found = legacy_metrics(away, away, soccer, SIZE)
    assert found.iou_part is None
    assert found.projection_m is found.projection_lost is None
    assert found.reprojection is found.reprojection_lost is None
    only_ours = legacy_metrics(MAIN, away, soccer, SIZE)
    assert only_ours.iou_part == 0.0
    assert only_ours.projection_m is None


def test_a_camera_in_the_ground_has_no_overlap_as_a_whole(soccer):
    x, y, _ = MAIN.position_world
    in_the_ground = replace(MAIN, position_world=(x, y, 0.0))
    found = legacy_metrics(in_the_ground, MAIN, soccer, SIZE)
    assert found.iou_whole is None
    assert found.iou_part == 0.0
    assert found.projection_m is None
    assert found.projection_lost == 1.0


def test_mean_and_median_over_the_frames_that_have_a_figure(soccer):
    frames = [legacy_metrics(moved(MAIN, dx, 0.0), MAIN, soccer, SIZE) for dx in (1.0, 2.0, 6.0)]
    assert legacy_averages(frames)["projection_m"] == MetricAverage(
        pytest.approx(3.0), pytest.approx(2.0), 3
    )
    assert MetricAverage.of([None, 1.0, None]) == MetricAverage(1.0, 1.0, 1)
    assert MetricAverage.of([None]) == MetricAverage(None, None, 0)


def test_a_source_without_camera_model_is_refused(soccer):
    with pytest.raises(UsageError, match="shares only projections"):
        legacy_metrics(MAIN, ElementProjections({}), soccer, SIZE)


def test_convex_polygons():
    square = GroundRectangle(0, 0, 2, 2).corners
    shifted = GroundRectangle(1, 1, 3, 3).corners
    assert polygon_area(square) == polygon_area(square[::-1]) == 4.0
    for a in (square, square[::-1]):
        for b in (shifted, shifted[::-1]):
            assert polygon_area(convex_intersection(a, b)) == pytest.approx(1.0)
    assert polygon_area(convex_intersection(square, GroundRectangle(5, 5, 6, 6).corners)) == 0.0
    assert len(clip_by_half_planes(square, np.array([(1.0, 0.0, -5.0), (1.0, 0.0, 0.0)]))) == 0
    assert polygon_area(
        clip_by_half_planes(square, np.array([(-1.0, -1.0, 2.0)]))
    ) == pytest.approx(2.0)


def world_cup(shared_data: Path, method: str):
    """The frames of a method: (name, camera, reference)."""
    wc14 = shared_data / "wc14"
    cameras = CameraSet.open(wc14 / f"cameras_{method}")
    references = CameraSet.open(wc14 / "homographies_carwc")
    for frame in cameras.frames:
        camera, reference = (s.camera(frame, SIZE) for s in (cameras, references))
        yield frame, camera.camera, reference.camera


@pytest.mark.parametrize(
    ("method", "whole", "part"), [("pnlcalib", 0.919, 0.977), ("nbjw", 0.915, 0.975)]
)
def test_published_methods_on_the_world_cup(shared_data, soccer, method, whole, part):
    """Within what is published for methods of this class: 96-98 % in part, 91-93 % as a whole."""
    frames = list(world_cup(shared_data, method))
    found = {name: legacy_metrics(c, r, soccer, SIZE) for name, c, r in frames}
    averages = legacy_averages(found.values())
    assert averages["iou_whole"].mean == pytest.approx(whole, abs=2e-3)
    assert averages["iou_part"].mean == pytest.approx(part, abs=2e-3)
    assert averages["iou_part"].median > averages["iou_part"].mean
    for name, camera, reference in frames[::20]:
        expected = raster_ious(camera, reference)
        assert found[name].iou_whole == pytest.approx(expected[0], abs=5e-3), name
        assert found[name].iou_part == pytest.approx(expected[1], abs=5e-3), name


@pytest.mark.parametrize("tilt", [70.0, 77.0, 80.0])
def test_every_part_of_the_picture_counts_alike(soccer, tilt):
    """The mean over a grid ten times as fine; samples on the borders would pull it by 1 %."""
    reference = replace(MAIN, tilt_rad=math.radians(tilt))
    camera = replace(reference, pan_rad=reference.pan_rad + 0.01, roll_rad=0.01)
    xs, ys = (
        (np.arange(n) + 0.5) * (extent - 1) / n for n, extent in zip((1000, 600), SIZE, strict=True)
    )
    px = np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 2)
    truth, found = (
        cv2.perspectiveTransform(px[None], np.linalg.inv(matrix_of(c)))[0]
        for c in (reference, camera)
    )
    shown = field_rectangle(soccer).holds(truth)
    # Above the horizon the homography gives points behind the camera.
    depth = np.column_stack((px, np.ones(len(px)))) @ np.linalg.inv(matrix_of(reference))[2]
    at_bottom = np.array([480.0, 539.0, 1.0]) @ np.linalg.inv(matrix_of(reference))[2]
    shown &= depth * at_bottom > 0
    expected = np.hypot(*(found - truth)[shown].T).mean()
    measured = legacy_metrics(camera, reference, soccer, SIZE)
    assert measured.projection_m == pytest.approx(expected, rel=4e-3)


def test_every_part_of_the_field_counts_alike(soccer):
    """Seen from far above, where all of the field is in the picture."""
    reference = HomographyCamera(np.array([[8.0, 0.0, 480.0], [0.0, 7.0, 270.0], [0.0, 0.0, 1.0]]))
    camera = HomographyCamera(np.array([[8.4, 0.0, 480.0], [0.0, 7.0, 270.0], [0.0, 0.0, 1.0]]))
    measured = legacy_metrics(camera, reference, soccer, SIZE)
    # The mean of 0.4 |x| over the field's length.
    assert measured.reprojection == pytest.approx(0.4 * LENGTH / 4 / 540, rel=2e-4)
