"""What an uncertainty map costs: run with ``pytest tests/bench --benchmark-only``."""

import time

import pytest

from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.gui.state.maps import know_ground

FIELD = load_field("soccer")
LIMIT_S = 0.040


@pytest.mark.parametrize("model", ["H", "R", "R+"])
def test_map_with_its_shapes(benchmark, sample_data, model):
    path = sample_data / "00002.json"
    annotation = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
    fit = fit_camera(annotation, FIELD, model=model, size=(1280, 720))
    times: list[float] = []

    def run() -> None:
        began = time.thread_time()
        assert know_ground(fit, FIELD).values.statistics.median is not None
        times.append(time.thread_time() - began)

    benchmark(run)
    if benchmark.enabled:
        median = sorted(times)[len(times) // 2]
        print(f"\nuncertainty map, {model}, 1280x720: {1e3 * median:.1f} ms (median, processor)")
        assert median <= LIMIT_S
