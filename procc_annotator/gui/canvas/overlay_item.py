"""An item over the picture: paints an overlay, and repaints only what changed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import chain, repeat, zip_longest

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRect, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QPainter, QPixmap, QTransform
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from procc_annotator.gui.canvas.label_plates import arranged
from procc_annotator.gui.canvas.overlay_painter import paint_overlay
from procc_annotator.gui.canvas.picture_item import exposed_rects
from procc_annotator.gui.theme import text_times
from procc_annotator.interaction.overlay_primitives import (
    EMPTY_OVERLAY,
    Box,
    CursorSigns,
    Labels,
    Overlay,
    PointMarks,
    Strokes,
)


class StillOverlay:
    """Overlays that are painted repeatedly at the same place, under something that moves.

    The first time at a place it is painted line by line; the second time into a picture of the
    whole view, which from then on costs next to nothing.
    """

    def __init__(self) -> None:
        self._painted: tuple[object, ...] = ()
        self._picture: QPixmap | None = None

    def paint(
        self,
        painter: QPainter,
        layers: tuple[Overlay, ...],
        *,
        scale: float,
        offset: tuple[float, float],
        clip: QRectF,
        room: QSize,
        seen: QRectF | None = None,
        lines_only: bool = False,
        texts: tuple[Labels, ...] = (),
    ) -> None:
        """Paint overlays, the first one lowest.

        Args:
            painter: in coordinates of the view.
            layers, scale, offset, clip, lines_only, texts: as for `paint_overlay`.
            room: size of the view.
            seen: where in the view the overlay can be seen; texts stay inside. None for all of it.
        """
        ratio = painter.device().devicePixelRatioF()
        times = text_times()
        asked = layers, scale, offset, room, seen, ratio, times, texts
        paint_still = partial(
            paint_overlay,
            scale=scale,
            offset=offset,
            room=seen,
            lines_only=lines_only,
            text_times=times,
            texts=texts,
        )
        if asked != self._painted:
            self._painted, self._picture = asked, None
            for overlay in layers:
                paint_still(painter, overlay, clip=clip)
            return
        if self._picture is None:
            self._picture = QPixmap(room * ratio)
            self._picture.setDevicePixelRatio(ratio)
            self._picture.fill(Qt.GlobalColor.transparent)
            own = QPainter(self._picture)
            whole = QRectF(0, 0, room.width(), room.height())
            for overlay in layers:
                paint_still(own, overlay, clip=whole)
            own.end()
        painter.save()
        for place in exposed_rects(painter):
            painter.setClipRect(place & clip)
            painter.drawPixmap(0, 0, self._picture)
        painter.restore()


_MARGIN = 14.0  # points: half a handle with its halo, a line's width
_LETTER = 8.5  # points: generous bounds of a label's letter, and of how high and low it stands
_WIDE_LETTER = 13.0  # of Japanese and Chinese
_SIGNS = 40.0  # signs next to a text at the cursor
_ABOVE = 28.0
_BELOW = 32.0
_EVERYWHERE = QRectF(-1e6, -1e6, 2e6, 2e6)

Positions = NDArray[np.floating]

_NO_ROWS = np.empty((0, 4))
_NO_PLACES = np.empty((0, 2))


# A text next to its point: the point, picture px, the text, and its plate from the point, device
# px.
Beside = tuple[tuple[float, float], str, tuple[float, ...]]


@dataclass(frozen=True, eq=False, slots=True)
class _Seen:
    """The view when it was last painted: position of the picture, visible area."""

    world: QTransform
    room: QRectF  # device px

    def beside_points(self, groups: tuple[Labels, ...]) -> frozenset[Beside]:
        """Return where texts are that give way to others."""
        scale, room = self.world.m11(), self.room
        at = scale, self.world.dx() + 0.5 * scale, self.world.dy() + 0.5 * scale
        box = room.left(), room.top(), room.right(), room.bottom()
        return _beside_points(groups, at, box, text_times())

    def areas_of(self, texts: frozenset[Beside]) -> list[QRectF]:
        """Return what they cover, scene coordinates."""
        point = 1.0 / self.world.m11()
        areas = []
        for (x, y), _, moved in texts:
            left, top, right, bottom = (point * edge for edge in moved)
            box = QRectF(x + 0.5 + left, y + 0.5 + top, right - left, bottom - top)
            areas.append(box.adjusted(-2 * point, -2 * point, 2 * point, 2 * point))
        return areas


@lru_cache(maxsize=8)
def _beside_points(
    groups: tuple[Labels, ...], at: tuple[float, float, float], room: Box, times: float
) -> frozenset[Beside]:
    scale, left, top = at
    found = []
    for plate in arranged(groups, at, room, times=times):
        x, y = plate.labels.positions[plate.row].tolist()
        point = (x * scale + left, y * scale + top) * 2
        moved = tuple(round(p - a, 2) for p, a in zip(plate.place, point, strict=True))
        found.append(((x, y), plate.text, moved))
    return frozenset(found)


class OverlayItem(QGraphicsItem):
    """Everything drawn over the picture; scene coordinates are the picture's pixel squares."""

    def __init__(self) -> None:
        super().__init__()
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemUsesExtendedStyleOption)
        self.setZValue(1)
        self.overlay = EMPTY_OVERLAY
        self.wireframes = EMPTY_OVERLAY  # over the overlay's lines, under marks and gestures
        self.ghosts = EMPTY_OVERLAY  # below everything
        self.gesture = EMPTY_OVERLAY  # above everything; what is below rarely changes meanwhile
        self._clear = Labels(_NO_PLACES, (), "")
        self._layers: tuple[Overlay, ...] | None = None
        self._still_ghosts = StillOverlay()
        self._still = StillOverlay()
        self._still_below_gesture = StillOverlay()
        self.side: QRectF | None = None  # of the viewport, in points; None: all of it
        self._area = QRectF()
        self._painted_at: _Seen | None = None

    def set_area(self, area: QRectF) -> None:
        """Set the area that may be painted (points may lie outside the picture)."""
        self.prepareGeometryChange()
        self._area = QRectF(area)

    def set_overlay(self, overlay: Overlay, scale: float, *, everywhere: bool = False) -> None:
        """Show another overlay; ``scale`` is screen px per picture px, for the reach of marks.

        ``everywhere`` spares the comparison when the whole picture is painted anyway.
        """
        if everywhere:
            self.overlay, self._layers = overlay, None
            self.update()
            return
        if overlay is self.overlay:
            return
        changed = changed_areas(self.overlay, overlay, scale)
        before, self.overlay, self._layers = self._texts, overlay, None
        self._update_areas(changed + self._given_way(before))

    def _update_areas(self, areas: list[QRectF]) -> None:
        scene = self.scene()
        for area in areas:  # Qt would unite those of an item
            if scene is not None:
                scene.update(area & self._area)

    def set_wireframes(self, wireframes: Overlay) -> None:
        """Show what other sources see of the field."""
        if wireframes is not self.wireframes:
            self.wireframes, self._layers = wireframes, None
            self.update()

    def set_ghosts(self, ghosts: Overlay, scale: float) -> None:
        """Show what is expected of elements not annotated yet; ``scale`` as for `set_overlay`."""
        if ghosts is not self.ghosts:
            area = _whole_area(self.ghosts, scale) | _whole_area(ghosts, scale)
            before, self.ghosts, self._layers = self._texts, ghosts, None
            self.update(area & self._area)
            self._update_areas(self._given_way(before))

    def keep_clear(self, places: Sequence[QRect]) -> None:
        """Keep places of the viewport free of texts."""
        boxes = tuple((p.x(), p.y(), p.x() + p.width(), p.y() + p.height()) for p in places)
        if boxes != self._clear.covered:
            before, self._clear = self._texts, Labels(_NO_PLACES, (), "", covered=boxes)
            self._update_areas(self._given_way(before))

    def set_gesture(self, gesture: Overlay, scale: float) -> None:
        """Show what the mouse drags or draws, or nothing; ``scale`` as for `set_overlay`."""
        if gesture is self.gesture:
            return
        changed = changed_areas(self.gesture, gesture, scale)
        self.gesture, self._layers = gesture, None
        if gesture is EMPTY_OVERLAY:
            self._still_below_gesture = StillOverlay()
        self._update_areas(changed)

    def place_labels(self) -> None:
        """View or side changed: texts may have to lie elsewhere next to their points.

        The view moves what is painted along and paints only what comes into sight.
        """
        scene = self.scene()
        if scene is None or not scene.views():
            return
        view, before = scene.views()[0], self._painted_at
        self._painted_at = _Seen(view.viewportTransform(), self._room(view.viewport().size()))
        labels = self._texts
        now = self._painted_at.beside_points(labels)
        was = now if before is None else before.beside_points(labels)
        for area in self._painted_at.areas_of(was ^ now):
            self.update(area & self._area)

    def text_at(self, place: QPointF) -> str:
        """Return the text that covers a place, scene coordinates; empty where none does."""
        seen = self._painted_at
        for text in seen.beside_points(self._texts) if seen is not None else ():
            if seen is not None and seen.areas_of(frozenset((text,)))[0].contains(place):
                return text[1]
        return ""

    @property
    def _texts(self) -> tuple[Labels, ...]:
        """Return the texts that give way to each other."""
        return (*self.ghosts.labels, *self.overlay.labels, self._clear)

    def _given_way(self, before: tuple[Labels, ...]) -> list[QRectF]:
        """Return where texts go that stay what they are, and come to, as others came or went."""
        seen, after = self._painted_at, self._texts
        if seen is None or before == after:
            return []
        cursor = self.gesture.labels
        was, now = seen.beside_points((*before, *cursor)), seen.beside_points((*after, *cursor))
        return seen.areas_of(was ^ now)

    def _room(self, viewport: QSize) -> QRectF:
        """Return what can be seen of this item, in points of the viewport."""
        return self.side if self.side is not None else QRectF(QPointF(), QSizeF(viewport))

    def boundingRect(self) -> QRectF:
        return self._area

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionGraphicsItem,
        widget: QWidget | None = None,
    ) -> None:
        world = painter.worldTransform()
        clip = world.mapRect(option.exposedRect)
        painter.save()
        painter.resetTransform()
        if self.side is not None:
            clip &= self.side
            painter.setClipRect(self.side, Qt.ClipOperation.IntersectClip)
        if not clip.isEmpty() and widget is not None:
            self._paint(painter, world, clip, widget.size())
        painter.restore()

    def _paint(self, painter: QPainter, world: QTransform, clip: QRectF, room: QSize) -> None:
        scale, offset = world.m11(), (world.dx(), world.dy())
        seen = self._room(room)
        self._painted_at = _Seen(QTransform(world), seen)
        layers = self.layers
        if self.gesture is not EMPTY_OVERLAY:
            self._still_below_gesture.paint(
                painter, layers[:-1], scale=scale, offset=offset, clip=clip, room=room, seen=seen,
                lines_only=True,
            )  # fmt: skip
            marks = chain.from_iterable(layer.marks for layer in layers)
            texts = chain.from_iterable(layer.labels for layer in layers[:-1])
            above = Overlay(self.gesture.strokes, tuple(marks), tuple(texts))
            layers = above, Overlay((), (), self.gesture.labels)
        for layer in layers:
            if layer is self.ghosts or layer is self.wireframes:
                still = self._still_ghosts if layer is self.ghosts else self._still
                still.paint(
                    painter, (layer,), scale=scale, offset=offset, clip=clip, room=room, seen=seen,
                    texts=self._texts,
                )  # fmt: skip
            else:
                paint_overlay(
                    painter, layer, scale=scale, offset=offset, clip=clip, room=seen,
                    text_times=text_times(),
                    texts=(*self._texts, *self.gesture.labels),
                )  # fmt: skip

    @property
    def layers(self) -> tuple[Overlay, ...]:
        """Return what is painted, first to last."""
        if self._layers is None:
            below, above = self.overlay, EMPTY_OVERLAY
            if self.wireframes.strokes:
                below, above = split_layers(self.overlay)
            every = self.ghosts, below, self.wireframes, above, self.gesture
            self._layers = tuple(layer for layer in every if layer is not EMPTY_OVERLAY)
        return self._layers


