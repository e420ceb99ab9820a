"""Overlay pictures of a report: choice of frames and captions."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeVar

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.errors import ImageError, InputError
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import FileSource
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import display_score, explain_score, score, worst_elements_first
from procc_annotator.report.comparison import ComparisonScene
from procc_annotator.report.overlay_scene import Scene
from procc_annotator.report.page.report_data import AuditReport, ReportedSource
from procc_annotator.report.scores.score_tables import percent_text, pixels

_MOST_SENTENCES = 8


S = TypeVar("S", Scene, ComparisonScene)


def paint_scene(painter: Callable[[S], bytes], scene: S) -> tuple[bytes, ImageError | None]:
    """The picture as JPEG, and why it is on plain ground in spite of a photograph."""
    try:
        return painter(scene), None
    except ImageError as error:
        return painter(replace(scene, image_path=None)), error


@dataclass(frozen=True, slots=True)
class OverlayPicture:
    """An overlay picture with its words.

    Attributes:
        picture: JPEG; empty where the frame has no camera.
        figures: JaC and error, with what they depend on.
        sentences: what lowers the score, the worst first.
        passing: how many elements agree.
        remark: what is unusual about the picture.
    """

    source: str
    frame: str
    picture: bytes
    figures: str
    sentences: tuple[str, ...] = ()
    passing: int = 0
    remark: str = ""

    @property
    def alternative(self) -> str:
        """For those who do not see it."""
        return f"Frame {self.frame} with the projection of {self.source}: {self.figures}."


@dataclass(frozen=True, slots=True)
class ChosenFrames:
    """Frames to draw.

    Attributes:
        worst: source -> its worst frames, the worst first.
        random: frames drawn at random, in natural order; every source is shown for them.
    """

    worst: Mapping[str, tuple[str, ...]]
    random: tuple[str, ...]


def choose_frames(report: AuditReport, worst: int, lot: int, seed: int) -> ChosenFrames:
    """The worst frames of every source (lowest JaC first, among equals the largest mean error), and
    some drawn at random from all that have a score."""
    scored = [name for name in report.frames if any(name in s.audits for s in report.evaluated)]
    drawn = set(random.Random(seed).sample(scored, min(lot, len(scored))))
    return ChosenFrames(
        {source.name: _worst(source, report.tau, worst) for source in report.detailed},
        tuple(name for name in scored if name in drawn),
    )


def _worst(source: ReportedSource, tau: float, count: int) -> tuple[str, ...]:
    def badness(name: str) -> tuple[float, float]:
        found = source.figures(name, tau)
        if found is None:
            return 2.0, 0.0
        return found.jac, -(found.mean_error or 0.0)

    return tuple(sorted(source.audits, key=badness)[:count])


class OverlayDrawer:
    """Draws frames under sources, as JPEG; what cannot be read is listed, never fatal."""

    def __init__(
        self,
        report: AuditReport,
        annotations: FileSource,
        sources: Sequence[CameraSet],
        pictures: Mapping[str, Path],
        painter: Callable[[Scene], bytes],
    ) -> None:
        self._report = report
        self._annotations = annotations
        self._files = list_annotations(annotations)
        self._cameras = {cameras.name: cameras for cameras in sources}
        self._pictures = pictures
        self._painter = painter
        self.problems: list[str] = []

    def draw(self, source: str, frame: str) -> OverlayPicture:
        """One picture."""
        try:
            scene = self._scene(source, frame)
        except InputError as error:  # it was scored a moment ago
            self.problems.append(str(error))
            scene = None
        if scene is None:
            return OverlayPicture(source, frame, b"", "no camera for this frame")
        return self._painted(source, frame, scene)

    def _scene(self, source: str, frame: str) -> Scene | None:
        setup = self._report.setup.of_frame(frame)
        loaded = self._cameras[source].camera(frame, setup.size)
        if loaded is None:
            return None
        file = self._files[frame]
        annotation = read_annotation(
            self._annotations.read(file), path=self._annotations.display(file), field=setup.field
        )
        measurement = measure(annotation, loaded.camera, setup)
        judged = display_score(measurement, self._report.tau)
        return Scene(self._pictures.get(frame), annotation, setup, measurement, judged, frame)

    def _painted(self, source: str, frame: str, scene: Scene) -> OverlayPicture:
        picture, failure = paint_scene(self._painter, scene)
        remark = ""
        if failure is not None:
            self.problems.append(str(failure))
            remark = "The picture cannot be read: drawn on plain ground."
        elif scene.image_path is None:
            remark = "No picture of this frame: drawn on plain ground."
        judged, measurement = scene.score, scene.measurement
        if judged is None or measurement is None:
            raise ValueError("a scene of a report has a score")
        said = worst_elements_first(explain_score(judged, measurement, scene.setup.field))
        failing = [one.sentence for one in said if one.status != "tp"]
        sentences = failing[:_MOST_SENTENCES]
        if len(failing) > len(sentences):
            sentences.append(f"And {len(failing) - len(sentences)} more elements.")
        labels = ", labels mirrored" if judged.mirrored else ""
        if not judged.mirrored and score(measurement, judged.threshold).mirrored:
            labels = "; explained with the labels as they are, the score takes them mirrored"
        terms = scene.setup.describe(measurement.projected.ground_only)
        error = "no error to measure"
        if judged.mean_error is not None:
            error = f"mean error {pixels(judged.mean_error)} px"
        figures = (
            f"JaC@{judged.threshold:g} {percent_text(judged.jac)} %, {error} ({terms}{labels})"
        )
        return OverlayPicture(source, frame, picture, figures, tuple(sentences), judged.tp, remark)
