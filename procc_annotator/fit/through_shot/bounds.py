"""Where the shot of a frame begins and ends."""

from __future__ import annotations

from collections.abc import Callable

from procc_annotator.fit.through_shot.reading import ReadFrame, decoded_frames


def shot_range_around(
    frame: ReadFrame, number: int, numbers: range, go_on: Callable[[], None] = lambda: None
) -> range:
    """The frames around one that are of the same camera, up to the cuts.

    Args:
        frame: number -> (H, W, 4) BGRA.
        number: one of the numbers.
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