def split_layers(overlay: Overlay) -> tuple[Overlay, Overlay]:
    """The lines that wireframes may hide, and what must not be hidden: error vectors, marks."""
    below = tuple(s for s in overlay.strokes if s.layer != "whisker")
    vectors = tuple(s for s in overlay.strokes if s.layer == "whisker")
    return Overlay(below, (), ()), Overlay(vectors, overlay.marks, overlay.labels)


def changed_areas(old: Overlay, new: Overlay, scale: float) -> list[QRectF]:
    """Return what has to be painted again, in scene coordinates, place by place.

    Groups that are the very same are not examined.
    """
    point = 1.0 / scale
    areas: list[QRectF] = []
    looked_at: set[tuple[int, int]] = set()  # lines of several looks, one over the other
    times = text_times()
    groups = chain(zip_longest(old.strokes, new.strokes), zip_longest(old.marks, new.marks))
    for was, now in [(was, now) for was, now in groups if was is not now]:
        if _seen(was) or _seen(now):
            rows, others, same_look = _rows(was), _rows(now), _look(was) == _look(now)
            pair = id(rows), id(others)
            if not same_look or pair not in looked_at:
                looked_at.add(pair)
                _add(areas, _changed(rows, others, same_look, _MARGIN * point))
    for labels, after in zip_longest(old.labels, new.labels):
        if labels is not after:
            for place, text, _ in _texts(labels) ^ _texts(after):
                _add(areas, _reach_of_label(place, text, point, times))
    return areas


