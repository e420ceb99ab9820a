"""Passes events of the canvas to the draw or edit tool, and its reactions to the state."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import Polyline
from procc_annotator.assist.copying import annotated_before
from procc_annotator.dataset import editing
from procc_annotator.dataset.records import PointKey
from procc_annotator.gui.canvas.snapping import ScreenSnapper
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.store import When
from procc_annotator.interaction.class_choice import unnamed_class
from procc_annotator.interaction.draw_tool import DrawTool, draft_with_cursor
from procc_annotator.interaction.edit_tool import EditTool
from procc_annotator.interaction.gestures import (
    Edit,
    Hit,
    Modifiers,
    Position,
    Reaction,
    ToolContext,
)
from procc_annotator.interaction.hints import GhostHint, status_hint
from procc_annotator.interaction.overlay_primitives import Draft
from procc_annotator.translation import tr, tr_count


def why_not_deleted(title: str, dropped: int) -> str:
    """Return why no element was deleted, or what was taken back instead: so many points that were
    under way of the chosen element, if there is one (its title)."""
    if not title:
        return tr("choose the element to delete first: field map, list, or its key")
    if dropped:
        return tr_count(
            dropped, "dropped {n} point of {title}", "dropped {n} points of {title}", title=title
        )
    return tr("{title} has no points in this frame: choose the element to delete", title=title)


# Given a key's name and whether Shift is held, takes it or does not.
KeyTaker = Callable[[str, bool], bool]


class Editor(QObject):
    """Gives events to the draw or edit tool and does what the tool answers."""

    changed = Signal()  # a draft or gesture changed, nothing in the state
    lineFinished = Signal(str)  # one that has no name yet: its class meanwhile
    explained = Signal(str)  # why nothing happened, the first time

    def __init__(self, services: Services, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._services = services
        self._draw = DrawTool()
        self._edit = EditTool()
        self._over: Hit | None = None
        self._cursor: Position | None = None
        self._held = Modifiers()
        self._explained = False
        self._snapper = ScreenSnapper(services)
        self.on_ground = False  # whether the last right click hit nothing
        self.seen_before: frozenset[str] = frozenset()
        self._take_field()
        services.store.watch(select.field, self._take_field)
        self.view_scale = 1.0
        self._asked_first: tuple[KeyTaker, ...] = ()
        services.store.events.frameLeft.connect(lambda: self._end_draft(leaving=True))
        services.store.events.aboutToLeave.connect(self.finish)
        self.changed.connect(self._keep_clicks)
        services.store.watch(select.selection, self._finish_for_another_class)
        services.store.watch(select.frame, self._look_before)
        services.store.watch(select.annotation, self._look_under, When.AFTER_PAINT)
        services.store.watch(select.mode, self._look_under)

    def _take_field(self) -> None:
        elements = self._services.state.field.elements
        self.curved = frozenset(e.name for e in elements if e.is_curved)
        landmarks = (mark.name for mark in self._services.state.field.landmarks)  # placed or not
        self.spots = frozenset((*(e.name for e in elements if e.is_spot), *landmarks))

    @property
    def drawing(self) -> bool:
        """Return whether a polyline is under way."""
        return self._draw.busy

    @property
    def dragging(self) -> bool:
        """Return whether a point is dragged by the mouse."""
        return self._edit.busy and self._edit.grabbed is not None

    @property
    def holding(self) -> bool:
        """Return whether the mouse holds anything: points, an element, a band."""
        return self._edit.busy

    @property
    def band(self) -> tuple[Position, Position] | None:
        """The rectangle that chooses points, picture px."""
        return self._edit.band

    @property
    def upcoming(self) -> str | None:
        """The class that is chosen by itself once the one under way is finished."""
        services = self._services
        if not services.state.options.auto_advance:
            return None
        finished = self._draw.class_name if self._draw.busy else services.state.selected_class
        return services.ghosts.following(finished, self.seen_before)

    @property
    def _one_click(self) -> bool:
        """Return whether the next click finishes the element that is chosen."""
        return (
            self._services.state.mode == "draw"
            and self._services.state.selected_class in self.spots
        )

    @property
    def follows_cursor(self) -> bool:
        """Return whether something is painted at the cursor."""
        services = self._services
        chosen = services.state.selected_class is not None
        drawing = services.state.mode == "draw" and (chosen or self._draw.busy)
        return drawing or services.state.hovered_class is not None

    def draft(self, cursor: Position | None, *, looking: bool = True) -> Draft | None:
        """The polyline under way, with its line to the cursor and where a click would be put;
        without ``looking`` only if that is known already."""
        services = self._services
        if services.state.mode != "draw" or not services.state.editable:
            return None
        context = self._context()
        if context.snap is not None and not looking:
            context = replace(context, snap=self._snapper.remembered)
        return draft_with_cursor(self._draw, context, cursor, self._held)

    def hint(self) -> str:
        """Return what the next click, Enter and Esc will do."""
        services = self._services
        return status_hint(
            services.state.mode,
            self._draw,
            self._edit,
            self._context() if services.state.frame is not None else None,
            services.state.field,
            blocked=services.state.why_not_editable,
            over=self._over,
            blind=not services.state.projection_visible,
            upcoming=self.upcoming if self._draw.busy or self._one_click else None,
            ghosts=self._ghost_hint(),
        )

    def _ghost_hint(self) -> GhostHint:
        ghosts = self._services.ghosts
        current, count = ghosts.current, len(ghosts.painted)
        if current is None:
            return GhostHint(count, resumes=ghosts.resumes, coming=ghosts.walking)
        found = ghosts.found(current.name)
        points = len(found.points) if found is not None else None
        return GhostHint(count, current.name, points)

    # --- events ---------------------------------------------------------------------------

    def hold(self, modifiers: Modifiers) -> None:
        """A modifier key went down or up without the mouse moving."""
        self._held = modifiers

    def point_at(self, position: Position) -> None:
        """Select what is under the cursor, for the menu there; chosen points stay chosen."""
        self.on_ground = False
        if self._draw.busy or (context := self._workable()) is None:
            return
        hit = self._edit.hover(position, context)
        self.on_ground = hit is None
        if hit is None:
            self._services.selection.select_point(None)
            if self._services.state.mode == "edit":
                self._services.selection.select_class(None)
            return
        ref = (hit.class_name, hit.index)
        if hit.kind == "point" and ref not in context.chosen_points:
            self._services.selection.select_point(*ref)
        elif hit.kind == "segment":
            self._services.selection.select_point(None)
            self._services.selection.select_class(hit.class_name)

    def press(self, position: Position, modifiers: Modifiers) -> None:
        """The left button went down."""
        self._held = modifiers
        if self._begin_on(self._context()):
            self._do(self._tool.press(position, modifiers, self._context()))

    def move(self, position: Position, modifiers: Modifiers) -> None:
        """The mouse moved, with or without a button."""
        self._held, self._cursor = modifiers, position
        if (context := self._workable()) is None:
            return
        if self._edit.busy:
            self._do(self._edit.move(position, modifiers, context))
        else:
            self._look_under()

    def release(self, position: Position, modifiers: Modifiers) -> None:
        """The left button went up."""
        if (context := self._workable()) is not None:
            self._do(self._tool.release(position, modifiers, context))

    def double_click(self, position: Position, modifiers: Modifiers) -> None:
        """The second press of two quick ones."""
        if (context := self._workable()) is not None:
            self._do(self._tool.double_click(position, modifiers, context))

    def ask_first(self, *takers: KeyTaker) -> None:
        """Ask these, one after the other, whether a key means something else than to the tools."""
        self._asked_first = takers

    def taken_first(self, name: str, shift: bool) -> bool:
        """Return whether a key, or "Undo", was meant for none of the tools, and is done with; Undo
        right after Escape takes the clicks back that it cancelled."""
        if name == "Undo" and self._tool is self._draw:
            reaction = self._draw.restore(self._context())
            self._do(reaction)
            if reaction.handled:
                return True
        return any(take(name, shift) for take in self._asked_first)

    def key(self, name: str, *, shift: bool = False) -> bool:
        """Enter, Backspace, Escape or Delete; whether it was of use."""
        begun = self._draw.busy or self._edit.busy
        if not begun and self.taken_first(name, shift):
            return True
        return self._ask(lambda context: self._answer(name, context, shift=shift), begun=begun)

    def nudge(self, arrow: str, step: float) -> bool:
        """Move the chosen points by ``step`` px; False if none is chosen."""
        if self._draw.busy:
            return False
        return self._ask(lambda context: self._edit.nudge(arrow, step, context), begun=False)

    def _ask(self, answer: Callable[[ToolContext], Reaction], *, begun: bool) -> bool:
        """Do what a tool answers to a key; whether it does."""
        if (context := self._workable()) is None:
            return False
        reaction = answer(context)
        if reaction.edit is not None and not begun:
            # The frame is taken only now, and its file may be newer: an idle tool keeps nothing of
            # a key that edits, so it is asked again.
            if not self._begin_on(context):
                return True
            reaction = answer(self._context())
        self._do(reaction)
        return reaction.handled

    def _answer(self, name: str, context: ToolContext, *, shift: bool) -> Reaction:
        reaction = self._tool.key(name, context, shift=shift)
        if not reaction.handled and not self._draw.busy and name == "Delete":
            # A point chosen in the table of scores can be removed while drawing too.
            reaction = self._edit.key(name, context, shift=shift)
        return reaction

    def delete_element(self) -> None:
        """Remove the selected element, also what is being clicked of it; say why nothing is."""
        services, name = self._services, self._services.state.selected_class
        if not self._begin_on(self._context()):
            return
        if dropped := len(self._draw.points):
            self._do(self._draw.key("Escape", self._context()))  # not shown
        reaction = self._edit.delete_element(self._context())
        self._do(reaction)
        if reaction.handled:
            return
        title = services.state.title_of(name) if name is not None else ""
        services.say(why_not_deleted(title, dropped), "info")

    def finish(self) -> None:
        """Something else is about to be done: what is under way becomes an edit, a single click an
        unconfirmed element; either is said."""
        self._end_draft()
        if self._edit.busy:
            self._do(self._edit.finish(self._context()))

    # --- inside ---------------------------------------------------------------------------

    @property
    def _tool(self) -> DrawTool | EditTool:
        return self._draw if self._services.state.mode == "draw" else self._edit

    def _context(self) -> ToolContext:
        services, self._snapper.view_scale = self._services, self.view_scale
        return ToolContext(
            services.state.annotation,
            services.state.picture_size or (2, 2),
            self.view_scale,
            services.state.selected_class,
            services.state.selection.point,
            services.state.selection.points,
            self.curved,
            self._snapper if self._snapper.wanted else None,
            services.state.options.pinned,
            services.state.options.two_clicks,
            services.state.field.title_of,
            self.spots,
            unnamed_class(services.state.annotation) if services.state.options.draw_first else None,
            services.state.selection.continues,
        )

    def _begin_on(self, seen: ToolContext) -> bool:
        """Return whether a gesture may begin: the frame can be edited, no one else has it, and no
        one changed what is chosen since it was ``seen``; that is to be checked first."""
        services = self._services
        if (
            services.state.frame is None
            or not services.state.editable
            or not services.editing.begin_edit()
        ):
            return False
        now, names = self._context(), {name for name, _ in seen.chosen_points}
        if seen.selected_class is not None:
            names.add(seen.selected_class)
        changed = [name for name in sorted(names) if now.polyline(name) != seen.polyline(name)]
        if not changed or self._draw.busy:  # what is being drawn goes on from whatever there is
            return True
        if now.chosen_points != seen.chosen_points:
            # The same key again must not mean the whole element.
            services.selection.select_class(None)
        titles = ", ".join(services.state.title_of(name) for name in changed)
        text = tr("{titles}: changed elsewhere, look again first", titles=titles)
        services.say(text, "info")
        return False

    def _workable(self) -> ToolContext | None:
        """Return what a gesture may look at; one that has begun ends even if its lock was lost."""
        begun = self._draw.busy or self._edit.busy
        return self._context() if self._services.state.editable or begun else None

    def _look_before(self) -> None:
        """Remember the elements of the last annotated frame: they are likely here too."""
        workspace, index = self._services.state.workspace, self._services.state.frame_index
        self.seen_before = frozenset()
        if workspace is not None and (found := annotated_before(workspace, index)) is not None:
            self.seen_before = frozenset(found[1].annotated)

    def _finish_for_another_class(self) -> None:
        chosen = self._services.state.selected_class
        if not self._draw.busy or chosen == self._draw.class_name:
            return
        if self._draw.unnamed and (chosen is None or self._draw.call(chosen)):
            self.changed.emit()
        else:
            self._end_draft(keep_selection=True)

    def _end_draft(self, *, keep_selection: bool = False, leaving: bool = False) -> None:
        """Finish what is being drawn; if the frame is left, a new element stays unfinished."""
        if not self._draw.busy:
            return
        name, count = self._draw.class_name, len(self._draw.points)
        before = self._services.state.annotation
        edit = self._draw.finish(self._context()).edit
        if edit is None or name is None:
            return
        drawn = edit.annotation.get(name)
        waits = drawn is not None and (
            len(drawn.points) == 1 or (leaving and before.get(name) is None)
        )
        if drawn is not None and waits:
            edit = replace(edit, annotation=editing.add_unconfirmed(before, [drawn]))
        self._commit(edit)
        if not keep_selection:
            self._services.selection.select_class(name)
        title = self._services.state.title_of(name)
        kept = tr_count(
            count,
            "kept {n} click of {title} on {frame}, unfinished: choose it there to go on",
            "kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on",
            title=title,
            frame=self._services.state.frame_name or "",
        )
        self._services.say(kept if waits else tr("finished {title}", title=title))
        self.changed.emit()

    def _keep_clicks(self) -> None:
        """Clicks under way are kept like an edit: as an element that waits for the user."""
        kept, snapped = None, frozenset[PointKey]()
        if self._draw.busy and (name := self._draw.class_name) is not None:
            context = self._context()
            points, snapped = self._draw.drawn(context)
            if (before := context.annotation.get_unconfirmed(name)) is not None:
                points = (*before.points, *points)
            elif context.polyline(name) is not None:  # what is in the file has its name
                name = unnamed_class(context.annotation)
            kept = Polyline(name, points)
        self._services.editing.keep_clicks(kept, snapped)

    def _commit(self, edit: Edit) -> bool:
        return self._services.editing.commit_edit(
            edit.label, edit.annotation, edit.kind, edit.snapped
        )

    def _look_under(self) -> None:
        """Find what is under the cursor; it may change without a move of the mouse."""
        services, context = self._services, self._workable()
        looking = services.state.mode == "edit" or services.state.selected_class is None
        if context is None or self._cursor is None or not looking:
            self._hover(None)
        elif not self._edit.busy:
            self._hover(self._edit.hover(self._cursor, context))

    def leave(self) -> None:
        """The mouse left the picture."""
        self._cursor = None
        self._hover(None)

    def _hover(self, hit: Hit | None) -> None:
        if hit != self._over:
            self._over = hit
            self._services.selection.hover_class(hit.class_name if hit is not None else None)

    def _do(self, reaction: Reaction) -> None:
        """Apply the reaction of a tool in one transaction."""
        if reaction.handled:
            with self._services.store.transaction():
                self._take(reaction)
            if reaction.cancelled:
                self._look_under()  # what was dragged is back at its place

    def _take(self, reaction: Reaction) -> None:
        """In an order in which indices of points are valid."""
        services = self._services
        if reaction.message:
            services.say(reaction.message, "info")
        if reaction.explanation:
            services.say(reaction.explanation, "info")
            if not self._explained:
                self.explained.emit(reaction.explanation)
            self._explained = True
        if reaction.cancelled:
            services.editing.set_preview(None)
        if reaction.preview is not None:
            services.editing.set_preview(reaction.preview)
        if reaction.edit is not None:
            self._commit(reaction.edit)
        if (chosen := reaction.select) is not None:
            if chosen.class_name is None or chosen.point is None:
                services.selection.select_point(None)
                services.selection.select_class(chosen.class_name)
            else:
                services.selection.select_point(chosen.class_name, chosen.point, chosen.points)
        if (
            reaction.finished
            and services.state.mode == "draw"
            and (name := self.upcoming) is not None
        ):
            services.selection.select_class(name)
        if reaction.to_name is not None:
            self.lineFinished.emit(reaction.to_name)
        if reaction.completed is not None:
            services.selection.note_finished(reaction.completed)
        if reaction.preview is None:
            self.changed.emit()
