"""Several camera sources on 2,000 frames of 1920x1080: switching, drawing, comparing.

Figures are printed, medians of many; machines differ, so nothing here fails on a time.
"""

import itertools
import time
from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from procc_annotator.annotation import points_px
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.maps import compare_cameras
from procc_annotator.gui.state.services import Services
from tests.bench.interaction.conftest import FRAMES, SIZE
from tests.gui.conftest import Hand, all_done

SETS = ("bad", "homography", "pinhole", "true")


@pytest.fixture
def sources(window, sample_data, tmp_path, qtbot) -> MainWindow:
    """Four sources that have a camera for every frame, all of them audited."""
    services = window.services
    for name in SETS:
        files = sorted((sample_data / "cameras" / name).iterdir())
        folder = tmp_path / name
        folder.mkdir()
        for i in range(FRAMES):
            file = files[i % len(files)]
            prefix = "camera_" if file.suffix == ".json" else ""
            (folder / f"{prefix}{i + 1:05d}{file.suffix}").symlink_to(file)
        begin = time.perf_counter()
        assert services.camera_sources.load_cameras(folder)
        print(f"\nload {FRAMES:,} cameras ({name}): {(time.perf_counter() - begin) * 1e3:.0f} ms")
    begin = time.perf_counter()
    qtbot.waitUntil(lambda: not services.scoring.running, timeout=300_000)
    print(f"audit the set for {len(SETS)} sources: {time.perf_counter() - begin:.1f} s")
    services.navigator.go_to(1)
    qtbot.waitUntil(
        lambda: all(services.source_frames.of(s) is not None for s in services.state.sources)
    )
    all_done(qtbot)
    return window


def test_switch_the_active_source(sources, report):
    services = sources.services
    turns = itertools.cycle(range(len(SETS)))
    report(
        "switch the active source, all redrawn",
        lambda: services.camera_sources.set_active_camera(next(turns)),
        60,
    )
    _assert_shown(services, turns)
    sources.panels.show("cameras")
    QApplication.processEvents()


def test_switch_with_the_panel_of_sources(sources, report):
    sources.panels.show("cameras")
    QApplication.processEvents()
    services = sources.services
    turns = itertools.cycle(range(len(SETS)))
    report(
        "switch, list of sources open",
        lambda: services.camera_sources.set_active_camera(next(turns)),
        60,
    )
    _assert_shown(services, turns)


def _assert_shown(services: Services, turns: Iterator[int]) -> None:
    """The source that was switched to last is the one that is judged, and drawn."""
    assert services.state.active is services.state.sources[(next(turns) - 1) % len(SETS)]
    assert services.scorer.measurement is not None


@pytest.mark.parametrize("split", [False, True], ids=["wireframes", "wireframes and split"])
def test_drag_beside_other_sources(sources, report, split):
    services, hand = sources.services, Hand(sources)
    services.camera_sources.set_active_camera(0)
    services.selection.set_mode("edit")
    if split:
        sources.actions_["split"].trigger()
    QApplication.processEvents()
    polyline = services.state.annotation.get("Big rect. left main")
    assert polyline is not None
    grip = hand.at(*map(float, points_px(polyline, SIZE)[0]))
    viewport = sources.canvas.viewport()
    none, left = Qt.KeyboardModifier.NoModifier, Qt.MouseButton.LeftButton
    QTest.mousePress(viewport, left, none, grip)
    steps = iter(range(10_000))

    def drag() -> None:
        i = next(steps)
        hand._move(grip + QPoint(3 + i % 40, (7 * i) % 30), left)

    report(f"drag a point, {'split view' if split else 'three wireframes'}", drag, 150)
    QTest.mouseRelease(viewport, left, none, grip)


def test_move_the_divider(sources, report):
    sources.actions_["split"].trigger()
    split = sources.canvas.comparison.split
    places = itertools.cycle([*range(300, 900, 12), *range(900, 300, -12)])
    report("move the divider", lambda: split.move_to(float(next(places))), 120)
    split.move_to(612.0)
    assert split.x == pytest.approx(612.0, abs=1.0)


def test_next_frame_with_four_sources(sources, report, qtbot):
    services = sources.services
    indices = itertools.count(2)

    def ready() -> None:
        index = services.state.frame_index + 1
        frame = services.state.workspace.frames[index]
        qtbot.waitUntil(lambda: services.cache.peek(frame.image_path) is not None)
        all_done(qtbot)

    report(
        "next frame, four sources", lambda: services.navigator.go_to(next(indices)), 25, setup=ready
    )


def test_disagreement(sources, report, qtbot):
    services = sources.services
    size, field = (1280, 720), services.state.field
    folder = services.state.sources
    for a, b in (("pinhole", "true"), ("bad", "homography")):
        pair = [
            CameraSet.open(next(s.camera_set.path for s in folder if s.name == name))
            for name in (a, b)
        ]
        cameras = [found.camera("00002", size).camera for found in pair]
        times = []
        for _ in range(20):
            begin = time.perf_counter()
            compare_cameras((a, b), cameras[0], cameras[1], field, size)
            times.append((time.perf_counter() - begin) * 1e3)
        print(f"\ndisagreement of {a} and {b}, 1280x720: {sorted(times)[10]:.1f} ms")
    sources.actions_["disagreement"].trigger()
    qtbot.waitUntil(lambda: services.disagreement.value is not None)
    shown = services.disagreement
    report("show it on picture and field map", shown.changed.emit, 40)
