"""The dimensions of the dataset's field: entered, or found from all of its frames; and where on
its lines the clicks lie."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import (
    QWidget,
)

from procc_annotator.batch.joint_calibration import Estimate, estimate_dimensions
from procc_annotator.calibration.joint.field_dimensions import FittedDimension
from procc_annotator.field.load import stadium_of
from procc_annotator.field.markings import has_off_centre_markings
from procc_annotator.field.model import MEASURED_LINE
from procc_annotator.gui.commands.dialog_task import DialogTask
from procc_annotator.gui.commands.field.dimensions_dialog import FieldDimensionsDialog
from procc_annotator.gui.messages import as_sentence
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import JobControl
from procc_annotator.gui.writing import opened_frame
from procc_annotator.translation import tr, tr_count

_SETTLED_MS = 150  # after a change of a number, so that a held arrow does not score the set anew


class FieldDimensionsTask(DialogTask):
    """Slot of the action: asks, shows at once what is entered, and lets the dataset keep it."""

    dialog: FieldDimensionsDialog | None

    def __init__(self, document: Document, parent: QWidget) -> None:
        super().__init__(document, parent)
        self._before: dict[str, float] = {}
        self._lines_before = MEASURED_LINE
        self._field_name = ""
        self._settled = QTimer(self, singleShot=True, interval=_SETTLED_MS)
        self._settled.timeout.connect(lambda: self._use(keep=False))
        document.store.watch(select.field, self._leave_other_field)

    def ask(self) -> None:
        """Show the dialog; the picture behind it goes by what is entered."""
        document = self._document
        if opened_frame(document) is None:
            return
        is_open = any(d.is_open for d in document.state.field.dimensions)
        if not is_open and not has_off_centre_markings(document.state.field):
            title = tr(document.state.field.title)
            document.say(tr("the rules fix every dimension of the field {field}", field=title))
            return
        if self.dialog is not None:
            self.dialog.raise_()
        else:
            self._field_name = document.state.field.name
            self._before = {d.name: d.value for d in document.state.field.dimensions}
            self._lines_before = document.state.field.lines
            self.dialog = dialog = FieldDimensionsDialog(self._parent, document.state.field)
            dialog.chosen.connect(self._settled.start)
            dialog.estimateWanted.connect(self.estimate)
            dialog.stopWanted.connect(self.stop)
            dialog.accepted.connect(self._keep)
            dialog.rejected.connect(self._take_back)
        self.dialog.show()
        self.dialog.activateWindow()

    def estimate(self) -> None:
        """Find the dimensions from all frames without a stadium of their own, in the background."""
        document, dialog = self._document, self.dialog
        workspace = document.state.workspace
        if dialog is None or workspace is None or self._work.running:
            return
        revealed = document.state.revealed_frames  # what their cameras say may be known
        meant = {
            frame.name: partial(workspace.read, i)
            for i, frame in enumerate(workspace.frames)
            if stadium_of(document.state.field, frame.name) is None
        }
        read = {name: own for name, own in meant.items() if revealed is None or name in revealed}
        if meant and not read:
            dialog.tell(
                tr("Blind: the set is looked at once a frame of it is committed (Ctrl+Enter).")
            )
            return
        hidden = len(meant) - len(read)
        field, size = document.state.field, document.state.picture_size or document.state.setup.size
        # A homography knows no zoom that could be held against the field.
        model = document.live_fit.model if document.live_fit.model != "H" else "R"

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
        dialog, values = self.dialog, self._before | self.dialog.values
        self._document.field_choice.resize(values, lines=dialog.lines, keep=keep)

    def _keep(self) -> None:
        self._use(keep=True)
        self._leave()

    def _take_back(self) -> None:
        self._leave()
        choice = self._document.field_choice
        choice.resize(self._before, lines=self._lines_before, keep=False)

    def _leave_other_field(self) -> None:
        """Another sport was chosen: the numbers were meant for the one before."""
        if self.dialog is not None and self._document.state.field.name != self._field_name:
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
