"""How a second annotator's clicks agree with these, class by class, and the noise of both."""

from __future__ import annotations

from dataclasses import dataclass
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
from procc_annotator.metric.agreement import (
    AgreementSummary,
    AgreementSums,
    ClassAgreement,
    FrameAgreement,
    compare_annotations,
)

_CLASS = Qt.ItemDataRole.UserRole
_NONE = "Open a second annotator's folder (menu File) to compare the clicks of both."
_APART = (
    "Apart: the two share (almost) no stretch of this element, which is no agreement."
    " Was its class swapped with a neighbour's?"
)
_ERRORS_SHOWN = 10


@dataclass(frozen=True, slots=True)
class _MeasuredSet:
    """The set's figures, and one line for each frame that could not be read."""

    summary: AgreementSummary
    errors: tuple[str, ...]


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
        self.table.setTabKeyNavigation(False)
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
        if second.error:
            self.frame.setText(
                f"The second annotator's file for this frame is unreadable: {second.error}"
            )
            self.table.setRowCount(0)
            return
        found = second.agreement(document.shown_annotation, document.setup.size)
        if found is None:
            self.frame.setText("The second annotator has nothing for this frame.")
            self.table.setRowCount(0)
            return
        self.frame.setText("\n".join(self._frame_lines(found)))
        # What agrees least comes first.
        ranked = sorted(found.by_class.values(), key=lambda c: (not c.apart, -(c.p95 or 0.0)))
        self.table.setRowCount(len(ranked))
        for row, entry in enumerate(ranked):
            self._show_row(row, entry)

    def _frame_lines(self, found: FrameAgreement) -> list[str]:
        document = self._document
        lines = [f"Agreement JaC at {document.tau:g} px: {found.jac(document.tau):.3f}"]
        if found.mirrored_hint:
            lines.append("One of the two seems to label the field turned by 180 degrees.")
        for names, what in (
            (tuple(c.class_name for c in found.by_class.values() if c.apart), "Apart"),
            (found.only_a, "Only here"),
            (found.only_b, "Only there"),
        ):
            if names:
                titles = ", ".join(class_title(document.field, n) for n in names)
                lines.append(f"{what}: {titles}")
        beyond = sum(c.left_out for c in found.by_class.values() if not c.apart)
        if beyond:
            lines.append(f"{_count(beyond, 'click')} beyond the other's ends, left out")
        return lines

    def _show_row(self, row: int, entry: ClassAgreement) -> None:
        """One element: its name, two distances, and how many of its clicks were compared."""
        title = class_title(self._document.field, entry.class_name)
        compared = len(entry.distances)
        if entry.apart:
            texts, tip = (title, "apart", "apart"), _APART
        else:
            texts = (title, _px(entry.median), _px(entry.p95))
            tip = f"{_count(compared, 'click')} compared"
            if entry.left_out:
                tip += f", {entry.left_out} left out: beyond the ends of what the other clicked"
        points = f"{compared} of {compared + entry.left_out}" if entry.left_out else str(compared)
        for column, text in enumerate((*texts, points)):
            item = QTableWidgetItem(text)
            # A narrow panel cuts the name.
            item.setToolTip(f"{title}\n{tip}")
            if column == 0:
                item.setData(_CLASS, entry.class_name)
            else:
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            if entry.apart:
                font = item.font()
                font.setBold(True)
                item.setFont(font)
            self.table.setItem(row, column, item)

    def _forget_noise(self) -> None:
        if not self._document.second.is_open:
            if self._job is not None:
                self._job.cancel()
                self._job = None
            self._document.set_noise_floor(None)

    # --- the set --------------------------------------------------------------------------

    def _measure_set(self) -> None:
        """The noise floor over all frames that both annotated, in the background."""
        document = self._document
        workspace, second = document.workspace, document.second
        if self._job is not None:
            self._job.cancel()
        document.set_noise_floor(None)  # it may be that of another annotator
        if workspace is None:
            return
        field, size, tau = document.field, document.setup.size, document.tau
        names = [frame.name for frame in workspace.frames]
        read_other = second.reader()

        def work(control: JobControl) -> _MeasuredSet:
            sums = AgreementSums((tau,))
            errors: list[str] = []
            for index, name in enumerate(names):
                if control.cancelled:
                    break
                try:
                    other: FrameAnnotation | None = read_other(name)
                    mine = workspace.read(index) if other is not None else None
                except InputError as error:
                    errors.append(str(error))
                    continue
                if mine is not None and other is not None and mine.annotated:
                    sums.add(name, compare_annotations(mine, other, field, size))
            return _MeasuredSet(sums.summary(), tuple(errors))

        self._say_of_set("Measuring the set…")
        self._job = run_in_background(
            work, on_result=self._take_set, on_error=self._say_of_set, owner=self
        )

    def _take_set(self, measured: _MeasuredSet) -> None:
        self._job = None
        summary = measured.summary
        size = self._document.setup.size
        median, p95 = summary.overall.median, summary.overall.p95
        floor = None if median is None or p95 is None else (median, p95)
        if not summary.overall.common:
            text = "No element is annotated by both in any frame."
        elif floor is None:
            text = "Nothing to measure noise by: all elements annotated by both are apart."
        else:
            text = (
                f"Human noise over {_count(summary.frames, 'frame')}: median {floor[0]:.2f} px,"
                f" 95 % within {floor[1]:.2f} px (at {size[0]}x{size[1]})"
            )
        self._say_of_set(text, measured.errors)
        self._document.set_noise_floor(floor)

    def _say_of_set(self, text: str, errors: tuple[str, ...] = ()) -> None:
        """Put a line on the set; frames that could not be read follow it, their errors in a tip."""
        if errors:
            text += f"\n{_count(len(errors), 'frame')} unreadable, not compared"
        shown = list(errors[:_ERRORS_SHOWN])
        if len(errors) > len(shown):
            shown.append(f"and {len(errors) - len(shown)} more")
        self.noise.setText(text)
        self.noise.setToolTip("\n".join(shown))


def _count(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def _px(value: float | None) -> str:
    return "–" if value is None else f"{value:.2f} px"
