"""Evaluate a method on a set, with per-frame tables and intervals."""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from natsort import natsorted

from procc_annotator.annotation import FrameAnnotation, as_size
from procc_annotator.api.inputs import (
    as_annotation,
    as_optional_size,
    dataframe,
    evaluated_camera,
    position_remarks,
)
from procc_annotator.api.loading import Dataset, as_dataset
from procc_annotator.api.methods import Method, cameras_of
from procc_annotator.arrays import FloatArray
from procc_annotator.batch.audit import TAU_GRID
from procc_annotator.batch.evaluation import CHUNK
from procc_annotator.batch.frame_sums import FrameSums, SourceSums, frame_sums
from procc_annotator.batch.grouping import NONE, SHOT, clusters_of
from procc_annotator.batch.inference import Inference, restrict_to_common_frames
from procc_annotator.batch.scoring import FrameInput, Tally, score_frames
from procc_annotator.calibration.fitting import DEFAULT_SIZE
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.messages import condensed, pluralize
from procc_annotator.metrics.score import FrameScore
from procc_annotator.metrics.sets import SetAccumulator, SetSummary
from procc_annotator.metrics.setup import EvaluationSetup, check_thresholds
from procc_annotator.metrics.statistics.intervals import (
    BootstrapSettings,
    Interval,
    IntervalMethodName,
)
from procc_annotator.metrics.statistics.significance import PairedDifference
from procc_annotator.report.scores.score_files import FRAME_COLUMNS, frame_values

if TYPE_CHECKING:
    import pandas


Clustering = str | Mapping[str, str] | None


