"""The camera of the clicks: fitted after every edit, judged, kept, hidden when blind."""

import csv
import json
import re
import sys
import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QMessageBox, QToolButton, QWidget
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.frame_analysis import FrameAnalysis, analyse_frame
from procc_annotator.batch.calibration import save_fit
from procc_annotator.calibration.result import ill_conditioned_reason
from procc_annotator.dataset.editing import delete_point
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.gui.commands.exporting import Exporter
from procc_annotator.gui.commands.triage import Triage
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.cameras import CamerasPanel
from procc_annotator.gui.panels.fit import FitPanel
from procc_annotator.gui.panels.plots.page import PlotSources
from procc_annotator.gui.panels.widgets import ElidedLabel
from procc_annotator.gui.settings import SOURCES, Settings
from procc_annotator.gui.state.prediction import live_fit
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.window.top_bar import CameraBar
from tests.gui.conftest import Hand, all_done, heard, let_work_end, settle

FAR = "Side line top"


@pytest.fixture
def services(open_services, annotated, qtbot) -> Services:
    """The second frame of the sample, fitted; the first one was not looked at."""
    services = open_services(annotated)
    services.live_fit.set_model("P")  # the quickest
    services.navigator.go_to(1)
    arrive(services, qtbot)
    return services


def arrive(services: Services, qtbot: QtBot) -> FrameAnalysis:
    """Wait for the fit of what is on screen."""
    live = services.live_fit
    qtbot.waitUntil(lambda: live.insight is not None)
    qtbot.waitUntil(lambda: not services.scoring.waiting)
    assert live.insight is not None
    return live.insight


def nudged(annotation: FrameAnnotation, by: float, index: int = 0) -> FrameAnnotation:
    """A point of the far touchline moved down by a share of the picture."""
    line = annotation.get(FAR)
    points = list(line.points)
    points[index] = points[index]._replace(v=points[index].v + by)
    moved = replace(line, points=tuple(points))
    others = tuple(moved if p is line else p for p in annotation.polylines)
    return replace(annotation, polylines=others)


def without(annotation: FrameAnnotation, keep: int) -> FrameAnnotation:
    """The first few elements only."""
    return replace(annotation, polylines=annotation.polylines[:keep])


@pytest.fixture
def slow_fits(monkeypatch) -> Callable[[], threading.Event]:
    """Fits that wait for a word; `asked` counts what was begun."""

    def hold() -> threading.Event:
        go, real = threading.Event(), analyse_frame

        def wait(annotation: FrameAnnotation, *more: Any, **terms: Any) -> FrameAnalysis:
            go.wait(20)
            return real(annotation, *more, **terms)

        monkeypatch.setattr(live_fit, "analyse_frame", wait)
        return go

    return hold


def test_it_is_the_camera_of_the_clicks(services, annotated):
    fit = services.live_fit.result
    path = annotated / "cameras" / "true" / "camera_00002.json"
    true = read_camera_file(path.read_bytes(), path=str(path))
    assert fit.size == services.state.picture_size
    assert np.hypot(*np.subtract(fit.camera.position_world, true.camera.position_world)[:2]) < 8


def test_of_a_burst_of_edits_only_the_last_one_is_shown(services, qtbot, slow_fits):
    start = services.state.annotation
    go, shown = slow_fits(), []
    services.live_fit.changed.connect(lambda: shown.append(services.live_fit.insight))
    for step in range(1, 6):
        assert services.editing.commit_edit("nudge", nudged(start, 0.002 * step))
        assert services.live_fit.insight is None
        assert services.live_fit.working
    go.set()
    insight = arrive(services, qtbot)
    assert insight.annotation is services.state.annotation
    assert {id(i) for i in shown if i is not None} == {id(insight)}
    let_work_end(qtbot)
    assert services.live_fit.insight is insight


def test_bursts_do_not_queue(services, qtbot, monkeypatch):
    begun: list[FrameAnnotation] = []
    go, real = threading.Event(), analyse_frame

    def wait(annotation: FrameAnnotation, *more: Any, **terms: Any) -> FrameAnalysis:
        begun.append(annotation)
        go.wait(20)
        return real(annotation, *more, **terms)

    monkeypatch.setattr(live_fit, "analyse_frame", wait)
    start = services.state.annotation
    services.editing.commit_edit("nudge", nudged(start, 0.001))
    qtbot.waitUntil(lambda: len(begun) == 1)
    for step in range(2, 12):
        services.editing.commit_edit("nudge", nudged(start, 0.001 * step))
    go.set()
    arrive(services, qtbot)
    assert len(begun) == 2  # the one under way, and the newest


