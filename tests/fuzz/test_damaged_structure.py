"""Files changed in their structure are refused in one clear line, or read without any change."""

import copy
import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.field.load import load_field
from tests.fuzz.readers import (
    ANNOTATIONS,
    CAMERAS,
    FIELD_LINES,
    as_homography,
    check_annotation,
    check_field,
    check_pinhole,
    check_place,
    read_annotation_file,
    read_camera,
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    return tmp_path_factory.mktemp("fuzz")


class Raw(str):
    """Text that is written into the file as it is."""


class Pairs(list[Any]):
    """An object as [key, value] lists, in which a key may stand twice."""


def parsed(data: bytes) -> Any:
    return json.loads(data, object_pairs_hook=lambda pairs: Pairs([list(p) for p in pairs]))


def spelled(value: Any) -> str:
    if isinstance(value, Raw):
        return str(value)
    if isinstance(value, Pairs):
        return "{" + ", ".join(f"{spelled(k)}: {spelled(v)}" for k, v in value) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(spelled, value)) + "]"
    return json.dumps(value)


VALUES = st.one_of(
    st.sampled_from(
        [
            *map(Raw, ("NaN", "Infinity", "-Infinity", "1e999", "-1e999", "1e-400", "-0", "-0.0")),
            *map(Raw, ("1E5", "01", "+1", ".5", "1.", "0x10", "1_000", "nan", "None", "'1'")),
            *map(Raw, ("9" * 300, "9" * 400, "9" * 4300, "9" * 5000, "0." + "7" * 500, "1e6")),
            *map(Raw, ("2" * 19, "9" * 20, "9007199254740993", "9007199254740993.0", "1000001")),
            *map(Raw, ('"\\ud83d"', '"\\ud83d\\ude00"', '"\\u0000"', '"\x1b[2J"', "")),
            *(Raw("[" * n + "]" * n) for n in (1, 60, 70, 1000, 50_000)),
            *(None, True, False, 0, 1, -1, 0.0, "0.5", "", "x" * 300, [], Pairs(), [[0.1, 0.2]]),
            Pairs([["x", 0.5], ["y", 0.5]]),
            [Pairs([["x", 0.5], ["y", 0.5], ["occluded", True]])],
        ]
    ),
    st.floats(allow_nan=False, allow_infinity=False),
    st.integers(),
    st.text(max_size=5).map(lambda text: Raw(json.dumps(text))),
)
NUMBERS = st.one_of(
    st.floats(-2, 2),
    st.floats(-2, 2).map(lambda number: Raw(f"{number:.25f}")),
    st.integers(-(10**6), 10**6),
    st.sampled_from([*map(Raw, ("-0", "-0.0", "1E5", "1e-400", "9007199254740993"))]),
    st.floats(allow_nan=False, allow_infinity=False),
)
KEYS = st.one_of(
    st.sampled_from(["x", "y", "Circle left", " Circle left", "Goal left post left"]),
    st.sampled_from(["pan_degrees", "width", "height", "image_width", "image_height"]),
    st.sampled_from(["", "a:b", "\x1b", "k" * 999]),
    st.sampled_from([Raw('"\\u0078"'), Raw('"Circle\\u0020left"'), Raw('"\\ud83d"'), Raw("x")]),
    st.text(max_size=3),
)
ENCODINGS = (
    *["utf-8"] * 60,
    *["utf-8-sig"] * 4,
    *("utf-16", "utf-16-le", "utf-32", "latin-1", "cp500"),
)


def containers(document: Any) -> list[Any]:
    """All objects and lists of a document, outermost first."""
    found, waiting = [], [document]
    while waiting:
        value = waiting.pop(0)
        if isinstance(value, list):
            found.append(value)
            waiting.extend([v for _, v in value] if isinstance(value, Pairs) else value)
    return found


