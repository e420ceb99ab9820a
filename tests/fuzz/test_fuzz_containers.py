"""Damaged field files, archives and pictures are refused in one clear line, or read as they are."""

from __future__ import annotations

import io
import json
import math
import tomllib
import zipfile
import zlib
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.field import load
from procc_annotator.field.load import load_field
from procc_annotator.field.sampling import sample_evenly, sample_official
from procc_annotator.formats.file_listing import list_annotations, list_cameras
from procc_annotator.formats.file_source import open_source
from procc_annotator.image.decoding import decode_bgra, decode_thumbnail
from procc_annotator.resources import resources_dir

Damage = Callable[[str, Sequence[bytes], int], Iterator[bytes]]
ROOT = Path(__file__).resolve().parents[2]
SAMPLE = ROOT / "sample_data"
SOCCER = (resources_dir() / "field" / "soccer.toml").read_text(encoding="utf-8")
# Half the elements take half the time and have all the kinds.
LINES = [line for line in SOCCER.splitlines() if line and not line.startswith("#")]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("fuzz")


# ----------------------------------------------------------------------------------------- fields

NUMBERS = st.one_of(
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


VALUES = st.one_of(
    NUMBERS,
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
    st.tuples(st.sampled_from(["length", "radius", "name", '"Middle line"', "x"]), VALUES).map(
        " = ".join
    ),
)


@st.composite
def changed_fields(draw: Any) -> Any:
    """The soccer field with lines changed, doubled, dropped, added; encoded, and cut off."""
    lines = LINES.copy()
    for _ in range(draw(st.sampled_from([1, 1, 1, 2, 4]))):
        at = draw(st.integers(0, len(lines) - 1))
        action = draw(
            st.sampled_from(["value", "value", "value", "number", "drop", "twice", "add"])
        )
        key, equals, _ = lines[at].partition(" = ")
        if action in ("value", "number") and equals:
            lines[at] = f"{key} = {draw(VALUES if action == 'value' else NUMBERS)}"
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
PLACES = [(i, line.split(" = ")[0]) for i, line in enumerate(LINES)]
PLACES = [(i, key) for i, key in PLACES if key in SAME]


@st.composite
def renamed_fields(draw: Any) -> Any:
    lines = LINES.copy()
    for _ in range(draw(st.integers(1, 5))):
        at, key = draw(st.sampled_from(PLACES))
        lines[at] = f"{key} = {draw(SAME[key])}"
    return "\n".join(lines).encode()


def check_field(judge: Any, path: Path, data: bytes) -> None:
    path.write_bytes(data)
    field = judge("field", str(path), lambda: load_field(path))
    # A formula could run for hours; milliseconds are usual.
    assert judge.kinds["field"].worst_seconds < 20
    if field is None:
        return
    load._field_from_text.cache_clear()  # or it would not be read again
    assert load_field(path) == field
    content = tomllib.loads(data.decode())
    for dimension in field.dimensions:
        for key, value in content["dimensions"][dimension.name].items():
            assert isinstance(value, str) or getattr(dimension, key) == value
    for element, entry in zip(field.elements, content["elements"], strict=True):
        for key in ("name", "title", "group", "colour", "shortcut"):
            assert getattr(element, key) == entry[key]
    for samples in (sample_official(field), sample_evenly(field, 1.0)):
        assert np.isfinite(samples.points_world).all()
        assert np.abs(samples.points_world).max() <= 2000
        assert len(samples.points_world) < 10**6
    assert all(math.isfinite(d.value) for d in field.dimensions)


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=25)
@given(data=changed_fields())
def test_fields_changed_in_structure(judge: Any, folder: Path, data: bytes) -> None:
    check_field(judge, folder / "field.toml", data)


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=25)
@given(data=renamed_fields())
def test_fields_with_other_words_are_read_as_they_are(
    judge: Any, folder: Path, data: bytes
) -> None:
    check_field(judge, folder / "field.toml", data)


@pytest.mark.laps
@settings(settings.get_profile("fuzz"), max_examples=50)
@given(formula=formulas(), key=st.sampled_from(["half_width", "unused"]))
def test_fields_with_any_formula(judge: Any, folder: Path, formula: str, key: str) -> None:
    line = 'half_width = "width / 2"'
    assert line in LINES
    changed = f"{key} = {json.dumps(formula)}" + (f"\n{line}" if key == "unused" else "")
    data = "\n".join(LINES).replace(line, changed).encode()
    check_field(judge, folder / "field.toml", data)


@pytest.mark.laps
def test_fields_changed_in_bytes(judge: Any, folder: Path, damage: Damage) -> None:
    for data in damage("field", [SOCCER.encode(), "\n".join(LINES).encode()], 37):
        check_field(judge, folder / "field.toml", data)


# --------------------------------------------------------------------------------------- archives


