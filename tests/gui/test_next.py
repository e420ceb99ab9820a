"""One element is next, the same on the field map, in the picture and in the list."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt

from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.element_states import WORDS

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
    """The titles that the three places give."""
    field = window.services.state.field
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
    return {
        "map": None if best is None else field.title_of(best.name),
        "list": next(iter(listed), None),
        "picture": next(iter(drawn), None),
    }


@pytest.mark.parametrize("sample", FRAMES)
@pytest.mark.parametrize("fewer", [1, 4])
def test_it_is_the_same_everywhere(make_window, qtbot, sample_data, tmp_path, sample, fewer):
    folder = part_of(sample_data / sample, tmp_path / "part", FRAMES[sample], fewer)
    window = make_window(folder)
    services, seen = window.services, 0
    for index in range(len(FRAMES[sample])):
        services.navigator.go_to(index)
        qtbot.waitUntil(lambda: services.live_fit.insight is not None)
        services.selection.select_class(None)
        places = told(window)
        assert len(set(places.values())) == 1, places
        seen += places["map"] is not None
        for name in services.state.annotation.annotated[
            :3
        ]:  # what was drawn last decides the order
            services.selection.select_class(name)
            best = services.ghosts.suggestion
            places = told(window)
            if best is not None:
                assert set(places.values()) == {services.state.field.title_of(best.name)}, places
    assert seen or fewer == 1 or sample != "."  # the others may be known well enough


def test_what_was_chosen_after_the_last_one_stays_the_next_until_it_is_drawn(
    make_window, qtbot, sample_data, tmp_path, hand_on
):
    folder = part_of(sample_data, tmp_path / "part", ("00002",), 4)
    window = make_window(folder)
    services, hand = window.services, hand_on(window)
    qtbot.waitUntil(lambda: services.live_fit.insight is not None)
    best = services.ghosts.suggestion
    services.selection.select_class(best.name)
    assert set(told(window).values()) == {services.state.field.title_of(best.name)}
    hand.click(600, 300)
    announced = window.canvas.editor.upcoming
    assert announced is not None
    hand.click(700, 350)
    hand.key(Qt.Key.Key_Return)
    assert services.state.selected_class == announced
    qtbot.waitUntil(lambda: services.live_fit.insight is not None)
    best = services.ghosts.suggestion
    if best is not None:  # of what the new fit has in sight
        assert best.name == announced
        assert set(told(window).values()) == {services.state.field.title_of(announced)}
