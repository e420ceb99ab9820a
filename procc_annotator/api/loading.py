"""Load datasets, annotations and cameras."""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from dataclasses import field as attribute
from pathlib import Path
from types import MappingProxyType

from procc_annotator.annotation import FrameAnnotation, pixel_like
from procc_annotator.api.inputs import as_field, as_path, kind_of
from procc_annotator.calibration import fitting
from procc_annotator.dataset.annotation_source import open_files, own_label_map
from procc_annotator.dataset.dataset_field import field_of_dataset
from procc_annotator.dataset.diagnostics import found_instead_of_cameras
from procc_annotator.dataset.frames import list_frames
from procc_annotator.dataset.landmarks.dataset_landmarks import field_of_dataset_with_landmarks
from procc_annotator.dataset.layout import annotations_or_path
from procc_annotator.dataset.picture_sizes import PictureSizes, picture_size, size_in_annotation
from procc_annotator.errors import InputError, ProccError, UsageError
from procc_annotator.field.load import field_for_frame
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.exchange import ExchangedFrame, Size
from procc_annotator.formats.annotations.label_map import read_label_map
from procc_annotator.formats.annotations.registry import SetReader
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera
from procc_annotator.formats.file_listing import CAMERA_PREFIX, files_of
from procc_annotator.formats.file_source import open_source
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.messages import pluralize

OnDamaged = Callable[[ProccError], None]
_ANNOTATIONS = (".json", ".xml")


@dataclass(frozen=True)
class Dataset:
    """Content of a dataset's folder.

    Attributes:
        path: the folder, archive or file.
        field: the one that the dataset says it shows, with its dimensions and landmarks; metres.
        annotations: frame name -> what is annotated in it, of the frames that have a file, in
            natural order.
        pictures: frame name -> its picture's file, of the frames that have one, in natural order;
            where they lie in folders of folders, frames are called by their paths (``game/00037``).
        sizes: frame name -> (width, height) px of its picture, of the annotated frames whose
            annotation or picture gives it; `size_of` also knows frames without annotation.
    """

    path: Path
    field: Field
    annotations: Mapping[str, FrameAnnotation] = attribute(repr=False)
    pictures: Mapping[str, Path] = attribute(repr=False)
    sizes: Mapping[str, Size] = attribute(default_factory=dict, repr=False)

    def size_of(self, frame: str) -> Size | None:
        """(width, height) px of a frame's picture as it is shown; None if unknown.

        The header of the picture is read; if absent, the annotations may say.

        Args:
            frame: its name.

        Raises:
            ImageError: the picture cannot be read.
        """
        picture = self.pictures.get(frame)
        return self.sizes.get(frame) if picture is None else picture_size(picture)

    def field_of(self, frame: str) -> Field:
        """The field with its landmarks where they are in a frame; metres.

        Args:
            frame: its name.
        """
        return field_for_frame(self.field, frame)


def load_dataset(
    path: str | Path,
    field: Field | str | None = None,
    *,
    on_damaged: OnDamaged | None = None,
    labels: str | Path | None = None,
) -> Dataset:
    """Read a dataset as the window and the commands see it.

    Args:
        path: its folder, of pictures, annotations or both; an archive or file of annotations; a
            video, whose frames' annotations lie next to it.
        field: as of `evaluate`; if None the one that the dataset says it shows, and the usual one
            where it does not say.
        on_damaged: called for each file or frame that cannot be used, which is then left out; None:
            the first one is raised.
        labels: a file ``labels.toml`` that says which classes the names of another program stand
            for; None: the dataset's own, if it has one.

    Returns:
        Annotations, pictures and the field. Pictures are not opened.

    Raises:
        UsageError: there is nothing at the path, or neither annotation nor picture.
        InputError: a file cannot be used.
    """
    place = as_path(path, "a dataset")
    known = field_of_dataset(place).field if field is None else as_field(field)
    known = field_of_dataset_with_landmarks(known, place)
    if place.is_file():
        place = annotations_or_path(place)  # of a video: its kept frames
    pictures = {}  # an archive's are not found
    if place.is_dir():
        pictures = {frame.name: frame.image_path for frame in list_frames(place)[1]}
    frames: list[ExchangedFrame] = []
    inside = annotations_or_path(place)
    if not pictures or _holds_annotations(inside):
        frames = _frames(inside, place, known, on_damaged, labels)
    sizes = {frame.name: frame.size or size_in_annotation(frame.annotation) for frame in frames}
    return Dataset(
        place,
        known,
        MappingProxyType({frame.name: frame.annotation for frame in frames}),
        MappingProxyType(pictures),
        MappingProxyType({name: size for name, size in sizes.items() if size is not None}),
    )


