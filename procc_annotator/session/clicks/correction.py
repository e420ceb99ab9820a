"""A frame's camera that somebody corrected by hand: by pegs, and the paint near its lines."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.fit.pegged_on_paint import align_with_control_points
from procc_annotator.fit.pegs import ControlPoint
from procc_annotator.fit.predict.given_camera import external_camera_fit
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.through_shot.track import TrackedFrame
from procc_annotator.image.pixels import PixelArray


@dataclass(frozen=True, eq=False)
class CameraCorrection:
    """A camera that was dragged; no part of any annotation.

    Attributes:
        pegs: the places that were dragged, at least one.
        fit: the camera, px of the picture.
        annotation: of the frame by then: clicks that come later say more.
        looked: whether its lines were looked for in the picture.
        coverage: share of the visible model on paint, 0 to 1; 0 where nobody looked, or in vain.
        residual_px: median distance of that paint, px of the picture; None without any.
        why_not: why the camera is not on paint; empty where it is.
    """

    pegs: tuple[ControlPoint, ...]
    fit: FitResult
    annotation: FrameAnnotation
    looked: bool = False
    coverage: float = 0.0
    residual_px: float | None = None
    why_not: str = ""


def correct_camera(
    camera: PinholeCamera,
    pegs: tuple[ControlPoint, ...],
    size: tuple[int, int],
    annotation: FrameAnnotation,
) -> CameraCorrection:
    """A camera that shows pegs where they are, before its lines were looked for.

    Args:
        camera: px of the picture.
        pegs: at least one.
        size: (width, height) px of the picture.
        annotation: of the frame.
    """
    return CameraCorrection(pegs, external_camera_fit(camera, size), annotation)


def align_to_lines(
    correction: CameraCorrection,
    picture: PixelArray,
    field: Field,
    *,
    go_on: Callable[[], None] = lambda: None,
) -> CameraCorrection:
    """The same on the paint of its picture, where that agrees with the pegs; safe from any thread.

    Args:
        correction: as it was dragged.
        picture: (H, W, 4) BGRA.
        field: the elements.
        go_on: called between the steps; raises whatever it likes when nobody wants the rest.
    """
    go_on()
    camera = correction.fit.camera
    assert isinstance(camera, PinholeCamera)
    found, why_not = align_with_control_points(picture, field, camera, correction.pegs, go_on=go_on)
    if found is None:
        return replace(correction, looked=True, why_not=why_not)
    return replace(
        correction,
        fit=found.fit,
        looked=True,
        coverage=found.coverage,
        residual_px=found.residual_px,
    )


def as_anchor(correction: CameraCorrection, number: int) -> TrackedFrame:
    """A frame of a shot whose camera was corrected."""
    found = correction.coverage, correction.residual_px
    return TrackedFrame(number, "anchor", "", correction.fit, *found, 0)
