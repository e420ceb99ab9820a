"""Score files: valid at every byte, there when complete, never half."""

import csv
import io
import json
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.batch.scoring import FrameResult
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.scores.score_files import (
    CsvScores,
    JsonScores,
    csv_fragment,
    json_fragment,
    score_format,
)
from procc_annotator.report.tables.table import shortest_number

CAMERA = PinholeCamera(
    0.0, np.deg2rad(78.0), 0.0, (0.0, 60.0, -14.0), (1400.0, 1400.0), (479.5, 269.5)
)
ANNOTATION = FrameAnnotation(
    (
        Polyline("Middle line", (Point(0.5, 0.4), Point(0.5, 0.6))),
        Polyline("Goal unknown", (Point(0.1, 0.1),)),
    )
)


@pytest.fixture(scope="module")
def setup() -> EvaluationSetup:
    return EvaluationSetup(load_field("soccer"))


def result(setup: EvaluationSetup, *thresholds: float) -> FrameResult:
    measurement = measure(ANNOTATION, CAMERA, setup)
    scores = {t: score(measurement, t) for t in thresholds}
    return FrameResult('a "quoted", name', "cameras/camera_a.json", None, (), scores)


def written(setup: EvaluationSetup, results: list[FrameResult], *, ground_only: bool) -> str:
    stream = io.BytesIO()
    scores = JsonScores(stream, setup, (5.0,))
    scores.begin()
    for each in results:
        scores.add(json_fragment(each))
    scores.end(None, ground_only=ground_only)
    return stream.getvalue().decode()


@pytest.mark.parametrize("count", [0, 1, 3])
def test_json_of_any_length_is_valid(setup, count):
    scores = json.loads(written(setup, [result(setup, 5.0)] * count, ground_only=False))
    assert len(scores["images"]) == count
    assert scores["field"] == scores["field_name"] == setup.field.name
    assert scores["field_dimensions"] == {d.name: d.value for d in setup.field.dimensions}
    assert "off_plane" not in scores


def test_off_plane_choice_is_reported_where_it_matters(setup):
    assert json.loads(written(setup, [], ground_only=True))["off_plane"] == "missed"


def test_elements_carry_verdict_and_distances(setup):
    entry = json.loads(json_fragment(result(setup, 5.0, 2.5)))
    assert entry["name"] == 'a "quoted", name'
    elements = entry["results"]["5"]["elements"]
    assert elements["Middle line"]["status"] == "tp"
    assert len(elements["Middle line"]["distances"]) == 2
    assert elements["Middle line"]["max_distance"] == max(elements["Middle line"]["distances"])
    assert elements["Goal unknown"] == {"status": "missed", "max_distance": None, "distances": []}
    assert elements["Circle central"]["status"] == "not_annotated"
    assert entry["results"]["2.5"]["elements"].keys() == elements.keys()


def test_undefined_distances_become_null(setup):
    measurement = measure(ANNOTATION, CAMERA, setup)
    measurement.plain.all_distances[:] = np.nan
    (mirrored,) = measurement.mirrored
    mirrored.all_distances[:] = np.nan
    fragment = json_fragment(FrameResult("a", None, None, (), {5.0: score(measurement, 5.0)}))
    assert b"NaN" not in fragment
    entry = json.loads(fragment)["results"]["5"]
    assert entry["mean_reprojection_error"] is None
    assert entry["elements"]["Middle line"]["distances"] == [None, None]


def test_csv_rows_survive_any_name(setup):
    stream = io.BytesIO()
    scores = CsvScores(stream)
    scores.begin()
    scores.add(csv_fragment(result(setup, 5.0, 2.5), setup, (5.0, 2.5)))
    scores.end(None, ground_only=False)
    rows = list(csv.DictReader(io.StringIO(stream.getvalue().decode())))
    assert [row["name"] for row in rows] == ['a "quoted", name'] * 2
    assert [row["threshold"] for row in rows] == ["5", "2.5"]


@pytest.mark.parametrize(("threshold", "key"), [(5.0, "5"), (2.5, "2.5"), (20, "20"), (0.1, "0.1")])
def test_shortests(threshold, key):
    assert shortest_number(threshold) == key


def test_only_known_endings():
    assert score_format(Path("a.JSON")) == "json"
    with pytest.raises(UsageError, match="scores"):
        score_format(Path("scores.txt"))


def test_elements_in_the_file_are_those_of_the_score(setup):
    """The file is written from arrays; the window shows `FrameScore.elements`."""
    frame = result(setup, 0.5, 3.0, 30.0)
    entry = json.loads(json_fragment(frame))
    for threshold, judged in frame.scores.items():
        written = entry["results"][shortest_number(threshold)]["elements"]
        assert written == {
            element.name: {
                "status": element.status,
                "max_distance": element.max_distance,
                "distances": element.distances.tolist(),
            }
            for element in judged.elements
        }
