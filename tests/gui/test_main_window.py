"""The window as a whole: actions, panels, cameras, blind mode, settings."""

import json
import math
import shutil
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDockWidget, QPushButton

from procc_annotator.annotation import points_px
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import LAYOUT, Settings
from procc_annotator.gui.theme import alarm_colours, palette
from procc_annotator.gui.window.key_dialogs import KeySheet
from procc_annotator.gui.window.tool_bar import IconButton
from procc_annotator.gui.window.welcome import RecentMenu
from procc_annotator.gui.window.workspaces import WORKSPACES
from procc_annotator.interaction.hints import join_hint
from tests.gui.conftest import SIZE, sheet_text

MIDDLE = "Middle line"
CTRL = Qt.KeyboardModifier.ControlModifier
EVALUATION = (960, 540)
PICTURE = (640, 360)

CAMERA = PinholeCamera(
    pan_rad=0.0,
    tilt_rad=math.radians(75),
    roll_rad=0.0,
    position_world=(0.0, 60.0, -15.0),
    focal_px=(1000.0, 1000.0),
    principal_point_px=(480.0, 270.0),
)


@pytest.fixture
def cameras(tmp_path) -> Path:
    """Cameras of the first two frames; the third has none."""
    folder = tmp_path / "cameras"
    folder.mkdir()
    for i in range(2):
        (folder / f"camera_frame_{i}.json").write_bytes(write_camera(CAMERA))
    return folder


def middle_line_points(window: MainWindow, shift: float = 0.0) -> list[tuple[float, float]]:
    """Picture px on the projected middle line, moved aside by some evaluation px."""
    import numpy as np

    world = np.array([[0.0, y, 0.0] for y in (-20.0, 0.0, 15.0)])
    px, valid = CAMERA.project(world)
    assert valid.all()
    factor = (PICTURE[0] - 1) / (EVALUATION[0] - 1)
    return [((x + shift) * factor, y * (PICTURE[1] - 1) / (EVALUATION[1] - 1)) for x, y in px]


class TestActions:
    def test_every_action_is_in_a_menu_and_on_the_sheet(self, window):
        in_menus = [
            action.objectName()
            for menu in window.actions_.menus.values()
            for action in menu.actions()
        ]
        for spec in ACTIONS:
            assert f"action_{spec.name}" in in_menus, spec.name
        QTest.keyClick(window.canvas, Qt.Key.Key_F1)
        sheet = window.findChild(object, "keySheet")
        text = sheet_text(sheet)
        for spec in ACTIONS:
            assert spec.text.lstrip("-") in text
            for keys in spec.keys:
                assert QKeySequence(keys).toString(QKeySequence.SequenceFormat.NativeText) in text
        for element in window.services.state.field.elements:
            assert element.title in text

    @pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
    def test_the_sheet_fits_the_window_and_can_be_searched(self, make_window, dataset, size):
        window = make_window(dataset, size=size)
        window.commands.show_keys()
        sheet = window.findChild(KeySheet, "keySheet")
        QApplication.processEvents()
        assert sheet.width() < size[0]
        assert sheet.height() < size[1]
        assert not sheet.table.horizontalScrollBar().isVisible()  # nothing is cut at the side
        QTest.keyClicks(sheet.search, "Loupe z")
        assert sheet_text(sheet).splitlines()[0] == "Shift+Z\tLoupe"
        assert "Hold Z\tloupe" in sheet_text(sheet)
        assert "Undo" not in sheet_text(sheet)
        QTest.keyClicks(sheet.search, "qq")
        assert sheet.nothing.isVisible()
        assert "“Loupe zqq”" in sheet.nothing.text()
        sheet.search.clear()
        assert "Undo" in sheet_text(sheet)

    def test_every_key_is_one_that_exists(self):
        for spec in ACTIONS:
            for keys in spec.keys:
                assert QKeySequence(keys).toString(), (spec.name, keys)

    def test_keys_of_the_field_choose_elements(self, window, qtbot):
        for element in window.services.state.field.elements:
            if element.shortcut:
                combination = QKeySequence(element.shortcut)[0]
                QTest.keyClick(window.canvas, combination.key(), combination.keyboardModifiers())
                assert window.services.state.selected_class == element.name

    def test_q_and_e_step_through_the_elements(self, window):
        names = [e.name for e in window.services.state.field.elements]
        QTest.keyClick(window.canvas, Qt.Key.Key_E)
        assert window.services.state.selected_class == names[0]
        QTest.keyClick(window.canvas, Qt.Key.Key_E)
        QTest.keyClick(window.canvas, Qt.Key.Key_Q)
        assert window.services.state.selected_class == names[0]

    def test_letters_typed_into_a_search_box_are_text(self, window):
        QTest.keyClick(window.canvas, Qt.Key.Key_Slash)
        box = window.elements.search
        assert box.hasFocus()
        QTest.keyClicks(box, "bad")
        assert box.text() == "bad"
        assert not window.services.state.blind
        assert window.services.state.frame_index == 0


