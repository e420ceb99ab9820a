"""Distances to polylines, against brute force."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.metrics.polylines import Polylines


def one_piece(*vertices: tuple[float, float], nan_if_zero_length: bool = False) -> Polylines:
    count = len(vertices)
    ends = np.arange(count) == count - 1
    return Polylines(
        np.array(vertices, dtype=float), np.zeros(count, np.intp), ends, 1, nan_if_zero_length
    )


def distances(polylines: Polylines, *points: tuple[float, float]) -> list[float]:
    px = np.array(points, dtype=float)
    return polylines.segments.distances(px, np.zeros(len(px), np.intp)).tolist()


def test_perpendicular_between_the_ends_and_to_the_end_beyond_them():
    line = one_piece((0, 0), (10, 0))
    assert distances(line, (5, 3), (-3, 4), (13, 4), (10, 2)) == [3, 5, 5, 2]


def test_a_gap_between_pieces_is_not_a_segment():
    polylines = Polylines(
        np.array([[0.0, 0], [10, 0], [30, 0], [40, 0]]),
        np.zeros(4, np.intp),
        np.array([False, True, False, True]),
        1,
    )
    assert distances(polylines, (20, 0)) == [10]
    assert [p.tolist() for p in polylines.pieces_of(0)] == [[[0, 0], [10, 0]], [[30, 0], [40, 0]]]


def test_a_segment_without_length_is_a_point_or_has_no_distance():
    assert distances(one_piece((1, 1), (1, 1)), (4, 5)) == [5]
    assert math.isnan(distances(one_piece((1, 1), (1, 1), nan_if_zero_length=True), (4, 5))[0])


def test_a_piece_of_one_vertex_is_a_point_under_either_rule():
    assert distances(one_piece((1, 1)), (4, 5)) == [5]
    assert distances(one_piece((1, 1), nan_if_zero_length=True), (4, 5)) == [5]


def test_no_points_have_no_distances():
    segments = one_piece((0, 0), (1, 0)).segments
    assert len(segments.distances(np.empty((0, 2)), np.empty(0, np.intp))) == 0
    assert segments.feet(np.empty((0, 2)), np.empty(0, np.intp)).shape == (0, 2)


def brute_force(vertices: list[tuple[float, float]], point: tuple[float, float]) -> float:
    """The definition, segment by segment; vertices are distinct."""
    best = math.dist(vertices[0], point)
    for (ax, ay), (bx, by) in itertools.pairwise(vertices):
        length2 = (bx - ax) ** 2 + (by - ay) ** 2
        k = ((point[0] - ax) * (bx - ax) + (point[1] - ay) * (by - ay)) / length2
        if 0 < k < 1:
            across = (point[0] - ax) * (by - ay) - (point[1] - ay) * (bx - ax)
            best = min(best, abs(across) / math.sqrt(length2))
        else:
            best = min(best, math.dist((ax, ay), point), math.dist((bx, by), point))
    return best


# On a grid, so that no segment is shorter than what float64 can measure.
place = st.tuples(st.integers(-400, 1400), st.integers(-400, 1000)).map(
    lambda p: (p[0] / 4, p[1] / 4)
)
polyline = st.lists(place, min_size=1, max_size=15, unique=True)


@settings(derandomize=True, deadline=None)
@given(st.lists(polyline, min_size=1, max_size=4), st.lists(place, min_size=1, max_size=6))
def test_distances_agree_with_brute_force_and_feet_lie_there(elements, points):
    counts = [len(e) for e in elements]
    owner = np.repeat(np.arange(len(elements)), counts)
    is_end = np.zeros(len(owner), dtype=bool)
    is_end[np.cumsum(counts) - 1] = True
    vertices = np.array([v for e in elements for v in e], dtype=float)
    segments = Polylines(vertices, owner, is_end, len(elements)).segments
    px = np.tile(np.array(points, dtype=float), (len(elements), 1))
    rows = np.repeat(np.arange(len(elements)), len(points))
    found = segments.distances(px, rows)
    expected = [brute_force(e, p) for e in elements for p in points]
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9)
    feet = segments.feet(px, rows)
    np.testing.assert_allclose(np.hypot(*(px - feet).T), expected, rtol=0, atol=1e-9)
    on_curve = [
        brute_force(elements[row], tuple(foot)) for row, foot in zip(rows, feet, strict=True)
    ]
    assert max(on_curve) == pytest.approx(0, abs=1e-9)
