"""The published homographies of World Cup 2014 fit its annotations: all conventions are right."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.cameras.loaded_camera import fit_to_size
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.file_listing import list_annotations, list_cameras
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (960, 540)


@pytest.mark.parametrize(
    ("off_plane", "expected"),
    [("left_out", (41.3, 83.0, 96.0)), ("missed", (35.5, 74.0, 86.1))],
)
def test_refined_homographies_reach_their_known_scores(shared_data, off_plane, expected) -> None:
    field = load_field()
    setup = EvaluationSetup(field, SIZE, off_plane=off_plane)
    annotations = open_source(shared_data / "wc14" / "annotations")
    cameras = open_source(shared_data / "wc14" / "homographies_carwc")
    files = list_cameras(cameras)
    jac: dict[float, list[float]] = {2.0: [], 5.0: [], 10.0: []}
    distances: list[float] = []
    for name, file in list_annotations(annotations).items():
        annotation = read_annotation(annotations.read(file), path=file, field=field)
        loaded = read_camera_file(cameras.read(files[name]), path=files[name])
        camera, notice = fit_to_size(loaded, SIZE)
        assert notice == "scaled from 1280x720 to 960x540"
        measurement = measure(annotation, camera, setup)
        for threshold, values in jac.items():
            result = score(measurement, threshold)
            values.append(result.jac)
            if threshold == 10:
                distances += [d for e in result.elements for d in e.distances]
    assert len(files) == 186
    assert tuple(round(100 * float(np.mean(v)), 1) for v in jac.values()) == expected
    assert round(float(np.mean(distances)), 2) == 1.73
