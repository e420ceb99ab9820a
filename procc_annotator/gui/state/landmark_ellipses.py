"""How surely the frame on screen shows the dataset's landmarks."""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

import numpy as np

from procc_annotator.calibration.prediction.uncertainty import project_error_ellipses
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.base import (
    CameraOrProjections,
    ElementProjections,
    projects_only_ground,
    scaled_camera,
)
from procc_annotator.field.geometry import Vector
from procc_annotator.field.landmarks import landmark_at_instant, landmarks_by_name
from procc_annotator.field.model import Field, Landmark
from procc_annotator.formats.landmark_file import LandmarkFile
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.gui.state.judge import Judge
from procc_annotator.gui.state.live_fit import LiveFit
from procc_annotator.gui.state.store import Store
from procc_annotator.interaction.overlay_lines import ShownEllipse

Size = tuple[int, int]
Ellipses = tuple[ShownEllipse, ...]
FileAndInstant = tuple[LandmarkFile, str | None]  # of a dataset, and of the frame on screen


class LandmarkEllipses(Derived[Ellipses]):
    """One for each landmark of the frame on screen whose place has a covariance, by the camera that
    is judged, else by the fit."""

    def __init__(
        self, store: Store, live_fit: LiveFit, judge: Judge, here: Callable[[], FileAndInstant]
    ) -> None:
        super().__init__(
            self._made_of, _project, Where.ONCE_A_REPAINT, store, after=(live_fit.changed,)
        )
        self._store, self._live_fit, self._judge = store, live_fit, judge
        self._here = here

    def _made_of(self) -> Inputs | None:
        state, (file, instant) = self._store.state, self._here()
        size = state.picture_size
        if size is None or not file.landmarks or not state.projection_visible:
            return None
        field, camera = self._judge.frame_setup.field, self._judge.camera
        if camera is not None:
            return file, instant, field, size, camera, state.setup.size
        fit = self._live_fit.result
        return None if fit is None else (file, instant, field, size, fit, fit.size)


def entries_of(file: LandmarkFile, instant: str | None) -> list[Landmark]:
    """One a landmark of a dataset, as it is at an instant."""
    return [
        landmark_at_instant(marks, instant) or marks[0]
        for marks in landmarks_by_name(file.landmarks).values()
    ]


def _project(
    file: LandmarkFile,
    instant: str | None,
    field: Field,
    size: Size,
    judged: CameraOrProjections | FitResult,
    judged_size: Size,
) -> Ellipses:
    entries = entries_of(file, instant)
    marks = [m for m in entries if m.position is not None and m.covariance is not None]
    positions = [cast(Vector, mark.position) for mark in marks]
    camera: CameraOrProjections | None = None
    spread = None
    if not isinstance(judged, FitResult):
        camera = scaled_camera(judged, judged_size, size)
    elif judged_size == size and marks:
        camera, spread = judged.camera, judged.projected_covariance(np.array(positions))
    if not marks or camera is None or isinstance(camera, ElementProjections):
        return ()
    if projects_only_ground(camera):
        return ()
    covariances = [mark.covariance for mark in marks]
    found = project_error_ellipses(camera, positions, covariances, camera_covariances=spread)
    elements = {e.name: e.colour for e in field.elements}
    return tuple(
        ShownEllipse(mark.name, elements[mark.name], ellipse)
        for mark, ellipse in zip(marks, found, strict=True)
        if ellipse is not None and mark.name in elements
    )
