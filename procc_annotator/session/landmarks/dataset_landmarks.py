"""The landmarks of a dataset, in its field: ``landmarks.json`` and ``views.csv`` in its folder."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from procc_annotator.errors import FieldError, InputError
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.model import Field
from procc_annotator.io.landmark_file import LANDMARKS_FILE, LandmarkFile, load_landmarks
from procc_annotator.session.dataset.dataset_folder import VIEWS_FILE, folder_of_dataset, json_stems
from procc_annotator.session.landmarks.view_groups import ViewGroups, load_views

if TYPE_CHECKING:
    from procc_annotator.session.dataset.workspace import Workspace


def read_dataset_landmarks(dataset: Path) -> tuple[LandmarkFile, ViewGroups]:
    """What the files of a dataset say; nothing where there are none.

    Args:
        dataset: see `folder_of_dataset`.

    Raises:
        InputError: one of them cannot be used.
    """
    folder = folder_of_dataset(dataset)
    return (LandmarkFile(), ViewGroups()) if folder is None else read_landmarks_in(folder)


def read_landmarks_in(folder: Path) -> tuple[LandmarkFile, ViewGroups]:
    """What the files in a dataset's folder say; nothing where there are none.

    Raises:
        InputError: one of them cannot be used.
    """
    return load_landmarks(folder / LANDMARKS_FILE), load_views(folder / VIEWS_FILE)


def strange_rows_of(groups: ViewGroups, workspace: Workspace) -> str:
    """What is to say of rows that name a frame which a dataset has not, in one sentence; empty
    where there are none.

    Args:
        groups: of its ``views.csv``.
        workspace: its frames; safe from any thread.
    """
    if not workspace.frames or not groups.strange_names(workspace.index):
        return ""
    there = {*workspace.index, *json_stems(workspace.frames[0].annotation_folder)}
    count = len(groups.strange_names(there))
    if not count:
        return ""
    (first,) = groups.strange_rows(there, 1)
    if count == 1:
        return first
    return f"{first} (and {count - 1:,} more {'row' if count == 2 else 'rows'} like it)"


def field_with(field: Field, landmarks: LandmarkFile, groups: ViewGroups, path: Path) -> Field:
    """The field with a dataset's landmarks.

    Args:
        path: of the landmarks' file, for errors.

    Raises:
        InputError: a landmark has the name of a class of the field; which entry it is.
    """
    instants = {frame: of.instant for frame, of in groups.frames.items()}
    try:
        return with_landmarks(field, landmarks.landmarks, None, instants)
    except FieldError as error:
        raise InputError(path, error.problem, place=error.place, advice=error.advice) from error


def field_of_dataset_with_landmarks(field: Field, *datasets: Path) -> Field:
    """The field with the landmarks of the first of these datasets that has any.

    Raises:
        InputError: their file cannot be used.
    """
    for dataset in datasets:
        landmarks, groups = read_dataset_landmarks(dataset)
        if landmarks.landmarks:
            folder = folder_of_dataset(dataset) or dataset
            return field_with(field, landmarks, groups, folder / LANDMARKS_FILE)
    return field
