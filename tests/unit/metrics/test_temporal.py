"""Steadiness over shots whose jitter, jumps and offset are known."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from procc_annotator.camera.matrices import calibration_matrix, pinhole_from_homography, translation
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.metrics.temporal.discontinuities import (
    Discontinuities,
    Jump,
    find_discontinuities,
    frame_offset,
    shift_range,
)
from procc_annotator.metrics.temporal.jitter import (
    ShotJitter,
    consecutive_neighbours,
    field_ground_points,
    pose_jitter,
    projection_jitter,
    shot_poses,
    shot_rms,
)
from tests.drawn_shots import Aim, course

SIZE = (960, 540)
FIELD = load_field("soccer")
STAND = (2.0, 70.0, -16.0)
NONE_OFF = np.zeros(400, dtype=bool)


@cache
def steady_shot(frames: int = 400) -> tuple[PinholeCamera, ...]:
    aims = (Aim(-35, -5, 1100.0), Aim(0, 0, 1000.0), Aim(36, -8, 1200.0))
    return course(STAND, aims, frames, SIZE)


def shaken(pan_rad: float, *, seed: int = 1) -> list[PinholeCamera]:
    """The shot, each frame panned off by itself."""
    off = np.random.default_rng(seed).normal(0, pan_rad, 400)
    return [replace(c, pan_rad=c.pan_rad + o) for c, o in zip(steady_shot(), off, strict=True)]


def measured(cameras: list, numbers: range | None = None) -> tuple[ShotJitter, Discontinuities]:
    order, points = numbers or range(len(cameras)), field_ground_points(FIELD)
    found = projection_jitter(cameras, order, points, SIZE)
    return found, find_discontinuities(cameras, order, points, SIZE, found)


def test_a_camera_that_turns_smoothly_hardly_trembles():
    steady, broken = measured(list(steady_shot()))
    assert (shot_rms(steady.px) or 1) < 0.02
    assert not broken.jumps
    assert not broken.outages


@pytest.mark.parametrize("pan_px", [0.5, 2.0])
def test_jitter_is_what_each_frame_was_shaken_by(pan_px):
    focal = np.mean([c.focal_px[0] for c in steady_shot()])
    cameras = shaken(pan_px / focal)
    steady, broken = measured(cameras)
    # A degree of pan moves what is below the axis by less than focal length times the angle.
    low = np.mean([np.sin(c.tilt_rad) for c in cameras])
    assert shot_rms(steady.px) == pytest.approx(pan_px * low, rel=0.1)
    jitter = pose_jitter(shot_poses(cameras, SIZE), range(400), broken.unsteady)
    assert jitter.pan_deg == pytest.approx(np.degrees(pan_px / focal), rel=0.1)
    assert jitter.tilt_deg == pytest.approx(0, abs=1e-3)
    assert jitter.position_m == pytest.approx(0, abs=1e-6)
    assert not broken.jumps


def test_metres_are_those_that_a_turn_takes_on_the_ground():
    """Shaken about the vertical, what a pixel means turns about the camera's foot."""
    cameras = shaken(1e-3)
    steady, _ = measured(cameras)
    points = field_ground_points(FIELD)
    expected = []
    for camera in cameras[::20]:
        px, valid = camera.project(points)
        seen = points[valid & ((px >= 0) & (px <= np.array(SIZE) - 1)).all(axis=1)]
        expected.append(np.mean(((seen[:, :2] - STAND[:2]) ** 2).sum(axis=1)))
    assert shot_rms(steady.ground_m) == pytest.approx(1e-3 * np.sqrt(np.mean(expected)), rel=0.1)


def test_a_leap_there_and_back_and_one_that_stays():
    cameras = list(steady_shot())
    for at in (100, 200, 201, 202, 203):
        cameras[at] = replace(cameras[at], pan_rad=cameras[at].pan_rad + 0.03)
    for at in range(300, 400):
        cameras[at] = replace(cameras[at], tilt_rad=cameras[at].tilt_rad + 0.02)
    steady, broken = measured(cameras)
    assert [(j.frame, j.back_after) for j in broken.jumps] == [(100, 1), (200, 4), (300, None)]
    assert broken.jumps[0].size_px == pytest.approx(broken.jumps[1].size_px, rel=0.05)
    assert broken.jumps[2].size_px == pytest.approx(0.02 * 1150, rel=0.15)
    assert (shot_rms(steady.px, broken.unsteady) or 1) < 0.02


