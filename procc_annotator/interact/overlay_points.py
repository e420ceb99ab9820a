"""The points of an overlay: by verdict, by class, by origin, by annotator, the chosen ones."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.interact import palette as tones
from procc_annotator.interact.overlay_shapes import (
    NO_LINE,
    Draft,
    Drawn,
    DrawnLine,
    FloatArray,
    PointMarks,
    Size,
    joined_points,
)
from procc_annotator.interact.verdicts import NO_POINTS, ScoredFrame
from procc_annotator.session.dataset.edits import PointRef
from procc_annotator.session.facts.origins import Origin, OriginKind, PointKey


def judged_marks(drawn: Drawn, verdict: ScoredFrame) -> Iterable[PointMarks]:
    """Points by verdict: their shapes tell them apart without colour."""
    size = tones.HANDLE_SIZE
    missed = [drawn.points(n) for n in drawn.names() if verdict.status.get(n) == "missed"]
    yield PointMarks(verdict.passing, "dot", tones.PASSES, size)
    yield PointMarks(verdict.failing, "cross", tones.TOO_FAR, size + 2)
    yield PointMarks(joined_points(missed), "ring", tones.MISSED, size)


def plain_marks(
    drawn: Drawn, verdict: ScoredFrame, field: Field, by_class: bool, *, hidden: bool
) -> Iterable[PointMarks]:
    """Points without a verdict, as handles in the colour of their lines."""
    rest = [] if hidden else [n for n in drawn.names() if n not in verdict.status]
    if by_class:
        marks = [_class_marks(NO_LINE, element.colour) for element in field.elements]
        for name in rest:
            if (i := field.index.get(name)) is not None:
                marks[i] = _class_marks(drawn.line(name), marks[i].colour)
        yield from marks
        rest = [n for n in rest if n not in field.index]
    points = joined_points([drawn.points(n) for n in rest])
    yield PointMarks(points, "handle", tones.UNKNOWN_CLASS, tones.HANDLE_SIZE)


@lru_cache(maxsize=256)  # the very same while other elements change
def _class_marks(line: DrawnLine, colour: str) -> PointMarks:
    return PointMarks(line.points, "handle", colour, tones.HANDLE_SIZE)


def origin_marks(
    annotation: FrameAnnotation, size: Size, origins: Mapping[PointKey, Origin] | None
) -> Iterable[PointMarks]:
    """Points by how they came to be."""
    groups: dict[OriginKind, list[PointKey]] = {kind: [] for kind in OriginKind}
    for key in _keys(annotation) if origins is not None else ():
        origin = origins.get(key) if origins is not None else None
        groups[origin.kind if origin is not None else OriginKind.FILE].append(key)
    for kind, keys in groups.items():
        colour, shape = tones.ORIGINS[kind.value]
        yield PointMarks(_places(keys, size), shape, colour, tones.HANDLE_SIZE)


def author_marks(
    annotation: FrameAnnotation, size: Size, origins: Mapping[PointKey, Origin] | None
) -> Iterable[PointMarks]:
    """Points by who put them there, in the order of the names; those of the file last."""
    known = origins if origins is not None else {}
    authors = sorted({origin.author for origin in known.values()})
    groups: list[list[PointKey]] = [[] for _ in tones.AUTHORS]
    unknown: list[PointKey] = []
    for key in _keys(annotation) if origins is not None else ():
        origin = known.get(key)
        chosen = unknown
        if origin is not None:
            chosen = groups[authors.index(origin.author) % len(tones.AUTHORS)]
        chosen.append(key)
    for (colour, shape), keys in zip(tones.AUTHORS, groups, strict=True):
        yield PointMarks(_places(keys, size), shape, colour, tones.HANDLE_SIZE)
    yield PointMarks(_places(unknown, size), "handle", tones.UNKNOWN_CLASS, tones.HANDLE_SIZE)


def landing(draft: Draft | None) -> FloatArray:
    """Where snapping would put a click now, (1, 2), or nowhere, (0, 2)."""
    if draft is None or draft.landing is None:
        return NO_POINTS
    return np.array([draft.landing], dtype=np.float64)


def chosen_points(chosen: frozenset[PointRef], *drawn: Drawn) -> FloatArray:
    """The selected points of confirmed and unconfirmed elements, (N, 2)."""
    parts = [group.point(ref) for ref in sorted(chosen) for group in drawn if ref[0] in group]
    return joined_points(parts)


def _keys(annotation: FrameAnnotation) -> Iterable[PointKey]:
    return [(p.u, p.v) for polyline in annotation.polylines for p in polyline.points]


def _places(keys: list[PointKey], size: Size) -> FloatArray:
    places = np.array(keys, dtype=np.float64).reshape(-1, 2)
    return places * (size[0] - 1, size[1] - 1)
