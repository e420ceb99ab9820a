"""Keys of one's own: what they call, clashes by name, other programs' keys, files."""

import json

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog, QTreeWidget

from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field
from procc_annotator.gui.actions import ACTIONS, ActionSpec
from procc_annotator.gui.keymap import PRESETS, USUAL, Keymap, clashes, from_values, to_values
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import KEYS, Settings
from procc_annotator.gui.window.key_dialogs import KeymapDialog
from tests.gui.conftest import sheet_text


@pytest.fixture
def dialog(window) -> KeymapDialog:
    made = KeymapDialog(window.services.state.field, window.services.state.keymap, window)
    made.show()
    return made


def choose(dialog: KeymapDialog, words: str) -> None:
    """Search for a row, and choose the first that is found."""
    dialog.search.setText(words)
    dialog.table.selectRow(0)


def press(dialog: KeymapDialog, keys: str) -> None:
    dialog.pressed.setKeySequence(QKeySequence(keys))


def shown(dialog: KeymapDialog, column: int = 1) -> str:
    return str(dialog.table.model().index(0, column).data())


def use(window: MainWindow, monkeypatch: pytest.MonkeyPatch, keymap: Keymap) -> None:
    """Choose a keymap in the dialog of the window."""

    def accept(dialog: KeymapDialog) -> KeymapDialog.DialogCode:
        dialog.keymap = keymap
        return KeymapDialog.DialogCode.Accepted

    monkeypatch.setattr(KeymapDialog, "exec", accept)
    window.actions_["keymap"].trigger()


@pytest.mark.parametrize("name", PRESETS)
def test_the_keys_of_other_programs_clash_with_nothing(name):
    assert not clashes(PRESETS[name])
    known = {spec.name for spec in ACTIONS}
    assert set(PRESETS[name].actions) <= known
    assert from_values(to_values(PRESETS[name])).actions == PRESETS[name].actions


def test_the_shipped_keys_of_soccer_clash_with_nothing():
    assert not clashes(USUAL, load_field("soccer").elements)


def test_another_key_is_given_and_its_clash_is_named(dialog):
    choose(dialog, "regularise all")
    assert shown(dialog) == "Shift+R"
    press(dialog, "A")
    dialog.only.click()
    assert shown(dialog) == "A"
    assert "Previous frame" in shown(dialog, 2)
    assert not dialog.ok.isEnabled()
    assert "⚠" in dialog.problem.text()
    press(dialog, "Ctrl+Alt+R")
    dialog.only.click()
    assert shown(dialog, 2) == ""
    assert dialog.ok.isEnabled()
    assert dialog.presets.currentText() == "Keys of your own"
    dialog.usual.click()
    assert to_values(dialog.keymap) == to_values(USUAL)
    assert dialog.presets.currentText() == "Usual"


def test_keys_are_added_and_taken_away(dialog):
    choose(dialog, "undo take back")  # its tip is no part of what is searched
    assert dialog.table.model().rowCount() == 0
    choose(dialog, "edit undo")
    press(dialog, "F2")
    dialog.add.click()
    assert shown(dialog) == "Ctrl+Z or F2"
    dialog.none.click()
    assert shown(dialog) == ""
    assert dialog.keymap.actions["undo"] == ()


def test_other_keys_work_at_once_and_are_remembered(window, hand, qtbot, monkeypatch):
    own = Keymap({"next_frame": ("F2",)}, {"Middle line": "F"})
    use(window, monkeypatch, own.with_action(_spec("fit"), ("Ctrl+0",)))
    hand.key(Qt.Key.Key_D)
    assert window.services.state.frame_index == 0
    hand.key(Qt.Key.Key_F2)
    assert window.services.state.frame_index == 1
    hand.key(Qt.Key.Key_F)
    assert window.services.state.selected_class == "Middle line"
    assert "(F2)" in window.actions_["next_frame"].toolTip()
    qtbot.waitUntil(lambda: "F" in _keys_of(window, "Halfway line"))
    assert to_values(Settings().get(KEYS))["elements"] == {"Middle line": "F"}
    window.commands.show_keys()
    sheet = window.findChild(object, "keySheet")
    assert "F2\tNext frame" in sheet_text(sheet)
    sheet.close()


@pytest.mark.new_window
def test_the_next_run_begins_with_them(make_window, dataset):
    Settings().set(KEYS, PRESETS["Like CVAT"])
    window = make_window(dataset)
    QTest.keyClick(window.canvas, Qt.Key.Key_F)
    assert window.services.state.frame_index == 1
    QTest.keyClick(window.canvas, Qt.Key.Key_D)
    assert window.services.state.frame_index == 0


def test_keys_go_to_a_file_and_come_back(dialog, tmp_path, monkeypatch):
    path = tmp_path / "keys.json"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    dialog.presets.setCurrentText("Left-handed")
    dialog.presets.activated.emit(dialog.presets.currentIndex())
    dialog.export_button.click()
    dialog.presets.setCurrentText("Usual")
    dialog.presets.activated.emit(dialog.presets.currentIndex())
    assert to_values(dialog.keymap) == to_values(USUAL)
    dialog.import_button.click()
    assert dialog.presets.currentText() == "Left-handed"
    path.write_text('{"actions": {"undo": ["Hyper+Z"]}}')
    dialog.import_button.click()
    assert "actions.undo" in dialog.problem.text()
    assert dialog.presets.currentText() == "Left-handed"  # nothing is lost


@pytest.mark.parametrize(
    "text",
    ["[]", '{"actions": []}', '{"actions": {"undo": "Z"}}', '{"elements": {"Circle left": 3}}'],
)
def test_what_is_no_keymap_is_refused(text):
    with pytest.raises(UsageError):
        from_values(json.loads(text))


def _keys_of(window: MainWindow, title: str) -> list[str]:
    """The column of keys in the elements panel."""
    tree = window.findChild(QTreeWidget, "elements_tree")
    found = tree.findItems(title, Qt.MatchFlag.MatchExactly | Qt.MatchFlag.MatchRecursive)
    return [item.text(1) for item in found]


def _spec(name: str) -> ActionSpec:
    return next(spec for spec in ACTIONS if spec.name == name)
