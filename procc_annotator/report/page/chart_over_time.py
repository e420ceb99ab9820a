"""Charts of sources over time: jitter frame by frame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from procc_annotator.report.over_time import TemporalMetrics, terms_over_time
from procc_annotator.report.page.chart_parts import chart_label, readable_on_both_themes, panels
from procc_annotator.report.page.chart_svg import FAINT, INK, Chart, draw_chart
from procc_annotator.session.runs.audit_figures import envelope

if TYPE_CHECKING:
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
        rows = panels(figure, len(found), between_in=0.26)
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
