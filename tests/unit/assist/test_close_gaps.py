"""Ends that fall a little short reach the corner, the picture's edge, the circle's beginning."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px, points_px
from procc_annotator.assist.regularise import close_gaps
from procc_annotator.field.load import load_field

FIELD = load_field()
SIZE = (1280, 720)
MAIN, TOP = "Big rect. left main", "Big rect. left top"


def line(name: str, *points: tuple[float, float]) -> Polyline:
    return Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in points))


def closed(polyline: Polyline, *others: Polyline) -> np.ndarray:
    annotation = FrameAnnotation((polyline, *others))
    return points_px(close_gaps(polyline, annotation, FIELD, SIZE), SIZE)


def test_an_end_reaches_the_corner_with_the_line_it_meets() -> None:
    found = closed(line(TOP, (300, 200), (590, 200)), line(MAIN, (600, 212), (600, 500)))
    assert found == pytest.approx(np.array([[300, 200], [600, 200]]), abs=1e-6)


def test_an_end_that_went_too_far_comes_back() -> None:
    found = closed(line(TOP, (300, 200), (612, 200)), line(MAIN, (600, 190), (600, 500)))
    assert found[-1] == pytest.approx([600, 200], abs=1e-6)


def test_lines_that_do_not_meet_on_the_field_leave_each_other_alone() -> None:
    polyline = line(TOP, (300, 200), (590, 200))
    other = line("Side line top", (600, 190), (600, 500))
    assert closed(polyline, other) == pytest.approx(points_px(polyline, SIZE))


def test_an_end_near_the_edge_reaches_it_along_its_line() -> None:
    found = closed(line("Side line top", (10, 100), (640, 90), (1270, 80)))
    assert found[0] == pytest.approx([0, 100 + 10 * 10 / 630], abs=1e-6)
    assert found[1] == pytest.approx([640, 90])
    assert found[-1] == pytest.approx([1279, 80 - 9 * 10 / 630], abs=1e-6)


def test_what_is_far_stays() -> None:
    polyline = line("Side line top", (60, 100), (1200, 80))
    assert closed(polyline) == pytest.approx(points_px(polyline, SIZE))


def test_a_circle_closes_with_its_first_point() -> None:
    angles = np.linspace(0, 2 * np.pi - 0.1, 9)
    points = [(640 + 200 * np.cos(a), 360 + 80 * np.sin(a)) for a in angles]
    polyline = line("Circle central", *points)
    found = close_gaps(polyline, FrameAnnotation((polyline,)), FIELD, SIZE)
    assert found.points == (*polyline.points, polyline.points[0])
    half = line("Circle central", *points[:5])
    assert close_gaps(half, FrameAnnotation((half,)), FIELD, SIZE) == half


def test_other_elements_and_single_points_come_back_as_they_are() -> None:
    for polyline in (line("Line unknown", (2, 2), (9, 9)), line(TOP, (5, 5))):
        assert close_gaps(polyline, FrameAnnotation((polyline,)), FIELD, SIZE) == polyline
