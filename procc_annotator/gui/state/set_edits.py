"""Edits of frames that need not be on screen: each locked, and a step of its history."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.gui.state.editing import Editing
from procc_annotator.gui.state.store import Store
from procc_annotator.session.dataset.workspace import Workspace
from procc_annotator.session.facts.origins import OriginKind


class LeftAlone(StrEnum):
    """Why an import has nothing to do in a frame."""

    SAME = "it holds the same already"
    ANNOTATED = "it is annotated already"


def why_left_alone(
    before: FrameAnnotation, incoming: FrameAnnotation, *, replacing: bool
) -> LeftAlone | None:
    """Whether there is anything to import into a frame that holds ``before``."""
    if before.same_content(incoming):
        return LeftAlone.SAME
    return LeftAlone.ANNOTATED if before.annotated and not replacing else None


def import_into_frame(
    store: Store, editing: Editing, index: int, incoming: FrameAnnotation, *, replacing: bool
) -> str:
    """Replace what is annotated in a frame; undo and versions keep what was there.

    Unconfirmed elements of other classes stay, and so do further entries of the file. The frame is
    locked then: whoever calls this saves it and gives it back (``editing.presence.give_back``).

    Args:
        replacing: also in a frame that is annotated, by its file as it is once the lock is taken.

    Returns:
        Why the frame was left as it was, not locked (a `LeftAlone` when there is nothing to do);
        empty when it was not.
    """
    workspace = store.state.workspace
    assert workspace is not None
    name, here = workspace.frames[index].name, index == store.state.frame_index
    editing.saver.settle(index)
    if here:
        if not editing.begin_edit():
            return store.state.why_not_editable or "it cannot be edited"
    else:
        holder = editing.presence.borrow(name)
        if holder is not None:
            return f"{holder.author or 'somebody'} is editing it"
    put = _put_on_screen if here else _put_elsewhere
    why = put(workspace, editing, index, incoming, replacing)
    if why:
        editing.presence.give_back(name)
    return why


def _put_on_screen(
    workspace: Workspace, editing: Editing, index: int, incoming: FrameAnnotation, replacing: bool
) -> str:
    editing.look_at_frame()
    held = workspace.state(index)
    if held.error is not None:
        return str(held.error)
    before = held.history.current
    if (why := why_left_alone(before, incoming, replacing=replacing)) is not None:
        return why
    editing.commit_edit("import", merged(before, incoming), OriginKind.FILE)
    return ""


def _put_elsewhere(
    workspace: Workspace, editing: Editing, index: int, incoming: FrameAnnotation, replacing: bool
) -> str:
    workspace.look_again(index)
    if workspace.state(index).error is None:
        try:
            # Another window may have saved it since it was read here.
            if workspace.refresh(index):
                editing.saver.save(index)  # no conflict is left to be decided
        except InputError as error:
            return str(error)
    held, name = workspace.state(index), workspace.frames[index].name
    if held.error is not None:
        return str(held.error)
    before = held.history.current
    if (why := why_left_alone(before, incoming, replacing=replacing)) is not None:
        return why
    after = merged(before, incoming)
    if workspace.edit(index, "import", after):
        editing.review.note_edit(name, before, after, OriginKind.FILE)
        editing.review.touched(name, before, after)
    return ""


def merged(before: FrameAnnotation, incoming: FrameAnnotation) -> FrameAnnotation:
    """What a frame holds after an import: the elements that came, and what has no other place."""
    classes = {p.class_name for p in incoming.polylines}
    return replace(
        incoming,
        extra=tuple((dict(before.extra) | dict(incoming.extra)).items()),
        unconfirmed=tuple(p for p in before.unconfirmed if p.class_name not in classes),
    )
