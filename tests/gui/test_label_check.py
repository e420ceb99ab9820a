"""The label check in the window: signs, the list, the walk, remedies by key, blind mode, export."""

import csv
import io
import json
import shutil
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
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
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.elements import POINTS
from procc_annotator.gui.window.menus import canvas_menu

FRONT, SMALL_FRONT = "Big rect. left main", "Small rect. left main"  # of frame 00002
EMPTY = "00001"
FIELD = load_field("soccer")
assert FIELD.half_turn is not None
HALF_TURN = FIELD.half_turn
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def annotated(annotated) -> Path:
    """Two annotated frames of the sample, and one that is not."""
    for path in annotated.glob("0*.*"):
        if path.stem not in ("00002", "00003", EMPTY):
            path.unlink()
    (annotated / f"{EMPTY}.json").unlink(missing_ok=True)
    return annotated


@pytest.fixture
def window(make_window, annotated, qtbot) -> MainWindow:
    """The window on the sample, at a frame with a dozen right labels."""
    window = make_window(annotated)
    window.services.navigator.go_to(window.services.state.workspace.index["00002"])
    wholly_checked(window, qtbot)
    return window


def checked(window: MainWindow, qtbot: QtBot) -> None:
    """Wait until the frame on screen has been checked as it is."""
    check = window.services.label_check
    qtbot.waitUntil(lambda: check.checked is not None, timeout=20_000)


def wholly_checked(window: MainWindow, qtbot: QtBot) -> None:
    """Wait until it has been checked with its picture, too: nothing comes any more by itself."""
    check = window.services.label_check
    qtbot.waitUntil(lambda: (kept := check.checked) is not None and kept.with_paint, timeout=20_000)


def press(
    window: MainWindow, key: Qt.Key, modifier: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier
) -> None:
    QTest.keyClick(window.canvas, key, modifier)


def swap(window: MainWindow, qtbot: QtBot, a: str = FRONT, b: str = SMALL_FRONT) -> None:
    services = window.services
    services.editing.commit_edit("swap", editing.swap_classes(services.state.annotation, a, b))
    checked(window, qtbot)


def reasons(window: MainWindow) -> list[str]:
    return [found.finding.reason for found in window.services.label_check.shown]


def concerned(window: MainWindow) -> set[str]:
    return {n for found in window.services.label_check.shown for n in found.finding.elements}


def put(window: MainWindow, *findings: Finding) -> None:
    """Let the check of the frame on screen have found this."""
    services = window.services
    size, frame = services.state.picture_size, services.state.frame
    assert size is not None
    fit = FitResult("R", size, None)
    services.label_check._take(frame.name, store_check(services.state.annotation, findings, fit))
    QApplication.processEvents()  # what is drawn together waits for the end of the turn


LOOK = Remedy(RemedyKind.LOOK, "look at it")


def shifted(annotation: FrameAnnotation, name: str) -> FrameAnnotation:
    """All points of a class a little farther to the right."""
    polyline = annotation.get(name)
    every = [(name, i) for i in range(len(polyline.points))]
    return editing.move_points(annotation, every, 0.001, 0.0)


def about(name: str, severity: Severity, rule: Rule = Rule.RESIDUAL) -> Finding:
    return Finding(rule, severity, (name,), f"{name} is off", (LOOK,), error_px=9.0)


# --- signs, and mending with one key ------------------------------------------------------------


def test_swapped_labels_are_found_and_mended_with_one_key(window, qtbot):
    services = window.services
    right = services.state.annotation
    assert not services.label_check.shown
    swap(window, qtbot)
    assert concerned(window) >= {FRONT, SMALL_FRONT}
    press(window, Qt.Key.Key_F12)
    assert services.state.annotation.same_content(right)
    told = window.status.hint.text()
    assert told.startswith("swapped")
    assert "Ctrl+Z takes it back" in told
    checked(window, qtbot)
    assert not services.label_check.shown
    services.editing.undo()
    checked(window, qtbot)
    assert concerned(window) >= {FRONT, SMALL_FRONT}


def test_a_mended_element_keeps_how_its_points_came_to_be(window, qtbot):
    services = window.services
    swap(window, qtbot)
    frame = services.state.frame
    before = dict(services.review.origins(frame.name))
    press(window, Qt.Key.Key_F12)
    assert dict(services.review.origins(frame.name)) == before


