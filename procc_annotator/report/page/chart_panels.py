"""Many small panels with the same axes as a few long paths: an axes object each takes seconds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.report.page.chart_svg import FAINT

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Floats = NDArray[np.floating[Any]]

_LABEL_SIZE = 6.5
_TICK_IN = 3.5 / 72
_MOST_TICKS = 9


@dataclass(frozen=True, eq=False)
class PanelGrid:
    """Panels row by row, without the places left empty at the end.

    Attributes:
        figure: that they are drawn on.
        boxes: (N, 4) left, bottom, width and height of each, inches.
        columns: of panels.
        highest: the largest x and y; the smallest are 0.
    """

    figure: Figure
    boxes: Floats
    columns: int
    highest: tuple[float, float]

    def draw_axes(self) -> None:
        """Grid, axes, ticks; their labels on the left and at the bottom of all panels."""
        lefts, bottoms, widths, heights = self.boxes.T
        for along, (starts, lengths, others, other_lengths) in enumerate(
            ((lefts, widths, bottoms, heights), (bottoms, heights, lefts, widths))
        ):
            length_in = float(lengths[0])
            ticks, labels = _ticks(self.highest[along], length_in, 3 if along == 0 else 2)
            at = starts[:, None] + lengths[:, None] * ticks / self.highest[along]
            low, high = others[:, None], (others + other_lengths)[:, None]
            self._strokes(_across(at, low, high, along), lw=0.5, alpha=0.3, zorder=0.5)
            self._strokes(_across(at, low, low - _TICK_IN, along), lw=0.6, zorder=0.6)
            self._strokes(
                _across(low, starts[:, None], (starts + lengths)[:, None], 1 - along),
                lw=0.6, capstyle="projecting", zorder=2.5,
            )  # fmt: skip
            for i in range(len(self.boxes)):
                if i % self.columns == 0 if along else i + self.columns >= len(self.boxes):
                    self._label(at[i], others[i] - 2 * _TICK_IN, labels, along)

    def stairs(self, panels: list[int], values: Floats, edges: Floats, **style: Any) -> None:
        """A stepped line on each of some panels.

        Args:
            panels: their places.
            values: (panels, bars). edges: (bars + 1,).
            style: as matplotlib has it.
        """
        ends = np.zeros((len(values), 1))
        y = np.hstack((ends, np.repeat(values, 2, axis=1), ends))
        x = np.broadcast_to(np.repeat(edges, 2), y.shape)
        lower, sizes = self.boxes[panels, None, :2], self.boxes[panels, None, 2:]
        self._strokes(lower + sizes * np.stack((x, y), axis=-1) / self.highest, **style)

    def title(self, panel: int, text: str) -> None:
        """A title above a panel."""
        left, bottom, _, height = self.boxes[panel]
        self._text(left, bottom + height + 2 / 72, text, fontsize=7)

    def _label(self, at: Floats, beside: float, labels: list[str], along: int) -> None:
        for place, text in zip(at, labels, strict=True):
            if along:
                self._text(beside, place, text, ha="right", va="center_baseline")
            else:
                self._text(place, beside, text, ha="center", va="top")

    def _text(self, x: float, y: float, text: str, **style: Any) -> None:
        transform = self.figure.dpi_scale_trans
        self.figure.text(x, y, text, transform=transform, **{"fontsize": _LABEL_SIZE, **style})

    def _strokes(self, lines: Floats, **style: Any) -> None:
        """Lines (N, points, 2) in inches as one path."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        one = [Path.MOVETO, *[Path.LINETO] * (lines.shape[1] - 1)]
        path = Path(lines.reshape(-1, 2), np.tile(one, len(lines)))
        look = {"color": FAINT, "fill": False, **style}
        self.figure.add_artist(PathPatch(path, transform=self.figure.dpi_scale_trans, **look))


def _across(at: Floats, low: Floats, high: Floats, along: int) -> Floats:
    """Straight lines (N, 2, 2) at places of one axis (0 is x), from low to high of the other."""
    at, low, high = np.broadcast_arrays(at, low, high)
    ends = np.stack((np.stack((at, low), -1), np.stack((at, high), -1)), -2).reshape(-1, 2, 2)
    return ends[..., ::-1] if along else ends


def _ticks(highest: float, length_in: float, widths: int) -> tuple[Floats, list[str]]:
    """Places and labels as matplotlib chooses them; a label needs so many widths of its letters."""
    from matplotlib.ticker import MaxNLocator, ScalarFormatter

    space = int(72 * length_in / (_LABEL_SIZE * widths))
    most = max(1, min(space, _MOST_TICKS))
    found = np.asarray(MaxNLocator(most, steps=[1, 2, 2.5, 5, 10]).tick_values(0, highest))
    places = found[(found >= 0) & (found <= highest * (1 + 1e-9))]
    formatter: Any = ScalarFormatter()
    formatter.create_dummy_axis()
    formatter.axis.set_view_interval(0, highest)
    return places, formatter.format_ticks(places)
