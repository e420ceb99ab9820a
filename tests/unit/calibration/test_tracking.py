"""A camera is followed through a shot, both ways, to the cuts; what is not known is said."""

import itertools
import threading
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import lru_cache

import cv2
import numpy as np
import pytest

from procc_annotator.calibration.line_alignment.expected_lines import marking_points
from procc_annotator.calibration.optimization.camera_parameters import vector_from_camera
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.field_points import field_line_points
from procc_annotator.calibration.single_image.icp_refinement import (
    AGREEMENT_POINTS,
    explained_on_field,
    line_pixels_for_field,
)
from procc_annotator.calibration.single_image.proposal import KnownPosition, Proposal
from procc_annotator.calibration.tracking import shot_tracker, smoother
from procc_annotator.calibration.tracking.filter_step import (
    FilterStep,
    nearest_pinhole_vector,
    remeasured_step,
    state_from_camera,
)
from procc_annotator.calibration.tracking.forward_pass import FrameChain, track_run
from procc_annotator.calibration.tracking.frame_reader import decoded_frames
from procc_annotator.calibration.tracking.motion_model import (
    MOTION_PARAMETERS,
    estimate_inter_frame_motion,
    motion_image,
)
from procc_annotator.calibration.tracking.shot_tracker import track_shot
from procc_annotator.calibration.tracking.smoother import (
    BandedNormalEquations,
    SmoothedChain,
    smooth_chain,
    solve_banded,
)
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.geometry import Line
from procc_annotator.field.model import PixelAspect
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.video import open_shared_video
from tests.drawn_shots import Aim, DrawnShot, Look, course, stage_of
from tests.unit.calibration import plain_pictures
from tests.unit.calibration.plain_pictures import FIELD, FRAME, SIZE, apart_px, camera, draw

COUNT = 20
CAMERAS = [camera(0.36 + 0.006 * n + 0.0002 * n * n, 1.33, 1500.0 * 1.005**n) for n in range(COUNT)]
OTHER = camera(-0.5, 1.34, 1700.0)
UNLIKE = np.random.default_rng(1).integers(0, 255, (SIZE[1], SIZE[0], 4), dtype=np.uint8)


@lru_cache(maxsize=64)
def _picture(number: int, lines: bool = True) -> PixelArray:
    return draw(CAMERAS[number], lines=lines, seed=number)


@pytest.fixture(scope="module", autouse=True)
def pictures_go_afterwards() -> Iterator[None]:
    """They take a hundred megabytes."""
    yield
    _picture.cache_clear()


def _nothing(_picture: PixelArray, _field: object, _known: tuple[KnownPosition, ...]) -> Proposal:
    fit = FitResult("R", SIZE, None, "nothing")
    return Proposal("none", "nothing was proposed", fit, 0.0, 0.0, None, 0.0, None)


def _followed(frame: Callable[[int], PixelArray] = _picture, **options: object) -> Track:
    options.setdefault("propose", _nothing)
    options.setdefault("anchors", {0: CAMERAS[0]})
    return track_shot(frame, range(COUNT), FIELD, **options)


def _off(frame: TrackedFrame) -> float:
    return apart_px(CAMERAS[frame.number], frame.fit.camera)


def test_every_frame_is_followed_from_one_in_the_middle():
    told: list[TrackedFrame] = []
    found = _followed(anchors={7: CAMERAS[7]}, on_frame=told.append)
    assert [f.number for f in found.frames] == list(range(COUNT))
    assert [f.state for f in found.frames] == ["followed"] * 7 + ["anchor"] + ["followed"] * 12
    assert max(_off(f) for f in found.frames) < 0.8
    assert min(f.coverage for f in found.frames) > 0.8
    assert [f.anchor_distance for f in found.frames] == [abs(n - 7) for n in range(COUNT)]
    assert found.shots == ((0, COUNT - 1),)
    assert sorted(f.number for f in told) == list(range(COUNT))
    fits = [f.fit for f in found.frames if f.fit is not None and f.state != "anchor"]
    positions = {f.camera.position_world for f in fits if isinstance(f.camera, PinholeCamera)}
    assert len(positions) == 1  # a tripod


def test_an_anchor_keeps_its_camera_to_the_digit_and_the_track_passes_it():
    anchors = {0: CAMERAS[0], 12: CAMERAS[12], 19: CAMERAS[19]}
    found = _followed(anchors=anchors)
    for number, given in anchors.items():
        fit = found.frames[number].fit
        assert fit.camera is given
        assert found.frames[number].state == "anchor"
    assert max(_off(f) for f in found.frames) < 0.8
    assert found.frames[10].anchor_distance == 2


