"""How surely the frame on screen shows the dataset's landmarks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, cast

import numpy as np

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.camera.projections import ElementProjections
from procc_annotator.camera.scaling import scaled
from procc_annotator.field.geometry import Vector
from procc_annotator.field.landmarks import Landmark
from procc_annotator.fit.projected_ellipse import projected_ellipses
from procc_annotator.interact.overlay_lines import ShownEllipse

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document


class LandmarkEllipses:
    """Ellipses by the active source, else by the fit, kept as long as nothing changed."""

    def __init__(self, document: Document, entries: Callable[[], Sequence[Landmark]]) -> None:
        self._document = document
        self._entries = entries
        self._made_of: tuple[object, ...] = ()  # compared by identity
        self._terms: tuple[object, ...] = ()  # compared by value
        self._shown: tuple[ShownEllipse, ...] = ()

    def shown(self) -> tuple[ShownEllipse, ...]:
        """One for each landmark of the frame on screen whose place has a covariance; the same
        object as long as nothing changed."""
        document = self._document
        made_of = document.judge.camera, document.live_fit.result, document.frame_field
        terms = document.setup.size, document.picture_size, document.projection_visible
        same = len(self._made_of) == len(made_of) and all(
            map(lambda a, b: a is b, made_of, self._made_of)
        )
        if not same or terms != self._terms:
            self._made_of, self._terms, self._shown = made_of, terms, self._project()
        return self._shown

    def _project(self) -> tuple[ShownEllipse, ...]:
        document, size = self._document, self._document.picture_size
        marks = [m for m in self._entries() if m.position is not None and m.covariance is not None]
        if size is None or not marks or not document.projection_visible:
            return ()
        positions = [cast(Vector, mark.position) for mark in marks]
        camera, own = document.judge.camera, None
        if camera is not None:
            camera = scaled(camera, document.setup.size, size)
        elif (fit := document.live_fit.result) is not None and fit.size == size:
            camera, own = fit.camera, fit
        if camera is None or isinstance(camera, ElementProjections) or projects_only_ground(camera):
            return ()
        spread = None if own is None else own.projected_covariance(np.array(positions))
        found = projected_ellipses(
            camera,
            positions,
            [m.covariance for m in marks],
            camera_covariances=spread,
        )
        elements = {e.name: e.colour for e in document.frame_field.elements}
        return tuple(
            ShownEllipse(mark.name, elements[mark.name], ellipse)
            for mark, ellipse in zip(marks, found, strict=True)
            if ellipse is not None and mark.name in elements
        )
