"""The shapes of a set that have labels of somebody else, frame by frame."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.read_set import ReadSet

_COPY = re.compile(r"(.*) \(\d{1,4}\)", re.DOTALL)
_USUAL_SIZE = (960, 540)  # of pictures whose size nobody knows

Points = tuple[Point, ...]


@dataclass(frozen=True)
class LabelledFrame:
    """A frame with shapes that nobody here knows the classes of.

    Attributes:
        name: of the frame.
        size: (width, height) px of its picture.
        shapes: label -> the shapes that have it, in the order of the file; normalised points.
        known: what has a class of the field.
    """

    name: str
    size: tuple[int, int]
    shapes: dict[str, tuple[Points, ...]]
    known: FrameAnnotation


@dataclass(frozen=True, slots=True)
class LabelCount:
    """How often a label occurs.

    Attributes:
        label: as in the files.
        shapes: with it in the set.
        frames: that have any.
        copies: in a frame, as most of those have it.
    """

    label: str
    shapes: int
    frames: int
    copies: int


def labelled_frames(found: ReadSet, field: Field) -> list[LabelledFrame]:
    """The frames of a set that was read without a map.

    Args:
        found: what was read.
        field: what it was read for.
    """
    frames = []
    for frame in found.frames.values():
        shapes: dict[str, list[Points]] = {}
        known: list[Polyline] = []
        for polyline in frame.annotation.polylines:
            if field.knows(polyline.class_name):
                known.append(polyline)
            elif polyline.points:
                label = _label_of(polyline.class_name, found)
                shapes.setdefault(label, []).append(polyline.points)
        kept = {label: tuple(some) for label, some in shapes.items()}
        size = frame.size or _USUAL_SIZE
        frames.append(LabelledFrame(frame.name, size, kept, FrameAnnotation(tuple(known))))
    return frames


def _label_of(name: str, found: ReadSet) -> str:
    """The label that a numbered copy has in the file."""
    copy = _COPY.fullmatch(name)
    own = name.strip() in found.unknown
    return copy[1].strip() if copy and not own else name.strip()


def label_counts(frames: Sequence[LabelledFrame]) -> list[LabelCount]:
    """How often each label occurs, the most frequent first."""
    copies: dict[str, Counter[int]] = {}
    for frame in frames:
        for label, shapes in frame.shapes.items():
            copies.setdefault(label, Counter())[len(shapes)] += 1
    counts = [
        LabelCount(label, sum(n * k for n, k in some.items()), some.total(), _usual(some))
        for label, some in copies.items()
    ]
    return sorted(counts, key=lambda count: -count.shapes)


def _usual(counts: Counter[int]) -> int:
    return max(counts, key=lambda n: (counts[n], n))


def middle(points: Sequence[Point]) -> tuple[float, float]:
    """The middle of a shape's extent, normalised."""
    us, vs = [p.u for p in points], [p.v for p in points]
    return (min(us) + max(us)) / 2, (min(vs) + max(vs)) / 2
