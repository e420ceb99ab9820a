"""Texts over the picture cover no other text, and leave nothing behind when they give way."""

from itertools import combinations

import numpy as np
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest

from procc_annotator.gui.canvas.label_plates import Plate, arranged
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.interaction.overlay_primitives import Labels
from tests.gui.conftest import settle

ROOM = (0.0, 0.0, 600.0, 400.0)
AT = np.array([[300.0, 200.0], [303.0, 202.0], [306.0, 204.0], [590.0, 390.0]])
TEXTS = ("5.7", "6.4", "7.1", "8.8")


def cover(one: Plate, other: Plate) -> bool:
    a, b = one.place, other.place
    return a[0] < b[2] and a[2] > b[0] and a[1] < b[3] and a[3] > b[1]


def test_none_covers_another_and_all_are_in_sight(qapp):
    plates = arranged((Labels(AT, TEXTS, "#fff"),), (1.0, 0.0, 0.0), ROOM)
    assert [plate.text for plate in plates] == list(TEXTS)
    assert not any(cover(a, b) for a, b in combinations(plates, 2))
    assert all(p.place[0] >= 0 and p.place[2] <= 600 and p.place[3] <= 400 for p in plates)


def test_signs_give_way_to_signs_and_a_text_without_room_is_left_out(qapp):
    signs = Labels(AT[:3], ("off",) * 3, "#fff", sign="error")
    distances = Labels(np.repeat(AT[:1], 60, axis=0), tuple(map(str, range(60))), "#fff")
    small, legend = (250.0, 150.0, 350.0, 250.0), (250.0, 230.0, 350.0, 250.0)
    clear = Labels(AT[:0], (), "", covered=(legend,))
    plates = arranged((distances, signs, clear), (1.0, 0.0, 0.0), small)
    assert not any(cover(plate, Plate(clear, 0, legend)) for plate in plates)
    assert [plate.text for plate in plates[:3]] == ["off"] * 3
    assert 5 < len(plates) < 63
    assert not any(cover(a, b) for a, b in combinations(plates, 2))


def test_a_sign_stays_at_its_point_and_what_is_at_the_cursor_moves_nothing(qapp):
    def at(*groups: Labels) -> dict[str, tuple[float, ...]]:
        plates = arranged(groups, (1.0, 0.0, 0.0), ROOM)
        assert not any(cover(a, b) for a, b in combinations(plates, 2))
        return {p.text: p.place for p in plates}

    distance = Labels(AT[:1], ("5.7",), "#fff")
    sign = Labels(AT[:1], ("off",), "#fff", sign="error")
    cursor = Labels(AT[:1], ("Halfway line",), "#fff", carried=True)
    assert at(distance, sign)["off"] == at(sign)["off"]
    assert at(distance, sign)["5.7"] != at(distance)["5.7"]
    assert at(distance, cursor)["5.7"] == at(distance)["5.7"]


def on_screen(window: MainWindow) -> np.ndarray:
    """What was painted, part by part."""
    viewport = window.canvas.viewport()
    shown = window.screen().grabWindow(window.winId()).toImage()
    image = shown.convertToFormat(QImage.Format.Format_RGB32)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.width(), 4)
    corner = viewport.mapTo(window, QPoint())
    left, top = corner.x(), corner.y()
    return rows[top : top + viewport.height(), left : left + viewport.width(), :3].copy()


def test_what_gives_way_leaves_no_stain(audited, qtbot):
    services, canvas = audited.services, audited.canvas
    services.camera_sources.set_active_camera(
        next(i for i, s in enumerate(services.state.sources) if s.name == "bad")
    )
    services.selection.set_mode("edit")
    settle(audited.services, qtbot)
    assert len(canvas.overlay_item.overlay.labels[0].texts) > 2

    def check() -> None:
        settle(audited.services, qtbot)
        part_by_part = on_screen(audited)
        canvas.viewport().update()
        settle(audited.services, qtbot)
        assert np.array_equal(part_by_part, on_screen(audited))

    point = services.state.annotation.polylines[0].points[0]
    width, height = services.state.picture_size
    x, y = point.u * (width - 1), point.v * (height - 1)
    viewport, none = canvas.viewport(), Qt.KeyboardModifier.NoModifier
    begin = canvas.to_view(x, y).toPoint()
    QTest.mousePress(viewport, Qt.MouseButton.LeftButton, none, begin)
    QTest.mouseMove(viewport, begin + QPoint(30, -20))
    QTest.mouseRelease(viewport, Qt.MouseButton.LeftButton, none, begin + QPoint(30, -20))
    check()
    services.editing.undo()
    check()
    canvas.zoom_in()
    canvas.go_along(QPointF(60, 25))
    check()
    canvas.go_along(QPointF(-45, -35))
    check()
