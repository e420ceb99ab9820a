"""A camera as a file."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.api.given import AnyCamera, as_annotation, as_camera, as_path, as_optional_size
from procc_annotator.errors import UsageError
from procc_annotator.fit.result import FitResult
from procc_annotator.io.atomic import write_atomic
from procc_annotator.io.camera_files.camera_writers import (
    CAMERA_TARGETS,
    CameraWriter,
    encode_camera,
    writer_of,
)
from procc_annotator.io.camera_files.fitted_on import (
    SIDECAR_SUFFIX,
    DIGEST,
    FIT_KEY,
    annotation_digest,
    sidecar_content,
)
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.version import __version__

_SOCCERNET = "soccernet"


def save_camera(
    camera: AnyCamera,
    path: str | Path,
    *,
    format: str = _SOCCERNET,
    size: tuple[int, int] | None = None,
    fitted_to: FrameAnnotation | None = None,
    overwrite: bool = False,
) -> tuple[str, ...]:
    """Write a camera to a file that `load_camera` and the commands read.

    A folder of ``camera_{frame}.json`` is a source of cameras for ``evaluate``, ``report`` and the
    window.

    Args:
        camera: a pinhole, fisheye or homography, a fit, or one read from a file.
        path: the file; its folder is there.
        format: what ``procc-annotator convert --to`` names: ``soccernet`` (.json), ``opencv``
            (.yml), ``krt`` (.json), or a homography as ``wc14`` (.homographyMatrix), ``carwc``
            (.npy) or ``world`` (.txt).
        size: (width, height) px of the picture. A plain camera belongs to it; fits, and cameras
            whose file told theirs, are scaled to it. Homographies need one.
        fitted_to: the annotation that the camera was fitted to, where ``camera`` does not know it
            (a fit does). The file, or one beside it that ends in .fit, then says so, and the camera
            is marked and not ranked wherever it is judged by these clicks.
        overwrite: whether a file that is there may be replaced.

    Returns:
        What the format could not hold of the camera, one line each.

    Raises:
        UsageError: no such format, one that cannot hold this camera, a name that does not end as
            files of the format do, or a file that is there.
        SaveError: writing failed.
    """
    file, writer = as_path(path, "a camera's file"), _writer(format)
    suffix = Path(writer.file_name).suffix
    if file.suffix.lower() != suffix.lower():
        raise UsageError(f"{file}: expected a name that ends in {suffix} (format {format})")
    if not overwrite and os.path.lexists(file):
        raise UsageError(f"{file}: is there already (overwrite=True replaces it)")
    loaded = _with_size(camera, as_optional_size(size))
    if fitted_to is not None:
        digest = annotation_digest(as_annotation(fitted_to))
        program = f"procc-annotator {__version__}"
        what = {"program": program, "model": loaded.model, DIGEST: digest}
        loaded = replace(loaded, fitted_on=digest, content={**loaded.content, FIT_KEY: what})
    try:
        data, losses = encode_camera(loaded, format, size=as_optional_size(size))
    except ValueError as error:
        raise UsageError(f"{file}: not written: {error}") from None
    beside = file.with_suffix(SIDECAR_SUFFIX)
    if loaded.fitted_on is not None and not writer.evaluated:  # the others say it themselves
        write_atomic(beside, sidecar_content(loaded.fitted_on))
    else:
        beside.unlink(missing_ok=True)  # of the camera that was there before
    write_atomic(file, data)
    return losses


def _writer(name: str) -> CameraWriter:
    alone = [target for target in CAMERA_TARGETS if target != "submission"]
    if name not in alone:
        raise UsageError(f"no format {name!r} for one camera; there are {', '.join(alone)}")
    return writer_of(name)


def _with_size(camera: AnyCamera, size: tuple[int, int] | None) -> LoadedCamera:
    """The camera with the size (px) that its pixels belong to."""
    if isinstance(camera, LoadedCamera):
        return camera if camera.size is not None else replace(camera, size=size)
    if isinstance(camera, FitResult):
        if camera.camera is None:
            raise UsageError(f"there is no camera to write, the fit failed: {camera.failure}")
        return LoadedCamera(camera.camera, camera.model, camera.size, fitted_on=camera.fitted_on)
    as_camera(camera, "camera")
    return LoadedCamera(camera, str(getattr(camera, "model", type(camera).__name__)), size)
