"""The shots of a video or of a folder of consecutive pictures: between its cuts."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise

from procc_annotator.errors import ImageError
from procc_annotator.image.decode import decode_bgra, decode_thumbnail
from procc_annotator.image.motion import estimate_motion
from procc_annotator.image.scenes import FrameSignature, cut_indices, frame_signature, frame_differences
from procc_annotator.image.video import open_shared_video, scene_cuts
from procc_annotator.session.dataset.frames import Frame
from procc_annotator.session.dataset.picture_source import PictureSource

_LOOKED_AT_PX = 320


def find_shots(source: PictureSource, progress: Callable[[int, int], None]) -> list[range]:
    """Where one camera hands over to another: the numbers of the frames of each shot.

    What changes the picture at once without another camera (a banner, a flash) is no cut: the
    stadium moves on steadily behind it.

    Args:
        source: its frames, numbered from 0.
        progress: called now and then with frames done and their count.

    Raises:
        ImageError: a video that cannot be read.
    """
    count = len(source.frames)
    if source.is_video:
        video = open_shared_video(source.frames[0].image_folder)
        begins = scene_cuts(video, progress=progress, cancelled=lambda: False)
    else:
        begins = _cuts_in_folder(source.frames, progress)
    told = set(begins)
    inner = [
        n
        for n in range(1, count)
        if _other_folder(source.frames, n) or (n in told and _is_cut(source.frames, n))
    ]
    return [range(first, past) for first, past in pairwise([0, *inner, count])]


def _other_folder(frames: Sequence[Frame], number: int) -> bool:
    return frames[number].image_folder != frames[number - 1].image_folder


def _cuts_in_folder(frames: Sequence[Frame], progress: Callable[[int, int], None]) -> list[int]:
    numbers: list[int] = []

    def looks() -> Iterator[FrameSignature]:
        for number, frame in enumerate(frames):
            progress(number, len(frames))
            try:
                small = decode_thumbnail(frame.image_path, _LOOKED_AT_PX)
            except ImageError:  # told when its shot is followed
                continue
            numbers.append(number)
            yield frame_signature(small[..., :3])

    steps, lasting = frame_differences(looks())
    progress(len(frames), len(frames))
    return [numbers[i] for i in cut_indices(steps, lasting)] if numbers else []


def _is_cut(frames: Sequence[Frame], number: int) -> bool:
    """Whether nothing of the stadium moves on from one picture to the next."""
    try:
        before, now = (decode_bgra(frames[n].image_path) for n in (number - 1, number))
    except ImageError:
        return True
    return estimate_motion(before, now) is None
