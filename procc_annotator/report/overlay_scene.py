"""What an overlay picture shows, and its limits."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import UsageError
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.measurement import Measurement
from procc_annotator.metrics.projection import ProjectedField
from procc_annotator.metrics.score import FrameScore
from procc_annotator.metrics.setup import EvaluationSetup

SUFFIXES = (".png", ".jpg", ".svg")
MIN_SCALE, MAX_SCALE = 0.05, 16.0
MOST_PIXELS = 100_000_000  # of a painted picture, 0.8 GB meanwhile; an SVG has none
GROUND_BGRA = (60, 92, 58, 255)

# At this width a point is a pixel; lines on larger pictures grow with them, as on a larger sheet.
_WIDTH_OF_POINTS = 1280.0
# Below this many px a point, texts on a reduced picture could not be read.
_SMALLEST_UNIT = 0.8


@dataclass(frozen=True)
class Scene:
    """Everything a picture shows.

    Without ``image_path`` it is drawn on plain ground of the evaluation's size.
    """

    image_path: Path | None
    annotation: FrameAnnotation
    setup: EvaluationSetup
    measurement: Measurement | None
    score: FrameScore | None
    title: str = ""
    source: str = ""  # what the cameras that were scored are called
    paint: ProjectedField | None = None  # the borders of painted lines, where they are wanted


Paint = Callable[[Scene], bytes]
"""Turns a scene into an encoded picture; raises ImageError for one that cannot be decoded."""


@dataclass(frozen=True, slots=True)
class OverlayLook:
    """Look of an overlay picture.

    Attributes:
        scale: px of the result per px of the picture; lines and text grow with it.
        legend: whether a band below the picture says what colours, dashes and marks mean.
        widest: px; larger results are made smaller than ``scale`` asks.
        emphasis: how much larger than in the window lines, marks and text are, for pictures that
            are shown small.
        caption: whether JaC and protocol stand in the picture (with a legend they stand there).
    """

    scale: float = 1.0
    legend: bool = False
    widest: int | None = None
    emphasis: float = 1.0
    caption: bool = True

    def __post_init__(self) -> None:
        if not MIN_SCALE <= self.scale <= MAX_SCALE:
            raise UsageError(
                f"the scale must be between {MIN_SCALE:g} and {MAX_SCALE:g}, not {self.scale:g}"
            )

    def scale_and_unit(self, width: int) -> tuple[float, float]:
        """Px of the result per px of a picture so wide, and px of the result per point."""
        scale = self.scale if self.widest is None else min(self.scale, self.widest / width)
        grown = max(1.0, width / _WIDTH_OF_POINTS) * scale * self.emphasis
        return scale, max(_SMALLEST_UNIT, grown)


def check_overlay_suffix(suffix: str) -> None:
    """Raises UsageError unless overlay pictures can be encoded so."""
    if suffix not in SUFFIXES:
        raise UsageError(f"overlay pictures are {', '.join(SUFFIXES)}, not {suffix or 'that'}")


def check_pixels(width: int, height: int) -> None:
    """Raises UsageError for a painted picture that would be too large."""
    if width * height > MOST_PIXELS:
        raise UsageError(f"{width}x{height} pixels are too many; choose a smaller scale, or .svg")


def pixels_of(scene: Scene) -> PixelArray:
    """The picture, or plain ground of the evaluation's size for a frame without one.

    Raises:
        ImageError: the picture cannot be decoded.
    """
    if scene.image_path is not None:
        return decode_bgra(scene.image_path)
    width, height = scene.setup.size
    return np.full((height, width, 4), GROUND_BGRA, dtype=np.uint8)


def caption(scene: Scene) -> str:
    """Return what the picture shows: whose score, with protocol and size; empty without a score."""
    if scene.score is None or scene.measurement is None:
        return ""
    ground_only = scene.measurement.projected.ground_only
    words = f"JaC@{scene.score.threshold:g} {scene.score.jac:.3f}"
    labels = ", labels mirrored" if scene.score.mirrored else ""
    whose = f"{scene.source}: " if scene.source else ""
    return f"{whose}{words}  ({scene.setup.describe(ground_only)}{labels})"
