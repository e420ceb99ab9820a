"""A sport of the sample: where its dataset lies, how it looks, who plays, what is seen of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from drawing.scenery import Arena
from drawing.solids import Thing
from drawing.views import View
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Element, Field

# (N, 3) metres and where a camera stands -> (N,) which of them it cannot see
Hidden = Callable[[NDArray[np.float64], tuple[float, float, float]], NDArray[np.bool_]]


@dataclass(frozen=True)
class Sport:
    """One dataset of the sample.

    Attributes:
        field_name: of the field it is played on.
        folder: of the dataset, below the sample's; "" for the sample's own.
        views: its frames.
        arena: what is drawn where nobody plays.
        things: what stands there, seen by a camera with a seed.
        sets: names of the camera sets, see `drawing.camera_sets`.
        noise: of a picture's values, and the quality of its file, 0 to 100.
        hidden: which places something stands in front of; None: all are open to view.
        absent: elements that are not there, or not annotated.
        shortest_px: what is shorter in a picture is not annotated.
    """

    field_name: str
    folder: str
    views: tuple[View, ...]
    arena: Arena
    things: Callable[[PinholeCamera, int], Sequence[Thing]]
    sets: tuple[str, ...]
    noise: float = 1.6
    jpeg_quality: int = 92
    hidden: Hidden | None = None
    absent: frozenset[str] = frozenset()
    shortest_px: float = 5.0

    @cached_property
    def field(self) -> Field:
        """The field it is played on."""
        return load_field(self.field_name)

    @property
    def clicked(self) -> tuple[Element, ...]:
        """The elements that are annotated."""
        return tuple(e for e in self.field.elements if e.name not in self.absent)
