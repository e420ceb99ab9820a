"""The overview of the set: gathered in the background, shown in a window of its own, exported."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QWidget

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.records import Origin, PointKey, count_points_by_origin
from procc_annotator.dataset.review import BlindStatus, blind_status, setting_of
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.gui.latest import Latest
from procc_annotator.gui.panels.overview.dialog import OverviewWindow
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import JobControl
from procc_annotator.gui.writing import ask_where, write
from procc_annotator.report.window_tables import OverviewRow, overview_csv, summarise
from procc_annotator.translation import tr, tr_count

T = TypeVar("T")

_RESTED_MS = 1_000  # all files of a set are gone through: not with every click


class OverviewCommand:
    """Opens the overview and keeps it up to date while it is open."""

    def __init__(self, document: Document, parent: QWidget) -> None:
        self._document = document
        self._parent = parent
        self._refreshing = Latest(document, lambda text: document.say(text, "error"))
        self.window: OverviewWindow | None = None
        self._rested = QTimer(document, singleShot=True, interval=_RESTED_MS)
        self._rested.timeout.connect(self._follow)
        document.store.watch(select.annotation, self._rested.start)
        for signal in (
            document.store.events.framesEdited,
            document.store.events.frameScoresChanged,
            document.review.statusChanged,
        ):
            signal.connect(self._rested.start)

    def _follow(self) -> None:
        if self.window is not None and self.window.isVisible():
            self.refresh()

    def show(self) -> None:
        """Show the window and gather what it shows."""
        if self.window is None:
            self.window = OverviewWindow(self._parent)
            self.window.exportRequested.connect(self.export)
        self.window.show()
        self.window.raise_()
        self.refresh()

    def refresh(self) -> None:
        """Gather the overview again."""
        window, field = self.window, self._document.state.field
        if window is not None:
            work = self._rows_for(lambda rows: summarise(rows, field))
            self._refreshing.start(work, window.show_overview)

    def export(self) -> None:
        """Ask for a file and write one row a frame."""
        asked = self._document, self._parent, tr("Export the overview")
        if (path := ask_where(*asked, "overview.csv", tr("Table (*.csv)"))) is not None:
            self.write(path)

    def write(self, path: Path) -> None:
        """Write one row a frame as CSV."""
        document = self._document

        def as_csv(rows: list[OverviewRow]) -> int:
            write_atomic(path, overview_csv(rows))
            return len(rows)

        scoring = document.set_scores.running

        def said(count: int) -> str:
            done = tr_count(
                count,
                "exported {n:,} frame to {path}",
                "exported {n:,} frames to {path}",
                path=path,
            )
            more = tr("the set was being scored still: some frames have no JaC yet")
            return f"{done}; {more}" if scoring else done

        write(document, self._rows_for(as_csv, complete=True), said, again="export_overview")

    def _rows_for(
        self, use: Callable[[list[OverviewRow]], T], *, complete: bool = False
    ) -> Callable[[JobControl], T]:
        """Return what gives the rows of all frames to ``use``, in a thread of its own."""
        document = self._document
        workspace, database = document.state.workspace, document.review.database
        document.review.note_activity()
        scores = dict(document.auditing.frame_scores.items())

        def work(control: JobControl) -> T:
            if workspace is None:
                return use([])
            return use(gather_rows(workspace, database, scores, control, complete=complete))

        return work


def gather_rows(
    workspace: Workspace,
    database: WorkspaceDatabase | None,
    scores: dict[str, float],
    control: JobControl | None = None,
    *,
    complete: bool = False,
) -> list[OverviewRow]:
    """One row a frame; unreadable annotations count as not annotated.

    Raises:
        Stopped: no one wants the rows any more.
        InputError: not all that is to be ``complete`` can be read from the database.
    """
    rows: list[OverviewRow] = []
    for index, frame in enumerate(workspace.frames):
        if control is not None:
            control.progress_or_stop(index, len(workspace.frames))
        work = BlindStatus.UNKNOWN
        try:
            annotation = workspace.read(index)
        except InputError:  # told when that frame is opened
            annotation = FrameAnnotation()
        else:
            if database is not None:
                work = blind_status(database.setting(setting_of(frame.name)), annotation)
        classes = {p.class_name: len(p.points) for p in annotation.polylines if p.points}
        origins: Mapping[PointKey, Origin] = {}
        if database is not None and classes:
            origins = database.read_origins(frame.name, complete=complete)
        record = database.record(frame.name) if database is not None else None
        rows.append(
            OverviewRow(
                name=frame.name,
                status=record.status.value if record is not None else "untouched",
                classes=classes,
                seconds=record.seconds if record is not None else 0.0,
                comments=record.comments if record is not None else 0,
                open_comments=record.open_comments if record is not None else 0,
                jac=scores.get(frame.name),
                origins={
                    k.value: n for k, n in count_points_by_origin(annotation, origins).items()
                },
                blind=work.value,
            )
        )
    return rows
