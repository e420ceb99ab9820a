"""Read a camera file of any known format and bring it to the size it is judged at."""

from __future__ import annotations

from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.camera.projections import CameraOrProjections, ElementProjections
from procc_annotator.camera.scaling import scaled
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.camera_files.registry import CAMERA_FORMATS, format_of

_FAR = 0.2  # of the picture's size

__all__ = ["CAMERA_FORMATS", "LoadedCamera", "fit_to_size", "read_camera_file"]


def read_camera_file(data: bytes, *, path: str, fmt: str = "auto") -> LoadedCamera:
    """Read a camera.

    Args:
        data: the file's bytes.
        path: its name; ``auto`` goes by the suffix.
        fmt: one of `CAMERA_FORMATS`.

    Raises:
        CameraError: the file is damaged or of an unknown kind.
        UsageError: no such format.
    """
    return format_of(path, fmt).read(data, path=path)


def fit_to_size(
    loaded: LoadedCamera,
    size: tuple[int, int],
    camera_size: tuple[int, int] | None = None,
) -> tuple[CameraOrProjections, str | None]:
    """The camera in pixels of the evaluation size, and a remark when it had to be scaled.

    Args:
        loaded: as read.
        size: (width, height) of the evaluation, px.
        camera_size: what the user says the camera's pixels belong to; beats the file.
    """
    camera = loaded.camera
    if isinstance(camera, ElementProjections):
        # Shares of the picture, which belong to any size: nothing to remark.
        return scaled(camera, loaded.size or size, size), None
    own = camera_size or loaded.size
    if own is None:
        return camera, _doubt(camera, size)
    if own == size:
        return camera, None
    notice = f"scaled from {own[0]}x{own[1]} to {size[0]}x{size[1]}"
    return scaled(camera, own, size), notice


def _doubt(camera: CameraOrProjections, size: tuple[int, int]) -> str | None:
    """A remark when a camera that names no picture size hardly belongs to this one.

    It is still taken as it is, as the official evaluation does: guessing would fail silently.
    """
    if not isinstance(camera, PinholeCamera | FisheyeCamera):
        return None
    x, y = camera.principal_point_px
    width, height = size
    if abs(x - width / 2) <= _FAR * width and abs(y - height / 2) <= _FAR * height:
        return None
    return (
        f"principal point far from the middle of {width}x{height}: if the camera belongs to another"
        " picture size, name it (camera size)"
    )