def test_squeezed_frames_are_followed_with_cameras_of_wide_pixels():
    size, wide = (540, 540), PixelAspect(16 / 9, 0.9)
    told: list[TrackedFrame] = []
    anchor = CAMERAS[7].scaled(SIZE, size)
    found = track_shot(
        lambda n: np.asarray(cv2.resize(_picture(n), size, interpolation=cv2.INTER_AREA), np.uint8),
        range(COUNT),
        replace(FIELD, pixels=wide),
        anchors={7: anchor},
        propose=_nothing,
        on_frame=told.append,
    )
    assert found.frames[7].fit.camera is anchor
    for frame in (*found.frames, *told):
        assert frame.fit.size == size
        assert apart_px(CAMERAS[frame.number], frame.fit.camera.scaled(size, SIZE)) < 1
        assert frame.state == "anchor" or "the pixels may not be" in frame.reason


def test_a_track_that_does_not_pass_through_a_known_camera_is_doubtful():
    """Its lines lie 23 px beside those of the picture, and all other frames agree on these."""
    wrong = replace(CAMERAS[7], pan_rad=CAMERAS[7].pan_rad + 0.02)
    found = _followed(anchors={7: wrong, 15: CAMERAS[15]})
    assert found.frames[7].fit.camera is wrong
    others = [f for f in found.frames if f.state != "anchor"]
    assert max(_off(f) for f in others) < 1.5
    assert all(("off the nearest frame" in f.reason) == (f.number <= 11) for f in others)


def test_an_element_that_following_lost_is_measured_again_around_the_smoothed_camera():
    frame, painted = ImageFrame(SIZE), marking_points(FIELD)
    vector = nearest_pinhole_vector(CAMERAS[0], FIELD, frame)
    start = state_from_camera(vector, FIELD, painted, frame)
    steps: list[FilterStep] = []
    track_run(
        _picture, range(3), start, painted, frame, lambda _, step: steps.append(step), lambda: None
    )
    whole = steps[2].marks
    lost = np.unique(whole.element)[0]
    poor = replace(steps[2], marks=whole.chosen(whole.element != lost), coverage=0.5)
    again = remeasured_step(_picture(2), poor, painted, frame)
    assert set(again.marks.element) == set(whole.element)
    assert again.coverage == pytest.approx(steps[2].coverage, abs=0.02)
    assert remeasured_step(draw(CAMERAS[2], lines=False), poor, painted, frame) is poor


def test_a_right_camera_explains_the_line_pixels_of_its_picture_and_a_wrong_one_does_not():
    vector, lines = vector_from_camera(CAMERAS[2], FRAME), field_line_points(FIELD)
    seen = line_pixels_for_field(_picture(2), FIELD).thinned(AGREEMENT_POINTS)
    turned = vector + 0.02 * (np.arange(11) == 0)  # 30 px
    assert explained_on_field(seen, vector, lines) > 0.95
    assert explained_on_field(seen, turned, lines) < 0.6


def test_a_sure_camera_is_not_replaced_by_one_that_leaves_its_lines(monkeypatch):
    """All frames together suit a camera that is turned: then they stay as they were followed."""

    def turned(chain: FrameChain, *given: object) -> SmoothedChain:
        found = smooth_chain(chain, *given)
        by = 0.02 * (np.arange(11) == 0)  # 30 px
        steps = [
            replace(step, belief=replace(step.belief, vector=step.belief.vector + by))
            for step in found.chain.steps
        ]
        return replace(found, chain=replace(found.chain, steps=steps))

    def propose(*_: object) -> Proposal:
        fit = FitResult("R", SIZE, CAMERAS[0], vector=vector_from_camera(CAMERAS[0], FRAME))
        return Proposal("sure", "all is there", fit, 1.0, 1.0, 0.1, 0.9, None)

    monkeypatch.setattr(shot_tracker, "smooth_chain", turned)
    found = _followed(anchors={}, propose=propose)
    assert max(_off(f) for f in found.frames) < 1.5
    assert not any(f.reason for f in found.frames)


