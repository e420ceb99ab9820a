"""Temporal stability of methods over shots: jitter, jumps, outages, frame offsets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.batch.execution.executor import Executor
from procc_annotator.batch.grouping import NotInOrderError, ShotFrames, require_in_order
from procc_annotator.batch.set_run import (
    AnnotationTask,
    ReopenableHandle,
    SetRun,
    annotations_for,
    reopenable_cameras,
    reopenable_source,
)
from procc_annotator.camera.base import Camera, CameraOrProjections
from procc_annotator.dataset.camera_set import FrameCameras
from procc_annotator.errors import CameraError, ImageError, InputError
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts
from procc_annotator.formats.cameras.loaded_camera import fit_to_size
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.motion import CameraMotion, estimate_motion, transfer_points
from procc_annotator.metrics.measurement import Measurement, measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.metrics.temporal.discontinuities import (
    Discontinuities,
    FrameOffset,
    find_discontinuities,
    frame_offset,
    shift_range,
)
from procc_annotator.metrics.temporal.jitter import (
    PoseJitter,
    ShotJitter,
    ShotPoses,
    field_ground_points,
    pose_jitter,
    projection_jitter,
    shot_poses,
    shot_rms,
    without_bare_projections,
)

TOO_FAR = 0.25  # of the picture's width: a step by which nothing follows
_FEWEST_STEPS = 5


def moves_on(steps_px: FloatArray, size: tuple[int, int]) -> bool:
    """Return whether frames show what those before them showed; where few are known, no one says
    no."""
    known = steps_px[np.isfinite(steps_px)]
    return len(known) < _FEWEST_STEPS or bool(np.median(known) < TOO_FAR * size[0])


def _camera(cameras: FrameCameras, name: str, size: tuple[int, int]) -> Camera | None:
    try:
        found = cameras.camera(name, size)
    except CameraError:  # the list of sources says so
        return None
    return None if found is None else without_bare_projections([found.camera])[0]


# Of a point that is farther off, or not shown at all, so much counts towards a frame offset: at the
# width of 960 px. One wild frame must not decide.
_FARTHEST_OFF_PX = 20.0
_MOST_PAIRS = 120  # of pictures of a shot whose motion is looked at
_FEWEST_CARRIED = 6
_AS_IS = np.zeros(1, dtype=np.intp)  # no shift


@dataclass(frozen=True, eq=False)
class ShotOverTime:
    """One source over one shot of n frames.

    Attributes:
        shot: its frames.
        size: px of all figures.
        steady: second differences of the projection.
        poses: of each frame.
        broken: jumps and outages.
        jac: (n,) at the threshold, NaN for frames without an annotation or a camera.
        offset: of cameras against annotations; None where too few frames can say.
        picture_offset: of cameras against the motion of the pictures.
        fitted: of n cameras, whether they were fitted to the annotation they are judged by.
        ground_only: whether a camera that is judged knows only the ground.
        errors: cameras, annotations and pictures that cannot be read, one line each.
    """

    shot: ShotFrames
    size: tuple[int, int]
    steady: ShotJitter
    poses: ShotPoses
    broken: Discontinuities
    jac: FloatArray
    offset: FrameOffset | None
    picture_offset: FrameOffset | None
    fitted: Sequence[FitCounts]
    ground_only: bool = False
    errors: tuple[str, ...] = ()

    @property
    def fits(self) -> FitCounts:
        """Of all its cameras."""
        return sum(self.fitted, NOT_FITTED)

    @property
    def jitter_px(self) -> float | None:
        """Of the projection, px; frames of a jump left out."""
        return shot_rms(self.steady.px, self.broken.unsteady)

    @property
    def jitter_m(self) -> float | None:
        """The same on the ground, metres."""
        return shot_rms(self.steady.ground_m, self.broken.unsteady)

    @cached_property
    def pose_jitter(self) -> PoseJitter:
        """Of pan, tilt, roll, zoom and position."""
        return pose_jitter(self.poses, self.shot.numbers, self.broken.unsteady)

    @property
    def outage_share(self) -> float:
        """Frames without a camera, of all."""
        lost = sum(outage.length for outage in self.broken.outages)
        return lost / len(self.shot.frames)

    @property
    def mean_jac(self) -> float | None:
        """Over the frames that have one."""
        known = self.jac[np.isfinite(self.jac)]
        return float(known.mean()) if len(known) else None

    @property
    def follows(self) -> bool:
        """Return whether the frames of the shot show what those before them showed."""
        return moves_on(self.steady.step_px, self.size)


_Found = tuple[CameraOrProjections | None, str | None]  # a camera, and what it was fitted to


class _JudgedShot(NamedTuple):
    """See `ShotOverTime`."""

    jac: FloatArray
    offset: FrameOffset | None
    fitted: Sequence[FitCounts]
    ground_only: bool


@dataclass(frozen=True)
class MeasureShots(AnnotationTask):
    """Measures chunks of shots.

    Attributes:
        cameras: of one source.
        setup: field, size and protocol.
        threshold: px, of JaC.
        camera_size: picture size the cameras refer to, where their files do not say.
        files: frame -> its annotation file.
        pictures: frame -> its picture; none: pictures are not examined.
    """

    cameras: ReopenableHandle[CameraCollection]
    setup: EvaluationSetup
    threshold: float
    camera_size: tuple[int, int] | None
    files: Mapping[str, str]
    pictures: Mapping[str, Path]

    def __call__(self, chunk: Sequence[ShotFrames]) -> tuple[list[ShotOverTime], None]:
        points = field_ground_points(self.setup.field)
        return [self._measured(shot, points) for shot in chunk], None

    def close(self) -> None:
        """Close what a worker opened."""
        super().close()
        self.cameras.close()

    def _measured(self, shot: ShotFrames, points: FloatArray) -> ShotOverTime:
        errors: list[str] = []
        found = [self._camera(name, errors) for name in shot.frames]
        given = [camera for camera, _ in found]
        cameras, size = without_bare_projections(given), self.setup.size
        steady = projection_jitter(cameras, shot.numbers, points, size)
        # Those known by their projections alone are no outage.
        pairs = zip(cameras, given, strict=True)
        there = [a if a is not None or b is None else _Unknown() for a, b in pairs]
        broken = find_discontinuities(there, shot.numbers, points, size, steady)
        # Where the field is somewhere else in every frame, no other frame's camera can be meant.
        follows = moves_on(steady.step_px, size)
        judged = self._against_clicks(shot, found, errors, shift_range() if follows else _AS_IS)
        moved = self._against_pictures(shot, given, points, errors) if self.pictures else None
        return ShotOverTime(
            shot, size, steady, shot_poses(given, size), broken, judged.jac, judged.offset, moved,
            judged.fitted, judged.ground_only, tuple(errors),
        )  # fmt: skip

    def _camera(self, name: str, errors: list[str]) -> _Found:
        cameras = self.cameras.opened
        if name not in cameras.frames:
            return None, None
        try:
            loaded = cameras.read(name, self.setup.field)
            setup = self.setup
            camera = fit_to_size(loaded, setup.size, self.camera_size, setup.unsized)[0]
            return camera, loaded.fitted_on
        except InputError as error:
            errors.append(str(error))
            return None, None

    # --- against annotations ---

    def _against_clicks(
        self,
        shot: ShotFrames,
        found: Sequence[_Found],
        errors: list[str],
        tried: IntArray,
    ) -> _JudgedShot:
        jac, fitted, ground_only = np.full(len(found), np.nan), [NOT_FITTED] * len(found), False
        at = {number: place for place, number in enumerate(shot.numbers)}
        rows = []
        for place, name in enumerate(shot.frames):
            annotation = self._annotation(name, errors)
            if annotation is None:
                continue
            setup = self.setup.of_frame(name)
            row = np.full(len(tried), np.nan)
            for column, shift in enumerate(tried.tolist()):
                there = at.get(shot.numbers[place] + shift)
                camera = None if there is None else found[there][0]
                if camera is None:
                    continue
                measurement = measure(annotation, camera, setup)
                row[column] = _distance_px(measurement)
                if shift == 0:
                    jac[place] = score(measurement, self.threshold).jac
                    fitted[place] = FitCounts.of(found[place][1], annotation, measurement)
                    ground_only |= measurement.projected.ground_only
            if annotation.annotated:  # a frame without clicks tells nothing of shifts
                rows.append(row)
        told = len(rows) > 0 and len(tried) > 1
        offset = frame_offset(np.array(rows)) if told else None
        return _JudgedShot(jac, offset, fitted, ground_only)

    def _annotation(self, name: str, errors: list[str]) -> FrameAnnotation | None:
        file = self.files.get(name)
        if file is None:
            return None
        try:
            return self.read(file, self.setup.field)
        except InputError as error:
            errors.append(str(error))
            return None

    # --- against the motion of the pictures ---

    def _against_pictures(
        self,
        shot: ShotFrames,
        given: Sequence[CameraOrProjections | None],
        points: FloatArray,
        errors: list[str],
    ) -> FrameOffset | None:
        cameras = without_bare_projections(given)
        shown = [None if c is None else _shown(c.project(points)) for c in cameras]
        at = {number: place for place, number in enumerate(shot.numbers)}
        pairs = [n for n, place in at.items() if n + 1 in at and self._seen(shot, place)]
        every = max(1, -(-len(pairs) // _MOST_PAIRS))
        rows = []
        for number in pairs[::every]:
            motion = self._motion(shot.frames[at[number]], shot.frames[at[number + 1]], errors)
            if motion is None:
                continue
            row = np.full(len(shift_range()), np.nan)
            for column, shift in enumerate(shift_range().tolist()):
                one, other = at.get(number + shift), at.get(number + shift + 1)
                if one is None or other is None:
                    continue
                row[column] = _motion_difference_px(
                    motion, shown[one], shown[other], self.setup.size
                )
            rows.append(row)
        return frame_offset(np.array(rows)) if rows else None

    def _seen(self, shot: ShotFrames, place: int) -> bool:
        return all(name in self.pictures for name in shot.frames[place : place + 2])

    def _motion(self, before: str, now: str, errors: list[str]) -> CameraMotion | None:
        try:
            pictures = [decode_bgra(self.pictures[name]) for name in (before, now)]
        except ImageError as error:
            errors.append(str(error))
            return None
        found = estimate_motion(*pictures)
        if found is None:
            return None
        height, width = pictures[0].shape[:2]
        to = [(a - 1) / (b - 1) for a, b in zip(self.setup.size, (width, height), strict=True)]
        scale = np.diag([*to, 1.0])
        whole = scale @ found.current_from_previous @ np.linalg.inv(scale)
        return CameraMotion(whole, found.inliers, found.matches)


class OverTimeRun(SetRun[ShotFrames, ShotOverTime, None]):
    """One pass of one source over shots; iterate it once."""

    chunk = 1

    def __init__(
        self,
        shots: Sequence[ShotFrames],
        annotations: FileSource,
        cameras: CameraCollection,
        setup: EvaluationSetup,
        threshold: float,
        *,
        camera_size: tuple[int, int] | None = None,
        pictures: Mapping[str, Path] | None = None,
        executor: Executor | None = None,
    ) -> None:
        """Prepare the pass.

        Args:
            shots: see `frame_order`; frames without a camera in them are outages.
            pictures: frame -> its picture, where cameras are to be held against what moves in them.

        Raises:
            UsageError: no annotation.
            NotInOrderError: see `require_in_order`.
        """
        require_in_order(shots)
        task = MeasureShots(
            reopenable_source(annotations),
            reopenable_cameras(cameras),
            setup,
            threshold,
            camera_size,
            dict(annotations_for(cameras.frames, annotations)),
            FrameTable(pictures or {}),
        )
        super().__init__(shots, task, executor)


def require_shots(found: Sequence[ShotOverTime], told_by: str) -> None:
    """Refuse figures over time of frames that have nothing to do with each other.

    Raises:
        NotInOrderError: in most shots the field is somewhere else in every frame.
    """
    lost = [one for one in found if not one.follows]
    if 2 * len(lost) > len(found):
        raise NotInOrderError(
            f"the frames do not follow each other ({told_by}): from one to the next the field moves"
            " by more than a quarter of the picture; say which do in a frames.csv:"
            " frame,shot,number"
        )


class _Unknown:
    """Stands for a camera that is there, and of which nothing is known but projections."""

    def project(self, points_world: FloatArray) -> tuple[FloatArray, np.ndarray]:
        count = len(points_world)
        return np.full((count, 2), np.nan), np.zeros(count, dtype=bool)


def _distance_px(measurement: Measurement) -> float:
    """Mean distance of the clicks, as far as it counts; what is not shown is as far as can be."""
    farthest = _FARTHEST_OFF_PX * measurement.setup.size[0] / 960
    labels = measurement.plain
    count = sum(labels.point_counts)
    if not count:
        return float("nan")
    near = np.nan_to_num(labels.all_distances, nan=farthest).clip(max=farthest)
    return float((near.sum() + farthest * (count - len(near))) / count)


def _shown(projected: tuple[FloatArray, np.ndarray]) -> FloatArray:
    px, valid = projected
    return np.where(valid[:, None], px, np.nan)


def _motion_difference_px(
    motion: CameraMotion, before: FloatArray | None, now: FloatArray | None, size: tuple[int, int]
) -> float:
    """Return how far the pictures' motion and the cameras' are apart over what is in sight, px."""
    if before is None or now is None:
        return float("nan")
    inside = ((before >= 0) & (before <= np.array(size) - 1)).all(axis=1)
    off = np.hypot(*(transfer_points(motion, before[inside]) - now[inside]).T)
    farthest = _FARTHEST_OFF_PX * size[0] / 960
    off = off[np.isfinite(off)].clip(max=farthest)
    return float(off.mean()) if len(off) >= _FEWEST_CARRIED else float("nan")
