"""The uncertainty map: over the picture and the field map, never of an older fit."""

import numpy as np
import pytest
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from procc_annotator.calibration.prediction.uncertainty import ground_sd, map_ground_uncertainty
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.field_map.painting import ground_colour
from tests.gui.conftest import Hand

FRAME = 1  # twelve elements
BARE = 4  # nothing is annotated
SEEN = (-40.0, 5.0)  # on the ground, metres


@pytest.fixture
def shown(make_window, annotated, qtbot) -> MainWindow:
    """The sample with the map over its second frame."""
    window = make_window(annotated)
    window.services.navigator.go_to(FRAME)
    qtbot.waitUntil(lambda: window.services.live_fit.result is not None)
    qtbot.waitUntil(lambda: window.services.visible_region.shown is not None)
    QApplication.processEvents()
    window.plain, window.plain_map = pixels(window), map_image(window)
    window.actions_["uncertainty"].trigger()
    arrive(window, qtbot)
    return window


@pytest.fixture
def person(shown) -> Hand:
    return Hand(shown)


def arrive(window: MainWindow, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: window.services.uncertainty.value is not None)
    QApplication.processEvents()


def pixels(window: MainWindow) -> np.ndarray:
    """(H, W, 3) what the canvas shows, r g b."""
    QApplication.processEvents()
    image = window.canvas.grab().toImage().convertToFormat(QImage.Format.Format_RGB888)
    flat = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return flat[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def map_image(window: MainWindow) -> QImage:
    return window.field_map.grab().toImage()


def test_what_is_seen_of_the_field_is_covered(shown):
    changed = np.abs(pixels(shown) - shown.plain).max(axis=2) > 8
    for x, y, covered in ((500, 560, True), (1000, 500, True), (640, 40, False)):
        at = shown.canvas.to_view(x, y)
        assert changed[round(at.y()), round(at.x())] == covered, (x, y)
    covered_map = map_image(shown)
    for ground, covered in ((SEEN, True), ((5.0, 20.0), False)):
        at = shown.field_map.to_widget(*ground).toPoint()
        same = covered_map.pixelColor(at) == shown.plain_map.pixelColor(at)
        assert same != covered, ground


def test_the_legend_gives_the_shares(shown):
    services, legend = shown.services, shown.canvas.maps.legend
    expected = map_ground_uncertainty(services.live_fit.result, services.state.field)
    assert legend.isVisible()
    assert legend.lines == tuple(
        f"{m:g} m: {100 * expected.share_within_m(m):.0f} % of the field in sight"
        for m in (0.1, 0.5, 1.0)
    )
    assert f"fitted camera ({services.live_fit.result.model})" in legend.title
    assert f"median {expected.statistics.median:.2f}" in legend.accessibleName()


def test_the_status_line_says_it_of_the_cursor(shown, person):
    fit = shown.services.live_fit.result
    for x, y in ((640.0, 500.0), (300.0, 640.0)):
        person.move(x, y)
        ground = ground_from_px(fit.camera, np.array([person.picture(x, y)]))
        words = shown.status.good_to.text().split()
        assert (words[0], words[2]) == ("ground", "m")
        assert float(words[1].lstrip("±")) == pytest.approx(ground_sd(fit, ground)[0], abs=0.006)
    person.move(640, 5)  # the crowd
    assert shown.status.good_to.text() == ""


def test_never_of_the_fit_before_an_edit(shown, qtbot):
    services = shown.services
    before = services.uncertainty.value
    services.selection.select_class("Side line left")
    shown.actions_["delete_element"].trigger()
    assert services.uncertainty.value is None
    assert shown.canvas.maps.legend.lines[0] == "0.1 m: …"
    arrive(shown, qtbot)
    after = services.uncertainty.value
    assert after.values.fit is services.live_fit.result
    assert after.values.statistics.median > before.values.statistics.median


def test_another_frame_has_its_own(shown, qtbot):
    services = shown.services
    for index in (2, 3, FRAME + 1):
        services.navigator.go_to(index)
        assert services.uncertainty.value is None
    arrive(shown, qtbot)
    assert services.uncertainty.value.values.fit is services.live_fit.result


def test_without_a_camera_it_says_why(shown, qtbot):
    legend = shown.canvas.maps.legend
    shown.services.navigator.go_to(BARE)
    qtbot.waitUntil(lambda: "3 needed" in legend.problem)
    assert legend.isVisible()
    assert (legend.title, legend.lines) == ("", ())


def test_blind_mode_hides_it(shown, qtbot):
    services, legend = shown.services, shown.canvas.maps.legend
    services.blind_lock.set_blind(True)
    assert services.uncertainty.value is None
    assert legend.problem.startswith("Blind")
    assert (legend.title, legend.lines) == ("", ())
    assert shown.status.good_to.text() == ""
    at = shown.field_map.to_widget(*SEEN).toPoint()
    assert map_image(shown).pixel(at) == ground_colour(shown.field_map.palette()).rgb()
    services.blind_lock.set_blind(False)
    arrive(shown, qtbot)


def test_without_the_live_fit_there_is_none(shown, qtbot):
    live, legend = shown.services.live_fit, shown.canvas.maps.legend
    live.set_wanted(False)
    assert "live fit is off" in legend.problem
    live.set_wanted(True)
    arrive(shown, qtbot)
    assert legend.problem == ""


def test_off_again_nothing_is_left(shown):
    shown.actions_["uncertainty"].trigger()
    assert not shown.canvas.maps.legend.isVisible()
    assert not shown.status.good_to.isVisible()
    assert np.array_equal(pixels(shown), shown.plain)
    assert map_image(shown) == shown.plain_map


def test_hiding_overlays_hides_it(shown):
    shown.actions_["hide_overlays"].trigger()
    assert not shown.canvas.maps.legend.isVisible()
    at = shown.canvas.to_view(500, 560)
    place = round(at.y()), round(at.x())
    assert np.array_equal(pixels(shown)[place], shown.plain[place])
    shown.actions_["hide_overlays"].trigger()
    assert shown.canvas.maps.legend.isVisible()


def test_it_and_the_disagreement_take_turns(shown, annotated, qtbot):
    services, legend = shown.services, shown.canvas.maps.legend
    for name in ("true", "bad"):
        assert services.camera_sources.load_cameras(annotated / "cameras" / name)
    shown.actions_["disagreement"].trigger()
    assert not shown.actions_["uncertainty"].isChecked()
    qtbot.waitUntil(lambda: services.disagreement.value is not None)
    assert "↔" in legend.title
    assert not shown.status.good_to.isVisible()
    shown.actions_["uncertainty"].trigger()
    assert not shown.actions_["disagreement"].isChecked()
    arrive(shown, qtbot)
    assert services.disagreement.value is None
    assert "fitted camera" in legend.title
    assert not shown.status.apart.isVisible()


def test_a_homography_has_one_too(shown, qtbot):
    shown.services.live_fit.set_model("H")
    qtbot.waitUntil(lambda: "(H)" in shown.canvas.maps.legend.title)
    assert shown.services.uncertainty.value.values.share_within_m(5.0) > 0.5