@dataclass(frozen=True, eq=False)
class SetScore:
    """Result of `evaluate_set`.

    Attributes:
        described: protocol, size and options in words, to stand next to every number; and whether
            cameras were fitted to the annotations they are judged by.
        summaries: threshold (px) -> the figures of the set, as ``evaluate`` gives them.
        frames: frame name -> threshold (px) -> its score; nothing for a frame without a camera.
    """

    described: str
    summaries: Mapping[float, SetSummary]
    frames: Mapping[str, Mapping[float, FrameScore]] = field(repr=False)
    _models: Mapping[str, str] = field(repr=False)
    _sums: SourceSums = field(repr=False)
    _terms: str = field(repr=False)

    def rows(self) -> list[dict[str, Any]]:
        """A row a frame and threshold.

        Returns:
            ``frame``, ``threshold`` (px), ``model`` of the camera, and the columns of score files:
            ``jac``, ``tp``, ``fp``, ``fn``, ``mirrored``, ``precision``, ``recall``, and mean
            errors (px). None where a figure is undefined, all of them without a camera.
        """
        names = [column.key for column in FRAME_COLUMNS]
        return [
            {"frame": frame, "threshold": tau, "model": self._models.get(frame)}
            | dict(zip(names, map(_plain, frame_values(scores.get(tau))), strict=True))
            for frame, scores in self.frames.items()
            for tau in self.summaries
        ]

    def class_rows(self) -> list[dict[str, Any]]:
        """A row a class and threshold.

        Returns:
            ``class``, ``threshold`` (px), ``tp``, ``fp``, ``fn`` in points, as the official
            evaluation counts classes, and ``jac``, ``precision``, ``recall`` of those (None where
            undefined).
        """
        return [
            {"class": name, "threshold": tau, "tp": of.tp, "fp": of.fp, "fn": of.fn}
            | {"jac": of.jac, "precision": of.precision, "recall": of.recall}
            for tau, summary in self.summaries.items()
            for name, of in summary.per_class.items()
        ]

    def to_dataframe(self) -> pandas.DataFrame:
        """The rows of `rows` as a pandas DataFrame; a UsageError where pandas is not installed."""
        return dataframe(self.rows())

    def mean_curve(self) -> tuple[FloatArray, FloatArray]:
        """The mean JaC of the frames that have a camera, as a function of the threshold.

        Returns:
            (T,) thresholds from 0.5 to 30 px, and (T,) JaC in [0, 1]; NaN without any camera.
        """
        curves = self._sums.curves()
        denominators = np.maximum(curves.denominators.sum(axis=0), 1.0)
        there = curves.denominators.sum(axis=0) > 0
        return TAU_GRID.copy(), np.where(there, curves.parts.sum(axis=0) / denominators, np.nan)

    def intervals(
        self,
        cluster: Clustering = None,
        *,
        method: IntervalMethodName = "t",
        draws: int = 10_000,
        seed: int = 1,
        level: float = 0.95,
    ) -> dict[float, dict[str, Interval | None]]:
        """Between which values the figures of the set lie, chance considered.

        Frames that are alike (of one match, one shot) say less than as many of several: whole
        clusters are drawn.

        Args:
            cluster: frame name -> what it belongs to; ``"shot"`` for shots as the frames' names
                give them, ``"none"`` for every frame for itself; None for shots if there are any.
            method: ``t`` (jackknife of clusters), ``percentile`` or ``bca``.
            draws: how many sets are drawn. seed: the same one draws the same sets.
            level: the share of sets in which the truth lies within, 0 to 1.

        Returns:
            Threshold (px) -> key of `SetSummary` (``mean_jac``, ``completeness``, ``final_score``,
            ``mean_precision``, ``mean_recall``, ``mean_error``) -> its interval, in the figure's
            unit; None with fewer than two clusters.

        Raises:
            UsageError: frames cannot be clustered as asked, or there is no such method.
        """
        certainty = _certainty(
            (self._sums,), cluster, method, BootstrapSettings(draws, seed, level)
        )
        found: dict[float, dict[str, Interval | None]] = {tau: {} for tau in self.summaries}
        for (key, tau), interval in certainty.intervals[0].items():
            found[tau][key] = interval
        return found

    def differences(
        self,
        other: SetScore,
        cluster: Clustering = None,
        *,
        method: IntervalMethodName = "t",
        draws: int = 10_000,
        seed: int = 1,
        level: float = 0.95,
    ) -> dict[float, dict[str, PairedDifference]]:
        """The figures of this method less those of another one, on the frames both have.

        Args:
            other: of the same annotations and thresholds.
            cluster: and method, draws, seed, level: as of `intervals`.

        Returns:
            Threshold (px) -> key (``mean_jac``, ``final_score``, ``mean_error``, ``completeness``)
            -> the difference in the figure's unit, its interval, the p of a permutation test, and
            whether it is beyond chance. This is one comparison of two methods: ``corrected`` is
            None. Of several pairs, correct the differences of one figure together:
            `corrected_for`, or `compare_methods`.

        Raises:
            UsageError: the two were scored differently, or as of `intervals`.
        """
        if other._terms != self._terms:
            raise UsageError(f"scored differently: {self._terms} and {other._terms}")
        if other._sums.thresholds != self._sums.thresholds:
            own, others = (_px_words(s._sums.thresholds) for s in (self, other))
            raise UsageError(f"scored at other thresholds: {own} and {others}")
        both = restrict_to_common_frames((self._sums, other._sums))
        certainty = _certainty(both, cluster, method, BootstrapSettings(draws, seed, level))
        found: dict[float, dict[str, PairedDifference]] = {tau: {} for tau in self.summaries}
        for (key, tau), difference in certainty.pairs[0].differences.items():
            found[tau][key] = replace(difference, corrected=None)
        return found


def _certainty(
    sources: Sequence[SourceSums],
    cluster: Clustering,
    method: IntervalMethodName,
    draws: BootstrapSettings,
) -> Inference:
    if method not in ("t", "percentile", "bca"):
        raise UsageError(f"unknown method {method!r}; choose one of t, percentile, bca")
    if draws.count < 1 or not 0 < draws.level < 1:
        raise UsageError("draws must be at least 1, and a level between 0 and 1")
    names = sources[0].names
    if isinstance(cluster, Mapping):
        clusters = clusters_of(names, "cluster", FrameTable(cluster))
    elif cluster in (None, SHOT, NONE):
        clusters = clusters_of(names, cluster, {})
    else:
        raise UsageError(f"unknown clusters {cluster!r}; give shot, none, or one a frame by name")
    return Inference(tuple(sources), clusters, draws, method)


def _px_words(thresholds: Iterable[float]) -> str:
    return ", ".join(f"{tau:g} px" for tau in thresholds)


