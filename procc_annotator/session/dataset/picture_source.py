"""What a command looks at: the pictures of a folder, or all frames of a video, as the window names
them."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from pathlib import Path

from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.image.suffixes import VIDEO_SUFFIXES
from procc_annotator.image.video import open_shared_video
from procc_annotator.io.annotation_files.label_map import LabelMap
from procc_annotator.session.dataset.dataset_folder import frames_folder
from procc_annotator.session.dataset.frame_annotations import FrameAnnotations
from procc_annotator.session.dataset.frames import Frame, list_frames, video_frame


@dataclass(frozen=True)
class PictureSource:
    """Pictures in their order.

    Attributes:
        path: the folder or video.
        folder: the dataset's own, which need not exist yet for a video.
        frames: their names, pictures and annotation files; pictures by absolute paths, so that any
            worker finds them.
        is_video: whether they are the frames of one.
        notices: what the user should know of it.
        problems: of the whole source, so that results of it are incomplete, one line each.
    """

    path: Path
    folder: Path
    frames: tuple[Frame, ...]
    is_video: bool = False
    notices: tuple[str, ...] = ()
    problems: tuple[str, ...] = ()

    def annotated(
        self, annotations: Path | None, field: Field, names: LabelMap | None = None
    ) -> FrameAnnotations:
        """What is annotated in them.

        Args:
            annotations: a folder, archive or file of annotations, if they are not where they would
                be looked for.
            field: knows the official names.
            names: what the labels of the files stand for, as of `FrameAnnotations.of`.

        Raises:
            UsageError, InputError: as of `FrameAnnotations.of`.
        """
        return FrameAnnotations.of(self.path, annotations, field, names)


def open_pictures(path: Path, annotations: Path | None = None) -> PictureSource:
    """The pictures of a folder in natural order, one picture, or all frames of a video.

    Nothing is made on the disk, and of a video only the timestamps are read.

    Args:
        path: folder, picture or video.
        annotations: folder of the annotation files, if it is not where it would be looked for.

    Raises:
        UsageError: nothing there, a file of another kind, or a folder without pictures.
        ImageError: a video that cannot be opened.
        InputError: a folder that cannot be listed.
    """
    whole = Path(os.path.abspath(path))
    if not path.exists():
        raise UsageError(f"{path}: does not exist")
    if path.is_file() and path.suffix.lower() in VIDEO_SUFFIXES:
        video = open_shared_video(path)
        frames = tuple(video_frame(whole, number) for number in range(video.frame_count))
        if annotations is not None:
            frames = tuple(_annotated_in(frame, annotations) for frame in frames)
        words = (video.squeezed, video.cut_off)
        known, missing = (tuple(f"{path}: {word}" for word in [one] if word) for one in words)
        return PictureSource(path, frames_folder(path), frames, True, known, missing)
    root, frames, notices = list_frames(path, annotations)
    if not frames:
        raise UsageError(f"nothing to do: no picture in {path}")
    found = tuple(
        replace(frame, image_folder=Path(os.path.abspath(frame.image_folder))) for frame in frames
    )
    return PictureSource(path, root, found, notices=notices)


def _annotated_in(frame: Frame, folder: Path) -> Frame:
    return Frame(frame.name, frame.image_file, frame.image_folder, folder)
