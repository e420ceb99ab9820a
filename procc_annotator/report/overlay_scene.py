"""Overlay pictures of a dataset, rendered with a given painter."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.sequence import FOLDER_FPS
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ImageError, InputError, UsageError
from procc_annotator.formats.atomic import make_folder, open_replacing, write_atomic
from procc_annotator.formats.frame_names import file_of_frame
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.video import open_shared_video, video_frame_of_path
from procc_annotator.image.video_writer import VideoWriter
from procc_annotator.metrics.measurement import Measurement, measure
from procc_annotator.metrics.projection import ProjectedField, project_markings
from procc_annotator.metrics.score import FrameScore, display_score
from procc_annotator.metrics.setup import EvaluationSetup

SUFFIXES = (".png", ".jpg", ".svg")
VIDEO_SUFFIX = ".mp4"
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
    camera: CameraOrProjections | None = None  # px of the evaluation's size


class OverlayPainter(Protocol):
    """Draws scenes."""

    def __call__(self, scene: Scene) -> bytes:
        """An encoded picture; raises ImageError for one that cannot be decoded."""

    def pixels(self, scene: Scene) -> PixelArray:
        """The same as (H, W, 4) BGRA, or (H, W, 3) BGR."""


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
    """The picture, or plain ground of the evaluation's size for a frame without one. `ImageError`
    if the picture cannot be decoded."""
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


@dataclass(frozen=True)
class Rendering:
    """A dataset, drawn frame by frame, coloured by a threshold, px; with the borders of painted
    lines if ``painted_width``."""

    workspace: Workspace
    setup: EvaluationSetup
    threshold: float
    cameras: CameraSet | None = None
    painted_width: bool = False

    def scenes(self, rendered: Rendered) -> Iterator[Scene]:
        """The frames in order; what cannot be read, and what is bare, is added to ``rendered``."""
        for index, frame in enumerate(self.workspace.frames):
            scene = self.scene(index, rendered)
            if scene.measurement is None and not scene.annotation.annotated:
                rendered.bare.append(frame.name)
            yield scene

    def scene(self, index: int, rendered: Rendered) -> Scene:
        """One frame; what cannot be read is added to ``rendered``."""
        frame = self.workspace.frames[index]
        annotation, measurement, paint, annotated = FrameAnnotation(), None, None, False
        setup, loaded = self.setup.of_frame(frame.name), None
        try:
            annotation = self.workspace.read(index)
            has_file = self.workspace.has_file(index)
            annotated = bool(annotation.polylines or annotation.extra) or has_file
            if self.cameras is not None:
                loaded = self.cameras.camera(frame.name, setup.size)
            if loaded is not None:
                measurement = measure(annotation, loaded.camera, setup)
                paint = project_markings(loaded.camera, setup) if self.painted_width else None
                rendered.notices.update([loaded.notice] if loaded.notice else [])
        except InputError as error:  # the picture is drawn all the same, with what could be read
            rendered.problems.append(str(error))
        judged = None
        if measurement is not None and annotated:  # else it belongs to no figure
            judged = display_score(measurement, self.threshold)
        source = "" if self.cameras is None else self.cameras.name
        picture = frame.image_path if frame.image_file else None
        return Scene(
            picture, annotation, setup, measurement, judged, frame.name, source, paint,
            None if loaded is None else loaded.camera,
        )  # fmt: skip


def render_pictures(
    rendering: Rendering, out: Path, paint: OverlayPainter, suffix: str = ".png"
) -> Iterator[Rendered]:
    """Write one picture per frame to a folder (made if needed), in the encoding that ``paint``
    produces, yielding what is done so far after each.

    Raises:
        SaveError: a picture cannot be written.
        UsageError: the pictures would replace those of the dataset.
    """
    if any(folder.resolve() == out.resolve() for folder in rendering.workspace.own_folders):
        raise UsageError(f"{out}: this is the dataset itself, choose another folder")
    make_folder(out)
    rendered = Rendered(out)
    for scene in rendering.scenes(rendered):
        try:
            data = paint(scene)
        except ImageError as error:
            rendered.problems.append(str(error))
        else:
            target = out / file_of_frame(scene.title, suffix)
            make_folder(target.parent)
            write_atomic(target, data)
            rendered.pictures.append(target)
        yield rendered


def render_video(
    rendering: Rendering, out: Path, painter: OverlayPainter, fps: float | None = None
) -> Iterator[Rendered]:
    """Write one H.264 video (.mp4) of all frames, yielding what is done so far after each.

    Args:
        out: the file; replaced when it is complete.
        fps: frames per second; None: the times of a video's own frames, and 25 of a folder's.

    Raises:
        SaveError: it cannot be written, or the pictures have several sizes.
    """
    frames = rendering.workspace.frames
    source = video_frame_of_path(frames[0].image_path)
    video = None if source is None else open_shared_video(source[0])
    rate = fps or (FOLDER_FPS if video is None else video.fps)
    times = np.arange(len(frames)) / rate if fps or video is None else video.times_s
    rendered = Rendered(out)
    with open_replacing(out) as stream:
        writer = VideoWriter(stream, out, rate)
        for scene, time_s in zip(rendering.scenes(rendered), times, strict=True):
            try:
                pixels = painter.pixels(scene)
            except ImageError as error:  # the picture before it stays
                rendered.problems.append(str(error))
            else:
                writer.write(pixels, float(time_s))
                rendered.pictures.append(out)
            yield rendered
        writer.close()
