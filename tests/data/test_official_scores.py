"""Agreement with the official SoccerNet evaluation on real and made-up frames."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.errors import CameraError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import jac_curve, score
from procc_annotator.metrics.sets import SetAccumulator
from procc_annotator.metrics.setup import EvaluationSetup

THRESHOLDS = (2.0, 5.0, 10.0, 20.0)
SETS = {
    "pnlcalib": ("wc14/annotations", "wc14/cameras_pnlcalib", "wc14/expected_pnlcalib.json"),
    "nbjw": ("wc14/annotations", "wc14/cameras_nbjw", "wc14/expected_nbjw.json"),
    "cases": (
        "official_cases/annotations",
        "official_cases/cameras",
        "official_cases/expected.json",
    ),
}
FIELD = load_field("soccer")

Frame = tuple[str, FrameAnnotation, Camera | None]


class RealSet:
    def __init__(self, data: Path, name: str, every: int = 1) -> None:
        self.annotations, self.cameras, expected = (data / part for part in SETS[name])
        self.every = every
        self.expected: dict[str, Any] = json.loads(expected.read_text())

    def frames(self) -> Iterator[Frame]:
        for name in list(self.expected["images"])[:: self.every]:
            path = self.annotations / f"{name}.json"
            annotation = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
            yield name, annotation, self._camera(self.cameras / f"camera_{name}.json")

    def _camera(self, path: Path) -> Camera | None:
        try:
            return read_camera_file(path.read_bytes(), path=str(path)).camera
        except (FileNotFoundError, CameraError):
            return None


@pytest.fixture(params=SETS)
def real_set(request, shared_data) -> RealSet:
    return RealSet(shared_data, request.param)


def test_every_count_flag_and_figure_is_the_official_one(real_set):
    setup = EvaluationSetup(FIELD)
    accumulator = SetAccumulator(setup, THRESHOLDS)
    for name, annotation, camera in real_set.frames():
        official = real_set.expected["images"][name]
        assert (camera is None) == (official is None), name
        if camera is None:
            accumulator.add_missing_camera(name)
            continue
        measurement = measure(annotation, camera, setup)
        scores = {tau: score(measurement, tau) for tau in THRESHOLDS}
        accumulator.add(name, measurement, scores)
        for tau, ours in scores.items():
            theirs = official[f"{tau:g}"]
            found = {"tp": ours.tp, "fp": ours.fp, "fn": ours.fn, "mirrored": ours.mirrored}
            assert found == {key: theirs[key] for key in found}, f"{name} at {tau} px"
            assert ours.jac == pytest.approx(theirs["jac"], abs=1e-6), name
            error = theirs["mean_reprojection_error"]
            assert ours.mean_reprojection_error == (
                None if error is None else pytest.approx(error, abs=5e-4)
            )
    check_summary(accumulator, real_set.expected["summary"])


def check_summary(accumulator: SetAccumulator, official: dict[str, dict[str, Any]]) -> None:
    summary = accumulator.summary()
    for tau in THRESHOLDS:
        ours, theirs = summary[tau], dict(official[f"{tau:g}"])
        theirs_per_class = theirs.pop("per_class")
        for figure, value in theirs.items():
            tolerance = 5e-4 if figure == "mean_reprojection_error" else 1e-6
            assert getattr(ours, figure) == pytest.approx(value, abs=tolerance), (tau, figure)
        found = {n: {"tp": c.tp, "fp": c.fp, "fn": c.fn} for n, c in ours.per_class.items()}
        assert found == {
            name: {key: sums[key] for key in ("tp", "fp", "fn")}
            for name, sums in theirs_per_class.items()
        }, tau


def test_the_curve_passes_through_every_score(real_set):
    setup = EvaluationSetup(FIELD)
    taus = np.linspace(0.5, 30, 60)
    for name, annotation, camera in list(real_set.frames())[::7]:
        if camera is not None:
            measurement = measure(annotation, camera, setup)
            one_by_one = [score(measurement, tau).jac for tau in taus]
            np.testing.assert_allclose(jac_curve(measurement, taus), one_by_one, err_msg=name)


def test_the_protocols_agree_where_the_official_one_has_no_artefact(shared_data):
    """On main-camera frames their JaC differ by little, and only the clean one has short pieces."""
    official = EvaluationSetup(FIELD)
    clean = EvaluationSetup(FIELD, protocol="procc", allow_mirrored=True)
    figures = []
    for _, annotation, camera in RealSet(shared_data, "pnlcalib").frames():
        assert camera is not None
        pair = (measure(annotation, camera, setup) for setup in (official, clean))
        figures.append([score(m, 5).jac for m in pair])
    mean_official, mean_clean = np.mean(figures, axis=0)
    assert mean_official == pytest.approx(0.8494, abs=1e-4)
    assert mean_clean == pytest.approx(mean_official, abs=0.02)
