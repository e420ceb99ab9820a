"""Which cameras stand on the other side from the rest, told from their positions."""

from __future__ import annotations

import numpy as np

from procc_annotator.calibration.joint.position_clusters import (
    OppositeSideFrames,
    find_opposite_side_frames,
)
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior

TRIPOD, HIGH, REVERSE, GOAL = (
    (1.0, 70.0, -16.0),
    (0.0, 90.0, -22.0),
    (4.0, -60.0, -5.0),
    (66, 0, -8),
)
TURN = np.array([-1.0, -1.0, 1.0])


def told(field, positions, sd=(0.5, 1.5, 0.3)) -> OppositeSideFrames:
    covariances = np.tile(np.diag(np.square(sd)), (len(positions), 1, 1))
    return find_opposite_side_frames(
        np.array(positions), covariances, camera_placement_prior(field)
    )


def around(position, count: int, seed: int = 0) -> list[np.ndarray]:
    return list(position + np.random.default_rng(seed).normal(0, (0.5, 1.5, 0.3), (count, 3)))


def test_a_turned_frame_stands_opposite_the_others(field) -> None:
    frames = [*around(TRIPOD, 8), *around(HIGH, 5), *(around(TRIPOD, 2, 1) * TURN)]
    found = told(field, frames)
    assert set(found.turned) == {13, 14}
    assert all(count >= 6 for count in found.turned.values())
    assert not found.minority


def test_most_of_a_place_may_be_turned_where_most_of_the_set_is_not(field) -> None:
    frames = [*around(TRIPOD, 4), *(around(TRIPOD, 7, 1) * TURN), *around(HIGH, 9)]
    assert set(told(field, frames).turned) == set(range(4, 11))


def test_a_camera_of_its_own_on_the_far_side_is_only_worth_a_look(field) -> None:
    found = told(field, [*around(TRIPOD, 20), np.array(REVERSE)])
    assert not found.turned
    assert found.minority == {20}


def test_several_frames_of_a_camera_on_the_far_side_are_a_camera(field) -> None:
    found = told(field, [*around(TRIPOD, 40), *around(REVERSE, 3)])
    assert found == OppositeSideFrames()


def test_cameras_behind_both_goals_are_two_cameras(field) -> None:
    behind = [*around(GOAL, 6), *(around(GOAL, 3, 1) * TURN)]
    assert not told(field, [*around(TRIPOD, 12), *behind]).turned


def test_the_main_camera_may_stand_behind_an_end(field) -> None:
    found = told(field, [*around(GOAL, 9), *(around(GOAL, 2, 1) * TURN)])
    assert set(found.turned) == {9, 10}


def test_nothing_is_told_of_few_or_no_frames(field) -> None:
    assert told(field, [*around(TRIPOD, 2), *(around(TRIPOD, 1) * TURN)]) == OppositeSideFrames()
    assert told(field, np.zeros((0, 3))) == OppositeSideFrames()