def zipped(members: dict[str, bytes], method: int = zipfile.ZIP_DEFLATED) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", method) as archive:
        for name, data in members.items():
            archive.writestr(zipfile.ZipInfo(name), data, method)
    return buffer.getvalue()


def archives() -> tuple[list[bytes], set[bytes]]:
    """Valid archives, and everything that stands in one of them."""
    annotations = {f.name: f.read_bytes() for f in sorted(SAMPLE.glob("0000*.json"))[:3]}
    cameras = {
        f"test/{f.name}": f.read_bytes() for f in sorted(SAMPLE.glob("cameras/true/*.json"))[:3]
    }
    small = {"1.json": b"{}", "camera_1.json": b"{}", "2.txt": b"1 0 0 0 1 0 0 0 1", "é/": b""}
    made = [
        zipped(annotations),
        zipped(cameras, zipfile.ZIP_STORED),
        zipped(small),
        zipped(small, zipfile.ZIP_BZIP2),
    ]
    return made, {*annotations.values(), *cameras.values(), *small.values()}


def check_archive(judge: Any, path: Path, data: bytes, contents: set[bytes]) -> None:
    path.write_bytes(data)
    source = judge("archive", str(path), lambda: open_source(path))
    if source is None:
        return
    with source:
        judge("archive", str(path), lambda: list_annotations(source), again=True)
        judge("archive", str(path), lambda: list_cameras(source), again=True)
        assert source.folders() == sorted(set(source.folders()), key=source.folders().index)
        for name in source.files()[:6]:
            read = judge("archive", str(path), partial(source.read, name), again=True)
            # What comes out is what was once put in, if under another name.
            assert read is None or read in contents


@pytest.mark.laps
def test_archives_changed_in_bytes(judge: Any, folder: Path, damage: Damage) -> None:
    seeds, contents = archives()
    for data in damage("archive", seeds, 150):
        check_archive(judge, folder / "z.zip", data, contents)


@pytest.mark.laps
def test_archives_changed_where_it_hurts(judge: Any, folder: Path, damage: Damage) -> None:
    """Most of an archive is content; here only its headers and its table are damaged."""
    seeds, contents = archives()
    for seed in seeds[2:]:
        start = seed.index(b"PK\x01\x02")
        for tail in damage(f"table {len(seed)}", [seed[start:]], 25):
            check_archive(judge, folder / "z.zip", seed[:start] + tail, contents)


# --------------------------------------------------------------------------------------- pictures


def pictures() -> dict[str, list[bytes]]:
    """Small pictures of each kind, plain and noisy, and one of a real size."""
    noise = np.random.default_rng(3).integers(0, 255, (36, 64, 3), dtype=np.uint8)
    plain = np.full((36, 64, 3), (40, 120, 200), dtype=np.uint8)
    alpha = np.dstack([noise, noise[..., 0]])
    made: dict[str, list[bytes]] = {}
    for suffix in (".jpg", ".png", ".bmp", ".webp"):
        shown = [noise, plain, noise[..., 0]] + ([alpha] if suffix == ".png" else [])
        made[suffix] = [cv2.imencode(suffix, picture)[1].tobytes() for picture in shown]
    made[".jpg"].append(cv2.imencode(".jpg", noise, [cv2.IMWRITE_JPEG_PROGRESSIVE, 1])[1].tobytes())
    made[".jpeg"] = [(SAMPLE / "00001.jpg").read_bytes()]
    return made


def mended(png: bytes) -> bytes:
    """A damaged PNG with a check sum that fits behind every chunk that can still be found."""
    data, at = bytearray(png), 8
    while at + 12 <= len(data):
        end = at + 8 + int.from_bytes(data[at : at + 4], "big")
        if end + 4 > len(data):
            break
        data[end : end + 4] = zlib.crc32(data[at + 4 : end]).to_bytes(4, "big")
        at = end + 4
    return bytes(data)


@pytest.mark.laps
@pytest.mark.parametrize(
    ("suffix", "count"),
    [(".jpg", 60), (".png", 40), (".bmp", 25), (".webp", 30), (".jpeg", 8)],
)
def test_pictures_changed_in_bytes(
    judge: Any, folder: Path, damage: Damage, suffix: str, count: int
) -> None:
    path = folder / f"frame{suffix}"
    for number, data in enumerate(damage(f"picture {suffix}", pictures()[suffix], count)):
        # Every second PNG gets its check sums mended, or none would come further than those.
        path.write_bytes(mended(data) if suffix == ".png" and number % 2 else data)
        for read in (decode_bgra, decode_thumbnail):
            again = read is decode_thumbnail
            picture = judge(f"picture {suffix}", str(path), partial(read, path), again=again)
            if picture is not None:
                assert picture.ndim == 3
                assert picture.shape[2] == 4
                assert picture.dtype == np.uint8
                assert not picture.flags.writeable
