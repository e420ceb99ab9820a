"""The loupe shows the picture's own pixels at the cursor, clear of it, inside the viewport."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, QSize, Qt
from PySide6.QtGui import QColor, QImage, QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget

from procc_annotator.gui.canvas.loupe import Loupe, magnify, place_beside, position_text
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction.overlay_primitives import Labels, Overlay, PointMarks, Strokes

NOTHING = Overlay((), (), ())


def _picture(width: int = 160, height: int = 90) -> PixelArray:
    """Every pixel has a colour of its own."""
    pixels = np.full((height, width, 4), 255, dtype=np.uint8)
    y, x = np.mgrid[:height, :width]
    pixels[..., 0], pixels[..., 1], pixels[..., 2] = x, y + 100, 60 + (x + y) % 2 * 60
    pixels.flags.writeable = False
    return pixels


class _Eye(QWidget):
    """A viewport whose every event is counted."""

    def __init__(self) -> None:
        super().__init__()
        self.presses: list[QPointF] = []

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.presses.append(event.position())


@pytest.fixture
def viewport(qtbot) -> _Eye:
    widget = _Eye()
    qtbot.addWidget(widget)
    widget.resize(800, 600)
    widget.show()
    return widget


def _seen(loupe: Loupe, ratio: float = 1.0) -> QImage:
    image = QImage(loupe.size() * ratio, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    image.fill(QColor("magenta"))
    loupe.render(image)
    return image


def _bgr(colour: QColor) -> list[int]:
    return [colour.blue(), colour.green(), colour.red()]


@pytest.mark.parametrize("at", [(80.0, 45.0), (80.3, 45.4), (79.6, 44.7), (80.49, 45.02)])
def test_pixels_are_blocks_around_the_cursor(viewport, at):
    pixels, loupe = _picture(), Loupe(viewport)
    loupe.show_at(QPointF(300, 300), at, pixels, NOTHING)
    image = _seen(loupe)
    middle = loupe.width() / 2 - 0.5  # the middle of a screen pixel
    for dx, dy in [(-6, -5), (3, -8), (7, 9), (-4, 2)]:
        x, y = round(at[0]) + dx, round(at[1]) + dy
        # The pixel's centre lies at its whole number, FACTOR points apart from the next.
        centre = [middle + (p - a) * loupe.FACTOR for p, a in zip((x, y), at, strict=True)]
        inside = {
            tuple(_bgr(image.pixelColor(int(centre[0] + i), int(centre[1] + j))))
            for i in (-3, 0, 2)
            for j in (-3, 0, 2)
        }
        assert inside == {tuple(pixels[y, x, :3].tolist())}


def test_outside_the_picture_it_is_dark(viewport):
    loupe = Loupe(viewport)
    loupe.show_at(QPointF(300, 300), (0.0, 45.0), _picture(), NOTHING)
    image = _seen(loupe)
    assert image.pixelColor(40, 60).lightness() < 40
    assert image.pixelColor(150, 60).lightness() > 40
    loupe.show_at(QPointF(300, 300), (-500.0, 9000.0), _picture(), NOTHING)
    assert _seen(loupe).pixelColor(150, 60).lightness() < 40


def test_the_overlay_is_drawn_where_it_belongs_without_labels(viewport):
    loupe = Loupe(viewport)
    overlay = Overlay(
        (Strokes(np.array([[60.0, 40.0, 100.0, 40.0]]), "#ff0000", 2.0),),
        (PointMarks(np.array([[85.0, 50.0]]), "handle", "#00ff00", 6.0),),
        (Labels(np.array([[80.0, 45.0]]), ("A label",), "#ffffff"),),
    )
    black = np.zeros((90, 160, 4), dtype=np.uint8)
    loupe.show_at(QPointF(300, 300), (80.0, 45.0), black, overlay)
    image = _seen(loupe)
    middle = loupe.width() // 2
    assert image.pixelColor(middle + 30, middle - 5 * 8).red() > 200
    assert image.pixelColor(middle + 5 * 8, middle + 5 * 8).green() > 200
    loupe.show_at(
        QPointF(300, 300), (80.0, 45.0), black, Overlay(overlay.strokes, overlay.marks, ())
    )
    assert _seen(loupe) == image


@pytest.mark.parametrize("fraction", [-0.4, -0.1, 0.0, 0.22, 0.37, 0.5])
def test_the_cross_marks_the_exact_position(viewport, fraction):
    loupe = Loupe(viewport)
    halves = np.full((90, 160, 4), 100, dtype=np.uint8)
    halves[:, 83:] = 60  # an edge at 82.5
    loupe.show_at(QPointF(300, 300), (80.0 + fraction, 45.0), halves, NOTHING)
    image = _seen(loupe)
    row = np.array([image.pixelColor(x, 40).lightness() for x in range(20, 180)])
    (cross,) = np.nonzero(row > 200)
    assert len(cross) == 1  # thin and sharp
    assert row[cross[0] - 1] < 60 > row[cross[0] + 1]  # readable on white, too
    edge = int(np.argmax(row == 60))
    # Half a screen pixel is a sixteenth of the picture's.
    assert (edge - (cross[0] + 0.5)) / loupe.FACTOR == pytest.approx(2.5 - fraction, abs=1 / 16)


@pytest.mark.parametrize("ratio", [1.25, 1.5, 2.0])
def test_blocks_are_even_on_fine_screens(ratio):
    side, factor = round(200 * ratio), round(8 * ratio)
    pixels = _picture()
    part = magnify(pixels, (-600, -300), factor, side)
    assert part.shape == (side, side, 4)
    x, y = (600 + np.arange(side)) // factor, (300 + np.arange(side)) // factor
    inside = np.ix_(y[y < 90], x[x < 160])
    np.testing.assert_array_equal(part[: (y < 90).sum(), : (x < 160).sum()], pixels[inside])


def test_it_is_sharp_on_a_fine_screen(viewport):
    pixels, loupe = _picture(), Loupe(viewport)
    loupe.show_at(QPointF(300, 300), (80.3, 45.4), pixels, NOTHING)
    image = loupe.grab().toImage()
    known = {tuple(p) for p in pixels[..., :3].reshape(-1, 3).tolist()}
    row = [tuple(_bgr(image.pixelColor(x, 30))) for x in range(10, image.width() - 10)]
    # All but the cross's few pixels are colours of the picture: nothing is blended.
    assert sum(colour not in known for colour in row) <= 6


def test_the_text_and_border_are_readable_on_any_picture(viewport):
    loupe = Loupe(viewport)
    for value in (0, 120, 255):
        flat = np.full((90, 160, 4), value, dtype=np.uint8)
        loupe.show_at(QPointF(300, 300), (80.0, 45.0), flat, NOTHING)
        image = _seen(loupe)
        edge = [image.pixelColor(x, 60).lightness() for x in range(4)]
        assert max(edge) - min(edge) > 150
        text = [image.pixelColor(x, 211).lightness() for x in range(40, 160)]
        assert min(text) < 40
        assert max(text) > 150
    assert position_text((987.3, -0.257)) == "987.30  −0.26 px"


def test_the_mouse_goes_through(viewport, qtbot):
    loupe = Loupe(viewport)
    loupe.show_at(QPointF(300, 300), (80.0, 45.0), _picture(), NOTHING)
    assert loupe.isVisible()
    within = loupe.geometry().center()
    assert viewport.childAt(within) is None
    qtbot.mouseClick(viewport.window().windowHandle(), Qt.MouseButton.LeftButton, pos=within)
    assert viewport.presses == [QPointF(within)]


@pytest.mark.parametrize("room", [(800, 600), (500, 520), (300, 500), (460, 230), (1200, 300)])
def test_it_never_covers_the_cursor_nor_leaves_the_room(room):
    size = QSize(200, 222)
    for x in range(0, room[0], 7):
        for y in range(0, room[1], 7):
            place = place_beside(QPointF(x, y), size, QSize(*room))
            if place is None:
                assert room[0] < 2 * (200 + 28)
                continue
            box = QRect(place, size)
            assert QRect(0, 0, *room).contains(box)
            assert not box.adjusted(-20, -20, 20, 20).contains(QPoint(x, y))


def test_it_prefers_below_right_and_flips_at_the_edges():
    size, room = QSize(200, 222), QSize(800, 600)
    assert place_beside(QPointF(100, 100), size, room) == QPoint(128, 128)
    assert place_beside(QPointF(700, 100), size, room) == QPoint(472, 128)
    assert place_beside(QPointF(100, 500), size, room) == QPoint(128, 250)
    assert place_beside(QPointF(790, 590), size, room) == QPoint(562, 340)


def test_without_room_it_hides_and_comes_back(viewport):
    loupe = Loupe(viewport)
    assert not loupe.isVisible()
    viewport.resize(220, 230)
    loupe.show_at(QPointF(110, 110), (80.0, 45.0), _picture(), NOTHING)
    assert not loupe.isVisible()
    viewport.resize(800, 600)
    loupe.show_at(QPointF(110, 110), (80.0, 45.0), _picture(), NOTHING)
    assert loupe.isVisible()
    loupe.hide()
    assert not loupe.isVisible()


def test_it_stays_in_place_when_the_view_scrolls(qtbot):
    view = PictureView()
    qtbot.addWidget(view)
    view.resize(640, 480)
    view.show()
    view.set_picture(_picture(640, 360), (640, 360))
    view.set_scale(4.0)
    loupe = Loupe(view.viewport())
    loupe.show_at(QPointF(100, 100), (80.0, 45.0), _picture(), NOTHING)
    before = loupe.pos()
    for _ in range(3):
        view.horizontalScrollBar().setValue(view.horizontalScrollBar().value() + 40)
        view.verticalScrollBar().setValue(view.verticalScrollBar().value() - 25)
        QApplication.processEvents()
        assert loupe.pos() == before


def test_it_shows_the_latest_of_many_moves(viewport):
    loupe, pixels = Loupe(viewport), _picture()
    for step in range(5):
        loupe.show_at(QPointF(100 + step, 100), (60.0 + step, 45.0), pixels, NOTHING)
    QApplication.sendPostedEvents(None, QEvent.Type.UpdateRequest)
    assert loupe.pos() == QPoint(132, 128)
    colour = _seen(loupe).pixelColor(loupe.width() // 2 - 40, loupe.width() // 2 - 40)
    assert _bgr(colour) == pixels[40, 59, :3].tolist()
