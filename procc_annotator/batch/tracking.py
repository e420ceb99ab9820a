"""Find cuts and track the camera through pieces of shots, skipping unusable pictures; the work of
one unit, wherever it is done."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path
from typing import ClassVar, Protocol

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.batch.camera_proposals import set_pixel_aspect
from procc_annotator.batch.serialization import serialize
from procc_annotator.batch.unit_store import hex_digest
from procc_annotator.calibration.line_alignment.gaussian_state import PARAMETERS_FREE
from procc_annotator.calibration.single_image.pixel_aspect import SQUARE_PIXELS
from procc_annotator.calibration.single_image.proposal import KnownPosition
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.camera.base import Camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.computed_cameras import review_reason
from procc_annotator.dataset.remote_files import local_path
from procc_annotator.dataset.sequence import PictureSource, find_cuts, open_pictures
from procc_annotator.errors import ImageError
from procc_annotator.field.load import field_for_stadium, stadium_of
from procc_annotator.field.model import Field, PixelAspect
from procc_annotator.formats.cameras.packed import (
    PARAMETERS,
    PackedCameras,
    camera_row,
    lower_triangle,
)
from procc_annotator.image.decoding import decode_for_camera
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.video import open_shared_video

UNREADABLE = "unreadable"  # state of a frame whose picture cannot be used
TRACK = "track"  # kind of the units of which the store keeps evidence
_ANY_SHAPE = (90, 160, 4)  # nothing of it will be seen


class UsablePictures:
    """Those that cannot be used are black, and remembered; for one thread at a time.

    Attributes:
        damaged: number -> why its picture cannot be used, of those that were asked for.
    """

    def __init__(
        self, read: Callable[[int], PixelArray], numbers: range, name: Callable[[int], str]
    ) -> None:
        """Nothing is read yet.

        Args:
            read: number -> (H, W, 4) BGRA; may raise `ImageError`.
            numbers: all there are.
            name: what a picture is called where its size is reported.
        """
        self.damaged: dict[int, str] = {}
        self._read, self._numbers, self._name = read, numbers, name
        self._shape: tuple[int, ...] | None = None
        self._last: PixelArray | None = None  # of `or_last`

    def or_last(self, number: int) -> PixelArray:
        """(H, W, 4) BGRA; the usable one asked for before instead of a black one, for who looks
        for cuts: black is none."""
        picture = self(number)
        if number in self.damaged:
            return picture if self._last is None else self._last
        self._last = picture
        return picture

    def __call__(self, number: int) -> PixelArray:
        """(H, W, 4) BGRA."""
        try:
            picture = self._read(number)
        except ImageError as error:
            self.damaged[number] = str(error)
            return self._black()
        if self._shape is None:
            self._shape = picture.shape
        if picture.shape != self._shape:
            height, width = self._shape[:2]
            self.damaged[number] = (
                f"{self._name(number)}: is not {width}x{height} px as the first of its shot"
            )
            return self._black()
        return picture

    def _black(self) -> PixelArray:
        if self._shape is None:
            self._shape = self._first_readable()
        black = np.zeros(self._shape, dtype=np.uint8)
        black[..., 3] = 255
        return black

    def _first_readable(self) -> tuple[int, ...]:
        for number in self._numbers:
            try:
                return self._read(number).shape
            except ImageError:
                continue
        return _ANY_SHAPE


def lost_frame(one: TrackedFrame, why: str) -> TrackedFrame:
    """A frame whose picture could not be used: it has no camera, whatever the picture gave."""
    return replace(
        one, state="lost", reason=why, fit=None, coverage=0.0, residual_px=None,
        anchor_distance=None, probability=None,
    )  # fmt: skip


OnFrame = Callable[[TrackedFrame], None]


class ShotTracker(Protocol):
    """Follows a camera, as `track` does; survives the trip to a worker."""

    def __call__(
        self,
        frame: Callable[[int], PixelArray],
        numbers: range,
        field: Field,
        *,
        anchors: Mapping[int, Camera],
        known: Sequence[KnownPosition],
        on_frame: OnFrame,
    ) -> Track: ...


@dataclass(frozen=True, eq=False)
class TrackingUnit:
    """Work on consecutive frames of a match.

    Attributes:
        match: that it is of.
        pictures: folder or video. stamp: of its content.
        field_key: of `TrackTask.fields`.
        numbers: its frames.
    """

    kind: ClassVar[str] = ""
    match: str
    pictures: Path
    stamp: str
    field_key: str
    numbers: range

    @property
    def frames(self) -> int:
        """Return how many."""
        return len(self.numbers)

    @property
    def key(self) -> str:
        """See `Unit`."""
        piece = f"{self.numbers.start:08d}-{self.numbers.stop:08d}"
        return f"{self.match}/{self.kind}/{self.stamp}/{piece}"


class CutUnit(TrackingUnit):
    """Frames in which cuts are looked for."""

    kind = "cuts"


class PixelUnit(TrackingUnit):
    """All frames, whose pictures may be squeezed: how wide their pixels are."""

    kind = "pixels"


@dataclass(frozen=True, eq=False)
class TrackUnit(TrackingUnit):
    """A piece of a shot whose camera is followed.

    Attributes:
        anchors: cameras that are known, by number; px of the pictures.
        clicks: digests of the annotations that anchors were fitted to, by number.
        known: where cameras of other shots stand; none: anywhere.
        pixels: of the pictures; None as the field says.
    """

    kind = TRACK
    anchors: Mapping[int, Camera] = field(default_factory=dict)
    clicks: Mapping[int, str] = field(default_factory=dict)
    known: tuple[KnownPosition, ...] = ()
    pixels: PixelAspect | None = None

    @property
    def key(self) -> str:
        """See `Unit`."""
        given = serialize([dict(self.anchors), dict(self.clicks), list(self.known), self.pixels])
        return f"{super().key}/{hex_digest(given)[:16]}"


def ignore_progress(_: TrackedFrame) -> None:
    """No one asks."""


@dataclass(frozen=True, eq=False)
class TrackTask:
    """Does units.

    Attributes:
        fields: the elements, metres, by what units call them.
        follow: follows a camera.
        on_frame: called with frames as they are followed, in this process only.
    """

    fields: Mapping[str, Field]
    follow: ShotTracker
    on_frame: OnFrame = ignore_progress

    def __call__(self, unit: TrackingUnit) -> list[int] | PixelAspect | PackedCameras:
        """The numbers at which shots begin, the pixels of the pictures, or a tracked piece.

        Raises:
            InputError: a video that cannot be read.
        """
        pictures = _opened(local_path(unit.pictures))
        if isinstance(unit, CutUnit):
            return find_cuts(pictures, unit.numbers)
        if isinstance(unit, TrackUnit):
            return self._follow(unit, pictures)
        named = [(frame.name, frame.image_path) for frame in pictures.frames]
        return set_pixel_aspect(named, self.fields[unit.field_key]) or SQUARE_PIXELS

    def _follow(self, unit: TrackUnit, source: PictureSource) -> PackedCameras:
        frames, numbers = source.frames, unit.numbers
        pictures = UsablePictures(
            lambda n: decode_for_camera(frames[n].image_path),
            numbers,
            lambda n: str(frames[n].image_path),
        )
        given = self.fields[unit.field_key]
        shown = field_for_stadium(given, stadium_of(given, frames[numbers.start].name))
        shown = replace(shown, pixels=unit.pixels or shown.pixels)
        track = self.follow(
            pictures, numbers, shown, anchors=unit.anchors, known=unit.known, on_frame=self.on_frame
        )
        if source.is_video:
            open_shared_video(source.path).release()
        tracked = [
            lost_frame(one, pictures.damaged[one.number])
            if one.number in pictures.damaged
            else replace(one, clicks=unit.clicks.get(one.number, ""))
            for one in track.frames
        ]
        shots = [frames[first].name for first, last in track.shots for _ in range(first, last + 1)]
        names = tuple(frames[n].name for n in numbers)
        cameras = pack(tracked, names, tuple(shots), source.times_s(numbers))
        states = zip(cameras.state, numbers, strict=True)
        state = tuple(UNREADABLE if n in pictures.damaged else own for own, n in states)
        return replace(cameras, state=state)


@lru_cache(maxsize=2)
def _opened(path: Path) -> PictureSource:
    return open_pictures(path)


# Lower triangle of the covariance of the 8 free parameters of a tracked camera.
_COVARIANCE = PARAMETERS_FREE * (PARAMETERS_FREE + 1) // 2


def pack(
    tracked: Sequence[TrackedFrame], names: tuple[str, ...], shots: tuple[str, ...],
    times_s: FloatArray,
) -> PackedCameras:  # fmt: skip
    cameras = np.full((len(tracked), len(PARAMETERS)), np.nan)
    covariances = np.full((len(tracked), _COVARIANCE), np.nan)
    sizes, aspects = np.zeros((len(tracked), 2)), np.ones(len(tracked))
    for row, one in enumerate(tracked):
        if one.fit is None or not isinstance(one.fit.camera, PinholeCamera):
            continue
        cameras[row], sizes[row] = camera_row(one.fit.camera), one.fit.size
        aspects[row] = one.fit.pixel_aspect
        if one.fit.covariance is not None:
            covariances[row] = lower_triangle(one.fit.covariance, _COVARIANCE)

    def numbers(values: Iterable[float | None]) -> FloatArray:
        return np.array([np.nan if value is None else value for value in values])

    return PackedCameras(
        names,
        times_s,
        shots,
        tuple(one.state for one in tracked),
        tuple(str(review_reason(one)) for one in tracked),
        numbers(one.coverage for one in tracked),
        numbers(one.residual_px for one in tracked),
        numbers(one.probability for one in tracked),
        numbers(one.anchor_distance for one in tracked),
        sizes,
        cameras,
        covariances,
        aspects,
        tuple(one.clicks for one in tracked),
    )
