"""Cameras that are found without a click: their ghosts, what is said of them, what they may do."""

import json
from collections.abc import Callable
from pathlib import Path
from threading import Event
from typing import Any

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from procc_annotator.calibration.result import FitResult, external_camera_fit
from procc_annotator.calibration.single_image.proposal import Proposal, ProposalState
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.dataset_field import ASPECT_SETTING, stored_pixel_aspect
from procc_annotator.dataset.records import OriginKind
from procc_annotator.errors import ImageError
from procc_annotator.field.model import Field, PixelAspect
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.prediction import camera_choice
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction import palette as tones
from tests.gui.conftest import Hand, all_done, heard, until_kept

Key, SHIFT = Qt.Key, Qt.KeyboardModifier.ShiftModifier


class Finder:
    """Stands for the search in the picture: says what it is told to."""

    def __init__(self, folder: Path) -> None:
        self.cameras = CameraSet.open(folder / "cameras" / "true", camera_size=(960, 540))
        self.state: ProposalState = "sure"
        self.reason = "94 % of the lines in sight are on paint"
        self.asked = 0
        self.pixels: PixelAspect | None = None
        self.wait: Event | None = None
        self.frame = "00002"

    def __call__(
        self,
        picture: PixelArray,
        field: Field,
        *,
        go_on: Callable[[], None],
    ) -> Proposal:
        self.asked += 1
        self.pixels = field.pixels
        while self.wait is not None and not self.wait.wait(0.01):
            go_on()
        size = picture.shape[1], picture.shape[0]
        if self.state == "none":
            none = FitResult("R", size, None, self.reason)
            return Proposal("none", self.reason, none, 0.0, 0.0, None, 0.0, None)
        found = self.cameras.camera(self.frame, size)
        fit = external_camera_fit(found.camera, size)
        return Proposal(self.state, self.reason, fit, 0.94, 0.9, 0.4, 0.3, None)


@pytest.fixture
def finder(annotated, monkeypatch) -> Finder:
    found = Finder(annotated)
    monkeypatch.setattr(camera_choice, "propose_camera", found)
    return found


@pytest.fixture
def bare(annotated) -> Path:
    """The sample; nothing is annotated in its second frame."""
    (annotated / "00002.json").unlink()
    return annotated


@pytest.fixture
def window(make_window, bare, finder, qtbot) -> MainWindow:
    made = make_window(bare)
    made.services.navigator.go_to(1)
    all_done(qtbot)
    return made


def ghosts(window: MainWindow) -> list[str]:
    return [ghost.name for ghost in window.services.ghosts.painted]


def tones_of(window: MainWindow) -> set[str]:
    return {stroke.colour for stroke in window.canvas.overlay_item.ghosts.strokes}


def entries(folder: Path) -> dict[str, Any]:
    until_kept()
    path = folder / "00002.json"
    return dict(json.loads(path.read_text())) if path.exists() else {}


def test_a_dataset_keeps_how_wide_its_pixels_are(make_window, bare, finder, qtbot, monkeypatch):
    """Several of its pictures tell, once."""
    for path in bare.glob("*.jpg"):
        cv2.imwrite(str(path), cv2.resize(cv2.imread(str(path)), (400, 400)))
    squeezed, calls = PixelAspect(16 / 9, 0.999), []

    def estimate(frames: list[tuple[str, Path]], *_: object) -> PixelAspect:
        calls.append(len(frames))
        return squeezed

    monkeypatch.setattr(camera_choice, "set_pixel_aspect", estimate)
    window = make_window(bare)
    window.services.navigator.go_to(1)
    all_done(qtbot)
    assert finder.pixels == squeezed
    assert calls == [len(window.services.state.workspace.frames)]
    assert stored_pixel_aspect(window.services.review.setting(ASPECT_SETTING)) == squeezed
    assert window.services.state.field.pixels == squeezed
    window.services.navigator.go_to(0)
    all_done(qtbot)
    wide, high = window.services.live_fit.insight.fit.camera.focal_px
    assert high / wide == pytest.approx(16 / 9)


