"""Charts of reprojection errors: histograms, radius, direction."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.batch.audit import bias, cell_arrows, histogram, radial_errors
from procc_annotator.field.landmarks import element_titles
from procc_annotator.report.page.chart_style import (
    FAINT,
    Chart,
    ChartedMethod,
    chart_label,
    draw_chart,
    legend_above,
    line_style,
    only_panel,
    panel_boxes,
)
from procc_annotator.report.page.report_data import AuditReport
from procc_annotator.report.page.report_tables import terms

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
        axes = only_panel(figure)
        for one, counts in zip(charted, bars.counts, strict=True):
            if counts.sum():
                axes.stairs(100 * counts / counts.sum(), bars.edges, **line_style(one.look))
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
        axes = only_panel(figure)
        for one in charted:
            found = radial_errors(one.points, report.setup.size)
            axes.plot(
                found.centres, found.medians, marker=one.look.marker, ms=3.5, **line_style(one.look)
            )
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
        figure.set_layout_engine(None)
        boxes = panel_boxes(
            figure.get_size_inches(), height, columns, between_in=0.3, top_in=0.45, bottom_in=0.5
        )
        grid = PanelGrid(figure, boxes[: len(rows)], columns, (float(coarse[-1]), 1.05 * highest))
        grid.draw_axes()
        for panel, row in enumerate(rows):
            grid.title(panel, _short(names[row]))
        for one, places, share in shares:
            grid.stairs(places, share, coarse, **{**line_style(one.look), "lw": 0.9})
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


def _class_shares(one: ChartedMethod, rows: list[int], edges: Floats) -> tuple[list[int], Floats]:
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
    arrows = {c.look.name: cell_arrows(c.points, size) for c in charted}
    lengths = np.concatenate([np.hypot(*a.vectors_px.T) for a in arrows.values()])
    longest = float(np.percentile(lengths, 95)) if len(lengths) else 1.0

    def draw(figure: Figure) -> None:
        figure.set_layout_engine(None)
        for i, one in enumerate(charted):
            bottom = 1 - (i + 0.88) / len(charted)
            high = 0.68 / len(charted)
            box = np.array((0.03, bottom, 0.3, high)) * np.tile(figure.get_size_inches(), 2)
            _rose(figure, box, one)
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
            axes.set_title(f"{chart_label(one.look.name)}: median residual of each cell", y=1.0)
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


def _rose(figure: Figure, box_in: Floats, one: ChartedMethod) -> None:
    """The shares of directions in a box (left, bottom, width, height), inches, and the bias above:
    as axes with polar coordinates show them, which take thirty times as long."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path
    from matplotlib.transforms import Affine2D

    radius = float(min(box_in[2:])) / 2
    centre = box_in[:2] + box_in[2:] / 2
    place = Affine2D().scale(radius).translate(*centre) + figure.dpi_scale_trans
    cross = Path(((-1, 0), (1, 0), (0, -1), (0, 1)), (Path.MOVETO, Path.LINETO) * 2)
    half = 0.45 * 360 / _SECTORS
    wedges = [
        Path.wedge(at - half, at + half).transformed(Affine2D().scale(reach))
        for at, reach in zip(np.arange(_SECTORS) * 360 / _SECTORS, _reaches(one), strict=True)
        if reach
    ]
    line: dict[str, Any] = {"fill": False, "edgecolor": FAINT}
    figure.add_artist(PathPatch(cross, transform=place, lw=0.5, alpha=0.3, **line))
    if wedges:
        bars = Path.make_compound_path(*wedges)
        look: dict[str, Any] = {"facecolor": one.look.colour, "alpha": 0.75, "lw": 0}
        figure.add_artist(PathPatch(bars, transform=place, **look))
    figure.add_artist(PathPatch(Path.unit_circle(), transform=place, lw=0.6, **line))
    for text, (x, y), ha, va in _SIDES:
        at = centre + radius * np.array((x, y)) + np.array((x * 8, y * 10)) / 72
        figure.text(
            at[0], at[1], text, transform=figure.dpi_scale_trans, fontsize=6.5, ha=ha, va=va
        )
    lean = bias(one.points)
    if lean is not None:
        across, along = lean
        sides = (f"{abs(across):.2f} {'right' if across >= 0 else 'left'}",
                 f"{abs(along):.2f} {'down' if along >= 0 else 'up'}")  # fmt: skip
        figure.text(
            centre[0] - radius,
            centre[1] + radius + 23 / 72,
            f"{chart_label(one.look.name)}: bias {', '.join(sides)} px",
            transform=figure.dpi_scale_trans,
            fontsize=7.5,
        )


_SIDES = (
    ("right", (1, 0), "left", "center"),
    ("up", (0, 1), "center", "bottom"),
    ("left", (-1, 0), "right", "center"),
    ("down", (0, -1), "center", "top"),
)


def _reaches(one: ChartedMethod) -> Floats:
    """Return how far the bar of each sector reaches, shares of the radius; the first one is to the
    right, the others follow anticlockwise."""
    residuals = one.points.residuals_px
    # The picture's y points down, that of a rose up.
    angles = np.arctan2(-residuals[:, 1], residuals[:, 0]) % (2 * math.pi)
    width = 2 * math.pi / _SECTORS
    sector = np.floor(angles / width + 0.5).astype(np.intp) % _SECTORS
    counts = np.bincount(sector, minlength=_SECTORS)
    return np.asarray(counts / (1.05 * max(1, counts.max())))


def _short(title: str) -> str:
    return title if len(title) <= 26 else f"{title[:25]}…"
