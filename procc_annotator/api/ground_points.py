"""Pixels to metres on the ground, and back: of tables, and by the nearest homography."""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as attribute
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from procc_annotator.api.inputs import (
    AnyCamera,
    as_field,
    as_optional_size,
    camera_at_size,
    dataframe,
    kind_of,
)
from procc_annotator.api.methods import Method, cameras_of
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.fitting import DEFAULT_SIZE
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.backprojection import ground_covariance, ground_from_px
from procc_annotator.camera.base import Camera, ElementProjections
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.fit_record import FIT_KEY, UNCERTAINTY
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera
from procc_annotator.formats.frame_names import frame_finder
from procc_annotator.formats.point_tables import PointTable, Row, read_rows
from procc_annotator.messages import list_names
from procc_annotator.metrics.ground_plane import (
    NearestHomography,
    field_rectangle,
    nearest_homography,
    region_of,
    require_camera_model,
)

if TYPE_CHECKING:
    import pandas

Points = str | Path | Sequence[Mapping[str, Any]] | Any  # or a DataFrame
AXES = ("field", "up", "corner", "metrica")
_DIGITS = 4  # of metres and px


@dataclass(frozen=True, eq=False)
class PlacedPoints:
    """Result of `to_ground` and `to_pixels`.

    Attributes:
        rows: the columns of the table and those that were added; None where a row has no place.
        reasons: why rows have no place -> how many.
        notes: what to know of standard deviations.
    """

    rows: list[Row] = attribute(repr=False)
    reasons: Mapping[str, int]
    notes: tuple[str, ...] = ()

    def to_dataframe(self) -> pandas.DataFrame:
        """The rows as a pandas DataFrame; a UsageError where pandas is not installed."""
        return dataframe(self.rows)


def to_ground(
    points: Points,
    cameras: Method,
    *,
    field: Field | str | None = None,
    size: tuple[int, int] | None = None,
    camera_size: tuple[int, int] | None = None,
    axes: str = "field",
    pixel_sd: float | None = None,
) -> PlacedPoints:
    """Find the metres on the ground that pixels show: the command ``ground``.

    Args:
        points: rows, a DataFrame, or the path of CSV, Parquet, JSON or MOT, with the columns
            ``frame`` and ``x``, ``y`` (px), or a box, of which the middle of the lower edge counts.
        cameras: of their frames, as `save_projection` takes them; a number names the only frame
            that ends in it (12: ``000012``).
        field, camera_size: as of `evaluate`.
        size: (width, height) px that points belong to; None for the size of the cameras.
        axes: ``field``: metres from the centre, y towards the main camera; ``up``: y away from it,
            as SkillCorner; ``corner``: from the far left corner; ``metrica``: the same as shares of
            length and width.
        pixel_sd: standard deviation of the points along each axis, px; None if unknown.

    Returns:
        The rows with ``X``, ``Y``, ``on_field``, and ``sigma_x``, ``sigma_y``: standard deviations
        by the covariance of a fit (also of files that keep it) and ``pixel_sd``.

    Raises:
        UsageError: an argument of another kind. InputError: a file or a row cannot be used.
    """
    table, known = _table(points, metres=False), as_field(field)
    factors, offsets = _axes(axes, known)
    ground, sds = np.full_like(table.places, np.nan), np.full_like(table.places, np.nan)
    seen, alone = set[str](), []
    for frame, camera, fit, rows in _by_frame(table, cameras, known, size, camera_size):
        ground[rows] = ground_from_px(camera, table.places[rows])
        sds[rows] = _deviations(camera, fit, ground[rows], pixel_sd)
        seen.add(frame)
        alone += [frame] if fit is None else []
    inside = field_rectangle(known).holds(ground).tolist()
    columns = dict(zip("XY", (ground * factors + offsets).T, strict=True))
    notes = []
    if np.isfinite(sds).any():
        columns |= dict(zip(("sigma_x", "sigma_y"), (sds * np.abs(factors)).T, strict=True))
        if alone and pixel_sd is not None:
            notes = [f"standard deviations of the pixels alone in {list_names(alone, 'frame')}"]
    placed = _placed(table, columns, seen)
    for row, on_field in zip(placed.rows, inside, strict=True):
        row["on_field"] = None if row["X"] is None else on_field
    return replace(placed, notes=tuple(notes))


def to_pixels(
    points: Points,
    cameras: Method,
    *,
    field: Field | str | None = None,
    size: tuple[int, int] | None = None,
    camera_size: tuple[int, int] | None = None,
    axes: str = "field",
) -> PlacedPoints:
    """Find the pixels that show places on the ground, the way back of `to_ground`.

    Args:
        points: as of `to_ground`, with ``X`` and ``Y`` in the axes.
        cameras, field, camera_size, axes: as of `to_ground`.
        size: as of `to_ground`; of the pixels.

    Returns:
        The rows with ``x``, ``y`` (px), which may lie outside the picture.

    Raises:
        UsageError, InputError: as of `to_ground`.
    """
    table, known = _table(points, metres=True), as_field(field)
    factors, offsets = _axes(axes, known)
    ground, px = (table.places - offsets) / factors, np.full_like(table.places, np.nan)
    seen = set[str]()
    for frame, camera, _, rows in _by_frame(table, cameras, known, size, camera_size):
        world = np.column_stack((np.nan_to_num(ground[rows]), np.zeros(len(rows))))
        found, shown = camera.project(world)
        px[rows] = np.where((shown & np.isfinite(ground[rows, 0]))[:, None], found, np.nan)
        seen.add(frame)
    return _placed(table, dict(zip("xy", px.T, strict=True)), seen)


