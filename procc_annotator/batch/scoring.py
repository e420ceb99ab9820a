"""Score chunks of frames in a worker: results, sums, notes, left-out elements."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import islice
from typing import Generic, NamedTuple, TypeVar

from natsort import natsorted

from procc_annotator.annotation import FrameAnnotation, pixel_like
from procc_annotator.batch.grouping import MODEL
from procc_annotator.batch.set_run import AnnotationTask, ReopenableHandle
from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.camera.models import model_name
from procc_annotator.errors import CameraError, InputError
from procc_annotator.field.load import field_fingerprint
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.fit_record import (
    NOT_FITTED,
    FitCounts,
    LeftOutElement,
    LeftOutResult,
    LeftOutSettings,
)
from procc_annotator.formats.cameras.loaded_camera import fit_to_size
from procc_annotator.formats.strict_json import printable
from procc_annotator.messages import first_names, list_names
from procc_annotator.metrics.camera_origin import origins
from procc_annotator.metrics.measurement import Measurement, measure_frames
from procc_annotator.metrics.projection import projections_error
from procc_annotator.metrics.score import FrameScore, score
from procc_annotator.metrics.sets import AnnotatedExtent, SetAccumulator, annotated_extent
from procc_annotator.metrics.setup import EvaluationSetup


@dataclass
class LeftOutTally:
    """The elements left out of a source's fits, of all its frames, by what they were judged with.

    Attributes:
        found: terms -> the elements of each frame.
    """

    found: dict[LeftOutSettings, list[tuple[LeftOutElement, ...]]] = field(default_factory=dict)

    def add(self, of_frame: LeftOutResult | None) -> None:
        """Add the result for a frame's camera."""
        if of_frame is not None:
            self.found.setdefault(of_frame.terms, []).append(of_frame.elements)

    def merge(self, other: LeftOutTally) -> None:
        """Add the frames that follow."""
        for terms, frames in other.found.items():
            self.found.setdefault(terms, []).extend(frames)

    def at(self, setup: EvaluationSetup) -> LeftOutMetrics:
        """Return what counts where cameras are judged so."""
        if not self.found:
            return LeftOutMetrics()
        own = left_out_settings(setup)
        frames = self.found.get(own, [])
        others = tuple(sorted({(t.protocol, t.size) for t in self.found if t != own}))
        every = tuple(e for frame in frames for e in frame)
        return LeftOutMetrics(sum(map(bool, frames)), every, others, len(frames))


@dataclass(frozen=True)
class LeftOutMetrics:
    """The elements left out of a source's fits.

    Attributes:
        frames: with at least one of these elements.
        elements: left out, of all frames.
        others: protocol and size of figures that were made with other terms, and do not count.
        tried: frames whose elements were left out, also those of which none counts.
    """

    frames: int = 0
    elements: tuple[LeftOutElement, ...] = ()
    others: tuple[tuple[str, tuple[int, int]], ...] = ()
    tried: int = 0

    def shares(self, tau: float) -> tuple[float, float] | None:
        """The shares of elements that are correct at a threshold under the cameras of the others,
        and under those of all; None without elements."""
        if not self.elements:
            return None
        predicted = passed((e.predicted_px for e in self.elements), tau)
        explained = passed((e.explained_px for e in self.elements), tau)
        return predicted / len(self.elements), explained / len(self.elements)


def left_out_settings(setup: EvaluationSetup) -> LeftOutSettings:
    """Return what elements are judged with."""
    return LeftOutSettings(setup.protocol, setup.size, field_fingerprint(setup.field))


def passed(distances_px: Iterable[float | None], tau: float) -> int:
    """Return how many elements with such farthest points are correct at a threshold."""
    return sum(d is not None and d < tau for d in distances_px)