def test_findings_are_marked_on_picture_list_and_map(window, qtbot):
    put(window, about(FRONT, Severity.ERROR), about("Circle left", Severity.HINT))
    labels = {x.sign: x for x in window.canvas.overlay_item.overlay.labels if x.sign}
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
    put(window)
    qtbot.waitUntil(lambda: items[FRONT].icon(POINTS).isNull())
    assert not any(len(x.texts) for x in window.canvas.overlay_item.overlay.labels if x.sign)


def test_signs_of_untouched_elements_stay_while_an_edit_is_checked(window):
    services = window.services
    put(window, about(FRONT, Severity.ERROR), about("Circle left", Severity.ERROR))
    moved = shifted(services.state.annotation, FRONT)
    services.editing.commit_edit("move", moved)
    assert reasons(window) == ["Circle left is off"]
    assert services.label_check.checked is None


def test_a_bad_point_is_removed_with_one_key(window):
    services = window.services
    before = services.state.annotation.get(FRONT)
    remedy = Remedy(RemedyKind.REMOVE_POINT, "remove point 2")
    put(window, Finding(Rule.POINT, Severity.WARNING, (FRONT,), "off", (remedy,), 1, 15.0))
    ring = window.canvas.overlay_item.overlay.marks[-1]
    width, height = services.state.picture_size or (0, 0)
    point = before.points[1]
    np.testing.assert_allclose(ring.centres, [[point.u * (width - 1), point.v * (height - 1)]])
    press(window, Qt.Key.Key_F12)
    after = services.state.annotation.get(FRONT)
    assert after.points == (*before.points[:1], *before.points[2:])
    assert "removed point 2 of Left penalty front" in window.status.hint.text()
    services.editing.undo()
    assert services.state.annotation.get(FRONT) == before


def test_a_remedy_of_elements_that_changed_meanwhile_is_not_done(window):
    services = window.services
    remedy = Remedy(RemedyKind.RELABEL, "relabel", ((FRONT, "Big rect. right main"),))
    put(window, Finding(Rule.RESIDUAL, Severity.ERROR, (FRONT,), "off", (remedy,)))
    found = services.label_check.shown[0]
    services.editing.commit_edit("move", shifted(services.state.annotation, FRONT))
    window.label_check.apply(found, remedy)
    assert services.state.annotation.get("Big rect. right main") is None
    assert "changed since" in window.status.hint.text()


def test_the_menu_over_an_element_offers_its_remedies(window):
    services = window.services
    remedy = Remedy(
        RemedyKind.RELABEL, "relabel to Right penalty front", ((FRONT, "Big rect. right main"),)
    )
    put(window, Finding(Rule.RESIDUAL, Severity.ERROR, (FRONT,), "off", (remedy,)))
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


# --- the list, and walking ----------------------------------------------------------------------


@pytest.fixture
def mistaken(make_window, annotated, qtbot) -> MainWindow:
    """The window on the sample with swapped labels in two of its frames, at the empty one."""
    for name, a, b in (
        ("00002", FRONT, SMALL_FRONT),
        ("00003", "Big rect. right main", "Small rect. right main"),
    ):
        path = annotated / f"{name}.json"
        entries = json.loads(path.read_text())
        entries[a], entries[b] = entries[b], entries[a]
        path.write_text(json.dumps(entries))
    window = make_window(annotated)
    checked(window, qtbot)
    return window


def check_set(window: MainWindow, qtbot: QtBot) -> None:
    window.panels.show("findings")
    window.findings.check_button.click()
    assert window.services.label_check.running
    qtbot.waitUntil(lambda: not window.services.label_check.running, timeout=60_000)


