"""A source that shares only where it shows the elements, not the camera that put them there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.base import Camera, FloatArray

_BORDER_TOLERANCE_PX = 1e-4  # files round shares


@dataclass(frozen=True, eq=False)
class ElementProjections:
    """Projected polylines of the elements a source shows.

    The protocols ask a camera for nothing but these, so a method that cannot share its model can
    be judged by them. There is no ``project``: what needs points in space is not possible.

    Attributes:
        pieces: class name -> its pieces, each (n, 2) px, vertices in order along the element.
    """

    pieces: Mapping[str, tuple[FloatArray, ...]]

    def is_clipped(self, size: tuple[int, int]) -> bool:
        """Whether pieces end at the border of a picture of (width, height) px and none goes on
        beyond it: somebody cut them to the picture.

        What a camera shows ends there by chance only. Programs cut at the centres of the last
        pixels, or, as the official evaluation does, at width and height.
        """
        pieces = [px for parts in self.pieces.values() for px in parts if len(px)]
        if not pieces:
            return False
        every, ends = np.concatenate(pieces), np.concatenate([px[[0, -1]] for px in pieces])
        border = np.array([[0.0, 0.0], np.subtract(size, 1), size])[:, None]
        within = ((every >= -_BORDER_TOLERANCE_PX) & (every <= np.add(size, _BORDER_TOLERANCE_PX))).all()
        return bool(within and (np.abs(ends - border) <= _BORDER_TOLERANCE_PX).any())

    def scaled(self, from_size: tuple[int, int], to_size: tuple[int, int]) -> ElementProjections:
        """The same for another picture size (pixel centres: factors (W'-1)/(W-1))."""
        factors = np.array(
            [(to_size[0] - 1) / (from_size[0] - 1), (to_size[1] - 1) / (from_size[1] - 1)]
        )
        return ElementProjections(
            {name: tuple(p * factors for p in parts) for name, parts in self.pieces.items()}
        )


CameraOrProjections = Camera | ElementProjections
