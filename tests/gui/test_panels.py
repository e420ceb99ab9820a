"""The panels beside the canvas: what they show of a real frame and camera, and what clicks do."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QMouseEvent
from PySide6.QtWidgets import QApplication, QComboBox, QLabel, QLineEdit, QToolButton, QWidget

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import field_names, load_field
from procc_annotator.formats.annotations.soccernet import write_annotation
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.gui.panels.cameras import CamerasPanel
from procc_annotator.gui.panels.element_states import (
    ElementState,
    element_states,
    short_titles,
    state_pen,
)
from procc_annotator.gui.panels.elements import NAME, POINTS, STATUS, ElementsPanel
from procc_annotator.gui.panels.field_map.field_map_panel import FieldMapPanel
from procc_annotator.gui.panels.scores import ScoresPanel
from procc_annotator.gui.state.services import Services
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (960, 540)
CAMERA = PinholeCamera(
    pan_rad=np.deg2rad(-25),
    tilt_rad=np.deg2rad(78),
    roll_rad=0.0,
    position_world=(0.0, 70.0, -15.0),
    focal_px=(900.0, 900.0),
    principal_point_px=(480.0, 270.0),
)
PASSES = "Big rect. left main"
TOO_FAR = "Middle line"
NOT_ANNOTATED = "Side line left"
MISSED = "Goal right crossbar"  # not in the picture of this camera
UNKNOWN = "Corner flag"


def _annotation() -> FrameAnnotation:
    pieces = project_field(CAMERA, EvaluationSetup(load_field("soccer"))).pieces
    assert MISSED not in pieces
    polylines = []
    for name, lines in pieces.items():
        if name == NOT_ANNOTATED:
            continue
        line = lines[0][:: max(1, len(lines[0]) // 3)].copy()
        if name == TOO_FAR:
            line[1, 0] += 12.0
        polylines.append(Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in line)))
    polylines.append(Polyline(MISSED, (Point(0.5, 0.5), Point(0.6, 0.5))))
    polylines.append(Polyline(UNKNOWN, (Point(0.1, 0.2),)))
    return FrameAnnotation(tuple(polylines))


@pytest.fixture
def frames(tmp_path) -> Path:
    """Two pictures, the first one annotated."""
    folder = tmp_path / "frames"
    folder.mkdir()
    for name in ("a", "b"):
        cv2.imwrite(str(folder / f"{name}.png"), np.full((540, 960, 3), 90, dtype=np.uint8))
    (folder / "a.json").write_bytes(write_annotation(_annotation()))
    return folder


@pytest.fixture
def cameras(tmp_path) -> Path:
    """A folder with the camera of the first frame, and a damaged one for the second."""
    folder = tmp_path / "true cameras"
    folder.mkdir()
    (folder / "camera_a.json").write_bytes(write_camera(CAMERA))
    broken = json.loads(write_camera(CAMERA))
    broken["radial_distortion"] = [0.0]
    (folder / "camera_b.json").write_text(json.dumps(broken))
    return folder


@pytest.fixture
def services(open_services, frames) -> Services:
    return open_services(frames)


@pytest.fixture
def judged(services, cameras) -> Services:
    assert services.camera_sources.load_cameras(cameras)
    return services


# --- states ------------------------------------------------------------------------------------


def test_states_follow_the_score(services, cameras):
    states = element_states(services)
    assert set(states.values()) == {ElementState.ANNOTATED}
    services.camera_sources.load_cameras(cameras)
    states = element_states(services)
    assert states[PASSES] is ElementState.PASSES
    assert states[TOO_FAR] is ElementState.TOO_FAR
    assert states[NOT_ANNOTATED] is ElementState.NOT_ANNOTATED
    assert states[MISSED] is ElementState.MISSED
    assert states[UNKNOWN] is ElementState.MISSED
    services.evaluation.set_tau(30.0)
    assert element_states(services)[TOO_FAR] is ElementState.PASSES
    services.blind_lock.set_blind(True)
    assert set(element_states(services).values()) == {ElementState.ANNOTATED}


def test_no_two_failing_states_have_the_same_line(qapp, services):
    palette = QWidget().palette()
    pens = [state_pen(state, palette, 2.0) for state in ElementState]
    looks = {(pen.color().name(), tuple(pen.dashPattern())) for pen in pens}
    assert len(looks) == len(pens)
    dashes = {
        tuple(state_pen(state, palette, 2.0).dashPattern())
        for state in (ElementState.PASSES, ElementState.NOT_ANNOTATED, ElementState.MISSED)
    }
    assert len(dashes) == 3


# --- field map ---------------------------------------------------------------------------------


def test_the_main_camera_s_side_is_at_the_bottom(services, show):
    panel = FieldMapPanel(services)
    show(panel)
    near, far = panel.position_of("Side line bottom"), panel.position_of("Side line top")
    crossbar, line = panel.position_of("Goal left crossbar"), panel.position_of("Side line left")
    assert near.y() > far.y()
    assert crossbar.x() < line.x() - 5


def point_at(widget: QWidget, position: QPointF) -> None:
    """Move the mouse over a widget, whatever window may lie over it."""
    none = Qt.MouseButton.NoButton
    where = QPointF(widget.mapToGlobal(position.toPoint()))
    moved = QMouseEvent(
        QEvent.Type.MouseMove, position, where, none, none, Qt.KeyboardModifier.NoModifier
    )
    QApplication.sendEvent(widget, moved)


def test_hovering_the_map_tells_everybody(qtbot, services, show):
    panel = FieldMapPanel(services)
    show(panel)
    position = panel.position_of("Circle central")
    assert position is not None
    point_at(panel, position)
    qtbot.waitUntil(lambda: services.state.hovered_class == "Circle central")
    point_at(panel, QPointF(1, 1))
    qtbot.waitUntil(lambda: services.state.hovered_class is None)


def test_the_map_shows_the_state_of_an_element(qtbot, services, cameras, show):
    panel = FieldMapPanel(services)
    show(panel)
    position = panel.position_of("Big rect. left main")
    beside = position.toPoint() + QPoint(0, 20)  # off the tick in the middle

    def colour() -> QColor:
        return panel.grab().toImage().pixelColor(beside)

    before = colour()
    services.camera_sources.load_cameras(cameras)
    qtbot.waitUntil(lambda: colour() != before)
    assert colour().green() > colour().red() + 60


# --- elements ----------------------------------------------------------------------------------


def _status(panel: ElementsPanel, class_name: str) -> tuple[str, str]:
    item = panel._items[class_name]
    return item.text(POINTS), item.text(STATUS)


def test_the_list_shows_points_and_status(qtbot, judged, show):
    panel = ElementsPanel(judged)
    show(panel)
    qtbot.waitUntil(lambda: _status(panel, PASSES)[1] == "passes")
    assert _status(panel, TOO_FAR)[1] == "too far"
    assert _status(panel, NOT_ANNOTATED) == ("", "not annotated")
    assert _status(panel, MISSED) == ("2", "missed")
    assert _status(panel, UNKNOWN) == ("1", "missed")
    assert "unknown classes" in panel._items[UNKNOWN].parent().text(NAME)
    assert "unknown" not in panel._items[UNKNOWN].text(NAME)  # that would take the name's room
    judged.navigator.next_frame()
    qtbot.waitUntil(lambda: UNKNOWN not in panel._items)
    assert _status(panel, PASSES) == ("", "")


def test_a_few_letters_and_enter_choose_an_element(qtbot, services, show):
    panel = ElementsPanel(services)
    show(panel)
    panel.focus_search()
    search = panel.findChild(QLineEdit, "elements_search")
    assert search is not None
    qtbot.keyClicks(search, "cen cir")
    with qtbot.waitSignal(panel.left):
        qtbot.keyClick(search, Qt.Key.Key_Return)
    assert services.state.selected_class == "Circle central"
    assert search.text() == ""
    qtbot.keyClicks(search, "xyz")
    assert panel.nothing.isVisible()
    assert "xyz" in panel.nothing.text()
    qtbot.keyClick(search, Qt.Key.Key_Return)
    assert services.state.selected_class == "Circle central"
    with qtbot.waitSignal(panel.left):
        qtbot.keyClick(search, Qt.Key.Key_Escape)
    assert not panel.nothing.isVisible()


def test_clicking_a_row_chooses_its_class(qtbot, services, show):
    panel = ElementsPanel(services)
    show(panel)
    rect = panel.tree.visualItemRect(panel._items["Big rect. left top"])
    qtbot.mouseClick(panel.tree.viewport(), Qt.MouseButton.LeftButton, pos=rect.center())
    assert services.state.selected_class == "Big rect. left top"
    services.selection.select_class("Circle right")
    qtbot.waitUntil(lambda: panel.tree.currentItem() is panel._items["Circle right"])


# --- cameras -----------------------------------------------------------------------------------


def test_loading_switching_and_removing_camera_sets(qtbot, services, cameras, show):
    services.live_fit.set_wanted(False)
    panel = CamerasPanel(services)
    show(panel)
    assert panel.empty.isVisible()
    panel.load(cameras)
    qtbot.waitUntil(lambda: panel.findChild(QLabel, "cameras_matched_0") is not None)
    matched = panel.findChild(QLabel, "cameras_matched_0")
    assert matched.text().startswith(("2 of 2", "1 of 2"))  # one is damaged, once it was read
    qtbot.waitUntil(lambda: matched.text() == "1 of 2, 1 unreadable")
    assert not panel.empty.isVisible()
    assert services.state.active_cameras is services.state.looks[0].cameras
    none = panel.findChild(QWidget, "cameras_none")
    qtbot.mouseClick(none, Qt.MouseButton.LeftButton, pos=QPoint(8, none.height() // 2))
    assert services.state.active_cameras is None
    remove = panel.findChild(QToolButton, "cameras_remove_0")
    remove.click()
    assert [look.cameras for look in services.state.looks] == []
    qtbot.waitUntil(panel.empty.isVisible)


def test_a_damaged_camera_is_told_where_it_is_used(qtbot, judged, show):
    panel, scores = CamerasPanel(judged), ScoresPanel(judged)
    show(panel)
    show(scores)
    assert not panel.error.isVisible()
    judged.navigator.next_frame()
    qtbot.waitUntil(panel.error.isVisible)
    assert "radial_distortion" in panel.error.text()
    qtbot.waitUntil(lambda: "radial_distortion" in scores.empty.text())


def test_the_protocol_is_chosen_here(qtbot, judged, show):
    panel, scores = CamerasPanel(judged), ScoresPanel(judged)
    show(panel)
    show(scores)
    combo = panel.findChild(QComboBox, "cameras_protocol")
    combo.setCurrentIndex(combo.findData("procc"))
    combo.activated.emit(combo.currentIndex())  # as choosing in its list does
    assert judged.state.setup.protocol == "procc"
    qtbot.waitUntil(lambda: scores.terms.text().startswith("procc"))


# --- scores ------------------------------------------------------------------------------------


def test_figures_stand_with_their_terms(qtbot, judged, show):
    panel = ScoresPanel(judged)
    show(panel)
    score = judged.scorer.score
    qtbot.waitUntil(lambda: panel.jac.text() == f"{score.jac:.3f}")
    assert panel.at_tau.text() == "JaC at 5.0 px"
    assert panel.terms.text().startswith("soccernet, 960x540\npoints: ")
    judged.evaluation.set_tau(30.0)
    later = judged.scorer.score
    qtbot.waitUntil(lambda: panel.at_tau.text() == "JaC at 30.0 px")
    assert panel.jac.text() == f"{later.jac:.3f}"
    assert later.jac > score.jac


def test_the_worst_element_is_first_and_a_click_flies_to_its_deciding_point(qtbot, judged, show):
    panel = ScoresPanel(judged)
    show(panel)
    qtbot.waitUntil(lambda: bool(panel.model.rows))
    names = [row.class_name for row in panel.model.rows]
    assert names[0] == TOO_FAR
    assert set(names[1:3]) == {MISSED, UNKNOWN}
    assert names[3] == NOT_ANNOTATED
    rect = panel.table.visualRect(panel.model.index(0, 0))
    with qtbot.waitSignal(judged.store.events.flyTo) as flown:
        qtbot.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, pos=rect.center())
    polyline = judged.state.annotation.get(TOO_FAR)
    target = polyline.points[1]
    assert flown.args == pytest.approx([target.u * 959, target.v * 539])
    assert judged.state.selection.point == (TOO_FAR, 1)
    rect = panel.table.visualRect(panel.model.index(3, 0))
    with qtbot.waitSignal(judged.store.events.flyTo) as flown:
        qtbot.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, pos=rect.center())
    x, y = flown.args
    assert 0 <= x <= 959
    assert 0 <= y <= 539


def test_without_camera_the_panel_says_what_to_do(qtbot, services, show):
    panel = ScoresPanel(services)
    show(panel)
    assert panel.empty.isVisible()
    assert "Load cameras" in panel.empty.text()


@pytest.mark.parametrize("name", field_names())
def test_titles_differ_where_a_narrow_list_cuts_their_middle(name):
    field = load_field(name)
    shown = short_titles(field)
    cut = {c: t if len(t) <= 20 else f"{t[:10]}…{t[-9:]}" for c, t in shown.items()}
    rows = [(element.group, cut[element.name]) for element in field.elements]
    assert sorted(rows) == sorted(set(rows))
