"""Blind mode: nothing of a camera before the commit, and what is said of edits after it."""

import csv
import io
import json
import re
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtWidgets import QDialogButtonBox, QLabel
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.records import Status
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.element_states import ElementState, element_states
from procc_annotator.gui.panels.plots.pages import TauPage, TimelinePage
from procc_annotator.gui.settings import SWITCHES, Settings
from procc_annotator.interaction.overlay_primitives import EMPTY_OVERLAY
from procc_annotator.report.overlay_scene import OverlayLook
from tests.gui.conftest import Hand, all_done, heard, settle

HERE, OTHER = "00002", "00003"  # on screen, not committed; committed
EMPTY = "00001"
# What is left of the frame on screen, so that there are ghosts.
KEPT = ("Big rect. left bottom", "Big rect. left main", "Big rect. left top", "Circle left")
KEPT = (*KEPT, "Goal left crossbar")
CTRL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def dataset(annotated) -> Path:
    """Three frames of the sample: one empty, one with five elements, one with all."""
    for path in annotated.glob("0*.*"):
        if path.stem not in (EMPTY, HERE, OTHER):
            path.unlink()
    (annotated / f"{EMPTY}.json").unlink(missing_ok=True)
    path = annotated / f"{HERE}.json"
    entries = json.loads(path.read_text())
    path.write_text(json.dumps({name: entries[name] for name in KEPT}))
    return annotated


@pytest.fixture
def window(make_window, dataset, qtbot) -> MainWindow:
    """Judged by wrong cameras beside the true ones, fitted, everything switched on; one frame is
    committed."""
    window = make_window(dataset)
    services = window.services
    services.live_fit.set_model("P")
    for name in ("true", "bad"):
        assert services.camera_sources.load_cameras(dataset / "cameras" / name)
    services.navigator.go_to(services.state.workspace.index[OTHER])
    services.editing.commit_frame()
    window.triage.mark("camera")
    services.navigator.go_to(services.state.workspace.index[HERE])
    qtbot.waitUntil(lambda: services.live_fit.insight is not None)
    settle(window.services, qtbot)
    window.triage.mark("camera")
    for name in ("scores", "fit", "cameras"):
        window.panels.show(name)
    return window


# --- what could tell of a camera ------------------------------------------------------------------


