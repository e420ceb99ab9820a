"""Which source the active one is compared with, and how far apart they see the ground."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtGui import QAction, QPalette
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.gui.panels.cameras.source_row import colour_icon
from procc_annotator.gui.panels.parts import box_of, choice, note_label, show_note
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.maps import Compared
from procc_annotator.gui.theme import fixed_width
from procc_annotator.metrics.error_maps import OFFSIDE_ACCURACY_M, MapSummary
from procc_annotator.translation import tr

_FIGURES = ("minimum", "median", "maximum")


class ComparingSection(QWidget):
    """Part of the cameras panel; there only while there is something to compare."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self.other = choice("cameras_compared", tr("Source to compare with"))
        self.other.setToolTip(tr("Held against the active source: comma, split view, disagreement"))
        self.other.activated.connect(self._choose)
        caption = QLabel(tr("Compare with"))
        caption.setBuddy(self.other)
        row = QHBoxLayout()
        row.addWidget(caption)
        row.addWidget(self.other, 1)
        self._boxes = QHBoxLayout()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        layout.setSpacing(4)
        layout.addLayout(row)
        layout.addLayout(self._boxes)
        self.figures = _Figures()
        layout.addWidget(self.figures)
        self.problem = note_label("disagreement_problem")
        layout.addWidget(self.problem)

    def add_actions(self, *actions: QAction) -> None:
        """Offer these as boxes to be ticked."""
        for action in actions:
            self._boxes.addWidget(box_of(action, f"cameras_{action.objectName()}"))

    def refresh(self) -> None:
        """Show the choice and the figures as they are now."""
        document = self._document
        compared = document.state.compared
        others = [s for s in document.state.sources if s is not document.state.active]
        with QSignalBlocker(self.other):
            self.other.clear()
            for source in others:
                icon = colour_icon(source.colour, self.devicePixelRatioF())
                self.other.addItem(icon, source.name, source)
            self.other.setCurrentIndex(others.index(compared) if compared is not None else -1)
        self.other.setEnabled(compared is not None)
        wanted = compared is not None or document.disagreement.enabled
        self.setVisible(wanted and bool(document.state.sources))
        found = document.disagreement.value
        self.figures.show_found(found)
        show_note(self.problem, document.disagreement.problem)

    def _choose(self, index: int) -> None:
        self._document.camera_sources.compare_with(self.other.itemData(index))


class _Figures(QWidget):
    """Least, median and largest disagreement, in metres and in pixels."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("disagreement_figures")
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(10)
        grid.setVerticalSpacing(1)
        self._values: dict[tuple[str, str], QLabel] = {}
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        for column, title in enumerate((tr("min"), tr("median"), tr("max")), start=1):
            head = QLabel(title)
            head.setForegroundRole(QPalette.ColorRole.PlaceholderText)
            grid.addWidget(head, 0, column, right)
        for row, (unit, tip) in enumerate(
            (
                ("m", tr("Between the two points on the ground that a pixel means")),
                ("px", tr("From a pixel to where the compared camera shows its ground point")),
            ),
            start=1,
        ):
            name = QLabel(tr("on the ground, m") if unit == "m" else tr("in the picture, px"))
            name.setToolTip(tip)
            name.setForegroundRole(QPalette.ColorRole.PlaceholderText)
            grid.addWidget(name, row, 0)
            for column, figure in enumerate(_FIGURES, start=1):
                value = QLabel()
                value.setObjectName(f"disagreement_{figure}_{unit}")
                value.setFont(fixed_width(self.font()))
                value.setToolTip(tip)
                self._values[unit, figure] = value
                grid.addWidget(value, row, column, right)
        grid.setColumnStretch(0, 1)
        self.within = QLabel()
        self.within.setObjectName("disagreement_within")
        self.within.setWordWrap(True)
        grid.addWidget(self.within, 3, 0, 1, 4)
        self.hide()

    def show_found(self, found: Compared | None) -> None:
        """Show the figures of a comparison; without any they take no room."""
        share = found.values.share_within(OFFSIDE_ACCURACY_M) if found is not None else None
        self.setVisible(share is not None)
        if found is None or share is None:
            return
        statistics = found.values.statistics
        self._show_spread("m", statistics.metres, 2)
        self._show_spread("px", statistics.pixels, 1)
        covered = found.values.compared_share
        self.within.setText(
            tr(
                "{share:.0f} % within {far:g} m, over {covered:.0f} % of the picture",
                share=100 * share,
                far=OFFSIDE_ACCURACY_M,
                covered=100 * covered,
            )
        )

    def _show_spread(self, unit: str, spread: MapSummary, decimals: int) -> None:
        for figure in _FIGURES:
            value = getattr(spread, figure)
            self._values[unit, figure].setText("–" if value is None else f"{value:.{decimals}f}")
