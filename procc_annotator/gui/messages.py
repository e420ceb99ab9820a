"""Message bars over the picture, questions, and writing a file that the user names."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QEvent, QObject, Qt, Signal, Slot
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QAbstractButton,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QMessageBox,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.dataset.frames import Frame
from procc_annotator.gui.state.availability import as_sentence, no_frame
from procc_annotator.gui.state.background import JobControl, run_in_background
from procc_annotator.gui.state.messages import Message
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import Notice
from procc_annotator.gui.theme import alarm_colours
from procc_annotator.translation import tr, tr_count, word

T = TypeVar("T")


def opened_frame(services: Services) -> Frame | None:
    """Return the frame on screen; without one, say what to do."""
    if why := no_frame(services.state):
        services.say(why, "warning")
    return services.state.frame


def ask_where(
    services: Services, parent: QWidget, title: str, name: str, kinds: str
) -> Path | None:
    """Ask for a file next to the folder of pictures; None if nowhere.

    Args:
        services: nothing is asked, and that is said, where no frame is open.
        name: offered for the file.
        kinds: Qt's filters; a name without a suffix gets that of the kind that was chosen.
    """
    if (frame := opened_frame(services)) is None:
        return None
    start = frame.image_path.parent.parent / name
    chosen, kind = QFileDialog.getSaveFileName(parent, title, str(start), kinds)
    if not chosen:
        return None
    path = Path(chosen)
    suffix = (kinds if ";;" not in kinds else kind).partition("(*.")[2].rstrip(")")
    return path.with_suffix(f".{suffix}") if suffix and not path.suffix else path


def write(
    services: Services,
    work: Callable[[JobControl], T],
    said: Callable[[T], str],
    *,
    owner: QObject | None = None,
    progress: Callable[[int, int], None] | None = None,
    again: str = "",
) -> None:
    """Write in the background, and say what came of it.

    Args:
        said: in words, what came of it.
        owner: nothing is said once it is gone; the services unless given.
        progress: receives how many of how many are done.
        again: the action that asks for another place.
    """
    run_in_background(
        work,
        on_result=lambda result: services.say(said(result)),
        on_error=lambda text: services.say(text, "error", again),
        on_progress=progress,
        owner=services if owner is None else owner,
    )


class Bar(QWidget):
    """A line of text across the window, with buttons at its right end."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.follow_theme()
        self.label = QLabel(wordWrap=True)
        self.label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.row = QHBoxLayout(self)
        self.row.setContentsMargins(10, 4, 6, 4)
        self.row.addWidget(self.label, 1)
        self.hide()

    def tell(self, text: str) -> None:
        """Show a text; nothing if it is empty."""
        if text:
            self.label.setText(text)
        self.setVisible(bool(text))

    def add_button(self, button: QAbstractButton, tip: str, do: Callable[[], object]) -> None:
        """Put a button at the right end."""
        button.setToolTip(tip)
        button.clicked.connect(do)
        self.row.addWidget(button)

    def follow_theme(self) -> None:
        """Take the colours of the theme; Qt says nothing to a widget with a style sheet."""
        name = self.objectName()
        background, text = alarm_colours(QGuiApplication.palette())
        style = f"#{name} {{ background: {background}; }}"  # not shown
        style += f" #{name} QLabel {{ color: {text}; }}"  # not shown
        if style != self.styleSheet():
            self.setStyleSheet(style)


_USUAL_REMEDY = word("Choose another place…")
_REMEDIES = {
    "save_copies": word("Save copies to…"),
    "copy_error": word("Copy details"),
    "next_doubtful": word("Show the next"),
}


