"""Findings element by element: signs in the list of elements, reasons in tips."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QTreeWidget, QTreeWidgetItem

from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.dataset.review import StoredFinding
from procc_annotator.gui.canvas.finding_sign import finding_icon
from procc_annotator.gui.panels.findings.rows import WORDS
from procc_annotator.gui.state.document import Document
from procc_annotator.translation import tr


def findings_by_element(document: Document) -> dict[str, tuple[StoredFinding, ...]]:
    """Findings of the frame on screen by the class they are marked at, the surest first."""
    by_class: dict[str, list[StoredFinding]] = {}
    for found in document.label_check.shown:
        for name, _ in found.places:
            by_class.setdefault(name, []).append(found)
    return {
        name: tuple(sorted(found, key=lambda f: f.finding.severity.rank))
        for name, found in by_class.items()
    }


def reasons_of(found: Iterable[StoredFinding]) -> str:
    """Return what is wrong, a line each."""
    return "\n".join(f"{tr(WORDS[f.finding.severity])}: {tr(f.finding.reason)}" for f in found)


class FindingSigns:
    """Signs in a column that has words of its own."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._shown: dict[str, tuple[StoredFinding, ...]] = {}
        self._icons: dict[Severity, QIcon] = {}

    def forget(self) -> None:
        """The rows are new ones: none has a sign."""
        self._shown = {}

    @property
    def any_shown(self) -> bool:
        """Return whether some element has a sign."""
        return bool(self._shown)

    def show(
        self, tree: QTreeWidget, items: Mapping[str, QTreeWidgetItem], column: int
    ) -> list[QTreeWidgetItem]:
        """Give every element the sign of its surest finding; the rows that are others now."""
        found = findings_by_element(self._document)
        others: list[QTreeWidgetItem] = []
        if found == self._shown:
            return others
        for name in self._shown.keys() | found.keys():
            item = items.get(name)
            here = found.get(name, ())
            if item is not None and here != self._shown.get(name):
                icon = self._icon(tree, here[0].finding.severity) if here else QIcon()
                item.setIcon(column, icon)
                item.setToolTip(column, reasons_of(here))
                others.append(item)
        self._shown = found
        return others

    def _icon(self, tree: QTreeWidget, severity: Severity) -> QIcon:
        if severity not in self._icons:
            self._icons[severity] = finding_icon(severity, tree.devicePixelRatioF())
        return self._icons[severity]
