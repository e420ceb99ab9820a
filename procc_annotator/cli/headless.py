"""What ``make run`` does where no display exists: the whole job on a dataset, no window."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli import datasets
from procc_annotator.cli.console import stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.cli.options import LabelsFile, label_map, make_setup
from procc_annotator.cli.painters import overlay_painter
from procc_annotator.errors import UsageError
from procc_annotator.io.annotation_files.label_map import LabelMap
from procc_annotator.io.atomic import make_folder
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report.export import Scoring, export_dataset
from procc_annotator.report.pictures import render_pictures
from procc_annotator.report.scores.scoring import Scored, score_set
from procc_annotator.report.scores.tables import sets_table
from procc_annotator.session.dataset.annotated_frames import DatasetFrames
from procc_annotator.session.dataset.annotation_source import open_annotations
from procc_annotator.session.dataset.dataset_folder import annotations_of

HELP = """\
Camera sets are the subfolders of DATASET/cameras.
"""

EXAMPLE = """
Example:

\b
  procc-annotator headless sample_data out
"""

THRESHOLDS = (5.0, 2.0, 10.0, 20.0)


def headless(
    dataset: Annotated[
        Path, typer.Argument(help="Folder of pictures and annotations, with cameras/.")
    ],
    out: Annotated[Path, typer.Argument(help="Folder of everything written.")],
    labels: LabelsFile = None,
) -> None:
    raise typer.Exit(run_headless(dataset, out, labels))


def run_headless(dataset: Path, out: Path, labels: Path | None = None) -> int:
    """Evaluate, export, draw, print where everything is; returns the exit code.

    Args:
        dataset: of pictures and annotations. out: folder of everything written.
        labels: what the labels of its files stand for; None: as its own map says, if it has one.
    """
    if not dataset.is_dir():
        raise UsageError(f"{dataset}: no such folder")
    echo(f"Without a window: evaluating, exporting and drawing {dataset}.\n")
    setup = make_setup(None, "960x540", "soccernet", "missed", mirrored=False, datasets=[dataset])
    names = label_map(labels, setup.field)
    make_folder(out)
    scored = {f: _score(dataset, f, out, setup, names) for f in camera_folders(dataset)}
    best = max(scored, key=lambda folder: _merit(scored[folder]), default=None)
    if scored:
        _print_table(scored)
        echo(f"\nscores, JSON and CSV   {out}/scores_*.json, .csv")
    problems = _export_and_draw(dataset, best, out, setup, names)
    for result in scored.values():
        problems += [error for error in result.errors if error not in problems]
    return datasets.report_unreadable(problems)


def camera_folders(dataset: Path) -> list[Path]:
    """The camera sets of a dataset: the subfolders of ``cameras``, or that folder itself."""
    folder = dataset / "cameras"
    if not folder.is_dir():
        return []
    return sorted(f for f in folder.iterdir() if f.is_dir() and f.name[0] != ".") or [folder]


def _score(
    dataset: Path, cameras: Path, out: Path, setup: EvaluationSetup, names: LabelMap | None
) -> Scored:
    outputs = [out / f"scores_{cameras.name}{suffix}" for suffix in (".json", ".csv")]
    with (
        open_annotations(annotations_of(dataset), setup.field, names) as annotation_source,
        CameraCollection.open(cameras) as collection,
    ):
        return score_set(annotation_source, collection, setup, THRESHOLDS, outputs=outputs)


def _merit(scored: Scored) -> tuple[float, float]:
    """Final score, and among equals the smaller error."""
    figures = scored.summaries[THRESHOLDS[0]]
    return figures.final_score or 0.0, -(figures.mean_error or 0.0)


def _print_table(scored: dict[Path, Scored]) -> None:
    rows = {folder.name: (s.summaries, s.described) for folder, s in scored.items()}
    stdout_console().print(sets_table(rows))


def _export_and_draw(
    dataset: Path,
    cameras: Path | None,
    out: Path,
    setup: EvaluationSetup,
    names: LabelMap | None,
) -> list[str]:
    """Export with, and draw, the camera set that agrees best; returns what could not be read."""
    workspace = datasets.open_dataset(dataset, setup.field, names=names)
    camera_set = datasets.open_cameras(cameras, "auto", None, setup.field)
    exported = export_dataset(
        DatasetFrames(workspace), out / "export", Scoring(setup, THRESHOLDS, camera_set)
    )
    drawn = 0
    problems = exported.problems
    for rendered in render_pictures(
        workspace,
        out / "overlays",
        overlay_painter(".png"),
        setup=setup,
        threshold=THRESHOLDS[0],
        cameras=camera_set,
    ):
        drawn = len(rendered.pictures)
        problems = exported.problems + [p for p in rendered.problems if p not in exported.problems]
    of_set = f" (cameras: {cameras.name})" if cameras is not None else ""
    echo(f"{exported.annotations} annotations and JaC   {out / 'export'}{of_set}")
    echo(f"{drawn} overlay pictures      {out / 'overlays'}{of_set}")
    return problems
