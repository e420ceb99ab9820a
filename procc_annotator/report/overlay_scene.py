"""Overlay pictures of a dataset, rendered with a given painter."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ImageError, InputError, UsageError
from procc_annotator.formats.atomic import make_folder, write_atomic
from procc_annotator.formats.frame_names import file_of_frame
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.measurement import Measurement, measure
from procc_annotator.metrics.projection import ProjectedField, project_markings
from procc_annotator.metrics.score import FrameScore, display_score
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


@dataclass
class Rendered:
    """Pictures written, problems (one line each), and frames without anything to draw."""

    folder: Path
    pictures: list[Path] = field(default_factory=list)
    problems: list[str] = field(default_factory=list)
    notices: Counter[str] = field(default_factory=Counter)
    bare: list[str] = field(default_factory=list)


def render_pictures(
    workspace: Workspace,
    out: Path,
    paint: Paint,
    *,
    setup: EvaluationSetup,
    threshold: float,
    cameras: CameraSet | None = None,
    suffix: str = ".png",
    painted_width: bool = False,
) -> Iterator[Rendered]:
    """Write one overlay picture a frame, yielding what is done so far after each.

    Args:
        out: folder of the pictures, made if needed.
        threshold: px, decides the colours.
        suffix: the encoding that ``paint`` produces.
        painted_width: whether the borders of painted lines are drawn, too.

    Raises:
        SaveError: a picture cannot be written.
        UsageError: the pictures would replace those of the dataset.
    """
    if any(folder.resolve() == out.resolve() for folder in workspace.own_folders):
        raise UsageError(f"{out}: this is the dataset itself, choose another folder")
    make_folder(out)
    rendered = Rendered(out)
    for index, frame in enumerate(workspace.frames):
        scene = _scene(
            workspace, index, frame, setup, threshold, cameras, rendered, painted=painted_width
        )
        if scene.measurement is None and not scene.annotation.annotated:
            rendered.bare.append(frame.name)
        try:
            data = paint(scene)
        except ImageError as error:
            rendered.problems.append(str(error))
        else:
            target = out / file_of_frame(frame.name, suffix)
            make_folder(target.parent)
            write_atomic(target, data)
            rendered.pictures.append(target)
        yield rendered


def _scene(
    workspace: Workspace,
    index: int,
    frame: Frame,
    setup: EvaluationSetup,
    threshold: float,
    cameras: CameraSet | None,
    rendered: Rendered,
    *,
    painted: bool,
) -> Scene:
    annotation, measurement, paint, annotated = FrameAnnotation(), None, None, False
    setup = setup.of_frame(frame.name)
    try:
        annotation = workspace.read(index)
        annotated = bool(annotation.polylines or annotation.extra) or workspace.has_file(index)
        loaded = None if cameras is None else cameras.camera(frame.name, setup.size)
        if loaded is not None:
            measurement = measure(annotation, loaded.camera, setup)
            paint = project_markings(loaded.camera, setup) if painted else None
            rendered.notices.update([loaded.notice] if loaded.notice else [])
    except InputError as error:  # the picture is drawn all the same, with what could be read
        rendered.problems.append(str(error))
    judged = None
    if measurement is not None and annotated:  # else it belongs to no figure
        judged = display_score(measurement, threshold)
    source = "" if cameras is None else cameras.name
    return Scene(
        frame.image_path, annotation, setup, measurement, judged, frame.name, source, paint
    )
