"""Take the README's pictures from the real window, on the sample data: ``make screenshots``."""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from PySide6.QtCore import QEventLoop, QPointF, QSettings, Qt, QTimer
from PySide6.QtTest import QTest

from procc_annotator.gui.app import application, build_window
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.theme import palette
from procc_annotator.session.camera_set import CameraSet

ROOT = Path(__file__).resolve().parent.parent
PICTURES = ROOT / "docs" / "pictures"
SIZE = (1440, 810)


def wait(milliseconds: int) -> None:
    """Let the window load, score and paint."""
    loop = QEventLoop()
    QTimer.singleShot(milliseconds, loop.quit)
    loop.exec()


def click(window: MainWindow, x: float, y: float) -> None:
    """Click a picture position with the mouse."""
    canvas = window.canvas
    place = canvas.mapFromScene(QPointF(x + 0.5, y + 0.5))
    QTest.mouseClick(canvas.viewport(), Qt.MouseButton.LeftButton, pos=place)


def audit(window: MainWindow, dataset: Path) -> None:
    """A mediocre camera judged against the clicks."""
    window.document.load_cameras(dataset / "cameras" / "bad")
    window.document.go_to(1)
    window.show_panel("scores")
    wait(2500)
    window.grab().save(str(PICTURES / "audit.png"))


def annotate(window: MainWindow, dataset: Path) -> None:
    """An element being clicked, in the dark theme."""
    document = window.document
    document.remove_camera_set(0)
    document.go_to(4)
    window.show_panel("elements")
    truth = CameraSet.open(dataset / "cameras" / "true").camera("00005", (960, 540))
    assert truth is not None

    def seen(points_world: list[tuple[float, float]]) -> list[list[float]]:
        px, _ = truth.camera.project(np.array([(x, y, 0.0) for x, y in points_world]))
        return (px * (1279 / 959, 719 / 539)).tolist()

    document.select_class("Big rect. right main")
    for x, y in seen([(36, -20.16), (36, -6), (36, 6)]):
        click(window, x, y)
    QTest.keyClick(window.canvas, Qt.Key.Key_Return)
    document.select_class("Circle right")
    wait(300)
    for x, y in seen([(41.5 + 9.15 * np.cos(a), 9.15 * np.sin(a)) for a in (4.0, 3.7, 3.4, 3.1)]):
        click(window, x, y)
    wait(600)
    window.grab().save(str(PICTURES / "annotate.png"))
    QTest.keyClick(window.canvas, Qt.Key.Key_Escape)


def main() -> None:
    PICTURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        QSettings.setDefaultFormat(QSettings.Format.IniFormat)
        QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, folder)
        dataset = Path(folder) / "sample_data"
        shutil.copytree(ROOT / "sample_data", dataset)
        app = application()
        window = build_window(dataset)
        window.resize(*SIZE)
        window.show()
        wait(800)
        audit(window, dataset)
        app.setPalette(palette(dark=True))
        annotate(window, dataset)
        window.close()


if __name__ == "__main__":
    main()
