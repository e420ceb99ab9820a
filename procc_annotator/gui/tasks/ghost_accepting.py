"""Ghosts become elements: one whose points are found, or all whose lines are seen well enough."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QInputDialog, QWidget

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.fit.predict.ghosts import Ghost
from procc_annotator.gui.settings import Settings
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.interact.hints import counted
from procc_annotator.session.ghost_points import LEAST_SUPPORT, GhostPoints, accept, find_points
from procc_annotator.session.origins import OriginKind

_SETTING = "ghost_support"

Found = tuple[GhostPoints, ...]


class GhostAccepting(QObject):
    """Edits made from ghosts; each is one step of undo, and what came too late is not applied."""

    progressed = Signal(int, int)  # looking for points; (0, 0) once that is over

    def __init__(
        self, document: Document, window: QWidget, settings: Settings, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._window = window
        self._settings = settings
        self._job: Job | None = None
        document.annotationChanged.connect(self.cancel)
        document.frameChanged.connect(self.cancel)

    @property
    def least_support(self) -> float:
        """The share of a ghost whose line must be seen for it to be accepted with all others."""
        return min(max(self._settings.number(_SETTING, LEAST_SUPPORT), 0.0), 1.0)

    @property
    def busy(self) -> bool:
        """Whether points are being looked for."""
        return self._job is not None

    def accept_one(self, made_for: FrameAnnotation, found: GhostPoints) -> bool:
        """Make a ghost an element if the annotation is still the one it was found for."""
        document, title = self._document, self._title(found.name)
        if document.annotation is not made_for:
            self._say(f"{title} is not accepted: the frame was edited meanwhile")
            return False
        if not found.points:
            self._say(
                f"{title}: no painted line is found along it; click it by hand, or say that it is"
                " not visible here (.)"
            )
            return False
        if not self._commit(made_for, (found,), title):
            return False
        points = counted(len(found.points), "point")
        self._say(f"accepted {title}: {points}, line seen along {found.support:.0%}")
        return True

    def find_and_accept(self, ghost: Ghost) -> None:
        """The same for a ghost whose points may not be found yet."""
        made_for = self._document.annotation
        self._find((ghost,), lambda found: self.accept_one(made_for, found[0]))

    def accept_all(self) -> None:
        """Make all ghosts elements whose lines are seen well enough."""
        self._document.aboutToLeave.emit()
        made_for = self._document.annotation
        self._find(self._document.ghosts.known, lambda found: self._accept_good(made_for, found))

    def _accept_good(self, made_for: FrameAnnotation, found: Found) -> None:
        least = self.least_support
        good = [f for f in found if f.points and f.support >= least]
        left = [f for f in found if f not in good]
        why = ", ".join(f"{self._title(f.name)} {f.support:.0%}" for f in left)
        too_little = f"less than {least:.0%} of the line is seen: {why}"
        if self._document.annotation is not made_for:
            self._say("no ghosts were accepted: the frame was edited meanwhile")
        elif not good:
            self._say(f"no ghost was accepted, {too_little}; Tab goes through them")
        else:
            what = self._title(good[0].name) if len(good) == 1 else counted(len(good), "ghost")
            if self._commit(made_for, good, what):
                share = f"{len(good)} of {len(found)} ghosts" if left else what
                self._say(f"accepted {share}{f'; left, {too_little}' if left else ''}")

    def _commit(self, made_for: FrameAnnotation, found: Sequence[GhostPoints], what: str) -> bool:
        document = self._document
        if not document.begin_edit() or document.annotation is not made_for:
            return False  # somebody else has the frame, or had it meanwhile: that is said
        annotation = accept(made_for, found)
        return document.commit_edit(f"accept {what}", annotation, OriginKind.SUGGESTED)

    # --- looking for points ---------------------------------------------------------------

    def _find(self, ghosts: tuple[Ghost, ...], apply: Callable[[Found], object]) -> None:
        """Have the points of ghosts found in the background; most are known already."""
        document, field = self._document, self._document.field
        picture, size = document.picture, document.picture_size
        if not ghosts or picture is None or size is None:
            return
        self.cancel()
        known = {ghost.name: document.ghosts.found(ghost.name) for ghost in ghosts}

        def work(control: JobControl) -> Found:
            found = []
            for number, ghost in enumerate(ghosts):
                control.progress_or_stop(number, len(ghosts))
                found.append(known[ghost.name] or find_points(ghost, picture, field, size))
            return tuple(found)

        def take(found: Found) -> None:
            self._end()
            apply(found)

        def fail(text: str) -> None:
            self._end()
            document.message.emit(text, "warning")

        self._job = run_in_background(
            work,
            on_result=take,
            on_error=fail,
            on_progress=self.progressed.emit,
            owner=self,
            urgent=True,
        )

    def cancel(self) -> None:
        """Whatever is looked for belongs to clicks that are not there any more."""
        if self._job is not None:
            self._job.cancel()
            self._end()

    def _end(self) -> None:
        self._job = None
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
            self._settings.set(_SETTING, share / 100)

    # --- inside ---------------------------------------------------------------------------

    def _title(self, name: str) -> str:
        return self._document.field.title_of(name)

    def _say(self, text: str) -> None:
        self._document.message.emit(text, "info")
