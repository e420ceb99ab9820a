"""Maps over picture and field, computed in the background: disagreement of two cameras, visible
field, uncertainty of the fit, painted line widths.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, QPointF, Qt, Signal
from PySide6.QtGui import QImage, QPainterPath, QPolygonF, QTransform

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.prediction.uncertainty import (
    GroundUncertainty,
    map_ground_uncertainty,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import Camera, CameraOrProjections, ElementProjections
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.gui.state import availability
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import ComputedValue, Inputs
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.prediction.camera_choice import PredictionSource
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.scoring.frame_score import FrameScorer, SourceFrames
from procc_annotator.gui.state.store import Store, When
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.top_view import GroundRaster, picture_on_ground
from procc_annotator.interaction.camera_view import (
    DISAGREEMENT,
    UNCERTAINTY,
    MapStyle,
    VisibleField,
    visible_field,
)
from procc_annotator.metrics.error_maps import (
    ContourBand,
    Disagreement,
    bilinear_value,
    contour_lines,
    disagreement,
    filled_contours,
)
from procc_annotator.metrics.projection import ProjectedField, project_markings
from procc_annotator.translation import tr


@dataclass(frozen=True, eq=False)
class MapShapes:
    """A map as shapes of Qt, in one frame of coordinates; not to be changed.

    Attributes:
        look: what they are painted with.
        lines: (N, 4) of each of the look's lines, segment by segment.
        area: as far as the map reaches; None where its shapes end there by themselves.
    """

    look: MapStyle
    bands: tuple[QPainterPath, ...]
    lines: tuple[FloatArray, ...]
    area: QPainterPath | None = None


def map_shapes(
    look: MapStyle,
    values: FloatArray,
    x: FloatArray,
    y: FloatArray,
    area: ContourBand | None = None,
) -> MapShapes:
    """The shapes of a map, for the arrays see `metrics.error_maps.filled_contours`; nothing is
    painted outside an area. Safe from any thread, and too slow for that of the interface."""
    return MapShapes(
        look,
        tuple(
            even_odd_path(band.polygons) for band in filled_contours(values, x, y, look.levels_m)
        ),
        tuple(segments(contour_lines(values, x, y, line.metres)) for line in look.lines),
        None if area is None else even_odd_path(area.polygons),
    )


def segments(lines: Iterable[FloatArray]) -> FloatArray:
    """(N, 4) the segments x, y, x, y of polylines (n, 2), one after the other."""
    pieces = [np.hstack((line[:-1], line[1:])) for line in lines]
    return np.concatenate(pieces) if pieces else np.empty((0, 4))


def even_odd_path(polygons: Iterable[Iterable[FloatArray]]) -> QPainterPath:
    """The area of polygons, each the (n, 2) outlines of itself and of its holes."""
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.OddEvenFill)
    for outlines in polygons:
        for outline in outlines:
            path.addPolygon(QPolygonF([QPointF(u, v) for u, v in outline.tolist()]))
    return path


_SAME_M = 1e-6


@dataclass(frozen=True, eq=False)
class Compared:
    """Two sources compared in the frame on screen.

    Attributes:
        names: of the active and of the compared source.
        values: the disagreement, px of the evaluation size and metres.
        picture: its shapes, px of the evaluation size.
        field: its shapes, metres on the ground as the active source sees it.
    """

    names: tuple[str, str]
    values: Disagreement
    picture: MapShapes
    field: MapShapes

    def at(self, x: float, y: float) -> tuple[float, float] | None:
        """Metres and pixels between the two at a place of the picture, px of the evaluation size;
        between the samples in proportion, None where one of them does not count."""
        grid = self.values.xs_px, self.values.ys_px
        metres = bilinear_value(self.values.metres, *grid, x, y)
        pixels = bilinear_value(self.values.pixels, *grid, x, y)
        return None if metres is None or pixels is None else (metres, pixels)


class DisagreementMap(ComputedValue[Compared]):
    """The disagreement in the frame on screen, once a person wants to see it."""

    def __init__(self, store: Store, source_frames: SourceFrames) -> None:
        super().__init__(self._made_of, compare_cameras, store, enabled=False)
        self._store, self._source_frames = store, source_frames
        store.keep_current(self, source_frames.changed, when=When.NOW)

    @property
    def problem(self) -> str:
        """Why there is nothing to be shown, or little, although a person wants to see it."""
        if problem := super().problem:
            return problem
        if self.value is None:
            return ""
        largest = self.value.values.statistics.metres.maximum
        if largest is None:
            return tr("The two see no part of the field in common in this frame.")
        return tr("Both cameras are the same in this frame.") if largest < _SAME_M else ""

    def _made_of(self) -> Inputs | str | None:
        state = self._store.state
        a, b = state.active, state.compared
        if why := availability.hidden(state) or availability.no_frame(state):
            return availability.as_sentence(why)
        if a is None and len(state.sources) > 1:
            return tr("No source is judged: choose one first.")
        if a is None or b is None:
            return tr("Two sources of cameras are needed: load another one.")
        shown = [self._source_frames.of(source) for source in (a, b)]
        cameras = [each.camera for each in shown if each is not None]
        if len(cameras) < 2:
            return None  # they are being read
        names, setup = (a.name, b.name), state.setup
        if why := _why_not(names, cameras):
            return why
        return names, *cameras, state.sized_field, setup.size


def _why_not(names: tuple[str, str], cameras: Sequence[CameraOrProjections | None]) -> str:
    named = list(zip(names, cameras, strict=True))
    without = [name for name, camera in named if camera is None]
    if without:
        return tr("{names}: no camera for this frame.", names=_both(without))
    projections = [name for name, camera in named if isinstance(camera, ElementProjections)]
    if not projections:
        return ""
    if len(projections) == 1:
        return tr(
            "{name} shares only where the elements are shown, no camera: there is no ground to"
            " compare.",
            name=projections[0],
        )
    return tr(
        "{names} share only where the elements are shown, no camera: there is no ground to"
        " compare.",
        names=_both(projections),
    )


def _both(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else tr("{a} and {b}", a=names[0], b=names[1])


def compare_cameras(
    names: tuple[str, str], a: Camera, b: Camera, field: Field, size: tuple[int, int]
) -> Compared:
    """Compare two cameras of a frame, px of ``size``; safe from any thread. `UsageError` if one of
    them shares only projections."""
    values = disagreement(a, b, field, size)
    _ = values.statistics  # kept with the values; worked out here, not where it is shown
    ground = values.ground_a
    return Compared(
        names,
        values,
        map_shapes(DISAGREEMENT, values.metres, values.xs_px, values.ys_px),
        map_shapes(DISAGREEMENT, values.metres, ground[..., 0], ground[..., 1]),
    )


_KEPT = 8


class VisibleFieldRegion(QObject):
    """Follows the camera that ghosts go by, else the one that is judged.

    While the next one of a frame is worked out the sight before stays, so that the map does not
    flicker with every click. A frame without a camera, or whose camera is not known yet, has
    nothing in sight; its map stays turned as it was, for cameras of one set stand on one side. In
    blind mode nothing of it is reported.
    """

    changed = Signal()

    def __init__(self, store: Store, prediction: PredictionSource, scorer: FrameScorer) -> None:
        super().__init__(store)
        self._store, self._prediction, self._scorer = store, prediction, scorer
        self.wanted = True
        self._sight: VisibleField | None = None
        self._sight_of: str | None = None  # its frame
        self._turns = 0
        self._signalled: tuple[object, ...] = ()
        self._found = ComputedValue(self._made_of, _look_at, self, cache_size=_KEPT)
        self._found.changed.connect(self._take)
        store.watch(lambda s: (s.workspace, s.field), self._begin_anew)
        store.watch(lambda s: (select.blind(s), select.frame(s)), self._look)
        store.keep_current(self._found)
        prediction.changed.connect(self._look)

    def set_wanted(self, wanted: bool) -> None:
        """Turn the map to the side of the camera, or leave the main camera's side below."""
        if wanted != self.wanted:
            self.wanted = wanted
            self._look()

    @property
    def shown(self) -> VisibleField | None:
        """Return what is in sight in the frame on screen; None where no camera is known, or may
        be."""
        of_this = self._sight_of == self._store.state.frame_name
        return self._sight if self._allowed and of_this else None

    @property
    def turns(self) -> int:
        """Quarter turns of the map, see `FieldSight.turns`."""
        return self._turns if self._allowed else 0

    # --- inside ---

    @property
    def _allowed(self) -> bool:
        return self.wanted and self._store.state.projection_visible

    def _made_of(self) -> Inputs | None:
        return self.camera_on_screen() if self._allowed else None

    def camera_on_screen(self) -> tuple[Field, Camera, tuple[int, int]] | None:
        """The field, the camera that the map follows, and the size in px that it is for; None
        where there is none, or it may not be shown."""
        state = self._store.state
        if state.frame is None or not state.projection_visible:
            return None
        insight = self._prediction.insight
        if insight is not None and insight.fit.camera is not None:
            return state.sized_field, insight.fit.camera, insight.fit.size
        camera = self._scorer.camera
        if camera is None or isinstance(camera, ElementProjections):
            return None
        return state.sized_field, camera, state.setup.size

    def _look(self, *_: object) -> None:
        self._found.invalidate()
        self._take()

    def _begin_anew(self) -> None:
        self._sight, self._turns = None, 0
        self._found.clear()
        self._look()

    def _take(self, *_: object) -> None:
        if not (self._found.working or self._prediction.working):
            self._sight, self._sight_of = self._found.value, self._store.state.frame_name
            if self._sight is not None:
                self._turns = self._sight.turns
        now = self.shown, self.turns
        if now != self._signalled:
            self._signalled = now
            self.changed.emit()


