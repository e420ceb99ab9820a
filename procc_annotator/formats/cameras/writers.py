"""Table of camera output formats and writing a set of cameras."""

from __future__ import annotations

import io
import zipfile
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.camera.base import CameraOrProjections, ScaledCamera, scaled_camera
from procc_annotator.camera.matrices import calibration_matrix, translation
from procc_annotator.camera.models import FisheyeCamera, HomographyCamera, PinholeCamera
from procc_annotator.errors import CameraError, UsageError
from procc_annotator.formats.atomic import make_folder, write_atomic
from procc_annotator.formats.cameras.fit_record import (
    DIGEST,
    FIT_KEY,
    with_mark,
)
from procc_annotator.formats.cameras.homography import CONVENTIONS, HOMOGRAPHY_SIZE
from procc_annotator.formats.cameras.krt import write_krt
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera
from procc_annotator.formats.cameras.opencv import write_opencv
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.formats.frame_names import escapes_folder, file_of_frame, is_file_name
from procc_annotator.formats.strict_json import printable
from procc_annotator.metrics.official import folds_into_image, soccernet_tables

OFFICIAL_SIZE = (960, 540)
_NEAREST = " (--region field, or homography_of in Python, gives the nearest one)"
_ZIP_DATE = (1980, 1, 1, 0, 0, 0)  # the same cameras give the same archive
_SIZE_KEYS = ("image_width", "image_height", "width", "height")

Size = tuple[int, int]
Losses = tuple[str, ...]


@dataclass(frozen=True)
class CameraWriter:
    """A format cameras are written to.

    Attributes:
        name: what is typed after ``--to``. title: what people read.
        file_name: the file of a frame, relative to the folder or archive.
        encode: camera -> the file's bytes, and what the format could not hold.
        size: the picture size its pixels belong to by definition; None for any.
        evaluated: whether the official evaluation reads it.
    """

    name: str
    title: str
    file_name: str
    encode: Callable[[LoadedCamera], tuple[bytes, Losses]]
    size: Size | None = None
    evaluated: bool = False


@dataclass
class ConvertedCameras:
    """Files that were written.

    Attributes:
        written: number of cameras.
        problems: one line for each camera that could not be read or that the format cannot hold.
        losses: remarks on the cameras, what of them the format does not hold, and for how many.
        folded: frames with cameras that the official evaluation folds into the picture.
    """

    path: Path
    written: int = 0
    problems: list[str] = field(default_factory=list)
    losses: Counter[str] = field(default_factory=Counter)
    folded: list[str] = field(default_factory=list)


def _soccernet(loaded: LoadedCamera) -> tuple[bytes, Losses]:
    camera = _pinhole(loaded.camera, "a SoccerNet camera")
    extra = dict(loaded.content)
    if loaded.size is not None:
        for key in _SIZE_KEYS:
            extra.pop(key, None)
        extra |= {"image_width": loaded.size[0], "image_height": loaded.size[1]}
    return write_camera(camera, extra | _fit(loaded)), ()


def _submission(loaded: LoadedCamera) -> tuple[bytes, Losses]:
    camera = _pinhole(loaded.camera, "the official evaluation")
    losses = _extra(loaded)
    if loaded.size is None:
        width, height = OFFICIAL_SIZE
        losses = (*losses, f"names no picture size: taken for pixels of {width}x{height}")
    return write_camera(camera, _fit(loaded)), losses


def _of_pose(write: Callable[..., bytes]) -> Callable[[LoadedCamera], tuple[bytes, Losses]]:
    def encode(loaded: LoadedCamera) -> tuple[bytes, Losses]:
        if not isinstance(loaded.camera, PinholeCamera | FisheyeCamera):
            raise ValueError(f"K, R and t cannot hold {_called(loaded.camera)}")
        return write(loaded.camera, loaded.size), _extra(loaded)

    return encode


