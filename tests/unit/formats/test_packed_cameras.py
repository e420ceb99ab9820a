"""One file for the cameras of all frames of a match."""

from dataclasses import fields, replace

import numpy as np
import pytest

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.packed import (
    PARAMETERS,
    PackedCameras,
    camera_row,
    read_packed,
)

CAMERA = PinholeCamera(
    0.1, 1.2, 0.01, (1.0, 70.0, -14.0), (3000.0, 3010.0), (959.5, 539.5),
    (0.1, 0.2, 0.3, 0.4, 0.5, 0.6), (0.01, 0.02), (0.1, 0.2, 0.3, 0.4),
)  # fmt: skip


@pytest.fixture
def packed() -> PackedCameras:
    """Three frames, the last without a camera."""
    numbers = np.array([0.25, 0.5, np.nan])
    lower = np.array([[1.0, 0.5, 2.0], [1.0, 0.0, 3.0], [np.nan] * 3])
    cameras = np.stack([camera_row(CAMERA), camera_row(CAMERA), np.full(len(PARAMETERS), np.nan)])
    return PackedCameras(
        ("a/1", "a/ü 2", "a/3"), numbers, ("a/1",) * 3, ("anchor", "followed", "lost"),
        ("", "why\u00e9", "dark"), numbers, numbers, numbers, numbers,
        np.tile([1920.0, 1080.0], (3, 1)), cameras, lower, np.ones(3), ("f" * 64, "", ""),
    )  # fmt: skip


def same(one: PackedCameras, other: PackedCameras) -> bool:
    pairs = ((getattr(one, f.name), getattr(other, f.name)) for f in fields(PackedCameras))
    return all(
        a == b if isinstance(a, tuple) else np.array_equal(a, b, equal_nan=True) for a, b in pairs
    )


def test_every_command_reads_it(packed, tmp_path):
    (tmp_path / "match.npz").write_bytes(packed.encoded())
    with CameraCollection.open(tmp_path) as cameras:
        assert list(cameras.frames) == ["a/1", "a/ü 2"]
        loaded = cameras.read("a/1")
    assert loaded.camera == CAMERA
    assert loaded.size == (1920, 1080)
    assert loaded.fitted_on == "f" * 64
    assert loaded.extra["fit"]["uncertainty"]["covariance"] == [[1.0, 0.5], [0.5, 2.0]]


def test_parts_are_joined_and_merged(packed):
    assert same(read_packed(packed.encoded(), "a.npz"), packed)
    parts = [packed.rows([0]), packed.rows([1, 2])]
    assert same(PackedCameras.joined(parts), packed)
    narrow = replace(packed.rows([1]), covariance=np.empty((1, 0)))
    assert np.isnan(PackedCameras.joined([packed, narrow]).covariance[3]).all()
    newer = replace(packed.rows([1]), state=("anchor",))
    assert newer.merged(packed, packed.frame).state == ("anchor", "anchor", "lost")


def test_damaged_files_are_refused_in_one_line(packed):
    data = packed.encoded()
    rng = np.random.default_rng(0)
    refused = []
    for _ in range(300):
        spoilt = bytearray(data)
        for at in rng.integers(44, len(data), 3):
            spoilt[at] ^= int(rng.integers(1, 256))
        try:
            read_packed(bytes(spoilt[: int(rng.integers(len(data) // 2, len(data)))]), "a.npz")
        except CameraError as error:
            refused.append(str(error))
    assert len(refused) > 250
    assert not any("\n" in said for said in refused)