def test_of_sure_cameras_the_first_one_with_a_known_position_is_followed(monkeypatch):
    """The one of frame 0 stands where it shows nearly the same, zoomed accordingly."""
    count, asked = 45, []
    true = [camera(0.02 * n, 1.33, 1500.0) for n in range(count)]
    pictures = [draw(shown, seed=n) for n, shown in enumerate(true)]

    def propose(*_: object) -> Proposal:
        number = 20 * len(asked)
        asked.append(number)
        fit = FitResult("R", SIZE, true[number], vector=vector_from_camera(true[number], FRAME))
        return Proposal("sure", "all is there", fit, 1.0, 1.0, 0.1, 0.9, None, 0.99)

    monkeypatch.setattr(shot_tracker, "_TRIED_FRAMES", 20)
    found = track_shot(pictures.__getitem__, range(count), FIELD, propose=propose)
    assert asked == [0, 20]
    assert [f.number for f in found.frames if f.anchor_distance == 0] == [20]
    assert {f.number: f.probability for f in found.frames if f.probability} == {20: 0.99}
    monkeypatch.setattr(shot_tracker, "_MAX_POSITION_SD_M", 0.0)
    asked.clear()
    found = track_shot(pictures.__getitem__, range(count), FIELD, propose=propose)
    assert asked == [0, 20, 40]
    assert all(f.state == "followed" for f in found.frames)


def test_frames_solved_some_at_a_time_have_the_same_cameras(monkeypatch):
    def frame(number: int) -> PixelArray:
        return _picture(number, lines=not 6 <= number < 12)  # some have nothing to solve

    whole = _followed(frame)
    monkeypatch.setattr(smoother, "_BATCH_FRAMES", 3)
    for one, other in zip(whole.frames, _followed(frame).frames, strict=True):
        np.testing.assert_allclose(other.fit.vector, one.fit.vector, atol=1e-9)
        np.testing.assert_allclose(other.fit.covariance, one.fit.covariance, rtol=1e-6)
        assert one.state == other.state
        assert one.coverage == pytest.approx(other.coverage)


@pytest.mark.parametrize("worn", [False, True])
def test_a_long_line_that_the_camera_shows_elsewhere_is_reported_and_a_worn_one_is_not(
    monkeypatch, worn
):
    """Everything else fits: four fifths of what is in sight lie on line pixels."""
    name = "Big rect. right main"
    there = FIELD.element(name)
    (x, *start), (_, *end) = there.geometry.start, there.geometry.end
    away = replace(there, geometry=Line((x - 3, *start), (x - 3, *end)))  # 20 px
    others = tuple(e for e in FIELD.elements if e.name != name)
    field = FIELD if worn else replace(FIELD, elements=(*others, away))
    if worn:
        monkeypatch.setattr(plain_pictures, "FIELD", replace(FIELD, elements=others))
    found = track_shot(
        lambda number: draw(CAMERAS[number]), range(4), field, anchors={0: CAMERAS[0]}
    ).frames[1:]
    assert all(f.state == "followed" and f.coverage > 0.65 and _off(f) < 1.0 for f in found)
    assert [there.title in f.reason for f in found] == [not worn] * 3


def test_the_same_frames_give_the_same_cameras():
    def vectors(found: Track) -> list[list[float]]:
        return [f.fit.vector.tolist() for f in found.frames if f.fit and f.fit.vector is not None]

    assert vectors(_followed()) == vectors(_followed())


def test_frames_without_paint_are_bridged_and_less_sure():
    bare = range(8, 13)
    found = _followed(lambda n: _picture(n, n not in bare))
    states = [f.state for f in found.frames]
    assert states[1:8] == ["followed"] * 7
    assert states[8:13] == ["bridged"] * 5
    assert states[13:] == ["followed"] * 7
    assert all(found.frames[n].reason for n in bare)
    assert max(_off(f) for f in found.frames) < 3.0
    place = np.array([[36.0, 0.0, 0.0]])
    deviations = [float(f.fit.projected_sd(place)[0]) for f in found.frames if f.fit]
    assert deviations[10] > 2.0 * deviations[5]


def test_a_cut_ends_a_shot_and_the_next_one_is_found_by_a_proposal():
    known: list[int] = []

    def frame(number: int) -> PixelArray:
        return _picture(number) if number < 9 else draw(OTHER, seed=number)

    def propose(picture: PixelArray, _: object, places: tuple[KnownPosition, ...]) -> Proposal:
        known.append(len(places))
        fit = FitResult("R", SIZE, OTHER, vector=vector_from_camera(OTHER, FRAME))
        return Proposal("sure", "all is there", fit, 1.0, 1.0, 0.1, 0.9, None)

    found = _followed(frame, propose=propose)
    assert found.shots == ((0, 8), (9, COUNT - 1))
    assert {f.state for f in found.frames[9:]} == {"followed"}
    assert known == [0]  # another shot may be from anywhere
    assert found.frames[15].anchor_distance == 6
    assert max(_off(f) for f in found.frames[:9]) < 0.8


