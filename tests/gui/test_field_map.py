"""The field map of any sport: everything can be clicked, spots too, and it can be magnified."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

from procc_annotator.annotation import Point, Polyline
from procc_annotator.field.geometry import Spot
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.load import field_names, load_field
from procc_annotator.field.model import Field, Landmark
from procc_annotator.gui.panels.field_map.field_map_panel import FieldMapPanel
from procc_annotator.gui.panels.field_map.field_shape import FieldShape
from procc_annotator.gui.state.services import Services


@pytest.fixture
def show_map(qtbot) -> Callable[..., tuple[FieldMapPanel, Services]]:
    def show(field: Field, size: tuple[int, int] = (300, 240)) -> tuple[FieldMapPanel, Services]:
        services = Services(field)
        panel = FieldMapPanel(services)
        qtbot.addWidget(panel)
        panel.resize(*size)
        panel.show()
        panel.destroyed.connect(services.close)
        return panel, services

    return show


def turn_wheel(panel: QWidget, at: QPointF, steps: int) -> None:
    event = QWheelEvent(
        at, panel.mapToGlobal(at), QPoint(), QPoint(0, 120 * steps), Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(panel, event)


@pytest.mark.parametrize(
    ("name", "size"),
    [
        *((name, (600, 420)) for name in field_names()),
        ("soccer", (260, 190)),
        ("soccer", (500, 160)),
    ],
)
def test_every_element_of_every_field_can_be_clicked(show_map, qtbot, name, size):
    panel, services = show_map(load_field(name), size)
    for element in services.state.field.elements:
        position = panel.position_of(element.name)
        qtbot.mouseClick(panel, Qt.MouseButton.LeftButton, pos=position.toPoint())
        assert services.state.selected_class == element.name
        assert panel.rect().contains(position.toPoint())
    qtbot.mouseClick(panel, Qt.MouseButton.LeftButton, pos=QPoint(1, 1))
    assert services.state.selected_class is None


@pytest.mark.parametrize("name", ["soccer", "ice_hockey_iihf", "basketball_fiba", "volleyball"])
def test_what_stands_is_laid_beside_the_field(name):
    field = load_field(name)
    shape = FieldShape.of(field)
    left, _, right, _ = shape.ground
    for element, line in zip(field.elements, shape.lines, strict=True):
        rail = element.name.startswith("Rail")
        if not element.on_ground and not rail:
            x = line[:, 0]
            assert (x <= left).all() or (x >= right).all(), element.name
    goals = [e.name for e in field.elements if e.name.startswith(("Goal left", "Rim left"))]
    for goal in goals:
        assert shape.on_map(goal, field_points(field, goal))[:, 0].max() <= left


def field_points(field: Field, name: str):
    from procc_annotator.field.geometry import outline_of

    return outline_of(field.element(name).geometry)


def test_the_wheel_magnifies_what_is_under_the_cursor(show_map, qtbot):
    panel, services = show_map(load_field("athletics"))
    lanes = [e.name for e in services.state.field.elements if e.name.startswith("Lane line")][:2]
    apart = panel.position_of(lanes[0]) - panel.position_of(lanes[1])
    cursor = panel.position_of(lanes[0])
    turn_wheel(panel, cursor, 20)
    assert (panel.position_of(lanes[0]) - cursor).manhattanLength() < 0.01
    wide = panel.position_of(lanes[0]) - panel.position_of(lanes[1])
    assert wide.manhattanLength() > 10 * apart.manhattanLength()
    qtbot.mouseClick(panel, Qt.MouseButton.LeftButton, pos=cursor.toPoint())
    assert services.state.selected_class == lanes[0]
    # Dragged, it moves and nothing is chosen; a double click beside all lines shows it whole.
    start, end = QPoint(100, 100), QPoint(140, 90)
    QTest.mousePress(panel, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(panel, end)
    QTest.mouseRelease(panel, Qt.MouseButton.LeftButton, pos=end)
    assert panel.position_of(lanes[0]).toPoint() == (cursor + QPointF(end - start)).toPoint()
    assert services.state.selected_class == lanes[0]
    empty = next(
        p for p in (QPoint(x, 100) for x in range(300)) if panel.class_at(QPointF(p)) is None
    )
    QTest.mouseDClick(panel, Qt.MouseButton.LeftButton, pos=empty)
    assert panel.position_of(lanes[0]).toPoint() == cursor.toPoint()


def test_a_far_landmark_leaves_the_field_its_room():
    field = load_field("soccer")
    light = replace(
        field.elements[0], name="light", geometry=Spot((30.0, -400.0, -45.0)), optional=True
    )
    alone, with_light = (
        FieldShape.of(field),
        FieldShape.of(replace(field, elements=(*field.elements, light), symmetries=())),
    )
    assert with_light.ground == alone.ground
    assert with_light.bounds[1] > alone.bounds[1] - 20
    (x, y) = with_light.anchors[-1]
    assert x == 30.0
    assert y < alone.bounds[1]


def test_landmarks_change_nothing_of_the_field_on_its_map():
    field = load_field("soccer")
    alone = FieldShape.of(field)
    places = {"seat": (-30.0, -50.0, -6.0), "net hook": (-53.0, 3.2, -2.0), "drain": (5.0, 5.0, 0)}
    shape = FieldShape.of(
        with_landmarks(field, [Landmark(name, position=place) for name, place in places.items()])
    )
    own = len(field.elements)
    assert shape.names == (*alone.names, *places)
    assert (shape.anchors[:own] == alone.anchors).all()
    assert shape.ground == alone.ground
    seat, hook, drain = shape.anchors[own:].tolist()
    assert drain == [5.0, 5.0]
    assert seat[0] == -30.0
    assert hook[0] < -54.0  # in the air at the goal: it is laid flat with it
    for name, (x, y) in zip(places, (seat, hook, drain), strict=True):
        assert shape.pick(x, y, 1.0) == name
        assert shape.on_map(name, np.array([places[name]])).tolist() == [[x, y]]
    assert shape.bounds[1] <= seat[1]


def test_a_field_may_be_one_line_or_hang_in_the_air(show_map):
    field = load_field("soccer")
    for keep in ("Middle line", "Goal left crossbar", "Penalty mark left"):
        (element,) = [e for e in field.elements if e.name == keep]
        panel, _ = show_map(replace(field, elements=(element,), symmetries=()))
        position = panel.position_of(keep)
        assert panel.class_at(position) == keep
        assert not panel.grab().isNull()


def test_a_spot_shows_its_state(window, qtbot):
    services, panel = window.services, window.field_map
    at = panel.position_of("Penalty mark left")
    ratio = panel.devicePixelRatio()
    area = (at * ratio).toPoint() - QPoint(8, 8)

    def picture() -> bytes:
        image = panel.grab().toImage().copy(area.x(), area.y(), 16, 16)
        return bytes(image.constBits())

    before = picture()
    mark = Polyline("Penalty mark left", (Point(0.4, 0.5),))
    services.editing.commit_edit("draw", services.state.annotation.with_polyline(mark))
    qtbot.waitUntil(lambda: picture() != before)
