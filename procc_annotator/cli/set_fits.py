"""Fit every frame of a set with a progress bar, for joint adjustment."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.joint_calibration import IndividualFit, SetFits, read_groups
from procc_annotator.batch.set_run import WORTH_WORKERS, annotation_files
from procc_annotator.batch.unit_store import UnitStore
from procc_annotator.cli.console import with_progress
from procc_annotator.cli.evaluation_plan import set_name_of
from procc_annotator.cli.options import shown_size
from procc_annotator.dataset.picture_sizes import FitSizes
from procc_annotator.formats.file_source import FileSource
from procc_annotator.metrics.setup import EvaluationSetup


@dataclass(frozen=True)
class FittedFrames:
    """A set, and the own fits of its frames."""

    fits: SetFits
    frames: list[IndividualFit]


def fit_sizes(source: FileSource, place: Path, dataset: Path, size: str | None) -> FitSizes:
    """Return what each frame of a set is fitted at, by the option's size or by the pictures of the
    dataset; UsageError if there is nothing to fit."""
    names = (name for name, _ in annotation_files(source))
    return FitSizes.of(shown_size(size), dataset, place, names)


def fit_set(
    source: FileSource,
    dataset: Path,
    setup: EvaluationSetup,
    sizes: FitSizes,
    model: str,
    groups: Path | None,
    workers: int | None,
    dask: str | None,
    kept: UnitStore | None = None,
) -> FittedFrames:
    """Fit every frame of a set (open annotations) by itself, with a progress bar.

    In a file of groups for several sets, the set is called like the dataset as the user named it.
    ``kept``: what was done before, and where the rest is kept.

    Raises UsageError for nothing to fit or a model that has no position, InputError for a file of
    groups that cannot be used."""
    known = None if groups is None else read_groups(groups, set_name_of(dataset))
    fits = SetFits(source, setup.field, sizes, model, known)
    with make_executor(workers, dask, frames=fits.total, worth_from=WORTH_WORKERS) as executor:
        fits.executor, fits.kept = executor, kept
        frames = list(with_progress(fits, fits.total, "fitting"))
    return FittedFrames(fits, frames)
