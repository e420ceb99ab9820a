"""The real basketball cameras see the court of the FIBA field as a camera in the hall would."""

from __future__ import annotations

import json

import numpy as np
import pytest

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.geometry import middle_of, outline_of
from procc_annotator.field.load import load_field
from procc_annotator.field.sampling import FieldSamples, sample_evenly
from procc_annotator.formats.cameras.collection import CameraCollection

FIELD = load_field("basketball_fiba")
SIZE = (960, 540)


@pytest.fixture(scope="module")
def cameras(shared_data) -> list[tuple[PinholeCamera, FloatArray]]:
    """Each camera, and the (3, 4) matrix its file gives for centimetres from the court's corner."""
    found: list[tuple[PinholeCamera, FloatArray]] = []
    for name in ("val", "test"):
        file = shared_data / "deepsportradar" / f"ground_truth_{name}.json"
        matrices = [np.array(e["P"]).reshape(3, 4) for e in json.loads(file.read_bytes())[1:]]
        with CameraCollection.open(file) as collection:
            for frame, matrix in zip(collection.frames, matrices, strict=True):
                camera = collection.read(frame).camera
                assert isinstance(camera, PinholeCamera)
                found.append((camera, matrix))
    assert len(found) == 248
    return found


def place(name: str) -> FloatArray:
    """(3,) metres: the middle of an element."""
    element = FIELD.element(name)
    return np.array(middle_of(element.geometry))


def seen(camera: PinholeCamera, samples: FieldSamples) -> set[str]:
    """Elements of which the picture shows 25 cm or more, or a spot."""
    px, valid = camera.project(samples.points_world)
    shown = valid & (px >= 0).all(axis=1) & (px <= np.array(SIZE) - 1).all(axis=1)
    counts = np.add.reduceat(shown.astype(int), samples.offsets[:-1])
    enough = [1 if e.is_spot else 5 for e in FIELD.elements]
    return {n for n, c, least in zip(samples.names, counts, enough, strict=True) if c >= least}


def test_the_court_begins_where_the_files_say(cameras) -> None:
    """Its far left corner is their origin, x runs along it, y towards the camera."""
    corners_cm = np.array([(0, 0, 0), (2800, 0, 0), (2800, 1500, 0), (0, 1500, 0)], dtype=float)
    edges = ("top", "right", "bottom", "left")
    for camera, matrix in cameras:
        homogeneous = np.column_stack((corners_cm, np.ones(4))) @ matrix.T
        for i, edge in enumerate(edges):
            element = FIELD.element(f"Court edge {edge}")
            ends, valid = camera.project(outline_of(element.geometry))
            assert valid.all()
            theirs = homogeneous[[i, (i + 1) % 4]]
            theirs_px = theirs[:, :2] / theirs[:, 2:]
            apart = np.linalg.norm(ends[:, None] - theirs_px[None], axis=2)
            nearest = apart.min(axis=1)
            # Numbers of single precision; corners may lie thousands of pixels outside the picture.
            assert (nearest < 1e-5 * (1e3 + np.linalg.norm(ends, axis=1))).all()


def test_cameras_stand_beside_the_court_and_look_down_at_it(cameras) -> None:
    places = np.array([camera.position_world for camera, _ in cameras])
    assert (np.abs(places[:, 0]) < 1.1).all()  # at the centre line
    usual = FIELD.cameras
    distance, height = places[:, 1] - 7.5, -places[:, 2]
    for measured, (least, _, most) in ((distance, usual.distance), (height, usual.height)):
        assert least < measured.min() <= measured.max() < most
    assert 9.6 < distance.min() <= distance.max() < 22.1
    assert 7.0 < height.min() <= height.max() < 10.8
    for camera, _ in cameras:
        forward = camera.rotation_cam_from_world[2]
        assert forward[1] < 0 < forward[2]  # away from the near side, and down


def test_each_view_shows_left_on_the_left_far_above_near_and_the_baskets_in_the_air(
    cameras,
) -> None:
    rims = np.array([place("Rim left centre"), place("Rim right centre")])
    world = np.vstack((
        rims, rims * (1, 1, 0), place("Court edge top"), place("Court edge bottom"),
        place("Court edge left"), place("Court edge right"), place("Midcourt line"),
    ))  # fmt: skip
    for camera, _ in cameras:
        px, valid = camera.project(world)
        assert valid.all()
        (x, y) = px.T
        assert (y[:2] < y[2:4]).all()  # each rim above the floor below it
        assert y[4] < y[8] < y[5]  # far sideline, centre, near sideline
        assert x[6] < x[8] < x[7]  # left endline, centre, right endline
        assert x[0] < x[8] < x[1]


def test_every_class_of_the_baseline_is_seen_and_every_view_shows_some(cameras) -> None:
    samples = sample_evenly(FIELD, 0.05)
    views = [seen(camera, samples) for camera, _ in cameras]
    counts = np.array([len(view) for view in views])
    assert counts.min() >= 2
    assert np.median(counts) >= 8
    assert set.union(*views) == {e.name for e in FIELD.elements}
