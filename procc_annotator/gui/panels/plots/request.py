"""What to plot: which sources, of which frames, on which terms."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from procc_annotator.batch.audit import FrameAudit
from procc_annotator.batch.grouping import FrameOrder
from procc_annotator.errors import InputError
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts
from procc_annotator.translation import tr

Scope = Literal["frame", "set"]


@dataclass(frozen=True, eq=False)
class PlottedSource:
    """A camera source as plots know it.

    Attributes:
        name, colour: as everywhere in the window; the colour as "#rrggbb".
        number: its place among all sources, which gives its dashes and its symbol.
        audits: by frame name; only of frames that may be shown.
        active: whether it is the one that is judged.
        fitted: whether they were fitted to the clicks they are judged by.
    """

    name: str
    colour: str
    number: int
    audits: Mapping[str, FrameAudit]
    active: bool = False
    fitted: FitCounts = NOT_FITTED


@dataclass(frozen=True, eq=False)
class PlotRequest:
    """What to plot.

    Attributes:
        sources: the visible ones.
        frames: names of all frames of the dataset, in its order.
        current: position of the frame on screen, -1 without one.
        scope: the frame on screen, or all of them.
        class_row: only points of this class of the field; None for all.
        tau: px.
        size: of the evaluation, px.
        titles: of the classes, by row of the field.
        blind: whether blind mode hides frames of the scope.
        order_file: the dataset's table of frames, if it has one.
    """

    sources: tuple[PlottedSource, ...]
    frames: tuple[str, ...]
    current: int
    scope: Scope
    class_row: int | None
    tau: float
    size: tuple[int, int]
    titles: tuple[str, ...] = ()
    blind: bool = False
    order_file: Path | None = None

    def order(self) -> tuple[FrameOrder | None, str]:
        """The dataset's table of frames, read anew (not on the interface's thread), and what is
        wrong with it, if it cannot be used."""
        if self.order_file is None or not self.order_file.is_file():
            return None, ""
        try:
            return FrameOrder.read(self.order_file), ""
        except InputError as error:
            return None, tr("Shots are told by names, since {error}.", error=error)

    def why_nothing(self, otherwise: str) -> str:
        """Why there is nothing to plot: blind mode, or what else a page says."""
        if not self.blind:
            return otherwise
        if self.scope == "frame":
            return tr("Hidden: blind mode shows this plot once this frame is committed.")
        return tr(
            "Hidden: blind mode shows committed frames only, and none of them is in this plot."
        )

    def audits(self, source: PlottedSource) -> list[FrameAudit]:
        """Return what the scope holds of a source, in the order of the frames."""
        if self.scope == "frame":
            name = self.frames[self.current] if self.current >= 0 else ""
            found = source.audits.get(name)
            return [] if found is None else [found]
        return [source.audits[name] for name in self.frames if name in source.audits]
