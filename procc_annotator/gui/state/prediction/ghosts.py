"""The ghosts of the frame on screen: which are shown, which one is current, what was found of them;
and what to annotate next.

A ghost is known by its class: it outlives a new fit, which moves it a little. All that was found
along a ghost belongs to one insight and goes with it.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

import numpy as np
from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.frame_analysis import FrameAnalysis
from procc_annotator.assist.ghost_points import GhostPoints, find_points
from procc_annotator.calibration.prediction.ghosts import Ghost
from procc_annotator.calibration.prediction.suggestions import AnnotationSuggestion, often_in_sight
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import ComputedValue, Inputs
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.prediction.camera_choice import PredictionSource
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.state import same
from procc_annotator.gui.state.store import Store, When
from procc_annotator.interaction.class_choice import next_element
from procc_annotator.translation import tr

_FIRST = 3  # classes that are named to begin with
_KEPT = 32  # ghosts whose points are kept, more than there are in any frame


class Ghosts(QObject):
    """Follows what is predicted for the frame; knows no widget.

    Attributes:
        wanted: whether the user wants to see ghosts.
        painted: the ghosts to show: while new ones are computed, those of before that are still
            missing, so that they do not flicker with every click.
        suggestion: the element to draw next, and its gain: the selected one if it is in sight and
            has no points, else the one after it. While that is computed, by what was known before.
        walking: whether a walk through the ghosts is in progress; it goes on while a fit is
            computed.
    """

    changed = Signal()  # which are shown, which one is current, what was found of it, what is next
    ended = Signal()  # the walk is over: there is no ghost left to go on to

    def __init__(self, store: Store, prediction: PredictionSource, review: ReviewState) -> None:
        super().__init__(store)
        self._store, self._prediction, self._review = store, prediction, review
        self.wanted = self._suggesting = True
        self._frame: tuple[str | None, str] = None, ""  # its name, and the sport
        self._latest: FrameAnalysis | None = None  # of this frame, while a newer one is computed
        self.painted: tuple[Ghost, ...] = ()
        self.suggestion: AnnotationSuggestion | None = None
        self.walking = False
        self._at: str | None = None  # the class where the walk is, or where it was left
        self._signalled: tuple[object, ...] = ()
        self._points = ComputedValue(
            self._to_find,
            lambda *inputs: find_points(*inputs),
            self,
            cache_size=_KEPT,
            cache_scope=lambda: self._frame,  # each holds the picture it was looked for in
        )
        self._points.changed.connect(self._take_points)
        self._points.failed.connect(self._say_failed)
        store.keep_current(self._points)
        prediction.changed.connect(self._look)
        store.watch(select.frame, self._look)
        store.watch(lambda s: (s.annotation, s.selection), self._look, When.AFTER_PAINT)
        review.notVisibleChanged.connect(self._look)

    # --- which ghosts there are -----------------------------------------------------------

    def set_wanted(self, wanted: bool) -> None:
        """Show ghosts, or do not."""
        if wanted != self.wanted:
            self.wanted = wanted
            self._look()

    @property
    def insight(self) -> FrameAnalysis | None:
        """Return what the ghosts follow from; None where none may be shown."""
        return self._prediction.insight if self.wanted else None

    @property
    def known(self) -> tuple[Ghost, ...]:
        """The ghosts of the annotation on screen, in the order of the field; none while they are
        worked out, and none that a person said cannot be seen."""
        insight = self.insight
        return self._in_order(insight.ghosts) if insight is not None else ()

    def _to_paint(self) -> tuple[Ghost, ...]:
        if self._latest is None or not self.wanted:
            return ()
        there = frozenset() if self.insight is self._latest else self._there
        return self._in_order(tuple(g for g in self._latest.ghosts if g.name not in there))

    def _in_order(self, ghosts: tuple[Ghost, ...]) -> tuple[Ghost, ...]:
        hidden = self._hidden
        shown = (ghost for ghost in ghosts if ghost.name not in hidden)
        return tuple(sorted(shown, key=lambda ghost: self._rank(ghost.name)))

    @property
    def _hidden(self) -> frozenset[str]:
        name = self._store.state.frame_name
        return self._review.not_visible(name) if name is not None else frozenset()

    def _rank(self, name: str) -> int:
        field = self._store.state.field
        return field.index.get(name, len(field.elements))

    # --- what next ------------------------------------------------------------------------

    @property
    def suggesting(self) -> bool:
        """Return whether suggestions of what to annotate next are wanted, and may be."""
        allowed = self._store.state.projection_visible
        return self._suggesting and self._prediction.wanted and allowed

    def set_suggesting(self, suggesting: bool) -> None:
        """Say what to annotate next, or do not."""
        if suggesting != self._suggesting:
            self._suggesting = suggesting
            self._look()

    @property
    def suggested_at(self) -> tuple[float, float] | None:
        """Return where in the picture the element to draw next is expected, px."""
        found, latest = self.suggestion, self._latest
        if found is None or latest is None or latest.fit.camera is None:
            return None
        px, shown = latest.fit.camera.project(np.array([found.place_world]))
        return (float(px[0, 0]), float(px[0, 1])) if shown[0] else None

    def _to_suggest(self) -> AnnotationSuggestion | None:
        latest, gains = self._latest, self.gains
        if latest is None or not gains:
            return None
        following = self._store.state.selected_class
        if following not in gains:  # it is there already, or not in sight
            following = self.following(following)
        return next((s for s in latest.suggestions if s.name == following), None)

    def following(self, finished: str | None, seen_before: Collection[str] = ()) -> str | None:
        """Return the class to offer after one was finished, see `next_element`."""
        unseen, terms = self.out_of_sight, (self._store.state.field, self._store.state.annotation)
        return next_element(*terms, finished, seen_before, gains=self.gains, out_of_sight=unseen)

    @property
    def first_to_draw(self) -> tuple[str, ...]:
        """The classes to begin with where nothing is known of the camera."""
        state, off = self._store.state, self._there | self._hidden
        usual = often_in_sight(state.sized_field, state.picture_size or (16, 9))
        return tuple(name for name in usual if name not in off)[:_FIRST]

    @property
    def advice(self) -> str:
        """Return what to draw where no camera was found."""
        titles = [tr(self._store.state.field.title_of(name)) for name in self.first_to_draw]
        return tr("draw 3 elements, two of which meet, such as {names}", names=", ".join(titles))

    @property
    def gains(self) -> Mapping[str, float]:
        """Return what annotating the classes that are missing would bring, px; empty where none of
        it is worth a word, or no one wants to hear of it."""
        if not self.suggesting or self._latest is None:
            return {}
        off = self._hidden | self._there | _with_points(self._latest.annotation)
        left = [one for one in self._latest.suggestions if one.name not in off]
        worth = any(one.is_worthwhile for one in left)
        return {one.name: one.gain_px for one in left} if worth else {}

    @property
    def out_of_sight(self) -> frozenset[str]:
        """The classes that are not in this picture: the camera shows them elsewhere, or a person
        said so."""
        latest = self._latest
        shown = latest.out_of_sight(self._store.state.field) if latest is not None else frozenset()
        return self._hidden | shown

    # --- the walk -------------------------------------------------------------------------

    @property
    def current(self) -> Ghost | None:
        """The ghost that is examined; None without a walk, and while a fit is worked out."""
        return self.named(self._at) if self.walking else None

    def named(self, name: str | None) -> Ghost | None:
        """The ghost of a class."""
        return next((ghost for ghost in self.known if ghost.name == name), None)

    def step(self, step: int) -> Ghost | None:
        """Go to the next ghost (1) or the one before (-1); None at the end of the walk.

        A walk that was left goes on behind the place where that was.
        """
        known, was_walking = self.known, self.walking
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
        """Return whether the next step goes on behind the place where a walk was left."""
        return self._at is not None and bool(self._beyond(self.painted, 1))

    def go_to(self, name: str) -> None:
        """Look at the ghost of a class."""
        if self.named(name) is not None and not (self.walking and name == self._at):
            self.walking, self._at = True, name
            self._points.retry()
            self.changed.emit()

    def leave(self, *, at_end: bool = False) -> None:
        """End the walk; ``at_end``: the next one begins from the start."""
        if at_end:
            self._at = None
        if self.walking:
            self.walking = False
            self.changed.emit()

    # --- what was found along them --------------------------------------------------------

    def found(self, name: str | None) -> GhostPoints | None:
        """The points that accepting the ghost of a class would add; None while they are looked
        for."""
        asked = self._search_for(self.named(name))
        return None if asked is None else self._points.cached(*asked)

    def _search_for(self, ghost: Ghost | None) -> Inputs | None:
        state = self._store.state
        if ghost is None or state.picture is None:
            return None
        return ghost, state.picture, state.sized_field, state.picture_size

    def _to_find(self) -> Inputs | None:
        """The current ghost first, then the next."""
        if (current := self.current) is None:
            return None
        ghosts = (current, *self._beyond(self.known, 1)[:1])
        asked = (self._search_for(ghost) for ghost in ghosts if self.found(ghost.name) is None)
        return next(asked, None)

    def _take_points(self) -> None:
        self._points.invalidate()  # there may be the next one to look for
        self.changed.emit()

    def _say_failed(self, text: str) -> None:
        asked = self._to_find()
        if asked is not None and isinstance(ghost := asked[0], Ghost):
            title = tr(self._store.state.field.title_of(ghost.name))
            said = tr("{title}: its line could not be looked for: {why}", title=title, why=text)
            say(self._store, said, "warning")

    # --- keeping up -----------------------------------------------------------------------

    def _look(self) -> None:
        """The frame, the fit or what is wanted may be other than before."""
        state, insight = self._store.state, self.insight
        here = state.frame_name, state.field.name
        if here != self._frame:
            self._frame, self._at, self.walking, self._latest = here, None, False, None
        fitted = self._prediction.insight
        if fitted is not None or not self._may_come:
            self._latest = fitted
        self.painted, self.suggestion = self._to_paint(), self._to_suggest()
        waiting = insight is None and self.wanted and self._may_come
        if self.walking and self.current is None and not waiting:
            self._go_on()
        self._points.retry()
        walk, wanted = (self.walking, self._at), (self.wanted, self.suggesting, self._hidden)
        signalled = insight, here, self.painted, self.suggestion, walk, wanted
        if not same(signalled, self._signalled):
            self._signalled = signalled
            self.changed.emit()

    @property
    def _may_come(self) -> bool:
        prediction, allowed = self._prediction, self._store.state.projection_visible
        return allowed and prediction.wanted and prediction.working

    @property
    def _there(self) -> frozenset[str]:
        """The classes that have points, confirmed or not."""
        return _with_points(self._store.state.annotation)

    def _go_on(self) -> None:
        """The current ghost is none any more: accepted, hidden, or not sure enough."""
        known = self.known
        left = self._beyond(known, 1) or known  # those that were passed over come again
        if left:
            self._at = left[0].name
            return
        self._at, self.walking = None, False
        if self.insight is not None:
            self.ended.emit()


def _with_points(annotation: FrameAnnotation) -> frozenset[str]:
    every = (*annotation.polylines, *annotation.unconfirmed)
    return frozenset(p.class_name for p in every if p.points)
