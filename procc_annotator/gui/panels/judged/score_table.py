"""The verdict on every element as table rows, worst first, each with a sentence that says why."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

from PySide6.QtCore import Qt
from PySide6.QtGui import QIcon

from procc_annotator.field.model import Field
from procc_annotator.gui.panels.rows import RIGHT, ElementRowsModel, ElementTable, Index
from procc_annotator.gui.panels.states import EXPLANATIONS, ElementState, class_title, words_for
from procc_annotator.gui.panels.titles import TitleDelegate
from procc_annotator.gui.state.state import MAX_TAU, MIN_TAU
from procc_annotator.metrics.measurement import Measurement
from procc_annotator.metrics.score import (
    FrameScore,
    ScoreExplanation,
    explain_score,
    px_text,
    worst_elements_first,
)
from procc_annotator.translation import tr, word

ELEMENT, STATUS, POINT, WORST, PASSES = range(5)
_HEADERS = (word("Element"), word("Status"), word("Point"), word("Worst"), word("Passes at"))
_HEADER_TIPS = (
    word("Click a row to see the point that decides"),
    word("How the element counts at tau"),
    word("The point that decides, counted from 1"),
    word("Largest distance of its points to the projection, px"),
    word("The smallest tau of the slider at which it passes, px"),
)


class ScoreRow(NamedTuple):
    """What one line of the table says; compared to find out what changed."""

    class_name: str
    counted_as: str
    title: str
    state: ElementState
    point: str
    worst: str
    passes: str
    why: str


def score_rows(
    score: FrameScore, measurement: Measurement, field: Field
) -> tuple[list[ScoreRow], list[ScoreExplanation]]:
    """Lines worst first: too far, missed, not annotated, passing; each by its largest distance."""
    elements = list(worst_elements_first(explain_score(score, measurement, field)))
    rows = []
    for element in elements:
        name = element.annotated_name or element.name
        deciding = element.deciding_px
        worst = "" if deciding is None else px_text(deciding, score.threshold)
        point = "" if element.deciding_point is None else str(element.deciding_point + 1)
        rows.append(
            ScoreRow(
                name,
                element.name,
                class_title(field, name),
                ElementState(element.status),
                point,
                worst,
                _passes_from(element.passes_above),
                element.sentence,
            )
        )
    return rows, elements


def _passes_from(distance: float | None) -> str:
    """The first step of the slider above a distance: passing means strictly closer than tau."""
    if distance is None:
        return ""
    tau = max(MIN_TAU, (math.floor(distance * 10) + 1) / 10)
    return f"{tau:.1f}" if tau <= MAX_TAU else f"> {MAX_TAU:.0f}"


class ScoreTableModel(ElementRowsModel[ScoreRow]):
    """The verdict on every element."""

    def __init__(self, icon: Callable[[ElementState], QIcon]) -> None:
        super().__init__(_HEADERS, _HEADER_TIPS, POINT)
        self._icon = icon
        self.elements: list[ScoreExplanation] = []

    def show(self, rows: list[ScoreRow], elements: list[ScoreExplanation]) -> None:
        """Replace the rows."""
        self.elements = elements
        self.replace(rows)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row, column = self.rows[index.row()], index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return (row.title, words_for(row.state), row.point, row.worst, row.passes)[column]
        if role == Qt.ItemDataRole.DecorationRole and column == ELEMENT:
            return self._icon(row.state)
        if role == Qt.ItemDataRole.TextAlignmentRole and column >= POINT:
            return RIGHT
        if role == Qt.ItemDataRole.ToolTipRole:
            lines = [row.title, row.why, tr(EXPLANATIONS[row.state])]
            if row.counted_as != row.class_name:
                lines.append(tr("Counts as {class_name}", class_name=row.counted_as))
            return "\n".join(lines)
        if role == Qt.ItemDataRole.AccessibleDescriptionRole:
            return row.why
        return None


def _samples() -> dict[int, str]:
    """Return what the columns have room for."""
    states = max(map(words_for, ElementState), key=len)
    return {
        STATUS: f"{states} ",
        POINT: f"{tr('Point')}  ",
        WORST: max("88.88 ", f"{tr('Worst')} ", key=len),
        PASSES: f"{tr('Passes at')}  ",
    }


def score_table(model: ScoreTableModel) -> ElementTable:
    """The view of the rows; what is left out of a title is its middle."""
    table = ElementTable("scores_table", model, _samples())
    table.setAccessibleName(tr("Scores by element"))
    table.setItemDelegateForColumn(ELEMENT, TitleDelegate(table))
    table.setTextElideMode(Qt.TextElideMode.ElideMiddle)
    table.setMouseTracking(True)
    return table
