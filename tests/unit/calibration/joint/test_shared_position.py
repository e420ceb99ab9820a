"""Frames of one camera position share it: told apart from others, known better, predicting more."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.joint.position_clusters import (
    OppositeSideFrames,
    cluster_positions,
    find_opposite_side_frames,
)
from procc_annotator.calibration.joint.shared_position import (
    SharedPositionResult,
    fit_at_known_position,
    fit_shared_position,
)
from procc_annotator.calibration.label_check.candidate_classes import relabelled
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.models import PinholeCamera

SIZE = (960, 540)
TRIPOD, OTHER = (2.0, 71.0, -16.0), (-30.0, 58.0, -9.0)
Frames = dict[str, FrameAnnotation]


def camera(position: tuple[float, float, float], pan: float, focal: float) -> PinholeCamera:
    """Looks at the middle of the field's width, nearly level."""
    away = np.hypot(position[1], 60 * np.tan(np.deg2rad(pan)))
    tilt = np.arctan2(away, -position[2])
    return PinholeCamera(
        np.deg2rad(pan), float(tilt), np.deg2rad(0.2), position, (focal, focal), (479.5, 269.5),
        (0.03 * (focal / 550) ** 2, 0, 0, 0, 0, 0),
    )  # fmt: skip


@pytest.fixture(scope="module")
def cameras() -> dict[str, PinholeCamera]:
    pans = np.linspace(-33, 33, 10)
    focals = 1700 + 500 * np.sin(np.arange(10))
    made = {
        f"t{i}": camera(TRIPOD, p, f) for i, (p, f) in enumerate(zip(pans, focals, strict=True))
    }
    made |= {f"o{i}": camera(OTHER, p, 1500) for i, p in enumerate((-10, 5, 20, 30))}
    return made


@pytest.fixture(scope="module")
def frames(views, cameras) -> Frames:
    rng = np.random.default_rng(4)
    return {name: views.clicks(c, rng) for name, c in cameras.items()}


@pytest.fixture(scope="module")
def alone(frames, field) -> dict[str, FitResult]:
    return {name: fit_camera(a, field, model="R") for name, a in frames.items()}


@pytest.fixture(scope="module")
def shared(frames, alone, field) -> SharedPositionResult:
    return fit_shared_position(frames, alone, field)


def test_positions_are_told_apart_and_found(shared):
    assert [set(t.frames) for t in shared.groups] == [
        {f"t{i}" for i in range(10)}, {f"o{i}" for i in range(4)},
    ]  # fmt: skip
    assert not shared.apart
    for tripod, true in zip(shared.groups, (TRIPOD, OTHER), strict=True):
        off = np.abs(tripod.position_m - true)
        assert (off < 0.5).all()
        assert (off < 3 * tripod.deviations_m).all()


def test_turned_labels_are_no_tripod_of_their_own(frames, alone, field):
    turned = [f"t{i}" for i in range(2, 6)]
    names = {name: field.half_turn.name_of(name) for name in field.index}
    given = frames | {name: relabelled(frames[name], names) for name in turned}
    fits = alone | {name: fit_camera(given[name], field, model="R") for name in turned}
    found = fit_shared_position(given, fits, field)
    assert [len(tripod.frames) for tripod in found.groups] == [6, 4]
    assert set(found.apart) == set(turned)
    assert all("turned" in found.apart[name] for name in turned)


def test_the_scatter_before_is_that_of_the_own_fits(shared, alone):
    tripod = shared.groups[0]
    own = np.array([alone[name].camera.position_world for name in tripod.frames])
    assert tripod.scatter_m == pytest.approx(own.std(axis=0, ddof=1))
    assert (tripod.deviations_m < tripod.scatter_m).all()
    # The own fits say how much they scatter, to a factor.
    assert (tripod.predicted_m > tripod.scatter_m / 4).all()
    assert (tripod.predicted_m < tripod.scatter_m * 4).all()


def test_all_frames_of_a_place_have_exactly_its_position(shared):
    for name, index in shared.group_of.items():
        fit = shared.fits[name]
        assert fit.camera.position_world == tuple(shared.groups[index].position_m)
        assert fit.deviations.position_m == pytest.approx(shared.groups[index].deviations_m)


def test_few_elements_predict_the_others_better(shared, frames, cameras, field, median_error):
    rng = np.random.default_rng(1)
    apart = []
    for name in shared.groups[0].frames:
        annotation = frames[name]
        some = rng.permutation(len(annotation.polylines))[:3]
        few = FrameAnnotation(tuple(annotation.polylines[i] for i in sorted(some)))
        own = fit_camera(few, field, model="R")
        known = fit_at_known_position(few, field, shared.groups[0], size=SIZE)
        errors = [
            100.0 if fit.camera is None else median_error(cameras[name], fit.camera)
            for fit in (own, known)
        ]
        apart.append(errors)
    medians = np.median(np.array(apart), axis=0)
    assert medians[1] < 0.7 * medians[0]
    assert medians[1] < 3


