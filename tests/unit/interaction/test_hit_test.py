"""What is under the cursor, against a search by plain arithmetic."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px, points_px
from procc_annotator.interaction.gestures import hit_test

SIZE = (640, 360)

coordinates = st.integers(-20, 660)
positions = st.tuples(coordinates, coordinates)
frames = st.lists(st.lists(positions, max_size=5), max_size=4).map(
    lambda polylines: FrameAnnotation(
        tuple(
            Polyline(f"class {i}", tuple(point_from_px(x, y, SIZE) for x, y in points))
            for i, points in enumerate(polylines)
        )
    )
)


def to_segment(at: tuple[float, float], a: list[float], b: list[float]) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    squared = dx * dx + dy * dy
    t = 0.0 if squared == 0 else ((at[0] - a[0]) * dx + (at[1] - a[1]) * dy) / squared
    t = min(1.0, max(0.0, t))
    return math.hypot(at[0] - a[0] - t * dx, at[1] - a[1] - t * dy)


def targets(
    annotation: FrameAnnotation, at: tuple[float, float]
) -> dict[str, dict[tuple[str, int], float]]:
    """Distance to every target, picture px."""
    found: dict[str, dict[tuple[str, int], float]] = {"point": {}, "segment": {}}
    for polyline in annotation:
        points = points_px(polyline, SIZE).tolist()
        for i, point in enumerate(points):
            found["point"][polyline.class_name, i] = math.dist(at, point)
        for i in range(len(points) - 1):
            found["segment"][polyline.class_name, i] = to_segment(at, points[i], points[i + 1])
    return found


@settings(max_examples=150)
@given(frames, positions, st.sampled_from([0.25, 1.0, 8.0]))
def test_the_nearest_point_in_reach_else_the_nearest_segment(annotation, at, scale) -> None:
    hit = hit_test(annotation, SIZE, at, scale)
    found = targets(annotation, at)
    for kind in ("point", "segment"):
        nearest = min(found[kind].values(), default=math.inf) * scale
        if nearest == pytest.approx(10.0, abs=1e-6):
            return  # on the rim of the radius rounding decides
        if nearest < 10.0:
            assert hit.kind == kind
            assert hit.distance_screen == pytest.approx(nearest, abs=1e-6)
            own = found[kind][hit.class_name, hit.index] * scale
            assert own == pytest.approx(nearest, abs=1e-6)
            assert math.dist(hit.foot, at) * scale == pytest.approx(nearest, abs=1e-6)
            return
    assert hit is None


def test_the_selected_class_out_of_reach_does_not_hide_another_in_reach() -> None:
    annotation = FrameAnnotation(
        (
            Polyline("near", (point_from_px(109.9, 100, SIZE),)),
            Polyline("selected", (point_from_px(89.8, 100, SIZE),)),
        )
    )
    hit = hit_test(annotation, SIZE, (100, 100), 1.0, prefer="selected")
    assert hit.class_name == "near"


def test_nothing_lies_between_two_polylines() -> None:
    annotation = FrameAnnotation(
        (
            Polyline("left", (point_from_px(0, 0, SIZE), point_from_px(100, 0, SIZE))),
            Polyline("empty", ()),
            Polyline("right", (point_from_px(300, 0, SIZE), point_from_px(400, 0, SIZE))),
        )
    )
    assert hit_test(annotation, SIZE, (200, 0), 1.0) is None
    hit = hit_test(annotation, SIZE, (350, 3), 1.0)
    assert (hit.class_name, hit.kind, hit.index) == ("right", "segment", 0)


def test_points_that_coincide_can_be_hit() -> None:
    twice = FrameAnnotation((Polyline("spot", (Point(0.5, 0.5), Point(0.5, 0.5))),))
    x, y = points_px(twice.polylines[0], SIZE)[0].tolist()
    hit = hit_test(twice, SIZE, (x + 1, y), 1.0)
    assert hit.kind == "point"


def test_an_empty_frame_has_nothing_to_hit() -> None:
    assert hit_test(FrameAnnotation(), SIZE, (5, 5), 1.0, prefer="Middle line") is None
