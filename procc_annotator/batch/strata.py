"""Stratify frames by tag, zoom, elements, coverage or side, and compare methods per stratum."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from natsort import natsorted

from procc_annotator.batch.audit import Pose
from procc_annotator.batch.frame_sums import COMPARED, FrameSums, SourceSums
from procc_annotator.batch.grouping import MODEL, SHOT, Clusters, FrameOrder, shots_in
from procc_annotator.batch.inference import Inference
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.metrics.ground_plane import field_rectangle
from procc_annotator.metrics.statistics.significance import PairedDifference, corrected_for

ZOOM, ELEMENTS, SPREAD, SIDE = "zoom", "elements", "spread", "side"
POSED = (ZOOM, SIDE)  # by the cameras of `reference_poses`
DERIVED = (ZOOM, ELEMENTS, SPREAD, SIDE, SHOT)
_PARTS = (1 / 3, 2 / 3)


@dataclass(frozen=True, eq=False)
class Stratum:
    """One of the parts of a set.

    Attributes:
        by, value: what its frames have in common; None for those of which it is not known.
        certainty: the sources over these frames.
        differences: (figure, tau) -> (a, b) -> the difference of two sources, corrected for all
            strata and pairs.
    """

    by: str
    value: str | None
    certainty: Inference
    differences: Mapping[tuple[str, float], Mapping[tuple[int, int], PairedDifference]]


def strata(certainty: Inference, by: str, values: Sequence[str | None]) -> list[Stratum]:
    """The parts of a set, in natural order, those of no value last.

    Args:
        values: (F,) of each frame.
    """
    named: list[str | None] = [*natsorted({v for v in values if v is not None})]
    found = [
        (value, _within(certainty, [v == value for v in values]))
        for value in [*named, *([None] if None in values else [])]
    ]
    parts = [part for _, part in found]
    differences: list[dict[tuple[str, float], Mapping[tuple[int, int], PairedDifference]]] = [
        {} for _ in parts
    ]
    if certainty.pairs:
        for key, tau in product(COMPARED, certainty.thresholds):
            own = _corrected([part.differences(key, tau) for part in parts])
            for of_part, differing in zip(differences, own, strict=True):
                of_part[key, tau] = differing
    return [
        Stratum(by, value, part, own) for (value, part), own in zip(found, differences, strict=True)
    ]


def _corrected(
    several: Sequence[Mapping[tuple[int, int], PairedDifference]],
) -> list[dict[tuple[int, int], PairedDifference]]:
    at = iter(corrected_for([one for own in several for one in own.values()]))
    return [{pair: next(at) for pair in own} for own in several]


def values_of_frames(
    by: str,
    sources: Sequence[SourceSums],
    field: Field,
    tags: Mapping[str, str | None],
    order: FrameOrder | None = None,
    poses: Mapping[str, Pose | None] | None = None,
) -> list[str | None]:
    """The value of each frame; which methods are compared matters for `MODEL` alone.

    Args:
        by: a tag, one of `DERIVED`, or `MODEL`. A tag that is called as one of `DERIVED` counts:
            anyone who gives it means it.
        tags: of the tag, by frame; empty where `by` is none.
        order: the dataset's table of frames; without it names give the shots.
        poses: of cameras fitted to the annotations, by frame, for `POSED`.

    Raises:
        UsageError: nothing is known of any frame.
    """
    names = sources[0].names
    fitted = [(poses or {}).get(name) for name in names]
    found: list[str | None]
    if tags:
        found = [tags.get(name) for name in names]
    elif by == ZOOM:
        focal = [None if pose is None else pose.focal_px for pose in fitted]
        found = _thirds(focal, "focal {} to {} px")
    elif by == ELEMENTS:
        counts = [frame.elements or None for frame in sources[0].frames]
        found = _thirds(counts, "{} to {} elements")
    elif by == SPREAD:
        shares = [None if f.spread is None else 100 * f.spread for f in sources[0].frames]
        found = _thirds(shares, "{} to {} % of the picture")
    elif by == SIDE:
        found = [None if pose is None else _side(pose, field) for pose in fitted]
    elif by == MODEL:
        found = [_models(frames) for frames in _frames(sources)]
    elif by == SHOT:
        shot_of = {frame: s.name for s in shots_in(names, order) for frame in s.frames}
        found = [shot_of.get(name) for name in names]
    else:
        found = []
    if not any(found):
        raise UsageError(f"cannot break down by {by!r}: it is known of no frame")
    return found


def _within(certainty: Inference, chosen: Sequence[bool]) -> Inference:
    kept = np.flatnonzero(chosen)
    _, numbers = np.unique(certainty.clusters.numbers[kept], return_inverse=True)
    clusters = Clusters(numbers, certainty.clusters.described, certainty.clusters.by)
    sources = tuple(
        SourceSums(s.name, s.thresholds, tuple(s.frames[i] for i in kept))
        for s in certainty.sources
    )
    return Inference(sources, clusters, certainty.draws, certainty.method, certainty.compared)


def _frames(sources: Sequence[SourceSums]) -> Iterator[tuple[FrameSums, ...]]:
    return zip(*(source.frames for source in sources), strict=True)


def _thirds(values: Sequence[float | None], words: str) -> list[str | None]:
    """Names of the three parts that values fall into; fewer where many are the same."""
    known = np.array([v for v in values if v is not None])
    if not len(known):
        return [None] * len(values)
    edges = np.unique(np.quantile(known, _PARTS, method="inverted_cdf"))
    parts = [None if v is None else int(np.searchsorted(edges, v)) for v in values]
    ends: dict[int, tuple[float, float]] = {}
    for part, value in zip(parts, values, strict=True):
        if part is not None and value is not None:
            low, high = ends.get(part, (value, value))
            ends[part] = min(low, value), max(high, value)
    names = {part: words.format(f"{a:.0f}", f"{b:.0f}") for part, (a, b) in ends.items()}
    return [None if part is None else names[part] for part in parts]


def _models(frames: Iterable[FrameSums]) -> str | None:
    """The models of a frame's cameras, in the order of the sources; None without any."""
    return " / ".join(dict.fromkeys(frame.model for frame in frames if frame.model)) or None


def _side(pose: Pose, field: Field) -> str:
    """Return where next to the field a camera stands."""
    x, y, _ = pose.position_world
    shown = field_rectangle(field)
    beyond_x = max(shown.left - x, x - shown.right)
    if beyond_x > max(shown.top - y, y - shown.bottom):
        return "behind the end at x < 0" if x < 0 else "behind the end at x > 0"
    return "main camera's side" if y > 0 else "opposite side"
