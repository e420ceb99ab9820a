"""The label check: of the frame on screen after every edit, of the whole set on request."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.assist.frame_analysis import FrameAnalysis
from procc_annotator.assist.line_evidence import confirmed_evidence, line_evidence
from procc_annotator.batch.label_check import Checked
from procc_annotator.calibration.label_check.check import add_line_evidence
from procc_annotator.calibration.label_check.evidence import LineEvidence
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
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import ComputedValue, Inputs
from procc_annotator.gui.state.checking.known_checks import KnownChecks
from procc_annotator.gui.state.checking.runner import CheckRunner
from procc_annotator.gui.state.messages import notify, say, withdraw
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.scoring.frame_score import FrameScorer
from procc_annotator.gui.state.state import BENT, same
from procc_annotator.gui.state.store import Store
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import tr

Evidence = Mapping[Polyline, LineEvidence]
_STAYED_MS = 150  # a frame that is left sooner was only passed
_KEPT_EVIDENCE = 8


class LinePixels(ComputedValue[Evidence]):
    """Line pixels along each element; from the picture alone, so that blind mode may show them.

    An element that did not change is not examined again.

    Attributes:
        shown: whether a person wants to see it next to the annotation; findings go by it anyway.
    """

    def __init__(self, store: Store) -> None:
        super().__init__(
            self._made_of,
            self._look_for,
            store,
            cache_size=_KEPT_EVIDENCE,
            cache_scope=lambda: store.state.frame_name,  # each holds the frame's picture
            stoppable=True,
            delay_ms=self._wait,
        )
        self._store, self.shown = store, False
        store.keep_current(self)
        self._frame: str | None = None
        self._before: tuple[tuple[object, ...], Evidence] | None = None  # picture and field

    def set_shown(self, shown: bool) -> None:
        """Draw it next to the annotation, or do not."""
        if shown != self.shown:
            self.shown = shown
            self.changed.emit()

    # --- inside ---

    def _made_of(self) -> Inputs | None:
        state = self._store.state
        if state.picture is None:
            return None
        return state.annotation, state.picture, state.field

    def _wait(self, _: Inputs) -> int:
        name, before = self._store.state.frame_name, self._frame
        self._frame = name
        return _STAYED_MS if name != before else 0

    def _look_for(
        self,
        annotation: FrameAnnotation,
        picture: PixelArray,
        field: Field,
        *,
        go_on: Callable[[], None],
    ) -> Evidence:
        """Find line pixels; runs in a thread, one at a time."""
        of, before = (picture, field), self._before
        known = before[1] if before is not None and same(before[0], of) else None
        found = line_evidence(annotation, picture, field, known, go_on)
        self._before = of, found
        return found


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
        scorer: FrameScorer,
        paint: LinePixels,
    ) -> None:
        super().__init__(store)
        self._store, self._live_fit, self._scorer, self._paint = store, live_fit, scorer, paint
        self.severities: frozenset[Severity] = frozenset(Severity)
        self.problems: dict[str, str] = {}
        self.set_checked = False
        self.known = KnownChecks(store, review)
        self._current: tuple[str, str] | None = None  # frame and key
        self._runner = CheckRunner(
            store,
            live_fit,
            arrived=self._take_arrived,
            progressed=self.progressed.emit,
            finished=self._take_end,
        )
        self._check = ComputedValue(self._to_check, _check, self, cache_size=_KEPT)
        self._content = ComputedValue(self._annotation, content_of, self, background=False)
        self._committed = store.state.committed
        self._shown: tuple[object, ...] = ()  # what was signalled last of the frame on screen
        self._bent: str | None = None  # the finding that is shown as a notice
        self._connect(store, review)

    def _connect(self, store: Store, review: ReviewState) -> None:
        store.keep_current(self._check, self._live_fit.changed, self._paint.changed)
        self._check.changed.connect(self._look)
        self._check.failed.connect(partial(say, store, level="warning"))
        self.framesChanged.connect(self.known.look_at_set_again)
        review.settingChanged.connect(self._take_setting)
        review.statusChanged.connect(self.known.look_at_set_again)  # committed elsewhere
        store.watch(select.dataset, self._forget)
        store.watch(select.field, self._forget)
        store.watch(select.annotation, self._look)
        store.watch(select.blind, self._take_blind)
        store.watch(select.committed, self._take_commit)
        store.events.annotationEdited.connect(self._note_edit)
        store.events.framesEdited.connect(self._take_edited)

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
        return (self.fit_shown and self._live_fit.working) or self._check.working

    def _annotation(self) -> Inputs:
        return (self._store.state.annotation,)

    @property
    def fit_shown(self) -> bool:
        """Return whether findings that hang on a camera are looked for in the frame on screen."""
        return self._live_fit.wanted and self._store.state.projection_visible

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

    def _look(self) -> None:
        """The frame on screen, its annotation or its check may be others."""
        name, found = self._store.state.frame_name, self._check.value
        if name is None:
            self._announce()
        elif found is None:
            self._keep_valid(name)
            self._announce()
        elif (before := self.known.frames.get(name)) is not found:
            self._take(name, found)
            self._check.invalidate()
            if before is not None and found.fitted:
                self._show_bent(before)

    def _take(self, name: str, found: FrameCheck) -> None:
        self._runner.drop(name)
        self.problems.pop(name, None)
        self.known.frames[name] = found
        self._signal(name)

    def _keep_valid(self, name: str) -> None:
        """Keep the findings of elements that were not touched until more is known."""
        kept = self.known.check_of(name)
        if kept is not None and kept.content != self._content.value:
            left = still_valid(kept, self._store.state.annotation)
            self.known.frames[name] = left
            if left.found != kept.found:
                self.framesChanged.emit(name)

    def _to_check(self) -> Inputs | None:
        """The frame on screen with its fit, or by the rules that need none."""
        state, evidence = self._store.state, self._paint.value
        name, field = state.frame_name, self._scorer.frame_setup.field
        if name is None:
            return None
        if self.fit_shown:
            insight, kept = self._live_fit.insight, self.known.frames.get(name)
            # Findings of the picture are not to go and come with every click.
            waits = kept is not None and kept.with_paint and self._paint.working
            return None if insight is None or waits else (insight, field, None, name, evidence)
        kept = self.known.check_of(name)
        is_same = kept is not None and kept.content == self._content.value
        if kept is not None and is_same and kept.with_paint >= (evidence is not None):
            return None
        return state.annotation, field, state.picture_size or state.setup.size, name, evidence

    def _show_bent(self, before: FrameCheck) -> None:
        """Notify of a new finding that an element runs beside its bent line pixels: it spoils
        everything that follows from the clicks."""
        known = {found.key for found in before.found}
        for found in self.shown:
            if found.finding.rule is Rule.BESIDE_PAINT and found.key not in known:
                self._bent = found.key
                notify(self._store, BENT, tr(found.finding.reason))

    def _announce(self) -> None:
        """Signal what is known of the frame on screen, if it differs from the last time."""
        if self._bent is not None and all(found.key != self._bent for found in self.shown):
            self._bent = None
            withdraw(self._store, BENT)
        shown = self._store.state.frame_name, self.shown, self.checked is not None
        if shown != self._shown:
            self._shown = shown
            self.changed.emit()

    def _take_setting(self, setting: str) -> None:
        if (frame := self.known.take_setting(setting)) is not None:
            self._signal(frame)

    def _signal(self, name: str) -> None:
        self.known.look_at_set_again()
        if name == self._store.state.frame_name:
            self._announce()
        self.framesChanged.emit(name)

    def _take_blind(self) -> None:
        self.set_checked = False
        self._look()
        self.framesChanged.emit("")
        if self.running:
            self.check_set()

    def _take_commit(self) -> None:
        """In blind mode a committed frame may show what it hid."""
        before, self._committed = self._committed, self._store.state.committed
        for name in (before ^ self._committed) if self._store.state.blind else ():
            if self.known.check_of(name) is not None and not self.known.is_known(name):
                self._runner.add(name)
            self._look()
            self.framesChanged.emit(name)

    def _note_edit(self) -> None:
        name = self._store.state.frame_name
        if name is not None and self.checked is None:
            self._runner.add(name)

    def _take_edited(self, indices: list[int]) -> None:
        """Annotations were changed all over the set: what was found there is of the past."""
        workspace = self._store.state.workspace
        if workspace is None:
            return
        for index in indices:
            name = workspace.frames[index].name
            checked = self.known.frames.pop(name, None), self.problems.pop(name, None)
            if checked != (None, None):
                self._runner.add(name)
        self.framesChanged.emit("")
        self._look()

    # --- the whole set ------------------------------------------------------------------------

    @property
    def running(self) -> bool:
        """Return whether the set is being checked."""
        return self._runner.running

    def check_set(self) -> None:
        """Check every annotated frame in the background, with a camera even where the live fit is
        off; in blind mode only the committed frames with a camera."""
        self.problems.clear()
        self._runner.check_set()

    def stop(self) -> None:
        """Stop checking the set; what was found so far stays."""
        self._runner.stop()

    def close(self) -> None:
        """Stop checking the set and edited frames."""
        self._runner.close()

    def _take_end(self, checked: int, from_set: dict[str, FrameCheck]) -> None:
        self.known.keep_set_findings(from_set)
        self._announce()
        self.set_checked = True
        self.framesChanged.emit("")
        self.finished.emit(checked)

    def _take_arrived(self, results: list[Checked]) -> None:
        """Keep what the background found, but of frames that changed meanwhile."""
        for name, checked in results:
            if isinstance(checked, str):
                self.known.frames.pop(name, None)
                self.problems[name] = checked
            elif not self._is_newest(name, checked):
                self._runner.add(name)
            elif self._store.state.reveals(name) or not checked.fitted:
                self.problems.pop(name, None)
                self.known.frames[name] = checked
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

    def _forget(self) -> None:
        """Another dataset or field: no finding is valid any more."""
        self._check.clear()
        self._runner.close()
        self.known.forget()
        self.problems.clear()
        self.set_checked = False
        self._current = None
        self.progressed.emit(0, 0)
        self.framesChanged.emit("")
        self.currentChanged.emit()
        self._check.invalidate()


def _check(
    checked: FrameAnalysis | FrameAnnotation,
    field: Field,
    size: tuple[int, int] | None,
    _frame: str,
    evidence: Evidence | None,
) -> FrameCheck:
    annotation = checked.annotation if isinstance(checked, FrameAnalysis) else checked
    paint = None if evidence is None else confirmed_evidence(annotation, evidence)
    if isinstance(checked, FrameAnnotation):
        assert size is not None
        return check_without_fit(annotation, field, size=size, paint=paint)
    found, fit = checked.findings, checked.fit
    if paint is not None:
        found = add_line_evidence(found, annotation, field, size=fit.size, fit=fit, paint=paint)
    return store_check(annotation, found, fit, with_paint=evidence is not None)
