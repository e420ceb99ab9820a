"""Every reader of files from outside: valid files, and what must hold of whatever it reads."""

import io
import json
import math
import re
import tomllib
import warnings
import zipfile
import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from procc_annotator.camera.base import ElementProjections
from procc_annotator.camera.models import FisheyeCamera, HomographyCamera, PinholeCamera
from procc_annotator.errors import AnnotationError, CameraError, InputError
from procc_annotator.field import load
from procc_annotator.field.load import load_field
from procc_annotator.field.sampling import sample_evenly, sample_official
from procc_annotator.formats.annotations.label_map import OrderedClasses, read_label_map
from procc_annotator.formats.annotations.registry import SetReader
from procc_annotator.formats.annotations.soccernet import read_annotation, write_annotation
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.homography import CONVENTIONS
from procc_annotator.formats.cameras.krt import krt_content, write_krt
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera, fit_to_size
from procc_annotator.formats.cameras.opencv import write_opencv
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.formats.file_listing import list_annotations, list_cameras
from procc_annotator.formats.file_source import open_source
from procc_annotator.image.decoding import decode_bgra, decode_thumbnail
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.resources import resources_dir

ROOT = Path(__file__).resolve().parents[2]
SAMPLE = ROOT / "sample_data"
FIELD = load_field("soccer")
SETUP = EvaluationSetup(FIELD, (960, 540), "procc")
SOCCER = (resources_dir() / "field" / "soccer.toml").read_text(encoding="utf-8")
# Half the elements take half the time and have all the kinds.
FIELD_LINES = [line for line in SOCCER.splitlines() if line and not line.startswith("#")]
GOOD_CAMERA = json.loads((SAMPLE / "cameras/true/camera_00001.json").read_text())
WORLD = np.random.default_rng(5).uniform((-60, -40, -3), (60, 40, 0), (20, 3))


def in_one_line(error: pytest.ExceptionInfo[Any], name: str) -> str:
    text = str(error.value)
    assert text.startswith(name)
    assert text.isprintable()
    assert len(text) < len(name) + 500
    return text


@dataclass(frozen=True)
class Reader:
    """``read`` gets the file; ``check`` what was read and the file's bytes."""

    kind: str  # in the tally
    file_name: str
    seeds: Callable[[Path], Sequence[bytes]]  # from the folder of real data, which may not exist
    read: Callable[[Path], Any]
    check: Callable[[Any, bytes], None]
    count: int  # damaged files per lap
    mend: Callable[[bytes], bytes] | None = None  # of every second damaged file


# ----------------------------------------------------------------------------------- annotations


def read_annotation_file(path: Path) -> Any:
    return read_annotation(path.read_bytes(), path=str(path), field=FIELD)


def check_annotation(annotation: Any, data: bytes) -> None:
    """Written again, it is the same file; numbers are compared as text: 1 and 1.0 differ."""
    written = write_annotation(annotation)
    again = read_annotation(written, path="00001.json", field=FIELD)
    assert write_annotation(again) == written
    assert again == annotation or b"NaN" in written
    content = json.loads(data.decode("utf-8-sig"))
    expected = {FIELD.canonical_name(key): value for key, value in content.items()}
    assert len(expected) == len(content)
    assert json.dumps(json.loads(written), sort_keys=True) == json.dumps(expected, sort_keys=True)
    assert [p.class_name for p in annotation] == [k for k in expected if annotation.get(k)]


def check_place(data: bytes) -> None:
    """The error of a file that is an object in JSON names the place of the mistake."""
    try:
        content = json.loads(data.decode("utf-8-sig"))
    except (ValueError, RecursionError):
        return
    try:
        read_annotation(data, path="00001.json", field=FIELD)
    except AnnotationError as error:
        named = error.place or re.search("occurs twice|nested|half a character", error.problem)
        assert named or content == {} or "" in content, error  # noqa: PT017


# --------------------------------------------------------------------------------------- cameras


