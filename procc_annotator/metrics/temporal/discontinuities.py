"""Jumps, outages and the frame offset of the cameras of a shot."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray, IntArray, true_runs
from procc_annotator.camera.base import Camera
from procc_annotator.metrics.temporal.jitter import (
    SECOND_DIFFERENCE_SCALE,
    ShotJitter,
    typical_frame_step,
)

# A leap: what is off by so many px, and so many times as much as is usual in the shot.
MIN_JUMP_PX = 3.0
_JUMP_RATIO = 8.0
_LOOKAHEAD_FRAMES = 50  # frames within which a camera that leapt may be back
_GROWTH_PER_FRAME = 0.1  # of the limit, for what nobody can foretell


@dataclass(frozen=True)
class Jump:
    """A camera that leaps from one frame to the next.

    Attributes:
        frame: place in the shot of the first frame that is off.
        size_px: how far off the field's points lie then, root mean square.
        back_after: frames until it is back where it would have been; None if it stays.
    """

    frame: int
    size_px: float
    back_after: int | None


@dataclass(frozen=True)
class Outage:
    """Frames one after the other without a camera.

    Attributes:
        frame: place in the shot of the first of them.
        back_after: frames from the first one until there is a camera that moves steadily; None
            where the shot ends before.
    """

    frame: int
    length: int
    back_after: int | None


@dataclass(frozen=True, eq=False)
class Discontinuities:
    """Of one shot.

    Attributes:
        jumps, outages: in the order of the frames.
        unsteady: (n,) frames whose second difference belongs to a jump.
        limit_px: from which second difference on a frame is off, as the error of one frame.
    """

    jumps: tuple[Jump, ...]
    outages: tuple[Outage, ...]
    unsteady: BoolArray
    limit_px: float


def find_discontinuities(
    cameras: Sequence[Camera | None],
    numbers: Sequence[int],
    points_world: FloatArray,
    size: tuple[int, int],
    steady: ShotJitter,
) -> Discontinuities:
    """Find the jumps and the outages of a shot.

    Args:
        cameras: (n,) in px of ``size``, None for a frame without one.
        numbers: (n,) of the frames, ascending.
        points_world: (P, 3) metres that are examined.
        size: (width, height) px.
        steady: of the same cameras.
    """
    known = steady.px[np.isfinite(steady.px)]
    usual = float(np.median(known)) if len(known) else 0.0
    limit = max(MIN_JUMP_PX, _JUMP_RATIO * usual)
    with np.errstate(invalid="ignore"):
        unsteady = steady.px > limit
    gone = np.array([camera is None for camera in cameras], dtype=bool)
    shot = _ShotProjections(cameras, numbers, points_world, size, limit)
    return Discontinuities(
        _find_jumps(shot, [(a, b - 1) for a, b in true_runs(unsteady)], steady),
        _find_outages(gone, unsteady),
        unsteady,
        limit,
    )


def _find_outages(gone: BoolArray, unsteady: BoolArray) -> tuple[Outage, ...]:
    found = []
    for first, past in true_runs(gone):
        back = next((i for i in range(past, len(gone)) if not gone[i] and not unsteady[i]), None)
        found.append(Outage(first, past - first, None if back is None else back - first))
    return tuple(found)


@dataclass(frozen=True, eq=False)
class _ShotProjections:
    cameras: Sequence[Camera | None]
    numbers: Sequence[int]
    points_world: FloatArray
    size: tuple[int, int]
    limit_px: float

    def off_px(self, before: int, after: int) -> float:
        """Return how far frame ``after`` lies from where the steps around lead from ``before``, px,
        as the error of one frame; infinite if undecidable."""
        steps = [(before - 1, before), (after, after + 1)]
        around = [s for s in steps if s[0] >= 0 and s[1] < len(self.cameras) and self._follow(*s)]
        a, b = self._shown(before), self._shown(after)
        if a is None or b is None or not around:
            return float("inf")
        speeds = [self._moved(*step) for step in around]
        count = (self.numbers[after] - self.numbers[before]) / typical_frame_step(self.numbers)
        inside = ((a >= 0) & (a <= np.array(self.size) - 1)).all(axis=1)
        off = (b - a - count * np.mean(speeds, axis=0))[inside]
        squares = (off**2).sum(axis=1)
        squares = squares[np.isfinite(squares)]
        return (
            float(np.sqrt(squares.mean())) / SECOND_DIFFERENCE_SCALE
            if len(squares)
            else float("inf")
        )

    def _follow(self, one: int, other: int) -> bool:
        return (
            self.numbers[other] - self.numbers[one] == typical_frame_step(self.numbers)
            and self.cameras[one] is not None
            and self.cameras[other] is not None
        )

    def _moved(self, one: int, other: int) -> FloatArray:
        a, b = self._shown(one), self._shown(other)
        assert a is not None  # they follow each other
        assert b is not None
        return b - a

    def _shown(self, at: int) -> FloatArray | None:
        camera = self.cameras[at]
        if camera is None:
            return None
        px, valid = camera.project(self.points_world)
        return np.where(valid[:, None], px, np.nan)


def _find_jumps(
    shot: _ShotProjections, runs: list[tuple[int, int]], steady: ShotJitter
) -> tuple[Jump, ...]:
    """Each run of unsteady frames begins and ends next to a leap; two may be one there and back."""
    found = []
    number = 0
    while number < len(runs):
        before = runs[number][0]
        largest = (
            float(np.nanmax(steady.px[before : runs[number][1] + 1])) * SECOND_DIFFERENCE_SCALE
        )
        back = None
        following = number + 1
        for later in range(number, len(runs)):
            after = runs[later][1]
            if after - before > _LOOKAHEAD_FRAMES:
                break
            if after - before < 2:
                continue  # a single step: nothing between that could have been off
            allowed = shot.limit_px * (1 + _GROWTH_PER_FRAME * (after - before))
            if shot.off_px(before, after) <= allowed:
                back, following = after - before - 1, later + 1
                break
        # There and back in one frame bends the course twice as much as a step does.
        size = largest / 2 if back == 1 else largest
        found.append(Jump(before + 1, size, back))
        number = following
    return tuple(found)


MAX_SHIFT = 5
MIN_FRAMES = 3
_MIN_MARGIN_SE = 3.0  # standard errors by which the best shift is better than any other
_MIN_MARGIN_PX = 0.05


@dataclass(frozen=True)
class FrameOffset:
    """Of one shot.

    Attributes:
        shift: frames; 1: the camera filed one frame later fits, cameras are one frame late.
        cost_px: mean over the frames at that shift, and ``cost_as_is_px`` without a shift.
        margin_px: by how much the next best shift is worse, and ``margin_se_px`` its standard
            error over frames.
        frames: that have a camera at every shift.
        costs_px: (2 K + 1,) at the shifts from -K to K.
    """

    shift: int
    cost_px: float
    cost_as_is_px: float
    margin_px: float
    margin_se_px: float
    frames: int
    costs_px: tuple[float, ...]

    @property
    def is_sure(self) -> bool:
        """Return whether no other shift could be the right one: never where nothing moves."""
        least = max(_MIN_MARGIN_PX, _MIN_MARGIN_SE * self.margin_se_px)
        return self.frames >= MIN_FRAMES and self.margin_px > least

    @property
    def in_words(self) -> str:
        """``cameras are 1 frame late``, for people."""
        if not self.is_sure:
            return "not determined"
        if self.shift == 0:
            return "none"
        frames = f"{abs(self.shift)} frame" + ("" if abs(self.shift) == 1 else "s")
        return f"cameras are {frames} {'late' if self.shift > 0 else 'early'}"


def shift_range() -> IntArray:
    """(2 K + 1,) from -K to K, K being `MAX_SHIFT`."""
    return np.arange(-MAX_SHIFT, MAX_SHIFT + 1)


def frame_offset(costs_px: FloatArray) -> FrameOffset | None:
    """The shift at which a shot fits best, by costs (F, 2 K + 1) of each frame at each shift, px,
    NaN where there is no camera; None where fewer than three frames have one at every shift.
    Shifts at the ends that would leave hardly any frame are not tried."""
    half = costs_px.shape[1] // 2
    for largest in range(half, 0, -1):
        table = costs_px[:, half - largest : half + largest + 1]
        whole = table[np.isfinite(table).all(axis=1)]
        if len(whole) >= max(MIN_FRAMES, len(costs_px) // 2):
            return _best_shift(whole, largest)
    return None


def _best_shift(table: FloatArray, largest: int) -> FrameOffset:
    mean = table.mean(axis=0)
    best = int(mean.argmin())
    worse = table - table[:, best : best + 1]
    margins = worse.mean(axis=0)
    margins[best] = np.inf
    next_best = int(margins.argmin())
    spread = float(worse[:, next_best].std(ddof=1)) if len(table) > 1 else math.inf
    return FrameOffset(
        shift=best - largest,
        cost_px=float(mean[best]),
        cost_as_is_px=float(mean[largest]),
        margin_px=float(margins[next_best]),
        margin_se_px=spread / math.sqrt(len(table)),
        frames=len(table),
        costs_px=tuple(mean.tolist()),
    )
