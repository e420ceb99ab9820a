"""Finds the frames a filter asks for, in the background where files must be read for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

from PySide6.QtCore import QObject, Signal

from procc_annotator.dataset.filter_query import FrameFacts, FrameQuery, parse_query
from procc_annotator.dataset.records import FrameRecord, Status, Verdict
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError, UsageError
from procc_annotator.gui.latest import Latest
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.scoring.dataset_scores import FrameScores
from procc_annotator.gui.worker import JobControl

_MANY = 500  # frames that are asked on the interface thread at most


class FrameFilter(QObject):
    """Turns the filter's text into the indices of matching frames; None means all of them."""

    found = Signal(object)  # list[int] | None
    problem = Signal(str)  # what is wrong with the text, or still missing; "" when nothing is

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._text = ""
        self._query = parse_query("", document.state.field)
        document.store.watch(select.field, lambda: self.set_text(self._text))
        self._searching = Latest(self, self.problem.emit)

    @property
    def depends_on_work(self) -> bool:
        """Return whether an edit, a status or a score can change what matches."""
        return not self._query.is_empty

    def set_text(self, text: str) -> None:
        """Read a filter; one that cannot be read leaves the frames as they are."""
        self._text = text
        try:
            query = parse_query(text, self._document.state.field)
        except UsageError as error:
            self.problem.emit(str(error))
            return
        self._query = query
        self.problem.emit(query.incomplete)
        self.search()

    def search(self) -> None:
        """Ask all frames again."""
        self._searching.cancel()
        workspace = self._document.state.workspace
        if workspace is None or self._query.is_empty:
            self.found.emit(None)
            return
        query, ask = self._query, self._asker(workspace)
        if len(workspace.frames) <= _MANY and not query.needs_annotation:
            self.found.emit(_matching(query, ask, len(workspace.frames), None))
            return

        def work(control: JobControl) -> list[int]:
            return _matching(query, ask, len(workspace.frames), control)

        self._searching.start(work, self.found.emit)

    def _asker(self, workspace: Workspace) -> Callable[[int], FrameFacts]:
        """Return what is known of each frame, from values that another thread may look at."""
        document = self._document
        database = document.review.database
        records: Mapping[str, FrameRecord] = dict(database.records()) if database else {}
        unsaved = frozenset(document.state.unsaved)
        source = document.state.active
        broken = frozenset(source.problems) if source is not None else frozenset()
        cameras = source.camera_set.frames if source is not None else {}
        audits, tau = dict(document.auditing.active_audits), document.state.tau
        drafts = frozenset(database.drafts()) if database is not None else frozenset()
        needs_annotation, reveals = self._query.needs_annotation, document.state.reveals
        allowed = document.auditing.frame_scores.allowed
        verdicts = _Verdicts(document.review.all_verdicts(), allowed)
        asked = workspace.frames if self._query.needs_check else ()
        findings = {f.name: document.label_check.known.severities_of(f.name) for f in asked}

        def jac(name: str, at: float | None) -> float | None:
            return FrameScores(audits, at if at is not None else tau, allowed).get(name)

        def ask(index: int) -> FrameFacts:
            name = workspace.frames[index].name
            record = records.get(name)
            annotated, unreadable = None, False
            if needs_annotation:
                try:
                    annotated = workspace.read(index).annotated
                except InputError:
                    unreadable = True
            has_comments = record is not None and record.comments > 0
            return FrameFacts(
                name=name,
                status=(record.status if record is not None else Status.UNTOUCHED).value,
                annotated=annotated,
                comments=record.comments if record is not None else 0,
                open_comments=record.open_comments if record is not None else 0,
                comment_text=database.comment_text(name) if database and has_comments else "",
                unsaved=index in unsaved,
                unreadable=unreadable,
                unconfirmed=name in drafts,
                jac=partial(jac, name),
                verdicts=verdicts.faults_in(name),
                findings=findings.get(name),
                has_camera=None if name in broken and reveals(name) else name in cameras,
            )

        return ask


@dataclass(frozen=True)
class _Verdicts:
    """Whose fault scores are, of the frames of which that may be known (None: of all)."""

    by_frame: Mapping[str, Mapping[str, Verdict]]
    allowed: Callable[[str], bool] | None

    def faults_in(self, name: str) -> frozenset[str]:
        """Return what was said of a frame under any source."""
        if name not in self.by_frame or (self.allowed is not None and not self.allowed(name)):
            return frozenset()
        return frozenset(str(verdict.fault) for verdict in self.by_frame[name].values())


def _matching(
    query: FrameQuery, ask: Callable[[int], FrameFacts], count: int, control: JobControl | None
) -> list[int]:
    rows: list[int] = []
    for index in range(count):
        if control is not None and control.cancelled:
            break
        if query.matches(ask(index)):
            rows.append(index)
    return rows
