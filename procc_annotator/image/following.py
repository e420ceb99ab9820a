"""How far a band goes on to both sides: with the same step of colour to each flank, as wide.

What was found at one place is paint if it goes on as a band does: heads, letters, folds of a net
and shirts look like one for a few pixels.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np

from procc_annotator.field.appearance import ANY, BAR, EDGE
from procc_annotator.image.colour_step import matches_colour_step
from procc_annotator.image.cuts import STEP_PX, ImagePatch, Values
from procc_annotator.image.sought import LineTarget

MAX_TRACE_PX = 24.0  # along, to either side
_STEP_ALONG_PX = 2.0
_SEARCH_ASIDE_PX = 4.0  # how far it may bend away
_MAX_TURN_STEPS = 2  # steps across that it may move from one place to the next
_FLANK_RANGE = 0.75, 2.75  # px from the band's edge: where the ground is looked at
_MIN_COLOUR_STEP = 10.0  # of 255
_SAME_STEP_RATIO = 0.4  # of the step at the middle
_STRONGER_STEP_RATIO = 1.8  # ... where paint may be lighter or darker: another band's
_SAME_COLOUR = 0.8  # cosine
_SMOOTHNESS_PENALTY = 0.1  # of the usual step: for less it does not move across
_START_OFFSETS = 0, 4, -4  # places along
_REFERENCE_SAMPLES = 5  # over so many places to either side its turn is measured


@dataclass(frozen=True, slots=True)
class LineExtent:
    """How far a band goes on without a gap.

    Attributes:
        length_px: both ways together.
        turn: of it against the direction in which it was followed, radians.
        begin_px: where along that direction it was begun.
    """

    length_px: float
    turn: float
    start_px: float


def trace_line(
    patch: ImagePatch, angle: float, offset_px: float, width_px: float, sought: LineTarget
) -> Iterator[LineExtent]:
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
    left, right = _colour_steps_along(patch.across(angle, offset_px), angle, width_px)
    if sought.looks.kind == EDGE:
        left = right = left - right  # from one side to the other
    middle = len(left) // 2
    for begin in _START_OFFSETS:
        course = _extent_from(left, right, middle + begin, sought)
        if course is not None:
            yield course


def _extent_from(left: Values, right: Values, begin: int, sought: LineTarget) -> LineExtent | None:
    """From a place along, with the steps of colour there for the usual ones."""
    here, around = left.shape[1] // 2, slice(begin - 1, begin + 2)
    usual = (left[around, here] + right[around, here]).sum(axis=0) / 6
    size = math.sqrt(float(usual @ usual))
    if size < _MIN_COLOUR_STEP or not (sought.looks.kind == EDGE or matches_colour_step(usual[None], sought)[0]):
        return None
    bar = sought.looks.kind == BAR
    found = _step_ratios(left, right, usual / size, around, here, bar=bar)
    if found is None:
        return None
    if sought.looks.tone == ANY:
        found[found > _STRONGER_STEP_RATIO] = 0.0
    shares = found.tolist()
    ahead, back = _track_band(shares[begin:], here), _track_band(shares[begin::-1], here)
    first, last = back[: _REFERENCE_SAMPLES + 1], ahead[: _REFERENCE_SAMPLES + 1]
    across, along = (last[-1] - first[-1]) * STEP_PX, (len(first) + len(last) - 2) * _STEP_ALONG_PX
    turn = math.atan2(across, along) if along else 0.0
    length = _STEP_ALONG_PX * (len(ahead) + len(back) - 1)
    return LineExtent(length, turn, _STEP_ALONG_PX * (begin - len(left) // 2))


def _colour_steps_along(patch: ImagePatch, angle: float, width_px: float) -> tuple[Values, Values]:
    """(n, m, 4) steps of colour from the left and the right ground to the band, at places along
    and offsets across."""
    near, far = (round((width_px / 2 + beside) / STEP_PX) for beside in _FLANK_RANGE)
    inner = round(max(0.5, 0.3 * width_px) / STEP_PX)
    aside = round(_SEARCH_ASIDE_PX / STEP_PX)
    half = far + aside + 1
    cuts = patch.cuts([angle], MAX_TRACE_PX, _STEP_ALONG_PX, half)[:, 0]

    def means(samples: int) -> Values:
        """Of so many samples across and three cuts along."""
        whole = cv2.boxFilter(cuts, cv2.CV_32F, (samples, 3))
        return np.asarray(whole[1:-1], dtype=np.float32)

    band, ground = means(2 * inner + 1), means(far - near + 1)
    anchor = (far - near + 1) // 2
    first, past = half - aside, half + aside + 1
    on_left, on_right = anchor - far, anchor + near
    here = band[:, first:past]
    return (
        here - ground[:, first + on_left : past + on_left],
        here - ground[:, first + on_right : past + on_right],
    )


def _step_ratios(
    left: Values, right: Values, direction: Values, around: slice, here: int, *, bar: bool
) -> Values | None:
    """(n, m) how much of the usual step there is; 0 where the colour is another one."""
    shape, flat = left.shape[:2], (-1, left.shape[2])
    on_left, on_right = ((side.reshape(flat) @ direction).reshape(shape) for side in (left, right))
    usual = [sorted(side[around, here].tolist())[1] for side in (on_left, on_right)]
    if bar:
        # Either side may be as bright as the bar for a while, never both.
        shares = np.maximum(on_left, on_right) / max(usual)
    else:
        if min(usual) < _MIN_COLOUR_STEP / 2:
            return None
        shares = np.minimum(on_left / usual[0], on_right / usual[1])
    both = (left + right).reshape(flat)
    lengths = np.sqrt(np.einsum("ij,ij->i", both, both)).reshape(shape) + 1e-6
    shares[on_left + on_right < _SAME_COLOUR * lengths] = 0.0
    return np.asarray(shares, dtype=np.float32)


def _track_band(shares: list[list[float]], here: int) -> list[int]:
    """Where a band is at each place from the first one on, while it goes on, bending a little."""
    walked = [here]
    for row in shares[1:]:
        low = max(0, here - _MAX_TURN_STEPS)
        near = row[low : here + _MAX_TURN_STEPS + 1]
        most = max(near)
        if most < _SAME_STEP_RATIO:
            break
        if row[here] < most - _SMOOTHNESS_PENALTY:
            here = low + near.index(most)
        walked.append(here)
    return walked
