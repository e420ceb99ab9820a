"""Inference settings and the statistical results of evaluated methods."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Protocol

from procc_annotator.batch.audit import Pose
from procc_annotator.batch.execution.executor import Executor
from procc_annotator.batch.frame_sums import ClickNoise, SourceSums
from procc_annotator.batch.grouping import FrameOrder, Tags, clusters_of
from procc_annotator.batch.inference import Inference, restrict_to_common_frames
from procc_annotator.batch.strata import POSED, Stratum, strata, values_of_frames
from procc_annotator.field.model import Field
from procc_annotator.formats.file_source import FileSource
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.metrics.statistics.intervals import BootstrapSettings, IntervalMethodName
from procc_annotator.report.scores.inference_tables import (
    annotation_noise_tables,
    curves_table,
    inference_tables,
    strata_differences_table,
    strata_metrics_table,
    strata_table,
)
from procc_annotator.report.tables.data_files import table_entry
from procc_annotator.report.tables.table import MetricTable


@dataclass(frozen=True)
class InferenceSettings:
    """Settings of statistical inference.

    Attributes:
        cluster: a tag, ``shot`` or ``none``; None for shots where there are any.
        tags: of the frames of all sets.
        orders: set -> its table of frames, where it has one.
        draws, method: how intervals are found.
        power: whether to say how many frames are needed.
        noise: how points are moved; None for not at all.
        by: what to break the differences down by.
        poses: set -> frame -> see `reference_poses`, where ``by`` needs them.
    """

    cluster: str | None = None
    tags: Tags | None = None
    orders: Mapping[str, FrameOrder] = field(default_factory=dict)
    draws: BootstrapSettings = field(default_factory=BootstrapSettings)
    method: IntervalMethodName = "t"
    power: bool = False
    noise: ClickNoise | None = None
    by: tuple[str, ...] = ()
    poses: Mapping[str, Mapping[str, Pose | None]] = field(default_factory=dict)

    def tag(self, of_set: str, name: str | None) -> Mapping[str, str | None]:
        """The values of a tag, by frame."""
        return {} if self.tags is None else self.tags.values(name, of_set)

    def with_poses(
        self, sets: Mapping[str, tuple[FileSource, EvaluationSetup]], executor: Executor | None
    ) -> InferenceSettings:
        """The same with cameras fitted to the annotations of each set, where ``by`` needs them."""
        columns = () if self.tags is None else self.tags.columns
        if not any(by in POSED and by not in columns for by in self.by):
            return self
        from procc_annotator.batch.reference_poses import reference_poses  # loads the solver

        poses = {name: reference_poses(*own, executor) for name, own in sets.items()}
        return replace(self, poses=poses)

    def certainty(self, of_set: str, sources: Sequence[SourceSums]) -> Inference:
        """Of sources over the same set. `UsageError` if frames cannot be clustered as asked."""
        same = restrict_to_common_frames(sources)
        clusters = clusters_of(
            same[0].names, self.cluster, self.tag(of_set, self.cluster), self.orders.get(of_set)
        )
        return Inference(same, clusters, self.draws, self.method)


class EvaluatedMethod(Protocol):
    """A source over a set, as it was scored."""

    @property
    def set_name(self) -> str: ...
    @property
    def described(self) -> str: ...
    @property
    def summaries(self) -> Mapping[float, SetSummary]: ...
    @property
    def sums(self) -> SourceSums | None: ...
    @property
    def setup(self) -> EvaluationSetup: ...


@dataclass(frozen=True)
class StatisticalResult:
    """Statistical results for the sources of one set at one size; curves, and differences in parts
    of it, are for files alone and take long."""

    set_name: str
    described: str
    sheets: tuple[MetricTable, ...]
    curves: Callable[[], tuple[MetricTable, ...]] = tuple


def statistical_results(
    scored: Sequence[EvaluatedMethod], terms: InferenceSettings
) -> list[StatisticalResult]:
    """The sources of each set and size side by side."""
    groups: dict[tuple[str, tuple[int, int]], list[EvaluatedMethod]] = {}
    for one in scored:
        groups.setdefault((one.set_name, one.setup.size), []).append(one)
    found = []
    for (set_name, _), own in groups.items():
        certainty = terms.certainty(set_name, [one.sums for one in own if one.sums is not None])
        described = min((one.described for one in own), key=len)
        summaries = [one.summaries for one in own]
        of_field = own[0].setup.field
        found.append(
            statistical_result(certainty, summaries, terms, (set_name, of_field), described)
        )
    return found


def statistical_result(
    certainty: Inference,
    summaries: Sequence[Mapping[float, SetSummary]],
    terms: InferenceSettings,
    of_set: tuple[str, Field],
    described: str,
) -> StatisticalResult:
    """Return the inference over methods, with the summaries of each by threshold; UsageError if it
    is to be broken down by what is known of no frame."""
    sheets = inference_tables(certainty, summaries, described, power=terms.power)
    if terms.noise is not None:
        sheets += annotation_noise_tables(certainty, terms.noise, described)
    tau = certainty.thresholds[0]
    parted: list[list[Stratum]] = []
    for by in terms.by:
        name = of_set[0]
        known = terms.tag(name, by), terms.orders.get(name), terms.poses.get(name)
        values = values_of_frames(by, certainty.sources, of_set[1], *known)
        parts = strata(certainty, by, values)
        sheets.append(strata_table(parts, certainty, tau, described))
        sheets.append(strata_metrics_table(parts, certainty, described))
        parted.append(parts)

    def curves() -> tuple[MetricTable, ...]:
        if not certainty.pairs:
            return ()
        more = (strata_differences_table(parts, certainty, described) for parts in parted)
        return (*more, curves_table(certainty, described))

    return StatisticalResult(of_set[0], described, tuple(sheets), curves)


def inference_entries(results: Sequence[StatisticalResult]) -> dict[str, Any]:
    """As files of figures hold it; nothing where nothing was asked."""
    if not results:
        return {}
    return {
        "chance": [
            {
                "set": one.set_name,
                "described": one.described,
                **{sheet.name: table_entry(sheet) for sheet in (*one.sheets, *one.curves())},
            }
            for one in results
        ]
    }
