"""Ghosts and label findings drawn over a picture."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.calibration.prediction.ghosts import Ghost, GhostPiece
from procc_annotator.dataset.review import StoredFinding
from procc_annotator.field.model import Field
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.gestures import closest_on_segments
from procc_annotator.interaction.overlay_primitives import (
    NO_POINTS,
    FilledArea,
    Labels,
    Overlay,
    PointMarks,
    Size,
    Strokes,
    joined,
)
from procc_annotator.metrics.polylines import arc_lengths, polyline_normals
from procc_annotator.translation import tr

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
    a person looks. A ring surrounds a point that is wrong by itself.

    Args:
        found: of this annotation, the surest first.
        annotation: of the frame, gestures under way included.
        picture_size: (width, height) px.
        looked_at: elements a person looks at: selected, hovered.

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
    """Return where a point is now, picture px; None if a gesture is taking it away."""
    polyline = annotation.get(place[0])
    if polyline is None or place[1] >= len(polyline.points):
        return None
    point = polyline.points[place[1]]
    return point.u * (picture_size[0] - 1), point.v * (picture_size[1] - 1)


# A chord this long stays within 0.1 px of any curve of a field that bends around 20 px or more.
_SPACING_PX = 4.0
BAND_SDS = 2.0  # to either side: 19 of 20 lines lie inside


def build_ghosts(
    ghosts: Iterable[Ghost],
    *,
    current: Ghost | None = None,
    label: str = "",
    points_px: FloatArray = NO_POINTS,
    tone: str = tones.GHOST,
) -> Overlay:
    """Draw ghosts.

    Args:
        ghosts: all that are shown, the current one among them.
        current: drawn stronger, with a dark rim and its points.
        label: said next to the current one.
        points_px: (N, 2) picture px, where accepting the current one would put points.
        tone: says how sure their camera is.
    """
    others = [piece for ghost in ghosts if ghost is not current for piece in _thinned(ghost)]
    patches = [*_bands(others, tones.GHOST_BAND, tone)]
    lines = _segments(others)
    strokes = [*_strokes(lines, tones.GHOST_WIDTH, tone)]
    if current is None:
        return Overlay(tuple(strokes), (), (), tuple(patches))
    pieces = _thinned(current)
    patches += _bands(pieces, tones.CURRENT_GHOST_BAND, tone)
    strokes += _strokes(_segments(pieces), tones.CURRENT_GHOST_WIDTH, tone)
    marks = PointMarks(points_px, "ring", tone, tones.GHOST_POINT_SIZE)
    labels = Labels(np.array([_middle(current)]), (label,), tones.LABEL)
    return Overlay(tuple(strokes), (marks,), (labels,), tuple(patches))


def with_next(
    overlay: Overlay, at: tuple[float, float], label: str, size: tuple[int, int]
) -> Overlay:
    """The same with a ring where the element to draw next is expected, picture px, as on the field
    map, and a label next to it."""
    centre = np.clip(np.array([at]), 0.0, np.array(size) - 1.0)
    rim = PointMarks(centre, "ring", tones.GHOST_OUTLINE, tones.NEXT_SIZE + 3.0)
    ring = PointMarks(centre, "ring", tones.GHOST, tones.NEXT_SIZE)
    said = Labels(centre, (label,), tones.LABEL)
    return replace(overlay, marks=(*overlay.marks, rim, ring), labels=(*overlay.labels, said))


def ghost_extent(ghost: Ghost) -> tuple[float, float, float, float]:
    """Left, top, right and bottom of what is visible of a ghost, picture px."""
    points = np.concatenate([piece.points_px for piece in ghost.pieces])
    (left, top), (right, bottom) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    return left, top, right, bottom


def nearest_ghost(
    ghosts: Iterable[Ghost], position: tuple[float, float], reach_px: float
) -> str | None:
    """The class of the ghost nearest to a picture position, px, if one is within reach."""
    best, found = reach_px, None
    for ghost in ghosts:
        for piece in ghost.pieces:
            course = piece.points_px
            feet = closest_on_segments(course[:-1], course[1:], np.array(position))
            distance = float(np.hypot(*(feet - position).T).min())
            if distance <= best:
                best, found = distance, ghost.name
    return found


def _thinned(ghost: Ghost) -> list[GhostPiece]:
    """The pieces with points at least `_SPACING_PX` apart: painting costs by the point."""
    thinned = []
    for piece in ghost.pieces:
        along = arc_lengths(piece.points_px)
        wanted = np.arange(0.0, along[-1], _SPACING_PX)
        rows = np.unique([*np.searchsorted(along, wanted), len(along) - 1])
        if len(rows) >= 2:
            thinned.append(GhostPiece(piece.points_px[rows], piece.sd_px[rows]))
    return thinned


def _segments(pieces: Iterable[GhostPiece]) -> FloatArray:
    courses = [piece.points_px for piece in pieces]
    return joined([np.concatenate((p[:-1], p[1:]), axis=1) for p in courses])


def _strokes(lines: FloatArray, width: float, tone: str) -> Iterable[Strokes]:
    yield Strokes(lines, tones.GHOST_OUTLINE, width + 1.4, layer="ghost")
    yield Strokes(lines, tone, width, tones.GHOST_DASH, "ghost")


def _bands(pieces: Iterable[GhostPiece], opacity: float, tone: str) -> Iterable[FilledArea]:
    for piece in pieces:
        yield FilledArea(_band(piece), tone, opacity)


def _band(piece: GhostPiece) -> FloatArray:
    """The outline of everywhere within `BAND_SDS` of a curve, (2 n, 2) picture px."""
    aside = polyline_normals(piece.points_px) * (BAND_SDS * piece.sd_px)[:, None]
    return np.concatenate((piece.points_px + aside, (piece.points_px - aside)[::-1]))


def _middle(ghost: Ghost) -> FloatArray:
    """The middle of the longest visible stretch, (2,) picture px."""
    longest = max(ghost.pieces, key=lambda p: _length(p.points_px))
    steps = np.hypot(*np.diff(longest.points_px, axis=0).T)
    half = np.searchsorted(np.cumsum(steps), steps.sum() / 2)
    middle: FloatArray = longest.points_px[min(int(half) + 1, len(steps))]
    return middle


def _length(points: FloatArray) -> float:
    return float(np.hypot(*np.diff(points, axis=0).T).sum())
