"""Evaluate the cameras of a method on a set.

One bad file never stops the set. Frames come in natural order anyone who does the work, and memory
does not grow with the set beyond its file names.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

from procc_annotator.batch.execution.executor import Executor
from procc_annotator.batch.grouping import Grouping
from procc_annotator.batch.scoring import Evaluated, FrameFiles, LeftOutMetrics, ScoreChunk, Tally
from procc_annotator.batch.set_run import (
    SetRun,
    annotations_for,
    choice_of,
    reopenable_cameras,
    reopenable_source,
)
from procc_annotator.dataset.diagnostics import found_instead_of_cameras
from procc_annotator.errors import UsageError
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_source import FileSource
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.metrics.setup import EvaluationSetup, check_thresholds

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


class EvaluationRun(SetRun[FrameFiles, T, Tally]):
    """One pass over a set; iterate it once, then ask for the `summary`.

    Attributes:
        matched: number of frames that have a camera file.
        tagged: number of frames that have tags.
        unmatched_cameras: frames with a camera file but no annotation: reported, not counted.
        notices: remarks on the cameras.
        tally: sums of the frames so far.
    """

    chunk = CHUNK
    task: ScoreChunk[T]

    def __init__(
        self,
        annotations: FileSource,
        cameras: CameraCollection,
        task: ScoreChunk[T],
        executor: Executor | None = None,
        grouping: Grouping | None = None,
    ) -> None:
        annotated, with_camera = annotations_for(cameras.frames, annotations), cameras.frames
        tags = grouping or Grouping()
        frames = [
            FrameFiles(name, file, name in with_camera, tags.of(name))
            for name, file in annotated.items()
        ]
        super().__init__(frames, task, executor)
        self.matched = sum(frame.has_camera for frame in frames)
        self.tagged = sum(frame.name in tags.values for frame in frames)
        used = {with_camera.name_there(frame.name) for frame in frames if frame.has_camera}
        self.unmatched_cameras = tuple(name for name in with_camera if name not in used)
        unread = (name for name in with_camera.unreadable if name not in used)
        notices = (f"{cameras.display(n)}: cannot be read (no frame annotated)" for n in unread)
        self.notices = (*cameras.notices, *notices)
        self.tally = task.new_tally()
        self._require_cameras(annotations, cameras)

    @property
    def setup(self) -> EvaluationSetup:
        """Return what every frame is scored with."""
        return self.task.setup

    @property
    def thresholds(self) -> tuple[float, ...]:
        """At which every frame is scored, px."""
        return self.task.thresholds

    def _require_cameras(self, annotations: FileSource, cameras: CameraCollection) -> None:
        if not cameras.frames:
            raise UsageError(
                f"nothing to do: no camera (format {cameras.format}) in {cameras.path}"
                + (found_instead_of_cameras(cameras.path) or choice_of(cameras))
            )
        if not self.matched:
            first = next(iter(cameras.frames))
            if instead := found_instead_of_cameras(cameras.path):
                raise UsageError(f"nothing to do: no camera in {cameras.path}{instead}")
            if len(cameras.frames) == 1:
                cameras.read(first)  # of a file of many that cannot be read only this is known
            annotated, called = self.frames[0].name, cameras.frames.only_folder + first
            raise UsageError(
                "nothing to do: no camera has the name of an annotation (annotations are named"
                f" like {annotated!r}, cameras like {called!r})"
                + (choice_of(annotations) if "/" in annotated else "")
            )

    def _take(self, results: Sequence[T], sums: Tally) -> None:
        self.tally.merge(sums)

    @property
    def held_out(self) -> LeftOutMetrics:
        """Return what is known of elements left out of the fits among the cameras so far."""
        return self.tally.held_out.at(self.setup)

    def summary(self) -> dict[float, SetSummary]:
        """Figures of the frames seen so far, by threshold."""
        return self.tally.sums.summary()

    def group_summaries(self) -> tuple[GroupSummary, ...]:
        """The same for the frames of each group, in the order of what they are grouped by."""
        return tuple(
            GroupSummary(by, value, sums.summary())
            for by in self.task.by
            for value, sums in self.tally.groups_by(by)
        )


def run_evaluation(
    annotations: FileSource,
    cameras: CameraCollection,
    setup: EvaluationSetup,
    thresholds: Sequence[float],
    digest: Callable[[Evaluated], T],
    *,
    camera_size: tuple[int, int] | None = None,
    executor: Executor | None = None,
    grouping: Grouping | None = None,
) -> EvaluationRun[T]:
    """Score every annotated frame that has a camera; yields ``digest(evaluated)`` of each.

    Args:
        digest: computed where the frame is scored; survives the trip into a worker process (a
            module's function, a partial of one).
        camera_size: picture size the cameras refer to, where their files do not say.
        grouping: what else to make figures by.

    Raises:
        UsageError: nothing to evaluate, or an invalid threshold.
        InputError: a folder or archive that cannot be listed.
    """
    task = ScoreChunk(
        reopenable_source(annotations),
        reopenable_cameras(cameras),
        setup,
        check_thresholds(thresholds),
        camera_size,
        grouping.by if grouping else (),
        digest,
    )
    return EvaluationRun(annotations, cameras, task, executor, grouping)