def _add(areas: list[QRectF], area: QRectF) -> None:
    """One more area; those that overlap become one."""
    if area.isEmpty():
        return
    for i, other in enumerate(areas):
        if other.intersects(area):
            areas.pop(i)
            _add(areas, other | area)
            return
    areas.append(area)


def _seen(group: Strokes | PointMarks | None) -> bool:
    return group is not None and group.box is not None


def _look(group: Strokes | PointMarks | None) -> tuple[object, ...]:
    if isinstance(group, Strokes):
        return group.colour, group.width, group.dash
    return () if group is None else (group.colour, group.size, group.shape)


def _rows(group: Strokes | PointMarks | None) -> Positions:
    if group is None:
        return _NO_ROWS
    return group.segments if isinstance(group, Strokes) else group.centres


def _changed(was: Positions, now: Positions, same_look: bool, margin: float) -> QRectF:
    """Return what some lines or points cover that are not painted as they were."""
    if same_look and len(was) == len(now):
        differs = (was != now).any(axis=1)
        was, now = was[differs], now[differs]
    elif same_look and len(was) and len(now):
        was, now = _different_rows(was, now)
    return _bounds(was, now, margin)


def _texts(
    labels: Labels | None,
) -> set[tuple[tuple[float, float], str, CursorSigns | None]]:
    """Each text with its place and what stands next to it."""
    if labels is None:
        return set()
    places = map(tuple, labels.positions.tolist())
    return set(zip(places, labels.texts, repeat(labels.hand)))


