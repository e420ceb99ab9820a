"""The visible pieces of a source that gives its projected polylines instead of a camera."""

from __future__ import annotations

import numpy as np

from procc_annotator.camera.projections import ElementProjections
from procc_annotator.field.model import Field
from procc_annotator.metric.clip import Chords, ClippedPolylines, clip_chords
from procc_annotator.metric.official import visible_polylines
from procc_annotator.metric.polylines import BoolArray, FloatArray, IntArray, Polylines


def clip_given_official(
    projections: ElementProjections, field: Field, size: tuple[int, int]
) -> Polylines:
    """The official walk along the vertices as if they were a camera's projected samples.

    Border points are added where a piece leaves the picture. Separate pieces stay separate: only
    a source that gives one list for an element asks for its gaps to be bridged.

    Args:
        projections: px of ``size``.
        field: classes that it does not have are passed over.
        size: (width, height) px.
    """
    px, row, piece = _flat_vertices(projections, field)
    whole = visible_polylines(
        px, np.ones(len(px), dtype=bool), piece, size, element_count=int(piece.max(initial=-1)) + 1
    )
    row_of_piece = np.zeros(whole.element_count, dtype=np.intp)
    row_of_piece[piece] = row
    return Polylines(
        whole.vertices,
        row_of_piece[whole.element],
        whole.is_end,
        len(field.elements),
        nan_if_zero_length=True,
    )


def clip_given_exact(projections: ElementProjections, field: Field, size: tuple[int, int]) -> ClippedPolylines:
    """The pieces, and their parts inside the picture; a single vertex has none, unless it is a
    spot.

    Args: as `clip_given_official`.
    """
    px, row, piece = _flat_vertices(projections, field)
    first = np.flatnonzero(piece[1:] == piece[:-1])
    is_spot = np.array([e.is_spot for e in field.elements], dtype=bool)
    spots = np.flatnonzero(is_spot[row] & (np.bincount(piece)[piece] == 1))
    position = np.arange(len(px), dtype=np.float64)
    ends = np.concatenate((np.column_stack((first, first + 1)), np.column_stack((spots, spots))))
    rows = np.arange(len(field.elements))
    return clip_chords(Chords(row[ends[:, 0]], position[ends], px[ends]), rows, len(rows), size)


def _flat_vertices(
    projections: ElementProjections, field: Field
) -> tuple[FloatArray, IntArray, IntArray]:
    """All vertices in field order (n, 2) px, the element and the piece (n,) each belongs to.

    A vertex equal to the one before it says nothing and is left out.
    """
    parts: list[tuple[int, FloatArray]] = []
    for name, pieces in projections.pieces.items():
        row = field.index.get(field.canonical_name(name))
        if row is not None:
            parts += [(row, _without_repetitions(px)) for px in pieces if len(px)]
    parts.sort(key=lambda part: part[0])
    if not parts:
        return np.empty((0, 2)), np.empty(0, dtype=np.intp), np.empty(0, dtype=np.intp)
    counts = [len(px) for _, px in parts]
    rows = np.array([row for row, _ in parts], dtype=np.intp)
    return (
        np.concatenate([px for _, px in parts]),
        np.repeat(rows, counts),
        np.repeat(np.arange(len(parts), dtype=np.intp), counts),
    )


def _without_repetitions(px: FloatArray) -> FloatArray:
    new: BoolArray = np.ones(len(px), dtype=bool)
    new[1:] = (px[1:] != px[:-1]).any(axis=1)
    return px[new]
