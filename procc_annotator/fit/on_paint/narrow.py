"""Where the middle of a narrow line lies to a fraction of a pixel.

A line that is narrower than the lens's blur has no flanks of its own: between two areas of
different colours its brightest place lies towards the lighter one. So the cut across it is
explained by three things at once, each blurred: a ground, a step from one side's to the other's
there where the line is, and the line. The shift at which they explain most is where it lies.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.observations import FloatArray

Values = NDArray[np.float32]

STEP_PX = 0.5  # between samples of a cut
PROFILE_HALF_SAMPLES = 6  # samples to either side of where the line was found
_BLUR_SIGMAS_PX = (0.85, 1.3)  # standard deviations: of lenses, scaling and loss
_SHIFTS_PX = np.arange(-1.5, 1.51, 0.25)
_WIDTHS_PX = np.arange(0.25, 2.01, 0.25)


def line_centres(cuts: Values, width_px: FloatArray) -> FloatArray:
    """How far the middles of lines lie from those of their cuts.

    Args:
        cuts: (n, 2 * `PROFILE_HALF_SAMPLES` + 1, c) values in c colours, `STEP_PX` apart.
        width_px: (n,) of the lines, px, at most 2.

    Returns:
        (n,) px.
    """
    kind = np.clip(np.round(width_px / _WIDTHS_PX[0]).astype(np.intp) - 1, 0, len(_WIDTHS_PX) - 1)
    level = (cuts - cuts.mean(axis=1, keepdims=True)).transpose(0, 2, 1)
    found = np.empty(len(cuts))
    for own in np.unique(kind).tolist():
        rows = np.flatnonzero(kind == own)
        found[rows] = _best_template_shifts(level[rows], _template_basis(own))
    return found


def _best_template_shifts(level: Values, ways: Values) -> FloatArray:
    """(n,) px, of (n, c, samples)."""
    blurs, shifts, two, samples = ways.shape
    told = level.reshape(-1, samples) @ ways.reshape(-1, samples).T
    told = told.reshape(len(level), -1, blurs, shifts, two)
    explained = (told * told).sum(axis=(1, 4)).astype(np.float64)
    rows = np.arange(len(level))
    blur = explained.max(axis=2).argmax(axis=1)
    of = explained[rows, blur]
    at = of.argmax(axis=1)
    inner = np.clip(at, 1, shifts - 2)
    left, middle, right = (of[rows, inner + away] for away in (-1, 0, 1))
    bend = np.maximum(2 * middle - left - right, 1e-9)
    part = np.clip((right - left) / (2 * bend), -0.5, 0.5)
    spacing = float(_SHIFTS_PX[1] - _SHIFTS_PX[0])
    return np.asarray(_SHIFTS_PX[at] + np.where(at == inner, part, 0.0) * spacing)


@lru_cache(maxsize=len(_WIDTHS_PX))
def _template_basis(kind: int) -> Values:
    """(blurs, shifts, 2, samples): what spans a step and a line of a width, less the mean."""
    half = float(_WIDTHS_PX[kind]) / 2
    places = np.arange(-PROFILE_HALF_SAMPLES, PROFILE_HALF_SAMPLES + 1) * STEP_PX
    found = []
    for blur in _BLUR_SIGMAS_PX:
        for shift in _SHIFTS_PX:
            at = places - shift
            line = _blurred_step((at + half) / blur) - _blurred_step((at - half) / blur)
            both = np.stack([_blurred_step(at / blur), line])
            both -= both.mean(axis=1, keepdims=True)
            found.append(np.linalg.qr(both.T)[0].T)
    shape = (len(_BLUR_SIGMAS_PX), len(_SHIFTS_PX), 2, len(places))
    return np.array(found, dtype=np.float32).reshape(shape)


def _blurred_step(places: FloatArray) -> FloatArray:
    """A step from 0 to 1 at 0, blurred by 1."""
    return np.array([(1 + math.erf(at / math.sqrt(2))) / 2 for at in places.tolist()])
