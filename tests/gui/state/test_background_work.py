"""Background work while another dataset is opened, or something is closed, edited or chosen."""

import csv
import json
import shutil
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from procc_annotator.field.load import load_field
from procc_annotator.gui.commands.exporting import ExportAs, Exporter
from procc_annotator.gui.panels.agreement import AgreementPanel
from procc_annotator.gui.state import background
from procc_annotator.gui.state.background import run_in_background
from procc_annotator.gui.state.scoring import dataset_scores
from procc_annotator.report import conversion
from tests.gui.conftest import draw, heard, let_work_end

TOP, MIDDLE, BOTTOM = "Side line top", "Middle line", "Side line bottom"


def annotate(folder: Path, frame: str, name: str, height: float = 0.5) -> None:
    folder.mkdir(exist_ok=True)
    points = [{"x": 0.1, "y": height}, {"x": 0.9, "y": height}]
    (folder / f"{frame}.json").write_text(json.dumps({name: points}))


@pytest.fixture
def other(dataset, tmp_path) -> Path:
    """A dataset with pictures of the same names, annotated otherwise."""
    shutil.copytree(dataset, tmp_path / "other")
    for number in range(3):
        annotate(dataset, f"frame_{number}", TOP)
        annotate(tmp_path / "other", f"frame_{number}", BOTTOM)
    return tmp_path / "other"


@contextmanager
def busy(threads: int = background._THREADS[background.Priority.LOW]) -> Iterator[None]:
    """Whatever walks over a set has to wait its turn meanwhile."""
    go = threading.Event()
    for _ in range(threads):
        run_in_background(lambda _: go.wait(20), on_result=lambda _: None, on_error=lambda _: None)
    try:
        yield
    finally:
        go.set()


class Stop:
    """Lets a function get as far as its n-th call, which waits to be let go on."""

    def __init__(self, function: Callable[..., Any], call: int = 1) -> None:
        self.function, self.left = function, call
        self.reached, self.go = threading.Event(), threading.Event()

    def __call__(self, *given: Any, **named: Any) -> Any:
        self.left -= 1
        if self.left == 0:
            self.reached.set()
            self.go.wait(20)
        return self.function(*given, **named)


def test_an_export_is_of_the_dataset_it_was_asked_for(
    widget, open_services, dataset, other, tmp_path, qtbot
):
    services = open_services(dataset)
    let_work_end(qtbot)
    with busy():
        Exporter(services, widget).write_annotations(tmp_path / "out")
        assert services.opening.open_path(other)
        services.evaluation.set_field(load_field("tennis"))
    qtbot.waitUntil((tmp_path / "out" / "frame_2.json").exists)
    assert list(json.loads((tmp_path / "out" / "frame_0.json").read_text())) == [TOP]
    let_work_end(qtbot)


def test_the_overview_is_exported_whole_or_not_at_all(
    widget, open_services, dataset, other, tmp_path, qtbot, monkeypatch
):
    services = open_services(dataset)
    let_work_end(qtbot)
    for name in ("whole.csv", "stopped.csv"):
        slow = Stop(services.state.workspace.read, 2)
        monkeypatch.setattr(services.state.workspace, "read", slow)
        Exporter(services, widget).write_overview(tmp_path / name)
        assert slow.reached.wait(10)
        monkeypatch.undo()
        if name == "stopped.csv":
            background.cancel_all()  # as at the end of the program
        slow.go.set()
        let_work_end(qtbot)
    with (tmp_path / "whole.csv").open(newline="") as file:
        assert len(list(csv.DictReader(file))) == 3
    assert not (tmp_path / "stopped.csv").exists()


@pytest.mark.parametrize("what", ["overview", "provenance"])
def test_where_points_come_from_is_exported_whole_or_not_at_all(
    widget, open_services, dataset, other, tmp_path, qtbot, what
):
    services = open_services(dataset)
    draw(services, MIDDLE)
    services.navigator.next_frame()
    let_work_end(qtbot)
    told, path = heard(services), tmp_path / "out"
    with busy():
        getattr(Exporter(services, widget), f"write_{what}")(path)
        assert services.opening.open_path(other)  # what is remembered of the first one is put away
    qtbot.waitUntil(lambda: any("origins" in text for text in told))
    assert not path.exists()


