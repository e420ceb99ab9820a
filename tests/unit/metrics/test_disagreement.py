"""The distance on the ground between what a pixel means to two cameras."""

import math
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import ElementProjections
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.metrics.error_maps import (
    DISAGREEMENT_LEVELS_M,
    ContourBand,
    bilinear_value,
    contour_lines,
    disagreement,
    filled_contours,
)
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


# Bands and lines of a map: closed, complete, blank where the map is.

X, Y = np.linspace(0.0, 40.0, 81), np.linspace(0.0, 20.0, 41)
GRID_X, GRID_Y = np.meshgrid(X, Y)


def area(points):
    x, y = points[:, 0], points[:, 1]
    return 0.5 * abs(float(x[:-1] @ y[1:] - x[1:] @ y[:-1]))


def area_of(band: ContourBand) -> float:
    return sum(area(p[0]) - sum(area(hole) for hole in p[1:]) for p in band.polygons)


def test_bands_of_a_slope():
    """Values are the x coordinate, so a band is a vertical stripe."""
    bands = filled_contours(GRID_X, X, Y, (0.0, 10.0, 25.0, math.inf))
    assert [(b.low, b.high) for b in bands] == [(0.0, 10.0), (10.0, 25.0), (25.0, math.inf)]
    assert [area_of(b) for b in bands] == pytest.approx([200.0, 300.0, 300.0])
    (polygon,) = bands[1].polygons
    assert polygon[0].min(axis=0).tolist() == [10.0, 0.0]
    assert polygon[0].max(axis=0).tolist() == [25.0, 20.0]


def test_polygons_are_closed_and_rings_have_holes():
    radius = np.hypot(GRID_X - 20.0, GRID_Y - 10.0)
    disc, ring, _ = filled_contours(radius, X, Y, (0.0, 3.0, 8.0, math.inf))
    assert [len(polygon) for polygon in disc.polygons] == [1]
    assert [len(polygon) for polygon in ring.polygons] == [2]
    assert area_of(disc) == pytest.approx(math.pi * 9, rel=0.02)
    assert area_of(ring) == pytest.approx(math.pi * (64 - 9), rel=0.02)
    for band in (disc, ring):
        for polygon in band.polygons:
            for outline in polygon:
                assert outline[0].tolist() == outline[-1].tolist()


def test_two_identical_cameras_fill_the_first_band():
    bands = filled_contours(np.zeros(GRID_X.shape), X, Y, DISAGREEMENT_LEVELS_M)
    assert area_of(bands[0]) == pytest.approx(800.0)
    assert all(not band.polygons for band in bands[1:])


def test_the_bands_together_are_the_map():
    rng = np.random.default_rng(1)
    values = 6.0 * np.abs(np.sin(GRID_X / 5) * np.cos(GRID_Y / 4)) + rng.uniform(0, 0.2, (41, 81))
    bands = filled_contours(values, X, Y, DISAGREEMENT_LEVELS_M)
    assert sum(map(area_of, bands)) == pytest.approx(800.0)
    assert all(band.polygons for band in bands)


def test_blank_stays_blank():
    values = GRID_X.copy()
    values[GRID_Y < 10.0] = np.nan  # as above a horizon
    bands = filled_contours(values, X, Y, (0.0, 20.0, math.inf))
    assert [area_of(b) for b in bands] == pytest.approx([200.0, 200.0])
    assert min(outline[:, 1].min() for b in bands for p in b.polygons for outline in p) >= 10.0
    (line,) = contour_lines(values, X, Y, 20.0)
    assert line[:, 1].min() >= 10.0
    assert line[:, 0] == pytest.approx(20.0)


def test_a_map_that_is_all_blank_has_no_polygon():
    blank = np.full(GRID_X.shape, np.nan)
    assert all(not b.polygons for b in filled_contours(blank, X, Y, DISAGREEMENT_LEVELS_M))
    assert contour_lines(blank, X, Y, 0.5) == ()
    assert contour_lines(np.zeros((1, 81)), X, Y[:1], 0.5) == ()


def test_a_bent_grid_as_of_the_field_map():
    """The same stripes on a sheared and stretched grid whose places are unknown where blank."""
    places_x, places_y = 2.0 * GRID_X + GRID_Y, 3.0 * GRID_Y
    values = GRID_X.copy()
    blank = GRID_Y < 5.0
    values[blank] = np.nan
    places_x[blank] = np.nan
    places_y[blank] = np.inf
    bands = filled_contours(values, places_x, places_y, (0.0, 10.0, math.inf))
    assert [area_of(b) for b in bands] == pytest.approx([10 * 15 * 6.0, 30 * 15 * 6.0])
    (line,) = contour_lines(values, places_x, places_y, 10.0)
    assert line[:, 0] - line[:, 1] / 3 == pytest.approx(20.0)
    assert line[:, 1].min() == pytest.approx(15.0)


def test_a_closed_line_repeats_its_first_point():
    radius = np.hypot(GRID_X - 20.0, GRID_Y - 10.0)
    (line,) = contour_lines(radius, X, Y, 5.0)
    assert line[0].tolist() == line[-1].tolist()
    assert np.hypot(*(line - (20.0, 10.0)).T) == pytest.approx(5.0, abs=0.02)


def test_levels_and_shapes_are_checked():
    with pytest.raises(ValueError, match="ascend"):
        filled_contours(GRID_X, X, Y, (0.0, 1.0, 1.0))
    with pytest.raises(ValueError, match="ascend"):
        filled_contours(GRID_X, X, Y, (0.0,))
    with pytest.raises(ValueError, match="shapes"):
        filled_contours(GRID_X, X[:-1], Y, (0.0, 1.0))


# Values between the samples of a map.

XS, YS = np.array([0.0, 2.0, 4.0]), np.array([-1.0, 0.0])
VALUES = np.array([[0.0, 1.0, np.nan], [4.0, 5.0, 6.0]])


@pytest.mark.parametrize(
    ("x", "y", "expected"),
    [
        (0.0, -1.0, 0.0),
        (2.0, 0.0, 5.0),
        (4.0, 0.0, 6.0),  # its neighbour above has no say
        (1.0, -0.5, 2.5),
        (3.0, 0.0, 5.5),
        (3.0, -0.5, None),
        (4.1, 0.0, None),
        (1.0, -1.1, None),
        (np.nan, 0.0, None),
    ],
)
def test_in_proportion_to_the_distances(x, y, expected):
    assert bilinear_value(VALUES, XS, YS, x, y) == (expected and pytest.approx(expected))
