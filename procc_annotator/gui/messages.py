"""The bars over the top of the picture, and the questions that are asked."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from PySide6.QtCore import QEvent, QObject, Qt, Signal, Slot
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QMessageBox,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.gui.state.messages import Message
from procc_annotator.gui.state.state import Notice
from procc_annotator.gui.theme import alarm_colours
from procc_annotator.translation import tr, tr_count, word


class Bar(QWidget):
    """A line of text across the window, with buttons at its right end."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.follow_theme()
        self.label = QLabel()
        self.label.setWordWrap(True)
        self.label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.row = QHBoxLayout(self)
        self.row.setContentsMargins(10, 4, 6, 4)
        self.row.addWidget(self.label, 1)
        self.hide()

    def follow_theme(self) -> None:
        """Take the colours of the theme; Qt says nothing to a widget with a style sheet."""
        name = self.objectName()
        background, text = alarm_colours(QGuiApplication.palette())
        style = f"#{name} {{ background: {background}; }}"  # not shown
        style += f" #{name} QLabel {{ color: {text}; }}"  # not shown
        if style != self.styleSheet():
            self.setStyleSheet(style)


_USUAL_REMEDY = word("Choose another place…")
_REMEDIES = {"save": word("Save again"), "copy_error": word("Copy details")}


class MessageBar(Bar):
    """The last error or warning, until it is dismissed, its cause is gone, or work has gone on: it
    is seen on the frame it came up on and on the next one."""

    remedy_wanted = Signal(str)  # the action that may help

    def __init__(self) -> None:
        super().__init__("messageBar")
        self._remedy = ""
        self.remedy = QPushButton(tr(_USUAL_REMEDY))
        self.remedy.setObjectName("messageRemedy")
        self.remedy.clicked.connect(lambda: self.remedy_wanted.emit(self._remedy))
        self.row.addWidget(self.remedy)
        close = QToolButton()
        close.setText("✕")
        close.setAutoRaise(True)
        close.setToolTip(tr("Dismiss this message"))
        close.setAccessibleName(tr("Dismiss this message"))
        close.clicked.connect(self.hide)
        self.row.addWidget(close)
        self._fresh = False
        self._lines: list[Message | Notice] = []

    def tell(self, message: Message, *, above: Iterable[Notice] = ()) -> None:
        """Show one line, under those that are still so."""
        self._show_lines([*above, message])
        self._offer(message.remedy)
        self._fresh = True
        self.show()

    def keep(self, notices: Collection[Notice]) -> None:
        """These are so, and no others: dismissed what was withdrawn, if it is shown."""
        held = {notice.key for notice in notices} | {""}
        left = [line for line in self._lines if line.key in held]
        if len(left) < len(self._lines):
            self._show_lines(left)
            self._offer(getattr(left[-1], "remedy", "") if left else "")
            self.setVisible(bool(left) and not self.isHidden())

    def _show_lines(self, lines: list[Message | Notice]) -> None:
        self._lines = lines
        self.label.setText("\n".join(line.text for line in lines))

    def _offer(self, remedy: str) -> None:
        """A button of what helps: the advice in the text need not be looked for in the menus."""
        self._remedy = remedy
        self.remedy.setText(tr(_REMEDIES.get(remedy, _USUAL_REMEDY)))
        self.remedy.setVisible(bool(remedy))

    def grow_old(self) -> None:
        """Another frame is on screen; what was reported before the last one was is dismissed."""
        if not self._fresh:
            self.hide()
        self._fresh = False


class FrameBar(Bar):
    """Shows why the frame on screen cannot be edited, as long as that is so."""

    def __init__(self) -> None:
        super().__init__("frameBar")

    def tell(self, problem: str) -> None:
        """Show the problem, or nothing."""
        if problem:
            self.label.setText(tr("This frame is not editable. {problem}", problem=problem))
        self.setVisible(bool(problem))


