"""Frames of a video as frames of a dataset, without extracting them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path

from procc_annotator.errors import SaveError
from procc_annotator.field.model import Field
from procc_annotator.image.decode import PixelArray
from procc_annotator.image.pixels import encode_png
from procc_annotator.io.atomic import write_atomic
from procc_annotator.session.dataset.dataset_folder import frames_folder
from procc_annotator.session.dataset.frames import Frame, video_frame
from procc_annotator.session.dataset.workspace import Workspace


def open_video(video: Path, numbers: Iterable[int], field: Field) -> Workspace:
    """The chosen frames of a video, and those worked on before, named ``match_000123``.

    Their pictures are decoded when asked for (paths like ``match.mp4/00000123``). Annotations lie
    in `frames_folder`, where `keep_frame` puts the pictures too, so that the folder is a dataset of
    its own.

    Args:
        video: an existing video file.
        numbers: frame numbers, counted from 0.
        field: knows the class names.
    """
    folder = frames_folder(video)
    frames = tuple(video_frame(video, number) for number in sorted({*numbers, *_frames_with_work(video)}))
    notices: tuple[str, ...] = ()
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        notices = (f"{folder}: cannot be made, nothing can be saved: {error.strerror}",)
    return Workspace(folder, frames, field, notices)


def _frames_with_work(video: Path) -> list[int]:
    """The frames that have an annotation or were kept, whatever was chosen that time."""
    name = re.compile(re.escape(video.stem) + r"_([0-9]{6,8})\.(?:json|png)", re.IGNORECASE)
    try:
        files = os.listdir(frames_folder(video))
    except OSError:  # usually: not made yet
        return []
    return [int(found[1]) for found in map(name.fullmatch, files) if found]


def keep_frame(frame: Frame, picture: PixelArray) -> Path:
    """Write a frame's picture beside its annotation, without loss; the same file each time.

    Raises:
        SaveError: it could not be written.
    """
    path = frame.annotation_folder / f"{frame.name}.png"
    if not path.parent.is_dir():
        raise SaveError(f"{path.parent}: does not exist, the picture was not kept")
    write_atomic(path, encode_png(picture), inside=path.parent)
    return path
