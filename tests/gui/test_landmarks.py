"""Landmarks in the window: named, clicked, placed, seen in the other views of the instant."""

import importlib.util
import json
import sys
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.landmarks.view_groups import groups_by_name, save_views
from procc_annotator.field.load import load_field
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.landmark_file import load_landmarks
from procc_annotator.gui.main_window import MainWindow
from tests.cli.conftest import camera_file
from tests.gui.conftest import Hand, let_work_end

ROOT = Path(__file__).parents[2]
CLOCK = (12.0, -52.0, -11.0)
CLOSE, LEFT, RIGHT = 0, 1, 2  # frames in natural order


@pytest.fixture
def match(tmp_path) -> Path:
    """Three views of one instant, six landmarks clicked in each; nothing known of them."""
    path = ROOT / "docs/examples/three_views.py"
    spec = importlib.util.spec_from_file_location("three_views", path)
    module = sys.modules["three_views"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    folder = tmp_path / "match"
    module.make_dataset(folder)
    save_views(folder / "views.csv", groups_by_name(module.CAMERAS, "{instant}_{view}"))
    return folder


@pytest.fixture
def seen(make_window, match, qtbot) -> MainWindow:
    window = make_window(match)
    window.panels.show("landmarks")
    qtbot.waitUntil(window.landmarks.name.isEnabled)
    return window


def rows(window: MainWindow) -> list[list[str]]:
    tree = window.landmarks.list
    items = [tree.topLevelItem(i) for i in range(tree.topLevelItemCount())]
    return [[item.text(column) for column in range(4)] for item in items if item is not None]


def name_landmark(window: MainWindow, name: str) -> None:
    window.landmarks.name.setFocus()
    QTest.keyClicks(window.landmarks.name, name)
    QTest.keyClick(window.landmarks.name, Qt.Key.Key_Return)


def press(button: object) -> None:
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def triangulated(window: MainWindow, qtbot: QtBot, name: str) -> None:
    name_landmark(window, name)
    qtbot.waitUntil(lambda: [row[3] for row in rows(window)] == ["3"])
    press(window.landmarks.triangulate)
    qtbot.waitUntil(lambda: rows(window)[-1][1] != "", timeout=20_000)


def test_a_named_landmark_is_placed_by_the_clicks_in_two_views(seen, match, qtbot):
    assert not seen.landmarks.empty.isHidden()
    triangulated(seen, qtbot, "Clock")
    (mark,) = load_landmarks(match / "landmarks.json").landmarks
    assert mark.position is not None
    assert np.abs(np.array(mark.position) - CLOCK).max() < 2
    assert (mark.surveyed, mark.frames) == (False, ("17_left", "17_right"))
    element = seen.services.state.field.element("Clock")
    assert element.is_spot
    assert seen.services.state.selected_class == "Clock"
    again = load_landmarks(match / "landmarks.json")
    assert again == seen.services.landmarks.file


def test_a_landmark_without_a_place_is_not_judged(seen, match):
    assert seen.services.camera_sources.load_cameras(match / "cameras")
    services = seen.services
    before = services.scorer.score.fn  # six classes that nobody knows
    name_landmark(seen, "Clock")
    assert services.scorer.score.fn == before - 1
    assert "Clock" in services.state.annotation.annotated
    assert "Clock" not in [element.name for element in services.scorer.score.elements]


def test_a_moving_landmark_is_explained_as_it_is_in_this_frame(make_window, dataset, qtbot):
    marks = [
        {"name": "ball", "title": "The ball", "moving": True},
        {"name": "ball", "position": [0, 200, 0], "instant": "t1"},  # behind the camera
    ]
    (dataset / "landmarks.json").write_text(json.dumps({"landmarks": marks}))
    (dataset / "views.csv").write_text("frame,instant,view\nframe_0,t1,main\n")
    (dataset / "frame_0.json").write_text(json.dumps({"ball": [{"x": 0.5, "y": 0.5}]}))
    (dataset / "cameras").mkdir()
    (dataset / "cameras" / "camera_frame_0.json").write_text(json.dumps(camera_file(0.0)))
    window = make_window(dataset)
    assert window.services.camera_sources.load_cameras(dataset / "cameras")
    window.services.evaluation.set_protocol(protocol="procc")
    window.panels.show("scores")

    def why() -> str:
        return next(
            (r.element.sentence for r in window.scores.model.rows if r.class_name == "ball"), ""
        )

    qtbot.waitUntil(lambda: why() != "")
    assert why().startswith("The ball is missed")
    assert "the camera does not show it" in why()


def test_a_landmark_shows_its_uncertainty_in_the_other_views(seen, match, qtbot):
    triangulated(seen, qtbot, "Clock")
    assert seen.services.camera_sources.load_cameras(match / "cameras")
    for frame in (LEFT, CLOSE):
        seen.services.navigator.go_to(frame)
        qtbot.waitUntil(lambda: len(seen.services.landmarks.ellipses.value or ()) == 1)
        (shown,) = seen.services.landmarks.ellipses.value
        drawn = seen.canvas.overlay_item.overlay.strokes
        assert any(stroke.colour == shown.colour and stroke.dash for stroke in drawn)
    assert shown.ellipse.semi_axes_px[0] > 8  # the close-up shows a decimetre as many pixels
    clicked = seen.services.state.annotation.get("Clock")
    click_px = np.array([clicked.points[0].u * 959, clicked.points[0].v * 539])
    assert np.hypot(*(shown.ellipse.centre_px - click_px)) < 20
    seen.services.blind_lock.set_blind(True)
    assert not seen.services.landmarks.ellipses.value


def test_the_other_views_are_a_click_away(seen, qtbot):
    panel = seen.landmarks
    assert seen.services.state.frame_index == CLOSE
    texts = [panel.views.item(i).text() for i in range(panel.views.count())]
    assert texts == ["left  (17_left)", "right  (17_right)"]
    item = panel.views.item(1)
    place = panel.views.visualItemRect(item).center()
    QTest.mouseClick(panel.views.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert seen.services.state.frame_index == RIGHT
    qtbot.waitUntil(lambda: panel.views.item(0).text() == "close  (17_close)")


def test_a_surveyed_place_is_kept_and_used(seen, match, qtbot, monkeypatch):
    name_landmark(seen, "Mast")
    qtbot.waitUntil(lambda: len(rows(seen)) == 1)
    panel = seen.landmarks
    qtbot.waitUntil(panel.place.isEnabled)
    for text, placed in (("14.5, -60", False), ("14.5, -60, -11", True)):
        panel.place.selectAll()
        QTest.keyClicks(panel.place, text)
        press(panel.survey)
        assert (seen.services.state.field.element("Mast") is not None) is placed
    assert "is no place" in seen.message_bar.label.text()
    (mark,) = load_landmarks(match / "landmarks.json").landmarks
    assert (mark.position, mark.surveyed) == ((14.5, -60.0, -11.0), True)
    panel.title.setFocus()
    panel.title.selectAll()
    QTest.keyClicks(panel.title, "The mast")
    QTest.keyClick(panel.title, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: rows(seen)[0][:2] == ["The mast", "14.50, -60.00, -11.00"])
    assert seen.services.state.field.title_of("Mast") == "The mast"
    monkeypatch.setattr("procc_annotator.gui.panels.landmarks.ask_to_delete", lambda *_: True)
    press(panel.remove)
    assert seen.services.state.field.element("Mast") is None
    assert json.loads((match / "landmarks.json").read_text()) == {"landmarks": []}
    assert "Mast" in seen.services.state.annotation.annotated  # clicks are nobody's to throw away


def test_a_surveyed_place_is_not_triangulated(seen, match, qtbot):
    name_landmark(seen, "Clock")
    panel, path = seen.landmarks, match / "landmarks.json"
    qtbot.waitUntil(panel.triangulate.isEnabled)
    assert "Find its place" in panel.triangulate.toolTip()
    assert seen.services.landmarks.survey("Clock", "14.5, -60, -11")
    qtbot.waitUntil(lambda: not panel.triangulate.isEnabled())
    assert "was surveyed" in panel.triangulate.toolTip()
    written = path.read_bytes()
    seen.services.landmarks.triangulation.start("Clock")
    assert not seen.services.landmarks.triangulation.working
    assert "Clock was surveyed" in seen.message_bar.label.text()
    assert path.read_bytes() == written


def test_a_place_surveyed_while_it_is_triangulated_stays(seen, match, qtbot):
    name_landmark(seen, "Clock")
    qtbot.waitUntil(seen.landmarks.triangulate.isEnabled)
    press(seen.landmarks.triangulate)
    assert seen.services.landmarks.triangulation.working == "Clock"
    entry = {"name": "Clock", "position": [14.5, -60.0, -11.0]}
    # Whole at once, as programs save: the window may read it at any moment.
    write_atomic(match / "landmarks.json", json.dumps({"landmarks": [entry]}).encode())
    qtbot.waitUntil(lambda: not seen.services.landmarks.triangulation.working, timeout=20_000)
    assert "Clock was surveyed" in seen.message_bar.label.text()
    assert json.loads((match / "landmarks.json").read_text()) == {"landmarks": [entry]}
    qtbot.waitUntil(lambda: rows(seen)[0][1] == "14.50, -60.00, -11.00")


@pytest.mark.parametrize("by_hand", [True, False])
def test_a_landmark_deleted_while_it_is_triangulated_stays_deleted(seen, match, qtbot, by_hand):
    name_landmark(seen, "Clock")
    qtbot.waitUntil(seen.landmarks.triangulate.isEnabled)
    press(seen.landmarks.triangulate)
    path = match / "landmarks.json"
    if by_hand:
        press(seen.landmarks.remove)
        assert not seen.services.landmarks.triangulation.working
    else:
        write_atomic(path, b'{"landmarks": []}')
    let_work_end(qtbot)
    assert load_landmarks(path).landmarks == ()
    assert ("deleted meanwhile" in seen.message_bar.label.text()) is not by_hand
    qtbot.waitUntil(lambda: rows(seen) == [])


def test_why_nothing_can_be_triangulated_is_said_where_one_looks(seen, qtbot):
    panel = seen.landmarks
    assert "no landmarks yet: Board, Clock, Mast, Seat A and 2 more" in panel.hint.text()
    assert panel.triangulate.toolTip() == panel.hint.text()
    name_landmark(seen, "Lamp")
    qtbot.waitUntil(lambda: "Lamp is clicked in no frame yet" in panel.hint.text())
    Hand(seen).draw("Lamp", (300, 200))
    qtbot.waitUntil(lambda: "Lamp is clicked in 17_close alone" in panel.hint.text())
    name_landmark(seen, "Clock")
    qtbot.waitUntil(panel.triangulate.isEnabled)
    assert panel.hint.isHidden()


def test_rows_that_name_no_frame_are_told_once(make_window, match, qtbot):
    path = match / "views.csv"
    good = path.read_text()
    path.write_text(f"{good}17_lefft,17,x\n99,2,\n")
    window = make_window(match)
    window.panels.show("landmarks")
    words = "line 5: there is neither a picture nor an annotation of '17_lefft'; did you mean"
    assert words in window.message_bar.label.text()
    assert "(and 1 more row like it)" in window.landmarks.note.text()
    window.message_bar.hide()
    (match / "landmarks.json").write_text('{"landmarks": [{"name": "Clock"}]}')
    qtbot.waitUntil(lambda: [row[0] for row in rows(window)] == ["Clock"])
    assert window.message_bar.isHidden()  # it was said
    path.write_text(f"{good}99,,\n")
    qtbot.waitUntil(lambda: "an annotation of '99'" in window.message_bar.label.text())
    path.write_text(good)
    qtbot.waitUntil(window.landmarks.note.isHidden)
    assert window.message_bar.isHidden()


def test_landmarks_are_back_once_the_field_knows_no_class_of_their_name(make_window, match, qtbot):
    window = make_window(match)
    clash = next(e.name for e in load_field("tennis").elements)
    window.services.field_choice.take(load_field("tennis"))
    entry = {"name": clash, "position": [12, -52, -11]}
    (match / "landmarks.json").write_text(json.dumps({"landmarks": [entry]}))
    assert window.services.opening.open_path(match)
    assert "are not used" in window.services.landmarks.problem
    window.services.field_choice.take(load_field("soccer"))
    qtbot.waitUntil(lambda: window.services.state.field.element(clash) is not None)
    assert window.services.landmarks.problem == ""
    assert [mark.name for mark in window.services.landmarks.entries] == [clash]


def test_views_are_counted_while_hands_click(seen, qtbot):
    name_landmark(seen, "Lamp")
    qtbot.waitUntil(lambda: rows(seen) == [["Lamp", "", "", "0"]])
    Hand(seen).draw("Lamp", (300, 200))
    qtbot.waitUntil(lambda: rows(seen)[0][3] == "1")
    seen.services.editing.undo()
    qtbot.waitUntil(lambda: rows(seen)[0][3] == "0")


def test_what_another_program_wrote_meanwhile_is_not_lost(seen, match, qtbot):
    name_landmark(seen, "Clock")
    entries = [{"name": "Clock"}, {"name": "Flag", "position": [52, -34, 0], "by": "hand"}]
    (match / "landmarks.json").write_text(json.dumps({"landmarks": entries}))
    name_landmark(seen, "Mast")
    kept = json.loads((match / "landmarks.json").read_text())["landmarks"]
    assert [entry["name"] for entry in kept] == ["Clock", "Flag", "Mast"]
    assert kept[1]["by"] == "hand"
    qtbot.waitUntil(lambda: [row[0] for row in rows(seen)] == ["Clock", "Flag", "Mast"])


def test_what_another_program_writes_is_shown_at_once(seen, match, qtbot):
    entries = [{"name": "Clock", "position": [12, -52, -11]}, {"name": "Mast"}]
    (match / "landmarks.json").write_text(json.dumps({"landmarks": entries}))
    qtbot.waitUntil(lambda: [row[0] for row in rows(seen)] == ["Clock", "Mast"])
    qtbot.waitUntil(lambda: [row[3] for row in rows(seen)] == ["3", "3"])
    assert seen.services.state.field.element("Clock") is not None
    assert seen.landmarks.views.count() == 2
    (match / "views.csv").unlink()
    qtbot.waitUntil(lambda: seen.landmarks.views.count() == 0)
    (match / "views.csv").write_text("frame,instant\n17_close,1\n17_left,1\n")
    qtbot.waitUntil(lambda: seen.landmarks.views.count() == 1)


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("landmarks.json", '{"landmarks": [{"name": 3}]}', "landmarks[0].name"),
        (
            "landmarks.json",
            '{"landmarks": [{"name": "Middle line"}]}',
            "has the name of a class of the field",
        ),
        ("views.csv", "frame\n17_close\n", "has no column 'instant'"),
    ],
)
def test_damage_by_another_program_is_told_and_the_last_good_stays(
    seen, match, qtbot, name, text, words
):
    name_landmark(seen, "Clock")
    assert seen.services.landmarks.survey("Clock", "12, -52, -11")
    good, path = (match / name).read_bytes(), match / name
    path.write_text(text)
    qtbot.waitUntil(lambda: words in seen.message_bar.label.text())
    qtbot.waitUntil(lambda: words in seen.landmarks.note.text())
    assert seen.services.state.field.element("Clock") is not None
    assert not seen.services.landmarks.remove("Clock")
    assert path.read_text() == text
    path.write_bytes(good)
    qtbot.waitUntil(seen.landmarks.note.isHidden)
    assert seen.message_bar.isHidden()
    assert seen.services.landmarks.remove("Clock")


