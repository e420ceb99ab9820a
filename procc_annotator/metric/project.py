"""The projected field: the visible pieces of every element and of its paint, by either protocol."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.camera.projections import CameraOrProjections, ElementProjections
from procc_annotator.field.paint import paint_of
from procc_annotator.metric.fine import fine_polylines
from procc_annotator.metric.given import given_fine, given_official
from procc_annotator.metric.official import official_polylines
from procc_annotator.metric.polylines import FloatArray, Polylines
from procc_annotator.metric.setup import EvaluationSetup


@dataclass(frozen=True, eq=False)
class ProjectedField:
    """What a camera shows of the field.

    Attributes:
        names: element names, in field order.
        polylines: the visible pieces as flat arrays, px of the evaluation size.
        left_out: classes that do not take part: elements off the ground, where only planar ones are
            evaluated, or for a camera that knows only the ground; optional ones, where the official
            evaluation is followed; landmarks whose place is not known.
        ground_only: whether the camera knows only the ground.
    """

    names: tuple[str, ...]
    polylines: Polylines
    left_out: frozenset[str] = frozenset()
    ground_only: bool = False

    @cached_property
    def pieces(self) -> dict[str, tuple[FloatArray, ...]]:
        """Visible pieces, each (n, 2) px of the evaluation size, of the elements that have any."""
        rows = self.polylines.detected.nonzero()[0].tolist()
        return {self.names[row]: self.polylines.pieces_of(row) for row in rows}


def project_field(camera: CameraOrProjections, setup: EvaluationSetup) -> ProjectedField:
    """Project the field to the evaluation size by the setup's protocol.

    Args:
        camera: parameters in px of ``setup.size``; or, for sources that share no camera, their
            projected polylines, clipped to the picture as the protocol clips a camera's.
        setup: field, size and protocol.
    """
    return project_fields([camera], setup)[0][0]


def project_fields(
    cameras: Sequence[CameraOrProjections], setup: EvaluationSetup
) -> tuple[list[ProjectedField], Polylines]:
    """The same for several frames at once, which is faster.

    Returns:
        What each of them shows, and all of it as `Polylines.joined` has it.
    """
    whole = _polylines(cameras, setup)
    if setup.planar_only:
        whole = whole.of_elements(np.tile(setup.tables.on_ground, len(cameras)))
    fields = [
        _field(camera, polylines, setup)
        for camera, polylines in zip(cameras, whole.of_frames(len(cameras)), strict=True)
    ]
    return fields, whole


def _polylines(cameras: Sequence[CameraOrProjections], setup: EvaluationSetup) -> Polylines:
    real = [camera for camera in cameras if not isinstance(camera, ElementProjections)]
    if setup.is_official and len(real) == len(cameras):
        return official_polylines(real, setup.tables, setup.size)
    return Polylines.joined([_polylines_of(camera, setup) for camera in cameras])


def _polylines_of(camera: CameraOrProjections, setup: EvaluationSetup) -> Polylines:
    if not setup.is_official:
        if isinstance(camera, ElementProjections):
            return given_fine(camera, setup.field, setup.size)
        return fine_polylines(camera, setup.field, setup.curves, setup.size)
    if not isinstance(camera, ElementProjections):
        return official_polylines([camera], setup.tables, setup.size)
    given = given_official(camera, setup.field, setup.size)
    return given.of_elements(setup.tables.is_official)


def _field(
    camera: CameraOrProjections, polylines: Polylines, setup: EvaluationSetup
) -> ProjectedField:
    tables = setup.tables
    ground_only = projects_only_ground(camera)
    left_out = tables.unplaced_names
    if setup.planar_only or (ground_only and setup.off_plane == "left_out"):
        left_out |= tables.off_plane_names
    if setup.is_official:
        left_out |= tables.optional_names
    return ProjectedField(tables.names, polylines, left_out, ground_only)


def project_paint(camera: CameraOrProjections, setup: EvaluationSetup) -> ProjectedField | None:
    """The borders of all painted bands in the picture, as true curves whatever the protocol.

    Args:
        camera: parameters in px of ``setup.size``.
        setup: its field has paint, its size is the picture's.

    Returns:
        Elements of `field.paint.paint_of`; None where nothing is painted, or where all that is
        known of a camera is where it shows the elements themselves.
    """
    if isinstance(camera, ElementProjections):
        return None
    paint = paint_of(setup.field)
    if not paint.elements:
        return None
    return project_field(camera, replace(setup, field=paint, protocol="procc"))
