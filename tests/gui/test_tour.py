"""The tour: its steps go on by what is done, Skip and Escape."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

from procc_annotator.dataset import editing
from tests.gui.conftest import draw

CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


@pytest.mark.new_window
def test_each_step_waits_until_it_was_done(make_window, dataset, sample_copy, qtbot, monkeypatch):
    monkeypatch.setattr("procc_annotator.gui.window.tour.sample_folder", lambda: sample_copy)
    window = make_window(dataset)
    tour, services = window.tour, window.services
    window.actions_["tour"].trigger()
    assert services.state.workspace.folder not in (dataset, sample_copy)
    assert not services.state.annotation.annotated

    def reaches(step: int) -> None:
        qtbot.waitUntil(lambda: tour.label.text().startswith(f"{step} of 8:"))

    reaches(1)
    for name in ("Middle line", "Side line top", "Circle central", "Side line left"):
        draw(services, name)
    reaches(2)
    moved = editing.move_points(services.state.annotation, [("Middle line", 0)], 0.1, 0.0)
    services.editing.commit_edit("move", moved)
    reaches(3)
    window.panels.show("findings")
    reaches(4)
    QTest.keyClick(window.canvas, Qt.Key.Key_Return, CTRL)
    reaches(5)
    QTest.keyClick(window.canvas, Qt.Key.Key_D, CTRL | SHIFT)
    assert not services.state.annotation.annotated
    draw(services, "Middle line")
    reaches(6)
    (skip, _) = tour.findChildren(QPushButton)
    for step in (7, 8):
        QTest.mouseClick(skip, Qt.MouseButton.LeftButton)
        reaches(step)
    services.selection.select_class(None)
    QTest.keyClick(window.canvas, Qt.Key.Key_Escape)
    assert not tour.isVisible()
