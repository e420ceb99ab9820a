"""Pictures and positions on the field from above."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.base import ElementProjections
from procc_annotator.errors import ImageError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.figures.overlay import (
    figure_file,
    figure_pixels,
    figure_style,
    pixel_figure,
    polylines_patch,
)
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.top_view import GroundRaster, panorama, picture_on_ground
from procc_annotator.report.overlay_scene import GROUND_BGRA, Rendered, Scene, pixels_of

SUFFIXES = (".png", ".jpg", ".svg", ".pdf")  # of one picture of many frames
PX_PER_M = 10.0
_LINE_SPACING_M = 0.25
_LINE, _POSITION, _RIM = "#FFFFFF", "#E69F00", "#202020"
_MOST_VIEWS = 25  # of a panorama: the median of more shows no more


class TopViewPainter:
    """Draws scenes from above; an `OverlayPainter`.

    Args:
        suffix: ``.png``, ``.jpg`` or ``.svg``.
        scale: of 10 px per metre.
        positions: frame name -> (N, 2) metres on the ground.
    """

    def __init__(
        self, suffix: str, scale: float = 1.0, positions: Mapping[str, FloatArray] | None = None
    ) -> None:
        self._suffix, self._px_per_m = suffix, PX_PER_M * scale
        self._positions = {} if positions is None else positions

    def __call__(self, scene: Scene) -> bytes:
        view = self._view(scene)
        with figure_style():
            return figure_file(self._figure(scene, view, scene.title), self._suffix)

    def pixels(self, scene: Scene) -> PixelArray:
        """(H, W, 4) BGRA; without a camera the field alone."""
        view = self._view(scene)
        with figure_style():
            return figure_pixels(self._figure(scene, view, scene.title))

    def panorama(self, scenes: Iterable[Scene], count: int, rendered: Rendered) -> bytes | None:
        """One picture of all ``count`` scenes of one field, the median of up to 25 of them; None if
        none has a camera. ``rendered`` gets the scenes that cannot be used."""
        views, used = [], None
        every = max(1, -(-count // _MOST_VIEWS))
        for at, scene in enumerate(scenes):
            if scene.camera is None or at % every:
                continue
            try:
                views.append(self._resampled(scene))
            except ImageError as error:
                rendered.problems.append(str(error))
            else:
                used = used or scene
        if used is None:
            return None
        with figure_style():
            return figure_file(self._figure(used, panorama(views), ""), self._suffix)

    def _raster(self, field: Field) -> GroundRaster:
        return GroundRaster.of(field, self._px_per_m)

    def _resampled(self, scene: Scene) -> tuple[PixelArray, NDArray[np.bool_]]:
        assert scene.camera is not None
        if isinstance(scene.camera, ElementProjections):
            raise UsageError(
                f"{scene.source}: holds where the elements are shown, no cameras: pictures cannot"
                " be laid on the ground by them"
            )
        raster = self._raster(scene.setup.field)
        return picture_on_ground(pixels_of(scene), scene.camera, scene.setup.size, raster)

    def _view(self, scene: Scene) -> PixelArray:
        if scene.camera is not None:
            return self._resampled(scene)[0]
        width, height = self._raster(scene.setup.field).size
        return np.full((height, width, 3), GROUND_BGRA[:3], np.uint8)

    def _figure(self, scene: Scene, view: PixelArray, frame: str) -> Any:
        raster, field = self._raster(scene.setup.field), scene.setup.field
        width, height = raster.size
        figure = pixel_figure(width, height)
        axes: Any = figure.add_axes((0, 0, 1, 1))
        left, right, bottom, top = raster.extent
        axes.set_axis_off()
        axes.imshow(view[:, :, ::-1], extent=raster.extent, interpolation="nearest")
        axes.set(xlim=(left, right), ylim=(bottom, top))
        samples = sample_evenly(field, _LINE_SPACING_M)
        lines = [samples.of(i)[:, :2] for i, e in enumerate(field.elements) if e.on_ground]
        axes.add_patch(polylines_patch(lines, color=_LINE, linewidth=0.8, alpha=0.7))
        found = self._positions.values() if not frame else [self._positions.get(frame)]
        shown = [points for points in found if points is not None]
        if shown:
            axes.scatter(
                *np.concatenate(shown).T, s=4 * self._px_per_m, c=_POSITION, edgecolors=_RIM,
                linewidths=0.8, zorder=3,
            )  # fmt: skip
        return figure
