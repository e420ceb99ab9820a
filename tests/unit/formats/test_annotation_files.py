"""SoccerNet annotation files: nothing changes on the way through, damage is named."""

import json
import math

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px, points_px
from procc_annotator.errors import AnnotationError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations import masks
from procc_annotator.formats.annotations.exchange import ExchangedFrame, WriteContext
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


def test_order_outside_points_empty_lists_and_unknown_classes_are_kept():
    text = (
        '{"Line unknown": [{"x": -0.25, "y": 1.5}], "Circle left": [],'
        ' "Corner flag": [{"x": 1, "y": 0.1}]}'
    )
    annotation = read(text)
    assert [p.class_name for p in annotation] == ["Line unknown", "Circle left", "Corner flag"]
    assert annotation.annotated == ("Line unknown", "Corner flag")
    assert json.loads(write_annotation(annotation)) == json.loads(text)


def test_the_missing_trailing_space_is_accepted_and_the_official_spelling_written():
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
def test_keys_we_do_not_know_are_written_back(text):
    annotation = read(text)
    assert json.loads(write_annotation(annotation)) == json.loads(text)
    assert read(write_annotation(annotation)) == annotation


def test_a_value_without_meaning_to_us_may_be_anything_python_writes():
    annotation = read('{"score": NaN, "Circle left": [{"x": 0.5, "y": 0.5}]}')
    assert annotation.annotated == ("Circle left",)
    assert b'"score": NaN' in write_annotation(annotation)


def test_whole_numbers_stay_whole():
    text = '{"Circle left": [{"x": 0, "y": 1.0}, {"x": -0.0, "y": 654321}]}'
    written = write_annotation(read(text)).decode()
    assert '{"x": 0, "y": 1.0}, {"x": -0.0, "y": 654321}' in written


def test_what_nobody_could_read_again_is_not_written():
    broken = FrameAnnotation((Polyline("Circle left", (Point(math.nan, 0.5),)),))
    with pytest.raises(ValueError, match="not finite"):
        write_annotation(broken)


numbers = st.one_of(st.floats(-10, 10), st.integers(-3, 3), st.floats(-1e6, 1e6))
points = st.lists(st.fixed_dictionaries({"x": numbers, "y": numbers}), max_size=12)
classes = st.sampled_from([e.name for e in FIELD.elements] + ["Line unknown", "Ecke ä"])


@given(st.dictionaries(classes, points, max_size=8))
def test_a_round_trip_changes_no_number(content):
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
def test_damage_is_one_line_with_its_place(text, expected):
    assert expected in problem(text)


def test_a_byte_order_mark_is_accepted():
    assert read(b'\xef\xbb\xbf{"Circle left": [{"x": 0, "y": 1}]}').annotated == ("Circle left",)


def test_every_real_annotation_comes_back_number_for_number(shared_data):
    files = sorted((shared_data / "wc14" / "annotations").glob("*.json"))
    files += sorted((shared_data / "official_cases" / "annotations").glob("*.json"))
    assert len(files) > 300
    for file in files:
        data = file.read_bytes()
        assert json.loads(write_annotation(read(data))) == json.loads(data), file


@given(st.data())
def test_a_file_cut_off_anywhere_is_an_error(data):
    whole = write_annotation(read('{"Circle left": [{"x": 0.25, "y": 1}], "a:b": []}')).rstrip()
    assert problem(whole[: data.draw(st.integers(0, len(whole) - 1))])


@given(st.binary(max_size=40))
def test_no_bytes_raise_anything_but_the_named_error(data):
    try:
        found = read(data)
    except AnnotationError:
        assert problem(data)
    else:
        assert read(write_annotation(found)).same_content(found)


@given(x=st.floats(-100, 5000), y=st.floats(-100, 5000))
def test_pixels_and_normalised_points_are_inverse(x, y):
    size = (1280, 720)
    back = points_px(Polyline("a", (point_from_px(x, y, size),)), size)[0]
    assert math.isclose(back[0], x, abs_tol=1e-9)
    assert math.isclose(back[1], y, abs_tol=1e-9)


def test_the_last_column_is_one():
    assert points_px(Polyline("a", (Point(1, 1), Point(0, 0))), (960, 540)).tolist() == [
        [959, 539],
        [0, 0],
    ]


# Masks: which pixels belong to a line, whatever its width and wherever its points lie.

SOCCER = load_field("soccer")
SIZE = (80, 60)
A, B = "Side line top", "Middle line"


def polyline(name: str, *points_px: tuple[float, float]) -> Polyline:
    return Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in points_px))


