"""Edits of frames that need not be on screen: each locked, and a step of its history."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from typing import TYPE_CHECKING

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.session.facts.origins import OriginKind

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document


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
    document: Document, index: int, incoming: FrameAnnotation, *, replacing: bool
) -> str:
    """Replace what is annotated in a frame; undo and versions keep what was there.

    Unconfirmed elements of other classes stay, and so do further entries of the file. The frame is
    locked then: whoever calls this saves it and gives it back (``document.presence.give_back``).

    Args:
        replacing: also in a frame that is annotated, by its file as it is once the lock is taken.

    Returns:
        Why the frame was left as it was, not locked (a `LeftAlone` when there is nothing to do);
        empty when it was not.
    """
    workspace = document.workspace
    assert workspace is not None
    name = workspace.frames[index].name
    if index == document.frame_index:
        if not document.begin_edit():
            return document.frame_error or "it cannot be edited"
    else:
        holder = document.presence.borrow(name)
        if holder is not None:
            return f"{holder.author or 'somebody'} is editing it"
    why = _replace(document, index, incoming, replacing)
    if why:
        document.presence.give_back(name)
    return why


def _replace(document: Document, index: int, incoming: FrameAnnotation, replacing: bool) -> str:
    workspace = document.workspace
    assert workspace is not None
    name = workspace.frames[index].name
    workspace.look_again(index)
    state = workspace.state(index)
    if state.error is None and index != document.frame_index:
        try:
            # Another window may have saved it since it was read here.
            if workspace.refresh(index):
                document.saver.save(index)  # no conflict is left to be decided
        except InputError as error:
            return str(error)
    if state.error is not None:
        return str(state.error)
    before = state.history.current
    if (why := why_left_alone(before, incoming, replacing=replacing)) is not None:
        return why
    after = merged(before, incoming)
    if index == document.frame_index:
        document.commit_edit("import", after, OriginKind.FILE)
    elif workspace.edit(index, "import", after):
        document.review.note_edit(name, before, after, OriginKind.FILE)
        document.review.touched(name, before, after)
    return ""


def merged(before: FrameAnnotation, incoming: FrameAnnotation) -> FrameAnnotation:
    """What a frame holds after an import: the elements that came, and what has no other place."""
    classes = {p.class_name for p in incoming.polylines}
    return replace(
        incoming,
        extra=tuple((dict(before.extra) | dict(incoming.extra)).items()),
        unconfirmed=tuple(p for p in before.unconfirmed if p.class_name not in classes),
    )
