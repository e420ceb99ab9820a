"""Widgets of panels and dialogs: tables, number boxes, empty states, notes, scrolled content."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Generic, Protocol, TypeVar

from PySide6.QtCore import (
    QAbstractTableModel,
    QEvent,
    QLocale,
    QModelIndex,
    QPersistentModelIndex,
    QRegularExpression,
    QSize,
    QSortFilterProxyModel,
    Qt,
    Signal,
    SignalInstance,
)
from PySide6.QtGui import QAction, QFont, QKeyEvent, QPainter, QPaintEvent, QPalette, QValidator
from PySide6.QtWidgets import (
    QAbstractItemView,
    QBoxLayout,
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFrame,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLayout,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QStackedWidget,
    QTableView,
    QToolTip,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import State
from procc_annotator.translation import tr

ROW, SEARCHED = Qt.ItemDataRole.UserRole, Qt.ItemDataRole.UserRole + 1
RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter

Index = QModelIndex | QPersistentModelIndex

R = TypeVar("R")


class RowsModel(QAbstractTableModel, Generic[R]):
    """Rows, headings and tips, replaced as a whole; only what changed is announced.

    Each table gives the texts of a row, and its tip, or all that its cells show (`data`).
    """

    def __init__(
        self, headings: Sequence[str], tips: Sequence[str] = (), first_figure: int | None = None
    ) -> None:
        """Headings and tips of the columns are marked by ``word``; columns from ``first_figure`` on
        are aligned to the right."""
        super().__init__()
        self.rows: Sequence[R] = ()
        self._headings, self._tips = [tr(one) for one in headings], [tr(one) for one in tips]
        self._first_figure = len(headings) if first_figure is None else first_figure

    def replace(self, rows: Sequence[R]) -> None:
        """Show other rows; a view keeps its place when their number stays."""
        if len(rows) == len(self.rows):
            changed = [i for i, row in enumerate(rows) if row != self.rows[i]]
            self.rows = rows
            for i in changed:
                self.dataChanged.emit(self.index(i, 0), self.index(i, len(self._headings) - 1))
        else:
            self.beginResetModel()
            self.rows = rows
            self.endResetModel()

    @abstractmethod
    def texts(self, row: R) -> Sequence[str]:
        """Return the text of each column."""

    def tip(self, row: R) -> str:
        """Return the tool tip of a row."""
        return ""

    def font(self, row: R) -> QFont | None:
        """Return the font of a row; None: that of the table."""
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row, column = self.rows[index.row()], index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return self.texts(row)[column]
        if role == Qt.ItemDataRole.TextAlignmentRole and column >= self._first_figure:
            return RIGHT
        if role == Qt.ItemDataRole.ToolTipRole:
            return self.tip(row)
        return self.font(row) if role == Qt.ItemDataRole.FontRole else None

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 (Qt's signature)
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self._headings)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation is Qt.Orientation.Horizontal:
            if role == Qt.ItemDataRole.DisplayRole:
                return self._headings[section]
            if role == Qt.ItemDataRole.ToolTipRole and self._tips:
                return self._tips[section]
            if role == Qt.ItemDataRole.TextAlignmentRole and section >= self._first_figure:
                return RIGHT
        return None


def searched_rows(model: QAbstractTableModel, search: QLineEdit) -> QSortFilterProxyModel:
    """Return the rows of a model whose `SEARCHED` text holds all the words of a search line."""
    proxy = QSortFilterProxyModel(search)
    model.setParent(proxy)  # or Python may delete it while the view is still there
    proxy.setSourceModel(model)
    proxy.setFilterRole(SEARCHED)

    def narrow(text: str) -> None:
        words = map(QRegularExpression.escape, text.split())
        pattern = QRegularExpression("".join(f"(?=.*{word})" for word in words))
        pattern.setPatternOptions(QRegularExpression.PatternOption.CaseInsensitiveOption)
        proxy.setFilterRegularExpression(pattern)

    search.textChanged.connect(narrow)
    return proxy


class LowTable(QTableView):
    """A table that asks for its least height, and takes what else there is: Qt's asks for 192."""

    def sizeHint(self) -> QSize:
        return QSize(super().sizeHint().width(), self.minimumSizeHint().height())

    def minimumSizeHint(self) -> QSize:
        return QSize(super().minimumSizeHint().width(), 4 * (self.fontMetrics().height() + 6))


