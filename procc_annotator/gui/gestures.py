"""What hands do without a menu: keys that are held, and the mouse."""

from __future__ import annotations

# Keys that mean something while they are held, without Shift and the like.
HELD_KEYS = ("X", "Z", ",", "Space")

# The sheet of keys lists them beside the actions.
GESTURES: tuple[tuple[str, str], ...] = (
    ("Wheel", "zoom at the cursor"),
    ("Two fingers", "pan; pinched, zoom"),
    ("Shift + wheel", "pan sideways, as a tilted wheel does"),
    ("Space + drag", "pan"),
    ("Middle button", "pan"),
    ("Hold X", "hide all overlays"),
    ("Hold Z", "loupe: eight times the picture's pixels"),
    ("Hold ,", "look at the compared camera source"),
    ("Tap ,", "judge with the compared source, compare with this one"),
    ("Hold Ctrl", "click beside the line: no snapping"),
    ("Ctrl+Alt + drag a line", "camera: it follows, the place stays as a peg"),
    ("Ctrl+Alt + click a peg", "camera: take the peg away"),
    ("Arrows", "crosshair: the keys point; chosen points are moved instead"),
    ("Space at the crosshair", "what a click does there (with Ctrl: no snapping)"),
    ("Right button", "menu of what is under the cursor"),
    ("Enter", "accept the current ghost"),
    ("Shift+Enter", "accept all ghosts"),
    ("Click", "draw: add a point"),
    ("Double-click", "draw: finish"),
    ("Drag a point", "edit: move it"),
    ("Shift+click a point", "edit: choose several"),
    ("Drag on empty ground", "edit: choose the points inside"),
    ("Drag a line", "edit: move the element, unless elements are pinned"),
    ("Alt+click a line", "edit: insert a point"),
    ("Alt+Shift+click", "edit: remove the point"),
    ("Click or drag on the strip", "go to a frame"),
    ("Wheel on the strip", "zoom; with Shift, scroll"),
    ("Shift+drag on the strip", "mark a stretch (a double click lets go of it)"),
)
