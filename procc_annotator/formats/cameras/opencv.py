"""OpenCV FileStorage cameras (YAML, XML, JSON), pinhole or fisheye.

See docs/reference/camera-formats.md for the keys.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from itertools import chain
from typing import Any

import numpy as np

from procc_annotator.camera.models import FisheyeCamera, PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.json_values import (
    SIZE_KEYS,
    JsonValues,
    is_camera_key,
    maps_objects,
)
from procc_annotator.formats.cameras.krt import KRT_KEYS, camera_of_matrices, krt_content
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera
from procc_annotator.formats.strict_json import utf8_text
from procc_annotator.formats.unread_formats import unread_format

KIND = "an OpenCV calibration"
# Of OpenCV's calibration sample: the poses of its boards.
_BOARDS = ("extrinsic_parameters",)
_LARGEST_FILE = 5 * 1024 * 1024  # a calibration may hold every point it was made from
_MOST_NUMBERS = 64  # of a matrix that belongs to a camera
# OpenCV's parsers call themselves for every level and end the program when there are too many.
_DEEPEST = 64


def read_opencv(data: bytes, *, path: str) -> LoadedCamera:
    """Read a camera from YAML, XML or JSON as ``cv::FileStorage`` writes it.

    Rotation and translation take this project's world (metres) to the camera, as everywhere.

    Raises:
        CameraError: names the key and what was expected.
    """
    try:
        content = _content(data, path)
        return camera_of_matrices(JsonValues(content, path, kind=KIND), KRT_KEYS)
    except CameraError as error:
        if (unread := unread_format(path, data)) is None:
            raise
        raise CameraError(path, unread.problem, advice=unread.advice) from error


def is_storage(content: object) -> bool:
    """Return whether decoded JSON is a FileStorage's: one of its entries is a matrix."""
    return maps_objects(content, {"rows", "cols", "data"})


def storage_numbers(
    data: bytes, path: str, wanted: Callable[[set[str]], Iterable[str]]
) -> dict[str, Any]:
    """The numbers of the wanted keys of a FileStorage, matrices as lists of rows, vectors flat.
    `CameraError` if it is damaged, or no FileStorage."""
    import cv2  # most sets have none of these files

    text = _text(data, path)
    try:
        storage = cv2.FileStorage(text, cv2.FILE_STORAGE_READ | cv2.FILE_STORAGE_MEMORY)
        root = storage.root()
        if not root.isMap():
            raise _unreadable(path)
        names = set(root.keys())
        values = JsonValues({}, path)
        return {
            key: _value(root.getNode(key), values, key) for key in wanted(names) if key in names
        }
    except (cv2.error, SystemError, UnicodeDecodeError, MemoryError) as error:
        raise _unreadable(path) from error


def write_opencv(camera: PinholeCamera | FisheyeCamera, size: tuple[int, int] | None) -> bytes:
    """A camera as YAML that ``cv::FileStorage`` reads, every number as it is. `ValueError` as
    `krt_content`."""
    content = krt_content(camera, size)
    lines = ["%YAML:1.0", "---"]
    if size is not None:
        lines += [f"image_width: {size[0]}", f"image_height: {size[1]}"]
    lines.append(f"model: {content['model']}")
    distortion = content["dist"]
    for key, rows, columns, numbers in (
        ("camera_matrix", 3, 3, np.ravel(content["K"])),
        ("distortion_coefficients", len(distortion), 1, distortion),
        ("R", 3, 3, np.ravel(content["R"])),
        ("tvec", 3, 1, content["t"]),
    ):
        spelled = ", ".join(_spelled(number) for number in numbers)
        lines += [
            f"{key}: !!opencv-matrix", f"   rows: {rows}", f"   cols: {columns}", "   dt: d",
            f"   data: [ {spelled} ]",
        ]  # fmt: skip
    return ("\n".join(lines) + "\n").encode()


def _spelled(number: float) -> str:
    text = repr(float(number))
    return text if any(c in text for c in ".en") else f"{text}."


def _text(data: bytes, path: str) -> str:
    if len(data) > _LARGEST_FILE:
        raise CameraError(
            path,
            f"is larger than {_LARGEST_FILE >> 20} MB, expected one calibration",
            advice="is it this file?",
        )
    text = utf8_text(data, path)
    if not text.strip():
        raise CameraError(path, "is empty, expected an OpenCV calibration")
    if _depth(text) > _DEEPEST:
        raise CameraError(path, "is nested too deeply to be read", advice="is it this file?")
    return text


