"""Charts of the frames' JaC: how it is distributed, and two sources frame by frame."""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.report.page.audit_report import AuditReport
from procc_annotator.report.page.chart_parts import ChartedMethod, chart_label, line_style
from procc_annotator.report.page.chart_svg import FAINT, Chart, draw_chart
from procc_annotator.report.page.report_tables import terms

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Floats = NDArray[np.floating[Any]]

_MAX_FRAME_PAIRS = 3  # of sources; more would fill a page
_ONE_FRAME, _SMALLEST_MARK, _LARGEST_MARK = 6.0, 2.0, 120.0  # areas, points squared


def frame_charts(report: AuditReport, charted: list[ChartedMethod]) -> list[Chart]:
    """The distribution for every source, and pairs of sources where there are several."""
    jacs: list[Floats] = [100 * report.jac_of_frames(one.source) for one in charted]
    charts = [_distribution(report, charted, jacs)]
    if len(charted) > 1:
        charts.append(_pairs(report, charted, jacs))
    return charts


def _distribution(report: AuditReport, charted: list[ChartedMethod], jacs: list[Floats]) -> Chart:
    known = [values[~np.isnan(values)] for values in jacs]

    def draw(figure: Figure) -> None:
        violins, curves = figure.subplots(1, 2)
        for place, (one, values) in enumerate(zip(charted, known, strict=True)):
            drawn = violins.violinplot([values], [place], widths=0.8, showextrema=False)
            for body in drawn["bodies"]:
                body.set(facecolor=one.look.colour, alpha=0.5)
            low, middle, high = np.percentile(values, (25, 50, 75))
            violins.plot([place, place], [low, high], color=one.look.colour, lw=4)
            violins.plot(
                [place], [middle], marker=one.look.marker, color=one.look.colour, ms=8, mec="white",
                mew=1.5,
            )  # fmt: skip
            share = 100 * (np.arange(len(values)) + 0.5) / len(values)
            curves.plot(share, np.sort(values), **line_style(one.look))
        names = [chart_label(one.look.name) for one in charted]
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


def _pairs(report: AuditReport, charted: list[ChartedMethod], jacs: list[Floats]) -> Chart:
    pairs = list(combinations(range(len(charted)), 2))[:_MAX_FRAME_PAIRS]

    def draw(figure: Figure) -> None:
        for row, (i, j) in enumerate(pairs):
            names = (
                chart_label(charted[i].source.marked_name),
                chart_label(charted[j].source.marked_name),
            )
            both = ~np.isnan(jacs[i]) & ~np.isnan(jacs[j])
            a, b = jacs[i][both], jacs[j][both]
            scatter = figure.add_subplot(len(pairs), 2, 2 * row + 1)
            places, counts = np.unique(np.stack((a, b), axis=1), axis=0, return_counts=True)
            scatter.plot((0, 100), (0, 100), color=FAINT, lw=0.8, ls=":")
            scatter.scatter(
                places[:, 0],
                places[:, 1],
                _mark_areas(counts),
                color=charted[i].look.colour,
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
            ordered.plot(share, np.sort(a - b), color=charted[i].look.colour, lw=1.2)
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


def _mark_areas(counts: NDArray[np.intp]) -> Floats:
    """Areas of marks that stand for so many frames: of a large set they would hide each other."""
    one = min(_ONE_FRAME, _LARGEST_MARK / counts.max(initial=1))
    return np.asarray(np.maximum(one * counts, _SMALLEST_MARK), dtype=np.float64)
