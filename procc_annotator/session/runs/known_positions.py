"""Where cameras are known to stand: from files of cameras, or the table of shared positions."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import CameraError, InputError
from procc_annotator.field.model import Field
from procc_annotator.fit.from_picture.agreed_positions import cluster_camera_positions
from procc_annotator.fit.from_picture.proposal import KnownPosition
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.io.camera_files.camera_writers import OFFICIAL_SIZE
from procc_annotator.io.csv_text import read_table

_PLACE, _DEVIATIONS = ("x_m", "y_m", "z_m"), ("sd_x_m", "sd_y_m", "sd_z_m")
_ADVICE = "expected positions.csv of calibrate --shared-position, or cameras"
_LEAST_SD_M = 0.05  # a table that says less than it can know


def read_positions(path: Path, field: Field, fmt: str = "auto") -> tuple[KnownPosition, ...]:
    """The positions that a file tells.

    Args:
        path: folder, archive or file of cameras; or a ``.csv`` with columns ``x_m``, ``y_m``,
            ``z_m`` and their standard deviations, as ``calibrate --shared-position`` writes it.
        field: the elements.
        fmt: of the cameras, one of `CAMERA_FORMATS`.

    Raises:
        InputError: no position can be read from it.
        UsageError: nothing at the path.
    """
    if path.suffix.lower() == ".csv":
        return _from_table(path)
    with CameraCollection.open(path, fmt, field=field) as collection:
        found = []
        for frame in collection.frames:
            try:
                loaded = collection.read(frame)
            except CameraError:  # a set is known by its others
                continue
            if isinstance(loaded.camera, PinholeCamera):
                found.append((loaded.camera, loaded.size or OFFICIAL_SIZE))
    if not found:
        raise InputError(path, "holds no camera with a position (a homography has none)")
    return cluster_camera_positions(found, field)


def _from_table(path: Path) -> tuple[KnownPosition, ...]:
    _, rows = read_table(path, (*_PLACE, *_DEVIATIONS), _ADVICE)
    found = []
    for line, row in rows:
        try:
            place = np.array([float(row[name]) for name in _PLACE])
            sd = np.array([float(row[name]) for name in _DEVIATIONS])
        except ValueError as error:
            why = "expected numbers for position and standard deviations"
            raise InputError(path, why, place=f"line {line}") from error
        if not (np.isfinite(place).all() and np.isfinite(sd).all()):
            raise InputError(path, "expected finite numbers", place=f"line {line}")
        found.append(KnownPosition(place, np.diag(np.maximum(sd, _LEAST_SD_M) ** 2)))
    if not found:
        raise InputError(path, "holds no position")
    return tuple(found)
