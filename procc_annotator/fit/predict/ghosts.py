"""Elements that are not annotated yet, where a fitted camera expects them, and how surely."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.field.sample import sample_every
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.observations import FloatArray

# A ghost is offered where it is known to this, across the element, px at 960 px width.
MOST_SD_PX = 2.5
_SPACING_M = 0.25


@dataclass(frozen=True, eq=False)
class GhostPiece:
    """One visible stretch of an element.

    Attributes:
        points_px: (n, 2) px of the picture, dense, n >= 2.
        sd_px: (n,) standard deviation of each across the element, px.
    """

    points_px: FloatArray
    sd_px: FloatArray


@dataclass(frozen=True, eq=False)
class Ghost:
    """An element nobody annotated, as a fitted camera shows it.

    Attributes:
        name: the class.
        pieces: its visible stretches, along the element.
    """

    name: str
    pieces: tuple[GhostPiece, ...]

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
    most_sd_px: float = MOST_SD_PX,
) -> tuple[Ghost, ...]:
    """The elements in sight that are not annotated, where the fit knows them well enough.

    Args:
        annotation: what is there already; confirmed or not.
        field: the elements, metres.
        fit: to this annotation.
        without: classes that are not to be offered.
        most_sd_px: the largest standard deviation across an element, px at 960 px width.
    """
    if fit.camera is None:
        return ()
    width, height = fit.size
    taken = {p.class_name for p in (*annotation.polylines, *annotation.unconfirmed) if p.points}
    most = most_sd_px * (width - 1) / 959
    samples = sample_every(field, _SPACING_M)
    found = []
    for row, name in enumerate(samples.names):
        if name in taken or name in without:
            continue
        world = samples.of(row)
        px, shown = fit.camera.project(world)
        inside = shown & ((px >= 0) & (px <= (width - 1, height - 1))).all(axis=1)
        pieces = []
        for begin, end in _runs(inside):
            if end - begin >= 2:
                stretch = px[begin:end]
                sd = fit.projected_sd(world[begin:end], _normals(stretch))
                pieces.append(GhostPiece(stretch, sd))
        if pieces and max(float(p.sd_px.max()) for p in pieces) <= most:
            found.append(Ghost(name, tuple(pieces)))
    return tuple(found)


def _runs(inside: np.ndarray) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], inside.astype(np.int8), [0]])))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def _normals(course: FloatArray) -> FloatArray:
    along = np.gradient(course, axis=0)
    length = np.hypot(along[:, 0], along[:, 1])[:, None]
    along = np.where(length > 0, along / np.maximum(length, 1e-12), (1.0, 0.0))
    return np.column_stack([-along[:, 1], along[:, 0]])