@dataclass
class AnnotationNotes:
    """Frames with such annotations, and the classes that are of no element of the field."""

    in_pixels: list[str] = field(default_factory=list)
    empty: list[str] = field(default_factory=list)
    of_cameras: list[str] = field(default_factory=list)
    without_place: list[str] = field(default_factory=list)
    classes: Counter[str] = field(default_factory=Counter)

    def add(self, frame: str, annotation: FrameAnnotation, known: Field) -> None:
        """Add a frame.

        Args:
            known: the field its classes are of.
        """
        strange = [n for n in annotation.annotated if known.canonical_name(n) not in known.index]
        if pixel_like(annotation) is not None:
            self.in_pixels.append(frame)
        if origins(annotation):
            self.of_cameras.append(frame)
        if not annotation.annotated:
            self.empty.append(frame)
        if strange:
            self.without_place.append(frame)
            self.classes.update(strange)

    def merge(self, other: AnnotationNotes) -> None:
        """Add those of the frames that follow."""
        self.in_pixels += other.in_pixels
        self.empty += other.empty
        self.of_cameras += other.of_cameras
        self.without_place += other.without_place
        self.classes.update(other.classes)

    def lines(self) -> tuple[str, ...]:
        """One line for people for each kind that there is."""
        found = []
        if self.in_pixels:
            frames = list_names(self.in_pixels, "frame")
            found.append(f"coordinates look like pixels, expected 0 to 1, in {frames}")
        if self.empty:
            frames = list_names(self.empty, "frame")
            found.append(f"no element is annotated in {frames}: whatever a camera shows is wrong")
        if self.of_cameras:
            frames = list_names(self.of_cameras, "frame")
            found.append(f"points of {frames} come from cameras, which count as fitted on them")
        if self.without_place:
            names = first_names([*map(printable, self.classes)])
            frames = list_names(self.without_place, "frame")
            found.append(
                f"classes of no element of the field always count as missed: {names}, in {frames}"
            )
        return tuple(found)


T = TypeVar("T")

# Frames measured together: fewer cost more calls, more of them leave the processor's cache.
_AT_ONCE = 32
NOTHING_SHOWN = "shows no element of the field in the picture"
# Of the picture's width: a mean error above it in a frame where no element passes is rather of
# cameras of another size or world. Of three published methods on 186 frames one frame is so.
_ASTRAY = 0.05


@dataclass(frozen=True, slots=True)
class FrameResult:
    """Result for one annotated frame.

    ``counted`` is False for an unreadable annotation: it is listed but belongs to no figure of the
    set, for no one knows what a camera should have agreed with. A frame whose camera is missing or
    unreadable is counted (it lowers the completeness) and has no scores. ``groups`` are its values
    of what the set is grouped by, None where it has none; ``model`` is empty without a camera;
    ``fitted`` says that the camera was fitted to this annotation or another version of it;
    ``clicked`` is how much of the frame is annotated, None where the annotation could not be read.
    """

    name: str
    camera: str | None
    error: str | None
    notices: tuple[str, ...]
    scores: Mapping[float, FrameScore]
    counted: bool = True
    ground_only: bool = False
    model: str = ""
    groups: tuple[str | None, ...] = ()
    fitted: FitCounts = NOT_FITTED
    clicked: AnnotatedExtent | None = None


@dataclass(frozen=True, eq=False, slots=True)
class Evaluated:
    """A frame's result with what it was computed from, which stays in the process that has it.

    ``camera`` (px of the evaluation size), ``model``, ``measurement`` and ``annotation`` are there
    for frames that have scores; ``held_out`` for fits that elements were left out of with this
    setup.
    """

    result: FrameResult
    camera: CameraOrProjections | None = None
    model: str = ""
    measurement: Measurement | None = None
    annotation: FrameAnnotation | None = None
    held_out: tuple[LeftOutElement, ...] = ()


class FrameFiles(NamedTuple):
    """A worker's input for a frame."""

    name: str
    annotation_file: str
    has_camera: bool
    groups: tuple[str | None, ...] = ()


