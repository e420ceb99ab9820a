"""The cameras of all frames of a match in one ``.npz`` file: see docs/reference/files.md.

A text column is two arrays: the place of each frame's text in ``NAME_values``, and these as UTF-8,
divided by line feeds.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from itertools import chain, pairwise
from typing import Any, Self

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.fit_record import DIGEST, FIT_KEY, UNCERTAINTY
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
)

PACKED_SUFFIX = ".npz"
PARAMETERS = (
    "pan_rad", "tilt_rad", "roll_rad", "x_m", "y_m", "z_m", "fx_px", "fy_px", "cx_px", "cy_px",
    "k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2", "s1", "s2", "s3", "s4",
)  # fmt: skip
_VERSION, _MARK, _VALUES = 1, "procc_cameras", "_values"
_MOST_BYTES = 2**30  # once decompressed
_ADVICE = "it may be cut off: write it again"

Texts = tuple[str, ...]


@dataclass(frozen=True, eq=False)
class PackedCameras:
    """The cameras of N frames, by columns; numbers are NaN where they are unknown."""

    frame: Texts
    time_s: FloatArray  # (N,) from the first frame
    shot: Texts  # name of its first frame
    state: Texts  # anchor, followed, bridged, lost, unreadable or set aside
    reason: Texts
    coverage: FloatArray  # (N,) share of the visible model on paint, 0 to 1
    residual_px: FloatArray  # (N,) median distance of that paint from the model
    probability: FloatArray  # (N,) that the camera is right
    anchor_distance: FloatArray  # (N,) frames to the nearest known camera
    size: FloatArray  # (N, 2) width and height of the picture, which the px belong to
    camera: FloatArray  # (N, 22) `PARAMETERS`
    covariance: FloatArray  # (N, K (K + 1) / 2) lower triangle, of the first parameters of a fit
    pixel_aspect: FloatArray  # (N,) width of a pixel over its height
    clicks: Texts  # SHA-256 of the annotation it was fitted to

    def __len__(self) -> int:
        return len(self.frame)

    @classmethod
    def joined(cls, parts: Sequence[PackedCameras]) -> Self:
        """The frames of several, in their order."""
        widest = max((part.covariance.shape[1] for part in parts), default=0)
        wide = [replace(part, covariance=_widened(part.covariance, widest)) for part in parts]
        columns: dict[str, Any] = {}
        for name in _KINDS:
            own = [getattr(part, name) for part in wide]
            columns[name] = tuple(chain(*own)) if name in _TEXTS else np.concatenate(own)
        return cls(**columns)

    def merged(self, other: PackedCameras, names: Sequence[str]) -> Self:
        """These, and those of another one of frames that these lack, in the order of names."""
        both = self.joined([self, other])
        place = {name: i for i, name in reversed(list(enumerate(both.frame)))}
        return both.rows([place[name] for name in names if name in place])

    def rows(self, chosen: Sequence[int] | range) -> Self:
        """Some of the frames."""
        columns: dict[str, Any] = {}
        for name in _KINDS:
            own = getattr(self, name)
            columns[name] = tuple(own[i] for i in chosen) if name in _TEXTS else own[list(chosen)]
        return type(self)(**columns)

    def encoded(self) -> bytes:
        """As a file."""
        arrays: dict[str, Any] = {_MARK: np.array(_VERSION)}
        for name, kind in _KINDS.items():
            column = getattr(self, name)
            if name in _TEXTS:
                values = list(dict.fromkeys(column))
                place = {value: i for i, value in enumerate(values)}
                arrays[name] = np.array([place[value] for value in column], np.int32)
                text = "\n".join(values).encode("utf-8", "surrogateescape")
                arrays[name + _VALUES] = np.frombuffer(text, np.uint8)
            else:
                # Column by column, equal neighbours lie together.
                arrays[name] = np.asfortranarray(column.astype(kind))
        buffer = io.BytesIO()
        np.savez_compressed(buffer, **arrays)
        return buffer.getvalue()

    @classmethod
    def without_cameras(cls, names: Texts, shot: str, state: str, reason: str = "") -> Self:
        """Frames without a camera, in a state for a reason."""
        count = len(names)
        nothing = np.full(count, np.nan)
        return cls(
            names, nothing, (shot,) * count, (state,) * count, (reason,) * count, nothing, nothing,
            nothing, nothing, np.zeros((count, 2)), np.full((count, len(PARAMETERS)), np.nan),
            np.empty((count, 0)), np.ones(count), ("",) * count,
        )  # fmt: skip

    @property
    def has_camera(self) -> BoolArray:
        """(N,) of each frame."""
        return np.asarray(np.isfinite(self.camera).all(axis=1))

    def position_sd_m(self, row: int) -> FloatArray:
        """(3,) standard deviations of the position of a row, metres; NaN where not known."""
        lower = self.covariance[row]
        diagonal = [i * (i + 3) // 2 for i in (3, 4, 5)]
        return np.sqrt(lower[diagonal]) if lower.size > diagonal[-1] else np.full(3, np.nan)

    def pinhole(self, row: int) -> PinholeCamera | None:
        """The camera of a row, px of its picture; None without one."""
        values = self.camera[row].tolist()
        if not np.isfinite(values).all():
            return None
        parts: list[Any] = [
            tuple(values[begin:end]) for begin, end in pairwise((3, 6, 8, 10, 16, 18, 22))
        ]
        return PinholeCamera(*values[:3], *parts)

    def read(self, row: int) -> LoadedCamera | None:
        """The same as read from a file, with what it was fitted to."""
        if (camera := self.pinhole(row)) is None:
            return None
        size = int(self.size[row, 0]), int(self.size[row, 1])
        fit: dict[str, Any] = {DIGEST: self.clicks[row]} if self.clicks[row] else {}
        lower = self.covariance[row]
        if (lower := lower[np.isfinite(lower)]).size:
            fit[UNCERTAINTY] = {
                "size": list(size),
                "pixel_aspect": float(self.pixel_aspect[row]),
                "covariance": _symmetric(lower).tolist(),
            }
        extra = {FIT_KEY: fit} if fit else {}
        return LoadedCamera(camera, "pinhole", size, extra, content=extra)


_TEXTS = ("frame", "shot", "state", "reason", "clicks")
# Shapes of rows: (), or their last axis; None for any.
_WIDTHS: dict[str, int | None] = {"size": 2, "camera": len(PARAMETERS), "covariance": None}
_KINDS = {
    one.name: np.float64 if one.name in ("time_s", "camera") else np.float32
    for one in fields(PackedCameras)
}


def camera_row(camera: PinholeCamera) -> FloatArray:
    """`PARAMETERS` of a camera."""
    pose = camera.pan_rad, camera.tilt_rad, camera.roll_rad, *camera.position_world
    lens = *camera.radial, *camera.tangential, *camera.thin_prism
    return np.array((*pose, *camera.focal_px, *camera.principal_point_px, *lens))


def lower_triangle(covariance: FloatArray, width: int) -> FloatArray:
    """(K, K) -> (width,), the rest NaN."""
    lower = covariance[np.tril_indices(len(covariance))]
    return np.pad(lower, (0, width - len(lower)), constant_values=np.nan)


def _widened(rows: FloatArray, width: int) -> FloatArray:
    return np.pad(rows, ((0, 0), (0, width - rows.shape[1])), constant_values=np.nan)


def _symmetric(lower: FloatArray) -> FloatArray:
    count = int((np.sqrt(8 * len(lower) + 1) - 1) / 2)
    full = np.zeros((count, count))
    full[np.tril_indices(count)] = lower
    return full + np.tril(full, -1).T


def is_packed(data: bytes) -> bool:
    """Return whether bytes are such a file, whole or damaged: its mark comes first in it."""
    return data[:2] == b"PK" and data[30 : 30 + len(_MARK)] == _MARK.encode()


def read_packed(data: bytes, path: str) -> PackedCameras:
    """The cameras of a file. `CameraError` if it is damaged, or of a newer version."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            if sum(one.file_size for one in archive.infolist()) > _MOST_BYTES:
                raise CameraError(path, f"holds more than {_MOST_BYTES} bytes")
        with np.load(io.BytesIO(data), allow_pickle=False) as arrays:
            if (version := int(arrays[_MARK])) != _VERSION:
                why = f"is of version {version} of packed cameras, this program reads {_VERSION}"
                raise CameraError(path, why, advice="use a newer version of this program")
            columns = {name: _column(arrays, name) for name in _KINDS}
    except (zipfile.BadZipFile, KeyError, ValueError, OSError, EOFError, IndexError) as error:
        raise CameraError(path, f"packed cameras are damaged: {error}", advice=_ADVICE) from error
    if len({len(column) for column in columns.values()}) != 1:
        raise CameraError(path, "its columns are of different lengths", advice=_ADVICE)
    found = PackedCameras(**columns)
    if not (found.size[found.has_camera] >= 1).all():
        raise CameraError(path, "cameras without the size of their pictures", advice=_ADVICE)
    return found


