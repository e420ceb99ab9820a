"""The real window, on small datasets, with settings of its own."""

import gc
import json
import shutil
import time
import zlib
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QObject, QPoint, QPointF, QSettings, Qt, QTimer
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.assist.line_evidence import line_evidence
from procc_annotator.calibration.label_check.evidence import LineEvidence
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.proposal import Proposal
from procc_annotator.field.model import Field
from procc_annotator.gui.app import build_window, collect_now_and_then, start_lean
from procc_annotator.gui.commands import field_dimensions, view_grouping
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels import frame_rows, frames
from procc_annotator.gui.settings import Settings
from procc_annotator.gui.state import background, review_state, visible_update
from procc_annotator.gui.state.checking import label_check, runner
from procc_annotator.gui.state.checking.label_check import Evidence
from procc_annotator.gui.state.prediction import camera_choice, live_fit
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import PlainTextStyle
from procc_annotator.gui.window.key_dialogs import KeySheet
from tests.gui.known_already import hand_out
from tests.gui.one_window import OneWindow

SIZE = (640, 360)

# What is annotated of the twelve elements of the frame that has been begun.
KEPT = ("Big rect. left bottom", "Big rect. left main", "Big rect. left top", "Circle left")
KEPT = (*KEPT, "Goal left crossbar")

MakeWindow = Callable[..., MainWindow]


@pytest.fixture
def qtbot(qtbot, monkeypatch) -> QtBot:
    """What a test waits for may take its time on a machine that is busy with other things, and is
    seen soon after it is so."""
    for name in ("waitActive", "waitSignal"):
        monkeypatch.setattr(qtbot, name, partial(getattr(qtbot, name), timeout=_PATIENCE_MS))
    monkeypatch.setattr(qtbot, "waitUntil", partial(_wait_until, qtbot))
    return qtbot


_PATIENCE_MS = 60_000
_SELDOM_MS = 10  # between two looks at something that takes long


def _wait_until(
    qtbot: QtBot, there: Callable[[], bool | None], *, timeout: int = _PATIENCE_MS
) -> None:
    """As that of `QtBot`, which first looks again after 10 ms."""
    began, pause_ms = time.monotonic(), 1
    while True:
        try:
            if there() in (None, True):
                return
            said = None
        except AssertionError as error:
            said = error
        if time.monotonic() - began > timeout / 1000:
            raise TimeoutError(f"waitUntil timed out in {timeout} milliseconds") from said
        qtbot.wait(pause_ms)
        pause_ms = min(pause_ms + 1, _SELDOM_MS)


