"""Which frames of a set are alike: those of one match or shot tell less than as many of several."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.errors import UsageError
from procc_annotator.metric.polylines import IntArray
from procc_annotator.session.runs.frame_order import FrameOrder, shots_in
from procc_annotator.words import count_words

SHOT = "shot"  # by the names of the frames, or the dataset's frames.csv
NONE = "none"  # every frame for itself
_MIN_RELIABLE = 5


@dataclass(frozen=True, eq=False)
class Clusters:
    """The clusters of F frames.

    Attributes:
        numbers: (F,) the cluster of each frame, from 0 on.
        described: what they were found by, in words.
        by: a tag, `SHOT`, or `NONE`.
    """

    numbers: IntArray
    described: str
    by: str

    @property
    def count(self) -> int:
        """How many there are."""
        return int(self.numbers.max()) + 1 if len(self.numbers) else 0

    @property
    def thing(self) -> str:
        """What there are so many of."""
        return "frame" if self.by == NONE else "cluster"

    @property
    def caution(self) -> str:
        """A sentence where there are too few for any interval, else empty."""
        if self.count >= _MIN_RELIABLE:
            return ""
        return f"Of fewer than {_MIN_RELIABLE} {self.thing}s no interval is to be relied on."


def clusters_of(
    frames: Sequence[str],
    by: str | None,
    values: Mapping[str, str | None],
    order: FrameOrder | None = None,
) -> Clusters:
    """The clusters of frames.

    Args:
        frames: names.
        by: a tag, `SHOT`, `NONE`; None for shots if there are any to be found.
        values: of the tag, by frame. A frame without one is a cluster of its own. A tag called
            `SHOT` counts rather than table and names.
        order: the dataset's table of frames; without it names tell the shots.

    Raises:
        UsageError: a tag that no frame has, or shots where none can be found.
    """
    if by == NONE:
        return _alone(frames, "every frame for itself")
    if by not in (None, SHOT) or (by == SHOT and values):
        if not any(values.get(frame) for frame in frames):
            raise UsageError(f"no frame has a value of {by!r} to cluster by")
        return _by_value(frames, [values.get(frame) for frame in frames], f"by {by}", by or "")
    found = shots_in(frames, order)
    shot_of = {frame: str(n) for n, shot in enumerate(found) for frame in shot.frames}
    told_by = "by names" if order is None else f"by {order.told_by}"
    if len(found) > 1 and any(len(shot.frames) > 1 for shot in found):
        return _by_value(
            frames, [shot_of.get(f) for f in frames], f"of one shot each, {told_by}", SHOT
        )
    if by == SHOT:
        raise UsageError("names of frames tell no shots to cluster by: give a tag with --tags")
    if order is not None and len(frames) > 1 and len(shot_of) == len(frames):
        words = f"all frames are of one shot, {told_by}, and true intervals are wider"
        return _alone(frames, f"not clustered: {words}")
    return _alone(
        frames,
        "not clustered: neither tag nor names say which frames are alike, and where some are, true"
        " intervals are wider",
    )


def _by_value(frames: Sequence[str], values: Sequence[str | None], words: str, by: str) -> Clusters:
    places: dict[tuple[bool, str], int] = {}
    keys = [
        (False, frame) if not value else (True, value)
        for frame, value in zip(frames, values, strict=True)
    ]
    numbers = np.array([places.setdefault(key, len(places)) for key in keys], dtype=np.intp)
    alone = sum(not tagged for tagged, _ in keys)
    rest = f", {count_words(alone, 'frame')} without" if alone else ""
    return Clusters(numbers, f"{count_words(len(places), 'cluster')} {words}{rest}", by)


def _alone(frames: Sequence[str], words: str) -> Clusters:
    return Clusters(np.arange(len(frames), dtype=np.intp), words, NONE)