def test_what_cannot_be_is_said(seen, match, qtbot):
    name_landmark(seen, "Middle line")
    assert "is a class of the field" in seen.message_bar.label.text()
    assert not (match / "landmarks.json").exists()


def test_a_damaged_file_is_told_and_never_written_over(make_window, match, qtbot):
    (match / "landmarks.json").write_text('{"landmarks": [{"name": 3}]}')
    window = make_window(match)
    window.panels.show("landmarks")
    qtbot.waitUntil(lambda: "landmarks[0].name" in window.landmarks.note.text())
    assert "landmarks[0].name" in window.message_bar.label.text()
    assert not window.landmarks.add.isEnabled()
    assert not window.services.landmarks.add("Clock")
    assert (match / "landmarks.json").read_text() == '{"landmarks": [{"name": 3}]}'


def test_the_landmarks_of_one_dataset_are_not_those_of_the_next(seen, dataset, qtbot):
    triangulated(seen, qtbot, "Clock")
    assert seen.services.opening.open_path(dataset)
    assert not seen.services.state.field.knows("Clock")
    qtbot.waitUntil(lambda: rows(seen) == [])


def test_a_place_is_not_deleted_unasked(seen, match, monkeypatch):
    panel, answers, told = seen.landmarks, [False, True], []
    asked: list[str] = []

    def answer(parent: object, what: str, lost: str) -> bool:
        asked.append(what)
        return answers[len(asked) - 1]

    monkeypatch.setattr("procc_annotator.gui.panels.landmarks.ask_to_delete", answer)
    seen.services.store.events.message.connect(lambda m: told.append(m.text))
    assert seen.services.landmarks.survey("Clock", "1, 2, -3")
    panel._refresh()
    panel.list.setCurrentItem(panel.list.topLevelItem(0))
    press(panel.remove)
    assert len(load_landmarks(match / "landmarks.json").landmarks) == 1
    press(panel.remove)
    assert load_landmarks(match / "landmarks.json").landmarks == ()
    assert asked == ["the landmark Clock"] * 2
    assert any("deleted the landmark Clock" in text for text in told)


def test_a_landmark_without_a_name_is_asked_for_one(seen):
    press(seen.landmarks.add)
    assert "needs a name" in seen.message_bar.label.text()
    assert seen.landmarks.name.hasFocus()
