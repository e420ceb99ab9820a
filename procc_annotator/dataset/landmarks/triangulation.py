"""Triangulate the landmarks of a dataset from clicked views with known or fitted cameras."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from dataclasses import field as dataclass_field
from functools import cache
from pathlib import Path

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.result import FitResult, ill_conditioned_reason
from procc_annotator.calibration.triangulation import (
    CameraCovariance,
    ClickedView,
    Triangulation,
    compare_with_survey,
    default_click_sd_px,
    pooled_noise_factor,
    triangulate,
)
from procc_annotator.camera.base import Camera, ElementProjections
from procc_annotator.dataset.camera_set import FrameCameras
from procc_annotator.dataset.landmarks.clicks import (
    Click,
    ClickedLandmark,
    ClickGathering,
    LocatedLandmark,
    surveyed_entry,
)
from procc_annotator.dataset.landmarks.view_groups import ViewGroups
from procc_annotator.dataset.picture_sizes import FitSizes
from procc_annotator.errors import CameraError, InputError
from procc_annotator.field.landmarks import is_moving, with_landmarks
from procc_annotator.field.load import field_for_frame
from procc_annotator.field.model import Field, Landmark
from procc_annotator.formats.landmark_file import LandmarkFile
from procc_annotator.translation import translatable

Size = tuple[int, int]


@dataclass(frozen=True, eq=False)
class FrameView:
    """A frame's camera, px of ``size``; how surely it knows where it shows places, if it knows."""

    camera: Camera
    size: Size
    covariance: CameraCovariance | None = None


# The camera of a clicked frame, or why it is missing.
ViewCameras = Callable[[str], FrameView | str]


def views_of_set(cameras: FrameCameras, size_of: Callable[[str], Size]) -> ViewCameras:
    """Cameras of a set, taken as they are; each frame has a (width, height) px to work in."""

    def view(frame: str) -> FrameView | str:
        size = size_of(frame)
        try:
            found = cameras.camera(frame, size)
        except CameraError as error:
            return str(error)
        if found is None:
            return cameras.why_none(frame)
        if isinstance(found.camera, ElementProjections):
            return f"{cameras.name} shares projections alone, no camera"
        return FrameView(found.camera, size)

    return view


def fitted_views(
    field: Field,
    annotation_of: Callable[[str], FrameAnnotation],
    size_of: Callable[[str], Size],
    model: str = "R",
) -> ViewCameras:
    """Cameras fitted to the annotations, with their uncertainty; each once. Each frame has a
    (width, height) px to fit at.

    Triangulated landmarks take no part in the fits: a place must not be what gives the camera that
    gives the place. The field has the dataset's landmarks.
    """
    own = surveyed_only(field)

    @cache
    def view(frame: str) -> FrameView | str:
        shown, size = field_for_frame(own, frame), size_of(frame)
        return view_of_fit(fit_camera(annotation_of(frame), shown, model=model, size=size))

    return view


def surveyed_only(field: Field) -> Field:
    """The field with those landmarks alone that stay in one place, which a person measured."""
    kept = [m for m in field.landmarks if m.surveyed and not is_moving(m)]
    return with_landmarks(field, kept)


def view_of_fit(fit: FitResult) -> FrameView | str:
    """A fitted camera with its uncertainty, or why it failed."""
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
    """Triangulate one landmark from its clicks.

    Args:
        click_px: standard deviation of a click along each axis, px of the views; without it the
            usual one, corrected by the residuals.
        noise: how many times as far off as usual clicks are, where other landmarks have shown.
        kept: the entry with a surveyed position: it is left alone, and compared to the clicks.
    """
    if clicked.problem and kept is None:
        return LocatedLandmark(clicked, Triangulation(failure=clicked.problem))
    seen: list[ClickedView] = []
    missing: list[tuple[str, str]] = []
    for click in clicked.clicks:
        found = views(click.frame)
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


def _explained(
    found: Triangulation, missing: Sequence[tuple[str, str]], seen: int
) -> Triangulation:
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


Readers = Mapping[str, Callable[[], FrameAnnotation]]
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class DatasetPaths:
    """Paths of pictures and annotations of a dataset: the pictures give the shape of frames.

    Attributes:
        dataset: as the user named it.
        annotations: what they are read from.
        frames: names of all its frames.
    """

    dataset: Path
    annotations: Path
    frames: Sequence[str] = ()


