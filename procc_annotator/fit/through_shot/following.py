"""A run of frames followed from one whose camera is known, until a cut, or until it is lost."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.on_paint.belief import Belief
from procc_annotator.fit.on_paint.painted import Painted
from procc_annotator.fit.on_paint.result import Worth
from procc_annotator.fit.solving.observations import PictureFrame
from procc_annotator.fit.through_shot.reading import Glimpse, ReadFrame, glimpses
from procc_annotator.fit.through_shot.stand import TRIPOD, ShotStand
from procc_annotator.fit.through_shot.stepping import Stepped, foretold, stepped
from procc_annotator.fit.through_shot.turning import OWN, Turn, turn_between

_FIRST_WORTH = Worth(0.4, 5.0)
_LOST_PX = 40.0  # solver px: who knows no better where lines are has lost them
_SAME_CAMERA = 0.5  # coverage from which on a picture that looks different is no cut
# So different looks a picture of which nothing can be followed if it comes from another camera: at
# least, and against the frames before it.
_OTHER_CAMERA, _TIMES_USUAL, _BEFORE = 0.015, 2.5, 12
_BLIND = 8  # frames that a flash or a hand before the lens may last


@dataclass(frozen=True, eq=False)
class Followed:
    """Frames in the order they were followed.

    Attributes:
        asked: numbers that were to be followed.
        numbers: of those that were.
        steps: of each.
        cut: whether another camera's picture ended it.
    """

    asked: Sequence[int]
    numbers: tuple[int, ...]
    steps: Sequence[Stepped]
    cut: bool

    def until(self, number: int) -> Followed:
        """The first of them, up to a frame and with it."""
        count = self.numbers.index(number) + 1
        return Followed(self.asked, self.numbers[:count], self.steps[:count], False)


def follow(
    frame: ReadFrame,
    numbers: Sequence[int],
    start: Belief,
    painted: Painted,
    picture_frame: PictureFrame,
    on_step: Callable[[int, Stepped], None],
    go_on: Callable[[], None],
    stand: ShotStand = TRIPOD,
) -> Followed:
    """Follow a camera from frame to frame.

    Args:
        frame: number -> picture.
        numbers: consecutive ones, ascending or descending; of the first the camera is known.
        start: what is believed of that.
        painted: the field's paint.
        picture_frame: the pictures.
        on_step: told of every frame as it is followed.
        go_on: called between frames; what it raises ends it.
        stand: what the camera stands on.
    """
    done, steps = list[int](), list[Stepped]()
    last: deque[Stepped] = deque(maxlen=2)
    before: Glimpse | None = None
    unlike: deque[float] = deque(maxlen=_BEFORE)
    cut, broken = False, 0  # for certain; frames since it seemed so, without paint
    for now in glimpses(frame, numbers, to_follow=True):
        go_on()
        step = _next(last, before, now, start, painted, picture_frame, stand)
        if now.begins and (step.marks is None or step.coverage < _SAME_CAMERA):
            cut = True
            break
        if step.marks is not None:
            broken = 0
        elif broken or (step.turn is None and _breaks(now, unlike)):
            broken += 1
        unlike.append(now.unlike)
        if broken > _BLIND or (step.marks is None and step.sd_px > _LOST_PX and done):
            break
        done.append(now.number)
        steps.append(step)
        last.append(step)
        on_step(now.number, step)
        before = now
    cut = cut or broken > 0
    while len(done) > 1 and _guessed(steps[-1], cut):
        done.pop()
        steps.pop()
    return Followed(numbers, tuple(done), steps, cut)


def _guessed(last: Stepped, cut: bool) -> bool:
    """Whether nothing confirms the last frame before a cut, or before it was lost."""
    return last.marks is None and (cut or last.turn is None)


def _breaks(now: Glimpse, before: Sequence[float]) -> bool:
    """Whether a frame differs from the one before it as those before it did not."""
    usual = float(np.median(before)) if before else 0.0
    return now.unlike > max(_OTHER_CAMERA, _TIMES_USUAL * usual)


def _next(
    done: Sequence[Stepped],
    before: Glimpse | None,
    now: Glimpse,
    start: Belief,
    painted: Painted,
    frame: PictureFrame,
    stand: ShotStand,
) -> Stepped:
    if before is None:
        return stepped(now.picture, start, None, painted, frame, _FIRST_WORTH)
    last = done[-1]
    expected = np.zeros(len(OWN))
    if len(done) > 1:
        expected = last.belief.vector[OWN] - done[-2].belief.vector[OWN]
    turn: Turn | None = turn_between(before.small, now.small, last.belief.vector, expected, frame)
    believed = foretold(last.belief, turn, expected, stand)
    return stepped(now.picture, believed, turn, painted, frame, last.worth)
