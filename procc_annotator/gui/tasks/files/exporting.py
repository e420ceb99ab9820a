"""Exports of the whole set, in the background."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QWidget

from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import JobControl, run_in_background
from procc_annotator.gui.writing import ask_where, opened_frame
from procc_annotator.interact.hints import counted
from procc_annotator.report.export import Exported, Scoring, export_annotations, export_scores
from procc_annotator.report.provenance import export_provenance
from procc_annotator.session.dataset.annotated_frames import DatasetFrames
from procc_annotator.session.dataset.camera_set import CameraSet
from procc_annotator.session.dataset.workspace import Workspace

Work = Callable[[Workspace, Callable[[int, int], None]], Exported]


class Exporter:
    """Asks where to, writes, and says what was written.

    The export reads the dataset from disk by itself, where every finished edit is; the session on
    screen is not shared with the thread that writes.
    """

    def __init__(self, document: Document, parent: QWidget) -> None:
        self._document = document
        self._parent = parent

    def ask_annotations(self) -> None:
        """Ask for a zip archive (or a folder's name) and write SoccerNet JSON there."""
        self._ask("annotations.zip", "Zip archive (*.zip);;Folder (*)", self.write_annotations)

    def ask_scores(self) -> None:
        """Ask for a file and write the JaC of every frame there."""
        if why := self._why_none_scored():
            self._document.say(why, "warning")
            return
        self._ask("jac.csv", "Table (*.csv);;JSON (*.json)", self.write_scores)

    def ask_provenance(self) -> None:
        """Ask for a file and write how every point came to be."""
        self._ask("provenance.json", "JSON (*.json)", self.write_provenance)

    def write_provenance(self, path: Path) -> None:
        """Write the origin of every point of the set as JSON."""
        review = self._document.review
        if review.database is not None:
            review.database.flush(5.0)
        database = review.database

        def work(workspace: Workspace, progress: Callable[[int, int], None]) -> Exported:
            return export_provenance(workspace, database, path, progress)

        self._run(work)

    def write_annotations(self, path: Path) -> None:
        """Write SoccerNet JSON of all annotated frames to a folder or zip archive."""
        self._run(
            lambda workspace, progress: export_annotations(DatasetFrames(workspace), path, progress)
        )

    def write_scores(self, path: Path) -> None:
        """Write the JaC of every frame, at tau and in words which protocol, to .csv or .json; in
        blind mode of those that are committed."""
        document = self._document
        if document.active_source is not None and (why := self._why_none_scored()):
            document.say(why, "warning")
            return
        scoring = Scoring(document.setup, (document.tau,), self._scored)
        only = document.revealed_frames
        self._run(
            lambda workspace, progress: export_scores(
                DatasetFrames(workspace), path, scoring, progress, only=only
            )
        )

    @property
    def _scored(self) -> CameraSet | None:
        """The cameras whose JaC is exported; None for fits, which are made from the very clicks
        they would be scored against."""
        active = self._document.active_source
        return active.files if active is not None else None

    def _why_none_scored(self) -> str:
        """Why no JaC can be exported; empty if it can."""
        active = self._document.active_source
        if active is None:
            return "load cameras first: there is nothing to score"
        if self._scored is not None:
            hidden = self._document.revealed_frames == frozenset()
            return "blind: no frame is committed yet, so there is no JaC to show" if hidden else ""
        return (
            f"{active.name} is made from the clicks it would be scored against: judge the cameras"
            " to be scored (procc-annotator calibrate fits and scores a set)"
        )

    def _ask(self, name: str, kinds: str, then: Callable[[Path], None]) -> None:
        if (path := ask_where(self._document, self._parent, "Export", name, kinds)) is not None:
            then(path)

    def _run(self, work: Work) -> None:
        document = self._document
        if opened_frame(document) is None:
            return
        if not document.save_now():
            document.say(
                "not everything could be saved: the export has the last saved state", "warning"
            )
        reopen = document.reopener()

        def export(control: JobControl) -> Exported:
            return work(reopen(), control.progress)

        run_in_background(
            export,
            on_result=self._tell,
            on_error=lambda text: document.say(text, "error"),
            on_progress=lambda done, total: document.say(f"exporting {done} / {total}"),
            owner=document,
        )

    def _tell(self, exported: Exported) -> None:
        parts = []
        if exported.annotations:
            parts.append(counted(exported.annotations, "annotation"))
        if exported.scored:
            parts.append(f"JaC of {counted(exported.scored, 'frame')}")
        what = " and ".join(parts) or "nothing: no frame is annotated"
        text = f"exported {what} to {exported.path}"
        if exported.left_out:
            text += "; " + "; ".join(exported.left_out)
        if exported.hidden:
            left = counted(exported.hidden, "frame")
            text += f"; blind mode leaves out {left} not committed yet"
        if exported.problems:
            unread = counted(len(exported.problems), "file")
            text += f"; {unread} could not be read: {exported.problems[0]}"
            self._document.say(text, "warning")
        else:
            self._document.say(text)
