"""The window as a whole: actions, panels, cameras, blind mode, settings."""

from __future__ import annotations

import json
import math
import shutil
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDockWidget, QPushButton
from pytestqt.qtbot import QtBot

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import LAYOUT, Settings
from procc_annotator.gui.theme import alarm_colours, palette
from procc_annotator.gui.window.key_dialogs import KeySheet
from procc_annotator.gui.window.status import MESSAGE_END
from procc_annotator.gui.window.tool_bar import IconButton
from procc_annotator.gui.window.welcome import RecentMenu
from procc_annotator.interaction.hints import SEPARATOR
from tests.gui.conftest import sheet_text

if TYPE_CHECKING:
    from tests.gui.conftest import Hand, MakeWindow, ReadPoints

# The offscreen platform has no window manager to pass these on to.
pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)

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
def cameras(tmp_path: Path) -> Path:
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
    def test_every_action_is_in_a_menu_and_on_the_sheet(self, window: MainWindow) -> None:
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
        for element in window.document.state.field.elements:
            assert element.title in text

    @pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
    def test_the_sheet_fits_the_window_and_can_be_searched(
        self, make_window: MakeWindow, dataset: Path, size: tuple[int, int]
    ) -> None:
        window = make_window(dataset, size=size)
        window.commands.show_keys()
        sheet = window.findChild(KeySheet, "keySheet")
        assert sheet is not None
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

    def test_no_two_actions_share_a_key(self, window: MainWindow) -> None:
        keys = [QKeySequence(k).toString() for spec in ACTIONS for k in spec.keys]
        keys += [
            QKeySequence(e.shortcut).toString()
            for e in window.document.state.field.elements
            if e.shortcut
        ]
        keys += ["X", "Space"]  # held down in the canvas
        assert [k for k, count in Counter(keys).items() if count > 1] == []

    def test_every_key_is_one_that_exists(self) -> None:
        for spec in ACTIONS:
            for keys in spec.keys:
                assert QKeySequence(keys).toString(), (spec.name, keys)

    def test_keys_of_the_field_choose_elements(self, window: MainWindow, qtbot: QtBot) -> None:
        for element in window.document.state.field.elements:
            if element.shortcut:
                combination = QKeySequence(element.shortcut)[0]
                QTest.keyClick(window.canvas, combination.key(), combination.keyboardModifiers())
                assert window.document.state.selected_class == element.name

    def test_q_and_e_step_through_the_elements(self, window: MainWindow) -> None:
        names = [e.name for e in window.document.state.field.elements]
        QTest.keyClick(window.canvas, Qt.Key.Key_E)
        assert window.document.state.selected_class == names[0]
        QTest.keyClick(window.canvas, Qt.Key.Key_E)
        QTest.keyClick(window.canvas, Qt.Key.Key_Q)
        assert window.document.state.selected_class == names[0]

    def test_letters_typed_into_a_search_box_are_text(self, window: MainWindow) -> None:
        QTest.keyClick(window.canvas, Qt.Key.Key_Slash)
        box = window.elements.search
        assert box.hasFocus()
        QTest.keyClicks(box, "bad")
        assert box.text() == "bad"
        assert not window.document.state.blind
        assert window.document.state.frame_index == 0


