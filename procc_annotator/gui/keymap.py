"""Keys of actions and elements: the defaults, or those that the user chose instead."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent, QKeySequence

from procc_annotator.errors import UsageError
from procc_annotator.field.model import Element, Field
from procc_annotator.gui.actions import ACTIONS, ActionSpec
from procc_annotator.translation import tr, word

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
    (word("Hold Ctrl"), word("click off the line: no snapping")),
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


NATIVE = QKeySequence.SequenceFormat.NativeText
_PORTABLE = QKeySequence.SequenceFormat.PortableText
_HELD = word("what is held down in the picture")


@dataclass(frozen=True)
class Keymap:
    """Keys of one's own; what is not named has its usual keys.

    Attributes:
        actions: name in the table of actions -> its keys, none for an action without any.
        elements: class -> its keys, "" for none.
    """

    actions: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    elements: Mapping[str, str] = field(default_factory=dict)

    def __hash__(self) -> int:
        return hash((frozenset(self.actions.items()), frozenset(self.elements.items())))

    def of_action(self, spec: ActionSpec) -> tuple[str, ...]:
        """The keys that call an action."""
        return self.actions.get(spec.name, spec.keys)

    def of_element(self, element: Element) -> str:
        """The keys that choose an element, unless they call something else."""
        return self.elements.get(element.name, element.shortcut)

    def with_action(self, spec: ActionSpec, keys: tuple[str, ...]) -> Keymap:
        """The same with other keys of an action."""
        others = {name: own for name, own in self.actions.items() if name != spec.name}
        own = {} if keys == spec.keys else {spec.name: keys}
        return Keymap(others | own, self.elements)

    def with_element(self, element: Element, keys: str) -> Keymap:
        """The same with other keys of an element."""
        others = {name: own for name, own in self.elements.items() if name != element.name}
        own = {} if keys == element.shortcut else {element.name: keys}
        return Keymap(self.actions, others | own)


USUAL = Keymap()

# Keys as in other programs, or for the left hand.
PRESETS: Mapping[str, Keymap] = {
    word("Usual"): USUAL,
    word("Left-handed"): Keymap(
        {
            "next_frame": ("P", "PgDown"),
            "previous_frame": ("O", "PgUp"),
            "next_unfinished": ("Ctrl+Alt+P",),
            "previous_unfinished": ("Ctrl+Alt+O",),
            "next_element": ("Shift+P",),
            "previous_element": ("Shift+O",),
            "regularise": ("L",),
            "regularise_all": ("Shift+L",),
            "switch_mode": ("Home",),  # not shown
            "snapping": ("End",),  # not shown
            "copy_previous": ("Ins",),  # not shown
            "insert_point": ("Ctrl+Ins",),  # not shown
            "confirm_all": ("Shift+Ins",),
        }
    ),
    word("Like CVAT"): Keymap(
        {
            "next_frame": ("F", "PgDown"),
            "previous_frame": ("D", "PgUp"),
            "ten_on": ("V", "Shift+PgDown"),
            "ten_back": ("C", "Shift+PgUp"),
            "next_unfinished": ("Shift+F",),
            "previous_unfinished": ("Shift+D",),
            "fit": ("Ctrl+0",),
            "copy_previous": ("Ctrl+V",),
            "next_camera": ("Ctrl+Alt+C",),
            "previous_camera": ("Ctrl+Alt+Shift+C",),
        }
    ),
    word("Like labelme"): Keymap(
        {
            "draw_mode": ("Ctrl+N",),
            "edit_mode": ("Ctrl+J",),
            "open_folder": ("Ctrl+O", "Ctrl+U"),
            "uncertainty": ("Ctrl+Shift+U",),
            "fit": ("F", "Ctrl+Shift+G"),
            "next_frame": ("D", "PgDown"),
            "previous_frame": ("A", "PgUp"),
        }
    ),
}


def chords_of(text: str) -> tuple[str, ...]:
    """The chords of a sequence in Qt's own words; () for keys that Qt does not know."""
    written = QKeySequence(text).toString(_PORTABLE)
    return tuple(written.split(", ")) if written else ()


def short_text(keys: str) -> str:
    """Keys as people write them, for where room is scarce: with the sign of Shift."""
    shift = QKeySequence("Shift+A").toString(NATIVE).removesuffix("A")
    return keys.replace(shift, "⇧")


def clashes(keymap: Keymap, elements: Sequence[Element] = ()) -> dict[str, str]:
    """Return what cannot be called since its keys mean something else, too: ``action:NAME`` or
    ``element:CLASS`` -> the title of what it clashes with, as it is shown.

    A sequence that begins with another's keys clashes with it: Qt would wait whether more comes.
    """
    taken = [(chords_of(key), "", tr(_HELD)) for key in HELD_KEYS]
    taken += [(chords_of(key), id_, title) for id_, title, keys in _calls(keymap, elements)
              for key in keys]  # fmt: skip
    found: dict[str, str] = {}
    for i, (chords, id_, title) in enumerate(taken):
        for other, other_id, other_title in taken[:i]:
            short = min(len(chords), len(other))
            if short and chords[:short] == other[:short] and id_ != other_id:
                found.setdefault(id_, other_title)
                if other_id:
                    found.setdefault(other_id, title)
    return found


