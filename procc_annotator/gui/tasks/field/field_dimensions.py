"""The dimensions of the dataset's field: entered, or found from all of its frames; and where on
its lines the clicks lie."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from html import escape

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.field.dimensions import Dimension, broken_relation
from procc_annotator.field.model import MEASURED, MIDDLE, Field
from procc_annotator.field.painted_middle import can_be_at_middle
from procc_annotator.fit.together.stadium import DEFAULT_NAMES, FittedDimension
from procc_annotator.gui.decimal_box import RangeBox
from procc_annotator.gui.panels.common import note_label, show_note
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.interact.hints import counted
from procc_annotator.session.runs.dimension_estimate import Estimate, estimate_dimensions

_SETTLED_MS = 150  # after a change of a number, so that a held arrow does not score the set anew
_WIDTH = 440
_OWN = (
    "Scores then differ from those of the nominal field ({nominal}), as official evaluations take"
    " it; they name the dimensions they were computed with."
)
_AT_MIDDLE = (
    "Scores then differ from those of official evaluations, which take lines where the rules"
    " measure them; they say so."
)
_LINES = ((MEASURED, "where the rules measure"), (MIDDLE, "the middle of the paint"))
_LINES_TIP = (
    "Rules measure many lines at an edge of their paint. Clicks are put on its middle, half the"
    " paint's width away: choose it where that matters, as in halls and near the camera."
)
_FIXED_SIDES = "Only length and width are found from frames, and the rules fix those of this field"
_FINEST = 4  # decimals of a metre


class FieldDimensionsDialog(QDialog):
    """A number a dimension, and what the set says of them; shows nothing but what it is told."""

    chosen = Signal()  # other numbers, or lines elsewhere
    estimateWanted = Signal()
    stopWanted = Signal()

    def __init__(self, parent: QWidget, field: Field) -> None:
        super().__init__(parent)
        self.setObjectName("fieldDimensionsDialog")
        self.setWindowTitle(f"Field dimensions: {field.title}")
        self.setMinimumWidth(_WIDTH)
        self._field = field
        self._dimensions = [d for d in field.dimensions if d.is_open]
        self.boxes: dict[str, RangeBox] = {}
        self.rules: dict[str, QLabel] = {}
        self._refused: set[str] = set()  # numbers out of the rules that nobody has looked at yet
        form = QFormLayout()
        for dimension in self._dimensions:
            box = self.boxes[dimension.name] = _box(dimension)
            box.valueChanged.connect(self._changed)
            box.refused.connect(partial(self._tell_refused, dimension))
            box.lineEdit().textEdited.connect(partial(self._tell_rule, dimension))
            row = QHBoxLayout()
            row.addWidget(box)
            rule = self.rules[dimension.name] = QLabel()
            self._tell_rule(dimension)
            row.addWidget(rule)
            row.addStretch(1)
            form.addRow(f"{dimension.title}:", row)
        widest = max((box.sizeHint().width() for box in self.boxes.values()), default=0)
        for box in self.boxes.values():  # what the rules say of each stands in a column
            box.setMinimumWidth(widest)
        self.broken = note_label("dimensions_broken")
        self.lines_box = QComboBox()
        self.lines_box.setObjectName("dimensions_lines")
        self.lines_box.setToolTip(_LINES_TIP)
        for lines, words in _LINES:
            self.lines_box.addItem(words, lines)
        self.lines_box.setCurrentIndex(self.lines_box.findData(field.lines))
        self.lines_box.currentIndexChanged.connect(self._changed)
        if can_be_at_middle(field):
            form.addRow("Clicks lie on:", self.lines_box)
        else:
            self.lines_box.setParent(self)
            self.lines_box.hide()
        self.note = note_label("dimensions_note")
        self.estimate_button = QPushButton("Estimate from this set")
        self.estimate_button.setAutoDefault(False)
        self.estimate_button.clicked.connect(self._estimate)
        if not any(d.name in DEFAULT_NAMES for d in self._dimensions):
            self.estimate_button.setEnabled(False)
            self.estimate_button.setToolTip(_FIXED_SIDES)
        self.bar = QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.hide()
        self.found = note_label("dimensions_found")
        self._running = False
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addWidget(self.broken)
        layout.addWidget(self.note)
        row = QHBoxLayout()
        row.addWidget(self.estimate_button)
        row.addWidget(self.bar, 1)
        row.addStretch(0)
        layout.addLayout(row)
        layout.addWidget(self.found)
        layout.addStretch(1)
        layout.addWidget(self._buttons())
        self._tell_official()

    @property
    def values(self) -> dict[str, float]:
        """The numbers, metres."""
        return {name: round(box.value(), box.decimals()) for name, box in self.boxes.items()}

    @property
    def breaks_a_rule(self) -> bool:
        """Whether the rules do not allow the numbers together."""
        return bool(self.broken.text())

    @property
    def lines(self) -> str:
        """Where the clicks lie, one of `LINES`."""
        return str(self.lines_box.currentData())

    def set_values(self, values: Mapping[str, float]) -> None:
        """Show other numbers, as if they were entered together."""
        for name, value in values.items():
            box = self.boxes[name]
            blocked = box.blockSignals(True)
            box.setValue(value)
            box.blockSignals(blocked)
        for dimension in self._dimensions:
            if dimension.name in values:
                self._tell_rule(dimension)
        self._changed()

    def set_running(self, running: bool) -> None:
        """While the set is looked at the button stops that."""
        self._running = running
        self.estimate_button.setText("Stop" if running else "Estimate from this set")
        self.bar.setVisible(running)
        self.bar.setRange(0, 0)

    def advance(self, done: int, total: int) -> None:
        """Show how far the work is."""
        self.bar.setRange(0, total)
        self.bar.setValue(done)

    def tell(self, text: str) -> None:
        """Say what came of it."""
        show_note(self.found, text)
        self.adjustSize()

    def _buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        keep = buttons.addButton("Keep for this dataset", QDialogButtonBox.ButtonRole.AcceptRole)
        buttons.button(QDialogButtonBox.StandardButton.Cancel).setAutoDefault(False)
        keep.setDefault(True)  # or Enter would cancel
        self.nominal_button = buttons.addButton("Nominal", QDialogButtonBox.ButtonRole.ResetRole)
        self.nominal_button.setToolTip("The field as official evaluations take it")
        self.nominal_button.setAutoDefault(False)
        self.nominal_button.clicked.connect(self._set_nominal)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        return buttons

    def accept(self) -> None:
        """Closes, unless a number was just refused or the rules do not allow them together: that is
        to be seen first."""
        for box in self.boxes.values():
            box.interpretText()
        if not self._refused and not self.breaks_a_rule:
            super().accept()
        self._refused.clear()

    def _set_nominal(self) -> None:
        blocked = self.lines_box.blockSignals(True)
        self.lines_box.setCurrentIndex(self.lines_box.findData(MEASURED))
        self.lines_box.blockSignals(blocked)
        self.set_values({d.name: d.nominal for d in self._dimensions})

    def _tell_rule(self, dimension: Dimension, _text: str = "") -> None:
        d, label = dimension, self.rules[dimension.name]
        label.setText(f"nominal {d.nominal:g} m, the rules allow {d.minimum:g} to {d.maximum:g} m")
        label.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self._refused.discard(d.name)

    def _tell_refused(self, dimension: Dimension, number: float) -> None:
        d, label = dimension, self.rules[dimension.name]
        label.setText(f"<b>not {number:g} m: the rules allow {d.minimum:g} to {d.maximum:g} m</b>")
        label.setForegroundRole(QPalette.ColorRole.WindowText)
        self._refused.add(d.name)

    def _changed(self) -> None:
        self._tell_official()
        self._tell_broken()
        self.chosen.emit()

    def _tell_broken(self) -> None:
        values = {d.name: d.value for d in self._field.dimensions} | self.values
        broken = broken_relation(self._field.relations, values)
        show_note(self.broken, f"<b>{escape(broken[:1].upper() + broken[1:])}</b>" * bool(broken))

    def _tell_official(self) -> None:
        own = any(self.values[d.name] != d.nominal for d in self._dimensions)
        nominal = ", ".join(f"{d.title.lower()} {d.nominal:g} m" for d in self._dimensions)
        notes = [_OWN.format(nominal=nominal)] if own else []
        if self.lines == MIDDLE:
            notes.append(_AT_MIDDLE)
        show_note(self.note, "\n".join(notes))

    def _estimate(self) -> None:
        (self.stopWanted if self._running else self.estimateWanted).emit()


class FieldDimensionsTask(QObject):
    """Slot of the action: asks, shows at once what is entered, and lets the dataset keep it."""

    def __init__(self, document: Document, parent: QWidget) -> None:
        super().__init__(parent)
        self._document = document
        self._parent = parent
        self._job: Job | None = None
        self._before: dict[str, float] = {}
        self._lines_before = MEASURED
        self._field_name = ""
        self._settled = QTimer(self, singleShot=True, interval=_SETTLED_MS)
        self._settled.timeout.connect(lambda: self._use(keep=False))
        self.dialog: FieldDimensionsDialog | None = None
        document.datasetChanged.connect(self._close)
        document.fieldChanged.connect(self._leave_other_field)

    def ask(self) -> None:
        """Show the dialog; the picture behind it goes by what is entered."""
        document = self._document
        if document.frame is None:
            document.say("open a folder of pictures first", "warning")
            return
        is_open = any(d.is_open for d in document.field.dimensions)
        if not is_open and not can_be_at_middle(document.field):
            title = document.field.title
            document.say(f"the rules fix every dimension of the field {title}")
            return
        if self.dialog is not None:
            self.dialog.raise_()
        else:
            self._field_name = document.field.name
            self._before = {d.name: d.value for d in document.field.dimensions}
            self._lines_before = document.field.lines
            self.dialog = dialog = FieldDimensionsDialog(self._parent, document.field)
            dialog.chosen.connect(self._settled.start)
            dialog.estimateWanted.connect(self.estimate)
            dialog.stopWanted.connect(self.stop)
            dialog.accepted.connect(self._keep)
            dialog.rejected.connect(self._take_back)
        self.dialog.show()
        self.dialog.activateWindow()

    def estimate(self) -> None:
        """Find the dimensions from all frames, in the background."""
        document, dialog = self._document, self.dialog
        workspace = document.workspace
        if dialog is None or workspace is None or self._job is not None:
            return
        revealed = document.revealed_frames  # what their cameras say may be known
        read = {
            frame.name: partial(workspace.read, i)
            for i, frame in enumerate(workspace.frames)
            if revealed is None or frame.name in revealed
        }
        if not read:
            dialog.tell("Blind: the set is looked at once a frame of it is committed (Ctrl+Enter).")
            return
        hidden = len(workspace.frames) - len(read)
        field, size = document.field, document.picture_size or document.setup.size
        # A homography knows no zoom that could be held against the field.
        model = document.live_fit.model if document.live_fit.model != "H" else "R"

        def work(control: JobControl) -> Estimate:
            return estimate_dimensions(
                read, field, size=size, model=model, progress=control.progress_or_stop
            )

        dialog.set_running(True)
        dialog.tell("")
        self._job = run_in_background(
            work,
            on_result=lambda found: self._found(found, hidden),
            on_error=self._failed,
            on_progress=dialog.advance,
            owner=self,
        )

    def stop(self) -> None:
        """Leave the estimate."""
        if self._job is not None:
            self._job.cancel()
            self._job = None
        if self.dialog is not None:
            self.dialog.set_running(False)

    # --- inside ---

    def _found(self, estimate: Estimate, hidden: int) -> None:
        self.stop()
        if self.dialog is not None:
            self.dialog.tell(_in_words(estimate, hidden))
            self.dialog.set_values(estimate.stadium.values)

    def _failed(self, text: str) -> None:
        self.stop()
        if self.dialog is not None:
            self.dialog.tell(f"{text[0].upper()}{text[1:]}.")

    def _use(self, *, keep: bool) -> None:
        self._settled.stop()
        if self.dialog is None or self.dialog.breaks_a_rule:  # the field stays as it was
            return
        dialog, values = self.dialog, self._before | self.dialog.values
        self._document.field_choice.resize(values, lines=dialog.lines, keep=keep)

    def _keep(self) -> None:
        self._use(keep=True)
        self._close()

    def _take_back(self) -> None:
        self._close()
        choice = self._document.field_choice
        choice.resize(self._before, lines=self._lines_before, keep=False)

    def _leave_other_field(self) -> None:
        """Another sport was chosen: the numbers were meant for the one before."""
        if self.dialog is not None and self._document.field.name != self._field_name:
            self._close()

    def _close(self) -> None:
        """Also when another dataset was opened: what was entered was meant for the one before."""
        self.stop()
        self._settled.stop()
        dialog, self.dialog = self.dialog, None
        if dialog is not None:
            dialog.blockSignals(True)
            dialog.close()
            dialog.deleteLater()


def _box(dimension: Dimension) -> RangeBox:
    box = RangeBox()
    box.setObjectName(f"dimension_{dimension.name}")
    box.setDecimals(_decimals(dimension))
    box.setSingleStep(_step(dimension))
    box.setRange(dimension.minimum, dimension.maximum)
    box.setSuffix(" m")
    box.setValue(dimension.value)
    box.setAccessibleName(dimension.title)
    return box


def _decimals(dimension: Dimension) -> int:
    """As many as its numbers need, centimetres at least."""
    numbers = dimension.minimum, dimension.nominal, dimension.maximum, dimension.value
    enough = (n for n in range(2, _FINEST) if all(abs(v - round(v, n)) < 1e-9 for v in numbers))
    return next(enough, _FINEST)


def _step(dimension: Dimension) -> float:
    """What an arrow adds: so that the range is some tens of steps."""
    steps = (0.1, 0.05, 0.01, 0.005, 0.001)
    reach = dimension.maximum - dimension.minimum
    return float(next((step for step in steps if reach >= 10 * step), 10.0**-_FINEST))


def _in_words(estimate: Estimate, hidden: int) -> str:
    """What came of it; ``hidden``: frames that blind mode kept out."""
    stadium = estimate.stadium
    lines = [_line(d) for d in stadium.dimensions]
    lines.append(
        f"From the cameras of {counted(stadium.frames, 'frame')}; ± is one standard deviation."
    )
    if stadium.doubt:
        lines.append(f"{stadium.doubt[:1].upper()}{stadium.doubt[1:]}")
    if hidden:
        lines.append(f"Blind: frames that are not committed took no part ({hidden}).")
    if estimate.unreadable:
        lines.append(f"Frames that cannot be read took no part: {len(estimate.unreadable)}.")
    return "\n".join(lines)


def _line(found: FittedDimension) -> str:
    d = found.dimension
    remark = f"{found.remark[:1].upper()}{found.remark[1:]}"
    if not found.is_determined:
        return f"{remark}; it stays as it was."
    told = counted(found.frames, "frame")
    line = f"{d.title}: {d.value:.2f} ± {found.sd_m:.2f} m, told by {told}."
    return f"{line} {remark}" if remark else line