class TestCameras:
    def test_tau_decides_live_whether_an_element_passes(self, window, hand, cameras):
        window.services.selection.set_option(
            "snapping", False
        )  # the digits on the pictures are white too
        hand.draw(MIDDLE, *middle_line_points(window, shift=4.0))
        assert window.services.camera_sources.load_cameras(cameras)
        score = window.services.scorer.score
        largest = next(e.max_distance for e in score.elements if e.name == MIDDLE)
        assert 2.5 < largest < 5.0
        assert score.tp == 1
        jac = window.top_bar.camera_bar.jac.text()
        for _ in range(6):
            QTest.keyClick(window.canvas, Qt.Key.Key_Minus)
        assert window.services.state.tau == 2.0
        assert window.top_bar.camera_bar.tau.spin.value() == 2.0
        assert window.top_bar.camera_bar.tau.slider.value() == 20
        assert window.services.scorer.score.tp == 0
        QApplication.processEvents()
        assert window.top_bar.camera_bar.jac.text() != jac
        QTest.keyClick(window.canvas, Qt.Key.Key_Plus)
        assert window.services.state.tau == 2.5
        window.top_bar.camera_bar.tau.slider.setValue(300)
        assert window.services.state.tau == 30.0
        assert window.services.scorer.score.tp == 1

    def test_the_protocol_and_size_stand_beside_the_score(self, window, cameras, qtbot):
        window.services.camera_sources.load_cameras(cameras)
        terms = window.top_bar.camera_bar.terms
        qtbot.waitUntil(lambda: terms.text() == "soccernet, 960x540")
        window.actions_["protocol_procc"].trigger()
        qtbot.waitUntil(lambda: terms.text() == "procc, 960x540")

    def test_the_cursor_is_shown_in_metres_on_the_field(self, window, hand, cameras):
        x, y = middle_line_points(window)[1]
        hand.move(x, y)
        assert window.status.metres.text() == ""
        window.services.camera_sources.load_cameras(cameras)
        hand.move(x + 3, y)
        hand.move(x, y)
        metres = [float(v) for v in window.status.metres.text().split()[:2]]
        assert metres == pytest.approx([0.0, 0.0], abs=0.5)

    def test_every_frame_of_the_set_gets_its_jac(self, window, hand, cameras, qtbot):
        hand.draw(MIDDLE, *middle_line_points(window))
        window.services.camera_sources.load_cameras(cameras)
        qtbot.waitUntil(lambda: "frame_0" in window.services.scoring.frame_scores)
        qtbot.waitUntil(lambda: not window.services.scoring.running)
        scores = window.services.scoring.frame_scores
        assert scores["frame_0"] == pytest.approx(window.services.scorer.score.jac, abs=1e-6)
        assert "frame_1" not in scores  # not annotated
        window.services.navigator.next_frame()
        hand.draw(MIDDLE, *middle_line_points(window))
        qtbot.waitUntil(lambda: window.services.scoring.frame_scores.get("frame_1", 0) > 0)

    def test_a_frame_without_camera_says_so(self, window, cameras, qtbot):
        window.services.camera_sources.load_cameras(cameras)
        window.services.navigator.go_to(2)
        qtbot.waitUntil(lambda: "no camera" in window.top_bar.camera_bar.jac.text())
        assert window.services.scorer.score is None

    def test_a_file_that_is_no_camera_is_told_in_a_bar(self, window, tmp_path):
        bad = tmp_path / "bad"
        bad.mkdir()
        (bad / "camera_frame_0.json").write_text('{"pan_degrees": NaN}')
        window.services.camera_sources.load_cameras(bad)
        assert window.services.scorer.score is None
        assert "camera_frame_0.json" in window.services.scorer.shown.error
        assert window.services.camera_sources.load_cameras(tmp_path / "missing") is False
        assert "missing" in window.message_bar.label.text()

    def test_flying_to_a_point_brings_it_to_the_middle(self, window):
        window.services.store.events.flyTo.emit(500.0, 300.0)
        middle = QPointF(window.canvas.viewport().rect().center())
        assert window.canvas.to_picture(middle) == pytest.approx((500, 300), abs=1.0)
        assert window.canvas.view_scale >= 4.0


