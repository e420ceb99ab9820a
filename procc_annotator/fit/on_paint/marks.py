"""Paint that was found, as a solver sees it: places on a field, and where across they appear."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.jacobian import Lens, project
from procc_annotator.fit.solving.models import FREE_PARAMETERS
from procc_annotator.fit.solving.observations import FloatArray

PARAMETERS_FREE = FREE_PARAMETERS["R"]

FloatingArray = NDArray[np.floating]
IntegerArray = NDArray[np.integer]


@dataclass(frozen=True, eq=False)
class EdgePoints:
    """n places of paint that were found in a picture.

    A place may slide along its element: only its distance across counts, which a camera that moves
    a little changes as that of the place itself.

    Attributes:
        world: (3, n) metres, in the middle of the paint.
        across: (n,) solver px: where the paint was found, along the normal.
        normal: (2, n) unit vectors in the picture.
        element: (n,) which element each is on.
        run: (n,) which stretch in sight.
    """

    world: FloatingArray
    across: FloatingArray
    normal: FloatingArray
    element: IntegerArray
    run: IntegerArray

    def __len__(self) -> int:
        return len(self.across)

    def small(self) -> EdgePoints:
        """The same in less than half the room, to be kept: places to some micrometres."""
        return EdgePoints(
            self.world.astype(np.float32),
            self.across.astype(np.float32),
            self.normal.astype(np.float32),
            self.element.astype(np.int16),
            self.run.astype(np.int16),
        )

    def chosen(self, rows: np.ndarray) -> EdgePoints:
        """Some of them."""
        return EdgePoints(
            self.world[:, rows],
            self.across[rows],
            self.normal[:, rows],
            self.element[rows],
            self.run[rows],
        )


def edge_point_errors(
    vectors: FloatArray, marks: EdgePoints, half_diagonal: float, free: int = PARAMETERS_FREE
) -> tuple[FloatArray, FloatArray]:
    """How far marks are from where cameras show them, across.

    Args:
        vectors: (B, 11) cameras.
        marks: n places.
        half_diagonal: half the picture's diagonal, solver px.
        free: derivatives by the first so many parameters.

    Returns:
        (B, n) solver px, and (B, n, free) derivatives of where the cameras show them.
    """
    lens = Lens.of(vectors, half_diagonal)
    places = marks.world.astype(np.float64)
    world = np.broadcast_to(places, (len(vectors), *places.shape))
    px, _, derivatives = project(lens, world, np.zeros_like(world), free)
    shown = (px * marks.normal).sum(axis=1)
    by = (derivatives * marks.normal).sum(axis=2)
    return marks.across - shown, by.transpose(0, 2, 1)
