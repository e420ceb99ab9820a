"""Going through a set worst first, marking with one key, reading why; driven as a person would."""

import csv
import io
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.records import FaultParty, Verdict
from procc_annotator.gui.commands.frame_walks import WorstFirst
from procc_annotator.gui.commands.triage import Triage
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.frames import FramesPanel
from procc_annotator.gui.panels.scores import ScoresPanel
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.services import Services
from procc_annotator.interaction.hints import KEYS, SEPARATOR
from procc_annotator.metrics.score import explain_score, worst_elements_first
from tests.gui.conftest import Hand, OpenServices, all_done, heard

SETS = ("true", "bad")


@pytest.fixture
def sample(annotated) -> Path:
    return annotated


def opened(open_services: OpenServices, sample: Path, qtbot: QtBot) -> Services:
    """The sample, both sources audited, "bad" active."""
    services = open_services(sample)
    for name in SETS:
        services.camera_sources.load_cameras(sample / "cameras" / name)
    services.camera_sources.set_active_camera(
        next(i for i, s in enumerate(services.state.sources) if s.name == "bad")
    )
    qtbot.waitUntil(lambda: not services.scoring.running)
    all_done(qtbot)
    return services


@pytest.fixture
def services(open_services, sample, qtbot) -> Services:
    services = opened(open_services, sample, qtbot)
    services.navigator.go_to(0)
    return services


@pytest.fixture
def triage(services, widget) -> Triage:
    return Triage(services, widget)


@pytest.fixture
def worst(services) -> WorstFirst:
    return WorstFirst(services)


@pytest.fixture
def frames(services, show) -> FramesPanel:
    return show(FramesPanel(services))


def source_of(services: Services, name: str) -> CameraSource:
    return next(source for source in services.state.sources if source.name == name)


def verdict_on(services: Services, frame: str, name: str) -> Verdict | None:
    return services.review.verdict(frame, source_of(services, name))


def press(window: MainWindow, key: Qt.Key) -> None:
    QTest.keyClick(window.canvas, key)


def exported(triage: Triage, path: Path, qtbot: QtBot) -> list[dict[str, str]]:
    triage.export(path)
    qtbot.waitUntil(path.exists)
    all_done(qtbot)
    return list(csv.DictReader(io.StringIO(path.read_bytes().decode())))


def walk(services: Services, step: Callable[[], None]) -> list[str]:
    """Frames in the order the key visits them, until it begins again."""
    names = []
    for _ in range(40):
        step()
        name = services.state.frame.name
        if names and name == names[0]:
            return names
        names.append(name)
    raise AssertionError("the walk never begins again")


