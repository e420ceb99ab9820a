"""The keyboard after something beside the picture was used."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractScrollArea,
    QApplication,
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QLineEdit,
    QToolTip,
    QWidget,
)

from procc_annotator.gui.app import build_window
from procc_annotator.gui.canvas.canvas_keys import typed_into
from tests.gui.conftest import Hand

LEFT = Qt.MouseButton.LeftButton


def press(*keys: Qt.Key | str) -> None:
    """Keys go to whoever has the keyboard."""
    for key in keys:
        focused = QApplication.focusWidget()
        assert focused is not None
        QTest.keyClick(focused, key)


@pytest.mark.new_window
def test_the_first_key_in_a_new_window_is_for_the_picture(dataset, qtbot):
    window = build_window(dataset)
    qtbot.addWidget(window)
    with qtbot.waitActive(window):
        window.show()
        window.activateWindow()
    press("d")
    assert window.services.state.frame_index == 1
    window.services.close()


@pytest.mark.parametrize(("end", "tau"), [(Qt.Key.Key_Return, 7.0), (Qt.Key.Key_Escape, 5.0)])
def test_a_threshold_that_was_typed_leaves_the_keys_to_the_picture(window, end, tau):
    box = window.findChild(QDoubleSpinBox, "tauSpin")
    box.setFocus()
    box.selectAll()
    press("7", end)
    assert window.services.state.tau == box.value() == tau
    assert window.canvas.hasFocus()
    press("d")
    assert window.services.state.frame_index == 1


def test_a_threshold_out_of_range_is_not_taken_and_that_is_said(window, monkeypatch):
    told: list[str] = []
    monkeypatch.setattr(QToolTip, "showText", lambda _, text, *__: told.append(text))
    box = window.findChild(QDoubleSpinBox, "tauSpin")
    for typed in ("31", "1000", "0"):
        told.clear()
        box.setFocus()
        box.selectAll()
        press(*typed, Qt.Key.Key_Return)
        assert window.services.state.tau == box.value() == 5.0
        assert told == [f"not {typed}: 0.5 to 30 px"]


def test_a_list_is_left_by_escape_and_walked_by_arrows(window, qtbot):
    window.panels.show("fit")
    models = window.findChild(QComboBox, "fit_model")
    qtbot.waitUntil(models.isVisible)
    models.setFocus()
    press(Qt.Key.Key_Down, Qt.Key.Key_Down)
    assert models.hasFocus()
    assert models.currentIndex() == 2
    press(Qt.Key.Key_Escape)
    assert window.canvas.hasFocus()


def test_a_name_under_way_is_put_back_by_escape(window, qtbot):
    window.panels.show("landmarks")
    line = window.findChild(QLineEdit, "landmarkName")
    qtbot.waitUntil(line.isVisible)
    line.setFocus()
    press("x", Qt.Key.Key_Escape)
    assert line.text() == ""
    assert window.canvas.hasFocus()


def test_a_click_beside_the_picture_leaves_it_the_keys(audited, qtbot):
    """Whatever is pressed in a panel and let go elsewhere: what is no text takes no key."""
    pressed = set()
    for name, dock in audited.docks.items():
        audited.panels.show(name)
        qtbot.waitUntil(lambda dock=dock: not dock.visibleRegion().isEmpty())
        for widget in dock.findChildren(QWidget):
            reached = widget.focusPolicy() & Qt.FocusPolicy.ClickFocus and widget.isEnabled()
            if not reached or widget.visibleRegion().isEmpty() or typed_into(widget):
                continue
            audited.canvas.setFocus()
            inner = widget.viewport() if isinstance(widget, QAbstractScrollArea) else widget
            QTest.mousePress(inner, LEFT, pos=QPoint(6, 6))
            QTest.mouseRelease(inner, LEFT, pos=QPoint(-999, -999))
            if isinstance(widget, QComboBox):
                widget.hidePopup()
            assert audited.canvas.hasFocus(), widget.objectName()
            pressed.add(type(widget).__name__)
    assert {"QTableView", "QPushButton", "QComboBox", "QCheckBox"} <= pressed
    audited.panels.show("review")
    audited.review.text.setFocus()
    audited.docks["review"].close()
    assert audited.canvas.hasFocus()


@pytest.mark.parametrize("name", ["frames_list", "elements_tree", "field_map_panel", "top_next"])
def test_keys_of_the_picture_work_in_a_list_and_escape_comes_back(begun, qtbot, name):
    """Wherever F6 and Tab brought the keyboard."""
    begun.panels.show("frames")  # the list in the place of the strip
    widget = begun.findChild(QWidget, name)
    qtbot.waitUntil(widget.isVisible)
    services = begun.services
    services.selection.select_class("Circle left")
    widget.setFocus(Qt.FocusReason.TabFocusReason)
    press(Qt.Key.Key_Delete)
    assert services.state.annotation.get("Circle left") is None
    Hand(begun).click(100, 100)
    Hand(begun).click(150, 100)
    widget.setFocus(Qt.FocusReason.TabFocusReason)
    press(Qt.Key.Key_Backspace)
    assert len(begun.canvas.editor._draw.points) == 1
    press(Qt.Key.Key_Escape)
    assert begun.canvas.hasFocus()
    assert not begun.canvas.editor.drawing
    widget.setFocus(Qt.FocusReason.TabFocusReason)
    press(Qt.Key.Key_Escape)
    assert begun.canvas.hasFocus()


class TestWhileDrawing:
    """Two points of a line are clicked, then a box in a panel."""

    @pytest.fixture
    def box(self, audited, qtbot) -> QWidget:
        audited.panels.show("cameras")
        audited.services.navigator.go_to(4)
        box = audited.findChild(QCheckBox, "cameras_action_split")
        qtbot.waitUntil(box.isVisible)
        audited.services.selection.select_class("Middle line")
        audited.services.selection.set_mode("draw")
        hand = Hand(audited)
        hand.click(100, 100)
        hand.click(200, 220)
        box.setFocus(Qt.FocusReason.MouseFocusReason)
        QTest.mouseClick(box, LEFT, pos=QPoint(8, box.height() // 2))
        assert box.hasFocus()
        return box

    @pytest.mark.parametrize(
        ("key", "points", "drawing"),
        [
            (Qt.Key.Key_Return, 2, False),
            (Qt.Key.Key_Backspace, 0, True),
            (Qt.Key.Key_Escape, 0, False),
        ],
    )
    def test_its_keys_still_mean_the_line(self, audited, box, key, points, drawing):
        press(key)
        line = audited.services.state.annotation.get("Middle line")
        assert len(line.points if line is not None else ()) == points
        assert audited.canvas.editor.drawing is drawing
        assert audited.canvas.hasFocus()


@pytest.mark.parametrize("named", [True, False])
def test_undo_right_after_escape_takes_the_clicks_back(begun, named):
    services, hand, editor = begun.services, Hand(begun), begun.canvas.editor
    before = services.state.annotation
    services.selection.select_class("Side line right" if named else None)
    for x in (700, 750, 800):
        hand.click(x, 300)
    press(Qt.Key.Key_Escape)
    assert not editor.drawing
    begun.actions_["undo"].trigger()
    assert len(editor._draw.points) == 3
    press(Qt.Key.Key_Escape)
    services.editing.edit("else", lambda seen: seen.without("Circle left"))
    begun.actions_["undo"].trigger()  # what was done since is meant
    assert not editor.drawing
    assert services.state.annotation == before
