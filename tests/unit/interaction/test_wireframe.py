"""What of a camera's wireframe is under the cursor."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.interaction.camera_view import segments_in_sight, wireframe_of

SIZE = (1280, 720)
FIELD = load_field()
CAMERA = PinholeCamera(
    0.1, 1.3, 0.01, (2.0, 60.0, -16.0), (1500.0, 1500.0), (639.5, 359.5), (0.05, 0, 0, 0, 0, 0)
)


def at(world: tuple[float, float, float]) -> tuple[float, float]:
    x, y = CAMERA.project(np.array([world]))[0][0].tolist()
    return x, y


def test_a_corner_goes_before_the_lines_through_it() -> None:
    frame = wireframe_of(CAMERA, FIELD, SIZE)
    x, y = at((0.0, -34.0, 0.0))
    found = frame.at((x + 5.0, y + 1.0), 10.0)
    assert found.along is None
    assert found.px == pytest.approx((x, y))


def test_between_corners_it_is_the_nearest_place_of_the_nearest_line() -> None:
    frame = wireframe_of(CAMERA, FIELD, SIZE)
    world = (0.0, -20.0, 0.0)
    x, y = at(world)
    found = frame.at((x + 3.0, y), 10.0)
    assert found.name == "Middle line"
    assert abs(found.along[1]) == pytest.approx(1.0)
    px = CAMERA.project(np.array([found.world]))[0][0]
    assert found.px == pytest.approx(tuple(px))
    assert np.hypot(*(px - (x + 3.0, y))) <= 3.0
    assert found.world[0] == pytest.approx(0.0, abs=1e-9)


def test_beyond_reach_and_out_of_the_picture_there_is_nothing() -> None:
    frame = wireframe_of(CAMERA, FIELD, SIZE)
    x, y = at((0.0, -20.0, 0.0))
    assert frame.at((x + 30.0, y), 5.0) is None
    away = replace(CAMERA, pan_rad=CAMERA.pan_rad + np.pi)
    assert wireframe_of(away, FIELD, SIZE).at((600.0, 300.0), 1e4) is None
    assert segments_in_sight(away, FIELD, SIZE).shape == (0, 4)


def test_segments_follow_the_lines_in_the_picture() -> None:
    segments = segments_in_sight(CAMERA, FIELD, SIZE)
    frame = wireframe_of(CAMERA, FIELD, SIZE)
    middles = (segments[:, :2] + segments[:, 2:]) / 2
    inside = ((middles > 0) & (middles < np.array(SIZE) - 1)).all(axis=1)
    for place in middles[inside].tolist():
        assert frame.at((place[0], place[1]), 1.5) is not None