class TestWalks:
    def test_by_jac(self, worst, services):
        services.navigator.go_to(4)  # not annotated: the walk begins at the worst

        names = walk(services, worst.go_worst)
        scores = services.scoring.frame_scores
        assert sorted(names) == sorted(scores)
        jacs = [scores[name] for name in names]
        assert jacs == sorted(jacs)

    def test_begun_on_the_worst_it_says_so_and_stays(self, worst, said, services):
        lowest = min(services.scoring.frame_scores, key=services.scoring.frame_scores.__getitem__)
        services.navigator.go_to(services.state.workspace.index[lowest])
        worst.go_worst()
        assert services.state.frame.name == lowest
        count = len(services.scoring.frame_scores)
        assert f"1 of {count}, worst first" in said[-1]
        assert "this is the worst" in said[-1]
        worst.go_worst()
        assert services.state.frame.name != lowest
        assert f"2 of {count}, worst first" in said[-1]

    def test_by_largest_error(self, worst, services):
        services.navigator.go_to(4)
        names = walk(services, worst.go_largest_error)
        audits = services.state.active.audits
        errors = [float(np.nanmax(audits[name].errors_px)) for name in names]
        assert errors == sorted(errors, reverse=True)
        assert sorted(names) == sorted(n for n, a in audits.items() if len(a.errors_px))

    def test_an_edit_does_not_change_the_order_while_one_walks(self, worst, services):
        services.navigator.go_to(4)
        worst.go_largest_error()
        first = services.state.frame.name
        worst.go_largest_error()
        second = services.state.frame.name
        element = worst_elements_first(
            explain_score(services.scorer.score, services.scorer.measurement, services.state.field)
        )[0]
        services.editing.commit_edit(
            "clear", services.state.annotation.without(element.annotated_name)
        )
        services.navigator.next_frame()  # a look beside
        rest = walk(services, worst.go_largest_error)
        assert rest[-2:] == [first, second]
        assert len(set(rest)) == len(rest)

    def test_by_disagreement(self, worst, services, qtbot):
        services.navigator.go_to(4)
        before = services.state.frame
        worst.go_disagreement()
        qtbot.waitUntil(lambda: services.state.frame is not before)
        (found,) = worst._kept.values()
        first = services.state.frame.name
        assert found.metres[first] == max(found.metres.values()) > 0.05
        names = [first]
        for _ in range(len(found.metres) - 1):
            worst.go_disagreement()
            names.append(services.state.frame.name)
        metres = [found.metres[name] for name in names]
        assert metres == sorted(metres, reverse=True)
        assert set(names) == set(found.metres)

    def test_whoever_moved_on_is_not_taken_away(self, worst, services, qtbot):
        worst.go_disagreement()
        services.navigator.go_to(3)
        qtbot.waitUntil(lambda: bool(worst._kept))
        assert services.state.frame_index == 3

    def test_without_a_second_source_it_says_what_to_do(self, services, worst, said):
        services.live_fit.set_wanted(False)
        services.camera_sources.remove_camera_set(0)
        worst.go_disagreement()
        assert "two sources are needed" in said[-1]


