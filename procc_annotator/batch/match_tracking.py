"""Track a match: cut it into shots and these into pieces, follow them, join what was found.

A plan is a generator of rounds: it yields units that may be done at the same time, anywhere, and is
sent what came of them. It depends on nothing else, so that a run that goes on, with other workers
too, comes to the same cameras.
"""

from __future__ import annotations

import math
from collections.abc import Generator, Mapping, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as dataclass_field
from itertools import groupby, pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.batch.tracking import CutUnit, PixelUnit, TrackingUnit, TrackUnit
from procc_annotator.calibration.line_alignment.expected_lines import marking_points
from procc_annotator.calibration.single_image.proposal import KnownPosition
from procc_annotator.camera.base import Camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Field, PixelAspect
from procc_annotator.formats.cameras.packed import PackedCameras

PIECE_FRAMES = 1500  # a minute at 25 frames a second
OVERLAP_FRAMES = 50
_CUT_FRAMES = 7500  # in which cuts are looked for at once
SET_ASIDE = "set aside"  # state of frames of a piece that failed again and again
_MOST_ROUNDS = 8  # pieces along which a camera is passed on
# Cameras of two pieces are the same where they differ by no more than what remains between lines
# and paint in either, or this much, px.
_SAME_PX = 1.0

Units = Sequence[TrackingUnit]
Results = Mapping[str, Any]  # by key, see `TrackTask`; of one that was set aside the error


@dataclass(frozen=True, eq=False)
class MatchToTrack:
    """What is known of a match beforehand.

    Attributes:
        name: of the match.
        pictures: folder or video. stamp: of its content, see `Unit.key`.
        field: the elements, metres. field_key: the same in `TrackTask.fields`.
        names: of its frames.
        anchors, clicks: as of `TrackUnit`.
        known: where cameras of earlier matches of the stadium stood.
        pixels: of the pictures; None as the field says.
        only: a frame whose shot alone is followed; None for all.
    """

    name: str
    pictures: Path
    stamp: str
    field: Field
    field_key: str
    names: tuple[str, ...]
    anchors: Mapping[int, Camera] = dataclass_field(default_factory=dict)
    clicks: Mapping[int, str] = dataclass_field(default_factory=dict)
    known: tuple[KnownPosition, ...] = ()
    pixels: PixelAspect | None = None
    only: int | None = None

    def unit(self, numbers: range) -> TrackUnit:
        """A piece with the anchors in it."""
        anchors = {n: camera for n, camera in self.anchors.items() if n in numbers}
        clicks = {n: clicks for n, clicks in self.clicks.items() if n in numbers}
        given = self.name, self.pictures, self.stamp, self.field_key, numbers
        return TrackUnit(*given, anchors, clicks, pixels=self.pixels)


@dataclass(frozen=True, eq=False)
class TrackedMatch:
    """Result for a match.

    Attributes:
        cameras: of the frames that were asked for.
        jumps: numbers at which the cameras of two pieces do not meet -> px between them.
    """

    cameras: PackedCameras
    jumps: Mapping[int, float]


def track_match(match: MatchToTrack) -> Generator[Units, Results, TrackedMatch]:
    """The plan of a match."""
    count = len(match.names)
    own = match.name, match.pictures, match.stamp, match.field_key
    firsts = range(0, count, _CUT_FRAMES)
    parts = [CutUnit(*own, range(i, min(i + _CUT_FRAMES, count))) for i in firsts]
    pixels = PixelUnit(*own, range(count))
    cuts = yield [*parts, *([pixels] if match.field.pixels is None else [])]
    found = cuts.get(pixels.key)
    match = replace(match, pixels=found if isinstance(found, PixelAspect) else match.pixels)
    begins = sorted({n for own in cuts.values() if isinstance(own, list) for n in own})
    shots = [range(first, past) for first, past in pairwise([0, *begins, count])]
    if match.only is not None:
        shots = [shot for shot in shots if match.only in shot]
    pieces = _Pieces(match, [own for shot in shots for own in divide_shot(shot)])
    yield from pieces.follow(range(len(pieces.numbers)))
    for _ in range(_MOST_ROUNDS):
        if not (again := pieces.pass_on()):
            break
        yield from pieces.follow(again)
    lost = [
        i
        for i, found in enumerate(pieces.found)
        if not found.has_camera.any() and found.state[0] != SET_ASIDE
    ]
    places = find_positions(pieces.found) if lost else ()
    if places := places or match.known:
        for i in lost:
            pieces.units[i] = replace(pieces.units[i], known=places)
        yield from pieces.follow(lost)
    return pieces.joined()


