"""Evaluate a set: pair annotations and cameras by frame name, score every frame, sum up.

One bad file never stops the set. Frames come in natural order whatever the number of workers, and
memory does not grow with the set beyond its file names.
"""

from __future__ import annotations

import math
import multiprocessing
import os
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any, Generic, TypeVar

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.errors import InputError, ProccError, UsageError
from procc_annotator.io.camera_collection import CameraCollection
from procc_annotator.io.cameras import fit_to_size
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.soccernet_annotation import read_annotation
from procc_annotator.io.source import FileSource, open_source
from procc_annotator.metric.measure import Measurement, measure
from procc_annotator.metric.score import FrameScore, score
from procc_annotator.metric.sets import SetAccumulator, SetSummary
from procc_annotator.metric.setup import EvaluationSetup

# Frames a worker takes at once. The sums are made chunk by chunk in one process too, so that the
# figures are the same to the last bit for any number of workers.
CHUNK = 64

# Starting a process costs about half a second: below this many frames one is as fast as many.
WORTH_WORKERS = 2000

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class FrameResult:
    """What became of one annotated frame.

    ``counted`` is False for an unreadable annotation: it is listed but belongs to no figure of the
    set, for nobody knows what a camera should have agreed with. A frame whose camera is missing or
    unreadable is counted (it lowers the completeness) and has no scores.
    """

    name: str
    camera: str | None
    error: str | None
    notices: tuple[str, ...]
    scores: Mapping[float, FrameScore]
    counted: bool = True
    ground_only: bool = False


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


@dataclass(frozen=True)
class _Job:
    """Everything a worker needs to evaluate any frame of the set."""

    annotations: Path
    cameras: Path
    setup: EvaluationSetup
    thresholds: tuple[float, ...]
    camera_format: str
    camera_size: tuple[int, int] | None
    digest: Callable[[Evaluated], Any]


_Pair = tuple[str, str, bool]  # frame name, annotation file, whether it has a camera


@dataclass
class EvaluationRun(Generic[T]):
    """One pass over a set; iterate it once, then ask for the `summary`.

    Attributes:
        total: number of annotation files, i.e. of results to come.
        matched: number of frames that have a camera file.
        unmatched_cameras: frames with a camera file but no annotation: reported, not counted.
        counted, with_camera: frames so far that count, and those of them that were scored.
    """

    annotations: FileSource
    cameras: CameraCollection
    job: _Job
    workers: int
    total: int = field(init=False)
    matched: int = field(init=False)
    unmatched_cameras: tuple[str, ...] = field(init=False)
    counted: int = field(init=False, default=0)
    with_camera: int = field(init=False, default=0)
    ground_only: bool = field(init=False, default=False)

    def __post_init__(self) -> None:
        annotation_files = list_annotations(self.annotations)
        camera_files = self.cameras.frames
        self._pairs: list[_Pair] = [
            (name, file, name in camera_files) for name, file in annotation_files.items()
        ]
        self.notices = self.cameras.notices
        self.total = len(self._pairs)
        self.matched = sum(has_camera for _, _, has_camera in self._pairs)
        self.unmatched_cameras = tuple(n for n in camera_files if n not in annotation_files)
        self._sums = SetAccumulator(self.job.setup, self.job.thresholds)
        self.workers = self.workers or _suitable_workers(self.total)
        self._require_work(list(annotation_files), list(camera_files))

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
        chunks = _chunks(self._pairs)
        if self.workers > 1 and self.total > CHUNK:
            yield from self._in_workers(chunks)
        else:
            for chunk in chunks:
                sums = SetAccumulator(self.job.setup, self.job.thresholds)
                tally = _Tally(sums)
                for pair in chunk:
                    result = _evaluate(pair, self.job, self.annotations, self.cameras, tally)
                    yield self.job.digest(result)
                self._take(tally)

    def _in_workers(self, chunks: Iterator[list[_Pair]]) -> Iterator[T]:
        context = multiprocessing.get_context("spawn")
        pool = ProcessPoolExecutor(self.workers, context, _start_worker, (self.job,))
        try:
            # A bounded window of chunks keeps memory flat when writing is slower than scoring.
            waiting: deque[Future[tuple[list[T], _Tally]]] = deque(
                pool.submit(_evaluate_chunk, chunk) for chunk in islice(chunks, 2 * self.workers)
            )
            while waiting:
                digests, tally = waiting.popleft().result()
                for chunk in islice(chunks, 1):
                    waiting.append(pool.submit(_evaluate_chunk, chunk))
                yield from digests
                self._take(tally)
        except BrokenProcessPool as error:
            raise ProccError(
                "a worker process was ended from outside (memory?); try --workers 1"
            ) from error
        finally:
            pool.shutdown(cancel_futures=True)

    def _take(self, tally: _Tally) -> None:
        self._sums.merge(tally.sums)
        self.counted += tally.counted
        self.with_camera += tally.with_camera
        self.ground_only |= tally.ground_only

    def summary(self) -> dict[float, SetSummary]:
        """Figures of the frames seen so far, by threshold."""
        return self._sums.summary()

    def describe(self) -> str:
        """Protocol, size and what else the numbers depend on, in words."""
        return self.job.setup.describe(self.ground_only)


