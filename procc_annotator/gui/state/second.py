"""A second annotator's folder next to the dataset: drawn, and compared class by class."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.annotation_source import ReadSource, open_annotations
from procc_annotator.dataset.layout import annotations_of
from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.file_listing import AnnotationFiles, list_annotations
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.strict_json import printable
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.store import Store
from procc_annotator.messages import first_names
from procc_annotator.metrics.agreement import FrameAgreement, compare_annotations
from procc_annotator.translation import tr, tr_count

_Read = tuple[FileSource, AnnotationFiles]


class SecondAnnotator(QObject):
    """Annotations of a second annotator in the same frames: that of the frame on screen, None if
    absent, and the ``error`` if its file could not be read."""

    changed = Signal()
    opened = Signal(Path)  # what was asked for is read: another one, or by another field

    def __init__(self, store: Store) -> None:
        super().__init__(store)
        self._store = store
        self._reading = LatestOnlyTask(self, lambda why: say(store, why, "error"))
        store.watch(select.field, self._read_again)
        self._frame: str | None = None
        self._source: FileSource | None = None
        self._files: dict[str, str] = {}
        self.path: Path | None = None
        self.annotation: FrameAnnotation | None = None
        self.error = ""

    @property
    def is_open(self) -> bool:
        """Return whether a second folder is open."""
        return self._source is not None

    def open(self, path: Path) -> None:
        """Read a folder, archive or file of annotations of any format in the background, with its
        own ``labels.toml``, as ``agree`` does; on failure everything stays as it is."""
        field = self._store.state.field

        def work(control: JobControl) -> _Read:
            source = open_annotations(annotations_of(path), field)
            files = list_annotations(source)
            if not files:
                said = (tr("{path}: holds no annotation (*.json)", path=path), *files.notices)
                raise UsageError("; ".join(said))
            return source, files

        self._reading.start(work, partial(self._take, path))

    def close(self) -> None:
        """Forget the second annotator, be he still read."""
        self._reading.cancel()
        self._source, self._files, self.path = None, {}, None
        self.annotation, self.error = None, ""
        self.changed.emit()

    def _take(self, path: Path, read: _Read) -> None:
        self._source, self._files = read
        self.path = path
        said = list(read[1].notices)
        if isinstance(self._source, ReadSource) and (unknown := self._source.unknown):
            labels = [printable(label) for label in unknown]
            said.append(
                tr_count(
                    len(labels),
                    "no class of this field: {n} label ({names})",
                    "no class of this field: {n} labels ({names})",
                    names=first_names(labels),
                )
            )
        if said:
            say(self._store, "; ".join(said))
        self.opened.emit(path)

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
        """With another field elements bear other names, and labels of others stand for others."""
        if self.path is not None and isinstance(self._source, ReadSource):
            self.open(self.path)
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
                say(self._store, tr("second annotator: {why}", why=error), "warning")
        self.changed.emit()

    def agreement(
        self, annotation: FrameAnnotation, size: tuple[int, int]
    ) -> FrameAgreement | None:
        """Return how both agree in this frame, in px of a size; None where the other has none."""
        if self.annotation is None:
            return None
        return compare_annotations(annotation, self.annotation, self._store.state.field, size)