@dataclass
class Look:
    """Looks at the window as somebody would who wants to know how a camera does."""

    window: MainWindow
    folder: Path
    qtbot: QtBot

    def bar(self) -> object:
        return re.search(r"\d", self.window.top_bar.camera_bar.jac.text())

    def status_line(self) -> object:
        canvas = self.window.canvas
        canvas.cursorMoved.emit((640.0, 500.0))
        status = self.window.status
        return status.metres.text() + status.apart.text() + status.good_to.text()

    def overlay(self) -> object:
        strokes = self.window.canvas.overlay_item.overlay.strokes
        return [s for s in strokes if s.layer in ("projection", "whisker") and len(s.segments)]

    def wireframes_of_others(self) -> object:
        return self.window.canvas.comparison.wireframes is not EMPTY_OVERLAY

    def ghosts(self) -> object:
        ghosts = self.window.services.ghosts
        return ghosts.painted or ghosts.suggestion

    def scores_panel(self) -> object:
        self.window.panels.show("scores")
        self._pass()
        return self.window.scores.jac.isVisible()

    def verdict_button(self) -> object:
        self.window.scores.verdict.refresh()
        return any(button.isChecked() for button in self.window.scores.verdict.buttons.values())

    def fit_panel(self) -> object:
        self.window.panels.show("fit")
        self._pass()
        return self.window.fit.mean.isVisible()

    def source_rows(self) -> object:
        self.window.panels.show("cameras")
        self._pass()
        label = self.window.findChild(QLabel, "cameras_jac_0")
        return re.search(r"\d", label.text() + label.toolTip())

    def field_map(self) -> object:
        """Turned to the camera, or the part it sees marked."""
        return self.window.services.visible_region.shown

    def legend_in_the_corner(self) -> object:
        legend = self.window.canvas.legend
        legend._look()
        return [e for e in legend.entries if e.text != "annotated, in its class's colour"]

    def elements(self) -> object:
        states = element_states(self.window.services).values()
        return {ElementState.PASSES, ElementState.TOO_FAR, ElementState.NOT_ANNOTATED} & set(states)

    def row_of_the_frame(self) -> object:
        model = self.window.frames.model
        row = model.row_of(self.window.services.state.frame_index)
        info = model.info(row)
        tip = model.data(model.index(row), Qt.ItemDataRole.ToolTipRole)
        return info.jac is not None or info.verdict is not None or "JaC" in tip

    def filter_by_jac(self) -> object:
        return self._filtered("jac:<=1")

    def filter_by_verdict(self) -> object:
        return self._filtered("verdict:camera")

    def walk_by_jac(self) -> object:
        return self._walked(self.window.worst_first.go_worst)

    def walk_by_error(self) -> object:
        return self._walked(self.window.worst_first.go_largest_error)

    def walk_by_disagreement(self) -> object:
        return self._walked(self.window.worst_first.go_disagreement)

    def plot_of_the_set(self) -> object:
        return self._plotted("set")

    def plot_of_the_frame(self) -> object:
        return self._plotted("frame")

    def exported_scores(self) -> object:
        text = self._written("jac.csv", self.window.exporter.write_scores)
        return HERE in text

    def exported_verdicts(self) -> object:
        return HERE in self._written("verdicts.csv", self.window.triage.export)

    def exported_overview(self) -> object:
        text = self._written("overview.csv", self.window.exporter.write_overview)
        rows = {row["name"]: row for row in csv.DictReader(io.StringIO(text, newline=""))}
        return rows[HERE]["jac"]

    def overlay_picture(self) -> object:
        text = self._written("picture.svg", self._write_picture)
        return "JaC" in text or "too far" in text

    def disagreement(self) -> object:
        return self.window.services.disagreement.value

    def uncertainty(self) -> object:
        services = self.window.services
        services.uncertainty.set_enabled(True)
        all_done(self.qtbot)
        found = services.uncertainty.value
        services.disagreement.set_enabled(True)
        all_done(self.qtbot)
        return found

    def saved_fit(self) -> object:
        folder = self.folder / "sample" / "cameras" / "fitted"
        with self.qtbot.waitSignal(self.window.services.store.events.message):
            self.window.actions_["save_fit"].trigger()
        there = folder.exists()
        shutil.rmtree(folder, ignore_errors=True)
        return there

    def split_view(self) -> object:
        compared, score = self.window.services.scorer.compared
        return compared or score

    def field_dimensions(self) -> object:
        self.window.actions_["field_dimensions"].trigger()
        dialog = self.window.field_dimensions.dialog
        dialog.estimate_button.click()
        self.qtbot.waitUntil(lambda: bool(dialog.found.text()) and dialog.bar.isHidden())
        said = dialog.found.text()
        dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Cancel).click()
        return "2 frames" in said

    # --- how it is looked at ---

    def _pass(self) -> None:
        all_done(self.qtbot)

    def _filtered(self, text: str) -> bool:
        frames = self.window.frames
        frames.filter.setText(text)
        all_done(self.qtbot)
        found = [frames.model.data(frames.model.index(i)) for i in range(frames.model.rowCount())]
        frames.filter.clear()
        all_done(self.qtbot)
        assert OTHER in found or "verdict" in text
        return HERE in found

    def _walked(self, step: Callable[[], None]) -> bool:
        services = self.window.services
        here, seen = services.state.frame_index, set()
        services.navigator.go_to(services.state.workspace.index[EMPTY])
        for _ in range(3):
            step()
            all_done(self.qtbot)
            self.qtbot.waitUntil(lambda: not self.window.worst_first._comparing.running)
            seen.add(services.state.frame.name)
        services.navigator.go_to(here)
        all_done(self.qtbot)
        self.qtbot.waitUntil(lambda: not services.live_fit.working)
        return HERE in seen

    def _plotted(self, scope: str) -> bool:
        plots = self.window.plots
        self.window.panels.show("plots")
        plots.scope.setCurrentIndex(plots.scope.findData(scope))
        plots.choose(TimelinePage.title if scope == "set" else TauPage.title)
        self._pass()
        self.qtbot.waitUntil(lambda: not plots.busy)
        if plots.page.is_empty:
            return False
        rows = csv.DictReader(io.StringIO(self._written("plot.csv", plots.save_numbers)))
        return scope == "frame" or any(r["jac@5 bad"] for r in rows if r["frame"] == HERE)

    def _write_picture(self, path: Path) -> None:
        assert self.window.overlay_saving.write(path, OverlayLook(legend=True))

    def _written(self, name: str, write: Callable[[Path], object]) -> str:
        path = self.folder / name
        path.unlink(missing_ok=True)
        write(path)
        self.qtbot.waitUntil(path.exists)
        all_done(self.qtbot)
        text = path.read_text(encoding="utf-8")
        path.unlink()
        return text


