"""Pixels to metres on the ground, and back: of tables, and by the nearest homography."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
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
from procc_annotator.camera.base import Camera, CameraOrProjections, ElementProjections
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.fit_record import FIT_KEY, UNCERTAINTY
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera
from procc_annotator.formats.frame_names import frame_finder
from procc_annotator.formats.point_tables import PointTable, Row, move_boxes
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
_DIGITS, _DIGITS_OF_SHARES = 4, 7  # of metres and px: 0.1 mm
_UNSEEN = "out of sight of the camera, or outside its lens model"
_NO_GROUND = "projections of the elements alone, which have no ground"


@dataclass(frozen=True, eq=False)
class PlacedPoints:
    """Result of `to_ground` and `to_pixels`.

    Attributes:
        rows: the columns of the table and those that were added; None where a row has no place.
        reasons: why rows have no place -> how many.
        notes: what size the pixels are of, and what to know of standard deviations.
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
        field: and camera_size: as of `evaluate`.
        size: (width, height) px that points belong to; None for the size that a COCO file states,
            else for that of the cameras.
        axes: ``field``: metres from the centre, y towards the main camera; ``up``: y away from it,
            as SkillCorner; ``corner``: from the far left corner; ``metrica``: the same as shares of
            length and width.
        pixel_sd: standard deviation of the points along each axis, px; None if unknown.

    Returns:
        The rows with ``X``, ``Y``, ``on_field``, ``axes`` unless they are those of ``field``, and
        ``sigma_x``, ``sigma_y``: standard deviations by the covariance of a fit (also of files that
        keep it) and ``pixel_sd``.

    Raises:
        UsageError: an argument of another kind. InputError: a file or a row cannot be used.
    """
    table, known = _table(points, metres=False), as_field(field)
    factors, offsets = _axes(axes, known)
    known_sd = isinstance(pixel_sd, int | float) and 0 <= pixel_sd < np.inf
    if pixel_sd is not None and not known_sd:
        raise UsageError(f"pixel_sd: expected a standard deviation in px, found {pixel_sd!r}")
    ground, sds = np.full_like(table.places, np.nan), np.full_like(table.places, np.nan)
    views = _views(table, cameras, known, as_optional_size(size) or table.size, camera_size)
    for view in views:
        if isinstance(view.camera, ElementProjections):
            continue
        ground[view.rows] = ground_from_px(view.camera, table.places[view.rows])
        sds[view.rows] = _deviations(view.camera, view.fit, ground[view.rows], pixel_sd)
    inside = field_rectangle(known).holds(ground).tolist()
    columns = dict(zip("XY", (ground * factors + offsets).T, strict=True))
    notes = []
    if np.isfinite(sds).any():
        columns |= dict(zip(("sigma_x", "sigma_y"), (sds * np.abs(factors)).T, strict=True))
        alone = [view.frame for view in views if view.fit is None]
        if alone and pixel_sd is not None:
            notes = [f"standard deviations of the pixels alone in {list_names(alone, 'frame')}"]
    placed = _placed(table, columns, views, _DIGITS_OF_SHARES if axes == "metrica" else _DIGITS)
    for row, on_field in zip(placed.rows, inside, strict=True):
        row["on_field"] = None if row["X"] is None else on_field
        if axes != AXES[0]:
            row["axes"] = axes
    return replace(placed, notes=(*placed.notes, *notes))


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
        points: as of `to_ground`, with ``X`` and ``Y`` in the axes, or those of a column ``axes``.
        cameras: and field, camera_size, axes: as of `to_ground`.
        size: as of `to_ground`; of the pixels.

    Returns:
        The rows with ``x``, ``y`` (px), which may lie outside the picture; boxes of any columns are
        moved there. ``x``, ``y`` is the corner where ``w``, ``h`` make it a box.

    Raises:
        UsageError, InputError: as of `to_ground`.
    """
    table, known = _table(points, metres=True), as_field(field)
    stated = {str(row["axes"]) for row in table.rows if "axes" in row}
    if len(stated | {axes} - {AXES[0]}) > 1:
        raise UsageError(f"the points are in the axes {', '.join(sorted(stated))}, not {axes}")
    factors, offsets = _axes(next(iter(stated), axes), known)
    ground, px = (table.places - offsets) / factors, np.full_like(table.places, np.nan)
    views = _views(table, cameras, known, as_optional_size(size) or table.size, camera_size)
    for view in views:
        if isinstance(view.camera, ElementProjections):
            continue
        on_ground = ground[view.rows]
        world = np.column_stack((np.nan_to_num(on_ground), np.zeros(len(on_ground))))
        found, shown = view.camera.project(world)
        px[view.rows] = np.where((shown & np.isfinite(on_ground[:, 0]))[:, None], found, np.nan)
    placed = _placed(table, dict(zip("xy", px.T, strict=True)), views, _DIGITS)
    move_boxes(placed.rows, _DIGITS)
    return placed


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
        field: and camera_size: as of `evaluate`.
        size: (width, height) px of the picture; None for what a fit or a file states.

    Returns:
        The homography as a ``camera`` (px of ``size``), with its largest and mean errors over the
        region: ``max_m``, ``mean_m``, ``max_px``, ``mean_px``.

    Raises:
        UsageError: no region or size, or the picture shows too little of it.
    """
    known, own = as_field(field), as_optional_size(camera_size)
    at = as_optional_size(size) or getattr(camera, "size", None) or own
    if at is None:
        raise UsageError("size: the camera states no picture size, give (width, height)")
    used = require_camera_model(camera_at_size(camera, at, own, field=known).camera)
    found = nearest_homography(used, region_of(region, known), at)
    if found is None:
        raise UsageError("the picture shows too little of the region for a homography")
    return found


def _table(points: Points, *, metres: bool) -> PointTable:
    if isinstance(points, str | Path):
        return PointTable.read(Path(points), metres=metres)
    rows = points.to_dict("records") if hasattr(points, "to_dict") else points
    if not isinstance(rows, Sequence) or not all(isinstance(row, Mapping) for row in rows):
        raise UsageError(f"points: expected rows, a DataFrame or a path, found {kind_of(points)}")
    plain = [
        {k: v.tolist() if isinstance(v, np.ndarray) else v for k, v in row.items()} for row in rows
    ]
    return PointTable.of(plain, "points", metres=metres)


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


@dataclass(frozen=True, eq=False)
class _View:
    """A frame with a camera (px of ``size``, which is assumed if nothing says it), its fit if the
    covariance is known, and the rows of the table."""

    frame: str
    camera: CameraOrProjections
    fit: FitResult | None
    rows: list[int]
    size: tuple[int, int]
    is_assumed: bool


def _views(
    table: PointTable,
    cameras: Method,
    known: Field,
    size: tuple[int, int] | None,
    camera_size: tuple[int, int] | None,
) -> list[_View]:
    """The frames that have a camera; UsageError: a size is given, and cameras that state none."""
    rows_of: dict[str, list[int]] = {}
    for row, frame in enumerate(table.frames):
        rows_of.setdefault(frame, []).append(row)
    cameras_by_frame, own = cameras_of(cameras, rows_of), as_optional_size(camera_size)
    find, of_points, views = frame_finder(cameras_by_frame), as_optional_size(size), []
    for frame, rows in rows_of.items():
        name = find(frame)
        if name is None or (camera := cameras_by_frame[name]) is None:
            continue
        usual = isinstance(camera, LoadedCamera) and camera.size_is_usual and own is None
        stated = getattr(camera, "size", None) or own
        if stated is None and of_points is not None and isinstance(camera, LoadedCamera):
            raise UsageError(
                f"camera of {frame}: nothing says what picture size it belongs to, so points of"
                f" {of_points[0]}x{of_points[1]} px cannot be placed: give the camera size"
            )
        at = of_points or stated or DEFAULT_SIZE
        used = camera_at_size(camera, at, own, f"camera of {frame}", field=known).camera
        assumed = usual or (of_points is None and stated is None)
        views.append(_View(frame, used, _fit_of(camera), rows, at, assumed))
    return views


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
    table: PointTable, columns: Mapping[str, FloatArray], views: Sequence[_View], digits: int
) -> PlacedPoints:
    """The rows with more columns."""
    rows = [dict(row) for row in table.rows]
    for name, values in columns.items():
        for row, value in zip(rows, values.tolist(), strict=True):
            row[name] = round(value, digits) if value == value else None
    why = {
        view.frame: _NO_GROUND if isinstance(view.camera, ElementProjections) else _UNSEEN
        for view in views
    }
    lost = Counter(
        why.get(frame, "no camera") if np.isfinite(place).all() else "empty cells"
        for row, frame, place in zip(rows, table.frames, table.places, strict=True)
        if row[next(iter(columns))] is None
    )
    placing = [v for v in views if not isinstance(v.camera, ElementProjections)]
    sizes = list(dict.fromkeys(f"{v.size[0]}x{v.size[1]}" for v in placing))
    notes = [f"pixels are those of pictures of {' and '.join(sizes)}"] if sizes else []
    if any(view.is_assumed for view in placing):
        notes[0] += ", and the cameras do not say theirs: it is assumed (size, camera size)"
    return PlacedPoints(rows, lost, tuple(notes))