def test_walking_over_a_set_visits_every_finding(mistaken, qtbot):
    window, services = mistaken, mistaken.services
    check = services.label_check
    check_set(window, qtbot)
    assert window.status.hint.text().startswith("checked 2 frames, camera model auto: ")
    found = check.known.in_set()
    assert {frame for frame, _ in found} == {"00002", "00003"}
    visited = []
    for _ in range(len(found)):
        press(window, Qt.Key.Key_F10)
        checked(window, qtbot)
        frame, current = services.state.frame, check.current
        assert services.state.selected_class == current.places[0][0]
        visited.append((frame.name, current.key))
    assert visited == [(frame, one.key) for frame, one in check.known.in_set()]
    press(window, Qt.Key.Key_F10)
    assert check.current.key == visited[0][1]
    press(window, Qt.Key.Key_F10, SHIFT)
    assert services.state.frame.name == "00003"
    qtbot.waitUntil(lambda: window.findings.list.currentIndex().isValid())


def test_mending_goes_on_with_the_next_frame(mistaken, qtbot):
    window, services = mistaken, mistaken.services
    check_set(window, qtbot)
    for name in ("00002", "00003"):
        press(window, Qt.Key.Key_F10)
        checked(window, qtbot)
        assert services.state.frame.name == name
        press(window, Qt.Key.Key_F12)
        checked(window, qtbot)
        assert not services.label_check.shown
    press(window, Qt.Key.Key_F10)
    assert "found nothing" in window.status.hint.text()
    window.findings.scope.setCurrentIndex(1)
    assert "Nothing found in 3 frames" in window.findings.empty.text()


def test_nothing_is_called_clean_that_is_still_looked_at(window, qtbot):
    services = window.services
    assert not services.label_check.shown
    services.editing.commit_edit(
        "swap", editing.swap_classes(services.state.annotation, FRONT, SMALL_FRONT)
    )
    for key in (Qt.Key.Key_F10, Qt.Key.Key_F12):
        services.say("")
        press(window, key)
        said = window.status.hint.text()
        assert said.startswith("the label check is still looking at this frame")
    wholly_checked(window, qtbot)
    press(window, Qt.Key.Key_F10)
    assert "finding 1 of" in window.status.hint.text()


def test_another_dataset_is_walked_from_its_first_finding(window, tmp_path, qtbot):
    services = window.services
    workspace = services.state.workspace
    again = Path(shutil.copytree(workspace.folder, tmp_path / "again"))
    for folder in (None, again):
        if folder is not None:
            window.opening.open_path(folder)
        services.editing.commit_edit(
            "swap", editing.swap_classes(services.state.annotation, FRONT, SMALL_FRONT)
        )
        wholly_checked(window, qtbot)
        press(window, Qt.Key.Key_F10)
        assert "finding 1 of" in window.status.hint.text()


def test_frames_with_errors_bear_a_sign_and_are_found_by_the_filter(mistaken, qtbot):
    window, frames = mistaken, mistaken.frames

    def listed() -> list[str]:
        model = frames.model
        return [str(model.data(model.index(row))) for row in range(model.rowCount())]

    frames.filter.setText("check:error")
    assert listed() == []
    check_set(window, qtbot)
    qtbot.waitUntil(lambda: listed() == ["00002", "00003"])
    assert [info.has_errors for row in (0, 1) if (info := frames.model.info(row))] == [True, True]
    tip = frames.model.data(frames.model.index(0), Qt.ItemDataRole.ToolTipRole)
    assert "penalty front" in tip
    frames.filter.setText("check:unchecked")
    qtbot.waitUntil(lambda: listed() == [])  # the empty one was looked at


def test_what_changed_while_the_set_was_checked_is_not_overwritten(mistaken, qtbot):
    window, services = mistaken, mistaken.services
    services.navigator.go_to(1)
    checked(window, qtbot)
    assert services.label_check.shown
    window.label_check.check_set()
    press(window, Qt.Key.Key_F12)
    qtbot.waitUntil(lambda: not services.label_check.running, timeout=60_000)
    checked(window, qtbot)
    assert not services.label_check.known.of("00002")


def test_a_frame_left_before_its_check_is_checked_by_itself(window, qtbot):
    services, check = window.services, window.services.label_check
    services.editing.commit_edit(
        "swap", editing.swap_classes(services.state.annotation, FRONT, SMALL_FRONT)
    )
    services.navigator.go_to(0)  # before any fit can have ended
    assert check.known.severities_of("00002") is None
    qtbot.waitUntil(lambda: check.known.is_known("00002"), timeout=20_000)
    assert check.known.worst("00002") is Severity.ERROR


