"""What the label check found, as marks and labels over a picture."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.labels.finding import Severity
from procc_annotator.interact import palette as tones
from procc_annotator.interact.overlay_shapes import (
    FloatArray,
    Labels,
    PointMarks,
    Size,
)
from procc_annotator.interact.verdicts import NO_POINTS
from procc_annotator.language import tr
from procc_annotator.session.facts.frame_check import StoredFinding

_Place = tuple[str, int]
_NO_RING = PointMarks(NO_POINTS, "ring", tones.FINDING, tones.BAD_POINT_SIZE)
_NO_LABELS = tuple(
    Labels(NO_POINTS, (), tones.LABEL, sign=severity.value, below=True) for severity in Severity
)


def finding_signs(
    found: Sequence[StoredFinding],
    annotation: FrameAnnotation,
    picture_size: Size,
    field: Field,
    looked_at: frozenset[str | None] = frozenset(),
) -> tuple[PointMarks, tuple[Labels, ...]]:
    """A sign at every element that has a finding, below the point it stands at.

    An element bears the sign of its surest finding. Errors and warnings are named; hints only where
    somebody looks. A ring surrounds a point that is wrong by itself.

    Args:
        found: of this annotation, the surest first.
        annotation: of the frame, gestures under way included.
        picture_size: (width, height) px.
        field: the elements' titles.
        looked_at: elements somebody looks at: selected, hovered.

    Returns:
        The same groups whatever was found: the ring, and the signs by severity.
    """
    if not found:
        return _NO_RING, _NO_LABELS
    chosen: dict[str, tuple[Severity, _Place]] = {}
    for severity in Severity:
        for one in found:
            if one.finding.severity is severity:
                for place in one.places:
                    chosen.setdefault(place[0], (severity, place))
    labels = []
    for severity, none in zip(Severity, _NO_LABELS, strict=True):
        places = [place for kind, place in chosen.values() if kind is severity]
        if not places:
            labels.append(none)
            continue
        at = {place: _position(place, annotation, picture_size) for place in places}
        shown = {place: xy for place, xy in at.items() if xy is not None}
        texts = tuple(
            tr(field.title_of(name)) if severity is not Severity.HINT or name in looked_at else ""
            for name, _ in shown
        )
        positions = np.array(list(shown.values()), dtype=np.float64).reshape(-1, 2)
        positions = np.clip(positions, 0.0, np.array(picture_size) - 1.0)  # or nobody sees them
        labels.append(Labels(positions, texts, tones.LABEL, sign=severity.value, below=True))
    bad = _bad_points(found, annotation, picture_size)
    ring = PointMarks(bad, "ring", tones.FINDING, tones.BAD_POINT_SIZE) if len(bad) else _NO_RING
    return ring, tuple(labels)


def found_elements(found: Sequence[StoredFinding], annotation: FrameAnnotation) -> FrameAnnotation:
    """Only the elements that something was found at: others may change, the signs stay."""
    names = {name for one in found for name, _ in one.places}
    return FrameAnnotation(tuple([p for p in annotation.polylines if p.class_name in names]))


def _bad_points(
    found: Sequence[StoredFinding], annotation: FrameAnnotation, picture_size: Size
) -> FloatArray:
    """Points that are wrong by themselves, (N, 2) picture px."""
    places = dict.fromkeys(f.places[0] for f in found if f.finding.point is not None and f.places)
    at = [_position(place, annotation, picture_size) for place in places]
    return np.array([xy for xy in at if xy is not None], dtype=np.float64).reshape(-1, 2)


def _position(
    place: _Place, annotation: FrameAnnotation, picture_size: Size
) -> tuple[float, float] | None:
    """Where a point is now, picture px; None if a gesture is taking it away."""
    polyline = annotation.get(place[0])
    if polyline is None or place[1] >= len(polyline.points):
        return None
    point = polyline.points[place[1]]
    return point.u * (picture_size[0] - 1), point.v * (picture_size[1] - 1)
