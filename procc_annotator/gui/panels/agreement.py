"""How a second annotator's clicks agree with these, class by class, and the noise of both."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QHeaderView,
    QLabel,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.gui.panels.common import Refresher, empty_state
from procc_annotator.gui.panels.states import class_title
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.metric.agreement import AgreementSums, compare

_CLASS = Qt.ItemDataRole.UserRole
_NONE = "Open a second annotator's folder (menu File) to compare the clicks of both."


class AgreementPanel(QWidget):
    """Distances between two annotators in this frame, and over the set: the human noise floor."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("agreement_panel")
        self._document = document
        self._job: Job | None = None
        self._build()
        self._refresher = Refresher(self, self._refresh, interval_ms=100)
        for signal in (
            document.frameChanged,
            document.annotationChanged,
            document.scoreChanged,
            document.second.changed,
        ):
            signal.connect(self._refresher.request)
        document.second.changed.connect(self._forget_noise)
        self._refresh()

    def open(self, path: Path) -> bool:
        """Compare with the annotations of a folder or zip."""
        document = self._document
        if not document.second.open(path):
            return False
        document.second.show(document.frame.name if document.frame is not None else None)
        self._measure_set()
        return True

    def _build(self) -> None:
        self.empty = empty_state(_NONE, "agreement_empty")
        self.noise = QLabel()
        self.noise.setObjectName("agreementNoise")
        self.noise.setWordWrap(True)
        self.frame = QLabel()
        self.frame.setObjectName("agreementFrame")
        self.frame.setWordWrap(True)
        self.table = QTableWidget(0, 4)
        self.table.setObjectName("agreementTable")
        self.table.setHorizontalHeaderLabels(["Element", "Median", "95 %", "Points"])
        self.table.verticalHeader().hide()
        self.table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        self.table.setSelectionBehavior(QTableWidget.SelectionBehavior.SelectRows)
        self.table.setShowGrid(False)
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for column in (1, 2, 3):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.ResizeToContents)
        self.table.itemClicked.connect(
            lambda item: self._document.select_class(
                self.table.item(item.row(), 0).data(_CLASS)  # type: ignore[union-attr]
            )
        )
        self.close_button = QPushButton("Close the second annotator")
        self.close_button.clicked.connect(self._document.second.close)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        for part in (self.empty, self.noise, self.frame, self.table, self.close_button):
            layout.addWidget(part)

    # --- showing --------------------------------------------------------------------------

    def _refresh(self) -> None:
        document = self._document
        second = document.second
        for part in (self.noise, self.frame, self.table, self.close_button):
            part.setVisible(second.is_open)
        self.empty.setVisible(not second.is_open)
        if not second.is_open:
            return
        found = second.agreement(document.shown_annotation, document.setup.size)
        if found is None:
            self.frame.setText("The second annotator has nothing for this frame.")
            self.table.setRowCount(0)
            return
        lines = [f"Agreement JaC at {document.tau:g} px: {found.jac(document.tau):.3f}"]
        if found.mirrored_hint:
            lines.append("One of the two seems to label the field turned by 180 degrees.")
        for names, who in ((found.only_a, "here"), (found.only_b, "there")):
            if names:
                titles = ", ".join(class_title(document.field, n) for n in names)
                lines.append(f"Only {who}: {titles}")
        self.frame.setText("\n".join(lines))
        ranked = sorted(found.by_class.values(), key=lambda c: -(c.p95 or 0.0))
        self.table.setRowCount(len(ranked))
        for row, entry in enumerate(ranked):
            name = QTableWidgetItem(class_title(document.field, entry.class_name))
            name.setData(_CLASS, entry.class_name)
            self.table.setItem(row, 0, name)
            texts = (_px(entry.median), _px(entry.p95), str(len(entry.distances)))
            for column, text in enumerate(texts, start=1):
                item = QTableWidgetItem(text)
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self.table.setItem(row, column, item)

    def _forget_noise(self) -> None:
        if not self._document.second.is_open:
            self._document.set_noise_floor(None)

    # --- the set --------------------------------------------------------------------------

    def _measure_set(self) -> None:
        """The noise floor over all frames that both annotated, in the background."""
        document = self._document
        workspace, second = document.workspace, document.second
        if self._job is not None:
            self._job.cancel()
        if workspace is None:
            return
        field, size, tau = document.field, document.setup.size, document.tau
        names = [frame.name for frame in workspace.frames]
        read_other = second.reader()

        def work(control: JobControl) -> AgreementSums:
            sums = AgreementSums((tau,))
            for index, name in enumerate(names):
                if control.cancelled:
                    break
                try:
                    other: FrameAnnotation | None = read_other(name)
                    mine = workspace.read(index) if other is not None else None
                except InputError:
                    continue  # told when that frame is opened
                if mine is not None and other is not None and mine.annotated:
                    sums.add(name, compare(mine, other, field, size))
            return sums

        self.noise.setText("Measuring the set…")
        self._job = run_in_background(
            work, on_result=self._take_set, on_error=self.noise.setText, owner=self
        )

    def _take_set(self, sums: AgreementSums) -> None:
        self._job = None
        summary = sums.summary()
        size = self._document.setup.size
        median, p95 = summary.overall.median, summary.overall.p95
        if median is None or p95 is None:
            self.noise.setText("No frame is annotated by both.")
            self._document.set_noise_floor(None)
            return
        floor = median, p95
        self.noise.setText(
            f"Human noise over {summary.frames} frames: median {floor[0]:.2f} px,"
            f" 95 % within {floor[1]:.2f} px (at {size[0]}x{size[1]})"
        )
        self._document.set_noise_floor(floor)


def _px(value: float | None) -> str:
    return "–" if value is None else f"{value:.2f} px"