def test_frames_that_are_only_passed_are_not_fitted(services, qtbot, monkeypatch):
    begun: list[FrameAnnotation] = []

    def note(annotation: FrameAnnotation, *more: Any, **terms: Any) -> FrameAnalysis:
        begun.append(annotation)
        return analyse_frame(annotation, *more, **terms)

    monkeypatch.setattr(live_fit, "analyse_frame", note)
    for _ in range(4):
        services.navigator.next_frame()
        assert services.live_fit.working
    arrive(services, qtbot)
    assert [id(annotation) for annotation in begun] == [id(services.state.annotation)]


def test_a_closed_window_works_for_nobody(services, qtbot, slow_fits):
    go = slow_fits()
    services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.004))
    services.close()
    go.set()
    services.live_fit.invalidate()
    assert not services.live_fit.working
    let_work_end(qtbot)
    assert services.live_fit.insight is None


def test_what_was_fitted_before_is_there_at_once(services, qtbot, slow_fits):
    second = services.live_fit.insight
    services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.004))
    arrive(services, qtbot)
    services.navigator.go_to(2)
    third = arrive(services, qtbot)
    assert third is not second
    go = slow_fits()
    services.navigator.go_to(1)
    assert services.live_fit.insight is not None
    services.editing.undo()
    assert services.live_fit.insight is second
    services.navigator.go_to(2)
    assert services.live_fit.insight is third
    go.set()


def test_a_frame_that_was_left_is_never_shown_on_another(services, qtbot, slow_fits):
    services.camera_sources.set_active_camera(0)
    assert services.scorer.score is not None
    go = slow_fits()
    services.navigator.go_to(4)  # nothing is annotated
    assert services.live_fit.insight is None
    assert services.scorer.score is None
    assert services.fit_source.cameras.camera("00005", (960, 540)) is None
    go.set()
    assert arrive(services, qtbot).annotation is services.state.annotation
    assert services.live_fit.result.failure is not None


@pytest.fixture
def bugs(monkeypatch) -> list[BaseException]:
    """Exceptions that nobody expected; they fail the test otherwise."""
    raised: list[BaseException] = []
    monkeypatch.setattr(sys, "excepthook", lambda kind, error, trace: raised.append(error))
    return raised


def test_a_fit_that_fails_unexpectedly_is_told_and_the_next_one_is_done(
    services, qtbot, monkeypatch, bugs
):
    def fail(*_: Any, **__: Any) -> FrameAnalysis:
        raise ZeroDivisionError("in a fit")

    told = []
    services.store.events.message.connect(lambda m: told.append((m.text, m.level)))
    with monkeypatch.context() as broken:
        broken.setattr(live_fit, "analyse_frame", fail)
        services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.004))
        qtbot.waitUntil(lambda: bool(told))
    (text, level), (bug,) = told[0], bugs
    assert level == "warning"
    assert "the fit failed: unexpected error (ZeroDivisionError: in a fit)" in text
    assert isinstance(bug, ZeroDivisionError)
    assert not services.live_fit.working
    services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.004))
    arrive(services, qtbot)


def test_clicks_made_while_a_fit_failed_are_fitted(services, qtbot, monkeypatch, bugs):
    go = threading.Event()
    begun: list[FrameAnnotation] = []

    def fail_first(annotation: FrameAnnotation, *more: Any, **terms: Any) -> FrameAnalysis:
        begun.append(annotation)
        if len(begun) == 1:
            go.wait(20)
            raise ZeroDivisionError("in a fit")
        return analyse_frame(annotation, *more, **terms)

    monkeypatch.setattr(live_fit, "analyse_frame", fail_first)
    services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.004))
    qtbot.waitUntil(lambda: len(begun) == 1)
    services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.004))
    go.set()
    assert arrive(services, qtbot).annotation is services.state.annotation
    assert len(bugs) == 1


def test_three_elements_show_the_field(services, qtbot):
    whole = services.state.annotation
    services.camera_sources.set_active_camera(0)
    services.editing.commit_edit("fewer", without(whole, 2))
    insight = arrive(services, qtbot)
    assert insight.fit.failure == "2 elements, 3 needed"
    assert services.scorer.score is None
    assert "2 elements, 3 needed" in services.scorer.shown.notice
    services.editing.commit_edit("more", without(whole, 3))
    arrive(services, qtbot)
    assert services.scorer.score is not None
    assert len(services.scorer.measurement.projected.pieces) > 3


