"""Formats that keep poses and intrinsics in two files: COLMAP (text, binary), EasyMocap.

Facts on COLMAP: https://colmap.github.io/format.html and https://colmap.github.io/cameras.html; the
numbers of the binary models are those of its ``sensor/models.h``. A
pose is world -> camera with axes as here (x right, y down, z forward), its rotation a quaternion
w x y z.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import PurePosixPath
from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.json_values import is_camera_key
from procc_annotator.formats.cameras.krt import centred_k, krt_from
from procc_annotator.formats.cameras.loaded_camera import (
    CameraFormat,
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    frame_of_image,
)
from procc_annotator.formats.cameras.opencv import storage_numbers
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.strict_json import finite_number, printable, utf8_text

CAMERAS = "the file of lenses"
# Parameters of each model in their order; those of one focal length have fx = fy.
_MODELS: dict[str, tuple[str, ...]] = {
    "SIMPLE_PINHOLE": ("f", "cx", "cy"),
    "PINHOLE": ("fx", "fy", "cx", "cy"),
    "SIMPLE_RADIAL": ("f", "cx", "cy", "k1"),
    "RADIAL": ("f", "cx", "cy", "k1", "k2"),
    "OPENCV": ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2"),
    "FULL_OPENCV": (
        "fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6",
    ),
    "OPENCV_FISHEYE": ("fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4"),
    "SIMPLE_RADIAL_FISHEYE": ("f", "cx", "cy", "k1"),
    "RADIAL_FISHEYE": ("f", "cx", "cy", "k1", "k2"),
}  # fmt: skip
# Binary files number the models and do not say how many parameters follow.
_NUMBERED_MODELS = (
    "SIMPLE_PINHOLE", "PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV", "OPENCV_FISHEYE",
    "FULL_OPENCV", "FOV", "SIMPLE_RADIAL_FISHEYE", "RADIAL_FISHEYE", "THIN_PRISM_FISHEYE",
    "RAD_TAN_THIN_PRISM_FISHEYE",
)  # fmt: skip
_UNREAD_MODELS = {"FOV": 5, "THIN_PRISM_FISHEYE": 12, "RAD_TAN_THIN_PRISM_FISHEYE": 16}
_PINHOLE_TERMS = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")
_FISHEYE_TERMS = ("k1", "k2", "k3", "k4")
# Id -> model, width, height and parameters, as they are spelled.
Lenses = dict[str, tuple[str, ...]]
_POSE_WORDS = 10  # id, four of the quaternion, three of t, the lens's id, the name


def colmap_records(images: bytes, cameras: bytes, path: str, cameras_path: str) -> CameraRecords:
    """The camera of every picture of a model. `CameraError` if it is damaged, or without a
    picture."""
    if cameras_path.lower().endswith(".bin"):
        lenses = _Binary(cameras, cameras_path).lenses()
        poses = _Binary(images, path).poses()
    else:
        lenses = _lenses(cameras, cameras_path)
        poses = ((f"line {n}", words) for n, words in _poses(utf8_text(images, path)))
    found: list[tuple[str, CameraRecord]] = []
    for place, words in poses:
        name = " ".join(words[_POSE_WORDS - 1 :])
        if not frame_of_image(name):
            raise CameraError(path, "expected the name of a picture", place=place)
        found.append((name, CameraRecord(place, (words, lenses))))
    return CameraRecords.of(
        path, found, _colmap_camera, (), "pictures as IMAGE_ID QW QX QY QZ TX TY TZ ..."
    )


def _colmap_camera(
    content: tuple[list[str], dict[str, tuple[str, ...]]], path: str, at: str
) -> LoadedCamera:
    words, lenses = content
    numbers = _numbers(words[1:8], path, at)
    lens = lenses.get(words[8])
    if lens is None:
        raise CameraError(
            path, f"names the camera {printable(words[8])!r}, which {CAMERAS} has not", place=at
        )
    model, width, height, *given = lens
    names = _MODELS.get(model)
    if names is None:
        raise CameraError(
            path,
            f"is of a lens of the model {printable(model)!r}; {', '.join(_MODELS)} are read",
            place=at,
            advice="undistort the pictures with COLMAP, and take the model it writes",
        )
    if len(given) != len(names):
        raise CameraError(
            path, f"expected {len(names)} parameters of {model}, found {len(given)}", place=at
        )
    of = dict(zip(names, _numbers(given, path, at), strict=True))
    fx, fy = (of.get(key, of.get("f", 0.0)) for key in ("fx", "fy"))
    fisheye = model.endswith("FISHEYE")
    terms = _FISHEYE_TERMS if fisheye else _PINHOLE_TERMS
    own = {
        "model": "fisheye" if fisheye else "pinhole",
        "K": centred_k(fx, fy, of["cx"], of["cy"]),
        "R": _rotation(numbers[:4], path, at).tolist(),
        "t": numbers[4:],
        "dist": [of.get(term, 0.0) for term in terms],
        **dict(zip(("width", "height"), _numbers([width, height], path, at), strict=True)),
    }
    return krt_from(own, path, at)


def _rotation(quaternion: list[float], path: str, at: str) -> FloatArray:
    """(3, 3) of w, x, y, z, which need not be of length 1."""
    length = math.hypot(*quaternion)
    if not 0 < length < math.inf:
        raise CameraError(path, "expected a quaternion that is not 0", place=at)
    w, x, y, z = (number / length for number in quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _lenses(data: bytes, path: str) -> Lenses:
    found: Lenses = {}
    for number, line in enumerate(utf8_text(data, path).splitlines(), 1):
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        if len(words) < 5:
            raise CameraError(
                path,
                "expected CAMERA_ID MODEL WIDTH HEIGHT PARAMS ...",
                place=f"line {number}",
                advice="the file may be cut off",
            )
        found[words[0]] = tuple(words[1:])
    return found


def _poses(text: str) -> Iterable[tuple[int, list[str]]]:
    """(line number, words) of the lines with poses; a line of seen points follows each."""
    points = False
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if words and words[0].startswith("#"):
            continue
        if points and (not words or _is_points(words)):
            points = False
            continue
        if not words:
            continue
        # A line that is too short is one for the reader to complain about.
        yield number, [*words, *[""] * (_POSE_WORDS - len(words))]
        points = True


class _Binary:
    """A binary file of COLMAP, little-endian: a count, then as many entries."""

    def __init__(self, data: bytes, path: str) -> None:
        self._data, self._path, self._at = data, path, 0

    def lenses(self) -> Lenses:
        """As of `_lenses`."""
        found: Lenses = {}
        for i in range(self._take("<Q")[0]):
            own, kind, width, height = self._take("<iiQQ")
            model = _NUMBERED_MODELS[kind] if 0 <= kind < len(_NUMBERED_MODELS) else ""
            if not model:
                raise CameraError(
                    self._path, f"is of a lens of the model number {kind}, which is not known",
                    place=f"camera {i + 1}", advice="write it as text: colmap model_converter"
                    " --output_type TXT",
                )  # fmt: skip
            count = _UNREAD_MODELS.get(model) or len(_MODELS[model])
            numbers = self._take(f"<{count}d")
            found[str(own)] = (model, str(width), str(height), *map(repr, numbers))
        return found

    def poses(self) -> Iterator[tuple[str, list[str]]]:
        """(place, words) of each picture, as of a line of the text file."""
        for i in range(self._take("<Q")[0]):
            own, *pose, lens = self._take("<i7di")
            end = self._data.find(b"\0", self._at)
            if end < 0:
                raise self._cut()
            name = self._data[self._at : end].decode("utf-8", "backslashreplace")
            self._at = end + 1
            features = self._take("<Q")[0]
            self._at += 24 * features  # x, y and the point of each
            if self._at > len(self._data):
                raise self._cut()
            yield f"image {i + 1}", [str(own), *map(repr, pose), str(lens), name]

    def _take(self, layout: str) -> tuple[Any, ...]:
        size = struct.calcsize(layout)
        if self._at + size > len(self._data):
            raise self._cut()
        self._at += size
        return struct.unpack_from(layout, self._data, self._at - size)

    def _cut(self) -> CameraError:
        return CameraError(
            self._path, "ends within an entry", place=f"byte {len(self._data)}",
            advice="the file may be cut off: copy it again",
        )  # fmt: skip


def _is_points(words: list[str]) -> bool:
    return len(words) % 3 == 0 and all(word[:1] in "-+.0123456789" for word in words)


def _numbers(words: Iterable[str], path: str, at: str) -> list[float]:
    found = []
    for word in words:
        number = finite_number(word)
        if number is None:
            raise CameraError(
                path, f"expected a finite number, found {printable(word, 40)!r}", place=at,
                advice="the file may be cut off",
            )  # fmt: skip
        found.append(number)
    return found


_LENS = {"K_": "K", "dist_": "dist", "W_": "width", "H_": "height"}
_POSE = {"Rot_": "R", "R_": "rvec", "T_": "t"}


def easymocap_records(
    extrinsics: bytes, intrinsics: bytes, path: str, intrinsics_path: str
) -> CameraRecords:
    """The named cameras of a pair of files.

    Raises:
        CameraError: damaged, or no camera in both.
    """
    poses, left = _by_name(extrinsics, path, _POSE)
    lenses, other = _by_name(intrinsics, intrinsics_path, _LENS)
    left |= other | {f"lens of {name}" for name in lenses.keys() - poses.keys()}
    found = [
        (name, CameraRecord(f"camera {name}", {**lenses.get(name, {}), **pose}))
        for name, pose in poses.items()
    ]
    notices = (f"not used: {printable(', '.join(sorted(left)), 200)}",) if left else ()
    return CameraRecords.of(path, found, krt_from, notices, "Rot_NAME (or R_NAME) and T_NAME")


def _by_name(
    data: bytes, path: str, parts: dict[str, str]
) -> tuple[dict[str, dict[str, Any]], set[str]]:
    """Return the numbers of each camera, and the camera keys that are not read."""
    others: set[str] = set()

    def wanted(names: set[str]) -> list[str]:
        own = sorted(n for n in names if n.startswith(tuple(parts)))
        others.update(n for n in names.difference(own) if is_camera_key(n) or n[1:2] == "_")
        return own

    content = storage_numbers(data, path, wanted)
    found: dict[str, dict[str, Any]] = {}
    for key, value in content.items():
        start = next(part for part in parts if key.startswith(part))
        found.setdefault(key[len(start) :], {})[parts[start]] = value
    return found, others


def paired_records(
    formats: Iterable[CameraFormat],
    source: FileSource,
    files: Mapping[str, str],
    fmt: str,
    about_to_read: Callable[[str], None],
) -> dict[str, CameraRecords]:
    """File of poses -> its cameras, for each pair that a source has, of one format: at its top, or
    in each folder of a tree.

    Args:
        files: frame name, as if each file were a frame's -> file to look at.
        fmt: what was asked for: ``auto``, or a name.

    Raises:
        CameraError: one of a pair is there without the other, or it was asked for and none is.
        InputError: damaged, or not readable.
    """
    for known in formats:
        if fmt not in ("auto", known.name):
            continue
        assert known.read_pair is not None
        pairs = _pairs(source, known, files, asked_for=fmt != "auto")
        found = {}
        for folder, (poses, lenses) in pairs.items():
            about_to_read(poses)
            data = source.read(poses), source.read(lenses)
            shown = source.display(poses), source.display(lenses)
            found[poses] = known.read_pair(*data, *shown).below(folder)
        if found:
            return found
    return {}


def _pairs(
    source: FileSource, known: CameraFormat, files: Mapping[str, str], asked_for: bool
) -> dict[str, tuple[str, str]]:
    """Folder that frames are called by -> both files of the pair in it."""
    by_folder: dict[str, dict[str, str]] = {"": {}} if asked_for and not files else {}
    for frame, file in files.items():
        name = PurePosixPath(file).name.lower()
        by_folder.setdefault(frame.rpartition("/")[0], {})[name] = file
    found = {}
    for folder, by_name in by_folder.items():
        there = [(by_name.get(poses), by_name.get(lenses)) for poses, lenses in known.pairs]
        whole = [(poses, lenses) for poses, lenses in there if poses and lenses]
        half = [pair for pair, (poses, _) in zip(known.pairs, there, strict=True) if poses]
        if whole:
            found[folder] = whole[0]
        elif half or asked_for:  # cameras.txt and intri.yml alone may be anything
            missing = half[0][1] if half else known.pairs[0][0]
            raise CameraError(
                source.path / folder,
                f"is without {missing}, expected {both_names(known.pairs)} side by side",
                advice="give the folder that holds both",
            )
    return found


def raise_half_of_pair(data: bytes, *, path: str, known: Sequence[tuple[str, str]]) -> LoadedCamera:
    """No file of a pair is a camera alone.

    Raises:
        CameraError: always.
    """
    raise CameraError(
        path,
        f"is one file, expected {both_names(known)} side by side",
        advice="give the folder that holds both",
    )


def both_names(pairs: Sequence[tuple[str, str]]) -> str:
    """Return the names of the files of a format of two."""
    return " or ".join(f"{poses} and {lenses}" for poses, lenses in pairs)
