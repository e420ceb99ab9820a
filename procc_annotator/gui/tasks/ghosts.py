"""Working through ghosts: the next one, accept it, say that it cannot be seen, accept all."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QObject

from procc_annotator.fit.predict.ghosts import Ghost
from procc_annotator.gui.picture.canvas import Canvas
from procc_annotator.gui.picture.overlay_item import NOTHING
from procc_annotator.gui.picture.view import ViewPlace
from procc_annotator.gui.settings import Settings
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.tasks.ghost_accepting import GhostAccepting
from procc_annotator.interact import palette as tones
from procc_annotator.interact.overlay_ghosts import extent, nearest_ghost
from procc_annotator.session.insight import Insight
from procc_annotator.session.workspace import Frame


@dataclass(frozen=True)
class _Before:
    """What the walk began from."""

    place: ViewPlace
    selected: str | None
    annotated: tuple[str, ...]
    frame: Frame | None


class GhostTasks(QObject):
    """Commands on the document's ghosts, and the flight of the canvas from one to the next."""

    def __init__(
        self, document: Document, canvas: Canvas, settings: Settings, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._ghosts = document.ghosts
        self._canvas = canvas
        self.accepting = GhostAccepting(document, canvas, settings, self)
        self._before: _Before | None = None
        self._shown: str | None = None  # the class of the ghost the view went to
        self._choosing = False
        # Enter came before the points were found: to be accepted unless something changes.
        self._waiting: tuple[Insight, str] | None = None
        canvas.editor.asked_first = self.key
        canvas.editor.changed.connect(self._leave_for_drawing)
        self._ghosts.changed.connect(self._follow)
        document.selectionChanged.connect(self._follow_selection)
        document.frameChanged.connect(self._forget)

    # --- the walk -------------------------------------------------------------------------

    def go(self, step: int) -> None:
        """Go to the next ghost (1) or the one before (-1) and have it fill the view."""
        if self._canvas.editor.drawing:
            self._say("finish what is being drawn first (Enter), or cancel it (Esc)")
            return
        if not self._ghosts.known:
            self._explain_none(step)
            return
        self._waiting = None
        was_walking = self._ghosts.walking
        if self._ghosts.step(step) is None and was_walking:
            where = "last" if step > 0 else "first"
            self._say(f"that was the {where} ghost; Tab begins again")

    def _explain_none(self, step: int) -> None:
        document, live_fit = self._document, self._document.live_fit
        insight = self._ghosts.insight
        if not (self._ghosts.wanted and live_fit.wanted and live_fit.allowed) or (
            document.frame is None
        ):
            # The key is the usual one again: on to the panels.
            self._canvas.focusNextPrevChild(step > 0)
        elif insight is None:
            self._say("the camera is being fitted: ghosts come in a moment")
        elif insight.fit.camera is None:
            self._say(f"no ghosts: {insight.fit.failure or 'no camera fits yet'}")
        else:
            self._say("no ghosts: what else is in sight is annotated, or not known well enough")

    def at_cursor(self) -> str | None:
        """The class of the ghost under the cursor."""
        at, canvas = self._canvas.cursor_px, self._canvas
        if at is None or canvas.overlay_item.ghosts is NOTHING:
            return None
        reach = tones.PICK_RADIUS_PX / canvas.view_scale
        return nearest_ghost(self._ghosts.known, at, reach)

    def look_at(self, name: str) -> None:
        """Go to the ghost of a class."""
        self._ghosts.go_to(name)

    def accept_named(self, name: str) -> None:
        """Accept the ghost of a class without going there."""
        ghost = self._ghosts.named(name)
        if ghost is not None:
            self.accepting.find_and_accept(ghost)

    def _follow(self) -> None:
        """Another ghost is current, or none: take the view along."""
        ghosts = self._ghosts
        current = ghosts.current
        if current is not None and current.name != self._shown:
            self._show(current)
        elif not ghosts.walking:
            self._end()
        self._accept_waiting()

    def _show(self, ghost: Ghost) -> None:
        document = self._document
        if self._before is None:
            self._before = _Before(
                self._canvas.place,
                document.selected_class,
                document.annotation.annotated,
                document.frame,
            )
        self._shown = ghost.name
        self._choose(ghost.name)
        self._canvas.show_area(*extent(ghost))

    def _choose(self, name: str | None) -> None:
        self._choosing = True
        self._document.select_class(name)
        self._choosing = False

    def _end(self) -> None:
        """Back to where the walk began, unless it was left for something else."""
        before, self._before = self._before, None
        self._shown = self._waiting = None
        if before is None:
            return
        self._canvas.show_place(before.place)
        document, selected = self._document, before.selected
        new = selected in document.annotation.annotated and selected not in before.annotated
        # What was accepted meanwhile is done: the next click must not continue it.
        self._choose(None if new and document.frame == before.frame else selected)

    def _leave_here(self) -> None:
        """The walk is over and the view stays: something else is being done here."""
        self._before = None
        self._ghosts.leave()

    def _leave_for_drawing(self) -> None:
        if self._ghosts.walking and self._canvas.editor.drawing:
            self._leave_here()

    def _follow_selection(self) -> None:
        """Whoever chooses another element means that one."""
        chosen = self._document.selected_class
        if self._choosing or not self._ghosts.walking or chosen in (None, self._shown):
            return
        if self._ghosts.named(chosen) is not None:
            self._shown = chosen  # the hand is where it is: the view stays
            self._ghosts.go_to(chosen or "")
        else:
            self._leave_here()

    def _forget(self) -> None:
        """Another frame is on screen, with a view of its own."""
        self._before = self._shown = self._waiting = None

    # --- keys -----------------------------------------------------------------------------

    def key(self, name: str, shift: bool) -> bool:
        """Take Enter, Shift+Enter or Escape while nothing is drawn; False if it is not meant for
        ghosts."""
        document, ghosts = self._document, self._ghosts
        if name == "Escape" and self.accepting.busy:
            self.accepting.cancel()
            self._say("no ghosts were accepted")
            return True
        if name == "Escape" and ghosts.walking:
            ghosts.leave()
            return True
        if name != "Enter":
            return False
        if shift and ghosts.known:
            selected = document.selected_class
            if selected is not None and document.annotation.get_unconfirmed(selected) is not None:
                return False  # it confirms that element
            self.accept_all()
            return True
        if ghosts.walking:
            self.accept()
            return True
        return False

    # --- accepting ------------------------------------------------------------------------

    def accept(self) -> None:
        """Make the current ghost an element, as soon as its points are found."""
        document, current, insight = self._document, self._ghosts.current, self._ghosts.insight
        if current is None or insight is None:
            waiting = self._ghosts.walking
            self._say(
                "the camera is being fitted: the next ghost comes in a moment"
                if waiting
                else "go to a ghost first (Tab)"
            )
            return
        found = self._ghosts.found(current.name)
        if found is None:
            self._waiting = insight, current.name
            self._say(f"{self._title(current.name)} is accepted once its points are found")
            return
        self._waiting = None
        accepted = self.accepting.accept_one(insight, found)
        if accepted and not document.auto_advance:
            self._leave_here()  # otherwise the walk goes on: this ghost is none any more

    def _accept_waiting(self) -> None:
        if self._waiting is None:
            return
        made_for, name = self._waiting
        current = self._ghosts.current
        if outdated := self.accepting.why_outdated(made_for):
            self._waiting = None
            self._say(f"{self._title(name)} is not accepted: {outdated}")
        elif current is not None and current.name != name:
            self._waiting = None
            self._say(f"{self._title(name)} is not accepted: another ghost was chosen meanwhile")
        elif current is not None and self._ghosts.found(name) is not None:
            self.accept()

    def accept_all(self) -> None:
        """Make all ghosts elements whose lines are seen well enough; one step of undo."""
        if self._ghosts.known:
            self._waiting = None
            self.accepting.accept_all()
        elif self._document.live_fit.working and self._ghosts.wanted:
            self._say("the camera is being fitted: accept its ghosts in a moment")
        else:
            self._say("no ghosts are shown: there is nothing to accept")

    # --- not visible here -----------------------------------------------------------------

    def say_not_visible(self) -> None:
        """The current ghost, or the chosen element, cannot be seen in this frame; once more takes
        it back."""
        document = self._document
        current = self._ghosts.current
        name = current.name if current is not None else document.selected_class
        if document.frame is None or name is None:
            self._say("go to a ghost (Tab) or choose an element first")
            return
        hidden = name in document.review.not_visible(document.frame.name)
        if name in document.annotation.annotated and not hidden:
            self._say(f"{self._title(name)} is annotated here: delete it first (Ctrl+Delete)")
            return
        self.set_not_visible(name, not hidden)

    def set_not_visible(self, name: str, hidden: bool) -> None:
        """Say that an element cannot be seen in this frame, or that it can after all."""
        document, title = self._document, self._title(name)
        if document.frame is None:
            return
        document.review.set_not_visible(document.frame.name, name, hidden)
        self._say(
            f"{title} is not visible here; Ctrl+. takes it back"
            if hidden
            else f"{title} may be visible here again"
        )

    def take_back_not_visible(self) -> None:
        """Take back what was said last of this frame."""
        said = self.not_visible()
        if said:
            self.set_not_visible(said[-1], False)
        else:
            self._say("no element of this frame was said to be not visible")

    def not_visible(self) -> tuple[str, ...]:
        """The elements said to be not visible in this frame, the latest last."""
        frame, database = self._document.frame, self._document.review.database
        if frame is None or database is None:
            return ()
        marks = database.marks_not_visible(frame.name)
        return tuple(sorted(marks, key=lambda name: marks[name].time))

    # --- inside ---------------------------------------------------------------------------

    def _title(self, name: str) -> str:
        return self._document.field.title_of(name)

    def _say(self, text: str) -> None:
        self._document.message.emit(text, "info")
