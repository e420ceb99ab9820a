"""The procc protocol's curves: closed, fine, cleanly cut and clipped."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.geometry import Circle, Line
from procc_annotator.field.model import Field
from procc_annotator.metrics.curve_projection import ElementCurves, project_curves
from procc_annotator.metrics.polylines import Polylines

SIZE = (101, 51)
HD = (960, 540)


def projected(field: Field, camera: object, size: tuple[int, int]) -> Polylines:
    return project_curves(camera, field, ElementCurves.of(field), size).in_sight


def test_the_centre_circle_is_closed(one_line, map_camera):
    found = projected(one_line(Circle((0.0, 0.0, 0.0), 9.0)), map_camera((50.0, 25.0)), SIZE)
    (piece,) = found.pieces_of(0)
    np.testing.assert_allclose(piece[0], piece[-1], atol=1e-12)
    radii = np.hypot(*(piece - (50, 25)).T)
    np.testing.assert_allclose(radii, 9, atol=1e-9)
    between = 9 - np.hypot(*((piece[1:] + piece[:-1]) / 2 - (50, 25)).T)
    assert between.max() <= 0.0025 + 1e-9


def test_a_line_is_clipped_to_the_pixel_centres(one_line, map_camera):
    field = one_line(Line((-500.0, 0.0, 0.0), (500.0, 0.0, 0.0)))
    (piece,) = projected(field, map_camera((50.0, 25.0)), SIZE).pieces_of(0)
    assert piece[0].tolist() == [0, 25]
    assert piece[-1].tolist() == [100, 25]


def test_a_long_chord_over_a_corner_is_found(one_line, map_camera):
    field = one_line(Line((-1000.0, -1010.0, 0.0), (1000.0, 990.0, 0.0)))
    (piece,) = projected(field, map_camera(), SIZE).pieces_of(0)
    np.testing.assert_allclose(piece[[0, -1]], [[10, 0], [61 - 1, 50]], atol=1e-9)


def test_a_circle_leaving_the_picture_is_in_separate_pieces(one_line, map_camera):
    """Radius 30 in a picture 50 px high, centre in its middle: top and bottom are cut off."""
    field = one_line(Circle((0.0, 0.0, 0.0), 30.0))
    found = projected(field, map_camera((50.0, 25.0)), SIZE)
    pieces = found.pieces_of(0)
    ends = sorted(round(float(x), 3) for p in pieces for x in (p[0, 0], p[-1, 0]))
    half_width = math.sqrt(30**2 - 25**2)
    cut = [50 - half_width] * 2 + [50 + half_width] * 2
    # The circle starts at its right end, which is inside: that piece comes in two.
    assert len(pieces) == 3
    assert ends == pytest.approx(sorted([*cut, 80, 80]), abs=5e-3)
    top = found.segments.distances(np.array([[50.0, 0.0]]), np.zeros(1, np.intp))[0]
    assert top == pytest.approx(half_width, abs=3e-3)


def test_an_element_that_only_touches_the_border_from_outside_is_not_there(one_line, map_camera):
    field = one_line(Line((-5.0, -5.0, 0.0), (0.0, 0.0, 0.0)))
    assert not projected(field, map_camera(), SIZE).detected[0]


def test_an_element_behind_the_camera_is_not_there(one_line, map_camera):
    field = one_line(Line((0.0, 0.0, 1.0), (10.0, 10.0, 1.0)))
    assert not projected(field, map_camera((20.0, 20.0)), SIZE).detected[0]


def test_a_line_that_goes_behind_is_cut_at_the_last_visible_point(one_line, map_camera):
    """z rises from -1 to +3 along x = 0..40: the ground is crossed at x = 10."""
    field = one_line(Line((0.0, 0.0, -1.0), (40.0, 0.0, 3.0)))
    (piece,) = projected(field, map_camera((20.0, 20.0)), SIZE).pieces_of(0)
    np.testing.assert_allclose(piece[[0, -1]], [[20, 20], [30, 20]], atol=1e-9)


def level_camera(**changes: object) -> PinholeCamera:
    """At x = 0, y = 0, 2 m above the ground, looking along -y, level."""
    values: dict[str, object] = {
        "pan_rad": 0.0,
        "tilt_rad": math.pi / 2,
        "roll_rad": 0.0,
        "position_world": (0.0, 0.0, -2.0),
        "focal_px": (500.0, 500.0),
        "principal_point_px": (480.0, 270.0),
    }
    return PinholeCamera(**(values | changes))


def test_a_line_passing_below_the_camera_reaches_the_border(one_line):
    """Straight ahead on the ground, from behind the camera to far off: it leaves at the bottom."""
    camera = level_camera()
    field = one_line(Line((0.5, 100.0, 0.0), (0.5, -100.0, 0.0)))
    (piece,) = projected(field, camera, HD).pieces_of(0)
    low = piece[np.argmax(piece[:, 1])]
    far = camera.project(np.array([[0.5, -100.0, 0.0]]))[0][0]
    assert low[1] == pytest.approx(539, abs=1e-6)
    np.testing.assert_allclose(piece[np.argmin(piece[:, 1])], far, atol=1e-6)
    # The image of the line runs straight from the far end to the vanishing direction.
    slope = (far[0] - 480) / (far[1] - 270)
    assert low[0] == pytest.approx(480 + slope * (539 - 270), abs=1e-4)


def test_no_chord_bridges_a_pole_of_the_distortion(one_line):
    """1 / (1 - 4 r^2) jumps from +infinity to -infinity at r = 0.5: nothing joins both sides."""
    camera = level_camera(radial=(0.0, 0.0, 0.0, -4.0, 0.0, 0.0))
    field = one_line(Line((-20.0, -10.0, -2.2), (20.0, -10.0, -2.2)))
    found = projected(field, camera, HD)
    assert found.detected[0]
    for piece in found.pieces_of(0):
        steps = np.hypot(*np.diff(piece, axis=0).T)
        assert steps.max() < 200
    edges = np.array([p[i] for p in found.pieces_of(0) for i in (0, -1)])
    on_border = (
        (edges[:, 0] < 1e-3) | (edges[:, 0] > 959 - 1e-3)
        | (edges[:, 1] < 1e-3) | (edges[:, 1] > 539 - 1e-3)
    )  # fmt: skip
    far_ends = camera.project(np.array([[-20.0, -10.0, -2.2], [20.0, -10.0, -2.2]]))[0]
    at_end = np.array([np.hypot(*(far_ends - e).T).min() < 1e-3 for e in edges])
    assert (on_border | at_end).all()


def test_pixels_that_are_not_finite_count_as_not_seen(one_line):
    class Holed:
        def project(self, points_world: FloatArray) -> tuple[FloatArray, FloatArray]:
            px = points_world[:, :2].copy()
            px[px[:, 0] > 30] = np.nan
            return px, np.ones(len(px), bool)

    field = one_line(Line((10.0, 10.0, 0.0), (90.0, 10.0, 0.0)))
    (piece,) = projected(field, Holed(), SIZE).pieces_of(0)
    np.testing.assert_allclose(piece[[0, -1]], [[10, 10], [30, 10]], atol=1e-9)


def test_a_camera_of_coarse_numbers_still_gives_one_piece(one_line):
    """A plug-in model that computes in single precision is noise, not a jump."""

    class Single:
        def project(self, points_world: FloatArray) -> tuple[FloatArray, FloatArray]:
            px = (points_world[:, :2] * 7.3 + 411.7).astype(np.float32).astype(float)
            return px, np.ones(len(px), bool)

    field = one_line(Line((-100.0, -31.0, 0.0), (200.0, 17.0, 0.0)))
    (piece,) = projected(field, Single(), HD).pieces_of(0)
    assert piece[0, 0] == pytest.approx(0, abs=1e-3)
    assert piece[-1, 0] == pytest.approx(959, abs=1e-3)


cameras = st.builds(
    lambda pan, tilt, roll, x, y, z, f, k1, k2, p1: PinholeCamera(
        pan_rad=math.radians(pan),
        tilt_rad=math.radians(tilt),
        roll_rad=math.radians(roll),
        position_world=(x, y, z),
        focal_px=(f, f * 1.01),
        principal_point_px=(479.5, 269.5),
        radial=(k1, k2, 0.0, 0.0, 0.0, 0.0),
        tangential=(p1, -p1),
        thin_prism=(0.0, 0.0, 0.0, 0.0),
    ),
    st.floats(-60, 60),
    st.floats(55, 88),
    st.floats(-2, 2),
    st.floats(-20, 20),
    st.floats(40, 90),
    st.floats(-30, -1.5),
    st.floats(400, 5000),
    st.floats(-0.5, 0.5),
    st.floats(-0.1, 0.1),
    st.floats(-0.005, 0.005),
)


@settings(derandomize=True, deadline=None, max_examples=30)
@given(cameras)
def test_pieces_stay_in_the_picture_and_follow_the_projection(soccer, camera):
    found = project_curves(camera, soccer, ElementCurves.of(soccer), HD).in_sight
    assert (found.vertices >= 0).all()
    assert (found.vertices <= (959, 539)).all()
    for row in np.flatnonzero(found.detected).tolist():
        dense = _dense(soccer, row)
        px, seen = camera.project(dense)
        inside = seen & (px >= 1).all(axis=1) & (px <= (958, 538)).all(axis=1)
        away = found.segments.distances(px[inside], np.full(inside.sum(), row))
        assert away.max(initial=0) < 0.005


def _dense(field: Field, row: int) -> FloatArray:
    t = np.linspace(0, 1, 997)
    return ElementCurves.of(field).at(np.full(len(t), row), t)


GRAZING = Line((-50.0, 20.0, 0.0), (50.0, 30.0, 0.0))  # leaves a picture 50 px high half way


def test_an_element_in_sight_goes_on_beyond_the_picture(one_line, map_camera):
    found = project_curves(
        map_camera((50.0, 25.0)), one_line(GRAZING), ElementCurves.of(one_line(GRAZING)), SIZE
    )
    np.testing.assert_allclose(found.in_sight.pieces_of(0)[0][[0, -1]], [[0, 45], [50, 50]])
    np.testing.assert_allclose(found.unclipped.pieces_of(0)[0][[0, -1]], [[0, 45], [100, 55]])


def test_an_element_out_of_sight_has_no_course_even_next_to_the_picture(one_line, map_camera):
    field = one_line(Line((-50.0, 25.5, 0.0), (50.0, 25.5, 0.0)))
    found = project_curves(map_camera((50.0, 25.0)), field, ElementCurves.of(field), SIZE)
    assert not found.in_sight.detected[0]
    assert not len(found.unclipped.vertices)


def test_an_element_ends_where_the_camera_has_no_projection(one_line, map_camera):
    """Beyond the picture, too: z rises, and the ground is crossed at x = 60 of the camera's 110."""
    field = one_line(Line((-50.0, 0.0, -11.0), (100.0, 0.0, 4.0)))
    found = project_curves(map_camera((50.0, 25.0)), field, ElementCurves.of(field), SIZE)
    np.testing.assert_allclose(found.unclipped.pieces_of(0)[0][[0, -1]], [[0, 25], [110, 25]])


