"""The field map lies as the camera sees the field, and what is out of sight is faint."""

import math
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.maps import VisibleFieldRegion
from procc_annotator.image.top_view import GroundRaster, picture_on_ground
from procc_annotator.interaction.camera_view import visible_field

SIZE = (960, 540)


def camera(x: float, y: float, at: tuple[float, float], focal: float = 900.0) -> PinholeCamera:
    """15 m above a place, looking at one on the ground."""
    dx, dy = at[0] - x, at[1] - y
    return PinholeCamera(
        pan_rad=math.atan2(dx, -dy),
        tilt_rad=math.atan2(math.hypot(dx, dy), 15.0),
        roll_rad=0.0,
        position_world=(x, y, -15.0),
        focal_px=(focal, focal),
        principal_point_px=(479.5, 269.5),
    )


MAIN = camera(0, 60, (0, 0), 1500)
SIDES = (MAIN, camera(90, 5, (50, 0), 2000), camera(0, -60, (0, 0)), camera(-90, -5, (-50, 0)))


@pytest.fixture
def cameras(tmp_path) -> Path:
    """A main camera, and one behind the right goal; the third frame has none."""
    folder = tmp_path / "cameras"
    folder.mkdir()
    for i, one in enumerate(SIDES[:2]):
        (folder / f"camera_frame_{i}.json").write_bytes(write_camera(one))
    return folder


@pytest.fixture
def judged(make_window, dataset, cameras, qtbot) -> MainWindow:
    window = make_window(dataset)
    assert window.services.camera_sources.load_cameras(cameras)
    see(window, qtbot)
    return window


def see(window: MainWindow, qtbot: QtBot) -> VisibleFieldRegion:
    sight = window.services.visible_region
    qtbot.waitUntil(lambda: sight.shown is not None)
    return sight


@pytest.mark.parametrize(("turns", "seen_by"), list(enumerate(SIDES)))
def test_the_side_of_the_camera_is_told_by_any_model(turns, seen_by):
    field = load_field("soccer")
    ground = np.array([(0, 0, 0), (10, 0, 0), (0, 10, 0), (10, 10, 0.0)])
    px, shown = seen_by.project(ground)
    assert shown.all()
    matrix = cv2.getPerspectiveTransform(ground[:, :2].astype(np.float32), px.astype(np.float32))
    by_matrix = HomographyCamera.from_world_from_image(np.linalg.inv(matrix), SIZE)
    for one in (seen_by, by_matrix):
        found = visible_field(field, one, SIZE)
        assert found.turns == turns


def test_a_camera_that_pans_turns_no_map():
    field = load_field("soccer")
    for x in (-52.0, -20.0, 20.0, 52.0):
        found = visible_field(field, camera(0, 60, (x, 20.0)), SIZE)
        assert found.turns == 0


def test_a_camera_over_the_field_turns_it_by_what_is_right():
    field = load_field("soccer")
    found = visible_field(field, camera(20, 0, (45, 1)), SIZE)
    assert found.turns == 3


def test_left_on_the_map_is_left_in_the_picture(judged, qtbot):
    window, services = judged, judged.services
    field_map = window.field_map
    assert services.visible_region.turns == 0
    far, left = (field_map.to_widget(*at) for at in ((0, -30), (-30, 0)))
    middle = field_map.to_widget(0, 0)
    assert far.y() < middle.y()
    assert left.x() < middle.x()
    services.navigator.go_to(1)
    assert services.visible_region.shown is None  # not what the frame before had in sight
    qtbot.waitUntil(lambda: services.visible_region.turns == 1)
    # From behind the right goal its far side is the left one, and its own goal lies near.
    px, _ = SIDES[1].project(np.array([(40, 20, 0), (40, -20, 0), (48, 0, 0), (30, 0, 0.0)]))
    on_map = [field_map.to_widget(*at) for at in ((40, 20), (40, -20), (48, 0), (30, 0))]
    assert (px[0, 0] < px[1, 0]) == (on_map[0].x() < on_map[1].x())
    assert (px[2, 1] > px[3, 1]) == (on_map[2].y() > on_map[3].y())
    # Clicks mean what they hit.
    at = field_map.position_of("Goal right crossbar")
    qtbot.mouseClick(field_map, Qt.MouseButton.LeftButton, pos=at.toPoint())
    assert services.state.selected_class == "Goal right crossbar"
    services.navigator.go_to(2)  # without a camera: it stays turned, and nothing is out of sight
    qtbot.waitUntil(lambda: services.visible_region.shown is None)
    assert services.visible_region.turns == 1
    window.actions_["turn_map"].trigger()
    assert services.visible_region.turns == 0


