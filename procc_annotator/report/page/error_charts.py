"""Charts of reprojection errors: histograms, radius, direction."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.batch.audit import bias, cell_arrows, histogram, radial_errors
from procc_annotator.field.landmarks import element_titles
from procc_annotator.report.page.chart_style import (
    FAINT,
    Chart,
    ChartedMethod,
    draw_chart,
    legend_above,
    panels,
)
from procc_annotator.report.page.report_data import AuditReport
from procc_annotator.report.page.report_tables import terms

if TYPE_CHECKING:
    from matplotlib.figure import Figure


_SECTORS = 24


def error_charts(report: AuditReport, charted: list[ChartedMethod]) -> list[Chart]:
    """The charts of reprojection errors."""
    return [
        _histogram(report, charted),
        _radius(report, charted),
        _class_histograms(report, charted),
        _directions(report, charted),
    ]


def _histogram(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    bars = histogram([c.points.errors_px for c in charted])

    def draw(figure: Figure) -> None:
        (axes,) = panels(figure, 1, top_in=0.08)
        for one, counts in zip(charted, bars.counts, strict=True):
            if counts.sum():
                axes.stairs(100 * counts / counts.sum(), bars.edges, **one.line)
        axes.axvline(report.tau, color=FAINT, lw=0.8, ls=":")
        axes.set(xlabel="reprojection error, px", ylabel="points, %", xlim=(0, bars.edges[-1]))
        axes.legend(loc="upper right", handlelength=4)

    rest = " The last bar holds all larger errors." if bars.open_ended else ""
    return draw_chart(
        3,
        "Reprojection errors",
        "How many of the annotated points lie how far from the projection of their element."
        f"{rest} The dotted line is tau = {report.tau:g} px ({terms(report)}).",
        2.6,
        draw,
    )


def _radius(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    def draw(figure: Figure) -> None:
        (axes,) = panels(figure, 1, top_in=0.08)
        for one in charted:
            found = radial_errors(one.points, report.setup.size)
            axes.plot(found.centres, found.medians, marker=one.marker, ms=3.5, **one.line)
        axes.set(
            xlabel="distance from the picture's centre, half diagonals",
            ylabel="median error, px",
            xlim=(0, 1.02),
        )
        axes.set_ylim(bottom=0)
        axes.ticklabel_format(axis="y", scilimits=(-3, 5))  # longer ones find no room
        axes.legend(loc="best", handlelength=4)

    return draw_chart(
        5,
        "Error against image radius",
        "Median reprojection error by distance from the picture's centre, where a twentieth of the"
        " way has five points or more. A rise towards the corners shows distortion that the camera"
        f" model lacks ({terms(report)}).",
        2.6,
        draw,
    )


def _class_histograms(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    names = list(element_titles(report.setup.field).values())
    rows = sorted({int(r) for c in charted for r in np.unique(c.points.class_rows)})
    bars = histogram([c.points.errors_px for c in charted])
    coarse = bars.edges[:: 2 if len(bars.edges) % 2 else 1]
    columns = 4
    height = math.ceil(len(rows) / columns)

    shares = [(one, *_class_shares(one, rows, coarse)) for one in charted]
    highest = max(float(share.max()) for _, _, share in shares if len(share))

    def draw(figure: Figure) -> None:
        grid = panels(figure, height, columns, between_in=0.3, top_in=0.45)
        for empty in grid[len(rows) :]:
            empty.remove()
        for at, (axes, row) in enumerate(zip(grid, rows, strict=False)):
            axes.set_title(_short(names[row]), fontsize=7, y=1.0, pad=2)
            axes.set(xlim=(0, coarse[-1]), ylim=(0, 1.05 * highest))
            axes.tick_params(
                labelsize=6.5, labelleft=at % columns == 0, labelbottom=at + columns >= len(rows)
            )
        for one, places, share in shares:
            for place, values in zip(places, share, strict=True):
                grid[place].stairs(values, coarse, **{**one.line, "lw": 0.9})
        legend_above(figure, charted)
        figure.supxlabel("reprojection error, px", fontsize=8, y=0.005)
        figure.supylabel("points of the class, %", fontsize=8, x=0.005)

    return draw_chart(
        4,
        "Reprojection errors by class",
        f"The errors of each class; all panels have the same axes ({terms(report)}).",
        min(9.4, 0.95 + 1.1 * height),
        draw,
    )


def _class_shares(
    one: ChartedMethod, rows: list[int], edges: NDArray[np.floating[Any]]
) -> tuple[list[int], FloatArray]:
    """Places of the classes that a source has errors of, and their histograms in percent."""
    places, shares = [], []
    for place, row in enumerate(rows):
        errors = one.points.errors_px[one.points.class_rows == row]
        if len(errors):
            counts, _ = np.histogram(np.minimum(errors, edges[-1]), edges)
            places.append(place)
            shares.append(100 * counts / counts.sum())
    return places, np.array(shares).reshape(-1, len(edges) - 1)


def _directions(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    size = report.setup.size
    arrows = [cell_arrows(one.points, size) for one in charted]
    lengths = np.concatenate([np.hypot(*a.vectors_px.T) for a in arrows])
    longest = float(np.percentile(lengths, 95)) if len(lengths) else 1.0

    def draw(figure: Figure) -> None:
        for i, (one, found) in enumerate(zip(charted, arrows, strict=True)):
            bottom, high = 1 - (i + 0.88) / len(charted), 0.68 / len(charted)
            _rose(figure.add_axes((0.03, bottom, 0.3, high), projection="polar"), one)
            axes = figure.add_axes((0.42, bottom, 0.56, high))
            axes.quiver(
                *found.at_px.T,
                *found.vectors_px.T,
                color=one.colour,
                angles="xy",
                scale_units="xy",
                # The longest arrow but for a few is as long as a cell is wide.
                scale=max(longest, 1e-6) / (size[0] / 16),
                width=0.0035,
            )
            axes.set(xlim=(-0.5, size[0] - 0.5), ylim=(size[1] - 0.5, -0.5), aspect="equal")
            axes.set_title(f"{one.label}: median residual of each cell", y=1.0)
            axes.tick_params(labelsize=6.5)
            axes.grid(visible=False)

    return draw_chart(
        6,
        "Directions of the residuals",
        "Left: the share of points whose projection lies in each direction of the click; a lean to"
        " one side is a bias, written beside it. Right: the median residual of each cell of the"
        f" picture with five points or more, {size[0] / 16 / max(longest, 1e-6):.0f} times"
        f" enlarged ({terms(report)}).",
        2.35 * len(charted),
        draw,
    )


def _rose(axes: Any, one: ChartedMethod) -> None:
    """Shares of directions on polar axes, and the bias above."""
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
    lean = bias(one.points)
    if lean is not None:
        across, along = lean
        sides = (f"{abs(across):.2f} {'right' if across >= 0 else 'left'}",
                 f"{abs(along):.2f} {'down' if along >= 0 else 'up'}")  # fmt: skip
        title = f"{one.label}: bias {', '.join(sides)} px"
        axes.set_title(title, fontsize=7.5, loc="center", pad=12)


def _short(title: str) -> str:
    return title if len(title) <= 26 else f"{title[:25]}…"
