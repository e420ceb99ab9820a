"""The findings of the label check, as a list to walk through and to fix from."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from html import escape
from typing import Protocol

from PySide6.QtCore import QEvent, QModelIndex, QSize, Qt, QTextBoundaryFinder
from PySide6.QtGui import QKeyEvent, QResizeEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QProgressBar,
    QPushButton,
    QToolButton,
)

from procc_annotator.calibration.label_check.finding import Remedy, Severity
from procc_annotator.dataset.review import StoredFinding, by_severity
from procc_annotator.gui.canvas.finding_sign import finding_icon
from procc_annotator.gui.panels.finding_rows import (
    Entry,
    FindingDelegate,
    FindingsList,
    FindingsModel,
)
from procc_annotator.gui.panels.widgets import (
    Pages,
    Panel,
    hbox,
    make_button,
    named,
    note_label,
    show_note,
    vbox,
)
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, tr_count


def frame_words(services: Services) -> str:
    """Of the frame on screen: nothing found, or which rules have not been examined and why.

    Empty if there are findings and every rule was examined.
    """
    check, frame = services.label_check, services.state.frame
    if frame is None:
        return tr("No frames.\nOpen a folder of pictures to check their labels.")
    if not services.state.annotation.annotated:
        return tr("Nothing is annotated in this frame.")
    checked = check.checked
    if checked is None:
        return "" if check.shown else tr("Checking this frame…")
    found = bool(check.shown)
    limit = _limit(services, checked.failure)
    if limit:
        nothing = tr("No problems so far.")
        return limit if found else f"{nothing}\n{limit}"
    ignored = check.known.ignored_here()
    if found:
        return ""
    if ignored:
        return tr_count(
            ignored,
            "Nothing found but {n:,} ignored finding.",
            "Nothing found but {n:,} ignored findings.",
        )
    return tr("Nothing found in this frame.")


def _limit(services: Services, failure: str) -> str:
    if not services.state.projection_visible:
        return tr(
            "Blind: findings that need a camera wait until this frame is committed (Ctrl+Enter)."
        )
    checked = services.label_check.checked
    if checked is not None and not checked.fitted:
        return tr("The live fit is off: the full check needs it.")
    if failure:
        return tr("Full check needs a camera: {why}.", why=failure)
    return ""


def set_words(services: Services) -> str:
    """Of the whole set: nothing found, or what was not checked.

    Empty if there are findings and every frame was checked.
    """
    check, workspace = services.label_check, services.state.workspace
    if workspace is None or not workspace.frames:
        return tr("No frames.\nOpen a folder of pictures to check their labels.")
    if check.running:
        return "" if check.known.in_set() else tr("Checking the set…")
    problems = ""
    if services.state.blind:
        problems = tr("Blind: only committed frames are checked with a camera.")
    if check.problems:
        count = len(check.problems)
        name, why = next(iter(check.problems.items()))
        said = tr_count(
            count,
            "{n:,} frame cannot be checked, such as {name}: {why}",
            "{n:,} frames cannot be checked, such as {name}: {why}",
            name=name,
            why=why,
        )
        problems = "\n".join(filter(None, (problems, said)))
    if not check.set_checked:
        return tr_count(
            check.known.count,
            "The set is not checked yet; {n:,} frame checked so far.",
            "The set is not checked yet; {n:,} frames checked so far.",
        )
    if check.known.in_set():
        return problems
    nothing = tr_count(
        check.known.count, "Nothing found in {n:,} frame.", "Nothing found in {n:,} frames."
    )
    return "\n".join(filter(None, (nothing, problems)))


def so_many(severity: Severity, count: int) -> str:
    """Return how many findings are that sure: "2 errors"."""
    match severity:
        case Severity.ERROR:
            return tr_count(count, "{n:,} error", "{n:,} errors")
        case Severity.WARNING:
            return tr_count(count, "{n:,} warning", "{n:,} warnings")
        case Severity.HINT:
            return tr_count(count, "{n:,} hint", "{n:,} hints")


_MOST_REMEDIES = 4


class _Commands(Protocol):
    """Slots of the list of findings."""

    def go(self, frame: str, found: StoredFinding) -> None: ...
    def apply(self, found: StoredFinding, remedy: Remedy) -> None: ...
    def ignore(self, frame: str, found: StoredFinding) -> None: ...
    def restore(self) -> None: ...
    def check_set(self) -> None: ...
    def stop(self) -> None: ...
    def ask_export(self) -> None: ...


class FindingsPanel(Panel):
    """Displays `services.label_check`; commands do what the user asks for."""

    def __init__(self, services: Services, commands: _Commands) -> None:
        super().__init__(services, "findings_panel", (300, 320))
        self._commands = commands
        self._check = services.label_check
        self._following = False
        self._build()
        self._follow(
            lambda s: (s.workspace, s.frame_index, s.field, s.projection_visible),
            self._check.changed,
            self._check.framesChanged,
            self._check.currentChanged,
            services.live_fit.changed,
        )
        self._check.progressed.connect(self._show_progress)
        self._refresh()

    # --- building -------------------------------------------------------------------------

    def _build(self) -> None:
        self.note = note_label("findings_note")
        self.note.setTextFormat(Qt.TextFormat.RichText)
        self.note.linkActivated.connect(self._commands.restore)
        self.model = FindingsModel(self._services)
        self.model.setParent(self)
        self.list = named(FindingsList(), "findings_list", title=tr("Findings"))
        self.list.setModel(self.model)
        self.list.selectionModel().currentChanged.connect(self._choose)
        self.list.clicked.connect(self._go)
        self.list.activated.connect(self._go)
        self.list.installEventFilter(self)
        self._pages = Pages(self.list, "findings_empty")
        self.empty = self._pages.empty
        self.remedies = vbox(spacing=3)
        self.remedy_buttons: list[WrappingButton] = []
        vbox(
            self._make_head(),
            self.note,
            (self._pages, 1),
            self.remedies,
            self._make_foot(),
            of=self,
            spacing=4,
            margins=2,
        )

    def _make_head(self) -> QHBoxLayout:
        tip = tr("List the findings of all checked frames, errors first, or of this frame")
        self.scope = named(QPushButton(tr("Whole set")), "findings_scope", tip=tip)
        self.scope.setCheckable(True)
        self.scope.toggled.connect(lambda _: self._refresh())
        self._check.finished.connect(lambda _: self.scope.setChecked(True))
        self.severity_buttons: dict[Severity, QToolButton] = {}
        head = hbox((self.scope, 1), spacing=2)
        for severity in Severity:
            button = named(QToolButton(), f"findings_{severity}")
            button.setCheckable(True)
            button.setChecked(True)
            button.setIcon(finding_icon(severity, self.devicePixelRatioF()))
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
            button.clicked.connect(self._take_severities)
            self.severity_buttons[severity] = button
            head.addWidget(button)
        return head

    def _make_foot(self) -> QHBoxLayout:
        self.check_button = make_button(
            tr("Check the whole set"),
            self._commands.check_set,
            "findings_check",
            tip=tr("Look for wrong labels in every annotated frame"),
        )
        title = tr("Frames checked")
        self.progress = named(QProgressBar(), "findings_progress", title=title)
        self.progress.setFormat("%v / %m")
        self.stop_button = make_button(tr("Stop"), self._commands.stop, "findings_stop")
        self.export_button = make_button(
            tr("Export…"),
            self._commands.ask_export,
            "findings_export",
            tip=tr("Write the findings of all checked frames as CSV"),
        )
        self._show_progress(0, 0)
        progress, check = (self.progress, 1), (self.check_button, 1)
        return hbox(check, progress, self.stop_button, self.export_button, spacing=4)

    # --- showing --------------------------------------------------------------------------

    def _refresh(self) -> None:
        check, frame = self._check, self._services.state.frame
        whole_set = self.scope.isChecked()
        every: list[Entry]
        if whole_set:
            every = sorted(check.known.in_set(), key=lambda one: one[1].finding.severity.rank)
        else:
            every = [(frame.name, found) for found in check.shown] if frame is not None else []
        counts = by_severity(found for _, found in every)
        for severity, button in self.severity_buttons.items():
            count = counts[severity]
            button.setText(str(count) if count < 1000 else f"{count // 1000}k")
            button.setChecked(severity in check.severities)
            many = so_many(severity, counts[severity])
            button.setToolTip(tr("{findings}; click to list them or not", findings=many))
            button.setAccessibleName(many)
        entries = [(n, f) for n, f in every if f.finding.severity in check.severities]
        words = set_words(self._services) if whole_set else frame_words(self._services)
        hidden = len(every) - len(entries)
        if hidden and not entries:
            words = tr_count(
                hidden,
                "{n:,} more is not listed: switch the signs above on.",
                "{n:,} more are not listed: switch the signs above on.",
            )
        self._show_entries(entries, whole_set)
        self._pages.explain("" if entries else words)
        self._show_note(words if entries else "", whole_set)
        self._show_remedies()
        self.check_button.setEnabled(self._services.state.workspace is not None)
        self.export_button.setEnabled(check.known.count > 0)

    def _show_entries(self, entries: list[Entry], whole_set: bool) -> None:
        self._following = True
        self.model.show_entries(entries, with_frames=whole_set)
        frame = self._services.state.frame
        row = self.model.row_of(frame.name if frame is not None else "", self._check.current)
        index = self.model.index(row) if row >= 0 else QModelIndex()
        if row >= 0 and index != self.list.currentIndex():
            self.list.show_row(row)
        elif row < 0:
            self.list.setCurrentIndex(index)
            self.list.clearSelection()
        self._following = False

    def _show_note(self, words: str, whole_set: bool) -> None:
        """Show what limits the list, and how to see ignored findings."""
        notes = [escape(words)] if words else []
        ignored = 0 if whole_set else self._check.known.ignored_here()
        if ignored:
            notes.append(
                tr_count(
                    ignored,
                    '{n:,} ignored here. <a href="restore">Show again</a>',
                    '{n:,} ignored here. <a href="restore">Show again</a>',
                )
            )
        show_note(self.note, "<br>".join(notes).replace("\n", " "))

    def _show_remedies(self) -> None:
        """Buttons for what can be done about the current finding."""
        found = self._check.current
        listed = self._pages.currentWidget() is self.list
        wanted: list[tuple[str, str, Callable[[], None]]] = []
        if found is not None and listed:
            for at, remedy in enumerate(found.finding.remedies[:_MOST_REMEDIES]):
                said = tr(remedy.text)
                text = said[:1].upper() + said[1:]

                do = partial(self._commands.apply, found, remedy)
                wanted.append((f"{text} (F12)" if at == 0 else text, "", do))
            frame = self._services.state.frame
            name = frame.name if frame is not None else ""
            tip = tr("Do not show it again until the points of its elements change")
            ignore = partial(self._commands.ignore, name, found)
            wanted.append((tr("Ignore this finding"), tip, ignore))
        while len(self.remedy_buttons) < len(wanted):
            button = named(WrappingButton(), f"findings_remedy_{len(self.remedy_buttons)}")
            self.remedies.addWidget(button)
            self.remedy_buttons.append(button)
        for at, button in enumerate(self.remedy_buttons):
            button.setVisible(at < len(wanted))
            if at < len(wanted):
                button.offer(*wanted[at])

    def _show_progress(self, done: int, total: int) -> None:
        running = total > 0 and self._check.running
        self.check_button.setVisible(not running)
        self.progress.setVisible(running)
        self.stop_button.setVisible(running)
        if running:
            self.progress.setRange(0, total)
            self.progress.setValue(done)

    def changeEvent(self, event: QEvent) -> None:
        delegate = self.list.itemDelegate() if hasattr(self, "list") else None
        if event.type() == QEvent.Type.FontChange and isinstance(delegate, FindingDelegate):
            delegate.forget()
            self.list.fit_rows()
        super().changeEvent(event)

    # --- choosing -------------------------------------------------------------------------

    def _take_severities(self) -> None:
        chosen = [s for s, button in self.severity_buttons.items() if button.isChecked()]
        self._check.set_severities(chosen)

    def _choose(self, current: QModelIndex, _: QModelIndex) -> None:
        """Arrows in the list go from finding to finding; clicks are taken when they end."""
        if current.isValid() and self.list.hasFocus() and not self._following:
            self._go(current)

    def _go(self, index: QModelIndex) -> None:
        if not self._following and 0 <= index.row() < len(self.model.entries):
            self._commands.go(*self.model.entries[index.row()])

    def eventFilter(self, watched: object, event: QEvent) -> bool:
        if watched is not self.list or not isinstance(event, QKeyEvent):
            return False
        row = self.list.currentIndex().row() if event.key() == Qt.Key.Key_Delete else -1
        if event.type() == QEvent.Type.KeyRelease or not 0 <= row < len(self.model.entries):
            return False
        event.accept()  # before the window deletes the element
        if event.type() == QEvent.Type.KeyPress:
            self._commands.ignore(*self.model.entries[row])
        return True


def _pieces(text: str) -> Iterator[str]:
    """A text in parts between which a line may end; not every language has spaces there."""
    finder = QTextBoundaryFinder(QTextBoundaryFinder.BoundaryType.Line, text)
    start = 0
    while (end := finder.toNextBoundary()) >= 0:
        yield text[start:end]
        start = end


class WrappingButton(QPushButton):
    """A button that wraps its text rather than cutting it off."""

    def __init__(self) -> None:
        super().__init__()
        self._whole = ""
        self._do: Callable[[], None] | None = None
        self.clicked.connect(lambda: self._do() if self._do is not None else None)

    def offer(self, text: str, tip: str, do: Callable[[], None]) -> None:
        """Set the text and the action of the button."""
        self._whole, self._do = text, do
        self.setAccessibleName(text)
        self.setToolTip(tip)
        self._wrap()

    def minimumSizeHint(self) -> QSize:
        return QSize(80, super().minimumSizeHint().height())

    def sizeHint(self) -> QSize:
        return QSize(80, super().sizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._wrap()

    def _wrap(self) -> None:
        metrics, room = self.fontMetrics(), max(60, self.width() - 16)
        lines: list[str] = []
        for piece in _pieces(self._whole):
            longer = f"{lines[-1]}{piece}" if lines else piece
            if lines and metrics.horizontalAdvance(longer.rstrip()) <= room:
                lines[-1] = longer
            else:
                lines.append(piece)
        text = "\n".join(map(str.rstrip, lines))
        if text != self.text():
            self.setText(text)