def test_two_elements_are_enough_where_they_say_enough(
    shared, frames, alone, cameras, field, median_error
):
    group = {name: frames[name] for name in shared.groups[0].frames}
    two = ("Middle line", "Circle central")
    whole = frames["t5"]
    group["t5"] = FrameAnnotation(tuple(p for p in whole if p.class_name in two))
    assert len(group["t5"].polylines) == 2
    group["one"] = FrameAnnotation(whole.polylines[:1])
    fits = {name: alone[name] for name in group if name in alone}
    for name in ("t5", "one"):
        fits[name] = fit_camera(group[name], field, model="R")
        assert fits[name].camera is None
    again = fit_shared_position(group, fits, field)
    assert again.gained == ("t5",)
    assert median_error(cameras["t5"], again.fits["t5"].camera) < 5
    assert "even with the position known: 1 element, 2 needed" in again.fits["one"].failure


def test_a_frame_from_elsewhere_keeps_its_own_position(frames, alone, field):
    names = [f"t{i}" for i in range(6)] + ["o1"]
    again = fit_shared_position({n: frames[n] for n in names}, {n: alone[n] for n in names}, field)
    assert set(again.group_of) == set(names) - {"o1"}
    assert "another camera?" in again.apart["o1"]
    assert again.fits["o1"] is alone["o1"]


def test_an_element_with_the_wrong_label_does_not_move_the_position(frames, alone, field):
    names = [f"t{i}" for i in range(10)]
    annotations = {n: frames[n] for n in names}
    swapped = {"Side line top": "Big rect. left main"}
    annotations["t1"] = FrameAnnotation(
        tuple(
            type(p)(swapped[p.class_name], p.points) if p.class_name in swapped else p
            for p in annotations["t1"]
            if p.class_name not in swapped.values()
        )
    )
    fits = {n: alone[n] for n in names} | {"t1": fit_camera(annotations["t1"], field, model="R")}
    again = fit_shared_position(annotations, fits, field)
    assert np.abs(again.groups[0].position_m - TRIPOD).max() < 0.5
    assert again.fits["t1"].left_out == ("Big rect. left main",)


def test_stopping_is_up_to_the_caller(frames, alone, field):
    class Enough(Exception):
        pass

    def stop() -> None:
        raise Enough

    with pytest.raises(Enough):
        fit_shared_position(frames, alone, field, on_step=stop)


def test_no_agreement_is_no_place():
    far = np.array([[0.0, 60, -10], [30, 60, -10], [0, 90, -20], [50, 20, -15]])
    small = np.tile(np.eye(3) * 0.1, (4, 1, 1))
    assert cluster_positions(far, small, 62.0) == ()
    assert cluster_positions(np.empty((0, 3)), np.empty((0, 3, 3)), 62.0) == ()


# Which cameras stand on the other side from the rest, told from their positions.

STAND, HIGH, REVERSE, GOAL = (
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


def test_a_turned_frame_stands_opposite_the_others(field):
    frames = [*around(STAND, 8), *around(HIGH, 5), *(around(STAND, 2, 1) * TURN)]
    found = told(field, frames)
    assert set(found.turned) == {13, 14}
    assert all(count >= 6 for count in found.turned.values())
    assert not found.minority


def test_most_of_a_place_may_be_turned_where_most_of_the_set_is_not(field):
    frames = [*around(STAND, 4), *(around(STAND, 7, 1) * TURN), *around(HIGH, 9)]
    assert set(told(field, frames).turned) == set(range(4, 11))


def test_a_camera_of_its_own_on_the_far_side_is_only_worth_a_look(field):
    found = told(field, [*around(STAND, 20), np.array(REVERSE)])
    assert not found.turned
    assert found.minority == {20}


def test_several_frames_of_a_camera_on_the_far_side_are_a_camera(field):
    found = told(field, [*around(STAND, 40), *around(REVERSE, 3)])
    assert found == OppositeSideFrames()


def test_cameras_behind_both_goals_are_two_cameras(field):
    behind = [*around(GOAL, 6), *(around(GOAL, 3, 1) * TURN)]
    assert not told(field, [*around(STAND, 12), *behind]).turned


def test_the_main_camera_may_stand_behind_an_end(field):
    found = told(field, [*around(GOAL, 9), *(around(GOAL, 2, 1) * TURN)])
    assert set(found.turned) == {9, 10}


def test_nothing_is_told_of_few_or_no_frames(field):
    assert told(field, [*around(STAND, 2), *(around(STAND, 1) * TURN)]) == OppositeSideFrames()
    assert told(field, np.zeros((0, 3))) == OppositeSideFrames()