def test_what_was_found_in_clicks_that_are_gone_is_not_kept(mistaken, qtbot):
    window, services = mistaken, mistaken.services
    check = services.label_check
    services.navigator.go_to(1)
    checked(window, qtbot)
    before = check.known.check_of("00002")
    assert before.found
    services.editing.commit_edit("clear", FrameAnnotation(services.state.annotation.polylines[2:]))
    services.navigator.go_to(0)
    check._take_arrived([("00002", before)])  # read by the check of the set before the edit
    assert check.known.check_of("00002") != before
    qtbot.waitUntil(lambda: check.known.is_known("00002"), timeout=20_000)
    kept = check.known.check_of("00002")
    assert kept.content != before.content


def test_checking_a_set_can_be_stopped(mistaken, qtbot):
    window = mistaken
    window.panels.show("findings")
    window.findings.check_button.click()
    assert window.findings.stop_button.isVisible()
    assert window.findings.progress.isVisible()
    window.findings.stop_button.click()
    assert not window.services.label_check.running
    assert window.findings.check_button.isVisible()
    window.findings.scope.setCurrentIndex(1)
    assert "not checked yet" in window.findings.empty.text() + window.findings.note.text()


def test_a_large_set_is_checked_in_a_process_of_its_own(make_window, annotated, qtbot):
    tiny = np.zeros((36, 64, 3), dtype=np.uint8)
    cv2.imwrite(str(annotated / "89.png"), tiny)
    for i in range(90, 106):
        shutil.copy(annotated / "89.png", annotated / f"{i}.png")
    (annotated / "105.json").write_text("{")
    window = make_window(annotated)
    check_set(window, qtbot)
    assert window.services.label_check.known.count == 3
    assert list(window.services.label_check.problems) == ["105"]
    assert "1 frame cannot be checked" in window.status.hint.text()


def test_the_list_shows_what_the_signs_above_let_through(window, qtbot):
    put(window, about(FRONT, Severity.ERROR), about("Circle left", Severity.HINT))
    window.panels.show("findings")
    panel = window.findings
    qtbot.waitUntil(lambda: panel.model.rowCount() == 2)
    assert [panel.severity_buttons[s].text() for s in Severity] == ["1", "0", "1"]
    panel.severity_buttons[Severity.ERROR].click()
    qtbot.waitUntil(lambda: panel.model.rowCount() == 1)
    assert panel.model.severity(0) is Severity.HINT
    press(window, Qt.Key.Key_F10)
    assert window.services.state.selected_class == "Circle left"
    panel.severity_buttons[Severity.HINT].click()
    qtbot.waitUntil(lambda: "2 more are not listed" in panel.empty.text())


def test_long_reasons_are_whole(window, qtbot):
    long = "without Left penalty front the others drop from 14.1 to 1.8 px, " * 5
    remedy = Remedy(RemedyKind.LOOK, "look at the corner of Left penalty front and Far touchline")
    put(
        window,
        Finding(Rule.RESIDUAL, Severity.ERROR, (FRONT, SMALL_FRONT), long, (remedy,)),
        about("Circle left", Severity.HINT),
    )
    window.panels.show("findings")
    panel = window.findings
    press(window, Qt.Key.Key_F10)
    qtbot.waitUntil(lambda: any(button.isVisible() for button in panel.remedy_buttons))
    listed = panel.list
    assert listed.rowHeight(0) > listed.rowHeight(1) + 5 * listed.fontMetrics().height()
    for button in panel.remedy_buttons[:2]:
        widest = max(button.fontMetrics().horizontalAdvance(x) for x in button.text().split("\n"))
        assert widest <= button.width() - 8
    assert panel.remedy_buttons[0].accessibleName().endswith("(F12)")


def test_a_click_in_the_list_goes_there_and_buttons_mend(window, qtbot):
    services, panel = window.services, window.findings
    remedy = Remedy(RemedyKind.RELABEL, "relabel it", ((FRONT, "Big rect. right main"),))
    put(
        window,
        about("Circle left", Severity.ERROR),
        Finding(Rule.RESIDUAL, Severity.ERROR, (FRONT,), "off", (remedy,)),
    )
    window.panels.show("findings")
    qtbot.waitUntil(lambda: panel.model.rowCount() == 2)
    at = panel.list.visualRect(panel.model.index(1)).center()
    QTest.mouseClick(panel.list.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(at.x(), at.y()))
    assert services.state.selected_class == FRONT
    qtbot.waitUntil(lambda: any(button.isVisible() for button in panel.remedy_buttons))
    panel.remedy_buttons[0].click()
    assert services.state.annotation.get("Big rect. right main") is not None


