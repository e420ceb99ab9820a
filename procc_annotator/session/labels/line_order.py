"""In which order the lines that share a label are in a picture, told by a homography of the ground.

Every point of a line says l^T G p = 0, with l the line on the ground and G the homography picture
-> ground, so that G follows from eight of them by a singular value decomposition (R. Hartley and
A. Zisserman, Multiple View Geometry, section 4.1, with points on lines in the place of points).
Every order is tried, and the one that all frames fit best is taken.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import permutations, product

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.geometry import Line
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.label_map import LEFT_TO_RIGHT, TOP_DOWN, OrderedClasses, Rule
from procc_annotator.session.labels.label_shapes import LabelledFrame, Points, middle

FloatArray = NDArray[np.float64]
_MOST_ORDERS = 3000
_MOST_FRAMES = 16
_FEWEST_EQUATIONS = 9  # one more than determine a homography: an order can be wrong
_FEWEST_LINES = 5
_LARGEST_FAMILY = 4
_FITS = 0.005  # of the picture's width: points are on their lines, as well as lenses let them
_CAPPED = 0.02  # of the picture's width: a frame where no order fits decides nothing


@dataclass(frozen=True, slots=True)
class LineOrders:
    """The orders of labels that lines share.

    Attributes:
        rules: label -> its classes in their order; empty where nothing tells it.
        fitting: frames whose points are on their lines with these orders.
        frames: that were tried.
    """

    rules: Mapping[str, OrderedClasses]
    fitting: int = 0
    frames: int = 0


def find_orders(
    frames: Sequence[LabelledFrame],
    alone: Mapping[str, str],
    families: Mapping[str, Sequence[str]],
    field: Field,
) -> LineOrders:
    """Find the order of the shapes of labels that several lines share.

    Args:
        frames: of the set.
        alone: label -> the one class it stands for.
        families: label -> the classes it stands for, straight and on the ground.
        field: the elements, metres.
    """
    lines = _lines(field)
    usable = all(len(s) <= _LARGEST_FAMILY and lines.keys() >= set(s) for s in families.values())
    told = [frame for frame in frames if _is_whole(frame, families)]
    if not families or not usable or not told:
        return LineOrders({})
    told.sort(key=lambda frame: -sum(map(len, frame.shapes.values())))
    told = told[:: max(1, len(told) // _MOST_FRAMES)][:_MOST_FRAMES]
    choices = [
        [OrderedClasses(way, names) for way in _ways(told, label) for names in permutations(some)]
        for label, some in families.items()
    ]
    if math.prod(map(len, choices)) > _MOST_ORDERS:
        return LineOrders({})
    best = (math.inf, LineOrders({}))
    for chosen in product(*choices):
        rules = dict(zip(families, chosen, strict=True))
        offs = [_off(_labelled(frame, rules, alone), frame, lines) for frame in told]
        known = [off for off in offs if off is not None]
        off = round(float(np.mean(known)), 9) if known else math.inf
        if off < best[0]:
            best = off, LineOrders(rules, sum(off < _FITS for off in known), len(known))
    return replace(best[1], rules=_first_rotated(best[1].rules, alone, field))


def _first_rotated(
    rules: Mapping[str, OrderedClasses], alone: Mapping[str, str], field: Field
) -> Mapping[str, OrderedClasses]:
    """Of orders that are as good on the turned field those whose classes come first in it: a set
    that is looked at again, or in parts, gets the same ones."""

    def place(some: Mapping[str, OrderedClasses]) -> list[list[int]]:
        return [[field.index[n] for n in some[label].classes] for label in sorted(some)]

    turned = [
        {
            label: replace(rule, classes=tuple(turn.name_of(name) for name in rule.classes))
            for label, rule in rules.items()
        }
        for turn in field.symmetries
        if all(turn.name_of(name) == name for name in alone.values())
    ]
    return min((rules, *turned), key=place)


def _lines(field: Field) -> dict[str, FloatArray]:
    """Straight elements of the ground as (3,) lines, in units of its half length."""
    half = max(
        (
            abs(v)
            for e in field.elements
            if isinstance(e.geometry, Line)
            for v in (*e.geometry.start[:2], *e.geometry.end[:2])
        ),
        default=0.0,
    )
    if not half:
        return {}
    found = {}
    for element in field.elements:
        shape = element.geometry
        if isinstance(shape, Line) and element.on_ground:
            a, b = (np.array([x / half, y / half, 1.0]) for x, y, _ in (shape.start, shape.end))
            line = np.cross(a, b)
            found[element.name] = line / np.linalg.norm(line[:2])
    return found


def _is_whole(frame: LabelledFrame, families: Mapping[str, Sequence[str]]) -> bool:
    return all(len(frame.shapes.get(label, ())) == len(some) for label, some in families.items())


def _ways(frames: Sequence[LabelledFrame], label: str) -> list[str]:
    """The ways of ordering shapes, the one first in which they are always farther apart."""
    apart = [
        np.ptp([middle(points) for points in frame.shapes[label]], axis=0) * np.array(frame.size)
        for frame in frames
    ]
    across, down = np.min(apart, axis=0)
    return [LEFT_TO_RIGHT, TOP_DOWN] if across > down else [TOP_DOWN, LEFT_TO_RIGHT]


def _labelled(
    frame: LabelledFrame, rules: Mapping[str, Rule], alone: Mapping[str, str]
) -> list[tuple[str, Points]]:
    found = [(p.class_name, p.points) for p in frame.known.polylines]
    for label, shapes in frame.shapes.items():
        rule = rules.get(label, alone.get(label))
        if isinstance(rule, OrderedClasses):
            axis = 0 if rule.order == LEFT_TO_RIGHT else 1
            ordered = sorted(shapes, key=lambda points: middle(points)[axis])
            found += zip(rule.classes, ordered, strict=True)
        elif isinstance(rule, str) and len(shapes) == 1:
            found.append((rule, shapes[0]))
    return found


def _off(
    shapes: Sequence[tuple[str, Points]], frame: LabelledFrame, lines: Mapping[str, FloatArray]
) -> float | None:
    """How far the points of a frame are from their lines under the homography that fits them best,
    as a share of the picture's width; None where they determine none."""
    used = [(lines[name], points) for name, points in shapes if name in lines]
    rows = np.array([line for line, points in used for _ in points])
    if len(used) < _FEWEST_LINES or len(rows) < _FEWEST_EQUATIONS:
        return None
    aspect = (frame.size[1] - 1) / (frame.size[0] - 1)
    px = np.array([(p.u, p.v * aspect, 1.0) for _, points in used for p in points])
    shift = px[:, :2].mean(axis=0)
    scale = float(np.abs(px[:, :2] - shift).mean()) or 1.0
    px[:, :2] = (px[:, :2] - shift) / scale
    equations = np.einsum("ni,nj->nij", rows, px).reshape(-1, 9)
    _, sizes, axes = np.linalg.svd(equations)
    if sizes[-2] < 1e-9 * sizes[0]:
        return None
    ground_from_image = axes[-1].reshape(3, 3)
    in_front = np.sign(px @ ground_from_image[2])
    side = 1.0 if in_front.sum() >= 0 else -1.0
    # Behind the camera, or seen from below: no camera shows the field so.
    if np.mean(in_front == side) < 0.8 or np.linalg.det(ground_from_image) * side < 0:
        return _CAPPED
    shown = rows @ ground_from_image
    norms = np.linalg.norm(shown[:, :2], axis=1)
    away = np.abs(np.sum(shown * px, axis=1)) / np.maximum(norms, 1e-12) * scale
    return float(min(np.mean(away), _CAPPED))