@pytest.mark.parametrize(("away_m", "state"), [(0.8, "followed"), (4.5, "lost")])
def test_a_camera_found_where_others_stand_counts_if_its_shot_tells_so(away_m, state):
    asked: list[int] = []

    def propose(_: PixelArray, __: object, places: tuple[KnownPosition, ...]) -> Proposal:
        asked.append(len(places))
        fit = FitResult("R", SIZE, CAMERAS[0], vector=vector_from_camera(CAMERAS[0], FRAME))
        return Proposal("sure", "all is there", fit, 1.0, 1.0, 0.1, 0.9, None)

    x, y, z = CAMERAS[0].position_world
    place = KnownPosition(np.array([x, y + away_m, z]), np.eye(3) * 0.5)
    found = _followed(anchors={}, known=[place], propose=propose)
    assert asked == [1]
    assert {f.state for f in found.frames} == {state}
    assert all(("does not stand" in f.reason) == (state == "lost") for f in found.frames)
    assert all((f.fit is None) == (state == "lost") for f in found.frames)


def test_what_shows_nothing_of_the_field_is_lost_and_said_to_be():
    found = _followed(lambda n: _picture(n) if n < 9 else UNLIKE)
    assert [f.state for f in found.frames[9:]] == ["lost"] * (COUNT - 9)
    assert all(f.fit is None and f.anchor_distance is None for f in found.frames[9:])
    assert found.frames[-1].reason == "nothing was proposed"


def test_it_ends_as_soon_as_it_is_told_to():
    class Stopped(Exception):
        pass

    calls = 0

    def go_on() -> None:
        nonlocal calls
        calls += 1
        if calls == 5:
            raise Stopped

    with pytest.raises(Stopped):
        _followed(go_on=go_on)
    assert calls == 5
    assert not [t for t in threading.enumerate() if t.name == "frames ahead"]


def test_no_frames_are_no_track():
    assert track_shot(_picture, range(0), FIELD).frames == ()


def test_frames_come_backwards_and_a_failure_is_passed_on():
    assert [g.number for g in decoded_frames(_picture, range(12, 2, -1))] == list(range(12, 2, -1))

    def broken(number: int) -> PixelArray:
        if number == 4:
            raise OSError("gone")
        return _picture(number)

    with pytest.raises(OSError, match="gone"):
        list(decoded_frames(broken, range(10)))


def test_the_motion_of_a_picture_is_that_of_its_camera():
    before, now = CAMERAS[3], CAMERAS[5]
    turn = estimate_inter_frame_motion(
        motion_image(_picture(3)),
        motion_image(_picture(5)),
        vector_from_camera(before, FRAME),
        np.zeros(4),
        FRAME,
    )
    true = (vector_from_camera(now, FRAME) - vector_from_camera(before, FRAME))[MOTION_PARAMETERS]
    assert np.abs(turn.step - true)[:2].max() < 1.0 / 1500  # a solver px
    assert abs(turn.step[3] - true[3]) < 0.004
    unlike = motion_image(UNLIKE)
    vector = vector_from_camera(before, FRAME)
    assert (
        estimate_inter_frame_motion(motion_image(_picture(3)), unlike, vector, np.zeros(4), FRAME)
        is None
    )


def test_a_banner_laid_over_the_picture_does_not_hold_the_camera_back():
    banner = np.random.default_rng(2).integers(20, 90, (6, 32, 4), dtype=np.uint8)
    banner = banner.repeat(20, axis=0).repeat(20, axis=1)
    cameras = [camera(0.4 + turned, 1.33, 1500.0) for turned in (0.0, 0.0015)]
    pictures = [draw(one, seed=seed).copy() for seed, one in enumerate(cameras)]
    for picture in pictures:
        picture[-len(banner) :] = banner
    before, now = (vector_from_camera(one, FRAME) for one in cameras)
    turn = estimate_inter_frame_motion(*map(motion_image, pictures), before, np.zeros(4), FRAME)
    assert (
        np.abs(turn.step - (now - before)[MOTION_PARAMETERS])[:2].max() < 0.5 / 1500
    )  # half a solver px


