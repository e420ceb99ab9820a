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
from procc_annotator.gui.panels.landmarks import LandmarksPanel
from procc_annotator.gui.panels.scores import ScoresPanel
from procc_annotator.gui.state.services import Services
from tests.cli.conftest import camera_file
from tests.gui.conftest import draw, let_work_end

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
def services(open_services, match) -> Services:
    return open_services(match)


@pytest.fixture
def panel(services, show, qtbot) -> LandmarksPanel:
    panel = show(LandmarksPanel(services))
    qtbot.waitUntil(panel.name.isEnabled)
    return panel


def rows(panel: LandmarksPanel) -> list[list[str]]:
    tree = panel.list
    items = [tree.topLevelItem(i) for i in range(tree.topLevelItemCount())]
    return [[item.text(column) for column in range(4)] for item in items if item is not None]


def name_landmark(panel: LandmarksPanel, name: str) -> None:
    panel.name.setFocus()
    QTest.keyClicks(panel.name, name)
    QTest.keyClick(panel.name, Qt.Key.Key_Return)


def press(button: object) -> None:
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def triangulated(panel: LandmarksPanel, qtbot: QtBot, name: str) -> None:
    name_landmark(panel, name)
    qtbot.waitUntil(lambda: [row[3] for row in rows(panel)] == ["3"])
    press(panel.triangulate)
    qtbot.waitUntil(lambda: rows(panel)[-1][1] != "")


def test_a_named_landmark_is_placed_by_the_clicks_in_two_views(panel, services, match, qtbot):
    assert not panel.empty.isHidden()
    triangulated(panel, qtbot, "Clock")
    (mark,) = load_landmarks(match / "landmarks.json").landmarks
    assert mark.position is not None
    assert np.abs(np.array(mark.position) - CLOCK).max() < 2
    assert (mark.surveyed, mark.frames) == (False, ("17_left", "17_right"))
    element = services.state.field.element("Clock")
    assert element.is_spot
    assert services.state.selected_class == "Clock"
    again = load_landmarks(match / "landmarks.json")
    assert again == services.landmarks.file


def test_a_landmark_without_a_place_is_not_judged(panel, services, match):
    assert services.camera_sources.load_cameras(match / "cameras")
    before = services.scorer.score.fn  # six classes that nobody knows
    name_landmark(panel, "Clock")
    assert services.scorer.score.fn == before - 1
    assert "Clock" in services.state.annotation.annotated
    assert "Clock" not in [element.name for element in services.scorer.score.elements]


def test_a_moving_landmark_is_explained_as_it_is_in_this_frame(show, open_services, dataset, qtbot):
    marks = [
        {"name": "ball", "title": "The ball", "moving": True},
        {"name": "ball", "position": [0, 200, 0], "instant": "t1"},  # behind the camera
    ]
    (dataset / "landmarks.json").write_text(json.dumps({"landmarks": marks}))
    (dataset / "views.csv").write_text("frame,instant,view\nframe_0,t1,main\n")
    (dataset / "frame_0.json").write_text(json.dumps({"ball": [{"x": 0.5, "y": 0.5}]}))
    (dataset / "cameras").mkdir()
    (dataset / "cameras" / "camera_frame_0.json").write_text(json.dumps(camera_file(0.0)))
    services = open_services(dataset)
    assert services.camera_sources.load_cameras(dataset / "cameras")
    services.evaluation.set_protocol(protocol="procc")
    scores = show(ScoresPanel(services))

    def why() -> str:
        return next((r.element.sentence for r in scores.model.rows if r.class_name == "ball"), "")

    qtbot.waitUntil(lambda: why() != "")
    assert why().startswith("The ball is missed")
    assert "the camera does not show it" in why()


def test_a_landmark_shows_its_uncertainty_in_the_other_views(panel, services, match, qtbot):
    triangulated(panel, qtbot, "Clock")
    assert services.camera_sources.load_cameras(match / "cameras")
    for frame in (LEFT, CLOSE):
        services.navigator.go_to(frame)
        qtbot.waitUntil(lambda: len(services.landmarks.ellipses.value or ()) == 1)
        (shown,) = services.landmarks.ellipses.value
    assert shown.ellipse.semi_axes_px[0] > 8  # the close-up shows a decimetre as many pixels
    clicked = services.state.annotation.get("Clock")
    click_px = np.array([clicked.points[0].u * 959, clicked.points[0].v * 539])
    assert np.hypot(*(shown.ellipse.centre_px - click_px)) < 20
    services.blind_lock.set_blind(True)
    assert services.landmarks.ellipses.value is None


