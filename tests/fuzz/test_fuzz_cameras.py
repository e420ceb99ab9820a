"""Damaged files of every camera format: one clear line, or a camera that projects."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from procc_annotator.camera.base import ElementProjections
from procc_annotator.camera.models import FisheyeCamera, PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.krt import krt_content, write_krt
from procc_annotator.formats.cameras.loaded_camera import fit_to_size
from procc_annotator.formats.cameras.opencv import write_opencv
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

Damage = Callable[[str, Sequence[bytes], int], Iterator[bytes]]
SETUP = EvaluationSetup(load_field(), (960, 540), "procc")
PINHOLE = PinholeCamera(
    0.1, 1.3, 0.01, (2.0, 60.0, -15.0), (1400.0, 1410.0), (640.0, 360.0),
    (-0.2, 0.05, 0.01, 0.02, 0.003, 0.001), (0.003, -0.002), (0.001, 0.0, 0.0, 2e-4),
)  # fmt: skip
FISHEYE = FisheyeCamera(
    0.1, 1.2, -0.02, (3.0, 55.0, -12.0), (600.0, 601.0), (641.0, 358.0), (0.02, -0.01, 0.003, 0.0)
)
SIZE = (1280, 720)
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
POINTS = {
    "Middle line": [{"x": 0.4, "y": 0.1}, {"x": 0.5, "y": 0.9}],
    "Circle central": [[{"x": 0.1, "y": 0.2}, {"x": 1.2, "y": 0.3}]],
}


def encoded(*values: object) -> bytes:
    return b"\n".join(json.dumps(value).encode() for value in values)


SEEDS: dict[str, list[bytes]] = {
    "krt": [write_krt(PINHOLE, SIZE), write_krt(FISHEYE, None), encoded({"1": KRT, "2": KRT})],
    "opencv": [write_opencv(PINHOLE, SIZE), write_opencv(FISHEYE, SIZE)],
    "tvcalib": [encoded(RECORD), encoded(RECORD, FLAT), encoded([RECORD, FLAT])],
    "broadtrack": [encoded({"1.jpg": {"cp": BROAD, "score": 1}, "2.jpg": {"cp": SOCCERNET}})],
    "deepsportradar": [encoded([{"width": 960, "height": 540}, BASKET, BASKET])],
    "polylines": [encoded(POINTS), encoded({"1": POINTS, "2.jpg": POINTS})],
    "soccernet": [encoded(SOCCERNET), encoded({"1.jpg": SOCCERNET, "2": SOCCERNET})],
}


def check(loaded: Any) -> None:
    camera, _ = fit_to_size(loaded, (960, 540))
    with np.errstate(all="ignore"):
        project_field(camera, SETUP)
    if not isinstance(camera, ElementProjections):
        px, valid = camera.project(np.random.default_rng(5).uniform(-60, 60, (20, 3)))
        assert px.shape == (20, 2)
        assert valid.dtype == bool


def read_all(folder: Path, data: bytes, fmt: str) -> list[Any]:
    """Every camera of a file, as a collection reads them; damaged ones are left out."""
    name = "1.yml" if fmt == "opencv" else "1.json"
    (folder / name).write_bytes(data)
    found = []
    with CameraCollection.open(folder / name, fmt) as cameras:
        for frame in cameras.frames:
            try:
                found.append(cameras.read(frame))
            except CameraError as error:
                assert "\n" not in str(error)  # noqa: PT017
    return found


@pytest.mark.laps
@pytest.mark.parametrize("fmt", SEEDS)
def test_files_of_each_format_changed_in_bytes(
    judge: Any, damage: Damage, tmp_path: Path, fmt: str
) -> None:
    assert all(read_all(tmp_path, seed, fmt) for seed in SEEDS[fmt])
    for data in damage(fmt, SEEDS[fmt], 31):
        for asked in (fmt, "auto"):
            cameras = judge(
                "camera", str(tmp_path), lambda d=data, a=asked: read_all(tmp_path, d, a)
            )
            for loaded in cameras or []:
                check(loaded)


@pytest.mark.laps
def test_xml_changed_in_bytes(judge: Any, damage: Damage) -> None:
    xml = (
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
    assert read_camera_file(xml, path="1.xml").model == "pinhole"
    for data in damage("xml", [xml], 62):
        loaded = judge(
            "camera", "1.xml", lambda d=data: read_camera_file(d, path="1.xml", fmt="opencv")
        )
        if loaded is not None:
            check(loaded)


def test_every_format_takes_every_kind_of_camera_file(judge: Any, tmp_path: Path) -> None:
    for seeds in SEEDS.values():
        for data in seeds:
            for fmt in SEEDS:
                cameras = judge(
                    "camera", str(tmp_path), lambda d=data, f=fmt: read_all(tmp_path, d, f)
                )
                for loaded in cameras or []:
                    check(loaded)