class TestAFrameWithoutAnnotation:
    def test_shows_ghosts_without_a_click_and_says_how_sure(self, window, finder):
        assert len(ghosts(window)) > 5
        plate = window.canvas.found_plate
        assert plate.isVisible()
        assert plate.text == f"Camera found, sure: {finder.reason}"
        assert tones.GHOST in tones_of(window)

    def test_a_long_reason_is_said_whole_in_a_narrow_window(self, window, finder):
        plate = window.canvas.found_plate
        one_line = plate.wanted_size().height()
        for text in ("short", "a", finder.reason, "not long either"):
            plate.say(text, tones.PASSES)
            plate._stand()
            assert plate.height() == one_line
        reason = "99 % of the lines in sight lie on paint, which explains 84 % of it " * 3
        plate.say(reason, tones.PASSES)
        plate._stand()
        assert plate.width() < plate.wanted_size().width()
        assert plate.height() > one_line * 1.3
        assert plate.geometry().bottom() < window.canvas.viewport().height()

    def test_nothing_is_saved_before_somebody_accepts(self, window, bare):
        window.services.navigator.next_frame()
        window.services.navigator.previous_frame()

        assert entries(bare) == {}
        assert [source.name for source in window.services.state.sources] == []

    def test_enter_goes_on_to_the_next_element_also_where_ghosts_are(self, window, finder, hand_on):
        there = ghosts(window)
        window.services.selection.select_class(there[0])
        hand = hand_on(window)
        (hand.click(40, 40), hand.click(90, 70))
        QTest.keyClick(window.canvas, Key.Key_Return)
        assert window.services.state.selected_class in there[1:]

    def test_unsure_cameras_look_unsure(self, make_window, bare, finder, qtbot):
        finder.state, finder.reason = "unsure", "another camera fits nearly as well"
        window = make_window(bare)
        window.services.navigator.go_to(1)
        all_done(qtbot)

        assert tones.UNSURE_GHOST in tones_of(window)
        plate = window.canvas.found_plate
        assert plate.text.startswith("Camera found, unsure: another camera")
        assert "Shift+Enter accepts, Delete rejects" in plate.text
        there = ghosts(window)
        QTest.keyClick(window.canvas, Qt.Key.Key_Delete)
        all_done(qtbot)
        assert plate.text.startswith("No camera found: you rejected it")
        assert ghosts(window) == []
        QTest.keyClick(window.canvas, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
        all_done(qtbot)
        assert ghosts(window) == there

    def test_without_a_camera_the_reason_is_said(self, make_window, bare, finder, qtbot, hand_on):
        finder.state, finder.reason = "none", "no paint of this field was found"
        window = make_window(bare)
        window.services.navigator.go_to(1)
        all_done(qtbot)

        assert ghosts(window) == []
        plate = window.canvas.found_plate
        advice = "draw 3 elements, two of which meet, such as Far touchline, Centre circle, Halfway"
        assert plate.text.startswith(f"No camera found: {finder.reason}. To begin, {advice} line")
        said = heard(window.services)
        QTest.keyClick(window.canvas, Qt.Key.Key_Tab)
        assert advice in said[-1]  # the same
        menu = window.actions_.menus["File/Field"]
        QTest.mouseClick(plate, Qt.MouseButton.LeftButton)
        assert menu.isVisible()
        menu.close()
        QTest.keyClick(window.canvas, Qt.Key.Key_Return)
        assert window.services.state.selected_class == "Side line top"

    def test_every_frame_is_looked_at_once_and_its_neighbours_before_they_are_come_to(
        self, window, finder, qtbot
    ):
        assert finder.asked == 1  # the neighbours are annotated

        for step in (1, -1, 1, -1):
            window.services.navigator.go_to(1 + max(step, 0))
            all_done(qtbot)

        assert finder.asked == 1

    def test_a_search_that_fails_is_over_and_the_next_frame_is_looked_at(
        self, make_window, bare, finder, qtbot, monkeypatch
    ):
        (bare / "00001.json").unlink()

        def fails(picture: PixelArray, *args: Any, **more: Any) -> Proposal:
            finder(picture, *args, **more)
            raise ImageError(bare, "too dark to look at")

        monkeypatch.setattr(camera_choice, "propose_camera", fails)
        window = make_window(bare)
        all_done(qtbot)

        assert not window.services.proposals.working
        assert not window.canvas.found_plate.isVisible()
        assert finder.asked == 2

    def test_leaving_the_frame_stops_the_search(self, make_window, bare, finder, qtbot):
        finder.wait = Event()
        window = make_window(bare)
        window.services.navigator.go_to(1)
        qtbot.waitUntil(lambda: finder.asked == 1)
        assert window.canvas.found_plate.text.startswith("Looking for the camera")

        window.services.navigator.go_to(2)
        all_done(qtbot)  # it would wait for ever

        assert not window.canvas.found_plate.isVisible()


class TestAccepting:
    def test_all_of_them_is_one_step_and_bears_where_it_came_from(
        self, window, bare, hand_on, qtbot
    ):
        hand: Hand = hand_on(window)
        services = window.services

        hand.key(Key.Key_Return, SHIFT)
        all_done(qtbot)

        assert len(entries(bare)) > 5
        counts = services.review.origin_counts("00002", services.state.annotation)
        assert set(counts) == {OriginKind.ACCEPTED}
        assert services.live_fit.result.camera is not None
        assert not window.canvas.found_plate.isVisible()
        services.editing.undo()
        all_done(qtbot)
        assert entries(bare) == {}
        assert window.canvas.found_plate.isVisible()

    def test_one_by_one_the_others_stay_while_the_clicks_know_fewer(self, window, hand_on, qtbot):
        hand: Hand = hand_on(window)
        services = window.services
        left = set(ghosts(window))

        hand.key(Key.Key_Tab)
        while len(left) > 2:
            current = services.ghosts.current  # the walk goes on
            all_done(qtbot)
            hand.key(Key.Key_Return)
            all_done(qtbot)
            left.remove(current.name)
            assert current.name in services.state.annotation.annotated
            assert set(ghosts(window)) == left
        assert not services.prediction.stands_in

    def test_not_visible_here(self, window, hand_on, qtbot):
        hand: Hand = hand_on(window)
        hand.key(Key.Key_Tab)
        current = window.services.ghosts.current
        hand.key(Key.Key_Period)
        all_done(qtbot)

        assert current.name not in ghosts(window)

    def test_clicks_that_contradict_the_camera_take_its_ghosts_away(self, window, hand_on, qtbot):
        hand: Hand = hand_on(window)
        name = ghosts(window)[0]
        height = (window.services.state.picture_size or (0, 0))[1]

        hand.draw(name, (10, height - 12), (40, height - 40))
        all_done(qtbot)

        assert not window.services.prediction.stands_in
        assert ghosts(window) == []


class TestOff:
    def test_in_blind_mode(self, make_window, bare, finder, qtbot):
        window = make_window(bare)
        window.services.blind_lock.set_blind(True)
        window.services.navigator.go_to(1)
        all_done(qtbot)

        assert finder.asked == 0
        assert ghosts(window) == []
        assert not window.canvas.found_plate.isVisible()
        window.services.blind_lock.set_blind(False)
        all_done(qtbot)
        assert ghosts(window)

    def test_by_the_option(self, window, finder, qtbot):
        window.actions_["propose"].trigger()
        all_done(qtbot)

        assert ghosts(window) == []
        assert not window.canvas.found_plate.isVisible()
        window.actions_["propose"].trigger()
        all_done(qtbot)
        assert ghosts(window)
        assert finder.asked == 1

    def test_the_live_fit_may_be_off(self, window, qtbot):
        window.services.live_fit.set_wanted(False)
        all_done(qtbot)

        assert ghosts(window)


def test_everything_sure_is_annotated_in_one_step(make_window, annotated, qtbot, hand_on):
    """A frame without a field, and one that was annotated before, are left as they are."""
    first, second, third = (annotated / f"0000{i}.json" for i in (1, 2, 3))
    before = first.read_bytes()
    second.unlink()
    third.unlink()
    noise = np.random.default_rng(0).integers(0, 255, (540, 960, 3)).astype(np.uint8)
    cv2.imwrite(str(annotated / "00000.jpg"), noise)
    window = make_window(annotated)
    window.services.navigator.go_to(2)
    all_done(qtbot)
    said = heard(window.services)

    def run(act: Callable[[], object]) -> list[bool]:
        act()
        qtbot.waitUntil(lambda: not window.stretch_accepting.running, timeout=60_000)
        all_done(qtbot)
        until_kept()
        files = [json.loads(path.read_text()) if path.exists() else {} for path in (second, third)]
        assert first.read_bytes() == before
        return [len(entries) > 3 for entries in files]

    assert run(window.actions_["annotate_sure"].trigger) == [True, True]
    assert not (annotated / "00000.json").exists()
    assert "1 frame is not sure" in said[-1]
    hand: Hand = hand_on(window)
    assert run(lambda: hand.key(Key.Key_Z, Qt.KeyboardModifier.ControlModifier)) == [False, False]
    assert run(lambda: hand.key(Key.Key_Y, Qt.KeyboardModifier.ControlModifier)) == [True, True]
    window.actions_["next_doubtful"].trigger()
    all_done(qtbot)
    assert window.services.state.frame_name == "00000"
