"""Check and convert the arguments of public functions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from procc_annotator.annotation import FrameAnnotation, as_size
from procc_annotator.batch.scoring import FrameInput
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.base import Camera, CameraOrProjections, ElementProjections
from procc_annotator.camera.custom import validated_camera
from procc_annotator.camera.models import model_name
from procc_annotator.dataset.dataset_field import MAX_PIXEL_ASPECT
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field, load_field_of
from procc_annotator.field.model import Field, PixelAspect
from procc_annotator.formats.cameras.fit_record import DIGEST, FIT_KEY, UNCERTAINTY
from procc_annotator.formats.cameras.loaded_camera import (
    NAME_THE_FORMAT,
    LoadedCamera,
    field_mismatch,
    fit_to_size,
    with_plausibility_remark,
)
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray, bgra_from_bgr
from procc_annotator.messages import pluralize
from procc_annotator.metrics.projection import projections_error
from procc_annotator.metrics.setup import EvaluationSetup

if TYPE_CHECKING:
    import pandas

AnyCamera = Camera | ElementProjections | FitResult | LoadedCamera
"""A camera as a caller has it: of any model, fitted, or read from a file."""


@dataclass(frozen=True)
class CameraInPixels:
    """A camera in px of a size.

    Attributes:
        model: as tables call it.
        fitted_on: what it was fitted to, see `LoadedCamera`.
    """

    camera: CameraOrProjections
    model: str
    fitted_on: str | None = None


def camera_at_size(
    camera: object,
    size: tuple[int, int],
    camera_size: tuple[int, int] | None = None,
    name: str = "camera",
    *,
    field: Field,
) -> CameraInPixels:
    """A camera in px of a picture size; what those of others return is checked from now on.

    Args:
        camera: as a caller gave it.
        size: (width, height) px.
        camera_size: (width, height) px that cameras belong to which do not say it; None for
            ``size``.
        name: how to call it where it is none.
        field: what its picture shows.

    Raises:
        UsageError: it is no camera, a fit that failed, or would be taken for one of another field.
    """
    loaded = loaded_camera(camera, name)
    if problem := field_mismatch(loaded.assumed_field, field):
        raise UsageError(f"{name}: {problem} ({NAME_THE_FORMAT})")
    used = validated_camera(fit_to_size(loaded, size, camera_size)[0], name)
    read = isinstance(camera, LoadedCamera)
    model = model_name(used, loaded.model, size) if read else loaded.model
    return CameraInPixels(used, model, loaded.fitted_on)


def evaluated_camera(
    camera: object,
    setup: EvaluationSetup,
    camera_size: tuple[int, int] | None = None,
    name: str = "camera",
) -> CameraInPixels:
    """As `camera_at_size`, for a camera that is judged; UsageError also for projections that the
    protocol cannot judge."""
    found = camera_at_size(camera, setup.size, camera_size, name, field=setup.field)
    if problem := projections_error(found.camera, setup):
        raise UsageError(f"{name}: {problem}")
    return found


def loaded_camera(camera: object, name: str) -> LoadedCamera:
    """A camera as a file of it would be read; its size is None where nothing says it. Raises
    UsageError for what is none, or a fit that failed."""
    if isinstance(camera, LoadedCamera):
        return camera
    if isinstance(camera, FitResult):
        if camera.camera is None:
            raise UsageError(f"{name}: there is no camera, the fit failed: {camera.failure}")
        what = {"model": camera.model, DIGEST: camera.fitted_on, UNCERTAINTY: camera.uncertainty}
        return LoadedCamera(
            camera.camera, camera.model, camera.size, content={FIT_KEY: what},
            fitted_on=camera.fitted_on,
        )  # fmt: skip
    own = as_camera(camera, name)
    return LoadedCamera(own, str(getattr(own, "model", type(own).__name__)))


def position_remarks(cameras: Iterable[CameraInPixels | FrameInput]) -> tuple[str, ...]:
    """One line for cameras that stand below the ground, as in a world with z up, or far away."""
    loaded = (LoadedCamera(c.camera, c.model) for c in cameras if c.camera is not None)
    found = [remark for one in loaded for remark in with_plausibility_remark(one).notices]
    return (f"{found[0]} ({pluralize(len(found), 'camera')})",) if found else ()


def as_camera(camera: object, name: str) -> CameraOrProjections:
    """A camera of any model, its answers checked from now on; UsageError for what is none."""
    if isinstance(camera, type):
        raise UsageError(f"{name}: {camera.__name__} is a class; give a camera made of it")
    if isinstance(camera, ElementProjections) or callable(getattr(camera, "project", None)):
        return validated_camera(camera, name)  # type: ignore[arg-type]
    if camera is None:
        raise UsageError("there is no camera to evaluate (a fit that failed says why in `failure`)")
    hint = ""
    if callable(camera):
        hint = "; camera_from_function makes one of a function"
    elif isinstance(camera, np.ndarray):
        hint = "; camera_from_projection and camera_from_homography make one of a matrix"
    raise UsageError(
        f"{name}: expected a camera (an object with `project`), found {kind_of(camera)}{hint}"
    )


def as_annotation(annotation: object) -> FrameAnnotation:
    """An annotation; UsageError for what is none."""
    if isinstance(annotation, FrameAnnotation):
        return annotation
    hint = ""
    if isinstance(annotation, str | Path):
        hint = " (load_annotation(path) reads one)"
    elif isinstance(annotation, Mapping):
        hint = " (FrameAnnotation.from_dict makes one)"
    raise UsageError(f"expected an annotation (FrameAnnotation), found {kind_of(annotation)}{hint}")


def as_field(field: object, pixel_aspect: float | None = None) -> Field:
    """A field, or the one of that name or file; the usual one for None; with the pixel aspect of
    its pictures, if one is given. UsageError for what is neither, FieldError for no such field."""
    if pixel_aspect is not None:
        if not isinstance(pixel_aspect, int | float) or not 0 < pixel_aspect < MAX_PIXEL_ASPECT:
            raise UsageError(
                "pixel_aspect: expected the width of a pixel over its height, more than 0 and less"
                f" than {MAX_PIXEL_ASPECT:g}, found {pixel_aspect!r}"
            )
        return replace(as_field(field), pixels=PixelAspect(float(pixel_aspect), 1.0))
    if isinstance(field, Field):
        return field
    if field is None:
        return load_field()
    if isinstance(field, str | Path):
        return load_field_of(field) if isinstance(field, str) else load_field(field)
    raise UsageError(f"expected a field, its name or its .toml file, found {kind_of(field)}")


def as_whole_number(value: object, name: str, least: int) -> int:
    """A whole number; UsageError for what is none, or below ``least``."""
    if not isinstance(value, int) or value < least:
        raise UsageError(f"{name}: expected a whole number, at least {least}, found {value!r}")
    return value


def as_frame_names(frames: object) -> tuple[str, ...] | None:
    """Names of frames, each once; None stays None. UsageError for what are none."""
    if frames is None:
        return None
    if isinstance(frames, Iterable) and not isinstance(frames, str):
        names = tuple(dict.fromkeys(frames))
        if names and all(isinstance(name, str) for name in names):
            return names
    raise UsageError(f"frames: expected names of frames, at least one, found {frames!r}")


def as_path(path: object, what: str) -> Path:
    """A path; UsageError for what is none, ``what`` says of what."""
    if isinstance(path, str | Path):
        return Path(path)
    raise UsageError(f"expected the path of {what}, found {kind_of(path)}")


def as_optional_size(size: Any) -> tuple[int, int] | None:
    """The same; None stays None."""
    return None if size is None else as_size(size)


def as_picture(picture: object) -> PixelArray:
    """(H, W, 4) BGRA of a picture's file or its pixels; UsageError for what is none, ImageError
    for a file that cannot be read."""
    if isinstance(picture, str | Path):
        return decode_bgra(Path(picture))
    return as_pixels(picture)


def as_pixels(picture: object) -> PixelArray:
    """(H, W, 4) BGRA of a picture's pixels; UsageError for what are none."""
    right = isinstance(picture, np.ndarray) and picture.dtype == np.uint8 and picture.ndim == 3
    if not isinstance(picture, np.ndarray) or not right or picture.shape[2] not in (3, 4):
        raise UsageError(
            "expected a picture: the path of one, or (H, W, 3) or (H, W, 4) uint8 pixels, found"
            f" {kind_of(picture)}"
        )
    if min(picture.shape[:2]) < 2:
        raise UsageError(f"the picture of {picture.shape[1]}x{picture.shape[0]} px is too small")
    return bgra_from_bgr(picture) if picture.shape[2] == 3 else picture


def dataframe(rows: Sequence[Mapping[str, Any]]) -> pandas.DataFrame:
    """Rows as a pandas DataFrame; UsageError where pandas is not installed."""
    try:
        import pandas
    except ImportError:
        raise UsageError("pandas is not installed; the rows are there as dicts") from None
    return pandas.DataFrame(rows)


def kind_of(value: object) -> str:
    """Return what a value is, in a word."""
    return "nothing" if value is None else type(value).__name__
