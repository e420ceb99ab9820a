"""What ``triangulate`` tells of landmarks and writes of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from procc_annotator.cli import datasets
from procc_annotator.cli.console import stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.field.words import did_you_mean
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.landmark_file import LANDMARKS_FILE, LandmarkFile, save_landmarks
from procc_annotator.io.source import FileSource
from procc_annotator.report.landmarks import frames_without_camera, landmarks_table, surveyed_astray
from procc_annotator.session.dataset.dataset_folder import VIEWS_FILE, folder_of_dataset
from procc_annotator.session.dataset.picture_sizes import PictureSizes
from procc_annotator.session.landmarks.landmark_clicks import LocatedLandmark
from procc_annotator.session.landmarks.view_groups import ViewGroups, load_views, save_views
from procc_annotator.words import count_of


def report_strange_rows(groups: ViewGroups, source: FileSource, dataset: Path) -> None:
    folder = folder_of_dataset(dataset)
    pictures = PictureSizes([folder] if folder is not None else [], tree=folder)
    frames = {*list_annotations(source), *pictures.frames()}
    datasets.report_remarks(groups.strange_rows(frames))


def report_not_clicked(named: Mapping[str, str], located: Iterable[LocatedLandmark]) -> None:
    clicked = {one.clicked.name.strip() for one in located}
    datasets.report_remarks(
        f"{option} {name}: it is clicked in no frame{did_you_mean(name, clicked)}"
        for name, option in named.items()
        if name not in clicked
    )


def print_landmarks(located: Sequence[LocatedLandmark], described: str) -> None:
    stdout_console().print(landmarks_table(located, f"cameras: {described}"))
    datasets.report_remarks(
        f"no camera in {frame}: {why}" for frame, why in frames_without_camera(located).items()
    )
    datasets.report_remarks(surveyed_astray(located))


def write_landmarks(target: Path, known: LandmarkFile) -> None:
    save_landmarks(target, known)
    placed = sum(mark.position is not None for mark in known.landmarks)
    echo(f"written: {count_of(placed, 'position')} to {target}")


def keep_groups(target: Path, groups: ViewGroups, dataset: Path) -> None:
    """Write the groups where the landmarks were written to the dataset, if it keeps none yet."""
    folder = folder_of_dataset(dataset)
    if folder is None or (folder / LANDMARKS_FILE).resolve() != target.resolve():
        echo(f"note: {VIEWS_FILE} was not written: the dataset stays as it is", err=True)
        return
    path = folder / VIEWS_FILE
    if not path.exists():
        save_views(path, groups)
        echo(f"written: {path}")
    elif load_views(path) != groups:
        echo(f"note: {path} groups the frames otherwise; it was not changed", err=True)
