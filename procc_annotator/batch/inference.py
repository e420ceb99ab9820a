"""Confidence intervals, paired tests and ranks of methods; annotation-noise sensitivity."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import combinations

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.batch.frame_sums import COMPARED, RATIOS, SPARSE, SPARSE_TAUS, SourceSums
from procc_annotator.batch.grouping import Clusters
from procc_annotator.errors import UsageError
from procc_annotator.messages import pluralize
from procc_annotator.metrics.statistics.intervals import (
    AnnotationNoiseSensitivity,
    BootstrapSample,
    BootstrapSettings,
    CurveBand,
    Interval,
    IntervalMethodName,
    RatioMetrics,
    annotation_noise_sensitivity,
    bootstrap,
    confidence_intervals,
    curve_band,
    normal_ppf,
    with_rule_of_three,
)
from procc_annotator.metrics.statistics.significance import (
    PairedDifference,
    corrected_for,
    min_clusters_for_significance,
    paired_differences,
    probability_of_best,
    significant_ranks,
    significantly_best,
)

# 435 pairs take some seconds to be tested; of 100 sources it would be 4,950.
MAX_COMPARED = 30
_FEW = 10  # clusters
_BAND_DRAWS = 2000  # the largest deviation of a whole curve takes no more


@dataclass(frozen=True, eq=False)
class MethodPair:
    """Two sources against each other.

    Attributes:
        a, b: their places.
        shared: how many frames both have a camera for, or elements both fits determine; their
            means are compared on these.
        only_a, only_b: frames that only one has: they count for completeness and final score.
        differences: (key, threshold) -> the figure of a less that of b.
        held_out: of fits, threshold -> the shares of elements that are correct under a and b.
    """

    a: int
    b: int
    shared: int
    only_a: tuple[str, ...]
    only_b: tuple[str, ...]
    differences: Mapping[tuple[str, float], PairedDifference]
    held_out: Mapping[float, tuple[float, ...]] = field(default_factory=dict)


def _corrected(pairs: Sequence[MethodPair]) -> tuple[MethodPair, ...]:
    """The pairs with each figure at each threshold corrected for as many comparisons."""
    keys = list(pairs[0].differences) if pairs else []
    tests = {key: corrected_for([pair.differences[key] for pair in pairs]) for key in keys}
    return tuple(
        replace(pair, differences={key: tests[key][n] for key in keys})
        for n, pair in enumerate(pairs)
    )


@dataclass(frozen=True, eq=False)
class Inference:
    """Sources over the same frames, chance considered.

    Attributes:
        sources: at least one, of the same frames and thresholds.
        clusters: of the frames.
        draws, method: how chance is asked, and how intervals are found.
        among: places of the sources that are compared and ranked; None: as of `compared`.
    """

    sources: tuple[SourceSums, ...]
    clusters: Clusters
    draws: BootstrapSettings = field(default_factory=BootstrapSettings)
    method: IntervalMethodName = "t"
    among: tuple[int, ...] | None = None

    def __post_init__(self) -> None:
        first = self.sources[0]
        for other in self.sources[1:]:
            if (other.names, other.thresholds) != (first.names, first.thresholds):
                raise UsageError(f"{first.name} and {other.name} were judged on other frames")

    @property
    def thresholds(self) -> tuple[float, ...]:
        """Of all figures, px."""
        return self.sources[0].thresholds

    @cached_property
    def described(self) -> str:
        """Return what intervals rest on, in words."""
        kind = {
            "t": "t, jackknife of clusters",
            "percentile": "percentile, expanded",
            "bca": "BCa, expanded",
        }[self.method]
        drawn = f"{self.draws.count:,} resamples, seed {self.draws.seed}"
        level = f"{100 * self.draws.level:g} % intervals"
        return f"{level} ({kind}); {self.clusters.described}; {drawn}"

    @cached_property
    def cautions(self) -> tuple[str, ...]:
        """Return what so few clusters cannot show, a sentence each; figures as in
        docs/explanation/statistics.md."""
        count, alike = self.clusters.count, self.clusters.thing
        said = [self.clusters.caution] if self.clusters.caution else []
        few = bool(said)
        if len(self.compared) < len(self.sources):
            said.append(
                f"Of {len(self.sources)} methods the {len(self.compared)} with the highest JaC at"
                f" {self.thresholds[0]:g} px are compared with each other and ranked."
            )
        if not few and self.method != "t" and count < _FEW:
            said.append(
                f"Of so few {alike}s ({count}) percentile and BCa intervals hold the truth in 88 to"
                " 93 of 100 sets, t in 92 to 97."
            )
        if len(self.sources) > 1 and count < min_clusters_for_significance(self.draws.level):
            said.append(
                f"Of {pluralize(count, alike)} no p is below {2.0 ** (1 - count):.2g}: no"
                " difference can be significant."
            )
        return tuple(said)

    @cached_property
    def intervals(self) -> tuple[Mapping[tuple[str, float], Interval | None], ...]:
        """Of each source: (key, threshold) -> the interval of the set's figure."""
        keys = [(key, tau) for key in RATIOS for tau in self.thresholds]
        # All sources at once: drawing sets costs more than what is summed over them.
        every = [source.ratios(key) for source in self.sources for key in RATIOS]
        sampled = self._sampled(RatioMetrics.beside(every))
        ends = confidence_intervals(sampled, self.draws, self.method)
        found = iter(zip(ends, sampled.effective.tolist(), strict=True))
        return tuple(
            {(key, tau): _possible(key, *next(found)) for key, tau in keys} for _ in self.sources
        )

    @cached_property
    def pairs(self) -> tuple[MethodPair, ...]:
        """Every two of the sources `compared`; what is tested is corrected for as many comparisons
        at a threshold. In-sample differences of fits have no interval and no test."""
        found = [self._pair(a, b) for a, b in combinations(self.compared, 2)]
        return _corrected(found)

    @cached_property
    def held_out_pairs(self) -> tuple[MethodPair, ...]:
        """Every two of the fits `compared` on the elements that both determine from the others
        (leave-one-element-out), corrected for as many at a threshold; key ``held_out``."""
        fits = [at for at in self.compared if any(f.held_out for f in self.sources[at].frames)]
        return _corrected([p for a, b in combinations(fits, 2) if (p := self._held_out(a, b))])

    def _held_out(self, a: int, b: int) -> MethodPair | None:
        shape = len(self.clusters.numbers), len(self.thresholds)
        passed, counts = np.zeros((2, *shape)), np.zeros(shape)
        every = zip(self.sources[a].frames, self.sources[b].frames, strict=True)
        for at, frames in enumerate(every):
            known = [{e.name: e.predicted_px for e in frame.held_out} for frame in frames]
            both = [name for name in known[0] if name in known[1]]
            counts[at] = len(both)
            for side, of_side in zip(passed, known, strict=True):
                px = np.array([np.inf if of_side[n] is None else of_side[n] for n in both])
                side[at] = (px[:, None] < np.array(self.thresholds)).sum(axis=0)
        if not counts.any():
            return None
        sides = [RatioMetrics(side, counts) for side in passed]
        found = self._paired(sides[0], sides[1], [True] * shape[1])
        shares = map(tuple, (passed.sum(axis=1) / counts.sum(axis=0)).T.tolist())
        return MethodPair(
            a, b, int(counts[:, 0].sum()), (), (),
            {("held_out", tau): d for tau, d in zip(self.thresholds, found, strict=True)},
            dict(zip(self.thresholds, shares, strict=True)),
        )  # fmt: skip

    def _paired(
        self, a: RatioMetrics, b: RatioMetrics, shares: Sequence[bool]
    ) -> list[PairedDifference]:
        columns = a.parts.shape[1]
        both = self._sampled(RatioMetrics.beside([a, b]))
        pair = both.at(slice(0, columns)), both.at(slice(columns, None))
        found = paired_differences(a, b, pair, self.clusters.numbers, self.draws, self.method)
        return [
            replace(one, interval=with_rule_of_three(one.interval, one.effective))
            if one.interval is not None and is_share
            else one
            for one, is_share in zip(found, shares, strict=True)
        ]

    def differences(self, key: str, tau: float) -> dict[tuple[int, int], PairedDifference]:
        """Of every two sources, by their places."""
        return {(pair.a, pair.b): pair.differences[key, tau] for pair in self.pairs}

    def highest(self, count: int) -> tuple[int, ...]:
        """The places of so many sources with the highest mean JaC at the first threshold; fits to
        the clicks come last."""

        def badness(at: int) -> tuple[bool, float]:
            own = self.sources[at].ratios("mean_jac")
            frames = own.denominators[:, 0].sum()
            return bool(self.sources[at].fitted), -float(own.parts[:, 0].sum() / max(frames, 1.0))

        return tuple(sorted(sorted(range(len(self.sources)), key=badness)[:count]))

    @cached_property
    def compared(self) -> tuple[int, ...]:
        """The sources that are compared with each other: all, or of many those that lead."""
        return self.highest(MAX_COMPARED) if self.among is None else self.among

    @cached_property
    def methods(self) -> list[int]:
        """The sources that are ranked: not those fitted to the clicks they are judged by."""
        return [at for at in self.compared if not self.sources[at].fitted]

    def ranks(self, key: str, tau: float) -> list[int | None]:
        """The place of each source; those that the data cannot distinguish share it."""
        found: list[int | None] = [None] * len(self.sources)
        places = significant_ranks(
            len(self.methods), self._among_methods(key, tau), RATIOS[key].better
        )
        for at, place in zip(self.methods, places, strict=True):
            found[at] = place
        return found

    def best(self, key: str, tau: float) -> int | None:
        """Which source is better than all others beyond chance."""
        best = significantly_best(
            len(self.methods), self._among_methods(key, tau), RATIOS[key].better
        )
        return None if best is None else self.methods[best]

    def can_be_bold(self, a: int, b: int, key: str) -> bool:
        """Return whether a difference of two sources may be reported as one between methods: none
        of them was fitted to the clicks, and their errors are of the same points."""
        if not {a, b} <= set(self.methods):
            return False
        return key != "mean_error" or self.sources[a].ground_only == self.sources[b].ground_only

    def _among_methods(self, key: str, tau: float) -> dict[tuple[int, int], PairedDifference]:
        """`differences` of those that are ranked, by their places among these."""
        at = {source: place for place, source in enumerate(self.methods)}
        every = self.differences(key, tau).items()
        return {(at[a], at[b]): d for (a, b), d in every if a in at and b in at}

    @cached_property
    def chances_of_being_best(self) -> dict[float, list[float | None]]:
        """Threshold -> in which share of the sets drawn each source that is ranked has the highest
        mean JaC, on the frames that all of these have; None where these frames are of fewer than
        two clusters, since every set drawn is the same then, or empty."""
        ranked = [self.sources[at] for at in self.methods]
        found: dict[float, list[float | None]] = {
            tau: [None] * len(self.sources) for tau in self.thresholds
        }
        if not ranked:
            return found
        everywhere = np.logical_and.reduce([source.with_camera for source in ranked])
        if len(np.unique(self.clusters.numbers[everywhere])) < 2:
            return found
        ratios = [source.ratios("mean_jac").of(everywhere) for source in ranked]
        drawn = bootstrap(RatioMetrics.beside(ratios), self.clusters.numbers, self.draws).drawn
        count = len(self.thresholds)
        for at, tau in enumerate(self.thresholds):
            chances = probability_of_best(list(drawn[:, at::count].T), +1)
            for place, chance in zip(self.methods, chances, strict=True):
                found[tau][place] = chance
        return found

    def jac_alone(self, source: int) -> tuple[BootstrapSample, int]:
        """The mean JaC of a source at each threshold, and its frames with a camera."""
        ratios = self.sources[source].ratios("mean_jac")
        frames = int(self.sources[source].with_camera.sum())
        return bootstrap(ratios, self.clusters.numbers, None), frames

    def curve(self, source: int) -> CurveBand:
        """The mean JaC of a source over `TAU_GRID`, with its band."""
        return self._band(self.sources[source].curves(), 0.0)

    def curve_of_difference(self, a: int, b: int) -> CurveBand:
        """Return what the curve of one source has more than that of another, on the frames both
        have."""
        mine, other = self.sources[a].curves(), self.sources[b].curves()
        shared = self._shared(a, b)[:, None]
        more = np.where(shared, mine.parts - other.parts, 0.0)
        return self._band(RatioMetrics(more, mine.denominators * shared), -1.0)

    def _band(self, ratios: RatioMetrics, least: float) -> CurveBand:
        draws = BootstrapSettings(
            min(_BAND_DRAWS, self.draws.count), self.draws.seed, self.draws.level
        )
        return curve_band(bootstrap(ratios, self.clusters.numbers, draws), draws, least, 1.0)

    def _sampled(self, ratios: RatioMetrics) -> BootstrapSample:
        draws = None if self.method == "t" else self.draws
        return bootstrap(ratios, self.clusters.numbers, draws)

    def _shared(self, a: int, b: int) -> BoolArray:
        return self.sources[a].with_camera & self.sources[b].with_camera

    def _pair(self, a: int, b: int) -> MethodPair:
        shared = self._shared(a, b)
        sides = [self._compared(self.sources[at], shared) for at in (a, b)]
        keys = [(key, tau) for key in COMPARED for tau in self.thresholds]
        found = self._paired(sides[0], sides[1], [RATIOS[key].better > 0 for key, _ in keys])
        if not {a, b} <= set(self.methods):  # fits explain the clicks: nothing to test
            found = [
                replace(one, interval=None, deviation=None, p=None, corrected=None) for one in found
            ]
        return MethodPair(
            a,
            b,
            int(shared.sum()),
            self._only(a, b),
            self._only(b, a),
            dict(zip(keys, found, strict=True)),
        )

    def _compared(self, source: SourceSums, shared: BoolArray) -> RatioMetrics:
        several = []
        for key in COMPARED:
            ratios = source.ratios(key)
            several.append(ratios if RATIOS[key].over_all else ratios.of(shared))
        return RatioMetrics.beside(several)

    def _only(self, a: int, b: int) -> tuple[str, ...]:
        own = self.sources[a].with_camera & ~self.sources[b].with_camera
        return tuple(np.array(self.sources[a].names, dtype=object)[own])


