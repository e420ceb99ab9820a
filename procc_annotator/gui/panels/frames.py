"""The list of all frames, its filter, and the keys that go through it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QEvent, QModelIndex, QObject, Qt, QTimer
from PySide6.QtGui import QKeyEvent, QShowEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableView,
)

from procc_annotator.dataset.filter_query import QUERY_HELP, FrameFacts, FrameQuery, parse_query
from procc_annotator.dataset.frames import Folder
from procc_annotator.dataset.records import FrameRecord
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError, UsageError
from procc_annotator.gui.panels.frame_delegate import FrameDelegate
from procc_annotator.gui.panels.frame_rows import FramesModel
from procc_annotator.gui.panels.widgets import (
    Pages,
    Panel,
    list_rows,
    make_label,
    named,
    note_label,
    search_line,
    show_note,
    vbox,
)
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask, after_paint
from procc_annotator.gui.state.scoring.dataset_scores import FrameScores
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, tr_count

_MANY = 500  # frames that are asked on the interface thread at most


class FrameFilter(QObject):
    """Turns the filter's text into the indices of matching frames; None means all of them."""

    def __init__(
        self,
        services: Services,
        owner: QObject,
        found: Callable[[list[int] | None], object],
        problem: Callable[[str], None],
    ) -> None:
        """``problem`` receives what is wrong with the text, or still missing; "" for nothing."""
        super().__init__(owner)
        self._services, self._found, self._problem = services, found, problem
        self._text = ""
        self._query = parse_query("", services.state.field)
        services.store.watch(select.field, self._read_again)
        self._searching = LatestOnlyTask(owner, problem)

    def _read_again(self) -> None:
        self.set_text(self._text)

    @property
    def depends_on_work(self) -> bool:
        """Return whether an edit, a status or a score can change what matches."""
        return not self._query.is_empty

    def set_text(self, text: str) -> None:
        """Read a filter; one that cannot be read leaves the frames as they are."""
        self._text = text
        try:
            query = parse_query(text, self._services.state.field)
        except UsageError as error:
            self._problem(str(error))
            return
        self._query = query
        self._problem(query.incomplete)
        self.search()

    def search(self) -> None:
        """Ask all frames again."""
        self._searching.cancel()
        workspace = self._services.state.workspace
        if workspace is None or self._query.is_empty:
            self._found(None)
            return
        query, ask = self._query, self._asker(workspace)
        if len(workspace.frames) <= _MANY and not query.needs_annotation:
            self._found(_matching(query, ask, len(workspace.frames), None))
            return

        def work(control: JobControl) -> list[int]:
            return _matching(query, ask, len(workspace.frames), control)

        self._searching.start(work, self._found)

    def _asker(self, workspace: Workspace) -> Callable[[int], FrameFacts]:
        """Return what is known of each frame, from values that another thread may look at."""
        services = self._services
        database = services.review.database
        records: Mapping[str, FrameRecord] = dict(database.records()) if database else {}
        unsaved = frozenset(services.state.unsaved)
        source = services.state.active
        broken = frozenset(source.problems) if source is not None else frozenset()
        cameras = source.camera_set.frames if source is not None else {}
        audits, tau = dict(services.scoring.active_audits), services.state.tau
        drafts = frozenset(database.drafts()) if database is not None else frozenset()
        needs_annotation, reveals = self._query.needs_annotation, services.state.reveals
        allowed = services.scoring.frame_scores.allowed
        verdicts = services.review.all_verdicts()
        asked = workspace.frames if self._query.needs_check else ()
        findings = {f.name: services.label_check.known.severities_of(f.name) for f in asked}

        def jac(name: str, at: float | None) -> float | None:
            return FrameScores(audits, at if at is not None else tau, allowed).get(name)

        def ask(index: int) -> FrameFacts:
            name = workspace.frames[index].name
            record = records.get(name, FrameRecord())
            annotated, unreadable = None, False
            if needs_annotation:
                try:
                    annotated = workspace.read(index).annotated
                except InputError:
                    unreadable = True
            judged = verdicts.get(name, {}) if allowed is None or allowed(name) else {}
            return FrameFacts(
                name=name,
                status=record.status.value,
                annotated=annotated,
                comments=record.comments,
                open_comments=record.open_comments,
                comment_text=database.comment_text(name) if database and record.comments else "",
                unsaved=index in unsaved,
                unreadable=unreadable,
                unconfirmed=name in drafts,
                jac=partial(jac, name),
                verdicts=frozenset(str(verdict.fault) for verdict in judged.values()),
                findings=findings.get(name),
                has_camera=None if name in broken and reveals(name) else name in cameras,
            )

        return ask


def _matching(
    query: FrameQuery, ask: Callable[[int], FrameFacts], count: int, control: JobControl | None
) -> list[int]:
    rows: list[int] = []
    for index in range(count):
        if control is not None and control.cancelled:
            break
        if query.matches(ask(index)):
            rows.append(index)
    return rows


