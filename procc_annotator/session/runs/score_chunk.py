"""Score chunks of frames: what is sent to whoever does the work, and what comes back."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Generic, NamedTuple, TypeVar

from natsort import natsorted

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.model_name import model_name
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.errors import CameraError, InputError
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.io.camera_files.cameras import fit_to_size
from procc_annotator.io.camera_files.fitted_on import NOT_FITTED, Fitted
from procc_annotator.io.camera_files.held_out_table import HeldOut
from procc_annotator.metric.clicked import AnnotatedExtent, clicked
from procc_annotator.metric.measure import Measurement, measure_frames
from procc_annotator.metric.project import why_clipped
from procc_annotator.metric.score import FrameScore, score
from procc_annotator.metric.sets import SetAccumulator
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.runs.annotation_notes import AnnotationNotes
from procc_annotator.session.runs.held_out import HeldOutTally
from procc_annotator.session.runs.set_run import AnnotationTask, KeptOpen
from procc_annotator.session.runs.tags import MODEL

T = TypeVar("T")

# Frames measured together: fewer cost more calls, more of them leave the processor's cache.
AT_ONCE = 32


@dataclass(frozen=True, slots=True)
class FrameResult:
    """What became of one annotated frame.

    ``counted`` is False for an unreadable annotation: it is listed but belongs to no figure of the
    set, for nobody knows what a camera should have agreed with. A frame whose camera is missing or
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
    fitted: Fitted = NOT_FITTED
    clicked: AnnotatedExtent | None = None


@dataclass(frozen=True, eq=False, slots=True)
class Evaluated:
    """A frame's result with what it was computed from, which stays in the process that has it.

    ``camera`` (px of the evaluation size), ``model``, ``measurement`` and ``annotation`` are there
    for frames that have scores.
    """

    result: FrameResult
    camera: CameraOrProjections | None = None
    model: str = ""
    measurement: Measurement | None = None
    annotation: FrameAnnotation | None = None


class FrameFiles(NamedTuple):
    """What a worker is told of a frame."""

    name: str
    annotation_file: str
    has_camera: bool
    groups: tuple[str | None, ...] = ()


@dataclass
class Tally:
    """Sums over one chunk of frames, and over those of each group."""

    sums: SetAccumulator
    groups: dict[tuple[str, str | None], SetAccumulator] = field(default_factory=dict)
    counted: int = 0
    with_camera: int = 0
    ground_only: bool = False
    fitted: Fitted = NOT_FITTED
    held_out: HeldOutTally = field(default_factory=HeldOutTally)
    notes: AnnotationNotes = field(default_factory=AnnotationNotes)

    def of_frame(self, by: tuple[str, ...], groups: tuple[str | None, ...]) -> list[SetAccumulator]:
        """Every sum a frame belongs to."""
        return [self.sums, *(self._group(key) for key in zip(by, groups, strict=True))]

    def merge(self, other: Tally) -> None:
        """Add the sums of the frames that follow."""
        self.sums.merge(other.sums)
        self.held_out.merge(other.held_out)
        self.notes.merge(other.notes)
        for key, sums in other.groups.items():
            self._group(key).merge(sums)

    def groups_by(self, by: str) -> list[tuple[str | None, SetAccumulator]]:
        """The groups of one kind in natural order, the one without a value last."""
        found = {value: sums for (kind, value), sums in self.groups.items() if kind == by}
        named = natsorted(value for value in found if value is not None)
        return [(value, found[value]) for value in (*named, *([None] if None in found else []))]

    def _group(self, key: tuple[str, str | None]) -> SetAccumulator:
        if key not in self.groups:
            self.groups[key] = SetAccumulator(self.sums.setup, self.sums.thresholds)
        return self.groups[key]


@dataclass(frozen=True)
class ScoreChunk(AnnotationTask, Generic[T]):
    """Evaluates chunks of frames."""

    cameras: KeptOpen[CameraCollection]
    setup: EvaluationSetup
    thresholds: tuple[float, ...]
    camera_size: tuple[int, int] | None
    by: tuple[str, ...]
    digest: Callable[[Evaluated], T]

    def __call__(self, chunk: Sequence[FrameFiles]) -> tuple[list[T], Tally]:
        tally = self.new_tally()
        digests: list[T] = []
        for start in range(0, len(chunk), AT_ONCE):
            read = [_read(pair, self) for pair in chunk[start : start + AT_ONCE]]
            digests += map(self.digest, _evaluated(read, self, tally))
        return digests, tally

    def new_tally(self) -> Tally:
        return Tally(SetAccumulator(self.setup, self.thresholds))

    def close(self) -> None:
        """Close what a worker opened."""
        super().close()
        self.cameras.close()