def _possible(key: str, interval: Interval | None, clusters: float) -> Interval | None:
    """No share is below 0 or above 1, and no error below 0; no share is known exactly."""
    if interval is None:
        return None
    highest = interval.high
    if RATIOS[key].better > 0:
        interval, highest = with_rule_of_three(interval, clusters), 1.0
    return replace(interval, low=max(0.0, interval.low), high=min(highest, interval.high))


def restrict_to_common_frames(sources: Sequence[SourceSums]) -> tuple[SourceSums, ...]:
    """Sources over the frames that all of them were judged on; an annotation that one run could
    not read any more is left out for all."""
    if not sources:
        return ()
    common = set.intersection(*(set(source.names) for source in sources))
    return tuple(
        SourceSums(s.name, s.thresholds, tuple(f for f in s.frames if f.frame in common))
        for s in sources
    )


@dataclass(frozen=True, eq=False)
class PairUnderClickNoise:
    """Two sources with the same points moved alike for both.

    Attributes:
        a, b: their places.
        spread: of the difference of mean JaC at each threshold.
        told_apart_from: the least tau at which they differ beyond what chance and clicks make of
            them, px; None where they do at none.
    """

    a: int
    b: int
    spread: AnnotationNoiseSensitivity
    distinguishable_from: float | None


