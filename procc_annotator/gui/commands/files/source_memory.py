"""Camera sources opened with a dataset are there again when it is opened the next time."""

from __future__ import annotations

import os
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path

import msgspec
from PySide6.QtCore import QObject

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.errors import ProccError
from procc_annotator.gui.settings import SOURCES, Settings
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import JobControl, run_in_background
from procc_annotator.translation import tr


@dataclass(frozen=True)
class RememberedSource:
    """A source as it is written down."""

    path: str
    format: str
    name: str
    colour: str
    visible: bool = True
    active: bool = False


@dataclass(frozen=True, eq=False)
class _Reopened:
    """What became of the sources of a dataset."""

    found: list[tuple[RememberedSource, CameraSet]]
    lost: list[str]


class SourceMemory(QObject):
    """Writes down the sources whenever they change; brings them back with their dataset.

    Sources belong to the dataset they were opened with: another dataset brings its own. Those that
    were opened before any dataset go over to the first one.
    """

    def __init__(self, document: Document, settings: Settings, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._settings = settings
        self._dataset: Path | None = None
        self._changing = False
        self._written: list[dict[str, object]] | None = None
        document.store.watch(select.dataset, self._take_dataset)
        document.store.watch(select.cameras, self._write_down)

    def _take_dataset(self) -> None:
        workspace = self._document.state.workspace
        dataset = workspace.root.resolve() if workspace is not None else None
        if dataset == self._dataset:
            return
        before, self._dataset = self._dataset, dataset
        self._written = None
        if before is not None:
            self._changing = True
            self._document.camera_sources.clear_sources()
            self._changing = False
        if dataset is not None:
            self._bring_back(dataset)

    def _bring_back(self, dataset: Path) -> None:
        remembered = _read(self._settings.entries(SOURCES, str(dataset)))
        if not remembered:
            return
        self._changing = True  # what is about to come back must not be forgotten meanwhile

        def work(control: JobControl) -> _Reopened:
            return _reopen(remembered)

        def done(reopened: _Reopened) -> None:
            if self._dataset == dataset:
                self._add(reopened)

        def fail(text: str) -> None:
            if self._dataset == dataset:
                self._changing = False
                self._document.say(
                    tr("cameras opened here before are not opened again: {why}", why=text),
                    "warning",
                )

        run_in_background(work, on_result=done, on_error=fail, owner=self)

    def _add(self, reopened: _Reopened) -> None:
        document = self._document
        # Sources that were opened meanwhile, or named on the command line, stay as they are.
        taken = {_place(s.files): s for s in document.state.sources if s.files is not None}
        for source, cameras in reopened.found:
            known = taken.get(_place(cameras))
            if known is None:
                document.camera_sources.add_source(
                    cameras,
                    colour=source.colour,
                    visible=source.visible,
                    active=source.active and not taken,
                )
            elif known.name in (cameras.path.name, cameras.path.stem):  # nobody named it otherwise
                document.camera_sources.rename_source(known, source.name)
                document.camera_sources.set_source_colour(known, source.colour)
        self._changing = False
        self._write_down()
        if reopened.lost:
            document.say(
                tr(
                    "cameras opened here before are not there any more: {paths}",
                    paths="; ".join(reopened.lost),
                ),
                "warning",
            )

    def _write_down(self) -> None:
        if self._changing or self._dataset is None:
            return
        document = self._document
        entries = [
            asdict(
                RememberedSource(
                    os.path.abspath(cameras.path),
                    cameras.format,
                    source.name,
                    source.colour,
                    source.visible,
                    source is document.state.active,
                )
            )
            for source in document.state.sources
            if (cameras := source.files) is not None
        ]
        if entries != self._written:
            self._written = entries
            self._settings.set_entries(SOURCES, str(self._dataset), entries)


def _place(cameras: CameraSet) -> tuple[Path, str]:
    return Path(os.path.abspath(cameras.path)), cameras.format


def _read(entries: list[object]) -> list[RememberedSource]:
    """Return what can be understood of what is written down."""
    remembered = []
    for entry in entries:
        with suppress(msgspec.ValidationError):
            remembered.append(msgspec.convert(entry, RememberedSource))
    return remembered


def _reopen(remembered: list[RememberedSource]) -> _Reopened:
    reopened = _Reopened([], [])
    for source in remembered:
        try:
            cameras = CameraSet.open(Path(source.path), source.format, source.name)
        except (ProccError, OSError):
            reopened.lost.append(source.path)
            continue
        if cameras.frames:
            reopened.found.append((source, cameras))
        else:
            reopened.lost.append(source.path)
    return reopened
