"""A second annotator's folder beside the dataset: drawn, and compared class by class."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError, ProccError
from procc_annotator.gui.state.saying import say
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.store import Store
from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.source import FileSource, open_source
from procc_annotator.metric.agreement import FrameAgreement, compare_annotations


class SecondAnnotator(QObject):
    """What somebody else clicked in the same frames.

    Attributes:
        annotation: theirs of the frame on screen; None where there is none, or none to be read.
        error: why the frame's file could not be read; empty where it could, or where there is none.
    """

    changed = Signal()

    def __init__(self, store: Store, signals: Signals) -> None:
        super().__init__(store)
        self._store = store
        signals.fieldChanged.connect(self._read_again)
        self._frame: str | None = None
        self._source: FileSource | None = None
        self._files: dict[str, str] = {}
        self.path: Path | None = None
        self.annotation: FrameAnnotation | None = None
        self.error = ""

    @property
    def is_open(self) -> bool:
        """Whether a second folder is open."""
        return self._source is not None

    def open(self, path: Path) -> bool:
        """Read a folder or zip of annotations; on failure everything stays as it is."""
        try:
            source = open_source(path)
            files = list_annotations(source)
        except ProccError as error:
            say(self._store, str(error), "error")
            return False
        if not files:
            said = (f"{path}: holds no annotation (*.json)", *files.notices)
            say(self._store, "; ".join(said), "error")
            return False
        self._source, self._files, self.path = source, files, path
        if files.notices:
            say(self._store, "; ".join(files.notices))
        return True

    def close(self) -> None:
        """Forget the second folder."""
        self._source, self._files, self.path = None, {}, None
        self.annotation, self.error = None, ""
        self.changed.emit()

    def reader(self) -> Callable[[str], FrameAnnotation | None]:
        """Reads the other annotation of a frame by its name, from any thread; None: there is none.

        What it returns may raise InputError when called.
        """
        source, files, field = self._source, self._files, self._store.state.field

        def read(frame: str) -> FrameAnnotation | None:
            file = files.get(frame)
            if source is None or file is None:
                return None
            return read_annotation(source.read(file), path=source.display(file), field=field)

        return read

    def _read_again(self) -> None:
        """With another field elements bear other names."""
        self.show(self._frame)

    def show(self, frame: str | None) -> None:
        """Read the annotation of the frame on screen."""
        self._frame = frame
        if not self.is_open:
            return
        self.annotation, self.error = None, ""
        if frame is not None:
            try:
                self.annotation = self.reader()(frame)
            except InputError as error:
                self.error = str(error)
                say(self._store, f"second annotator: {error}", "warning")
        self.changed.emit()

    def agreement(
        self, annotation: FrameAnnotation, size: tuple[int, int]
    ) -> FrameAgreement | None:
        """How both agree in this frame, in px of a size; None where the other has none."""
        if self.annotation is None:
            return None
        return compare_annotations(annotation, self.annotation, self._store.state.field, size)
