"""Landmarks of a dataset, triangulated together."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.camera.base import Camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.landmarks.triangulation import (
    DatasetPaths,
    FrameView,
    TriangulationSettings,
    fitted_views,
    locate_in_dataset,
)
from procc_annotator.field.load import field_for_frame, load_field, with_stadiums
from procc_annotator.field.model import Stadiums
from procc_annotator.formats.landmark_file import LandmarkFile
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (960, 540)
STAND = np.array([10.0, -40.0, -8.0])


def camera(x: float) -> PinholeCamera:
    position = (x, 60.0, -15.0)
    dx, dy, dz = STAND - position
    pan, tilt = math.atan2(dx, -dy), math.atan2(math.hypot(dx, dy), dz)
    return PinholeCamera(pan, tilt, 0.0, position, (1800.0, 1800.0), (479.5, 269.5))


CAMERAS = {"left": camera(-40.0), "right": camera(40.0)}


@dataclass(frozen=True)
class Found:
    camera: Camera


class Cameras:
    """A set of the true cameras."""

    name = "true"

    def camera(self, frame: str, size: tuple[int, int]) -> Found:
        return Found(CAMERAS[frame])

    def why_none(self, frame: str) -> str:
        return "none"


def located(folder: Path, rng: np.random.Generator, noise_px: float, click_px: float | None):
    places = STAND + rng.normal(size=(30, 3)) * (6, 4, 2)

    def clicked(frame: str) -> FrameAnnotation:
        shown, _ = CAMERAS[frame].project(places)
        off = shown + rng.normal(0, noise_px, shown.shape)
        return FrameAnnotation(
            tuple(Polyline(f"Seat {i}", (point_from_px(*p, SIZE),)) for i, p in enumerate(off))
        )

    read = {frame: partial(clicked, frame) for frame in CAMERAS}
    search = TriangulationSettings(LandmarkFile(), cameras=Cameras(), size=SIZE, click_px=click_px)
    found = locate_in_dataset(read, load_field("soccer"), DatasetPaths(folder, folder), search)
    assert len(found.located) == 30
    return [one.found for one in found.located]


@pytest.mark.parametrize("noise_px", [1.5, 3.0])
def test_all_landmarks_together_say_how_far_clicks_are_off(tmp_path, noise_px) -> None:
    """One that is clicked in two views says next to nothing of it."""
    found = located(tmp_path, np.random.default_rng(2), noise_px, None)
    assert {one.noise for one in found} == {found[0].noise}
    assert found[0].noise == pytest.approx(noise_px / 1.5, rel=0.25)
    told = located(tmp_path, np.random.default_rng(2), noise_px, 1.5)
    grown = [a.deviations_m[1] / b.deviations_m[1] for a, b in zip(found, told, strict=True)]
    np.testing.assert_allclose(grown, found[0].noise, rtol=1e-6)
    assert {one.noise for one in told} == {1.0}


def test_the_cameras_are_fitted_to_the_dimensions_of_each_frame_s_stadium() -> None:
    stadium = Stadiums({"a": "small"}, {"small": {"length": 100.0, "width": 64.0}})
    field = with_stadiums(load_field("soccer"), stadium)
    true = PinholeCamera(0.1, 1.35, 0.0, (5.0, 75.0, -18.0), (1100.0, 1100.0), (479.5, 269.5))
    shown = project_field(true, EvaluationSetup(field_for_frame(field, "a"), SIZE, "procc"))
    lines = []
    for name, pieces in shown.pieces.items():
        piece = max(pieces, key=len)
        few = piece[np.linspace(0, len(piece) - 1, 6).astype(int)]
        lines.append(Polyline(name, tuple(point_from_px(*p, SIZE) for p in few)))
    views = fitted_views(field, lambda _: FrameAnnotation(tuple(lines)), lambda _: SIZE, "P")
    found = views("a")
    assert isinstance(found, FrameView)
    np.testing.assert_allclose(found.camera.position_world, true.position_world, atol=0.2)
