"""The dimensions of the dataset's field: entered, or found from all of its frames; and where on
its lines the clicks lie.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from html import escape
from typing import Any

from PySide6.QtCore import QSignalBlocker, Qt, QTimer, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import (
    QComboBox,
    QDialogButtonBox,
    QFormLayout,
    QLabel,
    QPushButton,
    QWidget,
)

from procc_annotator.batch.joint_calibration import Estimate, estimate_dimensions
from procc_annotator.calibration.joint.field_dimensions import DEFAULT_DIMENSIONS, FittedDimension
from procc_annotator.field.dimensions import Dimension, violated_relation
from procc_annotator.field.load import stadium_of
from procc_annotator.field.markings import has_off_centre_markings
from procc_annotator.field.model import MEASURED_LINE, MIDDLE_LINE, Field
from procc_annotator.gui.commands.dialogs import DialogTask, TaskDialog, dialog_buttons
from procc_annotator.gui.messages import opened_frame
from procc_annotator.gui.panels.widgets import RangeBox, hbox, named, note_label, show_note, vbox
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.availability import as_sentence
from procc_annotator.gui.state.background import JobControl
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, tr_count, word

_WIDTH = 440
_OWN = word(
    "Scores then differ from those of the nominal field ({nominal}), as official evaluations take"
    " it; they name the dimensions they were computed with."
)
_STADIUMS = word(
    "Dimensions of their own (stadiums.csv): {frames} of {stadiums}. What is entered here is"
    " for all others, and for what stadiums leave open."
)
_AT_MIDDLE = word(
    "Scores then differ from those of official evaluations, which take lines where the rules"
    " measure them; they say so."
)
_LINES = (
    (MEASURED_LINE, word("where the rules measure")),
    (MIDDLE_LINE, word("the middle of the paint")),
)
_LINES_TIP = word(
    "Rules measure many lines at an edge of their paint. Clicks are put on its middle, half the"
    " paint's width away: choose it where that matters, as in halls and near the camera."
)
_FIXED_SIDES = word(
    "Only length and width are found from frames, and the rules fix those of this field"
)
_FINEST = 4  # decimals of a metre


class FieldDimensionsDialog(TaskDialog):
    """A number a dimension, and what the set says of them; shows nothing but what it is
    reported."""

    chosen = Signal()  # other numbers, or lines elsewhere

    def __init__(self, parent: QWidget, field: Field) -> None:
        title = tr("Field dimensions: {field}", field=tr(field.title))
        super().__init__(parent, "fieldDimensionsDialog", title)
        self.field = field
        self._dimensions = [d for d in field.dimensions if d.is_open]
        self.boxes: dict[str, RangeBox] = {}
        self.rules: dict[str, QLabel] = {}
        self._broken = ""
        self._refused: set[str] = set()  # numbers out of the rules that nobody has looked at yet
        self.bar.setTextVisible(False)
        self.estimate_button = QPushButton(tr("Estimate from this set"), autoDefault=False)
        if not any(d.name in DEFAULT_DIMENSIONS for d in self._dimensions):
            self.estimate_button.setEnabled(False)
            self.estimate_button.setToolTip(tr(_FIXED_SIDES))
        self.broken = note_label("dimensions_broken")
        self.broken.setTextFormat(Qt.TextFormat.RichText)
        self.note = note_label("dimensions_note")
        self.found = note_label("dimensions_found")
        estimating = hbox(self.estimate_button, (self.bar, 1), (None, 0))
        above = (self._form(), self.broken, self.note, estimating, self.found)
        vbox(*above, None, self._buttons(), of=self)
        self._tell_official()
        self.setMinimumWidth(max(_WIDTH, self.minimumSizeHint().width()))

    def _form(self) -> QFormLayout:
        form = QFormLayout()
        for dimension in self._dimensions:
            box = self.boxes[dimension.name] = _box(dimension)
            box.valueChanged.connect(self._changed)
            box.refused.connect(partial(self._tell_rule, dimension))
            box.lineEdit().textEdited.connect(lambda _, d=dimension: self._tell_rule(d))
            rule = self.rules[dimension.name] = QLabel(textFormat=Qt.TextFormat.RichText)
            self._tell_rule(dimension)
            form.addRow(f"{tr(dimension.title)}:", hbox(box, rule, None))
        widest = max((box.sizeHint().width() for box in self.boxes.values()), default=0)
        for box in self.boxes.values():  # what the rules say of each stands in a column
            box.setMinimumWidth(widest)
        self.lines_box = named(QComboBox(), "dimensions_lines", tip=tr(_LINES_TIP))
        for lines, words in _LINES:
            self.lines_box.addItem(tr(words), lines)
        self.lines_box.setCurrentIndex(self.lines_box.findData(self.field.lines))
        self.lines_box.currentIndexChanged.connect(self._changed)
        form.addRow(tr("Clicks lie on:"), self.lines_box)
        form.setRowVisible(self.lines_box, has_off_centre_markings(self.field))
        return form

    @property
    def values(self) -> dict[str, float]:
        """The numbers, metres."""
        return {name: round(box.value(), box.decimals()) for name, box in self.boxes.items()}

    @property
    def breaks_a_rule(self) -> bool:
        """Return whether the rules do not allow the numbers together."""
        return bool(self._broken)

    @property
    def lines(self) -> str:
        """Return where the clicks lie, one of `LINES`."""
        return str(self.lines_box.currentData())

    def set_values(self, values: Mapping[str, float]) -> None:
        """Show other numbers, as if they were entered together."""
        for name, value in values.items():
            with QSignalBlocker(self.boxes[name]):
                self.boxes[name].setValue(value)
        for dimension in self._dimensions:
            if dimension.name in values:
                self._tell_rule(dimension)
        self._changed()

    def set_running(self, running: bool) -> None:
        """While the set is examined the button stops that."""
        super().set_running(running)
        self.estimate_button.setText(tr("Stop") if running else tr("Estimate from this set"))

    def tell(self, text: str) -> None:
        show_note(self.found, text)
        self.adjustSize()

    def _buttons(self) -> QDialogButtonBox:
        buttons, _ = dialog_buttons(self, tr("Keep for this dataset"))
        self.nominal_button = buttons.addButton(
            tr("Nominal"), QDialogButtonBox.ButtonRole.ResetRole
        )
        self.nominal_button.setToolTip(tr("The field as official evaluations take it"))
        self.nominal_button.setAutoDefault(False)
        self.nominal_button.clicked.connect(self._set_nominal)
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
        with QSignalBlocker(self.lines_box):
            self.lines_box.setCurrentIndex(self.lines_box.findData(MEASURED_LINE))
        self.set_values({d.name: d.nominal for d in self._dimensions})

    def _tell_rule(self, dimension: Dimension, refused: float | None = None) -> None:
        """Show what the rules allow, and that they do not allow a number."""
        name, label = dimension.name, self.rules[dimension.name]
        limits: dict[str, Any] = {"minimum": dimension.minimum, "maximum": dimension.maximum}
        if refused is None:
            words = tr(
                "nominal {nominal:g} m, the rules allow {minimum:g} to {maximum:g} m",
                nominal=dimension.nominal,
                **limits,
            )
            label.setForegroundRole(QPalette.ColorRole.PlaceholderText)
            self._refused.discard(name)
        else:
            words = tr(
                "<b>not {number:g} m: the rules allow {minimum:g} to {maximum:g} m</b>",
                number=refused,
                **limits,
            )
            label.setForegroundRole(QPalette.ColorRole.WindowText)
            self._refused.add(name)
        label.setText(words)

    def _changed(self) -> None:
        self._tell_official()
        self._tell_broken()
        self.chosen.emit()

    def _tell_broken(self) -> None:
        values = _values(self.field) | self.values
        self._broken = violated_relation(self.field.relations, values)
        told = self._broken[:1].upper() + self._broken[1:]
        show_note(self.broken, f"<b>{escape(told)}</b>" if told else "")

    def _tell_official(self) -> None:
        own = any(self.values[d.name] != d.nominal for d in self._dimensions)
        nominal = ", ".join(f"{_within(d)} {d.nominal:g} m" for d in self._dimensions)
        notes = [tr(_OWN, nominal=nominal)] if own else []
        if self.lines == MIDDLE_LINE:
            notes.append(tr(_AT_MIDDLE))
        if (stadiums := self.field.stadiums) is not None:
            frames = tr_count(len(stadiums.frames), "{n} frame", "{n} frames")
            known = tr_count(len(stadiums.dimensions), "{n} stadium", "{n} stadiums")
            notes.append(tr(_STADIUMS, frames=frames, stadiums=known))
        show_note(self.note, "\n".join(notes))


def _values(field: Field) -> dict[str, float]:
    return {d.name: d.value for d in field.dimensions}


def _within(dimension: Dimension) -> str:
    """Its title within a sentence; only English is known to write it small there."""
    title = tr(dimension.title)
    return title.lower() if title == dimension.title else title


def _box(dimension: Dimension) -> RangeBox:
    least, most, step = dimension.minimum, dimension.maximum, _step(dimension)
    box = RangeBox(least, most, step, " m", decimals=_decimals(dimension))
    box.setObjectName(f"dimension_{dimension.name}")
    box.setValue(dimension.value)
    box.setAccessibleName(tr(dimension.title))
    return box


def _decimals(dimension: Dimension) -> int:
    """As many as its numbers need, centimetres at least."""
    numbers = dimension.minimum, dimension.nominal, dimension.maximum, dimension.value
    enough = (n for n in range(2, _FINEST) if all(abs(v - round(v, n)) < 1e-9 for v in numbers))
    return next(enough, _FINEST)


def _step(dimension: Dimension) -> float:
    """Return what an arrow adds: so that the range is some tens of steps."""
    steps = (0.1, 0.05, 0.01, 0.005, 0.001)
    reach = dimension.maximum - dimension.minimum
    return float(next((step for step in steps if reach >= 10 * step), 10.0**-_FINEST))


_SETTLED_MS = 150  # after a change of a number, so that a held arrow does not score the set anew


class FieldDimensionsTask(DialogTask):
    """Slot of the action: asks, shows at once what is entered, and lets the dataset keep it."""

    dialog: FieldDimensionsDialog | None

    def __init__(self, services: Services, parent: QWidget) -> None:
        super().__init__(services, parent)
        self._settled = QTimer(self, singleShot=True, interval=_SETTLED_MS)
        self._settled.timeout.connect(lambda: self._use(keep=False))
        services.store.watch(select.field, self._leave_other_field)

    def ask(self) -> None:
        """Show the dialog; the picture behind it goes by what is entered."""
        services = self._services
        if opened_frame(services) is None:
            return
        is_open = any(d.is_open for d in services.state.field.dimensions)
        if not is_open and not has_off_centre_markings(services.state.field):
            title = tr(services.state.field.title)
            services.say(tr("the rules fix every dimension of the field {field}", field=title))
            return
        if self.dialog is not None:
            self.dialog.raise_()
        else:
            self.dialog = dialog = FieldDimensionsDialog(self._parent, services.state.field)
            dialog.chosen.connect(self._settled.start)
            dialog.estimate_button.clicked.connect(self._toggle)
            dialog.accepted.connect(self._keep)
            dialog.rejected.connect(partial(self._take_back, dialog.field))
        self.dialog.show()
        self.dialog.activateWindow()

    def _toggle(self) -> None:
        if self._work.running:
            self.stop()
        else:
            self.estimate()

    def estimate(self) -> None:
        """Find the dimensions from all frames without a stadium of their own, in the background."""
        services, dialog = self._services, self.dialog
        workspace = services.state.workspace
        if dialog is None or workspace is None:
            return
        revealed = services.state.revealed_frames  # what their cameras say may be known
        meant = {
            frame.name: partial(workspace.read, i)
            for i, frame in enumerate(workspace.frames)
            if stadium_of(services.state.field, frame.name) is None
        }
        read = {name: own for name, own in meant.items() if revealed is None or name in revealed}
        if meant and not read:
            dialog.tell(
                tr("Blind: the set is checked once one of its frames is committed (Ctrl+Enter).")
            )
            return
        hidden = len(meant) - len(read)
        field, size = services.state.field, services.state.picture_size or services.state.setup.size
        # A homography knows no zoom that could be held against the field.
        model = services.live_fit.model if services.live_fit.model != "H" else "R"

        def work(control: JobControl) -> Estimate:
            return estimate_dimensions(
                read, field, size=size, model=model, progress=control.progress_or_stop
            )

        dialog.set_running(True)
        dialog.tell("")
        self._work.start(work, lambda found: self._found(found, hidden), progress=dialog.advance)

    def stop(self) -> None:
        """Leave the estimate."""
        self._work.cancel()
        if self.dialog is not None:
            self.dialog.set_running(False)

    # --- inside ---

    def _found(self, estimate: Estimate, hidden: int) -> None:
        self.stop()
        if self.dialog is not None:
            self.dialog.tell(_in_words(estimate, hidden))
            self.dialog.set_values(estimate.stadium.values)

    def _fail(self, text: str) -> None:
        super()._fail(as_sentence(text))

    def _use(self, *, keep: bool) -> None:
        self._settled.stop()
        if self.dialog is None or self.dialog.breaks_a_rule:  # the field stays as it was
            return
        dialog, values = self.dialog, _values(self.dialog.field) | self.dialog.values
        self._services.field_choice.resize(values, lines=dialog.lines, keep=keep)

    def _keep(self) -> None:
        self._use(keep=True)
        self._leave()

    def _take_back(self, before: Field) -> None:
        self._leave()
        self._services.field_choice.resize(_values(before), lines=before.lines, keep=False)

    def _leave_other_field(self) -> None:
        """Another sport was chosen: the numbers were meant for the one before."""
        if self.dialog is not None and self._services.state.field.name != self.dialog.field.name:
            self._leave()

    def _leave(self) -> None:
        self._settled.stop()
        super()._leave()


def _in_words(estimate: Estimate, hidden: int) -> str:
    """Return what came of it; ``hidden``: frames that blind mode kept out."""
    stadium = estimate.stadium
    lines = [_line(d) for d in stadium.dimensions]
    lines.append(
        tr_count(
            stadium.frames,
            "From the cameras of {n} frame; ± is one standard deviation.",
            "From the cameras of {n} frames; ± is one standard deviation.",
        )
    )
    if stadium.doubt:
        lines.append(f"{stadium.doubt[:1].upper()}{stadium.doubt[1:]}")
    if hidden:
        lines.append(tr("Blind: frames that are not committed took no part ({n}).", n=hidden))
    if estimate.unreadable:
        count = len(estimate.unreadable)
        lines.append(tr("Frames that cannot be read took no part: {n}.", n=count))
    return "\n".join(lines)


def _line(found: FittedDimension) -> str:
    d = found.dimension
    remark = f"{found.remark[:1].upper()}{found.remark[1:]}"
    if not found.is_determined:
        return tr("{remark}; it stays as it was.", remark=remark)
    line = tr_count(
        found.frames,
        "{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frame.",
        "{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames.",
        dimension=tr(d.title),
        value=d.value,
        sd=found.sd_m,
    )
    return f"{line} {remark}" if remark else line
