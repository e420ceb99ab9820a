"""Points along the line markings of a field, and where a camera projects them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.projection import Lens, project, project_visible
from procc_annotator.field.geometry import (
    Line,
    Part,
    Spot,
    angles_of,
    outline_of,
    parts_of,
    points_at_angles,
)
from procc_annotator.field.markings import marking_normal
from procc_annotator.field.model import ANY, BAR, DARKER, LIGHTER, LINE, Element, Field

# Between two places, of half the field's length; curves turn by this much at most.
_SPACING_SHARE = 0.004
_MAX_STEP_RAD = 0.05
_TONE_SIGNS = {LIGHTER: 1, DARKER: -1}


@dataclass(frozen=True, eq=False)
class MarkingPoints:
    """N places in the middle of the paint of E elements.

    Attributes:
        names: (E,) classes, those of the field that are painted lines or bars.
        titles: (E,) of these, shown to people.
        world: (3, N) metres.
        along: (3, N) unit vectors along the element.
        across: (3, N) unit vectors across it, in the plane of the paint; 0 for bars, which show
            their diameter to everybody.
        element: (N,) index in ``names``.
        run: (N,) which smooth part of an element it is on, ascending.
        width_m: (N,) of the band, or diameter of the bar; 0 if unknown.
        tone: (N,) 1 for paint lighter than what is next to it, -1 for darker, 0 where either may
            be.
        required: (E,) whether paint that is not found is missing. Not that of optional elements,
            nor of bars of any tone: what stands before a crowd is often not seen.
    """

    names: tuple[str, ...]
    titles: tuple[str, ...]
    world: FloatArray
    along: FloatArray
    across: FloatArray
    element: IntArray
    run: IntArray
    width_m: FloatArray
    tone: IntArray
    required: NDArray[np.bool_]


def marking_points(field: Field) -> MarkingPoints:
    """The places of a field's paint. Its elements are taken for the middle of their paint, as they
    are where clicks are put there: for where they are painted, use ``lines = middle``."""
    return _marking_points(field.elements)


@lru_cache(maxsize=8)
def _marking_points(elements: tuple[Element, ...]) -> MarkingPoints:
    sought = [e for e in elements if e.appearance.kind in (LINE, BAR) and not e.is_spot]
    reach = max((float(np.abs(outline_of(e.geometry)).max()) for e in sought), default=1.0)
    world, along, across, counts, owners = [], [], [], [], []
    for number, element in enumerate(sought):
        normal = None if element.appearance.kind == BAR else marking_normal(element)
        for part in _marking_parts(element):
            places, ways = _points_along(part, _SPACING_SHARE * reach)
            world.append(places)
            along.append(ways)
            across.append(np.zeros_like(ways) if normal is None else np.cross(normal, ways))
            counts.append(len(places))
            owners.append(number)
    if not sought:
        nothing = np.zeros((3, 0))
        rows = np.zeros(0, dtype=np.intp)
        none_required = np.zeros(0, dtype=bool)
        return MarkingPoints(
            (), (), nothing, nothing, nothing, rows, rows, np.zeros(0), rows, none_required
        )
    element_of = np.repeat(owners, counts)
    return MarkingPoints(
        tuple(e.name for e in sought),
        tuple(e.title for e in sought),
        np.concatenate(world).T.copy(),
        np.concatenate(along).T.copy(),
        np.concatenate(across).T.copy(),
        element_of,
        np.repeat(np.arange(len(counts)), counts),
        np.array([e.appearance.width_m for e in sought])[element_of],
        np.array([_TONE_SIGNS.get(e.appearance.tone, 0) for e in sought], dtype=np.intp)[
            element_of
        ],
        np.array([_is_required(e) for e in sought], dtype=bool),
    )


def _is_required(element: Element) -> bool:
    looks = element.appearance
    return not element.optional and (looks.kind != BAR or looks.tone != ANY)


def _marking_parts(element: Element) -> list[Part]:
    return [part for part in parts_of(element.geometry) if not isinstance(part, Spot)]


def _points_along(part: Part, spacing_m: float) -> tuple[FloatArray, FloatArray]:
    """(n, 3) metres along a part, and (n, 3) unit vectors along it there."""
    if isinstance(part, Spot):
        raise TypeError("a spot has no course")
    if isinstance(part, Line):
        start, end = np.array(part.start), np.array(part.end)
        length = float(np.linalg.norm(end - start))
        shares = np.linspace(0.0, 1.0, max(2, int(np.ceil(length / spacing_m)) + 1))[:, None]
        places = start + shares * (end - start)
        return places, np.broadcast_to((end - start) / length, places.shape)
    first, last = angles_of(part)
    step = min(spacing_m / part.radius, _MAX_STEP_RAD)
    angles = np.linspace(first, last, max(3, int(np.ceil((last - first) / step)) + 1))
    ahead, aside = np.array(part.ahead), np.array(part.aside)
    ways = -np.sin(angles)[:, None] * ahead + np.cos(angles)[:, None] * aside
    return points_at_angles(part, angles), ways


_IMAGE_MARGIN_PX = 3.0  # a cut any nearer to the picture's edge has but one flank


@dataclass(frozen=True, eq=False)
class ExpectedLinePoints:
    """n places where paint should be.

    Attributes:
        rows: (n,) of `MarkingPoints`.
        px: (2, n) solver px.
        normal: (2, n) unit vectors across the element in the picture.
        width_px: (n,) solver px of the band, across it; 0 if unknown.
        run: (n,) which unbroken stretch in sight it is on, ascending.
        length_px: (n,) solver px of the stretch that a place stands for.
    """

    rows: IntArray
    px: FloatArray
    normal: FloatArray
    width_px: FloatArray
    run: IntArray
    length_px: FloatArray

    def chosen(self, places: IntArray) -> ExpectedLinePoints:
        """Some of them, in order."""
        return ExpectedLinePoints(
            self.rows[places],
            self.px[:, places],
            self.normal[:, places],
            self.width_px[places],
            self.run[places],
            self.length_px[places],
        )


def expected_line_points(
    vector: FloatArray, painted: MarkingPoints, frame: ImageFrame, spacing_px: float
) -> ExpectedLinePoints:
    """Return what of the paint a camera (11,) has in its picture, ``spacing_px`` solver px apart;
    where the paint's places are farther apart, those are taken."""
    lens = Lens.of(vector[None], frame.half_diagonal)
    px, shown = (one[0] for one in project_visible(lens, painted.world))
    limit = (np.array(frame.size)[:, None] - 1) / 2 * frame.scale - _IMAGE_MARGIN_PX
    inside = np.flatnonzero(shown & (np.abs(px) <= limit).all(axis=0))
    if not len(inside):
        nothing = np.zeros((2, 0))
        return ExpectedLinePoints(inside, nothing, nothing, np.zeros(0), inside, np.zeros(0))
    seen = px[:, inside]
    begins = np.empty(len(inside), dtype=bool)
    begins[0] = True
    begins[1:] = (np.diff(inside) > 1) | (np.diff(painted.run[inside]) > 0)
    steps = np.zeros(len(inside))
    steps[1:] = np.hypot(*np.diff(seen, axis=1))
    steps[begins] = 0.0
    run = np.cumsum(begins) - 1
    gone = np.cumsum(steps)
    within = np.floor((gone - gone[np.flatnonzero(begins)][run]) / spacing_px)
    kept = begins | (np.diff(within, prepend=-1.0) > 0)
    rows, chosen = inside[kept], run[kept]
    normal, width = _normals_and_widths(lens, painted, rows)
    length = np.diff(gone[kept], append=gone[-1])
    length[np.diff(chosen, append=-1) != 0] = spacing_px
    return ExpectedLinePoints(rows, seen[:, kept], normal, width, chosen, length)


def _normals_and_widths(
    lens: Lens, painted: MarkingPoints, rows: IntArray
) -> tuple[FloatArray, FloatArray]:
    """(2, n) unit normals in the picture, and (n,) solver px of the bands' widths."""
    world = painted.world[None][:, :, rows]
    along = project(lens, world, painted.along[None][:, :, rows], 0)[1][0]
    along /= np.maximum(np.hypot(*along), 1e-12)
    normal = np.stack([-along[1], along[0]])
    across = painted.across[:, rows]
    aside = np.abs((project(lens, world, across[None], 0)[1][0] * normal).sum(axis=0))
    depth = lens.linear[0, 2, :3] @ world[0] + lens.linear[0, 2, 3]
    scale = np.where(across.any(axis=0), aside, lens.focal / depth)
    return normal, painted.width_m[rows] * scale
