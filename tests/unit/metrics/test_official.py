"""The official evaluation's visible polylines, quirk by quirk."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.metrics.official import visible_polylines
from procc_annotator.metrics.polylines import Polylines

SIZE = (100, 50)


def walk(*samples: tuple[float, float] | None) -> Polylines:
    """One element; None is a sample behind the camera."""
    valid = np.array([s is not None for s in samples])
    px = np.array([s or (1e9, 1e9) for s in samples], dtype=float)
    return visible_polylines(px, valid, np.zeros(len(px), np.intp), SIZE, element_count=1)


def distance(polylines: Polylines, x: float, y: float) -> float:
    return float(polylines.segments.distances(np.array([[x, y]]), np.zeros(1, np.intp))[0])


def test_an_element_inside_keeps_its_samples():
    assert walk((1, 2), (3, 4), (9, 9)).vertices.tolist() == [[1, 2], [3, 4], [9, 9]]


def test_inside_excludes_the_far_edge_but_includes_beyond_the_last_pixel_centre():
    assert walk((99.5, 49.5)).vertices.tolist() == [[99.5, 49.5]]
    assert len(walk((100, 10)).vertices) == 0
    assert len(walk((10, 50)).vertices) == 0
    assert walk((0, 0)).vertices.tolist() == [[0, 0]]


def test_entering_and_leaving_add_border_points_at_pixel_centres():
    found = walk((-10, 20), (10, 20), (90, 20), (110, 20)).vertices
    assert found.tolist() == [[0, 20], [10, 20], [90, 20], [99, 20]]


def test_the_border_point_lies_on_the_infinite_line_not_on_the_segment():
    """From the left to near the right edge: the nearest crossing lies ahead, on the right."""
    assert walk((-10, 20), (95, 20)).vertices.tolist() == [[99, 20], [95, 20]]


def test_the_border_coordinate_is_exact_for_a_slanted_line():
    border = walk((-0.1, 10.3), (1.7, 12.9)).vertices[0]
    assert border[0] == 0
    assert border[1] == pytest.approx(10.3 + 0.1 * 2.6 / 1.8)


def test_leaving_takes_the_crossing_nearest_to_the_outside_sample():
    """Through a corner region the line meets y = 0 first and x = 99 outside the picture."""
    assert walk((80, 10), (100, -10)).vertices.tolist() == [[80, 10], [90, 0]]


def test_between_the_last_pixel_centre_and_the_edge_the_line_is_cut_at_the_pixel_centre():
    assert walk((99.5, 20), (99.5, 80)).vertices.tolist() == [[99.5, 20], [99.5, 49]]
    assert walk((50, 49.5), (-20, 49.5)).vertices.tolist() == [[50, 49.5], [0, 49.5]]


def test_no_border_point_where_the_line_misses_the_pixel_centres():
    """A cut corner between the last pixel centres and the edge meets no side inside."""
    assert walk((99.75, 49.5), (100.25, 49.0)).vertices[1:].tolist() == []


def test_a_line_along_a_side_meets_only_the_other_sides():
    assert walk((50, 0), (-20, 0)).vertices.tolist() == [[50, 0], [0, 0]]


def test_samples_behind_the_camera_are_as_if_absent():
    assert walk(None, (10, 10), None, (20, 10)).vertices.tolist() == [[10, 10], [20, 10]]
    assert walk(None, (10, 10)).vertices.tolist() == [[10, 10]]


def test_the_last_sample_in_front_stays_the_previous_one_across_hidden_samples():
    assert walk((-10, 20), None, (10, 20)).vertices.tolist() == [[0, 20], [10, 20]]


def test_outside_then_behind_then_inside_has_no_border_point_without_a_previous_sample():
    assert walk(None, (10, 20), (20, 20)).vertices.tolist() == [[10, 20], [20, 20]]


def test_a_return_to_the_picture_is_bridged_by_a_straight_segment():
    polyline = walk((10, 40), (10, 60), (50, 60), (50, 40))
    assert polyline.vertices.tolist() == [[10, 40], [10, 49], [50, 49], [50, 40]]
    assert len(polyline.pieces_of(0)) == 1
    assert distance(polyline, 30, 45) == pytest.approx(4)


def test_a_list_of_one_point_is_detected_and_measured_to_that_point():
    polyline = walk(None, (10, 10), None)
    assert polyline.detected.tolist() == [True]
    assert distance(polyline, 13, 14) == 5


def test_an_element_outside_is_not_detected():
    polyline = walk((-10, -10), (-10, 60), (200, 60))
    assert polyline.detected.tolist() == [False]
    assert polyline.pieces_of(0) == ()


def test_a_chord_through_the_picture_between_outside_samples_is_not_seen():
    assert not walk((-10, 25), (110, 25)).detected[0]


def test_a_segment_without_length_makes_the_distance_nan():
    polyline = walk((10, 10), (10, 10), (30, 10))
    assert np.isnan(distance(polyline, 20, 10))


def test_a_sample_at_infinity_is_outside_and_gives_no_border_point():
    assert walk((10, 10), (np.inf, np.inf), (20, 10)).vertices.tolist() == [[10, 10], [20, 10]]


@pytest.mark.parametrize("far", [(np.inf, 10), (30, -np.inf)])
def test_a_sample_at_infinity_in_one_direction_gives_no_border_point(far):
    assert walk((20, 20), far).vertices.tolist() == [[20, 20]]
    assert walk(far, (20, 20)).vertices.tolist() == [[20, 20]]


def test_the_border_point_is_exact_however_far_off_the_other_sample_is():
    found = walk((20.1, 20.2), (1e13, 3e12)).vertices[1]
    assert found == pytest.approx([99, 20.2 + 78.9 * 0.3], abs=1e-9)


def test_elements_do_not_touch_each_other():
    px = np.array([[10.0, 10], [20, 10], [-5, 30], [5, 30], [50, 5], [50, -5]])
    element = np.array([0, 0, 1, 1, 3, 3])
    found = visible_polylines(px, np.ones(6, bool), element, SIZE, element_count=4)
    assert found.detected.tolist() == [True, True, False, True]
    assert found.pieces_of(0)[0].tolist() == [[10, 10], [20, 10]]
    assert found.pieces_of(1)[0].tolist() == [[0, 30], [5, 30]]
    assert found.pieces_of(2) == ()
    assert found.pieces_of(3)[0].tolist() == [[50, 5], [50, 0]]


def walked_one_by_one(samples: list[tuple[float, float] | None]) -> list[tuple[float, float]]:
    """The devkit's rules as a plain loop."""
    width, height = SIZE

    def inside(p: tuple[float, float]) -> bool:
        return 0 <= p[0] < width and 0 <= p[1] < height

    def border(a: tuple[float, float], b: tuple[float, float]) -> list[tuple[float, float]]:
        dx, dy = b[0] - a[0], b[1] - a[1]
        met = []
        if dx:
            met += [(x, b[1] + (x - b[0]) * (dy / dx)) for x in (0.0, width - 1.0)]
        if dy:
            met += [(b[0] + (y - b[1]) * (dx / dy), y) for y in (0.0, height - 1.0)]
        met = [p for p in met if inside(p)]
        return [min(met, key=lambda p: (p[0] - b[0]) ** 2 + (p[1] - b[1]) ** 2)] if met else []

    found: list[tuple[float, float]] = []
    previous = None
    in_image = False
    for sample in samples:
        if sample is None:
            continue
        if inside(sample):
            if not in_image and previous is not None:
                found += border(previous, sample)
            found.append(sample)
            in_image = True
        elif in_image and previous is not None:
            found += border(previous, sample)
            in_image = False
        previous = sample
    return found


coordinate = st.floats(-150, 250, width=32).map(float)
sample = st.one_of(st.none(), st.tuples(coordinate, coordinate))


@settings(derandomize=True, deadline=None)
@given(st.lists(st.lists(sample, min_size=1, max_size=12), min_size=1, max_size=4))
def test_all_elements_at_once_agree_with_the_plain_walk(elements):
    flat = [s for samples in elements for s in samples]
    px = np.array([s or (0.0, 0.0) for s in flat], dtype=float)
    valid = np.array([s is not None for s in flat])
    owner = np.repeat(np.arange(len(elements)), [len(s) for s in elements])
    found = visible_polylines(px, valid, owner, SIZE, element_count=len(elements))
    for row, samples in enumerate(elements):
        expected = walked_one_by_one(samples)
        pieces = found.pieces_of(row)
        assert len(pieces) == (1 if expected else 0)
        if expected:
            np.testing.assert_allclose(pieces[0], expected, rtol=0, atol=1e-9)
