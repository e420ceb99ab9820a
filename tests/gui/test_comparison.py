"""Two camera sources seen together: wireframes, blink, split view, disagreement in metres."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QFocusEvent, QImage, QMouseEvent, QPainter
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QCheckBox,
    QComboBox,
    QLabel,
    QLineEdit,
    QWidget,
)
from pytestqt.qtbot import QtBot

from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import ElementProjections
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.cameras import CamerasPanel
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.scoring.frame_score import SourceFrame
from procc_annotator.gui.state.services import Services
from procc_annotator.metrics.error_maps import disagreement
from tests.gui.conftest import Hand, all_done, settle

NONE, CTRL = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton
VIOLET = "#7a22ff"  # of the second source, "bad"
MAGENTA = "#d264d8"


@pytest.fixture
def hand(audited, hand_on) -> Hand:
    return hand_on(audited)


def named(services: Services, name: str) -> CameraSource:
    return next(s for s in services.state.sources if s.name == name)


def pixels(window: MainWindow) -> np.ndarray:
    """(H, W, 3) what the canvas shows, r g b."""
    QApplication.processEvents()
    image = window.canvas.grab().toImage().convertToFormat(QImage.Format.Format_RGB888)
    flat = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return flat[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(np.int16)


def same(some: np.ndarray, other: np.ndarray) -> bool:
    """Whether two pictures look the same but for the smoothing of a few pixels."""
    off = np.abs(some - other).max(axis=2)
    return bool(np.count_nonzero(off > 40) <= 3)


def near_colour(shown: np.ndarray, at: QPointF, colour: str) -> float:
    """How far the nearest of the pixels around a place is from a colour."""
    x, y = round(at.x()), round(at.y())
    around = shown[max(0, y - 2) : y + 3, max(0, x - 2) : x + 3].reshape(-1, 3)
    tone = QColor(colour)
    return float(np.abs(around - (tone.red(), tone.green(), tone.blue())).max(axis=1).min())


def seen_at(window: MainWindow, name: str) -> list[QPointF]:
    """Places of the view where a source shows an element, the middles of its segments."""
    services = window.services
    projected = services.source_frames.of(named(window.services, name)).projected
    scale = [(p - 1) / (s - 1) for p, s in zip((1280, 720), services.state.setup.size, strict=True)]
    places = []
    for pieces in projected.pieces.values():
        for piece in pieces:
            steps = np.linalg.norm(np.diff(piece, axis=0), axis=1)
            for i in np.flatnonzero(steps > 4):
                middle = piece[i : i + 2].mean(axis=0) * scale
                at = window.canvas.to_view(*middle)
                room = window.canvas.viewport().rect().adjusted(8, 8, -8, -8)
                if 20 < middle[0] < 1260 and 20 < middle[1] < 700 and room.contains(at.toPoint()):
                    places.append(at)
    assert len(places) > 3
    return places


def share_in_colour(window: MainWindow, name: str, colour: str) -> float:
    shown = pixels(window)
    found = [near_colour(shown, at, colour) < 60 for at in seen_at(window, name)]
    return sum(found) / len(found)


class TestWireframes:
    def test_another_source_is_drawn_in_its_colour(self, audited):
        bad = named(audited.services, "bad")
        assert bad.colour == VIOLET
        audited.services.camera_sources.set_source_colour(
            bad, MAGENTA
        )  # nothing else on the picture is
        assert share_in_colour(audited, "bad", MAGENTA) > 0.8
        audited.services.camera_sources.set_source_visible(bad, False)
        assert share_in_colour(audited, "bad", MAGENTA) < 0.1

    def test_one_key_hides_all_of_them(self, audited, hand):
        modifiers = CTRL | Qt.KeyboardModifier.ShiftModifier
        assert audited.canvas.comparison.wireframes.strokes
        hand.key(Qt.Key.Key_H, modifiers)
        assert not audited.canvas.comparison.wireframes.strokes
        hand.key(Qt.Key.Key_H, modifiers)
        assert audited.canvas.comparison.wireframes.strokes

    def test_the_box_of_a_row_shows_and_hides_one(self, audited, qtbot):
        audited.panels.show("cameras")
        box = audited.findChild(QCheckBox, "cameras_drawn_1")
        qtbot.waitUntil(box.isVisible)
        box.click()
        colours = {s.colour for s in audited.canvas.comparison.wireframes.strokes}
        assert VIOLET not in colours
        assert named(audited.services, "pinhole").colour in colours

    def test_the_one_that_is_judged_has_none(self, audited):
        audited.services.camera_sources.set_active_camera(1)
        colours = {s.colour for s in audited.canvas.comparison.wireframes.strokes}
        assert VIOLET not in colours
        assert named(audited.services, "true").colour in colours

    def test_each_frame_has_its_own(self, audited, qtbot):
        audited.services.camera_sources.set_source_colour(named(audited.services, "bad"), MAGENTA)
        before = audited.canvas.comparison.wireframes
        audited.services.navigator.next_frame()
        settle(audited.services, qtbot)
        after = audited.canvas.comparison.wireframes
        assert len(after.strokes) == len(before.strokes)
        assert not np.array_equal(after.strokes[0].segments, before.strokes[0].segments)
        assert share_in_colour(audited, "bad", MAGENTA) > 0.8

    def test_they_are_not_made_anew_while_points_are_dragged(self, audited, hand):
        services = audited.services
        services.selection.set_mode("edit")
        before = audited.canvas.comparison.wireframes
        point = services.state.annotation.polylines[0].points[0]
        at = point.u * 1279, point.v * 719
        hand.drag(at, (at[0] + 40, at[1] + 15))
        assert audited.canvas.comparison.wireframes is before


class TestBlink:
    def press(self, window: MainWindow) -> None:
        QTest.keyPress(window.canvas, Qt.Key.Key_Comma)

    def release(self, window: MainWindow) -> None:
        QTest.keyRelease(window.canvas, Qt.Key.Key_Comma)

    def test_while_the_key_is_held_the_other_one_is_seen(self, audited, monkeypatch, qtbot):
        canvas, services = audited.canvas, audited.services
        services.camera_sources.compare_with(named(audited.services, "bad"))
        all_done(qtbot)  # the legend names what is drawn when nothing else is due
        at_first = pixels(audited)
        clock = [100.0]
        monkeypatch.setattr("procc_annotator.gui.canvas.comparison.monotonic", lambda: clock[0])
        self.press(audited)
        during = pixels(audited)
        assert "bad" in canvas.comparison.front.name
        assert (during != at_first).any(axis=2).mean() > 0.001
        plate = audited.findChild(object, "blinkName")
        assert plate.isVisible()
        assert plate.text == f"bad  ·  JaC {services.scorer.compared[1].jac:.3f}"
        clock[0] += 2.0
        self.release(audited)
        assert not plate.isVisible()
        assert services.state.active.name == "true"
        qtbot.waitUntil(lambda: np.array_equal(pixels(audited), at_first))

    def test_a_tap_changes_their_places(self, audited):
        services = audited.services
        services.camera_sources.compare_with(named(audited.services, "bad"))
        for active, compared in (("bad", "true"), ("true", "bad")):
            self.press(audited)
            self.release(audited)
            assert services.state.active.name == active
            assert services.state.compared.name == compared

    def test_alone_it_says_what_is_missing(self, audited):
        for _ in range(2):
            audited.services.camera_sources.remove_camera_set(1)
        self.press(audited)
        assert "second set" in audited.status.hint.text()
        self.release(audited)
        assert audited.services.state.active.name == "true"


class TestKeysHeldElsewhere:
    """Beside the picture, too, keys that are held mean the picture."""

    def focus(self, window: MainWindow, qtbot: QtBot, where: str) -> QWidget:
        """Use a part of the window; whoever has the focus then."""
        window.panels.show("frames")
        if where == "frames":  # a click there leaves the keys to the picture, walking does not
            QTest.mouseClick(window.findChild(QLineEdit, "frames_filter"), LEFT)
            QTest.keyClick(window.findChild(QLineEdit, "frames_filter"), Qt.Key.Key_Down)
            view = window.findChild(QAbstractItemView, "frames_list")
            QTest.keyClick(view, Qt.Key.Key_Down)
        elif where == "source":
            window.panels.show("cameras")
            radio = window.cameras.list.rows[0].radio  # not one that is about to be deleted
            qtbot.waitUntil(radio.isVisible)
            radio.setFocus(Qt.FocusReason.TabFocusReason)
        else:
            QTest.mouseClick(window.findChild(QLineEdit, "frames_filter"), LEFT)
        settle(window.services, qtbot)
        focused = QApplication.focusWidget()
        assert focused is not None
        assert focused is not window.canvas
        return focused

    @pytest.mark.parametrize("where", ["frames", "source"])
    def test_the_other_source_is_seen_while_comma_is_down(self, audited, qtbot, where, monkeypatch):
        canvas, services = audited.canvas, audited.services
        services.camera_sources.compare_with(named(audited.services, "bad"))
        focused = self.focus(audited, qtbot, where)
        clock = [100.0]
        monkeypatch.setattr("procc_annotator.gui.canvas.comparison.monotonic", lambda: clock[0])
        QTest.keyPress(focused, Qt.Key.Key_Comma)
        assert canvas.comparison.front is named(audited.services, "bad")
        canvas.setFocus()  # as when the mouse comes over the picture
        assert canvas.comparison.looking
        clock[0] += 2.0
        QTest.keyRelease(canvas, Qt.Key.Key_Comma)
        assert canvas.comparison.front is services.state.active is named(audited.services, "true")

    def test_bare_picture_and_loupe(self, audited, qtbot, hand):
        canvas = audited.canvas
        focused = self.focus(audited, qtbot, "frames")
        QTest.keyPress(focused, Qt.Key.Key_X)
        assert not canvas.overlay_item.overlay.strokes
        QTest.keyRelease(focused, Qt.Key.Key_X)
        assert canvas.overlay_item.overlay.strokes
        hand.move(640, 360)
        QTest.keyPress(focused, Qt.Key.Key_Z)
        assert canvas.loupe.isVisible()
        QTest.keyRelease(focused, Qt.Key.Key_Z)
        assert not canvas.loupe.isVisible()

    def test_a_text_field_gets_what_is_typed(self, audited, qtbot):
        self.focus(audited, qtbot, "frames")  # what is around a text field was in use before
        focused = self.focus(audited, qtbot, "filter")
        for key in ("x", "z", ","):
            QTest.keyClick(focused, key)
        assert focused.text() == "xz,"
        assert audited.canvas.overlay_item.overlay.strokes

    def test_what_is_held_ends_when_the_key_cannot_be_seen_coming_up(self, audited, qtbot):
        canvas, services = audited.canvas, audited.services
        services.camera_sources.compare_with(named(audited.services, "bad"))
        focused = self.focus(audited, qtbot, "frames")
        for lost_to in ("field", "menu"):
            focused.setFocus()
            QTest.keyPress(focused, Qt.Key.Key_X)
            QTest.keyPress(focused, Qt.Key.Key_Comma)
            assert canvas.comparison.looking
            if lost_to == "field":
                audited.findChild(QLineEdit, "frames_filter").setFocus()
            else:
                away = QFocusEvent(QEvent.Type.FocusOut, Qt.FocusReason.PopupFocusReason)
                QApplication.sendEvent(focused, away)
            assert not canvas.comparison.looking
            assert canvas.overlay_item.overlay.strokes
            assert services.state.active is named(audited.services, "true")


class TestSplit:
    @pytest.fixture(autouse=True)
    def split(self, audited, monkeypatch) -> None:
        # Texts give way to each other within what can be seen of their side.
        nothing = "procc_annotator.gui.canvas.overlay_painter.paint_plates"
        monkeypatch.setattr(nothing, lambda *_, **__: None)
        audited.services.camera_sources.compare_with(named(audited.services, "bad"))
        for source in audited.services.state.sources:
            audited.services.camera_sources.set_source_visible(source, False)
        self.whole = pixels(audited)
        QTest.keyClick(audited.canvas, Qt.Key.Key_B, CTRL)
        assert audited.canvas.comparison.split.shown

    def alone(self, window: MainWindow, name: str) -> np.ndarray:
        """The view when a source is judged and nothing is divided."""
        services = window.services
        QTest.keyClick(window.canvas, Qt.Key.Key_B, CTRL)
        active = services.state.active
        services.camera_sources.set_active_camera(
            services.state.sources.index(named(window.services, name))
        )
        shown = pixels(window)
        services.camera_sources.set_active_camera(services.state.sources.index(active))
        QTest.keyClick(window.canvas, Qt.Key.Key_B, CTRL)
        return shown

    def test_either_side_shows_its_source(self, audited):
        x = round(audited.canvas.comparison.split.x)
        both, other = pixels(audited), self.alone(audited, "bad")
        top, bottom = 150, 460  # without the names and the grip
        left, right = slice(0, x - 3), slice(x + 3, None)
        assert same(both[top:bottom, right], other[top:bottom, right])
        assert not same(other[top:bottom, left], self.whole[top:bottom, left])

    def test_names_stand_at_the_top(self, audited):
        split, services = audited.canvas.comparison.split, audited.services
        assert split.left.text == f"true  ·  JaC {services.scorer.score.jac:.3f}"
        assert split.right.text == f"bad  ·  JaC {services.scorer.compared[1].jac:.3f}"
        assert split.left.geometry().right() < split.x < split.right.geometry().left()

    def drag_divider(self, window: MainWindow, by: int) -> None:
        grip = window.canvas.comparison.split.grip
        middle = grip.rect().center()
        QTest.mousePress(grip, LEFT, NONE, middle)
        for _ in range(2):  # the grip follows, so that the second half starts from its middle
            to = QPointF(middle) + QPointF(by / 2, 0)
            event = QMouseEvent(QEvent.Type.MouseMove, to, grip.mapToGlobal(to), LEFT, LEFT, NONE)
            QApplication.sendEvent(grip, event)
        QTest.mouseRelease(grip, LEFT, NONE, middle)

    @pytest.mark.new_window
    def test_the_divider_follows_the_hand(self, audited):
        split = audited.canvas.comparison.split
        before = split.x
        self.drag_divider(audited, 120)
        assert split.x == pytest.approx(before + 120, abs=2)
        x = round(split.x)
        both = pixels(audited)
        left = slice(round(before) + 3, x - 3)
        assert same(both[150:460, left], self.whole[150:460, left])
        self.drag_divider(audited, 5000)
        assert split.x < audited.canvas.viewport().width()

    def test_arrow_keys_move_it(self, audited):
        split = audited.canvas.comparison.split
        before = split.x
        QTest.keyClick(split.grip, Qt.Key.Key_Right)
        assert split.x == before + 8

    def test_clicks_on_the_line_are_clicks_on_the_picture(self, audited, hand):
        services, canvas = audited.services, audited.canvas
        services.selection.set_option("snapping", False)
        services.selection.select_class("Circle central")
        view = QPoint(round(canvas.comparison.split.x), 330)
        target = canvas.viewport().childAt(view)
        while target is not None and target.testAttribute(
            Qt.WidgetAttribute.WA_TransparentForMouseEvents
        ):
            target = None
        assert target is None
        QTest.mouseClick(canvas.viewport(), LEFT, NONE, view)
        QTest.mouseClick(canvas.viewport(), LEFT, NONE, view + QPoint(40, 10))
        hand.key(Qt.Key.Key_Return)
        points = services.state.annotation.get("Circle central").points
        assert canvas.to_picture(QPointF(view)) == pytest.approx(
            (points[0].u * 1279, points[0].v * 719), abs=1e-6
        )

    def test_it_stays_when_frame_place_and_zoom_change(self, audited, hand, qtbot):
        canvas, split = audited.canvas, audited.canvas.comparison.split
        x = split.x
        hand.key(Qt.Key.Key_D)
        settle(audited.services, qtbot)
        assert split.shown
        canvas.set_scale(2.0)
        grip_before = split.grip.pos()
        hand.drag((640, 360), (560, 330), Qt.MouseButton.MiddleButton)
        assert (split.x, split.grip.pos()) == (x, grip_before)
        both, other = pixels(audited), self.alone(audited, "bad")
        assert same(both[150:460, round(x) + 3 :], other[150:460, round(x) + 3 :])

    def test_blind_mode_and_hidden_overlays_hide_it(self, audited, hand):
        split = audited.canvas.comparison.split
        hand.key(Qt.Key.Key_B)
        assert not split.shown
        assert not split.grip.isVisible()
        hand.key(Qt.Key.Key_B)
        assert split.shown
        QTest.keyPress(audited.canvas, Qt.Key.Key_X)
        assert not split.grip.isVisible()
        QTest.keyRelease(audited.canvas, Qt.Key.Key_X)
        assert split.grip.isVisible()

    def test_both_sides_follow_a_point_that_is_dragged(self, audited):
        services, hand = audited.services, Hand(audited)
        services.selection.set_mode("edit")
        polyline = services.state.annotation.get("Big rect. left main")
        point = polyline.points[-1]
        at = point.u * 1279, point.v * 719
        before = services.scorer.compared[1].labelling.all_distances.copy()
        hand.drag(at, (at[0] + 30, at[1] + 12))
        assert not np.array_equal(services.scorer.compared[1].labelling.all_distances, before)
        assert services.scorer.compared[1].jac == pytest.approx(
            float(audited.canvas.comparison.split.right.text.split("JaC")[1]), abs=5e-4
        )


class TestDisagreementOfSources:
    @pytest.fixture
    def services(self, scored, qtbot) -> Services:
        scored.camera_sources.compare_with(named(scored, "bad"))
        scored.disagreement.set_enabled(True)
        qtbot.waitUntil(lambda: scored.disagreement.value is not None)
        return scored

    @pytest.fixture
    def panel(self, services, show) -> CamerasPanel:
        return show(CamerasPanel(services))

    def cameras(self, services: Services) -> tuple[object, object]:
        return tuple(services.source_frames.of(named(services, n)).camera for n in ("true", "bad"))

    def text(self, panel: CamerasPanel, name: str) -> str:
        return panel.findChild(QLabel, name).text()

    def test_figures_are_those_of_the_metric(self, panel, services, qtbot):
        found = disagreement(
            *self.cameras(services), services.state.field, services.state.setup.size
        )
        for unit, decimals in (("m", 2), ("px", 1)):
            spread = found.statistics.metres if unit == "m" else found.statistics.pixels
            for figure in ("minimum", "median", "maximum"):
                shown = f"{getattr(spread, figure):.{decimals}f}"
                name = f"disagreement_{figure}_{unit}"
                qtbot.waitUntil(lambda n=name, s=shown: self.text(panel, n) == s)
        share = f"{100 * found.share_within(0.5):.0f} % within 0.5 m"
        assert self.text(panel, "disagreement_within").startswith(share)

    def test_another_frame_or_source_is_worked_out_anew(self, panel, services, qtbot):
        first = services.disagreement.value
        services.navigator.next_frame()
        assert services.disagreement.value is None  # never that of the frame before
        qtbot.waitUntil(lambda: services.disagreement.value is not None)
        second = services.disagreement.value
        assert second.values.statistics != first.values.statistics
        box = panel.findChild(QComboBox, "cameras_compared")
        qtbot.waitUntil(lambda: box.count() == 2)
        box.setCurrentIndex(1)
        box.activated.emit(1)
        qtbot.waitUntil(
            lambda: (
                services.disagreement.value is not None
                and services.disagreement.value.names == ("true", "pinhole")
            )
        )

    def test_what_was_asked_for_before_never_arrives_late(self, services, qtbot):
        for index in (2, 3, 5, 4, 1):
            services.navigator.go_to(index)
        qtbot.waitUntil(lambda: services.disagreement.value is not None)
        all_done(qtbot)
        expected = disagreement(
            *self.cameras(services), services.state.field, services.state.setup.size
        )
        assert services.disagreement.value.values.statistics == expected.statistics

    def test_a_camera_missing_in_one_is_said(self, panel, services, qtbot):
        services.navigator.go_to(3)
        qtbot.waitUntil(lambda: self.text(panel, "disagreement_problem") != "")
        assert self.text(panel, "disagreement_problem") == "bad: no camera for this frame."

    def test_the_same_cameras_are_said_to_be(self, services, annotated, qtbot):
        (annotated / "cameras" / "true").rename(annotated / "cameras" / "copy")
        services.camera_sources.load_cameras(annotated / "cameras" / "copy")
        services.camera_sources.compare_with(named(services, "true"))
        qtbot.waitUntil(lambda: "the same" in services.disagreement.problem)
        assert services.disagreement.value.values.statistics.metres.maximum < 1e-6

    def test_a_source_of_projections_alone_has_no_ground(self, services, qtbot):
        bad = named(services, "bad")
        shown = SourceFrame(camera=ElementProjections({}), model="projections")
        services.source_frames.put(bad.camera_set, services.state.frame.name, shown)
        services.disagreement.invalidate()
        assert "no ground to compare" in services.disagreement.problem
        assert services.disagreement.problem.startswith("bad shares only")

    def test_without_a_second_source_it_says_what_is_missing(self, services):
        for _ in range(2):
            services.camera_sources.remove_camera_set(1)
        assert services.disagreement.problem.startswith("Two sources")

    def test_without_a_judged_source_it_says_to_choose_one(self, services):
        services.camera_sources.set_active_camera(-1)
        problem = "No source is judged: choose one first."
        assert services.disagreement.problem == problem
        while len(services.state.sources) > 1:
            services.camera_sources.remove_camera_set(0)
        assert services.disagreement.problem.startswith("Two sources")

    def test_without_any_source_there_is_no_choice(self, panel, services, qtbot):
        comparing = panel.comparing
        qtbot.waitUntil(comparing.isVisible)
        while services.state.sources:
            services.camera_sources.remove_camera_set(0)
        qtbot.waitUntil(lambda: not comparing.isVisible())


class TestDisagreement:
    @pytest.fixture
    def plain(self, audited, qtbot) -> np.ndarray:
        """The canvas without it; of a fixture, for pytest keeps what a test's object holds."""
        for source in audited.services.state.sources:
            audited.services.camera_sources.set_source_visible(source, False)
        audited.services.camera_sources.compare_with(named(audited.services, "bad"))
        audited.panels.show("cameras")
        all_done(qtbot)
        return pixels(audited)

    @pytest.fixture(autouse=True)
    def show(self, audited, plain, qtbot) -> None:
        audited.actions_["disagreement"].trigger()
        qtbot.waitUntil(lambda: audited.services.disagreement.value is not None)

    def cameras(self, window: MainWindow) -> tuple[object, object]:
        services = window.services
        return tuple(services.source_frames.of(named(services, n)).camera for n in ("true", "bad"))

    def text(self, window: MainWindow, name: str) -> str:
        return window.findChild(QLabel, name).text()

    def test_the_status_line_says_it_of_the_cursor(self, audited, hand):
        for x, y in ((640.0, 500.0), (300.0, 640.0), (900.0, 420.0)):
            px = hand.picture(x, y)
            hand.move(x, y)
            at = np.array([[px[0] * 959 / 1279, px[1] * 539 / 719]])
            a, b = (ground_from_px(camera, at)[0] for camera in self.cameras(audited))
            words = audited.status.apart.text().split()
            assert float(words[1]) == pytest.approx(np.hypot(*(a - b)), abs=0.01)
            back, _ = self.cameras(audited)[1].project(np.array([[*a, 0.0]]))
            assert float(words[3]) == pytest.approx(np.hypot(*(back - at)[0]), abs=0.1)
        hand.move(640, 5)  # the crowd
        assert audited.status.apart.text() == ""

    def test_the_ground_is_covered_and_what_is_above_is_not(self, audited, plain):
        shown = pixels(audited)
        changed = np.abs(shown - plain).max(axis=2) > 8
        canvas = audited.canvas
        for x, y, covered in ((500, 560, True), (1000, 560, True), (640, 40, False)):
            at = canvas.to_view(x, y)
            assert changed[round(at.y()), round(at.x())] == covered

    def test_the_field_map_is_covered_where_it_is_seen(self, audited, qtbot):
        panel = audited.field_map
        qtbot.waitUntil(lambda: audited.services.visible_region.shown is not None)
        covered = panel.grab().toImage()
        seen = panel.to_widget(-40.0, 15.0).toPoint()
        unseen = panel.to_widget(5.0, 20.0).toPoint()
        audited.actions_["disagreement"].trigger()
        QApplication.processEvents()
        bare = panel.grab().toImage()
        assert covered.pixelColor(seen) != bare.pixelColor(seen)
        assert covered.pixelColor(unseen) == bare.pixelColor(unseen)

    def test_off_again_nothing_is_left(self, audited, plain, qtbot):
        assert audited.canvas.maps.legend.isVisible()
        assert audited.canvas.maps.legend.title == "true ↔ bad"
        audited.actions_["disagreement"].trigger()
        assert not audited.canvas.maps.legend.isVisible()
        qtbot.waitUntil(lambda: np.array_equal(pixels(audited), plain))
        assert not audited.status.apart.isVisible()

    def test_blind_mode_hides_it(self, audited, qtbot):
        audited.services.blind_lock.set_blind(True)
        assert audited.services.disagreement.value is None
        assert not audited.canvas.maps.legend.title
        qtbot.waitUntil(lambda: "Blind" in self.text(audited, "disagreement_problem"))
        audited.services.blind_lock.set_blind(False)
        qtbot.waitUntil(lambda: audited.services.disagreement.value is not None)

    def test_the_legend_says_the_unit_whatever_the_names(self, audited, qtbot, monkeypatch):
        painted: list[str] = []

        class Painter(QPainter):
            def drawText(self, *given: object) -> None:
                painted.append(str(given[-1]))
                super().drawText(*given)

        monkeypatch.setattr("procc_annotator.gui.canvas.metre_maps.QPainter", Painter)
        for source in audited.services.state.sources:
            audited.services.camera_sources.rename_source(
                source, f"cameras of {source.name} with a long name"
            )
        legend = audited.canvas.maps.legend
        qtbot.waitUntil(lambda: legend.title.count("long name") == 2)
        legend.grab()
        assert "metres on the ground" in painted
        assert any("…" in text and text.startswith("cameras of") for text in painted)
        assert "metres on the ground" in legend.accessibleName()