def _column(arrays: Any, name: str) -> Any:
    column = arrays[name]
    if name in _TEXTS:
        text = arrays[name + _VALUES].astype(np.uint8).tobytes()
        values = text.decode("utf-8", "surrogateescape").split("\n")
        if column.ndim != 1 or (column < 0).any():
            raise ValueError(f"{name} is no column of texts")
        return tuple(values[place] for place in column.tolist())
    width = _WIDTHS.get(name, 0)
    if column.ndim != (1 if width == 0 else 2) or (width and column.shape[1] != width):
        raise ValueError(f"{name} has the shape {column.shape}")
    return column.astype(np.float64)


def packed_records(content: object, path: str) -> CameraRecords:
    """The frames with a camera of decoded content; CameraError if that is something else."""
    if not isinstance(content, PackedCameras):
        raise CameraError(path, f"holds no array {_MARK}, expected a file that track wrote")
    cameras = content

    def read(row: Any, path: str, place: str) -> LoadedCamera:
        loaded = cameras.read(row)
        if loaded is None:
            raise CameraError(path, "holds no camera", place=place)
        return loaded

    there = np.flatnonzero(cameras.has_camera).tolist()
    entries = {cameras.frame[i]: (CameraRecord(cameras.frame[i], i),) for i in there}
    return CameraRecords(
        path, entries, read, shots=dict(zip(cameras.frame, cameras.shot, strict=True))
    )
