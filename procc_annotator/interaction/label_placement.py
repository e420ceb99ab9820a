"""Placement of labels without overlap."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from procc_annotator.interaction.overlay_primitives import Box

_STEPS = 8  # heights of a text that it may be moved up or down


def place_apart(box: Box, taken: Sequence[Box], room: Box) -> Box:
    """The place nearest to where a text would go (left, top, right, bottom) that no text taken
    covers, and that is in sight in the room there is; ``box`` itself where there is no better
    one."""
    return next((b for b in _around(box) if within(b, room) and not covers(b, taken)), box)


def _around(box: Box) -> Iterator[Box]:
    left, top, right, bottom = box
    wide, high = right - left, bottom - top
    for aside in (0.0, wide, -wide):
        for step in range(_STEPS + 1):
            for sign in (-1, 1) if step else (1,):
                x, y = left + aside, top + sign * step * high
                yield x, y, x + wide, y + high


def within(box: Box, room: Box) -> bool:
    """Return whether a box lies in another one."""
    return box[0] >= room[0] and box[1] >= room[1] and box[2] <= room[2] and box[3] <= room[3]


def covers(box: Box, taken: Sequence[Box]) -> bool:
    """Return whether a box overlaps one of others."""
    return any(
        box[0] < other[2] and box[2] > other[0] and box[1] < other[3] and box[3] > other[1]
        for other in taken
    )
