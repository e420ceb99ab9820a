"""Result for a dataset's landmarks: a table for the terminal."""

from __future__ import annotations

from collections.abc import Sequence

from procc_annotator.dataset.landmarks.clicks import LocatedLandmark
from procc_annotator.report.tables.table import (
    Column,
    Metric,
    MetricTable,
    count_column,
    metric_column,
)


def landmarks_table(located: Sequence[LocatedLandmark], described: str) -> MetricTable:
    """One row a landmark, and an instant if it moves; ``described``: where cameras come from."""
    columns = (
        Column("landmark", "landmark"),
        Column("instant", "instant"),
        count_column("views"),
        count_column("clicked", joined=" of {}"),
        *_axes("position"),
        *_axes("sd"),
        metric_column(Metric("angle", "angle,", "deg", digits=1)),
        metric_column(Metric("off", "off,", "px", digits=1)),
        Column("remark", "remark"),
    )
    rows = []
    for one in located:
        found, clicked = one.found, len(one.clicked.clicks)
        kept = [px for frame, px in found.residuals_px if frame not in found.left_out]
        position, deviations = found.position, found.deviations_m
        rows.append((
            one.clicked.name.strip(),
            one.clicked.instant,
            clicked - len(one.without_view),
            clicked if one.without_view else None,
            *(3 * [None] if position is None else map(float, position)),
            *(3 * [None] if deviations is None else map(float, deviations)),
            found.angle_degrees if position is not None else None,
            max(kept) if kept and (one.kept or position is not None) else None,
            "; ".join(_remarks(one)),
        ))  # fmt: skip
    return MetricTable("landmarks", "Landmarks", columns, tuple(rows), notes=(described,))


def _axes(what: str) -> tuple[Column, ...]:
    figure, heading = Metric(what, what), f"{what} (x, y, z), m"
    return (
        metric_column(figure, key=f"{what}_x_m", heading=heading),
        *(metric_column(figure, key=f"{what}_{axis}_m", joined=", {}") for axis in "yz"),
    )


def frames_without_camera(located: Sequence[LocatedLandmark]) -> dict[str, str]:
    """Frame -> why it took no part; each frame once, whatever was clicked in it."""
    return {frame: why for one in located for frame, why in one.without_view}


def surveyed_astray(located: Sequence[LocatedLandmark]) -> list[str]:
    """One sentence for each surveyed place that its clicks contradict."""
    return [
        f"{one.clicked.name.strip()} was surveyed, but its clicks are elsewhere: {_far(one)} (is it"
        " the same place, and are the position and the cameras right?)"
        for one in located
        if one.astray
    ]


def _far(one: LocatedLandmark) -> str:
    px = dict(one.found.residuals_px)
    return ", ".join(
        f"{px[frame]:.0f} px off in {frame}" if frame in px else f"{frame} does not show the place"
        for frame in one.astray
    )


def _remarks(one: LocatedLandmark) -> list[str]:
    found = one.found
    if found.position is None:
        return [found.failure or "", *(["the clicks do not agree"] if one.astray else [])]
    away = dict(found.residuals_px)
    return [f"left out: {frame} ({away[frame]:.0f} px off)" for frame in found.left_out]
