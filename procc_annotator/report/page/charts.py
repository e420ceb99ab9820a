"""The charts of a report: JaC over tau and over the frames, errors, poses."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from procc_annotator.metric.chance.bands import CurveBand
from procc_annotator.metric.polylines import BoolArray
from procc_annotator.report.page.audit_report import AuditReport
from procc_annotator.report.page.chart_errors import error_charts
from procc_annotator.report.page.chart_frames import frame_charts
from procc_annotator.report.page.chart_parts import (
    ChartedMethod,
    chart_label,
    charted_sources,
    legend_above,
    line_style,
    readable_on_both_themes,
    only_panel,
    panels,
)
from procc_annotator.report.page.chart_svg import FAINT, INK, Chart, draw_chart
from procc_annotator.report.page.report_tables import terms
from procc_annotator.session.runs.audit import TAU_GRID
from procc_annotator.session.runs.audit_figures import (
    POSE_QUANTITIES,
    POSE_UNITS,
    FloatArray,
    mean_curve,
    poses,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

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
        axes = only_panel(figure)
        shown = _LARGEST_TAU >= TAU_GRID
        places = {source.name: at for at, source in enumerate(report.evaluated)}
        for one in charted:
            curve = mean_curve(list(one.source.audits.values()))
            axes.plot(TAU_GRID[shown], 100 * curve[shown], **line_style(one.look))
            band = report.certainty.curve(places[one.source.name])
            _shade(axes, band, shown, one.look.colour)
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
    """JaC of every two sources, one less the other, over tau."""
    names = [source.marked_name for source in report.evaluated]
    pairs = report.certainty.pairs[:_MOST_PAIRS]
    shown = _LARGEST_TAU >= TAU_GRID

    def draw(figure: Figure) -> None:
        rows = panels(figure, len(pairs), between_in=0.26)
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
        rows = panels(figure, len(charted), between_in=0.26)
        for axes, one in zip(rows, charted, strict=True):
            jac = 100 * report.jac_of_frames(one.source)
            places = np.arange(len(jac)) + 1
            axes.plot(places, jac, color=one.look.colour, lw=0.7, marker=one.look.marker, ms=1.8)
            (missing,) = np.nonzero(np.isnan(jac))
            axes.plot(missing + 1, np.zeros(len(missing)), "x", color=INK, ms=4, mew=1)
            axes.set_title(chart_label(one.look.name), y=1.0)
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
                    axes.fill_between(centres, low, high, color=one.look.colour, alpha=0.25, lw=0)
                    axes.plot(centres, medians, **{**line_style(one.look), "lw": 0.9})
                else:
                    places = np.arange(len(values)) + 1
                    axes.plot(places, values, **{**line_style(one.look), "lw": 0.8})
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
