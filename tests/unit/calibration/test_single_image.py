"""A camera from one picture: the right one, and never surely a wrong one."""

from dataclasses import replace
from functools import cache

import cv2
import numpy as np
import pytest

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.line_alignment.refinement import LineAlignment
from procc_annotator.calibration.optimization.camera_parameters import vector_from_camera
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image import candidates
from procc_annotator.calibration.single_image.candidates import (
    BestCandidate,
    RefinedCandidate,
    better_candidate,
)
from procc_annotator.calibration.single_image.field_points import field_line_points
from procc_annotator.calibration.single_image.pixel_aspect import (
    SQUARE_PIXELS,
    AspectSample,
    most_probable_aspect,
    possible_pixel_aspects,
)
from procc_annotator.calibration.single_image.probability import (
    POSSIBLE_FROM,
    SURE_FROM,
    ProposalEvidence,
    probability_right,
)
from procc_annotator.calibration.single_image.proposal import KnownPosition, Proposal
from procc_annotator.calibration.single_image.propose import found_camera, propose_camera
from procc_annotator.calibration.single_image.search import RankedCameras
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import PixelAspect
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from tests.drawn_shots import (
    PICTURE_SIZE,
    Look,
    Stage,
    draw,
    looking_at,
    random_camera,
    stage_of,
)

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
    assert "of expected lines found" in found.reason


def test_a_squeezed_picture_has_a_camera_with_wide_pixels():
    """It is not sure from one picture: a camera elsewhere suits square pixels as well."""
    camera, picture = _drawn()
    size = (540, 540)
    squeezed = np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), np.uint8)
    found = propose_camera(squeezed, _stage().field)
    assert found.state == "unsure"
    assert "its pixels may not be" in found.reason
    assert found.fit.camera.focal_px[1] / found.fit.camera.focal_px[0] == pytest.approx(
        16 / 9, 0.01
    )
    assert _worst_px(camera.scaled(PICTURE_SIZE, size), found.fit.camera, size) < 4
    certain = propose_camera(squeezed, replace(_stage().field, pixels=PixelAspect(16 / 9, 1.0)))
    assert certain.state == "sure"


SEEN = ProposalEvidence(0.95, 0.95, 0.2, 2500.0, 9, 0.3, 0.5, 1.0)


@pytest.mark.parametrize(
    "worse",
    [
        {"coverage": 0.6},
        {"explained": 0.6},
        {"margin": 0.05},
        {"length_px": 500.0},
        {"elements": 3},
        {"support": 0.02},
        {"sd_px": 5.0},
        {"displaced": "Side line top is 9 px off its line"},
    ],
)
def test_what_speaks_against_a_camera_makes_it_less_probable(worse):
    assert probability_right(replace(SEEN, **worse)) < probability_right(SEEN)


def test_overwhelming_evidence_is_sure_and_little_is_not():
    assert probability_right(replace(SEEN, coverage=0.97, explained=0.98, margin=0.3)) > SURE_FROM
    assert (
        probability_right(ProposalEvidence(0.3, 0.3, 0.0, 300.0, 1, 0.0, 3.0, 30.0)) < POSSIBLE_FROM
    )


def test_pixels_are_those_that_explain_most_pictures():
    """Other ones suit each picture as well, but from different positions."""
    possible = possible_pixel_aspects((640, 640))
    moved = {16 / 9: 0.01, 4 / 3: 1.0, 1.0: 2.0}
    samples = [
        [AspectSample(SEEN, np.array([moved[one.value] * n, 60, -16])) for n in range(4)]
        for one in possible
    ]
    found = most_probable_aspect(possible, samples)
    assert found.value == 16 / 9
    assert found.probability > 0.99
    assert possible_pixel_aspects((1920, 1080)) == (SQUARE_PIXELS,)


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


def test_searches_from_more_starts_where_the_usual_ones_find_no_probable_camera():
    field, size = _stage().field, (960, 540)
    camera = random_camera(field, np.random.default_rng(10), size)
    picture = draw(_stage(), camera, size, seed=10, look=BROADCAST)
    usual = found_camera(picture, field)
    assert usual is not None
    assert not usual.is_possible
    found = propose_camera(picture, field)
    assert found.state == "sure"
    assert _worst_px(camera, found.fit.camera, size) < 4


def test_a_known_position_is_kept():
    camera, picture = _drawn()
    known = KnownPosition(np.array(MAIN), np.eye(3) * 0.04)
    found = propose_camera(picture, _stage().field, known=[known])
    assert found.state == "sure"
    assert _worst_px(camera, found.fit.camera) < 4
    assert np.abs(np.array(found.fit.camera.position_world) - MAIN).max() < 0.8