def check_projects(loaded: LoadedCamera, data: bytes = b"") -> None:
    for camera_size in (None, (1280, 720)):
        camera, _ = fit_to_size(loaded, (960, 540), camera_size)
        with np.errstate(all="ignore"):
            project_field(camera, SETUP)
        if not isinstance(camera, ElementProjections):
            px, valid = camera.project(WORLD)
            assert px.shape == (len(WORLD), 2)
            assert valid.dtype == bool


def check_all_project(cameras: Sequence[LoadedCamera], data: bytes = b"") -> None:
    for loaded in cameras:
        check_projects(loaded)


def check_pinhole(loaded: LoadedCamera, data: bytes) -> None:
    check_projects(loaded)
    if not isinstance(loaded.camera, PinholeCamera):
        return check_homography(loaded, data, "wc14")
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
    return None


def check_homography(loaded: LoadedCamera, data: bytes, convention: str) -> None:
    """The numbers of the file, read by other means, belong to the camera."""
    check_projects(loaded)
    camera = loaded.camera
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


def read_camera(fmt: str = "auto") -> Callable[[Path], LoadedCamera]:
    return lambda path: read_camera_file(path.read_bytes(), path=str(path), fmt=fmt)


def read_collection(fmt: str = "auto") -> Callable[[Path], list[LoadedCamera]]:
    """Every camera of a file, as a collection reads them; damaged ones are left out."""

    def read(path: Path) -> list[LoadedCamera]:
        found = []
        with CameraCollection.open(path, fmt) as cameras:
            for frame in cameras.frames:
                try:
                    found.append(cameras.read(frame))
                except CameraError as error:
                    assert "\n" not in str(error)  # noqa: PT017
        return found

    return read


def encoded(*values: object) -> bytes:
    return b"\n".join(json.dumps(value).encode() for value in values)


def npy(array: Any, version: tuple[int, int] | None = None) -> bytes:
    buffer = io.BytesIO()
    np.lib.format.write_array(buffer, array, version)
    return buffer.getvalue()


