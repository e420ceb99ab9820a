"""Tracks: the camera of each frame of a shot, or why there is none."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from procc_annotator.calibration.result import FitResult

# Given beforehand; measured on the frame's own paint; propagated by the picture's motion; none.
FrameState = Literal["anchor", "followed", "bridged", "lost"]

MIN_COVERAGE = 0.65  # below it a frame is doubtful, unless the line pixels there are explained


@dataclass(frozen=True, eq=False)
class TrackedFrame:
    """The camera of one frame of a shot, or why there is none.

    Attributes:
        number: of the frame in its source.
        state: how its camera came about.
        reason: what there is to say about that, in words; "" for nothing.
        fit: the camera with its standard deviations; None if it is lost.
        coverage: share of the visible model that was found on paint, 0 to 1.
        residual_px: median distance of that paint from the model, px of the picture; None if none
            was found.
        anchor_distance: frames to the nearest anchor, or to where a proposal began the track; None
            if it is lost.
        explained: share of the line pixels on the field that its lines explain, 0 to 1, at this
            frame or up to half a second before; None where enough of the model was found.
        clicks: the SHA-256 of the annotation that an anchor was fitted to; empty for other frames.
        probability: 0 to 1, that the camera found in its picture, which began the track, is right;
            None for frames in which none was found.
    """

    number: int
    state: FrameState
    reason: str
    fit: FitResult | None
    coverage: float
    residual_px: float | None
    anchor_distance: int | None
    clicks: str = ""
    explained: float | None = None
    probability: float | None = None


@dataclass(frozen=True, eq=False)
class Track:
    """The cameras of a run of frames.

    Attributes:
        frames: in the order of their numbers.
        shots: first and last number of each shot, in order.
    """

    frames: tuple[TrackedFrame, ...] = field(repr=False)
    shots: tuple[tuple[int, int], ...]
