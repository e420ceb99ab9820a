"""Distances beside points: in sight wherever their point is."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QImage, QPainter
from pytestqt.qtbot import QtBot

from procc_annotator.gui.canvas import label_plates
from procc_annotator.gui.canvas.label_plates import place_label
from procc_annotator.gui.canvas.overlay_item import OverlayItem
from procc_annotator.gui.canvas.overlay_painter import paint_overlay
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.interaction.overlay_primitives import Labels, Overlay
from tests.gui.conftest import Hand, all_done, settle

SIZE = QSizeF(50, 18)
ROOM = QRectF(0, 0, 640, 360)


@pytest.mark.parametrize(
    ("at", "corner"),
    [
        ((300, 200), (309, 175)),  # right above
        ((639, 200), (580, 175)),
        ((300, 4), (309, 13)),
        ((639, 4), (580, 13)),
        ((645, 200), (586, 175)),  # half of its mark is seen
    ],
)
def test_a_text_flips_where_it_would_be_cut(at, corner):
    plate = place_label(QPointF(*at), SIZE, ROOM, 1.0)
    assert plate == QRectF(QPointF(*corner), SIZE)
    assert ROOM.contains(plate)


@pytest.mark.parametrize(
    ("at", "corner"),
    [
        ((300, 200), (309, 207)),  # right below
        ((639, 200), (580, 207)),
        ((300, 350), (309, 325)),
        ((639, 358), (580, 333)),
    ],
)
def test_a_sign_below_its_point_flips_where_it_would_be_cut(at, corner):
    plate = place_label(QPointF(*at), SIZE, ROOM, 1.0, below=True)
    assert plate == QRectF(QPointF(*corner), SIZE)
    assert ROOM.contains(plate)


def test_the_text_of_a_point_out_of_sight_stays_out_of_sight():
    assert not ROOM.intersects(place_label(QPointF(655, 200), SIZE, ROOM, 1.0))


def test_every_corner_of_a_picture_shows_its_texts(qapp):
    at = np.array([[0.0, 0.0], [639.0, 0.0], [0.0, 359.0], [639.0, 359.0]])
    bare = QImage(640, 360, QImage.Format.Format_RGB32)
    for point in at:
        labels = Labels(point[None], ("123.4 px",), "#ffffff")
        bare.fill(Qt.GlobalColor.white)
        painter = QPainter(bare)
        paint_overlay(painter, Overlay((), (), (labels,)), scale=1.0, room=ROOM)
        painter.end()
        shown = np.frombuffer(bare.constBits(), np.uint8).reshape(360, 640, 4)[:, :, 0] < 120
        rows, columns = np.nonzero(shown)
        assert np.ptp(columns) > 45  # the whole plate
        assert np.ptp(rows) > 12


@pytest.fixture
def judged(audited, qtbot) -> MainWindow:
    """A frame with a failing point at the right edge of its picture, which fills the view."""
    services = audited.services
    services.camera_sources.set_active_camera(1)
    settle(audited.services, qtbot)
    audited.canvas.set_scale(1.0)
    return audited


def plates(window: MainWindow, item: OverlayItem, monkeypatch: pytest.MonkeyPatch) -> list[QRectF]:
    """Where the texts of points in sight are painted."""
    placed = []

    def note(
        point: QPointF, size: QSizeF, room: QRectF, unit: float, *, below: bool = False
    ) -> QRectF:
        plate = place_label(point, size, room, unit, below=below)
        if room.intersects(QRectF(point, point).adjusted(-9, -9, 9, 9)):
            placed.append((room, plate))
        return plate

    with monkeypatch.context() as patch:
        patch.setattr(label_plates, "place_label", note)
        window.canvas.grab()
    seen = item._room(window.canvas.viewport().size())
    return [plate for room, plate in placed if room == seen]


def pan(window: MainWindow, by: QPoint) -> None:
    """Move what is seen by px of the view."""
    scale = window.canvas.view_scale
    end = 640 + by.x() / scale, 360 + by.y() / scale
    Hand(window).drag((640, 360), end, Qt.MouseButton.MiddleButton)


def on_screen(window: MainWindow, qtbot: QtBot) -> np.ndarray:
    """(H, W, 4) what the screen has of the picture, which is not painted anew for this."""
    all_done(qtbot)  # screens are painted a little later
    viewport = window.canvas.viewport()
    area = viewport.rect().translated(viewport.mapTo(window, QPoint()))
    taken = window.screen().grabWindow(window.winId()).toImage().copy(area)
    taken = taken.convertToFormat(QImage.Format.Format_RGB32)
    return np.frombuffer(taken.constBits(), np.uint8).reshape(taken.height(), -1, 4).astype(int)


def failing(window: MainWindow) -> np.ndarray:
    """(n, 2) where the view shows the points with a text."""
    labels = window.canvas.overlay_item.overlay.labels[0]
    assert len(labels.texts) > 0
    return np.array([window.canvas.to_view(*p.tolist()).toTuple() for p in labels.positions])


def test_texts_at_the_edges_of_the_view_and_at_the_divider_are_whole(judged, monkeypatch):
    canvas = judged.canvas
    x = failing(judged)[:, 0].max()
    pan(judged, QPoint(round(canvas.viewport().width() - 4 - x), 0))
    front = canvas.overlay_item
    width = canvas.viewport().width()
    whole = plates(judged, front, monkeypatch)
    assert any(plate.right() > width - 40 for plate in whole)
    assert all(plate.right() <= width for plate in whole)
    judged.services.camera_sources.compare_with(judged.services.state.sources[0])
    judged.actions_["split"].trigger()
    pan(judged, QPoint(-150, 0))  # the divider does not go to the very edge
    split = canvas.comparison.split
    split.move_to(failing(judged)[:, 0].max() + 3)
    left = plates(judged, front, monkeypatch)
    assert any(plate.right() > split.x - 40 for plate in left)
    assert all(plate.right() <= split.x for plate in left)


def test_panning_and_the_divider_leave_no_halves_behind(judged, qtbot):
    canvas = judged.canvas
    canvas.set_scale(2.0)
    x, y = failing(judged)[np.argmax(failing(judged)[:, 0])]
    pan(judged, QPoint(round(canvas.viewport().width() - 70 - x), round(40 - y)))
    for step in (QPoint(40, 0), QPoint(20, -20), QPoint(-60, -10), QPoint(-20, 40)):
        pan(judged, step)
        left_behind = on_screen(judged, qtbot)
        canvas.viewport().update()
        assert np.abs(on_screen(judged, qtbot) - left_behind).max() < 8  # smoothing
    judged.services.camera_sources.compare_with(judged.services.state.sources[0])
    judged.actions_["split"].trigger()
    for beside in (80.0, 3.0, -3.0, 60.0):
        canvas.comparison.split.move_to(failing(judged)[:, 0].max() + beside)
        left_behind = on_screen(judged, qtbot)
        canvas.viewport().update()
        assert np.abs(on_screen(judged, qtbot) - left_behind).max() < 8  # smoothing