class TestCameras:
    def test_tau_decides_live_whether_an_element_passes(
        self, window: MainWindow, hand: Hand, cameras: Path
    ) -> None:
        window.document.selecting.set_option(
            "snapping", False
        )  # the digits on the pictures are white too
        hand.draw(MIDDLE, *middle_line_points(window, shift=4.0))
        assert window.document.camera_sources.load_cameras(cameras)
        score = window.document.judge.score
        assert score is not None
        largest = next(e.max_distance for e in score.elements if e.name == MIDDLE)
        assert 2.5 < largest < 5.0
        assert score.tp == 1
        jac = window.top_bar.camera_bar.jac.text()
        for _ in range(6):
            QTest.keyClick(window.canvas, Qt.Key.Key_Minus)
        assert window.document.state.tau == 2.0
        assert window.top_bar.camera_bar.tau.spin.value() == 2.0
        assert window.top_bar.camera_bar.tau.slider.value() == 20
        assert window.document.judge.score.tp == 0
        assert window.top_bar.camera_bar.jac.text() != jac
        QTest.keyClick(window.canvas, Qt.Key.Key_Plus)
        assert window.document.state.tau == 2.5
        window.top_bar.camera_bar.tau.slider.setValue(300)
        assert window.document.state.tau == 30.0
        assert window.document.judge.score.tp == 1

    def test_the_protocol_and_size_stand_beside_the_score(
        self, window: MainWindow, cameras: Path, qtbot: QtBot
    ) -> None:
        window.document.camera_sources.load_cameras(cameras)
        terms = window.top_bar.camera_bar.terms
        qtbot.waitUntil(lambda: terms.text() == "soccernet, 960x540")
        window.actions_["protocol_procc"].trigger()
        qtbot.waitUntil(lambda: terms.text() == "procc, 960x540")

    def test_the_cursor_is_shown_in_metres_on_the_field(
        self, window: MainWindow, hand: Hand, cameras: Path
    ) -> None:
        x, y = middle_line_points(window)[1]
        hand.move(x, y)
        assert window.status.metres.text() == ""
        window.document.camera_sources.load_cameras(cameras)
        hand.move(x + 3, y)
        hand.move(x, y)
        metres = [float(v) for v in window.status.metres.text().split()[:2]]
        assert metres == pytest.approx([0.0, 0.0], abs=0.5)

    def test_every_frame_of_the_set_gets_its_jac(
        self, window: MainWindow, hand: Hand, cameras: Path, qtbot: QtBot
    ) -> None:
        hand.draw(MIDDLE, *middle_line_points(window))
        window.document.camera_sources.load_cameras(cameras)
        qtbot.waitUntil(lambda: "frame_0" in window.document.auditing.frame_scores)
        qtbot.waitUntil(lambda: not window.document.set_scores.running)
        scores = window.document.auditing.frame_scores
        assert scores["frame_0"] == pytest.approx(window.document.judge.score.jac, abs=1e-6)
        assert "frame_1" not in scores  # not annotated
        window.document.walk.next_frame()
        hand.draw(MIDDLE, *middle_line_points(window))
        qtbot.waitUntil(lambda: window.document.auditing.frame_scores.get("frame_1", 0) > 0)

    def test_a_frame_without_camera_says_so(
        self, window: MainWindow, cameras: Path, qtbot: QtBot
    ) -> None:
        window.document.camera_sources.load_cameras(cameras)
        window.document.walk.go_to(2)
        qtbot.waitUntil(lambda: "no camera" in window.top_bar.camera_bar.jac.text())
        assert window.document.judge.score is None

    def test_a_file_that_is_no_camera_is_told_in_a_bar(
        self, window: MainWindow, tmp_path: Path
    ) -> None:
        bad = tmp_path / "bad"
        bad.mkdir()
        (bad / "camera_frame_0.json").write_text('{"pan_degrees": NaN}')
        window.document.camera_sources.load_cameras(bad)
        assert window.document.judge.score is None
        assert "camera_frame_0.json" in window.document.judge.shown.error
        assert window.document.camera_sources.load_cameras(tmp_path / "missing") is False
        assert "missing" in window.message_bar.label.text()

    def test_flying_to_a_point_brings_it_to_the_middle(self, window: MainWindow) -> None:
        window.document.store.events.flyTo.emit(500.0, 300.0)
        middle = QPointF(window.canvas.viewport().rect().center())
        assert window.canvas.to_picture(middle) == pytest.approx((500, 300), abs=1.0)
        assert window.canvas.view_scale >= 4.0


class TestBlindMode:
    def test_nothing_of_the_camera_shows_until_the_frame_is_committed(
        self, window: MainWindow, hand: Hand, cameras: Path, qtbot: QtBot
    ) -> None:
        hand.draw(MIDDLE, *middle_line_points(window))
        window.document.camera_sources.load_cameras(cameras)
        qtbot.waitUntil(lambda: "frame_0" in window.document.auditing.frame_scores)
        shown = strokes(window)
        hand.key(Qt.Key.Key_B)
        assert strokes(window) < shown
        assert window.document.judge.measurement is None
        assert "JaC 0" not in window.top_bar.camera_bar.jac.text()
        assert "frame_0" not in window.document.auditing.frame_scores
        hand.key(Qt.Key.Key_Return, CTRL)
        assert strokes(window) == shown
        assert "frame_0" in window.document.auditing.frame_scores
        hand.key(Qt.Key.Key_D)
        assert window.document.judge.measurement is None

    def test_committing_takes_a_draft_along(
        self, window: MainWindow, hand: Hand, cameras: Path
    ) -> None:
        hand.key(Qt.Key.Key_B)
        window.document.camera_sources.load_cameras(cameras)
        window.document.selecting.select_class(MIDDLE)
        for point in middle_line_points(window):
            hand.click(*point)
        hand.key(Qt.Key.Key_Return, CTRL)
        assert window.document.judge.score is not None
        assert window.document.judge.score.tp == 1


