"""Charts of a report: JaC curves, distributions, timelines, poses, jitter."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.batch.audit import (
    POSE_QUANTITIES,
    POSE_UNITS,
    TAU_GRID,
    FloatArray,
    envelope,
    mean_curve,
    poses,
)
from procc_annotator.batch.inference import MethodPair
from procc_annotator.metrics.statistics.intervals import CurveBand
from procc_annotator.report.page.chart_style import (
    FAINT,
    INK,
    Chart,
    ChartedMethod,
    Panel,
    charted_sources,
    draw_chart,
    inner_range,
    readable_on_both_themes,
)
from procc_annotator.report.page.error_charts import error_charts
from procc_annotator.report.page.report_data import AuditReport
from procc_annotator.report.temporal import TemporalMetrics, terms_over_time

_NUMBER = 21
_MOST_PLACES = 750  # of a line; more could not be told apart on paper
_LEAST_SPAN_PX = 1.0
_LARGEST_TAU = 20.0
_SHOWN = TAU_GRID <= _LARGEST_TAU
_FRAMES = "frame, in natural order"
_MOST_PAIRS = 6  # of methods; more would fill a page
_MAX_FRAME_PAIRS = 3
_MOST_IN_A_ROW = 300  # frames next to each other; lines from frame to frame of more are a smear
_STRETCHES = 100  # that more frames are summed up in
_DRAWABLE = 1e6  # what a damaged camera says beyond that would leave no room for the others
_MOST_MARKS = 400  # of a scatter: of more, those of a square of 5 x 5 points of JaC are one
_ONE_FRAME, _SMALLEST_MARK, _LARGEST_MARK = 6.0, 2.0, 120.0  # areas, points squared


def draw_charts(report: AuditReport, colours: Sequence[str]) -> list[Chart]:
    """All charts that the report has numbers for; methods have the colours in order, repeated when
    there are more methods."""
    charted = charted_sources(report, colours)
    if not charted:
        return []
    curves = [_curves(report, charted)]
    methods = set(report.certainty.methods)
    if tested := [p for p in report.certainty.pairs if {p.a, p.b} <= methods]:
        curves.append(_differences(report, tested, colours))
    frames = [_timelines(report, charted)] if len(report.frames) <= _MOST_IN_A_ROW else []
    frames += frame_charts(report, charted)
    any_errors = any(len(c.points.errors_px) for c in charted)
    with_pose = [c for c in charted if poses(report.frames, c.source.audits).with_pose > 1]
    if with_pose:
        frames.append(_poses(report, with_pose))
    errors = error_charts(report, charted) if any_errors else []
    parts = (("curves", curves), ("errors", errors), ("frames", frames))
    return [replace(chart, part=part) for part, found in parts for chart in found]


def _curves(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    places = {source.name: at for at, source in enumerate(report.evaluated)}

    def draw(axes: Any) -> None:
        for one in charted:
            curve = mean_curve(list(one.source.audits.values()))
            axes.plot(TAU_GRID[_SHOWN], 100 * curve[_SHOWN], **one.line)
            _shade(axes, report.certainty.curve(places[one.source.name]), one.colour)
        for tau in report.thresholds:
            if tau <= _LARGEST_TAU:
                axes.axvline(tau, color=FAINT, lw=0.8, ls=":")
        axes.set(xlabel="threshold, px", ylabel="mean JaC, %")
        axes.set(xlim=(0, _LARGEST_TAU), ylim=(0, 100))
        axes.legend(loc="lower right", handlelength=4)

    marked = [f"{tau:g}" for tau in sorted(report.thresholds) if tau <= _LARGEST_TAU]
    lines = f"; dotted lines at {', '.join(marked)} px" if marked else ""
    text = (
        f"Mean JaC of the frames with a camera{lines}. Shaded: {_band_words(report)} of the whole"
        " curve."
    )
    return draw_chart(1, "JaC over the threshold", text, [Panel(draw, height_in=2.6)])


def _differences(
    report: AuditReport, tested: Sequence[MethodPair], colours: Sequence[str]
) -> Chart:
    names = [source.marked_name for source in report.evaluated]
    pairs = tested[:_MOST_PAIRS]

    def draw(axes: Any, at: int) -> None:
        band = report.certainty.curve_of_difference(pairs[at].a, pairs[at].b)
        colour = readable_on_both_themes(colours[at % len(colours)])
        axes.axhline(0, color=INK, lw=0.8)
        axes.plot(TAU_GRID[_SHOWN], 100 * band.values[_SHOWN], color=colour, lw=1.4)
        _shade(axes, band, colour)
        axes.set(xlabel="threshold, px", ylabel="points", xlim=(0, _LARGEST_TAU))

    rest = (
        f" {len(tested) - len(pairs)} more pairs are in the files." if tested[len(pairs) :] else ""
    )
    text = (
        "JaC of one method − that of another on the frames both have. Shaded:"
        f" {_band_words(report)} of the whole curve; where it excludes 0 the difference is"
        f" significant.{rest}"
    )
    panels = [
        Panel(partial(draw, at=at), f"{names[pair.a]} − {names[pair.b]}", 2.0)
        for at, pair in enumerate(pairs)
    ]
    return draw_chart(8, "Differences over the threshold", text, panels)


def _shade(axes: Any, band: CurveBand, colour: str) -> None:
    low, high = 100 * band.low[_SHOWN], 100 * band.high[_SHOWN]
    axes.fill_between(TAU_GRID[_SHOWN], low, high, color=colour, alpha=0.18, lw=0)


def _band_words(report: AuditReport) -> str:
    return f"{100 * report.certainty.draws.level:g} % confidence band"


def frame_charts(report: AuditReport, charted: list[ChartedMethod]) -> list[Chart]:
    """The distribution for every method, and pairs of methods where there are several."""
    jacs: list[FloatArray] = [100 * report.jac_of_frames(one.source) for one in charted]
    charts = [_distribution(report, charted, jacs)]
    if len(charted) > 1:
        charts.append(_pairs(report, charted, jacs))
    return charts


def _distribution(
    report: AuditReport, charted: list[ChartedMethod], jacs: list[FloatArray]
) -> Chart:
    known = [values[~np.isnan(values)] for values in jacs]

    def violins(axes: Any) -> None:
        for place, (one, values) in enumerate(zip(charted, known, strict=True)):
            drawn = axes.violinplot([values], [place], widths=0.8, showextrema=False)
            for body in drawn["bodies"]:
                body.set(facecolor=one.colour, alpha=0.5)
            low, middle, high = np.percentile(values, (25, 50, 75))
            axes.plot([place, place], [low, high], color=one.colour, lw=4)
            axes.plot(
                [place], [middle], marker=one.marker, color=one.colour, ms=8, mec="white",
                mew=1.5,
            )  # fmt: skip
        axes.set_xticks(range(len(charted)), [one.label for one in charted])
        axes.set(ylabel=f"JaC@{report.tau:g}, %", ylim=(-2, 102))

    def curves(axes: Any) -> None:
        for one, values in zip(charted, known, strict=True):
            share = 100 * (np.arange(len(values)) + 0.5) / len(values)
            places, shown = _thinned(share, np.sort(values))
            axes.plot(places, shown, **one.line)
        axes.set(xlabel="frames, %, by their JaC", ylabel=f"JaC@{report.tau:g}, %")
        axes.set(xlim=(0, 100), ylim=(-2, 102))
        axes.legend(loc="lower right", handlelength=4)

    text = (
        "Left: the bar is the middle half of the frames, the mark the median. Right: a curve above"
        " another has at every rank the better frame. Frames without a camera are left out."
    )
    panels = [Panel(violins, height_in=2.4), Panel(curves, height_in=2.4)]
    return draw_chart(9, "How the JaC of frames is distributed", text, panels)


def _thinned(places: FloatArray, ordered: FloatArray) -> tuple[FloatArray, FloatArray]:
    """A sorted curve without the places between equal values."""
    kept = np.ones(len(ordered), dtype=bool)
    kept[1:-1] = (ordered[1:-1] != ordered[:-2]) | (ordered[1:-1] != ordered[2:])
    return (places, ordered) if len(ordered) <= _MOST_PLACES else (places[kept], ordered[kept])


def _pairs(report: AuditReport, charted: list[ChartedMethod], jacs: list[FloatArray]) -> Chart:
    pairs = list(combinations(range(len(charted)), 2))[:_MAX_FRAME_PAIRS]

    def draw_both(axes: Any, i: int, j: int) -> None:
        both = ~np.isnan(jacs[i]) & ~np.isnan(jacs[j])
        values = np.stack((jacs[i][both], jacs[j][both]), axis=1)
        places, counts = np.unique(values, axis=0, return_counts=True)
        if len(places) > _MOST_MARKS:
            places, counts = np.unique(5 * np.round(values / 5), axis=0, return_counts=True)
        axes.plot((0, 100), (0, 100), color=FAINT, lw=0.8, ls=":")
        areas = _mark_areas(counts)
        for area in np.unique(areas):  # marks of one size share a path
            axes.scatter(
                *places[areas == area].T, area, color=charted[i].colour, alpha=0.55, linewidths=0,
                clip_on=False,  # most lie at the ends of the axes
            )  # fmt: skip
        axes.set(xlabel=f"{charted[i].label}, JaC %", ylabel=f"{charted[j].label}, JaC %")
        axes.set(xlim=(-3, 103), ylim=(-3, 103), aspect="equal")

    def draw_ordered(axes: Any, i: int, j: int) -> None:
        off = jacs[i] - jacs[j]
        ordered = np.sort(off[np.isfinite(off)])
        share = 100 * (np.arange(len(ordered)) + 0.5) / max(1, len(ordered))
        axes.axhline(0, color=FAINT, lw=0.8, ls=":")
        axes.plot(*_thinned(share, ordered), color=charted[i].colour, lw=1.2)
        axes.set(xlabel="frames, %, by the difference", ylabel="points", xlim=(0, 100))

    panels = [Panel(partial(draw_both, i=i, j=j), height_in=3.0) for i, j in pairs]
    panels += [
        Panel(partial(draw_ordered, i=i, j=j), f"{charted[i].label} − {charted[j].label}")
        for i, j in pairs
    ]
    cut = " The first pairs of many." if len(charted) > _MAX_FRAME_PAIRS else ""
    text = (
        f"JaC at {report.tau:g} px of the frames for which both have a camera. Scatter: a mark is a"
        " frame, a larger one several; above the dotted line the second method is better. Curves:"
        f" the differences in their order.{cut}"
    )
    return draw_chart(10, "Two methods, frame by frame", text, panels)


def _mark_areas(counts: NDArray[np.intp]) -> FloatArray:
    """Areas of marks that stand for so many frames: of a large set they would hide each other."""
    one = min(_ONE_FRAME, _LARGEST_MARK / counts.max(initial=1))
    return np.asarray(np.maximum(one * counts, _SMALLEST_MARK), dtype=np.float64)


def _timelines(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    def draw(axes: Any, one: ChartedMethod) -> None:
        jac = 100 * report.jac_of_frames(one.source)
        places = np.arange(len(jac)) + 1
        axes.plot(places, jac, color=one.colour, lw=0.7, marker=one.marker, ms=1.8)
        (missing,) = np.nonzero(np.isnan(jac))
        axes.plot(missing + 1, np.zeros(len(missing)), "x", color=INK, ms=4, mew=1)
        axes.set(ylabel=f"JaC@{report.tau:g}, %", ylim=(-4, 104), yticks=(0, 50, 100))
        axes.set(xlabel=_FRAMES, xlim=(0, len(report.frames) + 1))
        axes.locator_params(axis="x", integer=True)

    text = "A cross on the base line marks a frame without a usable camera."
    panels = [Panel(partial(draw, one=one), one.label, 1.7) for one in charted]
    return draw_chart(2, "JaC of every frame", text, panels)


def _poses(report: AuditReport, charted: list[ChartedMethod]) -> Chart:
    found = [(c, poses(report.frames, c.source.audits)) for c in charted]
    many = len(report.frames) > _MOST_IN_A_ROW
    drawable = [np.where(np.abs(over.values) < _DRAWABLE, over.values, np.nan) for _, over in found]

    def draw(axes: Any, column: int) -> None:
        for (one, _), rows in zip(found, drawable, strict=True):
            values = rows[:, column]
            if many:
                centres, low, medians, high = _stretches(values)
                axes.fill_between(centres, low, high, color=one.colour, alpha=0.25, lw=0)
                axes.plot(centres, medians, **{**one.line, "lw": 0.9})
            else:
                axes.plot(np.arange(len(values)) + 1, values, **{**one.line, "lw": 0.8})
        axes.set(ylabel=POSE_UNITS[column], xlabel=_FRAMES, xlim=(0, len(report.frames) + 1))
        if ranges[column][0] is not None:
            axes.set_ylim(ranges[column][0])
        axes.locator_params(axis="x", integer=True)
        if column == 0:
            axes.legend(loc="best", handlelength=4)

    columns = range(len(POSE_QUANTITIES))
    ranges = [inner_range([rows[:, column] for rows in drawable]) for column in columns]
    beyond = sum(count for _, count in ranges)
    without = [s.name for s in report.evaluated if not poses(report.frames, s.audits).with_pose]
    rest = f" {beyond} values beyond the 1st to 99th percentile are cut off." if beyond else ""
    rest += f" Without a pose: {', '.join(without)}." if without else ""
    summed = (
        f" Lines are medians of {_STRETCHES} stretches of the set, shaded from the least to the"
        " largest value in each."
        if many
        else ""
    )
    text = (
        "Pose and focal length (px of the evaluation size); in a sequence, a jump stands out."
        f"{summed} The height is above the ground; values over a million are left out.{rest}"
    )
    panels = [Panel(partial(draw, column=c), POSE_QUANTITIES[c], 1.8) for c in columns]
    return draw_chart(7, "Where the cameras stand and look", text, panels)


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


def jitter_chart(found: Sequence[TemporalMetrics], colours: Sequence[str]) -> Chart:
    """Jitter of every frame, a panel a method (one at least); shots one after the other."""
    values = [np.concatenate([shot.steady.px for shot in one.shots]) for one in found]
    jumps = [np.concatenate([shot.broken.unsteady for shot in one.shots]) for one in found]
    steady = [v[np.isfinite(v) & ~jump] for v, jump in zip(values, jumps, strict=True)]
    most = max([_LEAST_SPAN_PX, *(1.1 * float(np.quantile(v, 0.99)) for v in steady if len(v))])
    beyond = sum(int((v > most).sum()) for v in steady)
    ends = np.cumsum([len(shot.shot.frames) for shot in found[0].shots])[:-1]

    def draw(axes: Any, at: int) -> None:
        colour = readable_on_both_themes(colours[at % len(colours)])
        places, shown = envelope(values[at], 0, len(values[at]), _MOST_PLACES)
        axes.plot(places + 1, np.minimum(shown, most), color=colour, lw=0.9)
        (leapt,) = np.nonzero(jumps[at])
        axes.plot(leapt + 1, np.full(len(leapt), most), "v", color=INK, ms=4, mew=0)
        for end in ends:
            axes.axvline(end + 0.5, color=FAINT, lw=0.8, ls=":")
        axes.set(ylabel="jitter, px", ylim=(0, most * 1.05), xlim=(0, len(values[at]) + 1))
        axes.set_xlabel("frame of the shots, one after the other")

    cut = f" {beyond} larger values (beyond the 99th percentile) are cut off." if beyond else ""
    text = (
        "How far each frame is from where steady motion between its neighbours would have it."
        " A gap has no camera, or no neighbour with one; a triangle at the top is a frame of a"
        f" jump; dotted lines part shots ({terms_over_time(found)}, shots {found[0].told_by}).{cut}"
    )
    draws: list[Callable[[Any], None]] = [partial(draw, at=at) for at in range(len(found))]
    panels = [Panel(d, one.marked_name, 1.8) for d, one in zip(draws, found, strict=True)]
    return draw_chart(_NUMBER, "Jitter of every frame", text, panels)
