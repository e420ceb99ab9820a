"""The check of many frames goes on past what cannot be checked."""

import json

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.batch.label_check import CheckFrames, CheckRun, FrameToCheck
from procc_annotator.calibration.label_check.finding import Rule
from procc_annotator.dataset.picture_sizes import FitSizes
from procc_annotator.dataset.review import FrameCheck, check_without_fit
from procc_annotator.field.load import load_field
from procc_annotator.formats.file_source import open_source

FIELD = load_field()
SIZE = (960, 540)
BENT = FrameAnnotation(
    (Polyline("Middle line", (Point(0.2, 0.2), Point(0.3, 0.6), Point(0.6, 0.2))),)
)


def rules(checked: FrameCheck | str) -> list[Rule]:
    return [found.finding.rule for found in checked.found]


def test_frames_come_with_their_findings_and_damaged_ones_with_the_reason(tmp_path):
    places = ", ".join(f'{{"x": {p.u}, "y": {p.v}}}' for p in BENT.polylines[0].points)
    (tmp_path / "a.json").write_text(f'{{"Middle line": [{places}]}}')
    (tmp_path / "b.json").write_text('{"Middle line": [], "Middle line": []}')
    (tmp_path / "c.json").write_text("{}")
    with open_source(tmp_path) as source:
        found = dict(CheckRun(source, FIELD, FitSizes(SIZE), "R"))
    assert list(found) == ["a", "b", "c"]
    assert rules(found["a"]) == [Rule.BENT]
    assert found["a"].size == SIZE
    assert "twice" in str(found["b"])
    assert rules(found["c"]) == []


def test_a_picture_that_no_camera_has_is_told():
    frames = [FrameToCheck("a", BENT, (1, 1)), FrameToCheck("b", BENT, SIZE)]
    (_, tiny), (_, fine) = CheckFrames(FIELD, "R")(frames)
    assert "too small" in str(tiny)
    assert rules(fine) == [Rule.BENT]


def test_no_camera_is_fitted_where_none_may_be():
    ((_, checked),) = CheckFrames(FIELD, "R")([FrameToCheck("a", BENT, SIZE, fitted=False)])
    assert checked == check_without_fit(BENT, FIELD, size=SIZE)


@pytest.mark.parametrize("model", ["H", "P", "R", "R+", "auto"])
def test_every_model_will_do(model):
    ((_, checked),) = CheckFrames(FIELD, model)([FrameToCheck("a", BENT, SIZE)])
    assert rules(checked) == [Rule.BENT]


def test_a_set_tells_which_frame_stands_on_the_other_side(sample_data, tmp_path):
    names = {name: FIELD.half_turn.name_of(name) for name in FIELD.index}
    for name in ("00002", "00003", "00004", "00006"):
        content = json.loads((sample_data / f"{name}.json").read_text())
        turned = {names.get(key, key): value for key, value in content.items()}
        chosen = turned if name == "00003" else content
        (tmp_path / f"{name}.json").write_text(json.dumps(chosen))
    with open_source(tmp_path) as source:
        run = CheckRun(source, FIELD, FitSizes((1280, 720)), "R")
        alone = list(run)
        found = dict(run.together(alone))
    assert not any(Rule.OTHER_SIDE in rules(checked) for _, checked in alone)
    assert {name for name in found if Rule.OTHER_SIDE in rules(found[name])} == {"00003"}
