"""Pieces of shots: how a match is divided, and how what was found in pieces becomes one track."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.batch.execution.executor import InProcess
from procc_annotator.batch.match_tracking import (
    OVERLAP_FRAMES,
    PIECE_FRAMES,
    SET_ASIDE,
    MatchToTrack,
    TrackedMatch,
    divide_shot,
    track_match,
)
from procc_annotator.batch.season_run import SeasonRun
from procc_annotator.batch.tracking import CutUnit, TrackingUnit, TrackUnit
from procc_annotator.batch.unit_store import UnitStore
from procc_annotator.calibration.single_image.pixel_aspect import SQUARE_PIXELS
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.packed import PackedCameras, camera_row

FIELD = replace(load_field("soccer"), pixels=SQUARE_PIXELS)
CAMERA = PinholeCamera(0.0, 1.35, 0.0, (0.0, 70.0, -15.0), (1500.0,) * 2, (639.5, 359.5))
NAMES = tuple(f"m_{n:06d}" for n in range(4000))


def match(count: int = len(NAMES), **more: object) -> MatchToTrack:
    return MatchToTrack("m", Path("m.mp4"), "", FIELD, "m", NAMES[:count], **more)


def piece(unit: TrackUnit, camera: PinholeCamera | None, coverage: float = 0.9) -> PackedCameras:
    """Every frame with a camera, followed; or none."""
    names = NAMES[unit.numbers.start : unit.numbers.stop]
    bare = PackedCameras.without_cameras(names, names[0], "lost")
    if camera is None:
        return bare
    count = len(names)
    lower = np.diag([0.01] * 8)[np.tril_indices(8)]
    return replace(
        bare, state=("followed",) * count, coverage=np.full(count, coverage),
        residual_px=np.full(count, 0.2), size=np.tile([1280.0, 720.0], (count, 1)),
        camera=np.tile(camera_row(camera), (count, 1)), covariance=np.tile(lower, (count, 1)),
    )  # fmt: skip


def run(
    match: MatchToTrack,
    track: Callable[[TrackUnit], PackedCameras | None],
    cuts: Sequence[int] = (),
) -> TrackedMatch:
    plan = track_match(match)

    def done(unit: TrackingUnit) -> object:
        if isinstance(unit, CutUnit):
            return [n for n in cuts if n in unit.numbers]
        assert isinstance(unit, TrackUnit)
        return track(unit)

    units = next(plan)
    while True:
        try:
            units = plan.send({unit.key: done(unit) for unit in units})
        except StopIteration as end:
            return end.value


@pytest.mark.parametrize("count", [1, 40, PIECE_FRAMES, PIECE_FRAMES + 1, 4000, 67_500])
def test_pieces_cover_a_shot_and_share_frames(count):
    pieces = divide_shot(range(10, 10 + count))
    assert (pieces[0].start, pieces[-1].stop) == (10, 10 + count)
    assert max(map(len, pieces)) <= PIECE_FRAMES
    for one, other in pairwise(pieces):
        assert one.stop - other.start == OVERLAP_FRAMES


def test_pieces_that_agree_become_one_shot():
    found = run(match(), lambda unit: piece(unit, CAMERA), cuts=[1000])
    assert found.cameras.frame == NAMES
    assert found.cameras.shot == (NAMES[0],) * 1000 + (NAMES[1000],) * 3000
    assert not found.jumps


def test_a_piece_without_a_camera_gets_that_of_its_neighbours_along_the_shot():
    seen: list[tuple[int, tuple[int, ...]]] = []

    def track(unit: TrackUnit) -> PackedCameras:
        seen.append((unit.numbers.start, tuple(unit.anchors)))
        return piece(unit, CAMERA if unit.anchors or not unit.numbers.start else None)

    found = run(match(), track)
    assert found.cameras.has_camera.all()
    pieces = divide_shot(range(4000))
    handed = [(start, anchors) for start, anchors in seen if anchors]
    assert [start for start, _ in handed] == [own.start for own in pieces[1:]]
    assert all(before.stop - 1 == n for before, (_, (n,)) in zip(pieces, handed, strict=False))


def test_of_two_pieces_that_contradict_each_other_the_one_on_less_paint_is_followed_again():
    turned = replace(CAMERA, pan_rad=0.1)
    again: list[int] = []

    def track(unit: TrackUnit) -> PackedCameras:
        if unit.anchors:
            again.append(unit.numbers.start)
        first = not unit.numbers.start
        return piece(unit, CAMERA if first or unit.anchors else turned, 0.9 if first else 0.5)

    found = run(match(2000), track)
    assert again == [divide_shot(range(2000))[1].start]
    assert not found.jumps
    stubborn = run(match(2000), lambda u: piece(u, turned if u.numbers.start else CAMERA))
    assert len(stubborn.jumps) == 1
    assert stubborn.cameras.has_camera.all()


def test_a_shot_without_a_camera_is_looked_at_where_others_or_earlier_matches_stand():
    known: list[np.ndarray] = []

    def track(unit: TrackUnit) -> PackedCameras:
        known.extend(place.position_m for place in unit.known)
        return piece(unit, None if unit.numbers.start and not unit.known else CAMERA)

    assert run(match(300), track, cuts=[100]).cameras.has_camera.all()
    assert np.allclose(known, [CAMERA.position_world])


def test_a_season_ends_with_what_was_set_aside_and_later_matches_know_the_stadium(tmp_path):
    order: list[str] = []

    def task(unit: TrackingUnit) -> object:
        if isinstance(unit, CutUnit):
            return []
        order.append(unit.match)
        if unit.match == "b":
            raise OSError("the disk is gone")
        return piece(unit, CAMERA)

    with UnitStore(tmp_path / "s.sqlite", {}, resume=False) as store:
        run = SeasonRun[TrackedMatch](task, store, InProcess())
        plans = {name: track_match(replace(match(50), name=name)) for name in "abc"}
        found = dict(run.run({"a": "Arena", "b": "", "c": "Arena"}, plans.__getitem__))
        assert found["a"].cameras.has_camera.all()
        assert set(found["b"].cameras.state) == {SET_ASIDE}
        assert order.index("a") < order.index("c")
        (failed,) = store.units("failed")
        assert (failed.match, failed.tries) == ("b", 3)
        assert "the disk is gone" in failed.error
        states = {one.match: (one.done, one.failed) for one in store.matches()}
    assert states == {"a": (2, 0), "b": (1, 1), "c": (2, 0)}