SIZE = (1280, 720)
PINHOLE = PinholeCamera(
    0.1, 1.3, 0.01, (2.0, 60.0, -15.0), (1400.0, 1410.0), (640.0, 360.0),
    (-0.2, 0.05, 0.01, 0.02, 0.003, 0.001), (0.003, -0.002), (0.001, 0.0, 0.0, 2e-4),
)  # fmt: skip
FISHEYE = FisheyeCamera(
    0.1, 1.2, -0.02, (3.0, 55.0, -12.0), (600.0, 601.0), (641.0, 358.0), (0.02, -0.01, 0.003, 0.0)
)
SOCCERNET: dict[str, Any] = json.loads(write_camera(PINHOLE))
RECORD = {"image_ids": "1.jpg", **SOCCERNET}
FLAT = {"image_ids": "2.jpg", "homography": [[0.05, 0, -32], [0, 0.06, -18], [0, 1e-3, 1]]}
KRT = krt_content(PINHOLE, SIZE)
FLAT_K, FLAT_R = (np.array(KRT[key]).ravel().tolist() for key in ("K", "R"))
BASKET = {"K": FLAT_K, "R": FLAT_R, "T": KRT["t"], "kc": [0, 0, 0, 0, 0]}
BROAD = {
    "sensorResolutionWidthPixels": 1280.0, "sensorResolutionHeightPixels": 720.0,
    "horizontalFieldOfViewDegrees": 40.0, "panDegrees": 3.0, "tiltDegrees": 80.0,
    "rollDegrees": 0.1, "positionXMeters": 0.0, "positionYMeters": 55.0,
    "positionZMeters": -12.0, "normalizedRadialDistortionCoefficients": [0.1, 0.0, 0.0],
}  # fmt: skip
WHOLE = {
    "format": "procc-annotator projection 1", "size": [960, 540], "ground_only": False,
    "field_sha256": "", "pieces": {"Middle line": [[[1.0, 2.0], [3.0, 4.5]]]},
    "samples": {"Middle line": [[1.0, 2.0], None]},
}  # fmt: skip
POINTS = {
    "Middle line": [{"x": 0.4, "y": 0.1}, {"x": 0.5, "y": 0.9}],
    "Circle central": [[{"x": 0.1, "y": 0.2}, {"x": 1.2, "y": 0.3}]],
}
TRANSFORMS = {
    "w": 1280, "h": 720, "fl_x": 1000.0, "cx": 640.0, "cy": 360.0,
    "frames": [{"file_path": "1.jpg", "transform_matrix": np.eye(4).tolist()}],
}  # fmt: skip
PROJECTION = {"1": {"P": [[1000, 0, 640, 0], [0, 1000, 360, 0], [0, 0, 1, 60]]}}
DOME = {
    "cameras": [
        {"name": "00_01", "K": np.diag([1000.0, 1000, 1]).tolist(), "R": np.eye(3).tolist(),
         "t": [[0], [0], [50]], "distCoef": [0.0] * 5, "resolution": [1280, 720]}
    ]
}  # fmt: skip
XML = (
    b'<?xml version="1.0"?>\n<opencv_storage>\n<image_width>1280</image_width>\n'
    b"<image_height>720</image_height>\n"
    + b"".join(
        f'<{key} type_id="opencv-matrix">\n  <rows>{rows}</rows>\n  <cols>{columns}</cols>\n'
        f"  <dt>d</dt>\n  <data>\n    {numbers}</data></{key}>\n".encode()
        for key, rows, columns, numbers in (
            ("camera_matrix", 3, 3, " ".join(repr(float(v)) for v in FLAT_K)),
            ("R", 3, 3, " ".join(repr(float(v)) for v in FLAT_R)),
            ("tvec", 3, 1, " ".join(repr(float(v)) for v in KRT["t"])),
        )
    )
    + b"</opencv_storage>\n"
)
COLLECTIONS: dict[str, list[bytes]] = {
    "krt": [write_krt(PINHOLE, SIZE), write_krt(FISHEYE, None), encoded({"1": KRT, "2": KRT})],
    "opencv": [write_opencv(PINHOLE, SIZE), write_opencv(FISHEYE, SIZE)],
    "tvcalib": [encoded(RECORD), encoded(RECORD, FLAT), encoded([RECORD, FLAT])],
    "broadtrack": [encoded({"1.jpg": {"cp": BROAD, "score": 1}, "2.jpg": {"cp": SOCCERNET}})],
    "deepsportradar": [encoded([{"width": 960, "height": 540}, BASKET, BASKET])],
    "polylines": [encoded(POINTS), encoded({"1": POINTS, "2.jpg": POINTS}), encoded(WHOLE)],
    "soccernet": [encoded(SOCCERNET), encoded({"1.jpg": SOCCERNET, "2": SOCCERNET})],
}
MATRIX = np.array([[0.05, 0, 25.5], [0, 0.05, 19.0], [0, 1e-4, 1]])
ARRAYS = [npy(MATRIX), npy(MATRIX.astype(">f4")), npy(np.asfortranarray(MATRIX), (2, 0))]


# ------------------------------------------------------------------- maps of labels, COCO templates

LABELS = b"""# names
[labels]
"halfway" = "Middle line"   # sure
crowd = false
"goal line" = { left_to_right = ["Side line left", "Side line right"] }
pitch = { template = "soccer_32" }
"""
TEMPLATE = {
    "images": [{"id": 1, "width": 640, "height": 360, "file_name": "a.jpg"}],
    "annotations": [
        {"id": 1, "image_id": 1, "category_id": 1,
         "keypoints": [v for i in range(32) for v in (10 * i, 5 * i, 2 if i % 3 else 0)]}
    ],
    "categories": [
        {"id": 1, "name": "p", "keypoints": [f"k{i}" for i in range(32)],
         "skeleton": [[1, 2], [2, 3], [1, 14]]}
    ],
}  # fmt: skip


