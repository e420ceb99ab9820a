"""Propose a camera per picture: known positions, detector plug-ins, second pass."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as dataclass_field
from functools import cache
from itertools import chain
from pathlib import Path
from typing import Protocol

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.serialization import serialize
from procc_annotator.batch.set_run import CheckpointedRun
from procc_annotator.batch.unit_store import hex_digest, stamp_of_file
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.probability import SURE_FROM
from procc_annotator.calibration.single_image.proposal import (
    SURE,
    KnownPosition,
    Proposal,
    cluster_camera_positions,
    cluster_fit_positions,
)
from procc_annotator.calibration.single_image.propose import (
    ASPECT_PICTURES,
    estimate_pixel_aspect,
    propose_camera,
)
from procc_annotator.camera.models import FisheyeCamera, PinholeCamera
from procc_annotator.dataset.dataset_field import video_pixel_aspect
from procc_annotator.dataset.frames import Frame
from procc_annotator.errors import CameraError, InputError, ProccError, UsageError
from procc_annotator.field.load import field_for_frame, stadium_of
from procc_annotator.field.model import Field, PixelAspect
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.plugins import discover
from procc_annotator.formats.cameras.writers import OFFICIAL_SIZE
from procc_annotator.formats.csv_tables import read_table
from procc_annotator.image.decoding import decode_for_camera
from procc_annotator.image.pixels import PixelArray

_PLACE, _DEVIATIONS = ("x_m", "y_m", "z_m"), ("sd_x_m", "sd_y_m", "sd_z_m")
_ADVICE = "expected positions.csv of calibrate --shared-position, or cameras"
_LEAST_SD_M = 0.05  # a table that says less than it can know


def read_positions(path: Path, field: Field, fmt: str = "auto") -> tuple[KnownPosition, ...]:
    """The positions that a file holds.

    Args:
        path: folder, archive or file of cameras; or a ``.csv`` with columns ``x_m``, ``y_m``,
            ``z_m`` and their standard deviations, as ``calibrate --shared-position`` writes it.
        field: the elements.
        fmt: of the cameras, one of `CAMERA_FORMATS`.

    Raises:
        InputError: no position can be read from it.
        UsageError: nothing at the path.
    """
    if path.suffix.lower() == ".csv":
        return _from_table(path)
    with CameraCollection.open(path, fmt, field=field) as collection:
        found = []
        for frame in collection.frames:
            try:
                loaded = collection.read(frame)
            except CameraError:  # a set is known by its others
                continue
            if isinstance(loaded.camera, PinholeCamera | FisheyeCamera):
                found.append((_as_pinhole(loaded.camera), loaded.size or OFFICIAL_SIZE))
    if not found:
        raise InputError(path, "holds no camera with a position (a homography has none)")
    return cluster_camera_positions(found, field)


def _as_pinhole(camera: PinholeCamera | FisheyeCamera) -> PinholeCamera:
    """Return the pinhole camera of a fisheye's pose, with its lens to the third order of the angle:
    r = theta + k1 theta^3 is x + (k1 - 1/3) x^3 for x = tan(theta)."""
    if isinstance(camera, PinholeCamera):
        return camera
    pose = camera.pan_rad, camera.tilt_rad, camera.roll_rad, camera.position_world
    radial = (camera.coefficients[0] - 1 / 3, 0.0, 0.0, 0.0, 0.0, 0.0)
    return PinholeCamera(*pose, camera.focal_px, camera.principal_point_px, radial)


def _from_table(path: Path) -> tuple[KnownPosition, ...]:
    _, rows = read_table(path, (*_PLACE, *_DEVIATIONS), _ADVICE)
    found = []
    for line, row in rows:
        try:
            place = np.array([float(row[name]) for name in _PLACE])
            sd = np.array([float(row[name]) for name in _DEVIATIONS])
        except ValueError as error:
            why = "expected numbers for position and standard deviations"
            raise InputError(path, why, place=f"line {line}") from error
        if not (np.isfinite(place).all() and np.isfinite(sd).all()):
            raise InputError(path, "expected finite numbers", place=f"line {line}")
        found.append(KnownPosition(place, np.diag(np.maximum(sd, _LEAST_SD_M) ** 2)))
    if not found:
        raise InputError(path, "holds no position")
    return tuple(found)


GROUP = "procc_annotator.proposers"
# How surely a detector knows where a camera stands, and how many places are tried.
_SD_M, _MOST_POSITIONS = 2.0, 5

# What a detector says of a picture: cameras in its px, or points by class, normalised.
Hint = PinholeCamera | FrameAnnotation


@dataclass(frozen=True)
class PictureProposer:
    """A detector.

    Attributes:
        name: typed after ``--with``.
        title: for people.
        propose: picture, (H, W, 4) BGRA uint8, and field -> cameras in px of the picture, or
            annotations of normalised points, the likeliest first; nothing where it sees nothing.
    """

    name: str
    title: str
    propose: Callable[[PixelArray, Field], Iterable[Hint]]


@cache
def proposers() -> tuple[dict[str, PictureProposer], tuple[str, ...]]:
    """The detectors that are installed, by name, and what is wrong with others, one line each."""
    found, problems = discover(PictureProposer, GROUP, "proposer plug-in")
    by_name: dict[str, PictureProposer] = {}
    for point, given in found:
        if given.name in by_name:
            problems.append(f"the proposer plug-in {point!r} gives {given.name!r}, which there is")
        else:
            by_name[given.name] = given
    return by_name, tuple(problems)


@dataclass(frozen=True)
class WithPlugin:
    """`propose_camera`, also with the cameras of a detector and where it says that they stand:
    what it says is made right on the paint, and judged by the same probability.

    It survives the trip to a worker, where the detector is loaded anew.

    Attributes:
        name: of the detector.
        sure_from: see `propose_camera`.
    """

    name: str
    sure_from: float = SURE_FROM

    def __call__(
        self, picture: PixelArray, field: Field, *, known: Sequence[KnownPosition]
    ) -> Proposal:
        hinted = _hypotheses(self.hints(picture, field))
        return propose_camera(
            picture,
            field,
            known=(*known, *hinted),
            sure_from=self.sure_from,
        )

    def hints(self, picture: PixelArray, field: Field) -> list[PinholeCamera]:
        """The cameras that the detector's answers come to.

        Raises:
            ProccError: it went wrong, or gives something else.
        """
        try:
            hints = list(chosen_proposer(self.name).propose(picture, field))
        except ProccError:
            raise
        # Whatever another person's code raises is reported as its fault.
        except Exception as error:
            said = " ".join(str(error).split())[:300] or "no reason given"
            raise self._error(f"{type(error).__name__}: {said}") from error
        size = (picture.shape[1], picture.shape[0])
        found = [self._camera(hint, field, size) for hint in hints]
        return [camera for camera in found if camera is not None]

    def _camera(self, hint: object, field: Field, size: tuple[int, int]) -> PinholeCamera | None:
        if isinstance(hint, FrameAnnotation):
            camera = fit_camera(hint, field, model="P", size=size).camera
            return camera if isinstance(camera, PinholeCamera) else None
        if not isinstance(hint, PinholeCamera):
            raise self._error(f"gives {type(hint).__name__}, not PinholeCamera or FrameAnnotation")
        if not all(map(math.isfinite, hint.position_world)):
            raise self._error("gives a camera whose position is not finite")
        return hint

    def _error(self, why: str) -> ProccError:
        return ProccError(f"the proposer {self.name!r} cannot be used: {why}")


def _hypotheses(cameras: Sequence[PinholeCamera]) -> list[KnownPosition]:
    """The cameras, of those at one position the first."""
    found: list[KnownPosition] = []
    for camera in cameras:
        place = np.array(camera.position_world)
        if all(np.linalg.norm(place - other.position_m) > _SD_M for other in found):
            found.append(KnownPosition(place, np.eye(3) * _SD_M**2, camera=camera))
    return found[:_MOST_POSITIONS]


def chosen_proposer(name: str) -> PictureProposer:
    """An installed detector.

    Raises:
        UsageError: there is none of this name.
    """
    by_name, problems = proposers()
    if name not in by_name:
        there = ", ".join(by_name) or "none is installed"
        raise UsageError("; ".join((f"--detector {name}: no such proposer ({there})", *problems)))
    return by_name[name]


class Proposer(Protocol):
    """Proposes a camera for a picture, as `propose_camera` does; survives the trip to a worker."""

    def __call__(
        self, picture: PixelArray, field: Field, *, known: Sequence[KnownPosition]
    ) -> Proposal: ...


@dataclass(frozen=True, slots=True)
class Proposed:
    """Proposal for one frame.

    Attributes:
        name: of the frame.
        proposal: the camera, or why there is none; None if the picture cannot be used.
        seconds: that it took.
        error: why the picture cannot be used.
        from_agreement: whether it was looked for where sure frames agree that cameras stand.
    """

    name: str
    proposal: Proposal | None = None
    seconds: float = 0.0
    error: str = ""
    from_agreement: bool = False

    @property
    def is_sure(self) -> bool:
        """Return whether there is a camera that may be relied on."""
        return self.proposal is not None and self.proposal.state == SURE


@dataclass(frozen=True)
class ProposeCameras:
    """Proposes cameras for chunks of frames.

    Attributes:
        field: the elements, metres.
        known: where their cameras may be known to stand.
        propose: finds the camera of a picture.
        of_match: the same of the frames of a match, by `match_of`.
    """

    field: Field
    known: tuple[KnownPosition, ...]
    propose: Proposer
    of_match: Mapping[str, tuple[KnownPosition, ...]] = dataclass_field(default_factory=dict)

    def __call__(self, chunk: Sequence[Frame]) -> tuple[list[Proposed], None]:
        return [self._propose(frame) for frame in chunk], None

    def _propose(self, frame: Frame) -> Proposed:
        began = time.perf_counter()
        try:
            picture = decode_for_camera(frame.image_path)
        except InputError as error:
            return Proposed(frame.name, error=str(error))
        field = field_for_frame(self.field, frame.name)
        known = (*self.known, *self.of_match.get(match_of(self.field, frame.name), ()))
        proposal = self.propose(picture, field, known=known)
        return Proposed(frame.name, proposal, time.perf_counter() - began)


def set_pixel_aspect(
    frames: Sequence[tuple[str, Path]], field: Field, go_on: Callable[[], None] = lambda: None
) -> PixelAspect | None:
    """Find out how wide the pixels of a set are, from some of its pictures.

    ``go_on`` is called between steps; what it raises ends the search. None where pictures have a
    shape that cameras make.
    """

    def pictures() -> Iterator[tuple[PixelArray, Field]]:
        for name, path in frames[:: max(len(frames) // ASPECT_PICTURES, 1)][:ASPECT_PICTURES]:
            try:
                yield decode_for_camera(path), field_for_frame(field, name)
            except InputError:  # the run lists it
                continue

    stated = video_pixel_aspect(frames[0][1]) if frames else None
    return stated or estimate_pixel_aspect(pictures(), go_on)


class ProposalRun(CheckpointedRun[Frame, Proposed, None]):
    """One pass over pictures; iterate it once, then ask whether `again` is worth it."""

    chunk = 1  # a second's work, and what is found is written as it comes
    task: ProposeCameras

    def __init__(
        self,
        frames: Sequence[Frame],
        field: Field,
        propose: Proposer,
        known: tuple[KnownPosition, ...] = (),
        of_match: Mapping[str, tuple[KnownPosition, ...]] | None = None,
    ) -> None:
        super().__init__(frames, ProposeCameras(field, known, propose, of_match or {}))

    def _digest(self, chunk: Sequence[Frame]) -> str:
        parts: list[object] = [serialize([self.task.known, dict(self.task.of_match)])]
        for frame in chunk:
            # A frame of a video lies in the video's file.
            file = frame.image_folder if frame.image_folder.is_file() else frame.image_path
            parts += [frame.name, stamp_of_file(file)]
        return hex_digest(*parts)

    def _sums_of(self, results: Sequence[Proposed]) -> None:
        return None


@dataclass(frozen=True)
class SecondPass:
    """Frames that are examined once more where the sure ones say that cameras stand.

    Attributes:
        positions: on which frames agree.
        run: over the frames without a sure camera; it takes their results one by one.
        before: what was proposed for those.
    """

    positions: tuple[KnownPosition, ...]
    run: ProposalRun
    before: dict[str, Proposed]

    def better(self, found: Proposed) -> Proposed:
        """A frame's second proposal if it is sure, else its first one."""
        first = self.before[found.name]
        seconds = first.seconds + found.seconds
        if found.is_sure:
            return replace(found, seconds=seconds, from_agreement=True)
        return replace(first, seconds=seconds)


