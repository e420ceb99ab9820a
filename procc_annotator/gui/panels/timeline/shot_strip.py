"""The timeline below the picture: every frame of a video or a shot, to see and to go to."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, SignalInstance
from PySide6.QtGui import (
    QAccessible,
    QFocusEvent,
    QHelpEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from procc_annotator.dataset.computed_cameras import review_reason
from procc_annotator.dataset.records import Status
from procc_annotator.dataset.sequence import FrameSequence
from procc_annotator.gui.panels.timeline.content import Axis, StripContent
from procc_annotator.gui.panels.timeline.painting import StripPainter
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import give_role
from procc_annotator.translation import tr, word

# How a frame's camera came about.
_STATES = {
    "anchor": word("anchor", "a frame"),
    "followed": word("followed", "a frame"),
    "bridged": word("bridged", "a frame"),
    "lost": word("lost", "a frame"),
}


def strip_words(services: Services, content: StripContent, number: int | None) -> str:
    """Number, time and what is known of its camera, in a line."""
    sequence = content.sequence
    if sequence is None or number is None:
        return ""
    index = sequence.index_of.get(number)
    name = None
    if index is not None and services.state.workspace is not None:
        name = services.state.workspace.frames[index].name
    said = [
        tr(
            "frame {number} of {first}–{last}",
            number=number,
            first=sequence.first,
            last=sequence.last,
        )
    ]
    if name is not None and "/" in name:
        said = [name]  # in a tree numbers go on from folder to folder
    if sequence.step > 1:
        said.append(tr("names count by {step}", step=sequence.step))
    if sequence.video is not None:
        seconds = number / sequence.fps
        said.append(f"{int(seconds // 60)}:{seconds % 60:05.2f}")
    if number in content.anchors:
        said.append(tr("annotated"))
    if number in content.dragged and not content.hidden:
        said.append(tr("its camera was dragged"))
    status = content.statuses.get(number, Status.UNTOUCHED)
    if status is not Status.UNTOUCHED:
        said.append(tr(status.value, "a frame"))
    if services.state.reveals(name):
        said.extend(_of_track(services, number))
    else:
        said.append(tr("blind: its camera is hidden"))
    return "  ·  ".join(said)


def _of_track(services: Services, number: int) -> list[str]:
    frame = services.shot_track.tracked.get(number)
    if frame is None:
        return []
    said = [tr(_STATES[frame.state], "a frame")]
    if frame.fit is not None and frame.fit.camera is not None:
        said[0] = tr(
            "{state}, {share:.0%} of the lines on paint", state=said[0], share=frame.coverage
        )
        if (far := frame.residual_px) is not None:
            said[0] = tr("{found}, {far:.1f} px from it", found=said[0], far=far)
    if doubt := review_reason(frame):
        said.append(tr("doubtful: {why}", why=doubt))
    return said


_WHEEL_STEP = 1.25
_SIDE = 8  # px left and right of the frames


class StripTask(Protocol):
    """Work on a stretch of frames."""

    changed: SignalInstance  # how far it is
    marked: Callable[[], tuple[int, int] | None]

    def words(self) -> str:
        """Return how far it is; "" while it does nothing."""
        ...


_SHIFT = Qt.KeyboardModifier.ShiftModifier
_ALL = 1 << 30
_WAYS = {
    Qt.Key.Key_Left: -1,
    Qt.Key.Key_Right: 1,
    Qt.Key.Key_Home: -_ALL,
    Qt.Key.Key_End: _ALL,
}


class ShotStrip(QWidget):
    """Paints a `StripContent`; a click or a drag goes to frames, the wheel zooms."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        give_role(self, QAccessible.Role.Slider)
        self.setObjectName("shotStrip")
        self.setAccessibleName(tr("Frames of the shot"))
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.setAccessibleDescription(
            tr("The arrows go from frame to frame, with Shift they mark a stretch, Esc forgets it")
        )
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the keys to the picture
        self._services = services
        self.content = StripContent(services, self)
        self._axis: Axis | None = None
        self._followed: FrameSequence | None = None  # what the axis is of
        self._aim: int | None = None  # the number that is dragged to
        self._mark_from: int | None = None
        self.stretch: tuple[int, int] | None = None  # numbers, first and last, marked by hand
        self._tasks: tuple[StripTask, ...] = ()
        self._painted: QPixmap | None = None
        self._painted_of: tuple[object, ...] = ()
        self.content.changed.connect(self._paint_anew)
        self._refresher = services.store.watch_visible(
            self,
            self._follow,
            lambda s: (s.workspace, s.frame_index, s.blind, s.committed),
            self.content.changed,
        )

    def show_tasks(self, *tasks: StripTask) -> None:
        """Say how far these are, and which stretch is marked."""
        self._tasks = tasks
        for task in tasks:
            task.marked = lambda: self.stretch
            task.changed.connect(self.update)

    # --- what is shown ----------------------------------------------------------------------

    @property
    def axis(self) -> Axis | None:
        """Which frames are in sight along the width there is; None while there are none."""
        return None if self._axis is None else self._axis.with_width(self._room())

    @axis.setter
    def axis(self, axis: Axis | None) -> None:
        self._axis = axis

    @property
    def number(self) -> int | None:
        """The frame on screen, or the one that the user drags to."""
        sequence, index = self.content.sequence, self._services.state.frame_index
        if self._aim is not None or sequence is None:
            return self._aim
        return int(sequence.numbers[index]) if 0 <= index < len(sequence.numbers) else None

    def _follow(self) -> None:
        sequence = self.content.sequence
        if sequence is not self._followed:
            self._followed, self.stretch = sequence, None
            whole = None
            if sequence is not None:
                whole = Axis.whole(sequence.first, sequence.last, self._room())
            self._axis = whole
        number = self.number
        if self._axis is not None and number is not None and self._aim is None:
            self._axis = self._axis.showing(number)
        self.update()

    def _room(self) -> float:
        return max(1.0, self.width() - 2.0 * _SIDE)

    def sizeHint(self) -> QSize:
        return QSize(400, StripPainter.height(self.fontMetrics()))

    def minimumSizeHint(self) -> QSize:
        return QSize(120, StripPainter.height(self.fontMetrics()))

    def paintEvent(self, event: QPaintEvent) -> None:
        axis = self.axis
        if axis is None:
            return
        area = QRectF(_SIDE, 0, self._room(), self.height())
        strip = StripPainter(self.fontMetrics(), axis, area, self.palette())
        with QPainter(self) as painter:
            painter.drawPixmap(0, 0, self._frames_painted(axis, strip))
            far = next(filter(None, (task.words() for task in self._tasks)), "")
            words = strip_words(self._services, self.content, self.number)
            strip.paint_here(painter, self.number, words, far)

    def _frames_painted(self, axis: Axis, strip: StripPainter) -> QPixmap:
        """All but what changes from frame to frame, painted anew where it changed."""
        ratio = self.devicePixelRatioF()
        of = (axis, self.size(), ratio, self.stretch, self.content.hidden, self.palette())
        if self._painted is None or self._painted_of != of:
            self._painted_of = of
            self._painted = QPixmap(self.size() * ratio)
            self._painted.setDevicePixelRatio(ratio)
            with QPainter(self._painted) as painter:
                painter.setFont(self.font())
                strip.paint_frames(painter, self.content, self.stretch)
        return self._painted

    def _paint_anew(self) -> None:
        self._painted = None

    # --- keys and mouse ---------------------------------------------------------------------

    def keyPressEvent(self, event: QKeyEvent) -> None:
        sequence, number = self.content.sequence, self.number
        far = _WAYS.get(Qt.Key(event.key()))
        if event.key() == Qt.Key.Key_Escape and self.stretch is not None:
            self.stretch = self._mark_from = None
            self.update()
        elif sequence is None or number is None or far is None:
            event.ignore()
        else:
            self._go_by_key(number, far, marking=bool(event.modifiers() & _SHIFT))

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if not event.isAutoRepeat():
            self._aim = None
            self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self._aim = None  # another widget gets the release of the key
        self.update()

    def _go_by_key(self, number: int, far: int, *, marking: bool) -> None:
        """Step by frames; with Shift the frames passed are marked."""
        sequence = self.content.sequence
        assert sequence is not None
        index = min(max(sequence.nearest(number) + far, 0), len(sequence.numbers) - 1)
        there, begun = int(sequence.numbers[index]), self.stretch
        self._go(there)
        if marking:
            # The end that was gone away from stays.
            stays = number if begun is None else begun[0] if number == begun[1] else begun[1]
            self.stretch = min(stays, there), max(stays, there)
        self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton or self.axis is None:
            event.ignore()
            return
        number = self._number_under(event.position())
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self._mark_from = number
            self._mark(number)
        else:
            self._go(number)
        event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._mark_from is not None:
            self._mark(self._number_under(event.position()))
        elif self._aim is not None:
            self._go(self._number_under(event.position()))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._mark_from = self._aim = None
        self.update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if self.axis is not None and self.stretch is not None:
            self.stretch = None
            self.update()

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.axis is None:
            event.ignore()
            return
        turned = event.angleDelta()
        sideways = turned.x() or (
            turned.y() if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 0
        )
        if sideways:
            span = self.axis.end - self.axis.begin
            self.axis = self.axis.scrolled(-sideways / 120 * span / 10)
        else:
            times = _WHEEL_STEP ** (turned.y() / 120)
            self.axis = self.axis.zoomed(times, event.position().x() - _SIDE)
        self.update()
        event.accept()

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and self.axis is not None:
            number = self._number_under(QPointF(event.pos()))
            QToolTip.showText(
                event.globalPos(), strip_words(self._services, self.content, number), self
            )
            return True
        if event.type() == QEvent.Type.FontChange:
            self._paint_anew()
            self.updateGeometry()
        return super().event(event)

    def _number_under(self, place: QPointF) -> int:
        assert self.axis is not None
        return self.axis.number_at(place.x() - _SIDE)

    def _go(self, number: int) -> None:
        sequence = self.content.sequence
        if sequence is not None:
            index = sequence.nearest(number)
            self._aim = int(sequence.numbers[index])
            self._services.navigator.come_to(index)
            self.update()

    def _mark(self, number: int) -> None:
        assert self._mark_from is not None
        self.stretch = min(self._mark_from, number), max(self._mark_from, number)
        self.update()
