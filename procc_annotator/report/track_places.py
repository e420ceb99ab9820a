"""Where the cameras of shots that were followed stand, for those of the same source in which none
was found by itself."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from pathlib import Path

import numpy as np

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import InputError
from procc_annotator.fit.from_picture.proposal import KnownPosition
from procc_annotator.io.camera_files.cameras import read_camera_file
from procc_annotator.io.source import read_file
from procc_annotator.report.tracks import Line, TrackTable

# A shot whose camera's place counts: that many frames, their lines on paint, known so well.
_LEAST_FRAMES, _LEAST_COVERAGE, _MOST_SD_M = 10, 0.65, 1.0
_SAME_M, _WANDERS_M = 3.0, 0.5  # nearer ones are one place; farther apart in a shot it is none
_APART_M = 0.7  # shots of one match tell of a tripod to about a metre
_MOST = 4
_DEVIATIONS = ("sd_x_m", "sd_y_m", "sd_z_m")


def find_positions(out: Path, table: TrackTable) -> tuple[KnownPosition, ...]:
    """The places from which the shots of a track were filmed, that of most frames first.

    Args:
        out: its folder, with the cameras.
        table: what became of its frames.
    """
    shots = [list(own) for _, own in groupby(table.in_order(), key=lambda line: line["shot"])]
    found: list[KnownPosition] = []
    for shot in sorted(shots, key=len, reverse=True):
        place = _place_of(out, [line for line in shot if line["camera"]])
        if place is None:
            continue
        if all(np.linalg.norm(place.position_m - one.position_m) > _SAME_M for one in found):
            found.append(place)
    return tuple(found[:_MOST])


def _place_of(out: Path, lines: Sequence[Line]) -> KnownPosition | None:
    """Where a shot was filmed from, if that is known and stays the same."""
    followed = [line for line in lines if line["state"] == "followed"]
    if len(followed) < _LEAST_FRAMES:
        return None
    middle = followed[len(followed) // 2]
    deviations = np.array([middle[key] for key in _DEVIATIONS], dtype=np.float64)
    coverage = float(np.median([line["coverage"] for line in followed]))
    if coverage < _LEAST_COVERAGE or not deviations.max() <= _MOST_SD_M:
        return None
    positions = [_position(out / line["camera"]) for line in (followed[0], middle, followed[-1])]
    seen = np.array([position for position in positions if position is not None])
    if len(seen) < len(positions) or np.ptp(seen, axis=0).max() > _WANDERS_M:
        return None
    return KnownPosition(seen[1], np.diag(deviations**2 + _APART_M**2))


def _position(path: Path) -> tuple[float, float, float] | None:
    """Where the camera of a file stands, metres; None if somebody else has been there."""
    try:
        camera = read_camera_file(read_file(path), path=str(path)).camera
    except InputError:
        return None
    return camera.position_world if isinstance(camera, PinholeCamera) else None
