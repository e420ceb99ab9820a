"""What to import or export, in which format, and afterwards what came of it."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QProgressBar,
    QPushButton,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.formats.annotations.registry import FORMATS, AnnotationFormat
from procc_annotator.gui.panels.widgets import DecimalBox
from procc_annotator.translation import tr

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
