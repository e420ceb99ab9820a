"""A large picture that is not decoded yet is looked at in half its size until it is."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from procc_annotator.calibration.label_check.evidence import LinePresence
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.image.decoding import decode_bgra, decode_half_size
from tests.gui.conftest import Hand

SIZE = (1921, 1081)
LINE_X = 1200


@pytest.fixture
def large(tmp_path) -> Path:
    """Six pictures with a bright line from top to bottom."""
    folder = tmp_path / "large"
    folder.mkdir()
    picture = np.full((SIZE[1], SIZE[0], 3), (60, 130, 60), dtype=np.uint8)
    picture[:, LINE_X - 4 : LINE_X + 5] = 235
    for i in range(6):
        cv2.imwrite(str(folder / f"{i}.jpg"), picture, [cv2.IMWRITE_JPEG_QUALITY, 95])
    return folder


@pytest.fixture
def window(make_window, large, qtbot) -> MainWindow:
    made = make_window(large)
    qtbot.waitUntil(lambda: made.services.state.half is None)
    return made


def shown(window: MainWindow) -> np.ndarray:
    image = window.canvas.viewport().grab().toImage()
    size = image.height(), image.width(), 4
    return np.frombuffer(image.constBits(), np.uint8).reshape(size)[:, :, :3].astype(int)


def test_half_its_size_is_shown_first_in_the_same_place(window, qtbot):
    services = window.services
    services.navigator.go_to(5)
    state = services.state
    assert state.half is not None
    assert state.picture is None
    assert services.state.picture_size == SIZE
    first, place = shown(window), window.canvas.sceneRect()
    qtbot.waitUntil(lambda: services.state.picture is not None)
    assert services.state.half is None
    assert services.state.picture_size == SIZE
    assert window.canvas.sceneRect() == place
    whole = shown(window)
    assert np.abs(first - whole).mean() < 2
    # Where the line is brightest hangs on how it is sampled, its middle does not.
    bright = [np.clip(row[:, 0] - 100, 0, None) for row in (first[360], whole[360])]
    middles = [np.average(np.arange(len(row)), weights=row) for row in bright]
    assert abs(middles[0] - middles[1]) < 1


def test_who_walks_on_before_it_is_painted_spares_the_whole_one(window, qtbot, monkeypatch):
    services, decoded = window.services, []
    get_ready = services.cache.get_ready

    def noted(path: Path) -> np.ndarray:
        decoded.append(path.stem)
        return get_ready(path)

    monkeypatch.setattr(services.cache, "get_ready", noted)
    services.navigator.go_to(3)
    services.navigator.go_to(5)
    qtbot.waitUntil(lambda: services.state.picture is not None)
    assert decoded == ["5"]


def test_zoomed_in_it_is_in_the_same_place_too(window, qtbot):
    window.canvas.keep_zoom = True
    for _ in range(12):
        window.canvas.zoom_in()
    assert window.canvas.view_scale > 2
    window.services.navigator.go_to(5)
    assert window.services.state.half is not None
    first = shown(window)
    qtbot.waitUntil(lambda: window.services.state.picture is not None)
    assert np.abs(first - shown(window)).mean() < 6


def test_a_click_snaps_to_every_pixel(window):
    services, hand = window.services, Hand(window)
    services.navigator.go_to(5)
    assert services.state.half is not None
    services.selection.select_class("Middle line")
    hand.click(LINE_X + 5, 300)
    assert services.state.picture is not None
    hand.click(LINE_X - 5, 700)
    hand.key(Qt.Key.Key_Return)
    polyline = services.state.annotation.get("Middle line")
    assert [p.u * (SIZE[0] - 1) for p in polyline.points] == pytest.approx([LINE_X] * 2, abs=0.5)


def test_a_frame_that_is_passed_is_not_waited_for(window, qtbot):
    services = window.services
    for index in (5, 3, 0, 4):
        services.navigator.go_to(index)
    qtbot.waitUntil(lambda: services.state.picture is not None)
    assert services.state.frame_index == 4
    assert services.state.half is None


def test_what_asks_for_the_picture_gets_all_of_it(window, large):
    window.services.navigator.go_to(5)
    assert window.services.state.half is not None
    assert np.array_equal(window.services.navigator.picture, decode_bgra(large / "5.jpg"))


def test_the_loupe_shows_every_pixel(window):
    canvas, hand = window.canvas, Hand(window)
    hand.move(LINE_X, 500)
    canvas.set_loupe_always(True)
    assert canvas.loupe.isVisible()
    window.services.navigator.go_to(5)
    assert canvas.loupe.isVisible()
    assert canvas.shown.pixels.shape[:2] == SIZE[::-1]


def test_a_picture_that_goes_before_all_of_it_was_read(window, large, qtbot, monkeypatch):
    services = window.services
    monkeypatch.setattr(services.cache, "get_ready", lambda path: decode_bgra(large / "gone.jpg"))
    services.navigator.go_to(5)
    qtbot.waitUntil(lambda: services.state.half is None)
    assert "gone.jpg" in services.state.why_not_editable
    assert services.state.picture_size is None
    assert not services.state.editable
    monkeypatch.undo()
    services.navigator.go_to(4)
    qtbot.waitUntil(lambda: services.state.picture is not None)
    assert services.state.editable


def test_lines_are_enhanced_in_the_whole_picture_only(window, qtbot):
    from procc_annotator.image.pixels import DisplayAdjustment

    window.canvas.shown.set_look(DisplayAdjustment(enhance=True))
    window.services.navigator.go_to(5)
    qtbot.waitUntil(lambda: window.services.state.picture is not None)
    plain = window.services.navigator.picture
    qtbot.waitUntil(lambda: not np.array_equal(window.canvas.shown.pixels, plain))
    assert window.canvas.shown.pixels.shape == plain.shape


def test_a_wheel_and_a_key_meanwhile(window, qtbot):
    window.services.navigator.go_to(5)
    QTest.keyClick(window.canvas, Qt.Key.Key_A)
    assert window.services.state.frame_index == 4
    qtbot.waitUntil(lambda: window.services.state.picture is not None)


@pytest.mark.parametrize("turned", [False, True])
def test_half_of_a_picture_stored_lying_on_its_side(tmp_path, turned):
    path = tmp_path / "one.jpg"
    picture = np.zeros((SIZE[1], SIZE[0], 3), np.uint8)
    picture[:, :900] = 200
    data = cv2.imencode(".jpg", picture)[1].tobytes()
    if turned:  # EXIF: orientation 6
        exif = b"Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0"
        data = data[:2] + b"\xff\xe1" + (len(exif) + 2).to_bytes(2, "big") + exif + data[2:]
    path.write_bytes(data)
    whole, half = decode_bgra(path), decode_half_size(path)
    assert half.size == (whole.shape[1], whole.shape[0])
    assert half.size == (SIZE[::-1] if turned else SIZE)
    again = cv2.resize(whole, half.pixels.shape[1::-1], interpolation=cv2.INTER_AREA)
    assert np.abs(again.astype(int) - half.pixels).mean() < 2


def test_small_pictures_and_other_formats_are_decoded_at_once(tmp_path):
    cv2.imwrite(str(tmp_path / "small.jpg"), np.zeros((540, 960, 3), np.uint8))
    cv2.imwrite(str(tmp_path / "large.png"), np.zeros((1080, 1920, 3), np.uint8))
    (tmp_path / "no.jpg").write_bytes(b"\xff\xd8 nothing")
    for name in ("small.jpg", "large.png", "no.jpg", "missing.jpg"):
        assert decode_half_size(tmp_path / name) is None


def test_what_the_picture_shows_of_paint_is_told_once_the_whole_one_is_there(window, large, qtbot):
    services = window.services
    line = ((LINE_X, 100), (LINE_X, 900))
    points = [{"x": x / (SIZE[0] - 1), "y": y / (SIZE[1] - 1)} for x, y in line]
    (large / "5.json").write_text(json.dumps({"Middle line": points}))
    services.navigator.go_to(5)
    assert services.state.half is not None
    qtbot.waitUntil(lambda: services.line_pixels.value is not None)
    (seen,) = services.line_pixels.value.values()
    assert (seen.paint == LinePresence.UNDER).mean() > 0.9