def _depth(text: str) -> int:
    """No less than how deeply brackets, tags, indentation or ``- - -`` nest anywhere in a text."""
    # Brackets in quotes and comments are counted too: a camera has neither in such numbers.
    opened = deepest = 0
    for found in re.finditer(r"[\[{]|[\]}]", text):
        opened = opened + 1 if found[0] in "[{" else max(opened - 1, 0)
        deepest = max(deepest, opened)
    tags = 0
    for found in re.finditer(r"<(/?)[^<>]{0,400}?(/?)>|<", text):
        if found[1]:
            tags = max(tags - 1, 0)
        elif not found[2] and not found[0].startswith(("<?", "<!")):
            tags += 1
        deepest = max(deepest, tags)
    indented: list[int] = []
    for line in text.splitlines():
        body = line.lstrip(" \t")
        deepest = max(deepest, *(len(run) // 2 for run in re.findall(r"(?:-[ \t]+)+", body)), 0)
        indent = len(line) - len(body)
        while indented and indented[-1] >= indent:
            indented.pop()
        indented.append(indent)
        deepest = max(deepest, len(indented))
    return deepest


def _content(data: bytes, path: str) -> dict[str, Any]:
    wanted = {*KRT_KEYS.used, *chain(*SIZE_KEYS)}
    others: set[str] = set()

    def note(names: set[str]) -> set[str]:
        others.update(filter(is_camera_key, names - wanted - {*_BOARDS}))
        return wanted

    content = storage_numbers(data, path, note)
    # Of the others only the names count: they may hold anything.
    return content | dict.fromkeys(others, True)


def _unreadable(path: str) -> CameraError:
    return CameraError(
        path,
        "is not a readable OpenCV FileStorage (YAML, XML or JSON)",
        advice="the file may be cut off: write it again with cv::FileStorage",
    )


def _value(node: Any, values: JsonValues, key: str) -> Any:
    if node.isInt() or node.isReal():
        return float(node.real())
    if node.isString():
        return str(node.string())
    if node.isMap():
        return _matrix(node, values, key)
    return _rows(node, values, key) if node.isSeq() else None


def _matrix(node: Any, values: JsonValues, key: str) -> list[Any]:
    # Never `mat()`: it makes room for as many numbers as the file announces.
    parts: Mapping[str, Any] = {name: node.getNode(name) for name in list(node.keys())}
    if {"sizes", "data"} <= parts.keys():  # how OpenCV 5 writes a vector
        sizes = _rows(parts["sizes"], values, key) if parts["sizes"].isSeq() else []
        sizes = sizes or [float(parts["sizes"].real())]
        if len(sizes) > 2 or any(type(size) is not float for size in sizes):
            found = f"has {len(sizes)} dimensions"
            raise values.error(f"{found}, expected a vector or a matrix", key)
        rows, columns = (*sizes, 1.0)[:2]
    elif {"rows", "cols", "data"} <= parts.keys():
        rows, columns = (float(parts[name].real()) for name in ("rows", "cols"))
    else:
        raise values.error("expected a matrix", key)
    numbers = _rows(parts["data"], values, key) if parts["data"].isSeq() else []
    if not (rows * columns == len(numbers) and rows == int(rows) and columns == int(columns)):
        problem = f"announces {rows:g} x {columns:g} numbers, found {len(numbers)}"
        raise values.error(problem, key, "the file may be cut off")
    # A row or a column is a vector: no one agrees on which it is.
    if min(rows, columns) <= 1:
        return numbers
    return np.array(numbers, dtype=object).reshape(-1, int(columns)).tolist()


def _rows(node: Any, values: JsonValues, key: str) -> list[Any]:
    count = int(node.size())
    if count > _MOST_NUMBERS:
        raise values.error(f"has {count} entries, more than a camera's matrix has", key, "")
    found: list[Any] = []
    for i in range(count):
        entry = node.at(i)
        if entry.isSeq():
            found.append(_rows(entry, values, f"{key}[{i}]"))
        elif entry.isInt() or entry.isReal():
            found.append(float(entry.real()))
        else:
            raise values.error("expected a number", f"{key}[{i}]")
    return found