def homography_of(
    camera: AnyCamera,
    region: str | Sequence[float] = "field",
    *,
    field: Field | str | None = None,
    size: tuple[int, int] | None = None,
    camera_size: tuple[int, int] | None = None,
) -> NearestHomography:
    """Find the homography nearest to a camera of any model over a region, and how far it is off.

    Args:
        camera: as `evaluate` takes it.
        region: ``field``, or (x0, y0, x1, y1) metres; what the picture shows of it counts.
        field, camera_size: as of `evaluate`.
        size: (width, height) px of the picture; None for the camera's.

    Returns:
        The homography as a ``camera`` (px of ``size``), with its largest and mean errors over the
        region: ``max_m``, ``mean_m``, ``max_px``, ``mean_px``.

    Raises:
        UsageError: no region, or the picture shows too little of it.
    """
    known, own = as_field(field), as_optional_size(camera_size)
    at = as_optional_size(size) or getattr(camera, "size", None) or own or DEFAULT_SIZE
    used = require_camera_model(camera_at_size(camera, at, own, field=known).camera)
    found = nearest_homography(used, region_of(region, known), at)
    if found is None:
        raise UsageError("the picture shows too little of the region for a homography")
    return found


def _table(points: Points, *, metres: bool) -> PointTable:
    if isinstance(points, str | Path):
        return PointTable.of(read_rows(Path(points)), points, metres=metres)
    rows = points.to_dict("records") if hasattr(points, "to_dict") else points
    if not isinstance(rows, Sequence) or not all(isinstance(row, Mapping) for row in rows):
        raise UsageError(f"points: expected rows, a DataFrame or a path, found {kind_of(points)}")
    return PointTable.of([dict(row) for row in rows], "points", metres=metres)


def _axes(name: str, known: Field) -> tuple[FloatArray, FloatArray]:
    """(2,) factors and (2,) offsets from metres of the world to positions."""
    if name not in AXES:
        raise UsageError(f"unknown axes {name!r}; choose one of {', '.join(AXES)}")
    whole = field_rectangle(known)
    first, last = np.array((whole.left, whole.top)), np.array((whole.right, whole.bottom))
    if name in ("field", "up"):
        return np.array((1.0, -1.0 if name == "up" else 1.0)), np.zeros(2)
    factors = 1 / (last - first) if name == "metrica" else np.ones(2)
    return factors, -first * factors


def _by_frame(
    table: PointTable,
    cameras: Method,
    known: Field,
    size: tuple[int, int] | None,
    camera_size: tuple[int, int] | None,
) -> Iterator[tuple[str, Camera, FitResult | None, list[int]]]:
    """Of each frame with a camera its name, the camera in px of the points, its fit if the
    covariance is known, and its rows; projections are no camera."""
    rows_of: dict[str, list[int]] = {}
    for row, frame in enumerate(table.frames):
        rows_of.setdefault(frame, []).append(row)
    found, own = cameras_of(cameras, rows_of), as_optional_size(camera_size)
    find = frame_finder(found)
    for frame, rows in rows_of.items():
        name = find(frame)
        if name is not None and (camera := found[name]) is not None:
            at = as_optional_size(size) or getattr(camera, "size", None) or own or DEFAULT_SIZE
            used = camera_at_size(camera, at, own, f"camera of {frame}", field=known).camera
            if not isinstance(used, ElementProjections):
                yield frame, used, _fit_of(camera), rows


def _fit_of(camera: AnyCamera) -> FitResult | None:
    if isinstance(camera, FitResult):
        return camera
    kept = camera.content.get(FIT_KEY) if isinstance(camera, LoadedCamera) else None
    record = kept.get(UNCERTAINTY) if isinstance(kept, dict) else None
    posed = camera.camera if isinstance(camera, LoadedCamera) else None
    return FitResult.restored(posed, record) if isinstance(posed, PinholeCamera) else None


def _deviations(
    camera: Camera, fit: FitResult | None, ground: FloatArray, pixel_sd: float | None
) -> FloatArray:
    """(N, 2) metres along the axes of the world."""
    squares = np.zeros((len(ground), 2, 2)) if fit is None else fit.ground_covariance(ground)
    if pixel_sd is not None:
        squares = squares + ground_covariance(camera, ground, pixel_sd**2 * np.eye(2))
    elif fit is None:
        squares *= np.nan
    return np.asarray(np.sqrt(np.diagonal(squares, axis1=1, axis2=2)))


def _placed(
    table: PointTable, columns: Mapping[str, FloatArray], seen: Container[str]
) -> PlacedPoints:
    """The rows with more columns; seen: the frames that have a camera."""
    rows = [dict(row) for row in table.rows]
    for name, values in columns.items():
        for row, value in zip(rows, values.tolist(), strict=True):
            row[name] = round(value, _DIGITS) if value == value else None
    lost = Counter(
        "empty cells"
        if not np.isfinite(place).all()
        else "out of sight of the camera, or outside its lens model"
        if frame in seen
        else "no camera"
        for row, frame, place in zip(rows, table.frames, table.places, strict=True)
        if row[next(iter(columns))] is None
    )
    return PlacedPoints(rows, lost)
