"""The tour: its steps go on by what is done, Skip and Escape."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

from tests.gui.conftest import draw

CTRL = Qt.KeyboardModifier.ControlModifier
SIDES = "Side line top", "Side line left"


@pytest.mark.new_window
def test_each_step_waits_until_it_was_done(make_window, dataset, sample_copy, qtbot, monkeypatch):
    monkeypatch.setattr("procc_annotator.gui.window.tour.sample_folder", lambda: sample_copy)
    window = make_window(dataset)
    tour, services = window.tour, window.services
    window.actions_["tour"].trigger()
    assert services.state.workspace.folder not in (dataset, sample_copy)
    do = (
        lambda: [draw(services, p) for p in ("Middle line", *SIDES, "Circle central")],
        lambda: services.selection.select_point("Middle line", 0),
        lambda: window.panels.show("findings"),
        lambda: QTest.keyClick(window.canvas, Qt.Key.Key_Return, CTRL),
        lambda: [window.status_walk.go("unannotated", 1), draw(services, SIDES[0])],
        *[lambda: QTest.mouseClick(tour.findChild(QPushButton), Qt.MouseButton.LeftButton)] * 2,
        lambda: services.selection.select_class(None),
    )
    for number, act in enumerate(do, start=1):
        qtbot.waitUntil(lambda n=number: tour.label.text().startswith(f"{n} of 8:"))
        act()
    QTest.keyClick(window.canvas, Qt.Key.Key_Escape)
    assert not tour.isVisible()
