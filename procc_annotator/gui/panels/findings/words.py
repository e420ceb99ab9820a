"""What the list of findings says where it is empty, or is not all that could be known."""

from __future__ import annotations

from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.gui.state.document import Document
from procc_annotator.translation import tr, tr_count


def frame_words(document: Document) -> str:
    """Of the frame on screen: nothing found, or which rules have not been examined and why.

    Empty if there are findings and every rule was examined.
    """
    check, frame = document.label_check, document.state.frame
    if frame is None:
        return tr("No frames.\nOpen a folder of pictures to check their labels.")
    if not document.state.annotation.annotated:
        return tr("Nothing is annotated in this frame.")
    checked = check.checked
    if checked is None:
        return "" if check.shown else tr("Checking this frame…")
    found = bool(check.shown)
    limit = _limit(document, checked.failure)
    if limit:
        nothing = tr("Nothing found by the rules that need no camera.")
        return limit if found else f"{nothing}\n{limit}"
    ignored = check.known.ignored_here()
    if found:
        return ""
    if ignored:
        return tr_count(
            ignored,
            "Nothing found but {n:,} ignored finding.",
            "Nothing found but {n:,} ignored findings.",
        )
    return tr("Nothing found in this frame.")


def _limit(document: Document, failure: str) -> str:
    if not document.state.projection_visible:
        return tr(
            "Blind: findings that need a camera wait until this frame is committed (Ctrl+Enter)."
        )
    checked = document.label_check.checked
    if checked is not None and not checked.fitted:
        return tr("The live fit is off: only the rules that need no camera are looked at.")
    if failure:
        return tr(
            "No camera fits yet ({why}): only the rules that need none are looked at.", why=failure
        )
    return ""


def set_words(document: Document) -> str:
    """Of the whole set: nothing found, or what was not checked.

    Empty if there are findings and every frame was checked.
    """
    check, workspace = document.label_check, document.state.workspace
    if workspace is None or not workspace.frames:
        return tr("No frames.\nOpen a folder of pictures to check their labels.")
    if check.running:
        return "" if check.known.in_set() else tr("Checking the set…")
    problems = ""
    if document.state.blind:
        problems = tr("Blind: only committed frames are checked with a camera.")
    if check.problems:
        count = len(check.problems)
        name, why = next(iter(check.problems.items()))
        said = tr_count(
            count,
            "{n:,} frame cannot be checked, such as {name}: {why}",
            "{n:,} frames cannot be checked, such as {name}: {why}",
            name=name,
            why=why,
        )
        problems = "\n".join(filter(None, (problems, said)))
    if not check.set_checked:
        return tr_count(
            check.known.count,
            "The set is not checked yet; {n:,} frame looked at so far.",
            "The set is not checked yet; {n:,} frames looked at so far.",
        )
    if check.known.in_set():
        return problems
    nothing = tr_count(
        check.known.count, "Nothing found in {n:,} frame.", "Nothing found in {n:,} frames."
    )
    return "\n".join(filter(None, (nothing, problems)))


def so_many(severity: Severity, count: int) -> str:
    """Return how many findings are that sure: "2 errors"."""
    match severity:
        case Severity.ERROR:
            return tr_count(count, "{n:,} error", "{n:,} errors")
        case Severity.WARNING:
            return tr_count(count, "{n:,} warning", "{n:,} warnings")
        case Severity.HINT:
            return tr_count(count, "{n:,} hint", "{n:,} hints")
