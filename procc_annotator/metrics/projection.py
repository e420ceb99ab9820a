"""Project the field into the image by the setup's protocol, from a camera or given polylines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.camera.base import (
    CameraOrProjections,
    ElementProjections,
    projects_only_ground,
)
from procc_annotator.errors import UsageError
from procc_annotator.field.markings import marking_field
from procc_annotator.field.model import Field
from procc_annotator.metrics.curve_projection import project_curves
from procc_annotator.metrics.official import (
    official_polylines,
    project_samples,
    visible_polylines,
)
from procc_annotator.metrics.polylines import Chords, ClippedPolylines, Polylines, clip_chords
from procc_annotator.metrics.setup import EvaluationSetup


def clip_given_official(
    projections: ElementProjections, field: Field, size: tuple[int, int]
) -> Polylines:
    """The official walk along the vertices, px of ``size``, as if they were a camera's projected
    samples; classes that the field does not have are passed over.

    Border points are added where a piece leaves the picture. Separate pieces stay separate: only
    a source that gives one list for an element asks for its gaps to be bridged.
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


def clip_given_exact(
    projections: ElementProjections, field: Field, size: tuple[int, int]
) -> ClippedPolylines:
    """The pieces, and their parts inside the picture; a single vertex has none, unless it is a
    spot. Arguments as of `clip_given_official`."""
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


@dataclass(frozen=True, eq=False)
class ProjectedField:
    """Projected field of a camera.

    Attributes:
        names: element names, in field order.
        polylines: the visible pieces as flat arrays, px of the evaluation size.
        measured: what distances are taken to: the same elements as they go on beyond the picture,
            or, as in the official evaluation, the visible pieces.
        left_out: classes that do not take part: elements off the ground, where only planar ones are
            evaluated, or for a camera that knows only the ground; optional ones, where the official
            evaluation is followed; landmarks whose place is not known.
        ground_only: whether the camera knows only the ground.
        camera: in px of the evaluation size.
    """

    names: tuple[str, ...]
    polylines: Polylines
    measured: Polylines
    left_out: frozenset[str] = frozenset()
    ground_only: bool = False
    camera: CameraOrProjections | None = None

    @property
    def shows_any(self) -> bool:
        """Whether the camera shows any element in the picture."""
        return len(self.polylines.element) > 0

    @cached_property
    def pieces(self) -> dict[str, tuple[FloatArray, ...]]:
        """Visible pieces, each (n, 2) px of the evaluation size, of the elements that have any."""
        rows = self.polylines.detected.nonzero()[0].tolist()
        return {self.names[row]: self.polylines.pieces_of(row) for row in rows}


def project_field(camera: CameraOrProjections, setup: EvaluationSetup) -> ProjectedField:
    """Project the field to the evaluation size by the setup's protocol.

    The camera is in px of ``setup.size``; sources that share no camera have their projected
    polylines clipped to the picture as the protocol clips a camera's.
    """
    return project_fields([camera], setup)[0][0]


def project_fields(
    cameras: Sequence[CameraOrProjections], setup: EvaluationSetup
) -> tuple[list[ProjectedField], Polylines]:
    """The same for several frames at once, which is faster: what each of them shows, and what
    distances are taken to in all of them as `Polylines.joined` has it."""
    shown, measured = _project_all(cameras, setup)
    if setup.planar_only:
        planar = np.tile(setup.tables.on_ground, len(cameras))
        shown, measured = shown.of_elements(planar), measured.of_elements(planar)
    count = len(cameras)
    fields = [
        _projected_field(camera, pieces, near, setup)
        for camera, pieces, near in zip(
            cameras, shown.of_frames(count), measured.of_frames(count), strict=True
        )
    ]
    return fields, measured


def _project_all(
    cameras: Sequence[CameraOrProjections], setup: EvaluationSetup
) -> tuple[Polylines, Polylines]:
    """The visible pieces of all frames, and what is measured, `Polylines.joined`."""
    if setup.is_official:
        shown = _project_official(cameras, setup)
        return shown, shown
    courses = [_project_exact(camera, setup) for camera in cameras]
    return (
        Polylines.joined([frame.in_sight for frame in courses]),
        Polylines.joined([frame.unclipped for frame in courses]),
    )


def _project_official(cameras: Sequence[CameraOrProjections], setup: EvaluationSetup) -> Polylines:
    if not any(map(_has_pieces_only, cameras)):
        return official_polylines(cameras, setup.tables, setup.size)
    return Polylines.joined(
        [
            clip_given_official(camera, setup.field, setup.size).of_elements(
                setup.tables.is_official
            )
            if isinstance(camera, ElementProjections) and camera.samples is None
            else official_polylines([camera], setup.tables, setup.size)
            for camera in cameras
        ]
    )


def _has_pieces_only(camera: CameraOrProjections) -> bool:
    return isinstance(camera, ElementProjections) and camera.samples is None


