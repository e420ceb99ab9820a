"""Going through a set worst first, marking with one key, reading why; driven as a person would."""

import csv
import io
import shutil
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.records import FaultParty, Verdict
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.services import Services
from procc_annotator.metrics.score import explain_score, worst_elements_first
from tests.gui.conftest import Hand, MakeWindow, all_done, heard

SETS = ("true", "bad")


@pytest.fixture
def sample(annotated) -> Path:
    return annotated


def opened(make_window: MakeWindow, sample: Path, qtbot: QtBot) -> MainWindow:
    """The window on the sample, both sources audited, "bad" active."""
    window = make_window(sample)
    for name in SETS:
        window.services.camera_sources.load_cameras(sample / "cameras" / name)
    window.services.camera_sources.set_active_camera(
        next(i for i, s in enumerate(window.services.state.sources) if s.name == "bad")
    )
    qtbot.waitUntil(lambda: not window.services.scoring.running, timeout=20_000)
    all_done(qtbot)
    return window


@pytest.fixture
def window(make_window, sample, qtbot) -> MainWindow:
    window = opened(make_window, sample, qtbot)
    window.services.navigator.go_to(0)
    return window


def source_of(services: Services, name: str) -> CameraSource:
    return next(source for source in services.state.sources if source.name == name)


def verdict_on(services: Services, frame: str, name: str) -> Verdict | None:
    return services.review.verdict(frame, source_of(services, name))


def press(window: MainWindow, key: Qt.Key, *modifiers: Qt.KeyboardModifier) -> None:
    combined = Qt.KeyboardModifier.NoModifier
    for modifier in modifiers:
        combined |= modifier
    QTest.keyClick(window.canvas, key, combined)


def exported(window: MainWindow, path: Path, qtbot: QtBot) -> list[dict[str, str]]:
    window.triage.export(path)
    qtbot.waitUntil(path.exists)
    all_done(qtbot)
    return list(csv.DictReader(io.StringIO(path.read_bytes().decode())))


def walk(window: MainWindow, key: Qt.Key, *modifiers: Qt.KeyboardModifier) -> list[str]:
    """Frames in the order the key visits them, until it begins again."""
    names = []
    for _ in range(40):
        press(window, key, *modifiers)
        name = window.services.state.frame.name
        if names and name == names[0]:
            return names
        names.append(name)
    raise AssertionError("the walk never begins again")


