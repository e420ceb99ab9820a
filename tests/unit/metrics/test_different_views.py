"""The views that differ most, by where cameras look and how far they zoom."""

from __future__ import annotations

import math

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.metrics.sets import most_distinct_views


def camera(pan_degrees: float, focal_px: float = 1000.0) -> PinholeCamera:
    centre = (639.5, 359.5)
    pan = math.radians(pan_degrees)
    return PinholeCamera(pan, 1.3, 0.0, (0.0, 60.0, -15.0), (focal_px, focal_px), centre)


def chosen(cameras: list[PinholeCamera], count: int) -> list[int]:
    return most_distinct_views(cameras, [1280] * len(cameras), count)


def test_the_usual_view_comes_first_then_the_ends_of_a_pan() -> None:
    cameras = [camera(pan) for pan in (-30, -20, -10, 0, 10, 20, 31)]
    assert chosen(cameras, 3) == [3, 6, 0]


def test_a_zoom_is_another_view() -> None:
    cameras = [camera(0), camera(1), camera(2), camera(1, focal_px=3000), camera(3)]
    assert set(chosen(cameras, 2)) == {2, 3} or set(chosen(cameras, 2)) == {1, 3}


def test_a_pan_past_half_a_turn_is_no_jump() -> None:
    cameras = [camera(pan) for pan in (170, 175, 179, -179, -175, -140)]
    assert chosen(cameras, 2) == [2, 5]


def test_no_more_than_there_are_each_once() -> None:
    assert chosen([], 3) == []
    assert sorted(chosen([camera(0), camera(0), camera(5)], 9)) == [0, 1, 2]