def _look_at(*inputs: object) -> VisibleField | None:
    try:
        return visible_field(*inputs)  # type: ignore[arg-type]
    except UsageError:  # a field that hangs in the air has no ground to turn
        return None


@dataclass(frozen=True, eq=False)
class TopViewImage:
    """A picture as seen from above, and the transform from its px to metres on the ground."""

    image: QImage
    metres_from_px: QTransform


_TOP_VIEW_PX_PER_M = 8.0  # a field map on a large screen


@dataclass(frozen=True, eq=False)
class GroundAccuracy:
    """The uncertainty of ground points by one fit, and its shapes in px of the fit's picture and in
    metres on the ground."""

    values: GroundUncertainty
    picture: MapShapes
    field: MapShapes

    def at(self, x: float, y: float) -> float | None:
        """Standard deviation of the ground point at a place of the fit's picture, px, in metres:
        between the samples in proportion; None off the field and above the horizon."""
        known = self.values
        if known.fit.camera is None:
            return None
        ground_x, ground_y = ground_from_px(known.fit.camera, np.array([[x, y]]))[0].tolist()
        return bilinear_value(known.sd_m, known.xs_m, known.ys_m, ground_x, ground_y)


def know_ground(fit: FitResult, field: Field) -> GroundAccuracy:
    """The map of a fit with its shapes; safe from any thread. `UsageError` if it has no camera."""
    values = map_ground_uncertainty(fit, field)
    _ = values.statistics  # kept with the values; worked out here, not where it is shown
    x, y = np.meshgrid(values.xs_m, values.ys_m)
    in_sight = filled_contours(values.distance_to_border_px, x, y, (0.0, math.inf))[0]
    px = values.points_px
    return GroundAccuracy(
        values,
        map_shapes(UNCERTAINTY, values.sd_m, px[..., 0], px[..., 1]),
        map_shapes(UNCERTAINTY, values.sd_m, x, y, in_sight),
    )