def test_its_score_follows_the_clicks(services, qtbot):
    services.camera_sources.set_active_camera(0)
    name = services.state.frame.name
    assert services.scoring.active_audits[name].jac_at(5.0) == pytest.approx(
        services.scorer.score.jac
    )
    services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.05))
    arrive(services, qtbot)
    worst = max(e.max_distance or 0.0 for e in services.scorer.score.elements)
    assert worst > 5.0
    assert services.scoring.active_audits[name].jac_at(5.0) == pytest.approx(
        services.scorer.score.jac
    )
    services.evaluation.set_protocol("procc")
    settle(services, qtbot)
    assert services.scoring.active_audits[name].jac_at(5.0) == pytest.approx(
        services.scorer.score.jac
    )


def test_it_is_compared_with_a_method(services, annotated, qtbot):
    services.camera_sources.load_cameras(annotated / "cameras" / "bad")
    settle(services, qtbot)
    assert [s.name for s in services.state.sources] == ["bad", "fit"]
    assert services.state.compared.name == "fit"
    measurement, score = services.scorer.compared
    assert measurement is not None
    assert score.jac > services.scorer.score.jac
    services.disagreement.set_enabled(True)
    qtbot.waitUntil(lambda: services.disagreement.value is not None)
    before = services.disagreement.value
    services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.05))
    arrive(services, qtbot)
    qtbot.waitUntil(
        lambda: (
            services.disagreement.value is not None and services.disagreement.value is not before
        ),
    )
    assert services.disagreement.value.names == ("bad", "fit")


def test_a_fit_that_arrives_takes_no_score_from_others(services, annotated, qtbot):
    """While the set is audited, only the fit of a frame is known anew, nothing of a method."""
    services.camera_sources.load_cameras(annotated / "cameras" / "true")
    services.live_fit.set_model("R")
    arrive(services, qtbot)
    settle(services, qtbot)
    assert "00002" in services.scoring.active_audits


def test_only_frames_looked_at_count(services, qtbot):
    services.navigator.go_to(2)
    arrive(services, qtbot)
    settle(services, qtbot)
    assert set(services.fit_source.source.audits) == {"00002", "00003"}
    assert set(services.fit_source.cameras.frames) == {"00002", "00003"}


def test_it_enters_no_scores_and_no_verdicts(services, annotated, tmp_path, widget, qtbot):
    services.camera_sources.set_active_camera(0)
    told = heard(services)
    out = tmp_path / "jac.csv"
    exporter = Exporter(services, widget)
    exporter.write_scores(out)
    assert not out.exists()
    assert "made from the clicks" in told[-1]
    Triage(services, widget).mark("fine")
    assert "follows the clicks" in told[-1]
    assert services.review.all_verdicts() == {}
    services.camera_sources.load_cameras(annotated / "cameras" / "true")
    settle(services, qtbot)
    exporter.write_scores(out)
    qtbot.waitUntil(out.exists)
    rows = list(csv.DictReader(out.read_text().splitlines()))
    assert {Path(row["camera"]).name for row in rows if row["camera"]} <= {
        p.name for p in (annotated / "cameras" / "true").iterdir()
    }


def test_a_folder_called_fit_gets_another_name(services, annotated):
    (annotated / "cameras" / "true").rename(annotated / "cameras" / "fit")
    assert services.camera_sources.load_cameras(annotated / "cameras" / "fit")
    assert [s.name for s in services.state.sources] == ["fit (2)", "fit"]
    services.camera_sources.rename_source(services.state.sources[1], "method")
    assert services.state.sources[1].name == "fit"


def save(services: Services, qtbot: QtBot) -> str:
    told = heard(services)
    Exporter(services, QWidget()).save_fit()
    qtbot.waitUntil(lambda: any("sav" in text for text in told))
    return told[-1]


def test_the_file_holds_the_camera_and_what_it_was_fitted_from(services, annotated, qtbot):
    path = annotated / "cameras" / "fitted" / "camera_00002.json"
    assert str(path) in save(services, qtbot)
    loaded = read_camera_file(path.read_bytes(), path=str(path))
    fit = services.live_fit.result
    assert loaded.camera.position_world == fit.camera.position_world
    assert loaded.camera.tilt_rad == pytest.approx(fit.camera.tilt_rad, rel=1e-14)
    assert loaded.size == (1280, 720)
    assert json.loads(path.read_text())["fit"]["model"] == "P"


