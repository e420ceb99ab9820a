"""Which elements the shapes of a label lie on, as cameras show the field."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.errors import CameraError
from procc_annotator.field.model import Element, Field
from procc_annotator.fit.fitting import fit_camera
from procc_annotator.io.annotation_files.label_map import LEFT_TO_RIGHT, ORDERS, LabelMap, OrderedClasses
from procc_annotator.metric.measure import measure_projected
from procc_annotator.metric.project import ProjectedField, project_field
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.dataset.camera_set import FrameCameras
from procc_annotator.session.labels.label_shapes import LabelledFrame, Points, middle

_WIDTH = 960
_ON_PX = 8.0  # at this width: as far as clicks of somebody else may be beside an element
# Two or three points along a straight line lie on many a curve as well.
_POINTS_OF_A_CURVE = 4

CameraOf = Callable[[LabelledFrame, tuple[int, int]], CameraOrProjections | None]


@dataclass(frozen=True)
class LabelPlaces:
    """Where the shapes of a label were found.

    Attributes:
        on: class -> how many shapes lie on it, and on nothing nearer.
        shapes: that were looked at.
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
    """Which elements the shapes of each label lie on.

    Args:
        frames: of the set.
        camera_of: the camera of a frame at a size, px; None where there is none.
        field: the elements, metres.
    """
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


def cameras_of(cameras: FrameCameras, told: Callable[[str], object] | None = None) -> CameraOf:
    """Given cameras.

    Args:
        cameras: by the names of frames.
        told: of each one that cannot be used, why; None: nobody is.
    """

    def camera(frame: LabelledFrame, size: tuple[int, int]) -> CameraOrProjections | None:
        try:
            found = cameras.camera(frame.name, size)
        except CameraError as error:
            if told is not None:
                told(str(error))
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
    """The element that all points of a shape are on, the nearest of several."""
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