LOOKS = [name for name in vars(Look) if not name.startswith("_") and callable(vars(Look)[name])]


def telling(look: Look) -> list[str]:
    return [name for name in LOOKS if getattr(look, name)()]


def test_nothing_tells_how_a_camera_does_before_the_commit(window, tmp_path, qtbot):
    look, services = Look(window, tmp_path, qtbot), window.services
    services.disagreement.set_enabled(True)
    qtbot.waitUntil(lambda: services.disagreement.value is not None)
    assert telling(look) == LOOKS  # or nothing would be tested below
    services.blind_lock.set_blind(True)
    all_done(qtbot)
    assert telling(look) == []
    services.editing.commit_frame()
    qtbot.waitUntil(lambda: services.live_fit.insight is not None)
    all_done(qtbot)
    # A mean over the set is of frames that are not committed, too.
    assert telling(look) == [name for name in LOOKS if name != "source_rows"]


# --- the commit, and edits after it ---------------------------------------------------------------


@pytest.fixture
def blind(make_window, dataset, qtbot) -> MainWindow:
    """The window on a frame that nobody committed, in blind mode, with cameras and no fit."""
    window = make_window(dataset)
    services = window.services
    services.live_fit.set_wanted(False)
    services.blind_lock.set_blind(True)
    assert services.camera_sources.load_cameras(dataset / "cameras" / "bad")
    services.navigator.go_to(services.state.workspace.index[HERE])
    settle(window.services, qtbot)
    return window


@pytest.fixture
def told(blind) -> list[str]:
    return heard(blind.services)


def nudge(window: MainWindow) -> None:
    """Move a point by a key."""
    services = window.services
    services.selection.set_mode("edit")
    services.selection.select_point(KEPT[0], 0)
    Hand(window).key(Qt.Key.Key_Right)


def said_in_review(window: MainWindow, qtbot: QtBot) -> str:
    window.panels.show("review")
    all_done(qtbot)
    label = window.findChild(QLabel, "reviewBlind")
    return label.text() if label.isVisible() else ""


def in_overview(window: MainWindow, path: Path, qtbot: QtBot) -> dict[str, str]:
    window.exporter.write_overview(path)
    qtbot.waitUntil(path.exists)
    rows = csv.DictReader(io.StringIO(path.read_text(encoding="utf-8"), newline=""))
    return {row["name"]: row["blind"] for row in rows}


def test_an_edit_after_the_cameras_were_shown_is_told_everywhere(blind, told, tmp_path, qtbot):
    services = blind.services
    assert said_in_review(blind, qtbot) == ""
    services.editing.commit_frame()
    assert "as it was then" in said_in_review(blind, qtbot)
    nudge(blind)
    assert services.review.status(HERE) is Status.IN_PROGRESS
    assert "edited after the cameras were shown" in told[-1]
    assert said_in_review(blind, qtbot) == "Edited after the cameras were shown."
    services.navigator.go_to(services.state.workspace.index[OTHER])
    services.editing.commit_frame()
    assert in_overview(blind, tmp_path / "overview.csv", qtbot) == {
        EMPTY: "",
        HERE: "edited after the cameras were shown",
        OTHER: "blind",
    }
    provenance = tmp_path / "provenance.json"
    blind.exporter.write_provenance(provenance)
    qtbot.waitUntil(provenance.exists)
    entries = json.loads(provenance.read_text(encoding="utf-8"))["blind"]
    assert {name: entry[:2] for name, entry in entries.items()} == {
        HERE: ["edited after the cameras were shown", services.state.author],
        OTHER: ["blind", services.state.author],
    }


def test_committing_again_does_not_make_it_blind_work_but_taking_the_edit_back_does(
    blind, make_window, dataset, qtbot
):
    services = blind.services
    services.editing.commit_frame()
    nudge(blind)
    services.editing.commit_frame()
    assert services.review.status(HERE) is Status.DONE
    assert said_in_review(blind, qtbot).startswith("Edited")
    services.editing.undo()
    assert said_in_review(blind, qtbot).startswith("Committed in blind mode")
    blind.close()
    again = make_window(dataset)  # also read from the file
    again.services.navigator.go_to(again.services.state.workspace.index[HERE])
    assert said_in_review(again, qtbot).startswith("Committed in blind mode")


