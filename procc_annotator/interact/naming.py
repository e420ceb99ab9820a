"""Lines that are drawn first and named after: what they are called meanwhile, and what they likely
are."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import FloatArray

# SoccerNet's class of a line that nobody could name.
UNNAMED = "Line unknown"  # not shown
_REVERSED = 3.0  # how much farther a line counts that runs across what was drawn


def unnamed_class(annotation: FrameAnnotation) -> str:
    """The first free class of an unnamed line: ``Line unknown``, ``Line unknown (2)``..., as they
    are numbered in files that may hold several."""
    name, number = UNNAMED, 1
    while annotation.get(name) is not None or annotation.get_unconfirmed(name) is not None:
        number += 1
        name = f"{UNNAMED} ({number})"
    return name


def rank_classes(
    drawn: FloatArray,
    courses: Mapping[str, Sequence[FloatArray]],
    otherwise: Iterable[str] = (),
    *,
    farthest: float = np.inf,
    most: int = 3,
) -> tuple[str, ...]:
    """The elements that a drawn line likely is, best first.

    The mean distance of its points to where each element is expected counts, more where that runs
    in another direction.

    Args:
        drawn: (n, 2) px, n >= 1.
        courses: class -> its expected pieces, each (m, 2) px, m >= 1.
        otherwise: classes to fill up with, likeliest first.
        farthest: px; elements that are farther are none of it.
        most: how many are named.
    """
    away = {
        name: distance
        for name, pieces in courses.items()
        if len(pieces) and (distance := _distance(drawn, pieces)) <= farthest
    }
    ranked = sorted(away, key=lambda name: away[name])
    return tuple(dict.fromkeys((*ranked, *(n for n in otherwise if n not in away))))[:most]


def _distance(drawn: FloatArray, pieces: Sequence[FloatArray]) -> float:
    """Mean distance of points to a course, px, up to `_TURNED` + 1 times as much across it."""
    segments = np.concatenate([_segments(piece) for piece in pieces])
    starts, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    lengths = np.maximum((along**2).sum(axis=1), 1e-12)
    offsets = drawn[:, None] - starts[None]
    share = np.clip((offsets * along[None]).sum(axis=2) / lengths, 0.0, 1.0)
    feet = starts[None] + share[..., None] * along[None]
    distances = np.hypot(*np.moveaxis(drawn[:, None] - feet, -1, 0))
    nearest = distances.argmin(axis=1)
    mean = float(distances[np.arange(len(drawn)), nearest].mean())
    course = along[nearest].sum(axis=0)
    runs = drawn[-1] - drawn[0]
    if len(drawn) < 2 or not course.any() or not runs.any():
        return mean
    sine = (course[0] * runs[1] - course[1] * runs[0]) / (np.hypot(*course) * np.hypot(*runs))
    return mean * (1 + _REVERSED * float(sine) ** 2)


def _segments(piece: FloatArray) -> FloatArray:
    """(k, 2, 2): the segments of a piece; of a single point one without length."""
    if len(piece) == 1:
        piece = np.repeat(piece, 2, axis=0)
    return np.stack([piece[:-1], piece[1:]], axis=1)
