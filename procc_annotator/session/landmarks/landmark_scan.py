"""Which landmarks are clicked in which frames of a dataset, and where they are by those clicks."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from dataclasses import field as dataclass_field
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.field.model import Field
from procc_annotator.fit.click_noise import pooled_noise_factor
from procc_annotator.io.landmark_file import LandmarkFile
from procc_annotator.session.dataset.camera_set import FrameCameras
from procc_annotator.session.dataset.fit_sizes import FitSizes
from procc_annotator.session.landmarks.landmark_clicks import (
    ClickGathering,
    LocatedLandmark,
    surveyed_entry,
)
from procc_annotator.session.landmarks.landmark_views import FittedViews, ViewCameras, ViewsOfSet, locate
from procc_annotator.session.landmarks.view_groups import ViewGroups

Readers = Mapping[str, Callable[[], FrameAnnotation]]
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class DatasetPaths:
    """Where pictures and annotations of a dataset lie: the pictures tell the shape of frames.

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
    """How landmarks are looked for.

    Attributes:
        known: the landmarks of the dataset; what was surveyed is kept as it is.
        groups: when frames were taken.
        cameras: of the frames; None for cameras fitted to the annotations.
        names: the landmarks to place; None for all that are clicked.
        moving: those that move, beside those that are known to.
        model: to fit.
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
    """What became of the landmarks of a dataset.

    Attributes:
        located: in natural order, one an instant for what moves; empty if none is clicked.
        problems: one line for each annotation that cannot be read.
    """

    located: tuple[LocatedLandmark, ...] = ()
    problems: tuple[str, ...] = ()


def clicked_frames(
    read: Readers, names: Sequence[str], progress: Progress = lambda done, total: None
) -> dict[str, frozenset[str]]:
    """Frame -> the landmarks clicked in it; frames that cannot be read have none.

    Args:
        read: frame -> reads its annotation.
        names: of the landmarks.
        progress: takes what is done and the total; may raise to stop.
    """
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
    """Triangulate landmarks of a dataset; safe from any thread.

    Args:
        read: frame -> reads its annotation, of all frames that may show them.
        field: with the dataset's landmarks.
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


def _with_common_click_noise(located: list[LocatedLandmark], views: ViewCameras) -> list[LocatedLandmark]:
    """The same, the clicks of all of them telling together how far clicks are off."""
    # Who is left out, and so the residuals, may change with it.
    for _ in range(2):
        noise = pooled_noise_factor([(one.found.squares, one.found.spare) for one in located])
        located = [one if one.kept else locate(one.clicked, views, noise=noise) for one in located]
    return located


def _views(
    field: Field, annotations: Mapping[str, FrameAnnotation], place: DatasetPaths, search: TriangulationSettings
) -> ViewCameras:
    names = place.frames or tuple(annotations)
    sizes = FitSizes.of(search.size, place.dataset, place.annotations, names)

    def size_of(frame: str) -> tuple[int, int]:
        return sizes.of_frame(frame, annotations[frame]).fitted

    if search.cameras is not None:
        return ViewsOfSet(search.cameras, size_of)
    return FittedViews(field, annotations.__getitem__, size_of, search.model)
