"""Dialogs of import and export: place, format, names of labels, the report."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QSize, QStringListModel, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QProgressBar,
    QPushButton,
    QRadioButton,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.assist.label_proposal import LabelProposal, order_choices, rule_words
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import LABELS_FILE, Rule
from procc_annotator.formats.annotations.registry import FORMATS, AnnotationFormat
from procc_annotator.gui.panels.widgets import DecimalBox, note_label, show_note
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


class _AsItIs:
    """In the place of a rule: nothing is said of the label."""


class LabelDialog(QDialog):
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
        """Show what is proposed; what is open stays an unknown class unless a person says more.

        Args:
            proposals: of every label that is no class.
            field: of the dataset.
            better: title of a field whose classes are called more like the labels; may be empty.
            has_file: whether the dataset has a ``labels.toml`` already.
        """
        super().__init__(parent)
        self.setObjectName("labelDialog")
        self.setWindowTitle(tr("Names of another program"))
        self._proposals = proposals
        self.choices: list[QComboBox] = []
        self._rules: list[list[Rule | _AsItIs]] = []
        asked = QLabel(_asked(len(proposals), field), wordWrap=True)
        self.note = note_label("labelNote")
        words = tr(
            "These names are more like those of {field}: choose that field first (File > Field).",
            field=tr(better) if better else "",
        )
        show_note(self.note, words if better else "")
        self.keep = QCheckBox(tr("Keep these names with the dataset ({file})", file=LABELS_FILE))
        if has_file:
            self.keep.setText(
                tr("Add these names to the dataset's {file}, written anew", file=LABELS_FILE)
            )
        self.keep.setChecked(not has_file)
        self.buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.take = QPushButton(tr("Import"))
        self.buttons.addButton(self.take, QDialogButtonBox.ButtonRole.AcceptRole)
        self.buttons.button(QDialogButtonBox.StandardButton.Cancel).setAutoDefault(False)
        self.take.setDefault(True)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        for part in (asked, self.note, self._table(field), self.keep, self.buttons):
            column.addWidget(part, int(isinstance(part, QScrollArea)))
        self.resize(*_SIZE)
        if self.choices:
            self.choices[0].setFocus()

    @property
    def rules(self) -> dict[str, Rule]:
        """Return what was chosen, by label; labels that stay as they are are missing."""
        found: dict[str, Rule] = {}
        for one, box, rules in zip(self._proposals, self.choices, self._rules, strict=True):
            rule = rules[box.currentIndex()]
            if not isinstance(rule, _AsItIs):
                found[one.count.label] = rule
        return found

    def _table(self, field: Field) -> QScrollArea:
        inside = QWidget()
        grid = QGridLayout(inside)
        for column, header in enumerate(_HEADERS):
            title = QLabel(f"<b>{tr(header)}</b>" if header else "")
            title.setTextFormat(Qt.TextFormat.RichText)
            grid.addWidget(title, 0, column)
        names = [e.name for e in field.elements]
        titles = [tr(field.title_of(name)) for name in names]
        self._titles = QStringListModel([tr(_AS_IT_IS), tr(_LEFT_OUT), *titles], self)
        for row, one in enumerate(self._proposals, start=1):
            box = self._choice(one, names, titles, field)
            shown = one.count.label
            shown = shown if len(shown) <= _LONGEST else f"{shown[: _LONGEST - 1]}…"
            cells = (
                _text(shown, one.count.label), _text(str(one.count.shapes)), box,
                _text(tr(_SURETIES[one.surety], "a proposal")), _wrapped(_why(one, field)),
            )  # fmt: skip
            for column, cell in enumerate(cells):
                grid.addWidget(cell, row, column, Qt.AlignmentFlag.AlignVCenter)
        grid.setRowStretch(len(self._proposals) + 1, 1)
        grid.setColumnStretch(len(_HEADERS) - 1, 1)
        area = QScrollArea()
        area.setObjectName("labelTable")
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setWidget(inside)
        return area

    def _choice(
        self, one: LabelProposal, names: list[str], titles: list[str], field: Field
    ) -> QComboBox:
        orders = order_choices(one)
        rules: list[Rule | _AsItIs] = [_AsItIs(), None, *orders, *names]
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
            box.setCurrentIndex(rules.index(one.rule))
        box.setToolTip(box.currentText())
        box.currentTextChanged.connect(box.setToolTip)
        self.choices.append(box)
        self._rules.append(rules)
        return box


def _why(one: LabelProposal, field: Field) -> str:
    like = ", ".join(tr(field.title_of(name)) for name in one.like)
    return f"{one.why}: {like}" if like else one.why


def _text(text: str, tip: str = "") -> QLabel:
    label = QLabel(text)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setToolTip(tip)
    return label


def _wrapped(text: str) -> QLabel:
    label = _text(text, text)
    label.setWordWrap(True)
    return label


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


class _ExchangeDialog(QDialog):
    """A form, a bar that shows how far the work is, and a report of it."""

    started = Signal()
    cancelled = Signal()

    def __init__(self, parent: QWidget, title: str, verb: str) -> None:
        super().__init__(parent)
        self.setWindowTitle(title)
        self.setMinimumWidth(_WIDTH)
        self.form = QFormLayout()
        self.form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self.bar = QProgressBar()
        self.bar.hide()
        self.report = QPlainTextEdit(readOnly=True)
        self.report.setAccessibleName(tr("What came of it"))
        self.report.hide()
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        self.start_button = QPushButton(verb)
        self.start_button.setDefault(True)
        self.start_button.clicked.connect(self.started)
        buttons.addButton(self.start_button, QDialogButtonBox.ButtonRole.ActionRole)
        self.close_button = buttons.button(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(self.form)
        layout.addWidget(self.bar)
        layout.addWidget(self.report, 1)
        layout.addWidget(buttons)
        self._running = False

    def set_running(self, running: bool) -> None:
        """While the work goes on the form waits and Close is Cancel."""
        self._running = running
        for row in range(self.form.rowCount()):
            for role in (QFormLayout.ItemRole.FieldRole, QFormLayout.ItemRole.SpanningRole):
                item = self.form.itemAt(row, role)
                widget = item.widget() if item is not None else None
                if widget is not None:
                    widget.setEnabled(not running)
        self.start_button.setEnabled(not running)
        self.close_button.setText(tr("Cancel") if running else tr("Close"))
        self.bar.setVisible(running)
        self.bar.setRange(0, 0)

    def advance(self, done: int, total: int) -> None:
        """Show how far the work is."""
        self.bar.setRange(0, total)
        self.bar.setValue(done)

    def tell(self, headline: str, *groups: tuple[str, list[str]]) -> None:
        """Say what came of it: a headline, then titled lists; empty ones are left out."""
        lines = [headline]
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
        super().__init__(parent, tr("Import annotations"), tr("Import"))
        self.setObjectName("importDialog")
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
        self.only_empty = QRadioButton(tr("Only frames where nothing is annotated yet"))
        self.only_empty.setChecked(True)
        self.replace = QRadioButton(tr("Replace what is annotated in the others, too"))
        self.replace.setToolTip(
            tr(
                "What was there stays among the earlier versions of its frame, and undo brings it"
                " back"
            )
        )
        choice = QWidget()
        lines = QVBoxLayout(choice)
        lines.setContentsMargins(0, 0, 0, 0)
        lines.addWidget(self.only_empty)
        lines.addWidget(self.replace)
        self.form.addRow(tr("Annotations"), self._path_row())
        self.form.addRow(tr("Format"), self.formats)
        self.form.addRow(tr("Import into"), choice)
        note = QLabel(tr("Frames are matched by the name of their picture."))
        self.form.addRow("", note)

    def _path_row(self) -> QWidget:
        row = QWidget()
        layout = QHBoxLayout(row)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.path, 1)
        for text, choose in (
            (tr("File…"), self._choose_file),
            (tr("Folder…"), self._choose_folder),
        ):
            button = QPushButton(text)
            button.setAutoDefault(False)
            button.clicked.connect(choose)
            layout.addWidget(button)
        return row

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
        super().__init__(parent, tr("Export as"), tr("Export…"))
        self.setObjectName("exportDialog")
        self.formats = QComboBox()
        for known in FORMATS:
            self.formats.addItem(known.title, known.name)
        self.holds = QLabel(wordWrap=True)
        self.holds.setTextFormat(Qt.TextFormat.PlainText)
        self.line_width = DecimalBox()
        self.line_width.setRange(1, _WIDEST_LINE)
        self.line_width.setDecimals(1)
        self.line_width.setValue(4)
        self.line_width.setSuffix(" px")
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
        return FORMATS[self.formats.currentIndex()]

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
