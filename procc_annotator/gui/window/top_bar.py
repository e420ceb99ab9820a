"""The bar above the picture: frame, dataset and sport, the judged camera, what is saved, search."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QAction, QKeySequence, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QMenu,
    QSizePolicy,
    QStyle,
    QStyleOptionToolButton,
    QStylePainter,
    QToolBar,
    QToolButton,
    QWidget,
)

from procc_annotator.dataset.records import Status
from procc_annotator.gui.icons import paint_icon
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.theme import fixed_width
from procc_annotator.gui.window.apart import Apart
from procc_annotator.gui.window.camera_bar import CameraBar
from procc_annotator.gui.window.icon_button import IconButton
from procc_annotator.gui.window.menus import Actions
from procc_annotator.gui.window.save_state import SaveState
from procc_annotator.gui.window.status import SteadyLabel
from procc_annotator.translation import tr

_PAD = 5
_WIDEST_CHIP = 30  # average letters
_FEWEST = 6  # letters that say more than the icon alone


class WordsButton(QToolButton):
    """An icon and words, which are shortened where there is no room, in a frame of its own."""

    def __init__(self, icon: str, elide: Qt.TextElideMode, least: int) -> None:
        """Show nothing yet.

        Args:
            icon: left of the words.
            elide: where words are shortened.
            least: letters that there is always room for.
        """
        super().__init__()
        self._icon, self._elide, self._least = icon, elide, least
        self._words = self._key = ""
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def words(self) -> str:
        """All of them."""
        return self._words

    def set_words(self, words: str, key: str = "") -> None:
        """Show other words, and a key at the right end."""
        if (words, key) != (self._words, self._key):
            self._words, self._key = words, key
            self.setAccessibleName(words)
            self.updateGeometry()
            self.update()

    def sizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        words = metrics.horizontalAdvance(self._words)
        most = _WIDEST_CHIP * metrics.averageCharWidth()
        key = metrics.horizontalAdvance(f"   {self._key}") if self._key else 0
        width = self._beside() + min(words, most) + key
        return QSize(width + 2, metrics.height() + 2 * _PAD)

    def minimumSizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        least = min(
            metrics.averageCharWidth() * self._least, metrics.horizontalAdvance(self._words)
        )
        return QSize(self._beside() + least, self.sizeHint().height())

    def paintEvent(self, event: QPaintEvent) -> None:
        option = QStyleOptionToolButton()
        self.initStyleOption(option)
        option.text = ""
        option.features &= ~QStyleOptionToolButton.ToolButtonFeature.HasMenu
        painter = QStylePainter(self)
        painter.drawComplexControl(QStyle.ComplexControl.CC_ToolButton, option)
        self._paint_words(painter)

    def _paint_words(self, painter: QPainter) -> None:
        metrics, colours = self.fontMetrics(), self.palette()
        side = metrics.height()
        ink = colours.color(colours.ColorRole.ButtonText)
        box = QRectF(_PAD, (self.height() - side) / 2, side, side)
        paint_icon(painter, self._icon, box, ink)
        room = self.rect().adjusted(2 * _PAD + side, 0, -_PAD - self._arrow(), 0)
        middle = Qt.AlignmentFlag.AlignVCenter
        key = metrics.horizontalAdvance(f"   {self._key}") if self._key else 0
        if key and room.width() >= metrics.horizontalAdvance(self._words) + key:
            painter.setPen(colours.color(colours.ColorRole.PlaceholderText))
            painter.drawText(room, middle | Qt.AlignmentFlag.AlignRight, self._key)
            room.setRight(room.right() - key)
        painter.setPen(ink)
        shown = metrics.elidedText(self._words, self._elide, max(0, room.width()))
        shown = "" if len(shown) < _FEWEST < len(self._words) else shown
        painter.drawText(room, middle | Qt.AlignmentFlag.AlignLeft, shown)
        if self._arrow():
            place = self.rect().adjusted(self.width() - _PAD - self._arrow(), 0, -_PAD, 0)
            painter.drawText(place, middle | Qt.AlignmentFlag.AlignRight, "▾")

    def _arrow(self) -> int:
        return self.fontMetrics().horizontalAdvance("▾ ") if self.menu() is not None else 0

    def _beside(self) -> int:
        """Return what is next to the words, px."""
        return self.fontMetrics().height() + 3 * _PAD + self._arrow()


class TopBar(QToolBar):
    """Assembled from the table of actions and the document."""

    def __init__(self, document: Document, actions: Actions, fields: QMenu) -> None:
        """Show nothing yet.

        Args:
            document: what is open.
            actions: what the buttons do.
            fields: the menu in which a dataset's field is chosen.
        """
        super().__init__(tr("Top bar"))
        self.setObjectName("topBar")
        self.setMovable(False)
        self.setFloatable(False)
        self.toggleViewAction().setEnabled(False)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        self._document = document
        self._make_labels()
        self.chip = WordsButton("field", Qt.TextElideMode.ElideMiddle, 18)
        self.chip.setObjectName("fieldChip")
        self.chip.setMenu(fields)
        self.chip.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.camera_bar = CameraBar(document)
        self.saved = SaveState(document)
        self.search = self._make_search(actions["palette"])
        line = QWidget()
        row = QHBoxLayout(line)
        row.setContentsMargins(2, 2, 4, 2)
        row.setSpacing(4)
        for widget in (
            _button("previous", actions["previous_frame"]),
            self.position,
            _button("next", actions["next_frame"]),
            self.status,
            _button("done", actions["commit"]),
            self.chip,
        ):
            row.addWidget(widget)
        row.addWidget(self.camera_bar, 1)
        row.addStretch()
        row.addWidget(self.saved)
        row.addWidget(self.search)
        self.addWidget(Apart(line))
        store = document.store
        store.watch(lambda s: (s.workspace, s.frame_index), self._show_frame)
        store.watch(lambda s: (s.workspace, s.field), self._show_dataset)
        document.review.statusChanged.connect(self._show_status)
        self._show_frame()
        self._show_dataset()

    def _make_labels(self) -> None:
        self.position = SteadyLabel()
        self.position.setObjectName("framePosition")
        self.position.setFont(fixed_width(self.position.font()))
        # Nothing next to it moves when it changes.
        words, advance = (tr(s.value) for s in Status), self.fontMetrics().horizontalAdvance
        self.status = SteadyLabel(max(words, key=advance))
        self.status.setObjectName("frameStatus")
        self.status.setContentsMargins(4, 0, 4, 0)
        self.status.setToolTip(tr("Status of this frame (panel Review)"))

    def _make_search(self, action: QAction) -> WordsButton:
        search = WordsButton("find", Qt.TextElideMode.ElideRight, 0)
        search.setObjectName("searchButton")
        search.setToolTip(action.toolTip())
        search.clicked.connect(action.trigger)

        def show() -> None:
            keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
            search.set_words(tr("Find anything"), keys)

        action.changed.connect(show)
        show()
        return search

    def _show_status(self, _frame: str = "") -> None:
        shown = self._document.state.frame
        self.status.setText(tr(self._document.review.status(shown.name).value) if shown else "")

    def _show_frame(self) -> None:
        workspace = self._document.state.workspace
        count = len(workspace.frames) if workspace is not None else 0
        self.position.setText(
            f" {self._document.state.frame_index + 1} / {count} " if count else " – "
        )
        frame = self._document.state.frame
        self.position.setToolTip(str(frame.image_path) if frame is not None else "")
        self._show_status()

    def _show_dataset(self) -> None:
        """What is open, and the sport it is of."""
        workspace, field = self._document.state.workspace, self._document.state.field
        name = workspace.root.name if workspace is not None else ""
        self.chip.set_words(" · ".join(filter(None, (name, tr(field.title)))))
        lines = [str(workspace.root)] if workspace is not None else []
        lines += [tr("Field: {field}", field=field.described), tr("Click to choose another one")]
        self.chip.setToolTip("\n".join(lines))


def _button(icon: str, action: QAction) -> IconButton:
    button = IconButton(icon)
    button.setObjectName(f"top_{icon}")
    button.show_action(action)
    return button
