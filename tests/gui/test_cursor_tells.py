"""At the cursor stands what the next click belongs to, how much is missing, whether it snaps."""

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.theme import set_text_size
from procc_annotator.interaction.overlay_primitives import Labels
from tests.gui.conftest import SIZE, Hand

MIDDLE = "Middle line"


@pytest.fixture
def lined(tmp_path, make_window) -> MainWindow:
    """A picture with one white line down its middle."""
    pixels = np.full((SIZE[1], SIZE[0], 3), (40, 110, 40), dtype=np.uint8)
    cv2.line(pixels, (320, 0), (320, SIZE[1]), (250, 250, 250), 5)
    folder = tmp_path / "lined"
    folder.mkdir()
    cv2.imwrite(str(folder / "a.png"), pixels)
    return make_window(folder)


def told(window: MainWindow) -> Labels:
    """What stands at the cursor."""
    (found,) = [x for x in window.canvas.overlay_item.gesture.labels if x.hand is not None]
    return found


def test_class_points_and_snapping_stand_at_the_cursor(lined):
    hand, services = Hand(lined), lined.services
    services.selection.select_class(MIDDLE)
    hand.move(322, 100)
    assert told(lined).texts == ("Halfway line  2 to go",)
    signs = told(lined).hand
    assert (signs.colour, signs.snap) == (services.state.field.element(MIDDLE).colour, "found")
    hand.move(100, 100)
    assert told(lined).hand.snap == "none"
    lined.actions_["snapping"].trigger()
    hand.move(322, 100)
    assert told(lined).hand.snap == "off"
    hand.click(322, 100)
    hand.move(322, 200)
    assert told(lined).texts == ("Halfway line  1 to go",)
    hand.click(322, 200)
    hand.move(322, 300)
    assert told(lined).texts == ("Halfway line  2 points",)
    services.selection.select_class("Circle central")  # another one: a curve takes more
    hand.move(200, 200)
    assert told(lined).texts == ("Centre circle  5 to go",)
    hand.key(Qt.Key.Key_Escape)
    services.selection.set_mode("edit")
    hand.move(210, 200)
    assert not [x for x in lined.canvas.overlay_item.gesture.labels if x.hand is not None]


def test_texts_over_the_picture_grow_with_the_setting(lined):
    canvas, hand = lined.canvas, Hand(lined)

    def painted() -> tuple[int, int]:
        """(width, height) of what the text at the cursor covers, px."""
        canvas.drawing.set_hidden(True)
        bare = image(lined)
        canvas.drawing.set_hidden(False)
        hand.move(120, 200)
        shown = image(lined)
        at = hand.at(120, 200)
        around = slice(at.y() - 70, at.y() + 10), slice(at.x() - 10, at.x() + 400)
        rows, columns = np.nonzero(np.abs(shown - bare)[around].max(axis=2) > 40)
        return int(np.ptp(columns)), int(np.ptp(rows))

    lined.services.selection.select_class(MIDDLE)
    usual = painted()
    application = QApplication.instance()
    try:
        set_text_size(application, 150)
        QApplication.processEvents()
        large = painted()
    finally:
        set_text_size(application, 100)
    assert large[0] > 1.3 * usual[0]
    assert large[1] > 1.3 * usual[1]


def image(window: MainWindow) -> np.ndarray:
    """(H, W, 3) what the canvas shows."""
    from tests.gui.test_uncertainty import pixels

    return pixels(window)
