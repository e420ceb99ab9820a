"""The frame's status, how its points came to be, and its thread of comments."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QLabel,
    QListWidget,
    QListWidgetItem,
)

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.records import Comment, Status
from procc_annotator.dataset.review import BlindStatus
from procc_annotator.gui.messages import ask_to_approve
from procc_annotator.gui.panels.widgets import (
    Panel,
    hbox,
    make_button,
    make_label,
    named,
    note_label,
    search_line,
    show_note,
    vbox,
)
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.availability import as_sentence, no_frame
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import muted
from procc_annotator.interaction.gestures import Position
from procc_annotator.interaction.palette import ORIGINS
from procc_annotator.translation import tr, tr_count, word

_BLIND_WORDS = {
    BlindStatus.BLIND: word("Committed in blind mode, and as it was then."),
    BlindStatus.EDITED: word("Edited after the cameras were shown."),
}


class CommentList(QListWidget):
    """The thread of comments, each with a box to tick once it is settled; the theme knows it by
    its name."""


class ReviewPanel(Panel):
    """Shows and changes what the workspace's database knows about the frame on screen."""

    def __init__(self, services: Services) -> None:
        super().__init__(services, "review_panel")
        self._shown: tuple[Comment, ...] = ()
        # The frame that was given a status last, its status and annotation before.
        self._given: tuple[str, Status, FrameAnnotation] | None = None
        self._build()
        # Comments under way and their places, by frame.
        self._typed: dict[str, tuple[str, Position | None]] = {}
        self._typed_on: str | None = None
        services.review.commentChosen.connect(self._choose)
        services.store.watch(select.dataset, self._begin_dataset)
        services.store.watch(select.frame, self._begin_frame)
        self._begin_frame()
        self._follow(
            lambda s: (s.workspace, s.frame_index, s.annotation),
            services.review.statusChanged,
            services.review.originsChanged,
            services.review.settingChanged,
        )
        self._refresh()

    def focus_comment(self) -> None:
        """Put the keyboard into the box for a new comment."""
        self.text.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def _build(self) -> None:
        self.status = make_label(name="reviewStatus")
        self.time = make_label(tip=tr("Time worked on this frame; pauses over 30 s do not count"))
        self.blind = note_label("reviewBlind")
        tip = tr("How the points of this frame came to be")
        self.origins = make_label(name="reviewOrigins", wrap=True, tip=tip)
        self.origins.setTextFormat(Qt.TextFormat.RichText)
        self.comments = named(CommentList(), "reviewThread", title=tr("Comments"))
        self.comments.setWordWrap(True)
        self.comments.setSpacing(3)
        self.comments.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.comments.itemChanged.connect(self._settle)
        self.comments.itemClicked.connect(self._go_to)
        self.comments.itemActivated.connect(self._go_to)
        right, wrong = tr("This frame is right (Ctrl+Shift+A)"), tr("Send it back (Ctrl+Shift+X)")
        self.approve = make_button(tr("Approve"), lambda: self.give("approved"), tip=right)
        self.reject = make_button(tr("Reject"), lambda: self.give("rejected"), tip=wrong)
        self.empty = QLabel(tr("No comments on this frame."))
        self.empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.text = search_line("", "reviewText", title=tr("Comments"), keys=self._text_key)
        self.text.editingFinished.connect(self._drop_empty)
        self.text.setClearButtonEnabled(False)
        tip = tr("Add the comment to the thread (Enter)")
        self.send = make_button(tr("Add"), self._send, tip=tip)
        vbox(
            hbox((self.status, 1), self.time),
            hbox((self.approve, 1), (self.reject, 1)),
            self.blind,
            self.origins,
            (self.empty, 1),
            (self.comments, 1),
            hbox((self.text, 1), self.send),
            of=self,
            margins=6,
        )

    # --- showing --------------------------------------------------------------------------

    def _refresh(self) -> None:
        services, frame = self._services, self._services.state.frame
        for part in (self.approve, self.reject, self.text, self.send):
            part.setEnabled(frame is not None)
        if frame is None:
            self.time.clear()
            show_note(self.blind, "")
            self.origins.setText(as_sentence(no_frame(services.state)))
            self._show_thread(())
            return
        record = services.review.record(frame.name)
        self.status.setText(tr(record.status.value, "a frame"))
        self.time.setText(_duration(record.seconds))
        self._show_blind(frame.name)
        counts = services.review.origin_counts(frame.name, services.state.annotation)
        # The squares are the legend of the colours by provenance.
        points = ", ".join(
            f'<span style="color:{ORIGINS[kind.value][0]}">■</span>'  # not shown
            + f" {n} {tr(kind.value, 'points')}"
            for kind, n in counts.items()
        )
        waiting = len(services.state.annotation.unconfirmed)
        lines = [tr("Points: {kinds}", kinds=points) if points else tr("Points: none")]
        if waiting:
            lines.append(
                tr_count(
                    waiting,
                    "to be confirmed (Shift+V): {n:,} element",
                    "to be confirmed (Shift+V): {n:,} elements",
                )
            )
        self.origins.setText("<br>".join(lines))
        self._show_thread(services.review.comments(frame.name))
        on_place = tr("Comment on this place") if services.review.new_place else ""
        self.text.setPlaceholderText(on_place or tr("Comment on this frame"))

    def _show_blind(self, frame: str) -> None:
        """Show whether the clicks were committed before any camera was shown."""
        commit = self._services.review.blind_commit(frame)
        if commit is None:
            show_note(self.blind, "")
            return
        show_note(self.blind, tr(_BLIND_WORDS[commit.work(self._services.state.annotation)]))
        words = tr("Committed in blind mode by {author}", author=commit.author or tr("somebody"))
        if commit.time:
            words += f", {datetime.fromtimestamp(commit.time):%Y-%m-%d %H:%M}"
        self.blind.setToolTip(words)

    def _show_thread(self, comments: tuple[Comment, ...]) -> None:
        self.empty.setVisible(not comments)
        self.comments.setVisible(bool(comments))
        if comments == self._shown:
            return
        self._shown = comments
        self.comments.blockSignals(True)
        self.comments.clear()
        for number, comment in enumerate(comments, start=1):
            when = datetime.fromtimestamp(comment.time)
            pin = f"✎ {number}  " if comment.place else ""
            said = f"{pin}{comment.author}, {when:%Y-%m-%d %H:%M}\n{comment.text}"
            item = QListWidgetItem(said)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            item.setCheckState(
                Qt.CheckState.Checked if comment.resolved else Qt.CheckState.Unchecked
            )
            item.setToolTip(tr("Ticked: settled"))
            if comment.resolved:
                item.setForeground(muted(self.palette()))
            item.setData(Qt.ItemDataRole.UserRole, comment)
            self.comments.addItem(item)
        self.comments.blockSignals(False)
        self.comments.scrollToBottom()

    def _choose(self, comment: Comment) -> None:
        """Select a comment that was chosen on the picture."""
        if comment in self._shown:
            self.comments.setCurrentRow(self._shown.index(comment))

    # --- doing ----------------------------------------------------------------------------

    def give(self, status: str) -> None:
        """Give the frame on screen a status; ask before one with open comments is approved."""
        services, given = self._services, Status(status)
        if (frame := services.state.frame) is None:
            return
        services.store.events.aboutToLeave.emit()  # what is in progress is part of what is judged
        comments = services.review.comments(frame.name)
        left = sum(not c.resolved for c in comments) if given is Status.APPROVED else 0
        if not left or ask_to_approve(self, left):
            self._given = frame.name, services.review.status(frame.name), services.state.annotation
            services.review.set_status(frame.name, given)
            said = tr("{frame} is {status}", frame=frame.name, status=tr(status, "a frame"))
            services.say(said)

    def key(self, name: str, _shift: bool) -> bool:
        """Take Undo right after a status was given: the frame has the one of before again."""
        state, given = self._services.state, self._given
        if name != "Undo" or given is None or state.frame is None:
            return False
        self._given, (frame, before, annotation) = None, given
        if (frame, annotation) != (state.frame.name, state.annotation):
            return False
        self._services.review.set_status(frame, before)
        status = tr(before.value, "a frame")
        self._services.say(tr("{frame} is {status} again", frame=frame, status=status))
        return True

    def _send(self) -> None:
        frame = self._services.state.frame
        if frame is not None and self.text.text().strip():
            review = self._services.review
            review.add_comment(frame.name, self.text.text(), review.new_place)
            self.text.clear()
            review.begin_comment(None)

    def _drop_empty(self) -> None:
        """The keyboard left a comment without a word: its place is forgotten."""
        if not self.text.text():
            self._services.review.begin_comment(None)

    def _go_to(self, item: QListWidgetItem) -> None:
        comment: Comment = item.data(Qt.ItemDataRole.UserRole)
        if comment.place is not None:
            self._services.store.events.flyTo.emit(*comment.place)

    def _begin_frame(self) -> None:
        """Keep a comment that is being typed for the frame it was begun on."""
        services, typed = self._services, self.text.text()
        if self._typed_on is not None and typed:
            self._typed[self._typed_on] = typed, services.review.new_place
        frame = services.state.frame
        self._typed_on = None if frame is None else frame.name
        text, place = self._typed.pop(self._typed_on or "", ("", None))
        self.text.setText(text)
        services.review.begin_comment(place)

    def _begin_dataset(self) -> None:
        self._typed.clear()
        self._typed_on = None
        self.text.clear()

    def _settle(self, item: QListWidgetItem) -> None:
        comment: Comment = item.data(Qt.ItemDataRole.UserRole)
        resolved = item.checkState() is Qt.CheckState.Checked
        self._services.review.resolve_comment(comment, resolved)

    def _text_key(self, key: Qt.Key) -> None:
        if key == Qt.Key.Key_Escape:
            self._services.review.begin_comment(None)
            self.left.emit()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._send()


def _duration(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    if minutes:
        return tr("{minutes}:{seconds:02d} min", minutes=minutes, seconds=rest)
    return tr("{seconds} s", seconds=rest)