class TestVerdicts:
    def test_one_key_marks_and_the_same_key_takes_it_back(self, frames, triage, services, qtbot):
        frame = services.state.frame.name
        triage.mark("camera")
        assert verdict_on(services, frame, "bad").fault is FaultParty.CAMERA
        assert verdict_on(services, frame, "true") is None
        assert frames.model.info(0).verdict is FaultParty.CAMERA
        triage.mark("annotation")
        assert verdict_on(services, frame, "bad").fault is FaultParty.ANNOTATION
        triage.mark("annotation")
        assert verdict_on(services, frame, "bad") is None
        assert frames.model.info(0).verdict is None

    def test_the_buttons_say_it_and_mark_too(self, triage, services, qtbot, show):
        panel = show(ScoresPanel(services))
        triage.serve(panel.verdict)
        buttons = panel.verdict.buttons
        triage.mark("camera")
        qtbot.waitUntil(buttons[FaultParty.CAMERA].isChecked)
        qtbot.mouseClick(buttons[FaultParty.FINE], Qt.MouseButton.LeftButton)
        assert verdict_on(services, "00001", "bad").fault is FaultParty.FINE
        assert not buttons[FaultParty.CAMERA].isChecked()
        services.navigator.go_to(1)
        qtbot.waitUntil(lambda: not buttons[FaultParty.FINE].isChecked())

    def test_it_is_there_when_the_dataset_is_opened_again_and_exported(
        self, triage, services, open_services, sample, qtbot, tmp_path, widget
    ):
        triage.mark("camera")
        services.navigator.go_to(2)
        triage.mark("fine")
        services.review.set_verdict(
            "00003", source_of(services, "bad"), FaultParty.FINE, "as sharp as it gets"
        )
        jac = services.scoring.frame_scores["00003"]
        services.close()
        again = opened(open_services, sample, qtbot)
        assert verdict_on(again, "00001", "bad").fault is FaultParty.CAMERA
        path = tmp_path / "verdicts.csv"
        Triage(again, widget).export(path)
        qtbot.waitUntil(path.exists)
        all_done(qtbot)
        first, second = csv.DictReader(io.StringIO(path.read_bytes().decode()))
        assert (first["frame"], first["source"], first["verdict"]) == ("00001", "bad", "camera")
        assert (second["frame"], second["verdict"]) == ("00003", "fine")
        assert second["comment"] == "as sharp as it gets"
        assert float(second["jac@5px"]) == pytest.approx(jac, abs=1e-5)
        assert float(second["largest_error_px"]) == pytest.approx(
            np.nanmax(again.state.active.audits["00003"].errors_px), abs=2e-3
        )

    def test_they_go_along_when_their_source_gets_another_name(
        self, frames, triage, services, qtbot, tmp_path, show
    ):
        panel = show(ScoresPanel(services))
        triage.mark("camera")
        services.camera_sources.rename_source(services.state.active, "vendor X")
        assert frames.model.info(0).verdict is FaultParty.CAMERA
        qtbot.waitUntil(panel.verdict.buttons[FaultParty.CAMERA].isChecked)
        (row,) = exported(triage, tmp_path / "verdicts.csv", qtbot)
        assert (row["source"], row["problem"]) == ("vendor X", "")
        assert row["jac@5px"]

    def test_another_source_of_the_same_name_does_not_inherit_them(
        self, frames, triage, services, sample, qtbot, tmp_path
    ):
        triage.mark("camera")
        services.camera_sources.remove_camera_set(
            services.state.sources.index(services.state.active)
        )
        other = tmp_path / "elsewhere" / "bad"
        shutil.copytree(sample / "cameras" / "true", other)
        services.camera_sources.load_cameras(other)
        assert services.state.active.name == "bad"
        assert frames.model.info(0).verdict is None
        (row,) = exported(triage, tmp_path / "verdicts.csv", qtbot)
        assert row["problem"] == "the source cameras/bad is not loaded"
        assert row["jac@5px"] == ""
        triage.mark("fine")  # says nothing of the one that is gone
        services.camera_sources.load_cameras(sample / "cameras" / "bad", name="back again")
        assert frames.model.info(0).verdict is FaultParty.CAMERA

    def test_the_frames_can_be_filtered_by_it(self, frames, triage, services, qtbot):
        for index in (1, 5):
            services.navigator.go_to(index)
            triage.mark("annotation")
        frames.filter.setText("verdict:annotation")
        qtbot.waitUntil(lambda: frames.model.rowCount() == 2)
        triage.mark("annotation")
        qtbot.waitUntil(lambda: frames.model.rowCount() == 1)

    def test_blind_nothing_is_marked_or_shown(self, frames, triage, services, qtbot):
        triage.mark("camera")
        services.blind_lock.set_blind(True)
        assert frames.model.info(0).verdict is None
        with qtbot.waitSignal(services.store.events.message) as told:
            triage.mark("camera")
        assert "blind" in told.args[0].text
        services.blind_lock.set_blind(False)
        assert verdict_on(services, "00001", "bad").fault is FaultParty.CAMERA

    def test_blind_verdicts_on_committed_frames_only_are_exported(
        self, triage, services, qtbot, tmp_path
    ):
        for index in (0, 1):
            services.navigator.go_to(index)
            triage.mark("camera")
        services.editing.commit_frame()
        services.blind_lock.set_blind(True)
        told = heard(services)
        (shown,) = exported(triage, tmp_path / "verdicts.csv", qtbot)
        assert "leaves out 1 " in told[-1]
        assert shown["frame"] == "00002"
        assert shown["jac@5px"]
        assert shown["largest_error_px"]

    def test_nothing_to_export_is_said(self, triage, services, qtbot, tmp_path):
        with qtbot.waitSignal(services.store.events.message) as told:
            triage.export(tmp_path / "v.csv")
        assert "no frame has a verdict" in told.args[0].text
        assert not (tmp_path / "v.csv").exists()


