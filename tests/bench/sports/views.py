"""Plausible cameras around any field, and what an annotator would click on their pictures."""

from dataclasses import dataclass

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.calibration.optimization.camera_placement import (
    PlacementRange,
    camera_placement_prior,
)
from procc_annotator.camera.base import Camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (960, 540)
_SHORTEST_PX = 15.0
_FEWEST = 4  # elements that a view shows
_ABOVE = 0.15  # share of the cameras under the ceiling, where there are any
_SEEN = (0.25, 0.9)  # width of the view where the camera looks, as a share of the field's length
_FOCALS = (350.0, 8000.0)
_POINTS_OF_A_CURVE = 9


@dataclass(frozen=True)
class View:
    """A camera and the clicks along the elements it shows."""

    camera: Camera
    annotation: FrameAnnotation


class Views:
    """Makes views of a field; the same ones for the same seed."""

    def __init__(self, field: Field) -> None:
        self.field = field
        self.around = camera_placement_prior(field)
        self.setup = EvaluationSetup(field, SIZE, "procc")
        xs = np.linspace(-self.around.half_length, self.around.half_length, 60)
        ys = np.linspace(-self.around.half_width, self.around.half_width, 40)
        self.ground = np.array([(x, y, 0.0) for x in xs for y in ys])

    def random(self, rng: np.random.Generator) -> View:
        """A camera that shows at least four elements, clicked to 1 px."""
        while True:
            above = self.around.ceiling > 0 and rng.uniform() < _ABOVE
            camera = self._above(rng) if above else self._beside(rng)
            annotation = self.clicks(camera, rng)
            if len(annotation.polylines) >= _FEWEST:
                return View(camera, annotation)

    def clicks(
        self, camera: Camera, rng: np.random.Generator, noise_px: float = 1.0
    ) -> FrameAnnotation:
        """Points along the longest visible piece of every element that is long enough to click."""
        polylines = []
        for name, pieces in project_field(camera, self.setup).pieces.items():
            element = self.field.elements[self.field.index[name]]
            piece = max(pieces, key=_length)
            if element.is_spot:
                exact = piece[:1]
            elif _length(piece) < _SHORTEST_PX:
                continue
            else:
                straight = element.is_straight
                exact = _along(piece, int(rng.integers(2, 5)) if straight else _POINTS_OF_A_CURVE)
            shown = exact + rng.normal(0, noise_px, exact.shape)
            polylines.append(Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in shown)))
        return FrameAnnotation(tuple(polylines))

    def median_error(self, true: Camera, found: Camera | None) -> float:
        """Median distance, px, between where two cameras show the ground in the first one's view;
        infinite without a second."""
        if found is None:
            return np.inf
        shown, in_front = true.project(self.ground)
        inside = in_front & (shown >= 0).all(axis=1) & (shown <= np.array(SIZE) - 1.0).all(axis=1)
        again, known = found.project(self.ground)
        apart = np.where(known, np.hypot(*(shown - again).T), np.inf)
        return float(np.median(apart[inside])) if inside.any() else 0.0

    def _beside(self, rng: np.random.Generator) -> PinholeCamera:
        around = self.around
        away, along = _drawn(rng, around.distance), rng.uniform(-0.6, 0.6)
        length, width = around.half_length, around.half_width
        x, y = (
            (along * length, width + away),
            (along * length, -width - away),
            (-length - away, along * width),
            (length + away, along * width),
        )[int(rng.integers(4))]
        return self._looking(rng, np.array([x, y, -_drawn(rng, around.height)]))

    def _above(self, rng: np.random.Generator) -> PinholeCamera:
        around = self.around
        position = np.array(
            [
                rng.uniform(-0.8, 0.8) * around.half_length,
                rng.uniform(-0.8, 0.8) * around.half_width,
                -around.ceiling * rng.uniform(0.85, 1.15),
            ]
        )
        tilt, toward = np.deg2rad(rng.uniform(1, 20)), rng.uniform(0, 2 * np.pi)
        beside = around.ceiling * np.tan(tilt)
        target = position + np.array([beside * np.cos(toward), beside * np.sin(toward), 0.0])
        target[2] = 0.0
        return self._looking(rng, position, target, np.deg2rad(rng.uniform(-180, 180)))

    def _looking(
        self,
        rng: np.random.Generator,
        position: np.ndarray,
        target: np.ndarray | None = None,
        roll: float | None = None,
    ) -> PinholeCamera:
        around = self.around
        if target is None:
            target = np.array(
                [
                    rng.uniform(-1, 1) * around.half_length,
                    rng.uniform(-1, 1) * around.half_width,
                    0.0,
                ]
            )
        toward = target - position
        apart = float(np.linalg.norm(toward))
        toward /= apart
        seen = np.exp(rng.uniform(*np.log(_SEEN))) * 2 * around.half_length
        focal = float(np.clip(SIZE[0] * apart / seen, *_FOCALS))
        kappa = rng.uniform(0, 0.05)
        k1 = kappa * (focal / np.hypot(*(np.array(SIZE) - 1) / 2)) ** 2
        return PinholeCamera(
            float(np.arctan2(toward[0], -toward[1])),
            float(np.arccos(toward[2])),
            float(np.deg2rad(rng.normal(0, 1)) if roll is None else roll),
            (float(position[0]), float(position[1]), float(position[2])),
            (focal, focal),
            ((SIZE[0] - 1) / 2, (SIZE[1] - 1) / 2),
            (float(k1), 0.0, 0.0, 0.0, 0.0, 0.0),
        )


def _drawn(rng: np.random.Generator, between: PlacementRange) -> float:
    """A length within a range; cameras may all stand at the same one."""
    least, usual, most = between
    return float(rng.triangular(least, usual, most)) if least < most else usual


def _length(piece: np.ndarray) -> float:
    return float(np.hypot(*np.diff(piece, axis=0).T).sum()) if len(piece) > 1 else 0.0


def _along(piece: np.ndarray, count: int) -> np.ndarray:
    """(count, 2) evenly along a visible piece."""
    along = np.r_[0, np.cumsum(np.hypot(*np.diff(piece, axis=0).T))]
    places = np.linspace(0, along[-1], count)
    return np.column_stack([np.interp(places, along, piece[:, k]) for k in (0, 1)])