def test_its_uncertainty_is_drawn_over_the_picture(make_window, match, qtbot):
    window = make_window(match)
    services, landmarks = window.services, window.services.landmarks
    assert services.camera_sources.load_cameras(match / "cameras")
    assert landmarks.add("Clock")
    qtbot.waitUntil(lambda: landmarks.frames_with("Clock") is not None)
    landmarks.triangulation.start("Clock")
    services.navigator.go_to(LEFT)
    qtbot.waitUntil(lambda: len(landmarks.ellipses.value or ()) == 1)
    drawn = window.canvas.overlay_item.overlay.strokes
    assert any(
        stroke.colour == landmarks.ellipses.value[0].colour and stroke.dash for stroke in drawn
    )


def test_the_other_views_are_a_click_away(panel, services, qtbot):
    assert services.state.frame_index == CLOSE
    texts = [panel.views.item(i).text() for i in range(panel.views.count())]
    assert texts == ["left  (17_left)", "right  (17_right)"]
    item = panel.views.item(1)
    place = panel.views.visualItemRect(item).center()
    QTest.mouseClick(panel.views.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert services.state.frame_index == RIGHT
    qtbot.waitUntil(lambda: panel.views.item(0).text() == "close  (17_close)")


def test_a_surveyed_place_is_kept_and_used(said, panel, services, match, qtbot, monkeypatch):
    name_landmark(panel, "Mast")
    qtbot.waitUntil(lambda: len(rows(panel)) == 1)
    qtbot.waitUntil(panel.place.isEnabled)
    for text, placed in (("14.5, -60", False), ("14.5, -60, -11", True)):
        panel.place.selectAll()
        QTest.keyClicks(panel.place, text)
        press(panel.survey)
        assert (services.state.field.element("Mast") is not None) is placed
    assert "is no place" in said[-1]
    (mark,) = load_landmarks(match / "landmarks.json").landmarks
    assert (mark.position, mark.surveyed) == ((14.5, -60.0, -11.0), True)
    panel.title.setFocus()
    panel.title.selectAll()
    QTest.keyClicks(panel.title, "The mast")
    QTest.keyClick(panel.title, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: rows(panel)[0][:2] == ["The mast", "14.50, -60.00, -11.00"])
    assert services.state.field.title_of("Mast") == "The mast"
    monkeypatch.setattr("procc_annotator.gui.panels.landmarks.ask_to_delete", lambda *_: True)
    press(panel.remove)
    assert services.state.field.element("Mast") is None
    assert json.loads((match / "landmarks.json").read_text()) == {"landmarks": []}
    assert "Mast" in services.state.annotation.annotated  # clicks are nobody's to throw away


def test_a_surveyed_place_is_not_triangulated(said, services, panel, match, qtbot):
    name_landmark(panel, "Clock")
    path = match / "landmarks.json"
    qtbot.waitUntil(panel.triangulate.isEnabled)
    assert "Find its place" in panel.triangulate.toolTip()
    assert services.landmarks.survey("Clock", "14.5, -60, -11")
    qtbot.waitUntil(lambda: not panel.triangulate.isEnabled())
    assert "was surveyed" in panel.triangulate.toolTip()
    written = path.read_bytes()
    services.landmarks.triangulation.start("Clock")
    assert not services.landmarks.triangulation.working
    assert "Clock was surveyed" in said[-1]
    assert path.read_bytes() == written


def test_a_place_surveyed_while_it_is_triangulated_stays(said, panel, services, match, qtbot):
    name_landmark(panel, "Clock")
    qtbot.waitUntil(panel.triangulate.isEnabled)
    press(panel.triangulate)
    assert services.landmarks.triangulation.working == "Clock"
    entry = {"name": "Clock", "position": [14.5, -60.0, -11.0]}
    # Whole at once, as programs save: the window may read it at any moment.
    write_atomic(match / "landmarks.json", json.dumps({"landmarks": [entry]}).encode())
    qtbot.waitUntil(lambda: not services.landmarks.triangulation.working)
    assert "Clock was surveyed" in said[-1]
    assert json.loads((match / "landmarks.json").read_text()) == {"landmarks": [entry]}
    qtbot.waitUntil(lambda: rows(panel)[0][1] == "14.50, -60.00, -11.00")


@pytest.mark.parametrize("by_hand", [True, False])
def test_a_landmark_deleted_while_it_is_triangulated_stays_deleted(
    said, panel, services, match, qtbot, by_hand
):
    name_landmark(panel, "Clock")
    qtbot.waitUntil(panel.triangulate.isEnabled)
    press(panel.triangulate)
    path = match / "landmarks.json"
    if by_hand:
        press(panel.remove)
        assert not services.landmarks.triangulation.working
    else:
        write_atomic(path, b'{"landmarks": []}')
    let_work_end(qtbot)
    assert load_landmarks(path).landmarks == ()
    assert ("deleted meanwhile" in said[-1]) is not by_hand
    qtbot.waitUntil(lambda: rows(panel) == [])


def test_why_nothing_can_be_triangulated_is_said_where_one_looks(panel, services, qtbot):
    assert "no landmarks yet: Board, Clock, Mast, Seat A and 2 more" in panel.hint.text()
    assert panel.triangulate.toolTip() == panel.hint.text()
    name_landmark(panel, "Lamp")
    qtbot.waitUntil(lambda: "Lamp is clicked in no frame yet" in panel.hint.text())
    draw(services, "Lamp", (0.3, 0.4))
    qtbot.waitUntil(lambda: "Lamp is clicked in 17_close alone" in panel.hint.text())
    name_landmark(panel, "Clock")
    qtbot.waitUntil(panel.triangulate.isEnabled)
    assert panel.hint.isHidden()


def test_rows_that_name_no_frame_are_told_once(services, said, panel, match, qtbot):
    path = match / "views.csv"
    good = path.read_text()
    path.write_text(f"{good}17_lefft,17,x\n99,2,\n")
    words = "line 5: there is neither a picture nor an annotation of '17_lefft'; did you mean"
    qtbot.waitUntil(lambda: any(words in text for text in said))
    qtbot.waitUntil(lambda: "(and 1 more row like it)" in panel.note.text())
    (match / "landmarks.json").write_text('{"landmarks": [{"name": "Clock"}]}')
    qtbot.waitUntil(lambda: [row[0] for row in rows(panel)] == ["Clock"])
    assert len(said) == 1
    path.write_text(f"{good}99,,\n")
    qtbot.waitUntil(lambda: "an annotation of '99'" in said[-1])
    path.write_text(good)
    qtbot.waitUntil(panel.note.isHidden)
    assert not services.state.notices


def test_landmarks_are_back_once_the_field_knows_no_class_of_their_name(services, match, qtbot):
    clash = next(e.name for e in load_field("tennis").elements)
    services.field_choice.take(load_field("tennis"))
    entry = {"name": clash, "position": [12, -52, -11]}
    (match / "landmarks.json").write_text(json.dumps({"landmarks": [entry]}))
    assert services.opening.open_path(match)
    assert "are not used" in services.landmarks.problem
    services.field_choice.take(load_field("soccer"))
    qtbot.waitUntil(lambda: services.state.field.element(clash) is not None)
    assert services.landmarks.problem == ""
    assert [mark.name for mark in services.landmarks.entries] == [clash]


def test_views_are_counted_while_hands_click(panel, services, qtbot):
    name_landmark(panel, "Lamp")
    qtbot.waitUntil(lambda: rows(panel) == [["Lamp", "", "", "0"]])
    draw(services, "Lamp", (0.3, 0.4))
    qtbot.waitUntil(lambda: rows(panel)[0][3] == "1")
    services.editing.undo()
    qtbot.waitUntil(lambda: rows(panel)[0][3] == "0")


def test_what_another_program_wrote_meanwhile_is_not_lost(panel, services, match, qtbot):
    name_landmark(panel, "Clock")
    entries = [{"name": "Clock"}, {"name": "Flag", "position": [52, -34, 0], "by": "hand"}]
    (match / "landmarks.json").write_text(json.dumps({"landmarks": entries}))
    name_landmark(panel, "Mast")
    kept = json.loads((match / "landmarks.json").read_text())["landmarks"]
    assert [entry["name"] for entry in kept] == ["Clock", "Flag", "Mast"]
    assert kept[1]["by"] == "hand"
    qtbot.waitUntil(lambda: [row[0] for row in rows(panel)] == ["Clock", "Flag", "Mast"])


def test_what_another_program_writes_is_shown_at_once(panel, services, match, qtbot):
    entries = [{"name": "Clock", "position": [12, -52, -11]}, {"name": "Mast"}]
    (match / "landmarks.json").write_text(json.dumps({"landmarks": entries}))
    qtbot.waitUntil(lambda: [row[0] for row in rows(panel)] == ["Clock", "Mast"])
    qtbot.waitUntil(lambda: [row[3] for row in rows(panel)] == ["3", "3"])
    assert services.state.field.element("Clock") is not None
    assert panel.views.count() == 2
    (match / "views.csv").unlink()
    qtbot.waitUntil(lambda: panel.views.count() == 0)
    (match / "views.csv").write_text("frame,instant\n17_close,1\n17_left,1\n")
    qtbot.waitUntil(lambda: panel.views.count() == 1)


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
    said, panel, services, match, qtbot, name, text, words
):
    name_landmark(panel, "Clock")
    assert services.landmarks.survey("Clock", "12, -52, -11")
    good, path = (match / name).read_bytes(), match / name
    path.write_text(text)
    qtbot.waitUntil(lambda: any(words in text for text in said))
    qtbot.waitUntil(lambda: words in panel.note.text())
    assert services.state.field.element("Clock") is not None
    assert not services.landmarks.remove("Clock")
    assert path.read_text() == text
    path.write_bytes(good)
    qtbot.waitUntil(panel.note.isHidden)
    assert not services.state.notices
    assert services.landmarks.remove("Clock")


