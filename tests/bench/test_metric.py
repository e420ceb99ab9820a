"""What scoring costs a frame: run with ``pytest tests/bench --benchmark-only``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.cameras.soccernet import read_camera
from procc_annotator.metrics.measurement import measure, measure_projected
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.score import jac_curve, score
from procc_annotator.metrics.setup import EvaluationSetup

THRESHOLDS = (2.0, 5.0, 10.0, 20.0)
FIELD = load_field("soccer")

Frames = list[tuple[FrameAnnotation, Camera]]


@pytest.fixture(scope="module")
def frames(shared_data: Path) -> Frames:
    """The World Cup test frames with a published method's cameras."""
    loaded = []
    for path in sorted((shared_data / "wc14" / "annotations").glob("*.json")):
        camera = shared_data / "wc14" / "cameras_pnlcalib" / f"camera_{path.stem}.json"
        loaded.append(
            (
                read_annotation(path.read_bytes(), path=str(path), field=FIELD),
                read_camera(camera.read_bytes(), path=str(camera)).camera,
            )
        )
    return loaded


def report(benchmark: Any, frames: Frames) -> None:
    if benchmark.enabled:
        mean, best = (
            benchmark.stats.stats.as_dict()[k] / len(frames) * 1e3 for k in ("mean", "min")
        )
        benchmark.extra_info["ms_per_frame"] = mean
        print(f"\n{benchmark.name}: {mean:.3f} ms a frame (best round {best:.3f})")


@pytest.mark.parametrize("protocol", ["soccernet", "procc"])
def test_measure_and_score_at_four_thresholds(
    benchmark: Any, frames: Frames, protocol: str
) -> None:
    """Projection, visible pieces, distances under both labellings, four scores."""
    setup = EvaluationSetup(FIELD, protocol=protocol)

    def run() -> None:
        for annotation, camera in frames:
            measurement = measure(annotation, camera, setup)
            for tau in THRESHOLDS:
                assert score(measurement, tau).elements

    benchmark(run)
    report(benchmark, frames)


@pytest.mark.parametrize("protocol", ["soccernet", "procc"])
def test_measure_again_while_a_point_is_dragged(
    benchmark: Any, frames: Frames, protocol: str
) -> None:
    """The camera stays: only distances, one score and its elements are new."""
    setup = EvaluationSetup(FIELD, protocol=protocol)
    projected = [project_field(camera, setup) for _, camera in frames]

    def run() -> None:
        for (annotation, _), shown in zip(frames, projected, strict=True):
            assert score(measure_projected(annotation, shown, setup), 5).elements

    benchmark(run)
    report(benchmark, frames)


def test_curve_of_300_thresholds(benchmark: Any, frames: Frames) -> None:
    setup = EvaluationSetup(FIELD)
    measured = [measure(annotation, camera, setup) for annotation, camera in frames]
    taus = np.linspace(0.5, 30, 300)

    def run() -> None:
        for measurement in measured:
            assert len(jac_curve(measurement, taus)) == len(taus)

    benchmark(run)
    report(benchmark, frames)
