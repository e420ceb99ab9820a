"""Dialogs of import and export: place, format, names of labels, the report."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QSize, QStringListModel, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFileDialog,
    QFormLayout,
    QFrame,
    QGridLayout,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QRadioButton,
    QScrollArea,
    QSizePolicy,
    QWidget,
)

from procc_annotator.assist.label_proposal import LabelProposal, order_choices, rule_words
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import LABELS_FILE, Rule
from procc_annotator.formats.annotations.registry import FORMATS, WRITTEN, AnnotationFormat
from procc_annotator.gui.commands.dialogs import CLOSE, NamedDialog, TaskDialog, dialog_buttons
from procc_annotator.gui.panels import widgets
from procc_annotator.translation import tr, tr_count, word

_SIZE = (960, 480)
_HEADERS = (word("Label"), word("Shapes"), word("Stands for"), "", word("Why"))
_AS_IT_IS = word("? (stays as it is, an unknown class)")
_LEFT_OUT = word("Leave out")
_SURETIES = {
    "sure": word("sure", "a proposal"),
    "likely": word("likely", "a proposal"),
    "open": word("to be said", "a proposal"),
}
_LONGEST = 40  # characters of a label that are shown


class LabelDialog(NamedDialog):
    """One row a label: what it is proposed to stand for, how surely and why, to be changed."""

    def __init__(
        self,
        parent: QWidget,
        proposals: Sequence[LabelProposal],
        field: Field,
        *,
        better: str = "",
        has_file: bool = False,
    ) -> None:
        """Show what is proposed for labels that are no class; what is open stays an unknown class
        unless a person says more.

        Args:
            better: title of a field whose classes are called more like the labels; may be empty.
            has_file: whether the dataset has a ``labels.toml`` already.
        """
        super().__init__(parent, "labelDialog", tr("Names of another program"))
        self._proposals = proposals
        self.choices: list[QComboBox] = []
        self._rules: list[tuple[Rule, ...]] = []
        asked = QLabel(_asked(len(proposals), field), wordWrap=True)
        self.note = widgets.note_label("labelNote")
        words = tr(
            "These names are more like those of {field}: choose that field first (File > Field).",
            field=tr(better) if better else "",
        )
        widgets.show_note(self.note, words if better else "")
        self.keep = QCheckBox(tr("Keep these names with the dataset ({file})", file=LABELS_FILE))
        if has_file:
            self.keep.setText(
                tr("Add these names to the dataset's {file}, written anew", file=LABELS_FILE)
            )
        self.keep.setChecked(not has_file)
        buttons, self.take = dialog_buttons(self, tr("Import"))
        widgets.vbox(asked, self.note, (self._table(field), 1), self.keep, buttons, of=self)
        self.resize(*_SIZE)
        if self.choices:
            self.choices[0].setFocus()

    @property
    def rules(self) -> dict[str, Rule]:
        """Return what was chosen, by label; labels that stay as they are are missing."""
        chosen = zip(self._proposals, self.choices, self._rules, strict=True)
        return {
            one.count.label: rules[box.currentIndex() - 1]
            for one, box, rules in chosen
            if box.currentIndex() > 0
        }

    def _table(self, field: Field) -> QScrollArea:
        inside = QWidget()
        grid = QGridLayout(inside)
        for column, header in enumerate(_HEADERS):
            title = f"<b>{tr(header)}</b>" if header else ""
            grid.addWidget(QLabel(title, textFormat=Qt.TextFormat.RichText), 0, column)
        names = [e.name for e in field.elements]
        titles = [tr(field.title_of(name)) for name in names]
        self._titles = QStringListModel([tr(_AS_IT_IS), tr(_LEFT_OUT), *titles], self)
        for row, one in enumerate(self._proposals, start=1):
            box = self._choice(one, names, titles, field)
            shown = one.count.label
            shown = shown if len(shown) <= _LONGEST else f"{shown[: _LONGEST - 1]}…"
            like = ", ".join(tr(field.title_of(name)) for name in one.like)
            reason = f"{one.why}: {like}" if like else one.why
            why = _text(reason, reason)
            why.setWordWrap(True)
            cells = (
                _text(shown, one.count.label), _text(str(one.count.shapes)), box,
                _text(tr(_SURETIES[one.surety], "a proposal")), why,
            )  # fmt: skip
            for column, cell in enumerate(cells):
                grid.addWidget(cell, row, column, Qt.AlignmentFlag.AlignVCenter)
        grid.setRowStretch(len(self._proposals) + 1, 1)
        grid.setColumnStretch(len(_HEADERS) - 1, 1)
        area = QScrollArea(widgetResizable=True)
        area.setObjectName("labelTable")
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setWidget(inside)
        return area

    def _choice(
        self, one: LabelProposal, names: list[str], titles: list[str], field: Field
    ) -> QComboBox:
        orders = order_choices(one)
        rules = (None, *orders, *names)  # after the entry that leaves the label as it is
        box = QComboBox()
        box.setAccessibleName(tr("What {label} stands for", label=one.count.label))
        if orders:
            words = [rule_words(rule, field) for rule in orders]
            box.addItems([tr(_AS_IT_IS), tr(_LEFT_OUT), *words, *titles])
        else:  # most labels: one list for all of them
            box.setModel(self._titles)
        box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        box.setMinimumContentsLength(_LONGEST)
        box.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        if one.surety != "open":
            box.setCurrentIndex(1 + rules.index(one.rule))
        box.setToolTip(box.currentText())
        box.currentTextChanged.connect(box.setToolTip)
        self.choices.append(box)
        self._rules.append(rules)
        return box


def _text(text: str, tip: str = "") -> QLabel:
    return widgets.named(QLabel(text, textFormat=Qt.TextFormat.PlainText), tip=tip)


def _asked(count: int, field: Field) -> str:
    return tr_count(
        count,
        "{n} label is no class of {field}. Say what they stand for; what is proposed was"
        " told by their words, and by which elements their shapes lie on.",
        "{n} labels are no class of {field}. Say what they stand for; what is proposed was"
        " told by their words, and by which elements their shapes lie on.",
        field=tr(field.title),
    )


_WIDTH = 560
_WIDEST_LINE = 200.0


class _ExchangeDialog(TaskDialog):
    """A form, the progress of the work, and a report of it."""

    cancelled = Signal()

    def __init__(self, parent: QWidget, name: str, title: str, verb: str) -> None:
        super().__init__(parent, name, title)
        self.setMinimumWidth(_WIDTH)
        self._options = QWidget()
        self.form = QFormLayout(self._options)
        self.form.setContentsMargins(0, 0, 0, 0)
        self.form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self.report = QPlainTextEdit(readOnly=True)
        self.report.setAccessibleName(tr("What came of it"))
        self.report.hide()
        buttons, self.start_button = dialog_buttons(self, verb, CLOSE)
        self.close_button = buttons.button(CLOSE)
        widgets.vbox(self._options, self.bar, (self.report, 1), buttons, of=self)
        self._running = False

    def set_running(self, running: bool) -> None:
        """While the work is running the form is disabled and Close is Cancel."""
        super().set_running(running)
        self._running = running
        self._options.setEnabled(not running)
        self.start_button.setEnabled(not running)
        self.close_button.setText(tr("Cancel") if running else tr("Close"))

    def tell(self, text: str, *groups: tuple[str, list[str]]) -> None:
        """Show the outcome: a headline, then titled lists; empty ones are left out."""
        lines = [text]
        for title, entries in groups:
            if entries:
                lines += ["", f"{title}:", *(f"•  {entry}" for entry in entries)]
        self.report.setPlainText("\n".join(lines))
        self.report.show()
        self.resize(self.size().expandedTo(QSize(_WIDTH, 440)))

    def _make_room(self) -> None:
        """Never be lower than all texts need; Qt does not see to that where lines are wrapped."""
        layout = self.layout()
        if layout is not None:
            layout.activate()
            self.setMinimumHeight(max(0, layout.totalMinimumHeightForWidth(self.width())))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._make_room()

    def reject(self) -> None:
        if self._running:
            self.cancelled.emit()
            return
        super().reject()


class ImportDialog(_ExchangeDialog):
    """Which annotations, and what becomes of those that are there."""

    def __init__(self, parent: QWidget, folder: str) -> None:
        super().__init__(parent, "importDialog", tr("Import annotations"), tr("Import"))
        self._folder = folder
        self.path = QLineEdit(placeholderText=tr("A folder, a zip archive, or one file"))
        self.path.setAccessibleName(tr("Annotations to import"))
        self.path.textChanged.connect(lambda text: self.start_button.setEnabled(bool(text.strip())))
        self.start_button.setEnabled(False)
        self.formats = QComboBox()
        self.formats.addItem(tr("Look into the files"), "auto")
        for known in FORMATS:
            if known.read is not None:
                self.formats.addItem(known.title, known.name)
        self.only_empty = QRadioButton(tr("Only frames without annotations"))
        self.only_empty.setChecked(True)
        self.replace = QRadioButton(tr("Replace what is annotated in the others, too"))
        self.replace.setToolTip(
            tr(
                "What was there stays among the earlier versions of its frame, and undo brings it"
                " back"
            )
        )
        asked = ((tr("File…"), self._choose_file), (tr("Folder…"), self._choose_folder))
        buttons = [widgets.make_button(*button) for button in asked]
        for button in buttons:
            button.setAutoDefault(False)
        self.form.addRow(tr("Annotations"), widgets.hbox((self.path, 1), *buttons))
        self.form.addRow(tr("Format"), self.formats)
        self.form.addRow(tr("Import into"), self.only_empty)
        self.form.addRow("", self.replace)
        self.form.addRow("", QLabel(tr("Frames are matched by the name of their picture.")))

    def _choose_file(self) -> None:
        chosen, _ = QFileDialog.getOpenFileName(
            self,
            tr("Annotations"),
            self._folder,
            tr("Annotations (*.json *.xml *.zip);;All files (*)"),
        )
        self.path.setText(chosen or self.path.text())

    def _choose_folder(self) -> None:
        chosen = QFileDialog.getExistingDirectory(self, tr("Annotations"), self._folder)
        self.path.setText(chosen or self.path.text())


class ExportDialog(_ExchangeDialog):
    """Which format, and what of it is lost there."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent, "exportDialog", tr("Export as"), tr("Export…"))
        self.formats = QComboBox()
        for known in WRITTEN:
            self.formats.addItem(known.title, known.name)
        self.holds = QLabel(wordWrap=True, textFormat=Qt.TextFormat.PlainText)
        self.line_width = widgets.DecimalBox(1, _WIDEST_LINE, 1.0, " px", decimals=1)
        self.line_width.setValue(4)
        self.as_zip = QCheckBox(tr("One zip archive instead of a folder"))
        self.overwrite = QCheckBox(tr("Replace files that are there"))
        self.keep_optional = QCheckBox(tr("Keep elements that SoccerNet has no class for"))
        self.form.addRow(tr("Format"), self.formats)
        self.form.addRow("", self.holds)
        self.form.addRow(tr("Width of the lines"), self.line_width)
        self.form.addRow("", self.as_zip)
        self.pictures = QCheckBox(tr("Copy the pictures as well"))
        self.form.addRow("", self.pictures)
        self.form.addRow("", self.overwrite)
        self.form.addRow("", self.keep_optional)
        self.formats.currentIndexChanged.connect(self._show_format)
        self._show_format()

    @property
    def format(self) -> AnnotationFormat:
        """The chosen format."""
        return WRITTEN[self.formats.currentIndex()]

    def ask_path(self, folder: Path) -> Path | None:
        """Ask where to; None if nowhere."""
        if self.as_zip.isChecked():
            chosen, _ = QFileDialog.getSaveFileName(
                self,
                tr("Export as"),
                str(folder / f"{self.format.name}.zip"),
                tr("Zip archive (*.zip)"),
                options=QFileDialog.Option.DontConfirmOverwrite,
            )
            path = Path(chosen)
            return (path if path.suffix else path.with_suffix(".zip")) if chosen else None
        chosen = QFileDialog.getExistingDirectory(self, tr("Export to a folder"), str(folder))
        return Path(chosen) if chosen else None

    def _show_format(self) -> None:
        chosen = self.format
        self.holds.setText(
            tr("Keeps {holds}.\nLoses {loses}.", holds=chosen.holds, loses=chosen.loses)
        )
        self.form.setRowVisible(self.line_width, chosen.name == "masks")
        self.form.setRowVisible(self.keep_optional, chosen.classes != "any")
        self.form.setRowVisible(self.pictures, chosen.pictures is not None)
        self._make_room()
