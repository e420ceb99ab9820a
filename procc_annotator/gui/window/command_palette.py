"""The command palette: a line to type in above the picture, what fits below it, Enter calls it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QAbstractListModel, QEvent, QModelIndex, QObject, QRect, QSize, Qt
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPalette
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QFrame,
    QLabel,
    QLineEdit,
    QListView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.gui.panels.tables import Index
from procc_annotator.gui.settings import CALLED, Settings
from procc_annotator.gui.theme import blend
from procc_annotator.gui.window.palette_entries import KINDS, Entry
from procc_annotator.translation import tr, word

_WIDTH = 680
_ROWS = 12
_PAD = 8
_MARGIN = 24  # of the window that stays in sight around it
_KIND_WIDTH = 68  # at the usual font; it grows with it
_HINT = word("Enter calls it · ↑ ↓ choose · Esc closes")
_MOVES = {
    Qt.Key.Key_Up: -1,
    Qt.Key.Key_Down: 1,
    Qt.Key.Key_PageUp: -_ROWS,
    Qt.Key.Key_PageDown: _ROWS,
}


class CommandPalette(QFrame):
    """Lies over the top of a window while something is looked for; goes when the keyboard goes."""

    def __init__(
        self,
        window: QWidget,
        found: Callable[[str, Sequence[str]], list[Entry]],
        settings: Settings,
    ) -> None:
        super().__init__(window)
        self._window = window
        self.setObjectName("commandPalette")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)
        self._found, self._settings = found, settings
        self._before: QWidget | None = None  # who had the keyboard
        self.search = QLineEdit()
        self.search.setObjectName("paletteSearch")
        self.search.setPlaceholderText(
            tr("An action, element, frame, camera source, folder, number")
        )
        self.search.setAccessibleName(tr("Find anything"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._show)
        self.search.installEventFilter(self)
        self.model = _Entries()
        self.list = QListView()
        self.list.setObjectName("paletteList")
        self.list.setAccessibleName(tr("What fits"))
        self.list.setModel(self.model)
        self.list.setItemDelegate(_EntryDelegate(self.list))
        self.list.setUniformItemSizes(True)
        self.list.setMouseTracking(True)
        self.list.setFrameShape(QFrame.Shape.NoFrame)
        self.list.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # the line keeps the keyboard
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.list.clicked.connect(self._call)
        self.hint = QLabel(tr(_HINT))
        self.hint.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(_PAD, _PAD, _PAD, _PAD)
        for part in (self.search, self.list, self.hint):
            layout.addWidget(part)
        window.installEventFilter(self)
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._follow)
        self.hide()

    def ask(self) -> None:
        """Show it with an empty line; once more puts it away."""
        if self.isVisible():
            self.put_away()
            return
        self._before = QApplication.focusWidget()
        self.search.clear()
        self._show()
        self.place()
        self.show()
        self.raise_()
        self.search.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def put_away(self) -> None:
        """Hide it; the keyboard goes back to who had it."""
        before, self._before = self._before, None
        self.hide()
        if before is not None:
            before.setFocus(Qt.FocusReason.OtherFocusReason)

    def place(self) -> None:
        """In the middle of the window's width, below its top, no larger than its room."""
        room = self._window.size() - QSize(2 * _MARGIN, 2 * _MARGIN)
        row = self.list.sizeHintForRow(0) if self.model.rowCount() else 0
        self.list.setFixedHeight(_ROWS * max(row, self.fontMetrics().height() + _PAD))
        size = self.sizeHint().expandedTo(QSize(_WIDTH, 0)).boundedTo(room)
        self.setFixedSize(size)
        self.move((self._window.width() - size.width()) // 2, 2 * _MARGIN)

    # --- inside ---

    def _show(self) -> None:
        text = self.search.text()
        self.model.replace(self._found(text, self._settings.get(CALLED)))
        self.list.setCurrentIndex(self.model.index(0))
        self.list.scrollToTop()
        found = self.model.rowCount() > 0
        nothing = tr("Nothing is called “{text}”.", text=text.strip())
        self.hint.setText(tr(_HINT) if found else nothing)

    def _call(self, index: Index) -> None:
        entry = self.model.entry(index.row())
        if entry is None or not entry.enabled:
            return
        if entry.key:
            others = (key for key in self._settings.get(CALLED) if key != entry.key)
            self._settings.set(CALLED, (entry.key, *others)[: CALLED.most])
        self.put_away()  # first: what is called may ask for the keyboard itself
        entry.run()

    def _follow(self, _old: QWidget | None, new: QWidget | None) -> None:
        if self.isVisible() and new is not None and not self.isAncestorOf(new):
            self._before = None  # somebody went elsewhere by hand
            self.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self._window and event.type() == QEvent.Type.Resize:
            if self.isVisible():
                self.place()
            return False
        if watched is not self.search or not isinstance(event, QKeyEvent):
            return False
        if event.type() == QEvent.Type.ShortcutOverride and not _calls_palette(event):
            event.accept()  # every key is the line's, or it would do something unseen below it
            return True
        return event.type() == QEvent.Type.KeyPress and self._key(Qt.Key(event.key()))

    def _key(self, key: Qt.Key) -> bool:
        """Return whether a key was for the list."""
        if key in _MOVES:
            last = self.model.rowCount() - 1
            row = self.list.currentIndex().row() + _MOVES[key]
            self.list.setCurrentIndex(self.model.index(min(max(row, 0), last)))
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._call(self.list.currentIndex())
        elif key == Qt.Key.Key_Escape:
            self.put_away()
        else:
            return key in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab)
        return True


