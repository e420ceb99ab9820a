"""Table models and views of the panels, and titles of elements shortened to fit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import takewhile
from typing import Any, Generic, Protocol, TypeVar

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QPersistentModelIndex,
    QRegularExpression,
    QSize,
    QSortFilterProxyModel,
    Qt,
    Signal,
)
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QLineEdit,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
)

from procc_annotator.field.model import Field
from procc_annotator.translation import is_english, tr

ROW, SEARCHED = Qt.ItemDataRole.UserRole, Qt.ItemDataRole.UserRole + 1
RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter

Index = QModelIndex | QPersistentModelIndex

R = TypeVar("R")


class RowsModel(QAbstractTableModel, Generic[R]):
    """Rows, headings and tips, replaced as a whole; only what changed is announced. What the cells
    say is for each table to give (`data`)."""

    def __init__(
        self, headings: Sequence[str], tips: Sequence[str] = (), first_figure: int | None = None
    ) -> None:
        """Args:
        headings, tips: of the columns, marked by ``word``.
        first_figure: columns from here on are aligned to the right.
        """
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


def list_rows(table: QTableView, room: int = 6) -> None:
    """Have a table look like a list: whole rows, one of which may be chosen, without a grid.

    Args:
        table: its model is set.
        room: px a row is higher than its text.
    """
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setShowGrid(False)
    table.setTabKeyNavigation(False)  # Tab leaves it, and chooses nothing
    table.setWordWrap(False)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(table.fontMetrics().height() + room)
    table.horizontalHeader().setHighlightSections(False)


class ElementRow(Protocol):
    """Interface of a row."""

    @property
    def class_name(self) -> str:
        """The element's class."""
        ...


E = TypeVar("E", bound=ElementRow)


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
        """Args:
        name: the widget's.
        model: the rows.
        samples: by column, the widest text there; all other room is the titles'.
        """
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


_COMMAS = (",", "、", "，")


def short_titles(field: Field) -> dict[str, str]:
    """By class: the title without what its group says already.

    In English these are the leading words that all titles of the group share with it: below "Left
    three-point line" the "Left three-point far straight" is the "Far straight". Other languages
    bend their words and put them elsewhere; there it is a first part of words of the group: below
    "Linkes Tor" the "Linkes Tor, linker Pfosten" is the "Linker Pfosten".
    """
    groups: dict[str, list[tuple[str, str]]] = {}
    for element in field.elements:
        groups.setdefault(element.group, []).append((element.name, element.title))
    found = {}
    for group, elements in groups.items():
        leading = _leading(group, [title for _, title in elements])
        for name, title in elements:
            said, english = tr(title), " ".join(title.split()[leading:])
            rest = english if said == title else _beyond(tr(group), said)
            found[name] = f"{rest[:1].upper()}{rest[1:]}"
    return found


def _beyond(group: str, title: str) -> str:
    """Return what a title says behind a first part that has no word but the group's; else all of
    it."""
    for comma in _COMMAS:
        first, _, rest = title.partition(comma)
        if rest and set(first.split()) <= set(group.split()):
            return rest.strip()
    return title


def _leading(group: str, titles: list[str]) -> int:
    """Return how many leading words of a group all its titles share, each having words beyond
    them."""
    if len(titles) < 2:
        return 0
    columns = zip(group.split(), *(title.split()[:-1] for title in titles), strict=False)
    return sum(1 for _ in takewhile(lambda words: len(set(words)) == 1, columns))


class TitleDelegate(QStyledItemDelegate):
    """Writes titles so that near and far, left and right can be distinguished."""

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        view = option.widget
        style = view.style()
        room = style.subElementRect(QStyle.SubElement.SE_ItemViewItemText, option, view).width()
        margin = style.pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin, None, view) + 1
        option.text = elided_title(option.text, option.fontMetrics, room - 2 * margin)


def elided_title(title: str, metrics: QFontMetrics, width: int) -> str:
    """A title in so many px: the side of the field stands first, what distinguishes its parts last.

    "Right three-point far straight" becomes "Right … far straight", then "R… far straight". Other
    languages have the side anywhere: there every long word is shortened.
    """
    if not is_english():
        return _abbreviated(title, metrics, width)
    words = title.split()
    fewer = (words[1 + left_out :] for left_out in range(1, len(words) - 2))
    shorter = [title, *(" ".join((words[0], "…", *rest)) for rest in fewer)]
    if len(words) > 2:
        shorter.append(" ".join((f"{words[0][0]}…", *words[-2:])))
    for text in shorter:
        if metrics.horizontalAdvance(text) <= width:
            return text
    return metrics.elidedText(title, Qt.TextElideMode.ElideMiddle, max(width, 0))


def _abbreviated(title: str, metrics: QFontMetrics, width: int) -> str:
    """A title whose longest words give way first: "Surf. gauc. côté loin."."""
    words = title.split()
    for most in range(max(map(len, words), default=0), 1, -1):
        text = " ".join(w if len(w) <= most else f"{w[: most - 1]}." for w in words)
        if metrics.horizontalAdvance(text) <= width:
            return text
    return metrics.elidedText(title, Qt.TextElideMode.ElideMiddle, max(width, 0))
