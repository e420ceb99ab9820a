"""Match shapes with unknown labels to field elements by cameras and by line order."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import permutations, product

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.dataset.camera_set import FrameCameras
from procc_annotator.errors import CameraError
from procc_annotator.field.geometry import Line
from procc_annotator.field.model import Element, Field
from procc_annotator.formats.annotations.label_map import (
    LEFT_TO_RIGHT,
    ORDERS,
    TOP_DOWN,
    LabelMap,
    OrderedClasses,
    Rule,
)
from procc_annotator.formats.annotations.registry import ReadSet
from procc_annotator.metrics.measurement import measure_projected
from procc_annotator.metrics.projection import ProjectedField, project_field
from procc_annotator.metrics.setup import EvaluationSetup

_COPY = re.compile(r"(.*) \(\d{1,4}\)", re.DOTALL)
_USUAL_SIZE = (960, 540)  # of pictures whose size nobody knows

Points = tuple[Point, ...]


@dataclass(frozen=True)
class LabelledFrame:
    """A frame with shapes that no one here knows the classes of.

    Attributes:
        size: (width, height) px of its picture.
        shapes: label -> the shapes that have it, in the order of the file; normalised points.
        known: what has a class of the field.
    """

    name: str
    size: tuple[int, int]
    shapes: dict[str, tuple[Points, ...]]
    known: FrameAnnotation


@dataclass(frozen=True, slots=True)
class LabelCount:
    """Number of occurrences of a label.

    Attributes:
        shapes: with it in the set.
        copies: in a frame, as most of those have it.
    """

    label: str
    shapes: int
    copies: int


def labelled_frames(found: ReadSet, field: Field) -> list[LabelledFrame]:
    """The frames of a set that was read without a map, for a field."""
    frames = []
    for frame in found.frames.values():
        shapes: dict[str, list[Points]] = {}
        known: list[Polyline] = []
        for polyline in frame.annotation.polylines:
            if field.knows(polyline.class_name):
                known.append(polyline)
            elif polyline.points:
                label = _label_of(polyline.class_name, found)
                shapes.setdefault(label, []).append(polyline.points)
        kept = {label: tuple(some) for label, some in shapes.items()}
        size = frame.size or _USUAL_SIZE
        frames.append(LabelledFrame(frame.name, size, kept, FrameAnnotation(tuple(known))))
    return frames


def _label_of(name: str, found: ReadSet) -> str:
    copy = _COPY.fullmatch(name)
    own = name.strip() in found.unknown
    return copy[1].strip() if copy and not own else name.strip()


def label_counts(frames: Sequence[LabelledFrame]) -> list[LabelCount]:
    """Return how often each label occurs, the most frequent first."""
    copies: dict[str, Counter[int]] = {}
    for frame in frames:
        for label, shapes in frame.shapes.items():
            copies.setdefault(label, Counter())[len(shapes)] += 1
    counts = [
        LabelCount(label, sum(n * k for n, k in some.items()), _usual(some))
        for label, some in copies.items()
    ]
    return sorted(counts, key=lambda count: -count.shapes)


def _usual(counts: Counter[int]) -> int:
    return max(counts, key=lambda n: (counts[n], n))


def middle(points: Sequence[Point]) -> tuple[float, float]:
    """The middle of a shape's extent, normalised."""
    us, vs = [p.u for p in points], [p.v for p in points]
    return (min(us) + max(us)) / 2, (min(vs) + max(vs)) / 2


_WIDTH = 960
_ON_PX = 8.0  # at this width: as far as clicks of somebody else may be beside an element
# Two or three points along a straight line lie on many a curve as well.
_POINTS_OF_A_CURVE = 4

CameraOf = Callable[[LabelledFrame, tuple[int, int]], CameraOrProjections | None]


@dataclass(frozen=True)
class LabelPlaces:
    """Places of the shapes of a label.

    Attributes:
        on: class -> how many shapes lie on it, and on nothing nearer.
        shapes: that were examined.
        orders: each order -> how many frames have their shapes on these classes in it.
        frames: that have a camera.
    """

    on: Counter[str]
    shapes: int
    orders: Counter[OrderedClasses]
    frames: int

    @classmethod
    def none(cls) -> LabelPlaces:
        """Of a label that no camera was there for."""
        return cls(Counter(), 0, Counter(), 0)


def evaluation_size(frame: LabelledFrame) -> tuple[int, int]:
    """(width, height) px at which cameras are asked, in the shape of the picture."""
    return _WIDTH, max(2, round(_WIDTH * frame.size[1] / frame.size[0]))


