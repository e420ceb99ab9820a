"""What hands do without a menu: keys that are held, and the mouse."""

from __future__ import annotations

from procc_annotator.translation import word

# Keys that mean something while they are held, without Shift and the like.
HELD_KEYS = ("X", "Z", ",", "Space")  # not shown

# The sheet of keys lists them next to the actions.
GESTURES: tuple[tuple[str, str], ...] = (
    (word("Wheel"), word("zoom at the cursor")),
    (word("Two fingers"), word("pan; pinched, zoom")),
    (word("Shift + wheel"), word("pan sideways, as a tilted wheel does")),
    (word("Space + drag"), word("pan")),
    (word("Middle button"), word("pan")),
    (word("Hold X"), word("hide all overlays")),
    (word("Hold Z"), word("loupe: eight times the picture's pixels")),
    (word("Hold ,"), word("look at the compared camera source")),
    (word("Tap ,"), word("judge with the compared source, compare with this one")),
    (word("Hold Ctrl"), word("click beside the line: no snapping")),
    (word("Ctrl+Alt + drag a line"), word("camera: it follows, the place stays as a peg")),
    (word("Ctrl+Alt + click a peg"), word("camera: take the peg away")),
    (word("Arrows"), word("crosshair: the keys point; chosen points are moved instead")),
    (word("Space at the crosshair"), word("what a click does there (with Ctrl: no snapping)")),
    (word("Right button"), word("menu of what is under the cursor")),
    (word("Enter"), word("accept the current ghost")),
    (word("Shift+Enter"), word("accept all ghosts")),
    (word("Click"), word("draw: add a point")),
    (word("Double-click"), word("draw: finish")),
    (word("Drag a point"), word("edit: move it")),
    (word("Shift+click a point"), word("edit: choose several")),
    (word("Drag on empty ground"), word("edit: choose the points inside")),
    (word("Drag a line"), word("edit: move the element, unless elements are pinned")),
    (word("Alt+click a line"), word("edit: insert a point")),
    (word("Alt+Shift+click"), word("edit: remove the point")),
    (word("Click or drag on the strip"), word("go to a frame")),
    (word("Wheel on the strip"), word("zoom; with Shift, scroll")),
    (word("Shift+drag on the strip"), word("mark a stretch (a double click lets go of it)")),
)