def _whole_area(overlay: Overlay, scale: float) -> QRectF:
    """All that an overlay covers, scene coordinates."""
    point = 1.0 / scale
    corners = [s.segments.reshape(-1, 2) for s in overlay.strokes]
    outlines = [patch.outline for patch in overlay.patches]
    places = np.concatenate([_NO_PLACES, *corners, *outlines, *(m.centres for m in overlay.marks)])
    area = _bounds(places, _NO_PLACES, _MARGIN * point)
    for labels in overlay.labels:
        for place, text, _ in _texts(labels):
            area |= _reach_of_label(place, text, point, text_times())
    return area


def _different_rows(was: Positions, now: Positions) -> tuple[Positions, Positions]:
    """Return what is left of both when equal rows are taken off their beginnings and ends."""
    common = min(len(was), len(now))
    differs = (was[:common] != now[:common]).any(axis=1)
    head = int(np.argmax(differs)) if differs.any() else common
    rest = common - head
    differs = (was[len(was) - rest :][::-1] != now[len(now) - rest :][::-1]).any(axis=1)
    tail = int(np.argmax(differs)) if differs.any() else rest
    return was[head : len(was) - tail], now[head : len(now) - tail]


def _bounds(was: Positions, now: Positions, margin: float) -> QRectF:
    both = was.reshape(-1).tolist() + now.reshape(-1).tolist()
    if not both:
        return QRectF()
    if not math.isfinite(sum(both)):
        return _EVERYWHERE
    across, down = both[::2], both[1::2]
    left, top = min(across) - margin, min(down) - margin
    right, bottom = max(across) + margin, max(down) + margin
    # Pixel centres are whole numbers in the overlay and halves in the scene.
    return QRectF(left + 0.5, top + 0.5, right - left, bottom - top)


def _reach_of_label(place: Sequence[float], text: str, point: float, times: float) -> QRectF:
    """Return the bounds of a text around its point, both picture px, scene coordinates; texts are
    ``times`` as large as usual."""
    x, y = place
    letter = _LETTER if text.isascii() else _WIDE_LETTER
    reach = ((len(text) * letter + _SIGNS) * times + 20) * point
    return QRectF(
        x - reach, y - _ABOVE * times * point, 2 * reach, (_ABOVE + _BELOW) * times * point
    )
