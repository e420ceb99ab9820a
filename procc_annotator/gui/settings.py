"""Every setting the window remembers between runs, in one table, and the file they are kept in."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, Literal, TypeVar

from PySide6.QtCore import (
    QByteArray,
    QCoreApplication,
    QLibraryInfo,
    QLocale,
    QSettings,
    QTranslator,
)

from procc_annotator import translation
from procc_annotator.assist.ghost_points import LEAST_SUPPORT
from procc_annotator.errors import UsageError
from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.keymap import USUAL, Keymap, from_values, to_values
from procc_annotator.gui.state.prediction.live_fit import DEFAULT_MODEL, MODELS
from procc_annotator.gui.state.state import DEFAULT_TAU, MAX_TAU, MIN_TAU
from procc_annotator.resources import resources_dir
from procc_annotator.translation import word

CONTEXT = "procc"  # of all texts in the files of translations
SYSTEM, ENGLISH = "system", "en"

# Each by its own name: anyone who looks for theirs cannot read the others.
LANGUAGES = {
    ENGLISH: "English",  # not shown
    "de": "Deutsch",  # not shown
    "es": "Español",
    "fr": "Français",
    "ja": "日本語",
    "zh_CN": "简体中文",
}

_taken_up: list[QTranslator] = []


def folder() -> Path:
    """Return where the translations are."""
    return resources_dir() / "languages"


def of_system() -> str:
    """The first language the system asks for that there is, or English."""
    for asked in QLocale.system().uiLanguages():
        name = asked.replace("-", "_")
        for known in LANGUAGES:
            if name == known or name.split("_")[0] == known.split("_")[0]:
                return known
    return ENGLISH


def take_up(app: QCoreApplication, chosen: str) -> None:
    """Have all that is made from now on speak a language (a key of ``LANGUAGES``, or ``SYSTEM``);
    what was made keeps its words."""
    while _taken_up:
        app.removeTranslator(_taken_up.pop())
    translation.set_translator(None)
    name = of_system() if chosen == SYSTEM else chosen
    if name == ENGLISH:
        return
    of_qt = Path(QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath))
    for file in (of_qt / f"qtbase_{name}.qm", folder() / f"{name}.qm"):
        translator = QTranslator(app)
        if translator.load(str(file)):
            app.installTranslator(translator)
            _taken_up.append(translator)
    translation.set_translator(_look_up)


def _look_up(text: str, about: str, count: int) -> str:
    return QCoreApplication.translate(CONTEXT, text, about or None, count)


T = TypeVar("T")

ORGANISATION = "ProCC"
APPLICATION = "Annotator"  # not shown


@dataclass(frozen=True, slots=True)
class Kind(Generic[T]):
    """Conversion of values from and to the file.

    Attributes:
        read: a value from what is kept; None if it is of another kind.
        write: what is kept of a value.
    """

    read: Callable[[Any], T | None]
    write: Callable[[T], Any] = lambda value: value


@dataclass(frozen=True, slots=True)
class Shown:
    """Presentation of a setting in the dialog.

    Attributes:
        group: what it is listed with.
        title: its name there.
        choices: (value, words) of a setting that is one of a few.
        limits: least, largest and step of a number, as it is shown.
        unit: what stands behind a number.
        times: how often the number is shown of what is kept, 100 for a share in percent.
    """

    group: str
    title: str
    choices: tuple[tuple[str, str], ...] = ()
    limits: tuple[float, float, float] = (0.0, 100.0, 1.0)
    unit: str = ""
    times: float = 1.0


@dataclass(frozen=True, slots=True)
class Setting(Generic[T]):
    """One row of the table.

    Attributes:
        kind: how its values are kept there.
        default: what holds where nothing is kept, or nothing of its kind.
        scope: the window's, or of each dataset its own.
        most: values, or datasets, that are kept; those used longest ago go.
        shown: how the dialog of settings offers it; None for what is remembered only.
    """

    key: str
    kind: Kind[T]
    default: T
    text: str
    scope: Literal["window", "dataset"] = "window"
    most: int = 1
    shown: Shown | None = None


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
THEMES = ("system", "light", "dark")
_FIT = word("Fit and ghosts")

# fmt: off
GEOMETRY = Setting("geometry", BYTES, QByteArray(), "Where the window is and how large")
LAYOUT = Setting("state", BYTES, QByteArray(), "How the panels are arranged")
DESKS = Setting("desks", ENTRIES, {}, "How the panels of each kind of work are arranged")
THEME = Setting("theme", _one_of(*THEMES), "system", "Light, dark or system",
                shown=Shown("Appearance", "Theme", (("system", "System"),
                                                    ("light", "Light"), ("dark", "Dark"))))
FONT_PERCENT = Setting("font_percent", NUMBER, 100.0,
                       "Text size, % of system (after restart)",
                       shown=Shown("Appearance", "Text size", limits=(75, 200, 25), unit=" %"))
LANGUAGE = Setting("language", _one_of(SYSTEM, *LANGUAGES), SYSTEM,
                   "Language of the window (after restart); files stay as they are",
                   shown=Shown("Appearance", "Language",
                               ((SYSTEM, "System"), *LANGUAGES.items())))
AUTHOR = Setting("author", TEXT, "", "Author name (empty = login name)",
                 shown=Shown("Annotating", "Author name"))
TAU = Setting("tau", NUMBER, DEFAULT_TAU, "How far an annotated point may be from its element,"
              " px of the evaluation size",
              shown=Shown("Judging", "Threshold", limits=(MIN_TAU, MAX_TAU, 0.5), unit=" px"))
PROTOCOL = Setting("protocol", _one_of("soccernet", "procc"), "soccernet",
                   "How cameras are judged: as the official evaluation does, quirks included, or by"
                   " the paper's definition",
                   shown=Shown("Judging", "Protocol", (("soccernet", "soccernet (official)"),
                                                       ("procc", "procc (the paper's)"))))
OFF_PLANE = Setting("off_plane", _one_of("missed", "left_out"), "missed",
                    "How elements count that a homography cannot project: goals, baskets, nets",
                    shown=Shown("Judging", "Elements off the ground",
                                (("missed", "Count as missed"), ("left_out", "Leave out"))))
COLOUR_BY = Setting("colour_by", _one_of("criterion", "class", "origin", "annotator"), "criterion",
                    "What the colours over the picture say",
                    shown=Shown("Appearance", "Colour by",
                                (("criterion", "Criterion"), ("class", "Class"),
                                 ("origin", "Provenance"), ("annotator", "Annotator"))))
FIT_MODEL = Setting("fit_model", _one_of(*MODELS), DEFAULT_MODEL,
                    "The camera that is fitted to the clicks; auto: the simplest that they support",
                    shown=Shown(_FIT, "Model of the live fit",
                                tuple(MODELS.items())))
JUDGE_FIT = Setting("judge_fit", FLAG, False, "Whether the fit is judged where nothing else is",
                    shown=Shown(_FIT, "Judge the fit"))
GHOST_SUPPORT = Setting("ghost_support", NUMBER, LEAST_SUPPORT,
                        "How much of a ghost's line must be seen to accept it with all others",
                        shown=Shown(_FIT, "Line seen to accept all", limits=(0, 100, 5),
                                    unit=" %", times=100))
FOLDER = Setting("folder", TEXT, _HOME, "Where pictures were opened last")
VIDEO_EVERY = Setting("video_every", NUMBER, 1.0, "Seconds between frames of the last video")
VIDEO_SCENES = Setting("video_scenes", FLAG, False, "Whether its scenes' first frames were opened")
VIDEO_FIELD = Setting("video_field", TEXT, "", "The field that was chosen for it")
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

# Menu of an action that is remembered -> what it is listed with.
_GROUPS = {
    "Element": word("Annotating"),  # not shown
    "Element/Ghosts": _FIT,
    "Camera": _FIT,  # not shown
    "View": word("Picture"),  # not shown
}

# Every action that is marked so in the table of actions: on or off, as it was left.
SWITCHES: dict[str, Setting[bool]] = {
    spec.name: Setting(
        spec.name,
        FLAG,
        spec.checked,
        spec.tip,
        shown=Shown(_GROUPS.get(spec.menu, "Judging"), spec.text.lstrip("-")),
    )
    for spec in ACTIONS
    if spec.remembered
}

# All that the dialog offers, group by group.
# fmt: off
OFFERED: tuple[Setting[Any], ...] = (
    THEME, FONT_PERCENT, LANGUAGE, COLOUR_BY, AUTHOR, TAU, PROTOCOL, OFF_PLANE, FIT_MODEL,
    JUDGE_FIT, GHOST_SUPPORT, *SWITCHES.values(),
)
# fmt: on


class Settings:
    """The stored settings; a value of the wrong kind counts as absent."""

    def __init__(self) -> None:
        self._store = QSettings(
            QSettings.Format.IniFormat, QSettings.Scope.UserScope, ORGANISATION, APPLICATION
        )

    def get(self, setting: Setting[T]) -> T:
        """Return what is kept, or the default."""
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
        """Return what is kept of a dataset."""
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