class TestWalks:
    def test_by_jac(self, window):
        window.services.navigator.go_to(4)  # not annotated: the walk begins at the worst
        ctrl, shift = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
        names = walk(window, Qt.Key.Key_W, ctrl, shift)
        scores = window.services.scoring.frame_scores
        assert sorted(names) == sorted(scores)
        jacs = [scores[name] for name in names]
        assert jacs == sorted(jacs)

    def test_begun_on_the_worst_it_says_so_and_stays(self, window):
        services = window.services
        worst = min(services.scoring.frame_scores, key=services.scoring.frame_scores.__getitem__)
        services.navigator.go_to(services.state.workspace.index[worst])
        press(window, Qt.Key.Key_W, Qt.KeyboardModifier.ControlModifier,
              Qt.KeyboardModifier.ShiftModifier)  # fmt: skip
        assert services.state.frame.name == worst
        count = len(services.scoring.frame_scores)
        assert f"1 of {count}, worst first" in window.status.hint.text()
        assert "this is the worst" in window.status.hint.text()
        press(window, Qt.Key.Key_W, Qt.KeyboardModifier.ControlModifier,
              Qt.KeyboardModifier.ShiftModifier)  # fmt: skip
        assert services.state.frame.name != worst
        assert f"2 of {count}, worst first" in window.status.hint.text()

    def test_by_largest_error(self, window):
        window.services.navigator.go_to(4)
        names = walk(window, Qt.Key.Key_F3)
        audits = window.services.state.active.audits
        errors = [float(np.nanmax(audits[name].errors_px)) for name in names]
        assert errors == sorted(errors, reverse=True)
        assert sorted(names) == sorted(n for n, a in audits.items() if len(a.errors_px))

    def test_an_edit_does_not_change_the_order_while_one_walks(self, window):
        services = window.services
        services.navigator.go_to(4)
        press(window, Qt.Key.Key_F3)
        first = services.state.frame.name
        press(window, Qt.Key.Key_F3)
        second = services.state.frame.name
        worst = worst_elements_first(
            explain_score(services.scorer.score, services.scorer.measurement, services.state.field)
        )[0]
        services.editing.commit_edit(
            "clear", services.state.annotation.without(worst.annotated_name)
        )
        services.navigator.next_frame()  # a look beside
        rest = walk(window, Qt.Key.Key_F3)
        assert rest[-2:] == [first, second]
        assert len(set(rest)) == len(rest)

    def test_by_disagreement(self, window, qtbot):
        window.services.navigator.go_to(4)
        before = window.services.state.frame
        press(window, Qt.Key.Key_F4)
        qtbot.waitUntil(lambda: window.services.state.frame is not before, timeout=20_000)
        (found,) = window.worst_first._kept.values()
        first = window.services.state.frame.name
        assert found.metres[first] == max(found.metres.values()) > 0.05
        names = [first]
        for _ in range(len(found.metres) - 1):
            press(window, Qt.Key.Key_F4)
            names.append(window.services.state.frame.name)
        metres = [found.metres[name] for name in names]
        assert metres == sorted(metres, reverse=True)
        assert set(names) == set(found.metres)

    def test_whoever_moved_on_is_not_taken_away(self, window, qtbot):
        press(window, Qt.Key.Key_F4)
        window.services.navigator.go_to(3)
        qtbot.waitUntil(lambda: bool(window.worst_first._kept), timeout=20_000)
        assert window.services.state.frame_index == 3

    def test_without_a_second_source_it_says_what_to_do(self, make_window, sample, qtbot):
        window = make_window(sample)
        window.services.camera_sources.load_cameras(sample / "cameras" / "bad")
        with qtbot.waitSignal(window.services.store.events.message) as told:
            press(window, Qt.Key.Key_F4)
        assert "two sources are needed" in told.args[0].text


