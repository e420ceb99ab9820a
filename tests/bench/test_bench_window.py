"""What hands wait for: start, next frame, drag, undo, save, memory; on 1920x1080 pictures.

Figures are printed, medians of many; machines differ, so nothing here fails on a time.
"""

from __future__ import annotations

import json
import os
import shutil
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QPoint, QSettings, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytest_benchmark.fixture import BenchmarkFixture
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import points_px
from procc_annotator.gui.app import build_window
from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import Hand

FRAMES = 2_000
SIZE = (1920, 1080)
ELEMENT = "Big rect. left main"

_START = """
import sys, time, resource
begin = time.perf_counter()
from pathlib import Path
from PySide6.QtCore import QSettings
QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, sys.argv[2])
from procc_annotator.gui.app import application, build_window
app = application()
window = build_window(Path(sys.argv[1]))
window.resize(1920, 1080)
window.show()
app.processEvents()
window.grab()
print("start", time.perf_counter() - begin)
for index in range(75):
    window.document.go_to(index)
    app.processEvents()
print("memory", resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
window.close()
"""


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory, sample_data: Path) -> Path:
    """2,000 frames of 1920x1080 (links to the sample's, enlarged), annotated as the sample is."""
    folder = tmp_path_factory.mktemp("bench")
    originals = []
    for picture in sorted(sample_data.glob("*.jpg")):
        enlarged = folder / f"original_{picture.stem}.bin"
        pixels = cv2.resize(cv2.imread(str(picture)), SIZE, interpolation=cv2.INTER_CUBIC)
        _, encoded = cv2.imencode(".jpg", pixels, [cv2.IMWRITE_JPEG_QUALITY, 90])
        enlarged.write_bytes(encoded.tobytes())
        originals.append((enlarged, picture.with_suffix(".json")))
    for i in range(FRAMES):
        enlarged, annotation = originals[i % len(originals)]
        os.link(enlarged, folder / f"{i + 1:05d}.jpg")
        if annotation.exists():
            shutil.copy(annotation, folder / f"{i + 1:05d}.json")
    return folder


@pytest.fixture
def window(qtbot: QtBot, dataset: Path, tmp_path_factory: pytest.TempPathFactory) -> MainWindow:
    settings = str(tmp_path_factory.mktemp("settings"))
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, settings)
    made = build_window(dataset)
    qtbot.addWidget(made)
    made.resize(*SIZE)
    with qtbot.waitActive(made):
        made.show()
        made.activateWindow()
    return made


def report(what: str, benchmark: BenchmarkFixture, act: Callable[[], object], rounds: int) -> None:
    """Time an action together with the painting it causes; print the median."""
    times: list[float] = []

    def timed() -> None:
        begin = time.perf_counter()
        act()
        QApplication.processEvents()
        times.append((time.perf_counter() - begin) * 1e3)

    benchmark.pedantic(timed, rounds=rounds, warmup_rounds=2)
    print(f"\n{what}: {statistics.median(times):.2f} ms")


def test_start_and_memory(benchmark: BenchmarkFixture, dataset: Path, tmp_path: Path) -> None:
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    figures: dict[str, list[float]] = {"start": [], "memory": []}

    def run() -> None:
        command = [sys.executable, "-c", _START, str(dataset), str(tmp_path)]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        for line in done.stdout.splitlines():
            name, value = line.split()
            figures[name].append(float(value))

    benchmark.pedantic(run, rounds=3)
    print(
        f"\nstart to painted window, {FRAMES:,} frames: {statistics.median(figures['start']):.2f} s"
    )
    print(f"memory after 75 frames: {statistics.median(figures['memory']):.0f} MB")


def test_next_frame_prefetched(
    benchmark: BenchmarkFixture, window: MainWindow, qtbot: QtBot
) -> None:
    document = window.document
    state = {"index": 0}

    def forward() -> None:
        document.go_to(state["index"])

    def setup() -> None:
        state["index"] += 1
        path = document.workspace.frames[state["index"]].image_path
        qtbot.waitUntil(lambda: document.cache.peek(path) is not None)

    times: list[float] = []

    def timed() -> None:
        begin = time.perf_counter()
        forward()
        QApplication.processEvents()
        times.append((time.perf_counter() - begin) * 1e3)

    benchmark.pedantic(timed, setup=setup, rounds=30)
    print(f"\nnext frame, prefetched, 1920x1080: {statistics.median(times):.2f} ms")


@pytest.mark.parametrize("judged", [False, True], ids=["alone", "with live scores"])
def test_drag_and_undo(
    benchmark: BenchmarkFixture, window: MainWindow, sample_data: Path, judged: bool
) -> None:
    document, hand = window.document, Hand(window)
    document.go_to(1)
    if judged:
        document.load_cameras(sample_data / "cameras" / "bad")
    document.set_mode("edit")
    QApplication.processEvents()
    polyline = document.annotation.get(ELEMENT)
    assert polyline is not None
    x, y = points_px(polyline, SIZE)[0]
    grip = hand.at(float(x), float(y))
    viewport = window.canvas.viewport()
    none, left = Qt.KeyboardModifier.NoModifier, Qt.MouseButton.LeftButton
    QTest.mousePress(viewport, left, none, grip)
    steps = iter(range(10_000))

    def drag() -> None:
        i = next(steps)
        hand._move(grip + QPoint(3 + i % 40, (7 * i) % 30), left)

    name = "with live scores" if judged else "alone"
    report(f"drag a point, {name}", benchmark, drag, 150)
    QTest.mouseRelease(viewport, left, none, grip + QPoint(30, 20))
    times = []
    for i in range(60):
        begin = time.perf_counter()
        (document.redo if i % 2 else document.undo)()
        QApplication.processEvents()
        times.append((time.perf_counter() - begin) * 1e3)
    print(f"undo, saved and repainted, {name}: {statistics.median(times):.2f} ms")


def test_save(benchmark: BenchmarkFixture, window: MainWindow) -> None:
    document = window.document
    document.go_to(1)
    workspace = document.workspace
    shift = iter(np.linspace(0.1, 0.2, 10_000))

    def setup() -> None:
        raw = json.dumps({"Middle line": [{"x": float(next(shift)), "y": 0.5}] * 30})
        from procc_annotator.io.soccernet_annotation import read_annotation

        edited = read_annotation(raw.encode(), path="bench", field=document.field)
        workspace.edit(1, "bench", edited)

    times: list[float] = []

    def timed() -> None:
        begin = time.perf_counter()
        workspace.save(1)
        times.append((time.perf_counter() - begin) * 1e3)

    benchmark.pedantic(timed, setup=setup, rounds=100)
    print(f"\nsave, atomic, on disk: {statistics.median(times):.2f} ms")