# --- ignoring -------------------------------------------------------------------------------------


@pytest.mark.new_window
def test_an_ignored_finding_is_gone_until_its_element_changes(
    window, make_window, annotated, qtbot
):
    services, check = window.services, window.services.label_check
    swap(window, qtbot)
    keys = [found.key for found in check.shown]
    press(window, Qt.Key.Key_F10)
    window.panels.show("findings")
    qtbot.waitUntil(lambda: window.findings.list.currentIndex().isValid())
    window.findings.list.setFocus()
    QTest.keyClick(window.findings.list, Qt.Key.Key_Delete)
    assert [found.key for found in check.shown] == keys[1:]
    services.editing.save_now()
    services.review.database.flush()
    other = make_window(annotated)  # remembered by the dataset
    other.services.navigator.go_to(services.state.frame_index)
    checked(other, qtbot)
    assert [found.key for found in other.services.label_check.shown] == keys[1:]
    qtbot.waitUntil(lambda: "1 ignored" in window.findings.note.text()
                    or "ignored" in window.findings.empty.text())  # fmt: skip
    window.label_check.restore()
    assert [found.key for found in check.shown] == keys


def ignore(window: MainWindow, name: str) -> None:
    """Ignore the finding about an element of the frame on screen."""
    frame = window.services.state.frame
    for found in window.services.label_check.shown:
        if found.finding.elements == (name,):
            window.label_check.ignore(frame.name, found)


def test_ignoring_forgets_nothing_that_is_not_found_just_now(window):
    both = about(FRONT, Severity.ERROR), about("Circle left", Severity.HINT)
    put(window, *both)
    ignore(window, FRONT)
    put(window, both[1])  # as by the rules that need no camera
    ignore(window, "Circle left")
    put(window, *both)
    assert not window.services.label_check.shown


def test_two_windows_that_ignore_at_once_lose_nothing_and_hear_of_each_other(
    window, make_window, annotated, qtbot
):
    other = make_window(annotated)
    other.services.navigator.go_to(window.services.state.frame_index)
    wholly_checked(other, qtbot)
    for each, name in ((window, FRONT), (other, "Circle left")):
        put(each, about(FRONT, Severity.ERROR), about("Circle left", Severity.HINT))
        ignore(each, name)
    assert concerned(window) == {"Circle left"}
    assert concerned(other) == {FRONT}

    def both_know() -> bool:
        for each in (window, other):
            database = each.services.review.database
            database.flush()
            each.services.review.poll()
        return not concerned(window) and not concerned(other)

    qtbot.waitUntil(both_know)
    window.panels.show("findings")
    qtbot.waitUntil(lambda: "2 ignored" in window.findings.empty.text()
                    or "2 ignored" in window.findings.note.text())  # fmt: skip


# --- blind mode -----------------------------------------------------------------------------------


def test_blind_mode_shows_only_what_no_camera_was_needed_for(mistaken, qtbot):
    window, services = mistaken, mistaken.services
    check = services.label_check
    check_set(window, qtbot)
    services.navigator.go_to(1)
    checked(window, qtbot)
    assert check.shown
    services.blind_lock.set_blind(True)
    checked(window, qtbot)
    size = services.state.picture_size
    assert size is not None
    alone = check_without_fit(services.state.annotation, services.state.field, size=size)
    assert check.shown == alone.found
    assert {frame for frame, _ in check.known.in_set()} <= {"00002"}  # no other one was checked so
    check_set(window, qtbot)
    for name, index in services.state.workspace.index.items():
        if annotation := services.state.workspace.read(index):
            assert (
                check.known.of(name)
                == check_without_fit(annotation, services.state.field, size=size).found
            ), name
    window.findings.scope.setCurrentIndex(0)
    window.panels.show("findings")
    qtbot.waitUntil(lambda: "Blind" in window.findings.empty.text() + window.findings.note.text())
    services.editing.commit_frame()
    qtbot.waitUntil(lambda: bool(check.shown), timeout=20_000)


