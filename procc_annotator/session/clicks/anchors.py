"""The cameras of annotated frames, as what a track through their shot has to pass."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.errors import InputError
from procc_annotator.field.model import Field
from procc_annotator.field.stadiums import field_for_frame
from procc_annotator.fit.determined import ill_conditioned_reason
from procc_annotator.fit.fitting import fit_camera
from procc_annotator.io.camera_files.fitted_on import annotation_digest
from procc_annotator.session.dataset.workspace import Workspace


class ClickedAnchor(NamedTuple):
    """A camera fitted to clicks, and the `annotation_digest` of these."""

    camera: Camera
    clicks: str


def anchor_camera(
    annotation: FrameAnnotation, field: Field, *, size: tuple[int, int], model: str = "R"
) -> tuple[Camera | None, str]:
    """The camera fitted to clicks, if they determine one; else None and why they do not.

    Args:
        annotation: of a frame.
        field: its elements in that frame.
        size: (width, height) px of the picture.
        model: see `fit_camera`.
    """
    fit = fit_camera(annotation, field, model=model, size=size)
    if fit.camera is None:
        return None, fit.failure or ""
    why = ill_conditioned_reason(fit)
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
    """The camera fitted to each frame's clicks, by number; of those whose clicks determine one.

    Args:
        workspace: the dataset, read as it is now; safe from any thread.
        indices: number in the shot -> index in the dataset, of the frames to look at.
        field: the elements.
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