def strokes(window: MainWindow) -> int:
    return sum(len(s.segments) for s in window.canvas.overlay_item.overlay.strokes)


class TestWindow:
    def test_an_empty_window_says_what_to_do(self, make_window: MakeWindow) -> None:
        window = make_window()
        assert window.welcome.isVisible()
        assert not window.canvas.isVisible()
        assert window.top_bar.saved.text() == ""

    def test_bars_follow_a_change_of_theme(
        self, window: MainWindow, qapp: QApplication, qtbot: QtBot
    ) -> None:
        window.document.say("a warning", "warning")
        before = qapp.palette()
        try:
            qapp.setPalette(palette(dark=True))
            background, text = alarm_colours(palette(dark=True))
            qtbot.waitUntil(lambda: background in window.message_bar.styleSheet())
            assert text in window.message_bar.styleSheet()
        finally:
            qapp.setPalette(before)

    def test_jac_follows_a_file_that_was_read_again(
        self, make_window: MakeWindow, sample_data: Path, tmp_path: Path, qtbot: QtBot
    ) -> None:
        for name in ("00002.jpg", "00002.json"):
            shutil.copy(sample_data / name, tmp_path)
        window = make_window(tmp_path)
        document = window.document
        document.camera_sources.load_cameras(sample_data / "cameras" / "true")
        qtbot.waitUntil(lambda: document.auditing.frame_scores.get("00002", 0) > 0.5)
        (tmp_path / "00002.json").unlink()
        assert document.editing.begin_edit()  # looks at the file first
        assert document.state.annotation.annotated == ()
        qtbot.waitUntil(lambda: not document.auditing.frame_scores.get("00002"))

    def test_a_folder_of_folders_of_cameras_says_which_to_load(
        self, window: MainWindow, sample_data: Path
    ) -> None:
        assert not window.document.camera_sources.load_cameras(sample_data / "cameras")
        assert "bad, homography" in window.message_bar.label.text()
        assert [look.cameras for look in window.document.state.looks] == []

    def test_what_was_open_last_is_offered_to_go_on_with(
        self, make_window: MakeWindow, dataset: Path
    ) -> None:
        first = make_window()
        first.opening.open_path(dataset)
        first.document.walk.go_to(1)
        first.close()
        second = make_window()
        (button,) = second.welcome.findChildren(QPushButton, "welcomeRecent")
        assert button.text().startswith("dataset")
        button.click()
        assert second.document.state.frame_index == 1
        menu = second.findChild(RecentMenu)
        assert menu is not None
        menu.fill()
        assert [action.toolTip() for action in menu.actions()] == [str(dataset)]

    def test_a_path_that_does_not_exist_is_told_in_the_window(
        self, make_window: MakeWindow, tmp_path: Path
    ) -> None:
        window = make_window(tmp_path / "nowhere")
        assert window.message_bar.isVisible()
        assert "nowhere" in window.message_bar.label.text()

    def test_folders_dropped_are_opened_as_what_they_hold(
        self, make_window: MakeWindow, dataset: Path, cameras: Path
    ) -> None:
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
        assert len(window.document.state.workspace.frames) == 3
        assert window.document.state.active_cameras.name == "cameras"
        assert window.top_bar.camera_bar.cameras.currentText() == "cameras"

    def test_one_key_hides_all_panels_and_brings_them_back(self, window: MainWindow) -> None:
        docks = window.findChildren(QDockWidget)
        before = {d.objectName(): d.isHidden() for d in docks}
        QTest.keyClick(window.canvas, Qt.Key.Key_F11)
        assert all(d.isHidden() for d in docks)
        QTest.keyClick(window.canvas, Qt.Key.Key_F11)
        assert {d.objectName(): d.isHidden() for d in docks} == before

    def test_layout_and_settings_come_back(self, make_window: MakeWindow, dataset: Path) -> None:
        first = make_window(dataset)
        first.document.terms.set_tau(7.5)
        first.actions_["protocol_procc"].trigger()
        first.actions_["keep_zoom"].trigger()
        first.docks["frames"].close()
        first.close()
        second = make_window(dataset)
        assert second.document.state.tau == 7.5
        assert second.document.state.setup.protocol == "procc"
        assert second.actions_["protocol_procc"].isChecked()
        assert second.canvas.keep_zoom
        assert second.actions_["keep_zoom"].isChecked()
        assert second.docks["frames"].isHidden()

    def test_a_damaged_picture_stops_its_frame_only(
        self, make_window: MakeWindow, dataset: Path
    ) -> None:
        (dataset / "frame_0.png").write_bytes(b"not a picture")
        window = make_window(dataset)
        assert "frame_0.png" in window.frame_bar.label.text()
        window.document.walk.next_frame()
        assert not window.frame_bar.isVisible()

    @pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
    def test_nothing_of_the_bars_is_cut_off(
        self, make_window: MakeWindow, dataset: Path, cameras: Path, size: tuple[int, int]
    ) -> None:
        window = make_window(dataset, size=size, cameras=cameras)
        assert window.size().toTuple() == size
        bar = window.top_bar
        judged = bar.camera_bar
        for widget in (judged.tau, judged.cameras, judged.terms, bar.chip, bar.saved, bar.search):
            assert widget.isVisible()
            right = widget.mapTo(bar, QPoint(widget.width(), 0)).x()
            assert right <= bar.width()
            assert widget.width() >= widget.minimumSizeHint().width()
        for button in window.side_bar.findChildren(IconButton):
            assert button.isVisible()
            assert button.mapTo(window, QPoint(0, button.height())).y() <= window.height()