def check_label_map(found: Any, data: bytes) -> None:
    for rule in found.rules.values():
        for name in rule.classes if isinstance(rule, OrderedClasses) else (rule,):
            assert not isinstance(name, str) or FIELD.knows(name)
    classes, _ = found.classes([("halfway", ()), ("goal line", ()), ("goal line", ()), ("x", ())])
    assert len(classes) == 4


def read_coco(path: Path) -> Any:
    with open_source(path) as source:
        return SetReader(source, FIELD, fmt="coco").read_all()


def check_coco(found: Any, data: bytes) -> None:
    assert not any("\n" in problem for problem in found.problems)


# ----------------------------------------------------------------------------------------- fields


def check_field(field: Any, data: bytes, path: Path) -> None:
    """Read again, and by the TOML library, it is the same; its samples are finite."""
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


# --------------------------------------------------------------------------------------- archives


def zipped(members: dict[str, bytes], method: int = zipfile.ZIP_DEFLATED) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", method) as archive:
        for name, data in members.items():
            archive.writestr(zipfile.ZipInfo(name), data, method)
    return buffer.getvalue()


MEMBERS = [
    {f.name: f.read_bytes() for f in sorted(SAMPLE.glob("0000*.json"))[:3]},
    {f"test/{f.name}": f.read_bytes() for f in sorted(SAMPLE.glob("cameras/true/*.json"))[:3]},
    {"1.json": b"{}", "camera_1.json": b"{}", "2.txt": b"1 0 0 0 1 0 0 0 1", "é/": b""},
]
CONTENTS = {content for members in MEMBERS for content in members.values()}
ARCHIVES = [
    zipped(MEMBERS[0]),
    zipped(MEMBERS[1], zipfile.ZIP_STORED),
    zipped(MEMBERS[2]),
    zipped(MEMBERS[2], zipfile.ZIP_BZIP2),
]


def read_archive(path: Path) -> list[bytes]:
    """The first members, found by every listing; a member that is refused is left out."""
    found = []
    with open_source(path) as source:
        for listing in (list_annotations, list_cameras):
            try:
                listing(source)
            except InputError as error:
                assert str(error).isprintable()  # noqa: PT017
        assert source.folders() == list(dict.fromkeys(source.folders()))
        for name in source.files()[:6]:
            try:
                found.append(source.read(name))
            except InputError as error:
                assert str(error).isprintable()  # noqa: PT017
    return found


def check_members(members: list[bytes], data: bytes) -> None:
    """What comes out is what was once put in, if under another name."""
    assert set(members) <= CONTENTS


# --------------------------------------------------------------------------------------- pictures


def pictures(suffix: str) -> Callable[[Path], list[bytes]]:
    """Small pictures of a kind, plain and noisy."""

    def make(real: Path) -> list[bytes]:
        noise = np.random.default_rng(3).integers(0, 255, (36, 64, 3), dtype=np.uint8)
        plain = np.full((36, 64, 3), (40, 120, 200), dtype=np.uint8)
        shown = [noise, plain, noise[..., 0]]
        if suffix == ".png":
            shown.append(np.dstack([noise, noise[..., 0]]))
        made = [cv2.imencode(suffix, picture)[1].tobytes() for picture in shown]
        if suffix == ".jpg":
            progressive = cv2.imencode(".jpg", noise, [cv2.IMWRITE_JPEG_PROGRESSIVE, 1])[1]
            made += [progressive.tobytes()]
        return made

    return make


def with_check_sums(png: bytes) -> bytes:
    """A damaged PNG with a check sum that fits behind every chunk that can still be found."""
    data, at = bytearray(png), 8
    while at + 12 <= len(data):
        end = at + 8 + int.from_bytes(data[at : at + 4], "big")
        if end + 4 > len(data):
            break
        data[end : end + 4] = zlib.crc32(data[at + 4 : end]).to_bytes(4, "big")
        at = end + 4
    return bytes(data)


def check_picture(picture: Any, data: bytes) -> None:
    assert picture.ndim == 3
    assert picture.shape[2] == 4
    assert picture.dtype == np.uint8
    assert not picture.flags.writeable


