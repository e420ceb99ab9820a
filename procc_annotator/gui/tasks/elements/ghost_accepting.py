"""Ghosts become elements: one whose points are found, or all whose lines are seen well enough."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QInputDialog, QWidget

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.fit.predict.ghosts import Ghost
from procc_annotator.gui.settings import GHOST_SUPPORT, Settings
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.notices import Level
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.interact.hints import counted
from procc_annotator.session.clicks.insight import Insight
from procc_annotator.session.facts.origins import OriginKind
from procc_annotator.session.strokes.ghost_points import (
    GhostPoints,
    accept,
    accept_all,
    find_points,
)

# Whoever leaves a frame waits for ghosts they have just accepted: 10 ms for each, as a rule.
_MOST_WAIT_S = 1.0

AllPoints = tuple[GhostPoints, ...]


@dataclass(frozen=True, eq=False)
class _Accepting:
    """Ghosts to be accepted once their points are found."""

    ghosts: tuple[Ghost, ...]
    made_for: Insight
    frame: str
    all: bool


class GhostAccepting(QObject):
    """Edits made from ghosts; each is one step of undo.

    What somebody accepted is done before the frame is left; where it cannot be done any more, that
    is said.
    """

    progressed = Signal(int, int)  # looking for points; (0, 0) once that is over
    accepted = Signal(tuple)  # the classes that are elements now

    def __init__(
        self, document: Document, window: QWidget, settings: Settings, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._window = window
        self._settings = settings
        self._job: Job | None = None
        self._asked: _Accepting | None = None  # what the job is for
        self._where = ""  # said of what is done on leaving the frame
        document.ghosts.changed.connect(self._look)
        document.aboutToLeave.connect(self.finish)

    @property
    def least_support(self) -> float:
        """The share of a ghost whose line must be seen for it to be accepted with all others."""
        return min(max(self._settings.get(GHOST_SUPPORT), 0.0), 1.0)

    @property
    def busy(self) -> bool:
        """Whether points are being looked for."""
        return self._job is not None

    def accept_one(self, made_for: Insight, found: GhostPoints) -> bool:
        """Make a ghost an element if the insight is still the one it was found for."""
        title = self._title(found.name)
        if outdated := self.why_outdated(made_for):
            self._say(f"{title} is not accepted: {outdated}")
            return False
        if not found.points:
            self._say(
                f"{title}: no painted line is found along it; click it by hand, or say that it is"
                " not visible here (.)"
            )
            return False
        annotation = accept(made_for.annotation, (found,))
        if not self._commit(made_for, annotation, title):
            return False
        points = counted(len(found.points), "point")
        seen = f"line seen along {found.support:.0%}"
        self._say(f"accepted {title}{self._where}: {points}, {seen}{self._unsure((found,))}")
        self.accepted.emit((found.name,))
        return True

    def find_and_accept(self, ghost: Ghost) -> None:
        """The same for a ghost whose points may not be found yet."""
        ghosts = self._document.ghosts
        if ghost.name in self.waiting:
            return  # it is under way
        self.finish()
        made_for, found = ghosts.insight, ghosts.found(ghost.name)
        if made_for is None or ghost not in ghosts.known:
            self._say("the camera is being fitted: accept its ghosts in a moment")
        elif found is not None:
            self.accept_one(made_for, found)
        elif self._find((ghost,), everything=False):
            self._say(f"{self._title(ghost.name)} is accepted once its points are found")

    def accept_all(self) -> None:
        """Make all ghosts elements whose lines are seen well enough."""
        document = self._document
        if self._asked is not None and self._asked.all:
            return  # they are under way
        before, one_more = document.annotation, self.busy
        self.finish()
        document.aboutToLeave.emit()
        if document.annotation is not before:
            # The ghosts of the better camera are looked at before they are accepted.
            what = "the ghost is accepted" if one_more else "what was being drawn is finished"
            self._say(f"{what}: accept the ghosts of the new fit")
            return
        self._find(document.ghosts.known, everything=True)

    def _accept_good(self, made_for: Insight, found: AllPoints) -> None:
        least = self.least_support
        done = accept_all(made_for.annotation, found, least)
        good, left = done.accepted, done.left
        why = ", ".join(f"{self._title(f.name)} {f.support:.0%}" for f in left)
        too_little = f"less than {least:.0%} of the line is seen: {why}"
        if not good:
            self._say(f"no ghost was accepted, {too_little}; Tab goes through them")
            return
        what = self._title(good[0].name) if len(good) == 1 else counted(len(good), "ghost")
        if self._commit(made_for, done.annotation, what):
            share = f"{len(good)} of {len(found)} ghosts" if left else what
            why = f"; left, {too_little}" if left else ""
            self._say(f"accepted {share}{self._where}{self._unsure(good)}{why}")
            self.accepted.emit(tuple(f.name for f in good))

    def _unsure(self, found: AllPoints) -> str:
        """What is said of ends that the picture does not show."""
        ends = sum(f.unsure_ends for f in found)
        if not ends:
            return ""
        of = ", ".join(self._title(f.name) for f in found if f.unsure_ends)
        where = f" of {of}" if len(found) > 1 else ""
        return f"; {counted(ends, 'end')}{where} cannot be seen: the points stop before"

    def why_outdated(self, made_for: Insight) -> str:
        """Why an insight is not the one on screen any more; empty while it is."""
        document = self._document
        if document.ghosts.insight is made_for:
            return ""
        if document.annotation is not made_for.annotation:
            return "the frame was edited meanwhile"
        return "the camera is another one meanwhile"

    def _commit(self, made_for: Insight, annotation: FrameAnnotation, what: str) -> bool:
        document = self._document
        if not document.begin_edit() or document.annotation is not made_for.annotation:
            return False  # somebody else has the frame, or had it meanwhile: that is said
        kind = OriginKind.SUGGESTED if made_for.from_clicks else OriginKind.ACCEPTED
        return document.commit_edit(f"accept {what}", annotation, kind)

    # --- looking for points ---------------------------------------------------------------

    @property
    def waiting(self) -> tuple[str, ...]:
        """The classes that are elements once their points are found."""
        return tuple(ghost.name for ghost in self._asked.ghosts) if self._asked is not None else ()

    def _find(self, ghosts: tuple[Ghost, ...], *, everything: bool) -> bool:
        """Have the points of ghosts found in the background; most are known already."""
        document, field = self._document, self._document.state.sized_field
        made_for = document.ghosts.insight
        if not ghosts or made_for is None or not document.begin_edit():
            return False  # somebody else has the frame, or nobody can edit it: that is said
        picture, size, frame = document.picture, document.picture_size, document.frame
        if picture is None or size is None or frame is None:
            self._say("no ghost was accepted: there is no picture to look for their lines in")
            return False
        known = {ghost.name: document.ghosts.found(ghost.name) for ghost in ghosts}

        def work(control: JobControl) -> AllPoints:
            found = []
            for number, ghost in enumerate(ghosts):
                control.progress_or_stop(number, len(ghosts))
                found.append(known[ghost.name] or find_points(ghost, picture, field, size))
            return tuple(found)

        def take(found: AllPoints) -> None:
            self._end()
            if everything:
                self._accept_good(made_for, found)
            else:
                self.accept_one(made_for, found[0])

        self._asked = _Accepting(ghosts, made_for, frame.name, everything)
        self._job = run_in_background(
            work,
            on_result=take,
            on_error=lambda text: self.drop(text, "warning"),
            on_progress=self.progressed.emit,
            owner=self,
            urgent=True,
        )
        return True

    def finish(self) -> None:
        """What was accepted is done before anything else is: wait for the points."""
        job, asked = self._job, self._asked
        if job is None or asked is None:
            return
        self._where = f" on {asked.frame}"
        if not job.finish(_MOST_WAIT_S):
            self.drop(f"looking for the line on {asked.frame} took too long", "warning")
        self._where = ""

    def drop(self, why: str = "", level: Level = "info") -> None:
        """Accept nothing of what is waited for, and say so."""
        job, asked = self._job, self._asked
        if job is None or asked is None:
            return
        job.cancel()
        self._end()
        what = "no ghost was" if asked.all else f"{self._title(asked.ghosts[0].name)} is not"
        self._document.say(f"{what} accepted{f': {why}' if why else ''}", level)

    def _look(self) -> None:
        """What is looked for may belong to clicks, a field or a model that are not there now."""
        if self._asked is not None and (outdated := self.why_outdated(self._asked.made_for)):
            self.drop(outdated)

    def _end(self) -> None:
        self._job = self._asked = None
        self.progressed.emit(0, 0)

    # --- the setting ----------------------------------------------------------------------

    def ask_support(self) -> None:
        """Ask for the share of a line that must be seen."""
        share, given = QInputDialog.getInt(
            self._window,
            "Accept all ghosts",
            "How much of a ghost's line must be seen for it to be accepted with all others (%):",
            round(100 * self.least_support),
            0,
            100,
            5,
        )
        if given:
            self._settings.set(GHOST_SUPPORT, share / 100)

    # --- inside ---------------------------------------------------------------------------

    def _title(self, name: str) -> str:
        return self._document.field.title_of(name)

    def _say(self, text: str) -> None:
        self._document.say(text)
