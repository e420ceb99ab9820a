"""What fits reach and cost on the World Cup set: ``pytest tests/bench --benchmark-only -s``."""

from __future__ import annotations

import time

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.residuals import pinhole_residuals
from procc_annotator.field.load import load_field
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field("soccer")
SETUP = EvaluationSetup(FIELD, off_plane="left_out")
FLOORS = {
    "H": (75.0, 94.5),
    "P": (63.0, 93.5),
    "R": (90.0, 97.5),
    "R+": (95.0, 98.0),
    "auto": (94.0, 98.0),
}


@pytest.mark.parametrize("model", FLOORS)
def test_fit_every_frame(benchmark, world_cup, model) -> None:
    """JaC of fitted cameras at 2 and 5 px, and processor time of a cold and a warm fit."""

    def run() -> tuple[list[tuple[float, float]], list[float], list[float]]:
        jacs, cold, warm = [], [], []
        for annotation in world_cup:
            used = _planar(annotation) if model == "H" else annotation
            began = time.process_time()
            fit = fit_camera(used, FIELD, model=model)
            cold.append(time.process_time() - began)
            assert fit.camera is not None, fit.failure
            measurement = measure(used, fit.camera, SETUP)
            jacs.append((score(measurement, 2).jac, score(measurement, 5).jac))
            moved = _one_point_moved(used)
            began = time.process_time()
            fit_camera(moved, FIELD, model=model, start=fit.camera)
            warm.append(time.process_time() - began)
        return jacs, cold, warm

    jacs, cold, warm = benchmark.pedantic(run, rounds=1)
    at_2, at_5 = 100 * np.mean(jacs, axis=0)
    print(
        f"\n{model}: JaC@2 / @5 {at_2:.2f} / {at_5:.2f};"
        f" cold {1e3 * np.mean(cold):.1f} ms (worst {1e3 * max(cold):.0f}),"
        f" warm {1e3 * np.mean(warm):.1f} ms (worst {1e3 * max(warm):.0f})"
    )
    assert at_2 >= FLOORS[model][0]
    assert at_5 >= FLOORS[model][1]


@pytest.mark.parametrize("model", ["P", "R", "R+", "auto"])
def test_held_out_elements(benchmark, world_cup, model) -> None:
    """How far the points of elements are off that the fit has not seen, each left out in turn."""
    frame = ImageFrame((960, 540))

    def run() -> list[float]:
        means = []
        for annotation in world_cup:
            start = fit_camera(annotation, FIELD, model=model).camera
            for polyline in annotation:
                seen = build_observations(FrameAnnotation((polyline,)), FIELD, frame)
                rest = annotation.without(polyline.class_name)
                fit = fit_camera(rest, FIELD, model=model, start=start)
                if seen is None or fit.vector is None:
                    continue
                off = pinhole_residuals(fit.vector[None], seen, frame.half_diagonal, 8)
                means.append(float(off.distances.mean()))
        return means

    means = np.array(benchmark.pedantic(run, rounds=1))
    middle = float(np.median(means))
    print(f"\n{model}: {len(means)} held out, median {middle:.2f} px, {np.mean(means < 5):.1%} < 5")
    assert middle <= {"P": 1.7, "R": 1.05, "R+": 1.0, "auto": 1.05}[model]


def _planar(annotation: FrameAnnotation) -> FrameAnnotation:
    ground = {e.name for e in FIELD.elements if e.on_ground}
    return FrameAnnotation(tuple(p for p in annotation if p.class_name in ground))


def _one_point_moved(annotation: FrameAnnotation) -> FrameAnnotation:
    polyline = annotation.polylines[0]
    first = Point(polyline.points[0].u + 0.002, polyline.points[0].v + 0.002)
    return annotation.with_polyline(Polyline(polyline.class_name, (first, *polyline.points[1:])))
