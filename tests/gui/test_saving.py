"""Every finished edit is on disk at once; what cannot be saved is never lost and never hidden."""

import json
from pathlib import Path

import pytest
from PySide6.QtCore import Qt

from procc_annotator.dataset import saving
from procc_annotator.errors import SaveError
from procc_annotator.gui import main_window
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.messages import say
from tests.gui.conftest import heard

MIDDLE = "Middle line"


class Disk:
    """Stands before the real atomic write; can be full."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.full = False
        self._write = saving.write_atomic
        monkeypatch.setattr(saving, "write_atomic", self.write)

    def write(self, path: Path, data: bytes, **more: Path) -> None:
        if self.full:
            raise SaveError(f"{path}: cannot be written: No space left on device")
        self._write(path, data, **more)


@pytest.fixture
def disk(monkeypatch) -> Disk:
    return Disk(monkeypatch)


def test_a_finished_edit_is_on_disk_before_anything_else_happens(window, hand, saved):
    assert window.top_bar.saved.text() == ""
    window.services.selection.select_class(MIDDLE)
    hand.click(100, 50)
    hand.click(120, 200)
    hand.key(Qt.Key.Key_Return)
    assert window.top_bar.saved.text() == "saving..."
    assert len(saved()) == 2
    assert window.top_bar.saved.text() == "saved"
    assert not window.isWindowModified()


def test_a_failed_save_is_visible_told_once_and_tried_again(window, hand, disk, saved, qtbot):
    disk.full = True
    told = heard(window.services)
    hand.draw(MIDDLE, (100, 50), (120, 200))
    assert window.isWindowModified()
    assert "NOT SAVED" in window.top_bar.saved.text()
    assert window.message_bar.isVisible()
    assert "No space left" in window.message_bar.label.text()
    window.services.saver.retry_timer.setInterval(1)
    with qtbot.waitSignal(window.services.saver.retry_timer.timeout):
        pass
    assert sum("No space left" in text for text in told) == 1
    assert len(window.services.state.annotation.annotated) == 1
    disk.full = False
    qtbot.waitUntil(lambda: not window.isWindowModified())
    assert len(saved()) == 2
    assert not window.message_bar.isVisible()
    assert not window.services.saver.retry_timer.isActive()


def test_what_is_not_saved_stays_in_sight_when_more_fails(window, hand, disk):
    disk.full = True
    hand.draw(MIDDLE, (100, 50), (120, 200))
    say(window.services.store, "workspace.db: cannot be written", "warning")  # the same full disk
    shown = window.message_bar.label.text()
    assert "No space left" in shown
    assert "workspace.db" in shown
    disk.full = False
    hand.key(Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    assert window.message_bar.label.text() == "workspace.db: cannot be written"
    assert window.message_bar.isVisible()


@pytest.mark.parametrize("mine", [True, False])
def test_a_file_changed_outside_waits_for_a_decision(window, hand, dataset, saved, mine):
    hand.draw(MIDDLE, (100, 50), (120, 200))
    theirs = {"Side line top": [{"x": 0.5, "y": 0.25}, {"x": 0.75, "y": 0.25}]}
    file = dataset / "frame_0.json"
    file.write_text(json.dumps(theirs))
    hand.draw("Goal left crossbar", (10, 10), (20, 20))
    assert json.loads(file.read_text()) == theirs
    assert window.conflict_bar.isVisible()
    assert window.isWindowModified()
    bar = window.conflict_bar
    (bar.overwrite_button if mine else bar.reload_button).click()
    assert not bar.isVisible()
    assert not window.isWindowModified()
    if mine:
        assert set(json.loads(file.read_text())) == {MIDDLE, "Goal left crossbar"}
    else:
        assert window.services.state.annotation.annotated == ("Side line top",)
        hand.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
        assert window.services.state.annotation.annotated == (MIDDLE, "Goal left crossbar")


@pytest.mark.new_window
def test_closing_keeps_clicks_under_way_unfinished(window, hand, dataset, saved, make_window):
    window.services.selection.select_class(MIDDLE)
    hand.click(100, 50)
    hand.click(120, 200)
    assert window.close()
    assert len(saved()) == 0
    again = make_window(dataset)
    assert len(again.services.state.annotation.get_unconfirmed(MIDDLE).points) == 2


@pytest.mark.parametrize("leave", [True, False])
def test_closing_with_unsaved_work_asks_first(window, hand, disk, monkeypatch, leave):
    asked: list[list[str]] = []

    def answer(parent: MainWindow, problems: list[str]) -> bool:
        asked.append(problems)
        return leave

    monkeypatch.setattr(main_window, "ask_to_leave_unsaved", answer)
    disk.full = True
    hand.draw(MIDDLE, (100, 50), (120, 200))
    assert window.close() is leave
    assert len(asked) == 1
    assert "No space left" in asked[0][0]