def _homography(convention: str, as_text: bool) -> Callable[[LoadedCamera], tuple[bytes, Losses]]:
    def encode(loaded: LoadedCamera) -> tuple[bytes, Losses]:
        camera = loaded.camera
        losses = _extra(loaded)
        if isinstance(camera, PinholeCamera) and not camera.is_distorted:
            rotation = camera.rotation_cam_from_world
            seen = np.column_stack((rotation[:, 0], rotation[:, 1], translation(camera)))
            with np.errstate(over="ignore", invalid="ignore"):
                image_from_world = calibration_matrix(camera) @ seen
            losses = (*losses, "everything off the ground")
        elif isinstance(camera, HomographyCamera):
            image_from_world = camera.image_from_world
        elif isinstance(camera, PinholeCamera | FisheyeCamera):
            raise ValueError(f"a homography cannot hold lens distortion{_NEAREST}")
        else:
            raise ValueError(f"a homography cannot hold {_called(camera)}{_NEAREST}")
        if loaded.size is None:
            raise ValueError(
                "the camera names no picture size, a homography needs one (--camera-size)"
            )
        world_from_units = CONVENTIONS[convention].world_from_units
        if not np.isfinite(image_from_world).all():
            raise ValueError("not a camera: a parameter is without bounds")
        try:
            matrix = np.linalg.inv(image_from_world @ world_from_units)
        except np.linalg.LinAlgError as error:
            raise ValueError("the camera lies in the ground") from error
        matrix = matrix / np.abs(matrix).max()
        if as_text:
            lines = (" ".join(repr(float(v)) for v in row) for row in matrix)
            return ("\n".join(lines) + "\n").encode(), losses
        buffer = io.BytesIO()
        np.save(buffer, matrix, allow_pickle=False)
        return buffer.getvalue(), losses

    return encode


WRITERS: tuple[CameraWriter, ...] = (
    CameraWriter("soccernet", "SoccerNet camera JSON", "camera_{}.json", _soccernet, None, True),
    CameraWriter("opencv", "OpenCV FileStorage, YAML", "{}.yml", _of_pose(write_opencv)),
    CameraWriter("krt", "K, R, t and distortion, JSON", "{}.json", _of_pose(write_krt)),
    *(
        CameraWriter(
            name,
            f"homography, {CONVENTIONS[name].title}",
            "{}" + suffix,
            _homography(name, suffix != ".npy"),
            HOMOGRAPHY_SIZE,
        )
        for name, suffix in (("wc14", ".homographyMatrix"), ("carwc", ".npy"), ("world", ".txt"))
    ),
    CameraWriter(
        "submission", "submission to the official evaluation, zip", "{split}/camera_{}.json",
        _submission, OFFICIAL_SIZE, True,
    ),
)  # fmt: skip
CAMERA_TARGETS: tuple[str, ...] = tuple(writer.name for writer in WRITERS)


def writer_of(name: str) -> CameraWriter:
    """The writer of a format. `UsageError` if there is none."""
    for writer in WRITERS:
        if writer.name == name:
            return writer
    raise UsageError(
        f"no format {name!r} to write cameras to; there are {', '.join(CAMERA_TARGETS)}"
    )


def encode_camera(
    loaded: LoadedCamera, to: str, *, size: Size | None = None
) -> tuple[bytes, Losses]:
    """A camera as the content of a file of another format.

    Args:
        loaded: as read; its pixels belong to ``loaded.size``.
        size: (width, height) px the written camera shall be for; by default the camera's own.
            Formats that are for one size are written for that.

    Returns:
        The bytes, and what of the camera the format does not hold.

    Raises:
        UsageError: no such format.
        ValueError: the format cannot hold this camera, and why.
    """
    writer = writer_of(to)
    return _with_mark(writer, _for_size(loaded, writer.size or size))


