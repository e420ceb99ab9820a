"""Labels that are turned by half a turn, told from where the cameras of a whole set stand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.determined import ill_conditioned_reason
from procc_annotator.fit.labels.finding import LOOK, Finding, Remedy, RemedyKind, Rule, Severity
from procc_annotator.fit.result import FitResult, PosedCamera
from procc_annotator.fit.solving.models import POSITION_SLICE
from procc_annotator.fit.solving.surroundings import camera_placement_prior
from procc_annotator.fit.together.sides import find_opposite_side_frames
from procc_annotator.language import translatable, translatable_count


@dataclass(frozen=True, slots=True)
class FittedPosition:
    """Where the camera of a frame's own fit stands.

    Attributes:
        position_m: metres, world frame.
        covariance: rows of the (3, 3) one of it, metres squared.
        model: of the fit.
        is_sure: whether the points determine the camera.
    """

    position_m: tuple[float, ...]
    covariance: tuple[tuple[float, ...], ...]
    model: str
    is_sure: bool


def fitted_position(fit: FitResult) -> FittedPosition | None:
    """Where a fit has its camera; None without one, and for a homography."""
    if not isinstance(fit.camera, PosedCamera) or fit.of_clicks is None:
        return None
    covariance = fit.of_clicks[POSITION_SLICE, POSITION_SLICE].tolist()
    sure = not ill_conditioned_reason(fit)
    return FittedPosition(fit.camera.position_world, tuple(map(tuple, covariance)), fit.model, sure)


@dataclass(frozen=True, slots=True)
class OppositeSideFrame:
    """A frame whose camera stands on the other side from the rest.

    Attributes:
        opposite: how many frames stand where its camera does once its labels are turned; 0 if none
            do, and it merely stands where hardly any does.
        frames: of the set, with a camera.
        stand: its own.
    """

    opposite: int
    frames: int
    stand: FittedPosition


def find_opposite_frames(stands: Mapping[str, FittedPosition], field: Field) -> dict[str, OppositeSideFrame]:
    """The frames of a set whose camera stands on the other side from the rest.

    Args:
        stands: of the frames with a camera.
        field: of a field that half a turn does not take to itself nothing is told: there the labels
            of one frame tell the side.
    """
    if field.half_turn is None or not stands:
        return {}
    names = list(stands)
    positions = np.array([stand.position_m for stand in stands.values()])
    covariances = np.array([stand.covariance for stand in stands.values()])
    found = find_opposite_side_frames(positions, covariances, camera_placement_prior(field))
    opposite = {**dict.fromkeys(sorted(found.minority), 0), **found.turned}
    return {
        names[i]: OppositeSideFrame(count, len(names), stands[names[i]]) for i, count in opposite.items()
    }


def opposite_side_finding(
    annotation: FrameAnnotation, field: Field, found: OppositeSideFrame
) -> Finding | None:
    """What to tell of a frame on the other side; None where its labels say which side it is of.

    Args:
        annotation: of the frame.
        field: its elements, with the half turn.
        found: what the set says of it.
    """
    turn = field.half_turn
    names = [name for name in annotation.annotated if field.element(name) is not None]
    # A mark before the team benches, or a landmark, is on one side only.
    if turn is None or any(name not in turn.partner for name in names):
        return None
    pairs = tuple((name, turn.name_of(name)) for name in names if turn.name_of(name) != name)
    if not pairs:
        return None
    remedy = Remedy(RemedyKind.RELABEL, translatable("turn the labels by half a turn"), pairs)
    if found.opposite:
        severity = Severity.ERROR if found.stand.is_sure else Severity.WARNING
        return Finding(
            Rule.OTHER_SIDE,
            severity,
            tuple(names),
            translatable_count(
                found.opposite,
                "the camera stands on the other side of the field from the rest; with its labels"
                " turned by half a turn it stands where that of {n} frame does",
                "the camera stands on the other side of the field from the rest; with its labels"
                " turned by half a turn it stands where that of {n} frames does",
            ),
            (remedy,),
            model=found.stand.model,
        )
    return Finding(
        Rule.OTHER_SIDE,
        Severity.HINT,
        tuple(names),
        translatable_count(
            found.frames,
            "the camera stands on a side of the field where hardly any other of {n} frame does: a"
            " camera of its own, or labels turned by half a turn",
            "the camera stands on a side of the field where hardly any other of {n} frames does: a"
            " camera of its own, or labels turned by half a turn",
        ),
        (LOOK, remedy),
        model=found.stand.model,
    )
