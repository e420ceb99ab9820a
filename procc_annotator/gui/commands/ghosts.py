"""Working through ghosts: the next one, accept it, say that it cannot be seen, accept all."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QObject

from procc_annotator.calibration.prediction.ghosts import Ghost
from procc_annotator.dataset.frames import Frame
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.canvas.view import ViewPlace
from procc_annotator.gui.commands.ghost_accepting import GhostAccepting
from procc_annotator.gui.settings import Settings
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.availability import no_frame
from procc_annotator.gui.state.services import Services
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.overlay_predictions import ghost_extent, nearest_ghost
from procc_annotator.interaction.overlay_primitives import EMPTY_OVERLAY
from procc_annotator.translation import tr, tr_count, word

_CHOOSE_FIRST = word("go to a ghost (Tab) or choose an element first")


@dataclass(frozen=True)
class _Before:
    """The view and selection that the walk began from."""

    place: ViewPlace
    selected: str | None
    frame: Frame | None


class GhostCommands(QObject):
    """Commands on the state's ghosts, and the flight of the canvas from one to the next."""

    def __init__(
        self, services: Services, canvas: Canvas, settings: Settings, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._services, self._say = services, services.say
        self._ghosts = services.ghosts
        self._canvas = canvas
        self.accepting = GhostAccepting(services, settings, self)
        self._before: _Before | None = None
        self._shown: str | None = None  # the class of the ghost the view went to
        self._choosing = False
        canvas.editor.changed.connect(self._leave_for_drawing)
        self._ghosts.changed.connect(self._follow)
        self._ghosts.ended.connect(lambda: self._say(tr("that was the last ghost")))
        self.accepting.accepted.connect(self._go_on)
        services.store.watch(select.selection, self._follow_selection)
        services.store.watch(select.frame, self._forget)

    # --- the walk -------------------------------------------------------------------------

    def go(self, step: int) -> None:
        """Go to the next ghost (1) or the one before (-1) and have it fill the view."""
        if self._canvas.editor.drawing:
            self._say(tr("finish what is being drawn first (Enter), or cancel it (Esc)"))
            return
        self.accepting.finish()
        if why_none := self._why_none():
            self._say(why_none)
            return
        was_walking = self._ghosts.walking
        if self._ghosts.step(step) is None and was_walking:
            self._say(_passed_end(len(self._ghosts.known), last=step > 0))

    def to_panels(self) -> None:
        """Tab stays with the ghosts: take the keyboard from the picture to what comes after it."""
        self._canvas.focusNextPrevChild(True)

    def _why_none(self) -> str:
        foresight, insight = self._services.prediction, self._ghosts.insight
        if why := no_frame(self._services.state):
            return why
        if off := self._why_off():
            return off
        if insight is None:
            coming = tr("the camera is being fitted: ghosts come in a moment")
            return coming if foresight.working else tr("no ghosts: no camera could be fitted")
        if insight.fit.camera is None and self._services.proposals.working:
            return tr("no ghosts: the camera is looked for in the picture")
        if insight.fit.camera is None and not self._services.state.annotation.annotated:
            return tr("no ghosts: no camera is known; {advice}", advice=self._ghosts.advice)
        if insight.fit.camera is None:
            why = insight.fit.failure or tr("no camera fits yet")
            return tr("no ghosts: {why}", why=why)
        if not self._ghosts.known:
            return tr("no ghosts: what else is in sight is annotated, or not known well enough")
        return ""

    def _why_off(self) -> str:
        """Return why no ghosts are shown, whatever the clicks say; empty if they are."""
        visible = self._services.state.projection_visible
        if not (visible and self._services.prediction.wanted):
            return tr("no ghosts: {why}", why=self._services.live_fit.problem)
        if not self._ghosts.wanted:
            return tr("no ghosts: they are switched off (Element > Ghosts > Show ghosts)")
        if self._canvas.drawing.hidden:
            return tr("overlays are hidden: no ghost can be seen (Ctrl+H, or let go of X)")
        return ""

    def at_cursor(self) -> str | None:
        """The class of the ghost under the cursor."""
        at, canvas = self._canvas.cursor_px, self._canvas
        if at is None or canvas.overlay_item.ghosts is EMPTY_OVERLAY:
            return None
        reach = tones.PICK_RADIUS_PX / canvas.view_scale
        return nearest_ghost(self._ghosts.known, at, reach)

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

    def _show(self, ghost: Ghost) -> None:
        services = self._services
        if self._before is None:
            state = services.state
            self._before = _Before(self._canvas.place, state.selected_class, state.frame)
        self._shown = ghost.name
        self._choose(ghost.name)
        self._canvas.show_area(*ghost_extent(ghost))

    def _choose(self, name: str | None) -> None:
        self._choosing = True
        self._services.selection.select_class(name)
        self._choosing = False

    def _end(self) -> None:
        """Back to where the walk began, unless it was left for something else."""
        before, self._before, self._shown = self._before, None, None
        if before is not None:
            self._canvas.show_place(before.place)
            self._choose(self._chosen_before(before))

    def _chosen_before(self, before: _Before | None) -> str | None:
        if before is None or before.frame != self._services.state.frame:
            return None
        return before.selected

    def _go_on(self, accepted: tuple[str, ...]) -> None:
        """Ghosts are elements now: they are done."""
        services, walking = self._services, self._ghosts.walking
        if services.state.selected_class in accepted:
            self._choose(self._chosen_before(self._before))
        if walking and len(accepted) == 1 and not services.state.options.auto_advance:
            self._leave_here()  # otherwise the walk goes on: this ghost is none any more

    def _leave_here(self) -> None:
        """The walk is over and the view stays: something else is being done here."""
        self._before = None
        self._ghosts.leave()

    def _leave_for_drawing(self) -> None:
        if not self._canvas.editor.drawing:
            return
        if self._services.state.selected_class in self.accepting.waiting:
            self.accepting.drop(tr("it is being drawn by hand"))
        if self._ghosts.walking:
            self._leave_here()

    def _follow_selection(self) -> None:
        """Anyone who chooses another element means that one."""
        chosen = self._services.state.selected_class
        if self._choosing or not self._ghosts.walking or chosen in (None, self._shown):
            return
        if self._ghosts.named(chosen) is not None:
            self._shown = chosen  # the hand is where it is: the view stays
            self._ghosts.go_to(chosen or "")
        else:
            self._leave_here()

    def _forget(self) -> None:
        """Another frame is on screen, with a view of its own."""
        self._before = self._shown = None

    # --- keys -----------------------------------------------------------------------------

    def key(self, name: str, shift: bool) -> bool:
        """Take Enter, Shift+Enter, Escape, Delete or Undo while nothing is drawn; False if it is
        not meant for ghosts."""
        services, ghosts = self._services, self._ghosts
        free = services.state.selected_class is None and services.state.frame is not None
        if name in ("Escape", "Undo") and self.accepting.busy:
            self.accepting.drop(tr("taken back") if name == "Undo" else "")
            return True
        if name in ("Delete", "Undo") and free and services.shot_track.fit_here is None:
            return services.proposals.reject(name == "Delete")
        if name == "Escape" and ghosts.walking:
            ghosts.leave()
            return True
        if name != "Enter":
            return False
        if shift and services.state.frame is not None:
            waiting = services.state.annotation.unconfirmed
            if any(polyline.class_name == services.state.selected_class for polyline in waiting):
                return False  # it confirms that element
            if ghosts.painted or not waiting:
                self.accept_all()  # says why there are none
                return True
        if ghosts.walking:
            self.accept()
            return True
        first = ghosts.first_to_draw if free and services.state.mode == "draw" else ()
        if first and not ghosts.painted and not services.state.annotation.polylines:
            services.selection.select_class(first[0])
            return True
        return False

    # --- accepting ------------------------------------------------------------------------

    def accept(self) -> None:
        """Make the current ghost an element, as soon as its points are found."""
        current = self._ghosts.current
        if why_none := self._why_none():
            self._say(why_none)
        elif current is None:
            self._say(tr("go to a ghost first (Tab)"))
        else:
            self.accepting.find_and_accept(current)

    def accept_all(self) -> None:
        """Make all ghosts elements whose lines are seen well enough; one step of undo."""
        if why_none := self._why_none():
            self._say(why_none)
        else:
            self.accepting.accept_all()

    def accept_and_go_on(self) -> None:
        """Accept all ghosts and show the next frame: going through a shot, one key a frame. A frame
        that has none left because it is annotated is passed over."""
        services = self._services
        if self._why_none() and services.state.annotation.annotated and not self._why_off():
            services.navigator.next_frame()
        elif why_none := self._why_none():
            self._say(why_none)
        else:
            self.accepting.accept_all(then=services.navigator.next_frame)

    # --- not visible here -----------------------------------------------------------------

    def say_not_visible(self) -> None:
        """The current ghost, or the chosen element, cannot be seen in this frame; once more takes
        it back."""
        services = self._services
        current = self._ghosts.current
        if self._ghosts.walking and current is None:
            self._say(self._why_none())  # what was chosen before the walk is not meant
            return
        name = current.name if current is not None else services.state.selected_class
        if services.state.frame is None or name is None:
            off = self._why_off()
            self._say(tr("{off}; choose an element first", off=off) if off else tr(_CHOOSE_FIRST))
            return
        hidden = name in services.review.not_visible(services.state.frame.name)
        self.set_not_visible(name, not hidden)

    def set_not_visible(self, name: str, hidden: bool) -> None:
        """Say that an element cannot be seen in this frame, or that it can after all."""
        services, title = self._services, self._title(name)
        if services.state.frame is None or not services.editing.begin_edit():
            return  # somebody else has the frame, or nobody can edit it: that is said
        if hidden and name in services.state.annotation.annotated:  # maybe only since just now
            self._say(tr("{title} is annotated here: delete it first (Ctrl+Delete)", title=title))
            return
        services.review.set_not_visible(services.state.frame.name, name, hidden)
        self._say(
            tr("{title} is not visible here; Ctrl+. takes it back", title=title)
            if hidden
            else tr("{title} may be visible here again", title=title)
        )

    def take_back_not_visible(self) -> None:
        """Take back what was said last of this frame."""
        said = self.not_visible()
        if said:
            self.set_not_visible(said[-1], False)
        else:
            self._say(tr("no element of this frame was said to be not visible"))

    def not_visible(self) -> tuple[str, ...]:
        """The elements said to be not visible in this frame, the latest last."""
        frame, database = self._services.state.frame, self._services.review.database
        if frame is None or database is None:
            return ()
        marks = database.is_marked_not_visible(frame.name)
        return tuple(sorted(marks, key=lambda name: marks[name].time))

    # --- inside ---------------------------------------------------------------------------

    def _title(self, name: str) -> str:
        return tr(self._services.state.field.title_of(name))


def _passed_end(left: int, *, last: bool) -> str:
    end = tr("that was the last ghost") if last else tr("that was the first ghost")
    more = tr_count(left, "{n} ghost left, Tab begins again", "{n} ghosts left, Tab begins again")
    return f"{end}; {more}"
