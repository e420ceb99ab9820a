"""What a strip says of a frame."""

from __future__ import annotations

from procc_annotator.dataset.computed_cameras import review_reason
from procc_annotator.dataset.records import Status
from procc_annotator.gui.panels.timeline.content import StripContent
from procc_annotator.gui.state.document import Document
from procc_annotator.translation import tr, word

# How a frame's camera came about.
_STATES = {
    "anchor": word("anchor", "a frame"),
    "followed": word("followed", "a frame"),
    "bridged": word("bridged", "a frame"),
    "lost": word("lost", "a frame"),
}


def strip_words(document: Document, content: StripContent, number: int | None) -> str:
    """Number, time and what is known of its camera, in a line."""
    sequence = content.sequence
    if sequence is None or number is None:
        return ""
    index = sequence.index_of.get(number)
    name = None
    if index is not None and document.state.workspace is not None:
        name = document.state.workspace.frames[index].name
    said = [
        tr(
            "frame {number} of {first}–{last}",
            number=number,
            first=sequence.first,
            last=sequence.last,
        )
    ]
    if name is not None and "/" in name:
        said = [name]  # in a tree numbers go on from folder to folder
    if sequence.step > 1:
        said.append(tr("names count by {step}", step=sequence.step))
    if sequence.video is not None:
        seconds = number / sequence.fps
        said.append(f"{int(seconds // 60)}:{seconds % 60:05.2f}")
    if number in content.anchors:
        said.append(tr("annotated"))
    if number in content.dragged and not content.hidden:
        said.append(tr("its camera was dragged"))
    status = content.statuses.get(number, Status.UNTOUCHED)
    if status is not Status.UNTOUCHED:
        said.append(tr(status.value, "a frame"))
    if document.state.reveals(name):
        said.extend(_of_track(document, number))
    else:
        said.append(tr("blind: its camera is hidden"))
    return "  ·  ".join(said)


def _of_track(document: Document, number: int) -> list[str]:
    frame = document.shot_track.tracked.get(number)
    if frame is None:
        return []
    said = [tr(_STATES[frame.state], "a frame")]
    if frame.fit is not None and frame.fit.camera is not None:
        said[0] = tr(
            "{state}, {share:.0%} of the lines on paint", state=said[0], share=frame.coverage
        )
        if (far := frame.residual_px) is not None:
            said[0] = tr("{found}, {far:.1f} px from it", found=said[0], far=far)
    if doubt := review_reason(frame):
        said.append(tr("doubtful: {why}", why=doubt))
    return said