def _calls(
    keymap: Keymap, elements: Sequence[Element]
) -> Iterator[tuple[str, str, tuple[str, ...]]]:
    for spec in ACTIONS:
        title = tr(spec.text.lstrip("-"))
        yield f"action:{spec.name}", title, keymap.of_action(spec)  # not shown
    for element in elements:
        keys = keymap.of_element(element)
        title = tr(element.title)
        yield f"element:{element.name}", title, (keys,) if keys else ()  # not shown


# --- as it is kept and passed on ------------------------------------------------------------------


def to_values(keymap: Keymap) -> dict[str, object]:
    """A keymap as plain values, for a file."""
    actions = {name: list(keys) for name, keys in sorted(keymap.actions.items())}
    return {"actions": actions, "elements": dict(sorted(keymap.elements.items()))}


def from_values(values: object) -> Keymap:
    """A keymap from plain values; actions that this version does not know are left out.
    `UsageError`, with the place in it, if that is no keymap."""
    if not isinstance(values, dict):
        raise UsageError(tr('expected an object with "actions" and "elements"'))
    actions, elements = values.get("actions", {}), values.get("elements", {})
    if not isinstance(actions, dict) or not isinstance(elements, dict):
        raise UsageError(tr('"actions" and "elements": expected objects'))
    known = {spec.name for spec in ACTIONS}
    own = {}
    for name, keys in actions.items():
        place = f"actions.{name}"  # not shown
        if not isinstance(keys, list):
            raise UsageError(
                tr("{place}: expected a list of keys, like {one}", place=place, one=_LIKE)
            )
        own[str(name)] = tuple(_key(key, place) for key in keys)
    chosen = {
        str(name): _key(key, f"elements.{name}") if key else ""  # not shown
        for name, key in elements.items()
    }
    return Keymap({name: keys for name, keys in own.items() if name in known}, chosen)


_LIKE = '["Ctrl+Shift+R"]'
_UNKNOWN = "Unknown"  # not shown


def _key(value: object, place: str) -> str:
    if not isinstance(value, str) or not chords_of(value) or _UNKNOWN in chords_of(value):
        raise UsageError(
            tr("{place}: {value!r} is no key; expected one like {one}",
               place=place, value=value, one=_LIKE)
        )  # fmt: skip
    return value


# Codes of the keys 1 to 9 and 0 from left to right: evdev's plus 8 (X11, Wayland), those of
# Windows, and macOS's virtual keys.
_X11 = tuple(range(10, 20))


_WINDOWS = tuple(range(2, 12))


_MAC = (0x12, 0x13, 0x14, 0x15, 0x17, 0x16, 0x1A, 0x1C, 0x19, 0x1D)


_DIGITS = "1234567890"


_PLAIN = Qt.KeyboardModifier.NoModifier


_SHIFT = Qt.KeyboardModifier.ShiftModifier


def keys_by_place(event: QKeyEvent) -> str:
    """``7`` or ``Shift+7`` for the key that is the seventh digit's; "" for other keys, and where
    what it writes is that digit anyway."""
    held = event.modifiers()
    if held not in (_PLAIN, _SHIFT):
        return ""
    if sys.platform == "darwin":
        codes, code = _MAC, event.nativeVirtualKey()
    else:
        codes = _WINDOWS if sys.platform == "win32" else _X11
        code = event.nativeScanCode()
    if code not in codes:
        return ""
    digit = _DIGITS[codes.index(code)]
    if held == _SHIFT:
        return f"Shift+{digit}"  # not shown
    return "" if event.text() == digit else digit


_Chords = tuple[str, ...]


def element_keys(field: Field, keymap: Keymap = USUAL) -> Mapping[str, QKeySequence]:
    """Class -> the keys that choose it, without elements that share keys with something else.

    A key that begins a sequence of another element's belongs to the one that comes first in the
    field: Qt would wait forever whether more is to come.
    """
    return _keys_of(field.elements, keymap)


@lru_cache(maxsize=8)
def _keys_of(elements: tuple[Element, ...], keymap: Keymap) -> Mapping[str, QKeySequence]:
    found: dict[str, QKeySequence] = {}
    given = [key for spec in ACTIONS for key in keymap.of_action(spec)]
    whole = {chords_of(key) for key in (*given, *HELD_KEYS)}
    begun = {beginning for chords in whole for beginning in _beginnings(chords)}
    for element in elements:
        keys = keymap.of_element(element)
        chords = chords_of(keys)
        if not chords or chords in begun or not whole.isdisjoint(_beginnings(chords)):
            continue
        whole.add(chords)
        begun.update(_beginnings(chords))
        found[element.name] = QKeySequence(keys)
    return found


def key_text(field: Field, class_name: str, keymap: Keymap = USUAL) -> str:
    """The keys of a class as people write them; "" where there are none."""
    keys = element_keys(field, keymap).get(class_name)
    return keys.toString(NATIVE) if keys is not None else ""


def _beginnings(chords: _Chords) -> list[_Chords]:
    return [chords[: i + 1] for i in range(len(chords))]
