"""Drawn shots are what their cameras say: paint lies under the projected field."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from procc_annotator.field.sampling import sample_evenly
from tests import drawn_shots
from tests.drawn_shots import Look, Stage, draw, random_camera, soccer_shot, stage_of

SIZE = (640, 360)
NOBODY = Look(people=False, noise=0.0)


def _lighter_by(stage: Stage, picture: np.ndarray, camera: object) -> float:
    """How much lighter the ground is under lines on it than 8 px beside them, median."""
    on_ground = tuple(e for e in stage.field.elements if e.on_ground and e.line_width > 0)
    points = sample_evenly(replace(stage.field, elements=on_ground), 0.5).points_world
    px, seen = camera.project(points)
    seen &= ((px > 12) & (px < np.array(SIZE) - 13)).all(axis=1)
    grey = cv2.cvtColor(picture, cv2.COLOR_BGRA2GRAY).astype(float)
    x, y = np.round(px[seen]).astype(int).T
    around = [grey[y + dy, x + dx] for dx, dy in ((8, 0), (-8, 0), (0, 8), (0, -8))]
    return float(np.median(grey[y, x] - np.median(around, axis=0)))


@pytest.mark.parametrize("name", ["soccer", "tennis"])
def test_paint_lies_under_the_true_projection(name):
    stage, rng = stage_of(name), np.random.default_rng(1)
    for seed in (1, 2, 3):
        camera = random_camera(stage.field, rng, SIZE)
        picture = draw(stage, camera, SIZE, seed=seed, look=NOBODY)
        assert _lighter_by(stage, picture, camera) > 20


def test_a_frame_is_the_same_each_time_and_blur_keeps_its_place():
    shot = soccer_shot(60, size=SIZE, look=NOBODY)
    blurred = replace(shot, look=replace(NOBODY, shutter=0.5))
    assert np.array_equal(shot.frame(4), shot.frame(4))
    assert _lighter_by(shot.stage, blurred.frame(9), shot.cameras[9]) > 10


def test_a_cut_begins_another_shot():
    shot = drawn_shots.cut_shot(10, size=SIZE)
    assert shot.shots == ((0, 4), (5, 9))
    assert shot.cameras[4].pan_rad < 0 < shot.cameras[5].pan_rad
