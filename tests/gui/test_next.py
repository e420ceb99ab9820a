"""One element is next, the same on the field map, in the picture, in the list and in the bar."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.element_states import WORDS
from tests.gui.conftest import Hand

MakeWindow = Callable[..., MainWindow]
FRAMES = {".": ("00002", "00008"), "basketball": ("00001", "00004"), "volleyball": ("00001",)}


def part_of(sample: Path, folder: Path, names: tuple[str, ...], fewer: int) -> Path:
    """Some frames of a sample dataset, without the first of their elements."""
    folder.mkdir()
    if (sample / "field.toml").exists():
        shutil.copy(sample / "field.toml", folder)
    for name in names:
        shutil.copy(sample / f"{name}.jpg", folder)
        every = json.loads((sample / f"{name}.json").read_text())
        kept = dict(list(every.items())[fewer:])
        (folder / f"{name}.json").write_text(json.dumps(kept))
    return folder


def told(window: MainWindow) -> dict[str, str | None]:
    """The titles that the four places give."""
    document, field = window.document, window.document.state.field
    window.panels.show("elements")
    window.elements._refresh()
    window.field_map._refresh()
    listed = [
        field.title_of(name)
        for name in window.elements._items
        if WORDS[window.elements._shown[name][0]] == "next"
    ]
    assert len(listed) <= 1
    best = window.field_map._next
    shown = [t for labels in window.canvas.overlay_item.ghosts.labels for t in labels.texts]
    drawn = [text.removeprefix("next: ") for text in shown if text.startswith("next: ")]
    assert len(drawn) <= 1
    words = window.canvas.hint.split("  •  ")
    said = [word.removeprefix("next: ") for word in words if word.startswith("next: ")]
    if not said and document.state.selected_class is not None and words[0].startswith("DRAW"):
        said = [field.title_of(document.state.selected_class)]
    return {
        "map": None if best is None else field.title_of(best.name),
        "list": next(iter(listed), None),
        "picture": next(iter(drawn), None),
        "bar": next(iter(said), None),
    }


@pytest.mark.parametrize("sample", FRAMES)
@pytest.mark.parametrize("fewer", [1, 4])
def test_it_is_the_same_everywhere(
    make_window: MakeWindow,
    qtbot: QtBot,
    sample_data: Path,
    tmp_path: Path,
    sample: str,
    fewer: int,
) -> None:
    folder = part_of(sample_data / sample, tmp_path / "part", FRAMES[sample], fewer)
    window = make_window(folder)
    document, seen = window.document, 0
    for index in range(len(FRAMES[sample])):
        document.walk.go_to(index)
        qtbot.waitUntil(lambda: document.live_fit.insight is not None, timeout=20_000)
        document.selecting.select_class(None)
        places = told(window)
        assert len(set(places.values())) == 1, places
        seen += places["map"] is not None
        for name in document.state.annotation.annotated[
            :3
        ]:  # what was drawn last decides the order
            document.selecting.select_class(name)
            best = document.ghosts.suggestion
            places = told(window)
            if best is not None:
                assert set(places.values()) == {document.state.field.title_of(best.name)}, places
    assert seen or fewer == 1 or sample != "."  # the others may be known well enough


def test_what_was_chosen_after_the_last_one_stays_the_next_until_it_is_drawn(
    make_window: MakeWindow,
    qtbot: QtBot,
    sample_data: Path,
    tmp_path: Path,
    hand_on: Callable[[MainWindow], Hand],
) -> None:
    folder = part_of(sample_data, tmp_path / "part", ("00002",), 4)
    window = make_window(folder)
    document, hand = window.document, hand_on(window)
    qtbot.waitUntil(lambda: document.live_fit.insight is not None, timeout=20_000)
    best = document.ghosts.suggestion
    assert best is not None
    document.selecting.select_class(best.name)
    assert set(told(window).values()) == {document.state.field.title_of(best.name)}
    hand.click(600, 300)
    announced = window.canvas.editor.upcoming
    assert announced is not None
    hand.click(700, 350)
    hand.key(Qt.Key.Key_Return)
    assert document.state.selected_class == announced
    qtbot.waitUntil(lambda: document.live_fit.insight is not None, timeout=20_000)
    best = document.ghosts.suggestion
    if best is not None:  # of what the new fit has in sight
        assert best.name == announced
        assert set(told(window).values()) == {document.state.field.title_of(announced)}
