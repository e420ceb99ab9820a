"""The legend in the corner of the picture; it hides while the cursor is near."""

from __future__ import annotations

import math

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRect, QRectF, Qt, Signal, Slot
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from procc_annotator.dataset.records import OriginKind
from procc_annotator.gui.canvas.comparison import OtherSources
from procc_annotator.gui.canvas.overlay_painter import paint_samples
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.canvas.viewport_overlays import ViewportOverlay
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.state.services import Services
from procc_annotator.interaction.legend import LegendEntry, OnPicture, corner_legend
from procc_annotator.interaction.overlay import ColourBy

_EDGE = 8
_SAMPLE, _GAP = 30.0, 8.0
_PLATE = QColor(20, 20, 20, 200)
_TEXT = QColor("#f4f4f4")
_AROUND = 24  # screen px around it within which the cursor hides it
_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


class CornerLegend(ViewportOverlay):
    """Explains what is over the picture at its lower right corner, and nothing else."""

    stood = Signal(list)  # where it and what stands beneath it are, viewport px

    def __init__(self, services: Services, view: PictureView, comparison: OtherSources) -> None:
        super().__init__(view.viewport(), "cornerLegend")
        self._services, self._viewport, self._comparison = services, view.viewport(), comparison
        self.entries: tuple[LegendEntry, ...] = ()
        self._wanted, self._bare = True, False
        self._others: tuple[tuple[str, str], ...] = ()
        self._by: ColourBy = "criterion"
        self._hand: QPointF | None = None
        self._soon = after_paint(self, self._look)
        view.resized.connect(self._soon.start)
        for beneath in self._beneath():
            beneath.installEventFilter(self)
        services.store.watch(
            lambda s: (select.score(s), select.cameras(s), s.blind), self._soon.start
        )
        for signal in (
            services.source_frames.changed,
            services.ghosts.changed,
            services.second_annotator.changed,
            services.review.originsChanged,
        ):
            signal.connect(self._soon.start)

    def set_wanted(self, wanted: bool) -> None:
        """Show the legend, or not (View menu)."""
        self._wanted = wanted
        self._look()

    def show_for(self, colour_by: ColourBy, *, bare: bool) -> None:
        """Explain these colours; nothing for the bare picture."""
        shown = colour_by, bare, self._comparison.names_of_others()
        if shown != (self._by, self._bare, self._others):
            self._by, self._bare, self._others = shown
            self._soon.start()

    @Slot(object)
    def follow(self, cursor: QPointF | None) -> None:
        """Hide while the cursor (viewport px) is near."""
        self._hand = cursor
        if self.entries:
            self._show()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Show, QEvent.Type.Hide):
            self._soon.start()
        return False

    # --- inside ---

    def _look(self) -> None:
        shown = self._wanted and not self._bare and self._services.state.frame is not None
        self.entries = corner_legend(self._there()) if shown else ()
        self.setAccessibleName("; ".join(entry.text for entry in self.entries))
        self._stand()
        self._show()
        self.update()

    def _show(self) -> None:
        near = self._hand is not None and self.geometry().adjusted(
            -_AROUND, -_AROUND, _AROUND, _AROUND
        ).contains(self._hand.toPoint())
        self.setVisible(bool(self.entries) and not near)

    def _there(self) -> OnPicture:
        services = self._services
        annotation, score = services.state.annotation, services.scorer.score
        painted, foresight = services.ghosts.painted, services.prediction
        unsure = foresight.stands_in and bool(foresight.doubt)
        origins = self._origins()
        return OnPicture(
            annotated=bool(annotation.annotated),
            statuses=None if score is None else {e.status for e in score.elements},
            colour_by=self._by,
            origins=origins[0],
            authors=origins[1],
            ghosts=("unsure" if unsure else "sure") if painted else "",
            unconfirmed=bool(annotation.unconfirmed),
            second=services.second_annotator.annotation is not None
            and services.state.projection_visible,
            others=self._comparison.names_of_others(),
        )

    def _origins(self) -> tuple[frozenset[str], tuple[str, ...]]:
        """Return origins and authors of the points."""
        services = self._services
        if self._by not in ("origin", "annotator") or services.state.frame is None:
            return frozenset(), ()
        known = services.review.origins(services.state.frame.name) or {}
        keys = {(p.u, p.v) for line in services.state.annotation.polylines for p in line.points}
        kinds = {known[key].kind if key in known else OriginKind.FILE for key in keys}
        authors = tuple(sorted({origin.author for origin in known.values()}))
        return frozenset(kind.value for kind in kinds), authors

    def _stand(self) -> None:
        """At the lower right, above what else stands there."""
        metrics = QFontMetricsF(self.font())
        texts = [metrics.horizontalAdvance(entry.text) for entry in self.entries]
        line = math.ceil(metrics.height()) + 2
        width = math.ceil(max(texts, default=0) + _SAMPLE + _GAP + 2 * _EDGE)
        height = line * len(self.entries) + 2 * _EDGE - 4
        room = self._viewport.size()
        width = min(width, room.width() - 2 * _EDGE)
        corner = QPoint(room.width() - width - _EDGE, room.height() - height - _EDGE)
        place = QRect(corner.x(), corner.y(), width, height)
        for other in self._beneath():
            if not other.isHidden() and other.geometry().intersects(place):
                place.moveBottom(other.geometry().top() - _EDGE // 2)
        self.put(place)
        shown = [other.geometry() for other in self._beneath() if not other.isHidden()]
        self.stood.emit([*shown, place] if self.entries else shown)

    def _beneath(self) -> list[QWidget]:
        """Return what stands at the lower edge, too, and stays there."""
        named = (self._viewport.findChild(QWidget, name) for name in ("blindBadge", "foundPlate"))
        return [other for other in named if other is not None]

    def paintEvent(self, event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            self.paint_plate(painter, _PLATE)
            line = (self.height() - 2 * _EDGE + 4) / max(1, len(self.entries))
            middles = [_EDGE - 2 + line * (i + 0.5) for i in range(len(self.entries))]
            places = [(_EDGE, y) for y in middles]
            paint_samples(painter, self.entries, places, length=_SAMPLE)
            painter.setPen(_TEXT)
            left = _EDGE + _SAMPLE + _GAP
            for entry, y in zip(self.entries, middles, strict=True):
                room = QRectF(left, y - line / 2, self.width() - left - _EDGE / 2, line)
                painter.drawText(room, _LEFT, entry.text)