def test_a_chain_is_solved_as_all_of_it_at_once_would_be():
    random = np.random.default_rng(3)
    count, own, shared = 5, 3, 2
    total = count * own + shared
    whole = np.zeros((total, total))
    for k in range(count):
        rows = [*range(k * own, k * own + own), *range(count * own, total)]
        if k + 1 < count:
            rows += range((k + 1) * own, (k + 2) * own)
        by = random.normal(size=(20, len(rows)))
        whole[np.ix_(rows, rows)] += by.T @ by
    right = random.normal(size=(total, 1))
    blocks = [slice(k * own, (k + 1) * own) for k in range(count)]
    last = slice(count * own, total)
    found = solve_banded(
        BandedNormalEquations(
            np.array([whole[b, b] for b in blocks]),
            np.array([whole[a, b] for a, b in itertools.pairwise(blocks)]),
            np.array([whole[b, last] for b in blocks]),
            whole[last, last],
            np.array([right[b] for b in blocks]),
            right[last],
        )
    )
    solved, inverse = np.linalg.solve(whole, right), np.linalg.inv(whole)
    assert found.own.reshape(-1, 1) == pytest.approx(solved[: count * own])
    assert found.shared == pytest.approx(solved[last])
    assert found.shared_covariance == pytest.approx(inverse[last, last])
    for k, block in enumerate(blocks):
        assert found.own_covariance[k] == pytest.approx(inverse[block, block])


def test_a_camera_on_rails_is_followed_as_one():
    cameras = [
        camera(0.44 + 0.002 * n, 1.33, 1300.0, (-4.0 + 0.25 * n, 62.0, -17.0)) for n in range(COUNT)
    ]
    pictures = [draw(shown, seed=n) for n, shown in enumerate(cameras)]
    found = _followed(pictures.__getitem__, anchors={0: cameras[0]})
    assert {f.state for f in found.frames[1:]} == {"followed"}
    for frame in found.frames:
        assert apart_px(cameras[frame.number], frame.fit.camera) < 1.5
        apart = np.subtract(frame.fit.camera.position_world, cameras[frame.number].position_world)
        assert np.abs(apart).max() < 0.5


def test_a_camera_that_moves_where_each_place_leaves_a_few_lines_behind():
    """Held at one place it would lose a line after the other, and agree with those that it has."""
    count, (x, y, z) = 30, (-20.0, 50.0, -12.0)
    aims = tuple(Aim(x + 0.5 * dx, 0, 600.0, (x + dx, y, z)) for dx in (0.0, 4.5, 9.0))
    cameras = course((x, y, z), aims, count, (640, 360))
    shot = DrawnShot(stage_of("soccer"), (cameras,), (640, 360), Look(people=False))
    pictures = [shot.frame(number) for number in range(count)]
    anchors = {0: shot.cameras[0]}
    found = track_shot(pictures.__getitem__, range(count), shot.stage.field, anchors=anchors)
    for frame, true in zip(found.frames, shot.cameras, strict=True):
        assert frame.coverage > 0.9
        apart = np.subtract(frame.fit.camera.position_world, true.position_world)
        assert np.abs(apart).max() < 0.5


@pytest.mark.soak
def test_a_tripod_beside_a_pitch_that_is_not_as_its_file_says_stays_one(shared_data):
    """A position a frame explains such a shot a little better, by a camera that flies 19 m."""
    video = open_shared_video(shared_data / "clips" / "soccer_7_Psg-Angers_103_110.mp4")
    told: list[TrackedFrame] = []
    found = track_shot(video.frame, range(video.frame_count), FIELD, on_frame=told.append)
    cameras = [f.fit.camera for f in found.frames if f.fit is not None]
    places = [c.position_world for c in cameras if isinstance(c, PinholeCamera)]
    assert len(places) == video.frame_count
    assert np.ptp(places, axis=0).max() < 0.1
    # Followed once, and once more only until it is clear that it does not move.
    followed = sum(frame.state != "lost" for frame in told)
    assert 0.9 * video.frame_count < followed < 1.9 * video.frame_count


def test_coverage_is_that_of_the_camera_that_is_handed_back():
    """Lines that all frames together move a camera away from are not on its paint any more."""
    frame = ImageFrame(SIZE)
    painted = marking_points(FIELD)
    start = state_from_camera(
        nearest_pinhole_vector(CAMERAS[0], FIELD, frame), FIELD, painted, frame
    )
    steps: list[FilterStep] = []
    track_run(
        _picture,
        range(6),
        start,
        painted,
        frame,
        lambda _number, step: steps.append(step),
        lambda: None,
    )
    marks = steps[3].marks
    beside = np.arange(len(marks)) % 3 == 0
    steps[3] = replace(steps[3], marks=replace(marks, across=marks.across + 6.0 * beside))
    turns = tuple(step.turn for step in steps[1:])
    chain = FrameChain(tuple(range(6)), tuple(steps), turns, {0: start})
    found = smooth_chain(chain, FIELD, frame).chain.steps
    shares = [after.coverage / before.coverage for after, before in zip(found, steps, strict=True)]
    assert shares[3] == pytest.approx(2 / 3, abs=0.05)
    assert min(shares[:3] + shares[4:]) > 0.95
