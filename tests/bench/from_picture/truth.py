"""Points measured on paint in real shots, and whether a camera shows its elements there."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.base import Camera, scaled_camera
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import sample_evenly

SIZE = (960, 540)
_WITHIN_PX, _RIGHT_SHARE, _SPACING_M = 10.0, 0.7, 0.3


@dataclass(frozen=True, eq=False)
class PaintedFrame:
    """A frame, and (n, 2) normalised points on the paint of some of its elements."""

    clip: str
    number: int
    elements: dict[str, FloatArray]


def painted_frames(shared_data: Path, every: int) -> Iterator[PaintedFrame]:
    """Every so-manieth frame of all clips that were measured."""
    measured = json.loads((shared_data / "clips" / "painted_points.json").read_text("utf-8"))
    for clip in sorted(measured):
        for number in sorted(int(key) for key in measured[clip]):
            if number % every == 0:
                elements = measured[clip][f"{number:05d}"]["elements"]
                yield PaintedFrame(
                    clip, number, {name: np.array(points) for name, points in elements.items()}
                )


def is_right(frame: PaintedFrame, camera: Camera, size: tuple[int, int], field: Field) -> bool:
    """Whether 70 % of the elements lie within 10 px of where a camera shows them, at 960x540."""
    shown = scaled_camera(camera, size, SIZE)
    samples = sample_evenly(field, _SPACING_M)
    near = [
        _worst_px(shown, samples.of(field.index[name]), points * (np.array(SIZE) - 1)) <= _WITHIN_PX
        for name, points in frame.elements.items()
        if name in field.index
    ]
    return bool(np.mean(near) >= _RIGHT_SHARE)


def _worst_px(camera: Camera, world: FloatArray, points: FloatArray) -> float:
    px, ahead = camera.project(world)
    both = ahead[:-1] & ahead[1:]
    if not both.any():
        return np.inf
    first, way = px[:-1][both], np.diff(px, axis=0)[both]
    along = ((points[:, None] - first) * way).sum(axis=-1) / ((way * way).sum(axis=-1) + 1e-9)
    apart = points[:, None] - (first + np.clip(along, 0, 1)[..., None] * way)
    return float(np.hypot(apart[..., 0], apart[..., 1]).min(axis=1).max())
