"""The program tries itself: its window opens, one element is annotated, saved and read back.

It works on a copy of one picture in a folder of its own, with settings of its own: nothing that
the user has is read but that picture, and nothing is changed.
"""

from __future__ import annotations

import shutil
import tempfile
import time
from pathlib import Path

import cv2
import numpy as np
from PySide6.QtCore import QSettings, qVersion
from PySide6.QtWidgets import QApplication

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.dataset.frames import list_frames
from procc_annotator.dataset.layout import FIELD_FILE, has_pictures
from procc_annotator.errors import InputError, ProccError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.gui.app import application, build_window, start_lean
from procc_annotator.gui.commands.opening import sample_folder
from procc_annotator.gui.main_window import MainWindow

_WAIT_S = 30
_ENDS = ((0.3, 0.4), (0.7, 0.6))  # of the line, in widths and heights of the picture
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
            shown = _annotate(app, window, folder / f"{Path(picture).stem}.json")
        finally:
            window.close()
            app.processEvents()
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
        first, last = ((round(u * width), round(v * height)) for u, v in _ENDS)
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


def _annotate(app: QApplication, window: MainWindow, file: Path) -> str:
    """Annotate the field's first straight element and read it back; return its name."""
    services = window.services
    window.resize(1280, 720)
    window.show()
    until = time.monotonic() + _WAIT_S
    while services.navigator.picture is None:
        if time.monotonic() > until:
            raise SelftestError(f"selftest failed: the picture was not shown within {_WAIT_S} s")
        app.processEvents()
        time.sleep(0.01)
    field = services.state.field
    element = next(e for e in field.elements if e.is_straight and not e.optional)
    line = Polyline(element.name, tuple(Point(u, v) for u, v in _ENDS))
    services.editing.commit_edit("drawn", FrameAnnotation((line,)))
    services.editing.save_now()
    found = read_annotation(file.read_bytes(), path=str(file), field=field).get(element.name)
    if found is None or [(p.u, p.v) for p in found.points] != list(_ENDS):
        raise SelftestError(f"selftest failed: {line} was drawn, the file holds {found}")
    return element.name
