"""Everything of a field that has paint a finder can look for, as places along it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from procc_annotator.field.appearance import BAR, DARKER, LIGHTER, LINE
from procc_annotator.field.geometry import (
    Line,
    Part,
    Spot,
    angles_of,
    points_at_angles,
    outline_of,
    parts_of,
)
from procc_annotator.field.model import Element, Field
from procc_annotator.field.paint import marking_normal
from procc_annotator.fit.solving.observations import FloatArray, IntArray

# Between two places, of half the field's length; curves turn by this much at most.
_SPACING_SHARE = 0.004
_MAX_STEP_RAD = 0.05
_TONE_SIGNS = {LIGHTER: 1, DARKER: -1}


@dataclass(frozen=True, eq=False)
class MarkingPoints:
    """N places in the middle of the paint of E elements.

    Attributes:
        names: (E,) classes, those of the field that are painted lines or bars.
        world: (3, N) metres.
        along: (3, N) unit vectors along the element.
        across: (3, N) unit vectors across it, in the plane of the paint; 0 for bars, which show
            their diameter to everybody.
        element: (N,) index in ``names``.
        run: (N,) which smooth part of an element it is on, ascending.
        width_m: (N,) of the band, or diameter of the bar; 0 where nobody knows.
        tone: (N,) 1 for paint lighter than what is beside it, -1 for darker, 0 where either may be.
    """

    names: tuple[str, ...]
    world: FloatArray
    along: FloatArray
    across: FloatArray
    element: IntArray
    run: IntArray
    width_m: FloatArray
    tone: IntArray


def marking_points(field: Field) -> MarkingPoints:
    """The places of a field's paint.

    Args:
        field: its elements are taken for the middle of their paint, as they are where clicks are
            put there: whoever wants them where they are painted asks for ``lines = middle``.
    """
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
        return MarkingPoints((), nothing, nothing, nothing, rows, rows, np.zeros(0), rows)
    element_of = np.repeat(owners, counts)
    return MarkingPoints(
        tuple(e.name for e in sought),
        np.concatenate(world).T.copy(),
        np.concatenate(along).T.copy(),
        np.concatenate(across).T.copy(),
        element_of,
        np.repeat(np.arange(len(counts)), counts),
        np.array([e.appearance.width_m for e in sought])[element_of],
        np.array([_TONE_SIGNS.get(e.appearance.tone, 0) for e in sought], dtype=np.intp)[element_of],
    )


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
