"""A small window on one field: its map and its elements, shown anew as its file is written."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QMainWindow, QSplitter, QStackedWidget, QWidget

from procc_annotator.errors import FieldError
from procc_annotator.field.load import load_field, with_dimensions
from procc_annotator.field.model import Field
from procc_annotator.field.validation import FieldWarning, WarningSeverity, validate_field
from procc_annotator.gui.messages import Bar
from procc_annotator.gui.panels.elements import ElementsPanel
from procc_annotator.gui.panels.field_map.field_map_panel import FieldMapPanel
from procc_annotator.gui.panels.widgets import empty_state, make_label, note_label, show_note, vbox
from procc_annotator.gui.settings import LANGUAGE, Settings, take_up
from procc_annotator.gui.state.background import LatestOnlyTask
from procc_annotator.gui.state.editing.outside_changes import FileWatch
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, tr_count

_SIZE = (980, 620)
_MOST_REMARKS = 8


@dataclass(frozen=True)
class _Read:
    """A field with its warnings, or the error in its description."""

    field: Field | None = None
    remarks: tuple[FieldWarning, ...] = ()
    problem: str = ""


class FieldPreview(QMainWindow):
    """Shows a field by name or from a file; the last good one stays while the file is broken."""

    def __init__(
        self,
        source: str | Path,
        dimensions: Mapping[str, float] | None = None,
        taken_keys: Mapping[str, str] | None = None,
    ) -> None:
        """Begin to read a source as `load_field` takes it, with the dimensions, metres by name,
        that are not nominal, and with keys that mean something else in the window, and what."""
        super().__init__()
        self.setObjectName("fieldPreview")
        self._source, self._dimensions = source, dict(dimensions or {})
        self._taken_keys = dict(taken_keys or {})
        self.services = Services(parent=self)
        self.services.live_fit.set_wanted(False)
        self.problem_bar = Bar("problemBar")
        self.map = FieldMapPanel(self.services)
        self.elements = ElementsPanel(self.services)
        self.facts = make_label(wrap=True)
        self.remarks = note_label("preview_remarks")
        self._assemble()
        self._reading = LatestOnlyTask(self, self.problem_bar.tell)
        self._watch = FileWatch(self, self.read)
        if Path(source).suffix.lower() == ".toml":
            self._watch.watch(Path(source).absolute())
        self.setWindowTitle(str(source))
        self.read()

    def read(self) -> None:
        """Read the description again, in the background."""
        source, dimensions, keys = self._source, self._dimensions, self._taken_keys
        self._reading.start(lambda _: _read(source, dimensions, keys), self._take)

    def closeEvent(self, event: QCloseEvent) -> None:
        self._watch.watch(None)
        self._reading.cancel()
        self.services.close()
        event.accept()

    def _assemble(self) -> None:
        nothing = empty_state(tr("There is no field to show yet."), "preview_empty")
        right = QWidget()
        vbox(self.facts, (self.elements, 1), self.remarks, of=right)
        both = QSplitter()
        both.addWidget(self.map)
        both.addWidget(right)
        both.setStretchFactor(0, 1)
        both.setSizes([_SIZE[0] - 340, 340])
        self.pages = QStackedWidget()
        self.pages.addWidget(nothing)
        self.pages.addWidget(both)
        centre = QWidget()
        vbox(self.problem_bar, (self.pages, 1), of=centre, margins=0)
        self.setCentralWidget(centre)
        self.resize(*_SIZE)

    def _take(self, read: _Read) -> None:
        self.problem_bar.tell(read.problem)
        if read.field is None:
            return
        self.services.evaluation.set_field(read.field, keep=False)
        self.pages.setCurrentIndex(1)
        name = Path(self._source).name
        self.setWindowTitle(f"{tr(read.field.title)} – {name}")
        self.facts.setText(_facts(read.field))
        remarks = [str(r) for r in read.remarks if r.severity is not WarningSeverity.NOTE]
        more = len(remarks) - _MOST_REMARKS
        shown = remarks[:_MOST_REMARKS] + ([tr("... and {n} more", n=more)] if more > 0 else [])
        show_note(self.remarks, "\n".join(shown))


def _read(
    source: str | Path, dimensions: Mapping[str, float], taken_keys: Mapping[str, str]
) -> _Read:
    try:
        field = load_field(source)
        field = with_dimensions(field, dimensions) if dimensions else field
    except FieldError as error:
        return _Read(problem=str(error))
    return _Read(field, validate_field(field, taken_keys))


def _facts(field: Field) -> str:
    turns = ", ".join(f"{math.degrees(s.turn_rad):.4g}°" for s in field.symmetries)
    lines = [
        tr_count(
            len(field.elements),
            "{n} element, symmetries: {turns}",
            "{n} elements, symmetries: {turns}",
            turns=turns or tr("none"),
        )
    ]
    for d in field.dimensions:
        if d.is_open:
            lines.append(
                tr("{dimension}: {value:.10g} m (the rules allow {least:g} to {most:g} m)",
                   dimension=tr(d.title), value=d.value, least=d.minimum, most=d.maximum)
            )  # fmt: skip
        elif d.name in ("length", "width"):
            lines.append(f"{tr(d.title)}: {d.value:.10g} m")
    return "\n".join(lines)


def run_preview(
    source: str | Path,
    dimensions: Mapping[str, float] | None = None,
    taken_keys: Mapping[str, str] | None = None,
) -> int:
    """Show the window until it is closed; returns the exit code. See `FieldPreview`."""
    from procc_annotator.gui.app import application, show_until_closed

    app = application()
    take_up(app, Settings().get(LANGUAGE))
    return show_until_closed(app, FieldPreview(source, dimensions, taken_keys))