def _project_exact(camera: CameraOrProjections, setup: EvaluationSetup) -> ClippedPolylines:
    if isinstance(camera, ElementProjections):
        return clip_given_exact(camera, setup.field, setup.size)
    return project_curves(camera, setup.field, setup.curves, setup.size)


def _projected_field(
    camera: CameraOrProjections, polylines: Polylines, measured: Polylines, setup: EvaluationSetup
) -> ProjectedField:
    tables = setup.tables
    ground_only = projects_only_ground(camera)
    left_out = tables.unplaced_names
    if setup.planar_only or (ground_only and setup.off_plane == "left_out"):
        left_out |= tables.off_plane_names
    if setup.is_official:
        left_out |= tables.optional_names
    return ProjectedField(tables.names, polylines, measured, left_out, ground_only, camera)


def project_unclipped(
    camera: CameraOrProjections, setup: EvaluationSetup, only: BoolArray
) -> Polylines:
    """Elements as they go on beyond the picture, whatever the protocol measures distances to: of
    those wanted, ``only`` (E,), the ones that have a part in the picture. See `project_field`."""
    if isinstance(camera, ElementProjections):
        return clip_given_exact(camera, setup.field, setup.size).unclipped.of_elements(only)
    return project_curves(camera, setup.field, setup.curves, setup.size, only=only).unclipped


def project_measured(
    camera: CameraOrProjections, setup: EvaluationSetup
) -> dict[str, tuple[FloatArray, ...]]:
    """Return where a camera shows the elements in sight: all that the protocol measures distances
    to.

    ``soccernet`` ends at the border of the picture. ``procc`` goes on beyond it, for elements that
    are in sight.
    """
    shown = project_field(camera, setup)
    if setup.is_official:
        return shown.pieces
    names = np.array(shown.names)
    whole = project_unclipped(camera, setup, shown.polylines.detected)
    return {str(names[row]): whole.pieces_of(row) for row in whole.detected.nonzero()[0].tolist()}


def complete_projections(
    camera: CameraOrProjections, setup: EvaluationSetup, frame: str
) -> ElementProjections:
    """All that both protocols need of a camera: the same counts and distances at ``setup.size``.

    Under ``procc`` curves are chords that stay within 0.0025 px of them, of the elements that have
    a part in the picture, as far as the camera has a projection but no farther from the picture
    than its width and height together.

    Raises:
        UsageError: these are pieces only, without the official samples.
    """
    if _has_pieces_only(camera):
        raise UsageError("projected polylines alone lack the points of the official evaluation")
    if isinstance(camera, ElementProjections):
        return camera
    of_frame = setup.of_frame(frame)
    tables, names = of_frame.tables, np.array(of_frame.tables.names)
    px, valid = project_samples(camera, tables)
    px = np.where(valid[:, None], px, np.nan)
    rows = np.unique(tables.element_of_sample)
    whole = project_curves(camera, of_frame.field, of_frame.curves, setup.size).unclipped
    return ElementProjections(
        {str(names[row]): whole.pieces_of(row) for row in whole.detected.nonzero()[0].tolist()},
        {str(names[row]): px[tables.element_of_sample == row] for row in rows.tolist()},
        projects_only_ground(camera),
        of_frame.field_sha256,
    )


def projections_error(camera: CameraOrProjections, setup: EvaluationSetup) -> str:
    """Why projections of a frame cannot be judged: they are of another field, or the protocol
    measures beyond the picture; empty if they can. The setup is that of the frame."""
    if not isinstance(camera, ElementProjections):
        return ""
    if camera.field_sha256 and camera.field_sha256 != setup.field_sha256:
        return (
            "is the projection of another field, or of other dimensions: expected"
            f" {setup.field.described}; write it again with save_projection(..., field=...)"
        )
    rows = np.bincount(setup.tables.element_of_sample, minlength=len(setup.tables.names)).tolist()
    count = dict(zip(setup.tables.names, rows, strict=True))
    for name, px in (camera.samples or {}).items():
        if len(px) != count.get(name):
            return f"holds {len(px)} samples of {name!r}, expected {count.get(name, 0)}"
    if setup.is_official:
        return ""
    if not camera.is_clipped(setup.size):
        return ""
    return (
        "its polylines are cut to the picture; the protocol procc measures to where elements go on"
        " beyond it (convert --to polylines and project_field(clipped=False) give these)"
    )


def project_markings(camera: CameraOrProjections, setup: EvaluationSetup) -> ProjectedField | None:
    """The borders of all painted bands in the picture, as true curves whatever the protocol:
    elements of `field.markings.paint_of`. The size of the setup is the picture's.

    None where nothing is painted, or where all that is known of a camera is where it shows the
    elements themselves.
    """
    if isinstance(camera, ElementProjections):
        return None
    paint = marking_field(setup.field)
    if not paint.elements:
        return None
    return project_field(camera, replace(setup, field=paint, protocol="procc"))
