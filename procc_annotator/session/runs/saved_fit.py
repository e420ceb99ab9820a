"""A fit kept as the camera of its frame: a file that remembers what it was fitted from."""

from __future__ import annotations

import json
from contextlib import suppress
from pathlib import Path
from typing import Any

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import InputError, SaveError
from procc_annotator.fit.result import FitResult
from procc_annotator.io.atomic import make_folder, write_atomic
from procc_annotator.io.camera_files.fitted_on import SIDECAR_SUFFIX, DIGEST, FIT_KEY, annotation_digest
from procc_annotator.io.camera_files.soccernet_camera import write_camera
from procc_annotator.io.collections import camera_names
from procc_annotator.io.frame_names import file_of_frame
from procc_annotator.io.source import read_file
from procc_annotator.session.runs.calibration_run import camera_file
from procc_annotator.version import __version__

FOLDER = Path("cameras") / "fitted"  # in the dataset's folder


def fitted_folder(dataset: Path) -> Path:
    """Where the fits of a dataset are kept."""
    return dataset / FOLDER


def save_fit(
    folder: Path, frame: str, annotation: FrameAnnotation, fit: FitResult, *, field: str
) -> Path:
    """Write a fit as the camera of its frame; a fit of the frame that was saved before is replaced.

    A pinhole becomes ``camera_{frame}.json`` in SoccerNet form with a further key ``fit``, a
    homography ``{frame}.npy`` with a ``{frame}.fit`` beside it.

    Args:
        folder: of all saved fits; made if needed.
        annotation: what was fitted.
        field: the field's name.

    Returns:
        the camera's file.

    Raises:
        SaveError: writing failed, or a camera that is no saved fit is in the file's place.
        ValueError: the fit has no camera.
    """
    name, data = camera_file(frame, fit)
    path = folder / name
    beside = folder / file_of_frame(frame, SIDECAR_SUFFIX)
    others = _cameras_of(folder, frame)
    for there in others:
        if not _is_saved_fit(there, beside):
            raise SaveError(
                f"{there}: is a camera that was not saved as a fit (move it away to save this one)"
            )
    what = _fitted_from(annotation, fit, field)
    make_folder(path.parent)
    if isinstance(fit.camera, PinholeCamera):
        size = {"image_width": fit.size[0], "image_height": fit.size[1]}
        write_atomic(path, write_camera(fit.camera, {**size, FIT_KEY: what}))
        others = [*others, beside]
    else:
        # First what it was fitted from: without it the camera could not be replaced later.
        write_atomic(beside, (json.dumps(what, indent=2, ensure_ascii=False) + "\n").encode())
        write_atomic(path, data)
    for there in others:
        if there != path:  # saved with another model; a frame has one camera
            with suppress(OSError):
                there.unlink(missing_ok=True)
    return path


def _fitted_from(annotation: FrameAnnotation, fit: FitResult, field: str) -> dict[str, Any]:
    """Model, clicks and terms of a fit, and how well it did."""
    known: dict[str, Any] = {
        "program": f"procc-annotator {__version__}",
        "model": fit.model,
        "chosen_because": fit.chosen_because,
        "field": field,
        DIGEST: annotation_digest(annotation),
        "image_size": list(fit.size),
        "elements": [element.name for element in fit.elements if not element.left_out],
        "left_out": list(fit.left_out),
        "mean_residual_px": fit.mean_px,
        "point_sd_px": fit.error_px,
    }
    if (sd := fit.deviations) is not None:
        known["standard_deviations"] = {
            "pan_rad": sd.pan_rad,
            "tilt_rad": sd.tilt_rad,
            "roll_rad": sd.roll_rad,
            "position_meters": list(sd.position_m),
            "focal_px": sd.focal_px,
        }
    return known


def _cameras_of(folder: Path, frame: str) -> list[Path]:
    """The files of a frame's camera that are there."""
    paths = [folder / name for name in camera_names(frame)]
    return [path for path in paths if path.exists()]


def _is_saved_fit(path: Path, beside: Path) -> bool:
    """Whether a camera's file was written by `save_fit`."""
    if path.suffix != ".json":
        return beside.exists()
    try:
        content = json.loads(read_file(path))
    except (InputError, ValueError, RecursionError):
        return False
    found = content.get(FIT_KEY) if isinstance(content, dict) else None
    return isinstance(found, dict) and str(found.get("program", "")).startswith("procc-annotator ")
