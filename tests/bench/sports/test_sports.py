"""What fits reach in every shipped sport: ``pytest tests/bench/sports --benchmark-only -s``.

Of each field 200 plausible cameras (see `views`), the elements they show clicked to 1 px. A camera
is recovered if it shows the field in its picture within 5 px (median) of where the true one does.
Printed are the rows of the table in docs/explanation/measurements.md.
"""

import time

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.result import ill_conditioned_reason
from procc_annotator.field.load import field_names, load_field, with_lines
from tests.bench.sports.court_cameras import fitted_back, read_cameras
from tests.bench.sports.views import Views

_VIEWS, _RECOVERED_PX = 200, 5.0
# How many elements are needed is told from the first views, with so many of theirs.
_SOME_VIEWS, _COUNTS = 60, (3, 4, 5, 6, 8, 10, 12)
_ENOUGH = 0.95
# Of the cameras that a fit calls determined. Lanes of a track look alike at many places.
_SURE = 0.9


@pytest.mark.parametrize("name", field_names())
def test_fit_plausible_cameras(benchmark, name):
    """Share recovered, processor time of a cold fit, and how many elements are needed."""
    views = Views(load_field(name))
    rng = np.random.default_rng(2024)

    def run() -> tuple[list[float], list[float], list[bool], dict[int, list[bool]]]:
        errors, seconds, sure = [], [], []
        by_count: dict[int, list[bool]] = {count: [] for count in _COUNTS}
        for number in range(_VIEWS):
            view = views.random(rng)
            began = time.process_time()
            fit = fit_camera(view.annotation, views.field)
            seconds.append(time.process_time() - began)
            errors.append(views.median_error(view.camera, fit.camera))
            sure.append(fit.camera is not None and not ill_conditioned_reason(fit))
            shown = view.annotation.polylines
            for count in _COUNTS:
                if number >= _SOME_VIEWS or count > len(shown):
                    continue
                chosen = rng.permutation(len(shown))[:count]
                some = FrameAnnotation(tuple(shown[i] for i in sorted(chosen)))
                found = fit_camera(some, views.field).camera
                by_count[count].append(views.median_error(view.camera, found) <= _RECOVERED_PX)
        return errors, seconds, sure, by_count

    errors, seconds, sure, by_count = benchmark.pedantic(run, rounds=1)
    recovered = np.array(errors) <= _RECOVERED_PX
    shares = ", ".join(
        f"{n}: {100 * np.mean(found):.0f}" for n, found in by_count.items() if len(found) >= 20
    )
    determined = recovered[np.array(sure)]
    print(
        f"\n| {name} | {100 * recovered.mean():.1f} %"
        f" | {100 * np.mean(sure):.0f} % | {100 * determined.mean():.1f} %"
        f" | {np.median(errors):.2f} px | {shares}"
        f" | {1e3 * np.mean(seconds):.0f} ms ({1e3 * max(seconds):.0f}) |"
    )
    assert determined.mean() >= _SURE


@pytest.mark.parametrize("model", ["R+", "auto"])
def test_fit_court_cameras(benchmark, shared_data, model):
    """The 248 real cameras of basketball courts, fitted back to what they show."""
    cameras = read_cameras(shared_data / "deepsportradar")
    views = Views(load_field("basketball_fiba"))
    errors, jacs = benchmark.pedantic(lambda: fitted_back(views, cameras, model), rounds=1)
    within = np.mean(errors <= _RECOVERED_PX)
    print(
        f"\n{model}: {len(errors)} cameras, {within:.1%} within 5 px, median"
        f" {np.median(errors):.2f} px, JaC@5 {100 * np.mean(jacs):.1f}"
    )
    assert within >= _ENOUGH
    assert np.mean(jacs) >= _ENOUGH


@pytest.mark.parametrize("noise_px", [0.5, 1.0])
def test_fit_clicks_on_the_middle_of_paint(benchmark, shared_data, noise_px):
    """The same cameras, clicked on the middle of the paint, fitted with either choice of lines."""
    cameras = read_cameras(shared_data / "deepsportradar")
    measured = load_field("basketball_fiba")
    middle = Views(with_lines(measured, "middle"))

    def run() -> list[float]:
        return [
            float(
                np.median(fitted_back(views, cameras, "R+", clicked=middle, noise_px=noise_px)[0])
            )
            for views in (Views(measured), middle)
        ]

    off, right = benchmark.pedantic(run, rounds=1)
    print(f"\n{noise_px} px noise: median {off:.2f} px with measured, {right:.2f} px with middle")
    assert right < 0.6 * off
