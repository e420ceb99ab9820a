"""What an error says can be done stands beside it as a button; nothing is said twice."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog

from procc_annotator.gui.state.messages import notify, withdraw
from procc_annotator.gui.state.state import UNSAVED
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


def test_what_is_not_saved_can_be_saved_again(window):
    bar, store = window.message_bar, window.services.store
    notify(store, UNSAVED, "frame_0.json: could not be saved", "error", remedy="save")
    assert bar.remedy.isVisible()
    assert bar.remedy.text() == "Save again"
    withdraw(store, UNSAVED)
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
