"""Figures of a recipe besides those of each set: what chance leaves of them, and over time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from procc_annotator.metric.chance.sampling import BootstrapSettings
from procc_annotator.report.over_time import TemporalMetrics, shots_over_time_table
from procc_annotator.report.scores.chance import InferenceSettings, StatisticalResult
from procc_annotator.report.sheet.sheet import MetricTable, records
from procc_annotator.session.runs.moved_clicks import ClickNoise

SAME = 1e-12  # of a figure: the last digit that is written
Rows = list[dict[str, Any]]


@dataclass(frozen=True)
class ManifestInference:
    """What was asked of chance, and what it said.

    Attributes:
        cluster, by, method, draws, power, noise: as of `InferenceSettings`.
        tags, shots: paths of inputs, where such files were given.
        told: for each set and size, sheet -> its rows.
    """

    cluster: str | None
    by: tuple[str, ...]
    method: str
    draws: BootstrapSettings
    power: bool
    noise: ClickNoise | None
    tags: str | None
    shots: str | None
    told: list[dict[str, Rows]]


@dataclass(frozen=True)
class ManifestTemporal:
    """What was asked over the shots of the sets, and the figures of each shot.

    Attributes:
        threshold: px.
        shots: path of an input, where a table of frames was given.
        pictures: folder or video that cuts were found in, relative as inputs are.
    """

    threshold: float
    shots: str | None
    pictures: str | None
    rows: Rows


def manifest_inference(
    terms: InferenceSettings, told: Sequence[StatisticalResult], tags: str | None, shots: str | None
) -> ManifestInference:
    """What a recipe holds of chance; tags, shots: paths of inputs."""
    return ManifestInference(
        terms.cluster, terms.by, terms.method, terms.draws, terms.power, terms.noise, tags, shots,
        inference_rows(told),
    )  # fmt: skip


def inference_rows(told: Sequence[StatisticalResult]) -> list[dict[str, Rows]]:
    """The rows of every sheet, for each set and size."""
    return [{sheet.name: _rows(sheet) for sheet in one.sheets} for one in told]


def over_time_rows(found: Sequence[TemporalMetrics]) -> Rows:
    """The figures of every shot."""
    return _rows(shots_over_time_table(found))


def differing_inference(was: ManifestInference, told: Sequence[StatisticalResult]) -> Iterator[str]:
    """Which figures are others, one line each."""
    now = inference_rows(told)
    for at, sheets in enumerate(was.told):
        here = now[at] if at < len(now) else {}
        of = f"set {at + 1}, " if len(was.told) > 1 else ""
        for name, rows in sheets.items():
            yield from _differing_rows(f"{of}{name}", rows, here.get(name, []))


def differing_over_time(was: ManifestTemporal, found: Sequence[TemporalMetrics]) -> Iterator[str]:
    """Which figures of which shot are others, one line each."""
    yield from _differing_rows("over time", was.rows, over_time_rows(found))


def _rows(sheet: MetricTable) -> Rows:
    # As JSON has them: what is undefined is null.
    return [
        {key: None if value != value else value for key, value in row.items()}
        for row in records(sheet)
    ]


def _differing_rows(of: str, was: Rows, now: Rows) -> Iterator[str]:
    if len(was) != len(now):
        yield f"other figures: {of}: {len(now)} rows, were {len(was)}"
        return
    for number, (before, after) in enumerate(zip(was, now, strict=True), 1):
        for key, value in before.items():
            here = after.get(key)
            if not same_value(value, here):
                yield f"other figure: {of}, {_named(before, number)}: {key} {here}, was {value}"


def _named(row: Mapping[str, Any], number: int) -> str:
    """A row by its words, or else by its number."""
    words = [value for value in row.values() if isinstance(value, str) and len(value) < 40]
    tau = row.get("threshold")
    return (" ".join(words[:3]) or f"row {number}") + (f"@{tau:g}" if tau is not None else "")


def same_value(before: Any, after: Any) -> bool:
    """Whether two values are the same to the last digit that is written."""
    numbers = all(isinstance(v, int | float) and type(v) is not bool for v in (before, after))
    if not numbers:
        return bool(before == after)
    return bool(abs(before - after) <= SAME * max(1.0, abs(before)))
