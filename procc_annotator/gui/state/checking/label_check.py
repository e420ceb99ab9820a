"""What the label check found: in the frame on screen after every edit, in others when asked."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.frame_analysis import FrameAnalysis
from procc_annotator.assist.line_evidence import confirmed_evidence
from procc_annotator.batch.label_check import Checked
from procc_annotator.calibration.label_check.check import add_line_evidence
from procc_annotator.calibration.label_check.finding import Rule, Severity
from procc_annotator.dataset.review import (
    FrameCheck,
    StoredFinding,
    check_without_fit,
    content_of,
    still_valid,
    store_check,
)
from procc_annotator.field.model import Field
from procc_annotator.gui.soon import soon
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.checking.check_queue import CheckQueue
from procc_annotator.gui.state.checking.known_checks import IgnoredFindings, KnownChecks
from procc_annotator.gui.state.checking.line_pixels import Evidence, PaintWatch
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.gui.state.messages import BENT
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.saying import notify, say, withdraw
from procc_annotator.gui.state.scoring.frame_score import Judge
from procc_annotator.gui.state.state import same
from procc_annotator.gui.state.store import Store
from procc_annotator.translation import tr

_KEPT = 16  # checks of the frame on screen, of steps of undo one may come back to


class LabelCheck(QObject):
    """Findings by frame; none of them is ever older than the annotation it is shown with.

    Attributes:
        severities: which of them are listed and walked through.
        known: what was found, by frame.
        problems: frames that cannot be checked, and why.
        set_checked: whether the whole set was checked since it was opened.
    """

    changed = Signal()  # what is known of the frame on screen
    framesChanged = Signal(str)  # what is known of a frame (its name), or of many ("")
    currentChanged = Signal()
    progressed = Signal(int, int)  # frames checked, of how many; (0, 0) when it is over
    finished = Signal(int)  # frames that were checked

    def __init__(
        self,
        store: Store,
        review: ReviewState,
        live_fit: LiveFit,
        judge: Judge,
        paint: PaintWatch,
    ) -> None:
        super().__init__(store)
        self._store, self._live_fit, self._judge = store, live_fit, judge
        self._paint = paint
        self.severities: frozenset[Severity] = frozenset(Severity)
        self.problems: dict[str, str] = {}
        self.set_checked = False
        self.ignored = IgnoredFindings(review, self)
        self.known = KnownChecks(store, self.ignored)
        self._current: tuple[str, str] | None = None  # frame and key
        self._queue = CheckQueue(store, live_fit, self)
        self._without_fit = Derived(self._to_check, _check, Where.BESIDE, self)
        self._with_fit = Derived(self._fitted, _remembered, Where.AT_ONCE, self, kept=_KEPT)
        self._content = Derived(self._annotation, content_of, Where.AT_ONCE, self)
        # Of the frame on screen, remembered already: what its clicks say, what its picture shows.
        self._taken: tuple[FrameAnalysis, Evidence | None] | None = None
        self._committed = store.state.committed
        self._told: tuple[object, ...] = ()
        self._look_soon = soon(self, self.look)
        self._bent: str | None = None  # the finding that is told as a notice
        self._connect(review)

    def _connect(self, review: ReviewState) -> None:
        self._without_fit.changed.connect(self._take_without_fit)
        self._without_fit.failed.connect(self._warn)
        self.framesChanged.connect(self.known.look_at_set_again)
        self.ignored.changed.connect(self._tell)
        review.statusChanged.connect(self.known.look_at_set_again)  # committed elsewhere
        self._live_fit.changed.connect(self._look_soon.start)
        self._paint.changed.connect(self._look_soon.start)
        store = self._store
        store.watch(select.dataset, self._forget)
        store.watch(select.field, self._take_field)
        store.watch(select.annotation, self.look)
        store.events.annotationEdited.connect(self._note_edit)
        store.watch(select.blind, self._show_anew)
        store.watch(select.committed, self._take_commit)
        store.events.framesEdited.connect(self._take_edited)
        self._queue.arrived.connect(self._take_arrived)
        self._queue.progressed.connect(self.progressed)
        self._queue.told.connect(self._take_told)
        self._queue.finished.connect(self._take_end)

    # --- what is known ----------------------------------------------------------------------

    @property
    def shown(self) -> tuple[StoredFinding, ...]:
        """Findings of the frame on screen, the surest first, without those that are ignored."""
        name = self._store.state.frame_name
        return self.known.of(name) if name is not None else ()

    @property
    def checked(self) -> FrameCheck | None:
        """The check of the frame on screen; None while it is under way."""
        name = self._store.state.frame_name
        kept = self.known.check_of(name) if name is not None else None
        return kept if kept is not None and kept.content == self._content.value else None

    @property
    def working(self) -> bool:
        """Return whether the frame on screen is still examined, as it is now: more may be found."""
        if self._store.state.frame_name is None:
            return False
        return (self.fit_shown and self._live_fit.working) or self._without_fit.working

    def _annotation(self) -> Inputs:
        return (self._store.state.annotation,)

    @property
    def fit_shown(self) -> bool:
        """Return whether findings that hang on a camera are looked for in the frame on screen."""
        return self._live_fit.wanted and self._live_fit.allowed

    # --- the current finding ----------------------------------------------------------------

    @property
    def current(self) -> StoredFinding | None:
        """The finding that was walked to or chosen, if it is still one of the frame on screen."""
        if self._current is None or self._current[0] != self._store.state.frame_name:
            return None
        return next((f for f in self.shown if f.key == self._current[1]), None)

    def set_current(self, frame: str, found: StoredFinding | None) -> None:
        """Choose a finding of a frame, or none."""
        chosen = (frame, found.key) if found is not None else None
        if chosen != self._current:
            self._current = chosen
            self.currentChanged.emit()

    def set_severities(self, severities: Iterable[Severity]) -> None:
        """List and walk through findings that are as sure as this only."""
        self.severities = frozenset(severities)
        self.framesChanged.emit("")

    # --- the frame on screen --------------------------------------------------------------------

    def look(self) -> None:
        """The frame on screen, its annotation or its fit may be other than before."""
        name, annotation = self._store.state.frame_name, self._store.state.annotation
        if name is None:
            self._announce()
            return
        insight = self._live_fit.insight
        if insight is not None and not self._waits_for_paint(name):
            taken = insight, self._paint.value
            if self._taken is None or not same(taken, self._taken) or self.known.get(name) is None:
                self._taken = taken
                before = self.known.get(name)
                if (checked := self._with_fit.value) is not None:
                    self._take(name, checked)
                if before is not None:
                    self._say_bent(before)
            else:
                self._announce()
            self._without_fit.look()
            return
        self._taken = None
        content = self._content.value
        kept = self.known.check_of(name)
        if kept is not None and kept.content != content:
            # Signs of elements that no one touched stay until more is known.
            left = still_valid(kept, annotation)
            self.known.keep(name, left)
            if left.found != kept.found:
                self.framesChanged.emit(name)
        self._without_fit.look()
        self._announce()

    def _waits_for_paint(self, name: str) -> bool:
        """Return whether what an edit does to the paint under it is known in a moment: signs of the
        picture are not to go and come with every click."""
        kept = self.known.get(name)
        return kept is not None and kept.with_paint and self._paint.working

    def _say_bent(self, before: FrameCheck) -> None:
        """What was clicked just now and lies next to its bent paint spoils whatever follows."""
        known = {found.key for found in before.found}
        for found in self.shown:
            if found.finding.rule is Rule.BESIDE_PAINT and found.key not in known:
                self._bent = found.key
                notify(self._store, BENT, tr(found.finding.reason))

    def _fitted(self) -> Inputs | None:
        """The frame on screen, with its picture as soon as that was examined."""
        insight = self._live_fit.insight
        field = self._judge.frame_setup.field
        return None if insight is None else (insight, self._paint.value, field)

    def _announce(self) -> None:
        """Say so if what is known of the frame on screen is other than what was said last: every
        listener draws or lists it anew."""
        if self._bent is not None and all(found.key != self._bent for found in self.shown):
            self._bent = None
            withdraw(self._store, BENT)
        told = self._store.state.frame_name, self.shown, self.checked is not None
        if told != self._told:
            self._told = told
            self.changed.emit()

    def _to_check(self) -> Inputs | None:
        """The frame on screen, if no fit of it is to come: by the rules that need none."""
        state = self._store.state
        name = state.frame_name
        if name is None or self.fit_shown:
            return None
        kept, paint = self.known.check_of(name), self._paint.value
        same_content = kept is not None and kept.content == self._content.value
        if kept is not None and same_content and kept.with_paint >= (paint is not None):
            return None
        size = state.picture_size or state.setup.size
        return state.annotation, self._judge.frame_setup.field, size, name, paint

    def _take_without_fit(self) -> None:
        name, found = self._store.state.frame_name, self._without_fit.value
        if name is not None and found is not None:
            self._take(name, found)
            self._without_fit.look()

    def _warn(self, text: str) -> None:
        say(self._store, text, "warning")

    def _take(self, name: str, checked: FrameCheck) -> None:
        self._queue.drop(name)
        self.problems.pop(name, None)
        self.known.keep(name, checked)
        self._tell(name)

    def _tell(self, name: str) -> None:
        self.known.look_at_set_again()
        if name == self._store.state.frame_name:
            self._announce()
        self.framesChanged.emit(name)

    def _show_anew(self) -> None:
        """Blind mode may have come or gone: other findings may be seen."""
        self.set_checked = False
        self.look()
        self.framesChanged.emit("")
        if self.running:
            self.check_set()

    def _take_commit(self) -> None:
        """In blind mode a committed frame may show what it hid."""
        before, self._committed = self._committed, self._store.state.committed
        for name in (before ^ self._committed) if self._store.state.blind else ():
            if self.known.check_of(name) is not None and not self.known.is_known(name):
                self._queue.add(name)
            self.look()
            self.framesChanged.emit(name)

    def _note_edit(self) -> None:
        name = self._store.state.frame_name
        if name is not None and self.checked is None:
            self._queue.add(name)

    def _take_edited(self, indices: list[int]) -> None:
        """Annotations were changed all over the set: what was found there is of the past."""
        workspace = self._store.state.workspace
        if workspace is None:
            return
        for index in indices:
            name = workspace.frames[index].name
            known = self.known.drop(name)
            if self.problems.pop(name, None) is not None or known:
                self._queue.add(name)
        self.framesChanged.emit("")
        self.look()

    # --- the whole set ------------------------------------------------------------------------

    @property
    def running(self) -> bool:
        """Return whether the set is being checked."""
        return self._queue.running

    def check_set(self) -> None:
        """Check every annotated frame in the background, with a camera even where the live fit is
        off; in blind mode only the committed frames with a camera."""
        self.problems.clear()
        self._queue.check_set()

    def stop(self) -> None:
        """Stop checking the set; what was found so far stays."""
        self._queue.stop()

    def close(self) -> None:
        """Stop everything that runs in the background."""
        self._look_soon.stop()
        self._without_fit.close()
        self._queue.close()

    def _take_told(self, checks: dict[str, FrameCheck]) -> None:
        self.known.keep_told(checks)
        self._announce()

    def _take_end(self, checked: int) -> None:
        self.set_checked = True
        self.framesChanged.emit("")
        self.finished.emit(checked)

    def _take_arrived(self, results: list[Checked]) -> None:
        """Keep what the background found, but of frames that changed meanwhile."""
        for name, checked in results:
            if isinstance(checked, str):
                self.known.drop(name)
                self.problems[name] = checked
            elif not self._is_newest(name, checked):
                self._queue.add(name)
            elif self._store.state.reveals(name) or not checked.fitted:
                self.problems.pop(name, None)
                self.known.keep(name, checked)
        self.framesChanged.emit("")
        self._announce()

    def _is_newest(self, name: str, checked: FrameCheck) -> bool:
        """Return whether a check is of what a frame holds now, as far as this window knows."""
        workspace = self._store.state.workspace
        index = workspace.index.get(name) if workspace is not None else None
        if workspace is None or index is None:
            return False
        annotation = workspace.loaded_annotation(index)
        return annotation is None or content_of(annotation) == checked.content

    def _take_field(self) -> None:
        """The field has other dimensions: what was found hangs on them."""
        self._forget()
        self.look()

    def _forget(self) -> None:
        """Nothing of what was found counts any more, as when another dataset was opened."""
        self._without_fit.forget()
        self._with_fit.forget()
        self._queue.close()
        self.known.forget()
        self.problems.clear()
        self.set_checked = False
        self._current = None
        self.progressed.emit(0, 0)
        self.framesChanged.emit("")
        self.currentChanged.emit()


def _remembered(insight: FrameAnalysis, evidence: Evidence | None, field: Field) -> FrameCheck:
    annotation, found, fit = insight.annotation, insight.findings, insight.fit
    if evidence is not None:
        paint = confirmed_evidence(annotation, evidence)
        found = add_line_evidence(found, annotation, field, size=fit.size, fit=fit, paint=paint)
    return store_check(annotation, found, fit, with_paint=evidence is not None)


def _check(
    annotation: FrameAnnotation,
    field: Field,
    size: tuple[int, int],
    _frame: str,
    evidence: Evidence | None,
) -> FrameCheck:
    paint = None if evidence is None else confirmed_evidence(annotation, evidence)
    return check_without_fit(annotation, field, size=size, paint=paint)
