"""A camera from one picture: the right one, and never surely a wrong one."""

from dataclasses import replace
from functools import cache

import cv2
import numpy as np
import pytest

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_parameters import vector_from_camera
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.proposal import KnownPosition, Proposal, ProposalState
from procc_annotator.calibration.single_image.propose import better_proposal, propose_camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from tests.drawn_shots import PICTURE_SIZE, Look, Stage, draw, looking_at, stage_of

BROADCAST = Look(noise=3.0, jpeg_quality=70)
MAIN = (2.0, 68.0, -16.0)


@cache
def _stage() -> Stage:
    return stage_of("soccer")


@cache
def _drawn() -> tuple[PinholeCamera, PixelArray]:
    camera = looking_at(MAIN, (-34.0, -4.0, 0.0), 1900.0)
    return camera, draw(_stage(), camera, seed=3)


@cache
def _anywhere() -> Proposal:
    return propose_camera(_drawn()[1], _stage().field)


def _worst_px(
    one: PinholeCamera, other: PinholeCamera, size: tuple[int, int] = PICTURE_SIZE
) -> float:
    """Of what the first shows of the ground, by how much the other one is off at most."""
    x, y = np.meshgrid(np.linspace(-52, 52, 40), np.linspace(-34, 34, 30))
    ground: FloatArray = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    px, ahead = one.project(ground)
    inside = ahead & (px >= 0).all(axis=1) & (px <= np.array(size) - 1).all(axis=1)
    again, _ = other.project(ground)
    return float(np.hypot(*(px - again)[inside].T).max())


def test_finds_the_camera_of_a_drawn_picture():
    camera, _ = _drawn()
    found = _anywhere()
    assert found.state == "sure"
    assert _worst_px(camera, found.fit.camera) < 4
    assert found.coverage > 0.85
    assert found.explained > 0.85
    assert "lie on paint" in found.reason


def test_a_picture_squeezed_into_a_square_is_not_sure():
    """Its paint suits a camera at another height as well."""
    found = propose_camera(
        np.asarray(cv2.resize(_drawn()[1], (540, 540)), np.uint8), _stage().field
    )
    assert found.state == "unsure"
    assert "its pixels may not be square" in found.reason


def test_finds_a_camera_behind_a_goal():
    size, place = (960, 540), (67.98388, 13.30989, -20.18044)
    camera = replace(
        looking_at(place, (0.0, 0.0, 0.0), 956.136, size, kappa=0.0387),
        pan_rad=-1.3019251,
        tilt_rad=1.3248706,
        roll_rad=-0.0302383,
    )
    picture = draw(_stage(), camera, size, seed=25, look=BROADCAST)
    found = propose_camera(picture, _stage().field)
    assert _worst_px(camera, found.fit.camera, size) < 10


def test_the_paint_of_a_net_belongs_to_the_field():
    stage, size = stage_of("volleyball"), (960, 540)
    place = (16.65, 1.4, -4.85)
    camera = looking_at(place, (-0.1, 3.1, 0.0), 2350.0, size)
    picture = draw(stage, camera, size, seed=25, look=BROADCAST)
    known = KnownPosition(np.array(place), np.eye(3) * 0.25)
    found = propose_camera(picture, stage.field, known=[known])
    # A third of the paint in sight is the net's lower band.
    assert found.explained > 0.8
    assert found.state == "sure"


def test_deviations_hold_the_position():
    found = _anywhere()
    off = np.abs(np.array(found.fit.camera.position_world) - MAIN)
    assert (off < 4 * np.array(found.fit.deviations.position_m) + 0.1).all()


def test_the_same_picture_gives_the_same_camera():
    again = propose_camera(_drawn()[1].copy(), _stage().field)
    assert again.fit.camera == _anywhere().fit.camera


def test_a_known_position_is_kept():
    camera, picture = _drawn()
    known = KnownPosition(np.array(MAIN), np.eye(3) * 0.04)
    found = propose_camera(picture, _stage().field, known=[known])
    assert found.state == "sure"
    assert _worst_px(camera, found.fit.camera) < 4
    assert np.abs(np.array(found.fit.camera.position_world) - MAIN).max() < 0.8