def click_noise_spread(certainty: Inference, source: int) -> AnnotationNoiseSensitivity:
    """Of the mean JaC of a source at each threshold; its frames were judged with moved points."""
    sums = certainty.sources[source]
    own = sums.ratios("mean_jac")
    return _spread(certainty, own, _moved(sums, sums.with_camera), len(certainty.thresholds))


def pairs_under_click_noise(certainty: Inference) -> list[PairUnderClickNoise]:
    """Every two sources."""
    count = len(certainty.thresholds)
    found = []
    for pair in certainty.pairs:
        a, b = certainty.sources[pair.a], certainty.sources[pair.b]
        shared = a.with_camera & b.with_camera
        moved = _moved(a, shared) - _moved(b, shared)
        jac_a, jac_b = (s.ratios("mean_jac").of(shared) for s in (a, b))
        off = RatioMetrics(jac_a.parts - jac_b.parts, jac_a.denominators)
        found.append(
            PairUnderClickNoise(
                pair.a,
                pair.b,
                _spread(certainty, off, moved, count),
                _distinguishable_from(certainty, pair.a, pair.b, moved[..., count:]),
            )
        )
    return found


def _moved(sums: SourceSums, chosen: BoolArray) -> FloatArray:
    """(F, R, T + S) JaC of the frames chosen, all of which have a camera."""
    moved = [f.moved for f, own in zip(sums.frames, chosen, strict=True) if own]
    known = [m for m in moved if m is not None]
    shape = known[0].shape if known else (0, len(sums.thresholds) + len(SPARSE_TAUS))
    return np.array(known, dtype=np.float64).reshape(len(known), *shape)


def _spread(
    certainty: Inference, own: RatioMetrics, moved: FloatArray, count: int
) -> AnnotationNoiseSensitivity:
    return annotation_noise_sensitivity(
        moved[..., :count], bootstrap(own, certainty.clusters.numbers, None).deviation
    )


def _distinguishable_from(certainty: Inference, a: int, b: int, moved: FloatArray) -> float | None:
    band = certainty.curve_of_difference(a, b)
    sides = band.beyond_chance[SPARSE]
    clicks = annotation_noise_sensitivity(moved, np.full(len(SPARSE_TAUS), np.nan))
    far = normal_ppf((1 + certainty.draws.level) / 2) * clicks.deviations
    apart = (sides * clicks.means > far) & (sides != 0)
    return float(SPARSE_TAUS[int(np.argmax(apart))]) if apart.any() else None
