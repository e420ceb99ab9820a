"""COLMAP text models: ``images.txt`` with poses, ``cameras.txt`` with intrinsics.

Facts: https://colmap.github.io/format.html and https://colmap.github.io/cameras.html. A pose is
world -> camera with axes as here (x right, y down, z forward), its rotation a quaternion w x y z.
Pixels count from the corner of the picture, not from the centre of its first pixel.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from procc_annotator.camera.base import FloatArray
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.krt import krt_from
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    frame_of_image,
)
from procc_annotator.formats.strict_json import printable

IMAGES, CAMERAS = "images.txt", "cameras.txt"
CORNER = 0.5  # px from the corner of a picture to the centre of its first pixel
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
_PINHOLE_TERMS = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")
_FISHEYE_TERMS = ("k1", "k2", "k3", "k4")
# Id -> model, width, height and parameters, as they are spelled.
Lenses = dict[str, tuple[str, ...]]
_POSE_WORDS = 10  # id, four of the quaternion, three of t, the lens's id, the name


def colmap_records(images: bytes, cameras: bytes, *, path: str, cameras_path: str) -> CameraRecords:
    """The camera of every picture of a model.

    Args:
        images, cameras: the two files. path, cameras_path: for messages.

    Raises:
        CameraError: damaged, or without a picture.
    """
    lenses = _lenses(cameras, cameras_path)
    found: list[tuple[str, CameraRecord]] = []
    for number, words in _poses(_text(images, path)):
        place = f"line {number}"
        name = " ".join(words[_POSE_WORDS - 1 :])
        if not frame_of_image(name):
            raise CameraError(path, "expected the name of a picture", place=place)
        found.append((name, CameraRecord(place, (words, lenses))))
    if not found:
        raise CameraError(path, "lists no picture, expected IMAGE_ID QW QX QY QZ TX TY TZ ...")
    return CameraRecords.of(path, found, _camera)


def _camera(
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
        "K": [[fx, 0.0, of["cx"] - CORNER], [0.0, fy, of["cy"] - CORNER], [0.0, 0.0, 1.0]],
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
    for number, line in enumerate(_text(data, path).splitlines(), 1):
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


def _is_points(words: list[str]) -> bool:
    return len(words) % 3 == 0 and all(word[:1] in "-+.0123456789" for word in words)


def _numbers(words: Iterable[str], path: str, at: str) -> list[float]:
    found = []
    for word in words:
        try:
            number = float(word)
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            raise CameraError(
                path, f"expected a finite number, found {printable(word, 40)!r}", place=at,
                advice="the file may be cut off",
            )  # fmt: skip
        found.append(number)
    return found


def _text(data: bytes, path: str) -> str:
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise CameraError(
            path, "is not UTF-8 text", place=f"byte {error.start}", advice="save it as UTF-8"
        ) from error