def as_dataset(
    annotations: Mapping[str, FrameAnnotation] | Dataset | str | Path,
    field: Field | str | None,
    title: str = "annotations",
) -> Dataset:
    """Annotations as a caller has them, with the field they are judged by; ``title`` names those by
    frame name. UsageError for what are none."""
    if isinstance(annotations, str | Path):
        return load_dataset(annotations, field)
    if isinstance(annotations, Dataset):
        return annotations if field is None else replace(annotations, field=as_field(field))
    given: object = annotations
    if not isinstance(given, Mapping):
        found = kind_of(given)
        raise UsageError(f"annotations: expected them by frame name, or a path, found {found}")
    return Dataset(Path(title), as_field(field), annotations, {}, {})


def load_annotations(
    path: str | Path,
    field: Field | str | None = None,
    *,
    on_damaged: OnDamaged | None = None,
    labels: str | Path | None = None,
) -> dict[str, FrameAnnotation]:
    """Read what is annotated in the frames of a set.

    Args:
        path: a folder or zip archive of annotations, or a file of many frames, of any format the
            program reads; or a dataset's folder with its annotations in ``annotations/``.
        field: knows the official spellings of the classes; or its name, see `load_field`; the
            usual one if None.
        on_damaged: and labels: as of `load_dataset`.

    Returns:
        Frame name -> its annotation, see `load_annotation`, in natural order. What was left out of
        files of other programs is a warning.

    Raises:
        InputError: a file cannot be used; the message names it, the place and what was expected.
        UsageError: there is nothing at the path, no annotation, or annotations of several formats.
    """
    place = as_path(path, "annotations")
    frames = _frames(annotations_or_path(place), place, as_field(field), on_damaged, labels)
    return {frame.name: frame.annotation for frame in frames}


def load_annotation(
    path: str | Path, field: Field | str | None = None, *, labels: str | Path | None = None
) -> FrameAnnotation:
    """Read what is annotated in one frame.

    Args:
        path: a file of any annotation format the program reads, or a folder or zip archive with
            one such file; it must hold exactly one frame.
        field: and labels: as of `load_annotations`.

    Returns:
        The polylines by class, in the order of the file. Points are normalised: (0, 0) is the
        centre of the picture's first pixel, (1, 1) that of its last one (pixel = u * (width - 1)).
        Whatever the numbers are, they are kept; a `UserWarning` says if they look like pixels.

    Raises:
        InputError: the file cannot be read; the message names it, the place and what was expected.
        UsageError: there is nothing at the path, no annotation, or more than one frame.
    """
    place = as_path(path, "an annotation")
    if place.name.startswith(CAMERA_PREFIX) and place.is_file():
        raise UsageError(
            f"{place}: is a camera file ({CAMERA_PREFIX}*), expected an annotation"
            " (those are named after their frame: 00037.json)"
        )
    frames = _frames(place, place, as_field(field), None, labels)
    if len(frames) == 1:
        strange = pixel_like(frames[0].annotation)
        if strange is not None:
            warnings.warn(f"{place}: {fitting.pixel_coordinates_error(strange)}", stacklevel=2)
        return frames[0].annotation
    names = ", ".join(frame.name for frame in frames[:3])
    more = ", ..." if len(frames) > 3 else ""
    raise UsageError(
        f"{place}: holds {len(frames)} frames ({names}{more}), one is needed"
        if frames
        else f"{place}: holds no frame"
    )


