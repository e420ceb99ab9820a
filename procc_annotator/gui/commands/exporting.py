"""Writing to files: annotations, scores, provenance, overview, other formats, fitted cameras."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QFileDialog, QWidget

from procc_annotator.batch.calibration import fitted_folder, save_fit
from procc_annotator.calibration.result import ill_conditioned_reason
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.workspace import Workspace, dataset_frames
from procc_annotator.errors import ProccError
from procc_annotator.formats.annotations.soccernet import write_annotation
from procc_annotator.formats.atomic import make_folder, write_atomic
from procc_annotator.gui.commands.dialogs import DialogTask
from procc_annotator.gui.messages import ask_done_only, ask_where, opened_frame, write
from procc_annotator.gui.state.availability import no_source
from procc_annotator.gui.state.background import JobControl, Priority, run_in_background
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.review_state import UNFINISHED
from procc_annotator.gui.state.services import Services
from procc_annotator.report.export import Exported, Scoring, export_dataset, export_scores
from procc_annotator.report.provenance import export_provenance
from procc_annotator.report.window_tables import OverviewRow, overview_csv, overview_rows
from procc_annotator.translation import tr, tr_count

if TYPE_CHECKING:
    from procc_annotator.gui.commands.exchange_dialogs import ExportDialog
    from procc_annotator.report.conversion_output import Converted


_LISTED = 200


def _frames_to_export(services: Services, parent: QWidget) -> Collection[str] | None:
    """Return the names of all frames, or of those that are done; None: nothing is exported."""
    frames = services.state.workspace.frames if services.state.workspace is not None else ()
    names = [frame.name for frame in frames]
    done = {name for name in names if services.review.status(name) not in UNFINISHED}
    if not done or len(done) == len(names):
        return names
    wanted = ask_done_only(parent, len(names) - len(done), len(names))
    return None if wanted is None else done if wanted else names


class ExportAs(DialogTask):
    """Asks for format and place, writes in the background, and says what was lost."""

    dialog: ExportDialog | None

    def ask(self) -> None:
        """Show the dialog."""
        from procc_annotator.gui.commands.exchange_dialogs import ExportDialog

        if opened_frame(self._services) is None:
            return
        self._leave()
        self.dialog = dialog = ExportDialog(self._parent)
        dialog.start_button.clicked.connect(self._ask_path)
        dialog.cancelled.connect(self.cancel)
        dialog.open()

    def start(self, out: Path, only: Collection[str] | None = None) -> None:
        """Write to a folder or archive, as the dialog says, ``only`` frames of these names."""
        from procc_annotator.report.conversion import export_as
        from procc_annotator.report.conversion_output import ConversionRequest

        services, dialog = self._services, self.dialog
        if dialog is None:
            return
        unsaved = tr("Not everything could be saved: what is on disk goes.")
        said = "" if services.editing.save_now() else unsaved
        review, reopen = services.review, services.opening.reopener()
        drafts = set(review.database.drafts()) if review.database is not None else set()
        wanted = ConversionRequest(
            dialog.format.name,
            dialog.line_width.value(),
            overwrite=dialog.overwrite.isChecked(),
            keep_optional=dialog.keep_optional.isChecked(),
            pictures=dialog.pictures.isChecked() and dialog.format.pictures is not None,
        )
        dialog.set_running(True)

        def write(control: JobControl) -> Converted:
            return export_as(
                reopen().only(only), out, wanted, drafts=drafts, progress=control.progress_or_stop
            )

        self._work.start(write, lambda done: self._tell(done, said), progress=dialog.advance)

    def cancel(self) -> None:
        """Stop; an archive is then not there, files of single frames may be."""
        if self._work.cancel():
            self._fail(tr("Cancelled; files that were written already are still there."))

    def _ask_path(self) -> None:
        workspace = self._services.state.workspace
        if self.dialog is not None and workspace is not None:
            only = _frames_to_export(self._services, self.dialog)
            out = None if only is None else self.dialog.ask_path(workspace.folder.parent)
            if out is not None:
                self.start(out, only)

    def _leave(self) -> None:
        if self._work.cancel():
            # Once all have heard of the other dataset, for which the message bar is cleared.
            QTimer.singleShot(0, self, self._tell_cut_short)
        super()._leave()

    def _tell_cut_short(self) -> None:
        self._services.say(
            tr("export: cancelled; files that were written already are still there"), "warning"
        )

    def _tell(self, done: Converted, said: str) -> None:
        if self.dialog is None:
            return
        headline = tr("Nothing was written: no frame is annotated, or none could be written.")
        if done.frames:
            headline = _written(done)
        self.dialog.set_running(False)
        self.dialog.tell(
            "\n".join(filter(None, (headline, said))),
            (tr("Not written"), done.problems[:_LISTED]),
            (tr("What the format cannot hold"), done.losses),
        )


def _written(done: Converted) -> str:
    return tr(
        "{frames}, {elements} and {points} written to {path} ({format}).",
        frames=tr_count(done.frames, "{n:,} frame", "{n:,} frames"),
        elements=tr_count(done.elements, "{n:,} element", "{n:,} elements"),
        points=tr_count(done.points, "{n:,} point", "{n:,} points"),
        path=done.path,
        format=done.title,
    )


@dataclass(frozen=True, eq=False)
class _Saved:
    """A camera on disk, and the folder's cameras read again where they are a source."""

    path: Path
    frame: str
    again: tuple[tuple[CameraSource, CameraSet], ...]
    left_open: str  # what the clicks hardly determine
    problem: str = ""