def test_each_fit_is_written_however_soon_the_next_is_asked_for(services, annotated, widget, qtbot):
    told = heard(services)
    exporter = Exporter(services, widget)
    for _ in range(2):
        exporter.save_fit()
    qtbot.waitUntil(lambda: sum("is saved as" in text for text in told) == 2)


def test_a_single_picture_keeps_its_fit_in_its_folder(open_services, annotated, qtbot):
    services = open_services(annotated / "00002.jpg")
    arrive(services, qtbot)
    path = annotated / "cameras" / "fitted" / "camera_00002.json"
    assert str(path) in save(services, qtbot)
    assert path.exists()
    services.camera_sources.load_cameras(path.parent)
    assert services.review.place(services.state.sources[0]).endswith(":cameras/fitted")


def test_a_loaded_folder_shows_the_new_camera(services, annotated, qtbot):
    save(services, qtbot)
    services.camera_sources.load_cameras(annotated / "cameras" / "fitted")
    settle(services, qtbot)
    assert services.state.active.name == "fitted"
    before = services.scorer.score
    services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.03))
    arrive(services, qtbot)
    source, fit = services.state.active, services.live_fit.result
    save(services, qtbot)
    qtbot.waitUntil(
        lambda: len(services.state.sources) == 2 and services.scorer.score is not before
    )
    settle(services, qtbot)
    assert services.state.active is source
    shown = services.scorer.camera.position_world
    assert shown == pytest.approx(fit.camera.position_world)


def test_a_camera_of_somebody_else_stays(services, annotated, qtbot):
    folder = annotated / "cameras" / "fitted"
    folder.mkdir()
    theirs = folder / "camera_00002.json"
    theirs.write_bytes((annotated / "cameras" / "bad" / "camera_00002.json").read_bytes())
    before = theirs.read_bytes()
    assert "was not saved as a fit" in save(services, qtbot)
    assert theirs.read_bytes() == before


def test_a_failing_save_is_told_once(services, annotated, widget, qtbot):
    (annotated / "cameras" / "fitted").write_text("in the way")
    told: list[tuple[str, str]] = []
    services.store.events.message.connect(lambda m: told.append((m.text, m.level)))
    Exporter(services, widget).save_fit()
    qtbot.waitUntil(lambda: bool(told))
    let_work_end(qtbot)
    assert [level for _, level in told] == ["error"]
    assert "is a file, expected a folder" in told[0][0]


def test_nothing_is_known_until_the_frame_is_committed(services, qtbot):
    services.camera_sources.set_active_camera(0)
    services.blind_lock.set_blind(True)
    assert services.live_fit.insight is None
    assert services.scorer.score is None
    assert services.scorer.camera is None
    assert services.fit_source.source.audits == {}
    assert not services.fit_source.cameras.fits
    services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.004))
    let_work_end(qtbot)
    assert services.live_fit.insight is None
    assert not services.fit_source.cameras.fits
    assert not services.live_fit.working
    services.editing.commit_frame()
    arrive(services, qtbot)
    assert services.scorer.score is not None


def test_the_annotators_own_choice_comes_back_with_another_dataset(services, dataset):
    services.blind_lock.set_locked(True)
    assert services.state.blind
    assert services.opening.open_path(dataset)
    assert not services.state.blind


def test_it_is_listed_but_judged_only_on_request(services, show, qtbot):
    assert [s.name for s in services.state.sources] == ["fit"]
    assert services.state.active is None
    assert services.scorer.score is None
    panel = show(CamerasPanel(services))
    qtbot.waitUntil(lambda: panel.findChild(QLabel, "cameras_matched_0") is not None)
    qtbot.waitUntil(lambda: panel.findChild(QLabel, "cameras_matched_0").text() == "1 opened frame")
    services.camera_sources.set_active_camera(0)
    assert services.scorer.score.jac > 0.9
    assert show(CameraBar(services)).jac.text().endswith("of the fit")


