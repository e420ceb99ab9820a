"""The rail of icons at the left edge, and the bar above."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest

from procc_annotator.gui.theme import palette
from procc_annotator.gui.window.tool_bar import IconButton
from procc_annotator.resources import resources_dir


def press(button: IconButton) -> None:
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def grey(image: QImage) -> np.ndarray:
    image = image.convertToFormat(QImage.Format.Format_Grayscale8)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return rows[:, : image.width()].astype(int)


def test_buttons_do_what_the_keys_do_and_say_which(window, hand, qtbot):
    buttons = window.side_bar.buttons
    assert buttons["snapping"].key_text() == "S"
    assert buttons["redo"].key_text() == "Ctrl+Y"
    assert buttons["draw_mode"].isChecked()
    press(buttons["edit_mode"])
    assert window.services.state.mode == "edit"
    hand.key(Qt.Key.Key_W)
    assert buttons["draw_mode"].isChecked()
    assert not buttons["edit_mode"].isChecked()
    hand.draw("Middle line", (100, 50), (120, 200))
    qtbot.waitUntil(lambda: "Undo: " in buttons["undo"].toolTip())  # once the line is painted
    press(buttons["undo"])
    assert window.services.state.annotation.get("Middle line") is None


def test_pan_moves_the_picture_until_esc(window, hand, qtbot):
    canvas, pan = window.canvas, window.side_bar.buttons["pan"]
    canvas.set_scale(4.0)
    window.services.selection.select_class("Middle line")
    press(pan)
    assert window.status.hint.text().startswith("PAN")
    before = hand.at(320, 180)
    start, end = hand.picture(320, 180), hand.picture(330, 190)
    hand.drag(start, end)
    assert hand.at(320, 180) != before
    assert not canvas.editor.drawing  # the press was no click
    hand.key(Qt.Key.Key_Escape)
    assert not pan.isChecked()
    assert window.status.hint.text().startswith("DRAW")
    press(pan)
    press(window.side_bar.buttons["draw_mode"])  # a tool that is taken up ends it, too
    assert not pan.isChecked()


@pytest.mark.parametrize("dark", [False, True])
def test_icons_stand_out_in_both_themes(window, qapp, dark):
    before = qapp.palette()
    qapp.setPalette(palette(dark))
    try:
        for button in window.side_bar.findChildren(IconButton):
            shade = grey(button.grab().toImage())
            assert np.ptp(shade) > 100, button.objectName()
    finally:
        qapp.setPalette(before)


def test_every_icon_is_drawn_in_one_style():
    heads = {path.read_text().split("\n")[0] for path in (resources_dir() / "icons").glob("*.svg")}
    assert len(heads) == 1


def test_the_camera_has_room_only_once_there_is_one(window, tmp_path):
    bar = window.top_bar
    assert not bar.camera_bar.isVisible()
    assert bar.chip.words() == f"dataset · {window.services.state.field.title}"
    assert bar.chip.menu() is window.actions_.menus["File/Field"]
    (tmp_path / "cameras").mkdir()
    np.save(tmp_path / "cameras" / "frame_0.npy", np.eye(3))
    window.services.camera_sources.load_cameras(tmp_path / "cameras")
    assert bar.camera_bar.jac.isVisible()
    assert not bar.camera_bar.isVisible()
    window.panels.turn_to("judge")
    assert bar.camera_bar.isVisible()


def test_search_opens_the_palette(window):
    QTest.mouseClick(window.top_bar.search, Qt.MouseButton.LeftButton)
    assert window.palette_.isVisible()
    QTest.keyClick(window.palette_.search, Qt.Key.Key_Escape)