class ConflictBar(Bar):
    """Another person changed the file of the frame on screen: whose work stays?"""

    reload_chosen = Signal()
    overwrite_chosen = Signal()

    def __init__(self) -> None:
        super().__init__("conflictBar")
        self.reload_button = QPushButton(tr("Reload theirs"))
        self.reload_button.setToolTip(tr("Show what is in the file; undo brings your version back"))
        self.reload_button.clicked.connect(self.reload_chosen)
        self.overwrite_button = QPushButton(tr("Overwrite with mine"))
        self.overwrite_button.setToolTip(tr("Write what you see on screen over the file"))
        self.overwrite_button.clicked.connect(self.overwrite_chosen)
        self.row.addWidget(self.reload_button)
        self.row.addWidget(self.overwrite_button)

    def tell(self, problem: str) -> None:
        """Show the conflict, or nothing."""
        self.label.setText(problem)
        self.setVisible(bool(problem))


class BarStack(QWidget):
    """The bars, one below the other, over the top of what they are about.

    They lie over it rather than above it: a bar may come or go unasked, and a click that is on
    its way must land where it was aimed at.
    """

    heightChanged = Signal(int)  # screen px of what is below that the bars cover

    def __init__(self, bars: Sequence[Bar], below: QWidget) -> None:
        super().__init__(below.parentWidget())
        self.setObjectName("bars")
        self._bars, self._below, self._covered = tuple(bars), below, 0
        self._column = column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        for bar in self._bars:
            column.addWidget(bar)
        below.installEventFilter(self)

    @Slot()
    def place(self) -> None:
        """Take the room that the bars need now."""
        area, column = self._below.geometry(), self._column
        wanted = 0
        if any(not bar.isHidden() for bar in self._bars):
            wanted = max(
                column.totalHeightForWidth(area.width()), column.totalMinimumSize().height()
            )
        self.setGeometry(area.x(), area.y(), area.width(), wanted)
        self.raise_()
        if wanted != self._covered:
            self._covered = wanted
            self.heightChanged.emit(wanted)

    def event(self, event: QEvent) -> bool:
        taken = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest:
            self.place()
        return taken

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Move):
            self.place()
        return False


def ask_to_delete(parent: QWidget, what: str, lost: str) -> bool:
    """Delete something that undo does not bring back?"""
    return _ask(parent, tr("Delete {what}?", what=what), lost, tr("Delete"))


def ask_to_replace(parent: QWidget, what: str, lost: str) -> bool:
    """Write over a file that says something else?"""
    text = tr("{what} is there already, and says something else.", what=what)
    return _ask(parent, text, lost, tr("Replace it"))


def _ask(parent: QWidget, text: str, lost: str, yes: str) -> bool:
    box = QMessageBox(parent)
    box.setIcon(QMessageBox.Icon.Question)
    box.setText(text)
    box.setInformativeText(lost)
    keep = box.addButton(tr("Keep it"), QMessageBox.ButtonRole.RejectRole)
    agree = box.addButton(yes, QMessageBox.ButtonRole.DestructiveRole)
    box.setDefaultButton(keep)
    box.exec()
    return box.clickedButton() is agree


def ask_to_leave_unsaved(parent: QWidget, problems: list[str]) -> bool:
    """Close although something could not be written?"""
    box = QMessageBox(parent)
    box.setIcon(QMessageBox.Icon.Warning)
    box.setText(
        tr_count(
            len(problems),
            "{n} frame is not saved, and saving failed again just now.",
            "{n} frames are not saved, and saving failed again just now.",
        )
    )
    box.setInformativeText("\n".join(problems[:5]))
    stay = box.addButton(tr("Stay"), QMessageBox.ButtonRole.RejectRole)
    leave = box.addButton(tr("Close and lose them"), QMessageBox.ButtonRole.DestructiveRole)
    box.setDefaultButton(stay)
    box.exec()
    return box.clickedButton() is leave
