"""A run goes on only with results of what it is asked for."""

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.batch.serialization import SerializationError, deserialize, serialize
from procc_annotator.batch.unit_store import (
    UnitStore,
    field_settings,
)
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.dataset.picture_sizes import FrameSize
from procc_annotator.errors import UsageError
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.load import load_field
from procc_annotator.field.model import DARKER, CameraPlacement, Field, Landmark
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

SEAT = Landmark(
    "Seat",
    position=(60.0, 0.0, -10.0),
    covariance=((0.01, 0.0, 0.0), (0.0, 0.01, 0.0), (0.0, 0.0, 0.01)),
    surveyed=False,
)
BALL = Landmark("Ball", position=(0.0, 0.0, 0.0), instant="7", moving=True)


def field_with(*landmarks: Landmark) -> Field:
    return with_landmarks(load_field(), landmarks, None, {"1": "7"})


def darker(field: Field) -> Field:
    return replace(
        field,
        elements=tuple(
            replace(e, appearance=replace(e.appearance, tone=DARKER)) for e in field.elements
        ),
    )


@pytest.mark.parametrize(
    "change",
    [
        darker,
        lambda field: replace(field, cameras=CameraPlacement((1, 2, 3), (1, 2, 3))),
        lambda _: field_with(replace(SEAT, covariance=None), BALL),
        lambda _: field_with(SEAT, replace(BALL, position=(20.0, 0.0, 0.0))),
    ],
)
def test_results_of_another_field_are_not_gone_on_with(tmp_path, change):
    field = field_with(SEAT, BALL)
    file = tmp_path / ".propose.unfinished"
    with UnitStore(file, {"field": field_settings(field)}, resume=False) as kept:
        kept.add("0" * 64, [1.0])
    with UnitStore(file, {"field": field_settings(field)}, resume=True) as kept:
        assert len(kept) == 1
    with pytest.raises(UsageError, match="begun with another field"):
        UnitStore(file, {"field": field_settings(change(field))}, resume=True)


def test_a_piece_that_was_searched_twice_counts_once(tmp_path):
    """Of a match that goes on: 30 frames on paint, 45 in which no camera was found, again."""
    found = [("cuts/00-75", None, 75), ("track/00-30/a1", 0.9, 30), ("track/30-75/b2", 0.1, 45)]
    with UnitStore(tmp_path / "track.sqlite", {}, resume=False) as store:
        store.announce("m", frames=75)
        for key, evidence, frames in [*found, ("track/30-75/c3", 0.0, 45)]:
            about = {"kind": key.partition("/")[0], "seconds": 4.0, "evidence": evidence}
            store.add(f"m/{key}", [], match="m", frames=frames, cameras=frames, **about)
        (match,) = store.matches()
        assert (match.tracked, match.cameras, match.seconds, match.done) == (75, 150, 16.0, 3)
        assert match.evidence == pytest.approx(0.9 * 30 / 75)
        frames, since = store.tracked_since(0.0)
        assert frames == 75
        assert since < match.changed - 3.9


def test_what_no_fit_looks_at_keeps_no_run_from_going_on():
    noted = field_with(replace(SEAT, note="row 12", colour="#ff0000"), BALL)
    assert field_settings(noted) == field_settings(field_with(SEAT, BALL))


# What a run keeps of its results comes back to the last bit, and a file can make nothing else.


def test_a_fit_and_its_score_come_back(sample_data):
    field = load_field("soccer")
    file = sample_data / "00002.json"
    annotation = read_annotation(file.read_bytes(), path=str(file), field=field)
    fit = fit_camera(annotation, field, model="R")
    setup = EvaluationSetup(field)
    scored = score(measure(annotation, fit.camera, setup), 5.0)
    size = FrameSize((960, 540))
    again, score_again, same, size_again = deserialize(serialize((fit, {5.0: scored}, fit, size)))
    assert again is same
    assert again.camera == fit.camera
    assert isinstance(again.camera.position_world, tuple)
    assert again.vector.tobytes() == fit.vector.tobytes()
    assert again.covariance.tobytes() == fit.covariance.tobytes()
    assert again.deviations == fit.deviations
    assert again.elements == fit.elements
    assert size_again == size
    assert isinstance(size_again, FrameSize)
    assert score_again[5.0].jac == scored.jac
    assert score_again[5.0].labelling.all_distances.tobytes() == (
        scored.labelling.all_distances.tobytes()
    )
    score_again[5.0].labelling.all_distances[0] = 1  # as writable as it was


values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text() | st.binary(),
    lambda inner: st.lists(inner) | st.tuples(inner, inner) | st.dictionaries(st.floats(), inner),
    max_leaves=12,
)


def same(one: object, other: object) -> bool:
    if isinstance(one, float) and isinstance(other, float):
        return one.hex() == other.hex() or (math.isnan(one) and math.isnan(other))
    if isinstance(one, list | tuple) and isinstance(other, list | tuple):
        alike = type(one) is type(other) and len(one) == len(other)
        return alike and all(map(same, one, other))
    if isinstance(one, dict) and isinstance(other, dict):
        return same(list(one.items()), list(other.items()))
    return type(one) is type(other) and one == other


@given(values)
def test_whatever_is_plain_comes_back(value):
    assert same(deserialize(serialize(value)), value)


def test_numbers_of_arrays_keep_their_kind():
    found = deserialize(serialize([np.float32(0.1), np.arange(6).reshape(2, 3), Path("a/b")]))
    assert type(found[0]) is np.float32
    assert (found[1].dtype, found[1].shape) == (np.arange(6).dtype, (2, 3))
    assert found[2] == Path("a/b")


def test_only_plain_data_is_kept():
    for value in (object(), load_field, {1, 2}, np.array(["text"], dtype=object)):
        with pytest.raises(TypeError):
            serialize(value)


@pytest.mark.parametrize(
    "text",
    [
        "", "{", '{"x": 1}', '{"r": 0}', '{"a": ["|O", [1], "AAAAAAAAAAA="]}', '{"n": ["|O", 1]}',
        '{"c": ["os:system", ["true"]]}',
        '{"c": ["procc_annotator.formats.atomic:write_atomic", ["/tmp/x", ""]]}',
        '{"c": ["procc_annotator.batch.serialization:import_module", ["os"]]}',
        '{"c": ["procc_annotator.batch.serialization:Path", ["/"]]}',
        '{"c": ["procc_annotator.annotation:Point", []]}',
        '{"c": ["procc_annotator.annotation:Polyline", [1, 2, 3]]}',
        '{"c": ["procc_annotator.no.such:Thing", []]}',
    ],
)  # fmt: skip
def test_a_file_of_anybodys_makes_nothing_else(text):
    with pytest.raises(SerializationError):
        deserialize(text)


def test_values_in_values_come_back():
    annotation = FrameAnnotation((Polyline("Middle line", (Point(0.1, 0.2, (("a", 1),)),)),))
    assert deserialize(serialize(annotation)) == annotation
    assert json.loads(serialize(annotation))  # one line of JSON
