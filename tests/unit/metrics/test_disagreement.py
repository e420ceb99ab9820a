"""The distance on the ground between what a pixel means to two cameras."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import ElementProjections
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.metrics.error_maps import disagreement
from procc_annotator.metrics.ground_plane import field_rectangle

SIZE = (192, 108)
MAIN = PinholeCamera(
    math.radians(-12.0),
    math.radians(76.0),
    0.0,
    (0.0, 58.0, -16.0),
    (230.0, 230.0),
    (95.5, 53.5),
)


def homography_of(camera: PinholeCamera) -> HomographyCamera:
    """The ground of an undistorted pinhole, exactly."""
    rotation, position = camera.rotation_cam_from_world, np.array(camera.position_world)
    (fx, fy), (cx, cy) = camera.focal_px, camera.principal_point_px
    intrinsic = np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])
    ground = np.column_stack((rotation[:, 0], rotation[:, 1], -rotation @ position))
    return HomographyCamera(intrinsic @ ground)


def brute_force(a, b, field, size):
    """Pixel by pixel, one at a time: {(x, y): metres} of those that count."""
    rectangle = field_rectangle(field)
    found = {}
    for y in range(size[1]):
        for x in range(size[0]):
            pixel = np.array([[float(x), float(y)]])
            ground = [ground_from_px(camera, pixel)[0] for camera in (a, b)]
            on_field = [
                rectangle.left <= g[0] <= rectangle.right
                and rectangle.top <= g[1] <= rectangle.bottom
                for g in ground
            ]
            if any(on_field) and not np.isnan(ground).any():
                found[x, y] = math.dist(*ground)
    return found


def test_every_pixel_against_brute_force(soccer):
    size = (64, 36)
    a = replace(MAIN, focal_px=(76.0, 76.0), principal_point_px=(31.5, 17.5))
    b = replace(a, pan_rad=a.pan_rad + 0.01, radial=(0.05, 0.01, 0.0, 0.0, 0.0, 0.0))
    found = disagreement(a, b, soccer, size, step_px=1)
    assert found.xs_px.tolist() == list(range(64))
    assert found.ys_px.tolist() == list(range(36))
    expected = brute_force(a, b, soccer, size)
    assert 0 < len(expected) < 64 * 36
    counted = {(x, y) for y, x in np.argwhere(~np.isnan(found.metres)).tolist()}
    assert counted == set(expected)
    for (x, y), metres in expected.items():
        assert found.metres[y, x] == pytest.approx(metres, abs=1e-9)
    values = np.array(list(expected.values()))
    spread = found.statistics.metres
    assert spread.minimum == pytest.approx(values.min())
    assert spread.median == pytest.approx(np.median(values))
    assert spread.maximum == pytest.approx(values.max())
    for limit in (0.2, 0.5, 1.0):
        assert found.share_within(limit) == pytest.approx((values <= limit).mean())
    assert found.compared_share == pytest.approx(len(values) / (64 * 36))


def test_a_camera_moved_sideways_is_off_by_that_everywhere(soccer):
    """Each pixel's ray is parallel to what it was, so its ground point moves as the camera does."""
    x, y, z = MAIN.position_world
    moved = replace(MAIN, position_world=(x + 0.3, y - 0.4, z))
    found = disagreement(MAIN, moved, soccer, SIZE)
    metres = found.metres[~np.isnan(found.metres)]
    assert len(metres) > 100
    assert metres == pytest.approx(0.5, abs=1e-9)
    assert found.statistics.metres.median == pytest.approx(0.5, abs=1e-9)
    assert found.share_within(0.51) == 1.0
    assert found.share_within(0.49) == 0.0


def test_pixels_are_where_b_shows_what_a_sees(soccer):
    """A principal point that is 3 and 4 px off moves everything by 5 px."""
    cx, cy = MAIN.principal_point_px
    shifted = replace(MAIN, principal_point_px=(cx + 3.0, cy + 4.0))
    found = disagreement(MAIN, shifted, soccer, SIZE)
    pixels = found.pixels[~np.isnan(found.pixels)]
    assert pixels == pytest.approx(5.0, abs=1e-6)
    spread = found.statistics.pixels
    assert (spread.minimum, spread.maximum) == pytest.approx((5.0, 5.0), abs=1e-6)


