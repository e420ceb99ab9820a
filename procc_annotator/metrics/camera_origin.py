"""Annotations made from cameras: a mark of the camera at the first point of each element."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import CameraOrProjections, ElementProjections

_KEY = "from_camera"  # of a point in a file; other readers pass over it
_PLACES_M = np.array([[-30.0, -20.0, 0.0], [0.0, 0.0, 0.0], [0.0, 20.0, 0.0], [30.0, 0.0, 0.0]])
_SAME = 1e-4  # of the picture's size


def _places_shown(camera: CameraOrProjections, size: tuple[int, int]) -> list[float]:
    """Where a camera, of any format, shows four places, as shares of the picture."""
    if isinstance(camera, ElementProjections):
        return []
    px = np.nan_to_num(camera.project(_PLACES_M)[0]) / (np.array(size) - 1)
    return [round(share, 6) for share in px.clip(-1e6, 1e6).ravel().tolist()]


def with_origin(
    annotation: FrameAnnotation, camera: CameraOrProjections, size: tuple[int, int]
) -> FrameAnnotation:
    """The annotation with the mark of a camera, px of this (width, height)."""
    mark = ((_KEY, _places_shown(camera, size)),)
    marked = [(p, (p.points[0]._replace(extra=mark), *p.points[1:])) for p in annotation.polylines]
    return replace(annotation, polylines=tuple(replace(p, points=new) for p, new in marked))


def origins(annotation: FrameAnnotation) -> list[object]:
    """The marks of an annotation."""
    points = (point for polyline in annotation.polylines for point in polyline.points)
    return [mark for point in points if point.extra for key, mark in point.extra if key == _KEY]


def is_made_from(
    annotation: FrameAnnotation, camera: CameraOrProjections, size: tuple[int, int]
) -> bool:
    """Return whether an annotation has the mark of a camera, px of this (width, height)."""
    marks = origins(annotation)
    own = _places_shown(camera, size) if marks else []
    return bool(own) and any(
        isinstance(mark, list)
        and len(mark) == len(own)
        and all(isinstance(v, float | int) for v in mark)
        and np.allclose(mark, own, atol=_SAME)
        for mark in marks
    )