def _same(some: Path, other: Path) -> bool:
    return os.path.realpath(some) == os.path.realpath(other)


Work = Callable[[Workspace, Callable[[int, int], None]], Exported]


class Exporter:
    """Asks where to, writes, and says what was written.

    The export reads the dataset from disk by itself, where every finished edit is; the session on
    screen is not shared with the thread that writes.
    """

    def __init__(self, services: Services, parent: QWidget) -> None:
        self._services = services
        self._parent = parent

    def ask_annotations(self) -> None:
        """Ask for a zip archive (or a folder's name) and write SoccerNet JSON there."""
        if (only := _frames_to_export(self._services, self._parent)) is not None:
            kinds = tr("Zip archive (*.zip);;Folder (*)")
            self._ask("annotations.zip", kinds, partial(self.write_annotations, only=only))

    def save_copies(self) -> None:
        """Ask for a folder and write what is not saved there, under the names of its frames."""
        services, workspace = self._services, self._services.state.workspace
        dirty = [] if workspace is None else workspace.dirty_frames()
        if workspace is None or not dirty:
            services.say(tr("everything is saved in its own place"))
            return
        chosen = QFileDialog.getExistingDirectory(self._parent, tr("Save copies to"))
        if not chosen:
            return
        frames = workspace.frames
        copies = {Path(chosen, f"{frames[i].name}.json"): workspace.read(i) for i in dirty}

        def work(_: JobControl) -> int:
            for path, annotation in copies.items():
                make_folder(path.parent)
                write_atomic(path, write_annotation(annotation))
            return len(copies)

        def said(count: int) -> str:
            return tr_count(
                count,
                "copied {n:,} frame to {folder}; it is not saved in its own place yet",
                "copied {n:,} frames to {folder}; they are not saved in their own place yet",
                folder=chosen,
            )

        write(services, work, said, again="save_copies")

    def ask_scores(self) -> None:
        """Ask for a file and write the JaC of every frame there."""
        if why := self._why_none_scored():
            self._services.say(why, "warning")
            return
        self._ask("jac.csv", tr("Table (*.csv);;JSON (*.json)"), self.write_scores)

    def ask_provenance(self) -> None:
        """Ask for a file and write how every point came to be."""
        self._ask("provenance.json", "JSON (*.json)", self.write_provenance)

    def ask_overview(self) -> None:
        """Ask for a file and write the status, counts and time of every frame there."""
        self._ask("overview.csv", tr("Table (*.csv)"), self.write_overview)

    def write_overview(self, path: Path) -> None:
        """Write the status, counts and time of every frame as CSV."""
        services = self._services
        workspace, database = services.state.workspace, services.review.database
        services.review.note_activity()
        scores = dict(services.scoring.frame_scores.items())
        scoring = services.scoring.running

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

        write(services, work, said, again="export_overview")

    def write_provenance(self, path: Path) -> None:
        """Write the origin of every point of the set as JSON."""
        review = self._services.review
        if review.database is not None:
            review.database.flush(5.0)
        database = review.database

        def work(workspace: Workspace, progress: Callable[[int, int], None]) -> Exported:
            return export_provenance(workspace, database, path, progress)

        self._run(work, "export_provenance")

    def write_annotations(self, path: Path, only: Collection[str] | None = None) -> None:
        """Write SoccerNet JSON of all annotated frames, or ``only`` of these, to a folder or zip
        archive."""
        self._run(
            lambda workspace, progress: export_dataset(
                dataset_frames(workspace.only(only)), path, progress=progress
            ),
            "export_annotations",
        )

    def write_scores(self, path: Path) -> None:
        """Write the JaC of every frame, at tau and in words which protocol, to .csv or .json; in
        blind mode of those that are committed."""
        services = self._services
        if services.state.active is not None and (why := self._why_none_scored()):
            services.say(why, "warning")
            return
        scoring = Scoring(services.state.setup, (services.state.tau,), self._scored)
        only = services.state.revealed_frames
        self._run(
            lambda workspace, progress: export_scores(
                dataset_frames(workspace), path, scoring, progress, only=only
            ),
            "export_scores",
        )

    def save_fit(self) -> None:
        """Write the fit on screen into the dataset's folder of fits, in the background."""
        services = self._services
        frame, workspace = opened_frame(services), services.state.workspace
        insight = services.live_fit.insight
        if frame is None or workspace is None:
            return
        if insight is None or insight.fit.camera is None:
            failure = services.live_fit.result and services.live_fit.result.failure
            why = tr("no camera to save: the fit is not there yet")
            if failure:
                why = tr("no camera to save: {why}", why=failure)
            services.say(services.live_fit.problem or why)
            return
        if not services.editing.begin_edit():
            return  # somebody else has the frame, or nobody can edit it: that is said
        if services.live_fit.insight is not insight:
            services.say(tr("the fit is worked out again: save it in a moment"))
            return
        if services.state.picture_size != insight.fit.size:
            services.say(
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
            for source in services.state.sources
            if source.files is not None and _same(source.files.path, folder)
        ]
        left_open = ill_conditioned_reason(insight.fit)
        annotation, fit = insight.annotation, insight.fit
        field = services.scorer.frame_setup.field.described

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
            on_result=self._tell_saved,
            on_error=lambda text: services.say(text, "error"),
            owner=services,
            priority=Priority.IMMEDIATE,
        )

    def _tell_saved(self, saved: _Saved) -> None:
        services = self._services
        for source, cameras in saved.again:
            if source in services.state.sources:
                services.camera_sources.add_source(cameras, active=False, changed=[saved.frame])
        if saved.problem:
            services.say(
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
            services.say(
                tr("{saved}; it is hardly determined: {why}", saved=said, why=saved.left_open),
                "warning",
            )
        else:
            services.say(said)

    @property
    def _scored(self) -> CameraSet | None:
        """The cameras whose JaC is exported; None for fits, which are made from the very clicks
        they would be scored against."""
        active = self._services.state.active
        return active.files if active is not None else None

    def _why_none_scored(self) -> str:
        active = self._services.state.active
        if active is None:
            return no_source(self._services.state)
        if self._scored is not None:
            hidden = self._services.state.revealed_frames == frozenset()
            none = tr("blind: no frame is committed yet, so there is no JaC to show")
            return none if hidden else ""
        return tr(
            "{source} is made from the clicks it would be scored against: judge the cameras to be"
            " scored (procc-annotator calibrate fits and scores a set)",
            source=active.name,
        )

    def _ask(self, name: str, kinds: str, then: Callable[[Path], None]) -> None:
        if (path := ask_where(self._services, self._parent, tr("Export"), name, kinds)) is not None:
            then(path)

    def _run(self, work: Work, again: str) -> None:
        services = self._services
        if opened_frame(services) is None:
            return
        if not services.editing.save_now():
            services.say(
                tr("not everything could be saved: the export has the last saved state"), "warning"
            )
        reopen = services.opening.reopener()

        def export(control: JobControl) -> Exported:
            return work(reopen(), control.progress)

        run_in_background(
            export,
            on_result=self._tell,
            on_error=lambda text: services.say(text, "error", again),
            on_progress=lambda done, total: services.say(
                tr("exporting {done} / {total}", done=done, total=total)
            ),
            owner=services,
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
        self._services.say("; ".join(told), "warning" if exported.problems else "info")


def _what(exported: Exported) -> str:
    annotations = tr_count(exported.annotations, "{n:,} annotation", "{n:,} annotations")
    scores = tr_count(exported.scored, "JaC of {n:,} frame", "JaC of {n:,} frames")
    if exported.annotations and exported.scored:
        return tr("{annotations} and {scores}", annotations=annotations, scores=scores)
    if exported.annotations:
        return annotations
    return scores if exported.scored else tr("nothing: no frame is annotated")