def list_rows(table: QTableView, room: int = 6, widest: int | None = None) -> None:
    """Have a table with a model look like a list: whole rows, ``room`` px higher than their text,
    one of which may be chosen, without a grid; columns are as wide as the texts in sight but for
    the ``widest``, which takes the rest."""
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setShowGrid(False)
    table.setTabKeyNavigation(False)  # Tab leaves it, and chooses nothing
    table.setWordWrap(False)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(table.fontMetrics().height() + room)
    header = table.horizontalHeader()
    header.setHighlightSections(False)
    if widest is not None:
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setResizeContentsPrecision(0)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(widest, QHeaderView.ResizeMode.Stretch)


class _ElementRow(Protocol):
    @property
    def class_name(self) -> str: ...


E = TypeVar("E", bound=_ElementRow)


class ElementRowsModel(RowsModel[E]):
    """Rows that are found by their element."""

    def row_of(self, class_name: str | None) -> int:
        """The row of a class, -1 if it has none."""
        return next((i for i, row in enumerate(self.rows) if row.class_name == class_name), -1)


class ElementTable(LowTable):
    """Shows the rows of a model, titles of elements in the first column.

    A click, Enter and the arrows choose a row; showing the one that is chosen elsewhere
    (`show_chosen`) does not.
    """

    chosen = Signal(int)  # a row

    def __init__(self, name: str, model: ElementRowsModel[E], samples: Mapping[int, str]) -> None:
        """Show rows; samples are by column the widest text there, all other room is the titles'."""
        super().__init__()
        self._model = model
        self._following = False
        self.setObjectName(name)
        self.setModel(model)
        list_rows(self)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the keys to the canvas
        metrics, header = self.fontMetrics(), self.horizontalHeader()
        header.setMinimumSectionSize(36)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for column, sample in samples.items():
            header.resizeSection(column, metrics.horizontalAdvance(sample) + 8)
        self.clicked.connect(self._choose)
        self.activated.connect(self._choose)
        self.selectionModel().currentRowChanged.connect(self._take_current)

    def show_chosen(self, class_name: str | None) -> int:
        """Mark the row of a class; its number, or -1 where it has none."""
        row = self._model.row_of(class_name)
        self._following = True
        if row < 0:
            self.clearSelection()
        elif row != self.currentIndex().row() or not self.selectedIndexes():
            self.selectRow(row)
        self._following = False
        return row

    def _choose(self, index: QModelIndex) -> None:
        self.chosen.emit(index.row())

    def _take_current(self, current: QModelIndex, _: QModelIndex) -> None:
        """Arrows go from row to row; clicks are taken when they end."""
        if current.isValid() and self.hasFocus() and not self._following:
            self._choose(current)


NARROW = 380  # below this width tables leave out words that a symbol says as well

# Property of a line of text that leaves Escape to the window: back to what it was, then away.
LEFT_BY_ESCAPE = "left_by_escape"


Margins = int | tuple[int, int, int, int]  # px, around or left, top, right, bottom
W = TypeVar("W", bound=QWidget)
Part = QWidget | QLayout | tuple[QWidget | QLayout | None, int] | None


def named(widget: W, name: str = "", *, tip: str = "", title: str = "") -> W:
    """Set a widget's object name, tool tip and accessible name; return the widget."""
    widget.setObjectName(name)
    widget.setToolTip(tip)
    widget.setAccessibleName(title)
    return widget


def hbox(*parts: Part, spacing: int | None = None, margins: Margins | None = None) -> QHBoxLayout:
    """Lay out parts side by side, as `vbox` does."""
    return _fill(QHBoxLayout(), parts, spacing, margins)


def vbox(
    *parts: Part,
    of: QWidget | None = None,
    spacing: int | None = None,
    margins: Margins | None = None,
) -> QVBoxLayout:
    """Lay out parts one below the other.

    Args:
        parts: widgets and layouts, each alone or with its stretch; None: a space (stretch 1).
        spacing, margins: px between the parts and around them; None: those of the style.
    """
    box = _fill(QVBoxLayout(), parts, spacing, margins)
    if of is not None:
        of.setLayout(box)
    return box


B = TypeVar("B", bound=QBoxLayout)


def _fill(box: B, parts: Iterable[Part], spacing: int | None, margins: Margins | None) -> B:
    if spacing is not None:
        box.setSpacing(spacing)
    if margins is not None:
        box.setContentsMargins(*((margins,) * 4 if isinstance(margins, int) else margins))
    for part in parts:
        content, stretch = part if isinstance(part, tuple) else (part, int(part is None))
        if isinstance(content, QWidget):
            box.addWidget(content, stretch)
        elif content is not None:
            box.addLayout(content, stretch)
        else:
            box.addStretch(stretch)
    return box


