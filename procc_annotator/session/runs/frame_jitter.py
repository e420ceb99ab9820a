"""How steady a source is in every frame of an open dataset, from its cameras alone."""

from __future__ import annotations

from collections.abc import Container, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.base import Camera
from procc_annotator.errors import CameraError
from procc_annotator.field.model import Field
from procc_annotator.metric.over_time.positions import without_bare_projections
from procc_annotator.metric.over_time.steadiness import field_ground_points, projection_jitter
from procc_annotator.metric.polylines import FloatArray
from procc_annotator.session.dataset.camera_set import FrameCameras
from procc_annotator.session.runs.frame_order import FrameOrder, shots_in

TOO_FAR = 0.25  # of the picture's width: a step by which nothing follows
_FEWEST_STEPS = 5


@dataclass(frozen=True, eq=False)
class FrameJitter:
    """Of the F frames of a dataset.

    Attributes:
        px: (F,) second differences of the projection, as the error of one frame; NaN where a frame
            or a neighbour of it has no camera, or nothing follows anything.
        follows: whether frames show what those before them showed.
    """

    px: FloatArray
    follows: bool


def frame_jitter(
    cameras: FrameCameras,
    frames: Sequence[str],
    field: Field,
    size: tuple[int, int],
    hidden: Container[str] = (),
    order: FrameOrder | None = None,
) -> FrameJitter:
    """How far every frame is from steady motion between its neighbours in its shot.

    Args:
        cameras: of one source; a damaged one counts as none.
        frames: names of all frames.
        size: (width, height) px of the figures.
        hidden: frames of which nothing may be told.
        order: the dataset's table of frames; without it names tell the shots.
    """
    found = np.full(len(frames), np.nan)
    at = {name: place for place, name in enumerate(frames)}
    points, steps = field_ground_points(field), []
    for shot in shots_in([name for name in frames if name in cameras.frames], order):
        given = [_camera(cameras, name, size) for name in shot.frames]
        steady = projection_jitter(given, shot.numbers, points, size)
        steps.append(steady.step_px)
        found[[at[name] for name in shot.frames]] = steady.px
    if not moves_on(np.concatenate(steps) if steps else np.empty(0), size):
        return FrameJitter(np.full(len(frames), np.nan), False)
    found[[place for name, place in at.items() if name in hidden]] = np.nan
    return FrameJitter(found, True)


def moves_on(steps_px: FloatArray, size: tuple[int, int]) -> bool:
    """Whether frames show what those before them showed; where few are known, nobody says no."""
    known = steps_px[np.isfinite(steps_px)]
    return len(known) < _FEWEST_STEPS or bool(np.median(known) < TOO_FAR * size[0])


def _camera(cameras: FrameCameras, name: str, size: tuple[int, int]) -> Camera | None:
    try:
        found = cameras.camera(name, size)
    except CameraError:  # the list of sources says so
        return None
    return None if found is None else without_bare_projections([found.camera])[0]
