"""The strip below the picture: thumbnails of the frames, or the timeline of a video."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QModelIndex, QSize, Qt, QTransposeProxyModel
from PySide6.QtGui import QAction, QWheelEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QHeaderView,
    QSizePolicy,
    QStackedWidget,
    QTableView,
    QToolButton,
    QWidget,
)

from procc_annotator.gui.panels.frame_delegate import FilmDelegate
from procc_annotator.gui.panels.frames import FramesPanel
from procc_annotator.gui.panels.timeline.painting import StripPainter
from procc_annotator.gui.panels.timeline.shot_strip import ShotStrip
from procc_annotator.gui.panels.widgets import hbox, list_rows, named
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr

_LETTERS = 24  # of a filter that is shown


class FilmTable(QTableView):
    """The rows of the list of frames side by side; both have the same current frame."""

    def __init__(self, frames: FramesPanel) -> None:
        super().__init__()
        self._frames = frames
        named(self, "film_strip", title=tr("Frames"))
        turned = QTransposeProxyModel(self)
        turned.setSourceModel(frames.model)
        self.setModel(turned)
        self.setItemDelegate(FilmDelegate(self))
        list_rows(self)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectItems)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the keys to the picture
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        for bar in (self.setHorizontalScrollBarPolicy, self.setVerticalScrollBarPolicy):
            bar(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header = self.horizontalHeader()
        header.hide()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self._take_font()
        frames.list.selectionModel().currentChanged.connect(self._show_current)
        frames.model.modelReset.connect(self._show_current)
        self.selectionModel().currentChanged.connect(self._go)
        self.clicked.connect(lambda index: frames.choose(index.column()))

    def sizeHint(self) -> QSize:
        return QSize(400, StripPainter.height(self.fontMetrics()))

    minimumSizeHint = sizeHint  # of a table: room for its scroll bars

    def wheelEvent(self, event: QWheelEvent) -> None:
        turned, bar = event.angleDelta(), self.horizontalScrollBar()
        bar.setValue(bar.value() - (turned.x() or turned.y()))
        event.accept()

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.FontChange:
            self._take_font()
        super().changeEvent(event)

    def _take_font(self) -> None:
        width = FilmDelegate.width(self.sizeHint().height())
        self.horizontalHeader().setDefaultSectionSize(width)
        self.updateGeometry()

    def _show_current(self) -> None:
        index = self.model().index(0, self._frames.list.currentIndex().row())
        if index != self.currentIndex():
            self.setCurrentIndex(index)
            self.scrollTo(index)

    def _go(self, current: QModelIndex) -> None:
        if current.isValid():
            self._frames.list.setCurrentIndex(self._frames.model.index(current.column()))


class FrameStrips(QWidget):
    """Shows thumbnails, or for frames that follow one another their timeline, which is as high; the
    filter of the frames at its left, and at its right what opens the list of them instead."""

    def __init__(self, services: Services, frames: FramesPanel, timeline: ShotStrip) -> None:
        super().__init__()
        self._services, self._frames, self._timeline = services, frames, timeline
        self._wanted, self._covered = True, False
        self.film = FilmTable(frames)
        self.stack = QStackedWidget()
        for strip in (self.film, timeline):
            self.stack.addWidget(strip)
        self.filtered = named(
            QToolButton(autoRaise=True), "strip_filter", tip=tr("Show all frames")
        )
        self.filtered.clicked.connect(frames.filter.clear)
        self.list_button = named(QToolButton(autoRaise=True), "strip_list")
        self.list_button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        parts = (self.filtered, (self.stack, 1), self.list_button)
        self.setLayout(hbox(*parts, spacing=0, margins=0))
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        services.sequence.changed.connect(self._show)
        services.store.watch(select.dataset, self._show)
        for changed in (frames.model.modelReset, frames.filter.textChanged):
            changed.connect(self._show_filter)
        self._show()
        self._show_filter()

    def show_action(self, action: QAction) -> None:
        """Have the button at the right open the list of frames."""
        action.setIconText("☰")
        self.list_button.setDefaultAction(action)

    def set_wanted(self, wanted: bool) -> None:
        """Show a strip, or never."""
        self._wanted = wanted
        self._show()

    def set_covered(self, covered: bool) -> None:
        """Give the room to the picture: the list of frames is open, or all panels are hidden."""
        self._covered = covered
        self._show()

    def _show(self) -> None:
        workspace, sequence = self._services.state.workspace, self._services.sequence.value
        self.stack.setCurrentWidget(self.film if sequence is None else self._timeline)
        several = workspace is not None and len(workspace.frames) > 1
        self.setVisible(self._wanted and several and not self._covered)

    def _show_filter(self) -> None:
        shown, total = self._frames.model.shown, self._frames.model.total
        query = self._frames.filter.text().strip()
        words = query if len(query) <= _LETTERS else f"{query[: _LETTERS - 1]}…"
        counted = tr("{shown:,} of {frames}", shown=shown, frames=f"{total:,}")
        self.filtered.setText(f"{words}  ✕\n{counted}")
        self.filtered.setVisible(bool(query) and shown != total)
