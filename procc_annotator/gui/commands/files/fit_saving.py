"""Keeping the fit on screen as the camera of its frame."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject

from procc_annotator.batch.calibration import fitted_folder, save_fit
from procc_annotator.calibration.result import ill_conditioned_reason
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.errors import ProccError
from procc_annotator.gui.state.background import JobControl, Priority, run_in_background
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.writing import opened_frame
from procc_annotator.translation import tr


@dataclass(frozen=True, eq=False)
class _Saved:
    """A camera on disk, and the folder's cameras read again where they are a source."""

    path: Path
    frame: str
    again: tuple[tuple[CameraSource, CameraSet], ...]
    left_open: str  # what the clicks hardly determine
    problem: str = ""


class FitSaving(QObject):
    """Slot of the action that saves the fit; what came of it is a message of the document."""

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document

    def save(self) -> None:
        """Write the fit on screen into the dataset's folder of fits, in the background."""
        document = self._document
        frame, workspace = opened_frame(document), document.state.workspace
        insight = document.live_fit.insight
        if frame is None or workspace is None:
            return
        if insight is None or insight.fit.camera is None:
            document.say(self._why_none())
            return
        if not document.editing.begin_edit():
            return  # somebody else has the frame, or nobody can edit it: that is said
        if document.live_fit.insight is not insight:
            document.say(tr("the fit is worked out again: save it in a moment"))
            return
        if document.state.picture_size != insight.fit.size:
            document.say(
                tr(
                    "{frame}: the picture cannot be read, so that the camera's pixels belong to no"
                    " size; not saved",
                    frame=frame.name,
                ),
                "warning",
            )
            return
        folder = fitted_folder(workspace.folder)
        loaded = [
            (source, source.files)
            for source in document.state.sources
            if source.files is not None and _same(source.files.path, folder)
        ]
        left_open = ill_conditioned_reason(insight.fit)
        annotation, fit, field = (
            insight.annotation,
            insight.fit,
            document.judge.frame_setup.field.described,
        )

        def work(control: JobControl) -> _Saved:
            path = save_fit(folder, frame.name, annotation, fit, field=field)
            try:
                again = tuple(
                    (s, CameraSet.open(c.path, c.format, c.name, c.camera_size)) for s, c in loaded
                )
            except (ProccError, OSError) as error:
                return _Saved(path, frame.name, (), left_open, str(error))
            return _Saved(path, frame.name, again, left_open)

        # Each is written, however soon the next one is asked for.
        run_in_background(
            work,
            on_result=self._tell,
            on_error=lambda text: document.say(text, "error"),
            owner=self,
            priority=Priority.IMMEDIATE,
        )

    def _tell(self, saved: _Saved) -> None:
        document = self._document
        for source, cameras in saved.again:
            if source in document.state.sources:
                document.camera_sources.add_source(cameras, active=False, changed=[saved.frame])
        if saved.problem:
            document.say(
                tr(
                    "saved as {path}, but the loaded cameras could not be read again: {problem}",
                    path=saved.path,
                    problem=saved.problem,
                ),
                "warning",
            )
            return
        said = tr("the fit of {frame} is saved as {path}", frame=saved.frame, path=saved.path)
        if saved.left_open:
            document.say(
                tr("{saved}; it is hardly determined: {why}", saved=said, why=saved.left_open),
                "warning",
            )
        else:
            document.say(said)

    def _why_none(self) -> str:
        live = self._document.live_fit
        if barred := self._document.blind_lock.no_fit:
            return barred
        if not live.wanted:
            return tr("the live fit is off (Ctrl+T)")
        if not live.allowed:
            return tr("blind: the fit is hidden until this frame is committed (Ctrl+Enter)")
        failure = live.result.failure if live.result is not None else None
        if failure:
            return tr("no camera to save: {why}", why=failure)
        return tr("no camera to save: the fit is not there yet")


def _same(some: Path, other: Path) -> bool:
    return os.path.realpath(some) == os.path.realpath(other)
