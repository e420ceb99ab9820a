"""Evaluate a set: pair annotations and cameras by frame name, score every frame, sum up.

One bad file never stops the set. Frames come in natural order whoever does the work, and memory
does not grow with the set beyond its file names.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Generic, TypeVar

from procc_annotator.errors import UsageError
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.source import FileSource
from procc_annotator.metric.sets import SetSummary
from procc_annotator.metric.setup import EvaluationSetup, check_thresholds
from procc_annotator.session.runs.execution.executor import Executor, InProcess
from procc_annotator.session.runs.score_chunk import (
    Evaluated,
    FrameFiles,
    FrameResult,
    ScoreChunk,
    Tally,
)
from procc_annotator.session.runs.tags import Grouping

__all__ = [
    "CHUNK",
    "Evaluated",
    "EvaluationRun",
    "FrameResult",
    "GroupSummary",
    "check_thresholds",
    "in_pixels_words",
    "run_digested",
    "run_evaluation",
]

# Frames a worker takes at once. The sums are made chunk by chunk in one process too, so that the
# figures are the same to the last bit for any number of workers.
CHUNK = 64

T = TypeVar("T")


@dataclass(frozen=True)
class GroupSummary:
    """The figures of the frames that share a value.

    Attributes:
        by: what they are grouped by, a column of tags or ``model``.
        value: None for frames that have none.
        summaries: by threshold; their ``images`` and ``evaluated`` say how many frames there are.
    """

    by: str
    value: str | None
    summaries: Mapping[float, SetSummary]


@dataclass
class EvaluationRun(Generic[T]):
    """One pass over a set; iterate it once, then ask for the `summary`.

    Attributes:
        total: number of annotation files, i.e. of results to come.
        tagged: number of frames that have tags.
        matched: number of frames that have a camera file.
        unmatched_cameras: frames with a camera file but no annotation: reported, not counted.
        counted, with_camera: frames so far that count, and those of them that were scored.
    """

    annotations: FileSource
    cameras: CameraCollection
    task: ScoreChunk[T]
    executor: Executor
    grouping: Grouping = field(default_factory=Grouping)
    chunk: int = 0
    total: int = field(init=False)
    tagged: int = field(init=False)
    matched: int = field(init=False)
    unmatched_cameras: tuple[str, ...] = field(init=False)
    counted: int = field(init=False, default=0)
    with_camera: int = field(init=False, default=0)
    ground_only: bool = field(init=False, default=False)

    def __post_init__(self) -> None:
        annotation_files = list_annotations(self.annotations)
        camera_files = self.cameras.frames
        self._pairs: list[FrameFiles] = [
            FrameFiles(name, file, name in camera_files, self.grouping.of(name))
            for name, file in annotation_files.items()
        ]
        self.notices = self.cameras.notices
        self.total = len(self._pairs)
        self.tagged = sum(pair.name in self.grouping.values for pair in self._pairs)
        self.matched = sum(pair.has_camera for pair in self._pairs)
        self.unmatched_cameras = tuple(n for n in camera_files if n not in annotation_files)
        self._sums = self.task.new_tally()
        self._require_work(list(annotation_files), list(camera_files))

    @property
    def names(self) -> Iterator[str]:
        """The frames, in the order they come."""
        return (pair.name for pair in self._pairs)

    @property
    def setup(self) -> EvaluationSetup:
        """What every frame is scored with."""
        return self.task.setup

    @property
    def thresholds(self) -> tuple[float, ...]:
        """At which every frame is scored, px."""
        return self.task.thresholds

    def _require_work(self, annotated: list[str], cameras: list[str]) -> None:
        if not annotated:
            raise UsageError(
                f"nothing to do: no annotation (*.json) in {self.annotations.path}"
                + _choice(self.annotations)
            )
        if not cameras:
            raise UsageError(
                f"nothing to do: no camera (format {self.cameras.format}) in {self.cameras.path}"
                + _choice(self.cameras)
            )
        if not self.matched:
            raise UsageError(
                "nothing to do: no camera has the name of an annotation"
                f" (annotations are named like {annotated[0]!r}, cameras like {cameras[0]!r})"
            )

    def __iter__(self) -> Iterator[T]:
        for digests, tally in self.executor.map(self.task, self._chunks(), name=_frames_of):
            yield from digests
            self._take(tally)

    def _chunks(self) -> Iterator[list[FrameFiles]]:
        size = self.chunk or CHUNK
        for start in range(0, len(self._pairs), size):
            yield self._pairs[start : start + size]

    def _take(self, tally: Tally) -> None:
        self._sums.merge(tally)
        self.counted += tally.counted
        self.with_camera += tally.with_camera
        self.ground_only |= tally.ground_only

    @property
    def in_pixels(self) -> tuple[str, ...]:
        """The frames so far whose annotations look like pixels, where shares of the picture are
        expected."""
        return tuple(self._sums.in_pixels)

    def summary(self) -> dict[float, SetSummary]:
        """Figures of the frames seen so far, by threshold."""
        return self._sums.sums.summary()

    def group_summaries(self) -> tuple[GroupSummary, ...]:
        """The same for the frames of each group, in the order of what they are grouped by."""
        return tuple(
            GroupSummary(by, value, sums.summary())
            for by in self.task.by
            for value, sums in self._sums.groups_by(by)
        )

    def describe(self) -> str:
        """Protocol, size and what else the numbers depend on, in words."""
        return self.setup.describe(self.ground_only)


def in_pixels_words(frames: Sequence[str]) -> str:
    """What is wrong with annotations in pixels, and which are."""
    count = f"{len(frames)} frame" + ("" if len(frames) == 1 else "s")
    named = ", ".join(frames[:5]) + (", ..." if len(frames) > 5 else "")
    return f"coordinates look like pixels, expected 0 to 1, in {count} ({named})"


def run_evaluation(
    annotations: FileSource,
    cameras: CameraCollection,
    setup: EvaluationSetup,
    thresholds: Sequence[float],
    *,
    camera_size: tuple[int, int] | None = None,
    executor: Executor | None = None,
    grouping: Grouping | None = None,
) -> EvaluationRun[FrameResult]:
    """Score every annotated frame that has a camera.

    Args:
        annotations: folder or archive of annotation files.
        cameras: the cameras, by frame name.
        setup: field, size, protocol.
        thresholds: px, at least one.
        camera_size: picture size the cameras refer to, where their files do not say.
        executor: who does the work; this process unless given.
        grouping: what else to make figures by.

    Raises:
        UsageError: nothing to evaluate, or a threshold that is none.
        InputError: a folder or archive that cannot be listed.
    """
    return run_digested(
        annotations,
        cameras,
        setup,
        thresholds,
        _itself,
        camera_size=camera_size,
        executor=executor,
        grouping=grouping,
    )


def run_digested(
    annotations: FileSource,
    cameras: CameraCollection,
    setup: EvaluationSetup,
    thresholds: Sequence[float],
    digest: Callable[[Evaluated], T],
    *,
    camera_size: tuple[int, int] | None = None,
    executor: Executor | None = None,
    grouping: Grouping | None = None,
    chunk: int = 0,
) -> EvaluationRun[T]:
    """As `run_evaluation`, but yields ``digest(evaluated)``, computed where the frame was scored.

    Args:
        digest: survives the trip into a worker process (a module's function, a partial of one).
        chunk: frames a worker takes at once, where they take much longer than scoring does. It
            belongs to the task, not to the machine: sums of other chunks may differ in their last
            digit.
    """
    grouping = grouping or Grouping()
    task = ScoreChunk(
        annotations.path,
        cameras.path,
        Path.cwd(),
        setup,
        check_thresholds(thresholds),
        cameras.format,
        camera_size,
        grouping.by,
        digest,
    )
    vars(task)["sources"] = annotations, cameras  # what is open here need not be opened again
    return EvaluationRun(annotations, cameras, task, executor or InProcess(), grouping, chunk)


def _itself(evaluated: Evaluated) -> FrameResult:
    return evaluated.result


def _frames_of(chunk: Sequence[FrameFiles]) -> str:
    first, last = chunk[0].name, chunk[-1].name
    return f"frame {first}" if len(chunk) == 1 else f"frames {first} to {last}"


def _choice(source: FileSource | CameraCollection) -> str:
    """What to choose from where several splits lie in one place."""
    folders = source.folders()
    if len(folders) < 2:
        return ""
    return f"; it holds {len(folders)} folders ({', '.join(folders[:5])}), choose one"
