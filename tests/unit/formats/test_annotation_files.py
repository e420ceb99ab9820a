"""SoccerNet annotation files: nothing changes on the way through, damage is named."""

from __future__ import annotations

import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px, points_px
from procc_annotator.errors import AnnotationError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation, write_annotation

FIELD = load_field()
POST = "Goal left post left "


def read(text: str | bytes) -> FrameAnnotation:
    data = text.encode() if isinstance(text, str) else text
    return read_annotation(data, path="00001.json", field=FIELD)


def problem(text: str | bytes) -> str:
    with pytest.raises(AnnotationError) as caught:
        read(text)
    message = str(caught.value)
    assert message.startswith("00001.json")
    assert "\n" not in message
    return message


def test_order_outside_points_empty_lists_and_unknown_classes_are_kept() -> None:
    text = (
        '{"Line unknown": [{"x": -0.25, "y": 1.5}], "Circle left": [],'
        ' "Corner flag": [{"x": 1, "y": 0.1}]}'
    )
    annotation = read(text)
    assert [p.class_name for p in annotation] == ["Line unknown", "Circle left", "Corner flag"]
    assert annotation.annotated == ("Line unknown", "Corner flag")
    assert json.loads(write_annotation(annotation)) == json.loads(text)


def test_the_missing_trailing_space_is_accepted_and_the_official_spelling_written() -> None:
    annotation = read('{"Goal left post left": [{"x": 0.5, "y": 0.5}]}')
    assert annotation.annotated == (POST,)
    assert POST in json.loads(write_annotation(annotation))


@pytest.mark.parametrize(
    "text",
    [
        '{"version": 3, "Circle left": [{"x": 0.5, "y": 0.5, "occluded": true}], "meta": {"a": 1}}',
        '{"Circle left": [], "size": [1280, 720], "tags": ["a:b", null], "note": "\\"x\\": 1"}',
        '{"Circle left": [{"x": 1, "y": 2, "z": {"x": [1]}, "é": "\\ud83d\\ude00"}]}',
        "{}",
    ],
)
def test_keys_we_do_not_know_are_written_back(text) -> None:
    annotation = read(text)
    assert json.loads(write_annotation(annotation)) == json.loads(text)
    assert read(write_annotation(annotation)) == annotation


def test_a_value_without_meaning_to_us_may_be_anything_python_writes() -> None:
    annotation = read('{"score": NaN, "Circle left": [{"x": 0.5, "y": 0.5}]}')
    assert annotation.annotated == ("Circle left",)
    assert b'"score": NaN' in write_annotation(annotation)


def test_whole_numbers_stay_whole() -> None:
    text = '{"Circle left": [{"x": 0, "y": 1.0}, {"x": -0.0, "y": 654321}]}'
    written = write_annotation(read(text)).decode()
    assert '{"x": 0, "y": 1.0}, {"x": -0.0, "y": 654321}' in written


def test_what_nobody_could_read_again_is_not_written() -> None:
    broken = FrameAnnotation((Polyline("Circle left", (Point(math.nan, 0.5),)),))
    with pytest.raises(ValueError, match="not finite"):
        write_annotation(broken)


numbers = st.one_of(st.floats(-10, 10), st.integers(-3, 3), st.floats(-1e6, 1e6))
points = st.lists(st.fixed_dictionaries({"x": numbers, "y": numbers}), max_size=12)
classes = st.sampled_from([e.name for e in FIELD.elements] + ["Line unknown", "Ecke ä"])


