"""How elements move with a field's dimensions, and how far points are from them with it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.field.model import Field
from procc_annotator.fit.solving.feet import ClosestPoints, find_closest_points
from procc_annotator.fit.solving.jacobian import Lens, project
from procc_annotator.fit.solving.models import POSITION_SLICE
from procc_annotator.fit.solving.observations import FloatArray, Observations
from procc_annotator.fit.solving.residual import Residuals, project_out_tangent, with_folded_hidden


@dataclass(frozen=True, eq=False)
class GeometryDerivatives:
    """How the geometry of some elements moves with D dimensions, metres a metre.

    Attributes:
        line_ends: (D, 3, 2 L).
        curve_frames: (D, 3, 3 C).
        spots: (D, 3, S).
    """

    line_ends: FloatArray
    curve_frames: FloatArray
    spots: FloatArray

    @classmethod
    def of(cls, seen: Observations, around: list[tuple[Field, Field, float]]) -> GeometryDerivatives:
        pairs = [(seen.on(less).parts, seen.on(more).parts, d) for less, more, d in around]
        return cls(
            np.array([(b.line_ends - a.line_ends) / d for a, b, d in pairs]),
            np.array([(b.curve_frames - a.curve_frames) / d for a, b, d in pairs]),
            np.array([(b.spots - a.spots) / d for a, b, d in pairs]),
        )

    def of_points(self, seen: Observations, feet: ClosestPoints) -> FloatArray:
        """How the feet of one camera move, each staying at its place on its element: (D, 3, N)."""
        world = feet.world[0]
        pair = np.arange(world.shape[1]) if feet.pair is None else feet.pair[0]
        parts, part = seen.parts, seen.candidates.part[pair]
        moved = np.zeros((len(self.line_ends), *world.shape))
        lines, curves = parts.lines, parts.curves
        on_line, on_spot = part < lines, part >= lines + curves
        if on_line.any():
            row = part[on_line]
            begin, end = parts.line_ends[:, row], parts.line_ends[:, lines + row]
            span = end - begin
            share = ((world[:, on_line] - begin) * span).sum(axis=0) / (span**2).sum(axis=0)
            first, second = self.line_ends[:, :, :lines], self.line_ends[:, :, lines:]
            moved[:, :, on_line] = first[:, :, row] * (1 - share) + second[:, :, row] * share
        on_curve = ~(on_line | on_spot)
        if on_curve.any():
            row = part[on_curve] - lines
            frames = parts.curve_frames.reshape(3, 3, curves)[:, :, row]
            rates = self.curve_frames.reshape(-1, 3, 3, curves)[:, :, :, row]
            off = world[:, on_curve] - frames[:, 0]
            squares = (frames[:, 1] ** 2).sum(axis=0)
            ahead = (off * frames[:, 1]).sum(axis=0) / squares
            aside = (off * frames[:, 2]).sum(axis=0) / squares
            moved[:, :, on_curve] = rates[:, :, 0] + rates[:, :, 1] * ahead + rates[:, :, 2] * aside
        moved[:, :, on_spot] = self.spots[:, :, part[on_spot] - lines - curves]
        return moved


def residuals_by_dimensions(
    vector: FloatArray, seen: Observations, half_diagonal: float, free: int, rates: GeometryDerivatives
) -> Residuals:
    """Residuals of one camera, with derivatives by D dimensions of the field, then by its own.

    Args:
        vector: (11,) pinhole parameters.
        seen: N points.
        half_diagonal: half the picture's diagonal, solver px.
        free: derivatives by the first so many parameters.
        rates: how the elements move with the dimensions.
    """
    lens = Lens.of(vector[None], half_diagonal)
    feet = with_folded_hidden(find_closest_points(lens.linear, lens.undistorted(seen.points), seen), lens)
    ahead = (lens.rotation[:, 2] + vector[POSITION_SLICE])[:, :, None]
    world = np.where(feet.hidden[:, None], ahead, feet.world)
    pixels, along, by_camera = project(lens, world, feet.along, free)
    moved = rates.of_points(seen, feet)
    by_dimension = [project(lens, world, step[None], free)[1] for step in moved]
    derivatives = np.concatenate([np.stack(by_dimension, axis=1), by_camera], axis=1)
    return project_out_tangent(seen, pixels, along, derivatives, feet)
