"""The camera of the clicks on screen: fitted after every edit, judged, kept, hidden when blind."""

import json

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMessageBox
from pytestqt.qtbot import QtBot

from procc_annotator.assist.frame_analysis import FrameAnalysis
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import SOURCES, Settings
from tests.gui.conftest import Hand, all_done, heard, let_work_end, settle

FAR = "Side line top"


@pytest.fixture
def fitted(make_window, annotated, qtbot) -> MainWindow:
    """The window on the second frame of the sample, fitted."""
    window = make_window(annotated)
    window.services.live_fit.set_model("P")  # the quickest
    window.services.navigator.go_to(1)
    arrive(window, qtbot)
    return window


def arrive(window: MainWindow, qtbot: QtBot) -> FrameAnalysis:
    """Wait for the fit of what is on screen."""
    live = window.services.live_fit
    qtbot.waitUntil(lambda: live.insight is not None, timeout=20_000)
    qtbot.waitUntil(lambda: not window.services.scoring.waiting)
    assert live.insight is not None
    return live.insight


class TestFit:
    def test_a_drag_is_fitted_once_it_ends(self, fitted, qtbot):
        services, hand = fitted.services, Hand(fitted)
        services.selection.set_mode("edit")
        before = services.live_fit.insight
        u, v = (
            services.state.annotation.get(FAR).points[0].u,
            services.state.annotation.get(FAR).points[0].v,
        )
        start = u * 1279, v * 719
        first, viewport = hand.at(*start), fitted.canvas.viewport()
        QTest.mousePress(viewport, Qt.MouseButton.LeftButton, pos=first)
        for down in (10, 20, 30):
            last = hand.at(start[0] + 4, start[1] + down)
            hand._move(last, Qt.MouseButton.LeftButton)
            let_work_end(qtbot)
            assert (
                services.state.shown_annotation is not services.state.annotation
            )  # the drag is under way
            assert services.live_fit.insight is before
        QTest.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=last)
        insight = arrive(fitted, qtbot)
        assert insight is not before
        assert insight.annotation is services.state.annotation

    def test_switched_off_and_on_and_remembered(self, fitted, make_window, annotated, qtbot):
        fitted.actions_["live_fit"].trigger()
        services = fitted.services
        assert services.live_fit.insight is None
        assert services.state.sources == ()
        fitted.close()
        again = make_window(annotated)
        assert not again.actions_["live_fit"].isChecked()
        assert not again.services.live_fit.wanted
        assert again.services.live_fit.model == "P"
        again.actions_["live_fit"].trigger()
        arrive(again, qtbot)
        qtbot.waitUntil(lambda: [s.name for s in again.services.state.sources] == ["fit"])


class TestSource:
    def test_whoever_judges_it_finds_it_judged_the_next_time(
        self, fitted, make_window, annotated, qtbot
    ):
        sources = fitted.services.camera_sources
        sources.load_cameras(annotated / "cameras" / "true")
        sources.set_active_camera(1)
        fitted.close()
        remembered = Settings().entries(SOURCES, str(annotated.resolve()))
        assert [entry["name"] for entry in remembered] == ["true"]  # not the fit itself
        again = make_window(annotated)
        qtbot.waitUntil(lambda: again.services.state.active is not None, timeout=20_000)
        assert again.services.state.active.name == "fit"


class TestBlind:
    def test_a_locked_dataset_is_blind_for_everybody(self, fitted, make_window, annotated, qtbot):
        fitted.actions_["lock_blind"].trigger()
        services = fitted.services
        assert services.state.blind
        told = heard(services)
        fitted.actions_["blind"].trigger()
        assert services.state.blind
        assert fitted.actions_["blind"].isChecked()
        assert "locked this dataset to blind mode" in told[-1]
        assert "locked this dataset" in fitted.actions_["blind"].toolTip()
        fitted.close()
        again = make_window(annotated)
        assert again.services.state.blind
        assert again.services.live_fit.insight is None
        assert again.actions_["lock_blind"].isChecked()

    def test_in_a_locked_dataset_no_fit_ever_guides_the_clicks(self, fitted, annotated, qtbot):
        services = fitted.services
        fitted.panels.show("fit")
        services.camera_sources.load_cameras(annotated / "cameras" / "bad")
        settle(fitted.services, qtbot)
        fitted.actions_["lock_blind"].trigger()
        services.editing.commit_frame()
        settle(fitted.services, qtbot)
        assert (
            services.scorer.score is not None
        )  # cameras from files are judged once it is committed
        all_done(qtbot)
        assert services.live_fit.insight is None
        assert not services.live_fit.working
        assert not services.ghosts.painted
        assert services.ghosts.suggestion is None
        assert services.fit_source.source not in services.state.sources
        before = services.state.annotation
        told = heard(services)
        Hand(fitted).key(Qt.Key.Key_Return, Qt.KeyboardModifier.ShiftModifier)
        fitted.actions_["accept_ghosts"].trigger()
        assert services.state.annotation is before
        fitted.actions_["live_fit"].trigger()
        assert not fitted.actions_["live_fit"].isChecked()
        assert "no live fit" in told[-1]
        fitted.actions_["save_fit"].trigger()
        assert "no live fit" in told[-1]
        qtbot.waitUntil(lambda: "no live fit" in fitted.fit.empty.text())
        qtbot.waitUntil(lambda: services.label_check.checked is not None)
        fitted.actions_["uncertainty"].trigger()
        assert "no live fit" in services.uncertainty.problem
        services.blind_lock.set_locked(False)
        arrive(fitted, qtbot)
        assert fitted.actions_["live_fit"].isChecked()

    def test_the_choice_of_a_live_fit_outlives_a_locked_dataset(self, fitted, make_window, dataset):
        fitted.actions_["lock_blind"].trigger()
        assert not fitted.services.live_fit.wanted
        fitted.close()
        assert make_window(dataset).services.live_fit.wanted

    def test_unlocking_asks_and_is_recorded(self, fitted, monkeypatch):
        services = fitted.services
        fitted.actions_["lock_blind"].trigger()
        asked: list[str] = []

        def press(role: QMessageBox.ButtonRole) -> None:
            def answer(box: QMessageBox) -> int:
                asked.append(box.text() + box.informativeText())
                next(b for b in box.buttons() if box.buttonRole(b) == role).click()
                return 0

            monkeypatch.setattr(QMessageBox, "exec", answer)

        press(QMessageBox.ButtonRole.RejectRole)
        fitted.actions_["lock_blind"].trigger()
        assert services.state.blind
        assert fitted.actions_["lock_blind"].isChecked()
        press(QMessageBox.ButtonRole.AcceptRole)
        fitted.actions_["lock_blind"].trigger()
        assert not services.state.blind
        assert not fitted.actions_["lock_blind"].isChecked()
        assert "recorded" in asked[0]
        events = json.loads(services.review.setting("blind lock"))
        assert [(e["locked"], e["author"]) for e in events] == [
            (True, services.state.author),
            (False, services.state.author),
        ]
