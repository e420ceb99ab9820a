"""A source that shares only where it shows the elements, not the camera that put them there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.base import Camera, FloatArray


@dataclass(frozen=True, eq=False)
class ElementProjections:
    """Projected polylines of the elements a source shows.

    The protocols ask a camera for nothing but these, so a method that cannot share its model can
    be judged by them. There is no ``project``: what needs points in space is not possible.

    Attributes:
        pieces: class name -> its pieces, each (n, 2) px, vertices in order along the element.
    """

    pieces: Mapping[str, tuple[FloatArray, ...]]

    def scaled(self, from_size: tuple[int, int], to_size: tuple[int, int]) -> ElementProjections:
        """The same for another picture size (pixel centres: factors (W'-1)/(W-1))."""
        factors = np.array(
            [(to_size[0] - 1) / (from_size[0] - 1), (to_size[1] - 1) / (from_size[1] - 1)]
        )
        return ElementProjections(
            {name: tuple(p * factors for p in parts) for name, parts in self.pieces.items()}
        )


CameraOrProjections = Camera | ElementProjections