class _Read(NamedTuple):
    """What was read of a frame: the annotation unless it is unreadable, the camera if there is one,
    with its model and the remarks on it; what went wrong; and how much is annotated."""

    frame: FrameFiles
    annotation: FrameAnnotation | None
    camera: CameraOrProjections | None = None
    model: str = ""
    notices: tuple[str, ...] = ()
    fitted: Fitted = NOT_FITTED
    held_out: HeldOut | None = None
    error: str | None = None
    clicked: AnnotatedExtent | None = None


def _read(frame: FrameFiles, task: ScoreChunk[Any]) -> _Read:
    try:
        annotation = task.read(frame.annotation_file, task.setup.field)
    except InputError as error:
        return _Read(frame, None, error=str(error))
    how_much = clicked(annotation, task.setup.field)
    if not frame.has_camera:
        return _Read(frame, annotation, clicked=how_much)
    try:
        found = _load_camera(frame.name, annotation, task, task.cameras.opened)
        return _Read(frame, annotation, *found, clicked=how_much)
    except InputError as error:
        return _Read(frame, annotation, error=str(error), clicked=how_much)


def _evaluated(frames: Sequence[_Read], task: ScoreChunk[Any], tally: Tally) -> Iterator[Evaluated]:
    measured = _measured(frames, task.setup)
    for read in frames:
        name, groups = read.frame.name, read.frame.groups
        if read.annotation is None:
            unread = FrameResult(name, None, read.error, (), {}, counted=False, groups=groups)
            yield Evaluated(unread)
            continue
        tally.counted += 1
        tally.notes.add(name, read.annotation, task.setup.of_frame(name).field)
        if read.camera is None:
            for sums in tally.of_frame(task.by, groups):
                sums.add_missing_camera(name)
            without = FrameResult(name, None, read.error, (), {}, groups=groups)
            yield Evaluated(replace(without, clicked=read.clicked))
            continue
        yield _scored(read, measured[name], task, tally)


def _measured(frames: Sequence[_Read], setup: EvaluationSetup) -> dict[str, Measurement]:
    """The measurements of the frames that have a camera; of those on the same field at once."""
    alike: dict[int, tuple[EvaluationSetup, list[_Read]]] = {}
    for read in frames:
        if read.annotation is not None and read.camera is not None:
            own = setup.of_frame(read.frame.name)
            alike.setdefault(id(own.field), (own, []))[1].append(read)
    measured: dict[str, Measurement] = {}
    for own, some in alike.values():
        annotations = [read.annotation for read in some if read.annotation is not None]
        cameras = [read.camera for read in some if read.camera is not None]
        names = [read.frame.name for read in some]
        measured.update(zip(names, measure_frames(annotations, cameras, own), strict=True))
    return measured


def _scored(
    read: _Read, measurement: Measurement, task: ScoreChunk[Any], tally: Tally
) -> Evaluated:
    name = read.frame.name
    groups = tuple(
        read.model if by == MODEL else group
        for by, group in zip(task.by, read.frame.groups, strict=True)
    )
    scores = {threshold: score(measurement, threshold) for threshold in task.thresholds}
    for sums in tally.of_frame(task.by, groups):
        sums.add(name, measurement, scores)
    ground_only = measurement.projected.ground_only
    tally.with_camera += 1
    tally.ground_only |= ground_only
    tally.fitted += read.fitted
    tally.held_out.add(read.held_out if read.fitted.these else None)
    result = FrameResult(
        name,
        task.cameras.opened.display(name),
        None,
        read.notices,
        scores,
        ground_only=ground_only,
        model=read.model,
        groups=groups,
        fitted=read.fitted,
        clicked=read.clicked,
    )
    return Evaluated(result, read.camera, read.model, measurement, read.annotation)


def _load_camera(
    name: str, annotation: FrameAnnotation, task: ScoreChunk[Any], cameras: CameraCollection
) -> tuple[CameraOrProjections, str, tuple[str, ...], Fitted, HeldOut | None]:
    if name not in cameras.frames:  # it was there when the set was listed, on the first machine
        raise CameraError(
            cameras.path, f"holds no camera of frame {name!r} any more", advice="try again"
        )
    loaded = cameras.read(name, task.setup.field)
    setup = task.setup
    camera, scaled = fit_to_size(loaded, setup.size, task.camera_size, setup.unsized)
    if problem := why_clipped(camera, setup):
        raise CameraError(cameras.display(name), problem)
    notices = loaded.notices if scaled is None else (*loaded.notices, scaled)
    model = model_name(camera, loaded.model, setup.size)
    fitted = Fitted.of(loaded.fitted_on, annotation)
    return camera, model, notices, fitted, loaded.held_out