# ---------------------------------------------------------------------------------------- readers


def files(*patterns: str, folder: Path = SAMPLE) -> list[bytes]:
    return [f.read_bytes() for pattern in patterns for f in sorted(folder.glob(pattern))]


ANNOTATIONS = files("*.json")
CAMERAS = files("cameras/*/camera_*.json")
HOMOGRAPHIES = files("cameras/*/*.homographyMatrix")


def fixed(seeds: Sequence[bytes]) -> Callable[[Path], Sequence[bytes]]:
    return lambda real: seeds


def of_real_data(pattern: str) -> Callable[[Path], Sequence[bytes]]:
    return lambda real: files(pattern, folder=real / "wc14")[::10]


def as_homography(convention: str) -> Callable[[LoadedCamera, bytes], None]:
    def check(loaded: LoadedCamera, data: bytes) -> None:
        if isinstance(loaded.camera, HomographyCamera):
            check_homography(loaded, data, convention)
        else:
            check_projects(loaded)

    return check


CAMERA_NAME = "camera_00001.json"
READERS: dict[str, Reader] = {
    "annotation": Reader(
        "annotation", "00001.json", fixed(ANNOTATIONS), read_annotation_file, check_annotation, 187
    ),
    "real annotation": Reader(
        "real files", "1.json", of_real_data("annotations/*.json"), read_annotation_file,
        check_annotation, 37,
    ),
    "camera": Reader("camera", CAMERA_NAME, fixed(CAMERAS), read_camera(), check_pinhole, 125),
    "real camera": Reader(
        "real files", CAMERA_NAME, of_real_data("cameras_*/*.json"), read_camera(), check_pinhole,
        37,
    ),
    "real homography": Reader(
        "real files", "1.npy", of_real_data("homographies_carwc/*.npy"), read_camera("carwc"),
        as_homography("carwc"), 37,
    ),
    **{
        f"homography {convention}": Reader(
            "homography", "1.npy", fixed([*HOMOGRAPHIES, *ARRAYS, *CAMERAS[:2]]),
            read_camera(convention), as_homography(convention), 34,
        )
        for convention in ("wc14", "carwc", "world")
    },
    **{
        f"{fmt} {choice}": Reader(
            "camera", "1.yml" if fmt == "opencv" else "1.json", fixed(seeds),
            read_collection(fmt if choice == "named" else "auto"), check_all_project, 31,
        )
        for fmt, seeds in COLLECTIONS.items()
        for choice in ("named", "detected")
    },
    **{
        f"further {i}": Reader(
            "camera", "c.json", fixed([encoded(seed)]), read_collection(), check_all_project, 13
        )
        for i, seed in enumerate((TRANSFORMS, PROJECTION, DOME))
    },
    "xml": Reader("camera", "1.xml", fixed([XML]), read_camera("opencv"), check_projects, 62),
    "label map": Reader(
        "labels", "labels.toml", fixed([LABELS]), lambda path: read_label_map(path, FIELD),
        check_label_map, 11,
    ),
    "template": Reader(
        "annotation", "k.json", fixed([encoded(TEMPLATE)]), read_coco, check_coco, 12
    ),
    "field": Reader(
        "field", "field.toml", fixed([SOCCER.encode(), "\n".join(FIELD_LINES).encode()]),
        load_field, lambda field, data: None, 37,
    ),
    "archive": Reader("archive", "z.zip", fixed(ARCHIVES), read_archive, check_members, 150),
    **{
        f"{suffix} {read.__name__}": Reader(
            "picture", f"frame{suffix}", pictures(suffix), read, check_picture, count,
            with_check_sums if suffix == ".png" else None,
        )
        for suffix, count in ((".jpg", 60), (".png", 40), (".bmp", 25), (".webp", 30))
        for read in (decode_bgra, decode_thumbnail)
    },
    "sample picture": Reader(
        "picture", "frame.jpeg", fixed(files("00001.jpg")), decode_bgra, check_picture, 8
    ),
}  # fmt: skip
