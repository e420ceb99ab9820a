"""How far a band goes on to both sides: with the same step of colour to each flank, as wide.

What was found at one place is paint if it goes on as a band does: heads, letters, folds of a net
and shirts look like one for a few pixels.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from procc_annotator.field.appearance import BAR, EDGE
from procc_annotator.image.colour_step import fits
from procc_annotator.image.cuts import STEP_PX, FloatArray, Patch, Values
from procc_annotator.image.sought import Sought

REACH_PX = 24.0  # along, to either side
_EVERY_PX = 2.0
_ASIDE_PX = 4.0  # how far it may bend away
_TURN = 2  # steps across that it may move from one place to the next
_BESIDE = 0.75, 2.75  # px from the band's edge: where the ground is looked at
_LEAST_STEP = 10.0  # of 255
_SAME_STEP = 0.4  # of the step at the middle
_SAME_COLOUR = 0.8  # cosine
_STAYS = 0.1  # of the usual step: for less it does not move across
_BEGINS = 0, 4, -4  # places along
_NEAR = 5  # over so many places to either side its turn is measured

_ALONG = np.arange(-REACH_PX, REACH_PX + 0.1, _EVERY_PX)


@dataclass(frozen=True, slots=True)
class Course:
    """How far a band goes on without a gap, both ways together, px, and its turn against the
    direction in which it was followed, radians."""

    length_px: float
    turn: float


def follow(
    patch: Patch, angle: float, offset_px: float, width_px: float, sought: Sought
) -> Iterator[Course]:
    """Follow a band or an edge both ways.

    Args:
        patch: reaching `REACH_PX` farther than the band's place.
        angle: of the band, radians.
        offset_px: of its middle from the patch's position, across.
        width_px: of the band; 0 of an edge.
        sought: whether its colour fits, and whether its grounds may change.

    Returns:
        How far it goes on from its middle, then from ahead and from back of it: at an end another
        line lies in its ground. Nothing where it does not stand out, or has another colour.
    """
    x, y = patch.centre
    place = x - offset_px * math.sin(angle), y + offset_px * math.cos(angle)
    left, right = _steps(Patch(patch.pixels, place), angle, width_px)
    if sought.looks.kind == EDGE:
        left = right = left - right  # from one side to the other
    middle = len(left) // 2
    for begin in _BEGINS:
        course = _course(left, right, middle + begin, sought)
        if course is not None:
            yield course


def _course(left: Values, right: Values, begin: int, sought: Sought) -> Course | None:
    """From a place along, with the steps of colour there for the usual ones."""
    here, around = left.shape[1] // 2, slice(begin - 1, begin + 2)
    usual = (left[around, here] + right[around, here]).mean(axis=0) / 2
    size = math.sqrt(float(usual @ usual))
    if size < _LEAST_STEP or not (sought.looks.kind == EDGE or fits(usual, sought)):
        return None
    bar = sought.looks.kind == BAR
    shares = _shares(left, right, usual / size, around, here, bar=bar)
    if shares is None:
        return None
    ahead, back = _walk(shares[begin:], here), _walk(shares[begin::-1], here)
    first, last = back[: _NEAR + 1], ahead[: _NEAR + 1]
    across, along = (last[-1] - first[-1]) * STEP_PX, (len(first) + len(last) - 2) * _EVERY_PX
    turn = math.atan2(across, along) if along else 0.0
    return Course(_EVERY_PX * (len(ahead) + len(back) - 1), turn)


def _steps(patch: Patch, angle: float, width_px: float) -> tuple[Values, Values]:
    """(n, m, 3) steps of colour from the left and the right ground to the band, at places along
    and offsets across."""
    near, far = (width_px / 2 + beside for beside in _BESIDE)
    inner = max(0.5, 0.3 * width_px)
    half = math.ceil((far + _ASIDE_PX) / STEP_PX) + 1
    across = np.arange(-half, half + 1, dtype=np.float64) * STEP_PX
    cuts = patch.cuts(np.array([angle]), _ALONG, across)[0]
    sums = np.cumsum((cuts[:-2] + cuts[1:-1] + cuts[2:]) / 3, axis=1)
    aside = round(_ASIDE_PX / STEP_PX)
    first, past = half - aside, half + aside + 1

    def mean(begin_px: float, end_px: float) -> Values:
        before, last = round(begin_px / STEP_PX) - 1, round(end_px / STEP_PX)
        whole = sums[:, first + last : past + last] - sums[:, first + before : past + before]
        return np.asarray(whole / (last - before), dtype=np.float32)

    band = mean(-inner, inner)
    return band - mean(-far, -near), band - mean(near, far)


def _shares(
    left: Values, right: Values, direction: Values, around: slice, here: int, *, bar: bool
) -> FloatArray | None:
    """(n, m) how much of the usual step there is; 0 where the colour is another one."""
    on_left, on_right = left @ direction, right @ direction
    usual = [sorted(side[around, here].tolist())[1] for side in (on_left, on_right)]
    if bar:
        # Either side may be as bright as the bar for a while, never both.
        shares = np.maximum(on_left, on_right) / max(usual)
    else:
        if min(usual) < _LEAST_STEP / 2:
            return None
        shares = np.minimum(on_left / usual[0], on_right / usual[1])
    both = (left + right) / 2
    lengths = np.sqrt((both * both).sum(axis=-1)) + 1e-6
    alike = (on_left + on_right) / 2 >= _SAME_COLOUR * lengths
    return np.where(alike, shares, 0.0)


def _walk(shares: FloatArray, here: int) -> list[int]:
    """Where a band is at each place from the first one on, while it goes on, bending a little."""
    last = shares.shape[1] - 1
    walked = [here]
    for row in shares[1:]:
        low, high = max(0, here - _TURN), min(last, here + _TURN) + 1
        best = low + int(row[low:high].argmax())
        if row[best] < _SAME_STEP:
            break
        if row[here] < row[best] - _STAYS:
            here = best
        walked.append(here)
    return walked