def divide_shot(shot: range) -> list[range]:
    """Pieces of at most `PIECE_FRAMES`, equally long; neighbours share `OVERLAP_FRAMES`."""
    alone = len(shot) - OVERLAP_FRAMES
    count = max(math.ceil(alone / (PIECE_FRAMES - OVERLAP_FRAMES)), 1)
    firsts = [shot.start + round(i * alone / count) for i in range(count)]
    pasts = [*(first + OVERLAP_FRAMES for first in firsts[1:]), shot.stop]
    return [range(first, past) for first, past in zip(firsts, pasts, strict=True)]


class _Meeting(NamedTuple):
    """Where the next piece takes over.

    Attributes:
        number: of a frame that both have.
        px: between their cameras there; infinite where only one has any.
        agree: whether that is what either's paint leaves open.
        left_is_better: which of them knows better.
    """

    number: int
    px: float
    agree: bool
    left_is_better: bool


class _Pieces:
    """The pieces of a match, with what was found so far."""

    def __init__(self, match: MatchToTrack, numbers: list[range]) -> None:
        self.match = match
        self.numbers = numbers
        self.units = [match.unit(own) for own in numbers]
        self.found: list[PackedCameras] = []
        self._world = marking_points(match.field).world.T
        self._passed: set[tuple[int, int]] = set()  # receiver and giver

    def follow(self, which: Sequence[int]) -> Generator[Units, Results, None]:
        """Do some of the units; of those that were set aside all frames are lost."""
        results = yield [self.units[i] for i in which]
        self.found = self.found or [self._nothing(own, "") for own in self.numbers]
        for i in which:
            found = results[self.units[i].key]
            if isinstance(found, PackedCameras):
                self.found[i] = found
            elif not self.found[i].has_camera.any():
                self.found[i] = self._nothing(self.numbers[i], str(found))

    def _nothing(self, numbers: range, why: str) -> PackedCameras:
        names = self.match.names[numbers.start : numbers.stop]
        return PackedCameras.without_cameras(names, names[0], SET_ASIDE, why)

    def pass_on(self) -> list[int]:
        """Give pieces a camera of a neighbour that knows better, once; which these are."""
        again: set[int] = set()
        for i in range(len(self.numbers) - 1):
            meeting = self._meeting(i)
            if meeting is None or meeting.agree:
                continue
            giver, receiver = (i, i + 1) if meeting.left_is_better else (i + 1, i)
            camera = self._camera(giver, meeting.number)
            if camera is None or receiver in again or (receiver, giver) in self._passed:
                continue
            self._passed.add((receiver, giver))
            again.add(receiver)
            unit = self.units[receiver]
            anchors = {**unit.anchors, meeting.number: camera}
            self.units[receiver] = replace(unit, anchors=anchors)
        return sorted(again)

    def _meeting(self, i: int) -> _Meeting | None:
        """How a piece and the next one meet; None without a camera in any frame they share."""
        apart: dict[int, float] = {}
        alone: dict[bool, int] = {}  # the frame nearest to the other end, by whether of the left
        for number in self._shared(i):
            left, right = self._camera(i, number), self._camera(i + 1, number)
            if left is not None and right is not None:
                size = self.found[i].size[number - self.numbers[i].start]
                apart[number] = difference_px(left, right, size, self._world)
            elif left is not None:
                alone[True] = number
            elif right is not None:
                alone.setdefault(False, number)
        if apart:
            number = min(apart, key=lambda n: (apart[n], n))
            px = apart[number]
            known = [np.nan_to_num(f.coverage).mean() for f in self.found[i : i + 2]]
            return _Meeting(number, px, px <= self._open_px(i, number), bool(known[0] >= known[1]))
        if not alone:
            return None
        is_left = True in alone
        return _Meeting(alone[is_left], math.inf, False, is_left)

    def _shared(self, i: int) -> range:
        return range(self.numbers[i + 1].start, self.numbers[i].stop)

    def _camera(self, i: int, number: int) -> PinholeCamera | None:
        return self.found[i].pinhole(number - self.numbers[i].start)

    def _open_px(self, i: int, number: int) -> float:
        """How far apart the cameras of two pieces may be by what is left of their paint, px."""
        off = [self.found[j].residual_px[number - self.numbers[j].start] for j in (i, i + 1)]
        return max(_SAME_PX, float(np.nan_to_num(off).sum()))

    def joined(self) -> TrackedMatch:
        """The cameras of the match: of frames that two pieces share those of the first one up to
        where both agree best."""
        parts = list[PackedCameras]()
        jumps = dict[int, float]()
        begin = 0
        for i, (numbers, found) in enumerate(zip(self.numbers, self.found, strict=True)):
            begin, past = max(begin, numbers.start), numbers.stop
            if i + 1 < len(self.numbers) and (shared := self._shared(i)):
                meeting = self._meeting(i) or _Meeting(shared[len(shared) // 2], 0.0, True, False)
                past = meeting.number + meeting.left_is_better
                if not meeting.agree and math.isfinite(meeting.px):
                    jumps[past] = meeting.px
            rows = found.rows(range(begin - numbers.start, past - numbers.start))
            if parts and begin > numbers.start:  # of the shot that goes on
                before, first = parts[-1].shot[-1], self.match.names[numbers.start]
                shots = tuple(before if shot == first else shot for shot in rows.shot)
                rows = replace(rows, shot=shots)
            parts.append(rows)
            begin = past
        return TrackedMatch(PackedCameras.joined(parts), jumps)


def difference_px(
    one: PinholeCamera, other: PinholeCamera, size: FloatArray, world: FloatArray
) -> float:
    """Mean distance, px, between where two cameras show points of the field; NaN where the first
    one shows none in the picture.

    Args:
        size: (2,) width and height of the picture, px. world: (N, 3) points, metres.
    """
    here, shown = one.project(world)
    there, _ = other.project(world)
    seen = shown & ((here >= 0) & (here <= size - 1)).all(axis=1)
    return float(np.hypot(*(here - there)[seen].T).mean()) if seen.any() else math.nan


# A shot whose camera's place counts: that many frames, their lines on paint, known so well.
_LEAST_FRAMES, _LEAST_COVERAGE, _MOST_SD_M = 10, 0.65, 1.0
_APART_M, _WANDERS_M = 3.0, 0.5  # nearer ones are one place; farther apart in a shot it is none
_TRIPOD_SD_M = 0.7  # shots of one match give a tripod to about a metre
_MOST_POSITIONS = 4


def find_positions(parts: Sequence[PackedCameras]) -> tuple[KnownPosition, ...]:
    """The places from which shots were filmed, that of most frames first."""
    places: list[tuple[int, KnownPosition]] = []
    for part in parts:
        for _, rows in groupby(range(len(part)), key=part.shot.__getitem__):
            followed = [row for row in rows if part.state[row] == "followed"]
            if (place := _place_of(part, followed)) is not None:
                places.append((len(followed), place))
    found: list[KnownPosition] = []
    for _, place in sorted(places, key=lambda own: -own[0]):
        if all(np.linalg.norm(place.position_m - p.position_m) > _APART_M for p in found):
            found.append(place)
    return tuple(found[:_MOST_POSITIONS])


def _place_of(cameras: PackedCameras, rows: Sequence[int]) -> KnownPosition | None:
    """Where a shot was filmed from, if that is known and stays the same."""
    if len(rows) < _LEAST_FRAMES or np.median(cameras.coverage[rows]) < _LEAST_COVERAGE:
        return None
    middle = rows[len(rows) // 2]
    deviations = cameras.position_sd_m(middle)
    seen = cameras.camera[[rows[0], middle, rows[-1]], 3:6]
    if not deviations.max() <= _MOST_SD_M or np.ptp(seen, axis=0).max() > _WANDERS_M:
        return None
    return KnownPosition(seen[1], np.diag(deviations**2 + _TRIPOD_SD_M**2))