WRONG = KnownPosition(np.array([-30.0, 50.0, -8.0]), np.eye(3) * 0.04)


def test_a_camera_of_a_detector_is_a_hypothesis_where_the_search_misses_it(monkeypatch):
    camera, picture = _drawn()
    frame = ImageFrame(PICTURE_SIZE)

    def misses(*_args: object) -> RankedCameras:
        elsewhere = vector_from_camera(replace(camera, pan_rad=camera.pan_rad + 0.5), frame)
        return RankedCameras(elsewhere[None], np.array([0.3]), elsewhere[None])

    monkeypatch.setattr(candidates, "search_cameras", misses)
    detected = replace(camera, pan_rad=camera.pan_rad + 0.005)
    place = KnownPosition(np.array(camera.position_world), np.eye(3))
    missed = propose_camera(picture, _stage().field, known=[place], elsewhere=False)
    assert missed.state == "none"
    place = replace(place, camera=detected)
    found = propose_camera(picture, _stage().field, known=[place], elsewhere=False)
    assert _worst_px(camera, found.fit.camera) < 4
    assert found.probability > POSSIBLE_FROM


def test_a_wrong_known_position_is_not_sure_and_replaces_nothing():
    only = propose_camera(_drawn()[1], _stage().field, known=[WRONG], elsewhere=False)
    assert only.state != "sure"
    found = propose_camera(_drawn()[1], _stage().field, known=[WRONG])
    assert (found.state, found.fit.camera) == ("sure", _anywhere().fit.camera)


def _seen(position: tuple[float, float, float], x: float, share: float) -> BestCandidate:
    """A camera that looks at (x, 0, 0) and agrees so well with the line pixels."""
    size = (1280, 720)
    focal_px = 1700.0 * np.hypot(*position[1:]) / np.hypot(60, 16)
    camera = looking_at(position, (x, 0, 0), focal_px, size)
    vector = vector_from_camera(camera, ImageFrame(size))
    fit = FitResult("P", size, camera, vector=vector, covariance=np.eye(len(vector)) * 0.09)
    refined = LineAlignment(fit, share, None, {}, 100)
    return BestCandidate(
        RefinedCandidate(vector, refined, share, share, 0.0), None, 0.5 * share, 1.0
    )


@pytest.mark.parametrize(
    ("at_known", "kept", "rival"),
    [
        (_seen((0.3, 60, -16), 20.0, 0.85), "at_known", 0.425),
        (_seen((0.3, -60, -16), -20.0, 0.85), "at_known", 0.425),  # its other side
        (_seen((0, 64, -17), 20.0, 0.95), "free", 0.44),  # contradicted by the picture
        (_seen((0, 60, -16), -20.0, 0.95), "at_known", 0.88),
        (_seen((0, 60, -16), -20.0, 0.60), "free", 0.44),
        (_seen((0, 60, -16), -20.0, 0.86), "free", 0.44),
        (_seen((0, 60, -16), -20.0, 1.00), "at_known", 0.88),
    ],
)
def test_a_known_position_is_one_more_hypothesis(at_known, kept, rival):
    """The better one wins; a free camera that wins is as sure as without a known position."""
    free, field = _seen((0, 60, -16), 20.0, 0.88), _stage().field
    found = better_candidate(free, at_known, field, field_line_points(field))
    assert found.candidate is {"free": free, "at_known": at_known}[kept].candidate
    assert found.other_score == pytest.approx(rival)


@pytest.mark.parametrize("sport", ["volleyball", "ice_hockey"])
def test_a_picture_of_another_sport_is_not_sure(sport, sample_data):
    picture = decode_bgra(sample_data / sport / "00001.jpg")
    found = propose_camera(picture, _stage().field)
    assert found.state != "sure"
    assert found.reason.startswith("is this Soccer? ")


def test_more_paint_on_the_right_field_does_not_question_the_sport():
    """Such as the lines of a training pitch across it."""
    picture = _drawn()[1].copy()
    for y in range(330, 700, 60):
        cv2.line(picture, (250, y), (1150, y + 40), (235, 238, 236, 255), 4, cv2.LINE_AA)
    known = KnownPosition(np.array(MAIN), np.eye(3) * 0.04)
    found = propose_camera(picture, _stage().field, known=[known], elsewhere=False)
    assert not found.reason.startswith("is this")
    assert _worst_px(_drawn()[0], found.fit.camera) < 4


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
