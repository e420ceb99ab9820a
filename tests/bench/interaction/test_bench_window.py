"""What hands wait for: start, next frame, drag, undo, save, memory; on 1920x1080 pictures.

Figures are printed, medians of many; machines differ, so nothing here fails on a time.
"""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import time
from collections import defaultdict
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytest_benchmark.fixture import BenchmarkFixture
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import points_px
from procc_annotator.gui.main_window import MainWindow
from tests.bench.interaction.conftest import FRAMES, SIZE, Report
from tests.gui.conftest import Hand

ELEMENT = "Big rect. left main"

_START = """
import os, sys, time
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
for index in range(500):
    window.document.go_to(index)
    app.processEvents()
    if index + 1 in (75, 200, 350, 500):
        # The peak that the system keeps would be that of the program this one was started by.
        pages = int(open("/proc/self/statm").read().split()[1])
        print(f"memory{index + 1}", pages * os.sysconf("SC_PAGE_SIZE") / 2**20)
window.close()
"""


def test_start_and_memory(benchmark: BenchmarkFixture, dataset: Path, tmp_path: Path) -> None:
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    figures: dict[str, list[float]] = defaultdict(list)

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
    for visited in (75, 200, 350, 500):
        peak = statistics.median(figures[f"memory{visited}"])
        print(f"memory after frame {visited}: {peak:.0f} MB")


def test_next_frame_prefetched(
    benchmark: BenchmarkFixture, window: MainWindow, qtbot: QtBot
) -> None:
    document = window.document
    document.go_to(0)  # a dataset opens where it was left
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
def test_drag_and_undo(report: Report, window: MainWindow, sample_data: Path, judged: bool) -> None:
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
    report(f"drag a point, {name}", drag, 150)
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
        from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation

        edited = read_annotation(raw.encode(), path="bench", field=document.field)
        workspace.edit(1, "bench", edited)

    times: list[float] = []

    def timed() -> None:
        begin = time.perf_counter()
        workspace.save(1)
        times.append((time.perf_counter() - begin) * 1e3)

    benchmark.pedantic(timed, setup=setup, rounds=100)
    print(f"\nsave, atomic, on disk: {statistics.median(times):.2f} ms")