_TYPED_MS = 150  # after a key, so that a word is not looked for letter by letter
_FOLD_KEYS = frozenset({Qt.Key.Key_Left, Qt.Key.Key_Right})
_TURN_KEYS = frozenset({Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space})


class FramesPanel(Panel):
    """The list of frames with a filter; the frame on screen is highlighted and kept in view."""

    def __init__(self, services: Services) -> None:
        super().__init__(services, "frames_panel", (240, 480))
        self.model = FramesModel(services, services.cache)
        self.model.setParent(self)
        self.frame_filter = FrameFilter(services, self, self._take_found, self._show_problem)
        self._search_soon = QTimer(self, singleShot=True, interval=_TYPED_MS)
        self._search_soon.timeout.connect(self._search)
        self._build()
        services.store.watch(select.dataset, self._take_dataset)
        # After the canvas was painted: no one looks at the list first.
        self._soon = after_paint(self, self._refresh)
        self._revealed = -1  # the frame that folders were unfolded for last
        self._due: set[int] = set()  # frames on screen since the list was brought up to date
        services.store.watch(select.annotation, self._follow_soon)
        services.store.events.framesEdited.connect(self._take_edited)
        services.store.watch(select.unsaved, self.model.take_save_state)
        services.store.watch(select.unsaved, self._search_soon.start)
        services.store.watch(lambda s: (s.active, s.tau, s.blind, s.committed), self._take_scores)
        services.store.events.frameScoresChanged.connect(self._take_scores)
        services.review.statusChanged.connect(self._take_status)
        services.label_check.framesChanged.connect(self._take_status)
        self.model.figures.changed.connect(self.list.viewport().update)
        self._take_dataset()

    def focus_filter(self) -> None:
        """Put the keyboard into the filter box."""
        self.filter.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.filter.selectAll()

    def _build(self) -> None:
        find = self.frame_filter.set_text
        self.filter = search_line(tr("Filter frames"), "frames_filter", find, keys=self._filter_key)
        lines = (f"{query}   {tr(words)}" for query, words in QUERY_HELP)
        self.filter.setToolTip("\n".join(lines))
        # Laying out 20,000 rows takes a QListView 40 ms, a table of fixed rows 0.2 ms.
        self.list = named(QTableView(), "frames_list", title=tr("Frames"))
        self.list.setMouseTracking(True)
        self.list.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        delegate = FrameDelegate(self.list)
        self.list.setItemDelegate(delegate)
        list_rows(self.list)
        self.list.horizontalHeader().hide()
        self.list.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        rows = self.list.verticalHeader()
        rows.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        rows.setDefaultSectionSize(delegate.row_height(self.fontMetrics()))
        self.list.setModel(self.model)
        self.list.selectionModel().currentChanged.connect(self._go)
        self.list.clicked.connect(lambda index: self.choose(index.row()))  # arrows walk on
        self.list.activated.connect(self._activate)
        self.list.installEventFilter(self)
        self._pages = Pages(self.list, "frames_empty")
        self.empty = self._pages.empty
        self.problem = note_label("frames_problem")
        self.count = make_label(name="frames_count")
        parts = (self.filter, self.problem, (self._pages, 1), self.count)
        vbox(*parts, of=self, spacing=4, margins=4)

    def _take_dataset(self) -> None:
        self.model.reset()
        self._revealed = self._services.state.frame_index
        self.filter.clear()
        self.frame_filter.search()
        self.model.take_save_state()
        self._due = {self._services.state.frame_index}
        self._show_which()
        self._show_current()

    def _take_found(self, rows: list[int] | None) -> None:
        self._services.navigator.within = None if rows is None else frozenset(rows)
        self.model.show_only(rows)
        self._show_which()
        self._show_current()

    def _show_problem(self, text: str) -> None:
        show_note(self.problem, text)

    def _search(self) -> None:
        if self.frame_filter.depends_on_work:
            self.frame_filter.search()

    def _take_status(self, name: str) -> None:
        """A frame's status or comments changed; what matches may have, too."""
        self.model.figures.look_again()
        self._repaint(name)
        self._search_soon.start()

    def _show_which(self) -> None:
        total, shown = self.model.total, self.model.shown
        if not total:
            why = tr(
                "No frames.\nOpen a folder of pictures (jpg, png, bmp, webp), or drop one here."
            )
            self.count.clear()
        else:
            query = self.filter.text().strip()
            why = tr("Nothing matches “{query}”.", query=query)
            frames = tr_count(total, "{n:,} frame", "{n:,} frames")
            if self.model.folders:
                frames = tr_count(
                    sum(f.first < f.own_past for f in self.model.folders),
                    "{frames} in {n:,} folder",
                    "{frames} in {n:,} folders",
                    frames=frames,
                )
            if shown != total:
                frames = tr("{shown:,} of {frames}", shown=shown, frames=frames)
            self.count.setText(frames)
        self._pages.explain("" if shown else why)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self.list and isinstance(event, QKeyEvent) and self.model.folders:
            taken = event.type() in (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress)
            if taken and (event.key() in _FOLD_KEYS or self._turns_folder(event)):
                event.accept()
                if event.type() == QEvent.Type.KeyPress:
                    self._fold_key(event)
                return True
        return super().eventFilter(watched, event)

    def _turns_folder(self, event: QKeyEvent) -> bool:
        row = self.list.currentIndex().row()
        on_folder = row >= 0 and self.model.folder_at(row) is not None
        return on_folder and event.key() in _TURN_KEYS

    def _fold_key(self, event: QKeyEvent) -> None:
        """Left folds a folder, or goes to the one around; right unfolds it, or goes into it; Enter
        and Space do either. With Shift all folders are meant."""
        folds = event.key() == Qt.Key.Key_Left
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self.model.fold_all(folds)
            self._show_current()
            return
        row = self.list.currentIndex().row()
        folder = self.model.folder_at(row) if row >= 0 else None
        if event.key() in _TURN_KEYS:
            if folder is not None:
                self._set_folded(folder, not self.model.is_folded(folder))
            return
        if folder is not None and self.model.is_folded(folder) != folds:
            self._set_folded(folder, folds)
        elif folds and row >= 0 and (around := self.model.folder_of(row)) >= 0:
            self.list.setCurrentIndex(self.model.index(around))
        elif not folds and folder is not None:
            self.list.setCurrentIndex(self.model.index(row + 1))

    def _set_folded(self, folder: Folder, folded: bool) -> None:
        scrolled = self.list.verticalScrollBar().value()
        row = self.model.fold(folder, folded)
        self.list.verticalScrollBar().setValue(scrolled)
        self.list.setCurrentIndex(self.model.index(row))

    def choose(self, row: int) -> None:
        """A click: a frame is gone to, a folder folded or unfolded."""
        folder = self.model.folder_at(row)
        if folder is None:
            self.left.emit()
        else:
            self._set_folded(folder, not self.model.is_folded(folder))

    def _activate(self, index: QModelIndex) -> None:
        """Enter, or a double click; of a folder each click and key counts by itself."""
        if self.model.folder_at(index.row()) is None:
            self.left.emit()

    def _filter_key(self, key: Qt.Key) -> None:
        """Esc shows all frames again; Enter and arrows go on to the list, to its first row."""
        if key == Qt.Key.Key_Escape:
            self.filter.clear()
            self.left.emit()
            return
        if self.model.rowCount():
            if not self.list.currentIndex().isValid():
                rows = range(self.model.rowCount())
                first = next((row for row in rows if self.model.frame_index(row) >= 0), 0)
                self.list.setCurrentIndex(self.model.index(first))
        else:
            return
        self.list.setFocus(Qt.FocusReason.OtherFocusReason)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.list.scrollTo(self.list.currentIndex())

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.FontChange:
            height = FrameDelegate.row_height(self.fontMetrics())
            self.list.verticalHeader().setDefaultSectionSize(height)
        super().changeEvent(event)

    def _show_current(self) -> None:
        if self._revealed != self._services.state.frame_index:
            self._revealed = self._services.state.frame_index
            self.model.reveal(self._revealed)
        row = self.model.row_showing(self._services.state.frame_index)
        index = self.model.index(row) if row >= 0 else QModelIndex()
        if index != self.list.currentIndex():
            self.list.setCurrentIndex(index)
            if index.isValid():
                self.list.scrollTo(index)
            else:
                self.list.clearSelection()

    def _go(self, current: QModelIndex, previous: QModelIndex) -> None:
        if current.isValid() and (frame := self.model.frame_index(current.row())) >= 0:
            self._services.navigator.go_to(frame)

    def _follow_soon(self) -> None:
        """Another frame is on screen, or what is annotated in it is another thing."""
        self._due.add(self._services.state.frame_index)
        self._soon.start()

    def _refresh(self) -> None:
        for index in self._due:
            self.model.recount(index)
            self.model.repaint(index)
        self._due = {self._services.state.frame_index}  # it may be edited and left at once
        self._show_current()

    def _take_edited(self, indices: list[int]) -> None:
        """Annotations were changed all over the set."""
        for index in indices:
            self.model.recount(index)
        self.list.viewport().update()
        self._search_soon.start()

    def _take_scores(self, name: str = "") -> None:
        """One frame's score after an edit, or all of them (an empty name)."""
        self.model.take_scores()
        if not name:
            self._search_soon.start()
        self._repaint(name)

    def _repaint(self, name: str) -> None:
        """Paint the row of a frame again, or those of all (an empty name)."""
        workspace = self._services.state.workspace
        index = workspace.index.get(name) if workspace is not None else None
        if index is None:
            self.list.viewport().update()
        elif index == self._services.state.frame_index:
            self._soon.start()
        else:
            self.model.repaint(index)
