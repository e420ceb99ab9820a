"""Painters of pictures: Qt, as in the window; where its libraries are missing, a plainer
painter."""

from __future__ import annotations

import ctypes
from functools import cache
from pathlib import Path

import cv2
import numpy as np

from procc_annotator.cli.echo import echo
from procc_annotator.errors import SaveError
from procc_annotator.interaction.overlay import OverlayBuilder, OverlayContent
from procc_annotator.interaction.overlay_figure import draw_overlay
from procc_annotator.report.comparison import Paint as PaintPair
from procc_annotator.report.overlay_scene import (
    OverlayLook,
    Paint,
    Scene,
    caption,
    check_overlay_suffix,
    check_pixels,
    pixels_of,
)


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


def overlay_painter(suffix: str, look: OverlayLook | None = None) -> Paint:
    """Paints overlays as ``.png``, ``.jpg`` or ``.svg``; says once on stderr if it is without Qt.

    Raises:
        UsageError: another suffix.
    """
    if _can_paint("pictures are drawn plainer, without a legend"):
        from procc_annotator.gui.canvas.overlay_picture import OverlayPictures

        return OverlayPictures(suffix, look)
    check_overlay_suffix(suffix)
    return _PlainPictures(suffix, look if look is not None else OverlayLook())


def pair_painter(suffix: str = ".png") -> PaintPair | None:
    """Paints where two cameras disagree; None, said on stderr, without Qt."""
    if not _can_paint("pictures of disagreement are left out"):
        return None
    from procc_annotator.gui.canvas.comparison_picture import ComparisonPictures

    return ComparisonPictures(suffix)


@cache
def _can_paint(otherwise: str) -> bool:
    if why := missing_qt():
        echo(f"note: Qt cannot be loaded here ({why}): {otherwise}", err=True)
    return not why


class _PlainPictures:
    """Called with a scene, gives the encoded picture."""

    def __init__(self, suffix: str, look: OverlayLook) -> None:
        self._suffix, self._look = suffix, look

    def __call__(self, scene: Scene) -> bytes:
        pixels = pixels_of(scene)
        height, width = pixels.shape[:2]
        scale, unit = self._look.scale_and_unit(width)
        size = max(1, round(width * scale)), max(1, round(height * scale))
        check_pixels(*size)
        if scale != 1:
            method = cv2.INTER_AREA if scale < 1 else cv2.INTER_CUBIC
            pixels = np.asarray(cv2.resize(pixels, size, interpolation=method), np.uint8)
        shown = OverlayContent(
            annotation=scene.annotation,
            size=scene.setup.size,
            field=scene.setup.field,
            measurement=scene.measurement,
            score=scene.score,
            picture_size=(width, height),
            paint=scene.paint,
        )
        words = caption(scene) if self._look.caption else ""
        is_svg = self._suffix == ".svg"
        drawn = draw_overlay(
            pixels, OverlayBuilder().build(shown), scale=scale, unit=unit, caption=words, svg=is_svg
        )
        if isinstance(drawn, bytes):
            return drawn
        done, encoded = cv2.imencode(self._suffix, drawn[:, :, :3])
        if not done:
            raise SaveError(f"{scene.title}: the overlay cannot be encoded as {self._suffix}")
        return encoded.tobytes()