def test_exchanging_the_cameras_changes_no_metre(soccer):
    other = replace(MAIN, tilt_rad=MAIN.tilt_rad + 0.02, radial=(0.1, 0, 0, 0, 0, 0))
    one, two = disagreement(MAIN, other, soccer, SIZE), disagreement(other, MAIN, soccer, SIZE)
    np.testing.assert_array_equal(one.metres, two.metres)
    np.testing.assert_array_equal(one.ground_a, two.ground_b)
    assert one.statistics.metres == two.statistics.metres


def test_a_homography_of_the_same_camera_agrees(soccer):
    found = disagreement(MAIN, homography_of(MAIN), soccer, SIZE)
    assert found.statistics.metres.maximum == pytest.approx(0.0, abs=1e-6)
    assert found.statistics.pixels.maximum == pytest.approx(0.0, abs=1e-6)
    assert found.share_within(0.5) == 1.0


def test_above_the_horizon_and_off_the_field_is_blank(soccer):
    level = replace(MAIN, tilt_rad=math.radians(88.0))
    found = disagreement(level, level, soccer, SIZE)
    counts = ~np.isnan(found.metres)
    horizon = 53.5 - 230.0 * math.tan(math.radians(2.0))
    assert np.isnan(found.ground_a[found.ys_px < horizon]).all()
    assert not counts[found.ys_px < horizon].any()
    seen = np.isfinite(found.ground_a).all(axis=-1)
    on_field = field_rectangle(soccer).holds(found.ground_a)
    assert (seen & ~on_field).any()
    np.testing.assert_array_equal(counts, on_field)


def test_one_of_the_two_on_the_field_is_enough(soccer):
    x, y, z = MAIN.position_world
    far = replace(MAIN, position_world=(x, y + 30.0, z))
    found = disagreement(MAIN, far, soccer, SIZE)
    rectangle = field_rectangle(soccer)
    either = rectangle.holds(found.ground_a) | rectangle.holds(found.ground_b)
    assert (rectangle.holds(found.ground_a) != rectangle.holds(found.ground_b)).any()
    np.testing.assert_array_equal(~np.isnan(found.metres), either)


@pytest.mark.parametrize("step", [1, 4, 5, 7, 1000])
def test_the_grid_covers_the_whole_picture(soccer, step):
    found = disagreement(MAIN, MAIN, soccer, SIZE, step_px=step)
    for samples, extent in ((found.xs_px, SIZE[0]), (found.ys_px, SIZE[1])):
        assert samples[0] == 0
        assert samples[-1] == extent - 1
        spacing = np.diff(samples)
        assert spacing.max() <= step + 1e-9
        assert np.ptp(spacing) < 1e-9
    assert found.metres.shape == found.pixels.shape == (len(found.ys_px), len(found.xs_px))
    assert found.ground_a.shape == found.ground_b.shape == (*found.metres.shape, 2)


def test_figures_hardly_depend_on_the_step(soccer):
    other = replace(MAIN, pan_rad=MAIN.pan_rad + 0.01)
    fine, coarse = (disagreement(MAIN, other, soccer, SIZE, step_px=s) for s in (1, 6))
    assert coarse.statistics.metres.median == pytest.approx(fine.statistics.metres.median, rel=0.01)
    assert coarse.share_within(0.5) == pytest.approx(fine.share_within(0.5), abs=0.01)
    assert coarse.compared_share == pytest.approx(fine.compared_share, abs=0.01)


def test_a_camera_that_sees_no_field_has_nothing_to_compare(soccer):
    away = replace(MAIN, tilt_rad=math.radians(120.0))
    found = disagreement(MAIN, away, soccer, SIZE)
    assert found.statistics.metres.median is None
    assert found.statistics.pixels.maximum is None
    assert found.share_within(0.5) is None
    assert found.compared_share == 0.0


def test_a_source_without_camera_model_is_refused(soccer):
    with pytest.raises(UsageError, match="shares only projections, there is no ground to compare"):
        disagreement(MAIN, ElementProjections({}), soccer, SIZE)
    with pytest.raises(UsageError, match="at least 1 px"):
        disagreement(MAIN, MAIN, soccer, SIZE, step_px=0)