def test_taking_an_edit_back_makes_the_frame_done_again(blind, told):
    blind.services.editing.commit_frame()
    nudge(blind)
    blind.services.editing.undo()
    assert blind.services.review.status(HERE) is Status.DONE
    assert f"{HERE} is done again" in told[-1]


def test_what_was_committed_with_cameras_shown_is_no_blind_work(blind, told, qtbot):
    services = blind.services
    services.blind_lock.set_blind(False)
    services.editing.commit_frame()
    services.blind_lock.set_blind(True)
    services.editing.commit_frame()
    assert said_in_review(blind, qtbot) == ""
    nudge(blind)
    assert services.review.status(HERE) is Status.DONE
    assert not [text for text in told if "cameras were shown" in text]


def test_an_empty_frame_is_committed_by_the_second_key_only(blind, told, qtbot):
    services, hand = blind.services, Hand(blind)
    services.navigator.go_to(services.state.workspace.index[EMPTY])
    hand.key(Qt.Key.Key_Return, CTRL)
    assert "Ctrl+Enter again shows the cameras" in told[-1]
    assert not services.state.projection_visible
    services.navigator.go_to(services.state.workspace.index[HERE])
    services.navigator.go_to(services.state.workspace.index[EMPTY])
    hand.key(Qt.Key.Key_Return, CTRL)  # it was asked for long ago
    assert not services.state.projection_visible
    hand.key(Qt.Key.Key_Return, CTRL)
    assert services.state.projection_visible
    hand.draw("Middle line", (300, 300), (500, 500))
    assert said_in_review(blind, qtbot) == "Edited after the cameras were shown."


def test_exporting_says_what_blind_mode_leaves_out(blind, told, tmp_path, qtbot):
    path = tmp_path / "jac.csv"
    blind.actions_["export_scores"].trigger()  # asks for no file
    assert "no frame is committed yet" in told[-1]
    blind.exporter.write_scores(path)
    assert "no frame is committed yet" in told[-1]
    assert not path.exists()
    blind.services.editing.commit_frame()
    blind.exporter.write_scores(path)
    qtbot.waitUntil(lambda: "leaves out 1 frame" in told[-1])
    rows = list(csv.DictReader(io.StringIO(path.read_text(encoding="utf-8"), newline="")))
    assert [row["name"] for row in rows] == [HERE]


def test_the_field_is_estimated_from_committed_frames_only(blind, qtbot):
    blind.actions_["field_dimensions"].trigger()
    dialog = blind.field_dimensions.dialog
    dialog.estimate_button.click()
    assert "once one of its frames is committed" in dialog.found.text()
    blind.services.navigator.go_to(blind.services.state.workspace.index[OTHER])
    blind.services.editing.commit_frame()
    dialog.estimate_button.click()
    qtbot.waitUntil(lambda: "took no part (2)" in dialog.found.text())
    assert "1 frame;" in dialog.found.text()


def test_in_a_folder_that_cannot_be_written_it_is_said_whom_it_holds_for(
    dataset, make_window, monkeypatch, tmp_path, qtbot
):
    (dataset / ".procc").write_text("a file where the folder belongs")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    window = make_window(dataset)
    told = heard(window.services)
    window.actions_["lock_blind"].trigger()
    assert "locked to blind mode, for you alone" in told[-1]
    assert "for you alone" in window.actions_["blind"].toolTip()
    window.actions_["field_dimensions"].trigger()
    window.field_dimensions.dialog.boxes["length"].setValue(101.0)
    window.field_dimensions.dialog.accept()
    qtbot.waitUntil(lambda: "from now on, for you alone" in told[-1])


def test_the_picture_stands_in_a_frame_while_blind(blind, qtbot):
    shown = blind.canvas.blind_frame
    edges, badge = shown.edges, shown.badge
    view = blind.canvas.viewport()
    before = blind.canvas.to_picture(QPointF(100, 100))
    assert all(edge.isVisible() for edge in edges)
    assert "Ctrl+Enter" in badge.text
    assert view.rect().contains(badge.geometry())
    blind.services.editing.commit_frame()
    qtbot.waitUntil(lambda: "committed" in badge.text)
    blind.services.blind_lock.set_blind(False)
    assert not any(part.isVisible() for part in (*edges, badge))
    assert blind.canvas.to_picture(QPointF(100, 100)) == before  # nothing has moved


def test_blind_mode_outlives_a_program_that_is_killed(window, qtbot):
    for blind in (True, False):
        window.actions_["blind"].trigger()
        qtbot.waitUntil(lambda on=blind: Settings().get(SWITCHES["blind"]) is on)
