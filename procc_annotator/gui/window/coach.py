"""The first three steps, shown over the real picture, each until it was done once."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from procc_annotator.dataset.records import OriginKind
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.canvas.pinned import Pinned
from procc_annotator.gui.keymap import NATIVE
from procc_annotator.gui.settings import COACHED, Settings
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.window.menus import Actions
from procc_annotator.interaction import palette as tones
from procc_annotator.translation import tr, word

_PLATE, _LIGHT, _QUIET = QColor(20, 20, 20, 225), QColor("#f4f4f4"), QColor("#b4b8bc")
_PAD, _BESIDE, _SIGN = 12, 10, 26
_TITLE = word("Three steps to a frame")
_TAKEN = (OriginKind.SUGGESTED, OriginKind.ACCEPTED)  # what the camera expected


class Coach(QObject):
    """Watches what is done; what was done is ticked, and after the third step it does not reappear.

    Attributes:
        steps: what is to be done, in words.
        done: which of them were.
        card: what shows them; it lets the mouse through.
        close_button: dismisses it for good.
    """

    def __init__(
        self, document: Document, canvas: Canvas, actions: Actions, settings: Settings
    ) -> None:
        super().__init__(canvas)
        self._document, self._canvas, self._settings = document, canvas, settings
        self._actions = actions
        self.done = [False, False, False]
        self._going = False
        self._covered = 0
        viewport = canvas.viewport()
        self.card = _Card(viewport)
        self.close_button = _Close(viewport, self.end)
        self._annotated: tuple[str, frozenset[str]] = ("", frozenset())

    @property
    def steps(self) -> tuple[str, str, str]:
        """With the keys as they are now."""
        actions = self._actions
        regularise = actions["regularise_all"].shortcut().toString(NATIVE)
        tab = actions["next_ghost"].shortcut().toString(NATIVE)
        return (
            tr("Click the two ends of a painted line, then Enter"),
            tr("{keys}: points along every line, on its paint", keys=regularise),
            tr("{keys}, then Enter: take what the camera expects", keys=tab),
        )

    def begin(self) -> None:
        """Report the steps, unless they were done before."""
        if self._going or self._settings.get(COACHED):
            return
        self._going = True
        document = self._document
        document.store.watch(select.frame, self._begin_frame)
        document.store.watch(select.annotation, self._look)
        document.store.watch(lambda s: s.keymap, self._show)
        self._actions["regularise_all"].triggered.connect(lambda: self._tick(1))
        self._canvas.viewport().installEventFilter(self)
        self._begin_frame()

    def end(self) -> None:
        """Dismiss it for good."""
        self._going = False
        self._settings.set(COACHED, True)
        self._show()

    def set_covered(self, height: int) -> None:
        """Bars lie over the top of the picture: the steps stand below them, screen px."""
        self._covered = height
        self._show()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.FontChange):
            self._show()
        return False

    # --- inside ---

    def _begin_frame(self) -> None:
        frame = self._document.state.frame
        name = "" if frame is None else frame.name
        self._annotated = name, frozenset(self._document.state.annotation.annotated)
        self._show()

    def _look(self) -> None:
        """Another step of the frame's history: a line that is new, or a ghost that was taken."""
        frame = self._document.state.frame
        if not self._going or frame is None:
            return
        before = self._annotated
        now = frame.name, frozenset(self._document.state.annotation.annotated)
        self._annotated = now
        if before[0] == now[0] and now[1] > before[1]:
            self._tick(2 if self._taken(frame.name, now[1] - before[1]) else 0)

    def _taken(self, frame: str, names: frozenset[str]) -> bool:
        """Return whether elements came to be by taking what the camera expects."""
        document = self._document
        origins = document.review.origins(frame)
        lines = filter(None, map(document.state.annotation.get, names))
        keys = ((p.u, p.v) for line in lines for p in line.points)
        return any(key in origins and origins[key].kind in _TAKEN for key in keys)

    def _tick(self, step: int) -> None:
        if self._going:
            self.done[step] = True
            if all(self.done):
                self.end()
            self._show()

    def _show(self) -> None:
        shown = self._going and self._document.state.frame is not None
        self.card.setVisible(shown)
        self.close_button.setVisible(shown)
        if not shown:
            return
        self.card.tell(self.steps, self.done)
        size = self.card.wanted_size()
        viewport = self._canvas.viewport()
        width = min(size.width(), viewport.width() - 2 * _BESIDE)
        corner = QPoint(viewport.width() - width - _BESIDE, self._covered + _BESIDE)
        self.card.put(QRect(corner, QSize(width, size.height())))
        side = self.card.fontMetrics().height() + 6
        self.close_button.put(QRect(corner.x() + width - side - 4, corner.y() + 4, side, side))
        self.card.raise_()
        self.close_button.raise_()


class _Card(Pinned):
    """The steps on a dark plate: a tick before what was done, an arrow before what comes next."""

    def __init__(self, viewport: QWidget) -> None:
        super().__init__(viewport, "coach")
        self.lines: tuple[str, ...] = ()
        self._done: list[bool] = []

    def tell(self, steps: tuple[str, ...], done: list[bool]) -> None:
        """Show the steps, and which were done."""
        self.lines, self._done = steps, list(done)
        states = zip(steps, done, strict=True)
        told = (tr("{step}, done", step=s) if d else s for s, d in states)
        self.setAccessibleName("; ".join(told))
        self.update()

    def wanted_size(self) -> QSize:
        """Room for all words."""
        metrics = QFontMetrics(self._bold())
        words = max(metrics.horizontalAdvance(line) for line in (*self.lines, tr(_TITLE) + "    "))
        rows = len(self.lines) + 1
        return QSize(words + 2 * _PAD + _SIGN, round(rows * self._row() + 2 * _PAD))

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_PLATE)
        painter.drawRoundedRect(self.rect(), 6, 6)
        row = self._row()
        left = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
        room = QRectF(_PAD, _PAD, self.width() - 2 * _PAD, row)
        painter.setPen(_QUIET)
        painter.drawText(room, left, tr(_TITLE))
        following = self._done.index(False) if False in self._done else -1
        for number, (line, done) in enumerate(zip(self.lines, self._done, strict=True)):
            room = room.translated(0, row)
            here = number == following
            painter.setFont(self._bold() if here else self.font())
            painter.setPen(QColor(tones.PASSES).lighter(140) if done else _LIGHT)
            painter.drawText(room, left, "✓" if done else "▸" if here else str(number + 1))
            painter.setPen(_LIGHT if here else _QUIET)
            words = room.adjusted(_SIGN, 0, 0, 0)
            elide = Qt.TextElideMode.ElideRight
            shown = painter.fontMetrics().elidedText(line, elide, int(words.width()))
            painter.drawText(words, left, shown)

    def _bold(self) -> QFont:
        font = QFont(self.font())
        font.setBold(True)
        return font

    def _row(self) -> float:
        return self.fontMetrics().height() * 1.45


class _Close(Pinned):
    """A cross that takes a click."""

    def __init__(self, viewport: QWidget, closed: Callable[[], object]) -> None:
        super().__init__(viewport, "coachClose")
        self._closed = closed
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents, False)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setToolTip(tr("Put the three steps away for ever (Help has the user guide)"))
        self.setAccessibleName(tr("Put the three steps away"))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        event.accept()
        self._closed()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setPen(_LIGHT)
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, "✕")
