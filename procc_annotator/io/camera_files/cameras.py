"""Read a camera file of any known format and bring it to the size it is judged at."""

from __future__ import annotations

from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.camera.projections import CameraOrProjections, ElementProjections
from procc_annotator.camera.scaling import scaled_camera
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.camera_files.registry import CAMERA_FORMATS, format_of

_FAR = 0.2  # of the picture's size
_EXACT = 1e-6  # px

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
    unsized: tuple[int, int] | None = None,
) -> tuple[CameraOrProjections, str | None]:
    """The camera in pixels of the evaluation size, and a remark when it had to be scaled.

    Args:
        loaded: as read.
        size: (width, height) of the evaluation, px.
        camera_size: what the user says the camera's pixels belong to, where its file does not say.
        unsized: what they belong to where nothing says it; None for ``size``.
    """
    camera = loaded.camera
    if isinstance(camera, ElementProjections):
        # Shares of the picture, which belong to any size: nothing to remark.
        return scaled_camera(camera, loaded.size or size, size), None
    told = loaded.size_where(camera_size)
    own = told or unsized or size
    said = f"{own[0]}x{own[1]}"
    if loaded.size not in (None, own):
        said += f" (usual: {loaded.size[0]}x{loaded.size[1]})"
    if own != size:
        return scaled_camera(camera, own, size), f"scaled from {said} to {size[0]}x{size[1]}"
    if told is None:
        return camera, _doubt(camera, size)
    return camera, None if loaded.size in (None, own) else f"taken for {said}"


def _doubt(camera: CameraOrProjections, size: tuple[int, int]) -> str | None:
    """A remark when a camera that names no picture size hardly belongs to this one.

    It is still taken as it is, as the official evaluation does: guessing would fail silently.
    """
    if not isinstance(camera, PinholeCamera | FisheyeCamera):
        return None
    x, y = camera.principal_point_px
    width, height = size
    off_x, off_y = abs(x - width / 2), abs(y - height / 2)
    if off_x > _FAR * width or off_y > _FAR * height:
        place = f"far from the middle of {width}x{height}"
    elif (own := _exact_middle_of(x, y)) is not None and max(off_x, off_y) > 1:
        place = f"in the exact middle of {own[0]}x{own[1]}, not of {width}x{height}"
    else:
        return None
    return (
        f"principal point {place}: if the camera belongs to another picture size, name it"
        " (camera size)"
    )


def _exact_middle_of(x: float, y: float) -> tuple[int, int] | None:
    """The (width, height) px a principal point was put in the middle of, be that (width - 1) / 2 or
    width / 2; None for one that was fitted."""
    twice = round(2 * x), round(2 * y)
    if min(twice) < 2 or any(abs(2 * v - t) > _EXACT for v, t in zip((x, y), twice, strict=True)):
        return None
    return twice[0] + twice[0] % 2, twice[1] + twice[1] % 2