class TestExport:
    def test_annotations_and_scores_of_the_set(
        self, window: MainWindow, hand: Hand, cameras: Path, tmp_path: Path, qtbot: QtBot
    ) -> None:
        hand.draw(MIDDLE, *middle_line_points(window))
        window.document.camera_sources.load_cameras(cameras)
        out, scores = tmp_path / "out", tmp_path / "jac.json"
        window.exporter.write_annotations(out)
        window.exporter.write_scores(scores)
        qtbot.waitUntil(lambda: (out / "frame_0.json").exists() and scores.exists())
        dataset_file = window.document.state.frame.annotation_path
        assert json.loads((out / "frame_0.json").read_text()) == json.loads(
            dataset_file.read_text()
        )
        written = json.loads(scores.read_text())
        image = next(i for i in written["images"] if i["name"] == "frame_0")
        assert image["results"]["5"]["jac"] == window.document.judge.score.jac
        assert written["protocol"] == "soccernet"


class TestNotices:
    def test_what_is_left_out_of_a_dataset_is_said(
        self, make_window: MakeWindow, dataset: Path
    ) -> None:
        (dataset / "frame_0.jpg").write_bytes((dataset / "frame_0.png").read_bytes())
        window = make_window(dataset)
        assert "already is frame frame_0" in window.message_bar.label.text()

    def test_a_choice_between_two_cameras_of_a_frame_is_said(
        self, window: MainWindow, cameras: Path
    ) -> None:
        np.save(cameras / "frame_0.npy", np.eye(3))
        window.document.camera_sources.load_cameras(cameras)
        assert "has a JSON camera and a homography" in window.message_bar.label.text()

    def test_opening_another_dataset_keeps_the_polyline_under_way(
        self, window: MainWindow, hand: Hand, dataset: Path, saved: ReadPoints
    ) -> None:
        window.document.selecting.select_class("Middle line")
        clicked = [hand.click(100, 50), hand.click(120, 200)]
        window.opening.open_path(dataset)
        np.testing.assert_allclose(saved(), clicked, atol=1e-9)

    def test_ctrl_f_filters_the_frames_by_name(self, window: MainWindow, hand: Hand) -> None:
        hand.key(Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
        QTest.keyClicks(window.focusWidget(), "_2")
        assert window.frames.model.rowCount() == 1


@pytest.mark.new_window
@pytest.mark.parametrize("with_dataset", [False, True])
def test_panels_start_wide_enough_to_be_read(
    make_window: MakeWindow, dataset: Path, qtbot: QtBot, with_dataset: bool
) -> None:
    window = make_window(dataset if with_dataset else None)
    qtbot.waitUntil(lambda: window.docks["elements"].width() >= 280)
    assert window.docks["frames"].width() >= 200


def test_the_field_map_keeps_its_room_whatever_panel_is_opened(
    make_window: MakeWindow, annotated: Path, qtbot: QtBot
) -> None:
    window = make_window(annotated, size=(1280, 720))
    window.document.camera_sources.load_cameras(annotated / "cameras" / "bad")
    window.document.walk.go_to(1)
    qtbot.waitUntil(lambda: window.document.live_fit.result is not None, timeout=20_000)
    height = window.field_map.height()
    assert height >= 220
    for name in set(window.docks) - {"frames", "field_map"}:
        window.panels.show(name)
        QApplication.processEvents()
        assert window.field_map.height() == height, name
    assert window.height() == 720


def test_a_layout_of_another_version_is_dropped(make_window: MakeWindow, dataset: Path) -> None:
    first = make_window(dataset)
    first.docks["frames"].close()
    first.tabifyDockWidget(first.docks["elements"], first.docks["field_map"])
    first.close()
    Settings().set(LAYOUT, first.saveState(2))
    second = make_window(dataset)
    assert second.docks["frames"].isVisible()
    assert second.docks["agreement"].isHidden()
    assert second.docks["field_map"] not in second.tabifiedDockWidgets(second.docks["elements"])
    assert second.docks["findings"] in second.tabifiedDockWidgets(second.docks["elements"])


def test_keys_draw_again_after_a_click_in_the_list_of_frames(
    window: MainWindow, hand: Hand
) -> None:
    frames = window.frames.list
    place = frames.visualRect(window.frames.model.index(2, 0)).center()
    QTest.mouseClick(frames.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert window.document.state.frame_index == 2
    assert window.canvas.hasFocus()
    frames.setFocus()
    QTest.keyClick(frames, Qt.Key.Key_Up)  # arrows walk the list on
    assert window.document.state.frame_index == 1
    assert frames.hasFocus()
    QTest.keyClick(frames, Qt.Key.Key_Return)
    assert window.canvas.hasFocus()


def test_long_titles_of_elements_are_cut_in_their_middle(window: MainWindow) -> None:
    status, document = window.status, window.document
    title = (
        "Far touchline of the pitch that was repainted beside the old athletics track, number 20"
    )
    field = document.state.field
    far = replace(field.elements[field.index["Side line top"]], title=title)
    others = [e for e in field.elements if e.name != far.name]
    document.terms.set_field(replace(field, elements=(*others, far)))
    document.selecting.select_class(far.name)
    figures = [status.pixels.geometry(), status.metres.geometry()]
    for name in (title, "Near touchline"):
        status.tell(f"removed point 2 of {name}, 3 are left")
        QApplication.processEvents()
        shown = status.hint.text_for(status.hint.width())
        told, _, hint = shown.partition(MESSAGE_END)
        assert told.startswith("removed point 2 of ")
        assert told.endswith(", 3 are left")
        assert hint.startswith("DRAW Far touch")
        assert ", number 20  •  click begins it  •  Enter" in hint
        assert title not in shown
        assert title in status.hint.toolTip()
    assert [status.pixels.geometry(), status.metres.geometry()] == figures


def test_a_long_title_does_not_hide_how_to_go_on(window: MainWindow) -> None:
    hint = window.status.hint
    how = ["click begins it by hand", "Enter accepts 5 points", "Esc goes back", "Tab goes on"]
    title = "GHOST Right three-point far straight"
    hint.show_line("", SEPARATOR.join([title, *how, ". not visible here"]))
    width = hint.fontMetrics().horizontalAdvance(SEPARATOR.join(["GHOST Right…traight", *how, "…"]))
    shown = hint.text_for(width + 10)
    assert "Tab goes on" in shown
    assert shown.startswith("GHOST ")
    assert title not in shown
    assert hint.text_for(10 * width) == hint.text()


def test_a_panel_behind_another_tab_waits_until_it_is_looked_at(
    window: MainWindow, qtbot: QtBot
) -> None:
    protocol = window.cameras.protocol
    window.panels.show("cameras")
    qtbot.waitUntil(lambda: protocol.currentData() == "soccernet")
    window.panels.show("elements")
    window.document.terms.set_protocol("procc")
    qtbot.waitUntil(lambda: "procc" in window.top_bar.camera_bar.terms.text())
    QApplication.processEvents()
    assert protocol.currentData() == "soccernet"  # nobody sees it
    window.panels.show("cameras")
    qtbot.waitUntil(lambda: protocol.currentData() == "procc")
