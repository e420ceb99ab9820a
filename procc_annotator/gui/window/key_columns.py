"""Keys and what they do, in columns as many as the width holds.

It is painted: the same as rich text takes Qt a quarter of a second.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import reduce

from PySide6.QtCore import QEvent, QPoint, QRect, QSize, Qt, Signal
from PySide6.QtGui import (
    QFont,
    QFontMetrics,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QResizeEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from procc_annotator.translation import tr

_MOST_COLUMNS = 4
_LETTERS = 46  # what a column holds in a line, keys and words together
_KEYS_SHARE = 0.42  # of a column's width
_GAP = 18
_BREAK = "\u200b"  # takes no room; a line may end there
_LINES_AROUND = 2  # a title and the room above it, in lines
_WRAP = Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop


@dataclass(frozen=True, slots=True)
class SheetRow:
    """A line of the sheet.

    Attributes:
        keys: as people write them; they mean the same.
        text: what they do.
        calls: what a click calls, as the sheet knows it; "" for what only the mouse can do.
        english: the same in English, which finds it whatever the language.
    """

    keys: tuple[str, ...]
    text: str
    calls: str = ""
    english: str = ""

    def holds(self, words: Sequence[str], title: str) -> bool:
        """Return whether it has all of some words, in small letters, or the title of its section
        has."""
        text = f"{' '.join(self.keys)} {self.text} {self.english} {title}".casefold()
        return all(word in text for word in words)


_Placed = tuple[list[tuple[QRect, str, bool]], list[tuple[QRect, SheetRow]]]


@dataclass(frozen=True, slots=True)
class Section:
    """A part of the sheet.

    Attributes:
        title: of a menu, or what its keys are for.
        rows: its lines.
    """

    title: str
    rows: tuple[SheetRow, ...]

    def matching(self, words: Sequence[str]) -> Section:
        """The rows that have all these words, in small letters, in their keys, text or title."""
        return Section(self.title, tuple(r for r in self.rows if r.holds(words, self.title)))


class KeyColumns(QWidget):
    """Shows sections in reading order, in columns as short as that allows; a click calls a row."""

    called = Signal(str)  # `SheetRow.calls`

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("keyColumns")
        self.sections: tuple[Section, ...] = ()
        self._texts: list[tuple[QRect, str, bool]] = []  # where, what, whether bold
        self._rows: list[tuple[QRect, SheetRow]] = []
        self._below: SheetRow | None = None  # the cursor
        self.setMouseTracking(True)
        policy = QSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)

    def set_sections(self, sections: tuple[Section, ...]) -> None:
        """Show others."""
        self.sections = sections
        self.setAccessibleName(self.text())
        self._lay_out()

    def text(self) -> str:
        """All that is shown, a row a line."""
        return "\n".join(
            line
            for section in self.sections
            for line in (
                section.title,
                *(f"{keys_text(row.keys)}\t{row.text}" for row in section.rows),
            )
        )

    def sizeHint(self) -> QSize:
        return QSize(_GAP, self._height(self.width()))

    def heightForWidth(self, width: int) -> int:
        return self._height(width)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self._lay_out()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        for box, row in self._rows:
            if row is self._below:
                painter.fillRect(box, self.palette().color(QPalette.ColorRole.Midlight))
        painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
        usual, bold = self.font(), _bold(self.font())
        for box, text, is_bold in self._texts:
            if box.intersects(event.rect()):
                painter.setFont(bold if is_bold else usual)
                painter.drawText(box, int(_WRAP), text)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._point_at(self._row_at(event.position().toPoint()))

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._point_at(None)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        row = self._row_at(event.position().toPoint())
        if event.button() == Qt.MouseButton.LeftButton and row is not None:
            self.called.emit(row.calls)

    # --- inside ---

    def _row_at(self, at: QPoint) -> SheetRow | None:
        """The row below a point that a click calls."""
        return next((row for box, row in self._rows if row.calls and box.contains(at)), None)

    def _point_at(self, row: SheetRow | None) -> None:
        if row is not self._below:
            self._below = row
            self.setCursor(
                Qt.CursorShape.ArrowCursor if row is None else Qt.CursorShape.PointingHandCursor
            )
            self.update()

    def _lay_out(self) -> None:
        self._texts, self._rows = self._placed(self.width())
        self._below = None
        self.updateGeometry()
        self.update()

    def _height(self, width: int) -> int:
        placed = self._texts if width == self.width() else self._placed(width)[0]
        return max((box.bottom() for box, _, _ in placed), default=0) + _GAP

    def _words_of_keys(self) -> Iterator[str]:
        for section in self.sections:
            for row in section.rows:
                yield from " ".join(row.keys).split()

    def _placed(self, width: int) -> _Placed:
        usual, bold = QFontMetrics(self.font()), QFontMetrics(_bold(self.font()))
        count = width // (_LETTERS * usual.averageCharWidth())
        count = min(max(count, 1), _MOST_COLUMNS)
        column = (width - (count - 1) * _GAP) // count
        longest = max(map(bold.horizontalAdvance, self._words_of_keys()), default=0) + _GAP // 2
        keys = max(round(_KEYS_SHARE * column), min(longest, column // 2))
        titles = (section.title.upper() for section in self.sections)
        line = max((_tall(bold, column, title) for title in titles), default=usual.height())
        sized = []
        for section in self.sections:
            heights = [
                max(
                    _tall(bold, keys - _GAP // 2, _breakable(row.keys)),
                    _tall(usual, column - keys, row.text),
                )
                for row in section.rows
            ]
            sized.append((section, heights))
        filled = _filled([sum(heights) + _LINES_AROUND * line for _, heights in sized], count)
        texts: list[tuple[QRect, str, bool]] = []
        rows: list[tuple[QRect, SheetRow]] = []
        for number, indices in enumerate(filled):
            x, y = number * (column + _GAP), 0
            for section, heights in (sized[i] for i in indices):
                texts.append((QRect(x, y, column, line), section.title.upper(), True))
                y += line + line // 4
                for row, height in zip(section.rows, heights, strict=True):
                    keys_box = QRect(x, y, keys - _GAP // 2, height)
                    texts.append((keys_box, _breakable(row.keys), True))
                    texts.append((QRect(x + keys, y, column - keys, height), row.text, False))
                    rows.append((QRect(x, y, column, height), row))
                    y += height
                y += line - line // 4
        return texts, rows


def keys_text(keys: tuple[str, ...]) -> str:
    """Keys that mean the same, in words: "A or PgUp"."""
    return reduce(lambda one, other: tr("{one} or {other}", one=one, other=other), keys or ("",))


def _breakable(keys: tuple[str, ...]) -> str:
    """Keys that may go on in the next line after a plus."""
    return keys_text(keys).replace("+", f"+{_BREAK}")


def _bold(font: QFont) -> QFont:
    bold = QFont(font)
    bold.setBold(True)
    return bold


def _tall(metrics: QFontMetrics, width: int, text: str) -> int:
    """Return how high a text is in a width, px."""
    plain = text.replace(_BREAK, "").isascii()  # other letters may be higher
    if plain and metrics.horizontalAdvance(text) <= width:
        return metrics.height()
    return metrics.boundingRect(QRect(0, 0, width, 10_000), int(_WRAP), text).height()


def _filled(heights: Sequence[int], most: int) -> list[list[int]]:
    """Indices of sections, column by column, at most so many, none higher than it must be."""
    if not heights:
        return []
    low, high = max(heights), sum(heights)
    while low < high:
        limit = (low + high) // 2
        if len(_fill(heights, limit)) > most:
            low = limit + 1
        else:
            high = limit
    return _fill(heights, low)


def _fill(heights: Sequence[int], limit: int) -> list[list[int]]:
    columns: list[list[int]] = [[]]
    used = 0
    for index, height in enumerate(heights):
        if used + height > limit and columns[-1]:
            columns.append([])
            used = 0
        columns[-1].append(index)
        used += height
    return columns
