"""Exports of the whole set, in the background."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QWidget

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.workspace import Workspace, dataset_frames
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.gui.state.background import JobControl, run_in_background
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.writing import ask_where, opened_frame, write
from procc_annotator.report.export import Exported, Scoring, export_dataset, export_scores
from procc_annotator.report.provenance import export_provenance
from procc_annotator.report.window_tables import OverviewRow, overview_csv, overview_rows
from procc_annotator.translation import tr, tr_count

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
        self._ask("annotations.zip", tr("Zip archive (*.zip);;Folder (*)"), self.write_annotations)

    def ask_scores(self) -> None:
        """Ask for a file and write the JaC of every frame there."""
        if why := self._why_none_scored():
            self._document.say(why, "warning")
            return
        self._ask("jac.csv", tr("Table (*.csv);;JSON (*.json)"), self.write_scores)

    def ask_provenance(self) -> None:
        """Ask for a file and write how every point came to be."""
        self._ask("provenance.json", "JSON (*.json)", self.write_provenance)

    def ask_overview(self) -> None:
        """Ask for a file and write the status, counts and time of every frame there."""
        asked = self._document, self._parent, tr("Export the overview")
        if (path := ask_where(*asked, "overview.csv", tr("Table (*.csv)"))) is not None:
            self.write_overview(path)

    def write_overview(self, path: Path) -> None:
        """Write the status, counts and time of every frame as CSV."""
        document = self._document
        workspace, database = document.state.workspace, document.review.database
        document.review.note_activity()
        scores = dict(document.auditing.frame_scores.items())
        scoring = document.set_scores.running

        def work(control: JobControl) -> int:
            rows: list[OverviewRow] = []
            if workspace is not None:
                rows = overview_rows(workspace, database, scores, control.progress_or_stop)
            write_atomic(path, overview_csv(rows))
            return len(rows)

        def said(count: int) -> str:
            done = tr_count(
                count,
                "exported {n:,} frame to {path}",
                "exported {n:,} frames to {path}",
                path=path,
            )
            more = tr("the set was being scored still: some frames have no JaC yet")
            return f"{done}; {more}" if scoring else done

        write(document, work, said, again="export_overview")

    def write_provenance(self, path: Path) -> None:
        """Write the origin of every point of the set as JSON."""
        review = self._document.review
        if review.database is not None:
            review.database.flush(5.0)
        database = review.database

        def work(workspace: Workspace, progress: Callable[[int, int], None]) -> Exported:
            return export_provenance(workspace, database, path, progress)

        self._run(work, "export_provenance")

    def write_annotations(self, path: Path) -> None:
        """Write SoccerNet JSON of all annotated frames to a folder or zip archive."""
        self._run(
            lambda workspace, progress: export_dataset(
                dataset_frames(workspace), path, progress=progress
            ),
            "export_annotations",
        )

    def write_scores(self, path: Path) -> None:
        """Write the JaC of every frame, at tau and in words which protocol, to .csv or .json; in
        blind mode of those that are committed."""
        document = self._document
        if document.state.active is not None and (why := self._why_none_scored()):
            document.say(why, "warning")
            return
        scoring = Scoring(document.state.setup, (document.state.tau,), self._scored)
        only = document.state.revealed_frames
        self._run(
            lambda workspace, progress: export_scores(
                dataset_frames(workspace), path, scoring, progress, only=only
            ),
            "export_scores",
        )

    @property
    def _scored(self) -> CameraSet | None:
        """The cameras whose JaC is exported; None for fits, which are made from the very clicks
        they would be scored against."""
        active = self._document.state.active
        return active.files if active is not None else None

    def _why_none_scored(self) -> str:
        """Why no JaC can be exported; empty if it can."""
        active = self._document.state.active
        if active is None:
            return tr("load cameras first: there is nothing to score")
        if self._scored is not None:
            hidden = self._document.state.revealed_frames == frozenset()
            none = tr("blind: no frame is committed yet, so there is no JaC to show")
            return none if hidden else ""
        return tr(
            "{source} is made from the clicks it would be scored against: judge the cameras to be"
            " scored (procc-annotator calibrate fits and scores a set)",
            source=active.name,
        )

    def _ask(self, name: str, kinds: str, then: Callable[[Path], None]) -> None:
        if (path := ask_where(self._document, self._parent, tr("Export"), name, kinds)) is not None:
            then(path)

    def _run(self, work: Work, again: str) -> None:
        document = self._document
        if opened_frame(document) is None:
            return
        if not document.editing.save_now():
            document.say(
                tr("not everything could be saved: the export has the last saved state"), "warning"
            )
        reopen = document.opening.reopener()

        def export(control: JobControl) -> Exported:
            return work(reopen(), control.progress)

        run_in_background(
            export,
            on_result=self._tell,
            on_error=lambda text: document.say(text, "error", again),
            on_progress=lambda done, total: document.say(
                tr("exporting {done} / {total}", done=done, total=total)
            ),
            owner=document,
        )

    def _tell(self, exported: Exported) -> None:
        told = [tr("exported {what} to {path}", what=_what(exported), path=exported.path)]
        told += exported.left_out
        if exported.hidden:
            told.append(
                tr_count(
                    exported.hidden,
                    "blind mode leaves out {n:,} frame not committed yet",
                    "blind mode leaves out {n:,} frames not committed yet",
                )
            )
        if exported.problems:
            told.append(
                tr_count(
                    len(exported.problems),
                    "{n:,} file could not be read: {problem}",
                    "{n:,} files could not be read: {problem}",
                    problem=exported.problems[0],
                )
            )
        self._document.say("; ".join(told), "warning" if exported.problems else "info")


def _what(exported: Exported) -> str:
    annotations = tr_count(exported.annotations, "{n:,} annotation", "{n:,} annotations")
    scores = tr_count(exported.scored, "JaC of {n:,} frame", "JaC of {n:,} frames")
    if exported.annotations and exported.scored:
        return tr("{annotations} and {scores}", annotations=annotations, scores=scores)
    if exported.annotations:
        return annotations
    return scores if exported.scored else tr("nothing: no frame is annotated")