def make_label(
    text: str = "",
    name: str = "",
    *,
    tip: str = "",
    wrap: bool = False,
    faint: bool = False,
    font: QFont | None = None,
) -> QLabel:
    """Make a label; faint text steps back behind what it explains."""
    made = named(QLabel(text, wordWrap=wrap), name, tip=tip)
    if faint:
        made.setForegroundRole(QPalette.ColorRole.PlaceholderText)
    if font is not None:
        made.setFont(font)
    return made


def caption(text: str, field: QWidget) -> QHBoxLayout:
    """Lay out a field behind its name, which its mnemonic and screen readers refer to."""
    name = QLabel(text)
    name.setBuddy(field)
    return hbox(name, (field, 1))


def make_button(
    text: str,
    slot: Callable[..., object] | SignalInstance,
    name: str = "",
    *,
    tip: str = "",
    wide: bool = False,
) -> QPushButton:
    """Make a button that calls a slot; a wide one takes the width that there is."""
    made = named(QPushButton(text), name, tip=tip)
    made.clicked.connect(slot)
    if wide:
        made.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    return made


_LINE_KEYS = frozenset(
    {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape, Qt.Key.Key_Up, Qt.Key.Key_Down}
)


class Panel(QWidget):
    """A panel of the window, which is updated while it can be seen."""

    left = Signal()  # the keyboard belongs to the canvas again

    def __init__(self, services: Services, name: str, size: tuple[int, int] | None = None) -> None:
        """Name the panel; it asks for a size, px, else for what its content asks for."""
        super().__init__()
        self.setObjectName(name)
        self._services, self._size = services, size

    def sizeHint(self) -> QSize:
        return super().sizeHint() if self._size is None else QSize(*self._size)

    def _follow(self, select: Callable[[State], object], *signals: SignalInstance) -> None:
        """Refresh after a paint whenever a selection of the state has changed, and after signals of
        what is no part of the state."""
        self._refresher = self._services.store.watch_visible(self, self._refresh, select, *signals)

    @abstractmethod
    def _refresh(self) -> None:
        """Show the state as it is now."""


class KeyLine(QLineEdit):
    """A line of text that has Enter, Escape and the arrows although the window has them too."""

    keyPressed = Signal(object)  # a Qt.Key

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.key() in _LINE_KEYS:
            if event.type() == QEvent.Type.KeyPress:
                self.keyPressed.emit(Qt.Key(event.key()))
            if event.type() != QEvent.Type.KeyRelease:
                event.accept()  # here they do not finish a polyline
                return True
        return super().event(event)


def search_line(
    hint: str,
    name: str,
    changed: Callable[..., object] | None = None,
    title: str = "",
    *,
    keys: Callable[[Qt.Key], object] | None = None,
) -> QLineEdit:
    """Make a line to search with.

    Args:
        hint: shown while it is empty.
        title: read out instead of the hint.
        keys: receives Enter, Escape and the vertical arrows, which are the line's then.
    """
    line = QLineEdit() if keys is None else KeyLine()
    line.setPlaceholderText(hint)
    line.setClearButtonEnabled(True)
    named(line, name, title=title or hint)
    if changed is not None:
        line.textChanged.connect(changed)
    if isinstance(line, KeyLine) and keys is not None:
        line.keyPressed.connect(keys)
    return line


class Pages(QStackedWidget):
    """A widget, or in its place a text that explains why it has nothing to show."""

    def __init__(self, content: QWidget, name: str) -> None:
        super().__init__()
        self.content, self.empty = content, empty_state("", name)
        self.addWidget(content)
        self.addWidget(self.empty)

    def explain(self, why: str) -> None:
        """Show a text; the content if it is empty."""
        if why:
            self.empty.setText(why)
        self.setCurrentWidget(self.empty if why else self.content)


def empty_state(text: str, name: str) -> QLabel:
    """A label that explains why a panel has nothing to show, and what to do about it."""
    made = make_label(text, name, wrap=True, faint=True)
    made.setAlignment(Qt.AlignmentFlag.AlignCenter)
    made.setMargin(12)
    made.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Expanding)
    return made


def note_label(name: str, tip: str = "") -> QLabel:
    """A wrapping label for one line of explanation; hidden until `show_note` gives it text."""
    made = make_label(name=name, tip=tip, wrap=True)
    made.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    made.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
    made.hide()
    return made


def show_note(note: QLabel, text: str) -> None:
    """Put text on a note; without text the note takes no room."""
    note.setText(text)
    note.setVisible(bool(text))


