"""Pictures with annotations and what cameras make of them."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.api.inputs import (
    AnyCamera,
    as_annotation,
    as_field,
    as_optional_size,
    as_picture,
    camera_at_size,
)
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction import overlay_figure
from procc_annotator.interaction.overlay import OverlayBuilder, OverlayContent
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.projection import project_markings
from procc_annotator.metrics.score import display_score
from procc_annotator.metrics.setup import EvaluationSetup, check_thresholds
from procc_annotator.report.overlay_scene import OverlayLook, check_pixels


def draw_overlay(
    picture: PixelArray | str | Path,
    annotation: FrameAnnotation | None = None,
    camera: AnyCamera | None = None,
    *,
    field: Field | str | None = None,
    size: tuple[int, int] | None = None,
    camera_size: tuple[int, int] | None = None,
    tau: float = 5.0,
    protocol: str = "soccernet",
    scale: float = 1.0,
    painted_width: bool = False,
    caption: str = "",
) -> PixelArray:
    """A picture with what is annotated in it and where a camera shows the field.

    Colours are those of the window: an annotated element is green where all its points are closer
    than ``tau`` to the projection. Without a camera, elements have the colours of their classes.
    Neither Qt nor a display is needed.

    Args:
        picture: a picture's file, or its pixels, (H, W, 3) or (H, W, 4) uint8, BGR.
        annotation: what is annotated, points normalised; None for nothing.
        camera: as `evaluate` takes it; None for none.
        field: the elements, metres; or a field's name, see `load_field`; the usual one if None.
        size: (width, height) px at which annotation and camera are compared, which ``tau`` belongs
            to; that of the picture if None.
        camera_size: (width, height) px that the camera belongs to, where it is no fit and its file
            does not say it; ``size`` if None (1280x720 for files of homographies).
        tau: px of ``size``.
        protocol: ``soccernet`` or ``procc``.
        scale: px of the result per px of the picture; lines and text grow with it.
        painted_width: whether the borders of painted lines are drawn, too.
        caption: in the lower left corner.

    Returns:
        (H * scale, W * scale, 3) uint8, BGR: what ``cv2.imwrite`` takes; ``[..., ::-1]`` is RGB.

    Raises:
        UsageError: an argument of another kind, see `evaluate`.
        ImageError: the picture cannot be read.
        FieldError: no such field.
    """
    pixels, known = as_picture(picture), as_field(field)
    (threshold,) = check_thresholds((tau,))
    height, width = pixels.shape[:2]
    setup = EvaluationSetup(known, as_optional_size(size) or (width, height), protocol)
    given = FrameAnnotation() if annotation is None else as_annotation(annotation)
    measurement, judged, paint = None, None, None
    if camera is not None:
        used = camera_at_size(camera, setup.size, as_optional_size(camera_size), field=known).camera
        measurement = measure(given, used, setup)
        judged = display_score(measurement, threshold)
        paint = project_markings(used, setup) if painted_width else None
    shown = OverlayContent(
        annotation=given,
        size=setup.size,
        field=known,
        measurement=measurement,
        score=judged,
        picture_size=(width, height),
        paint=paint,
    )
    at, unit = OverlayLook(scale).scale_and_unit(width)
    if at != 1:
        larger = max(1, round(width * at)), max(1, round(height * at))
        check_pixels(*larger)
        method = cv2.INTER_AREA if at < 1 else cv2.INTER_CUBIC
        pixels = np.asarray(cv2.resize(pixels, larger, interpolation=method), np.uint8)
    overlay = OverlayBuilder().build(shown)
    drawn = overlay_figure.draw_overlay(pixels, overlay, scale=at, unit=unit, caption=caption)
    assert not isinstance(drawn, bytes)  # that is an SVG
    return np.ascontiguousarray(drawn[:, :, :3])
