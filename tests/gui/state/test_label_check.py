"""The label check: findings, walking through them, remedies, ignoring, blind mode, the set."""

import csv
import io
import json
import shutil
from functools import partial
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.label_check.candidate_classes import (
    MIRROR_Y,
    mirrored_names,
    relabelled,
)
from procc_annotator.calibration.label_check.finding import (
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.dataset import editing
from procc_annotator.dataset.review import check_without_fit, store_check
from procc_annotator.field.load import load_field
from procc_annotator.gui.commands.label_check import LabelCheckCommands
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.elements import POINTS
from procc_annotator.gui.panels.findings import FindingsPanel
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.window.menus import canvas_menu
from tests.gui.conftest import heard

FRONT, SMALL_FRONT = "Big rect. left main", "Small rect. left main"  # of frame 00002


FIELD = load_field("soccer")


@pytest.fixture
def annotated(annotated) -> Path:
    """Two annotated frames of the sample, and one that is not."""
    for path in annotated.glob("0*.*"):
        if path.stem not in ("00002", "00003", "00001"):
            path.unlink()
    (annotated / "00001.json").unlink(missing_ok=True)
    return annotated


@pytest.fixture
def services(open_services, annotated, qtbot) -> Services:
    """The sample, at a frame with a dozen right labels."""
    services = open_services(annotated)
    services.navigator.go_to(services.state.workspace.index["00002"])
    wholly_checked(services, qtbot)
    return services


@pytest.fixture
def commands(services, widget) -> LabelCheckCommands:
    return LabelCheckCommands(services, widget)


@pytest.fixture
def said(services) -> list[str]:
    return heard(services)


def checked(services: Services, qtbot: QtBot) -> None:
    """Wait until the frame on screen has been checked as it is."""
    check = services.label_check
    qtbot.waitUntil(lambda: check.checked is not None)


def wholly_checked(services: Services, qtbot: QtBot) -> None:
    """Wait until it has been checked with its picture, too: nothing comes any more by itself."""
    check = services.label_check
    qtbot.waitUntil(lambda: (kept := check.checked) is not None and kept.with_paint)


def swap(services: Services, qtbot: QtBot, a: str = FRONT, b: str = SMALL_FRONT) -> None:
    services.editing.commit_edit("swap", editing.swap_classes(services.state.annotation, a, b))
    checked(services, qtbot)


def reasons(services: Services) -> list[str]:
    return [found.finding.reason for found in services.label_check.shown]


def concerned(services: Services) -> set[str]:
    return {n for found in services.label_check.shown for n in found.finding.elements}


def put(services: Services, *findings: Finding) -> None:
    """Let the check of the frame on screen have found this."""
    size, frame = services.state.picture_size, services.state.frame
    fit = FitResult("R", size, None)
    services.label_check._take(frame.name, store_check(services.state.annotation, findings, fit))


LOOK = Remedy(RemedyKind.LOOK, "look at it")


def shifted(annotation: FrameAnnotation, name: str) -> FrameAnnotation:
    """All points of a class a little farther to the right."""
    polyline = annotation.get(name)
    every = [(name, i) for i in range(len(polyline.points))]
    return editing.move_points(annotation, every, 0.001, 0.0)


def about(name: str, severity: Severity, rule: Rule = Rule.RESIDUAL) -> Finding:
    return Finding(rule, severity, (name,), f"{name} is off", (LOOK,), error_px=9.0)


def test_swapped_labels_are_found_and_mended_with_one_key(services, qtbot, commands, said):
    right = services.state.annotation
    assert not services.label_check.shown
    swap(services, qtbot)
    assert concerned(services) >= {FRONT, SMALL_FRONT}
    commands.apply_first()
    assert services.state.annotation.same_content(right)
    told = said[-1]
    assert told.startswith("swapped")
    assert "Ctrl+Z takes it back" in told
    checked(services, qtbot)
    assert not services.label_check.shown
    services.editing.undo()
    checked(services, qtbot)
    assert concerned(services) >= {FRONT, SMALL_FRONT}


def test_a_mended_element_keeps_how_its_points_came_to_be(services, qtbot, commands):
    swap(services, qtbot)
    frame = services.state.frame
    before = dict(services.review.origins(frame.name))
    commands.apply_first()
    assert dict(services.review.origins(frame.name)) == before


def test_signs_of_untouched_elements_stay_while_an_edit_is_checked(services):
    put(services, about(FRONT, Severity.ERROR), about("Circle left", Severity.ERROR))
    moved = shifted(services.state.annotation, FRONT)
    services.editing.commit_edit("move", moved)
    assert reasons(services) == ["Circle left is off"]
    assert services.label_check.checked is None


def test_a_remedy_of_elements_that_changed_meanwhile_is_not_done(services, commands, said):
    remedy = Remedy(RemedyKind.RELABEL, "relabel", ((FRONT, "Big rect. right main"),))
    put(services, Finding(Rule.RESIDUAL, Severity.ERROR, (FRONT,), "off", (remedy,)))
    found = services.label_check.shown[0]
    services.editing.commit_edit("move", shifted(services.state.annotation, FRONT))
    commands.apply(found, remedy)
    assert services.state.annotation.get("Big rect. right main") is None
    assert "changed since" in said[-1]


@pytest.fixture
def mistaken(annotated) -> None:
    """Labels are swapped in two frames."""
    for name, a, b in (
        ("00002", FRONT, SMALL_FRONT),
        ("00003", "Big rect. right main", "Small rect. right main"),
    ):
        path = annotated / f"{name}.json"
        entries = json.loads(path.read_text())
        entries[a], entries[b] = entries[b], entries[a]
        path.write_text(json.dumps(entries))


def check_set(services: Services, qtbot: QtBot) -> None:
    services.label_check.check_set()
    assert services.label_check.running
    qtbot.waitUntil(lambda: not services.label_check.running)


def test_walking_over_a_set_visits_every_finding(mistaken, services, qtbot, commands, said):
    check = services.label_check
    check_set(services, qtbot)
    assert said[-1].startswith("checked 2 frames, camera model auto: ")
    found = check.known.in_set()
    assert {frame for frame, _ in found} == {"00002", "00003"}
    visited = []
    for _ in range(len(found)):
        commands.step(1)
        checked(services, qtbot)
        frame, current = services.state.frame, check.current
        assert services.state.selected_class == current.places[0][0]
        visited.append((frame.name, current.key))
    assert visited == [(frame, one.key) for frame, one in check.known.in_set()]
    commands.step(1)
    assert check.current.key == visited[0][1]
    commands.step(-1)
    assert services.state.frame.name == "00003"


def test_mending_goes_on_with_the_next_frame(mistaken, services, qtbot, commands, said):
    check_set(services, qtbot)
    for name in ("00002", "00003"):
        commands.step(1)
        checked(services, qtbot)
        assert services.state.frame.name == name
        commands.apply_first()
        checked(services, qtbot)
        assert not services.label_check.shown
    commands.step(1)
    assert "found nothing" in said[-1]


def test_nothing_is_called_clean_that_is_still_looked_at(services, qtbot, commands, said):
    assert not services.label_check.shown
    services.editing.commit_edit(
        "swap", editing.swap_classes(services.state.annotation, FRONT, SMALL_FRONT)
    )
    for command in (partial(commands.step, 1), commands.apply_first):
        command()
        assert said.pop().startswith("the label check is still looking at this frame")
    wholly_checked(services, qtbot)
    commands.step(1)
    assert "finding 1 of" in said[-1]


def test_another_dataset_is_walked_from_its_first_finding(
    services, tmp_path, qtbot, commands, said
):
    workspace = services.state.workspace
    again = Path(shutil.copytree(workspace.folder, tmp_path / "again"))
    for folder in (None, again):
        if folder is not None:
            services.opening.open_path(folder)
        services.editing.commit_edit(
            "swap", editing.swap_classes(services.state.annotation, FRONT, SMALL_FRONT)
        )
        wholly_checked(services, qtbot)
        commands.step(1)
        assert "finding 1 of" in said[-1]


def test_what_changed_while_the_set_was_checked_is_not_overwritten(
    mistaken, services, qtbot, commands
):
    services.navigator.go_to(1)
    checked(services, qtbot)
    assert services.label_check.shown
    commands.check_set()
    commands.apply_first()
    qtbot.waitUntil(lambda: not services.label_check.running)
    checked(services, qtbot)
    assert not services.label_check.known.of("00002")


def test_a_frame_left_before_its_check_is_checked_by_itself(services, qtbot):
    check = services.label_check
    services.editing.commit_edit(
        "swap", editing.swap_classes(services.state.annotation, FRONT, SMALL_FRONT)
    )
    services.navigator.go_to(0)  # before any fit can have ended
    assert check.known.severities_of("00002") is None
    qtbot.waitUntil(lambda: check.known.is_known("00002"))
    assert check.known.worst("00002") is Severity.ERROR


def test_what_was_found_in_clicks_that_are_gone_is_not_kept(mistaken, services, qtbot):
    check = services.label_check
    services.navigator.go_to(1)
    checked(services, qtbot)
    before = check.known.check_of("00002")
    assert before.found
    services.editing.commit_edit("clear", FrameAnnotation(services.state.annotation.polylines[2:]))
    services.navigator.go_to(0)
    check._take_arrived([("00002", before)])  # read by the check of the set before the edit
    assert check.known.check_of("00002") != before
    qtbot.waitUntil(lambda: check.known.is_known("00002"))
    kept = check.known.check_of("00002")
    assert kept.content != before.content


def test_a_large_set_is_checked_in_a_process_of_its_own(open_services, annotated, qtbot, widget):
    tiny = np.zeros((36, 64, 3), dtype=np.uint8)
    cv2.imwrite(str(annotated / "89.png"), tiny)
    for i in range(90, 106):
        shutil.copy(annotated / "89.png", annotated / f"{i}.png")
    (annotated / "105.json").write_text("{")
    services = open_services(annotated)
    commands, said = LabelCheckCommands(services, widget), heard(services)
    commands.check_set()
    qtbot.waitUntil(lambda: not services.label_check.running)
    assert services.label_check.known.count == 3
    assert list(services.label_check.problems) == ["105"]
    assert "1 frame cannot be checked" in said[-1]


def test_an_ignored_finding_is_gone_until_its_element_changes(
    services, open_services, annotated, qtbot, commands, panel
):
    check = services.label_check
    swap(services, qtbot)
    keys = [found.key for found in check.shown]
    commands.step(1)
    commands.ignore_current()
    assert [found.key for found in check.shown] == keys[1:]
    services.editing.save_now()
    services.review.database.flush()
    other = open_services(annotated)  # remembered by the dataset
    other.navigator.go_to(services.state.frame_index)
    checked(other, qtbot)
    assert [found.key for found in other.label_check.shown] == keys[1:]
    qtbot.waitUntil(lambda: "ignored" in panel.empty.text() + panel.note.text())
    commands.restore()
    assert [found.key for found in check.shown] == keys


def ignore(commands: LabelCheckCommands, services: Services, name: str) -> None:
    """Ignore the finding about an element of the frame on screen."""
    frame = services.state.frame
    for found in services.label_check.shown:
        if found.finding.elements == (name,):
            commands.ignore(frame.name, found)


def test_ignoring_forgets_nothing_that_is_not_found_just_now(services, commands):
    both = about(FRONT, Severity.ERROR), about("Circle left", Severity.HINT)
    put(services, *both)
    ignore(commands, services, FRONT)
    put(services, both[1])  # as by the rules that need no camera
    ignore(commands, services, "Circle left")
    put(services, *both)
    assert not services.label_check.shown


def test_two_windows_that_ignore_at_once_lose_nothing_and_hear_of_each_other(
    services, open_services, annotated, qtbot, widget
):
    other = open_services(annotated)
    other.navigator.go_to(services.state.frame_index)
    wholly_checked(other, qtbot)
    for each, name in ((services, FRONT), (other, "Circle left")):
        put(each, about(FRONT, Severity.ERROR), about("Circle left", Severity.HINT))
        ignore(LabelCheckCommands(each, widget), each, name)
    assert concerned(services) == {"Circle left"}
    assert concerned(other) == {FRONT}

    def both_know() -> bool:
        for each in (services, other):
            database = each.review.database
            database.flush()
            each.review.poll()
        return not concerned(services) and not concerned(other)

    qtbot.waitUntil(both_know)


def test_blind_mode_shows_only_what_no_camera_was_needed_for(mistaken, services, qtbot, panel):
    check = services.label_check
    check_set(services, qtbot)
    services.navigator.go_to(1)
    checked(services, qtbot)
    assert check.shown
    services.blind_lock.set_blind(True)
    checked(services, qtbot)
    size = services.state.picture_size
    alone = check_without_fit(services.state.annotation, services.state.field, size=size)
    assert check.shown == alone.found
    assert {frame for frame, _ in check.known.in_set()} <= {"00002"}  # no other one was checked so
    check_set(services, qtbot)
    for name, index in services.state.workspace.index.items():
        if annotation := services.state.workspace.read(index):
            assert (
                check.known.of(name)
                == check_without_fit(annotation, services.state.field, size=size).found
            ), name
    qtbot.waitUntil(lambda: "Blind" in panel.empty.text() + panel.note.text())
    services.editing.commit_frame()
    qtbot.waitUntil(lambda: bool(check.shown))


def test_rules_without_a_camera_are_looked_at_while_blind(services, qtbot):
    services.blind_lock.set_blind(True)
    bent = Polyline(
        "Side line top", tuple(Point(0.1 + 0.2 * i, 0.2 + 0.1 * (i % 2)) for i in range(5))
    )
    services.editing.commit_edit("bend", services.state.annotation.with_polyline(bent))
    checked(services, qtbot)
    assert Rule.BENT in {found.finding.rule for found in services.label_check.shown}
    services.editing.undo()
    turned = mirrored_names(services.state.field, MIRROR_Y)
    services.editing.commit_edit("turn", relabelled(services.state.annotation, turned))
    checked(services, qtbot)
    assert Rule.REFLECTED in {found.finding.rule for found in services.label_check.shown}


@pytest.fixture
def turned(annotated, sample_data) -> None:
    """Frames of one tripod, the labels of 00003 turned by half a turn."""
    for name in ("00004", "00006"):
        shutil.copy(sample_data / f"{name}.jpg", annotated)
        shutil.copy(sample_data / f"{name}.json", annotated)
    path = annotated / "00003.json"
    entries = json.loads(path.read_text())
    names = {name: FIELD.half_turn.name_of(name) for name in FIELD.index}
    path.write_text(json.dumps({names.get(key, key): value for key, value in entries.items()}))


def test_a_turned_frame_is_told_by_the_set_and_turned_back(turned, services, qtbot, commands):
    check = services.label_check
    services.navigator.go_to(2)
    wholly_checked(services, qtbot)

    def told() -> list[Rule]:
        return [found.finding.rule for found in check.shown]

    assert Rule.OTHER_SIDE not in told()
    before = services.state.annotation
    check_set(services, qtbot)
    assert told()[0] is Rule.OTHER_SIDE
    services.navigator.go_to(1)
    services.navigator.go_to(2)
    wholly_checked(services, qtbot)
    assert told()[0] is Rule.OTHER_SIDE  # also once the frame was looked at anew
    commands.apply_first()
    checked(services, qtbot)
    turned_back, turned_line = (
        a.get(f"Side line {side}")
        for a, side in ((services.state.annotation, "right"), (before, "left"))
    )
    assert turned_back.points == turned_line.points
    assert Rule.OTHER_SIDE not in told()
    services.editing.undo()
    checked(services, qtbot)
    assert told()[0] is Rule.OTHER_SIDE


def test_findings_are_exported(mistaken, services, qtbot, tmp_path, commands, said):
    check = services.label_check
    check_set(services, qtbot)
    path = tmp_path / "findings.csv"
    commands.export(path)
    rows = list(csv.DictReader(io.StringIO(path.read_bytes().decode())))
    assert [row["frame"] for row in rows] == [frame for frame, _ in check.known.in_set()]
    assert {row["severity"] for row in rows} >= {"error"}
    assert {(row["width"], row["height"]) for row in rows} == {("1280", "720")}
    assert {row["model"] for row in rows if row["error_px"]} == {"R"}
    assert "exported" in said[-1]
    commands.export(tmp_path / "nowhere" / "findings.csv")
    assert "nowhere" in said[-1]


@pytest.fixture
def window(make_window, annotated, qtbot) -> MainWindow:
    """The window on the sample, at a frame with a dozen right labels."""
    window = make_window(annotated)
    window.services.navigator.go_to(window.services.state.workspace.index["00002"])
    wholly_checked(window.services, qtbot)
    return window


@pytest.fixture
def panel(services, commands, show) -> FindingsPanel:
    return show(FindingsPanel(services, commands))


def test_findings_are_marked_on_picture_list_and_map(window, qtbot):
    put(window.services, about(FRONT, Severity.ERROR), about("Circle left", Severity.HINT))
    item = window.canvas.overlay_item
    qtbot.waitUntil(lambda: any(len(x.texts) for x in item.overlay.labels if x.sign))
    labels = {x.sign: x for x in item.overlay.labels if x.sign}
    assert labels["error"].texts == ("Left penalty front",)
    assert labels["hint"].texts == ("",)
    window.panels.show("elements")
    tree, items = window.elements.tree, window.elements._items
    qtbot.waitUntil(lambda: not items[FRONT].icon(POINTS).isNull())
    assert "Error: Big rect. left main is off" in items[FRONT].toolTip(POINTS)
    # the sign is whole
    qtbot.waitUntil(lambda: tree.columnWidth(POINTS) >= tree.sizeHintForColumn(POINTS))
    assert "Error: Big rect. left main is off" in window.field_map._tip(FRONT)
    at = window.canvas.to_view(*labels["hint"].positions[0].tolist())
    assert "Circle left is off" in window.finding_tips.tip_at(at + QPointF(14, 12))
    assert window.finding_tips.tip_at(at + QPointF(0, 300)) == ""
    put(window.services)
    qtbot.waitUntil(lambda: items[FRONT].icon(POINTS).isNull())
    qtbot.waitUntil(lambda: not any(len(x.texts) for x in item.overlay.labels if x.sign))


def test_a_bad_point_is_removed_with_one_key(window, qtbot):
    services = window.services
    before = services.state.annotation.get(FRONT)
    remedy = Remedy(RemedyKind.REMOVE_POINT, "remove point 2")
    put(window.services, Finding(Rule.POINT, Severity.WARNING, (FRONT,), "off", (remedy,), 1, 15.0))
    width, height = services.state.picture_size or (0, 0)
    point = before.points[1]
    at = [[point.u * (width - 1), point.v * (height - 1)]]
    item = window.canvas.overlay_item
    qtbot.waitUntil(lambda: np.array_equal(item.overlay.marks[-1].centres, at))
    QTest.keyClick(window.canvas, Qt.Key.Key_F12)
    after = services.state.annotation.get(FRONT)
    assert after.points == (*before.points[:1], *before.points[2:])
    assert "removed point 2 of Left penalty front" in window.status.hint.text()
    services.editing.undo()
    assert services.state.annotation.get(FRONT) == before


def test_the_menu_over_an_element_offers_its_remedies(window):
    services = window.services
    remedy = Remedy(
        RemedyKind.RELABEL, "relabel to Right penalty front", ((FRONT, "Big rect. right main"),)
    )
    put(window.services, Finding(Rule.RESIDUAL, Severity.ERROR, (FRONT,), "off", (remedy,)))
    services.selection.select_class(FRONT)

    def entries() -> dict[str, object]:
        menu = canvas_menu(
            window, services, window.actions_, window.element_edits, window.label_check
        )
        return {action.text(): action for action in menu.actions()}

    entries()["Relabel to Right penalty front"].trigger()
    assert services.state.annotation.get("Big rect. right main") is not None
    assert services.state.annotation.get(FRONT) is None
    assert services.state.selected_class == "Big rect. right main"
    services.editing.undo()
    services.selection.select_class("Circle left")
    assert "Relabel to Right penalty front" not in entries()


def test_frames_with_errors_bear_a_sign_and_are_found_by_the_filter(mistaken, window, qtbot):
    frames = window.frames

    def listed() -> list[str]:
        model = frames.model
        return [str(model.data(model.index(row))) for row in range(model.rowCount())]

    frames.filter.setText("check:error")
    assert listed() == ["00002"]  # only it was looked at
    window.services.navigator.go_to(0)
    checked(window.services, qtbot)
    check_set(window.services, qtbot)
    qtbot.waitUntil(lambda: listed() == ["00002", "00003"])
    assert [info.has_errors for row in (0, 1) if (info := frames.model.info(row))] == [True, True]
    tip = frames.model.data(frames.model.index(0), Qt.ItemDataRole.ToolTipRole)
    assert "penalty front" in tip
    frames.filter.setText("check:unchecked")
    qtbot.waitUntil(lambda: listed() == [])  # the empty one was looked at


def test_checking_a_set_can_be_stopped(mistaken, services, panel, qtbot):
    panel.check_button.click()
    assert panel.stop_button.isVisible()
    assert panel.progress.isVisible()
    panel.stop_button.click()
    assert not services.label_check.running
    assert panel.check_button.isVisible()
    panel.scope.click()
    assert "not checked yet" in panel.empty.text() + panel.note.text()


def test_a_checked_set_is_listed_errors_first(mistaken, services, panel, qtbot):
    put(services, about(FRONT, Severity.HINT))
    panel.check_button.click()
    qtbot.waitUntil(lambda: panel.scope.isChecked())  # it is listed by itself
    qtbot.waitUntil(lambda: panel.model.rowCount() > 1)
    ranks = [panel.model.severity(row).rank for row in range(panel.model.rowCount())]
    assert ranks == sorted(ranks)
    panel.scope.click()
    assert all(frame == services.state.frame_name for frame, _ in panel.model.entries)


def test_the_list_shows_what_the_signs_above_let_through(services, commands, panel, qtbot):
    put(services, about(FRONT, Severity.ERROR), about("Circle left", Severity.HINT))
    qtbot.waitUntil(lambda: panel.model.rowCount() == 2)
    assert [panel.severity_buttons[s].text() for s in Severity] == ["1", "0", "1"]
    panel.severity_buttons[Severity.ERROR].click()
    qtbot.waitUntil(lambda: panel.model.rowCount() == 1)
    assert panel.model.severity(0) is Severity.HINT
    commands.step(1)
    assert services.state.selected_class == "Circle left"
    panel.severity_buttons[Severity.HINT].click()
    qtbot.waitUntil(lambda: "2 more are not listed" in panel.empty.text())


def test_long_reasons_are_whole(services, commands, panel, qtbot):
    panel.resize(280, 480)
    long = "without Left penalty front the others drop from 14.1 to 1.8 px, " * 5
    remedy = Remedy(RemedyKind.LOOK, "look at the corner of Left penalty front and Far touchline")
    put(
        services,
        Finding(Rule.RESIDUAL, Severity.ERROR, (FRONT, SMALL_FRONT), long, (remedy,)),
        about("Circle left", Severity.HINT),
    )
    commands.step(1)
    qtbot.waitUntil(lambda: any(button.isVisible() for button in panel.remedy_buttons))
    listed = panel.list
    assert listed.rowHeight(0) > listed.rowHeight(1) + 5 * listed.fontMetrics().height()
    for button in panel.remedy_buttons[:2]:
        widest = max(button.fontMetrics().horizontalAdvance(x) for x in button.text().split("\n"))
        assert widest <= button.width() - 8
    assert panel.remedy_buttons[0].accessibleName().endswith("(F12)")


def test_a_click_in_the_list_goes_there_and_buttons_mend(services, panel, qtbot):
    remedy = Remedy(RemedyKind.RELABEL, "relabel it", ((FRONT, "Big rect. right main"),))
    put(
        services,
        about("Circle left", Severity.ERROR),
        Finding(Rule.RESIDUAL, Severity.ERROR, (FRONT,), "off", (remedy,)),
    )
    qtbot.waitUntil(lambda: panel.model.rowCount() == 2)
    at = panel.list.visualRect(panel.model.index(1)).center()
    QTest.mouseClick(panel.list.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(at.x(), at.y()))
    assert services.state.selected_class == FRONT
    qtbot.waitUntil(lambda: any(button.isVisible() for button in panel.remedy_buttons))
    panel.remedy_buttons[0].click()
    assert services.state.annotation.get("Big rect. right main") is not None


def test_the_panel_says_why_it_is_empty(services, panel, qtbot):

    def says(words: str) -> None:
        qtbot.waitUntil(lambda: words in panel.empty.text())

    says("Nothing found in this frame.")
    services.editing.commit_edit("clear", FrameAnnotation())
    says("Nothing is annotated in this frame.")
    services.editing.undo()
    two = FrameAnnotation(services.state.annotation.polylines[:2])
    services.editing.commit_edit("two", two)
    says("Full check needs a camera")
    services.editing.undo()
    panel.scope.click()
    says("not checked yet")