WRONG = KnownPosition(np.array([-30.0, 50.0, -8.0]), np.eye(3) * 0.04)


def test_a_wrong_known_position_is_not_sure_and_replaces_nothing():
    only = propose_camera(_drawn()[1], _stage().field, known=[WRONG], elsewhere=False)
    assert only.state != "sure"
    found = propose_camera(_drawn()[1], _stage().field, known=[WRONG])
    assert (found.state, found.fit.camera) == ("sure", _anywhere().fit.camera)


def _seen(
    position: tuple[float, float, float], x: float, share: float, state: ProposalState
) -> Proposal:
    """A camera that looks at (x, 0, 0) and agrees so well with the line pixels."""
    size = (1280, 720)
    focal_px = 1700.0 * np.hypot(*position[1:]) / np.hypot(60, 16)
    camera = looking_at(position, (x, 0, 0), focal_px, size)
    vector = vector_from_camera(camera, ImageFrame(size))
    fit = FitResult("P", size, camera, vector=vector, covariance=np.eye(len(vector)) * 0.09)
    return Proposal(state, "", fit, share, share, 0.3, 0.5, None)


@pytest.mark.parametrize(
    ("at_known", "kept", "state"),
    [
        (_seen((0.3, 60, -16), 20.0, 0.85, "sure"), "at_known", "sure"),
        (_seen((0.3, -60, -16), -20.0, 0.85, "sure"), "at_known", "sure"),  # its other side
        (_seen((0, 64, -17), 20.0, 0.95, "sure"), "free", "sure"),  # contradicted by the picture
        (_seen((0, 60, -16), -20.0, 0.95, "unsure"), "free", "sure"),
        (_seen((0, 60, -16), -20.0, 0.60, "sure"), "free", "sure"),
        (_seen((0, 60, -16), -20.0, 0.86, "sure"), "free", "unsure"),
        (_seen((0, 60, -16), -20.0, 1.00, "sure"), "at_known", "sure"),
    ],
)
def test_a_known_position_is_one_more_hypothesis(at_known, kept, state):
    free = _seen((0, 60, -16), 20.0, 0.88, "sure")
    found = better_proposal(free, at_known, _stage().field)
    assert found.fit is {"free": free, "at_known": at_known}[kept].fit
    assert found.state == state


@pytest.mark.parametrize("sport", ["volleyball", "ice_hockey"])
def test_a_picture_of_another_sport_is_not_sure(sport, sample_data):
    picture = decode_bgra(sample_data / sport / "00001.jpg")
    found = propose_camera(picture, _stage().field)
    assert found.state != "sure"
    assert found.reason.startswith("is this Soccer, and no other sport? ")


def test_more_paint_on_the_right_field_does_not_question_the_sport():
    """Such as the lines of a training pitch across it."""
    picture = _drawn()[1].copy()
    for y in range(330, 700, 60):
        cv2.line(picture, (250, y), (1150, y + 40), (235, 238, 236, 255), 4, cv2.LINE_AA)
    known = KnownPosition(np.array(MAIN), np.eye(3) * 0.04)
    found = propose_camera(picture, _stage().field, known=[known], elsewhere=False)
    assert found.state == "unsure"
    assert found.reason.startswith("there is paint where the field has none")


def test_a_picture_without_paint_has_no_camera():
    picture = np.full((540, 960, 4), (60, 140, 70, 255), dtype=np.uint8)
    found = propose_camera(picture, _stage().field)
    assert found.state == "none"
    assert found.fit.camera is None
    assert found.fit.failure == found.reason
    assert "hardly any paint" in found.reason


def test_can_be_stopped():
    class _StoppedError(Exception):
        pass

    def stop() -> None:
        raise _StoppedError

    with pytest.raises(_StoppedError):
        propose_camera(_drawn()[1], _stage().field, go_on=stop)
