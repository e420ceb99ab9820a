"""What is believed of a camera that was given for a frame: where a track starts, and passes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.camera.base import Camera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.fit.fitting import fit_camera
from procc_annotator.fit.on_paint.belief import GaussianState, default_state
from procc_annotator.fit.on_paint.expected import expected_line_points
from procc_annotator.fit.on_paint.marks import EdgePoints, edge_point_errors
from procc_annotator.fit.on_paint.painted import MarkingPoints
from procc_annotator.fit.predict.sight import visible_stretches
from procc_annotator.fit.solving.models import vector_from_camera
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame

# A given camera is trusted to show every line so well, solver px; the picture can correct it.
_GIVEN_CAMERA_SD_PX = 1.0
_SAMPLE_POINTS = 12


def nearest_pinhole_vector(camera: Camera, field: Field, frame: ImageFrame) -> FloatArray:
    """(11,) parameters of the pinhole camera that is nearest to any.

    Raises:
        UsageError: none is near it.
    """
    if isinstance(camera, PinholeCamera):
        return vector_from_camera(camera, frame)
    polylines = []
    for stretch in visible_stretches(field, camera, frame.size):
        rows = np.linspace(0, len(stretch.points_px) - 1, _SAMPLE_POINTS).round().astype(int)
        points = [point_from_px(x, y, frame.size) for x, y in stretch.points_px[rows].tolist()]
        polylines.append(Polyline(stretch.name, tuple(points)))
    found = fit_camera(FrameAnnotation(tuple(polylines)), field, model="R", size=frame.size)
    if found.vector is None:
        raise UsageError(
            f"a camera that is to be followed is no camera of this field: {found.failure}"
        )
    return found.vector


def state_from_camera(vector: FloatArray, field: Field, painted: MarkingPoints, frame: ImageFrame) -> GaussianState:
    """What is believed of a frame whose camera (11,) was given: that it shows lines about right."""
    expected = expected_line_points(vector, painted, frame, spacing_px=20.0)
    rows = expected.rows
    across = (expected.px * expected.normal).sum(axis=0)
    marks = EdgePoints(
        painted.world[:, rows], across, expected.normal, painted.element[rows], expected.run
    )
    before = default_state(vector, field)
    _, by = edge_point_errors(vector[None], marks, frame.half_diagonal, len(before.information))
    # The lines of a given camera are off together: they are worth as much as their number.
    lines = len(np.unique(expected.run))
    told = by[0].T @ by[0] * (lines / max(len(rows), 1)) / _GIVEN_CAMERA_SD_PX**2
    return replace(before, vector=vector, information=before.information + told)
