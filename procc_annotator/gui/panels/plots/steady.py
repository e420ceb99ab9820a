"""How steadily the cameras of each source go from frame to frame."""

from __future__ import annotations

import numpy as np

from procc_annotator.batch.audit import PlotData
from procc_annotator.batch.temporal import frame_jitter
from procc_annotator.gui.panels.plots.curves import TimelinePage, Timelines
from procc_annotator.gui.panels.plots.request import PlotRequest
from procc_annotator.translation import tr, word

_LEAST_SPAN_PX = 1.0
_NO_CAMERAS = word("No three frames in a row have a camera that goes from one to the next.")


class SteadyPage(TimelinePage):
    """Jitter of every frame under every source, with a camera or an annotation; a click shows the
    frame."""

    title = word("Jitter over the frames")
    follows_tau = False
    digits = 2

    def __init__(self) -> None:
        super().__init__("plot_steady")
        self.item.vb.setLimits(yMin=0, yMax=1e6)

    @staticmethod
    def compute(request: PlotRequest) -> Timelines:
        field = request.field
        if field is None:
            return Timelines(tuple(np.full(len(request.frames), np.nan) for _ in request.sources))
        order, _ = request.order()
        return Timelines(
            tuple(
                np.full(len(request.frames), np.nan)
                if source.cameras is None
                else frame_jitter(
                    source.cameras, request.frames, field, request.size, request.hidden, order
                ).px
                for source in request.sources
            )
        )

    def draw(self, data: Timelines, request: PlotRequest) -> str:
        known = [float(np.nanmax(v)) for v in data.values if np.isfinite(v).any()]
        self.item.setYRange(0, max([_LEAST_SPAN_PX, *known]), padding=0.06)
        super().draw(data, request)
        self.say_empty("" if known else request.why_nothing(tr(_NO_CAMERAS)))
        return tr("How far each frame is from steady motion between its neighbours.")

    def mark(self, request: PlotRequest) -> None:
        super().mark(request)
        self.item.setLabel("left", tr("jitter (px)"))

    @staticmethod
    def table(data: Timelines, request: PlotRequest) -> PlotData:
        names = (f"jitter_px {source.name}" for source in request.sources)
        numbers = np.arange(1, len(request.frames) + 1)
        return PlotData(("number", "frame", *names), (numbers, request.frames, *data.values))
