"""How much of a frame is annotated: what its cameras are judged by, whichever they are."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field


@dataclass(frozen=True, slots=True)
class AnnotatedExtent:
    """What is annotated of a field in one frame.

    Attributes:
        annotated_elements: how many of its elements have points.
        spread: the share of the picture that these points enclose; None without points.
    """

    annotated_elements: int
    spread: float | None


def annotated_extent(annotation: FrameAnnotation, field: Field) -> AnnotatedExtent:
    """Number of elements and spread of their points.

    The spread is the area of the convex hull of all points, over that of the picture; points
    outside count where the border is nearest to them. It is 0 for points on one line.
    """
    count = 0
    flat: list[float] = []
    for polyline in annotation.polylines:
        if polyline.points and field.canonical_name(polyline.class_name) in field.index:
            count += 1
            for point in polyline.points:
                flat += point[:2]
    if not flat:
        return AnnotatedExtent(0, None)
    points = np.clip(np.array(flat, dtype=np.float32).reshape(-1, 2), 0.0, 1.0)
    return AnnotatedExtent(count, float(cv2.contourArea(cv2.convexHull(points))))
