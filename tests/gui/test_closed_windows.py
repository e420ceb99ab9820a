"""Nothing of a window is left once it is closed."""

import gc
import os
import threading
import weakref
from collections import Counter
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QObject
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from procc_annotator.gui.app import build_window
from procc_annotator.gui.state import background
from procc_annotator.gui.window.workspaces import WORKSPACES
from tests.gui.conftest import all_done, let_work_end


def open_and_close(qtbot: QtBot, path: Path) -> list[weakref.ref[QObject]]:
    """What there is to be gone: a window and its services, after a look at every panel."""
    window = build_window(path)
    window.resize(1280, 720)
    window.show()
    QApplication.processEvents()
    assert window.services.camera_sources.load_cameras(path / "cameras" / "true")
    window.services.camera_sources.set_active_camera(0)
    window.services.navigator.go_to(1)
    for desk in WORKSPACES:
        window.panels.turn_to(desk)
        QApplication.processEvents()
    window.panels.show("plots")
    all_done(qtbot)
    assert not window.plots.page.is_empty
    left: list[weakref.ref[QObject]] = [weakref.ref(window), weakref.ref(window.services)]
    window.close()
    window.deleteLater()
    del window
    let_work_end(qtbot)
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
    return left


def alive() -> Counter[str]:
    """Qt's objects by their class, as Python knows them."""
    gc.collect()
    return Counter(type(one).__name__ for one in gc.get_objects() if isinstance(one, QObject))


def threads() -> list[str]:
    """Those of windows; the desk's, as many as there is work for, are everybody's."""
    names = (thread.name for thread in threading.enumerate())
    return sorted(name for name in names if not name.startswith(("urgent", "low", "immediate")))


def open_files() -> int:
    return len(os.listdir("/proc/self/fd")) if os.path.isdir("/proc/self/fd") else 0


@pytest.mark.new_window
@pytest.mark.parametrize("windows", [6, pytest.param(20, marks=pytest.mark.soak)])
def test_windows_leave_nothing_behind(qtbot, annotated, windows):
    open_and_close(qtbot, annotated)  # what is made once and kept (threads, icons) is there then
    before, files, running = alive(), open_files(), threads()
    left = [ref for _ in range(windows) for ref in open_and_close(qtbot, annotated)]
    after = alive()
    assert not [ref() for ref in left if ref() is not None]
    assert {name: n for name, n in after.items() if n > before[name]} == {}
    assert threads() == running
    assert open_files() <= files
    assert not background._dispatcher().jobs