def change_once(draw: Callable[[Any], Any], document: Any) -> None:
    places = containers(document)
    if not places:
        return
    if draw(st.booleans()):
        change_number(draw, places)
        return
    # Few are near the top and decide most: as likely as all the points together.
    near = draw(st.booleans())
    place = places[draw(st.integers(0, min(len(places) - 1, 8 if near else 10**6)))]
    at = draw(st.integers(0, max(0, len(place) - 1)))
    is_object = isinstance(place, Pairs)
    action = draw(st.sampled_from(["replace", "replace", "insert", "delete", "repeat", "rename"]))
    if action == "insert" or not place:
        value = copy.deepcopy(draw(VALUES))
        place.insert(at, [draw(KEYS), value] if is_object else value)
    elif action == "delete":
        del place[at]
    elif action == "repeat":
        place.insert(draw(st.integers(0, len(place))), copy.deepcopy(place[at]))
    elif action == "rename" and is_object:
        place[at][0] = draw(KEYS)
    elif is_object:
        place[at][1] = copy.deepcopy(draw(VALUES))
    else:
        place[at] = copy.deepcopy(draw(VALUES))


def change_number(draw: Callable[[Any], Any], places: list[Any]) -> None:
    """Nearly always to another one that is accepted, so that keeping it is tested as well."""
    numbers = [
        (place, i)
        for place in places
        for i, value in enumerate(place)
        if isinstance(value[1] if isinstance(place, Pairs) else value, int | float)
    ]
    if not numbers:
        return
    place, i = numbers[draw(st.integers(0, len(numbers) - 1))]
    number = draw(NUMBERS)
    if isinstance(place, Pairs):
        place[i][1] = number
    else:
        place[i] = number


@st.composite
def changed_json(draw: Any, seeds: Sequence[bytes]) -> Any:
    """A valid file with values replaced, keys repeated, renamed, deleted; encoded, and cut off."""
    document = parsed(seeds[draw(st.integers(0, len(seeds) - 1))])
    for _ in range(draw(st.sampled_from([1, 1, 1, 2, 4]))):
        change_once(draw, document)
    data = spelled(document).encode(draw(st.sampled_from(ENCODINGS)), "replace")
    if draw(st.integers(0, 19)) == 19:
        data = data[: draw(st.integers(0, len(data)))]
    return data + draw(st.sampled_from([*[b"", b"\n"] * 20, b"\0", b"}", b" 1", b"//"]))


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=200)
@given(data=changed_json(ANNOTATIONS))
def test_annotations(judge, folder, data):
    path = folder / "00001.json"
    path.write_bytes(data)
    annotation = judge("annotation", str(path), lambda: read_annotation_file(path))
    if annotation is None:
        check_place(data)
    else:
        check_annotation(annotation, data)


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=125)
@given(data=changed_json(CAMERAS))
def test_cameras(judge, folder, data):
    path = folder / "camera_00001.json"
    path.write_bytes(data)
    loaded = judge("camera", str(path), lambda: read_camera()(path))
    if loaded is not None:
        check_pinhole(loaded, data)


# ----------------------------------------------------------------------------------- homographies

MATRIX_WORDS = st.one_of(
    st.sampled_from(["0", "1", "-1", "1e-4", "0.05", "640", "5e-324", "1e308", "-1e308"]),
    st.sampled_from(["nan", "inf", "1e999", "1_0", "١", "½", ",", ";", "[[1", "'1'", "1j"]),
    st.sampled_from(["9" * 400, "9" * 5000, "0." + "3" * 400, "1\x0b2", "\x1b"]),
    st.floats(-1000, 1000).map(repr),
)
HEADERS = st.sampled_from(
    [
        "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 3), }",
        "{'descr': '<f8', 'fortran_order': True, 'shape': (3, 3), }",
        "{'descr': '>f4', 'fortran_order': False, 'shape': (3, 3), }",
        "{'descr': '|i1', 'fortran_order': False, 'shape': (3, 3), }",
        "{'descr': '<u8', 'fortran_order': False, 'shape': (3, 3), }",
        "{'descr': '<f16', 'fortran_order': False, 'shape': (3, 3), }",
        "{'descr': '<f2', 'fortran_order': False, 'shape': (3L, 3L), }",
        "{'descr': '|O', 'fortran_order': False, 'shape': (3, 3), }",
        "{'descr': (), 'fortran_order': False, 'shape': (3, 3), }",
        "{'descr': 'a8', 'fortran_order': False, 'shape': (3, 3), }",
        "{'descr': [('a', '<f8')], 'fortran_order': False, 'shape': (3, 3), }",
        "{'descr': '<U1073741824', 'fortran_order': False, 'shape': (1, ), }",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (300000000, 90000)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999999999, 3)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (True, 9)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (-3, 3)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 3), 1: 2}",
        "{1: 2, 'a': 3}",
        "{[]: 1}",
        "-" * 9000 + "1",
        "(" * 9000,
        "[" * 150 + "]" * 150,
        "9" * 5000,
        "",
    ]
)