class TestVerdicts:
    def test_one_key_marks_and_the_same_key_takes_it_back(self, window, qtbot):
        services = window.services
        frame = services.state.frame.name
        press(window, Qt.Key.Key_F7)
        assert verdict_on(services, frame, "bad").fault is FaultParty.CAMERA
        assert verdict_on(services, frame, "true") is None
        assert window.frames.model.info(0).verdict is FaultParty.CAMERA
        press(window, Qt.Key.Key_F8)
        assert verdict_on(services, frame, "bad").fault is FaultParty.ANNOTATION
        press(window, Qt.Key.Key_F8)
        assert verdict_on(services, frame, "bad") is None
        assert window.frames.model.info(0).verdict is None

    def test_the_buttons_say_it_and_mark_too(self, window, qtbot):
        window.panels.show("scores")
        buttons = window.scores.verdict.buttons
        press(window, Qt.Key.Key_F7)
        qtbot.waitUntil(buttons[FaultParty.CAMERA].isChecked)
        qtbot.mouseClick(buttons[FaultParty.FINE], Qt.MouseButton.LeftButton)
        assert verdict_on(window.services, "00001", "bad").fault is FaultParty.FINE
        assert not buttons[FaultParty.CAMERA].isChecked()
        window.services.navigator.go_to(1)
        qtbot.waitUntil(lambda: not buttons[FaultParty.FINE].isChecked())

    def test_it_is_there_when_the_dataset_is_opened_again_and_exported(
        self, window, make_window, sample, qtbot, tmp_path
    ):
        press(window, Qt.Key.Key_F7)
        window.services.navigator.go_to(2)
        press(window, Qt.Key.Key_F9)
        services = window.services
        services.review.set_verdict(
            "00003", source_of(services, "bad"), FaultParty.FINE, "as sharp as it gets"
        )
        jac = window.services.scoring.frame_scores["00003"]
        window.close()
        again = opened(make_window, sample, qtbot)
        assert verdict_on(again.services, "00001", "bad").fault is FaultParty.CAMERA
        path = tmp_path / "verdicts.csv"
        again.triage.export(path)
        qtbot.waitUntil(path.exists)
        all_done(qtbot)
        first, second = csv.DictReader(io.StringIO(path.read_bytes().decode()))
        assert (first["frame"], first["source"], first["verdict"]) == ("00001", "bad", "camera")
        assert (second["frame"], second["verdict"]) == ("00003", "fine")
        assert second["comment"] == "as sharp as it gets"
        assert float(second["jac@5px"]) == pytest.approx(jac, abs=1e-5)
        assert float(second["largest_error_px"]) == pytest.approx(
            np.nanmax(again.services.state.active.audits["00003"].errors_px), abs=2e-3
        )

    def test_they_go_along_when_their_source_gets_another_name(self, window, qtbot, tmp_path):
        services = window.services
        window.panels.show("scores")
        press(window, Qt.Key.Key_F7)
        services.camera_sources.rename_source(services.state.active, "vendor X")
        assert window.frames.model.info(0).verdict is FaultParty.CAMERA
        qtbot.waitUntil(window.scores.verdict.buttons[FaultParty.CAMERA].isChecked)
        (row,) = exported(window, tmp_path / "verdicts.csv", qtbot)
        assert (row["source"], row["problem"]) == ("vendor X", "")
        assert row["jac@5px"]

    def test_another_source_of_the_same_name_does_not_inherit_them(
        self, window, sample, qtbot, tmp_path
    ):
        services = window.services
        press(window, Qt.Key.Key_F7)
        services.camera_sources.remove_camera_set(
            services.state.sources.index(services.state.active)
        )
        other = tmp_path / "elsewhere" / "bad"
        shutil.copytree(sample / "cameras" / "true", other)
        services.camera_sources.load_cameras(other)
        assert services.state.active.name == "bad"
        assert window.frames.model.info(0).verdict is None
        (row,) = exported(window, tmp_path / "verdicts.csv", qtbot)
        assert row["problem"] == "the source cameras/bad is not loaded"
        assert row["jac@5px"] == ""
        press(window, Qt.Key.Key_F9)  # says nothing of the one that is gone
        services.camera_sources.load_cameras(sample / "cameras" / "bad", name="back again")
        assert window.frames.model.info(0).verdict is FaultParty.CAMERA

    def test_the_frames_can_be_filtered_by_it(self, window, qtbot):
        for index in (1, 5):
            window.services.navigator.go_to(index)
            press(window, Qt.Key.Key_F8)
        window.frames.filter.setText("verdict:annotation")
        qtbot.waitUntil(lambda: window.frames.model.rowCount() == 2)
        press(window, Qt.Key.Key_F8)
        qtbot.waitUntil(lambda: window.frames.model.rowCount() == 1)

    def test_blind_nothing_is_marked_or_shown(self, window, qtbot):
        services = window.services
        press(window, Qt.Key.Key_F7)
        services.blind_lock.set_blind(True)
        assert window.frames.model.info(0).verdict is None
        with qtbot.waitSignal(services.store.events.message) as told:
            press(window, Qt.Key.Key_F7)
        assert "blind" in told.args[0].text
        services.blind_lock.set_blind(False)
        assert verdict_on(services, "00001", "bad").fault is FaultParty.CAMERA

    def test_blind_verdicts_on_committed_frames_only_are_exported(self, window, qtbot, tmp_path):
        services = window.services
        for index in (0, 1):
            services.navigator.go_to(index)
            press(window, Qt.Key.Key_F7)
        services.editing.commit_frame()
        services.blind_lock.set_blind(True)
        told = heard(services)
        (shown,) = exported(window, tmp_path / "verdicts.csv", qtbot)
        assert "leaves out 1 " in told[-1]
        assert shown["frame"] == "00002"
        assert shown["jac@5px"]
        assert shown["largest_error_px"]

    def test_nothing_to_export_is_said(self, window, qtbot, tmp_path):
        with qtbot.waitSignal(window.services.store.events.message) as told:
            window.triage.export(tmp_path / "v.csv")
        assert "no frame has a verdict" in told.args[0].text
        assert not (tmp_path / "v.csv").exists()