@dataclass
class Tally:
    """Sums over frames, and over those of each group.

    Attributes:
        counted, with_camera: frames that count, and those of them that were scored.
        ground_only: whether one of the cameras knows only the ground.
        astray: frames in which no element passes and the mean error is above `_ASTRAY`.
        fitted: how many of the cameras were fitted to the annotations they are judged by.
    """

    sums: SetAccumulator
    groups: dict[tuple[str, str | None], SetAccumulator] = field(default_factory=dict)
    counted: int = 0
    with_camera: int = 0
    ground_only: bool = False
    astray: int = 0
    fitted: FitCounts = NOT_FITTED
    held_out: LeftOutTally = field(default_factory=LeftOutTally)
    notes: AnnotationNotes = field(default_factory=AnnotationNotes)

    @cached_property
    def left_out_terms(self) -> LeftOutSettings:
        """What elements left out of fits are judged with."""
        return left_out_settings(self.sums.setup)

    def of_frame(self, by: tuple[str, ...], groups: tuple[str | None, ...]) -> list[SetAccumulator]:
        """Every sum a frame belongs to."""
        return [self.sums, *(self._group(key) for key in zip(by, groups, strict=True))]

    def merge(self, other: Tally) -> None:
        """Add the sums of the frames that follow."""
        self.sums.merge(other.sums)
        self.counted += other.counted
        self.with_camera += other.with_camera
        self.ground_only |= other.ground_only
        self.astray += other.astray
        self.fitted += other.fitted
        self.held_out.merge(other.held_out)
        self.notes.merge(other.notes)
        for key, sums in other.groups.items():
            self._group(key).merge(sums)

    @property
    def described(self) -> str:
        """Protocol, size and what else the numbers depend on, in words."""
        terms = self.sums.setup.describe(self.ground_only)
        mark = self.fitted.among(self.with_camera)
        return f"{terms}, {mark}" if mark else terms

    @property
    def size_doubt(self) -> str:
        """Remark for a set whose cameras hardly belong to its size or world; empty for others."""
        if 2 * self.astray <= self.with_camera or self.notes.in_pixels:
            return ""
        width, height = self.sums.setup.size
        return (
            f"in {self.astray} of {self.with_camera} frames no element passes, and points are over"
            f" {_ASTRAY * width:.0f} px off or their elements out of sight: check which picture"
            f" size the cameras belong to (camera size; evaluated at {width}x{height}), that z"
            " is down, and that the origin is the field's centre, not a corner"
        )

    def groups_by(self, by: str) -> list[tuple[str | None, SetAccumulator]]:
        """The groups of one kind in natural order, the one without a value last."""
        found = {value: sums for (kind, value), sums in self.groups.items() if kind == by}
        named = natsorted(value for value in found if value is not None)
        return [(value, found[value]) for value in (*named, *([None] if None in found else []))]

    def _group(self, key: tuple[str, str | None]) -> SetAccumulator:
        if key not in self.groups:
            self.groups[key] = SetAccumulator(self.sums.setup, self.sums.thresholds)
        return self.groups[key]


@dataclass(frozen=True, slots=True)
class FrameInput:
    """A frame to score.

    Attributes:
        annotation: None if it could not be read.
        camera: px of the evaluation size; None if absent or it could not be read.
        place: where the camera was read.
        model, notices, fitted_on, held_out: of the camera, see `LoadedCamera`.
        error: what could not be read, and why.
        groups: values of what the set is grouped by; that of ``model`` is the camera's.
    """

    name: str
    annotation: FrameAnnotation | None
    camera: CameraOrProjections | None = None
    place: str | None = None
    model: str = ""
    notices: tuple[str, ...] = ()
    fitted_on: str | None = None
    held_out: LeftOutResult | None = None
    error: str | None = None
    groups: tuple[str | None, ...] = ()


def score_frames(
    frames: Iterable[FrameInput], tally: Tally, by: tuple[str, ...] = ()
) -> Iterator[Evaluated]:
    """Score frames one after the other and add them to a tally, which has setup and thresholds.

    Args:
        by: what ``groups`` of the frames are values of.
    """
    rest = iter(frames)
    while some := list(islice(rest, _AT_ONCE)):
        measured = _measured(some, tally.sums.setup)
        for frame in some:
            yield _scored(frame, measured.get(frame.name), tally, by)


def _measured(frames: Sequence[FrameInput], setup: EvaluationSetup) -> dict[str, Measurement]:
    """The measurements of the frames that have a camera; of those on the same field at once."""
    alike: dict[int, tuple[EvaluationSetup, list[FrameInput]]] = {}
    for frame in frames:
        if frame.annotation is not None and frame.camera is not None:
            own = setup.of_frame(frame.name)
            alike.setdefault(id(own.field), (own, []))[1].append(frame)
    measured: dict[str, Measurement] = {}
    for own, some in alike.values():
        annotations = [frame.annotation for frame in some if frame.annotation is not None]
        cameras = [frame.camera for frame in some if frame.camera is not None]
        names = [frame.name for frame in some]
        measured.update(zip(names, measure_frames(annotations, cameras, own), strict=True))
    return measured