@dataclass(frozen=True)
class TriangulationSettings:
    """Settings of a search for landmarks.

    Attributes:
        known: the landmarks of the dataset; what was surveyed is kept as it is.
        groups: when frames were taken.
        cameras: of the frames; None for cameras fitted to the annotations.
        names: the landmarks to place; None for all that are clicked.
        moving: those that move, next to those that are known to.
        click_px: see `locate`.
        size: (width, height) px to work in; None for what suits the pictures.
    """

    known: LandmarkFile
    groups: ViewGroups = dataclass_field(default_factory=ViewGroups)
    cameras: FrameCameras | None = None
    names: Collection[str] | None = None
    moving: Collection[str] = ()
    model: str = "R"
    click_px: float | None = None
    size: tuple[int, int] | None = None


@dataclass(frozen=True)
class FoundInDataset:
    """Result for the landmarks of a dataset.

    Attributes:
        located: in natural order, one an instant for what moves; empty if none is clicked.
        problems: one line for each annotation that cannot be read.
    """

    located: tuple[LocatedLandmark, ...] = ()
    problems: tuple[str, ...] = ()


def clicked_frames(
    read: Readers, names: Sequence[str], progress: Progress = lambda done, total: None
) -> dict[str, frozenset[str]]:
    """Frame -> the landmarks of these names clicked in it; frames that cannot be read have none.
    ``progress`` takes what is done and the total; it may raise to stop."""
    found = {}
    for done, (frame, read_one) in enumerate(read.items()):
        progress(done, len(read))
        try:
            found[frame] = clicked_in(read_one(), names)
        except InputError:
            continue
    return found


def clicked_in(annotation: FrameAnnotation, names: Sequence[str]) -> frozenset[str]:
    """The landmarks that have points in a frame."""
    annotated = set(annotation.annotated)
    return frozenset(name for name in names if name in annotated)


def locate_in_dataset(
    read: Readers,
    field: Field,
    place: DatasetPaths,
    search: TriangulationSettings,
    progress: Progress = lambda done, total: None,
) -> FoundInDataset:
    """Triangulate landmarks of a dataset, which its field has; safe from any thread.

    Args:
        read: frame -> reads its annotation, of all frames that may show them.
        place: of the files.
        search: what is looked for, and how.
        progress: takes what is done and the total; may raise to stop.
    """
    gathering = ClickGathering(field, search.known.landmarks, search.groups, search.moving)
    annotations: dict[str, FrameAnnotation] = {}
    problems = []
    for done, (frame, read_one) in enumerate(read.items()):
        progress(done, 2 * len(read))
        try:
            annotation = read_one()
        except InputError as error:
            problems.append(str(error))
            continue
        if gathering.add(frame, annotation):
            annotations[frame] = annotation
    wanted = None if search.names is None else {name.strip() for name in search.names}
    clicked = [one for one in gathering.clicked() if wanted is None or one.name.strip() in wanted]
    if not clicked:
        return FoundInDataset((), tuple(problems))
    views = _views(field, annotations, place, search)
    located = []
    for done, one in enumerate(clicked):
        progress(len(read) + len(read) * done // len(clicked), 2 * len(read))
        kept = surveyed_entry(search.known.landmarks, one.name, one.instant)
        located.append(locate(one, views, click_px=search.click_px, kept=kept))
    if search.click_px is None:
        located = _with_common_click_noise(located, views)
    return FoundInDataset(tuple(located), tuple(problems))


def _with_common_click_noise(
    located: list[LocatedLandmark], views: ViewCameras
) -> list[LocatedLandmark]:
    """The same, the clicks of all of them telling together how far clicks are off."""
    # Who is left out, and so the residuals, may change with it.
    for _ in range(2):
        noise = pooled_noise_factor([(one.found.squares, one.found.spare) for one in located])
        located = [one if one.kept else locate(one.clicked, views, noise=noise) for one in located]
    return located


def _views(
    field: Field,
    annotations: Mapping[str, FrameAnnotation],
    place: DatasetPaths,
    search: TriangulationSettings,
) -> ViewCameras:
    names = place.frames or tuple(annotations)
    sizes = FitSizes.of(search.size, place.dataset, place.annotations, names)

    def size_of(frame: str) -> tuple[int, int]:
        return sizes.of_frame(frame, annotations[frame]).fitted

    if search.cameras is not None:
        return views_of_set(search.cameras, size_of)
    return fitted_views(field, annotations.__getitem__, size_of, search.model)
