"""The status bar, its reports of state and cursor, and the routing of messages and errors."""

from __future__ import annotations

import sys

import numpy as np
from PySide6.QtCore import (
    QEvent,
    QMessageLogContext,
    QObject,
    QSize,
    Qt,
    QTimer,
    QtMsgType,
    Signal,
    Slot,
    qInstallMessageHandler,
)
from PySide6.QtGui import QGuiApplication, QResizeEvent
from PySide6.QtWidgets import QLabel, QMainWindow, QSizePolicy, QStatusBar, QWidget

from procc_annotator import error_log
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.messages import Bar, ConflictBar, MessageBar
from procc_annotator.gui.panels.widgets import ElidedLabel, hbox, make_label, named
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.messages import Message
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import UNSAVED
from procc_annotator.gui.theme import fixed_width
from procc_annotator.interaction.hints import KEYS, SEPARATOR
from procc_annotator.translation import tr, word


class IsolatedRow(QWidget):
    """Gives a widget all its room: whatever that asks for, nothing around is laid out anew."""

    def __init__(self, widget: QWidget) -> None:
        super().__init__()
        self._widget = widget
        widget.setParent(self)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)

    def minimumSizeHint(self) -> QSize:
        return self._widget.minimumSizeHint()

    sizeHint = minimumSizeHint

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._widget.setGeometry(self.rect())


MESSAGE_END = "  ·  "  # what just happened stands before the hint
_MESSAGE_MS = 5000
_SHARE = 0.4  # of the line, at least, is the message's: a short sentence at 1280 px
_GROUND = word("ground ±{metres:.2f} m")
_PAD = 1  # above and below a line


class HintLabel(ElidedLabel):
    """What just happened, and the hint: what the next click does, what keys do. Either keeps its
    own part; keys are whole phrases, as many as fit."""

    def __init__(self) -> None:
        super().__init__()
        self._message = self._hint = ""

    def show_line(self, message: str, hint: str) -> None:
        """Show what just happened and what comes next; either may be empty."""
        self._message, self._hint = message, hint
        self.set_text(MESSAGE_END.join(filter(None, (message, hint))))
        self.setToolTip(self.text())

    def text_for(self, width: int) -> str:
        """Return what is shown in a width, px: the message gives way first, then keys do."""
        metrics, right = self.fontMetrics(), Qt.TextElideMode.ElideRight
        shown, end = self._hint, MESSAGE_END if self._message and self._hint else ""
        rest = width - metrics.horizontalAdvance(f"{end}{shown}")
        message = metrics.elidedText(self._message, right, max(rest, round(_SHARE * width))) + end
        room = width - metrics.horizontalAdvance(message)
        while (fitting := metrics.elidedText(shown, right, room)) != shown:
            if KEYS not in shown:
                break
            first, _, keys = shown.rpartition(KEYS)
            shown = f"{first}{KEYS}{keys.rpartition(SEPARATOR)[0]}".removesuffix(KEYS)
        return f"{message}{fitting}"


