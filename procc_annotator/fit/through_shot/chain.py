"""Frames that were followed one from the other, in the order of their numbers, to be smoothed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from procc_annotator.fit.on_paint.belief import GaussianState
from procc_annotator.fit.through_shot.following import TrackedRun
from procc_annotator.fit.through_shot.stepping import FilterStep
from procc_annotator.fit.through_shot.turning import InterFrameMotion


@dataclass(frozen=True, eq=False)
class FrameChain:
    """K frames of one shot.

    Attributes:
        numbers: ascending.
        steps: where following left each frame.
        turns: (K - 1,) how the camera moved from each frame to the next; None where nothing tells.
        given: place in the chain -> what is believed of that frame's camera by itself.
    """

    numbers: tuple[int, ...]
    steps: Sequence[FilterStep]
    turns: tuple[InterFrameMotion | None, ...]
    given: Mapping[int, GaussianState]


def build_chain(runs: Sequence[TrackedRun], given: Mapping[int, GaussianState]) -> FrameChain:
    """The chain of frames that were followed, in either direction, from frames they share or up to
    frames beside each other.

    Args:
        runs: what was followed.
        given: number -> what is believed of its camera, of frames that were given one.
    """
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
