"""What an error says can be done stands beside it as a button; nothing is said twice."""

import json
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog

from procc_annotator.dataset.records import Status
from procc_annotator.errors import SaveError
from tests.gui.conftest import until_kept


def test_another_place_is_a_click_away(window, hand, tmp_path, qtbot, monkeypatch):
    hand.draw("Middle line", (300, 50), (300, 300))
    bar = window.message_bar
    in_the_way = tmp_path / "file"
    in_the_way.write_text("not a folder")
    chosen = [str(in_the_way / "out.zip"), str(tmp_path / "out.zip")]
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (chosen.pop(0), "(*.zip)"))
    window.actions_["export_annotations"].trigger()
    qtbot.waitUntil(bar.isVisible)
    assert "file" in bar.label.text()
    assert bar.remedy.isVisible()
    assert bar.remedy.text() == "Choose another place…"
    qtbot.waitUntil(lambda: bar.remedy.height() > 0)
    QTest.mouseClick(bar.remedy, Qt.MouseButton.LeftButton)
    qtbot.waitUntil((tmp_path / "out.zip").exists)


@pytest.mark.parametrize(("done_only", "written"), [(True, 1), (False, 2), (None, 0)])
def test_an_export_says_what_is_not_done_and_may_leave_it_out(
    window, hand, tmp_path, qtbot, monkeypatch, done_only, written
):
    for _ in range(2):
        hand.draw("Middle line", (300, 50), (300, 300))
        window.services.navigator.next_frame()
    window.services.review.set_status("frame_0", Status.DONE)
    asked = []

    def answer(_parent: object, *counts: int) -> bool | None:
        asked.append(counts)
        return done_only

    monkeypatch.setattr("procc_annotator.gui.commands.exporting.ask_done_only", answer)
    out = tmp_path / "out"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(out), "(*)"))
    window.actions_["export_annotations"].trigger()
    assert asked == [(2, 3)]
    if written:
        qtbot.waitUntil(lambda: "exported" in window.status.hint.text())
    assert len(list(out.glob("*.json")) if out.is_dir() else []) == written


def test_copies_of_what_is_not_saved_go_elsewhere(
    window, hand, dataset, tmp_path, qtbot, monkeypatch
):
    def refuse(path: Path, *_: object, **__: object) -> None:
        raise SaveError(f"{path}: could not be saved: Permission denied")

    with monkeypatch.context() as patch:
        patch.setattr("procc_annotator.dataset.saving.write_atomic", refuse)
        bar, services = window.message_bar, window.services
        hand.draw("Middle line", (300, 50), (300, 300))
        assert window.isWindowModified()
        services.navigator.next_frame()
        assert not window.isWindowModified()  # the star is that of the frame on screen
        assert bar.label.text().count("could not be saved") == 1
        assert bar.remedy.text() == "Save copies to…"
        patch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path / "copies"))
        QApplication.processEvents()  # the bar takes its place
        QTest.mouseClick(bar.remedy, Qt.MouseButton.LeftButton)
        copy = tmp_path / "copies" / "frame_0.json"
        qtbot.waitUntil(copy.exists)
        assert len(json.loads(copy.read_text())["Middle line"]) == 2
    services.saver.retry()
    until_kept()
    assert json.loads((dataset / "frame_0.json").read_text()) == json.loads(copy.read_text())
    assert not bar.isVisible()
    window.services.say("something else", "warning")
    assert bar.isVisible()
    assert not bar.remedy.isVisible()


def test_a_damaged_file_is_told_of_once(make_window, dataset):
    (dataset / "frame_1.json").write_text('{"Middle')
    window = make_window(dataset)
    window.services.navigator.go_to(1)
    assert "frame_1.json" in window.frame_bar.label.text()
    for name in ("undo", "close_gaps", "commit"):
        window.actions_[name].trigger()
    until_kept()
    assert not window.message_bar.isVisible()
    told = window.frame_bar.label.text()
    assert told.count("frame_1.json") == 1
