"""What the list of findings says where it is empty, or is not all that could be known."""

from __future__ import annotations

from procc_annotator.gui.state.document import Document
from procc_annotator.interact.hints import counted


def frame_words(document: Document) -> str:
    """Of the frame on screen: nothing found, or which rules have not been looked at and why.

    Empty if there are findings and every rule was looked at.
    """
    check, frame = document.label_check, document.frame
    if frame is None:
        return "No frames.\nOpen a folder of pictures to check their labels."
    if not document.annotation.annotated:
        return "Nothing is annotated in this frame."
    checked = check.checked
    if checked is None:
        return "" if check.shown else "Checking this frame…"
    found = bool(check.shown)
    limit = _limit(document, checked.failure)
    if limit:
        nothing = "" if found else "Nothing found by the rules that need no camera.\n"
        return f"{nothing}{limit}"
    ignored = check.ignored_here()
    if found:
        return ""
    if ignored:
        return f"Nothing found but {counted(ignored, 'ignored finding')}."
    return "Nothing found in this frame."


def _limit(document: Document, failure: str) -> str:
    if not document.projection_visible:
        return "Blind: findings that need a camera wait until this frame is committed (Ctrl+Enter)."
    checked = document.label_check.checked
    if checked is not None and not checked.fitted:
        return "The live fit is off: only the rules that need no camera are looked at."
    if failure:
        return f"No camera fits yet ({failure}): only the rules that need none are looked at."
    return ""


def set_words(document: Document) -> str:
    """Of the whole set: nothing found, or what was not checked.

    Empty if there are findings and every frame was checked.
    """
    check, workspace = document.label_check, document.workspace
    if workspace is None or not workspace.frames:
        return "No frames.\nOpen a folder of pictures to check their labels."
    if check.running:
        return "" if check.in_set() else "Checking the set…"
    problems = ""
    if document.blind:
        problems = "Blind: only committed frames are checked with a camera."
    if check.problems:
        count = len(check.problems)
        name, why = next(iter(check.problems.items()))
        said = f"{counted(count, 'frame')} cannot be checked, such as {name}: {why}"
        problems = "\n".join(filter(None, (problems, said)))
    if not check.set_checked:
        known = counted(check.known_frames, "frame")
        return f"The set is not checked yet; {known} looked at so far."
    if check.in_set():
        return problems
    nothing = f"Nothing found in {counted(check.known_frames, 'frame')}."
    return "\n".join(filter(None, (nothing, problems)))
