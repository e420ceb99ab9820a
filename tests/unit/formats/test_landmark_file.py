"""``landmarks.json``: read strictly, written back without losing anything."""

import json
from typing import Any

import numpy as np
import pytest

from procc_annotator.errors import InputError, SaveError
from procc_annotator.field.model import Landmark
from procc_annotator.formats.landmark_file import (
    LandmarkFile,
    encode_landmarks,
    load_landmarks,
    read_landmarks,
    save_landmarks,
)

FULL: dict[str, Any] = {
    "stadium": {"name": "somewhere", "seats": 12000},
    "landmarks": [
        {
            "name": "Floodlight NE ",
            "title": "Floodlight, north east",
            "position": [61.23456789012345, -45.1, -28.400000000000002],
            "covariance": [[0.01, 0.001, 0.0], [0.001, 0.02, 0.0], [0.0, 0.0, 0.09]],
            "surveyed": False,
            "colour": "#ff00aa",
            "shortcut": "F7",
            "note": "the lamp at the top",
            "frames": ["left", "right"],
            "reflector": [1, {"colour": "white"}],
        },
        {"name": "Ball", "moving": True},
        {"name": "Ball", "position": [1, 2, -0.11], "instant": "17"},
    ],
}


def _read(content: object) -> LandmarkFile:
    return read_landmarks(json.dumps(content).encode(), path="landmarks.json")


def test_what_is_read_is_written_back_to_the_last_digit():
    read = _read(FULL)
    assert json.loads(encode_landmarks(read)) == FULL
    assert read_landmarks(encode_landmarks(read), path="") == read


def test_an_entry_needs_nothing_but_its_name():
    assert _read({"landmarks": [{"name": "Mast"}]}).landmarks == (Landmark("Mast"),)


def test_a_dataset_without_the_file_has_no_landmarks(tmp_path):
    assert load_landmarks(tmp_path / "landmarks.json") == LandmarkFile()


def test_saving_and_loading(tmp_path):
    path = tmp_path / "landmarks.json"
    save_landmarks(path, _read(FULL))
    assert load_landmarks(path) == _read(FULL)
    with pytest.raises(SaveError):
        save_landmarks(tmp_path / "nowhere" / "landmarks.json", LandmarkFile())


def test_entries_are_replaced_by_name_and_instant():
    read = _read(FULL)
    moved = read.with_landmark(Landmark("Ball", position=(5.0, 5.0, 0.0), instant="17"))
    assert [m.position for m in moved.landmarks[1:]] == [None, (5.0, 5.0, 0.0)]
    more = moved.with_landmark(Landmark("Ball", position=(6.0, 5.0, 0.0), instant="18"))
    assert len(more.landmarks) == 4
    assert more.extra == read.extra
    assert [m.name for m in more.without("Ball").landmarks] == ["Floodlight NE "]


def test_a_place_at_all_times_and_at_an_instant_contradict_each_other():
    entries = [
        {"name": "Ball", "position": [1, 2, 0]},
        {"name": "Ball", "moving": True, "instant": "17", "position": [3, 2, 0]},
    ]
    with pytest.raises(InputError, match="a moving landmark's position holds for one") as caught:
        _read({"landmarks": entries})
    assert caught.value.place == "landmarks[0].instant"
    assert len(_read({"landmarks": [{"name": "Ball"}, entries[1]]}).landmarks) == 2


def _entry(**keys: object) -> object:
    return {"landmarks": [{"name": "A"}, {"name": "B", **keys}]}


@pytest.mark.parametrize(
    ("content", "place", "problem"),
    [
        ({"landmarks": [{}]}, "landmarks[0]", "lacks the key 'name'"),
        (_entry(position=[1, float("nan"), 3]), "landmarks[1].position[1]", "expected a number"),
        (_entry(position=[1, 2, 1e9]), "landmarks[1].position[2]", "at most 1000"),
        ([], "", "expected an object with a list 'landmarks', found a list"),
        ({"landmarks": [3]}, "landmarks[0]", "expected an object, found a whole number"),
        (_entry(name=" "), "landmarks[1].name", "is empty"),
        (_entry(name="A "), "landmarks[1].name", "again, after landmarks[0]"),
        (_entry(name="a\nb"), "landmarks[1].name", "one printable line"),
        (_entry(colour="red"), "landmarks[1].colour", "expected #rrggbb"),
        (_entry(instant="1", position=[1, 2, 3]), "landmarks[1].instant", 'says that "B" does'),
        (_entry(moving=True, position=[1, 2, 3]), "landmarks[1].instant", "is missing"),
        (_entry(covariance=np.eye(3).tolist()), "landmarks[1].covariance", "without a position"),
        (
            _entry(position=[1, 2, 3], covariance=[[1, 2, 0], [0, 1, 0], [0, 0, 1]]),
            "landmarks[1].covariance",
            "symmetric",
        ),
        (
            _entry(position=[1, 2, 3], covariance=[[1, 2, 0], [2, 1, 0], [0, 0, 1]]),
            "landmarks[1].covariance",
            "no negative variance",
        ),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_with_its_place(content, place, problem):
    with pytest.raises(InputError) as caught:
        _read(content)
    assert caught.value.place == place
    assert problem in caught.value.problem
    assert str(caught.value).startswith("landmarks.json")


def test_a_file_that_is_cut_off_is_told_with_its_line():
    with pytest.raises(InputError, match="line 2 column"):
        read_landmarks(b'{"landmarks": [\n{"name": "A"}', path="landmarks.json")