def test_what_cannot_be_is_said(said, panel, services, match, qtbot):
    name_landmark(panel, "Middle line")
    assert "is a class of the field" in said[-1]
    assert not (match / "landmarks.json").exists()


def test_a_damaged_file_is_told_and_never_written_over(services, panel, said, match, qtbot):
    (match / "landmarks.json").write_text('{"landmarks": [{"name": 3}]}')
    assert services.opening.open_path(match)
    qtbot.waitUntil(lambda: "landmarks[0].name" in panel.note.text())
    assert "landmarks[0].name" in said[-1]
    assert not panel.add.isEnabled()
    assert not services.landmarks.add("Clock")
    assert (match / "landmarks.json").read_text() == '{"landmarks": [{"name": 3}]}'


def test_the_landmarks_of_one_dataset_are_not_those_of_the_next(panel, services, dataset, qtbot):
    triangulated(panel, qtbot, "Clock")
    assert services.opening.open_path(dataset)
    assert not services.state.field.knows("Clock")
    qtbot.waitUntil(lambda: rows(panel) == [])


def test_a_place_is_not_deleted_unasked(services, panel, said, match, monkeypatch):
    answers = [False, True]
    asked: list[str] = []

    def answer(parent: object, what: str, lost: str) -> bool:
        asked.append(what)
        return answers[len(asked) - 1]

    monkeypatch.setattr("procc_annotator.gui.panels.landmarks.ask_to_delete", answer)
    assert services.landmarks.survey("Clock", "1, 2, -3")
    panel._refresh()
    panel.list.setCurrentItem(panel.list.topLevelItem(0))
    press(panel.remove)
    assert len(load_landmarks(match / "landmarks.json").landmarks) == 1
    press(panel.remove)
    assert load_landmarks(match / "landmarks.json").landmarks == ()
    assert asked == ["the landmark Clock"] * 2
    assert any("deleted the landmark Clock" in text for text in said)


def test_a_landmark_without_a_name_is_asked_for_one(said, panel, services):
    press(panel.add)
    assert "needs a name" in said[-1]
    assert panel.name.hasFocus()