def load_cameras(
    path: str | Path, *, format: str = "auto", on_damaged: OnDamaged | None = None
) -> dict[str, LoadedCamera]:
    """Read the cameras of a method.

    Args:
        path: a folder or zip archive of camera files, or a file of many cameras, of any format the
            program reads.
        format: what the files are, as ``--camera-format`` names it; ``auto`` to look into them.
        on_damaged: as of `load_dataset`.

    Returns:
        Frame name -> its camera with the picture size (px) that it belongs to, in natural order;
        what a person should know of them (``notices``) is a warning, too. A frame is found, too, by
        a name that is composed otherwise, or that has the folders of its picture in it.

    Raises:
        CameraError: a file cannot be used.
        UsageError: there is nothing at the path, no camera, or no such format.
    """
    found = FrameTable[LoadedCamera]()
    notices = Counter[str]()
    with CameraCollection.open(as_path(path, "cameras"), format) as cameras:
        found.only_folder = cameras.frames.only_folder
        for error in cameras.passed_over:
            (on_damaged or _raise)(error)
        for frame in cameras.frames:
            try:
                loaded = found[frame] = cameras.read(frame)
                notices.update(loaded.notices)
            except InputError as error:
                (on_damaged or _raise)(error)
        if not cameras.frames:
            raise UsageError(
                f"{cameras.path}: holds no camera (format {format})"
                + found_instead_of_cameras(cameras.path)
            )
        told = [*cameras.remarks]
    told += (f"{notice} ({pluralize(count, 'camera')})" for notice, count in notices.items())
    for notice in told:
        warnings.warn(f"{path}: {notice}", stacklevel=2)
    return found


def load_camera(path: str | Path, *, format: str = "auto") -> LoadedCamera:
    """Read one camera.

    Args:
        path: its file, of any format the program reads.
        format: what it is, as ``--camera-format`` names it; ``auto`` to look into it.

    Returns:
        The camera with the picture size (px) that it belongs to, where the file says it, and what
        else the file says.

    Raises:
        CameraError: the file cannot be read, or is no camera.
        UsageError: no such format, or the file holds several cameras.
    """
    found = load_cameras(path, format=format)
    if len(found) > 1:
        names = ", ".join(list(found)[:3])
        raise UsageError(f"{path}: holds {len(found)} cameras ({names}, ...), one is needed")
    return next(iter(found.values()))


def _holds_annotations(place: Path) -> bool:
    with open_source(place) as source:
        return bool(files_of(source, lambda name: name.lower().endswith(_ANNOTATIONS))[0])


def _frames(
    place: Path,
    dataset: Path,
    field: Field,
    on_damaged: OnDamaged | None,
    labels: str | Path | None,
) -> list[ExchangedFrame]:
    """Return what is annotated at a place, each frame once; sizes that files leave out are those of
    pictures around the dataset, names of another program those of its ``labels.toml``."""
    if labels is None:
        names = own_label_map(dataset, field)
    else:
        names = read_label_map(as_path(labels, "labels"), field)
    sizes = PictureSizes.around(dataset, place)
    with open_files(place) as source:
        reader = SetReader(
            source, field, names,
            size_of=sizes.size, pictures=sizes.names(), called=sizes.called,
        )  # fmt: skip
        reader.reading.on_problem = on_damaged or _raise
        frames = list(reader.frames())
    for loss in reader.losses:
        if "left out" in loss:  # others say how it was read
            warnings.warn(f"{place}: {loss}", stacklevel=3)
    return frames


def _raise(error: ProccError) -> None:
    raise error