def test_an_element_goes_on_as_far_as_the_lens_does_not_fold(one_line):
    camera = level_camera(radial=(-0.2, 0.0, 0.0, 0.0, 0.0, 0.0))
    field = one_line(Line((-40.0, -10.0, -2.2), (40.0, -10.0, -2.2)))
    lines = project_curves(camera, field, ElementCurves.of(field), HD).unclipped
    (piece,) = lines.pieces_of(0)
    assert (np.diff(piece[:, 0]) > 0).all()
    # The radius of the fold, sqrt(5 / 3), appears at two thirds of itself.
    ends = 480 + 500 * math.sqrt(5 / 3) * 2 / 3 * np.array((-1, 1))
    np.testing.assert_allclose(piece[[0, -1], 0], ends, atol=0.3)


def test_nothing_behind_the_camera_comes_back_over_the_picture(one_line):
    """A line on the ground from far ahead to behind: below the picture it goes down for ever."""
    field = one_line(Line((0.5, 100.0, 0.0), (0.5, -100.0, 0.0)))
    lines = project_curves(level_camera(), field, ElementCurves.of(field), HD).unclipped
    assert lines.vertices[:, 1].max() > 1e5
    assert (lines.vertices[:, 1] > 270).all()


@settings(derandomize=True, deadline=None, max_examples=40)
@given(cameras)
def test_distances_are_those_to_the_projection_in_the_picture_and_beyond(soccer, camera):
    """Against brute force: no sample of an element in sight is nearer than what is measured."""
    lines = project_curves(camera, soccer, ElementCurves.of(soccer), HD).unclipped
    grid = np.stack(np.meshgrid(np.linspace(0, 959, 5), np.linspace(0, 539, 4)), -1).reshape(-1, 2)
    for row in np.flatnonzero(lines.detected).tolist():
        px, seen = camera.project(_dense(soccer, row))
        brute = np.hypot(*(grid[:, None] - px[seen]).transpose(2, 0, 1)).min(axis=1)
        found = lines.segments.distances(grid, np.full(len(grid), row))
        assert (found < brute + np.maximum(0.01, 1e-3 * brute)).all()
