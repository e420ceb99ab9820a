"""Charts of a report: JaC curves, distributions, timelines, poses, jitter."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import BoolArray
from procc_annotator.batch.audit import (
    POSE_QUANTITIES,
    POSE_UNITS,
    TAU_GRID,
    FloatArray,
    envelope,
    mean_curve,
    poses,
)
from procc_annotator.metrics.statistics.intervals import CurveBand
from procc_annotator.report.page.chart_style import (
    FAINT,
    INK,
    Chart,
    ChartedMethod,
    chart_label,
    charted_sources,
    draw_chart,
    legend_above,
    panels,
    readable_on_both_themes,
)
from procc_annotator.report.page.error_charts import error_charts
from procc_annotator.report.page.report_data import AuditReport
from procc_annotator.report.page.report_tables import terms
from procc_annotator.report.temporal import TemporalMetrics, terms_over_time

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


_NUMBER = 21
_MOST_PLACES = 1500  # of a line; more could not be told apart on paper
_LEAST_SPAN_PX = 1.0


def jitter_chart(found: Sequence[TemporalMetrics], colours: Sequence[str]) -> Chart:
    """Jitter of every frame, a panel a source; shots one after the other.

    Args:
        found: at least one source.
        colours: of the sources, in order.
    """
    values = [np.concatenate([shot.steady.px for shot in one.shots]) for one in found]
    jumps = [np.concatenate([shot.broken.unsteady for shot in one.shots]) for one in found]
    steady = [v[np.isfinite(v) & ~jump] for v, jump in zip(values, jumps, strict=True)]
    most = max([_LEAST_SPAN_PX, *(float(v.max()) * 1.1 for v in steady if len(v))])
    ends = np.cumsum([len(shot.shot.frames) for shot in found[0].shots])[:-1]

    def draw(figure: Figure) -> None:
        rows = panels(figure, len(found))
        for at, (axes, one) in enumerate(zip(rows, found, strict=True)):
            colour = readable_on_both_themes(colours[at % len(colours)])
            places, shown = envelope(values[at], 0, len(values[at]), _MOST_PLACES)
            axes.plot(places + 1, np.minimum(shown, most), color=colour, lw=0.9)
            (leapt,) = np.nonzero(jumps[at])
            axes.plot(leapt + 1, np.full(len(leapt), most), "v", color=INK, ms=4, mew=0)
            for end in ends:
                axes.axvline(end + 0.5, color=FAINT, lw=0.8, ls=":")
            axes.set_title(chart_label(one.marked_name), y=1.0)
            axes.set(ylabel="jitter, px", ylim=(0, most * 1.05), xlim=(0, len(values[at]) + 1))
            axes.tick_params(labelbottom=axes is rows[-1])
        rows[-1].set_xlabel("frame of the shots, one after the other")

    return draw_chart(
        _NUMBER,
        "Jitter of every frame",
        "How far each frame is from where steady motion between its neighbours would have it, px."
        " A gap has no camera, or no neighbour with one; a triangle at the top is a frame of a"
        f" jump; dotted lines part shots ({terms_over_time(found)}, shots {found[0].told_by}).",
        0.62 + 1.2 * len(found),
        draw,
    )


_MAX_FRAME_PAIRS = 3  # of sources; more would fill a page
_ONE_FRAME, _SMALLEST_MARK, _LARGEST_MARK = 6.0, 2.0, 120.0  # areas, points squared


def frame_charts(report: AuditReport, charted: list[ChartedMethod]) -> list[Chart]:
    """The distribution for every source, and pairs of sources where there are several."""
    jacs: list[FloatArray] = [100 * report.jac_of_frames(one.source) for one in charted]
    charts = [_distribution(report, charted, jacs)]
    if len(charted) > 1:
        charts.append(_pairs(report, charted, jacs))
    return charts


def _distribution(
    report: AuditReport, charted: list[ChartedMethod], jacs: list[FloatArray]
) -> Chart:
    known = [values[~np.isnan(values)] for values in jacs]

    def draw(figure: Figure) -> None:
        figure.set_layout_engine("constrained")
        violins, curves = figure.subplots(1, 2)
        for place, (one, values) in enumerate(zip(charted, known, strict=True)):
            drawn = violins.violinplot([values], [place], widths=0.8, showextrema=False)
            for body in drawn["bodies"]:
                body.set(facecolor=one.colour, alpha=0.5)
            low, middle, high = np.percentile(values, (25, 50, 75))
            violins.plot([place, place], [low, high], color=one.colour, lw=4)
            violins.plot(
                [place], [middle], marker=one.marker, color=one.colour, ms=8, mec="white",
                mew=1.5,
            )  # fmt: skip
            share = 100 * (np.arange(len(values)) + 0.5) / len(values)
            curves.plot(share, np.sort(values), **one.line)
        names = [one.label for one in charted]
        violins.set_xticks(range(len(charted)), names, fontsize=7)
        violins.set(ylabel=f"JaC@{report.tau:g}, %", ylim=(-2, 102))
        curves.set(xlabel="frames, %, in the order of their JaC", xlim=(0, 100), ylim=(-2, 102))
        curves.legend(loc="lower right", handlelength=4)

    return draw_chart(
        9,
        "How the JaC of frames is distributed",
        f"Left: how many frames have which JaC at {report.tau:g} px; the bar holds the middle half"
        " of them, the mark is the median. Right:"
        " the frames of each source in the order of their JaC: a curve above another has at every"
        f" rank the better frame. Frames without a camera are left out ({terms(report)}).",
        2.9,
        draw,
    )


def _pairs(report: AuditReport, charted: list[ChartedMethod], jacs: list[FloatArray]) -> Chart:
    pairs = list(combinations(range(len(charted)), 2))[:_MAX_FRAME_PAIRS]

    def draw(figure: Figure) -> None:
        figure.set_layout_engine("constrained")
        for row, (i, j) in enumerate(pairs):
            names = charted[i].label, charted[j].label
            both = ~np.isnan(jacs[i]) & ~np.isnan(jacs[j])
            a, b = jacs[i][both], jacs[j][both]
            scatter = figure.add_subplot(len(pairs), 2, 2 * row + 1)
            places, counts = np.unique(np.stack((a, b), axis=1), axis=0, return_counts=True)
            scatter.plot((0, 100), (0, 100), color=FAINT, lw=0.8, ls=":")
            scatter.scatter(
                places[:, 0],
                places[:, 1],
                _mark_areas(counts),
                color=charted[i].colour,
                alpha=0.55,
                linewidths=0,
                clip_on=False,  # most lie at the ends of the axes
            )
            scatter.set(
                xlabel=f"{names[0]}, JaC %", ylabel=f"{names[1]}, JaC %", xlim=(-3, 103),
                ylim=(-3, 103), aspect="equal",
            )  # fmt: skip
            ordered = figure.add_subplot(len(pairs), 2, 2 * row + 2)
            share = 100 * (np.arange(len(a)) + 0.5) / max(1, len(a))
            ordered.axhline(0, color=FAINT, lw=0.8, ls=":")
            ordered.plot(share, np.sort(a - b), color=charted[i].colour, lw=1.2)
            ordered.set(
                xlabel="frames, %, in the order of the difference",
                ylabel=f"{names[0]} less {names[1]}, points", xlim=(0, 100),
            )  # fmt: skip

    cut = " The first pairs of many." if len(charted) > 3 else ""
    return draw_chart(
        10,
        "Two sources, frame by frame",
        f"JaC at {report.tau:g} px of the frames for which both have a camera. Left: a mark is a"
        " frame, a larger one several; above the dotted line the second source is better. Right:"
        " the differences in their order: where the curve crosses zero, one source stops being"
        f" better ({terms(report)}).{cut}",
        2.7 * len(pairs),
        draw,
    )


def _mark_areas(counts: NDArray[np.intp]) -> FloatArray:
    """Areas of marks that stand for so many frames: of a large set they would hide each other."""
    one = min(_ONE_FRAME, _LARGEST_MARK / counts.max(initial=1))
    return np.asarray(np.maximum(one * counts, _SMALLEST_MARK), dtype=np.float64)


_LARGEST_TAU = 20.0
_FRAMES = "frame, counted in natural order"
_MOST_PAIRS = 6  # of sources; more would fill a page
_MOST_IN_A_ROW = 300  # frames beside each other; lines from frame to frame of more are a smear
_STRETCHES = 100  # that more frames are summed up in
_DRAWABLE = 1e6  # what a damaged camera says beyond that would leave no room for the others


def draw_charts(report: AuditReport, colours: Sequence[str]) -> list[Chart]:
    """All charts that the report has numbers for.

    Args:
        report: gathered.
        colours: of the sources, in order, repeated when there are more sources.
    """
    charted = charted_sources(report, colours)
    if not charted:
        return []
    charts = [_curves(report, charted)]
    if report.certainty.pairs:
        charts.append(_differences(report, colours))
    if len(report.frames) <= _MOST_IN_A_ROW:
        charts.append(_timelines(report, charted))
    charts += frame_charts(report, charted)
    if any(len(c.points.errors_px) for c in charted):
        charts += error_charts(report, charted)
    with_pose = [c for c in charted if poses(report.frames, c.source.audits).with_pose > 1]
    if with_pose:
        charts.append(_poses(report, with_pose))
    return charts


def _curves(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    def draw(figure: Figure) -> None:
        (axes,) = panels(figure, 1, top_in=0.08)
        shown = _LARGEST_TAU >= TAU_GRID
        places = {source.name: at for at, source in enumerate(report.evaluated)}
        for one in charted:
            curve = mean_curve(list(one.source.audits.values()))
            axes.plot(TAU_GRID[shown], 100 * curve[shown], **one.line)
            band = report.certainty.curve(places[one.source.name])
            _shade(axes, band, shown, one.colour)
        for tau in report.thresholds:
            if tau <= _LARGEST_TAU:
                axes.axvline(tau, color=FAINT, lw=0.8, ls=":")
        axes.set(xlabel="tau, px", ylabel="mean JaC, %", xlim=(0, _LARGEST_TAU), ylim=(0, 100))
        axes.legend(loc="lower right", handlelength=4)

    marked = [f"{tau:g}" for tau in sorted(report.thresholds) if tau <= _LARGEST_TAU]
    lines = f"; dotted lines at {', '.join(marked)} px" if marked else ""
    return draw_chart(
        1,
        "JaC over the threshold",
        f"Mean JaC of the frames that have a camera, for every threshold tau{lines}"
        f" ({terms(report)}). Shaded: {_band_words(report)}.",
        2.7,
        draw,
    )


def _differences(report: AuditReport, colours: Sequence[str]) -> Chart:
    names = [source.marked_name for source in report.evaluated]
    pairs = report.certainty.pairs[:_MOST_PAIRS]
    shown = _LARGEST_TAU >= TAU_GRID

    def draw(figure: Figure) -> None:
        rows = panels(figure, len(pairs))
        for at, (axes, pair) in enumerate(zip(rows, pairs, strict=True)):
            band = report.certainty.curve_of_difference(pair.a, pair.b)
            colour = readable_on_both_themes(colours[at % len(colours)])
            axes.axhline(0, color=INK, lw=0.8)
            axes.plot(TAU_GRID[shown], 100 * band.values[shown], color=colour, lw=1.4)
            _shade(axes, band, shown, colour)
            title = f"{names[pair.a]} less {names[pair.b]}, {pair.shared} frames"
            axes.set_title(chart_label(title), y=1.0)
            axes.set(ylabel="points", xlim=(0, _LARGEST_TAU))
            axes.tick_params(labelbottom=axes is rows[-1])
        rows[-1].set_xlabel("tau, px")

    more = len(report.certainty.pairs) - len(pairs)
    rest = f" {more} more pairs are in the files." if more else ""
    return draw_chart(
        8,
        "The difference over the threshold",
        "JaC of one source less that of another on the frames both have, for every threshold tau"
        f" ({terms(report)}). Shaded: {_band_words(report)}. Where it lies wholly above or below 0"
        f" the two can be told apart.{rest}",
        0.62 + 1.2 * len(pairs),
        draw,
    )


def _shade(axes: Axes, band: CurveBand, shown: BoolArray, colour: str) -> None:
    low, high = 100 * band.low[shown], 100 * band.high[shown]
    axes.fill_between(TAU_GRID[shown], low, high, color=colour, alpha=0.18, lw=0)


def _band_words(report: AuditReport) -> str:
    certainty = report.certainty
    level = f"{100 * certainty.draws.level:g} % band of the whole curve"
    return f"{level}; {certainty.clusters.described}"


def _timelines(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    def draw(figure: Figure) -> None:
        rows = panels(figure, len(charted))
        for axes, one in zip(rows, charted, strict=True):
            jac = 100 * report.jac_of_frames(one.source)
            places = np.arange(len(jac)) + 1
            axes.plot(places, jac, color=one.colour, lw=0.7, marker=one.marker, ms=1.8)
            (missing,) = np.nonzero(np.isnan(jac))
            axes.plot(missing + 1, np.zeros(len(missing)), "x", color=INK, ms=4, mew=1)
            axes.set_title(one.label, y=1.0)
            axes.set(
                ylabel=f"JaC@{report.tau:g}, %",
                ylim=(-4, 104),
                yticks=(0, 50, 100),
                xlim=(0, len(report.frames) + 1),
            )
            axes.locator_params(axis="x", integer=True)
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


def _poses(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    found = [(c, poses(report.frames, c.source.audits)) for c in charted]
    many = len(report.frames) > _MOST_IN_A_ROW

    def draw(figure: Figure) -> None:
        rows = panels(figure, len(POSE_QUANTITIES), between_in=0.12, top_in=0.35)
        for column, (axes, quantity, unit) in enumerate(
            zip(rows, POSE_QUANTITIES, POSE_UNITS, strict=True)
        ):
            for one, over in found:
                values = over.values[:, column]
                values = np.where(np.abs(values) < _DRAWABLE, values, np.nan)
                if many:
                    centres, low, medians, high = _stretches(values)
                    axes.fill_between(centres, low, high, color=one.colour, alpha=0.25, lw=0)
                    axes.plot(centres, medians, **{**one.line, "lw": 0.9})
                else:
                    places = np.arange(len(values)) + 1
                    axes.plot(places, values, **{**one.line, "lw": 0.8})
            axes.set_ylabel(f"{quantity}, {unit}")
            axes.tick_params(labelsize=6.5, labelbottom=axes is rows[-1])
            axes.set_xlim(0, len(report.frames) + 1)
            axes.locator_params(axis="x", integer=True)
        rows[-1].set_xlabel(_FRAMES)
        legend_above(figure, charted)

    without = [s.name for s in report.evaluated if not poses(report.frames, s.audits).with_pose]
    rest = f" Without a pose: {', '.join(without)}." if without else ""
    summed = (
        f" Lines are medians of {_STRETCHES} stretches of the set, shaded from the least to the"
        " largest value in each."
        if many
        else ""
    )
    return draw_chart(
        7,
        "Where the cameras stand and look",
        "Pose and focal length (px of the evaluation size) over the frames; in a sequence, a jump"
        f" stands out.{summed} The height is above the ground; values over a million are left out."
        f"{rest}",
        7.6,
        draw,
    )


def _stretches(values: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Middle, least, median and largest value of stretches of a row; NaN where one has none."""
    rows = []
    start = 1
    for part in np.array_split(values, _STRETCHES):
        known = part[np.isfinite(part)]
        told = np.quantile(known, (0, 0.5, 1)) if len(known) else np.full(3, np.nan)
        rows.append((start + (len(part) - 1) / 2, *told))
        start += len(part)
    centres, low, medians, high = np.array(rows).T
    return centres, low, medians, high