def test_it_says_that_it_is_of_these_clicks(services, show, annotated, qtbot):
    folder = annotated / "cameras" / "kept"
    name = services.state.frame.name
    fit = services.live_fit.insight.fit
    save_fit(folder, name, services.state.annotation, fit, field=services.state.field.name)
    services.camera_sources.load_cameras(folder)
    panel = show(CamerasPanel(services))
    settle(services, qtbot)
    mark = "fitted on these clicks"
    marks = {s.name: s.fitted.mark for s in services.state.sources}
    assert marks == {"kept": mark, "fit": mark}
    for row in (0, 1):
        label = panel.findChild(ElidedLabel, f"cameras_model_{row}")
        qtbot.waitUntil(lambda label=label: mark in label.toolTip())
    request = PlotSources(services).request("set", None)
    assert all(source.fitted for source in request.sources)
    services.editing.commit_edit("nudge", nudged(services.state.annotation, 0.05))
    arrive(services, qtbot)
    settle(services, qtbot)
    other = "fitted to another version of these annotations"
    assert {s.name: s.fitted.mark for s in services.state.sources} == {
        "kept": other,
        "fit": mark,
    }
    label = panel.findChild(ElidedLabel, "cameras_model_0")
    qtbot.waitUntil(lambda: other in label.toolTip())


def test_removing_it_switches_the_live_fit_off(services, show, annotated, qtbot):
    services.camera_sources.load_cameras(annotated / "cameras" / "true")
    services.camera_sources.set_active_camera(1)
    panel = show(CamerasPanel(services))
    qtbot.waitUntil(lambda: panel.findChild(QToolButton, "cameras_remove_1") is not None)
    panel.findChild(QToolButton, "cameras_remove_1").click()
    assert not services.live_fit.wanted
    assert [s.name for s in services.state.sources] == ["true"]
    assert services.state.active.name == "true"


def fit_panel(services: Services, show: Callable[[FitPanel], FitPanel]) -> FitPanel:
    panel = FitPanel(services)
    panel.add_actions(QAction(panel, checkable=True, checked=True), QAction(panel))
    return show(panel)


def test_it_says_model_figures_and_elements(services, show, qtbot):
    panel = fit_panel(services, show)
    qtbot.waitUntil(lambda: bool(panel.rows.rows))
    assert panel.jac.text() == "1.000"
    assert panel.at_tau.text() == "JaC at 5.0 px"
    assert "soccernet, 960x540" in panel.terms.text()
    assert "1280x720" in panel.terms.text()
    assert panel.chosen.text() == "P: pinhole"
    largest = [float(row.largest) for row in panel.rows.rows]
    assert largest == sorted(largest, reverse=True)
    assert panel.pose[3][2].text().endswith("%)")
    services.live_fit.set_model("auto")
    arrive(services, qtbot)
    qtbot.waitUntil(lambda: "Chosen: " in panel.chosen.text())


def test_an_element_left_out_says_so_and_a_click_goes_to_its_worst_point(services, show, qtbot):
    panel = fit_panel(services, show)
    services.editing.commit_edit("wrong", nudged(services.state.annotation, 0.2))
    arrive(services, qtbot)
    qtbot.waitUntil(lambda: any(row.left_out for row in panel.rows.rows))
    row = panel.rows.rows[0]
    assert (row.class_name, row.words) == (FAR, "✕ left out: Far touchline")
    flown = []
    services.store.events.flyTo.connect(lambda x, y: flown.append((x, y)))
    place = panel.table.visualRect(panel.rows.index(0, 0)).center()
    QTest.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert services.state.selection.point == (FAR, 0)
    point = services.state.annotation.get(FAR).points[0]
    assert flown == [pytest.approx((point.u * 1279, point.v * 719))]


def test_a_row_of_the_clicks_before_leads_to_an_element_that_has_got_shorter(
    services, show, qtbot, slow_fits
):
    panel = fit_panel(services, show)
    whole = services.state.annotation
    last = len(whole.get(FAR).points) - 1
    services.editing.commit_edit("wrong", nudged(whole, 0.2, last))
    arrive(services, qtbot)
    qtbot.waitUntil(
        lambda: [(row.class_name, row.point) for row in panel.rows.rows[:1]] == [(FAR, last)]
    )
    at = next(i for i, row in enumerate(panel.rows.rows) if row.class_name == FAR)
    go, flown = slow_fits(), []
    services.store.events.flyTo.connect(lambda x, y: flown.append((x, y)))
    services.editing.commit_edit("shorten", delete_point(services.state.annotation, FAR, last))
    place = panel.table.visualRect(panel.rows.index(at, 0)).center()
    QTest.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert services.state.selected_class == FAR
    first = services.state.annotation.get(FAR).points[0]
    assert flown == [pytest.approx((first.u * 1279, first.v * 719))]
    go.set()


