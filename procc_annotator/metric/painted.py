"""Where a camera shows the paint of the field's lines."""

from __future__ import annotations

from dataclasses import replace

from procc_annotator.camera.projections import CameraOrProjections, ElementProjections
from procc_annotator.field.paint import paint_of
from procc_annotator.metric.project import ProjectedField, project_field
from procc_annotator.metric.setup import EvaluationSetup


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