class TestStatusLine:
    @staticmethod
    def told(window: MainWindow) -> str:
        assert window.status.hint.toolTip() == window.status.hint.text()
        return window.status.hint.text()

    def test_blind_mode_takes_back_what_was_said_of_the_camera(self, window, qtbot):
        window.worst_first.go_worst()
        assert "JaC" in self.told(window)
        press(window, Qt.Key.Key_B)
        assert "JaC" not in self.told(window)
        qtbot.waitUntil(lambda: "BLIND" in self.told(window))

    def test_what_was_said_of_a_frame_goes_with_it(self, window, qtbot):
        press(window, Qt.Key.Key_F7)
        assert "00001: camera fault" in self.told(window)
        all_done(qtbot)
        press(window, Qt.Key.Key_D)
        assert window.services.state.frame.name == "00002"
        assert "00001" not in self.told(window)

    def test_what_leaving_a_frame_did_stays(self, window, qtbot):
        hand = Hand(window)
        window.services.navigator.go_to(4)
        window.services.selection.select_class("Middle line")
        hand.click(400, 200)
        hand.click(420, 400)
        all_done(qtbot)
        window.services.navigator.next_frame()
        assert "finished" in self.told(window)


class TestExplainer:
    @pytest.fixture
    def panel(self, window, qtbot):
        window.services.navigator.go_to(1)
        window.panels.show("scores")
        # The panel says in its own time what the frame before had no more than three rows of.
        qtbot.waitUntil(lambda: len(window.scores.model.rows) > 3)
        return window.scores

    def test_every_row_says_why(self, window, panel):
        services = window.services
        expected = worst_elements_first(
            explain_score(services.scorer.score, services.scorer.measurement, services.state.field)
        )
        assert [row.element.sentence for row in panel.model.rows] == [e.sentence for e in expected]
        assert any("too far: point" in row.element.sentence for row in panel.model.rows)

    def test_a_click_selects_flies_and_says_why(self, window, panel, qtbot):
        services = window.services
        rect = panel.table.visualRect(panel.model.index(0, 0))
        with qtbot.waitSignal(services.store.events.flyTo) as flown:
            qtbot.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, pos=rect.center())
        row, element = panel.model.rows[0], panel.model.rows[0].element
        assert services.state.selection.point == (row.class_name, element.deciding_point)
        point = services.state.annotation.get(row.class_name).points[element.deciding_point]
        width, height = services.state.picture_size
        assert flown.args == pytest.approx([point.u * (width - 1), point.v * (height - 1)])
        qtbot.waitUntil(lambda: panel.why.text() == row.element.sentence)

    def test_arrows_and_enter_do_the_same(self, window, panel, qtbot):
        services = window.services
        panel.table.setFocus(Qt.FocusReason.TabFocusReason)
        panel.table.selectRow(0)
        with qtbot.waitSignal(services.store.events.flyTo):
            qtbot.keyClick(panel.table, Qt.Key.Key_Down)
        assert services.state.selected_class == panel.model.rows[1].class_name
        qtbot.waitUntil(lambda: panel.why.text() == panel.model.rows[1].element.sentence)
        with qtbot.waitSignal(services.store.events.flyTo):
            qtbot.keyClick(panel.table, Qt.Key.Key_Return)

    def test_selecting_elsewhere_does_not_fly(self, window, panel, qtbot):
        panel.table.setFocus(Qt.FocusReason.TabFocusReason)
        with qtbot.assertNotEmitted(window.services.store.events.flyTo, wait=150):
            window.services.selection.select_class(panel.model.rows[2].class_name)
        assert panel.why.text() == panel.model.rows[2].element.sentence

    def test_the_sentence_is_never_cut_off(self, window, panel, qtbot):
        services = window.services
        longest = max(panel.model.rows, key=lambda row: len(row.element.sentence))
        services.selection.select_class(longest.class_name)
        qtbot.waitUntil(lambda: panel.why.text() == longest.element.sentence)
        all_done(qtbot)
        assert panel.why.height() >= panel.why.heightForWidth(panel.why.width())

    def test_it_can_be_copied(self, window, panel):
        panel._copy_all()
        assert QGuiApplication.clipboard().text().splitlines() == [
            row.element.sentence for row in panel.model.rows
        ]