@st.composite
def built_homography(draw: Any) -> Any:
    if draw(st.booleans()):
        words = draw(st.lists(MATRIX_WORDS, min_size=8, max_size=10))
        return draw(st.sampled_from([" ", ",", "\n", "\r\n", " , "])).join(words).encode()
    header = draw(HEADERS)
    if draw(st.integers(0, 3)) == 0:
        at = draw(st.integers(0, len(header)))
        header = header[:at] + draw(st.sampled_from(["", "'", "0", "{", "\x00", "é"])) + header[at:]
    version = draw(st.sampled_from([1, 2, 3, 0, 9]))
    text = (header + "\n").encode("latin-1")
    length = (len(text) + draw(st.sampled_from([0, 0, 0, 1, -1, 9999]))) % 65536
    size = length.to_bytes(2 if version == 1 else 4, "little")
    return b"\x93NUMPY" + bytes([version, 0]) + size + text + draw(st.binary(max_size=144))


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=90)
@given(data=built_homography(), convention=st.sampled_from(["wc14", "carwc", "world"]))
def test_homographies(judge, folder, data, convention):
    path = folder / "1.npy"
    path.write_bytes(data)
    loaded = judge("homography", str(path), lambda: read_camera(convention)(path))
    if loaded is not None:
        as_homography(convention)(loaded, data)


# ----------------------------------------------------------------------------------------- fields

TOML_NUMBERS = st.one_of(
    st.sampled_from(["0", "-0.0", "1", "1e-9", "1e300", "1e999", "nan", "inf", "true", "1j"]),
    st.sampled_from(["9" * 400, "9" * 5000, "0x" + "f" * 5000, "0b1", "1_0", "01", "1979-05-27"]),
    st.floats(-200, 200).map(repr),
)
WORDS = st.sampled_from(
    [
        *("length", "width", "half_length", "circle_radius", "pi", "x", "lenght", "__import__"),
        *("1", "2.5", "9", "0", "1e308", "3999999", "'a'", "f'{9:>9999999}'", "[1]", "True"),
        *("sqrt(9)", "acos(2)", "sin(pi)", "atan2(1, 2)", "hypot()", "radians", "pi.hex()"),
        *("exit()", "(1).__class__", "lambda: 1", "9**9", "9**9**9", "1if 1else 2", "'a'*9999999"),
    ]
)
OPERATORS = st.sampled_from(
    [" + ", " - ", "*", "/", "//", "**", "%", " << ", " == ", " or ", ";", ",", " = ", ".", "("]
)


@st.composite
def formulas(draw: Any) -> Any:
    parts = [draw(WORDS)]
    for _ in range(draw(st.integers(0, 5))):
        parts += [draw(OPERATORS), draw(WORDS)]
    opened = draw(st.sampled_from(["", "", "-", "(", "-" * 150, "((((", "sqrt("]))
    return opened + "".join(parts) + ")" * opened.count("(") * draw(st.integers(0, 1))


