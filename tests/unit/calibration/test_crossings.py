"""Where two clicked lines cross is a place both on the field and in the picture."""

from __future__ import annotations

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.optimization.initialization import nearest_control_point
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations

FRAME = ImageFrame((960, 540))
NEAR_CORNER = ("Side line bottom", "Side line left")


def only(annotation: FrameAnnotation, *names: str) -> FrameAnnotation:
    return FrameAnnotation(tuple(p for p in annotation if p.class_name in names))


def test_the_picture_shows_the_place_where_it_is(views, field) -> None:
    view = views.main(np.random.default_rng(50), noise_px=0.0, k1=0.0)
    place, shown = nearest_control_point(build_observations(view.annotation, field, FRAME))
    expected, seen = view.camera.project(place[None])
    assert seen.all()
    np.testing.assert_allclose(shown + np.array(FRAME.centre_px), expected[0], atol=1e-3)
    # Of several crossings the one nearest to the middle of the picture.
    for pair in (("Big rect. left main", "Big rect. left top"), NEAR_CORNER):
        found = nearest_control_point(
            build_observations(only(view.annotation, *pair), field, FRAME)
        )
        if found is not None:
            assert np.hypot(*shown) <= np.hypot(*found[1]) + 1e-9


def test_lines_are_prolonged(views, field) -> None:
    """A corner outside the picture is as good as one inside."""
    lines = (
        Polyline("Side line top", (Point(0.2, 0.5), Point(0.5, 0.5))),
        Polyline("Side line left", (Point(0.1, 0.6), Point(0.0, 0.8))),
    )
    place, shown = nearest_control_point(build_observations(FrameAnnotation(lines), field, FRAME))
    np.testing.assert_allclose(place, (-52.5, -34.0, 0.0), atol=1e-6)
    np.testing.assert_allclose(shown, ((0.15 - 0.5) * 959, 0.0), atol=1e-6)


def test_some_lines_never_meet(field) -> None:
    up, down = (Point(0.2, 0.2), Point(0.3, 0.9)), (Point(0.8, 0.2), Point(0.7, 0.9))
    level = (Point(0.2, 0.5), Point(0.7, 0.5))
    for names, courses in (
        (("Side line left", "Side line right"), (up, down)),  # parallel on the field
        (("Big rect. left main", "Middle line"), (up, down)),
        (("Small rect. left top", "Big rect. left main"), (up, level)),  # end before they meet
        (("Goal left crossbar", "Side line left"), (up, level)),  # one above the other
        (("Side line top", "Side line left"), (level, (Point(0.2, 0.51), Point(0.7, 0.51)))),
        (("Side line top", "Side line left"), (level, up[:1])),  # one point is no line
        (("Side line top", "Circle central"), (level, up)),
    ):  # fmt: skip
        lines = tuple(Polyline(n, c) for n, c in zip(names, courses, strict=True))
        assert (
            nearest_control_point(build_observations(FrameAnnotation(lines), field, FRAME)) is None
        ), names
