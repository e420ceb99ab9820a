"""Track a run of frames from a known one until a cut or until lost; chains of such runs."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.line_alignment.expected_lines import MarkingPoints
from procc_annotator.calibration.line_alignment.gaussian_state import EdgeNoiseModel, GaussianState
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.tracking.filter_step import FilterStep, filter_step, predict_state
from procc_annotator.calibration.tracking.frame_reader import (
    DecodedFrame,
    ReadFrame,
    decoded_frames,
)
from procc_annotator.calibration.tracking.motion_model import (
    MOTION_PARAMETERS,
    TRIPOD_NOISE,
    InterFrameMotion,
    ProcessNoise,
    estimate_inter_frame_motion,
)

_INITIAL_NOISE = EdgeNoiseModel(0.4, 5.0)
_LOST_SD_PX = 40.0  # solver px: who knows no better where lines are has lost them
_SAME_SHOT_COVERAGE = 0.5  # coverage from which on a picture that looks different is no cut
# So different looks a picture of which nothing can be followed if it comes from another camera: at
# least, and against the frames before it.
_CUT_DIFFERENCE, _CUT_RATIO, _CUT_HISTORY = 0.015, 2.5, 12
_MAX_UNMEASURED_FRAMES = 8  # frames that a flash or a hand before the lens may last


@dataclass(frozen=True, eq=False)
class TrackedRun:
    """Frames in the order they were followed.

    Attributes:
        asked: numbers that were to be followed.
        numbers: of those that were.
        cut: whether another camera's picture ended it.
    """

    asked: Sequence[int]
    numbers: tuple[int, ...]
    steps: Sequence[FilterStep]
    cut: bool

    def until(self, number: int) -> TrackedRun:
        """The first of them, up to a frame and with it."""
        count = self.numbers.index(number) + 1
        return TrackedRun(self.asked, self.numbers[:count], self.steps[:count], False)


def track_run(
    frame: ReadFrame,
    numbers: Sequence[int],
    start: GaussianState,
    painted: MarkingPoints,
    picture_frame: ImageFrame,
    on_step: Callable[[int, FilterStep], None],
    go_on: Callable[[], None],
    stand: ProcessNoise = TRIPOD_NOISE,
) -> TrackedRun:
    """Follow a camera from frame to frame.

    Args:
        numbers: consecutive ones, ascending or descending; of the first the camera is known.
        start: what is believed of that.
        on_step: called for every frame as it is followed.
        go_on: called between frames; what it raises ends it.
    """
    done, steps = list[int](), list[FilterStep]()
    last: deque[FilterStep] = deque(maxlen=2)
    before: DecodedFrame | None = None
    unlike: deque[float] = deque(maxlen=_CUT_HISTORY)
    cut, broken = False, 0  # for certain; frames since it seemed so, without paint
    for now in decoded_frames(frame, numbers, to_follow=True):
        go_on()
        step = _next_step(last, before, now, start, painted, picture_frame, stand)
        if now.begins and (step.marks is None or step.coverage < _SAME_SHOT_COVERAGE):
            cut = True
            break
        if step.marks is not None:
            broken = 0
        elif broken or (step.turn is None and _is_unseen_cut(now, unlike)):
            broken += 1
        unlike.append(now.unlike)
        if broken > _MAX_UNMEASURED_FRAMES or (
            step.marks is None and step.sd_px > _LOST_SD_PX and done
        ):
            break
        done.append(now.number)
        steps.append(step)
        last.append(step)
        on_step(now.number, step)
        before = now
    cut = cut or broken > 0
    while len(done) > 1 and _is_unconfirmed(steps[-1], cut):
        done.pop()
        steps.pop()
    return TrackedRun(numbers, tuple(done), steps, cut)


def _is_unconfirmed(last: FilterStep, cut: bool) -> bool:
    """Return whether nothing confirms the last frame before a cut, or before it was lost."""
    return last.marks is None and (cut or last.turn is None)


def _is_unseen_cut(now: DecodedFrame, before: Sequence[float]) -> bool:
    """Return whether a frame differs from the one before it as those before it did not."""
    usual = float(np.median(before)) if before else 0.0
    return now.unlike > max(_CUT_DIFFERENCE, _CUT_RATIO * usual)


def _next_step(
    done: Sequence[FilterStep],
    before: DecodedFrame | None,
    now: DecodedFrame,
    start: GaussianState,
    painted: MarkingPoints,
    frame: ImageFrame,
    stand: ProcessNoise,
) -> FilterStep:
    if before is None:
        return filter_step(now.picture, start, None, painted, frame, _INITIAL_NOISE)
    last = done[-1]
    expected = np.zeros(len(MOTION_PARAMETERS))
    if len(done) > 1:
        expected = last.belief.vector[MOTION_PARAMETERS] - done[-2].belief.vector[MOTION_PARAMETERS]
    turn: InterFrameMotion | None = estimate_inter_frame_motion(
        before.small, now.small, last.belief.vector, expected, frame
    )
    believed = predict_state(last.belief, turn, expected, stand)
    return filter_step(now.picture, believed, turn, painted, frame, last.worth)


@dataclass(frozen=True, eq=False)
class FrameChain:
    """K frames of one shot.

    Attributes:
        numbers: ascending.
        steps: where following left each frame.
        turns: (K - 1,) how the camera moved from each frame to the next; None where nothing
            decides.
        given: place in the chain -> what is believed of that frame's camera by itself.
    """

    numbers: tuple[int, ...]
    steps: Sequence[FilterStep]
    turns: tuple[InterFrameMotion | None, ...]
    given: Mapping[int, GaussianState]


def build_chain(runs: Sequence[TrackedRun], given: Mapping[int, GaussianState]) -> FrameChain:
    """The chain of frames that were followed, in either direction, from frames they share or up to
    frames next to each other; ``given``: number -> state of the frames that were given a camera."""
    steps: dict[int, FilterStep] = {}
    turns: dict[int, InterFrameMotion | None] = {}
    for run in runs:
        before: int | None = None
        for number, step in zip(run.numbers, run.steps, strict=True):
            # Of a frame that one run ends at and another one begins with, the end knows more.
            steps[number] = step
            if before is None:
                pass
            elif before < number:
                turns[before] = step.turn
            else:
                turns[number] = None if step.turn is None else step.turn.backwards()
            before = number
    numbers = tuple(sorted(steps))
    return FrameChain(
        numbers,
        [steps[n] for n in numbers],
        tuple(turns.get(n) for n in numbers[:-1]),
        {place: given[n] for place, n in enumerate(numbers) if n in given},
    )


def neighbour_vector(chain: FrameChain, place: int, way: int) -> FloatArray | None:
    """Return the camera (11,) of a frame by the one before (-1) or after it (1) and the motion
    between both; None without either."""
    if not 0 <= place + way < len(chain.numbers):
        return None
    turn = chain.turns[place if way > 0 else place - 1]
    if turn is None:
        return None
    vector = chain.steps[place + way].belief.vector.copy()
    vector[MOTION_PARAMETERS] -= way * turn.step
    return vector
