"""Sliders make looks, looks move sliders, and only a hand is announced."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPalette
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel

from procc_annotator.gui.theme import palette
from procc_annotator.gui.window.display_adjustment import AdjustmentControls
from procc_annotator.image.pixels import DisplayAdjustment


@pytest.fixture
def controls(qtbot) -> AdjustmentControls:
    controls = AdjustmentControls()
    qtbot.addWidget(controls)
    controls.resize(230, controls.sizeHint().height())
    controls.show()
    return controls


@pytest.fixture
def announced(controls) -> list[DisplayAdjustment]:
    looks: list[DisplayAdjustment] = []
    controls.lookChanged.connect(looks.append)
    return looks


def _number(controls: AdjustmentControls, name: str) -> str:
    label = controls.findChild(QLabel, f"look_{name}_number")
    return label.text()


def test_sliders_and_box_make_a_look(controls, announced):
    controls.sliders["brightness"].setValue(25)
    controls.sliders["contrast"].setValue(-40)
    controls.sliders["gamma"].setValue(100)
    QTest.mouseClick(
        controls.enhance, Qt.MouseButton.LeftButton, pos=controls.enhance.rect().center() / 8
    )
    assert announced[-1] == DisplayAdjustment(
        brightness=0.25, contrast=-0.4, gamma=5.0, enhance=True
    )
    assert len(announced) == 4
    assert controls.look == announced[-1]
    assert [_number(controls, n) for n in controls.sliders] == ["+25", "−40", "5.00"]


def test_every_end_of_the_sliders_is_a_look(controls, announced):
    for slider in controls.sliders.values():
        for value in (slider.minimum(), slider.maximum()):
            slider.setValue(value)
    assert len(announced) == 6
    assert announced[4].gamma == pytest.approx(0.2)


def test_keys_move_a_slider(controls, announced):
    QTest.keyClick(controls.sliders["brightness"], Qt.Key.Key_Right)
    QTest.keyClick(controls.sliders["brightness"], Qt.Key.Key_PageUp)
    assert [look.brightness for look in announced] == pytest.approx([0.01, 0.11])


def test_a_look_chosen_elsewhere_is_shown_and_not_announced(controls, announced):
    look = DisplayAdjustment(brightness=-0.333, contrast=0.5, gamma=2.2, enhance=True)
    controls.set_look(look)
    assert announced == []
    assert controls.look == look
    assert [_number(controls, n) for n in controls.sliders] == ["−33", "+50", "2.20"]
    assert controls.enhance.isChecked()
    # What is not moved keeps its exact value, though the slider has whole steps.
    controls.sliders["contrast"].setValue(0)
    assert announced == [DisplayAdjustment(brightness=-0.333, gamma=2.2, enhance=True)]


def test_reset(controls, announced):
    assert not controls.reset_button.isEnabled()
    controls.set_look(DisplayAdjustment(gamma=3.0, enhance=True))
    QTest.mouseClick(controls.reset_button, Qt.MouseButton.LeftButton)
    assert announced == [DisplayAdjustment()]
    assert not controls.reset_button.isEnabled()
    assert not controls.enhance.isChecked()
    assert [s.value() for s in controls.sliders.values()] == [0, 0, 0]


def test_it_fits_into_a_narrow_dock(controls):
    controls.set_look(DisplayAdjustment(brightness=-1.0, contrast=-1.0, gamma=5.0))
    assert controls.minimumSizeHint().width() <= 230
    hint = controls.findChild(QLabel, "lookHint")
    assert "never the file" in hint.text()


@pytest.mark.parametrize("dark", [False, True])
def test_it_follows_the_theme(controls, dark):
    controls.setPalette(palette(dark))
    QApplication.processEvents()
    corner = QColor(controls.grab().toImage().pixel(2, 2))
    assert corner == palette(dark).color(QPalette.ColorRole.Window)
