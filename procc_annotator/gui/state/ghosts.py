"""The ghosts of the frame on screen: which are shown, which one is current, what was found of them;
and what to annotate next.

A ghost is known by its class: it outlives a new fit, which moves it a little. All that was found
along a ghost belongs to one insight and goes with it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from procc_annotator.fit.predict.ghosts import Ghost
from procc_annotator.fit.predict.suggestion import Suggestion
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.session.clicks.insight import Insight
from procc_annotator.session.strokes.ghost_points import GhostPoints, find_points

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document


class Ghosts(QObject):
    """Belongs to the document; knows no widget."""

    changed = Signal()  # which are shown, which one is current, what was found of it, what is next
    ended = Signal()  # the walk is over: there is no ghost left to go on to

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self._wanted = True
        self._frame: str | None = None
        self._sport = document.field.name
        self._insight: Insight | None = None
        self._painted: tuple[Ghost, ...] = ()
        self._suggesting = True
        self._suggestion: Suggestion | None = None
        self._latest: Insight | None = None  # of this frame, while a newer one is worked out too
        self._walking = False
        self._at: str | None = None  # the class where the walk is, or where it was left
        self._found: dict[str, GhostPoints] = {}
        self._job: Job | None = None
        self._told: tuple[object, ...] = ()
        document.live_fit.changed.connect(self._look)
        document.frameChanged.connect(self._look)
        document.annotationChanged.connect(self._look)
        document.review.notVisibleChanged.connect(self._look)

    # --- which ghosts there are -----------------------------------------------------------

    @property
    def wanted(self) -> bool:
        """Whether somebody wants to see ghosts."""
        return self._wanted

    def set_wanted(self, wanted: bool) -> None:
        """Show ghosts, or do not."""
        if wanted != self._wanted:
            self._wanted = wanted
            self._look()

    @property
    def insight(self) -> Insight | None:
        """What the ghosts follow from; None where none may be shown."""
        return self._document.live_fit.insight if self._wanted else None

    @property
    def known(self) -> tuple[Ghost, ...]:
        """The ghosts of the annotation on screen, in the order of the field; none while they are
        worked out, and none that somebody said cannot be seen."""
        insight = self.insight
        return self._in_order(insight.ghosts) if insight is not None else ()

    @property
    def painted(self) -> tuple[Ghost, ...]:
        """What to show: while new ghosts are worked out, those of before that are still missing,
        so that they do not flicker with every click."""
        return self._painted

    def _in_order(self, ghosts: tuple[Ghost, ...]) -> tuple[Ghost, ...]:
        hidden = self._hidden
        shown = (ghost for ghost in ghosts if ghost.name not in hidden)
        return tuple(sorted(shown, key=lambda ghost: self._rank(ghost.name)))

    @property
    def _hidden(self) -> frozenset[str]:
        frame = self._document.frame
        return self._document.review.not_visible(frame.name) if frame is not None else frozenset()

    def _rank(self, name: str) -> int:
        return self._document.field.index.get(name, len(self._document.field.elements))

    # --- what next ------------------------------------------------------------------------

    @property
    def suggesting(self) -> bool:
        """Whether somebody wants to be told what to annotate next, and may be."""
        live_fit = self._document.live_fit
        return self._suggesting and live_fit.wanted and live_fit.allowed

    def set_suggesting(self, suggesting: bool) -> None:
        """Say what to annotate next, or do not."""
        if suggesting != self._suggesting:
            self._suggesting = suggesting
            self._look()

    @property
    def suggestion(self) -> Suggestion | None:
        """The element that would make the projection surest, with how much; while that is worked
        out, the one of before if it is still missing."""
        return self._suggestion

    def _to_suggest(self) -> Suggestion | None:
        if not self.suggesting:
            return None
        insight = self._document.live_fit.insight
        if insight is not None:
            best = tuple(one for one in insight.suggestions if one.is_worthwhile)
        else:
            best = (self._suggestion,) if self._suggestion and self._may_come else ()
        off = self._hidden | self._there
        return next((one for one in best if one.name not in off), None)

    @property
    def suggested(self) -> tuple[str, ...]:
        """The classes worth annotating, the most helpful first, as far as is known now."""
        if not self.suggesting or self._latest is None:
            return ()
        off = self._hidden | self._there
        best = (one.name for one in self._latest.suggestions if one.is_worthwhile)
        return tuple(name for name in best if name not in off)

    @property
    def out_of_sight(self) -> frozenset[str]:
        """The classes that are not in this picture: the camera shows them elsewhere, or somebody
        said so."""
        latest = self._latest
        shown = latest.out_of_sight(self._document.field) if latest is not None else frozenset()
        return self._hidden | shown

    # --- the walk -------------------------------------------------------------------------

    @property
    def walking(self) -> bool:
        """Whether a walk through the ghosts is under way; it goes on while a fit is worked out."""
        return self._walking

    @property
    def current(self) -> Ghost | None:
        """The ghost that is looked at; None without a walk, and while a fit is worked out."""
        return self.named(self._at) if self._walking else None

    def named(self, name: str | None) -> Ghost | None:
        """The ghost of a class."""
        return next((ghost for ghost in self.known if ghost.name == name), None)

    def step(self, step: int) -> Ghost | None:
        """Go to the next ghost (1) or the one before (-1); None at the end of the walk.

        A walk that was left goes on behind the place where that was.
        """
        known, was_walking = self.known, self._walking
        beyond = self._beyond(known, step)
        if not beyond and not was_walking:
            beyond = known
        if not beyond:
            self.leave(at_end=True)
            return None
        ghost = beyond[0] if step > 0 else beyond[-1]
        self.go_to(ghost.name)
        return ghost

    def _beyond(self, known: tuple[Ghost, ...], step: int) -> tuple[Ghost, ...]:
        """The ghosts on one side of the place where the walk is."""
        if self._at is None:
            return known
        at = self._rank(self._at)
        return tuple(ghost for ghost in known if (self._rank(ghost.name) - at) * step > 0)

    @property
    def resumes(self) -> bool:
        """Whether the next step goes on behind the place where a walk was left."""
        return self._at is not None and bool(self._beyond(self._painted, 1))

    def go_to(self, name: str) -> None:
        """Look at the ghost of a class."""
        if self.named(name) is not None and not (self._walking and name == self._at):
            self._walking, self._at = True, name
            self._find()
            self.changed.emit()

    def leave(self, *, at_end: bool = False) -> None:
        """End the walk; ``at_end``: the next one begins from the start."""
        if at_end:
            self._at = None
        if self._walking:
            self._walking = False
            self.changed.emit()

    # --- what was found along them --------------------------------------------------------

    def found(self, name: str | None) -> GhostPoints | None:
        """The points that accepting the ghost of a class would add; None while they are looked
        for."""
        return self._found.get(name or "") if self._insight is self.insight else None

    def add_found(self, insight: Insight, found: GhostPoints) -> None:
        """Take over what was found elsewhere."""
        if insight is self._insight:
            self._found[found.name] = found

    def _find(self) -> None:
        """Look for the points of the current ghost, then for those of the next, in the
        background."""
        document, insight, ghost = self._document, self._insight, self._next_to_find()
        picture, size, field = document.picture, document.picture_size, document.field
        if self._job is not None or ghost is None or picture is None or size is None:
            return

        def work(control: JobControl) -> GhostPoints | None:
            return None if control.cancelled else find_points(ghost, picture, field, size)

        def take(found: GhostPoints | None) -> None:
            self._job = None
            if insight is not None and found is not None:
                self.add_found(insight, found)
            self._find()
            self.changed.emit()

        def fail(text: str) -> None:
            self._job = None
            title = field.title_of(ghost.name)
            document.message.emit(f"{title}: its line could not be looked for: {text}", "warning")

        self._job = run_in_background(work, on_result=take, on_error=fail, owner=self, urgent=True)

    def _next_to_find(self) -> Ghost | None:
        current = self.current
        if current is None:
            return None
        following = (current, *self._beyond(self.known, 1)[:1])
        return next((ghost for ghost in following if ghost.name not in self._found), None)

    def close(self) -> None:
        """Look for nothing any more."""
        if self._job is not None:
            self._job.cancel()
            self._job = None

    # --- keeping up -----------------------------------------------------------------------

    def _look(self) -> None:
        """The frame, the fit or what is wanted may be other than before."""
        document, insight = self._document, self.insight
        frame = document.frame.name if document.frame is not None else None
        sport = document.field.name
        if (frame, sport) != (self._frame, self._sport):
            self._sport = sport
            self._frame, self._at, self._walking = frame, None, False
            self._painted, self._suggestion, self._latest = (), None, None
        if insight is not self._insight:
            self._insight = insight
            self._found = {}
            self.close()
        fitted = document.live_fit.insight
        if fitted is not None or not self._may_come:
            self._latest = fitted
        self._painted = self._to_paint(insight)
        self._suggestion = self._to_suggest()
        waiting = insight is None and self._wanted and self._may_come
        if self._walking and self.current is None and not waiting:
            self._go_on()
        self._find()
        walk, wanted = (self._walking, self._at), (self._wanted, self.suggesting, self._hidden)
        told = insight, frame, self._painted, self._suggestion, walk, wanted
        if told != self._told:
            self._told = told
            self.changed.emit()

    @property
    def _may_come(self) -> bool:
        """Whether ghosts are being worked out."""
        live_fit = self._document.live_fit
        return live_fit.allowed and live_fit.wanted and live_fit.working

    def _to_paint(self, insight: Insight | None) -> tuple[Ghost, ...]:
        if insight is not None:
            return self._in_order(insight.ghosts)
        if not (self._wanted and self._may_come):
            return ()
        there = self._there
        return self._in_order(tuple(g for g in self._painted if g.name not in there))

    @property
    def _there(self) -> frozenset[str]:
        """The classes that have points, confirmed or not."""
        annotation = self._document.annotation
        every = (*annotation.polylines, *annotation.unconfirmed)
        return frozenset(p.class_name for p in every if p.points)

    def _go_on(self) -> None:
        """The current ghost is none any more: accepted, hidden, or not sure enough."""
        known = self.known
        left = self._beyond(known, 1) or known  # those that were passed over come again
        if left:
            self._at = left[0].name
            return
        self._at, self._walking = None, False
        if self._wanted and self._insight is not None:
            self.ended.emit()
