"""Read frames in tracking order, decoded ahead, with scene cuts."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import takewhile

import numpy as np

from procc_annotator.calibration.tracking.motion_model import (
    EMPTY_MOTION_IMAGE,
    MotionImage,
    motion_image,
)
from procc_annotator.image.motion import (
    FrameSignature,
    cut_indices,
    frame_signature,
    signature_distance,
)
from procc_annotator.image.pixels import PixelArray

ReadFrame = Callable[[int], PixelArray]

_READ_AHEAD_FRAMES = 3
_CUT_WINDOW = 6  # frames to either side that a cut stands out of, see `image.motion`


@dataclass(frozen=True, eq=False)
class DecodedFrame:
    """A frame as it is given out.

    Attributes:
        picture: (H, W, 4) BGRA.
        small: the picture much reduced; nothing of it if it is not to be followed.
        begins: whether it comes from another camera than the one given out before it.
        unlike: how different it looks from that one, see `image.motion.look_difference`.
    """

    number: int
    picture: PixelArray
    small: MotionImage
    begins: bool = False
    unlike: float = 0.0


@dataclass(eq=False)
class _PendingFrame:
    """A frame that waits until it is known whether it begins a shot."""

    number: int
    picture: PixelArray
    small: MotionImage
    look: FrameSignature
    step: float
    lasting: float


def decoded_frames(
    frame: ReadFrame, numbers: Sequence[int], *, to_follow: bool = False
) -> Iterator[DecodedFrame]:
    """Frames in the order of their numbers, ascending or descending, decoded by a thread.

    Args:
        frame: number -> (H, W, 4) BGRA; may raise, which is passed on.
        numbers: of consecutive frames.
        to_follow: whether a camera is to be followed through them.
    """
    held: deque[_PendingFrame] = deque()
    done: deque[tuple[float, float]] = deque(maxlen=_CUT_WINDOW)
    looks: deque[FrameSignature] = deque(maxlen=4)
    for number, picture, small, look in _read_ahead(frame, numbers, to_follow):
        step = signature_distance(looks[-1], look) if looks else 0.0
        past = list(looks)[-3:-1]
        looks.append(look)
        lasting = min((signature_distance(old, look) for old in past), default=1.0)
        if len(looks) == 4 and len(held) >= 2:  # small also where a flash begins
            held[-2].lasting = min(held[-2].lasting, signature_distance(looks[0], look))
        held.append(_PendingFrame(number, picture, small, look, step, lasting))
        if len(held) > _CUT_WINDOW:
            yield _emit_frame(held, done)
    while held:
        yield _emit_frame(held, done)


def _emit_frame(held: deque[_PendingFrame], done: deque[tuple[float, float]]) -> DecodedFrame:
    steps = np.array([*(s for s, _ in done), *(h.step for h in held)])
    lasting = np.array([*(v for _, v in done), *(h.lasting for h in held)])
    begins = bool(done) and len(done) in cut_indices(steps, lasting)
    first = held.popleft()
    done.append((first.step, first.lasting))
    return DecodedFrame(first.number, first.picture, first.small, begins, first.step)


def _read_ahead(
    frame: ReadFrame, numbers: Sequence[int], to_follow: bool
) -> Iterator[tuple[int, PixelArray, MotionImage, FrameSignature]]:
    """Return what a thread has read ahead, in the order asked for."""
    stopped = threading.Event()

    def read(number: int) -> tuple[int, PixelArray, MotionImage, FrameSignature]:
        picture = frame(number)
        small = motion_image(picture) if to_follow else EMPTY_MOTION_IMAGE
        return number, picture, small, frame_signature(picture[:, :, :3])

    frames = map(read, takewhile(lambda _: not stopped.is_set(), numbers))
    with ThreadPoolExecutor(1, "frames ahead") as reader:
        try:
            ahead = deque(reader.submit(next, frames, None) for _ in range(_READ_AHEAD_FRAMES))
            while (item := ahead.popleft().result()) is not None:
                ahead.append(reader.submit(next, frames, None))
                yield item
        finally:
            stopped.set()
            reader.shutdown(cancel_futures=True)


def shot_range_around(
    frame: ReadFrame, number: int, numbers: range, go_on: Callable[[], None] = lambda: None
) -> range:
    """The frames around one that are of the same camera, up to the cuts.

    Args:
        frame: number -> (H, W, 4) BGRA.
        numbers: all there are, ascending.
        go_on: called at least once a frame; what it raises ends everything.
    """
    last = _shot_end(frame, range(number, numbers[-1] + 1), go_on)
    first = _shot_end(frame, range(number, numbers[0] - 1, -1), go_on)
    return range(first, last + 1)


def _shot_end(frame: ReadFrame, numbers: range, go_on: Callable[[], None]) -> int:
    """The last frame before another camera's."""
    last = numbers[0]
    for now in decoded_frames(frame, numbers):
        go_on()
        if now.begins:
            break
        last = now.number
    return last