def distances(a: tuple[float, float], b: tuple[float, float]) -> np.ndarray:
    """(H, W) distance of each pixel's centre to a segment, px."""
    grid = np.stack(np.meshgrid(np.arange(SIZE[0]), np.arange(SIZE[1])), axis=-1).astype(float)
    start, along = np.array(a), np.subtract(b, a)
    squared = float(along @ along)
    t = np.clip((grid - start) @ along / squared, 0, 1) if squared else np.zeros(grid.shape[:2])
    return np.linalg.norm(grid - start - t[..., None] * along, axis=-1)


position = st.floats(-40, 120)
place = st.tuples(position, position)


@given(place, place, st.floats(1, 20))
def test_pixels_within_half_the_width_are_the_line(a, b, width):
    mask = masks.draw_mask([polyline(A, a, b)], {A: 7}, SIZE, width)
    points = polyline(A, a, b).points
    exact = [(p.u * (SIZE[0] - 1), p.v * (SIZE[1] - 1)) for p in points]
    apart = distances(exact[0], exact[1])
    clear = abs(apart - width / 2) > 1e-6  # a pixel just on the edge may be either
    assert np.array_equal(mask[clear] == 7, (apart <= width / 2)[clear])
    assert set(np.unique(mask)) <= {0, 7}


def test_points_a_million_pictures_away_are_drawn_to_the_border():
    far = Polyline(A, (Point(-1e6, 30 / 59), Point(1e6, 30 / 59)))
    mask = masks.draw_mask([far], {A: 1}, SIZE, 2.9)
    assert mask.sum(axis=1).tolist() == [SIZE[0] if 29 <= y <= 31 else 0 for y in range(SIZE[1])]


def test_a_single_point_is_a_dot():
    mask = masks.draw_mask([polyline(A, (10, 20))], {A: 1}, SIZE, 3.1)
    assert np.argwhere(mask).tolist() == [[y, x] for y in (19, 20, 21) for x in (9, 10, 11)]


def test_the_order_of_the_file_does_not_matter():
    lines = [polyline(A, (0, 30), (79, 30)), polyline(B, (40, 0), (40, 59))]
    values = {A: 1, B: 2}
    first = masks.draw_mask(lines, values, SIZE, 4)
    assert np.array_equal(first, masks.draw_mask(lines[::-1], values, SIZE, 4))
    assert first[30, 40] == 2


def test_files_and_legend():
    written: dict[str, bytes] = {}

    def put(name: str, data: bytes) -> bool:
        written[name] = data
        return True

    annotation = FrameAnnotation(
        (polyline(A, (0, 10), (79, 10)), polyline("advert", (0, 40), (90, 40)), Polyline(B, ()))
    )
    writing = WriteContext(SOCCER, put, line_width=2)
    masks.write_many([ExchangedFrame("7", annotation, SIZE)], writing)
    assert list(written) == ["7.png", "classes.json"]
    mask = cv2.imdecode(np.frombuffer(written["7.png"], np.uint8), cv2.IMREAD_UNCHANGED)
    assert mask.shape == (60, 80)
    assert mask.dtype == np.uint8
    legend = json.loads(written["classes.json"])
    values = {entry["class"]: entry["value"] for entry in legend["classes"]}
    assert legend["background"] == 0
    assert sorted(values.values()) == list(range(1, len(values) + 1))
    assert [e.name for e in SOCCER.elements] == list(values)[: len(SOCCER.elements)]
    assert set(np.unique(mask)) == {0, values[A], values["advert"]}
    assert mask[10, 40] == values[A]
    told = writing.remarks.lines()
    assert any("not read back" in line for line in told)
    assert "what lies outside the picture is not in its mask (1 frame: 7)" in told


def test_more_classes_than_grey_values_are_told():
    many = tuple(polyline(f"class {i}", (0, 0), (9, 9)) for i in range(300))
    writing = WriteContext(SOCCER, lambda name, data: True)
    masks.write_many([ExchangedFrame("7", FrameAnnotation(many), SIZE)], writing)
    assert any("255 values" in line for line in writing.remarks.lines())
    assert writing.elements == 255 - len(SOCCER.elements) - 2


@pytest.mark.parametrize("width", [0, 0.5, 201, float("nan")])
def test_widths_that_cannot_be_drawn(width):
    from procc_annotator.errors import UsageError

    with pytest.raises(UsageError, match="line width"):
        masks.write_many([], WriteContext(SOCCER, lambda name, data: True, line_width=width))


def test_further_keys_of_points_may_hold_anything():
    """Elements are looked up by what they are, whatever other programs keep at their points."""
    data = b'{"Middle line": [{"x": 0.1, "y": 0.2, "of": [1, {"a": []}]}, {"x": 0.3, "y": 0.4}]}'
    one, other = (read_annotation(data, path="1.json", field=FIELD).polylines[0] for _ in range(2))
    assert {one: 1}[other] == 1
