"""Every picture of the dataset; click one to go there."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QModelIndex, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QLabel,
    QLineEdit,
    QStackedLayout,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.dataset.filter_query import QUERY_HELP
from procc_annotator.dataset.frames import Folder
from procc_annotator.gui.panels.frames.delegate import FrameDelegate
from procc_annotator.gui.panels.frames.filter import FrameFilter
from procc_annotator.gui.panels.frames.model import FramesModel
from procc_annotator.gui.panels.parts import SEARCH_KEYS, empty_state, note_label, show_note
from procc_annotator.gui.panels.rows import list_rows
from procc_annotator.gui.soon import soon
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document
from procc_annotator.image.decoding import FrameCache
from procc_annotator.translation import tr, tr_count

_TYPED_MS = 150  # after a key, so that a word is not looked for letter by letter
_FOLD_KEYS = frozenset({Qt.Key.Key_Left, Qt.Key.Key_Right})
_TURN_KEYS = frozenset({Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space})


class FramesPanel(QWidget):
    """The list of frames with a filter; the frame on screen is highlighted and kept in view."""

    left = Signal()  # a frame was chosen: the keyboard belongs to the canvas again

    def __init__(
        self, document: Document, cache: FrameCache, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("frames_panel")
        self._document = document
        self.model = FramesModel(document, cache)
        self.model.setParent(self)
        self.frame_filter = FrameFilter(document, self)
        self.frame_filter.found.connect(self._take_found)
        self.frame_filter.problem.connect(self._tell_problem)
        self._search_soon = QTimer(self, singleShot=True, interval=_TYPED_MS)
        self._search_soon.timeout.connect(self._search)
        self._build()
        document.store.watch(select.dataset, self._take_dataset)
        # After the canvas was painted: no one looks at the list first.
        self._soon = soon(self, self._follow_frames)
        self._revealed = -1  # the frame whose folders were unfolded last
        self._due: set[int] = set()  # frames on screen since the list was brought up to date
        document.store.watch(select.annotation, self._follow_soon)
        document.store.events.framesEdited.connect(self._take_edited)
        document.store.watch(select.unsaved, self.model.take_save_state)
        document.store.watch(select.unsaved, self._search_soon.start)
        document.store.watch(select.dataset_scores, self._take_scores)
        document.store.events.frameScoresChanged.connect(self._take_scores)
        document.review.statusChanged.connect(self._take_status)
        document.label_check.framesChanged.connect(self._take_status)
        self.model.figures.changed.connect(self.list.viewport().update)
        self._take_dataset()

    def sizeHint(self) -> QSize:
        return QSize(240, 480)

    def focus_filter(self) -> None:
        """Put the keyboard into the filter box."""
        self.filter.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.filter.selectAll()

    def _build(self) -> None:
        self.filter = QLineEdit(placeholderText=tr("Filter frames"), clearButtonEnabled=True)
        self.filter.setObjectName("frames_filter")
        self.filter.setAccessibleName(tr("Filter frames"))
        self.filter.setToolTip(_help_table())
        self.filter.textChanged.connect(self._apply_filter)
        self.filter.installEventFilter(self)
        # Laying out 20,000 rows takes a QListView 40 ms, a table of fixed rows 0.2 ms.
        self.list = QTableView()
        self.list.setObjectName("frames_list")
        self.list.setAccessibleName(tr("Frames"))
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
        self.list.clicked.connect(self._choose)  # arrows walk on in the list
        self.list.activated.connect(self._activate)
        self.list.installEventFilter(self)
        self.empty = empty_state("", "frames_empty")
        self._stack = QStackedLayout()
        self._stack.addWidget(self.list)
        self._stack.addWidget(self.empty)
        self.problem = note_label("frames_problem")
        self.count = QLabel()
        self.count.setObjectName("frames_count")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 4, 4, 4)
        layout.setSpacing(4)
        layout.addWidget(self.filter)
        layout.addWidget(self.problem)
        layout.addLayout(self._stack, 1)
        layout.addWidget(self.count)

    def _take_dataset(self) -> None:
        self.model.reset()
        self._revealed = self._document.state.frame_index
        self.filter.clear()
        self.frame_filter.search()
        self.model.take_save_state()
        self._due = {self._document.state.frame_index}
        self._show_which()
        self._show_current()

    def _apply_filter(self, text: str) -> None:
        self.frame_filter.set_text(text)

    def _take_found(self, rows: list[int] | None) -> None:
        self.model.show_only(rows)
        self._show_which()
        self._show_current()

    def _tell_problem(self, text: str) -> None:
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
            self.empty.setText(
                tr("No frames.\nOpen a folder of pictures (jpg, png, bmp, webp), or drop one here.")
            )
            self.count.clear()
        else:
            query = self.filter.text().strip()
            self.empty.setText(tr("Nothing matches “{query}”.", query=query))
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
        self._stack.setCurrentWidget(self.list if shown else self.empty)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self.filter and isinstance(event, QKeyEvent) and event.key() in SEARCH_KEYS:
            if event.type() == QEvent.Type.ShortcutOverride:
                event.accept()
                return True
            if event.type() == QEvent.Type.KeyPress:
                self._filter_key(Qt.Key(event.key()))
                return True
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

    def _choose(self, index: QModelIndex) -> None:
        """A click: a frame is gone to, a folder folded or unfolded."""
        folder = self.model.folder_at(index.row())
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
        elif self.model.rowCount():
            if not self.list.currentIndex().isValid():
                rows = range(self.model.rowCount())
                first = next((row for row in rows if self.model.frame_index(row) >= 0), 0)
                self.list.setCurrentIndex(self.model.index(first))
        else:
            return
        self.list.setFocus(Qt.FocusReason.OtherFocusReason)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.FontChange:
            height = FrameDelegate.row_height(self.fontMetrics())
            self.list.verticalHeader().setDefaultSectionSize(height)
        super().changeEvent(event)

    def _show_current(self) -> None:
        if self._revealed != self._document.state.frame_index:
            self._revealed = self._document.state.frame_index
            self.model.reveal(self._revealed)
        row = self.model.row_showing(self._document.state.frame_index)
        index = self.model.index(row) if row >= 0 else QModelIndex()
        if index != self.list.currentIndex():
            self.list.setCurrentIndex(index)
            if index.isValid():
                self.list.scrollTo(index)
            else:
                self.list.clearSelection()

    def _go(self, current: QModelIndex, previous: QModelIndex) -> None:
        if current.isValid() and (frame := self.model.frame_index(current.row())) >= 0:
            self._document.walk.go_to(frame)

    def _follow_soon(self) -> None:
        """Another frame is on screen, or what is annotated in it is another thing."""
        self._due.add(self._document.state.frame_index)
        self._soon.start()

    def _follow_frames(self) -> None:
        for index in self._due:
            self.model.recount(index)
            self.model.repaint(index)
        self._due = {self._document.state.frame_index}  # it may be edited and left at once
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
        workspace = self._document.state.workspace
        index = workspace.index.get(name) if workspace is not None else None
        if index is None:
            self.list.viewport().update()
        elif index == self._document.state.frame_index:
            self._soon.start()
        else:
            self.model.repaint(index)


def _help_table() -> str:
    """Return what can be written into the filter, one line each, for its tip."""
    return "\n".join(f"{query}   {tr(words)}" for query, words in QUERY_HELP)
