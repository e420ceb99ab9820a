"""The views of a set that differ most: which frames to look at first."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.pinhole import PinholeCamera

# Twice as large a picture differs as much as one that is half a picture's width aside.
_ZOOM_SCALE = 0.5 / np.log(2)


def most_distinct_views(
    cameras: Sequence[PinholeCamera], widths_px: Sequence[int], count: int
) -> list[int]:
    """The places of the views that differ most, by where cameras look and how far they zoom.

    The first is the one nearest to the middle of all; each further one is the one farthest from
    those before, the earliest of equals.

    Args:
        cameras: in px of their pictures.
        widths_px: of the pictures.
        count: how many; all of them where there are fewer.

    Returns:
        Places in ``cameras``, in the order they were chosen.
    """
    if not cameras or count < 1:
        return []
    places = _view_coordinates(cameras, widths_px)
    chosen = [int(np.hypot(*(places - np.median(places, axis=0)).T).argmin())]
    nearest = np.full(len(places), np.inf)
    while len(chosen) < min(count, len(places)):
        nearest = np.minimum(nearest, np.hypot(*(places - places[chosen[-1]]).T))
        nearest[chosen] = -1.0
        chosen.append(int(nearest.argmax()))
    return chosen


def _view_coordinates(cameras: Sequence[PinholeCamera], widths_px: Sequence[int]) -> NDArray[np.float64]:
    """(n, 2) pan in widths of the usual view, and zoom on the scale of it."""
    pans = np.unwrap([camera.pan_rad for camera in cameras])
    focal = np.array([c.focal_px[0] / w for c, w in zip(cameras, widths_px, strict=True)])
    usual = float(np.exp(np.median(np.log(focal))))
    width_rad = 2 * np.arctan(0.5 / usual)
    return np.column_stack([pans / width_rad, _ZOOM_SCALE * np.log(focal / usual)])
