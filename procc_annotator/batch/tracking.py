"""Track the camera through shots, skipping unusable pictures."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Protocol

import numpy as np

from procc_annotator.batch.execution.executor import InProcess
from procc_annotator.batch.set_run import SetRun
from procc_annotator.calibration.single_image.proposal import KnownPosition
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.camera.base import Camera
from procc_annotator.dataset.frames import Frame
from procc_annotator.errors import ImageError
from procc_annotator.field.load import field_for_stadium, stadium_of
from procc_annotator.field.model import Field
from procc_annotator.image.decoding import decode_for_camera
from procc_annotator.image.pixels import PixelArray

_ANY_SHAPE = (90, 160, 4)  # nothing of it will be seen


class UsablePictures:
    """Those that cannot be used are black, and remembered; for one thread at a time.

    Attributes:
        damaged: number -> why its picture cannot be used, of those that were asked for.
    """

    def __init__(
        self,
        read: Callable[[int], PixelArray],
        numbers: range,
        name: Callable[[int], str],
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
        anchor_distance=None,
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
class ShotToTrack:
    """A shot on its way to a worker.

    Attributes:
        first: number of its first frame.
        frames: all of them.
        anchors: cameras that are known, by number; px of the pictures.
        clicks: digests of the annotations that anchors were fitted to, by number.
        known: where cameras of other shots stand; none: anywhere.
    """

    first: int
    frames: tuple[Frame, ...]
    anchors: Mapping[int, Camera]
    clicks: Mapping[int, str] = field(default_factory=dict)
    known: tuple[KnownPosition, ...] = ()

    @property
    def name(self) -> str:
        """Its first and last frame."""
        if len(self.frames) == 1:
            return self.frames[0].name
        return f"{self.frames[0].name} to {self.frames[-1].name}"

    @property
    def numbers(self) -> range:
        """Of its frames."""
        return range(self.first, self.first + len(self.frames))


@dataclass(frozen=True, eq=False)
class TrackedShot:
    """Result for a shot.

    Attributes:
        first: number of its first frame.
        frames: by name, in their order.
        tracked: what became of each.
        begins: numbers at which, on a closer look, another shot began.
        damaged: number -> why a picture cannot be used.
    """

    first: int
    frames: tuple[Frame, ...]
    tracked: tuple[TrackedFrame, ...]
    begins: tuple[int, ...] = ()
    damaged: Mapping[int, str] | None = None


def ignore_progress(_: TrackedFrame) -> None:
    """No one asks."""


@dataclass(frozen=True, eq=False)
class TrackShots:
    """Follows shots one by one.

    Attributes:
        field: the elements, metres.
        follow: follows one.
        on_frame: called with frames as they are followed, in this process only.
    """

    field: Field
    follow: ShotTracker
    on_frame: OnFrame = ignore_progress

    def __call__(self, chunk: Sequence[ShotToTrack]) -> tuple[list[TrackedShot], None]:
        return [self._follow(shot) for shot in chunk], None

    def _follow(self, shot: ShotToTrack) -> TrackedShot:
        pictures = _pictures_of(shot)
        anchors = {n: camera for n, camera in shot.anchors.items() if n in shot.numbers}
        shown = field_for_stadium(self.field, stadium_of(self.field, shot.frames[0].name))
        found = self.follow(
            pictures,
            shot.numbers,
            shown,
            anchors=anchors,
            known=shot.known,
            on_frame=self.on_frame,
        )
        tracked = tuple(
            lost_frame(one, pictures.damaged[one.number])
            if one.number in pictures.damaged
            else replace(one, clicks=shot.clicks.get(one.number, ""))
            for one in found.frames
        )
        begins = tuple(first for first, _ in found.shots if first != shot.first)
        return TrackedShot(shot.first, shot.frames, tracked, begins, pictures.damaged)


def damaged_pictures(shot: ShotToTrack, lost: Collection[str]) -> list[str]:
    """Why pictures of a shot that was followed before cannot be used, one line each.

    Args:
        shot: all of it.
        lost: names of its frames that have no camera.
    """
    if not lost:
        return []
    pictures = _pictures_of(shot)
    pictures(shot.first)  # says of which size the others are
    for number, frame in zip(shot.numbers, shot.frames, strict=True):
        if frame.name in lost:
            pictures(number)
    return list(pictures.damaged.values())


def _pictures_of(shot: ShotToTrack) -> UsablePictures:
    paths = {n: frame.image_path for n, frame in zip(shot.numbers, shot.frames, strict=True)}
    return UsablePictures(
        lambda n: decode_for_camera(paths[n]), shot.numbers, lambda n: str(paths[n])
    )


class TrackRun(SetRun[ShotToTrack, TrackedShot, None]):
    """One pass over shots; iterate it once."""

    chunk = 1
    task: TrackShots

    def __init__(self, shots: Sequence[ShotToTrack], field: Field, follow: ShotTracker) -> None:
        super().__init__(shots, TrackShots(field, follow))

    @property
    def frame_count(self) -> int:
        """Frames of all shots."""
        return sum(len(shot.frames) for shot in self.frames)

    def tell(self, on_frame: OnFrame) -> bool:
        """Report frames as they are followed; whether they are, which other processes cannot."""
        here = isinstance(self.executor, InProcess)
        if here:
            self.task = replace(self.task, on_frame=on_frame)
        return here
