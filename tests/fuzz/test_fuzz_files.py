"""Damaged annotations and cameras are refused in one clear line, or read without any change."""

from __future__ import annotations

import copy
import io
import json
import re
import warnings
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.camera.base import ElementProjections
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.errors import AnnotationError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation, write_annotation
from procc_annotator.formats.cameras.homography import CONVENTIONS
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera, fit_to_size
from procc_annotator.formats.cameras.registry import CAMERA_FORMATS, read_camera_file
from procc_annotator.formats.cameras.soccernet import write_camera

Damage = Callable[[str, Sequence[bytes], int], Iterator[bytes]]
ROOT = Path(__file__).resolve().parents[2]
SAMPLE = ROOT / "sample_data"
FIELD = load_field()
ANNOTATIONS = [f.read_bytes() for f in sorted(SAMPLE.glob("*.json"))]
CAMERAS = [f.read_bytes() for f in sorted(SAMPLE.glob("cameras/*/camera_*.json"))]
HOMOGRAPHIES = [f.read_bytes() for f in sorted(SAMPLE.glob("cameras/*/*.homographyMatrix"))]
WORLD = np.random.default_rng(5).uniform((-60, -40, -3), (60, 40, 0), (20, 3))


def npy(array: Any, version: tuple[int, int] | None = None) -> bytes:
    buffer = io.BytesIO()
    np.lib.format.write_array(buffer, array, version)
    return buffer.getvalue()


# ------------------------------------------------------------- JSON, damaged by its structure


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


# ----------------------------------------------------------------------------------- annotations


def check_annotation(judge: Any, kind: str, data: bytes) -> None:
    def read(content: bytes) -> Any:
        return read_annotation(content, path="00001.json", field=FIELD)

    annotation = judge(kind, "00001.json", lambda: read(data))
    if annotation is None:
        check_place(data)
        return
    written = write_annotation(annotation)
    again = read(written)
    assert write_annotation(again) == written
    assert again == annotation or b"NaN" in written
    content = json.loads(data.decode("utf-8-sig"))
    expected = {FIELD.canonical_name(key): value for key, value in content.items()}
    assert len(expected) == len(content)
    # As text, so that 1 and 1.0, 0.0 and -0.0 differ.
    assert json.dumps(json.loads(written), sort_keys=True) == json.dumps(expected, sort_keys=True)
    assert [p.class_name for p in annotation] == [k for k in expected if annotation.get(k)]


def check_place(data: bytes) -> None:
    """Where the file is a readable object, the error says where in it something is wrong."""
    try:
        content = json.loads(data.decode("utf-8-sig"))
    except (ValueError, RecursionError):
        return
    try:
        read_annotation(data, path="00001.json", field=FIELD)
    except AnnotationError as error:
        named = error.place or re.search("occurs twice|nested|half a character", error.problem)
        assert named or content == {} or "" in content, error  # noqa: PT017


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=200)
@given(data=changed_json(ANNOTATIONS))
def test_annotations_changed_in_structure(judge: Any, data: bytes) -> None:
    check_annotation(judge, "annotation", data)


@pytest.mark.laps
def test_annotations_changed_in_bytes(judge: Any, damage: Damage) -> None:
    for data in damage("annotation", ANNOTATIONS, 187):
        check_annotation(judge, "annotation", data)


# --------------------------------------------------------------------------------------- cameras


def check_camera(judge: Any, kind: str, data: bytes, name: str, fmt: str = "auto") -> None:
    loaded = judge(kind, name, lambda: read_camera_file(data, path=name, fmt=fmt))
    if loaded is None:
        return
    for camera_size in (None, (1280, 720)):
        camera, _ = fit_to_size(loaded, (960, 540), camera_size)
        if isinstance(camera, ElementProjections):
            continue
        px, valid = camera.project(WORLD)
        assert px.shape == (len(WORLD), 2)
        assert valid.dtype == bool
    if fmt not in ("auto", "soccernet", *CONVENTIONS):
        return
    if isinstance(loaded.camera, PinholeCamera):
        check_pinhole(loaded, data)
    else:
        check_homography(loaded.camera, data, fmt)