def _plain(value: Any) -> Any:
    return None if value != value else value  # NaN is undefined


Size = tuple[int, int]


def evaluate_set(
    annotations: Mapping[str, FrameAnnotation] | Dataset | str | Path,
    cameras: Method,
    *,
    field: Field | str | None = None,
    size: Size = DEFAULT_SIZE,
    camera_size: Size | None = None,
    thresholds: float | Sequence[float] = (5.0,),
    protocol: str = "soccernet",
    allow_mirrored: bool = False,
    off_plane: str = "missed",
    planar_only: bool = False,
) -> SetScore:
    """Score the cameras of a method on a set: the figures of ``procc-annotator evaluate``.

    Args:
        annotations: frame name -> what is annotated in it; or a dataset, or the path of one.
        cameras: frame name -> its camera, as `evaluate` takes it; or a list of cameras in the order
            of the frames, a function of the frame's name, or the path of camera files.
            Annotated frames without a camera, or whose camera is None or a fit that failed, lower
            the completeness; cameras of frames that are not annotated are not counted.
        field: as of `evaluate`; if None that of the dataset, and the usual one for other
            annotations.
        size: (width, height) px at which annotations and cameras are compared; cameras are scaled
            to it.
        thresholds: px; compared strictly.
        camera_size: and protocol, allow_mirrored, off_plane, planar_only: as of `evaluate`.

    Returns:
        The figures of the set by threshold, the scores of its frames, and both as tables.

    Raises:
        UsageError: nothing to score, an argument of another kind, a camera whose answers are no
            projection, or a choice that there is not, see `evaluate`.
        InputError: a file cannot be used.
    """
    dataset, at = as_dataset(annotations, field), as_size(size)
    setup = EvaluationSetup(dataset.field, at, protocol, allow_mirrored, off_plane, planar_only)
    chosen = check_thresholds(thresholds)
    inputs = _inputs(dataset.annotations, cameras, setup, as_optional_size(camera_size))
    total, sums = Tally(SetAccumulator(setup, chosen)), list[FrameSums | None]()
    scores, notices = dict[str, Mapping[float, FrameScore]](), Counter[str]()
    for start in range(0, len(inputs), CHUNK):  # as `evaluate` adds, to the last digit
        part = Tally(SetAccumulator(setup, chosen))
        for evaluated in score_frames(inputs[start : start + CHUNK], part):
            scores[evaluated.result.name] = evaluated.result.scores
            notices.update(evaluated.result.notices)
            sums.append(frame_sums(evaluated, chosen))
        total.merge(part)
    told = condensed(notices)
    remarks = [f"{notice} ({pluralize(count, 'camera')})" for notice, count in told.items()]
    for line in (*total.notes.lines(), *position_remarks(inputs), *remarks, total.size_doubt):
        if line:
            warnings.warn(line, stacklevel=2)
    models = {one.name: one.model for one in inputs if one.camera is not None}
    source, terms = SourceSums.of("this", chosen, sums), setup.describe(total.ground_only)
    return SetScore(total.described, total.sums.summary(), scores, models, source, terms)


def _inputs(
    annotations: Mapping[str, FrameAnnotation],
    cameras: Method,
    setup: EvaluationSetup,
    camera_size: Size | None,
) -> list[FrameInput]:
    """The frames in natural order; UsageError if none has a camera."""
    by_frame, inputs = cameras_of(cameras, annotations), []
    for name in natsorted(annotations):
        one = FrameInput(name, as_annotation(annotations[name]))
        if (camera := by_frame.get(name)) is not None:
            used = evaluated_camera(camera, setup.of_frame(name), camera_size, f"camera of {name}")
            one = replace(one, camera=used.camera, model=used.model, fitted_on=used.fitted_on)
        inputs.append(one)
    if any(one.camera is not None for one in inputs):
        return inputs
    what = "no frame that is annotated has a camera" if inputs else "no annotated frame"
    theirs = next((name for name in by_frame if name not in annotations), None)
    if inputs and theirs is not None:
        what += f" (annotations are named like {inputs[0].name!r}, cameras like {theirs!r})"
    raise UsageError(f"nothing to score: {what}")