class TestBlindMode:
    def test_committing_takes_a_draft_along(self, window, hand, cameras):
        hand.key(Qt.Key.Key_B)
        window.services.camera_sources.load_cameras(cameras)
        window.services.selection.select_class(MIDDLE)
        for point in middle_line_points(window):
            hand.click(*point)
        hand.key(Qt.Key.Key_Return, CTRL)
        assert window.services.scorer.score.tp == 1


class TestWindow:
    def test_an_empty_window_says_what_to_do(self, make_window):
        window = make_window()
        assert window.welcome.isVisible()
        assert not window.canvas.isVisible()
        assert window.top_bar.saved.text() == ""

    def test_bars_follow_a_change_of_theme(self, window, qapp, qtbot):
        window.services.say("a warning", "warning")
        before = qapp.palette()
        try:
            qapp.setPalette(palette(dark=True))
            background, text = alarm_colours(palette(dark=True))
            qtbot.waitUntil(lambda: background in window.message_bar.styleSheet())
            assert text in window.message_bar.styleSheet()
        finally:
            qapp.setPalette(before)

    def test_jac_follows_a_file_that_was_read_again(
        self, make_window, sample_data, tmp_path, qtbot
    ):
        for name in ("00002.jpg", "00002.json"):
            shutil.copy(sample_data / name, tmp_path)
        window = make_window(tmp_path)
        services = window.services
        services.camera_sources.load_cameras(sample_data / "cameras" / "true")
        qtbot.waitUntil(lambda: services.scoring.frame_scores.get("00002", 0) > 0.5)
        (tmp_path / "00002.json").unlink()
        assert services.editing.begin_edit()  # looks at the file first
        assert services.state.annotation.annotated == ()
        qtbot.waitUntil(lambda: not services.scoring.frame_scores.get("00002"))

    def test_a_folder_of_folders_of_cameras_says_which_to_load(self, window, sample_data):
        assert not window.services.camera_sources.load_cameras(sample_data / "cameras")
        assert "bad, homography" in window.message_bar.label.text()
        assert [look.cameras for look in window.services.state.looks] == []

    def test_what_was_open_last_is_offered_to_go_on_with(self, make_window, dataset):
        first = make_window()
        first.opening.open_path(dataset)
        first.services.navigator.go_to(1)
        first.close()
        second = make_window()
        (button,) = second.welcome.findChildren(QPushButton, "welcomeRecent")
        assert button.text().startswith("dataset")
        button.click()
        assert second.services.state.frame_index == 1
        menu = second.findChild(RecentMenu)
        menu.fill()
        assert [action.toolTip() for action in menu.actions()] == [str(dataset)]

    def test_a_path_that_does_not_exist_is_told_in_the_window(self, make_window, tmp_path):
        window = make_window(tmp_path / "nowhere")
        assert window.message_bar.isVisible()
        assert "nowhere" in window.message_bar.label.text()

    def test_folders_dropped_are_opened_as_what_they_hold(self, make_window, dataset, cameras):
        window = make_window()
        for folder in (dataset, cameras):
            data = QMimeData()
            data.setUrls([QUrl.fromLocalFile(str(folder))])
            event = QDropEvent(
                QPointF(5, 5),
                Qt.DropAction.CopyAction,
                data,
                Qt.MouseButton.LeftButton,
                Qt.KeyboardModifier.NoModifier,
            )
            window.dropEvent(event)
        assert window.canvas.isVisible()
        assert len(window.services.state.workspace.frames) == 3
        assert window.services.state.active_cameras.name == "cameras"
        assert window.top_bar.camera_bar.cameras.currentText() == "cameras"

    def test_one_key_hides_all_panels_and_brings_them_back(self, window):
        docks = window.findChildren(QDockWidget)
        before = {d.objectName(): d.isHidden() for d in docks}
        QTest.keyClick(window.canvas, Qt.Key.Key_F11)
        assert all(d.isHidden() for d in docks)
        QTest.keyClick(window.canvas, Qt.Key.Key_F11)
        assert {d.objectName(): d.isHidden() for d in docks} == before

    def test_layout_and_settings_come_back(self, make_window, dataset):
        first = make_window(dataset)
        first.services.evaluation.set_tau(7.5)
        first.actions_["protocol_procc"].trigger()
        first.actions_["keep_zoom"].trigger()
        first.docks["frames"].close()
        first.close()
        second = make_window(dataset)
        assert second.services.state.tau == 7.5
        assert second.services.state.setup.protocol == "procc"
        assert second.actions_["protocol_procc"].isChecked()
        assert second.canvas.keep_zoom
        assert second.actions_["keep_zoom"].isChecked()
        assert second.docks["frames"].isHidden()

    def test_a_damaged_picture_stops_its_frame_only(self, make_window, dataset):
        (dataset / "frame_0.png").write_bytes(b"not a picture")
        window = make_window(dataset)
        assert "frame_0.png" in window.frame_bar.label.text()
        window.services.navigator.next_frame()
        assert not window.frame_bar.isVisible()

    @pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
    def test_nothing_of_the_bars_is_cut_off(self, make_window, dataset, cameras, size):
        window = make_window(dataset, size=size, cameras=cameras)
        window.panels.turn_to("judge")
        QApplication.processEvents()
        assert window.size().toTuple() == size
        bar = window.top_bar
        judged = bar.camera_bar
        for widget in (judged.tau, judged.cameras, judged.terms, bar.chip, bar.saved, bar.search):
            assert widget.isVisible()
            around = widget.parentWidget()
            assert around.rect().contains(widget.geometry())
            assert widget.width() >= widget.minimumSizeHint().width()
        for button in window.side_bar.findChildren(IconButton):
            assert button.isVisible()
            assert button.mapTo(window, QPoint(0, button.height())).y() <= window.height()


