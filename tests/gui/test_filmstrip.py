"""The frames as small pictures below the picture, where they follow no shot."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QImage, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.records import Status
from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import Hand, MakeWindow, all_done

pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)


@pytest.fixture
def there(window: MainWindow, qtbot: QtBot) -> MainWindow:
    qtbot.waitUntil(lambda: window.filmstrip.isVisible())
    all_done(qtbot)
    return window


def cell(window: MainWindow, frame: int) -> QPoint:
    strip = window.filmstrip
    return strip.visualRect(strip.model().index(0, frame)).center()


def seen(window: MainWindow, frame: int) -> np.ndarray:
    strip = window.filmstrip
    area = strip.visualRect(strip.model().index(0, frame))
    image = strip.viewport().grab(area).toImage().convertToFormat(QImage.Format.Format_RGB32)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return rows[:, : 4 * image.width()].astype(int)


def test_a_click_goes_to_a_frame_and_the_frame_is_marked(
    there: MainWindow, hand: Hand, qtbot: QtBot
) -> None:
    strip = there.filmstrip
    at = cell(there, 2)
    QTest.mouseClick(strip.viewport(), Qt.MouseButton.LeftButton, pos=at)
    qtbot.waitUntil(lambda: there.document.state.frame_index == 2)
    qtbot.waitUntil(lambda: strip.currentIndex().column() == 2)
    assert there.canvas.hasFocus()  # keys go on drawing
    hand.key(Qt.Key.Key_A)
    qtbot.waitUntil(lambda: strip.currentIndex().column() == 1)


def test_states_are_seen(there: MainWindow, qtbot: QtBot) -> None:
    before = seen(there, 1)
    there.document.review.set_status("frame_1", Status.DONE)
    QApplication.processEvents()
    done = seen(there, 1)
    assert not np.array_equal(before, done)
    there.document.review.set_status("frame_1", Status.REJECTED)
    QApplication.processEvents()
    assert not np.array_equal(done, seen(there, 1))


def test_it_shows_what_the_filter_lets_through(there: MainWindow, qtbot: QtBot) -> None:
    there.frames.filter.setText("_2")
    qtbot.waitUntil(lambda: there.filmstrip.model().columnCount() == 1)
    assert there.filmstrip.model().index(0, 0).data() == "frame_2"
    QTest.mouseClick(there.filmstrip.viewport(), Qt.MouseButton.LeftButton, pos=cell(there, 0))
    qtbot.waitUntil(lambda: there.document.state.frame_index == 2)


def test_it_is_switched_off_and_comes_back(there: MainWindow) -> None:
    there.actions_["strip"].trigger()
    assert not there.filmstrip.isVisible()
    there.document.walk.next_frame()
    assert not there.filmstrip.isVisible()
    there.actions_["strip"].trigger()
    assert there.filmstrip.isVisible()


def test_one_picture_has_no_strip(make_window: MakeWindow, dataset, qtbot: QtBot) -> None:
    for name in ("frame_1.png", "frame_2.png"):
        (dataset / name).unlink()
    window = make_window(dataset)
    all_done(qtbot)
    assert not window.filmstrip.isVisible()


def test_the_wheel_goes_along(make_window: MakeWindow, dataset, striped, qtbot: QtBot) -> None:
    for i in range(3, 30):
        (dataset / f"other_{i}x.png").write_bytes(striped[i % 3])
    window = make_window(dataset)
    strip = window.filmstrip
    qtbot.waitUntil(strip.isVisible)
    at = QPointF(cell(window, 1))
    event = QWheelEvent(
        at,
        QPointF(strip.viewport().mapToGlobal(at.toPoint())),
        QPoint(),
        QPoint(0, -240),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(strip.viewport(), event)
    assert strip.horizontalScrollBar().value() == 240


def test_frames_are_gone_to_by_keys(there: MainWindow, qtbot: QtBot) -> None:
    strip = there.filmstrip
    strip.setFocus(Qt.FocusReason.TabFocusReason)
    assert strip.hasFocus()
    QTest.keyClick(strip, Qt.Key.Key_Right)
    QTest.keyClick(strip, Qt.Key.Key_Right)
    assert there.document.state.frame_index == 0  # only looked at
    QTest.keyClick(strip, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: there.document.state.frame_index == 2)
    assert strip.hasFocus()