TOML_VALUES = st.one_of(
    TOML_NUMBERS,
    formulas().map(json.dumps),
    st.lists(formulas(), max_size=4).map(json.dumps),
    st.sampled_from(['""', '" "', "[]", "{}", "{a = 1}", "[[1, 2], 3]", "'''", '"\\u001b[2J"']),
    st.sampled_from(["[" * 500 + "]" * 500, "[" * 5000, "{a=" * 300 + "1" + "}" * 300, ""]),
    st.sampled_from(['"line"', '"circle"', '"arc"', '"Middle line"', '"#FFFFFF"', '"#FFF"']),
    st.text(max_size=5).map(json.dumps),
)
ADDED = st.one_of(
    st.sampled_from(["[elements]", "[[elements]]", "[dimensions]", "[mirror]", "[formulas]", "]"]),
    st.sampled_from(["a.b = 1", "title" + ".a" * 30 + " = 1", "[" + "a." * 5000 + "a]", "\x00"]),
    st.tuples(st.sampled_from(["length", "radius", "name", '"Middle line"', "x"]), TOML_VALUES).map(
        " = ".join
    ),
)


@st.composite
def changed_fields(draw: Any) -> Any:
    """The soccer field with lines changed, doubled, dropped, added; encoded, and cut off."""
    lines = FIELD_LINES.copy()
    for _ in range(draw(st.sampled_from([1, 1, 1, 2, 4]))):
        at = draw(st.integers(0, len(lines) - 1))
        action = draw(
            st.sampled_from(["value", "value", "value", "number", "drop", "twice", "add"])
        )
        key, equals, _ = lines[at].partition(" = ")
        if action in ("value", "number") and equals:
            lines[at] = f"{key} = {draw(TOML_VALUES if action == 'value' else TOML_NUMBERS)}"
        elif action == "drop":
            del lines[at]
        elif action == "twice":
            lines.insert(draw(st.integers(0, len(lines))), lines[at])
        else:
            lines.insert(at, draw(ADDED))
    text = "\n".join(lines)
    if draw(st.integers(0, 29)) == 29:
        text = text[: draw(st.integers(0, len(text)))]
    return text.encode(draw(st.sampled_from([*["utf-8"] * 40, "utf-8-sig", "utf-16", "cp500"])))


# Changes that are accepted, so that keeping them is tested as well.
TEXTS = st.text(min_size=1, max_size=8).map(lambda text: json.dumps(f"a{text}", ensure_ascii=False))
SAME = {
    "title": TEXTS,
    "group": TEXTS,
    "source": TEXTS,
    "colour": st.integers(0, 0xFFFFFF).map(lambda rgb: f'"#{rgb:06x}"'),
    "half_length": st.sampled_from(["length*0.5", "length//2", "(length + 0.0) * 2**-1", "52.5"]),
    "half_width": st.sampled_from(["hypot(width, 0) / 2", "width - width / 2", "--width % 34.5"]),
}
SAME |= {key: SAME[key].map(json.dumps) for key in ("half_length", "half_width")}
PLACES = [(i, line.split(" = ")[0]) for i, line in enumerate(FIELD_LINES)]
PLACES = [(i, key) for i, key in PLACES if key in SAME]


@st.composite
def renamed_fields(draw: Any) -> Any:
    lines = FIELD_LINES.copy()
    for _ in range(draw(st.integers(1, 5))):
        at, key = draw(st.sampled_from(PLACES))
        lines[at] = f"{key} = {draw(SAME[key])}"
    return "\n".join(lines).encode()


def read_and_check_field(judge: Any, path: Path, data: bytes) -> None:
    path.write_bytes(data)
    field = judge("field", str(path), lambda: load_field(path))
    # A formula could run for hours; milliseconds are usual.
    assert judge.kinds["field"].worst_seconds < 20
    if field is not None:
        check_field(field, data, path)


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=25)
@given(data=changed_fields())
def test_fields(judge, folder, data):
    read_and_check_field(judge, folder / "field.toml", data)


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=25)
@given(data=renamed_fields())
def test_fields_with_other_values(judge, folder, data):
    read_and_check_field(judge, folder / "field.toml", data)


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=50)
@given(formula=formulas(), key=st.sampled_from(["half_width", "unused"]))
def test_fields_with_any_formula(judge, folder, formula, key):
    line = 'half_width = "width / 2"'
    assert line in FIELD_LINES
    changed = f"{key} = {json.dumps(formula)}" + (f"\n{line}" if key == "unused" else "")
    data = "\n".join(FIELD_LINES).replace(line, changed).encode()
    read_and_check_field(judge, folder / "field.toml", data)