class TestExport:
    def test_annotations_and_scores_of_the_set(self, window, hand, cameras, tmp_path, qtbot):
        hand.draw(MIDDLE, *middle_line_points(window))
        window.services.camera_sources.load_cameras(cameras)
        out, scores = tmp_path / "out", tmp_path / "jac.json"
        window.exporter.write_annotations(out)
        window.exporter.write_scores(scores)
        qtbot.waitUntil(lambda: (out / "frame_0.json").exists() and scores.exists())
        dataset_file = window.services.state.frame.annotation_path
        assert json.loads((out / "frame_0.json").read_text()) == json.loads(
            dataset_file.read_text()
        )
        written = json.loads(scores.read_text())
        image = next(i for i in written["images"] if i["name"] == "frame_0")
        assert image["results"]["5"]["jac"] == window.services.scorer.score.jac
        assert written["protocol"] == "soccernet"


class TestNotices:
    def test_what_is_left_out_of_a_dataset_is_said(self, make_window, dataset):
        (dataset / "frame_0.jpg").write_bytes((dataset / "frame_0.png").read_bytes())
        window = make_window(dataset)
        assert "already is frame frame_0" in window.message_bar.label.text()

    def test_a_choice_between_two_cameras_of_a_frame_is_said(self, window, cameras):
        np.save(cameras / "frame_0.npy", np.eye(3))
        window.services.camera_sources.load_cameras(cameras)
        assert "has a JSON camera and a homography" in window.message_bar.label.text()

    def test_opening_another_dataset_keeps_the_polyline_under_way(self, window, hand, dataset):
        window.services.selection.select_class("Middle line")
        clicked = [hand.click(100, 50), hand.click(120, 200)]
        window.opening.open_path(dataset)
        kept = window.services.state.annotation.get_unconfirmed("Middle line")
        np.testing.assert_allclose(points_px(kept, SIZE), clicked, atol=1e-9)

    def test_ctrl_f_filters_the_frames_by_name(self, window, hand):
        hand.key(Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
        QTest.keyClicks(window.focusWidget(), "_2")
        assert window.frames.model.rowCount() == 1


@pytest.mark.new_window
@pytest.mark.parametrize("with_dataset", [False, True])
def test_panels_start_wide_enough_to_be_read(make_window, dataset, qtbot, with_dataset):
    window = make_window(dataset if with_dataset else None)
    qtbot.waitUntil(lambda: window.docks["elements"].width() >= 220)
    window.panels.turn_to("review")
    qtbot.waitUntil(lambda: window.docks["frames"].width() >= 200)


def test_the_field_map_keeps_its_room_whatever_panel_is_opened(make_window, annotated, qtbot):
    window = make_window(annotated, size=(1280, 720))
    window.services.camera_sources.load_cameras(annotated / "cameras" / "bad")
    window.services.navigator.go_to(1)
    qtbot.waitUntil(lambda: window.services.live_fit.result is not None)
    for names in WORKSPACES.values():
        heights = set()
        for name in names:
            window.panels.show(name)
            QApplication.processEvents()
            heights.add(window.field_map.height())
        assert len(heights) == 1, names
        assert min(heights) >= 150
    assert window.height() == 720


def test_a_layout_of_another_version_is_dropped(make_window, dataset):
    first = make_window(dataset)
    first.docks["findings"].close()
    first.tabifyDockWidget(first.docks["elements"], first.docks["field_map"])
    first.close()
    Settings().set(LAYOUT, first.saveState(2))
    second = make_window(dataset)
    assert second.docks["frames"].isHidden()
    assert second.docks["agreement"].isHidden()
    assert second.docks["field_map"] not in second.tabifiedDockWidgets(second.docks["elements"])
    assert second.docks["findings"] in second.tabifiedDockWidgets(second.docks["elements"])


def test_keys_draw_again_after_a_click_in_the_list_of_frames(window, hand):
    frames = window.frames.list
    place = frames.visualRect(window.frames.model.index(2, 0)).center()
    QTest.mouseClick(frames.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert window.services.state.frame_index == 2
    assert window.canvas.hasFocus()
    frames.setFocus()
    QTest.keyClick(frames, Qt.Key.Key_Up)  # arrows walk the list on
    assert window.services.state.frame_index == 1
    assert frames.hasFocus()
    QTest.keyClick(frames, Qt.Key.Key_Return)
    assert window.canvas.hasFocus()


def test_a_narrow_hint_leaves_out_whole_keys(window):
    hint = window.status.hint
    click, keys = ("DRAW Halfway line", "click adds a point"), ("Enter finishes", "Esc cancels")
    texts = [join_hint(click, keys[:count]) for count in range(3)]
    hint.show_line("", texts[-1])
    for text in texts:
        assert hint.text_for(hint.fontMetrics().horizontalAdvance(text) + 2) == text
    figures = [window.status.pixels.geometry(), window.status.metres.geometry()]
    window.status.tell("removed point 2 of Near touchline, 3 are left " * 4)
    QApplication.processEvents()
    assert [window.status.pixels.geometry(), window.status.metres.geometry()] == figures


def test_a_panel_behind_another_tab_waits_until_it_is_looked_at(window, qtbot):
    protocol = window.cameras.protocol
    window.panels.show("cameras")
    qtbot.waitUntil(lambda: protocol.currentData() == "soccernet")
    window.panels.show("elements")
    window.services.evaluation.set_protocol("procc")
    qtbot.waitUntil(lambda: "procc" in window.top_bar.camera_bar.terms.text())
    QApplication.processEvents()
    assert protocol.currentData() == "soccernet"  # nobody sees it
    window.panels.show("cameras")
    qtbot.waitUntil(lambda: protocol.currentData() == "procc")