@given(st.dictionaries(classes, points, max_size=8))
def test_a_round_trip_changes_no_number(content) -> None:
    written = write_annotation(read(json.dumps(content)))
    assert json.loads(written) == content
    assert list(json.loads(written)) == list(content)
    assert read(written) == read(json.dumps(content))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "is empty"),
        ("[1, 2]", "expected an object of class names, found a list"),
        ('{"Circle left": [{"x": 0.1, "y": 0.2}', "may be cut off"),
        ('{"Circle left": [{"x": NaN, "y": 0.2}]}', "Circle left[0].x: expected a finite number"),
        ('{"Circle left": [{"x": 1, "y": 2}, {"x": 1, "y": 1e999}]}', "Circle left[1].y"),
        ('{"Circle left": [{"x": 1e300, "y": 0}]}', "Circle left[0].x: expected a normalised"),
        ('{"Circle left": [{"x": 0, "y": -9999999}]}', "Circle left[0].y: expected a normalised"),
        ('{"Circle left": [{"x": 1}]}', "Circle left[0]: the coordinate 'y' is missing"),
        ('{"Circle left": [{"x": 1, "y": null}]}', "Circle left[0].y: expected a finite number"),
        ('{"Circle left": [{"x": true, "y": 1}]}', "Circle left[0].x: expected a finite number"),
        ('{"Circle left": [{"x": "0.5", "y": 1}]}', "Circle left[0].x: expected a finite number"),
        ('{"Circle left": [[0.1, 0.2]]}', "Circle left[0]: expected a point"),
        ('{"My line": [[0.1, 0.2]]}', "My line[0]: expected a point"),
        ('{"Circle left": null}', "Circle left: expected a list of points, found null"),
        ('{"Circle left": {"x": 1, "y": 1}}', "Circle left: expected a list of points"),
        ('{"Circle left": 5}', "Circle left: expected a list of points, found a number"),
        ('{"Circle left": [{"x": 1, "y": -Infinity}]}', "found -Infinity"),
        ('{"Circle left": [{"y": 1, "x": %s}]}' % ("9" * 400), "Circle left[0].x"),
        ('{"Circle left": [{"y": 1, "x": %s}]}' % ("9" * 9000), "thousands of digits"),
        ('{"Circle left": [{"x": 1, "y": 2}]} 3', "line 1 column 37"),
        ('{"Circle left": [{"x": 1, "y": 2},]}', "line 1 column"),
        ('{"half \\ud83d": [{"x": 1, "y": 2}]}', "half a character"),
        ('{"pan_degrees": 3, "position_meters": [1, 2, 3]}', "is a camera"),
        ('{"Circle left": [], "Circle left": [{"x": 2, "y": 2}]}', "'Circle left' occurs twice"),
        ('{"Circle left" : [], "Circle\\u0020left" : []}', "'Circle left' occurs twice"),
        ('{"Circle left": [{"x": 1, "y": 2, "y": 3}]}', "'y' occurs twice"),
        ('{"meta": {"a": 1, "a": 2}}', "'a' occurs twice"),
        ("null", "expected an object of class names, found null"),
        ("\0" * 64, "is empty"),
        ("{}".encode("utf-16-le"), "it looks like UTF-16"),
        ('{"Circle left": [{"x": 1, "y": 1}], "Circle left": [{"x": 2, "y": 2}]}', "occurs twice"),
        ('{"Circle left": [{"x": 1, "x": 2, "y": 1}]}', "occurs twice"),
        (
            '{"Goal left post left": [{"x": 1, "y": 1}], "Goal left post left ": []}',
            "the class occurs twice",
        ),
        ('{"a": [{"x": 1, "y": 1}]}'.encode("utf-16"), "is not UTF-8 text"),
        ('{"ä": []}'.encode("latin-1"), "is not UTF-8 text"),
        ("[" * 100_000, "nested too deeply"),
        ('{"meta":' * 100_000, "nested too deeply"),
    ],
)
def test_damage_is_one_line_with_its_place(text, expected) -> None:
    assert expected in problem(text)


def test_a_byte_order_mark_is_accepted() -> None:
    assert read(b'\xef\xbb\xbf{"Circle left": [{"x": 0, "y": 1}]}').annotated == ("Circle left",)


def test_every_real_annotation_comes_back_number_for_number(shared_data) -> None:
    files = sorted((shared_data / "wc14" / "annotations").glob("*.json"))
    files += sorted((shared_data / "official_cases" / "annotations").glob("*.json"))
    assert len(files) > 300
    for file in files:
        data = file.read_bytes()
        assert json.loads(write_annotation(read(data))) == json.loads(data), file


@given(st.data())
def test_a_file_cut_off_anywhere_is_an_error(data) -> None:
    whole = write_annotation(read('{"Circle left": [{"x": 0.25, "y": 1}], "a:b": []}')).rstrip()
    assert problem(whole[: data.draw(st.integers(0, len(whole) - 1))])


@given(st.binary(max_size=40))
def test_no_bytes_raise_anything_but_the_named_error(data) -> None:
    try:
        found = read(data)
    except AnnotationError:
        assert problem(data)
    else:
        assert read(write_annotation(found)).same_content(found)


@given(x=st.floats(-100, 5000), y=st.floats(-100, 5000))
def test_pixels_and_normalised_points_are_inverse(x, y) -> None:
    size = (1280, 720)
    back = points_px(Polyline("a", (point_from_px(x, y, size),)), size)[0]
    assert math.isclose(back[0], x, abs_tol=1e-9)
    assert math.isclose(back[1], y, abs_tol=1e-9)


def test_the_last_column_is_one() -> None:
    assert points_px(Polyline("a", (Point(1, 1), Point(0, 0))), (960, 540)).tolist() == [
        [959, 539],
        [0, 0],
    ]
