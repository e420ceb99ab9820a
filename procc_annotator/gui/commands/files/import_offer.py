"""The bar that offers to take in what another program annotated in the open dataset."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QPushButton, QToolButton

from procc_annotator.dataset.layout import ForeignAnnotations, find_foreign_annotations
from procc_annotator.gui.commands.files.importing import AnnotationImporter
from procc_annotator.gui.latest import Latest
from procc_annotator.gui.messages import Bar
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import JobControl
from procc_annotator.translation import tr


class ImportBar(Bar):
    """Says what the pictures are annotated in."""

    import_chosen = Signal()

    def __init__(self) -> None:
        super().__init__("importBar")
        self.import_button = QPushButton(tr("Import…"))
        self.import_button.setToolTip(tr("Take these annotations in; their files stay as they are"))
        self.import_button.clicked.connect(self.import_chosen)
        close = QToolButton()
        close.setText("✕")
        close.setAutoRaise(True)
        close.setToolTip(tr("Leave them, and say nothing more of them"))
        close.clicked.connect(self.hide)
        self.row.addWidget(self.import_button)
        self.row.addWidget(close)

    def tell(self, title: str) -> None:
        """Offer annotations of a format."""
        self.label.setText(
            tr("Annotations of another program lie in this dataset: {format}.", format=title)
        )
        self.show()


class ImportOffer(QObject):
    """Looks for annotations of another program whenever a dataset is opened, in the background."""

    def __init__(self, document: Document, importer: AnnotationImporter, bar: ImportBar) -> None:
        super().__init__(bar)
        self._document, self._importer, self._bar = document, importer, bar
        self._work = Latest(self, document.say)
        self._found: ForeignAnnotations | None = None
        bar.import_chosen.connect(self._ask)
        importer.imported.connect(bar.hide)
        document.store.watch(select.dataset, self._look)

    @property
    def looking(self) -> bool:
        """Return whether it is not known yet what is in the dataset."""
        return self._work.running

    def _look(self) -> None:
        self._bar.hide()
        workspace = self._document.state.workspace
        if workspace is None:
            self._work.cancel()
            return
        self._work.start(partial(_look_in, workspace.folder), self._offer)

    def _offer(self, found: ForeignAnnotations | None) -> None:
        self._found = found
        if found is not None:
            self._bar.tell(found.title)

    def _ask(self) -> None:
        if self._found is not None:
            self._importer.ask(self._found.place)


def _look_in(folder: Path, control: JobControl) -> ForeignAnnotations | None:
    return find_foreign_annotations(folder)
