"""What the program works out beside its window, kept from one test to the next.

Most tests open the same few frames; decoding, fitting and checking these again for each of them is
most of what goes on in the background. The first test that needs something has it worked out, and
every other is handed what came of it. Tests that put something of their own in the place of one
of these functions still do.
"""

import threading
import zlib
from collections import OrderedDict
from collections.abc import Callable, Hashable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.frame_analysis import FrameAnalysis
from procc_annotator.calibration.tracking.frame_reader import ReadFrame
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.camera.base import Camera
from procc_annotator.dataset.review import FrameCheck
from procc_annotator.field.model import Field
from procc_annotator.gui.commands import shot_following
from procc_annotator.gui.panels import frame_rows
from procc_annotator.gui.state.checking import label_check
from procc_annotator.gui.state.prediction import live_fit
from procc_annotator.image import decoding
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import is_english

T = TypeVar("T")


class _Memory:
    """The newest of what was worked out, safe to use from any thread."""

    def __init__(self, most: int) -> None:
        self._most, self._lock = most, threading.Lock()
        self._known: OrderedDict[Hashable, tuple[Any, tuple[object, ...]]] = OrderedDict()

    def of(self, key: Hashable, work: Callable[[], T], *alive: object) -> T:
        """What came of some inputs; ``alive``: those that the key knows by their ids."""
        with self._lock:
            if key in self._known:
                self._known.move_to_end(key)
                found: T = self._known[key][0]
                return found
        found = work()
        with self._lock:
            self._known[key] = found, alive
            while len(self._known) > self._most:
                self._known.popitem(last=False)
        return found


_PICTURES, _SHRUNK, _THUMBNAILS = _Memory(12), _Memory(12), _Memory(200)
_INSIGHTS, _CHECKS = _Memory(600), _Memory(600)


def _content(path: Path) -> Hashable:
    """By what a picture is told, whatever its file is called; None where it is in no file."""
    if not path.is_file():
        return None
    data = path.read_bytes()
    return len(data), zlib.crc32(data), path.suffix


def _may_be_kept(key: Hashable) -> bool:
    """What an annotation file holds beside its points may be anything, and what is found may be
    told in the language of the window."""
    try:
        hash(key)
    except TypeError:
        return False
    return is_english()


def hand_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have the window ask here first."""
    decode, decode_small = decoding.decode_bgra, frame_rows.decode_thumbnail
    shrink = frame_rows.downscale_to
    gain, check = live_fit.analyse_frame, label_check.check_without_fit

    def picture(path: Path) -> PixelArray:
        content = _content(path)
        return decode(path) if content is None else _PICTURES.of(content, lambda: decode(path))

    def thumbnail(path: Path, side: int) -> PixelArray:
        content = _content(path)
        if content is None:
            return decode_small(path, side)
        return _THUMBNAILS.of((content, side), lambda: decode_small(path, side))

    def shrunk(picture: PixelArray, side: int) -> PixelArray:
        return _SHRUNK.of((id(picture), side), lambda: shrink(picture, side), picture)

    def insight(
        annotation: FrameAnnotation,
        field: Field,
        *,
        start: Camera | None = None,
        go_on: Callable[[], None] = lambda: None,
        **terms: Any,
    ) -> FrameAnalysis:
        go_on()

        def work() -> FrameAnalysis:
            return gain(annotation, field, start=start, go_on=go_on, **terms)

        key = annotation, id(field), id(start), tuple(sorted(terms.items()))
        if not _may_be_kept(key):
            return work()
        return replace(_INSIGHTS.of(key, work, field, start), annotation=annotation)

    def by_eye(
        annotation: FrameAnnotation, field: Field, *, size: tuple[int, int], paint: Any = None
    ) -> FrameCheck:
        def work() -> FrameCheck:
            return check(annotation, field, size=size, paint=paint)

        # No paint found is another answer than none looked for.
        seen = None if paint is None else tuple((name, id(found)) for name, found in paint.items())
        key = annotation, id(field), size, seen
        if not _may_be_kept(key):
            return work()
        return _CHECKS.of(key, work, field, *(paint or {}).values())

    monkeypatch.setattr(decoding, "decode_bgra", picture)
    monkeypatch.setattr(frame_rows, "decode_thumbnail", thumbnail)
    monkeypatch.setattr(frame_rows, "downscale_to", shrunk)
    monkeypatch.setattr(live_fit, "analyse_frame", insight)
    monkeypatch.setattr(label_check, "check_without_fit", by_eye)


class TrackMemory:
    """Tracks of a drawn shot from the same anchors, told frame by frame as they once came."""

    def __init__(self) -> None:
        self._tracks = _Memory(20)

    def hand_out(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """Have the window ask here first."""
        real = shot_following.track_shot

        def track(
            frame: ReadFrame,
            numbers: range,
            field: Field,
            *,
            anchors: Mapping[int, Camera],
            on_frame: Callable[[TrackedFrame], None],
            go_on: Callable[[], None],
        ) -> Track:
            told: list[TrackedFrame] | None = None

            def work() -> tuple[Track, list[TrackedFrame]]:
                nonlocal told
                told = []

                def tell(found: TrackedFrame) -> None:
                    told.append(found)
                    on_frame(found)

                return real(
                    frame, numbers, field, anchors=anchors, on_frame=tell, go_on=go_on
                ), told

            first = zlib.crc32(np.ascontiguousarray(frame(numbers[0])))
            cameras = tuple((number, id(camera)) for number, camera in sorted(anchors.items()))
            key = first, numbers, id(field), cameras
            found, once_told = self._tracks.of(key, work, field, *anchors.values())
            if told is None:
                for one in once_told:
                    go_on()
                    on_frame(one)
            return found

        monkeypatch.setattr(shot_following, "track_shot", track)