def find_places(
    frames: Iterable[LabelledFrame], camera_of: CameraOf, field: Field
) -> dict[str, LabelPlaces]:
    """Which elements the shapes of each label lie on, by the camera of a frame at a size, px; None
    if absent."""
    places: dict[str, LabelPlaces] = {}
    for frame in frames:
        size = evaluation_size(frame)
        camera = camera_of(frame, size)
        if camera is None:
            continue
        setup = EvaluationSetup(field, size, "procc", off_plane="left_out")
        projected = project_field(camera, setup)
        for label, shapes in frame.shapes.items():
            known = places.get(label) or LabelPlaces.none()
            names = [_nearest(points, projected, setup, field) for points in shapes]
            known.on.update(name for name in names if name is not None)
            known.orders.update(_orders(shapes, names))
            places[label] = replace(
                known, shapes=known.shapes + len(shapes), frames=known.frames + 1
            )
    return places


def cameras_of(
    cameras: FrameCameras, on_unusable: Callable[[str], object] | None = None
) -> CameraOf:
    """Given cameras, by the names of frames; ``on_unusable`` is called with the reason for each one
    that cannot be used."""

    def camera(frame: LabelledFrame, size: tuple[int, int]) -> CameraOrProjections | None:
        try:
            found = cameras.camera(frame.name, size)
        except CameraError as error:
            if on_unusable is not None:
                on_unusable(str(error))
            return None
        return None if found is None else found.camera

    return camera


def fitted_cameras(names: LabelMap, field: Field) -> CameraOf:
    """Cameras fitted to the shapes that a map has classes for."""

    def camera(frame: LabelledFrame, size: tuple[int, int]) -> CameraOrProjections | None:
        shapes = [(label, points) for label, some in frame.shapes.items() for points in some]
        classes, _ = names.classes(shapes)
        taken = {p.class_name for p in frame.known.polylines}
        polylines = [*frame.known.polylines]
        for name, (_, points) in zip(classes, shapes, strict=True):
            if name is not None and field.knows(name) and name not in taken:
                taken.add(name)
                polylines.append(Polyline(name, points))
        fit = fit_camera(FrameAnnotation(tuple(polylines)), field, size=size)
        return fit.camera

    return camera


def _nearest(
    points: Points, projected: ProjectedField, setup: EvaluationSetup, field: Field
) -> str | None:
    names = [e.name for e in field.elements if _could_be(e, len(points))]
    disguised = FrameAnnotation(tuple(Polyline(name, points) for name in names))
    plain = measure_projected(disguised, projected, setup).plain
    near = [
        (float(off.mean()), name)
        for name, off in zip(plain.names, plain.distances, strict=True)
        if off is not None and np.isfinite(off).all() and off.max() <= _ON_PX
    ]
    return min(near)[1] if near else None


def _could_be(element: Element, count: int) -> bool:
    if element.is_spot or count == 1:
        return element.is_spot and count == 1
    return element.is_straight or count >= _POINTS_OF_A_CURVE


def _orders(shapes: Sequence[Points], names: Sequence[str | None]) -> list[OrderedClasses]:
    """In which orders the shapes of a frame are on these classes, both ways of ordering."""
    known = [name for name in names if name is not None]
    if len(known) < 2 or len(set(known)) < len(names):
        return []
    found = []
    for order in ORDERS:
        axis = 0 if order == LEFT_TO_RIGHT else 1
        pairs = sorted(zip(shapes, known, strict=True), key=lambda one: middle(one[0])[axis])
        found.append(OrderedClasses(order, tuple(name for _, name in pairs)))
    return found


_MOST_ORDERS = 3000
_MOST_FRAMES = 16
_FEWEST_EQUATIONS = 9  # one more than determine a homography: an order can be wrong
_FEWEST_LINES = 5  # four determine a homography, the fifth tests it
_LARGEST_FAMILY = 4  # 24 orders; a fifth line would make 120
_FITS = 0.005  # of the picture's width: points are on their lines, as well as lenses let them
_CAPPED = 0.02  # of the picture's width: a frame where no order fits decides nothing


@dataclass(frozen=True, slots=True)
class LineOrders:
    """The orders of labels that lines share.

    Attributes:
        rules: label -> its classes in their order; empty if unknown.
        fitting: frames with all points on their lines, with these orders.
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
        alone: label -> the one class it stands for.
        families: label -> the classes it stands for, straight and on the ground.
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
    """Of orders that are as good on the turned field those with the first classes of it: a set
    that is examined again, or in parts, gets the same ones."""

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
    """Return how far the points of a frame are from their lines under the homography that fits them
    best, as a share of the picture's width; None where they determine none."""
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
