"""The frames of a dataset: which pictures there are, and the files their annotations belong in."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from procc_annotator.errors import UsageError
from procc_annotator.image.suffixes import PICTURE_SUFFIXES
from procc_annotator.io.collections import OWN_FILES
from procc_annotator.io.frame_names import ByFrame
from procc_annotator.session.dataset.dataset_folder import (
    annotation_folder,
    json_stems,
    like_cameras,
    pictures_in,
)


@dataclass(frozen=True, slots=True)
class Frame:
    """One picture of the dataset and the file its annotation belongs in.

    ``annotation_stem`` is what that file is called where its letters are composed otherwise.
    """

    name: str
    image_file: str
    image_folder: Path
    annotation_folder: Path
    annotation_stem: str = ""

    # Paths are made when asked for: making them for 20,000 frames costs more than listing those.
    @property
    def image_path(self) -> Path:
        """The picture."""
        return self.image_folder / self.image_file

    @property
    def annotation_path(self) -> Path:
        """Where its annotation is or will be."""
        return self.annotation_folder / f"{self.annotation_stem or self.name}.json"


def list_frames(
    path: Path, annotations: Path | None = None
) -> tuple[Path, tuple[Frame, ...], tuple[str, ...]]:
    """List a folder's pictures in natural order, or take a single picture.

    Args:
        path: folder or picture.
        annotations: folder of the annotation files, if it is not where it would be looked for.

    Returns:
        The dataset's folder, its frames, and what the user should know of it.

    Raises:
        UsageError: no such folder, or a file that is no picture.
        InputError: a folder that cannot be listed.
    """
    if path.is_dir():
        root, pictures = path, pictures_in(path)
    elif not path.exists():
        raise UsageError(f"{path}: no such file or folder")
    elif path.suffix.lower() not in PICTURE_SUFFIXES:
        kinds = ", ".join(sorted(PICTURE_SUFFIXES))
        raise UsageError(f"{path}: not a picture (expected {kinds}) and not a folder")
    else:
        root, pictures = path.parent, [path.name]
    folder = annotations if annotations is not None else annotation_folder(root)
    frames: dict[str, Frame] = {}
    notices: list[str] = []
    # Only letters beside ASCII may be composed otherwise in the annotation's name.
    plain = all(map(str.isascii, pictures))
    stems = ByFrame[str]() if plain else ByFrame((s, s) for s in json_stems(folder))
    for file_name in pictures:
        name = os.path.splitext(file_name)[0]
        if (own := f"{name}.json") in OWN_FILES:
            notices.append(f"{file_name} is left out: {own} is not its annotation; rename it")
        elif name in frames:
            kept = frames[name].image_file
            notices.append(f"{file_name} is left out: {kept} already is frame {name}")
        else:
            frames[name] = Frame(name, file_name, root, folder, stems.get(name, ""))
    if remark := like_cameras(frame.image_file for frame in frames.values()):
        notices.insert(0, remark)  # the window shows the first three
    if folder != root and annotations is None:
        unused = sum(stem in frames for stem in json_stems(root))
        if unused:
            notices.append(
                f"annotations are those in {folder}; {unused} beside the pictures are not used"
            )
    return root, tuple(frames.values()), tuple(notices)
