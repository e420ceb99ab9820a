"""How each point came to be: what an edit adds to it, and counts.

A point is known by its exact coordinates within its frame. So undo, redo, splitting and giving an
element another class keep a point's origin without any bookkeeping, and moving a point gives it a
new one.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.session.facts.origins import Origin, OriginKind, PointKey


def point_keys(annotation: FrameAnnotation) -> set[PointKey]:
    """The coordinates of every confirmed point."""
    return {(p.u, p.v) for polyline in annotation.polylines for p in polyline.points}


def new_origins(
    before: FrameAnnotation,
    after: FrameAnnotation,
    kind: OriginKind,
    author: str,
    time: float,
    *,
    snapped: Collection[PointKey] = (),
    known: Mapping[PointKey, Origin] | None = None,
) -> dict[PointKey, Origin]:
    """Origins of the points that an edit brought: ``kind``, or snapped where that is listed.

    Points that were unconfirmed before and are unchanged now were copied. A place that had an
    origin before and is reached again (a point put back) is new again, by whoever did that.
    """
    taken = {(p.u, p.v) for polyline in before.unconfirmed for p in polyline.points}
    origins: dict[PointKey, Origin] = {}
    for key in point_keys(after) - point_keys(before):
        if key in snapped:
            found = OriginKind.SNAPPED
        elif key in taken:
            was = known.get(key) if known is not None else None
            found = was.kind if was is not None else OriginKind.COPIED
        else:
            found = kind
        origins[key] = Origin(found, author, time)
    return origins


def count_origins(
    annotation: FrameAnnotation, origins: Mapping[PointKey, Origin]
) -> dict[OriginKind, int]:
    """How many confirmed points are of each kind; points nothing is known of are from the file."""
    counts = Counter(
        origins[key].kind if (key := (p.u, p.v)) in origins else OriginKind.FILE
        for polyline in annotation.polylines
        for p in polyline.points
    )
    return {kind: counts[kind] for kind in OriginKind if counts[kind]}