def choice(
    name: str,
    title: str = "",
    *,
    tip: str = "",
    items: Iterable[tuple[str, object]] = (),
    chosen: Callable[[Any], object] | None = None,
) -> QComboBox:
    """Make a list to choose from, as narrow as its panel; the title is read out where no label is,
    ``chosen`` receives the value that the user chooses."""
    combo = named(QComboBox(), name, tip=tip, title=title)
    for text, value in items:
        combo.addItem(text, value)
    combo.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
    combo.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    combo.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    if chosen is not None:
        combo.activated.connect(lambda index: chosen(combo.itemData(index)))
    return combo


def box_of(action: QAction, name: str) -> QCheckBox:
    """An action that is on or off as a box to be ticked."""
    box = named(QCheckBox(action.text()), name, tip=action.toolTip())
    box.setChecked(action.isChecked())
    box.clicked.connect(action.trigger)
    action.toggled.connect(box.setChecked)
    return box


class ElidedLabel(QWidget):
    """A text that is shortened with dots instead of pushing its neighbours out."""

    def __init__(self, elide: Qt.TextElideMode = Qt.TextElideMode.ElideRight) -> None:
        super().__init__()
        self._text, self._elide = "", elide
        self._soon = after_paint(self, self.update)  # what the text is about is painted first
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)

    def text(self) -> str:
        """All of it."""
        return self._text

    def set_text(self, text: str) -> None:
        """Show something else."""
        if text != self._text:
            self._text = text
            self.setAccessibleName(text)
            self._soon.start()

    def text_for(self, width: int) -> str:
        """Return what is shown in a width, px."""
        return self.fontMetrics().elidedText(self._text, self._elide, width)

    def minimumSizeHint(self) -> QSize:
        return QSize(40, self.fontMetrics().height() + 2)

    sizeHint = minimumSizeHint

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, area = QPainter(self), self.contentsRect()
        painter.setPen(self.palette().color(self.foregroundRole()))
        left = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
        painter.drawText(area, left, self.text_for(area.width()))


class ScrolledContent(QWidget):
    """A panel's content to be put into `scrolling`: as high as its texts need at their width. Qt
    would reserve what they need at their narrowest."""

    def minimumSizeHint(self) -> QSize:
        least = super().minimumSizeHint()
        layout = self.layout()
        # Without a text that wraps no one asks for the height at a width: this is all there is.
        wraps = layout is not None and layout.hasHeightForWidth()
        return QSize(least.width(), 0) if wraps else least


def scrolling(content: ScrolledContent) -> QScrollArea:
    """A panel's content with a scroll bar where it has no room.

    It asks for no room of its own, so a text that changes in it moves nothing outside: docks that
    share a column with others are laid out anew whenever one of them wants another size.
    """
    area = QScrollArea()
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidgetResizable(True)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    area.setWidget(content)
    return area


class DecimalBox(QDoubleSpinBox):
    """Shows a decimal point, as all numbers of the window, and accepts a comma."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setLocale(QLocale(QLocale.Language.C))

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        return super().validate(text.replace(",", "."), position)


class RangeBox(DecimalBox):
    """Lets numbers out of its range be typed, and reports that they are not accepted."""

    refused = Signal(float)  # this was entered; the value is what it was

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        text = text.replace(",", ".")
        if self._outside(text) is not None:
            return QValidator.State.Intermediate, text, position
        return super().validate(text, position)

    def fixup(self, text: str) -> str:
        number = self._outside(text)
        if number is not None:
            self.refused.emit(number)
        return str(super().fixup(text))

    def tell_refused(self, number: float) -> None:
        """Show next to the box that a number is not accepted."""
        words = tr(
            "not {number:g}: {least:g} to {most:g}{unit}",
            number=number,
            least=self.minimum(),
            most=self.maximum(),
            unit=self.suffix(),
        )
        QToolTip.showText(self.mapToGlobal(self.rect().bottomLeft()), words, self)

    def _outside(self, text: str) -> float | None:
        """The number of a text, if the range does not have it."""
        bare = text.replace(",", ".").removesuffix(self.suffix()).strip()
        number, is_number = self.locale().toDouble(bare)
        if not is_number or self.minimum() <= number <= self.maximum():
            return None
        return number


def range_box(least: float, most: float, step: float, unit: str, *, decimals: int = 1) -> RangeBox:
    """Make a box for a number; one out of range is refused next to it."""
    box = RangeBox()
    box.setDecimals(decimals)
    box.setRange(least, most)
    box.setSingleStep(step)
    box.setSuffix(unit)
    box.setKeyboardTracking(False)
    box.refused.connect(box.tell_refused)
    return box