def write_cameras(
    cameras: Iterable[tuple[str, LoadedCamera | CameraError]],
    out: Path,
    to: str,
    *,
    size: Size | None = None,
    split: str = "test",
    total: int = 0,
    progress: Callable[[int, int], None] | None = None,
) -> ConvertedCameras:
    """Write cameras to a folder, or to an archive: for ``submission``, or if ``out`` ends in .zip.

    Args:
        cameras: frame names with cameras, or with what is wrong with them.
        out: made if it is not there; files of the same names are replaced.
        to, size: as for `encode_camera`.
        total: how many there will be, for ``progress``, which is called with (done, total).

    Raises:
        UsageError: no such format, a split that is no folder's name, or a submission without .zip.
        SaveError: writing failed; an archive is then not there, or the old one.
    """
    writer = writer_of(to)
    if not is_file_name(split):
        raise UsageError(f"{split!r} is not the name of a split (test, challenge, ...)")
    archived = out.suffix.lower() == ".zip"
    if to == "submission" and not archived:
        raise UsageError(f"{out}: a submission is an archive, its name must end in .zip")
    make_folder(out.parent if archived else out)
    done = ConvertedCameras(out)
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for number, (frame, loaded) in enumerate(cameras, 1):
            encoded = _encoded(frame, loaded, writer, size, done)
            if encoded is not None:
                name = _place(writer, frame, split)
                if archived:
                    archive.writestr(zip_entry(name), encoded)
                else:
                    make_folder((out / name).parent)
                    write_atomic(out / name, encoded)
                done.written += 1
            if progress is not None:
                progress(number, total)
    if archived and done.written:
        write_atomic(out, buffer.getvalue())
    return done


def _with_mark(writer: CameraWriter, loaded: LoadedCamera) -> tuple[bytes, Losses]:
    data, losses = writer.encode(loaded)
    return with_mark(data, loaded.fitted_on), losses


def _place(writer: CameraWriter, frame: str, split: str) -> str:
    head, slash, tail = writer.file_name.rpartition("/")
    prefix, suffix = tail.split("{}")
    return f"{head}{slash}".format(split=split) + file_of_frame(frame, suffix, prefix)


def _encoded(
    frame: str,
    loaded: LoadedCamera | CameraError,
    writer: CameraWriter,
    size: Size | None,
    done: ConvertedCameras,
) -> bytes | None:
    if isinstance(loaded, CameraError):
        done.problems.append(str(loaded))
        return None
    shown = printable(frame)
    if escapes_folder(frame) or not all(map(is_file_name, frame.split("/"))):
        done.problems.append(f"{shown}: is no name for a file, expected one without \\ or the like")
        return None
    try:
        loaded = _for_size(loaded, writer.size or size)
        data, losses = _with_mark(writer, loaded)
    except ValueError as error:
        done.problems.append(f"{shown}: {error}; not written")
        return None
    done.losses.update([*loaded.notices, *losses])
    if writer.evaluated and folds_into_image(
        loaded.camera, soccernet_tables(), loaded.size or OFFICIAL_SIZE
    ):
        done.folded.append(shown)
    if size is not None and loaded.size is None and writer.size is None:
        done.losses.update([f"not scaled to {size[0]}x{size[1]}: names no picture size"])
    return data


def _for_size(loaded: LoadedCamera, size: Size | None) -> LoadedCamera:
    if size is None or loaded.size is None or loaded.size == size:
        return loaded
    camera = scaled_camera(loaded.camera, loaded.size, size)
    return replace(loaded, camera=camera, size=size)


def _pinhole(camera: CameraOrProjections, what: str) -> PinholeCamera:
    if not isinstance(camera, PinholeCamera):
        raise ValueError(f"{what} cannot hold {_called(camera)}")
    return camera


def _called(camera: CameraOrProjections) -> str:
    names = {
        "PinholeCamera": "a pinhole camera",
        "FisheyeCamera": "a fisheye camera",
        "HomographyCamera": "a homography (it has no position and no focal length)",
        "ElementProjections": "projected polylines",
    }
    model: object = camera.camera if isinstance(camera, ScaledCamera) else camera
    own = getattr(model, "model", type(model).__name__)
    return names.get(type(camera).__name__, f"a camera model of a plug-in ({own})")


def _fit(loaded: LoadedCamera) -> dict[str, Any]:
    """Return what a file that has a place for it says of the annotation the camera was fitted
    to."""
    if loaded.fitted_on is None:
        return {}
    return {FIT_KEY: loaded.content.get(FIT_KEY, {DIGEST: loaded.fitted_on})}


def _extra(loaded: LoadedCamera) -> Losses:
    left_out = sorted(key for key in loaded.extra if key not in (*_SIZE_KEYS, FIT_KEY))
    return (f"keys left out: {', '.join(map(printable, left_out[:5]))}",) if left_out else ()


def zip_entry(name: str) -> zipfile.ZipInfo:
    """A file of an archive, which is the same for the same content."""
    entry = zipfile.ZipInfo(name, _ZIP_DATE)
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = 0o644 << 16
    return entry
