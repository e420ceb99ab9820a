"""What follows from the clicks of one frame."""

from __future__ import annotations

import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.frame_analysis import analyse_frame
from procc_annotator.calibration.prediction.visible_elements import visible_stretches
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation

FIELD = load_field()
SIZE = (1280, 720)
SOME = {"Big rect. left bottom", "Big rect. left main", "Big rect. left top", "Circle left"}


@pytest.fixture(scope="module")
def clicked(sample_data) -> FrameAnnotation:
    path = sample_data / "00002.json"
    annotation = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
    return FrameAnnotation(tuple(p for p in annotation if p.class_name in SOME))


def test_out_of_sight_is_what_the_camera_has_nowhere_in_the_picture(clicked) -> None:
    insight = analyse_frame(clicked, FIELD, size=SIZE)
    assert insight.fit.camera is not None
    away = insight.out_of_sight(FIELD)
    seen = {s.name for s in visible_stretches(FIELD, insight.fit.camera, SIZE) if s.length_px > 20}
    assert seen
    assert not away & (seen | SOME)
    assert {"Side line right", "Goal right crossbar", "Circle right"} <= away
    assert "Penalty mark left" not in away
    assert {"Penalty mark right", "Corner arc right top"} <= away


def test_a_homography_says_nothing_of_what_is_off_the_ground(clicked) -> None:
    away = analyse_frame(clicked, FIELD, size=SIZE, model="H").out_of_sight(FIELD)
    assert "Circle right" in away
    assert all(element.on_ground for n in away if (element := FIELD.element(n)))


def test_without_a_camera_nothing_is_known_of_it(clicked) -> None:
    one = FrameAnnotation(clicked.polylines[:1])
    assert analyse_frame(one, FIELD, size=SIZE).out_of_sight(FIELD) == frozenset()