class TestStatusLine:
    @pytest.fixture
    def window(self, make_window, sample, qtbot) -> MainWindow:
        window = make_window(sample)
        assert window.services.camera_sources.load_cameras(sample / "cameras" / "bad")
        qtbot.waitUntil(lambda: not window.services.scoring.running)
        all_done(qtbot)
        return window

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
        assert "00001: camera wrong" in self.told(window)
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

    def test_what_was_said_of_an_act_goes_with_the_next_one(self, window, qtbot):
        hand = Hand(window)
        window.services.navigator.go_to(4)
        QTest.keyClick(window.canvas, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
        assert "nothing to undo" in self.told(window)
        all_done(qtbot)
        window.services.selection.select_class("Middle line")
        hand.click(400, 200)
        assert "nothing to undo" not in self.told(window)

    def test_a_long_message_leaves_the_keys_of_the_hint(self, window):
        hint = window.status.hint
        window.status.tell("accepted 1 of 5 ghosts; skipped (under 50% visible): " + "front, " * 20)
        keys = hint.text().rpartition(KEYS)[2].split(SEPARATOR)
        shown = hint.text_for(1000)
        assert shown.startswith("accepted 1 of 5 ghosts; skipped")
        assert keys[0] in shown
        assert hint.fontMetrics().horizontalAdvance(shown) <= 1000


class TestExplainer:
    @pytest.fixture
    def panel(self, services, show, qtbot):
        services.navigator.go_to(1)
        panel = show(ScoresPanel(services))
        # The panel says in its own time what the frame before had no more than three rows of.
        qtbot.waitUntil(lambda: len(panel.model.rows) > 3)
        return panel

    def test_every_row_says_why(self, services, panel):
        expected = worst_elements_first(
            explain_score(services.scorer.score, services.scorer.measurement, services.state.field)
        )
        assert [row.element.sentence for row in panel.model.rows] == [e.sentence for e in expected]
        assert any("too far: point" in row.element.sentence for row in panel.model.rows)

    def test_a_click_selects_flies_and_says_why(self, services, panel, qtbot):
        rect = panel.table.visualRect(panel.model.index(0, 0))
        with qtbot.waitSignal(services.store.events.flyTo) as flown:
            qtbot.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, pos=rect.center())
        row, element = panel.model.rows[0], panel.model.rows[0].element
        assert services.state.selection.point == (row.class_name, element.deciding_point)
        point = services.state.annotation.get(row.class_name).points[element.deciding_point]
        width, height = services.state.picture_size
        assert flown.args == pytest.approx([point.u * (width - 1), point.v * (height - 1)])
        qtbot.waitUntil(lambda: panel.why.text() == row.element.sentence)

    def test_arrows_and_enter_do_the_same(self, services, panel, qtbot):
        panel.table.setFocus(Qt.FocusReason.TabFocusReason)
        panel.table.selectRow(0)
        with qtbot.waitSignal(services.store.events.flyTo):
            qtbot.keyClick(panel.table, Qt.Key.Key_Down)
        assert services.state.selected_class == panel.model.rows[1].class_name
        qtbot.waitUntil(lambda: panel.why.text() == panel.model.rows[1].element.sentence)
        with qtbot.waitSignal(services.store.events.flyTo):
            qtbot.keyClick(panel.table, Qt.Key.Key_Return)

    def test_selecting_elsewhere_does_not_fly(self, services, panel, qtbot):
        panel.table.setFocus(Qt.FocusReason.TabFocusReason)
        with qtbot.assertNotEmitted(services.store.events.flyTo, wait=150):
            services.selection.select_class(panel.model.rows[2].class_name)
        assert panel.why.text() == panel.model.rows[2].element.sentence

    def test_the_sentence_is_never_cut_off(self, services, panel, qtbot):
        longest = max(panel.model.rows, key=lambda row: len(row.element.sentence))
        services.selection.select_class(longest.class_name)
        qtbot.waitUntil(lambda: panel.why.text() == longest.element.sentence)
        all_done(qtbot)
        assert panel.why.height() >= panel.why.heightForWidth(panel.why.width())

    def test_it_can_be_copied(self, services, panel):
        panel._copy_all()
        assert QGuiApplication.clipboard().text().splitlines() == [
            row.element.sentence for row in panel.model.rows
        ]
