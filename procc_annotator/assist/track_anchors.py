"""Known cameras that start a track: corrected by hand, fitted to annotations, from files."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.line_alignment.control_points import (
    ControlPoint,
    align_with_control_points,
)
from procc_annotator.calibration.optimization.camera_placement import too_few_elements_text
from procc_annotator.calibration.optimization.robust_fit import MIN_ELEMENTS
from procc_annotator.calibration.result import (
    FitResult,
    external_camera_fit,
    ill_conditioned_reason,
)
from procc_annotator.calibration.tracking.track import TrackedFrame
from procc_annotator.camera.base import Camera, ElementProjections
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.annotation_source import FrameAnnotations
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.picture_sizes import picture_size
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import CameraError, InputError
from procc_annotator.field.load import field_for_frame
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.fit_record import annotation_digest
from procc_annotator.formats.cameras.loaded_camera import fit_to_size
from procc_annotator.formats.cameras.writers import OFFICIAL_SIZE
from procc_annotator.image.pixels import PixelArray


@dataclass(frozen=True, eq=False)
class CameraCorrection:
    """A camera that was dragged; no part of any annotation.

    Attributes:
        pegs: the places that were dragged, at least one.
        fit: the camera, px of the picture.
        annotation: of the frame by then: clicks that come later say more.
        looked: whether its lines were looked for in the picture.
        coverage: share of the visible model on paint, 0 to 1; 0 where no one looked, or in vain.
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
    """A camera, px of the picture, that shows one or more pegs where they are, before its lines
    were looked for."""
    return CameraCorrection(pegs, external_camera_fit(camera, size), annotation)


def align_to_lines(
    correction: CameraCorrection,
    picture: PixelArray,
    field: Field,
    *,
    go_on: Callable[[], None] = lambda: None,
) -> CameraCorrection:
    """The same on the paint of its picture (H, W, 4) BGRA, where that agrees with the pegs; safe
    from any thread. ``go_on`` is called between the steps; it raises whatever it likes to end
    them."""
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
    """A frame of a shot with a corrected camera."""
    found = correction.coverage, correction.residual_px
    return TrackedFrame(number, "anchor", "", correction.fit, *found, 0)


class ClickedAnchor(NamedTuple):
    """A camera fitted to clicks, and the `annotation_digest` of these."""

    camera: Camera
    clicks: str


def anchor_camera(
    annotation: FrameAnnotation, field: Field, *, size: tuple[int, int], model: str = "R"
) -> tuple[Camera | None, str]:
    """The camera fitted to clicks, if they determine one; else None and why they do not. For the
    model see `fit_camera`; (width, height) px of the picture."""
    fit = fit_camera(annotation, field, model=model, size=size)
    if fit.camera is None:
        return None, fit.failure or ""
    why = ill_conditioned_reason(fit)
    if len(fit.elements) <= MIN_ELEMENTS:  # a wrong one among them would fit as well
        why = too_few_elements_text(len(fit.elements), MIN_ELEMENTS + 1)
    return (None, why) if why else (fit.camera, "")


def anchors_of(
    workspace: Workspace,
    indices: Mapping[int, int],
    field: Field,
    *,
    size: tuple[int, int],
    model: str = "R",
    go_on: Callable[[], None] = lambda: None,
) -> dict[int, ClickedAnchor]:
    """The camera fitted to each frame's clicks, by number; of those with clicks that determine one.

    Args:
        workspace: the dataset, read as it is now; safe from any thread.
        indices: number in the shot -> index in the dataset, of the frames to look at.
        size: (width, height) px of the pictures.
        model: see `fit_camera`.
        go_on: called between frames.
    """
    found: dict[int, ClickedAnchor] = {}
    for number, index in sorted(indices.items()):
        go_on()
        try:
            annotation = workspace.read(index)
        except InputError:
            continue  # told when that frame is opened
        if not annotation.annotated:
            continue
        shown = field_for_frame(field, workspace.frames[index].name)
        camera, _ = anchor_camera(annotation, shown, size=size, model=model)
        if camera is not None:
            found[number] = ClickedAnchor(camera, annotation_digest(annotation))
    return found


@dataclass
class TrackAnchors:
    """Cameras that are known.

    Attributes:
        cameras: by number of the frame, px of the pictures.
        clicks: of those that are fits to an annotation, its `annotation_digest`.
        remarks: on cameras, and annotated frames that give none with the reason, one line each.
        errors: annotations, pictures and cameras that cannot be used, one line each.
    """

    cameras: dict[int, Camera] = field(default_factory=dict)
    clicks: dict[int, str] = field(default_factory=dict)
    remarks: list[str] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)

    def add_cameras(
        self,
        frames: Sequence[Frame],
        collection: CameraCollection,
        camera_size: tuple[int, int] | None,
    ) -> None:
        """Add the cameras of files; an anchor that is there already stays. Where the files do not
        say, their pixels belong to ``camera_size``, (width, height)."""
        for number, frame in enumerate(frames):
            if number in self.cameras or frame.name not in collection.frames:
                continue
            try:
                loaded = collection.read(frame.name)
                size = picture_size(frame.image_path)
            except (CameraError, InputError) as error:
                self.errors.append(str(error))
                continue
            self.remarks += [n for n in loaded.notices if n not in self.remarks]
            camera, _ = fit_to_size(loaded, size, camera_size, OFFICIAL_SIZE)
            if isinstance(camera, ElementProjections):
                self.errors.append(f"{collection.display(frame.name)}: holds no camera to follow")
            else:
                self.cameras[number] = camera

    def add_annotated(self, frames: Sequence[Frame], given: FrameAnnotations, field: Field) -> None:
        """Add a fit to every annotated frame that gives a camera to rely on."""
        for number, frame in enumerate(frames):
            try:
                annotation = given.read(frame, field)
                if annotation is None or not annotation.annotated:
                    continue
                size = picture_size(frame.image_path)
            except InputError as error:
                self.errors.append(str(error))
                continue
            camera, why = anchor_camera(annotation, field_for_frame(field, frame.name), size=size)
            if camera is None:
                self.remarks.append(f"{frame.name}: its annotation is no anchor: {why}")
                continue
            self.cameras[number] = camera
            self.clicks[number] = annotation_digest(annotation)