class MessageBar(Bar):
    """The last error or warning, until it is dismissed, its cause is gone, or work has gone on: it
    is seen on the frame it came up on and on the next one."""

    def __init__(self, do: Callable[[str], object]) -> None:
        """Show nothing yet; ``do`` receives the name of an action that may help."""
        super().__init__("messageBar")
        self._remedy = ""
        self.remedy = QPushButton(tr(_USUAL_REMEDY))
        self.remedy.setObjectName("messageRemedy")
        self.add_button(self.remedy, "", lambda: do(self._remedy))
        close = QToolButton(autoRaise=True)
        close.setText("✕")
        close.setAccessibleName(tr("Dismiss this message"))
        self.add_button(close, tr("Dismiss this message"), self.hide)
        self._fresh = False
        self._lines: list[Message | Notice] = []

    def show_message(self, message: Message, *, above: Iterable[Notice] = ()) -> None:
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


class ConflictBar(Bar):
    """Asks which work stays: another person changed the file of the frame on screen."""

    def __init__(self, reload: Callable[[], object], overwrite: Callable[[], object]) -> None:
        super().__init__("conflictBar")
        self.reload_button = QPushButton(tr("Reload theirs"))
        tip = tr("Show what is in the file; undo brings your version back")
        self.add_button(self.reload_button, tip, reload)
        self.overwrite_button = QPushButton(tr("Overwrite with mine"))
        tip = tr("Write what you see on screen over the file")
        self.add_button(self.overwrite_button, tip, overwrite)


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
    return _ask(parent, tr("Delete {what}?", what=what), lost, tr("Keep it"), tr("Delete")) > 0


def ask_to_replace(parent: QWidget, what: str, lost: str) -> bool:
    """Write over a file that says something else?"""
    text = tr("{what} is there already, and says something else.", what=what)
    return _ask(parent, text, lost, tr("Keep it"), tr("Replace it")) > 0


def ask_to_approve(parent: QWidget, open_comments: int) -> bool:
    """Approve a frame although comments on it are open?"""
    text = tr_count(
        open_comments,
        "{n} comment on this frame is not settled.",
        "{n} comments on this frame are not settled.",
    )
    settled = tr("A tick in the Review panel settles a comment.")
    return _ask(parent, text, settled, tr("Do not approve"), tr("Approve")) > 0


def ask_done_only(parent: QWidget, unfinished: int, total: int) -> bool | None:
    """Export only the frames that are done? None: export nothing."""
    text = tr("{n:,} of {total:,} frames are not done.", n=unfinished, total=total)
    answer = _ask(parent, text, "", tr("Cancel"), tr("Export all"), tr("Done only"))
    return answer > 1 if answer else None


def ask_to_unlock(parent: QWidget, reason: str, lost: str) -> bool:
    """Ask whether blind mode is unlocked; ``reason``: who locked it and when."""
    answers, icon = (tr("Keep it locked"), tr("Unlock, and record it")), QMessageBox.Icon.Warning
    return _ask(parent, as_sentence(reason), lost, *answers, icon=icon) > 0


def ask_to_leave_unsaved(parent: QWidget, problems: list[str]) -> bool:
    """Close although something could not be written?"""
    text = tr_count(
        len(problems),
        "{n} frame is not saved, and saving failed again just now.",
        "{n} frames are not saved, and saving failed again just now.",
    )
    answers, icon = (tr("Stay"), tr("Close and lose them")), QMessageBox.Icon.Warning
    return _ask(parent, text, "\n".join(problems[:5]), *answers, icon=icon) > 0


def _ask(
    parent: QWidget,
    text: str,
    lost: str,
    *answers: str,
    icon: QMessageBox.Icon = QMessageBox.Icon.Question,
) -> int:
    """Return the index of the answer; 0, which changes nothing, for Esc, too."""
    box = QMessageBox(icon, "", text, parent=parent, informativeText=lost)
    role = QMessageBox.ButtonRole
    keep = box.addButton(answers[0], role.RejectRole)
    buttons: list[QAbstractButton] = [keep]
    buttons += [box.addButton(one, role.DestructiveRole) for one in answers[1:]]
    box.setDefaultButton(keep)
    box.exec()
    return buttons.index(box.clickedButton())