class Readout(QLabel):
    """A text that changes with every move of the mouse, in fixed room."""

    def __init__(self, name: str, widest: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self._widest = widest
        self.setFont(fixed_width(self.font()))
        self.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._make_room()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._make_room()

    def _make_room(self) -> None:
        metrics = self.fontMetrics()
        self.setFixedSize(metrics.horizontalAdvance(self._widest), metrics.height() + 2)


class SteadyLabel(QLabel):
    """A label that has its neighbours laid out anew only when it needs another size."""

    def __init__(self, least: str = "") -> None:
        """Show nothing yet; there is always room for the text ``least``."""
        super().__init__()
        self._least = least

    def setText(self, text: str) -> None:
        if text == self.text():
            return
        super().setText(text)
        self._make_room()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and self.text():
            self._make_room()

    def _make_room(self) -> None:
        metrics, margins = self.fontMetrics(), self.contentsMargins()
        wide = max(map(metrics.horizontalAdvance, (self.text(), self._least)))
        # Where it is the same Qt does nothing.
        across, down = margins.left() + margins.right(), margins.top() + margins.bottom()
        self.setFixedSize(wide + across + 2, metrics.height() + down + 2)


class StatusLine(QStatusBar):
    """Hint, work under way, cursor in picture pixels and field metres."""

    def __init__(self, services: Services, canvas: Canvas) -> None:
        super().__init__()
        self._services, self._canvas = services, canvas
        self.setSizeGripEnabled(False)
        self.hint = named(HintLabel(), "hint")
        self.pixels = Readout("cursorPixels", "-1234.5 -1234.5 px ")
        self.metres = Readout("cursorMetres", "-123.5 -123.5 m ")
        self.pixels.setToolTip(
            tr("Cursor in picture pixels; the centre of the top left pixel is 0 0")
        )
        self.metres.setToolTip(tr("Cursor on the ground of the field, in metres from its centre"))
        self.apart = Readout("cursorDisagreement", "Δ 12345.67 m 1234.5 px ")
        self.apart.setToolTip(
            tr(
                "How far apart the active and the compared camera see the cursor:\n"
                "on the ground, and in pixels of the evaluation size"
            )
        )
        self.good_to = Readout("cursorUncertainty", tr(_GROUND, metres=1234.56) + " ")
        self.good_to.setToolTip(
            tr(
                "How surely the fitted camera knows the ground point at the cursor: standard\n"
                "deviation in the worst direction, whatever the cursor itself is off by"
            )
        )
        for readout in (self.apart, self.good_to):
            readout.hide()
        self.work = make_label(name="backgroundWork")
        line = QWidget()
        parts = (self.work, self.apart, self.good_to, self.pixels, self.metres)
        line.setLayout(hbox((self.hint, 1), *parts, margins=(8, _PAD, 4, _PAD)))
        self.addWidget(IsolatedRow(line), 1)
        self._hint = self._message = ""
        self._message_timer = QTimer(self, singleShot=True)
        self._message_timer.timeout.connect(self._end_message)
        self._just_told = QTimer(self, singleShot=True)  # runs until the event loop turns
        self._follow(services, canvas)

    def _follow(self, services: Services, canvas: Canvas) -> None:
        canvas.cursorMoved.connect(self.show_cursor)
        canvas.hintChanged.connect(self.set_hint)
        canvas.editor.changed.connect(self.forget)
        watch = services.store.watch
        watch(select.annotation, self.forget)
        watch(
            lambda s: (s.setup, s.projection_visible, s.active, s.cameras_of(s.active)),
            self._refresh_cursor,
        )
        for computed in (services.disagreement, services.uncertainty):
            computed.changed.connect(self._refresh_cursor)
        services.scoring.progressed.connect(self.show_scoring)
        self.set_hint(canvas.hint)

    def set_hint(self, text: str) -> None:
        """Set what the next click, Enter and Esc do; shown after the message."""
        self._hint = text
        self.hint.show_line(self._message, text)

    def tell(self, text: str) -> None:
        """Show what just happened, for a few seconds or until the next act."""
        self._message = text
        self._message_timer.start(_MESSAGE_MS)
        self._just_told.start(0)
        self.hint.show_line(text, self._hint)

    @Slot()
    def forget(self, *, just_told: bool = False) -> None:
        """Have the message go: it is of an act before, or of what is not on screen any more; also
        one that was just shown if ``just_told``."""
        if self._message and (just_told or not self._just_told.isActive()):
            self._message_timer.stop()
            self._message = ""
            self.hint.show_line("", self._hint)

    def _end_message(self) -> None:
        if self.hint.underMouse():  # what is cut is read in the tip
            self._message_timer.start(_MESSAGE_MS)
        else:
            self.forget()

    def set_work(self, text: str, tip: str = "") -> None:
        """Show the background work; empty for none."""
        self.work.setText(text)
        self.work.setToolTip(tip)

    def show_scoring(self, done: int, total: int) -> None:
        """Show the progress of scoring the set; nothing when it is complete."""
        text = tr("scoring {done:,} / {total:,}", done=done, total=total) if done < total else ""
        self.set_work(text, tr("Camera > Stop scoring the set ends it"))

    def show_comparing(self, done: int, total: int) -> None:
        """Show the progress of comparing two sources; nothing when it is over."""
        text = tr("comparing {done:,} / {total:,}", done=done, total=total) if total else ""
        self.set_work(text, tr("Camera > Stop scoring the set ends it"))

    def show_ghosts(self, done: int, total: int) -> None:
        """Show the progress of checking all ghosts; nothing when it is over."""
        text = tr("ghosts {done:,} / {total:,}", done=done, total=total) if total else ""
        self.set_work(text, tr("Esc ends it"))

    def _refresh_cursor(self) -> None:
        self.show_cursor(self._canvas.cursor_px)

    def show_cursor(self, px: tuple[float, float] | None) -> None:
        """Picture pixels, and metres on the ground when a camera is shown."""
        at = None if px is None else self._evaluated(px)
        metres = None if at is None else self._metres(at)
        self.pixels.setText("" if px is None else f"{px[0]:.1f} {px[1]:.1f} px")
        self.metres.setText("" if metres is None else f"{metres[0]:.1f} {metres[1]:.1f} m")
        disagreement, uncertainty = self._services.disagreement, self._services.uncertainty
        found, known = disagreement.value, uncertainty.value
        apart = found.at(*at) if found is not None and at is not None else None
        self.apart.setVisible(disagreement.enabled)
        self.apart.setText("" if apart is None else f"Δ {apart[0]:.2f} m {apart[1]:.1f} px")
        sd = known.at(*px) if known is not None and px is not None else None
        self.good_to.setVisible(uncertainty.enabled)
        self.good_to.setText("" if sd is None else tr(_GROUND, metres=sd))

    def _evaluated(self, px: tuple[float, float]) -> tuple[float, float] | None:
        """A place of the picture in px of the evaluation size."""
        size, target = self._services.state.picture_size, self._services.state.setup.size
        if size is None:
            return None
        # Both grids share the centres of their corners.
        return px[0] * (target[0] - 1) / (size[0] - 1), px[1] * (target[1] - 1) / (size[1] - 1)

    def _metres(self, at: tuple[float, float]) -> tuple[float, float] | None:
        camera = self._services.scorer.camera
        if camera is None:
            return None
        ground = ground_from_px(camera, np.array([at]))
        if not np.isfinite(ground).all() or np.abs(ground).max() > 999:
            return None
        metres = ground[0]
        return float(metres[0]), float(metres[1])


_TITLE = "ProCC Annotator[*]"  # not shown


class MessageRouter(QObject):
    """Puts each thing that is said in its place: what matters stays until it is dealt with."""

    def __init__(
        self,
        services: Services,
        bars: tuple[MessageBar, Bar, ConflictBar],
        status: StatusLine,
        window: QMainWindow,
    ) -> None:
        super().__init__(window)
        self._services, self._status, self._window = services, status, window
        self._messages, self._frame_bar, self._conflicts = bars
        watch = services.store.watch
        watch(select.dataset, self._messages.hide)
        watch(select.frame, self._take_frame)
        watch(lambda s: (select.annotation(s), select.mode(s)), self._show_not_editable)
        watch(lambda s: (select.frame(s), s.unsaved), self._show_saved)
        watch(select.blind, self._hide_message)
        watch(lambda s: s.notices, self._keep_notices)
        services.store.events.message.connect(self._tell)
        self._take_frame()
        self._show_saved()

    def _take_frame(self) -> None:
        if not self._services.saver.problems:
            self._messages.grow_old()  # it was of the frame before
        self._status.forget()
        self._show_not_editable()

    def _show_not_editable(self) -> None:
        why = self._services.state.why_not_editable
        text = tr("This frame is not editable. {problem}", problem=why) if why else ""
        self._frame_bar.tell(text)

    def _show_saved(self) -> None:
        saver, frame = self._services.saver, self._services.state.frame
        conflict = saver.conflict(self._services.state.frame_index)
        self._conflicts.tell(str(conflict) if conflict is not None else "")
        self._window.setWindowTitle(f"{frame.name}[*]" if frame is not None else _TITLE)
        self._window.setWindowModified(self._services.state.frame_index in saver.problems)

    def _hide_message(self) -> None:
        if self._services.state.blind:  # it may contain the score of a camera
            self._status.forget(just_told=True)

    def _keep_notices(self) -> None:
        self._messages.keep(self._services.state.notices)

    def _tell(self, message: Message) -> None:
        services = self._services
        conflict = services.saver.conflict(services.state.frame_index)
        if message.level == "info":
            self._status.tell(message.text)
        elif message.text == services.state.why_broken:
            self._status.tell(tr("not editable: the bar over the picture says why"))
        elif message.key != UNSAVED:
            # What is not saved stays in sight, whatever else fails meanwhile (a full disk fails
            # everything).
            unsaved = [notice for notice in services.state.notices if notice.key == UNSAVED]
            self._messages.show_message(message, above=unsaved)
        elif conflict is None or message.text != str(conflict):  # that one has a bar of its own
            self._messages.show_message(message)


class ErrorReports(QObject):
    """Shows what `error_log` reports. The event loop goes on, and with it saving."""

    _happened = Signal(str, str)  # perhaps in another thread

    def __init__(self, services: Services, parent: QObject) -> None:
        super().__init__(parent)
        self._services, self._details = services, ""
        self._happened.connect(self._show, Qt.ConnectionType.QueuedConnection)

    def install(self) -> None:
        """Report every unexpected error of this process here, and log the warnings of Qt."""
        error_log.install_handlers(self._happened.emit)
        qInstallMessageHandler(_log_qt)

    def copy(self) -> None:
        """Copy the details of the last unexpected error, or say that there was none."""
        path = error_log.log_path()
        if self._details:
            QGuiApplication.clipboard().setText(self._details)
            text = tr("the details are copied; they are in {path}, too", path=path)
        else:
            text = tr("there was no unexpected error; they are logged in {path}", path=path)
        self._services.say(text)

    def _show(self, line: str, details: str) -> None:
        self._details = details
        text = tr("unexpected error ({what}); saving goes on, the details are in {path}",
                  what=line, path=error_log.log_path())  # fmt: skip
        self._services.say(text, "error", remedy="copy_error")


def _log_qt(kind: QtMsgType, _: QMessageLogContext, text: str) -> None:
    if kind not in (QtMsgType.QtDebugMsg, QtMsgType.QtInfoMsg):
        error_log.log_line(f"Qt: {text}")  # not shown
    if sys.stderr is not None:
        print(text, file=sys.stderr)