def _calls_palette(event: QKeyEvent) -> bool:
    held = event.modifiers() == Qt.KeyboardModifier.ControlModifier
    return held and event.key() == Qt.Key.Key_K


class _Entries(QAbstractListModel):
    """What fits, for the list; read aloud as title, keys and what it does."""

    def __init__(self) -> None:
        super().__init__()
        self._entries: Sequence[Entry] = ()

    def replace(self, entries: Sequence[Entry]) -> None:
        self.beginResetModel()
        self._entries = entries
        self.endResetModel()

    def entry(self, row: int) -> Entry | None:
        return self._entries[row] if 0 <= row < len(self._entries) else None

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 (Qt's signature)
        return 0 if parent.isValid() else len(self._entries)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        entry = self.entry(index.row())
        if entry is None:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return entry.title
        if role == Qt.ItemDataRole.ToolTipRole:
            return entry.detail
        if role == Qt.ItemDataRole.AccessibleTextRole:
            state = {None: "", True: tr("on"), False: tr("off")}[entry.on]
            parts = (tr(entry.kind), entry.title, state, entry.keys, entry.detail)
            return ", ".join(part for part in parts if part)
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        entry = self.entry(index.row())
        if entry is None or not entry.enabled:
            return Qt.ItemFlag.NoItemFlags
        return super().flags(index)


class _EntryDelegate(QStyledItemDelegate):
    """One line: the sort of thing, its name, what it does as far as there is room, its keys."""

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        return QSize(0, option.fontMetrics.height() + _PAD)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        model = index.model()
        entry = model.entry(index.row()) if isinstance(model, _Entries) else None
        if entry is None:
            return
        painter.save()
        text, quiet = self._ground(painter, option, entry.enabled)
        metrics = option.fontMetrics
        room = option.rect.adjusted(_PAD, 0, -_PAD, 0)
        align = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
        painter.setFont(option.font)
        painter.setPen(quiet)
        widest = max(metrics.horizontalAdvance(tr(kind)) for kind in KINDS)
        kind_width = max(_KIND_WIDTH, widest + 2 * _PAD)
        at = QRect(room.topLeft(), QSize(kind_width, room.height()))
        painter.drawText(at, align, tr(entry.kind))
        keys_width = metrics.horizontalAdvance(entry.keys)
        if entry.keys:
            at = room.adjusted(room.width() - keys_width, 0, 0, 0)
            painter.setPen(text)
            painter.drawText(at, align, entry.keys)
            room = room.adjusted(0, 0, -keys_width - 2 * _PAD, 0)
        room = room.adjusted(kind_width, 0, 0, 0)
        title = f"✓ {entry.title}" if entry.on else entry.title
        elide = Qt.TextElideMode.ElideRight
        shown = metrics.elidedText(title, elide, room.width())
        painter.setPen(text)
        painter.drawText(room, align, shown)
        room = room.adjusted(metrics.horizontalAdvance(shown) + 2 * _PAD, 0, 0, 0)
        if room.width() > kind_width:
            painter.setPen(quiet)
            painter.drawText(room, align, metrics.elidedText(entry.detail, elide, room.width()))
        painter.restore()

    def _ground(
        self, painter: QPainter, option: QStyleOptionViewItem, enabled: bool
    ) -> tuple[QColor, QColor]:
        """Paint what is below a row; the colours of its text and of what steps back."""
        group = QPalette.ColorGroup.Active if enabled else QPalette.ColorGroup.Disabled
        colours: QPalette = option.palette
        base = colours.color(QPalette.ColorRole.Base)
        text = colours.color(group, QPalette.ColorRole.Text)
        if option.state & QStyle.StateFlag.State_Selected:
            base = colours.color(QPalette.ColorRole.Highlight)
            text = colours.color(QPalette.ColorRole.HighlightedText)
            painter.fillRect(option.rect, base)
        elif option.state & QStyle.StateFlag.State_MouseOver:
            base = blend(base, text, 0.07)
            painter.fillRect(option.rect, base)
        return text, blend(text, base, 0.25)
