"""What tables of cameras found by the program share: columns, and CSV."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable
from typing import Any

from procc_annotator.fit.result import PoseDeviations

DEVIATION_COLUMNS = (
    "sd_pan_degrees", "sd_tilt_degrees", "sd_roll_degrees", "sd_focal_px",
    "sd_x_m", "sd_y_m", "sd_z_m",
)  # fmt: skip


def in_file_units(deviations: PoseDeviations) -> tuple[float, ...]:
    """Standard deviations in the order of `DEVIATION_COLUMNS`: degrees, px, metres."""
    angles = (deviations.pan_rad, deviations.tilt_rad, deviations.roll_rad)
    return (*map(math.degrees, angles), deviations.focal_px, *deviations.position_m)


def deviation_cells(deviations: PoseDeviations | None) -> tuple[float | str, ...]:
    """The same as cells of a row; empty ones where nothing is known."""
    return ("",) * len(DEVIATION_COLUMNS) if deviations is None else in_file_units(deviations)


def csv_bytes(rows: Iterable[Iterable[Any]]) -> bytes:
    """Rows as a CSV file."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue().encode()
