"""Painters of pictures: Qt, as in the window; where its libraries are missing, a plainer
painter."""

from __future__ import annotations

import ctypes
from functools import cache
from pathlib import Path

from procc_annotator.cli.echo import echo
from procc_annotator.figures.overlay import PlainPictures
from procc_annotator.report.overlay_scene import OverlayLook, OverlayPainter, check_overlay_suffix


@cache
def missing_qt() -> str:
    """Why Qt cannot paint here; empty where it can.

    Its platform plugin is examined as well: Qt ends the whole program where that cannot be loaded.
    """
    try:
        from PySide6 import QtSvg, QtWidgets  # noqa: F401
        from PySide6.QtCore import QLibraryInfo

        plugins = Path(QLibraryInfo.path(QLibraryInfo.LibraryPath.PluginsPath))
        for plugin in (plugins / "platforms").glob("libqoffscreen.so"):
            ctypes.CDLL(str(plugin))
    except (ImportError, OSError) as error:
        return str(error)
    return ""


def overlay_painter(suffix: str, look: OverlayLook | None = None) -> OverlayPainter:
    """Paints overlays as ``.png``, ``.jpg`` or ``.svg`` (UsageError for another suffix); says once
    on stderr if it is without Qt."""
    if _can_paint():
        from procc_annotator.gui.canvas.overlay_picture import OverlayPictures

        return OverlayPictures(suffix, look)
    check_overlay_suffix(suffix)
    return PlainPictures(suffix, look if look is not None else OverlayLook())


@cache
def _can_paint() -> bool:
    if why := missing_qt():
        plainer = "pictures are drawn plainer, without a legend"
        echo(f"note: Qt cannot be loaded here ({why}): {plainer}", err=True)
    return not why
