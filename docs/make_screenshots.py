"""Take the README's pictures from the real window, in both themes: ``make screenshots``.

They show the sample data, and a shot that is drawn for it; everything is done by the window itself.
"""

from __future__ import annotations

import json
import os
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import cv2
import numpy as np
from PySide6.QtCore import QEventLoop, QPointF, QSettings, Qt, QTimer
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from procc_annotator.annotation import points_px
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.records import Status
from procc_annotator.gui.app import application, build_window
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.theme import is_dark, wear

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from tests.drawn_shots import cut_shot  # noqa: E402
from tests.unit.interaction.test_palette import SEEN_BY  # noqa: E402

PICTURES = ROOT / "docs" / "pictures"
SIZE = (1440, 810)
FRAMES = 60  # of the drawn shot
QUALITY = 88  # of WebP: text stays sharp, turf takes a tenth of what it takes as PNG
FILM_SIZE, FILM_QUALITY = (800, 450), 50
PATIENCE_MS, STEP_MS = 120_000, 200


def wait(milliseconds: int) -> None:
    """Let the window load, score and paint."""
    loop = QEventLoop()
    QTimer.singleShot(milliseconds, loop.quit)
    loop.exec()


def wait_until(done: Callable[[], bool], what: str) -> None:
    """Let the window work until it is through.

    Raises:
        SystemExit: it takes too long.
    """
    for _ in range(PATIENCE_MS // STEP_MS):
        if done():
            return
        wait(STEP_MS)
    raise SystemExit(f"{what}: not done after {PATIENCE_MS // 1000} s")


def take(window: MainWindow, name: str) -> None:
    """Keep what the window shows, in the theme it has."""
    dark = "-dark" if is_dark(QApplication.palette()) else ""
    window.grab().toImage().save(str(PICTURES / f"{name}{dark}.webp"), "WEBP", QUALITY)


class Film:
    """An animation of what the window shows, in the theme it has."""

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._frames: list[np.ndarray] = []
        self._durations_ms: list[int] = []

    def add(self, duration_ms: int) -> None:
        """Add what is shown now, for so long."""
        image = self._window.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
        pixels = np.frombuffer(image.constBits(), np.uint8)
        bgr = pixels.reshape(image.height(), image.bytesPerLine() // 4, 4)[:, : image.width(), :3]
        self._frames.append(cv2.resize(bgr, FILM_SIZE, interpolation=cv2.INTER_AREA))
        self._durations_ms.append(duration_ms)

    def write(self, name: str) -> None:
        """Write it as animated WebP, which repeats."""
        dark = "-dark" if is_dark(QApplication.palette()) else ""
        film = cv2.Animation()
        film.frames, film.durations = self._frames, self._durations_ms
        path = str(PICTURES / f"{name}{dark}.webp")
        if not cv2.imwriteanimation(path, film, [cv2.IMWRITE_WEBP_QUALITY, FILM_QUALITY]):
            raise SystemExit(f"{path}: cannot be written")


def as_others_see_it(name: str) -> None:
    """Put a picture that was taken beside itself as it is without one of the eye's three receptors:
    all, no red, no green, no blue, in two rows."""
    dark = "-dark" if is_dark(QApplication.palette()) else ""
    taken = cv2.imread(str(PICTURES / f"{name}{dark}.webp"))
    assert taken is not None
    small = cv2.resize(taken, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)
    srgb = small[:, :, ::-1] / 255
    linear = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)  # IEC 61966
    seen = []
    for matrix in SEEN_BY.values():
        light = np.clip(linear @ matrix.T, 0, 1)
        back = np.where(light <= 0.0031308, light * 12.92, 1.055 * light ** (1 / 2.4) - 0.055)
        seen.append(np.round(back[:, :, ::-1] * 255).astype(np.uint8))
    four = np.vstack([np.hstack(seen[:2]), np.hstack(seen[2:])])
    cv2.imwrite(
        str(PICTURES / f"{name}-eyes{dark}.webp"), four, [cv2.IMWRITE_WEBP_QUALITY, QUALITY]
    )


def click(window: MainWindow, x: float, y: float) -> None:
    """Click a picture position with the mouse."""
    canvas = window.canvas
    place = canvas.mapFromScene(QPointF(x + 0.5, y + 0.5))
    QTest.mouseClick(canvas.viewport(), Qt.MouseButton.LeftButton, pos=place)


def audit(window: MainWindow, dataset: Path) -> None:
    """A mediocre camera judged against the clicks."""
    window.services.camera_sources.load_cameras(dataset / "cameras" / "bad")
    window.services.navigator.go_to(1)
    window.panels.show("scores")
    wait(2500)
    take(window, "audit")
    as_others_see_it("audit")


def other_sport(folder: Path) -> None:
    """A basketball frame and a camera that lags behind."""
    dataset = folder / "basketball"
    shutil.copytree(ROOT / "sample_data" / "basketball", dataset)
    window = build_window(dataset)
    window.resize(*SIZE)
    window.show()
    window.services.camera_sources.load_cameras(dataset / "cameras" / "late")
    window.services.navigator.go_to(1)
    window.panels.show("scores")
    wait(2500)
    take(window, "basketball")
    window.close()


def annotate(window: MainWindow, dataset: Path) -> None:
    """An element being clicked."""
    services = window.services
    services.camera_sources.remove_camera_set(0)
    services.navigator.go_to(4)
    window.panels.show("elements")
    truth = CameraSet.open(dataset / "cameras" / "true").camera("00005", (960, 540))
    assert truth is not None

    def seen(points_world: list[tuple[float, float]]) -> list[list[float]]:
        px, _ = truth.camera.project(np.array([(x, y, 0.0) for x, y in points_world]))
        return (px * (1279 / 959, 719 / 539)).tolist()

    services.selection.select_class("Big rect. right main")
    for x, y in seen([(36, -20.16), (36, -6), (36, 6)]):
        click(window, x, y)
    QTest.keyClick(window.canvas, Qt.Key.Key_Return)
    services.selection.select_class("Circle right")
    wait(300)
    for x, y in seen([(41.5 + 9.15 * np.cos(a), 9.15 * np.sin(a)) for a in (4.0, 3.7, 3.4, 3.1)]):
        click(window, x, y)
    wait(600)
    take(window, "annotate")
    QTest.keyClick(window.canvas, Qt.Key.Key_Escape)


def copy(folder: Path, dataset: Path) -> None:
    """Elements copied to the next frame of a panning camera, one of them under the loupe."""
    panned = folder / "panned"
    panned.mkdir()
    picture = cv2.imread(str(dataset / "00002.jpg"))
    height, width = picture.shape[:2]
    part, shift = round(0.9 * width), round(0.08 * width)
    for name, left in (("00001", 0), ("00002", shift)):
        cv2.imwrite(str(panned / f"{name}.jpg"), picture[:, left : left + part])
    window = build_window(dataset)
    source = window.services
    source.navigator.go_to(1)
    polylines = source.state.annotation.polylines
    first = [p for p in polylines if max(q.u for q in p.points) < part / width]
    scale = (width - 1) / (part - 1)
    entries = {p.class_name: [{"x": q.u * scale, "y": q.v} for q in p.points] for p in first}
    (panned / "00001.json").write_text(json.dumps(entries))
    source.opening.open_path(panned)
    window.resize(*SIZE)
    window.show()
    wait(600)
    source.navigator.go_to(1)
    window.assistant.copy_from_previous()
    wait(900)
    source.selection.set_mode("edit")
    window.actions_["loupe"].trigger()
    waiting = source.state.annotation.get_unconfirmed("Big rect. left main")
    if waiting is None:
        raise SystemExit("the camera's motion was not found: nothing to show")
    x, y = points_px(waiting, (part, height))[-1]
    place = window.canvas.mapFromScene(QPointF(x + 0.5, y + 0.5))
    QTest.mouseMove(window.canvas.viewport(), place)
    wait(400)
    take(window, "copy")
    window.close()


def review(window: MainWindow, dataset: Path) -> None:
    """Frames filtered by a query, one of them with a thread of comments."""
    services = window.services
    services.camera_sources.load_cameras(dataset / "cameras" / "bad")
    wait(1500)
    for number, status in (
        (2, Status.APPROVED),
        (3, Status.REJECTED),
        (4, Status.DONE),
        (6, Status.DONE),
        (7, Status.REJECTED),
        (8, Status.REJECTED),
        (11, Status.DONE),
    ):
        services.review.set_status(f"{number:05d}", status)
    services.navigator.go_to(2)
    services.selection.select_class(None)
    window.panels.show("review")
    name = "00003"
    services.review.add_comment(name, "The far touchline ends before the corner.")
    services.review.add_comment(name, "The arc sits on the edge of the paint, not its middle.")
    window.frames.filter.setText("state:rejected,done jac5:<0.8")
    wait(800)
    take(window, "review")


def disagree(folder: Path) -> None:
    """Two sources: where they disagree on the ground, with the plots of both, in a new window."""
    dataset = folder / "disagreement"
    shutil.copytree(ROOT / "sample_data", dataset)
    window = build_window(dataset)
    window.resize(*SIZE)
    window.show()
    services = window.services
    for name in ("true", "bad"):
        services.camera_sources.load_cameras(dataset / "cameras" / name)
    services.navigator.go_to(5)
    window.panels.show("cameras")
    window.actions_["disagreement"].trigger()
    wait(2500)
    take(window, "disagreement")
    window.actions_["disagreement"].trigger()
    window.actions_["split"].trigger()
    window.panels.show("plots")
    wait(2500)
    take(window, "plots")
    window.close()


def clicks(folder: Path) -> None:
    """The camera of four clicked elements: a ghost about to be accepted; labels that are wrong."""
    dataset = folder / "clicks"
    shutil.copytree(ROOT / "sample_data", dataset)
    window = build_window(dataset)
    window.resize(*SIZE)
    window.show()
    services = window.services
    services.navigator.go_to(1)
    annotation = services.state.annotation
    for name in annotation.annotated[4:]:
        annotation = annotation.without(name)
    services.editing.commit_edit("four elements", annotation)
    window.panels.show("fit")
    window.canvas.setFocus()
    wait(2000)
    QTest.keyClick(window.canvas, Qt.Key.Key_Tab)
    wait(1500)
    take(window, "ghosts")
    QTest.keyClick(window.canvas, Qt.Key.Key_Escape)
    services.navigator.go_to(2)
    services.selection.select_class("Side line right")
    window.element_edits.change_class("Side line left")
    window.panels.show("findings")
    wait(3000)
    take(window, "check")
    window.close()


def without_a_click(folder: Path) -> None:
    """A shot that nobody annotated: its camera is found in one picture and followed through all."""
    shot = folder / "shot"
    shot.mkdir()
    drawn = cut_shot(FRAMES)
    for number in range(FRAMES):
        cv2.imwrite(str(shot / f"match_{number:06d}.jpg"), drawn.frame(number)[..., :3])
    window = build_window(shot)
    window.resize(*SIZE)
    window.show()
    services = window.services
    services.navigator.go_to(FRAMES // 6)
    window.panels.show("elements")
    wait_until(lambda: bool(services.ghosts.painted), "looking for the camera in the picture")
    wait(1500)
    take(window, "proposal")
    film = Film(window)
    film.add(1800)
    window.canvas.setFocus()
    QTest.keyClick(window.canvas, Qt.Key.Key_Return, Qt.KeyboardModifier.ShiftModifier)
    wait(1500)
    film.add(1500)
    QTest.keyClick(window.canvas, Qt.Key.Key_T)
    while window.shot_following.running:
        wait(STEP_MS)
        film.add(STEP_MS)
    services.navigator.go_to(FRAMES // 3)
    wait(1500)
    take(window, "strip")
    film.add(1000)
    QTest.keyClick(
        window.canvas,
        Qt.Key.Key_Return,
        Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.ControlModifier,
    )
    wait_until(lambda: not window.stretch_accepting.running, "accepting the shot")
    for number in range(0, FRAMES // 2, 2):
        services.navigator.go_to(number)
        wait(2 * STEP_MS)
        film.add(STEP_MS)
    film.write("shot")
    window.close()


def main() -> None:
    PICTURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        QSettings.setDefaultFormat(QSettings.Format.IniFormat)
        app = application()
        for dark in (False, True):
            own = Path(folder) / ("dark" if dark else "light")
            own.mkdir()
            # Neither begins with what was chosen in the other.
            QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(own))
            wear(app, dark)
            take_all(own)


def take_all(folder: Path) -> None:
    """Every picture in the theme of the moment."""
    dataset = folder / "sample_data"
    others = shutil.ignore_patterns("basketball", "volleyball", "ice_hockey")
    shutil.copytree(ROOT / "sample_data", dataset, ignore=others)
    window = build_window(dataset)
    window.resize(*SIZE)
    window.show()
    wait(800)
    audit(window, dataset)
    annotate(window, dataset)
    review(window, dataset)
    window.close()
    copy(folder, dataset)
    disagree(folder)
    clicks(folder)
    other_sport(folder)
    without_a_click(folder)


if __name__ == "__main__":
    main()
