"""Every action of the window, in one table: name, text, keys, menu, what it calls, tip.

``slot`` is a dotted path from the main window (``document.undo``), called with ``args``. Actions with ``scope`` "canvas"
work while the picture has the keyboard, so that Enter and Backspace keep their meaning in text fields.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from operator import attrgetter
from typing import Literal, cast

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu, QWidget

MENUS = ("File", "Edit", "Frame", "Element", "View", "Camera", "Help")


@dataclass(frozen=True, slots=True)
class ActionSpec:
    """One row of the table; ``menu`` may name a submenu ("View/Colour by"), "-" in front of the
    text starts a new group, actions with the same ``choice`` exclude each other."""

    name: str
    text: str
    keys: tuple[str, ...]
    menu: str
    slot: str
    tip: str
    checkable: bool = False
    checked: bool = False
    choice: str = ""
    scope: Literal["window", "canvas"] = "window"
    repeat: bool = False
    args: tuple[object, ...] = ()


def _spec(
    name: str, text: str, keys: str, menu: str, slot: str, tip: str, **more: object
) -> ActionSpec:
    return ActionSpec(name, text, tuple(keys.split()), menu, slot, tip, **more)  # type: ignore[arg-type]


_CANVAS = {"scope": "canvas"}
_AGAIN = {"scope": "canvas", "repeat": True}
_CHECK = {"checkable": True}

ACTIONS: tuple[ActionSpec, ...] = (
    _spec(
        "open_folder",
        "Open folder…",
        "Ctrl+O",
        "File",
        "commands.open_folder",
        "Annotate all pictures of a folder",
    ),
    _spec(
        "open_picture",
        "Open picture…",
        "Ctrl+Shift+O",
        "File",
        "commands.open_picture",
        "Annotate a single picture",
    ),
    _spec(
        "open_sample",
        "Open the sample",
        "",
        "File",
        "commands.open_sample",
        "Open the frames that come with the program",
    ),
    _spec(
        "save",
        "-Save now",
        "Ctrl+S",
        "File",
        "document.save_now",
        "Every finished edit is saved at once; this tries again what failed",
    ),
    _spec(
        "export_annotations",
        "-Export SoccerNet JSON…",
        "Ctrl+E",
        "File",
        "commands.export_annotations",
        "Write the annotations of all frames as a folder or zip of SoccerNet JSON",
    ),
    _spec(
        "export_scores",
        "Export JaC of the set…",
        "Ctrl+Shift+E",
        "File",
        "commands.export_scores",
        "Write the JaC of every frame as CSV or JSON",
    ),
    _spec("quit", "-Quit", "Ctrl+Q", "File", "close", "Close the window; everything is saved"),
    _spec(
        "undo",
        "Undo",
        "Ctrl+Z",
        "Edit",
        "canvas.undo",
        "Take back the last step of this frame",
        repeat=True,
    ),
    _spec(
        "redo",
        "Redo",
        "Ctrl+Shift+Z Ctrl+Y",
        "Edit",
        "document.redo",
        "Do the step again",
        repeat=True,
    ),
    _spec(
        "delete",
        "-Delete point or element",
        "Delete",
        "Edit",
        "canvas.key",
        "Remove the selected point; without one, the selected element",
        **_CANVAS,
        args=("Delete",),
    ),
    _spec(
        "cancel",
        "Cancel",
        "Esc",
        "Edit",
        "canvas.key",
        "Drop the points just clicked, then let go of the selection",
        **_CANVAS,
        args=("Escape",),
    ),
    _spec(
        "nudge_left",
        "Left 1 px",
        "Left",
        "Edit/Nudge point",
        "canvas.key",
        "Move the selected point 1 px to the left",
        **_AGAIN,
        args=("Left",),
    ),
    _spec(
        "nudge_right",
        "Right 1 px",
        "Right",
        "Edit/Nudge point",
        "canvas.key",
        "Move the selected point 1 px to the right",
        **_AGAIN,
        args=("Right",),
    ),
    _spec(
        "nudge_up",
        "Up 1 px",
        "Up",
        "Edit/Nudge point",
        "canvas.key",
        "Move the selected point 1 px up",
        **_AGAIN,
        args=("Up",),
    ),
    _spec(
        "nudge_down",
        "Down 1 px",
        "Down",
        "Edit/Nudge point",
        "canvas.key",
        "Move the selected point 1 px down",
        **_AGAIN,
        args=("Down",),
    ),
    _spec(
        "nudge_left_fine",
        "-Left 0.1 px",
        "Shift+Left",
        "Edit/Nudge point",
        "canvas.key",
        "Move the selected point 0.1 px to the left",
        **_AGAIN,
        args=("Left", True),
    ),
    _spec(
        "nudge_right_fine",
        "Right 0.1 px",
        "Shift+Right",
        "Edit/Nudge point",
        "canvas.key",
        "Move the selected point 0.1 px to the right",
        **_AGAIN,
        args=("Right", True),
    ),
    _spec(
        "nudge_up_fine",
        "Up 0.1 px",
        "Shift+Up",
        "Edit/Nudge point",
        "canvas.key",
        "Move the selected point 0.1 px up",
        **_AGAIN,
        args=("Up", True),
    ),
    _spec(
        "nudge_down_fine",
        "Down 0.1 px",
        "Shift+Down",
        "Edit/Nudge point",
        "canvas.key",
        "Move the selected point 0.1 px down",
        **_AGAIN,
        args=("Down", True),
    ),
    _spec(
        "next_frame",
        "Next frame",
        "D PgDown",
        "Frame",
        "document.next_frame",
        "Show the next picture",
        repeat=True,
    ),
    _spec(
        "previous_frame",
        "Previous frame",
        "A PgUp",
        "Frame",
        "document.previous_frame",
        "Show the previous picture",
        repeat=True,
    ),
    _spec(
        "next_unannotated",
        "-Next without annotation",
        "Shift+D",
        "Frame",
        "document.go_to_unannotated",
        "Go on to the next frame where nothing is annotated",
        args=(1,),
    ),
    _spec(
        "previous_unannotated",
        "Previous without annotation",
        "Shift+A",
        "Frame",
        "document.go_to_unannotated",
        "Go back to the frame before where nothing is annotated",
        args=(-1,),
    ),
    _spec(
        "first_frame",
        "-First frame",
        "Ctrl+Home",
        "Frame",
        "document.go_to",
        "Show the first picture",
        args=(0,),
    ),
    _spec(
        "last_frame",
        "Last frame",
        "Ctrl+End",
        "Frame",
        "commands.last_frame",
        "Show the last picture",
    ),
    _spec(
        "blind",
        "-Blind mode",
        "B",
        "Frame",
        "document.set_blind",
        "Hide the projection until the frame is committed, so that the camera cannot pull the clicks",
        **_CHECK,
    ),
    _spec(
        "commit",
        "Commit frame",
        "Ctrl+Return Ctrl+Enter",
        "Frame",
        "document.commit_frame",
        "This frame is done: in blind mode, show the projection now",
    ),
    _spec(
        "draw_mode",
        "Draw",
        "",
        "Element",
        "document.set_mode",
        "Clicks add points to the chosen element",
        checkable=True,
        checked=True,
        choice="mode",
        args=("draw",),
    ),
    _spec(
        "edit_mode",
        "Edit",
        "",
        "Element",
        "document.set_mode",
        "Drag, insert and remove points",
        checkable=True,
        choice="mode",
        args=("edit",),
    ),
    _spec(
        "switch_mode",
        "Switch between draw and edit",
        "W",
        "Element",
        "commands.switch_mode",
        "From drawing to editing and back",
    ),
    _spec(
        "next_element",
        "-Next element",
        "E",
        "Element",
        "commands.step_element",
        "Choose the next element of the field",
        repeat=True,
        args=(1,),
    ),
    _spec(
        "previous_element",
        "Previous element",
        "Q",
        "Element",
        "commands.step_element",
        "Choose the element before",
        repeat=True,
        args=(-1,),
    ),
    _spec(
        "find_element",
        "Find element…",
        "/",
        "Element",
        "commands.find_element",
        "Type a part of the element's name",
    ),
    _spec(
        "finish",
        "-Finish element",
        "Return Enter",
        "Element",
        "canvas.key",
        "Make the points just clicked an element (or double-click the last one)",
        **_CANVAS,
        args=("Enter",),
    ),
    _spec(
        "back",
        "Take back last point",
        "Backspace",
        "Element",
        "canvas.key",
        "Remove the point clicked last",
        **_AGAIN,
        args=("Backspace",),
    ),
    _spec(
        "delete_element",
        "Delete element",
        "Ctrl+Delete",
        "Element",
        "canvas.delete_element",
        "Remove the selected element with all its points",
        **_CANVAS,
    ),
    _spec("fit", "Fit to window", "F Ctrl+0", "View", "canvas.fit", "Show the whole picture"),
    _spec(
        "actual_size",
        "Actual size",
        "Ctrl+1",
        "View",
        "canvas.actual_size",
        "One picture pixel is one screen pixel",
    ),
    _spec(
        "zoom_in",
        "Zoom in",
        "Ctrl++ Ctrl+=",
        "View",
        "canvas.zoom_in",
        "Magnify (the mouse wheel does it at the cursor)",
        repeat=True,
    ),
    _spec(
        "zoom_out",
        "Zoom out",
        "Ctrl+-",
        "View",
        "canvas.zoom_out",
        "Reduce (the mouse wheel does it at the cursor)",
        repeat=True,
    ),
    _spec(
        "keep_zoom",
        "Keep zoom across frames",
        "Ctrl+K",
        "View",
        "canvas.set_keep_zoom",
        "Stay at this place of the picture when the frame changes",
        **_CHECK,
    ),
    _spec(
        "hide_overlays",
        "-Hide overlays",
        "Ctrl+H",
        "View",
        "canvas.set_overlays_hidden",
        "Show the bare picture (or hold X)",
        **_CHECK,
    ),
    _spec(
        "colour_criterion",
        "Criterion",
        "",
        "View/Colour by",
        "canvas.set_colour_by",
        "Colours say how the camera is judged",
        checkable=True,
        checked=True,
        choice="colour",
        args=("criterion",),
    ),
    _spec(
        "colour_class",
        "Class",
        "",
        "View/Colour by",
        "canvas.set_colour_by",
        "Every element in its own colour",
        checkable=True,
        choice="colour",
        args=("class",),
    ),
    _spec(
        "hide_panels",
        "-Hide all panels",
        "F11 \\",
        "View",
        "commands.set_panels_hidden",
        "Give the picture all the room",
        **_CHECK,
    ),
    _spec(
        "reset_layout",
        "Reset the layout",
        "",
        "View",
        "commands.reset_layout",
        "Put the panels back where they were at first",
    ),
    _spec(
        "load_cameras",
        "Load cameras…",
        "Ctrl+L",
        "Camera",
        "commands.load_cameras",
        "Judge a folder of cameras or homographies against the annotations",
    ),
    _spec(
        "load_camera_file",
        "Load camera file…",
        "Ctrl+Shift+L",
        "Camera",
        "commands.load_camera_file",
        "Judge a single camera file, or a zip of them",
    ),
    _spec(
        "next_camera",
        "Next camera set",
        "C",
        "Camera",
        "commands.next_camera",
        "Switch between the loaded camera sets",
    ),
    _spec(
        "tau_up",
        "-Threshold up 0.5 px",
        "+ =",
        "Camera",
        "commands.step_tau",
        "Allow larger distances",
        repeat=True,
        args=(1,),
    ),
    _spec(
        "tau_down",
        "Threshold down 0.5 px",
        "-",
        "Camera",
        "commands.step_tau",
        "Allow smaller distances only",
        repeat=True,
        args=(-1,),
    ),
    _spec(
        "protocol_soccernet",
        "soccernet",
        "",
        "Camera/Protocol",
        "document.set_protocol",
        "The official SoccerNet evaluation, quirks included",
        checkable=True,
        checked=True,
        choice="protocol",
        args=("soccernet",),
    ),
    _spec(
        "protocol_procc",
        "procc",
        "",
        "Camera/Protocol",
        "document.set_protocol",
        "The paper's definition, without the official code's artefacts",
        checkable=True,
        choice="protocol",
        args=("procc",),
    ),
    _spec(
        "off_plane_missed",
        "Count as missed",
        "",
        "Camera/Homographies: elements off the ground",
        "commands.set_off_plane",
        "Goals that a homography cannot project count against it",
        checkable=True,
        checked=True,
        choice="off_plane",
        args=("missed",),
    ),
    _spec(
        "off_plane_left_out",
        "Leave out",
        "",
        "Camera/Homographies: elements off the ground",
        "commands.set_off_plane",
        "Goals that a homography cannot project are not counted",
        checkable=True,
        choice="off_plane",
        args=("left_out",),
    ),
    _spec(
        "stop_scoring",
        "-Stop scoring the set",
        "",
        "Camera",
        "document.set_scores.cancel",
        "Stop computing the JaC of the frames not opened yet",
    ),
    _spec(
        "keys",
        "Keys",
        "F1 ?",
        "Help",
        "commands.show_keys",
        "Show all actions and their keys on one sheet",
    ),
    _spec("about", "About ProCC Annotator", "", "Help", "commands.about", "Version"),
)

# What hands do without a menu; the sheet of keys lists them beside the actions.
GESTURES: tuple[tuple[str, str], ...] = (
    ("Wheel", "zoom at the cursor"),
    ("Space + drag, middle button", "pan, in every mode"),
    ("Hold X", "hide all overlays"),
    ("Draw: click", "add a point to the chosen element"),
    ("Draw: double-click", "finish the element"),
    ("Edit: drag a point", "move it"),
    ("Edit: Alt + click a line", "insert a point"),
    ("Edit: Alt + Shift + click a point", "remove it"),
)


class Actions:
    """The table as QActions, in menus, bound to what they call."""

    def __init__(self, window: QMainWindow, canvas: QWidget) -> None:
        self._by_name: dict[str, QAction] = {}
        self._groups: dict[str, QActionGroup] = {}
        self.menus: dict[str, QMenu] = {m: window.menuBar().addMenu(_mnemonic(m)) for m in MENUS}
        for spec in ACTIONS:
            action = self._make(spec, window, canvas)
            menu = self._menu(spec.menu)
            if spec.text.startswith("-"):
                menu.addSeparator()
            menu.addAction(action)
            (canvas if spec.scope == "canvas" else window).addAction(action)
            self._by_name[spec.name] = action

    def __getitem__(self, name: str) -> QAction:
        return self._by_name[name]

    def __iter__(self) -> Iterator[QAction]:
        return iter(self._by_name.values())

    def set_checked(self, name: str, checked: bool) -> None:
        """Show a state that changed elsewhere, without calling anything."""
        action = self._by_name[name]
        if action.isChecked() != checked:
            action.setChecked(checked)  # slots hang on `triggered`, which only a person sends

    def _make(self, spec: ActionSpec, window: QMainWindow, canvas: QWidget) -> QAction:
        action = QAction(spec.text.lstrip("-"), window)
        action.setObjectName(f"action_{spec.name}")
        action.setShortcuts([QKeySequence(k) for k in spec.keys])
        action.setAutoRepeat(spec.repeat)
        keys = (
            f" ({action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)})"
            if spec.keys
            else ""
        )
        action.setToolTip(f"{spec.tip}{keys}")
        action.setStatusTip("")
        if spec.scope == "canvas":
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        if spec.choice:
            self._groups.setdefault(spec.choice, QActionGroup(window)).addAction(action)
        action.setCheckable(spec.checkable)
        action.setChecked(spec.checked)
        slot = cast(Callable[..., object], attrgetter(spec.slot)(window))
        if spec.checkable and not spec.choice:
            action.triggered.connect(lambda checked: slot(checked))
        else:
            action.triggered.connect(lambda: slot(*spec.args))
        return action

    def _menu(self, path: str) -> QMenu:
        menu = self.menus.get(path)
        if menu is None:
            parent, _, title = path.rpartition("/")
            menu = self.menus[path] = self._menu(parent).addMenu(title)
        return menu


def _mnemonic(title: str) -> str:
    return f"&{title}" if title != "Element" else "E&lement"
