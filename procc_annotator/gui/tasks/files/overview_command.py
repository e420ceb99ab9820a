"""The overview of the set: gathered in the background, shown in a window of its own, exported."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TypeVar

from PySide6.QtWidgets import QFileDialog, QWidget

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.gui.panels.overview.dialog import OverviewWindow
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.io.atomic import write_atomic
from procc_annotator.report.overview import OverviewRow, overview_csv, summarise
from procc_annotator.session.database.database import WorkspaceDatabase
from procc_annotator.session.dataset.workspace import Workspace
from procc_annotator.session.facts.blind_work import BlindWork, setting_of, work_of
from procc_annotator.session.facts.origins import Origin, PointKey
from procc_annotator.session.facts.provenance import count_origins

T = TypeVar("T")


class OverviewCommand:
    """Opens the overview and keeps it up to date while it is open."""

    def __init__(self, document: Document, parent: QWidget) -> None:
        self._document = document
        self._parent = parent
        self._refreshing: Job | None = None
        self.window: OverviewWindow | None = None

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
        window, field = self.window, self._document.field
        if window is not None:
            if self._refreshing is not None:
                self._refreshing.cancel()
            self._refreshing = self._gather(
                lambda rows: summarise(rows, field), window.show_overview
            )

    def export(self) -> None:
        """Ask for a file and write one row a frame."""
        frame = self._document.frame
        if frame is None:
            self._document.say("open a folder of pictures first", "warning")
            return
        start = frame.image_path.parent.parent / "overview.csv"
        chosen, _ = QFileDialog.getSaveFileName(
            self._parent, "Export the overview", str(start), "Table (*.csv)"
        )
        if chosen:
            self.write(Path(chosen))

    def write(self, path: Path) -> None:
        """Write one row a frame as CSV."""
        document = self._document

        def write(rows: list[OverviewRow]) -> int:
            write_atomic(path, overview_csv(rows).encode())
            return len(rows)

        scoring = document.set_scores.running
        more = "; the set was being scored still: some frames have no JaC yet" if scoring else ""

        def tell(count: int) -> None:
            document.say(f"exported {count} frames to {path}{more}")

        self._gather(write, tell, complete=True)

    def _gather(
        self,
        use: Callable[[list[OverviewRow]], T],
        then: Callable[[T], None],
        *,
        complete: bool = False,
    ) -> Job | None:
        """Give the rows of all frames to ``use``, in the background, and its result to ``then``."""
        document = self._document
        workspace, database = document.workspace, document.review.database
        if workspace is None:
            then(use([]))
            return None
        document.review.note_activity()
        scores = dict(document.frame_scores.items())

        def work(control: JobControl) -> T:
            return use(gather_rows(workspace, database, scores, control, complete=complete))

        return run_in_background(
            work,
            on_result=then,
            on_error=lambda text: document.say(text, "error"),
            owner=document,
        )


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
        Stopped: nobody wants the rows any more.
        InputError: not all that is to be ``complete`` can be read from the database.
    """
    rows: list[OverviewRow] = []
    for index, frame in enumerate(workspace.frames):
        if control is not None:
            control.progress_or_stop(index, len(workspace.frames))
        work = BlindWork.UNKNOWN
        try:
            annotation = workspace.read(index)
        except InputError:  # told when that frame is opened
            annotation = FrameAnnotation()
        else:
            if database is not None:
                work = work_of(database.setting(setting_of(frame.name)), annotation)
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
                origins={k.value: n for k, n in count_origins(annotation, origins).items()},
                blind=work.value,
            )
        )
    return rows