@dataclass
class _Tally:
    """Sums over one chunk of frames."""

    sums: SetAccumulator
    counted: int = 0
    with_camera: int = 0
    ground_only: bool = False


def run_evaluation(
    annotations: FileSource,
    cameras: CameraCollection,
    setup: EvaluationSetup,
    thresholds: Sequence[float],
    *,
    camera_size: tuple[int, int] | None = None,
    workers: int = 0,
) -> EvaluationRun[FrameResult]:
    """Score every annotated frame that has a camera.

    Args:
        annotations: folder or archive of annotation files.
        cameras: the cameras, by frame name.
        setup: field, size, protocol.
        thresholds: px, at least one.
        camera_size: picture size the cameras refer to, where their files do not say.
        workers: processes; 0 for as many as suit the size of the set and the machine.

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
        workers=workers,
    )


def run_digested(
    annotations: FileSource,
    cameras: CameraCollection,
    setup: EvaluationSetup,
    thresholds: Sequence[float],
    digest: Callable[[Evaluated], T],
    *,
    camera_size: tuple[int, int] | None = None,
    workers: int = 0,
) -> EvaluationRun[T]:
    """As `run_evaluation`, but yields ``digest(evaluated)``, computed where the frame was scored.

    Args:
        digest: survives the trip into a worker process (a module's function, a partial of one).
    """
    job = _Job(
        annotations.path,
        cameras.path,
        setup,
        check_thresholds(thresholds),
        cameras.format,
        camera_size,
        digest,
    )
    return EvaluationRun(annotations, cameras, job, workers)


def check_thresholds(thresholds: Sequence[float]) -> tuple[float, ...]:
    """The thresholds without repetitions, in the order given.

    Raises:
        UsageError: none given, or one that is not a positive number of pixels.
    """
    for threshold in thresholds:
        if not (math.isfinite(threshold) and threshold > 0):
            raise UsageError(f"a threshold must be a positive number of pixels, not {threshold:g}")
    if not thresholds:
        raise UsageError("at least one threshold is needed")
    return tuple(dict.fromkeys(float(t) for t in thresholds))


def _suitable_workers(frames: int) -> int:
    if frames < WORTH_WORKERS:
        return 1
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _itself(evaluated: Evaluated) -> FrameResult:
    return evaluated.result


def _chunks(pairs: list[_Pair]) -> Iterator[list[_Pair]]:
    for start in range(0, len(pairs), CHUNK):
        yield pairs[start : start + CHUNK]


@dataclass
class _Worker:
    job: _Job
    annotations: FileSource
    cameras: CameraCollection


_worker: list[_Worker] = []  # set once in each worker process, never in the main one


def _start_worker(job: _Job) -> None:
    cameras = CameraCollection.open(job.cameras, job.camera_format)
    _worker[:] = [_Worker(job, open_source(job.annotations), cameras)]


def _evaluate_chunk(chunk: list[_Pair]) -> tuple[list[Any], _Tally]:
    (worker,) = _worker
    tally = _Tally(SetAccumulator(worker.job.setup, worker.job.thresholds))
    digests = [
        worker.job.digest(_evaluate(pair, worker.job, worker.annotations, worker.cameras, tally))
        for pair in chunk
    ]
    return digests, tally


def _evaluate(
    pair: _Pair, job: _Job, annotations: FileSource, cameras: CameraCollection, tally: _Tally
) -> Evaluated:
    name, annotation_file, has_camera = pair
    try:
        data = annotations.read(annotation_file)
        shown = annotations.display(annotation_file)
        annotation = read_annotation(data, path=shown, field=job.setup.field)
    except InputError as error:
        return Evaluated(FrameResult(name, None, str(error), (), {}, counted=False))
    tally.counted += 1
    if not has_camera:
        tally.sums.add_missing_camera(name)
        return Evaluated(FrameResult(name, None, None, (), {}))
    try:
        camera, model, notices = _load_camera(name, job, cameras)
    except InputError as error:
        tally.sums.add_missing_camera(name)
        return Evaluated(FrameResult(name, None, str(error), (), {}))
    ground_only = projects_only_ground(camera)
    measurement = measure(annotation, camera, job.setup)
    scores = _scores(measurement, job.thresholds)
    tally.sums.add(name, measurement, scores)
    tally.with_camera += 1
    tally.ground_only |= ground_only
    shown = cameras.display(name)
    result = FrameResult(name, shown, None, notices, scores, ground_only=ground_only)
    return Evaluated(result, camera, model, measurement)


def _scores(measurement: Measurement, thresholds: tuple[float, ...]) -> dict[float, FrameScore]:
    return {threshold: score(measurement, threshold) for threshold in thresholds}


def _load_camera(
    name: str, job: _Job, cameras: CameraCollection
) -> tuple[CameraOrProjections, str, tuple[str, ...]]:
    loaded = cameras.read(name)
    camera, scaled = fit_to_size(loaded, job.setup.size, job.camera_size)
    notices = loaded.notices if scaled is None else (*loaded.notices, scaled)
    return camera, loaded.model, notices


def _choice(source: FileSource | CameraCollection) -> str:
    """What to choose from where several splits lie in one place."""
    folders = source.folders()
    if len(folders) < 2:
        return ""
    return f"; it holds {len(folders)} folders ({', '.join(folders[:5])}), choose one"
