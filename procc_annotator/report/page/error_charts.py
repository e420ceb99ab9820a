"""Charts of reprojection errors: histograms, radius, direction."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.batch.audit import bias, cell_arrows, histogram, radial_errors
from procc_annotator.field.landmarks import element_titles
from procc_annotator.report.page.chart_style import (
    FAINT,
    Chart,
    ChartedMethod,
    Panel,
    draw_chart,
    inner_range,
)
from procc_annotator.report.page.report_data import AuditReport

_SECTORS = 24


def error_charts(report: AuditReport, charted: list[ChartedMethod]) -> list[Chart]:
    """The charts of reprojection errors."""
    return [
        _histogram(report, charted),
        _radius(report, charted),
        _classes(report, charted),
        _directions(report, charted),
    ]


def _histogram(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    bars = histogram([c.points.errors_px for c in charted])

    def draw(axes: Any) -> None:
        for one, counts in zip(charted, bars.counts, strict=True):
            if counts.sum():
                axes.stairs(100 * counts / counts.sum(), bars.edges, **one.line)
        axes.axvline(report.tau, color=FAINT, lw=0.8, ls=":")
        axes.set(xlabel="reprojection error, px", ylabel="points, %", xlim=(0, bars.edges[-1]))
        axes.legend(loc="upper right", handlelength=4)

    rest = " The last bar holds all larger errors." if bars.open_ended else ""
    text = (
        "Annotated points by their distance to the projection of their element."
        f"{rest} The dotted line is {report.tau:g} px."
    )
    return draw_chart(3, "Reprojection errors", text, [Panel(draw)])


def _radius(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    found = [radial_errors(one.points, report.setup.size) for one in charted]

    def draw(axes: Any) -> None:
        for one, errors in zip(charted, found, strict=True):
            axes.plot(errors.centres, errors.medians, marker=one.marker, ms=3.5, **one.line)
        axes.set(xlabel="distance from the picture's centre, half diagonals", xlim=(0, 1.02))
        axes.set_ylabel("median error, px")
        axes.set_ylim(bottom=0)
        axes.ticklabel_format(axis="y", scilimits=(-3, 5))  # longer ones find no room
        axes.legend(loc="best", handlelength=4)

    text = (
        "Median by distance from the picture's centre, where a twentieth of the way has five points"
        " or more. A rise towards the corners shows distortion that the camera model lacks."
    )
    return draw_chart(5, "Error against image radius", text, [Panel(draw)])


def _classes(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    names = list(element_titles(report.setup.field))
    rows = sorted({int(r) for c in charted for r in np.unique(c.points.class_rows)}, reverse=True)
    step = 0.7 / len(charted)
    quartiles = [_class_quartiles(one, rows) for one in charted]
    limits, beyond = inner_range([np.concatenate([q[:, 2] for q in quartiles])])

    def draw(axes: Any) -> None:
        for at, (one, own) in enumerate(zip(charted, quartiles, strict=True)):
            places = np.arange(len(rows)) + 0.35 - step * (at + 0.5)
            axes.hlines(places, own[:, 0], own[:, 2], color=one.colour, lw=1.2)
            axes.plot(
                own[:, 1], places, ls="", marker=one.marker, color=one.colour, ms=3, label=one.label
            )
        axes.set_yticks(range(len(rows)), [names[row].strip() for row in rows], fontsize=6)
        axes.set(xlabel="reprojection error, px", ylim=(-0.6, len(rows) - 0.4))
        axes.set_xlim(0, None if limits is None else limits[1])
        axes.legend(loc="best", fontsize=6)

    cut = f" {beyond} ends of bars beyond the 99th percentile are cut off." if beyond else ""
    text = f"The mark is the median of a class, the bar its middle half.{cut}"
    height = 0.7 + len(rows) * max(0.16, 0.06 * len(charted))
    panel = Panel(draw, height_in=height, left_in=1.25)
    return draw_chart(4, "Reprojection errors by class", text, [panel])


def _class_quartiles(one: ChartedMethod, rows: list[int]) -> FloatArray:
    """(C, 3) quartiles of the errors of each class, NaN without any."""
    groups = (one.points.errors_px[one.points.class_rows == row] for row in rows)
    found = [np.quantile(e, (0.25, 0.5, 0.75)) if len(e) else np.full(3, np.nan) for e in groups]
    return np.array(found, dtype=np.float64).reshape(-1, 3)


def _directions(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    size = report.setup.size
    arrows = [cell_arrows(one.points, size) for one in charted]
    lengths = np.concatenate([np.hypot(*a.vectors_px.T) for a in arrows])
    longest = float(np.percentile(lengths, 95)) if len(lengths) else 1.0

    def draw(axes: Any, at: int) -> None:
        axes.quiver(
            *arrows[at].at_px.T,
            *arrows[at].vectors_px.T,
            color=charted[at].colour,
            angles="xy",
            scale_units="xy",
            # The longest arrow but for a few is as long as a cell is wide.
            scale=max(longest, 1e-6) / (size[0] / 16),
            width=0.0035,
        )
        axes.set(xlim=(-0.5, size[0] - 0.5), ylim=(size[1] - 0.5, -0.5), aspect="equal")
        axes.grid(visible=False)

    panels = [Panel(partial(_rose, one=c), _bias_words(c), 2.5, polar=True) for c in charted]
    panels += [
        Panel(partial(draw, at=at), f"{one.label}: median residuals", 2.5)
        for at, one in enumerate(charted)
    ]
    text = (
        "Roses: the share of points whose projection lies in each direction of the click; a lean to"
        " one side is a bias. Arrows: the median residual of each cell of the picture with five"
        f" points or more, {size[0] / 16 / max(longest, 1e-6):.0f} times enlarged."
    )
    return draw_chart(6, "Directions of the residuals", text, panels)


def _bias_words(one: ChartedMethod) -> str:
    lean = bias(one.points)
    if lean is None:
        return one.label
    across, along = lean
    sides = (f"{abs(across):.2f} {'right' if across >= 0 else 'left'}",
             f"{abs(along):.2f} {'down' if along >= 0 else 'up'}")  # fmt: skip
    return f"{one.label}: bias {', '.join(sides)} px"


def _rose(axes: Any, one: ChartedMethod) -> None:
    width = 2 * math.pi / _SECTORS
    residuals = one.points.residuals_px
    # The picture's y points down, that of a rose up.
    angles = np.arctan2(-residuals[:, 1], residuals[:, 0])
    sectors = np.floor(angles / width + 0.5).astype(np.intp) % _SECTORS
    counts = np.bincount(sectors, minlength=_SECTORS)
    axes.bar(width * np.arange(_SECTORS), counts, 0.9 * width, color=one.colour, alpha=0.75)
    axes.set_ylim(0, 1.05 * max(1, counts.max()))
    axes.set_xticks(np.arange(4) * math.pi / 2, ("right", "up", "left", "down"), fontsize=6.5)
    axes.tick_params(pad=1)
    axes.set_yticks([])
