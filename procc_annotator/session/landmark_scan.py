"""Which landmarks are clicked in which frames of a dataset, and where they are by those clicks."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.field.model import Field
from procc_annotator.io.landmark_file import LandmarkFile
from procc_annotator.session.camera_set import FrameCameras
from procc_annotator.session.fit_sizes import FitSizes
from procc_annotator.session.landmark_clicks import ClickGathering, LocatedLandmark
from procc_annotator.session.landmark_views import FittedViews, Views, ViewsOfSet, locate
from procc_annotator.session.view_groups import ViewGroups

Readers = Mapping[str, Callable[[], FrameAnnotation]]
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class PlaceOfFiles:
    """Where pictures and annotations of a dataset lie: the pictures tell the shape of frames."""

    dataset: Path
    annotations: Path


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
    name: str,
    read: Readers,
    field: Field,
    known: LandmarkFile,
    groups: ViewGroups,
    cameras: FrameCameras | None,
    place: PlaceOfFiles,
    *,
    model: str = "R",
    progress: Progress = lambda done, total: None,
) -> tuple[LocatedLandmark, ...]:
    """Triangulate one landmark of a dataset; safe from any thread.

    Args:
        name: of the landmark.
        read: frame -> reads its annotation, of the frames it is clicked in.
        field: with the dataset's landmarks.
        known: the landmarks.
        groups: when frames were taken.
        cameras: of the frames; None for cameras fitted to the annotations.
        place: of the files.
        model: to fit.
        progress: takes what is done and the total; may raise to stop.

    Returns:
        One a instant for what moves, else one; empty if it is not clicked.

    Raises:
        InputError: an annotation cannot be read.
    """
    gathering = ClickGathering(field, known.landmarks, groups)
    annotations = {}
    for done, (frame, read_one) in enumerate(read.items()):
        progress(done, 2 * len(read))
        annotations[frame] = read_one()
        gathering.add(frame, annotations[frame])
    sizes = FitSizes.of(None, place.dataset, place.annotations, annotations)

    def size_of(frame: str) -> tuple[int, int]:
        return sizes.of_frame(frame, annotations[frame]).fitted

    views: Views = (
        FittedViews(field, annotations.__getitem__, size_of, model)
        if cameras is None
        else ViewsOfSet(cameras, size_of)
    )
    return tuple(locate(one, views) for one in gathering.clicked() if one.name == name)
