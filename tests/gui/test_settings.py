"""The table of settings, and the file they are kept in."""

from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QByteArray, QSettings

from procc_annotator.gui import settings as rows
from procc_annotator.gui.keymap import Keymap
from procc_annotator.gui.settings import SWITCHES, Setting, Settings

# People keep their settings: these names are in their files.
KEPT = {
    "geometry",
    "state",
    "author",
    "desks",
    *("video_every", "video_scenes", "video_field"),
    "tau",
    "protocol",
    "off_plane",
    "colour_by",
    "fit_model",
    "judge_fit",
    "ghost_support",
    "theme",
    "font_percent",
    "folder",
    "second",
    "cameras",
    "field_folder",
    "recent",
    "own_fields",
    "called",
    "keys",
    "sources",
    "snapping",
    "pinned",
    "auto_advance",
    "turn_map",
    "top_view",
    "legend",
    "language",
    "two_clicks",
    "draw_first",
    "loupe",
    "painted_width",
    "strip",
    "evidence",
    "live_fit",
    "ghosts",
    "propose",
    "suggest",
    "keep_zoom",
    "blind",
}


def table() -> list[Setting[Any]]:
    return [*(row for row in vars(rows).values() if isinstance(row, Setting)), *SWITCHES.values()]


def store() -> QSettings:
    return QSettings(
        QSettings.Format.IniFormat,
        QSettings.Scope.UserScope,
        rows.ORGANISATION,
        rows.APPLICATION,
    )


def test_names_in_the_file_stay_what_they_were():
    keys = [row.key for row in table()]
    assert len(keys) == len(set(keys))
    assert set(keys) == KEPT
    assert all(row.text for row in table())


@pytest.mark.parametrize("row", table(), ids=lambda row: row.key)
def test_what_is_set_is_read_again_in_the_next_run(row):
    values = {bool: True, float: 0.75, str: "criterion", tuple: (Path("/a"),), dict: {"x": [1]}}
    value = values.get(type(row.default), QByteArray(b"abc"))
    if row is rows.KEYS:
        value = Keymap({"undo": ("F2",), "redo": ()}, {"Middle line": "F"})
    if row.kind is rows.TEXTS:
        value = ("action:undo",)
    if row.kind.read("criterion") is None and isinstance(row.default, str):
        value = row.default  # one of a few
    settings = Settings()
    assert settings.get(row) == row.default
    settings.set(row, value)
    settings.sync()
    assert Settings().get(row) == value


@pytest.mark.parametrize(
    ("row", "kept"),
    [
        (rows.TAU, "much"),
        (rows.PROTOCOL, "another"),
        (rows.FIT_MODEL, "Q"),
        (rows.GEOMETRY, "wide"),
        (rows.SOURCES, "{"),
        (rows.SOURCES, "[1, 2]"),
    ],
    ids=lambda value: value.key if isinstance(value, Setting) else value,
)
def test_a_value_of_another_kind_counts_as_absent(row, kept):
    written = store()
    written.setValue(row.key, kept)
    written.sync()
    assert Settings().get(row) == row.default


def test_paths_used_last_come_first_and_the_oldest_go():
    settings = Settings()
    for number in range(10):
        settings.put_first(rows.RECENT, Path(f"/{number}"))
    settings.put_first(rows.RECENT, Path("/5"))
    settings.take_out(rows.RECENT, Path("/8"))
    assert list(settings.get(rows.RECENT)) == [Path(f"/{n}") for n in (5, 9, 7, 6, 4, 3, 2)]


def test_datasets_used_longest_ago_are_forgotten():
    settings = Settings()
    for number in range(rows.SOURCES.most + 1):
        settings.set_entries(rows.SOURCES, str(number), [{"path": "x"}])
    assert settings.entries(rows.SOURCES, "0") == []
    assert settings.entries(rows.SOURCES, "1") == [{"path": "x"}]
    settings.set_entries(rows.SOURCES, "1", [])
    assert settings.entries(rows.SOURCES, "1") == []
