"""Ghosts become elements: one whose points are found, or all whose lines are seen well enough."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.frame_analysis import FrameAnalysis
from procc_annotator.assist.ghost_points import GhostPoints, accept, accept_all, find_points
from procc_annotator.calibration.prediction.ghosts import Ghost
from procc_annotator.dataset.records import OriginKind
from procc_annotator.gui.settings import GHOST_SUPPORT, Settings
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask, Priority
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import Level
from procc_annotator.translation import (
    TranslatableText,
    tr,
    tr_count,
    translatable,
    translatable_count,
)

# Anyone who leaves a frame waits for ghosts they have just accepted: 10 ms for each, as a rule.
_MOST_WAIT_S = 1.0

AllPoints = tuple[GhostPoints, ...]


@dataclass(frozen=True, eq=False)
class _Accepting:
    """Ghosts to be accepted once their points are found."""

    ghosts: tuple[Ghost, ...]
    made_for: FrameAnalysis
    frame: str
    all: bool


class GhostAccepting(QObject):
    """Edits made from ghosts; each is one step of undo.

    What a person accepted is done before the frame is left; where it cannot be done any more, that
    is said.
    """

    progressed = Signal(int, int)  # looking for points; (0, 0) once that is over
    accepted = Signal(tuple)  # the classes that are elements now

    def __init__(self, services: Services, settings: Settings, parent: QObject) -> None:
        super().__init__(parent)
        self._services, self._say = services, services.say
        self._settings = settings
        self._looking = LatestOnlyTask(
            self, lambda text: self.drop(text, "warning"), priority=Priority.URGENT
        )
        self._asked: _Accepting | None = None  # what is looked for
        self._where = ""  # the frame that is being left
        services.ghosts.changed.connect(self._look)
        services.store.events.aboutToLeave.connect(self.finish)

    @property
    def least_support(self) -> float:
        """The share of a ghost whose line must be seen for it to be accepted with all others."""
        return min(max(self._settings.get(GHOST_SUPPORT), 0.0), 1.0)

    @property
    def busy(self) -> bool:
        """Return whether points are being looked for."""
        return self._asked is not None

    def accept_one(self, made_for: FrameAnalysis, found: GhostPoints) -> bool:
        """Make a ghost an element if the insight is still the one it was found for."""
        title = self._title(found.name)
        if outdated := self.why_outdated(made_for):
            self._say(tr("{element} is not accepted: {why}", element=title, why=outdated))
            return False
        if not found.points:
            self._say(
                tr(
                    "{element}: no painted line is found along it; click it by hand, or say that"
                    " it is not visible here (.)",
                    element=title,
                )
            )
            return False
        annotation = accept(made_for.annotation, (found,))
        if not self._commit(made_for, annotation, self._said_title(found.name)):
            return False
        self._say_with_unsure(self._accepted_words(title, found), (found,))
        self.accepted.emit((found.name,))
        return True

    def find_and_accept(self, ghost: Ghost) -> None:
        """The same for a ghost whose points may not be found yet."""
        ghosts = self._services.ghosts
        if ghost.name in self.waiting:
            return  # it is under way
        self.finish()
        made_for, found = ghosts.insight, ghosts.found(ghost.name)
        if made_for is None or ghost not in ghosts.known:
            self._say(tr("the camera is being fitted: accept its ghosts in a moment"))
        elif found is not None:
            self.accept_one(made_for, found)
        elif self._find((ghost,), everything=False):
            title = self._title(ghost.name)
            self._say(tr("{element} is accepted once its points are found", element=title))

    def accept_all(self, then: Callable[[], None] = lambda: None) -> None:
        """Make all ghosts elements whose lines are seen well enough; ``then`` is called after that
        if their frame is still on screen and holds anything."""
        services = self._services
        if self._asked is not None and self._asked.all:
            return  # they are under way
        before, one_more = services.state.annotation, self.busy
        self.finish()
        services.store.events.aboutToLeave.emit()
        if services.state.annotation is not before:
            # The ghosts of the better camera are examined before they are accepted.
            self._say(
                tr("the ghost is accepted: accept the ghosts of the new fit")
                if one_more
                else tr("what was being drawn is finished: accept the ghosts of the new fit")
            )
            return
        self._find(services.ghosts.known, everything=True, then=then)

    def _accept_good(self, made_for: FrameAnalysis, found: AllPoints) -> bool:
        """Make those elements whose lines are seen well enough; whether there are some."""
        least = self.least_support
        done = accept_all(made_for.annotation, found, least)
        good, left = done.accepted, done.left
        why = ", ".join(f"{self._title(f.name)} {f.support:.0%}" for f in left)
        if not good:
            self._say(
                tr(
                    "no ghost accepted, under {least:.0%} of the line visible: {ghosts}; Tab goes"
                    " through them",
                    least=least,
                    ghosts=why,
                )
            )
            return False

        if len(good) == 1:
            what = self._said_title(good[0].name)
        else:
            what = translatable_count(len(good), "{n} ghost", "{n} ghosts")
        if not self._commit(made_for, done.annotation, what):
            return False
        share = tr(what)
        if left:
            share = tr("{n} of {total} ghosts", n=len(good), total=len(found))
        too_little = tr("skipped (under {least:.0%} visible): {ghosts}", least=least, ghosts=why)
        self._say_with_unsure(self._accepted_words(share), good, too_little if left else "")
        self.accepted.emit(tuple(f.name for f in good))
        return True

    def _accepted_words(self, what: str, found: GhostPoints | None = None) -> str:
        """Return what was accepted and, while the frame is left, where; of one ghost how its
        line is."""
        if found is None:
            if self._where:
                return tr("accepted {what} on {frame}", what=what, frame=self._where)
            return tr("accepted {what}", what=what)
        points = tr_count(len(found.points), "{n} point", "{n} points")
        return tr(
            "{accepted}: {points}, line seen along {share:.0%}",
            accepted=self._accepted_words(what),
            points=points,
            share=found.support,
        )

    def _say_with_unsure(self, words: str, found: AllPoints, more: str = "") -> None:
        self._say("; ".join(filter(None, (words, self._unsure(found), more))))

    def _unsure(self, found: AllPoints) -> str:
        ends = sum(f.unsure_ends for f in found)
        if not ends:
            return ""
        return tr_count(
            ends,
            "{n} end of {elements} cannot be seen: the points stop before",
            "{n} ends of {elements} cannot be seen: the points stop before",
            elements=", ".join(self._title(f.name) for f in found if f.unsure_ends),
        )

    def why_outdated(self, made_for: FrameAnalysis) -> str:
        """Return why an insight is not the one on screen any more; empty while it is."""
        services = self._services
        if services.ghosts.insight is made_for:
            return ""
        if services.state.annotation is not made_for.annotation:
            return tr("the frame was edited meanwhile")
        return tr("the camera is another one meanwhile")

    def _commit(
        self, made_for: FrameAnalysis, annotation: FrameAnnotation, what: TranslatableText
    ) -> bool:
        services = self._services
        editable = services.editing.begin_edit()
        if not editable or services.state.annotation is not made_for.annotation:
            return False  # somebody else has the frame, or had it meanwhile: that is said
        kind = OriginKind.SUGGESTED if made_for.from_clicks else OriginKind.ACCEPTED
        label = translatable("accept {what}", what=what)
        return services.editing.commit_edit(label, annotation, kind)

    # --- looking for points ---------------------------------------------------------------

    @property
    def waiting(self) -> tuple[str, ...]:
        """The classes that are elements once their points are found."""
        return tuple(ghost.name for ghost in self._asked.ghosts) if self._asked is not None else ()

    def _find(
        self,
        ghosts: tuple[Ghost, ...],
        *,
        everything: bool,
        then: Callable[[], None] = lambda: None,
    ) -> bool:
        """Have the points of ghosts found in the background; most are known already."""
        services, field = self._services, self._services.state.sized_field
        made_for = services.ghosts.insight
        if not ghosts or made_for is None or not services.editing.begin_edit():
            return False  # somebody else has the frame, or nobody can edit it: that is said
        picture, state = services.navigator.picture, services.state
        size, frame = state.picture_size, state.frame
        if picture is None or size is None or frame is None:
            self._say(tr("no ghost was accepted: there is no picture to look for their lines in"))
            return False
        known = {ghost.name: services.ghosts.found(ghost.name) for ghost in ghosts}

        def work(control: JobControl) -> AllPoints:
            found = []
            for number, ghost in enumerate(ghosts):
                control.progress_or_stop(number, len(ghosts))
                found.append(known[ghost.name] or find_points(ghost, picture, field, size))
            return tuple(found)

        def take(found: AllPoints) -> None:
            self._end()
            if everything:
                leaving = bool(self._where)
                accepted = self._accept_good(made_for, found)
                if (accepted or made_for.annotation.annotated) and not leaving:
                    then()
            else:
                self.accept_one(made_for, found[0])

        self._asked = _Accepting(ghosts, made_for, frame.name, everything)
        self._looking.start(work, take, progress=self.progressed.emit)
        return True

    def finish(self) -> None:
        """Wait for the points of accepted ghosts before anything else is done."""
        asked = self._asked
        if asked is None:
            return
        self._where = asked.frame
        if not self._looking.finish(_MOST_WAIT_S):
            why = tr("looking for the line on {frame} took too long", frame=asked.frame)
            self.drop(why, "warning")
        self._where = ""

    def drop(self, why: str = "", level: Level = "info") -> None:
        """Accept nothing of what is waited for, and say so."""
        asked = self._asked
        if asked is None:
            return
        self._looking.cancel()
        self._end()
        if asked.all:
            none = tr("no ghost was accepted: {why}", why=why) if why else ""
            self._services.say(none or tr("no ghost was accepted"), level)
            return
        title = self._title(asked.ghosts[0].name)
        one = tr("{element} is not accepted: {why}", element=title, why=why) if why else ""
        self._services.say(one or tr("{element} is not accepted", element=title), level)

    def _look(self) -> None:
        """Drop a search whose clicks, field or model are no longer there."""
        if self._asked is not None and (outdated := self.why_outdated(self._asked.made_for)):
            self.drop(outdated)

    def _end(self) -> None:
        self._asked = None
        self.progressed.emit(0, 0)

    # --- inside ---------------------------------------------------------------------------

    def _title(self, name: str) -> str:
        return tr(self._said_title(name))

    def _said_title(self, name: str) -> TranslatableText:
        return translatable(self._services.state.field.title_of(name))