def _scored(
    frame: FrameInput, measurement: Measurement | None, tally: Tally, by: tuple[str, ...]
) -> Evaluated:
    name, annotation, setup = frame.name, frame.annotation, tally.sums.setup
    if annotation is None:
        unread = FrameResult(name, None, frame.error, (), {}, counted=False, groups=frame.groups)
        return Evaluated(unread)
    tally.counted += 1
    tally.notes.add(name, annotation, setup.of_frame(name).field)
    extent = annotated_extent(annotation, setup.field)
    if measurement is None:
        for sums in tally.of_frame(by, frame.groups):
            sums.add_missing_camera(name)
        without = FrameResult(name, None, frame.error, (), {}, groups=frame.groups, clicked=extent)
        return Evaluated(without)
    groups = tuple(
        frame.model if kind == MODEL else value
        for kind, value in zip(by, frame.groups, strict=True)
    )
    scores = {threshold: score(measurement, threshold) for threshold in tally.sums.thresholds}
    for sums in tally.of_frame(by, groups):
        sums.add(name, measurement, scores)
    shown = measurement.projected
    ground_only = shown.ground_only
    tally.with_camera += 1
    tally.ground_only |= ground_only
    tally.astray += _is_astray(scores[max(scores)], setup)
    fitted = FitCounts.of(frame.fitted_on, annotation, measurement)
    tally.fitted += fitted
    held_out = frame.held_out if fitted.these else None
    tally.held_out.add(held_out)
    result = FrameResult(
        name,
        frame.place,
        None,
        frame.notices if shown.shows_any else (*frame.notices, NOTHING_SHOWN),
        scores,
        ground_only=ground_only,
        model=frame.model,
        groups=groups,
        fitted=fitted,
        clicked=extent,
    )
    elements: tuple[LeftOutElement, ...] = ()
    if held_out is not None and held_out.terms == tally.left_out_terms:
        elements = held_out.elements
    return Evaluated(result, frame.camera, frame.model, measurement, annotation, elements)


def _is_astray(score: FrameScore, setup: EvaluationSetup) -> bool:
    if score.tp or not (score.read.rows >= 0).any():
        return False
    return score.mean_error is None or score.mean_error > _ASTRAY * setup.size[0]


@dataclass(frozen=True)
class ScoreChunk(AnnotationTask, Generic[T]):
    """Evaluates chunks of frames."""

    cameras: ReopenableHandle[CameraCollection]
    setup: EvaluationSetup
    thresholds: tuple[float, ...]
    camera_size: tuple[int, int] | None
    by: tuple[str, ...]
    digest: Callable[[Evaluated], T]

    def __call__(self, chunk: Sequence[FrameFiles]) -> tuple[list[T], Tally]:
        tally = self.new_tally()
        found = score_frames(map(self._input, chunk), tally, self.by)
        return list(map(self.digest, found)), tally

    def new_tally(self) -> Tally:
        return Tally(SetAccumulator(self.setup, self.thresholds))

    def close(self) -> None:
        """Close what a worker opened."""
        super().close()
        self.cameras.close()

    def _input(self, frame: FrameFiles) -> FrameInput:
        name, annotation = frame.name, None
        try:
            annotation = self.read(frame.annotation_file, self.setup.field)
            if frame.has_camera:
                return self._with_camera(frame, annotation)
        except InputError as error:
            return FrameInput(name, annotation, error=str(error), groups=frame.groups)
        return FrameInput(name, annotation, groups=frame.groups)

    def _with_camera(self, frame: FrameFiles, annotation: FrameAnnotation) -> FrameInput:
        name, cameras, setup = frame.name, self.cameras.opened, self.setup
        if name not in cameras.frames:  # it was there when the set was listed, on the first machine
            raise CameraError(
                cameras.path, f"holds no camera of frame {name!r} any more", advice="try again"
            )
        loaded, place = cameras.read(name, setup.field), cameras.display(name)
        camera, scaled = fit_to_size(loaded, setup.size, self.camera_size, setup.unsized)
        if problem := projections_error(camera, setup.of_frame(name)):
            raise CameraError(place, problem)
        return FrameInput(
            name,
            annotation,
            camera,
            place,
            model_name(camera, loaded.model, setup.size),
            loaded.notices if scaled is None else (*loaded.notices, scaled),
            loaded.fitted_on,
            loaded.held_out,
            groups=frame.groups,
        )
