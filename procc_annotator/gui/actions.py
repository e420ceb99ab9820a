"""Every action of the window, in one table: menu, name, text, keys, what it calls, tip.

``slot`` is a dotted path from the main window (``document.undo``), called with ``args``. Actions
with ``scope`` "canvas" work while the picture has the keyboard, so that Enter and Backspace keep
their meaning in text fields.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

MENUS = ("File", "Edit", "Frame", "Element", "View", "Camera", "Help")


@dataclass(frozen=True, slots=True)
class ActionSpec:
    """One row of the table.

    ``menu`` may name a submenu ("View/Colour by"); a "-" in front of ``text`` starts a new group;
    actions with the same ``choice`` exclude each other; ``repeat``: again while the key is held.
    """

    menu: str
    name: str
    text: str
    keys: tuple[str, ...]
    slot: str
    tip: str
    args: tuple[object, ...] = ()
    checkable: bool = False
    checked: bool = False
    choice: str = ""
    scope: Literal["window", "canvas"] = "window"
    repeat: bool = False


def _spec(
    menu: str, name: str, text: str, keys: str, slot: str, tip: str, **more: Any
) -> ActionSpec:
    return ActionSpec(menu, name, text, tuple(keys.split()), slot, tip, **more)


# fmt: off
ACTIONS: tuple[ActionSpec, ...] = (
    _spec("File", "open_folder", "Open folder…", "Ctrl+O", "commands.open_folder",
          "Annotate all pictures of a folder"),
    _spec("File", "open_picture", "Open picture…", "Ctrl+Shift+O", "commands.open_picture",
          "Annotate a single picture"),
    _spec("File", "open_sample", "Open the sample", "", "commands.open_sample",
          "Open the frames that come with the program"),
    _spec("File", "save", "-Save now", "Ctrl+S", "document.save_now",
          "Every finished edit is saved at once; this tries again what failed"),
    _spec("File", "export_annotations", "-Export SoccerNet JSON…", "Ctrl+E",
          "commands.export_annotations",
          "Write the annotations of all frames as a folder or zip of SoccerNet JSON"),
    _spec("File", "export_scores", "Export JaC of the set…", "Ctrl+Shift+E",
          "commands.export_scores",
          "Write the JaC of every frame as CSV or JSON"),
    _spec("File", "quit", "-Quit", "Ctrl+Q", "close",
          "Close the window; everything is saved"),
    _spec("Edit", "undo", "Undo", "Ctrl+Z", "canvas.undo",
          "Take back the last step of this frame", repeat=True),
    _spec("Edit", "redo", "Redo", "Ctrl+Shift+Z Ctrl+Y", "document.redo",
          "Do the step again", repeat=True),
    _spec("Edit", "delete", "-Delete point or element", "Delete", "canvas.key",
          "Remove the selected point; without one, the selected element", args=("Delete",),
          scope="canvas"),
    _spec("Edit", "cancel", "Cancel", "Esc", "canvas.key",
          "Drop the points just clicked, then let go of the selection", args=("Escape",),
          scope="canvas"),
    _spec("Edit/Nudge point", "nudge_left", "Left 1 px", "Left", "canvas.key",
          "Move the selected point 1 px to the left", args=("Left",), scope="canvas", repeat=True),
    _spec("Edit/Nudge point", "nudge_right", "Right 1 px", "Right", "canvas.key",
          "Move the selected point 1 px to the right", args=("Right",), scope="canvas",
          repeat=True),
    _spec("Edit/Nudge point", "nudge_up", "Up 1 px", "Up", "canvas.key",
          "Move the selected point 1 px up", args=("Up",), scope="canvas", repeat=True),
    _spec("Edit/Nudge point", "nudge_down", "Down 1 px", "Down", "canvas.key",
          "Move the selected point 1 px down", args=("Down",), scope="canvas", repeat=True),
    _spec("Edit/Nudge point", "nudge_left_fine", "-Left 0.1 px", "Shift+Left", "canvas.key",
          "Move the selected point 0.1 px to the left", args=("Left", True), scope="canvas",
          repeat=True),
    _spec("Edit/Nudge point", "nudge_right_fine", "Right 0.1 px", "Shift+Right", "canvas.key",
          "Move the selected point 0.1 px to the right", args=("Right", True), scope="canvas",
          repeat=True),
    _spec("Edit/Nudge point", "nudge_up_fine", "Up 0.1 px", "Shift+Up", "canvas.key",
          "Move the selected point 0.1 px up", args=("Up", True), scope="canvas", repeat=True),
    _spec("Edit/Nudge point", "nudge_down_fine", "Down 0.1 px", "Shift+Down", "canvas.key",
          "Move the selected point 0.1 px down", args=("Down", True), scope="canvas", repeat=True),
    _spec("Frame", "next_frame", "Next frame", "D PgDown", "document.next_frame",
          "Show the next picture", repeat=True),
    _spec("Frame", "previous_frame", "Previous frame", "A PgUp", "document.previous_frame",
          "Show the previous picture", repeat=True),
    _spec("Frame", "next_unannotated", "-Next without annotation", "Shift+D",
          "document.go_to_unannotated",
          "Go on to the next frame where nothing is annotated", args=(1,)),
    _spec("Frame", "previous_unannotated", "Previous without annotation", "Shift+A",
          "document.go_to_unannotated",
          "Go back to the frame before where nothing is annotated", args=(-1,)),
    _spec("Frame", "first_frame", "-First frame", "Ctrl+Home", "document.go_to",
          "Show the first picture", args=(0,)),
    _spec("Frame", "last_frame", "Last frame", "Ctrl+End", "commands.last_frame",
          "Show the last picture"),
    _spec("Frame", "find_frame", "Find frame…", "Ctrl+F", "commands.find_frame",
          "Type a part of the frame's name"),
    _spec("Frame", "blind", "-Blind mode", "B", "document.set_blind",
          "Hide the projection until the frame is committed, so that the camera cannot pull the "
          "clicks",
          checkable=True),
    _spec("Frame", "commit", "Commit frame", "Ctrl+Return Ctrl+Enter", "document.commit_frame",
          "This frame is done: in blind mode, show the projection now"),
    _spec("Element", "draw_mode", "Draw", "", "document.set_mode",
          "Clicks add points to the chosen element", args=("draw",), checkable=True, checked=True,
          choice="mode"),
    _spec("Element", "edit_mode", "Edit", "", "document.set_mode",
          "Drag, insert and remove points", args=("edit",), checkable=True, choice="mode"),
    _spec("Element", "switch_mode", "Switch between draw and edit", "W", "commands.switch_mode",
          "From drawing to editing and back"),
    _spec("Element", "next_element", "-Next element", "E", "commands.step_element",
          "Choose the next element of the field", args=(1,), repeat=True),
    _spec("Element", "previous_element", "Previous element", "Q", "commands.step_element",
          "Choose the element before", args=(-1,), repeat=True),
    _spec("Element", "find_element", "Find element…", "/", "commands.find_element",
          "Type a part of the element's name"),
    _spec("Element", "finish", "-Finish element", "Return Enter", "canvas.key",
          "Make the points just clicked an element (or double-click the last one)",
          args=("Enter",), scope="canvas"),
    _spec("Element", "back", "Take back last point", "Backspace", "canvas.key",
          "Remove the point clicked last", args=("Backspace",), scope="canvas", repeat=True),
    _spec("Element", "delete_element", "Delete element", "Ctrl+Delete", "canvas.delete_element",
          "Remove the selected element with all its points", scope="canvas"),
    _spec("View", "fit", "Fit to window", "F Ctrl+0", "canvas.fit",
          "Show the whole picture"),
    _spec("View", "actual_size", "Actual size", "Ctrl+1", "canvas.actual_size",
          "One picture pixel is one screen pixel"),
    _spec("View", "zoom_in", "Zoom in", "Ctrl++ Ctrl+=", "canvas.zoom_in",
          "Magnify (the mouse wheel does it at the cursor)", repeat=True),
    _spec("View", "zoom_out", "Zoom out", "Ctrl+-", "canvas.zoom_out",
          "Reduce (the mouse wheel does it at the cursor)", repeat=True),
    _spec("View", "keep_zoom", "Keep zoom across frames", "Ctrl+K", "canvas.set_keep_zoom",
          "Stay at this place of the picture when the frame changes", checkable=True),
    _spec("View", "hide_overlays", "-Hide overlays", "Ctrl+H", "canvas.set_overlays_hidden",
          "Show the bare picture (or hold X)", checkable=True),
    _spec("View/Colour by", "colour_criterion", "Criterion", "", "canvas.set_colour_by",
          "Colours say how the camera is judged", args=("criterion",), checkable=True,
          checked=True, choice="colour"),
    _spec("View/Colour by", "colour_class", "Class", "", "canvas.set_colour_by",
          "Every element in its own colour", args=("class",), checkable=True, choice="colour"),
    _spec("View", "hide_panels", "-Hide all panels", "F11 \\", "commands.set_panels_hidden",
          "Give the picture all the room", checkable=True),
    _spec("View", "reset_layout", "Reset the layout", "", "commands.reset_layout",
          "Put the panels back where they were at first"),
    _spec("Camera", "load_cameras", "Load cameras…", "Ctrl+L", "commands.load_cameras",
          "Judge a folder of cameras or homographies against the annotations"),
    _spec("Camera", "load_camera_file", "Load camera file…", "Ctrl+Shift+L",
          "commands.load_camera_file",
          "Judge a single camera file, or a zip of them"),
    _spec("Camera", "next_camera", "Next camera set", "C", "commands.next_camera",
          "Switch between the loaded camera sets"),
    _spec("Camera", "tau_up", "-Threshold up 0.5 px", "+ =", "commands.step_tau",
          "Allow larger distances", args=(1,), repeat=True),
    _spec("Camera", "tau_down", "Threshold down 0.5 px", "-", "commands.step_tau",
          "Allow smaller distances only", args=(-1,), repeat=True),
    _spec("Camera/Protocol", "protocol_soccernet", "soccernet", "", "document.set_protocol",
          "The official SoccerNet evaluation, quirks included", args=("soccernet",),
          checkable=True, checked=True, choice="protocol"),
    _spec("Camera/Protocol", "protocol_procc", "procc", "", "document.set_protocol",
          "The paper's definition, without the official code's artefacts", args=("procc",),
          checkable=True, choice="protocol"),
    _spec("Camera/Elements off the ground", "off_plane_missed", "Count as missed",
          "", "commands.set_off_plane",
          "Goals that a homography cannot project count against it", args=("missed",),
          checkable=True, checked=True, choice="off_plane"),
    _spec("Camera/Elements off the ground", "off_plane_left_out", "Leave out", "",
          "commands.set_off_plane",
          "Goals that a homography cannot project are not counted", args=("left_out",),
          checkable=True, choice="off_plane"),
    _spec("Camera", "stop_scoring", "-Stop scoring the set", "", "document.set_scores.cancel",
          "Stop computing the JaC of the frames not opened yet"),
    _spec("Help", "keys", "Keys", "F1 ?", "commands.show_keys",
          "Show all actions and their keys on one sheet"),
    _spec("Help", "about", "About ProCC Annotator", "", "commands.about",
          "Version"),
)
# fmt: on

# What hands do without a menu; the sheet of keys lists them beside the actions.
GESTURES: tuple[tuple[str, str], ...] = (
    ("Wheel", "zoom at the cursor"),
    ("Space + drag", "pan"),
    ("Middle button", "pan"),
    ("Hold X", "hide all overlays"),
    ("Click", "draw: add a point"),
    ("Double-click", "draw: finish"),
    ("Drag a point", "edit: move it"),
    ("Alt+click a line", "edit: insert a point"),
    ("Alt+Shift+click", "edit: remove the point"),
)