def second_pass(run: ProposalRun, found: Sequence[Proposed]) -> SecondPass | None:
    """Return what a second look at a set, of a run that is done and its results, is to be, if its
    sure frames agree on a position and others may gain by it; the same executor does it."""
    before = {one.name: one for one in found if one.proposal is not None and not one.is_sure}
    field = run.task.field
    fits: dict[str, tuple[list[FitResult], list[FitResult]]] = {}  # sure ones and others by match
    for one in found:
        if one.proposal is not None:
            own = fits.setdefault(match_of(field, one.name), ([], []))
            own[0 if one.is_sure else 1].append(one.proposal.fit)
    positions = {
        match: places
        for match, (sure, others) in fits.items()
        if others and (places := cluster_fit_positions(sure, field, others))
    }
    frames = [f for f in run.frames if f.name in before and match_of(field, f.name) in positions]
    if not frames:
        return None
    again = ProposalRun(frames, field, run.task.propose, run.task.known, positions)
    again.executor, again.kept = run.executor, run.kept
    return SecondPass(tuple(chain(*positions.values())), again, before)


def match_of(field: Field, frame: str) -> str:
    """Whose tripods a frame shares: its stadium's where that is known, else its folder's."""
    return stadium_of(field, frame) or frame.rpartition("/")[0]