def test_it_says_what_counts_against_it_though_nothing_annotated_is_off(services, show, qtbot):
    panel = fit_panel(services, show)
    whole = "12 of 12 annotated elements within 5 px"
    qtbot.waitUntil(lambda: panel.counted.text() == whole)
    services.editing.commit_edit("fewer", without(services.state.annotation, 5))
    said = re.compile(r"5 of 5 annotated elements within 5 px; (\d+) in sight not annotated yet")
    qtbot.waitUntil(lambda: said.fullmatch(panel.counted.text()) is not None)
    waiting = int(said.fullmatch(panel.counted.text())[1])
    assert float(panel.jac.text()) == pytest.approx(5 / (5 + waiting), abs=1e-3)


def test_it_says_why_there_is_no_camera(services, show, qtbot):
    panel = fit_panel(services, show)
    services.editing.commit_edit("fewer", without(services.state.annotation, 2))
    qtbot.waitUntil(lambda: "2 elements, 3 needed" in panel.empty.text())
    assert panel.empty.isVisible()
    assert not panel.save.isEnabled()
    services.blind_lock.set_blind(True)
    qtbot.waitUntil(lambda: panel.empty.text().startswith("Blind"))
    services.blind_lock.set_blind(False)
    services.live_fit.set_wanted(False)
    qtbot.waitUntil(lambda: panel.empty.text().startswith("The live fit is off"))


def test_a_camera_that_is_hardly_determined_is_called_so(services, show, qtbot):
    panel = fit_panel(services, show)
    qtbot.waitUntil(lambda: panel.chosen.text().startswith("P"))
    assert panel.weak.isHidden()
    assert "hardly determined" not in save(services, qtbot)
    services.editing.commit_edit("fewer", without(services.state.annotation, 3))
    qtbot.waitUntil(panel.weak.isVisible)
    left_open = ill_conditioned_reason(services.live_fit.result)
    assert panel.weak.text().endswith(f": {left_open}")
    assert save(services, qtbot).endswith(f"hardly determined: {left_open}")


@pytest.fixture
def fitted(make_window, annotated, qtbot) -> MainWindow:
    """The window on the second frame of the sample, fitted."""
    window = make_window(annotated)
    window.services.live_fit.set_model("P")  # the quickest
    window.services.navigator.go_to(1)
    arrive(window.services, qtbot)
    return window


def test_a_drag_is_fitted_once_it_ends(fitted, qtbot):
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
    insight = arrive(fitted.services, qtbot)
    assert insight is not before
    assert insight.annotation is services.state.annotation


def test_switched_off_and_on_and_remembered(fitted, make_window, annotated, qtbot):
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
    arrive(again.services, qtbot)
    qtbot.waitUntil(lambda: [s.name for s in again.services.state.sources] == ["fit"])


def test_whoever_judges_it_finds_it_judged_the_next_time(fitted, make_window, annotated, qtbot):
    sources = fitted.services.camera_sources
    sources.load_cameras(annotated / "cameras" / "true")
    sources.set_active_camera(1)
    fitted.close()
    remembered = Settings().entries(SOURCES, str(annotated.resolve()))
    assert [entry["name"] for entry in remembered] == ["true"]  # not the fit itself
    again = make_window(annotated)
    qtbot.waitUntil(lambda: again.services.state.active is not None)
    assert again.services.state.active.name == "fit"


def test_a_locked_dataset_is_blind_for_everybody(fitted, make_window, annotated, qtbot):
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


def test_in_a_locked_dataset_no_fit_ever_guides_the_clicks(fitted, annotated, qtbot):
    services = fitted.services
    fitted.panels.show("fit")
    services.camera_sources.load_cameras(annotated / "cameras" / "bad")
    settle(fitted.services, qtbot)
    fitted.actions_["lock_blind"].trigger()
    services.editing.commit_frame()
    settle(fitted.services, qtbot)
    assert services.scorer.score is not None  # cameras from files are judged once it is committed
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
    arrive(fitted.services, qtbot)
    assert fitted.actions_["live_fit"].isChecked()


def test_the_choice_of_a_live_fit_outlives_a_locked_dataset(fitted, make_window, dataset):
    fitted.actions_["lock_blind"].trigger()
    assert not fitted.services.live_fit.wanted
    fitted.close()
    assert make_window(dataset).services.live_fit.wanted


def test_unlocking_asks_and_is_recorded(fitted, monkeypatch):
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
