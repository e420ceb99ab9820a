"""MATLAB files of level 5: what scipy writes and reads, and files that are damaged."""

import io
import struct
import zlib
from typing import Any

import numpy as np
import pytest
import scipy

from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.arrays import matlab_content

STRUCTURE: dict[str, Any] = {
    "image_name": "1.jpg",
    "homography": np.arange(9.0).reshape(3, 3) / 7,
    "deep": {"focal": 1234.5, "names": np.array(["a", "bc"], dtype=object)},
}
CONTENT: dict[str, Any] = {
    "K": np.array([[1000.0, 0, 640], [0, 1000, 360], [0, 0, 1]]),
    "stack": np.arange(24, dtype=np.int16).reshape(2, 3, 4),
    "width": np.uint16(1280),
    "row": np.linspace(0, 1, 5, dtype=np.float32),
    "title": "Stade de la Paix, é",
    "cells": np.array([1.5, "two", np.eye(2)], dtype=object),
    "annotation": np.array([STRUCTURE, STRUCTURE], dtype=object),
    "one": STRUCTURE,
    "seen": np.array([True, False]),
    "empty": np.zeros((0, 3)),
}


def written(content: dict[str, Any], *, compressed: bool = False) -> bytes:
    file = io.BytesIO()
    scipy.io.savemat(file, content, do_compression=compressed)
    return file.getvalue()


def plain(value: Any) -> Any:
    """What scipy reads, as nested lists."""
    if isinstance(value, dict):
        return {key: plain(entry) for key, entry in value.items()}
    if isinstance(value, list) or (isinstance(value, np.ndarray) and value.dtype == object):
        return [plain(entry) for entry in value]
    return value.tolist() if isinstance(value, np.ndarray | np.generic) else value


@pytest.mark.parametrize("compressed", [False, True])
def test_it_reads_what_scipy_reads(compressed):
    data = written(CONTENT, compressed=compressed)
    found = matlab_content(data, "1.mat")
    theirs = scipy.io.loadmat(io.BytesIO(data), simplify_cells=True)
    assert found.keys() == CONTENT.keys()
    for name in found:
        assert found[name] == plain(theirs[name]), name


def test_what_is_no_part_of_a_camera_is_none():
    found = matlab_content(written({"z": np.array([1j, 2.0]), "K": np.eye(3)}), "1.mat")
    assert found["z"] is None
    assert found["K"] == np.eye(3).tolist()


def test_files_of_the_other_byte_order():
    """As a SPARC wrote them: one variable, 2 x 2 numbers, named k."""
    name = struct.pack(">HH4s", 1, 1, b"k")  # a small element: length and type in one word
    inner = (
        struct.pack(">IIII", 6, 8, 6, 0)
        + struct.pack(">IIii", 5, 8, 2, 2)
        + name
        + struct.pack(">II4d", 9, 32, 1.0, 2.0, 3.0, 4.0)
    )
    header = b"MATLAB 5.0 MAT-file".ljust(124) + b"\x01\x00MI"
    data = header + struct.pack(">II", 14, len(inner)) + inner
    assert matlab_content(data, "1.mat") == {"k": [[1.0, 3.0], [2.0, 4.0]]}


@pytest.mark.parametrize("compressed", [False, True])
def test_a_file_cut_off_anywhere_is_one_line(compressed):
    data = written({"K": np.eye(3), "one": STRUCTURE}, compressed=compressed)
    whole = matlab_content(data, "1.mat")
    for length in range(len(data)):
        try:
            found = matlab_content(data[:length], "1.mat")
        except CameraError as error:
            assert "\n" not in str(error)  # noqa: PT017
            assert "MATLAB file of level 5" in str(error)  # noqa: PT017
        else:  # between two variables: nothing tells that more was there
            assert found.items() <= whole.items()
            assert len(found) < len(whole)


def test_a_part_that_grows_without_end_is_refused():
    bomb = zlib.compress(bytes(70 * 1024 * 1024), 9)
    header = b"MATLAB 5.0 MAT-file".ljust(124) + b"\x00\x01IM"
    with pytest.raises(CameraError, match="too large"):
        matlab_content(header + struct.pack("<II", 15, len(bomb)) + bomb, "1.mat")


@pytest.mark.parametrize("numbers", [False, True])
@pytest.mark.parametrize("shape", [(2**31 - 1, 0), (2**31 - 1, 3), (0, 2**31 - 1), (1,) * 70])
def test_dimensions_of_no_bounds_take_no_memory(shape, numbers):
    """Texts of so many lines, or so many empty lists, were more than any machine holds."""

    def part(kind: int, data: bytes) -> bytes:
        return struct.pack("<II", kind, len(data)) + data + bytes(-len(data) % 8)

    dimensions = struct.pack(f"<{len(shape)}i", *shape)
    content = part(9, b"") if numbers else part(16, b"" if 0 in shape else b"abc")
    variable = (
        part(6, struct.pack("<II", 6 if numbers else 4, 0))
        + part(5, dimensions)
        + part(1, b"v")
        + content
    )
    data = b"MATLAB 5.0 MAT-file".ljust(124) + b"\x00\x01IM" + part(14, variable)
    if len(shape) == 2 and 0 in shape:
        assert matlab_content(data, "1.mat") == {"v": [] if numbers else ""}
    else:
        with pytest.raises(CameraError, match=r"expected|dimensions"):
            matlab_content(data, "1.mat")


@pytest.mark.laps
def test_damaged_bytes_are_an_error_or_another_value(shared_data, lap):
    """Uncompressed, so that a changed byte is a changed type, length or number."""
    rng = np.random.default_rng(3 + lap)
    seeds = [written(CONTENT)]
    for file in sorted((shared_data / "foreign").glob("*.mat")):
        theirs = scipy.io.loadmat(file)
        seeds.append(written({k: v for k, v in theirs.items() if not k.startswith("__")}))
    assert len(seeds) > 1
    refused = 0
    for i in range(200):
        seed = seeds[i % len(seeds)]
        data = bytearray(seed)
        for _ in range(rng.integers(1, 4)):
            at = rng.integers(124, min(len(data), 2500))
            data[at] = rng.choice([0, 1, 128, 255, rng.integers(256)])
        try:
            matlab_content(bytes(data), "1.mat")
        except CameraError as error:
            refused += 1
            assert "\n" not in str(error)  # noqa: PT017
    assert refused > 33
