"""Snapping, regularising, copying, and very large datasets, on 1920x1080 pictures.

Figures are printed, medians of many; machines differ, so nothing here fails on a time.
"""

import os
import shutil
import time
from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QApplication

from procc_annotator.annotation import points_px
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.records import Status
from procc_annotator.gui.app import build_window
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.image.line_snapping import snap_to_line
from tests.bench.interaction.conftest import SIZE
from tests.gui.conftest import Hand

MANY = 20_000
PAN = 0.1  # of the width


def near_lines(window: MainWindow, count: int) -> Iterator[tuple[float, float]]:
    """Places up to 4 px beside the annotated points of the frame, again and again."""
    rng = np.random.default_rng(1)
    places = [points_px(p, SIZE) for p in window.services.state.annotation.polylines]
    points = np.concatenate(places)
    inside = points[((points > 40) & (points < np.array(SIZE) - 40)).all(axis=1)]
    for i in range(count):
        x, y = inside[i % len(inside)] + rng.uniform(-3, 3, 2)
        yield float(x), float(y)


def test_click_with_snap(window, report):
    services, hand = window.services, Hand(window)
    services.navigator.go_to(1)
    places = near_lines(window, 10_000)
    services.selection.set_mode("draw")
    services.selection.select_class("Circle left", continues=True)
    QApplication.processEvents()
    before = len(points_px(services.state.annotation.get("Circle left"), SIZE))
    clicked: list[tuple[float, float]] = []
    report("a click that snaps, repainted", lambda: clicked.append(hand.click(*next(places))), 60)
    hand.key(Qt.Key.Key_Return)
    drawn = points_px(services.state.annotation.get("Circle left"), SIZE)
    assert len(drawn) == before + len(clicked)
    moved = np.hypot(*(drawn[before:] - clicked).T) > 0.01
    assert moved.mean() > 0.3  # the others are at crossings, or on no paint


def test_snap_alone(window, report):
    window.services.navigator.go_to(1)
    picture = window.services.navigator.picture
    assert picture is not None
    places = near_lines(window, 10_000)
    report("finding a line's centre", lambda: snap_to_line(picture, next(places)), 300)
    direction = (1.0, 0.2)
    report_places = near_lines(window, 10_000)
    begin = time.perf_counter()
    for _ in range(300):
        snap_to_line(picture, next(report_places), direction=direction)
    print(f"with a known direction: {(time.perf_counter() - begin) / 300 * 1e3:.2f} ms")


def test_regularise_a_frame(window, qtbot, report):
    services = window.services
    services.navigator.go_to(1)
    elements = len(services.state.annotation.polylines)

    def regularise() -> None:
        with qtbot.waitSignal(
            services.store.events.message, check_params_cb=lambda m: "regularise" in m.text
        ):
            window.assistant.regularise_frame()

    def restore() -> None:
        services.editing.undo()

    report(f"regularise a frame of {elements} elements, in the background", regularise, 10, restore)


@pytest.fixture
def panned(tmp_path, dataset) -> Path:
    """Two frames, the second a tenth of the width further to the side; the first is annotated."""
    folder = tmp_path / "panned"
    folder.mkdir()
    wide = cv2.resize(cv2.imread(str(dataset / "00002.jpg")), (SIZE[0] * 2, SIZE[1] * 2))
    for i, shift in enumerate((0, round(PAN * SIZE[0]))):
        top = SIZE[1] // 2
        part = wide[top : top + SIZE[1], 800 + shift : 800 + shift + SIZE[0]]
        cv2.imwrite(str(folder / f"{i}.jpg"), part, [cv2.IMWRITE_JPEG_QUALITY, 90])
    shutil.copy(dataset / "00002.json", folder / "0.json")
    return folder


def test_copy_with_motion(qtbot, panned, tmp_path, report):
    QSettings.setPath(
        QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(tmp_path / "settings")
    )
    window = build_window(panned)
    qtbot.addWidget(window)
    services = window.services
    services.navigator.go_to(1)

    def copy() -> None:
        with qtbot.waitSignal(
            services.store.events.message, check_params_cb=lambda m: "copied" in m.text
        ):
            window.assistant.copy_from_previous()

    report("copy, moved with the camera", copy, 10, services.editing.undo)
    services.close()


def test_open_a_very_large_dataset(benchmark, qtbot, dataset, tmp_path):
    """Everything up to the painted window, its database full of statuses and comments."""
    folder = tmp_path / "many"
    folder.mkdir()
    names = [f"{i:06d}" for i in range(MANY)]
    for name in names:
        os.link(dataset / "00001.jpg", folder / f"{name}.jpg")
    database = WorkspaceDatabase.open(folder, "bench")
    states = (Status.DONE, Status.APPROVED, Status.REJECTED, Status.IN_PROGRESS)
    for i, name in enumerate(names):
        database.set_status(name, states[i % len(states)])
        if i % 20 == 0:
            database.add_comment(name, "the far line is hidden")
    database.close()
    QSettings.setPath(
        QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(tmp_path / "settings")
    )
    window = build_window(None)
    qtbot.addWidget(window)
    window.resize(*SIZE)
    window.show()
    QApplication.processEvents()

    def opened() -> None:
        window.services.opening.open_path(folder)
        QApplication.processEvents()
        window.grab()

    benchmark.pedantic(opened, rounds=5, warmup_rounds=1)
    assert len(window.services.state.workspace.frames) == MANY
    assert window.services.review.database.record(names[2]).status == Status.REJECTED
    print(f"\nopen {MANY:,} frames with their database: {benchmark.stats.stats.median:.2f} s")
    window.services.close()
