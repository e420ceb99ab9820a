"""Cameras from matrices and functions, saving them, and drawing what they show."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from procc_annotator.annotation import FrameAnnotation, as_size
from procc_annotator.api.inputs import (
    AnyCamera,
    as_annotation,
    as_field,
    as_optional_size,
    as_path,
    as_picture,
    camera_at_size,
    loaded_camera,
)
from procc_annotator.arrays import FloatArray
from procc_annotator.camera.base import Camera
from procc_annotator.camera.custom import FunctionCamera, ValidatedCamera
from procc_annotator.camera.matrices import (
    decompose_projection,
    fisheye_from_parts,
    intrinsics_from_matrix,
    pinhole_from_parts,
    pose_from_rt,
)
from procc_annotator.camera.models import (
    FisheyeCamera,
    HomographyCamera,
    MatrixCamera,
    PinholeCamera,
)
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.figures import overlay
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.cameras.fit_record import DIGEST, FIT_KEY, annotation_digest
from procc_annotator.formats.cameras.writers import (
    CAMERA_TARGETS,
    CameraWriter,
    encode_camera,
    writer_of,
)
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.projection import project_markings
from procc_annotator.metrics.score import display_score
from procc_annotator.metrics.setup import EvaluationSetup, check_thresholds
from procc_annotator.report.overlay_scene import OverlayLook, Scene
from procc_annotator.version import __version__


def camera_from_krt(
    k: ArrayLike,
    r: ArrayLike,
    t: ArrayLike,
    *,
    distortion: ArrayLike | None = None,
    fisheye: bool = False,
    size: tuple[int, int] | None = None,
) -> PinholeCamera | FisheyeCamera:
    """A camera from OpenCV's matrices: x_cam = R x_world + t, pixel = K x_cam / depth.

    The world frame is that of `Field`: metres, origin at the field's centre, x along its length, y
    across towards the main camera, **z down**. A camera of a world with z up is brought there by
    R @ diag(1, -1, -1).

    Args:
        k: (3, 3) px, without skew.
        r: (3, 3) rotation world -> camera, or (3,) rad, OpenCV's rotation vector.
        t: (3,) metres.
        distortion: OpenCV's k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 s2 s3 s4]]], in a row or a column;
            k1 k2 k3 k4 of a fisheye; None for none.
        fisheye: whether the lens is OpenCV's fisheye.
        size: (width, height) px of the picture; says how far a skew would move its pixels.

    Returns:
        The camera, in px of the picture that K belongs to.

    Raises:
        UsageError: a matrix of another shape, one that is not what it should be (with what is
            wrong), or a skew: `camera_from_projection` takes those.
    """
    rotation = _numbers("r", r)
    if rotation.size == 3:
        import cv2

        rotation = np.asarray(cv2.Rodrigues(rotation.reshape(3))[0], dtype=np.float64)
    try:
        inside = intrinsics_from_matrix(_numbers("k", k), as_optional_size(size))
        pose = pose_from_rt(rotation, _numbers("t", t).reshape(-1))
        coefficients = _numbers("distortion", () if distortion is None else distortion).reshape(-1)
        return (fisheye_from_parts if fisheye else pinhole_from_parts)(
            inside, pose, coefficients.tolist()
        )
    except ValueError as error:
        raise UsageError(f"no camera: {error}") from None


def camera_from_projection(
    matrix: ArrayLike, *, size: tuple[int, int] | None = None
) -> PinholeCamera | MatrixCamera:
    """A camera from a projection matrix, P = K [R | t] times any number.

    Args:
        matrix: (3, 4), metres in the world (x, y, z, 1; world frame of `Field`, z down) to px. It
            may have a skew; its sign does not matter.
        size: (width, height) px of the picture; says how far a skew moves its pixels.

    Returns:
        The camera, in px of the picture that the matrix is for: a pinhole with angles, position and
        focal lengths, unless the matrix has a skew that moves a pixel by more than 0.01 px, which
        only the matrix itself can say.

    Raises:
        UsageError: not (3, 4) finite numbers, or a camera that is infinitely far away.
    """
    known = as_optional_size(size)
    try:
        camera = MatrixCamera.of(_numbers("matrix", matrix))
    except ValueError as error:
        raise UsageError(f"matrix: no projection matrix: {error}") from None
    try:
        k, rotation, t = decompose_projection(camera.image_from_world)
        return pinhole_from_parts(intrinsics_from_matrix(k, known), pose_from_rt(rotation, t), ())
    except ValueError:  # a skew, or numbers too near to no camera to be taken apart
        return camera


def camera_from_homography(
    matrix: ArrayLike, size: tuple[int, int], *, to_ground: bool = False
) -> HomographyCamera:
    """A camera that knows the ground only, from a homography.

    Args:
        matrix: (3, 3), metres on the ground (x, y, 1; world frame of `Field`) to px.
        size: (width, height) px of the picture. A homography does not distinguish front from
            behind: the lower edge of the picture is taken to show ground in front of the camera.
        to_ground: whether the matrix is the other way, px to metres.

    Returns:
        The camera, in px of ``size``.

    Raises:
        UsageError: not (3, 3) finite numbers, or a matrix that cannot be inverted.
    """
    given = _numbers("matrix", matrix)
    try:
        if not to_ground and given.shape == (3, 3):
            given = np.linalg.inv(given).astype(np.float64)
        return HomographyCamera.from_world_from_image(given, as_size(size))
    except (ValueError, np.linalg.LinAlgError) as error:
        raise UsageError(f"matrix: no homography: {error}") from None


def camera_from_function(
    function: Callable[[FloatArray], Any], *, ground_only: bool = False
) -> Camera:
    """A camera that is a function of places in the world.

    Args:
        function: takes (N, 3) metres, world frame of `Field` (z down), and returns (N, 2) px; NaN
            for points that have no projection: behind the camera, or where the lens model folds.
            Or it returns those and (N,) bool, which points have one. Pixels of points behind the
            camera are lines where there are none: ``cv2.projectPoints``, say, does not give them.
        ground_only: whether it knows the plane z = 0 only, as a homography does.

    Returns:
        The camera, in px of the picture that the function is for. Whatever the function returns is
        checked, each time: another shape or kind, or a point that is said to be valid without
        finite pixels, is a `UsageError`.

    Raises:
        UsageError: it is no function.
    """
    if not callable(function):
        raise UsageError(f"expected a function, found {type(function).__name__}")
    return ValidatedCamera(FunctionCamera(function, ground_only), "the camera")


def _numbers(name: str, values: ArrayLike) -> FloatArray:
    try:
        return np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise UsageError(f"{name}: expected numbers, found {type(values).__name__}") from None


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
            whose file states theirs, are scaled to it. Homographies need one.
        fitted_to: the annotation that the camera was fitted to, where ``camera`` does not know it
            (a fit does). The file then says so, and the camera is marked and not ranked wherever
            it is judged by these clicks.
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
    loaded = loaded_camera(camera, "camera")
    if loaded.size is None:
        loaded = replace(loaded, size=as_optional_size(size))
    if fitted_to is not None:
        digest = annotation_digest(as_annotation(fitted_to))
        program = f"procc-annotator {__version__}"
        what = {"program": program, "model": loaded.model, DIGEST: digest}
        loaded = replace(loaded, fitted_on=digest, content={**loaded.content, FIT_KEY: what})
    try:
        data, losses = encode_camera(loaded, format, size=as_optional_size(size))
    except ValueError as error:
        other = "; save_projection keeps where a camera of any model shows the field"
        raise UsageError(f"{file}: not written: {error}{other}") from None
    write_atomic(file, data)
    return losses


def _writer(name: str) -> CameraWriter:
    alone = [target for target in CAMERA_TARGETS if target != "submission"]
    if name not in alone:
        raise UsageError(f"no format {name!r} for one camera; there are {', '.join(alone)}")
    return writer_of(name)


def draw_overlay(
    picture: PixelArray | str | Path,
    annotation: FrameAnnotation | None = None,
    camera: AnyCamera | None = None,
    *,
    field: Field | str | None = None,
    size: tuple[int, int] | None = None,
    camera_size: tuple[int, int] | None = None,
    threshold: float = 5.0,
    protocol: str = "soccernet",
    scale: float = 1.0,
    painted_width: bool = False,
    caption: str = "",
) -> PixelArray:
    """A picture with what is annotated in it and where a camera shows the field.

    Colours are those of the window: an annotated element is green where all its points are closer
    than ``threshold`` to the projection. Without a camera, elements have the colours of their
    classes. Neither Qt nor a display is needed.

    Args:
        picture: a picture's file, or its pixels, (H, W, 3) or (H, W, 4) uint8, BGR.
        annotation: what is annotated, points normalised; None for nothing.
        camera: as `evaluate` takes it; None for none.
        size: (width, height) px at which annotation and camera are compared, which ``threshold``
            belongs to; that of the picture if None.
        field: and camera_size, threshold, protocol: as of `evaluate`.
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
    (chosen,) = check_thresholds(threshold)
    height, width = pixels.shape[:2]
    setup = EvaluationSetup(known, as_optional_size(size) or (width, height), protocol)
    given = FrameAnnotation() if annotation is None else as_annotation(annotation)
    measurement, judged, paint = None, None, None
    if camera is not None:
        used = camera_at_size(camera, setup.size, as_optional_size(camera_size), field=known).camera
        measurement = measure(given, used, setup)
        judged = display_score(measurement, chosen)
        paint = project_markings(used, setup) if painted_width else None
    scene = Scene(None, given, setup, measurement, judged, paint=paint)
    shown = overlay.scene_content(scene, pixels)
    drawn = overlay.draw_overlay(pixels, shown, OverlayLook(scale), caption=caption)
    assert not isinstance(drawn, bytes)  # that is an SVG
    return np.ascontiguousarray(drawn[:, :, :3])
