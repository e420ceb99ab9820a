"""Start the program."""

from __future__ import annotations

import ctypes
import gc
import signal
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from PySide6.QtCore import QEvent, QObject, QSize, Qt, QTimer
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QApplication, QWidget

from procc_annotator.field.model import Field
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import APPLICATION, LANGUAGE, ORGANISATION, Settings, take_up
from procc_annotator.gui.state.background import hold, release
from procc_annotator.gui.theme import follow_system
from procc_annotator.resources import resources_dir

_M_ARENA_MAX, _M_MMAP_THRESHOLD = -8, -3  # of malloc.h
_LARGE_BYTES = 2**20
_NEW_OBJECTS = 20_000  # before garbage is looked for among them
_LOOK_MS = 1000
_PARTS_A_WHOLE = 10  # looks among new objects for one through all


def application() -> QApplication:
    """The application object, made once."""
    existing = QApplication.instance()
    if isinstance(existing, QApplication):
        return existing
    made = QApplication(sys.argv[:1])
    made.setOrganizationName(ORGANISATION)
    made.setApplicationName(APPLICATION)
    made.setApplicationDisplayName("ProCC Annotator")  # not shown
    made.setDesktopFileName("org.procc.Annotator")
    made.setWindowIcon(_icon())
    follow_system(made)
    return made


def _icon() -> QIcon:
    """The program's icon; Qt reads the size it wants when it wants it."""
    icon = QIcon()
    for file in (resources_dir() / "desktop" / "icons").glob("*.png"):
        size = int(file.stem)
        icon.addFile(str(file), QSize(size, size))
    return icon


@dataclass(frozen=True, slots=True)
class CameraChoice:
    """Cameras to be loaded at once; without a name they are called like their folder."""

    path: Path
    format: str = "auto"
    name: str | None = None


def build_window(
    path: Path | None = None,
    *,
    annotations: Path | None = None,
    cameras: Path | Sequence[CameraChoice] = (),
    field: Field | None = None,
) -> MainWindow:
    """The window, not shown yet; a path that cannot be opened is reported in the window.

    Of several sources of cameras the first one is judged. A field that is given is the dataset's
    from now on.
    """
    window = MainWindow()
    services = window.services
    if path is not None:
        window.opening.open_path(path, annotations, field)
    elif field is not None:
        services.field_choice.take(field)
    choices = [CameraChoice(cameras)] if isinstance(cameras, Path) else cameras
    loaded = [services.camera_sources.load_cameras(c.path, c.format, c.name) for c in choices]
    if any(loaded):
        services.camera_sources.set_active_camera(0)
    return window


def main(
    path: Path | None = None,
    *,
    annotations: Path | None = None,
    cameras: Sequence[CameraChoice] = (),
    field: Field | None = None,
) -> int:
    """Show the window and run until it is closed; returns the exit code."""
    start_lean()
    app = application()
    take_up(app, Settings().get(LANGUAGE))  # before anything is made that says something
    hold()
    window = build_window(path, annotations=annotations, cameras=cameras, field=field)
    window.error_reports.install()
    window.installEventFilter(_FirstPaint(partial(go_to_work, app), window))
    return show_until_closed(app, window)


class _FirstPaint(QObject):
    """Calls back once a window was painted for the first time."""

    def __init__(self, then: Callable[[], object], window: QWidget) -> None:
        super().__init__(window)
        self._then = then

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Paint:  # its children are painted with it
            watched.removeEventFilter(self)
            QTimer.singleShot(0, self._then)
        return False


def start_lean() -> None:
    """Look for no garbage while the window is made, since nothing of it goes again, and have glibc
    give the memory of pictures back to the system as soon as they go."""
    gc.disable()
    with suppress(OSError, AttributeError, TypeError):  # another C library
        libc = ctypes.CDLL(None)
        libc.mallopt(_M_ARENA_MAX, 2)
        libc.mallopt(_M_MMAP_THRESHOLD, _LARGE_BYTES)


def go_to_work(app: QApplication) -> None:
    """The window was painted: begin what waited for that."""
    release()
    collect_between_gestures(app)


def collect_between_gestures(app: QApplication) -> None:
    """From here on look for garbage among new objects only, less often, and never during a gesture:
    looking through all that a window is made of takes several frames of a screen.

    Python by itself would look in whichever thread makes the next object; what Qt owns and goes
    there, such as a watched file, leaves the interface thread asking for it without end.
    """
    gc.freeze()
    timer = QTimer(app, interval=_LOOK_MS)
    timer.timeout.connect(collect_now_and_then)
    timer.start()


def collect_now_and_then() -> None:
    """Look for garbage if there may be much and no mouse button is held."""
    new, _, parts = gc.get_count()
    if new >= _NEW_OBJECTS and QApplication.mouseButtons() == Qt.MouseButton.NoButton:
        gc.collect(2 if parts >= _PARTS_A_WHOLE else 1)


def show_until_closed(app: QApplication, window: QWidget) -> int:
    """Show a window until it is closed, or Ctrl+C is pressed in the terminal; the exit code."""
    window.show()
    signal.signal(signal.SIGINT, lambda *_: window.close())
    wake = QTimer()  # lets Python see Ctrl+C in the terminal while Qt waits
    wake.timeout.connect(lambda: None)
    wake.start(500)
    return app.exec()
