"""Elements that are not annotated yet, where a fitted camera expects them, and how surely.

The gate is the predicted standard deviation across the element, from the covariance of the fit. An
element is offered as a whole or not at all: one of which a part is taken would look finished
although it ends in the middle of nowhere, and would not be offered again. Spots are not offered:
nothing in the picture would tell where they are, so that accepting one would only repeat the
camera's own opinion. Nor are optional elements, which a set need not have.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.predict.joints import ExpectedEnds, expected_ends
from procc_annotator.fit.predict.mistaken import classes_labelled_otherwise
from procc_annotator.fit.predict.sight import (
    VisibleStretch,
    split_at_corners,
    visible_stretches,
)
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.observations import FloatArray
from procc_annotator.metric.course import polyline_normals

# A ghost is offered where it is known to this, across the element, px at 960 px width.
MAX_SD_PX = 3.0
# Shorter pieces are not worth a click, px at 960 px width.
MIN_LENGTH_PX = 10.0
_SD_SPACING_PX = 12.0  # the deviation changes slowly along an element


@dataclass(frozen=True, eq=False)
class GhostPiece:
    """One visible stretch of an element.

    Attributes:
        points_px: (n, 2) px of the picture, dense, in the element's direction, n >= 2.
        sd_px: (n,) standard deviation of each across the element, px. The line is expected within
            two of them to either side, which is the band that is drawn.
    """

    points_px: FloatArray
    sd_px: FloatArray


@dataclass(frozen=True, eq=False)
class Ghost:
    """An element nobody annotated, as a fitted camera shows it.

    Attributes:
        name: the class.
        pieces: its visible stretches, along the element; one ends and another begins where a chain
            has a corner.
        ends: of a straight one, first and last; None where the picture's edge cuts it off.
    """

    name: str
    pieces: tuple[GhostPiece, ...]
    ends: ExpectedEnds = (None, None)

    @property
    def sd_px(self) -> float:
        """The largest standard deviation along it, px."""
        return max(float(piece.sd_px.max()) for piece in self.pieces)


def find_ghosts(
    annotation: FrameAnnotation,
    field: Field,
    fit: FitResult,
    *,
    without: Collection[str] = (),
    most_sd_px: float = MAX_SD_PX,
) -> tuple[Ghost, ...]:
    """The elements in sight that are not annotated, where the fit knows them well enough.

    A camera that knows only the ground has no ghosts off the ground. A line that is annotated under
    a class that does not belong there is no ghost: it would have two labels.

    Args:
        annotation: what is there already; confirmed or not.
        field: the elements, metres.
        fit: to this annotation.
        without: classes that are not to be offered.
        most_sd_px: the largest standard deviation across an element, px at 960 px width.

    Returns:
        In the field's order.
    """
    if fit.camera is None:
        return ()
    per_reference = (fit.size[0] - 1) / 959
    optional = {e.name for e in field.elements if e.optional}
    seen = unannotated_stretches(annotation, field, fit, optional.union(without))
    smooth = [part for stretch in seen for part in split_at_corners(stretch)]
    long_enough = [s for s in smooth if s.length_px >= MIN_LENGTH_PX * per_reference]
    pieces = stretch_deviations(long_enough, fit)
    found: dict[str, list[GhostPiece]] = {}
    for stretch, piece in zip(long_enough, pieces, strict=True):
        found.setdefault(stretch.name, []).append(piece)
    ends = expected_ends(long_enough, field, fit)
    ghosts = (
        Ghost(name, tuple(pieces), ends.get(name, (None, None))) for name, pieces in found.items()
    )
    return tuple(g for g in ghosts if g.sd_px <= most_sd_px * per_reference)


def unannotated_stretches(
    annotation: FrameAnnotation, field: Field, fit: FitResult, without: Collection[str] = ()
) -> tuple[VisibleStretch, ...]:
    """What the fitted camera has in sight of elements that have no points yet, neither under their
    own class nor under another one."""
    if fit.camera is None:
        return ()
    taken = {p.class_name for p in (*annotation.polylines, *annotation.unconfirmed) if p.points}
    seen = visible_stretches(field, fit.camera, fit.size, taken.union(without))
    mistaken = classes_labelled_otherwise(annotation, fit, seen)
    return tuple(stretch for stretch in seen if stretch.name not in mistaken)


def stretch_deviations(stretches: list[VisibleStretch], fit: FitResult) -> list[GhostPiece]:
    """The pieces of stretches, with deviations; one call for all of them."""
    if not stretches:
        return []
    knots = [_sd_sample_rows(s) for s in stretches]
    world = np.concatenate([s.points_world[k] for s, k in zip(stretches, knots, strict=True)])
    across = np.concatenate(
        [polyline_normals(s.points_px)[k] for s, k in zip(stretches, knots, strict=True)]
    )
    # Of the camera, and of what this element may lie beside it by itself.
    sd = np.hypot(fit.projected_sd(world, across), fit.offset_px)
    ends = np.cumsum([len(k) for k in knots])[:-1]
    return [
        GhostPiece(s.points_px, np.interp(np.arange(len(s.points_px)), k, own))
        for s, k, own in zip(stretches, knots, np.split(sd, ends), strict=True)
    ]


def _sd_sample_rows(stretch: VisibleStretch) -> np.ndarray:
    count = min(len(stretch.points_px), max(3, round(stretch.length_px / _SD_SPACING_PX)))
    return np.unique(np.linspace(0, len(stretch.points_px) - 1, count).round().astype(np.intp))