class Texts:
    """A painter that keeps what is written where, and paints nothing."""

    def __init__(self) -> None:
        self.at: dict[str, Qt.AlignmentFlag] = {}

    def setPen(self, _: object) -> None: ...

    def drawText(self, _: object, edge: Qt.AlignmentFlag, text: str) -> None:
        self.at[text] = edge


def test_the_sides_of_a_turned_map_are_named(judged, qtbot):
    field_map, texts = judged.field_map, Texts()
    field_map._paint_sides(texts, field_map._placement())
    assert texts.at == {}  # seen from the main side nothing is turned
    judged.services.navigator.go_to(1)
    qtbot.waitUntil(lambda: judged.services.visible_region.turns == 1)
    field_map._paint_sides(texts, field_map._placement())
    left, far = field_map.to_widget(-50, 0), field_map.to_widget(0, -30)
    middle = field_map.to_widget(0, 0)
    assert bool(texts.at["left"] & Qt.AlignmentFlag.AlignTop) == (left.y() < middle.y() - 1)
    assert bool(texts.at["far"] & Qt.AlignmentFlag.AlignRight) == (far.x() > middle.x() + 1)


def test_what_is_out_of_sight_is_faint(judged, qtbot):
    field_map = judged.field_map
    field_map.resize(330, 300)

    def contrast(name: str) -> float:
        image = field_map.grab().toImage()
        at = field_map.position_of(name).toPoint()
        ground = image.pixelColor(at + QPoint(4, 4)).lightnessF()
        around = [at + QPoint(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1)]
        return max(abs(image.pixelColor(p).lightnessF() - ground) for p in around)

    assert contrast("Middle line") > 2 * contrast("Big rect. left main")
    judged.services.selection.select_class("Big rect. left main")
    assert contrast("Big rect. left main") > 0.2  # who asks for it sees it


def test_the_whole_field_is_always_in_sight(judged, qtbot):
    field_map = judged.field_map
    judged.services.navigator.go_to(1)  # from behind the right goal
    qtbot.waitUntil(lambda: judged.services.visible_region.turns == 1)
    for corner in ((-52.5, -34), (-52.5, 34), (52.5, -34), (52.5, 34)):
        assert field_map.rect().contains(field_map.to_widget(*corner).toPoint())


def test_the_picture_lies_on_the_map(judged, qtbot):
    """It is where the camera shows the ground; blind mode shows nothing of it."""
    services, field_map = judged.services, judged.field_map
    judged.actions_["top_view"].trigger()
    qtbot.waitUntil(lambda: services.top_view.value is not None)
    above = services.top_view.value
    white = np.full((540, 960, 4), 255, np.uint8)
    shown = services.visible_region.camera_on_screen()
    assert shown is not None
    field, camera, size = shown
    raster = GroundRaster.of(field, 8.0)
    _, seen = picture_on_ground(white, camera, size, raster)
    assert (above.image.width(), above.image.height()) == raster.size
    x, y = above.metres_from_px.map(above.image.width() / 2, above.image.height() / 2)
    assert (x, y) == pytest.approx((0, 0), abs=0.1)
    rows, columns = np.nonzero(seen)
    inside = int(len(rows) / 2)
    place = above.metres_from_px.map(float(columns[inside]), float(rows[inside]))
    with_picture = field_map.grab().toImage().pixelColor(field_map.to_widget(*place).toPoint())
    judged.actions_["top_view"].trigger()
    plain = field_map.grab().toImage().pixelColor(field_map.to_widget(*place).toPoint())
    assert with_picture != plain
    judged.actions_["top_view"].trigger()
    judged.actions_["blind"].trigger()
    assert services.top_view.value is None
