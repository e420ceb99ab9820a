"""What is painted again when an overlay gives way to another one: all that differs, by places."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QApplication

from procc_annotator.gui.canvas.overlay_item import changed_areas
from procc_annotator.gui.canvas.overlay_painter import paint_overlay
from procc_annotator.interaction.overlay_primitives import (
    NO_POINTS,
    CursorSigns,
    Labels,
    Overlay,
    PointMarks,
    Strokes,
)


def lines(*rows: tuple[float, float, float, float], colour: str = "#ffffff") -> Strokes:
    return Strokes(np.array(rows, dtype=float).reshape(-1, 4), colour, 2.0)


STILL = lines((500, 500, 600, 600))
DOT = PointMarks(np.array([[900.0, 50.0]]), "dot", "#00ff00", 6.0)


def overlay(moving: Strokes, mark: PointMarks = DOT, *texts: str) -> Overlay:
    at = np.array([[300.0, 700.0 + 200 * i] for i in range(len(texts))]).reshape(-1, 2)
    return Overlay((STILL, moving), (mark,), (Labels(at, texts, "#ffffff"),))


def test_nothing_is_painted_where_nothing_differs() -> None:
    same = lines((0, 0, 10, 10))
    assert changed_areas(overlay(same), overlay(same), 1.0) == []
    assert changed_areas(overlay(same), overlay(lines((0, 0, 10, 10))), 1.0) == []
    assert changed_areas(overlay(lines()), overlay(lines()), 1.0) == []


def test_places_far_apart_are_painted_apart() -> None:
    moved = PointMarks(np.array([[905.0, 50.0]]), "dot", "#00ff00", 6.0)
    areas = changed_areas(
        overlay(lines((0, 0, 10, 10))), overlay(lines((0, 0, 20, 10)), moved), 1.0
    )
    assert len(areas) == 2
    for point in (QPointF(20, 10), QPointF(900, 50), QPointF(905, 50)):
        assert any(area.contains(point) for area in areas)
    assert not any(area.contains(QPointF(550, 550)) for area in areas)


def test_a_line_more_or_less_or_of_another_colour_is_painted() -> None:
    one, more = lines((0, 0, 10, 10)), lines((0, 0, 10, 10), (200, 0, 210, 10))
    for before, after in ((one, more), (more, one)):
        (area,) = changed_areas(overlay(before), overlay(after), 1.0)
        assert area.contains(QPointF(205, 5))
        assert not area.contains(QPointF(5, 5))
    (area,) = changed_areas(overlay(one), overlay(lines((0, 0, 10, 10), colour="#ff0000")), 1.0)
    assert area.contains(QPointF(5, 5))


def test_only_the_text_that_differs_is_painted() -> None:
    one = lines((0, 0, 10, 10))
    (area,) = changed_areas(overlay(one, DOT, "4.2", "7"), overlay(one, DOT, "4.3", "7"), 1.0)
    assert area.contains(QPointF(300, 700))
    assert not area.contains(QPointF(300, 900))


@pytest.mark.parametrize(
    "label",
    [
        Labels(np.array([[200.0, 200.0]]), ("",), "#ffffff", sign="hint", below=True),
        Labels(np.array([[200.0, 200.0]]), ("Grundlinie",), "#ffffff", sign="error", below=True),
        Labels(
            np.array([[200.0, 200.0]]), ("Ziel",), "#ffffff", hand=CursorSigns("#ff0000", "found")
        ),
        Labels(np.array([[200.0, 200.0]]), ("センターサークル",), "#ffffff"),
    ],
)
@pytest.mark.parametrize("scale", [0.5, 1.0, 3.0])
def test_what_goes_leaves_no_stain(qapp: QApplication, label: Labels, scale: float) -> None:
    image = QImage(900, 900, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.transparent)
    gone = Overlay((), (), (label,))
    painter = QPainter(image)
    paint_overlay(painter, gone, scale=scale)
    painter.end()
    alpha = np.frombuffer(image.constBits(), np.uint8).reshape(900, 900, 4)[..., 3]
    rows, columns = np.nonzero(alpha)
    assert len(rows)
    (area,) = changed_areas(gone, Overlay((), (), (Labels(NO_POINTS, (), "#ffffff"),)), scale)
    for x in (columns.min(), columns.max() + 1):
        for y in (rows.min(), rows.max() + 1):
            assert area.contains(QPointF(float(x), float(y)) / scale)
