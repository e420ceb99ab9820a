"""Datasets as large as real ones, and the real window on them."""

import os
import shutil
import statistics
import time
from collections.abc import Callable
from pathlib import Path

import cv2
import pytest
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication

from procc_annotator.gui.app import build_window
from procc_annotator.gui.main_window import MainWindow

FRAMES = 2_000
SIZE = (1920, 1080)
Report = Callable[..., None]


@pytest.fixture(scope="module")
def dataset(tmp_path_factory, sample_data) -> Path:
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
def window(qtbot, dataset, tmp_path_factory) -> MainWindow:
    settings = str(tmp_path_factory.mktemp("settings"))
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, settings)
    made = build_window(dataset)
    qtbot.addWidget(made)
    made.resize(*SIZE)
    with qtbot.waitActive(made):
        made.show()
        made.activateWindow()
    return made


@pytest.fixture
def report(benchmark) -> Report:
    """Time an action together with the painting it causes; print the median."""

    def measure(
        what: str,
        act: Callable[[], object],
        rounds: int,
        setup: Callable[[], object] | None = None,
    ) -> None:
        times: list[float] = []

        def timed() -> None:
            begin = time.perf_counter()
            act()
            QApplication.processEvents()
            times.append((time.perf_counter() - begin) * 1e3)

        def prepare() -> None:
            if setup is not None:
                setup()

        benchmark.pedantic(timed, setup=prepare, rounds=rounds, warmup_rounds=2)
        worst = max(times[2:])
        print(f"\n{what}: median {statistics.median(times[2:]):.2f} ms, worst {worst:.2f} ms")

    return measure