def test_rules_without_a_camera_are_looked_at_while_blind(window, qtbot):
    services = window.services
    services.blind_lock.set_blind(True)
    bent = Polyline(
        "Side line top", tuple(Point(0.1 + 0.2 * i, 0.2 + 0.1 * (i % 2)) for i in range(5))
    )
    services.editing.commit_edit("bend", services.state.annotation.with_polyline(bent))
    checked(window, qtbot)
    assert Rule.BENT in {found.finding.rule for found in services.label_check.shown}
    services.editing.undo()
    turned = mirrored_names(services.state.field, MIRROR_Y)
    assert turned is not None
    services.editing.commit_edit("turn", relabelled(services.state.annotation, turned))
    checked(window, qtbot)
    assert Rule.REFLECTED in {found.finding.rule for found in services.label_check.shown}


# --- what only the set tells ----------------------------------------------------------------------


@pytest.fixture
def turned(make_window, sample_copy, qtbot) -> MainWindow:
    """The window on frames of one tripod, the labels of 00003 turned by half a turn."""
    for path in sample_copy.glob("0*.*"):
        if path.stem not in ("00002", "00003", "00004", "00006"):
            path.unlink()
    names = {name: HALF_TURN.name_of(name) for name in FIELD.index}
    path = sample_copy / "00003.json"
    entries = json.loads(path.read_text())
    path.write_text(json.dumps({names.get(key, key): value for key, value in entries.items()}))
    window = make_window(sample_copy)
    checked(window, qtbot)
    return window


def test_a_turned_frame_is_told_by_the_set_and_turned_back(turned, qtbot):
    window, services = turned, turned.services
    check = services.label_check
    services.navigator.go_to(1)
    wholly_checked(window, qtbot)

    def told() -> list[Rule]:
        return [found.finding.rule for found in check.shown]

    assert Rule.OTHER_SIDE not in told()
    before = services.state.annotation
    check_set(window, qtbot)
    assert told()[0] is Rule.OTHER_SIDE
    services.navigator.go_to(0)
    services.navigator.go_to(1)
    wholly_checked(window, qtbot)
    assert told()[0] is Rule.OTHER_SIDE  # also once the frame was looked at anew
    press(window, Qt.Key.Key_F12)
    checked(window, qtbot)
    turned_back, turned_line = (
        a.get(f"Side line {side}")
        for a, side in ((services.state.annotation, "right"), (before, "left"))
    )
    assert turned_back.points == turned_line.points
    assert Rule.OTHER_SIDE not in told()
    services.editing.undo()
    checked(window, qtbot)
    assert told()[0] is Rule.OTHER_SIDE


# --- empty states, export -------------------------------------------------------------------------


def test_the_panel_says_why_it_is_empty(window, qtbot):
    services, panel = window.services, window.findings
    window.panels.show("findings")

    def says(words: str) -> None:
        qtbot.waitUntil(lambda: words in panel.empty.text(), timeout=20_000)

    says("Nothing found in this frame.")
    services.editing.commit_edit("clear", FrameAnnotation())
    says("Nothing is annotated in this frame.")
    services.editing.undo()
    two = FrameAnnotation(services.state.annotation.polylines[:2])
    services.editing.commit_edit("two", two)
    says("No camera fits yet")
    services.editing.undo()
    panel.scope.setCurrentIndex(1)
    says("not checked yet")


def test_findings_are_exported(mistaken, qtbot, tmp_path):
    window, check = mistaken, mistaken.services.label_check
    check_set(window, qtbot)
    path = tmp_path / "findings.csv"
    window.label_check.export(path)
    rows = list(csv.DictReader(io.StringIO(path.read_bytes().decode())))
    assert [row["frame"] for row in rows] == [frame for frame, _ in check.known.in_set()]
    assert {row["severity"] for row in rows} >= {"error"}
    assert {(row["width"], row["height"]) for row in rows} == {("1280", "720")}
    assert {row["model"] for row in rows if row["error_px"]} == {"R"}
    assert "exported" in window.status.hint.text()
    window.label_check.export(tmp_path / "nowhere" / "findings.csv")
    assert window.message_bar.isVisible()