@pytest.fixture(scope="session", autouse=True)
def hurried(lean) -> Iterator[None]:
    """The window waits a tenth as long for a hand that may go on typing, walking or dragging."""
    with pytest.MonkeyPatch.context() as patch:
        for module, name in _WAITS_FOR_A_HAND:
            patch.setattr(module, name, getattr(module, name) // 10)
        yield


_WAITS_FOR_A_HAND = (
    (runner, "_DELAY_MS"),
    (field_dimensions, "_SETTLED_MS"),
    (frame_rows, "_SETTLED_MS"),
    (live_fit, "_STAYED_MS"),
    (label_check, "_STAYED_MS"),
    (frames, "_TYPED_MS"),
    (camera_choice, "_STAYED_MS"),
    (review_state, "_COLLECT_MS"),
    (frame_rows, "_SOON_MS"),
    (frame_rows, "_HAND_MS"),
    (visible_update, "_INTERVAL_MS"),
    (view_grouping, "_SETTLED_MS"),
)


@pytest.fixture(scope="session")
def settings_of_tests(tmp_path_factory) -> None:
    """Tests neither read nor change the settings of whoever runs them."""
    folder = str(tmp_path_factory.mktemp("settings"))
    for form in (QSettings.Format.IniFormat, QSettings.Format.NativeFormat):
        QSettings.setPath(form, QSettings.Scope.UserScope, folder)


@pytest.fixture(autouse=True)
def no_settings(settings_of_tests) -> None:
    """Every test begins without any."""
    store = Settings()._store
    if store.allKeys():  # or the file would be written anew before every test
        store.clear()


@pytest.fixture(scope="session", autouse=True)
def lean(qapp) -> None:
    """The style of the program; memory of pictures goes back to the system, and nobody looks for
    garbage in what was there before the tests."""
    qapp.setStyle(PlainTextStyle("Fusion"))
    start_lean()
    gc.collect()
    gc.freeze()


@pytest.fixture(autouse=True)
def little_garbage(qapp) -> Iterator[None]:
    """What a test leaves goes before the next one, on the interface's thread."""
    yield
    collect_now_and_then()


@pytest.fixture(autouse=True)
def no_button_held(qapp) -> Iterator[None]:
    """A button that a test leaves pressed is let go: what waits for the hand never ended else."""
    yield
    for button in (Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton):
        if QApplication.mouseButtons() & button:
            QTest.mouseRelease(QWidget(), button)


@pytest.fixture(autouse=True)
def nobody_asks(monkeypatch) -> None:
    """A window that is closed with unsaved work asks a question nobody would answer here."""
    monkeypatch.setattr("procc_annotator.gui.main_window.ask_to_leave_unsaved", lambda *_: True)


@pytest.fixture(autouse=True)
def nothing_proposed(monkeypatch) -> None:
    """No camera is found in a picture alone, unless a test is about that: what is annotated in a
    test comes from its clicks."""

    def none(picture: np.ndarray, *_: object, **__: object) -> Proposal:
        why = "this test is about something else"
        fit = FitResult("R", (picture.shape[1], picture.shape[0]), None, why)
        return Proposal("none", why, fit, 0.0, 0.0, None, 0.0, None)

    monkeypatch.setattr("procc_annotator.gui.state.prediction.camera_choice.propose_camera", none)


@pytest.fixture(autouse=True)
def worked_out_once(monkeypatch) -> None:
    """What goes on beside a window is the same in most tests, see `known_already`."""
    hand_out(monkeypatch)


@pytest.fixture(autouse=True)
def paint_looked_for_once(monkeypatch) -> None:
    """What a picture shows along a drawn element is looked for in the first test only that has the
    two, unless a test is about that: it is most of what goes on beside a window."""

    def evidence(
        annotation: FrameAnnotation,
        picture: np.ndarray,
        field: Field,
        known: Evidence | None = None,
        go_on: Callable[[], None] = lambda: None,
    ) -> dict[Polyline, LineEvidence]:
        of = (zlib.crc32(np.ascontiguousarray(picture)), picture.shape, id(field))
        _, seen = _SEEN.setdefault(of, (field, {}))
        found = line_evidence(annotation, picture, field, seen | dict(known or {}), go_on)
        seen.update(found)
        return found

    monkeypatch.setattr("procc_annotator.gui.state.checking.label_check.line_evidence", evidence)


_SEEN: dict[tuple[int, tuple[int, ...], int], tuple[Field, dict[Polyline, LineEvidence]]] = {}


@pytest.fixture(scope="session")
def striped() -> list[bytes]:
    """PNG of a striped pitch, with 0, 1 and 2 written on it."""
    stripes = np.zeros((SIZE[1], SIZE[0], 3), dtype=np.uint8)
    stripes[:, :, 1] = 90 + 20 * ((np.arange(SIZE[0]) // 40) % 2)
    found = []
    for i in range(3):
        picture = stripes.copy()
        cv2.putText(picture, str(i), (300, 200), cv2.FONT_HERSHEY_SIMPLEX, 3, (255, 255, 255), 4)
        found.append(cv2.imencode(".png", picture)[1].tobytes())
    return found


@pytest.fixture
def dataset(tmp_path, striped) -> Path:
    """Three pictures of a striped pitch; nothing is annotated."""
    folder = tmp_path / "dataset"
    folder.mkdir()
    for i, picture in enumerate(striped):
        (folder / f"frame_{i}.png").write_bytes(picture)
    return folder


@pytest.fixture(scope="session")
def one_window(qapp) -> Iterator[OneWindow]:
    """The window that the tests share."""
    shared = OneWindow()
    yield shared
    shared.end()


@pytest.fixture(autouse=True)
def new_window(request, one_window) -> bool:
    """Whether a test wants windows of its own; then there is no other."""
    wanted = request.node.get_closest_marker("new_window") is not None
    if wanted:
        one_window.end()
    return wanted


@pytest.fixture
def make_window(qtbot, one_window, new_window) -> Iterator[MakeWindow]:
    """Build and show windows, but lend the first one to tests that are not marked `new_window`; new
    ones are closed at the end."""
    windows: list[MainWindow] = []
    lending = not new_window

    def make(
        path: Path | None = None, *, size: tuple[int, int] = (1280, 720), **more: Any
    ) -> MainWindow:
        nonlocal lending
        if lending and path is not None and not more:
            window, lending = one_window.lend(path), False
        else:
            window = build_window(path, **more)
            windows.append(window)
            qtbot.addWidget(window)
        window.resize(*size)
        with qtbot.waitActive(window):  # keys reach an active window only
            window.show()
            window.activateWindow()
        window.canvas.setFocus()
        return window

    yield make
    for window in windows:
        window.services.close()
    windows.clear()
    # pytest-qt wants them deleted, which Qt does once events are handled again.
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)


@pytest.fixture
def window(make_window, dataset) -> MainWindow:
    """The window on the three pictures."""
    return make_window(dataset)


T = TypeVar("T", bound=QWidget)
OpenServices = Callable[..., Services]


@pytest.fixture
def open_services(qapp) -> Iterator[OpenServices]:
    """Open datasets, each as a window of its own does; all are closed at the end."""
    made: list[Services] = []

    def make(path: Path | None = None) -> Services:
        services = Services()
        made.append(services)
        assert path is None or services.opening.open_path(path)
        return services

    yield make
    for services in made:
        services.close()


@pytest.fixture
def services(open_services, dataset) -> Services:
    """The state on the three pictures."""
    return open_services(dataset)


@pytest.fixture
def said(services) -> list[str]:
    """The messages from now on, in order; the last one is shown."""
    return heard(services)


@pytest.fixture
def widget(qtbot) -> QWidget:
    """The parent of the dialogs that commands open."""
    parent = QWidget()
    qtbot.addWidget(parent)
    return parent


@pytest.fixture
def show(qtbot) -> Callable[[T], T]:
    """Show a panel or a bar by itself."""

    def shown(widget: T) -> T:
        qtbot.addWidget(widget)
        widget.resize(420, 480)
        with qtbot.waitActive(widget):  # or it would not have the keyboard
            widget.show()
            widget.activateWindow()
        return widget

    return shown


LINE = ((0.15, 0.3), (0.3, 0.6))


def draw(services: Services, name: str, *points: tuple[float, float]) -> bool:
    """Draw an element through points (u, v), as finished clicks do; True once it is saved, False if
    the frame cannot be edited."""
    drawn = Polyline(name, tuple(Point(u, v) for u, v in points or LINE))
    done = services.editing.edit(f"draw {name}", lambda seen: seen.with_polyline(drawn))
    services.saver.settle()
    return done


class Hand:
    """A person's mouse over the canvas: positions are in picture px."""

    def __init__(self, window: MainWindow) -> None:
        self.canvas = window.canvas
        self.services = window.services

    def at(self, x: float, y: float) -> QPoint:
        """The screen pixel that shows a picture position."""
        return self.canvas.to_view(x, y).toPoint()

    def picture(self, x: float, y: float) -> tuple[float, float]:
        """Where exactly a click meant for (x, y) lands, the screen having whole pixels."""
        return self.canvas.to_picture(QPointF(self.at(x, y)))

    def move(self, x: float, y: float) -> None:
        self._move(self.at(x, y), Qt.MouseButton.NoButton)

    def _move(self, at: QPoint, held: Qt.MouseButton) -> None:
        # QTest.mouseMove sets the one cursor of the platform, which other windows may lie under.
        viewport = self.canvas.viewport()
        event = QMouseEvent(
            QEvent.Type.MouseMove,
            QPointF(at),
            QPointF(viewport.mapToGlobal(at)),
            Qt.MouseButton.NoButton,
            held,
            Qt.KeyboardModifier.NoModifier,
        )
        QApplication.sendEvent(viewport, event)

    def click(
        self,
        x: float,
        y: float,
        modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier,
    ) -> tuple[float, float]:
        at = self.picture(x, y)
        viewport = self.canvas.viewport()
        QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, modifiers, self.at(x, y))
        return at

    def double_click(self, x: float, y: float) -> tuple[float, float]:
        """As Qt sends it: press, release, double-click, release."""
        at = self.click(x, y)
        viewport = self.canvas.viewport()
        QTest.mouseDClick(
            viewport, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, self.at(x, y)
        )
        return at

    def drag(
        self,
        start: tuple[float, float],
        end: tuple[float, float],
        button: Qt.MouseButton = Qt.MouseButton.LeftButton,
    ) -> None:
        viewport = self.canvas.viewport()
        none = Qt.KeyboardModifier.NoModifier
        first, last = self.at(*start), self.at(*end)
        QTest.mousePress(viewport, button, none, first)
        for step in (0.3, 0.6, 1.0):
            delta = last - first
            between = first + QPoint(round(delta.x() * step), round(delta.y() * step))
            self._move(between, button)
        QTest.mouseRelease(viewport, button, none, last)

    def draw(self, class_name: str, *points: tuple[float, float]) -> np.ndarray:
        """Choose an element, click its points, press Enter, see it saved; where the clicks were."""
        self.services.selection.select_class(class_name, continues=True)
        clicked = [self.click(*p) for p in points]
        self.key(Qt.Key.Key_Return)
        if self.canvas.editor.drawing:  # keys reach the active window only
            self.canvas.key("Enter")
        until_kept()
        return np.array(clicked)

    def key(
        self, key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier
    ) -> None:
        QTest.keyClick(self.canvas, key, modifiers)


@pytest.fixture
def hand(window) -> Hand:
    """A hand on the window's canvas."""
    return Hand(window)


@pytest.fixture
def hand_on() -> Callable[[MainWindow], Hand]:
    """Hands on windows that a test makes itself."""
    return Hand


ReadPoints = Callable[..., "np.ndarray"]


@pytest.fixture
def saved(dataset) -> ReadPoints:
    """The points of a class of a frame as they are on disk, in px."""

    def read(class_name: str = "Middle line", frame: int = 0) -> np.ndarray:
        until_kept()
        path = dataset / f"frame_{frame}.json"
        entries = json.loads(path.read_text()) if path.exists() else {}
        points = [(p["x"], p["y"]) for p in entries.get(class_name, [])]
        return np.array(points).reshape(-1, 2) * (SIZE[0] - 1, SIZE[1] - 1)

    return read


@pytest.fixture(scope="session")
def first_frames(sample_data) -> list[Path]:
    """The files of the sample's first frames and of their cameras, within its folder."""
    found = [*sample_data.glob("*0000[1-6].*"), *sample_data.glob("cameras/**/*0000[1-6].*")]
    return [path.relative_to(sample_data) for path in found]


@pytest.fixture
def annotated(sample_data, first_frames, tmp_path) -> Path:
    """The sample's first frames and their cameras, to be changed at will."""
    folder = tmp_path / "sample"
    for parent in {path.parent for path in first_frames}:
        (folder / parent).mkdir(parents=True, exist_ok=True)
    for path in first_frames:
        shutil.copyfile(sample_data / path, folder / path)
    return folder


@pytest.fixture
def begun(make_window, annotated, qtbot) -> MainWindow:
    """The window on a sample frame with five of twelve elements, its ghosts shown."""
    path = annotated / "00002.json"
    entries = json.loads(path.read_text())
    path.write_text(json.dumps({name: entries[name] for name in KEPT}))
    window = make_window(annotated)
    window.services.navigator.go_to(1)
    wait_for_ghosts(window, qtbot)
    return window


@pytest.fixture
def told(begun) -> list[str]:
    """What the window said, in order."""
    return heard(begun.services)


def heard(services) -> list[str]:
    """A list that every message text goes to from now on."""
    texts: list[str] = []
    services.store.events.message.connect(lambda m: texts.append(m.text))
    return texts


def wait_for_ghosts(window: MainWindow, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: window.services.live_fit.insight is not None)


def audit(services: Services, folder: Path, qtbot: QtBot) -> None:
    """Score the sample under three sources, the first one active; there is no live fit, which would
    be a fourth source."""
    services.live_fit.set_wanted(False)
    for name in ("true", "bad", "pinhole"):
        assert services.camera_sources.load_cameras(folder / "cameras" / name)
    services.camera_sources.set_active_camera(0)
    services.navigator.go_to(1)
    settle(services, qtbot)


@pytest.fixture
def audited(make_window, annotated, qtbot) -> MainWindow:
    """The window on the sample with three sources, all frames audited."""
    window = make_window(annotated)
    audit(window.services, annotated, qtbot)
    return window


@pytest.fixture
def scored(open_services, annotated, qtbot) -> Services:
    """The same without a window."""
    services = open_services(annotated)
    audit(services, annotated, qtbot)
    return services


def until_kept() -> None:
    """Wait until what was edited in any window is on disk, or it is said why not; nothing else
    happens meanwhile."""
    for window in QApplication.topLevelWidgets():
        if isinstance(window, MainWindow):
            window.services.saver.settle()


def let_work_end(qtbot: QtBot) -> None:
    """Wait until no work is under way in the background, wanted or not, and all is delivered."""
    qtbot.waitUntil(lambda: not background._dispatcher().jobs)


def settle(services: Services, qtbot: QtBot) -> None:
    """Wait until everything computed in the background has arrived."""
    qtbot.waitUntil(lambda: not services.scoring.waiting)
    qtbot.waitUntil(lambda: not services.scoring.running)
    qtbot.waitUntil(
        lambda: all(services.source_frames.of(s) is not None for s in services.state.sources)
    )


_SOON_MS = 1_000


def all_done(qtbot: QtBot) -> None:
    """Wait until nothing is due in any window: no update, no work in the background."""
    quiet, due = 0, ""

    def nothing_due() -> bool:
        nonlocal quiet, due
        due = "; ".join(map(_what, background._dispatcher().jobs.values()))
        if not due:  # or timers, which take longer to look through
            due = "; ".join(map(_whose, _timers_due()))
        quiet = 0 if due else quiet + 1
        return quiet == 3  # what has just been done may have asked for more

    try:
        qtbot.waitUntil(nothing_due)
    except TimeoutError as error:
        raise AssertionError(f"this does not end: {due}") from error


def _what(job: background.Job) -> str:
    state = "delivered" if job._delivered else "wanted" if job.running else "cancelled"
    work = "not begun" if job._future is None else str(job._future)
    # Not its text: the receiver may be a deleted object of a window before.
    receiver = getattr(job._on_result, "__qualname__", type(job._on_result).__name__)
    return f"{state} work for {receiver}, {work}"


def _whose(timer: QTimer) -> str:
    owners: list[QObject] = [timer]
    while (parent := owners[-1].parent()) is not None:
        owners.append(parent)
    names = " in ".join(o.objectName() or o.metaObject().className() for o in owners)
    return f"{names}, every {timer.interval()} ms"


def _timers_due() -> list[QTimer]:
    """Those that run out once, and soon."""
    windows = [w for w in QApplication.topLevelWidgets() if w.parent() is None]
    timers = [t for window in windows for t in window.findChildren(QTimer) if t.isActive()]
    return [t for t in timers if t.isSingleShot() and t.interval() <= _SOON_MS]


def sheet_text(sheet: KeySheet) -> str:
    """Return what the sheet of keys shows, a row per line."""
    return "\n".join(f"{row.keys}\t{row.title}" for row in sheet.table.shown())
