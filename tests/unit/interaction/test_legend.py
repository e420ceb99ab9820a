"""The legend explains what is on the picture, and nothing else."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.interaction import palette
from procc_annotator.interaction.legend import legend_of
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (960, 540)
CAMERA = PinholeCamera(
    0.0, np.deg2rad(78.0), 0.0, (0.0, 60.0, -14.0), (1400.0, 1400.0), (479.5, 269.5)
)


@pytest.fixture
def setup() -> EvaluationSetup:
    return EvaluationSetup(load_field("soccer"), SIZE, "procc")


def polyline(setup: EvaluationSetup, name: str, off_px: float = 0.0) -> Polyline:
    """Two points of an element as the camera shows it, moved down."""
    piece = project_field(CAMERA, setup).pieces[name][0]
    points = [piece[len(piece) // 3], piece[2 * len(piece) // 3]]
    return Polyline(
        name, tuple(Point(x / (SIZE[0] - 1), (y + off_px) / (SIZE[1] - 1)) for x, y in points)
    )


def texts(setup: EvaluationSetup, annotation: FrameAnnotation) -> list[str]:
    measurement = measure(annotation, CAMERA, setup)
    entries = legend_of(annotation, setup.field, measurement, score(measurement, 5.0))
    return [entry.text for entry in entries]


def test_only_verdicts_that_occur(setup):
    shown = list(project_field(CAMERA, setup).pieces)
    everything = FrameAnnotation(tuple(polyline(setup, name) for name in shown))
    assert texts(setup, everything) == [
        "passes: every point closer than 5 px",
        "thin lines: the projection",
    ]
    hidden = next(e.name for e in setup.field.elements if e.name not in shown)
    away = Polyline(hidden, (Point(0.1, 0.1), Point(0.2, 0.2)))
    some = FrameAnnotation((polyline(setup, shown[0], 30.0), away))
    assert texts(setup, some) == [
        "too far: a point 5 px or more away",
        "missed: annotated, not projected",
        "not annotated: projected only",
        "thin lines: the projection",
    ]


def test_distances_are_of_the_evaluation_not_of_the_picture(setup):
    name = next(iter(project_field(CAMERA, setup).pieces))
    annotation = FrameAnnotation((polyline(setup, name, 30.0),))
    measurement = measure(annotation, CAMERA, setup)
    judged = score(measurement, 5.0)
    entries = legend_of(annotation, setup.field, measurement, judged, setup.size)
    assert entries[-1].text == f"distances: px of {setup.size[0]}x{setup.size[1]}"


def test_looks_are_those_of_the_overlay(setup):
    name = next(iter(project_field(CAMERA, setup).pieces))
    annotation = FrameAnnotation((polyline(setup, name, 30.0),))
    measurement = measure(annotation, CAMERA, setup)
    entries = legend_of(annotation, setup.field, measurement, score(measurement, 5.0))
    too_far = next(e for e in entries if e.text.startswith("too far"))
    assert too_far.lines[0].colour == palette.TOO_FAR
    assert too_far.mark.shape == "cross"
    absent = next(e for e in entries if e.text.startswith("not annotated"))
    assert absent.lines[0].dash == palette.STATUS_DASHES["not_annotated"]


def test_without_a_camera_classes_are_named(setup):
    element = setup.field.elements[3]
    unknown = Polyline("Advertising", (Point(0.1, 0.1),))
    known = Polyline(element.name, (Point(0.1, 0.1),))
    annotation = FrameAnnotation((known, Polyline("Circle central", ()), unknown))
    entries = legend_of(annotation, setup.field)
    assert [e.text for e in entries] == [element.title, "Advertising"]
    assert entries[0].lines[0].colour == element.colour
    assert entries[1].lines[0].dash == palette.UNKNOWN_CLASS_DASH


def test_elements_without_a_verdict_and_unconfirmed_ones(setup):
    planar = EvaluationSetup(setup.field, SIZE, "procc", planar_only=True)
    goal = next(e.name for e in setup.field.elements if not e.on_ground)
    waiting = Polyline("Circle central", (Point(0.5, 0.5),))
    post = Polyline(goal, (Point(0.1, 0.1), Point(0.1, 0.2)))
    annotation = FrameAnnotation((post,), unconfirmed=(waiting,))
    found = texts(planar, annotation)
    assert "takes no part" in found
    assert found[-1] == "unconfirmed: never counted"
