"""What a strip says of a frame."""

from __future__ import annotations

from procc_annotator.gui.state.document import Document
from procc_annotator.gui.strip.content import StripContent
from procc_annotator.session.dataset.tracked_cameras import doubt_about
from procc_annotator.session.facts.origins import Status


def words_of(document: Document, content: StripContent, number: int | None) -> str:
    """Number, time and what is known of its camera, in a line."""
    sequence = content.sequence
    if sequence is None or number is None:
        return ""
    index = sequence.index_of.get(number)
    name = None
    if index is not None and document.workspace is not None:
        name = document.workspace.frames[index].name
    said = [f"frame {number} of {sequence.first}–{sequence.last}"]
    if name is not None and "/" in name:
        said = [name]  # in a tree numbers go on from folder to folder
    if sequence.step > 1:
        said.append(f"names count by {sequence.step}")
    if sequence.video is not None:
        seconds = number / sequence.fps
        said.append(f"{int(seconds // 60)}:{seconds % 60:05.2f}")
    if number in content.anchors:
        said.append("annotated")
    if number in content.dragged and not content.hidden:
        said.append("its camera was dragged")
    status = content.statuses.get(number, Status.UNTOUCHED)
    if status is not Status.UNTOUCHED:
        said.append(status.value)
    if document.state.reveals(name):
        said.extend(_of_track(document, number))
    else:
        said.append("blind: its camera is hidden")
    return "  ·  ".join(said)


def _of_track(document: Document, number: int) -> list[str]:
    frame = document.shot_track.tracked.get(number)
    if frame is None:
        return []
    said: list[str] = [frame.state]
    if frame.fit is not None and frame.fit.camera is not None:
        far = f", {frame.residual_px:.1f} px from it" if frame.residual_px is not None else ""
        said[0] += f", {frame.coverage:.0%} of the lines on paint{far}"
    if doubt := doubt_about(frame):
        said.append(f"doubtful: {doubt}")
    return said
