"""Score chunks of frames: what is sent to whoever does the work, and what comes back."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Generic, NamedTuple, TypeVar

from natsort import natsorted

from procc_annotator.annotation import pixel_like
from procc_annotator.camera.base import projects_only_ground
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.errors import CameraError, InputError
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.io.camera_files.cameras import fit_to_size
from procc_annotator.metric.measure import Measurement, measure
from procc_annotator.metric.score import FrameScore, score
from procc_annotator.metric.sets import SetAccumulator
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.runs.set_run import AnnotationTask, KeptOpen
from procc_annotator.session.runs.tags import MODEL

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class FrameResult:
    """What became of one annotated frame.

    ``counted`` is False for an unreadable annotation: it is listed but belongs to no figure of the
    set, for nobody knows what a camera should have agreed with. A frame whose camera is missing or
    unreadable is counted (it lowers the completeness) and has no scores. ``groups`` are its values
    of what the set is grouped by, None where it has none; ``model`` is empty without a camera.
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


@dataclass(frozen=True, eq=False, slots=True)
class Evaluated:
    """A frame's result with what it was computed from, which stays in the process that has it.

    ``camera`` (px of the evaluation size), ``model`` and ``measurement`` are there for frames that
    have scores.
    """

    result: FrameResult
    camera: CameraOrProjections | None = None
    model: str = ""
    measurement: Measurement | None = None


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
    in_pixels: list[str] = field(default_factory=list)  # frames whose coordinates look like that

    def of_frame(self, by: tuple[str, ...], groups: tuple[str | None, ...]) -> list[SetAccumulator]:
        """Every sum a frame belongs to."""
        return [self.sums, *(self._group(key) for key in zip(by, groups, strict=True))]

    def merge(self, other: Tally) -> None:
        """Add the sums of the frames that follow."""
        self.sums.merge(other.sums)
        self.in_pixels += other.in_pixels
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
        return [self.digest(_evaluate(pair, self, tally)) for pair in chunk], tally

    def new_tally(self) -> Tally:
        return Tally(SetAccumulator(self.setup, self.thresholds))

    def close(self) -> None:
        """Close what a worker opened."""
        super().close()
        self.cameras.close()


def _evaluate(pair: FrameFiles, task: ScoreChunk[Any], tally: Tally) -> Evaluated:
    cameras = task.cameras.opened
    name, groups = pair.name, pair.groups
    try:
        annotation = task.read(pair.annotation_file, task.setup.field)
    except InputError as error:
        return Evaluated(FrameResult(name, None, str(error), (), {}, counted=False, groups=groups))
    tally.counted += 1
    if pixel_like(annotation) is not None:
        tally.in_pixels.append(name)
    try:
        loaded = _load_camera(name, task, cameras) if pair.has_camera else None
    except InputError as error:
        problem: str | None = str(error)
        loaded = None
    else:
        problem = None
    if loaded is None:
        for sums in tally.of_frame(task.by, groups):
            sums.add_missing_camera(name)
        return Evaluated(FrameResult(name, None, problem, (), {}, groups=groups))
    camera, model, notices = loaded
    groups = tuple(
        model if by == MODEL else group for by, group in zip(task.by, groups, strict=True)
    )
    ground_only = projects_only_ground(camera)
    measurement = measure(annotation, camera, task.setup.of_frame(name))
    scores = _scores(measurement, task.thresholds)
    for sums in tally.of_frame(task.by, groups):
        sums.add(name, measurement, scores)
    tally.with_camera += 1
    tally.ground_only |= ground_only
    shown = cameras.display(name)
    result = FrameResult(
        name, shown, None, notices, scores, ground_only=ground_only, model=model, groups=groups
    )
    return Evaluated(result, camera, model, measurement)


def _scores(measurement: Measurement, thresholds: tuple[float, ...]) -> dict[float, FrameScore]:
    return {threshold: score(measurement, threshold) for threshold in thresholds}


def _load_camera(
    name: str, task: ScoreChunk[Any], cameras: CameraCollection
) -> tuple[CameraOrProjections, str, tuple[str, ...]]:
    if name not in cameras.frames:  # it was there when the set was listed, on the first machine
        raise CameraError(
            cameras.path, f"holds no camera of frame {name!r} any more", advice="try again"
        )
    loaded = cameras.read(name)
    camera, scaled = fit_to_size(loaded, task.setup.size, task.camera_size)
    notices = loaded.notices if scaled is None else (*loaded.notices, scaled)
    return camera, loaded.model, notices
