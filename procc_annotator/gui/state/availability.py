"""Why something is not offered, for menus, messages and empty panels; empty where it is offered."""

from __future__ import annotations

from procc_annotator.gui.state.state import State
from procc_annotator.translation import tr


def no_frame(state: State) -> str:
    """No frame is on screen."""
    return tr("open a folder of pictures first") if state.frame is None else ""


def hidden(state: State) -> str:
    """Blind mode hides the cameras of the frame on screen."""
    if state.projection_visible:
        return ""
    return tr("blind: the camera is hidden until this frame is committed (Ctrl+Enter)")


def no_source(state: State) -> str:
    """No camera source is active."""
    if state.active is not None:
        return ""
    if state.sources:
        return tr("choose the camera to judge first (C)")
    return tr("load cameras first: there is nothing to score")


def no_fit(state: State, locked: str, *, wanted: bool) -> str:
    """The clicks on screen are not fitted; ``locked``: that the dataset is locked to blind mode,
    which has no fit, empty if it is not."""
    off = "" if wanted else tr("the live fit is off (Ctrl+T)")
    return no_frame(state) or locked or off or hidden(state)


def as_sentence(text: str) -> str:
    """With a capital and a full stop; a path stays as it is written."""
    first = text.split(" ", 1)[0]
    if "/" not in first and "\\" not in first and ":" not in first[:-1] and "." not in first:
        text = f"{text[:1].upper()}{text[1:]}"
    return tr("{text}.", text=text) if text else ""
