"""Frames grouped by their names in the window: the pattern, what it does, and the file."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.landmarks.view_groups import load_views
from procc_annotator.gui.commands.view_grouping import ViewDialog, ViewGrouping
from procc_annotator.gui.panels.landmarks import LandmarksPanel
from procc_annotator.gui.state.services import Services

NAMES = ("17_left", "17_right", "18_left", "18_right", "poster")
BALL = [{"name": "Ball", "moving": True}, {"name": "Ball", "instant": "18", "position": [1, 2, -3]}]


@pytest.fixture
def folder(tmp_path) -> Path:
    """Two instants by two cameras, and a picture of nothing; a ball that was placed at one."""
    folder = tmp_path / "match"
    folder.mkdir()
    for name in NAMES:
        cv2.imwrite(str(folder / f"{name}.png"), np.full((90, 160, 3), 90, np.uint8))
    (folder / "landmarks.json").write_text(json.dumps({"landmarks": BALL}))
    return folder


@pytest.fixture
def services(open_services, folder) -> Services:
    services = open_services(folder)
    services.navigator.go_to(2)
    return services


@pytest.fixture
def panel(services, show) -> LandmarksPanel:
    return show(LandmarksPanel(services))


@pytest.fixture
def task(services, widget) -> ViewGrouping:
    widget.show()
    return ViewGrouping(services, widget)


def asked(task: ViewGrouping, qtbot: QtBot) -> ViewDialog:
    task.ask()
    dialog = task.dialog
    qtbot.waitUntil(dialog.write.isEnabled)
    return dialog


def shown(dialog: ViewDialog) -> list[tuple[str, ...]]:
    model = dialog.table.model()
    return [
        tuple(model.index(row, column).data() for column in range(3))
        for row in range(model.rowCount())
    ]


def type_pattern(dialog: ViewDialog, text: str) -> None:
    dialog.pattern.selectAll()
    QTest.keyClicks(dialog.pattern, text)


def press_write(dialog: ViewDialog) -> None:
    QTest.mouseClick(dialog.write, Qt.MouseButton.LeftButton)


def test_groups_by_names_are_shown_written_and_used_at_once(task, panel, services, folder, qtbot):
    assert panel.views.count() == 0
    assert services.scorer.frame_setup.field.element("Ball") is None
    dialog = asked(task, qtbot)
    assert dialog.pattern.text() == "{instant}_{view}"
    assert shown(dialog)[0] == ("17", "left", "17_left")
    assert shown(dialog)[-1] == ("—", "—", "poster")
    assert dialog.counts.text() == (
        "4 frames in 2 groups; 1 name does not fit (last in the table)."
    )
    press_write(dialog)
    qtbot.waitUntil(lambda: panel.views.count() == 1)
    assert panel.views.item(0).text() == "right  (18_right)"
    assert services.scorer.frame_setup.field.element("Ball") is not None
    assert task.dialog is None
    assert load_views(folder / "views.csv").groups == {
        "17": ("17_left", "17_right"),
        "18": ("18_left", "18_right"),
    }


def test_what_is_wrong_with_a_pattern_is_said_while_it_is_written(task, services, qtbot):
    dialog = asked(task, qtbot)
    for pattern, words in (
        ("{view}", "names no instant"),
        ("{instant}x{view}", "no name fits it"),
        ("(?P<instant>[0-9]+)_.*(?P<view>t)", "both for the view 't'"),
    ):
        type_pattern(dialog, pattern)
        assert not dialog.write.isEnabled()
        qtbot.waitUntil(lambda words=words: words in dialog.note.text())
        assert not dialog.write.isEnabled()
    assert shown(dialog)[0] == ("17", "t", "17_left")  # what it does can be seen all the same
    type_pattern(dialog, "(?P<instant>[0-9]+)_.*")
    qtbot.waitUntil(dialog.write.isEnabled)
    assert dialog.note.isHidden()
    assert shown(dialog)[0] == ("17", "—", "17_left")


def test_another_file_is_not_written_over_unasked(panel, task, folder, qtbot, monkeypatch):
    answers = [False, True]
    monkeypatch.setattr(
        "procc_annotator.gui.commands.view_grouping.ask_to_replace", lambda *_: answers.pop(0)
    )
    path = folder / "views.csv"
    path.write_text("frame,instant\n17_left,1\n18_left,1\n")
    qtbot.waitUntil(lambda: panel.views.count() == 1)
    dialog = asked(task, qtbot)
    assert dialog.there.text() == "views.csv is there already: 2 frames of 1 instant."
    before = path.read_bytes()
    press_write(dialog)
    qtbot.waitUntil(lambda: len(answers) == 1 and dialog.write.isEnabled())
    assert path.read_bytes() == before
    press_write(dialog)
    qtbot.waitUntil(lambda: task.dialog is None)
    assert len(load_views(path).frames) == 4


def test_a_file_that_cannot_be_written_is_told_in_the_dialog(task, services, folder, qtbot):
    (folder / "views.csv").symlink_to(folder.parent / "elsewhere.csv")
    dialog = asked(task, qtbot)
    press_write(dialog)
    qtbot.waitUntil(lambda: "could not be saved" in dialog.note.text())
    assert dialog.write.isEnabled()
    assert not (folder.parent / "elsewhere.csv").exists()