def test_a_leap_among_trembling_is_told_from_it():
    cameras = shaken(1e-3)
    cameras[50] = replace(cameras[50], pan_rad=cameras[50].pan_rad + 0.05)
    _, broken = measured(cameras)
    assert [(j.frame, j.back_after) for j in broken.jumps] == [(50, 1)]


def test_outages_and_the_time_to_come_back():
    cameras: list[PinholeCamera | None] = list(steady_shot())
    cameras[10:14] = [None] * 4
    cameras[395:] = [None] * 5
    # After the first outage the camera is off for a frame.
    off = cameras[16]
    cameras[16] = replace(off, pan_rad=off.pan_rad + 0.05)
    steady, broken = measured(cameras)
    assert [(o.frame, o.length) for o in broken.outages] == [(10, 4), (395, 5)]
    assert broken.outages[1].back_after is None
    assert broken.jumps == (Jump(16, broken.jumps[0].size_px, 1),)
    assert np.isnan(steady.px[9:15]).all()


def test_only_frames_that_follow_each_other_count():
    assert consecutive_neighbours([1, 2, 3, 5, 6, 7]).tolist() == [
        False,
        True,
        False,
        False,
        True,
        False,
    ]
    assert consecutive_neighbours([0, 25, 50]).tolist() == [False, True, False]
    assert consecutive_neighbours([4, 5]).tolist() == [False, False]
    cameras = list(steady_shot(40))
    steady = projection_jitter(
        cameras, [*range(20), *range(100, 120)], field_ground_points(FIELD), SIZE
    )
    assert np.flatnonzero(np.isnan(steady.px)).tolist() == [0, 19, 20, 39]


def test_a_homography_implies_where_its_camera_stands():
    for camera in steady_shot()[::40]:
        turned = np.column_stack((camera.rotation_cam_from_world, translation(camera)))
        matrix = calibration_matrix(camera) @ turned[:, [0, 1, 3]]
        found = pinhole_from_homography(HomographyCamera(matrix), SIZE)
        assert found.position_world == pytest.approx(camera.position_world, abs=1e-6)
        assert found.focal_px[0] == pytest.approx(camera.focal_px[0])
        assert found.pan_rad == pytest.approx(camera.pan_rad)
    poses = shot_poses([HomographyCamera(matrix), None], SIZE)
    assert poses.implied
    assert poses.position_world[0] == pytest.approx(STAND)
    assert np.isnan(poses.position_world[1]).all()


def test_the_shift_that_fits_best_is_found_with_its_margin():
    random = np.random.default_rng(2)
    costs = np.abs(shift_range() - 1) * 2.0 + random.uniform(1, 2, (40, 1)) * np.ones(11)
    costs += random.normal(0, 0.2, costs.shape)
    found = frame_offset(costs)
    assert (found.shift, found.frames) == (1, 40)
    assert found.is_sure
    assert found.in_words == "cameras are 1 frame late"
    assert found.margin_px == pytest.approx(2, abs=0.2)


def test_a_camera_that_rests_has_no_offset_that_could_be_told():
    costs = np.ones((40, 11)) + np.random.default_rng(2).normal(0, 0.01, (40, 11))
    found = frame_offset(costs)
    assert not found.is_sure
    assert found.in_words == "not determined"


def test_a_short_shot_is_tried_at_few_shifts():
    costs = np.abs(shift_range() + 1) * np.ones((8, 1))
    for row in range(8):
        costs[row, np.abs(shift_range()) > min(row, 7 - row)] = np.nan
    found = frame_offset(costs)
    assert found.shift == -1
    assert len(found.costs_px) == 5
    assert frame_offset(costs[:2]) is None
