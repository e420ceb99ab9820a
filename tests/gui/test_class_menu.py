"""Every class can be reached, suggestions come first, names reach the caller exactly."""

import pytest
from PySide6.QtGui import QAction, QColor
from PySide6.QtWidgets import QMenu, QWidget

from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.gui.window.menus import class_menu

FIELD = load_field("soccer")


@pytest.fixture
def parent(qtbot) -> QWidget:
    widget = QWidget()
    qtbot.addWidget(widget)
    return widget


def _groups(menu: QMenu) -> dict[str, list[QAction]]:
    return {a.text(): sub.actions() for a in menu.actions() if (sub := a.menu()) is not None}


def _entries(menu: QMenu) -> list[QAction]:
    return [a for actions in _groups(menu).values() for a in actions]


def _colour(action: QAction) -> str:
    image = action.icon().pixmap(16, 16).toImage()
    return image.pixelColor(image.width() // 2, image.height() // 2).name()


def test_all_classes_by_group(parent):
    menu = class_menu(parent, FIELD, "Change class to", chosen=lambda name: None)
    assert menu.title() == "Change class to"
    groups = _groups(menu)
    assert list(groups)[-1] == "Without geometry"
    assert list(groups)[:-1] == list(dict.fromkeys(e.group for e in FIELD.elements))
    names = [a.data() for a in _entries(menu)]
    assert sorted(names) == sorted(
        [*(e.name for e in FIELD.elements), *FIELD.classes_without_geometry]
    )
    assert not [a for a in menu.actions() if a.isSeparator()]


def test_entries_have_title_key_and_colour_but_take_no_key(parent):
    menu = class_menu(parent, FIELD, "Merge into", chosen=lambda name: None)
    for action in _entries(menu):
        element = FIELD.element(action.data())
        if element is not None:
            title, _, key = action.text().partition("\t")
            assert title == element.title
            assert key == element.shortcut
            assert QColor(_colour(action)).name() == element.colour.lower()
        assert action.shortcut().isEmpty()


def test_suggestions_come_first_and_once(parent):
    first = ["Goal left post left ", "Side line top", "Goal left post left ", "Box & line"]
    menu = class_menu(parent, FIELD, "Split", first=first, chosen=lambda name: None)
    top = menu.actions()[:4]
    assert [a.data() for a in top[:3]] == ["Goal left post left ", "Side line top", "Box & line"]
    assert top[2].text() == "Box && line (unknown class)"
    assert top[3].isSeparator()
    assert len(_entries(menu)) == len(FIELD.elements) + len(FIELD.classes_without_geometry)


def test_choosing_tells_the_exact_class_name(parent):
    chosen: list[str] = []
    menu = class_menu(parent, FIELD, "Split", first=["Circle left"], chosen=chosen.append)
    menu.actions()[0].trigger()
    for action in _entries(menu):
        if action.data() == "Goal left post left ":
            action.trigger()
    assert chosen == ["Circle left", "Goal left post left "]


def test_disabled_classes_stay_but_cannot_be_chosen(parent):
    chosen: list[str] = []
    arcs = {e.name for e in FIELD.elements if e.group == "Left goal"} | {"Circle left"}
    menu = class_menu(
        parent, FIELD, "Split", first=["Circle left"], disabled=arcs, chosen=chosen.append
    )
    for action in [menu.actions()[0], *_entries(menu)]:
        assert action.isEnabled() == (action.data() not in arcs)
    menu.actions()[0].trigger()
    assert chosen == []
    enabled = {a.text(): a.isEnabled() for a in menu.actions() if a.menu() is not None}
    assert not enabled["Left goal"]
    assert enabled["Left penalty area"]


def test_a_field_without_more_classes(parent):
    field = Field("small", "Small", (), FIELD.elements[:2], {})
    menu = class_menu(parent, field, "Split", chosen=lambda name: None)
    assert list(_groups(menu)) == [FIELD.elements[0].group]