class UncertaintyMap(ComputedValue[GroundAccuracy]):
    """The map of the live fit, once a person wants to see it."""

    def __init__(self, store: Store, live_fit: LiveFit, disagreement: DisagreementMap) -> None:
        super().__init__(self._made_of, know_ground, store, enabled=False)
        self._store, self._live_fit = store, live_fit
        self._disagreement = disagreement
        store.keep_current(self, live_fit.changed, when=When.NOW)
        disagreement.changed.connect(self._give_way)

    @property
    def problem(self) -> str:
        """Why there is nothing to be shown, or little, although a person wants to see it."""
        if problem := super().problem:
            return problem
        found = self.value
        nothing = found is not None and found.values.statistics.median is None
        return tr("The fitted camera sees no part of the field.") if nothing else ""

    def set_enabled(self, enabled: bool) -> None:
        """Show it or not; it takes the place of the disagreement."""
        if enabled:
            self._disagreement.set_enabled(False)
        super().set_enabled(enabled)

    def _made_of(self) -> Inputs | str | None:
        live = self._live_fit
        if live.problem:
            return availability.as_sentence(live.problem)
        fit = live.result
        if fit is None:
            if live.working:
                return None
            return tr("There is no fit of this frame, so no uncertainty map.")
        if fit.camera is None:
            return tr("No camera yet, so no uncertainty map: {why}.", why=fit.failure)
        return fit, self._store.state.sized_field

    def _give_way(self) -> None:
        if self._disagreement.enabled:
            self.set_enabled(False)


class LineWidths(ComputedValue[ProjectedField]):
    """The borders of painted lines, once a person wants to see them."""

    def __init__(self, store: Store, scorer: FrameScorer) -> None:
        super().__init__(
            self._made_of, lambda *inputs: project_markings(*inputs), store, enabled=False
        )
        self._store, self._scorer = store, scorer
        self.failed.connect(self._say)
        store.watch(select.score, self.retry)

    def _made_of(self) -> Inputs | None:
        camera = self._scorer.camera
        return None if camera is None else (camera, self._scorer.frame_setup)

    def _say(self, text: str) -> None:
        say(self._store, tr("the painted width cannot be drawn: {why}", why=text), "warning")


class TopView(ComputedValue[TopViewImage]):
    """The picture on screen as seen from above, once a person wants to see it."""

    def __init__(self, store: Store, region: VisibleFieldRegion, prediction: PredictionSource):
        super().__init__(self._made_of, _seen_from_above, store, enabled=False)
        self._store, self._region = store, region
        store.keep_current(self, region.changed, prediction.changed)

    def _made_of(self) -> Inputs | None:
        shown, picture = self._region.camera_on_screen(), self._store.state.picture
        return None if shown is None or picture is None else (picture, *shown)


def _seen_from_above(
    picture: PixelArray, field: Field, camera: Camera, size: tuple[int, int]
) -> TopViewImage:
    raster = GroundRaster.of(field, _TOP_VIEW_PX_PER_M)
    pixels, seen = picture_on_ground(picture, camera, size, raster)
    shown = np.dstack((pixels, np.where(seen, np.uint8(255), np.uint8(0))))
    (width, height), scale = raster.size, 1 / raster.px_per_m
    # A copy: the image must own its memory.
    image = QImage(shown.data, width, height, 4 * width, QImage.Format.Format_ARGB32).copy()
    return TopViewImage(image, QTransform(scale, 0, 0, scale, raster.left, raster.top))
