"""Edits of frames that need not be on screen: each locked, and a step of its history."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from enum import StrEnum

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.records import OriginKind
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError
from procc_annotator.gui.state.editing import Editing
from procc_annotator.gui.state.store import Store
from procc_annotator.translation import tr, word

# Given what a frame holds: what it is to hold, or why it is to stay as it is.
Change = Callable[[FrameAnnotation], FrameAnnotation | str]


class LeftAlone(StrEnum):
    """Why an import has nothing to do in a frame."""

    SAME = word("it holds the same already")
    ANNOTATED = word("it is annotated already")


def why_left_alone(
    before: FrameAnnotation, incoming: FrameAnnotation, *, replacing: bool
) -> LeftAlone | None:
    """Return whether there is anything to import into a frame that holds ``before``."""
    if before.same_content(incoming):
        return LeftAlone.SAME
    return LeftAlone.ANNOTATED if before.annotated and not replacing else None


def edit_frame(
    store: Store, editing: Editing, index: int, change: Change, label: str, kind: OriginKind
) -> str:
    """Change what is annotated in a frame; undo and versions keep what was there.

    The frame is locked then: anyone who calls this saves it and gives it back
    (``editing.presence.give_back``).

    Args:
        change: given what the frame holds once the lock is taken; what it is to hold, or why it is
            to stay as it is.
        label: of the step in its history.
        kind: how new points came to be.

    Returns:
        Why the frame was left as it was, not locked, for `tr`; empty when it was not.
    """
    workspace = store.state.workspace
    assert workspace is not None
    name, here = workspace.frames[index].name, index == store.state.frame_index
    editing.saver.settle(index)
    if here:
        if not editing.begin_edit():
            return store.state.why_not_editable or tr("it cannot be edited")
    else:
        holder = editing.presence.borrow(name)
        if holder is not None:
            return tr("{who} is editing it", who=holder.author or tr("somebody"))
    put = _put_on_screen if here else _put_elsewhere
    why = put(workspace, editing, index, change, label, kind)
    if why:
        editing.presence.give_back(name)
    return why


def _put_on_screen(
    workspace: Workspace,
    editing: Editing,
    index: int,
    change: Change,
    label: str,
    kind: OriginKind,
) -> str:
    editing.look_at_frame()
    held = workspace.state(index)
    if held.error is not None:
        return str(held.error)
    after = change(held.history.current)
    if isinstance(after, str):
        return after
    editing.commit_edit(label, after, kind)
    return ""


def _put_elsewhere(
    workspace: Workspace,
    editing: Editing,
    index: int,
    change: Change,
    label: str,
    kind: OriginKind,
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
    after = change(before)
    if isinstance(after, str):
        return after
    if workspace.edit(index, label, after):
        editing.review.note_edit(name, before, after, kind)
        editing.review.touched(name, before, after)
    return ""


def imported(incoming: FrameAnnotation, *, replacing: bool) -> Change:
    """Return what an import makes of a frame.

    Unconfirmed elements of other classes stay, and so do further entries of the file.

    Args:
        replacing: also in a frame that is annotated.
    """

    def change(before: FrameAnnotation) -> FrameAnnotation | str:
        why = why_left_alone(before, incoming, replacing=replacing)
        return merged(before, incoming) if why is None else why

    return change


def merged(before: FrameAnnotation, incoming: FrameAnnotation) -> FrameAnnotation:
    """Return what a frame holds after an import: the elements that came, and what has no other
    place."""
    classes = {p.class_name for p in incoming.polylines}
    return replace(
        incoming,
        extra=tuple((dict(before.extra) | dict(incoming.extra)).items()),
        unconfirmed=tuple(p for p in before.unconfirmed if p.class_name not in classes),
    )
