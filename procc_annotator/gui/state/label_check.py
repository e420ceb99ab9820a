"""What the label check found: in the frame on screen after every edit, in others when asked."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from procc_annotator.fit.labels.finding import Severity
from procc_annotator.gui.state.set_check import Checked, check_in_background
from procc_annotator.gui.worker import Job, run_in_background
from procc_annotator.session.frame_check import (
    SEVERITIES,
    Found,
    FrameCheck,
    check_without_fit,
    content_of,
    remember,
    surviving,
    worst_severity,
)

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document
    from procc_annotator.session.insight import Insight

_IGNORED = "ignored findings of "


class LabelCheck(QObject):
    """Findings by frame; none of them is ever older than the annotation it is shown with.

    Attributes:
        severities: which of them are listed and walked through.
        problems: frames that cannot be checked, and why.
        set_checked: whether the whole set was checked since it was opened.
    """

    changed = Signal()  # what is known of the frame on screen
    framesChanged = Signal(str)  # what is known of a frame (its name), or of many ("")
    currentChanged = Signal()
    progressed = Signal(int, int)  # frames checked, of how many; (0, 0) when it is over
    finished = Signal(int)  # frames that were checked

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self.severities: frozenset[Severity] = frozenset(SEVERITIES)
        self.problems: dict[str, str] = {}
        self.set_checked = False
        self._frames: dict[str, FrameCheck] = {}
        self._in_set: tuple[tuple[str, Found], ...] | None = None  # until anything changes
        self._current: tuple[str, str] | None = None  # frame and key
        self._arrived: deque[Checked] = deque()
        self._touched: set[str] = set()  # frames that changed while the set is being checked
        self._set_job: Job | None = None
        self._frame_job: Job | None = None
        self._content_known = (document.annotation, content_of(document.annotation))
        self._taken: Insight | None = None  # of the frame on screen, remembered already
        self._asked = ""  # content that the job of the frame on screen is about
        self._told: tuple[object, ...] = ()
        self.framesChanged.connect(self._look_at_set_again)
        document.review.statusChanged.connect(self._look_at_set_again)  # other windows ignore too
        document.live_fit.changed.connect(self.look)
        document.datasetChanged.connect(self._forget)
        document.fieldChanged.connect(self._take_field)
        document.frameChanged.connect(self.look)
        document.annotationChanged.connect(self.look)
        document.blindChanged.connect(self._show_anew)
        document.frameScoresChanged.connect(self._take_commit)
        document.framesEdited.connect(self._take_edited)

    # --- what is known ----------------------------------------------------------------------

    @property
    def shown(self) -> tuple[Found, ...]:
        """Findings of the frame on screen, the surest first, without those that are ignored."""
        frame = self._document.frame
        return self.of(frame.name) if frame is not None else ()

    @property
    def checked(self) -> FrameCheck | None:
        """The check of the frame on screen; None while it is under way."""
        frame = self._document.frame
        kept = self._frames.get(frame.name) if frame is not None else None
        return kept if kept is not None and kept.content == self._content() else None

    def _content(self) -> str:
        """Of the annotation on screen; asked for with every move of the mouse."""
        annotation = self._document.annotation
        if annotation is not self._content_known[0]:
            self._content_known = annotation, content_of(annotation)
        return self._content_known[1]

    def of(self, frame: str) -> tuple[Found, ...]:
        """Findings of a frame, as far as it was checked and blind mode lets them be seen."""
        kept = self._frames.get(frame)
        if kept is None or not kept.found:
            return ()
        ignored, allowed = self.ignored(frame), self._fit_allowed(frame)
        return tuple(
            found
            for found in kept.found
            if found.key not in ignored and (allowed or not found.needs_fit)
        )

    def is_known(self, frame: str) -> bool:
        """Whether a frame was checked by every rule that may be shown."""
        kept = self._frames.get(frame)
        return kept is not None and (kept.fitted or not self._fit_allowed(frame))

    def severities_of(self, frame: str) -> frozenset[Severity] | None:
        """How sure the findings of a frame are; None if it was not checked."""
        if not self.is_known(frame):
            return None
        return frozenset(found.finding.severity for found in self.of(frame))

    def worst(self, frame: str) -> Severity | None:
        """How sure the surest finding of a frame is; None for none."""
        return worst_severity(self.of(frame))

    def in_set(self) -> tuple[tuple[str, Found], ...]:
        """Every finding with its frame, in the order of the frames."""
        if self._in_set is None:
            workspace = self._document.workspace
            index = workspace.index if workspace is not None else {}
            names = sorted((n for n in self._frames if n in index), key=index.__getitem__)
            self._in_set = tuple((name, found) for name in names for found in self.of(name))
        return self._in_set

    def counts(self, found: Iterable[Found]) -> Mapping[Severity, int]:
        """How many of some findings there are of each severity."""
        counted = Counter(f.finding.severity for f in found)
        return {severity: counted[severity] for severity in SEVERITIES}

    @property
    def known_frames(self) -> int:
        """How many frames were checked."""
        return sum(self.is_known(name) for name in self._frames)

    @property
    def fit_shown(self) -> bool:
        """Whether findings that hang on a camera are looked for in the frame on screen."""
        return self._document.live_fit.wanted and self._document.projection_visible

    def _fit_allowed(self, frame: str) -> bool:
        document = self._document
        return not document.blind or document.review.record(frame).committed

    # --- the current finding ----------------------------------------------------------------

    @property
    def current(self) -> Found | None:
        """The finding that was walked to or chosen, if it is still one of the frame on screen."""
        frame = self._document.frame
        if frame is None or self._current is None or self._current[0] != frame.name:
            return None
        return next((f for f in self.shown if f.key == self._current[1]), None)

    def set_current(self, frame: str, found: Found | None) -> None:
        """Choose a finding of a frame, or none."""
        chosen = (frame, found.key) if found is not None else None
        if chosen != self._current:
            self._current = chosen
            self.currentChanged.emit()

    def set_severities(self, severities: Iterable[Severity]) -> None:
        """List and walk through findings that are as sure as this only."""
        self.severities = frozenset(severities)
        self.framesChanged.emit("")

    # --- ignoring -----------------------------------------------------------------------------

    def ignored(self, frame: str) -> frozenset[str]:
        """Keys of the findings that somebody looked at and let be."""
        database = self._document.review.database
        kept = database.setting(_IGNORED + frame) if database is not None else None
        return frozenset(kept.split()) if kept else frozenset()

    def ignored_here(self) -> int:
        """How many findings of the frame on screen are ignored."""
        frame = self._document.frame
        kept = self._frames.get(frame.name) if frame is not None else None
        if frame is None or kept is None:
            return 0
        ignored = self.ignored(frame.name)
        return sum(found.key in ignored for found in kept.found)

    def ignore(self, frame: str, key: str) -> None:
        """Show a finding no more, as long as the points of its elements stay as they are."""
        kept = self._frames.get(frame)
        # Keys of points that were changed since mean nothing any more.
        known = {found.key for found in kept.found} if kept is not None else set()
        self._set_ignored(frame, (self.ignored(frame) & known) | {key})

    def restore(self, frame: str, key: str | None = None) -> None:
        """Show an ignored finding of a frame again, or all of them."""
        self._set_ignored(frame, self.ignored(frame) - {key} if key is not None else frozenset())

    def _set_ignored(self, frame: str, keys: Iterable[str]) -> None:
        database = self._document.review.database
        if database is not None:
            database.set_setting(_IGNORED + frame, " ".join(sorted(keys)) or None)
            self._tell(frame)

    # --- the frame on screen --------------------------------------------------------------------

    def look(self) -> None:
        """The frame on screen, its annotation or its fit may be other than before."""
        document = self._document
        frame = document.frame
        if frame is None:
            self._announce()
            return
        size = document.picture_size or document.setup.size
        insight = document.live_fit.insight
        if insight is not None:
            if insight is not self._taken or frame.name not in self._frames:
                self._taken = insight
                self._take(frame.name, remember(insight.annotation, insight.findings, insight.fit))
            else:
                self._announce()
            return
        self._taken = None
        content = self._content()
        kept = self._frames.get(frame.name)
        if kept is not None and kept.content != content:
            # Signs of elements that nobody touched stay until more is known.
            self._frames[frame.name] = left = surviving(kept, document.annotation)
            if left.found != kept.found:
                self.framesChanged.emit(frame.name)
        if (kept is None or kept.content != content) and not self.fit_shown:
            self._check_without_fit(frame.name, content, size)
        self._announce()

    def _announce(self) -> None:
        """Say so if what is known of the frame on screen is other than what was said last: every
        listener draws or lists it anew."""
        frame = self._document.frame
        told = frame.name if frame is not None else None, self.shown, self.checked is not None
        if told != self._told:
            self._told = told
            self.changed.emit()

    def _check_without_fit(self, name: str, content: str, size: tuple[int, int]) -> None:
        """No fit is to come for the frame on screen: look at the rules that need none."""
        if content == self._asked and self._frame_job is not None:
            return
        self._drop_frame_job()
        self._asked = content
        annotation, field = self._document.annotation, self._document.field

        def done(checked: FrameCheck) -> None:
            self._frame_job = None
            kept = self._frames.get(name)
            if kept is None or kept.content != checked.content:
                self._take(name, checked)

        def failed(text: str) -> None:
            self._frame_job = None
            self._document.message.emit(text, "warning")

        self._frame_job = run_in_background(
            lambda _: check_without_fit(annotation, field, size=size),
            on_result=done,
            on_error=failed,
            owner=self,
            urgent=True,
        )

    def _take(self, name: str, checked: FrameCheck) -> None:
        self._touched.add(name)
        self.problems.pop(name, None)
        self._frames[name] = checked
        self._tell(name)

    def _look_at_set_again(self, _: str) -> None:
        self._in_set = None

    def _tell(self, name: str) -> None:
        self._in_set = None
        frame = self._document.frame
        if frame is not None and frame.name == name:
            self._announce()
        self.framesChanged.emit(name)

    def _show_anew(self, _: bool) -> None:
        """Blind mode may have come or gone: other findings may be seen."""
        self.look()
        self.framesChanged.emit("")

    def _take_commit(self, name: str) -> None:
        """In blind mode a committed frame may show what it hid."""
        if self._document.blind and name:
            self.look()
            self.framesChanged.emit(name)

    def _take_edited(self, indices: list[int]) -> None:
        """Annotations were changed all over the set: what was found there is of the past."""
        workspace = self._document.workspace
        if workspace is None:
            return
        for index in indices:
            name = workspace.frames[index].name
            self._touched.add(name)
            self._frames.pop(name, None)
            self.problems.pop(name, None)
        self.framesChanged.emit("")
        self.look()

    # --- the whole set ------------------------------------------------------------------------

    @property
    def running(self) -> bool:
        """Whether the set is being checked."""
        return self._set_job is not None

    def check_set(self) -> None:
        """Check every annotated frame in the background; the frame on screen is known already."""
        document = self._document
        workspace = document.workspace
        if workspace is None or self._set_job is not None:
            return
        self._touched.clear()
        self.problems.clear()
        arrived: deque[Checked] = deque()
        self._arrived = arrived
        self._set_job = check_in_background(
            workspace,
            document.field,
            document.live_fit.model,
            arrived,
            on_progress=self._progressed,
            on_done=self._finished,
            on_error=self._failed,
            owner=self,
        )
        self.progressed.emit(0, len(workspace.frames))

    def stop(self) -> None:
        """Stop checking the set; what was found so far stays."""
        if self._set_job is not None:
            self._set_job.cancel()
            self._end()

    def close(self) -> None:
        """Stop everything that runs in the background."""
        self._drop_frame_job()
        if self._set_job is not None:
            self._set_job.cancel()
            self._set_job = None

    def _progressed(self, done: int, total: int) -> None:
        if self._take_arrived():
            self.framesChanged.emit("")
        self.progressed.emit(done, total)

    def _finished(self, checked: int) -> None:
        self.set_checked = True
        self._end()
        self.finished.emit(checked)

    def _failed(self, text: str) -> None:
        self._end()
        self._document.message.emit(text, "error")

    def _end(self) -> None:
        self._set_job = None
        self._take_arrived()
        self.progressed.emit(0, 0)
        self.framesChanged.emit("")
        self._announce()

    def _take_arrived(self) -> bool:
        """Keep what the background found, but of frames that changed meanwhile."""
        any_new = False
        while self._arrived:
            name, checked = self._arrived.popleft()
            if name in self._touched:
                continue
            any_new = True
            if isinstance(checked, FrameCheck):
                self._frames[name] = checked
            else:
                self._frames.pop(name, None)
                self.problems[name] = checked
        return any_new

    def _drop_frame_job(self) -> None:
        if self._frame_job is not None:
            self._frame_job.cancel()
            self._frame_job = None
        self._asked = ""

    def _take_field(self) -> None:
        """The field has other dimensions: what was found hangs on them."""
        self._forget()
        self.look()

    def _forget(self) -> None:
        """Nothing of what was found counts any more, as when another dataset was opened."""
        self.close()
        self._frames.clear()
        self.problems.clear()
        self._touched.clear()
        self.set_checked = False
        self._current = None
        self.progressed.emit(0, 0)
        self.framesChanged.emit("")
        self.currentChanged.emit()
