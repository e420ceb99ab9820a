"""What chance leaves of evaluations: asked once, told for the sources of each set together."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from procc_annotator.field.model import Field
from procc_annotator.metric.chance.intervals import Method
from procc_annotator.metric.chance.sampling import Draws
from procc_annotator.metric.sets import SetSummary
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report.scores.chance_sheets import chance_sheets, curves_sheet
from procc_annotator.report.scores.click_sheets import clicks_sheets
from procc_annotator.report.scores.strata_sheet import (
    figures_sheet,
    strata_differences_sheet,
    strata_sheet,
)
from procc_annotator.report.sheet.as_json import sheet_entry
from procc_annotator.report.sheet.sheet import Sheet
from procc_annotator.session.runs.certainty import Certainty, same_frames
from procc_annotator.session.runs.clusters import clusters_of
from procc_annotator.session.runs.frame_order import FrameOrder
from procc_annotator.session.runs.frame_sums import SourceSums
from procc_annotator.session.runs.moved_clicks import ClickNoise
from procc_annotator.session.runs.strata import Stratum, strata, values_of_frames
from procc_annotator.session.runs.tags import Tags


@dataclass(frozen=True)
class ChanceTerms:
    """What is asked of chance.

    Attributes:
        cluster: a tag, ``shot`` or ``none``; None for shots where there are any.
        tags: of the frames of all sets.
        orders: set -> its table of frames, where it has one.
        draws, method: how intervals are found.
        power: whether to say how many frames are needed.
        noise: how points are moved; None for not at all.
        by: what to break the differences down by.
    """

    cluster: str | None = None
    tags: Tags | None = None
    orders: Mapping[str, FrameOrder] = field(default_factory=dict)
    draws: Draws = field(default_factory=Draws)
    method: Method = "t"
    power: bool = False
    noise: ClickNoise | None = None
    by: tuple[str, ...] = ()

    def tag(self, of_set: str, name: str | None) -> Mapping[str, str | None]:
        """The values of a tag, by frame."""
        return {} if self.tags is None else self.tags.values(name, of_set)

    def certainty(self, of_set: str, sources: Sequence[SourceSums]) -> Certainty:
        """Of sources over the same set.

        Raises:
            UsageError: frames cannot be clustered as asked.
        """
        same = same_frames(sources)
        clusters = clusters_of(
            same[0].names, self.cluster, self.tag(of_set, self.cluster), self.orders.get(of_set)
        )
        return Certainty(same, clusters, self.draws, self.method)


class Judged(Protocol):
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
class ToldOfSet:
    """What chance leaves of the sources of one set at one size; curves, and differences in parts of
    it, are for files alone and take long."""

    set_name: str
    described: str
    sheets: tuple[Sheet, ...]
    curves: Callable[[], tuple[Sheet, ...]] = tuple


def chance_told(scored: Sequence[Judged], terms: ChanceTerms) -> list[ToldOfSet]:
    """The sources of each set and size side by side."""
    groups: dict[tuple[str, tuple[int, int]], list[Judged]] = {}
    for one in scored:
        groups.setdefault((one.set_name, one.setup.size), []).append(one)
    found = []
    for (set_name, _), own in groups.items():
        certainty = terms.certainty(set_name, [one.sums for one in own if one.sums is not None])
        described = min((one.described for one in own), key=len)
        summaries = [one.summaries for one in own]
        of_field = own[0].setup.field
        found.append(told_of_set(certainty, summaries, terms, (set_name, of_field), described))
    return found


def told_of_set(
    certainty: Certainty,
    summaries: Sequence[Mapping[float, SetSummary]],
    terms: ChanceTerms,
    of_set: tuple[str, Field],
    described: str,
) -> ToldOfSet:
    """What chance leaves of some sources.

    Args:
        certainty: of the sources. summaries: the figures of each, by threshold.
        of_set: its name and field.
        described: protocol, size and options.

    Raises:
        UsageError: it is to be broken down by what is known of no frame.
    """
    sheets = chance_sheets(certainty, summaries, described, power=terms.power)
    if terms.noise is not None:
        sheets += clicks_sheets(certainty, terms.noise, described)
    tau = certainty.thresholds[0]
    parted: list[list[Stratum]] = []
    for by in terms.by:
        known = terms.tag(of_set[0], by), terms.orders.get(of_set[0])
        values = values_of_frames(by, certainty.sources, of_set[1], *known)
        parts = strata(certainty, by, values)
        sheets.append(strata_sheet(parts, certainty, tau, described))
        sheets.append(figures_sheet(parts, certainty, described))
        parted.append(parts)

    def curves() -> tuple[Sheet, ...]:
        if not certainty.pairs:
            return ()
        more = (strata_differences_sheet(parts, certainty, described) for parts in parted)
        return (*more, curves_sheet(certainty, described))

    return ToldOfSet(of_set[0], described, tuple(sheets), curves)


def chance_entries(told: Sequence[ToldOfSet]) -> dict[str, Any]:
    """As files of figures hold it; nothing where nothing was asked."""
    if not told:
        return {}
    return {
        "chance": [
            {
                "set": one.set_name,
                "described": one.described,
                **{sheet.name: sheet_entry(sheet) for sheet in (*one.sheets, *one.curves())},
            }
            for one in told
        ]
    }