def check_pinhole(loaded: LoadedCamera, data: bytes) -> None:
    assert isinstance(loaded.camera, PinholeCamera)
    loaded.camera.project_float32(WORLD)
    written = write_camera(loaded.camera, loaded.content)
    again = read_camera_file(written, path="camera_1.json")
    assert again.camera == loaded.camera
    assert again.size == loaded.size
    assert repr(again.extra) == repr(loaded.extra)
    lists = {"radial": 6, "tangential": 2, "thin_prism": 4}
    absent = {f"{key}_distortion": [0.0] * n for key, n in lists.items()}
    expected = {**absent, **json.loads(data.decode("utf-8-sig"))}
    assert json.dumps(json.loads(written), sort_keys=True) == json.dumps(expected, sort_keys=True)


def check_homography(camera: Any, data: bytes, convention: str) -> None:
    """The numbers of the file, read by other means, belong to the camera."""
    assert isinstance(camera, HomographyCamera)
    if data.startswith(b"\x93NUMPY"):
        with warnings.catch_warnings():  # numpy remarks on headers that Python 2 wrote
            warnings.simplefilter("ignore")
            matrix = np.load(io.BytesIO(data), allow_pickle=False).astype(np.float64)
    else:
        matrix = np.array(re.split(r"[,\s]+", data.decode("utf-8-sig").strip(", \r\n\t")), float)
        matrix = matrix.reshape(3, 3)
    matrix = matrix / np.abs(matrix).max()
    rule = CONVENTIONS[convention]
    shift = np.diag([rule.unit_m, rule.unit_m, 1.0])
    shift[:2, 2] = -rule.unit_m * np.array(rule.centre)
    world_from_image = shift @ matrix
    if np.linalg.cond(world_from_image) < 1e7:
        product = camera.image_from_world @ world_from_image
        np.testing.assert_allclose(product / product[2, 2], np.eye(3), atol=1e-6)


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=125)
@given(data=changed_json(CAMERAS))
def test_cameras_changed_in_structure(judge: Any, data: bytes) -> None:
    check_camera(judge, "camera", data, "camera_00001.json")


@pytest.mark.laps
def test_cameras_changed_in_bytes(judge: Any, damage: Damage) -> None:
    for data in damage("camera", CAMERAS, 125):
        check_camera(judge, "camera", data, "camera_00001.json")


WORDS = st.one_of(
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
        words = draw(st.lists(WORDS, min_size=8, max_size=10))
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
@given(data=built_homography(), fmt=st.sampled_from(["wc14", "carwc", "world"]))
def test_homographies_built_from_odd_pieces(judge: Any, data: bytes, fmt: str) -> None:
    check_camera(judge, "homography", data, "1.npy", fmt)


@pytest.mark.laps
def test_homographies_changed_in_bytes(judge: Any, damage: Damage) -> None:
    matrix = np.array([[0.05, 0, 25.5], [0, 0.05, 19.0], [0, 1e-4, 1]])
    arrays = [npy(matrix), npy(matrix.astype(">f4")), npy(np.asfortranarray(matrix), (2, 0))]
    for i, data in enumerate(damage("homography", [*HOMOGRAPHIES, *arrays, *CAMERAS[:2]], 100)):
        check_camera(judge, "homography", data, "1.npy", ("wc14", "carwc", "world")[i % 3])


# ------------------------------------------------------------------------------------- real files


@pytest.mark.laps
def test_real_annotations_and_cameras_changed_in_bytes(
    judge: Any, damage: Damage, shared_data: Path
) -> None:
    real = shared_data / "wc14"
    annotations = [f.read_bytes() for f in sorted((real / "annotations").glob("*.json"))[::10]]
    cameras = [f.read_bytes() for f in sorted(real.glob("cameras_*/*.json"))[::10]]
    homographies = [f.read_bytes() for f in sorted(real.glob("homographies_carwc/*.npy"))[::10]]
    for data in damage("real annotation", annotations, 37):
        check_annotation(judge, "real files", data)
    for data in damage("real camera", cameras, 37):
        check_camera(judge, "real files", data, "camera_1.json")
    for data in damage("real homography", homographies, 37):
        check_camera(judge, "real files", data, "1.npy", "carwc")


def test_every_format_takes_every_kind_of_file(judge: Any) -> None:
    for data in (ANNOTATIONS[0], CAMERAS[0], HOMOGRAPHIES[0], npy(np.eye(3)), b"", b"\0" * 99):
        for fmt in CAMERA_FORMATS[1:]:
            check_camera(judge, "camera", data, "1.txt", fmt)
