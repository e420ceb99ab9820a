"""Clicks that were put on painted lines, in drawn pictures of a hall: fits know where they lie."""

from __future__ import annotations

import cv2
import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.camera.base import Camera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.field.load import load_field, with_lines
from procc_annotator.field.model import Field
from procc_annotator.image.line_snapping import snap_points_to_lines
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

FRAME, SIZE = "00003", (1280, 720)
EVALUATED = (960, 540)
COURT = load_field("volleyball")


def snapped(picture: np.ndarray, camera: Camera) -> FrameAnnotation:
    """Clicks near where the rules measure, put on the painted lines."""
    polylines, paint = [], ExpectedLines(COURT, SIZE[0])
    for name, pieces in project_field(camera, EvaluationSetup(COURT, SIZE, "procc")).pieces.items():
        element, piece = COURT.element(name), max(pieces, key=len)
        if not (element.line_width and element.is_straight):
            continue
        clicks = piece[0] + np.linspace(0.1, 0.9, 8)[:, None] * (piece[-1] - piece[0])
        along, sought = np.diff(clicks, axis=0)[[0] * len(clicks)], paint.of(name)
        placed = snap_points_to_lines(picture, clicks, along, sought)
        placed = placed[~np.isnan(placed[:, 0])]
        if len(placed) > 2:
            polylines.append(Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in placed)))
    return FrameAnnotation(tuple(polylines))


def distance_px(annotation: FrameAnnotation, camera: Camera, field: Field) -> float:
    setup = EvaluationSetup(field, EVALUATED, "procc")
    return float(np.median(score(measure(annotation, camera, setup), 5).labelling.all_distances))


def test_a_fit_to_the_middle_of_paint_is_the_true_camera(sample_data) -> None:
    folder = sample_data / "volleyball"
    cameras = CameraSet.open(folder / "cameras" / "true")
    true = cameras.camera(FRAME, EVALUATED).camera
    picture = cv2.cvtColor(cv2.imread(str(folder / f"{FRAME}.jpg")), cv2.COLOR_BGR2BGRA)
    annotation = snapped(picture, true.scaled(EVALUATED, SIZE))
    assert len(annotation.polylines) >= 6
    assert distance_px(annotation, true, COURT) > 0.3
    middle = with_lines(COURT, "middle")
    assert distance_px(annotation, true, middle) < 0.1

    corners = np.array([(x, y, 0.0) for x in (-9, 0, 9) for y in (-4.5, 4.5)])
    here, _ = true.project(corners)

    def off_px(field: Field) -> float:
        fit = fit_camera(annotation, field, model="R+")
        shown, _ = fit.camera.project(corners)
        return float(np.median(np.hypot(*(shown - here).T)))

    assert off_px(middle) < 0.3
    assert off_px(COURT) > 2 * off_px(middle) + 0.3
