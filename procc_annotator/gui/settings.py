"""Every setting the window remembers between runs, in one table, and the file they are kept in."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, Literal, TypeVar

from PySide6.QtCore import QByteArray, QSettings

from procc_annotator.errors import UsageError
from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.keymap import USUAL, Keymap, from_values, to_values
from procc_annotator.gui.state.live_fit import DEFAULT_MODEL, MODELS
from procc_annotator.gui.state.state import DEFAULT_TAU
from procc_annotator.session.strokes.ghost_points import LEAST_SUPPORT

T = TypeVar("T")

ORGANISATION = "ProCC"
APPLICATION = "Annotator"


@dataclass(frozen=True, slots=True)
class Kind(Generic[T]):
    """How values are kept in the file.

    Attributes:
        read: a value from what is kept; None if it is none of this kind.
        write: what is kept of a value.
    """

    read: Callable[[Any], T | None]
    write: Callable[[T], Any] = lambda value: value


@dataclass(frozen=True, slots=True)
class Setting(Generic[T]):
    """One row of the table.

    Attributes:
        key: its name in the file.
        kind: how its values are kept there.
        default: what holds where nothing is kept, or nothing of its kind.
        text: what it is.
        scope: the window's, or of each dataset its own.
        most: values, or datasets, that are kept; those used longest ago go.
    """

    key: str
    kind: Kind[T]
    default: T
    text: str
    scope: Literal["window", "dataset"] = "window"
    most: int = 1


def _number(kept: Any) -> float | None:
    try:
        return float(str(kept))
    except ValueError:
        return None


def _paths(kept: Any) -> Sequence[Path] | None:
    kept = [kept] if isinstance(kept, str) else kept  # Qt reads a list of one as a text
    return tuple(Path(str(one)) for one in kept) if isinstance(kept, list) else None


def _entries(kept: Any) -> dict[str, object] | None:
    try:
        entries = json.loads(str(kept))
    except ValueError:
        return None
    return entries if isinstance(entries, dict) else None


def _keymap(kept: Any) -> Keymap | None:
    try:
        return from_values(json.loads(str(kept)))
    except (ValueError, UsageError):
        return None


def _one_of(*names: str) -> Kind[str]:
    return Kind(lambda kept: str(kept) if str(kept) in names else None)


def _texts(kept: Any) -> Sequence[str] | None:
    kept = [kept] if isinstance(kept, str) else kept
    return tuple(str(one) for one in kept) if isinstance(kept, list) else None


FLAG = Kind(lambda kept: str(kept).lower() in ("true", "1"))
NUMBER = Kind(_number)
TEXT = Kind(str)
TEXTS = Kind(_texts, list)
PATHS = Kind(_paths, lambda paths: [str(path) for path in paths])
ENTRIES = Kind(_entries, json.dumps)
BYTES = Kind(lambda kept: kept if isinstance(kept, QByteArray) else None)

_HOME = str(Path.home())

# fmt: off
GEOMETRY = Setting("geometry", BYTES, QByteArray(), "Where the window is and how large")
LAYOUT = Setting("state", BYTES, QByteArray(), "How the panels are arranged")
DESKS = Setting("desks", ENTRIES, {}, "How the panels of each kind of work are arranged")
AUTHOR = Setting("author", TEXT, "", "Whose name points, comments and versions bear")
TAU = Setting("tau", NUMBER, DEFAULT_TAU, "The threshold, px")
PROTOCOL = Setting("protocol", _one_of("soccernet", "procc"), "soccernet",
                   "The protocol of the evaluation")
OFF_PLANE = Setting("off_plane", _one_of("missed", "left_out"), "missed",
                    "How elements count that a homography cannot project")
COLOUR_BY = Setting("colour_by", _one_of("criterion", "class", "origin", "annotator"), "criterion",
                    "What colours say")
FIT_MODEL = Setting("fit_model", _one_of(*MODELS), DEFAULT_MODEL, "The model of the live fit")
JUDGE_FIT = Setting("judge_fit", FLAG, False, "Whether the fit is judged where nothing else is")
GHOST_SUPPORT = Setting("ghost_support", NUMBER, LEAST_SUPPORT,
                        "The share of a ghost's line that must be seen to accept it with all")
FOLDER = Setting("folder", TEXT, _HOME, "Where pictures were opened last")
SECOND = Setting("second", TEXT, _HOME, "The second annotator's folder that was opened last")
CAMERAS = Setting("cameras", TEXT, _HOME, "Where cameras were loaded last")
FIELD_FOLDER = Setting("field_folder", TEXT, _HOME, "Where a field file was chosen last")
RECENT = Setting("recent", PATHS, (), "What was opened last, newest first", most=8)
KEYS = Setting("keys", Kind(_keymap, lambda keymap: json.dumps(to_values(keymap))), USUAL,
               "The keys that are not the usual ones")
CALLED = Setting("called", TEXTS, (), "What the command palette called last, newest first", most=8)
OWN_FIELDS = Setting("own_fields", PATHS, (), "The user's own field files, newest first", most=6)
SOURCES = Setting("sources", ENTRIES, {}, "The camera sources of a dataset",
                  scope="dataset", most=40)
# fmt: on

# Every action that is marked so in the table of actions: on or off, as it was left.
SWITCHES = {
    spec.name: Setting(spec.name, FLAG, spec.checked, spec.tip)
    for spec in ACTIONS
    if spec.remembered
}


class Settings:
    """What is kept of the settings; a value of the wrong kind counts as absent."""

    def __init__(self) -> None:
        self._store = QSettings(
            QSettings.Format.IniFormat, QSettings.Scope.UserScope, ORGANISATION, APPLICATION
        )

    def get(self, setting: Setting[T]) -> T:
        """What is kept, or the default."""
        kept = self._store.value(setting.key)
        value = setting.kind.read(kept) if kept is not None else None
        return setting.default if value is None else value

    def set(self, setting: Setting[T], value: T) -> None:
        """Remember a value."""
        self._store.setValue(setting.key, setting.kind.write(value))

    def put_first(self, setting: Setting[Sequence[Path]], path: Path) -> None:
        """Put a path in front of those used last."""
        others = (p for p in self.get(setting) if p != path)
        self.set(setting, (path, *others)[: setting.most])

    def take_out(self, setting: Setting[Sequence[Path]], path: Path) -> None:
        """Take a path out of those used last: it is gone."""
        self.set(setting, tuple(p for p in self.get(setting) if p != path))

    def entries(self, setting: Setting[dict[str, object]], dataset: str) -> list[object]:
        """What is kept of a dataset."""
        entries = self.get(setting).get(dataset)
        return entries if isinstance(entries, list) else []

    def set_entries(
        self, setting: Setting[dict[str, object]], dataset: str, entries: list[dict[str, object]]
    ) -> None:
        """Keep something of a dataset; those used longest ago are forgotten."""
        known: dict[str, object] = {k: v for k, v in self.get(setting).items() if k != dataset}
        if entries:
            known[dataset] = entries
        self.set(setting, dict(list(known.items())[-setting.most :]))

    def sync(self) -> None:
        """Write to disk now."""
        self._store.sync()
