"""Intervals, differences and figures over time in a recipe: what is kept, and how to repeat it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import cast

from procc_annotator.cli.chance_options import cluster_of, orders_by_set
from procc_annotator.cli.over_time import TemporalRequest
from procc_annotator.metric.chance.intervals import IntervalMethodName
from procc_annotator.report.over_time import TemporalMetrics
from procc_annotator.report.recipe import RunManifest
from procc_annotator.report.recipe_further import ManifestInference, ManifestTemporal
from procc_annotator.report.scores.chance import InferenceSettings, StatisticalResult
from procc_annotator.report.scores.scoring import EvaluationRequest
from procc_annotator.session.dataset.dataset_folder import FRAMES_FILE, folder_of_dataset
from procc_annotator.session.runs.execution.executor import Executor
from procc_annotator.session.runs.tags import Tags


@dataclass(frozen=True)
class FurtherResults:
    """What a command made besides the figures of each set.

    Attributes:
        chance, told: what was asked of chance, and what it said.
        over_time, steady: the same over time.
    """

    chance: InferenceSettings | None = None
    told: Sequence[StatisticalResult] = ()
    over_time: TemporalRequest | None = None
    steady: Sequence[TemporalMetrics] = ()

    def frame_tables(self, asked: Sequence[EvaluationRequest]) -> set[Path]:
        """The tables of frames that were used without being named."""
        if self.chance is None and self.over_time is None:
            return set()
        folders = (folder_of_dataset(one.annotations.path) for one in asked)
        tables = (folder / FRAMES_FILE for folder in folders if folder is not None)
        return {table for table in tables if table.is_file()}


def inference_settings_again(known: ManifestInference, recipe: RunManifest, root: Path) -> InferenceSettings:
    """What a recipe asks of chance, elsewhere.

    Raises:
        UsageError, InputError: a file of tags or frames cannot be used.
    """
    sets = {one.set: root / one.annotations for one in recipe.evaluations}
    tags = None if known.tags is None else Tags.read(root / known.tags)
    shots = None if known.shots is None else root / known.shots
    return InferenceSettings(
        cluster_of(known.cluster, tags), tags, orders_by_set(sets, shots), known.draws,
        cast(IntervalMethodName, known.method), known.power, known.noise, known.by,
    )  # fmt: skip


def temporal_again(
    known: ManifestTemporal, root: Path, asked: Sequence[EvaluationRequest], executor: Executor
) -> list[TemporalMetrics] | str:
    """The figures over time, elsewhere; or why they cannot be made.

    Raises:
        UsageError, InputError: a table of frames cannot be used.
    """
    pictures = None if known.pictures is None else root / known.pictures
    if pictures is not None and not pictures.exists():
        return f"not repeated: over time: {known.pictures} is not here"
    shots = None if known.shots is None else root / known.shots
    return TemporalRequest(shots, pictures, ()).run(asked, known.threshold, executor)
