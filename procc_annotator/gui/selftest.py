"""The program tries itself: the window opens, one element is annotated by mouse and keys, saved and
read back, and the window closes.

It works on a copy of one picture in a folder of its own, with settings of its own: nothing that
the user has is read but that picture, and nothing is changed.
"""

from __future__ import annotations

import json
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
from PySide6.QtCore import QPoint, QSettings, Qt, qVersion
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from procc_annotator.dataset.frames import list_frames
from procc_annotator.dataset.layout import FIELD_FILE, has_pictures
from procc_annotator.errors import InputError, ProccError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.gui.app import application, build_window, start_lean
from procc_annotator.gui.commands.files.opening import sample_folder
from procc_annotator.gui.main_window import MainWindow

_WAIT_MS = 30_000
# The clicks, in widths and heights of the picture; and how far a whole screen pixel may put them.
_CLICKS = ((0.3, 0.4), (0.7, 0.6))
_OFF = 0.02
_SIZE = (960, 540)


class SelftestError(ProccError):
    """A step of the self-test did not do what it should."""


def run_selftest(path: Path | None = None, field: Field | None = None) -> str:
    """Open the window, annotate, save, read back, close.

    Args:
        path: a folder of pictures, or a picture: one is copied. None: one of the sample, or one
            that is drawn where there is no sample.
        field: what it shows, if that is not given by its folder.

    Returns:
        What was done, in one line.

    Raises:
        SelftestError: which step failed, and how.
        UsageError: there is no picture at the path.
        SaveError: the temporary folder cannot be written.
    """
    start_lean()
    with tempfile.TemporaryDirectory(prefix="procc_selftest_", ignore_cleanup_errors=True) as made:
        folder = Path(made) / "dataset"
        folder.mkdir()
        for form in (QSettings.Format.IniFormat, QSettings.Format.NativeFormat):
            QSettings.setPath(form, QSettings.Scope.UserScope, str(Path(made) / "settings"))
        picture = _copied(path or sample_folder(), folder)
        app = application()
        window = build_window(folder, field=field)
        try:
            shown = _annotate(window, folder / f"{Path(picture).stem}.json")
        finally:
            window.close()
            app.processEvents()
        _require(not window.isVisible(), "the window did not close")
        return (
            f"selftest passed: Qt {qVersion()} on {app.platformName()}, {shown} annotated in a copy"
            f" of {picture}, saved and read back"
        )


def _copied(path: Path | None, folder: Path) -> str:
    """Put one picture into a folder; its name."""
    if path is None:
        name = "drawn.png"
        width, height = _SIZE
        picture = np.full((height, width, 3), (60, 130, 60), dtype=np.uint8)
        first, last = ((round(u * width), round(v * height)) for u, v in _CLICKS)
        cv2.line(picture, first, last, (235, 235, 235), 4, cv2.LINE_AA)
        write_atomic(folder / name, cv2.imencode(".png", picture)[1].tobytes())
        return name
    if path.is_dir() and not has_pictures(path):
        raise UsageError(f"nothing to do: no picture in {path}")
    root, frames, _ = list_frames(path)
    for file in (frames[0].image_folder / frames[0].image_file, root / FIELD_FILE):
        if file.is_file():
            try:
                shutil.copyfile(file, folder / file.name)
            except OSError as error:
                raise InputError(file, f"cannot be read: {error.strerror or error}") from error
    return frames[0].image_file


def _annotate(window: MainWindow, file: Path) -> str:
    """Annotate the field's first straight element with the mouse; its name."""
    document, canvas = window.document, window.canvas
    window.resize(1280, 720)
    window.show()
    window.activateWindow()
    _wait(lambda: window.isActiveWindow() and canvas.isVisible(), "the window did not appear")
    _wait(lambda: document.walk.picture is not None, "the picture was not shown")
    document.selecting.set_option(
        "snapping", False
    )  # the clicks are to be found again where they were made
    element = next(e for e in document.state.field.elements if e.is_straight and not e.optional)
    document.selecting.select_class(element.name)
    canvas.setFocus()
    picture = document.walk.picture
    assert picture is not None
    height, width = picture.shape[:2]
    for u, v in _CLICKS:
        at: QPoint = canvas.to_view(u * (width - 1), v * (height - 1)).toPoint()
        QTest.mouseClick(
            canvas.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, at
        )
    QTest.keyClick(canvas, Qt.Key.Key_Return)
    _wait(file.exists, "nothing was saved")
    document.saver.settle()
    _check_saved(file, element.name, document.state.field)
    return element.name


def _check_saved(file: Path, class_name: str, field: Field) -> None:
    annotation = read_annotation(file.read_bytes(), path=str(file), field=field)
    found = annotation.get(class_name)
    points = [(p.u, p.v) for p in found.points] if found is not None else []
    near = len(points) == len(_CLICKS) and np.allclose(points, _CLICKS, atol=_OFF)
    _require(near, f"clicked {json.dumps(_CLICKS)}, the file holds {json.dumps(points)}")


def _wait(condition: Callable[[], bool], otherwise: str) -> None:
    for _ in range(_WAIT_MS // 20):
        if condition():
            return
        QTest.qWait(20)
        QApplication.processEvents()
    _require(condition(), f"{otherwise} within {_WAIT_MS // 1000} s")


def _require(holds: bool, otherwise: str) -> None:
    if not holds:
        raise SelftestError(f"selftest failed: {otherwise}")
