"""What is painted by places while a hand carries something is what would be painted afresh."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QObject, QPoint, Qt
from PySide6.QtGui import QContextMenuEvent, QImage, QPixmap
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.exceptions import TimeoutError
from pytestqt.qtbot import QtBot

from procc_annotator.gui.main_window import MainWindow
from procc_annotator.image.pixels import DisplayAdjustment
from tests.gui.conftest import Hand

# Pixels are compared, which hang on how large each panel is.
pytestmark = pytest.mark.new_window

ELEMENT, ROW = "Big rect. left main", 1  # at its ends it meets other elements
LEFT, NONE = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
RING = 2  # px at the rim that the ring around what has the keyboard lies over
WAY = (QPoint(4, 2), QPoint(30, -12), QPoint(-25, 40), QPoint(60, 60), QPoint(58, 61))


class _Held:
    """A point of an element under the mouse button."""

    def __init__(self, window: MainWindow, qtbot: QtBot) -> None:
        self.window, self.canvas, self._hand = window, window.canvas, Hand(window)
        self._qtbot = qtbot
        window.services.selection.set_mode("edit")
        polyline = window.services.state.annotation.get(ELEMENT)
        size = window.services.state.picture_size
        u, v = polyline.points[ROW][:2]
        self.at = u * (size[0] - 1), v * (size[1] - 1)

    def take(self) -> None:
        self.grip = self._hand.at(*self.at)
        self._hand._move(self.grip, Qt.MouseButton.NoButton)
        QTest.mousePress(self.canvas.viewport(), LEFT, NONE, self.grip)

    def carry(self, by: QPoint) -> None:
        self._hand._move(self.grip + by, LEFT)

    def drop(self, by: QPoint) -> None:
        QTest.mouseRelease(self.canvas.viewport(), LEFT, NONE, self.grip + by)

    def assert_painted(self, when: str) -> None:
        """Compares the screen with all of it painted anew; what still arrives is waited for, what
        was left out by mistake stays."""
        QApplication.processEvents()
        try:
            self._qtbot.waitUntil(lambda: not self._differing().any())
        except TimeoutError:
            pytest.fail(when)

    def _differing(self) -> np.ndarray:
        window, view = self.window, self.canvas.viewport()
        screen = window.screen().grabWindow(window.winId())
        corner = view.mapTo(window, QPoint())
        seen = screen.copy(corner.x(), corner.y(), view.width(), view.height())
        # The rim of a line that is cut at another place is rounded otherwise, by a level or five.
        differing = np.abs(_pixels(seen) - _pixels(view.grab())) > 8
        return differing[RING:-RING, RING:-RING]


def _pixels(picture: QPixmap) -> np.ndarray:
    image = picture.toImage().convertToFormat(QImage.Format.Format_RGB32)
    shape = image.height(), image.width(), 4
    return np.frombuffer(image.constBits(), np.uint8).reshape(shape)[..., :3].astype(int)


def _magnify(held: _Held) -> None:
    held.canvas.fly_to(*held.at)
    held.canvas.set_scale(8.0)


def _split(held: _Held) -> None:
    held.canvas.drawing.set_split(True)


def _zoom_out(held: _Held) -> None:
    held.canvas.set_scale(0.3)


@pytest.mark.parametrize("prepare", [lambda held: None, _magnify, _split, _zoom_out])
def test_a_carried_point(audited, qtbot, prepare):
    held = _Held(audited, qtbot)
    prepare(held)
    held.assert_painted("before")
    held.take()
    for by in WAY:
        held.carry(by)
        held.assert_painted(f"carried by {by.toTuple()}")
    held.drop(WAY[-1])
    held.assert_painted("dropped")


@pytest.mark.parametrize(
    "happens",
    [
        lambda window: window.services.selection.select_class("Middle line"),
        lambda window: window.canvas.undo(),
        lambda window: window.canvas.shown.set_look(DisplayAdjustment(brightness=0.2)),
        lambda window: window.services.camera_sources.set_active_camera(1),
        lambda window: window.services.evaluation.set_tau(12.0),
        lambda window: window.canvas.drawing.set_colour_by("class"),
        lambda window: window.services.navigator.go_to(2),
        lambda window: window.resize(window.width() - 120, window.height() - 80),
    ],
    ids=["selected", "undone", "look", "source", "threshold", "colours", "frame", "resized"],
)
def test_what_happens_meanwhile_is_seen(audited, qtbot, happens):
    held = _Held(audited, qtbot)
    held.take()
    held.carry(WAY[1])
    held.assert_painted("before")
    happens(audited)
    held.assert_painted("when it happens")
    for by in WAY[2:]:
        held.carry(by)
        held.assert_painted("carried on")
    held.drop(WAY[-1])


def test_the_cursor_is_told_once_it_is_let_go(audited, qtbot):
    held, shown = _Held(audited, qtbot), audited.status.pixels
    held.take()
    before = shown.text()
    held.carry(WAY[1])
    qtbot.waitUntil(lambda: shown.text() != before)
    held.carry(WAY[2])
    held.drop(WAY[2])
    x, y = audited.canvas.cursor_px or (0.0, 0.0)
    assert shown.text() == f"{x:.1f} {y:.1f} px"


def _places(window: MainWindow) -> np.ndarray:
    polyline = window.services.state.annotation.get(ELEMENT)
    return np.array([point[:2] for point in polyline.points])


def test_each_button_ends_its_own_gesture(audited, qtbot):
    held, middle = _Held(audited, qtbot), Qt.MouseButton.MiddleButton
    canvas, before = audited.canvas, _places(audited)
    held.take()
    held.carry(WAY[1])
    QTest.mousePress(canvas.viewport(), middle, NONE, held.grip + WAY[1])
    held._hand._move(held.grip + WAY[3], LEFT | middle)
    held.drop(WAY[3])
    assert canvas.panning
    assert not canvas.editor.holding
    moved = _places(audited)
    assert np.abs(moved - before).max() > 0
    QTest.mouseRelease(canvas.viewport(), middle, NONE, held.grip + WAY[3])
    assert not canvas.panning
    held._hand._move(held.grip, Qt.MouseButton.NoButton)
    assert (_places(audited) == moved).all()
    audited.canvas.undo()
    assert (_places(audited) == before).all()


def test_no_menu_opens_while_a_point_is_carried(audited, qtbot):
    held, view, asked = _Held(audited, qtbot), audited.canvas.viewport(), []
    audited.canvas.menuWanted.disconnect()
    audited.canvas.menuWanted.connect(asked.append)
    held.take()
    held.carry(WAY[1])
    at = held.grip + WAY[1]
    mouse = QContextMenuEvent.Reason.Mouse
    QApplication.sendEvent(view, QContextMenuEvent(mouse, at, view.mapToGlobal(at)))
    assert not asked
    held.drop(WAY[1])
    QApplication.sendEvent(view, QContextMenuEvent(mouse, at, view.mapToGlobal(at)))
    assert asked


def test_a_point_whose_release_went_elsewhere_stays_where_it_was_seen(audited, qtbot):
    held, before = _Held(audited, qtbot), _places(audited)
    audited.services.selection.set_option("snapping", False)
    held.take()
    held.carry(WAY[1])
    x, y = held._hand.picture(held.at[0], held.at[1])
    there = audited.canvas.cursor_px
    held._hand._move(held.grip + WAY[3], Qt.MouseButton.NoButton)
    assert not audited.canvas.editor.holding
    w, h = audited.services.state.picture_size or (0, 0)
    moved = (_places(audited) - before)[ROW] * (w - 1, h - 1)
    assert moved == pytest.approx((there[0] - x, there[1] - y), abs=0.01)


class _Paints(QObject):
    count = 0

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        self.count += event.type() == QEvent.Type.Paint
        return False


def test_a_list_in_which_nothing_changes_is_not_painted(begun, qtbot):
    held, paints = _Held(begun, qtbot), _Paints()
    begun.panels.show("elements")
    held.take()
    panel, refresher = begun.elements, begun.elements._refresher

    def carried(by: QPoint) -> None:
        held.carry(by)
        qtbot.waitUntil(lambda: not refresher._stale)
        qtbot.waitUntil(lambda: not refresher._timer.isActive())

    carried(WAY[0])
    panel.tree.viewport().installEventFilter(paints)
    carried(WAY[1])
    painted = paints.count
    held.drop(WAY[1])
    assert painted == 0
