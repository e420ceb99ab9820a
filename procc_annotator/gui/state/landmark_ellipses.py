"""How surely the frame on screen shows the dataset's landmarks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import cast

import numpy as np

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.camera.projections import ElementProjections
from procc_annotator.camera.scaling import scaled
from procc_annotator.field.geometry import Vector
from procc_annotator.field.model import Landmark
from procc_annotator.fit.projected_ellipse import projected_ellipses
from procc_annotator.gui.state.judge import Judge
from procc_annotator.gui.state.live_fit import LiveFit
from procc_annotator.gui.state.store import Store
from procc_annotator.interact.overlay_landmarks import ShownEllipse


class LandmarkEllipses:
    """Ellipses by the active source, else by the fit, kept as long as nothing changed."""

    def __init__(
        self,
        store: Store,
        judge: Judge,
        live_fit: LiveFit,
        entries: Callable[[], Sequence[Landmark]],
    ) -> None:
        self._store, self._judge, self._live_fit = store, judge, live_fit
        self._entries = entries
        self._made_of: tuple[object, ...] = ()  # compared by identity
        self._terms: tuple[object, ...] = ()  # compared by value
        self._shown: tuple[ShownEllipse, ...] = ()

    def shown(self) -> tuple[ShownEllipse, ...]:
        """One for each landmark of the frame on screen whose place has a covariance; the same
        object as long as nothing changed."""
        state = self._store.state
        made_of = self._judge.camera, self._live_fit.result, self._judge.frame_setup.field
        terms = state.setup.size, state.picture_size, state.projection_visible
        same = len(self._made_of) == len(made_of) and all(
            map(lambda a, b: a is b, made_of, self._made_of)
        )
        if not same or terms != self._terms:
            self._made_of, self._terms, self._shown = made_of, terms, self._project()
        return self._shown

    def _project(self) -> tuple[ShownEllipse, ...]:
        state, size = self._store.state, self._store.state.picture_size
        marks = [m for m in self._entries() if m.position is not None and m.covariance is not None]
        if size is None or not marks or not state.projection_visible:
            return ()
        positions = [cast(Vector, mark.position) for mark in marks]
        camera, own = self._judge.camera, None
        if camera is not None:
            camera = scaled(camera, state.setup.size, size)
        elif (fit := self._live_fit.result) is not None and fit.size == size:
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
        elements = {e.name: e.colour for e in self._judge.frame_setup.field.elements}
        return tuple(
            ShownEllipse(mark.name, elements[mark.name], ellipse)
            for mark, ellipse in zip(marks, found, strict=True)
            if ellipse is not None and mark.name in elements
        )
