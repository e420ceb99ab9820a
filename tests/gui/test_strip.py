"""The strip below the picture: when it is there, where a click goes, what it tells of frames."""

import threading
from collections.abc import Iterable
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QFocusEvent, QPalette, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog

from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.tracking.track import FrameState, Track, TrackedFrame
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.frames import list_frames
from procc_annotator.dataset.sequence import FEWEST, sequence_of
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.timeline import content, painting
from procc_annotator.gui.panels.timeline.content import Axis, Band, band_pixels
from tests.gui.conftest import Hand, all_done

SIZE = (320, 180)
COUNT = 24
CAMERA = PinholeCamera(
    pan_rad=0.0,
    tilt_rad=1.35,
    roll_rad=0.0,
    position_world=(0.0, 60.0, -15.0),
    focal_px=(400.0, 400.0),
    principal_point_px=(159.5, 89.5),
)


def panned(number: int, scene: int = 0) -> np.ndarray:
    """A camera that pans over a scene."""
    colours = np.random.default_rng(scene).integers(0, 200, (6, 12, 3), dtype=np.uint8)
    wide = cv2.resize(colours, (SIZE[0] + 2 * COUNT, SIZE[1]), interpolation=cv2.INTER_CUBIC)
    return np.ascontiguousarray(wide[:, 2 * number : 2 * number + SIZE[0]])


@pytest.fixture(scope="module")
def following() -> list[bytes]:
    """PNG of pictures that follow one another."""
    return [cv2.imencode(".png", panned(number))[1].tobytes() for number in range(COUNT)]


@pytest.fixture
def shot(tmp_path, following) -> Path:
    """A folder of them."""
    folder = tmp_path / "shot"
    folder.mkdir()
    for number, picture in enumerate(following, start=100):
        (folder / f"shot_{number:04d}.png").write_bytes(picture)
    return folder


@pytest.fixture
def window(make_window, shot, qtbot) -> MainWindow:
    made = make_window(shot)
    qtbot.waitUntil(made.strip.isVisible)
    all_done(qtbot)
    return made


def tracked(number: int, state: FrameState = "followed", coverage: float = 0.9) -> TrackedFrame:
    fit = None if state == "lost" else FitResult("R", SIZE, CAMERA)
    return TrackedFrame(number, state, "", fit, coverage, 0.3, 4)


def take(window: MainWindow, frames: Iterable[TrackedFrame], *shots: tuple[int, int]) -> None:
    window.services.shot_track.take(Track(tuple(frames), shots))


