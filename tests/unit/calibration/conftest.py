"""Made-up views of a field: a camera somewhere around it, and what an annotator would click."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.camera.base import Camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (960, 540)
SHORTEST_PX = 25.0
GROUND = np.array([(x, y, 0.0) for x in np.linspace(-52, 52, 40) for y in np.linspace(-34, 34, 28)])


@dataclass(frozen=True)
class View:
    """A camera, the side it stands on, and the clicks along the elements it shows."""

    camera: PinholeCamera
    side: int
    annotation: FrameAnnotation


class Views:
    """Makes views; the same ones for the same seed."""

    def __init__(self, field: Field) -> None:
        self.field = field
        self.setup = EvaluationSetup(field, SIZE, "procc")

    def clicks(
        self, camera: Camera, rng: np.random.Generator, noise_px: float = 1.0
    ) -> FrameAnnotation:
        """Points along the longest visible piece of every element that a set has to have, if it is
        long enough to click."""
        polylines = []
        for name, pieces in project_field(camera, self.setup).pieces.items():
            element = self.field.element(name)
            if element is not None and element.optional:
                continue
            piece = max(pieces, key=len)
            along = np.r_[0, np.cumsum(np.hypot(*np.diff(piece, axis=0).T))]
            if along[-1] < SHORTEST_PX:
                continue
            places = np.linspace(0, along[-1], 9 if "Circle" in name else int(rng.integers(2, 5)))
            exact = np.column_stack([np.interp(places, along, piece[:, k]) for k in (0, 1)])
            shown = exact + rng.normal(0, noise_px, exact.shape)
            points = tuple(point_from_px(x, y, SIZE) for x, y in shown)
            polylines.append(Polyline(name, points))
        return FrameAnnotation(tuple(polylines))

    def random(
        self,
        rng: np.random.Generator,
        *,
        noise_px: float = 1.0,
        at_least: int = 4,
        side: int | None = None,
        k1: float | None = None,
    ) -> View:
        """A camera on one of the four sides of the field that shows some elements."""
        while True:
            where = int(rng.integers(4)) if side is None else side
            camera = _random_camera(rng, where, rng.uniform(0, 0.3) if k1 is None else k1)
            annotation = self.clicks(camera, rng, noise_px)
            if len(annotation.polylines) >= at_least:
                return View(camera, where, annotation)

    def main(self, rng: np.random.Generator, *, noise_px: float = 1.0, k1: float = 0.05) -> View:
        """The main camera, looking at the left penalty area."""
        camera = PinholeCamera(
            np.deg2rad(-32), np.deg2rad(78), np.deg2rad(0.4), (1.0, 66.0, -14.0),
            (1500.0, 1500.0), (479.5, 269.5), (k1, 0, 0, 0, 0, 0),
        )  # fmt: skip
        return View(camera, 0, self.clicks(camera, rng, noise_px))


def _random_camera(rng: np.random.Generator, side: int, k1: float) -> PinholeCamera:
    away, along = rng.uniform(8, 60), rng.uniform(-0.6, 0.6)
    x, y = (
        (along * 52.5, 34 + away),
        (along * 52.5, -34 - away),
        (-52.5 - away, along * 34),
        (52.5 + away, along * 34),
    )[side]
    position = np.array([x, y, -rng.uniform(4, 25)])
    toward = np.array([rng.uniform(-52.5, 52.5), rng.uniform(-34, 34), 0.0]) - position
    toward /= np.linalg.norm(toward)
    focal = float(np.exp(rng.uniform(np.log(900), np.log(4000))))
    return PinholeCamera(
        float(np.arctan2(toward[0], -toward[1])),
        float(np.arccos(toward[2])),
        float(np.deg2rad(rng.normal(0, 1))),
        (float(position[0]), float(position[1]), float(position[2])),
        (focal, focal),
        (479.5, 269.5),
        (float(k1), 0.0, 0.0, 0.0, 0.0, 0.0),
    )


@pytest.fixture(scope="session")
def field() -> Field:
    return load_field("soccer")


@pytest.fixture(scope="session")
def views(field) -> Views:
    return Views(field)


@pytest.fixture(scope="session")
def median_error() -> Callable[[Camera, Camera], float]:
    """Median distance, px, between where two cameras show the ground that the first one sees."""

    def median(true: Camera, found: Camera) -> float:
        shown, in_front = true.project(GROUND)
        again, known = found.project(GROUND)
        inside = in_front & (shown >= 0).all(axis=1) & (shown <= (SIZE[0] - 1, SIZE[1] - 1)).all(1)
        apart = np.where(known, np.hypot(*(shown - again).T), np.inf)
        return float(np.median(apart[inside])) if inside.any() else 0.0

    return median
