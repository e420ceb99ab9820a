"""Clicked views with their cameras: of a camera set, or fitted to the annotation of each frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from dataclasses import field as dataclass_field
from typing import Protocol

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.camera.projections import ElementProjections
from procc_annotator.errors import CameraError
from procc_annotator.field.landmarks import is_moving, with_landmarks
from procc_annotator.field.model import Field, Landmark
from procc_annotator.field.stadiums import field_for_frame
from procc_annotator.fit.determined import ill_conditioned_reason
from procc_annotator.fit.fitting import fit_camera
from procc_annotator.fit.place_agreement import compare_with_survey
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.triangulation import (
    CameraCovariance,
    Triangulation,
    ClickedView,
    triangulate,
    default_click_sd_px,
)
from procc_annotator.language import translatable
from procc_annotator.session.dataset.camera_set import FrameCameras
from procc_annotator.session.landmarks.landmark_clicks import (
    Click,
    ClickedLandmark,
    LocatedLandmark,
)

Size = tuple[int, int]


@dataclass(frozen=True, eq=False)
class FrameView:
    """A frame's camera, px of ``size``; how surely it knows where it shows places, if it knows."""

    camera: Camera
    size: Size
    covariance: CameraCovariance | None = None


class ViewCameras(Protocol):
    """Where the cameras of clicked frames come from."""

    def of(self, frame: str) -> FrameView | str:
        """A frame's camera, or why there is none."""


@dataclass(frozen=True)
class ViewsOfSet:
    """Cameras of a set, which are taken as they are.

    Attributes:
        cameras: of the set.
        size_of: frame -> (width, height) px to work in.
    """

    cameras: FrameCameras
    size_of: Callable[[str], Size]

    def of(self, frame: str) -> FrameView | str:
        size = self.size_of(frame)
        try:
            found = self.cameras.camera(frame, size)
        except CameraError as error:
            return str(error)
        if found is None:
            return self.cameras.why_none(frame)
        if isinstance(found.camera, ElementProjections):
            return f"{self.cameras.name} shares projections alone, no camera"
        return FrameView(found.camera, size)


@dataclass
class FittedViews:
    """Cameras fitted to the annotations, with their uncertainty.

    Triangulated landmarks take no part in the fits: a place must not be what tells the camera that
    tells the place.

    Attributes:
        field: with the dataset's landmarks.
        annotation_of: frame -> what was clicked.
        size_of: frame -> (width, height) px to fit at.
        model: see `fit_camera`.
    """

    field: Field
    annotation_of: Callable[[str], FrameAnnotation]
    size_of: Callable[[str], Size]
    model: str = "R"
    _fits: dict[str, FitResult] = dataclass_field(default_factory=dict)

    def __post_init__(self) -> None:
        self.field = surveyed_only(self.field)

    def of(self, frame: str) -> FrameView | str:
        fit = self._fits.get(frame)
        if fit is None:
            fit = self._fits[frame] = fit_camera(
                self.annotation_of(frame),
                field_for_frame(self.field, frame),
                model=self.model,
                size=self.size_of(frame),
            )
        return view_of_fit(fit)


def surveyed_only(field: Field) -> Field:
    """The field with those landmarks alone whose place somebody measured and that stay there."""
    kept = [m for m in field.landmarks if m.surveyed and not is_moving(m)]
    return with_landmarks(field, kept)


def view_of_fit(fit: FitResult) -> FrameView | str:
    """A fitted camera with its uncertainty, or why there is none."""
    if fit.camera is None:
        return fit.failure or translatable("no camera was found")
    if left_open := ill_conditioned_reason(fit):
        return translatable("its camera is hardly determined: {what}", what=left_open)
    return FrameView(fit.camera, fit.size, fit.projected_covariance)


def locate(
    clicked: ClickedLandmark,
    views: ViewCameras,
    *,
    click_px: float | None = None,
    noise: float | None = None,
    kept: Landmark | None = None,
) -> LocatedLandmark:
    """Triangulate one landmark.

    Args:
        clicked: its clicks.
        views: the cameras.
        click_px: standard deviation of a click along each axis, px of the views; without it the
            usual one, corrected by the residuals.
        noise: how many times as far off as usual clicks are, where other landmarks have told.
        kept: the entry whose position somebody gave: it is left alone, and compared to the clicks.
    """
    if clicked.problem and kept is None:
        return LocatedLandmark(clicked, Triangulation(failure=clicked.problem))
    seen: list[ClickedView] = []
    missing: list[tuple[str, str]] = []
    for click in clicked.clicks:
        found = views.of(click.frame)
        if isinstance(found, str):
            missing.append((click.frame, found))
        else:
            seen.append(_view(click, found, click_px))
    if kept is not None and kept.position is not None:
        agreed = compare_with_survey(
            seen, kept.position, kept.covariance, estimate_noise=click_px is None
        )
        result = Triangulation(
            residuals_px=agreed.residuals_px, failure=translatable("surveyed: kept as it is")
        )
        return LocatedLandmark(clicked, result, tuple(missing), True, agreed.astray)
    result = triangulate(seen, estimate_noise=click_px is None, noise=noise)
    return LocatedLandmark(clicked, _explained(result, missing, len(seen)), tuple(missing))


def _explained(found: Triangulation, missing: Sequence[tuple[str, str]], seen: int) -> Triangulation:
    """Where cameras are missing, that is why nothing was found."""
    if found.position is not None or seen > 1 or not missing:
        return found
    frame, why = missing[0]
    others = len(missing) - 1
    if others:
        problem = translatable(
            "no camera in {frame} ({why}), and {count} more", frame=frame, why=why, count=others
        )
    else:
        problem = translatable("no camera in {frame} ({why})", frame=frame, why=why)
    return Triangulation(failure=problem)


def _view(click: Click, of: FrameView, click_px: float | None) -> ClickedView:
    scale = np.array(of.size) - 1.0
    point = np.array([click.point.u, click.point.v]) * scale
    noise = default_click_sd_px(of.size[0]) if click_px is None else click_px
    return ClickedView(click.frame, of.camera, point, noise, of.covariance)