def place_of(window: MainWindow, number: int) -> QPoint:
    strip = window.strip
    return QPoint(round(8 + strip.axis.middle_of(number)), strip.height() // 2)


def key(window: MainWindow, key: Qt.Key, modifiers: Qt.KeyboardModifier) -> None:
    QTest.keyClick(window.canvas, key, modifiers)


SHIFT, CTRL, ALT = (
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.AltModifier,
)


class TestWhereItIs:
    def test_pictures_that_follow_one_another_have_one(self, window):
        sequence = window.services.sequence.value

        assert (sequence.first, sequence.last, sequence.video) == (100, 123, None)
        assert window.strip.mapTo(window, QPoint()).y() > window.canvas.mapTo(window, QPoint()).y()

    def test_shots_in_folders_of_their_own_lie_one_behind_the_other(
        self, make_window, tmp_path, qtbot
    ):
        for scene, match in enumerate(("a", "b")):
            (tmp_path / match / "img1").mkdir(parents=True)
            for number in range(FEWEST):
                path = tmp_path / match / "img1" / f"{number:06d}.png"
                cv2.imwrite(str(path), panned(number, scene=scene))
        window = make_window(tmp_path)
        qtbot.waitUntil(window.strip.isVisible)
        window.services.navigator.go_to(FEWEST)
        all_done(qtbot)
        assert strip_words(window).startswith("b/img1/000000")
        sequence = window.services.sequence.value
        assert len(sequence.unbroken(int(sequence.numbers[FEWEST]))) == FEWEST

    def test_unrelated_pictures_have_none(self, make_window, tmp_path, qtbot):
        for number in range(COUNT):
            cv2.imwrite(str(tmp_path / f"{number:05d}.png"), panned(0, scene=number))

        window = make_window(tmp_path)
        all_done(qtbot)

        assert window.services.sequence.value is None
        assert not window.strip.isVisible()

    def test_few_pictures_or_names_without_order_make_no_sequence(self, shot):
        frames = list_frames(shot)[1]

        assert sequence_of(frames) is not None
        assert sequence_of(frames[: FEWEST - 1]) is None
        gaps = [frame for i, frame in enumerate(frames) if i % 3]
        assert sequence_of(gaps) is None  # one is missing again and again

    def test_names_may_count_by_more_than_one(self, tmp_path):
        for number in range(COUNT):
            cv2.imwrite(str(tmp_path / f"match_{5 * number:06d}.png"), panned(2 * number))
        frames = list_frames(tmp_path)[1]

        every_fifth = sequence_of(frames)

        assert every_fifth.step == 5
        assert every_fifth.numbers.tolist() == list(range(COUNT))
        assert every_fifth.paths[3] == frames[3].image_path
        assert every_fifth.fps == 5.0
        found = sequence_of([*frames[:4], *frames[5:]])
        assert 4 not in found.index_of

    def test_it_takes_the_place_of_the_thumbnails_without_moving_the_picture(
        self, make_window, dataset, shot, qtbot
    ):
        window = make_window(dataset)
        all_done(qtbot)
        services = window.services
        services.opening.open_path(shot)
        assert services.sequence.working
        services.selection.select_class("Middle line")
        QApplication.processEvents()
        before = window.canvas.height()
        assert window.strips.film.isVisible()
        qtbot.waitUntil(lambda: services.sequence.value is not None)

        assert window.strip.isVisible()
        assert window.canvas.height() == before  # the thumbnails were as high

    def test_it_is_switched_off_and_remembered(self, window, make_window, shot, qtbot):
        window.actions_["strip"].trigger()

        assert not window.strip.isVisible()
        window.services.navigator.next_frame()
        assert not window.strip.isVisible()
        window.actions_["strip"].trigger()
        assert window.strip.isVisible()


class TestHands:
    def test_a_click_goes_to_a_frame_and_a_drag_along_them(self, window, qtbot):
        strip, services = window.strip, window.services
        left = Qt.MouseButton.LeftButton

        QTest.mouseClick(strip, left, Qt.KeyboardModifier.NoModifier, place_of(window, 112))
        qtbot.waitUntil(lambda: services.state.frame_index == 12)
        QTest.mousePress(strip, left, Qt.KeyboardModifier.NoModifier, place_of(window, 105))
        for number in (108, 115, 120):
            QTest.mouseMove(strip, place_of(window, number))
        qtbot.waitUntil(lambda: services.state.frame_index == 20)
        QTest.mouseRelease(strip, left, Qt.KeyboardModifier.NoModifier, place_of(window, 120))

        assert strip.number == 120

    def test_the_wheel_zooms_where_the_pointer_is(self, window):
        strip = window.strip
        before = strip.axis
        assert before.is_whole

        for turned in (120, 120):
            at = QPointF(place_of(window, 110))
            event = QWheelEvent(
                at,
                QPointF(strip.mapToGlobal(at.toPoint())),
                QPoint(),
                QPoint(0, turned),
                Qt.MouseButton.NoButton,
                Qt.KeyboardModifier.NoModifier,
                Qt.ScrollPhase.NoScrollPhase,
                False,
            )
            QApplication.sendEvent(strip, event)
        after = strip.axis

        assert after.per_frame > before.per_frame
        assert after.middle_of(110) == pytest.approx(before.middle_of(110), abs=2.0)

    def test_the_keyboard_stays_with_the_picture(self, window):
        QTest.mouseClick(
            window.strip,
            Qt.MouseButton.LeftButton,
            Qt.KeyboardModifier.NoModifier,
            place_of(window, 110),
        )

        assert window.canvas.hasFocus()

    def test_a_stretch_is_marked_with_shift(self, window):
        strip, left = window.strip, Qt.MouseButton.LeftButton

        QTest.mousePress(strip, left, SHIFT, place_of(window, 118))
        QTest.mouseMove(strip, place_of(window, 106))
        QTest.mouseRelease(strip, left, SHIFT, place_of(window, 106))

        assert strip.stretch == (106, 118)
        assert window.services.state.frame_index == 0


class TestKeys:
    def test_by_ten(self, window, qtbot):
        services = window.services

        for expected in (10, 20, COUNT - 1):
            key(window, Qt.Key.Key_PageDown, SHIFT)
            qtbot.waitUntil(lambda at=expected: services.state.frame_index == at)
        key(window, Qt.Key.Key_PageUp, SHIFT)
        qtbot.waitUntil(lambda: services.state.frame_index == COUNT - 11)

    def test_to_annotated_frames(self, window, hand_on, qtbot):
        services = window.services
        services.navigator.go_to(7)
        hand: Hand = hand_on(window)
        hand.draw("Middle line", (40, 40), (200, 120))
        services.navigator.go_to(15)
        hand.draw("Middle line", (40, 40), (200, 120))
        all_done(qtbot)

        assert window.strip.content.anchors == (107, 115)
        key(window, Qt.Key.Key_PageUp, CTRL)
        qtbot.waitUntil(lambda: services.state.frame_index == 7)
        key(window, Qt.Key.Key_PageDown, CTRL)
        qtbot.waitUntil(lambda: services.state.frame_index == 15)

    def test_to_doubtful_frames(self, window, qtbot):
        services = window.services
        frames = [tracked(n) for n in range(100, 124)]
        frames[9], frames[14] = tracked(109, "bridged"), tracked(114, coverage=0.2)
        take(window, frames, (100, 123))

        for expected in (9, 14):
            key(window, Qt.Key.Key_PageDown, ALT)
            qtbot.waitUntil(lambda at=expected: services.state.frame_index == at)
        key(window, Qt.Key.Key_PageUp, ALT)
        qtbot.waitUntil(lambda: services.state.frame_index == 9)

    def test_playing_goes_on_to_the_end_and_an_edit_stops_it(self, window, qtbot):
        services, walk = window.services, window.shot_walk

        key(window, Qt.Key.Key_Space, SHIFT)
        qtbot.waitUntil(lambda: services.state.frame_index > 2)
        window.canvas.editor.changed.emit()
        assert not walk.playing
        services.navigator.go_to(COUNT - 3)
        key(window, Qt.Key.Key_Space, SHIFT)
        qtbot.waitUntil(lambda: not walk.playing)

        assert services.state.frame_index == COUNT - 1

    def test_a_menu_of_the_picture_is_of_the_frame_it_was_asked_for_on(
        self, window, qtbot, monkeypatch
    ):
        services, seen = window.services, []

        class Menu:
            def exec(self, _: QPoint) -> None:
                before = services.state.frame_index
                assert not window.shot_walk.playing
                assert not services.navigator.coming
                seen.append(before)

            def deleteLater(self) -> None:
                pass

        monkeypatch.setattr("procc_annotator.gui.main_window.canvas_menu", lambda *_, **__: Menu())
        key(window, Qt.Key.Key_Space, SHIFT)
        qtbot.waitUntil(lambda: services.state.frame_index > 2)
        window.canvas.menuWanted.emit(QPoint())
        assert seen == [services.state.frame_index]

    def test_a_dialog_is_about_the_frame_it_was_opened_on(self, window, qtbot):
        key(window, Qt.Key.Key_Space, SHIFT)
        qtbot.waitUntil(lambda: window.services.state.frame_index > 2)
        dialog = QDialog(window)
        dialog.open()
        assert not window.shot_walk.playing
        assert not window.services.navigator.coming
        dialog.close()
        dialog.deleteLater()

    def test_a_picture_on_its_way_takes_nobody_back_who_went_elsewhere(
        self, window, qtbot, monkeypatch
    ):
        services, visited, go = window.services, [], threading.Event()
        decode = services.cache.get_ready

        def slow(path: Path) -> object:
            go.wait(30)
            return decode(path)

        monkeypatch.setattr(services.cache, "get_ready", slow)
        services.store.watch(
            lambda s: s.frame_index, lambda: visited.append(services.state.frame_index)
        )
        services.navigator.come_to(10)
        services.navigator.come_to(20)
        services.navigator.go_to(20)
        go.set()
        all_done(qtbot)
        assert visited == [20]


class TestWhatItTells:
    def test_of_a_followed_frame(self, window):
        take(window, [tracked(n) for n in range(100, 120)], (100, 109), (110, 119))
        services, content = window.services, window.strip.content

        assert content.cuts == (110,)
        assert np.isnan(content.band.coverage[20:]).all()
        assert "track" in [source.name for source in services.state.sources]
        services.camera_sources.set_active_camera(
            services.state.sources.index(services.shot_track.source)
        )
        assert services.scorer.camera is not None
        services.navigator.go_to(21)
        assert services.scorer.camera is None
        assert services.scorer.shown.notice == "not followed so far"

    def test_nothing_of_cameras_in_blind_mode(self, window):
        take(window, [tracked(n) for n in range(100, 120)], (100, 119))

        window.services.blind_lock.set_blind(True)

        assert window.strip.content.hidden
        assert "on paint" not in strip_words(window)
        window.services.blind_lock.set_blind(False)
        assert "on paint" in strip_words(window)

    def test_the_band_shows_the_window_where_nothing_is_known(self, window):
        take(window, [tracked(n) for n in range(100, 112)], (100, 111))
        strip = window.strip
        image = strip.grab().toImage()
        ground = strip.palette().color(QPalette.ColorRole.Base)
        low = strip.fontMetrics().height() + 17  # in the band, as high as the worst frame

        def colour(number: int) -> QColor:
            return image.pixelColor(place_of(window, number).x(), low)

        assert colour(120) == ground
        assert colour(105) != ground

    def test_another_dataset_begins_without(self, window, dataset, qtbot):
        take(window, [tracked(n) for n in range(100, 120)], (100, 119))

        window.services.opening.open_path(dataset)
        all_done(qtbot)

        assert not window.services.shot_track.tracked
        assert not window.services.state.sources
        assert not window.strip.isVisible()


def strip_words(window: MainWindow) -> str:
    from procc_annotator.gui.panels.timeline.shot_strip import strip_words

    return strip_words(window.services, window.strip.content, window.strip.number)


def test_frames_are_gone_to_and_marked_by_keys(window, qtbot):
    strip, services = window.strip, window.services
    strip.setFocus(Qt.FocusReason.TabFocusReason)
    QTest.keyClick(strip, Qt.Key.Key_Right)
    qtbot.waitUntil(lambda: services.state.frame_index == 1)
    for frame in (2, 3, 4):
        QTest.keyClick(strip, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
        qtbot.waitUntil(lambda frame=frame: services.state.frame_index == frame)
    first = int(strip.content.sequence.numbers[0])
    assert strip.stretch == (first + 1, first + 4)
    QTest.keyClick(strip, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    qtbot.waitUntil(lambda: services.state.frame_index == 3)
    assert strip.stretch == (first + 1, first + 3)
    QTest.keyClick(strip, Qt.Key.Key_Escape)
    assert strip.stretch is None
    QTest.keyClick(strip, Qt.Key.Key_End)
    qtbot.waitUntil(lambda: services.state.frame_index == COUNT - 1)
    QTest.keyClick(strip, Qt.Key.Key_Home)
    qtbot.waitUntil(lambda: services.state.frame_index == 0)


def test_it_follows_the_frame_again_when_a_key_came_up_elsewhere(window, qtbot):
    strip, services = window.strip, window.services
    strip.setFocus(Qt.FocusReason.TabFocusReason)
    QTest.keyPress(strip, Qt.Key.Key_Right)
    qtbot.waitUntil(lambda: services.state.frame_index == 1)
    QApplication.sendEvent(strip, QFocusEvent(QEvent.Type.FocusOut))
    services.navigator.go_to(5)
    assert strip.number == int(strip.content.sequence.numbers[5])


def test_a_band_shows_the_worst_of_what_shares_a_column():
    band = Band.unknown(1000)
    band.coverage[:] = 0.9
    band.coverage[500], band.lost[500], band.doubtful[500] = 0.0, True, True
    pixels = band_pixels(band, Axis.whole(0, 999, 100.0), (100, 16))

    heights = (pixels != 0).sum(axis=0)
    assert heights[50] < 4 < heights[49]
    assert (heights[np.arange(100) != 50] >= 14).all()


@pytest.mark.parametrize("width", [100, 3840])
def test_a_frame_is_found_where_it_is_painted(width):
    axis = Axis.whole(10, 5009, float(width)).zoomed(4.0, width / 3)

    for number in (int(axis.begin) + 2, int(axis.end) - 2):
        assert abs(axis.number_at(axis.middle_of(number)) - number) <= 1
    assert axis.scrolled(1e9).end == 5010


def test_the_band_is_painted_once_for_all_frames_on_screen(window, qtbot, monkeypatch):
    strip, painted = window.strip, []
    monkeypatch.setattr(painting, "band_pixels", lambda *of: painted.append(of) or band_pixels(*of))
    strip.content.changed.emit()
    for index in (0, 7, 12):
        window.services.navigator.go_to(index)
        strip.grab()
    assert len(painted) == 1
    strip.content.changed.emit()
    strip.grab()
    assert len(painted) == 2


def test_what_the_band_tells_already_is_not_taken_down_again(make_window, shot, qtbot, monkeypatch):
    window = make_window(shot)
    qtbot.waitUntil(window.strip.isVisible)
    before = {n: tracked(n) for n in range(100, 120)}
    window.services.shot_track.replace(before, ())
    taken: list[int] = []
    put = content._put

    def noted(band: Band, at: int, frame: TrackedFrame) -> None:
        taken.append(frame.number)
        put(band, at, frame)

    monkeypatch.setattr(content, "_put", noted)
    after = before | {105: tracked(105, coverage=0.6)}
    del after[110]
    window.services.shot_track.replace(after, ())

    assert taken == [105]
    assert window.strip.content.band.coverage[5] == 0.6
    assert np.isnan(window.strip.content.band.coverage[10])