def test_what_is_exported_while_the_set_is_scored_is_said_to_be_unfinished(
    widget, open_services, annotated, tmp_path, qtbot
):
    services = open_services(annotated)
    services.live_fit.set_wanted(False)
    let_work_end(qtbot)
    told = heard(services)
    with busy(background._THREADS[background.Priority.LOW] - 1):
        slow = Stop(dataset_scores._audit, 3)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(dataset_scores, "_audit", slow)
            assert services.camera_sources.load_cameras(annotated / "cameras" / "true")
            assert slow.reached.wait(10)
        Exporter(services, widget).write_overview(tmp_path / "overview.csv")
    try:
        qtbot.waitUntil(lambda: any("overview.csv" in text for text in told))
    finally:
        slow.go.set()
    assert "some frames have no JaC yet" in next(t for t in told if "overview.csv" in t)
    let_work_end(qtbot)
    Exporter(services, widget).write_overview(tmp_path / "later.csv")
    qtbot.waitUntil(lambda: any("later.csv" in text for text in told))
    assert "JaC" not in next(t for t in told if "later.csv" in t)


def test_an_export_that_another_dataset_cuts_short_is_told(
    widget, open_services, dataset, other, tmp_path, qtbot, monkeypatch
):
    services = open_services(dataset)
    let_work_end(qtbot)
    slow = Stop(conversion.export_as)
    monkeypatch.setattr(conversion, "export_as", slow)
    told, export = heard(services), ExportAs(services, widget)
    export.ask()
    export.start(tmp_path / "out")
    assert slow.reached.wait(10)
    assert services.opening.open_path(other)
    slow.go.set()
    qtbot.waitUntil(lambda: any("still there" in text for text in told))


def test_a_landmark_clicked_while_clicks_are_looked_for_is_known(services, qtbot, monkeypatch):
    let_work_end(qtbot)
    slow = Stop(services.state.workspace.read, 2)
    monkeypatch.setattr(services.state.workspace, "read", slow)
    assert services.landmarks.add("roof")
    assert services.landmarks.frames_with("roof") is None
    qtbot.waitUntil(slow.reached.is_set)  # the frame on screen was looked at
    draw(services, "roof")
    services.navigator.next_frame()
    slow.go.set()
    qtbot.waitUntil(lambda: services.landmarks.frames_with("roof") is not None)
    assert services.landmarks.frames_with("roof") == ("frame_0",)


@pytest.mark.parametrize("how", ["closed", "another annotator", "another dataset"])
def test_the_noise_of_an_annotator_who_was_closed_is_not_shown(
    show, open_services, dataset, other, tmp_path, qtbot, how
):
    for number in range(3):
        annotate(tmp_path / "second", f"frame_{number}", TOP, 0.51)
    services = open_services(dataset)
    show(AgreementPanel(services))
    let_work_end(qtbot)
    if how == "another annotator":
        services.second_annotator.open(tmp_path / "second")
        qtbot.waitUntil(lambda: services.state.noise_floor is not None)
    with busy():
        services.second_annotator.open(tmp_path / "second" if how != "another annotator" else other)
        if how == "closed":
            services.second_annotator.close()
        elif how == "another dataset":
            assert services.opening.open_path(other)
        # Until the other one is read, the first stays.
        assert (services.state.noise_floor is None) == (how != "another annotator")
    let_work_end(qtbot)
    assert services.state.noise_floor is None  # no element is annotated by both


def test_a_field_chosen_while_a_file_is_read_stays(open_services, dataset, tmp_path, qtbot):
    path = tmp_path / "court.toml"
    shutil.copy(str(load_field("basketball_fiba").source), path)
    services = open_services(dataset)
    choice = services.field_choice
    choice.take(load_field(path))
    let_work_end(qtbot)
    slow = Stop(choice._prepared)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(choice, "_prepared", slow)
        choice.read_again()
        assert slow.reached.wait(10)
    choice.choose("tennis")
    qtbot.waitUntil(lambda: services.state.field.name == "tennis")
    slow.go.set()
    let_work_end(qtbot)
    assert services.state.field.name == "tennis"
