"""The charts of a report: curves, histograms, radius, directions, timelines, poses."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.report.audit_report import AuditReport, ReportedSource
from procc_annotator.report.chart_svg import FAINT, INK, Chart, draw_chart
from procc_annotator.report.report_tables import terms
from procc_annotator.session.audit import TAU_GRID
from procc_annotator.session.audit_figures import (
    POSE_QUANTITIES,
    POSE_UNITS,
    Points,
    bias,
    cell_arrows,
    envelope,
    gather,
    histogram,
    mean_curve,
    poses,
    radial_errors,
    timeline,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Floats = NDArray[np.floating[Any]]

_DASHES = ("-", (0, (5, 2)), (0, (1, 1.3)), (0, (6, 2, 1, 2)), (0, (3, 1)), (0, (8, 3)))
_MARKERS = ("o", "s", "^", "D", "v", "P")
_LARGEST_TAU = 20.0
_SECTORS = 24
_FRAMES = "frame, counted in natural order"
_MOST_PLACES = 1500  # of a line; more could not be told apart on paper


@dataclass(frozen=True, slots=True)
class _Look:
    """How a source is drawn, whichever chart: never by colour alone."""

    name: str
    colour: str
    dash: Any
    marker: str


@dataclass(frozen=True, eq=False)
class _Charted:
    source: ReportedSource
    look: _Look
    points: Points


def draw_charts(report: AuditReport, colours: Sequence[str]) -> list[Chart]:
    """All charts that the report has numbers for.

    Args:
        report: gathered.
        colours: of the sources, in order, repeated when there are more sources.
    """
    charted = [
        _Charted(
            source,
            _Look(
                source.name,
                colours[i % len(colours)],
                _DASHES[i % len(_DASHES)],
                _MARKERS[i % len(_MARKERS)],
            ),
            gather(list(source.audits.values())),
        )
        for i, source in enumerate(report.sources)
        if source.audits
    ]
    if not charted:
        return []
    charts = [_curves(report, charted), _timelines(report, charted)]
    if any(len(c.points.errors_px) for c in charted):
        charts += [
            _histogram(report, charted),
            _radius(report, charted),
            _class_histograms(report, charted),
            _directions(report, charted),
        ]
    with_pose = [c for c in charted if poses(report.frames, c.source.audits).with_pose > 1]
    if with_pose:
        charts.append(_poses(report, with_pose))
    return charts


def _curves(report: AuditReport, charted: list[_Charted]) -> Chart:
    def draw(figure: Figure) -> None:
        axes = figure.subplots()
        shown = _LARGEST_TAU >= TAU_GRID
        for one in charted:
            curve = mean_curve(list(one.source.audits.values()))
            axes.plot(TAU_GRID[shown], 100 * curve[shown], **_line(one.look))
        for tau in report.thresholds:
            if tau <= _LARGEST_TAU:
                axes.axvline(tau, color=FAINT, lw=0.8, ls=":")
        axes.set(xlabel="tau, px", ylabel="mean JaC, %", xlim=(0, _LARGEST_TAU), ylim=(0, 100))
        axes.legend(loc="lower right", handlelength=4)

    taus = ", ".join(f"{tau:g}" for tau in sorted(report.thresholds))
    return draw_chart(
        1,
        "JaC over the threshold",
        f"Mean JaC of the frames that have a camera, for every threshold tau; dotted lines at"
        f" {taus} px ({terms(report)}).",
        2.7,
        draw,
    )


def _timelines(report: AuditReport, charted: list[_Charted]) -> Chart:
    def draw(figure: Figure) -> None:
        rows = _panels(figure, len(charted), 1, between_in=0.26)
        for axes, one in zip(rows, charted, strict=True):
            jac = 100 * timeline(report.frames, one.source.audits, report.tau)
            places, values = envelope(jac, 0, len(jac), _MOST_PLACES)
            axes.plot(
                places + 1, values, color=one.look.colour, lw=0.7, marker=one.look.marker, ms=1.8
            )
            (missing,) = np.nonzero(np.isnan(jac))
            axes.plot(missing + 1, np.zeros(len(missing)), "x", color=INK, ms=4, mew=1)
            axes.set_title(_titled(one.source.name))
            axes.set(
                ylabel=f"JaC@{report.tau:g}, %",
                ylim=(-4, 104),
                yticks=(0, 50, 100),
                xlim=(0, len(report.frames) + 1),
            )
            axes.tick_params(labelbottom=axes is rows[-1])
        rows[-1].set_xlabel(_FRAMES)

    return draw_chart(
        2,
        "JaC of every frame",
        f"JaC at {report.tau:g} px frame by frame; a cross on the base line marks a frame without"
        f" a usable camera ({terms(report)}).",
        0.62 + 1.2 * len(charted),
        draw,
    )


def _histogram(report: AuditReport, charted: list[_Charted]) -> Chart:
    bars = histogram([c.points.errors_px for c in charted])

    def draw(figure: Figure) -> None:
        axes = figure.subplots()
        for one, counts in zip(charted, bars.counts, strict=True):
            if counts.sum():
                axes.stairs(100 * counts / counts.sum(), bars.edges, **_line(one.look))
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


def _class_histograms(report: AuditReport, charted: list[_Charted]) -> Chart:
    names = [element.title for element in report.setup.field.elements]
    rows = sorted({int(r) for c in charted for r in np.unique(c.points.class_rows)})
    bars = histogram([c.points.errors_px for c in charted])
    coarse = bars.edges[:: 2 if len(bars.edges) % 2 else 1]
    columns = 4
    height = math.ceil(len(rows) / columns)

    highest = 0.0
    shares: list[list[tuple[_Charted, Floats]]] = []
    for row in rows:
        of_class = []
        for one in charted:
            errors = one.points.errors_px[one.points.class_rows == row]
            if len(errors):
                counts, _ = np.histogram(np.minimum(errors, coarse[-1]), coarse)
                of_class.append((one, 100 * counts / counts.sum()))
                highest = max(highest, float(of_class[-1][1].max()))
        shares.append(of_class)

    def draw(figure: Figure) -> None:
        panels = _panels(figure, height, columns, between_in=0.3, top_in=0.45, bottom_in=0.5)
        for i, axes in enumerate(panels):
            axes.set_visible(i < len(rows))
            axes.set(xlim=(0, coarse[-1]), ylim=(0, 1.05 * highest))
            axes.tick_params(
                labelsize=6.5,
                labelbottom=i + columns >= len(rows),
                labelleft=i % columns == 0,
            )
        for axes, row, of_class in zip(panels, rows, shares, strict=False):
            axes.set_title(_short(names[row]), fontsize=7, pad=2)
            for one, share in of_class:
                axes.stairs(share, coarse, **{**_line(one.look), "lw": 0.9})
        _legend_above(figure, charted)
        figure.supxlabel("reprojection error, px", fontsize=8, y=0.005)
        figure.supylabel("points of the class, %", fontsize=8, x=0.005)

    return draw_chart(
        4,
        "Reprojection errors by class",
        f"The errors of each class; all panels have the same axes ({terms(report)}).",
        min(9.4, 0.95 + 1.1 * height),
        draw,
    )


def _radius(report: AuditReport, charted: list[_Charted]) -> Chart:
    def draw(figure: Figure) -> None:
        axes = figure.subplots()
        for one in charted:
            found = radial_errors(one.points, report.setup.size)
            axes.plot(
                found.centres, found.medians, marker=one.look.marker, ms=3.5, **_line(one.look)
            )
        axes.set(
            xlabel="distance from the picture's centre, half diagonals",
            ylabel="median error, px",
            xlim=(0, 1.02),
        )
        axes.set_ylim(bottom=0)
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


def _directions(report: AuditReport, charted: list[_Charted]) -> Chart:
    size = report.setup.size
    arrows = {c.look.name: cell_arrows(c.points, size) for c in charted}
    lengths = np.concatenate([np.hypot(*a.vectors_px.T) for a in arrows.values()])
    longest = float(np.percentile(lengths, 95)) if len(lengths) else 1.0

    def draw(figure: Figure) -> None:
        figure.set_layout_engine("none")
        for i, one in enumerate(charted):
            bottom = 1 - (i + 0.88) / len(charted)
            high = 0.68 / len(charted)
            _rose(figure.add_axes((0.03, bottom, 0.3, high), projection="polar"), one)
            axes = figure.add_axes((0.42, bottom, 0.56, high))
            found = arrows[one.look.name]
            axes.quiver(
                *found.at_px.T,
                *found.vectors_px.T,
                color=one.look.colour,
                angles="xy",
                scale_units="xy",
                # The longest arrow but for a few is as long as a cell is wide.
                scale=max(longest, 1e-6) / (size[0] / 16),
                width=0.0035,
            )
            axes.set(xlim=(-0.5, size[0] - 0.5), ylim=(size[1] - 0.5, -0.5), aspect="equal")
            axes.set_title(f"{_titled(one.source.name)}: median residual of each cell")
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


def _rose(axes: Axes, one: _Charted) -> None:
    residuals = one.points.residuals_px
    # The picture's y points down, that of a rose up.
    angles = np.arctan2(-residuals[:, 1], residuals[:, 0]) % (2 * math.pi)
    width = 2 * math.pi / _SECTORS
    sector = np.floor(angles / width + 0.5).astype(np.intp) % _SECTORS
    counts = np.bincount(sector, minlength=_SECTORS)
    share = 100 * counts / max(1, counts.sum())
    axes.bar(
        np.arange(_SECTORS) * width,
        share,
        width=0.9 * width,
        color=one.look.colour,
        alpha=0.75,
        lw=0,
    )
    axes.set_xticks(np.arange(4) * math.pi / 2, ("right", "up", "left", "down"), fontsize=6.5)
    axes.set_yticks([])
    lean = bias(one.points)
    if lean is not None:
        across, along = lean
        sides = (f"{abs(across):.2f} {'right' if across >= 0 else 'left'}",
                 f"{abs(along):.2f} {'down' if along >= 0 else 'up'}")  # fmt: skip
        axes.set_title(f"{_titled(one.source.name)}: bias {', '.join(sides)} px", fontsize=7.5)


def _poses(report: AuditReport, charted: list[_Charted]) -> Chart:
    found = [(c, poses(report.frames, c.source.audits)) for c in charted]

    def draw(figure: Figure) -> None:
        rows = _panels(figure, len(POSE_QUANTITIES), 1, between_in=0.12, top_in=0.35)
        for column, (axes, quantity, unit) in enumerate(
            zip(rows, POSE_QUANTITIES, POSE_UNITS, strict=True)
        ):
            for one, over in found:
                values = over.values[:, column]
                places, shown = envelope(values, 0, len(values), _MOST_PLACES)
                axes.plot(places + 1, shown, **{**_line(one.look), "lw": 0.8})
            axes.set_ylabel(f"{quantity}, {unit}")
            axes.tick_params(labelsize=6.5, labelbottom=axes is rows[-1])
            axes.set_xlim(0, len(report.frames) + 1)
        rows[-1].set_xlabel(_FRAMES)
        _legend_above(figure, charted)

    without = [s.name for s in report.evaluated if not poses(report.frames, s.audits).with_pose]
    rest = f" Without a pose: {', '.join(without)}." if without else ""
    return draw_chart(
        7,
        "Where the cameras stand and look",
        "Pose and focal length (px of the evaluation size) over the frames; in a sequence, a jump"
        f" stands out. The height is above the ground.{rest}",
        7.6,
        draw,
    )


def _panels(
    figure: Figure,
    rows: int,
    columns: int,
    *,
    between_in: float,
    top_in: float = 0.28,
    bottom_in: float = 0.42,
) -> list[Axes]:
    """Small panels row by row; placed here, for matplotlib's own layout of many takes seconds."""
    width, height = figure.get_size_inches()
    left, right = 0.6, 0.1
    high = (height - top_in - bottom_in - between_in * (rows - 1)) / rows
    wide = (width - left - right - 0.14 * (columns - 1)) / columns
    figure.set_layout_engine("none")
    return [
        figure.add_axes(
            (
                (left + column * (wide + 0.14)) / width,
                (height - top_in - high - row * (high + between_in)) / height,
                wide / width,
                high / height,
            )
        )
        for row in range(rows)
        for column in range(columns)
    ]


def _legend_above(figure: Figure, charted: Sequence[_Charted]) -> None:
    from matplotlib.lines import Line2D

    lines = [Line2D([], [], **_line(one.look)) for one in charted]
    figure.legend(handles=lines, loc="upper center", ncols=4, handlelength=4, borderaxespad=0.1)


def _line(look: _Look) -> dict[str, Any]:
    return {"color": look.colour, "ls": look.dash, "lw": 1.4, "label": _titled(look.name)}


def _titled(name: str) -> str:
    """A name as a label; matplotlib leaves out labels that begin with an underscore."""
    name = name if len(name) <= 40 else f"{name[:38]}…"
    return f" {name}" if name.startswith("_") else name


def _short(title: str) -> str:
    return title if len(title) <= 26 else f"{title[:25]}…"
