"""The functions other programs call: what they read, fit and score, and how they decline."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import procc_annotator
from procc_annotator import evaluate, fit_camera, load_annotation
from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import AnnotationError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.metric.measure import measure
from procc_annotator.metric.score import score
from procc_annotator.metric.setup import EvaluationSetup

SAMPLES = Path(__file__).parents[2] / "sample_data"
FRAME = SAMPLES / "00002.json"


def test_a_frame_is_read_as_it_is_in_the_file() -> None:
    annotation = load_annotation(FRAME)
    content = json.loads(FRAME.read_text())
    assert [p.class_name for p in annotation] == list(content)
    first = annotation.polylines[0]
    assert [(p.u, p.v) for p in first.points] == [
        (p["x"], p["y"]) for p in content[first.class_name]
    ]
    assert load_annotation(str(FRAME)) == annotation


def test_other_formats_are_read_too(tmp_path) -> None:
    shape = {
        "label": "Middle line", "shape_type": "linestrip", "points": [[0, 269.5], [959, 539]],
        "group_id": None, "flags": {},
    }  # fmt: skip
    content = {
        "version": "5.0.0", "flags": {}, "shapes": [shape], "imagePath": "7.jpg", "imageData": None,
        "imageWidth": 960, "imageHeight": 540,
    }  # fmt: skip
    (tmp_path / "7.json").write_text(json.dumps(content))
    (line,) = load_annotation(tmp_path / "7.json")
    assert [(p.u, p.v) for p in line.points] == [(0.0, 0.5), (1.0, 1.0)]


def test_anything_but_one_readable_frame_is_declined(tmp_path) -> None:
    with pytest.raises(
        UsageError, match=r"holds \d+ frames \(00001, 00002, 00003, \.\.\.\), one is"
    ):
        load_annotation(SAMPLES)
    with pytest.raises(UsageError, match="no such file"):
        load_annotation(tmp_path / "nothing.json")
    damaged = tmp_path / "damaged.json"
    damaged.write_text('{"Middle line": [{"x": 0.5}]}')
    with pytest.raises(
        AnnotationError, match=r"damaged.json: Middle line\[0\]: the coordinate 'y'"
    ):
        load_annotation(damaged)
    (tmp_path / "empty").mkdir()
    with pytest.raises(UsageError, match="no annotation"):
        load_annotation(tmp_path / "empty")


def test_fit_and_score_with_nothing_but_the_annotation() -> None:
    annotation = load_annotation(FRAME)
    fit = fit_camera(annotation)
    assert fit.model == "R"
    assert evaluate(annotation, fit.camera).jac == 1.0
    few = fit_camera(FrameAnnotation(annotation.polylines[:2]))
    assert (few.camera, few.failure) == (None, "2 elements, 3 needed")
    with pytest.raises(UsageError, match="no camera to evaluate"):
        evaluate(annotation, few.camera)
    with pytest.raises(UsageError, match="did you mean auto"):
        fit_camera(annotation, model="auot")


def test_the_score_is_that_of_the_metric() -> None:
    annotation, field = load_annotation(FRAME), load_field()
    camera = PinholeCamera(
        0.0, np.deg2rad(77), 0.0, (0.0, 62.0, -17.0), (1480.0, 1480.0), (479.5, 269.5)
    )
    setup = EvaluationSetup(field, (960, 540), "procc")
    expected = score(measure(annotation, camera, setup), 8.0)
    found = evaluate(annotation, camera, tau=8.0, protocol="procc")
    assert (found.jac, found.tp, found.fp, found.fn) == (
        expected.jac, expected.tp, expected.fp, expected.fn,
    )  # fmt: skip
    with pytest.raises(UsageError, match="unknown protocol"):
        evaluate(annotation, camera, protocol="soccer")


def test_labels_of_the_turned_field_count_where_they_are_allowed() -> None:
    annotation = load_annotation(FRAME)
    camera = fit_camera(annotation, model="P").camera
    x, y, z = camera.position_world
    turned = replace(camera, pan_rad=camera.pan_rad + np.pi, position_world=(-x, -y, z))
    assert evaluate(annotation, turned, protocol="procc").jac < 0.5
    found = evaluate(annotation, turned, protocol="procc", allow_mirrored=True)
    assert (found.jac, found.mirrored) == (1.0, True)
    assert evaluate(annotation, turned).mirrored  # as the official evaluation does anyway


def test_the_field_can_be_another_one() -> None:
    annotation, small = load_annotation(FRAME), load_field("soccer", length=100.0, width=64.0)
    right, wrong = fit_camera(annotation), fit_camera(annotation, small)
    assert right.mean_px < wrong.mean_px
    assert evaluate(annotation, wrong.camera, field=small, tau=2).tp < 12


def test_the_package_offers_just_these() -> None:
    for name in procc_annotator.__all__:
        assert getattr(procc_annotator, name) is not None
    with pytest.raises(AttributeError, match="no attribute 'fit_cameras'"):
        procc_annotator.fit_cameras  # noqa: B018
