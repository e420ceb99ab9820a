"""Packet index and frame decoding of a video stream (PyAV).

A frame is identified by its presentation time. The times of all packets are read without decoding
(about 20 ms per thousand); sorted, they number the frames. What comes out of the decoder is never
counted: it drops what it cannot decode and conceals errors. A frame that does not come out, or
that is flagged as corrupt, is damaged, and so is each frame decoded after it up to the next key
frame, because it may be predicted from it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, dropwhile, islice, pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.errors import ImageError
from procc_annotator.image.headers import VIDEO_SUFFIXES
from procc_annotator.image.pixels import PixelArray, bgra_from_bgr, require_decodable_size
from procc_annotator.regular_file import read_head

if TYPE_CHECKING:  # imported with the first video: most datasets have none
    from av import Packet as AnyPacket
    from av import VideoFrame
    from av.container import InputContainer
    from av.video.stream import VideoStream

    Packet = AnyPacket[VideoStream]

_Indices = NDArray[np.int64]
_Flags = NDArray[np.bool_]

# Decoding forward costs 2 ms per frame (1920 x 1080), a seek as much as its group of frames.
_NEARBY_PACKETS = 48
# Read backwards, frames are decoded from the key frame before them: as many are kept, as they come
# out of the decoder (4:2:0).
_BACKWARD_BYTES, _BYTES_PER_PIXEL = 128 << 20, 1.5
_COMPARED_PACKETS = (
    12  # frames that must come out in the order of their times before these are trusted
)
_STATE_DURATION = "matroska", "asf", "flv"
_NO_INDEX = "mpeg", "mxf", "asf", "flv"
_PACKET_OVERHEAD_BYTES = 64  # between packets: at most 25 were found in mkv and avi
_ROUNDING_S = 0.1  # what durations of containers may be off by
_MOST_TIMELESS = 0.1  # of the packets
_HOLE_STEPS = 2.5  # of times: recorders leave out a frame where they are late
_SAME_STEP_TOLERANCE = 0.2  # of the usual one: times are rounded, to 1 ms in mkv
_MAX_REORDER = 16  # packets: no codec reorders more
_MAX_DECODE_ATTEMPTS = 1000  # packets among which a first frame must be
# AV_PICTURE_TYPE_NONE, _I, _SI: other key frames need what is before them
_INTRA_PROFILES = 0, 1, 5
# Decoders that do not mark what is corrupt: they have to fail
_CODECS_WITHOUT_KEY_FLAGS = "hevc", "mjpeg"
_STEPS_BACK_S = (0.0, 1.0, 4.0, 16.0)  # where a seek lands too late
_CONVERSION_ADVICE = "convert it, for example with ffmpeg -i old.mp4 -c:v libx264 new.mp4"
_ROTATE_CODES = {
    90: cv2.ROTATE_90_COUNTERCLOCKWISE,
    -90: cv2.ROTATE_90_CLOCKWISE,
    180: cv2.ROTATE_180,
    -180: cv2.ROTATE_180,
}


def require_video_file(path: Path) -> None:
    """Refuse what is no video before FFmpeg reads it: it also opens playlists and text.

    Raises:
        ImageError: missing, not a file, empty, or none of `VIDEO_SUFFIXES` inside.
    """
    try:
        head = read_head(path, 197)
    except OSError as error:
        raise ImageError(path, f"cannot be read: {error.strerror or error}") from error
    if not head:
        raise ImageError(path, "the file is empty, expected a video")
    boxes = (b"ftyp", b"moov", b"mdat", b"wide", b"free", b"skip", b"pnot")
    known = head[4:8] in boxes or head[:4] == b"\x1a\x45\xdf\xa3"
    known |= head[:4] == b"RIFF" and head[8:12] == b"AVI "
    # Each packet of a transport stream begins so; those of m2ts after a time of 4 bytes.
    known |= head[:1] == head[188:189] == b"G" or head[4:5] == head[196:197] == b"G"
    # MXF, MPEG program stream, Flash, Windows Media
    known |= head.startswith((b"\x06\x0e\x2b\x34", b"\0\0\x01\xba", b"FLV\1", b"0&\xb2u\x8ef\xcf"))
    if not known:
        kinds = ", ".join(sorted(suffix[1:] for suffix in VIDEO_SUFFIXES))
        raise ImageError(path, f"expected a video, this is none of {kinds} inside")


def open_container(path: Path) -> tuple[InputContainer, VideoStream]:
    """A container and its first video stream, before its first packet. `ImageError` if FFmpeg finds
    no video in it, or frames over `MAX_PIXELS`."""
    import av

    try:
        container = av.open(str(path.absolute()))
    except av.FFmpegError as error:
        raise _open_error(path) from error
    if not container.streams.video:
        container.close()
        raise _open_error(path)
    stream = container.streams.video[0]
    require_decodable_size(path, stream.codec_context.width, stream.codec_context.height)
    stream.thread_type = "AUTO"
    if stream.codec_context.name in _CODECS_WITHOUT_KEY_FLAGS:
        stream.codec_context.options = {"err_detect": "explode"}
    return container, stream


def _open_error(path: Path) -> ImageError:
    return ImageError(path, "cannot be opened as a video: damaged, cut off, or without pictures")


def _packets(container: InputContainer, *stream: VideoStream) -> Iterator[AnyPacket[Any]]:
    """Packets, of one stream or all, as far as the file can be read."""
    import av

    packets = container.demux(*stream)
    while True:
        try:
            packet = next(packets, None)
        except av.FFmpegError:
            return
        if packet is None:
            return
        if packet.size:  # not what ends a stream
            yield packet


def decode_packet(stream: VideoStream, packet: Packet | None) -> list[VideoFrame] | None:
    """The frames that come out after a packet, or at the end; None for a decoding error, which may
    be of an earlier packet."""
    import av

    try:
        return stream.codec_context.decode(packet)
    except av.FFmpegError:
        return None


def bgra_from_frame(frame: VideoFrame) -> PixelArray:
    """(H, W, 4) opaque, read-only BGRA, rotated as the metadata says."""
    from av.video.reformatter import Interpolation

    # Bicubic, as OpenCV interpolates colours: cameras and points refer to these pixels.
    pixels = frame.to_ndarray(format="bgr24", interpolation=Interpolation.BICUBIC)
    turn = _ROTATE_CODES.get(round(frame.rotation))
    return bgra_from_bgr(
        np.asarray(pixels if turn is None else cv2.rotate(pixels, turn), dtype=np.uint8)
    )


@dataclass(frozen=True, eq=False)
class StreamProbe:
    """Properties of the first frames of a video.

    Attributes:
        size: (width, height) px as shown.
        rate: frames per second; 0 if unknown.
        pixel_aspect: width of a pixel by its height, as the metadata say; 1 if they say nothing.
        times: presentation times as they come out of the decoder; none if one is damaged.
    """

    size: tuple[int, int]
    rate: float
    pixel_aspect: float
    times: list[int | None]


def probe_stream(path: Path) -> StreamProbe:
    """Decode the first frames.

    Raises:
        ImageError: no frame can be decoded.
    """
    container, stream = open_container(path)
    size, times, intact = None, list[int | None](), True
    with container:
        rate, aspect = float(stream.average_rate or 0), float(stream.sample_aspect_ratio or 1)
        for packet in chain(islice(_packets(container, stream), _MAX_DECODE_ATTEMPTS), (None,)):
            frames = decode_packet(stream, packet)
            intact &= frames is not None
            for frame in frames or ():
                if size is None:
                    height, width = bgra_from_frame(frame).shape[:2]
                    size = width, height
                intact &= not frame.is_corrupt
                times.append(frame.pts)
            if size is not None and (len(times) >= _COMPARED_PACKETS or not intact):
                break
    if size is None:
        raise ImageError(path, "none of its frames can be decoded", advice=_CONVERSION_ADVICE)
    return StreamProbe(size, rate, aspect, times if intact else [])


@dataclass(eq=False)
class PacketIndex:
    """The packets of a video in the order in which they are decoded.

    Attributes:
        times: (packets,) presentation times in the stream's unit.
        times_s: (frames,) seconds from the first frame, ascending; None if times do not number the
            frames: then only counting from the first one does.
        numbers: (packets,) of the frame in a packet, -1 if it is not shown.
        places: (frames,) the packet of each frame, -1 if it could not be read.
        keys: (packets,) whether decoding may begin there; decoding removes those that turn out to
            need what is before them.
        lost: (packets + 1,) whether the frame does not come out intact; decoding adds to it. The
            last one stands for all that could not be read.
        cut_off: what is missing at the end of the file; empty if nothing is known to be.
    """

    times: list[int | None]
    times_s: FloatArray | None
    numbers: _Indices
    places: _Indices
    keys: _Flags
    lost: _Flags
    cut_off: str

    @cached_property
    def packet_at_time(self) -> dict[int | None, int]:
        """Presentation time -> packet."""
        return {time: place for place, time in enumerate(self.times)}

    @cached_property
    def reach(self) -> _Indices:
        """(packets,) highest number up to each: once that one came out, the others did or never
        will."""
        return np.maximum.accumulate(self.numbers)

    def decode_start(self, number: int) -> int:
        """The packet from which a frame is decoded: the last key frame before it, both in decoding
        and in presentation order."""
        before = np.flatnonzero(self.keys[: self.places[number] + 1])
        while before[-1] and self.numbers[before[-1]] > number:
            before = before[:-1]
        return int(before[-1])

    def is_damaged(self, number: int) -> bool:
        """Return whether a packet that a frame may depend on is lost; known once it was decoded."""
        place = int(self.places[number])
        if self.lost[place]:
            return True
        begin = self.decode_start(number)
        needed = slice(begin, place + 1)
        # Frames shown before the key frame are no reference for those after it.
        after = self.numbers[needed] >= self.numbers[begin]
        return bool((self.lost[needed] & after).any())


class _Packets(NamedTuple):
    """What a container says of its packets, in their order.

    Attributes:
        times: in units of the stream; None where none is stated.
        keys, lost, unread: whether one can be decoded alone, is corrupt, or comes after a gap.
        shown: places of those that are frames.
        last_s: when the last one of any stream ends.
    """

    times: list[int | None]
    keys: list[bool]
    lost: list[bool]
    unread: list[bool]
    shown: list[int]
    last_s: float


def read_packet_index(path: Path, first: list[int | None]) -> PacketIndex:
    """Read all packets of a video, without decoding them. `ImageError` if it cannot be opened, or
    has no packets."""
    container, stream = open_container(path)
    with container:
        kind, unit = container.format.name, float(stream.time_base or 1)
        times, keys, lost, unread, shown, last_s = _read_packets(container, stream)
        # As the edit list leaves them; the stream's own number counts what it hides, too.
        declared = len(stream.index_entries) if "mp4" in kind else 0
        duration_s = (container.duration or 0) / 1e6
        # In an avi, times count the packets that could be read: after a gap they are wrong.
        certain = kind != "avi" or len(times) >= len(stream.index_entries)
    if not shown:
        raise _open_error(path)
    timeless = [place for place in shown if times[place] is None]
    if kind.startswith(_NO_INDEX) and len(timeless) < _MOST_TIMELESS * len(shown):  # damaged
        shown = [place for place in shown if times[place] is not None]
        for place in timeless:
            lost[place] = unread[place] = True
    own = np.array([times[place] for place in shown], dtype=np.float64)
    order = np.argsort(own)
    ordered, places = own[order], np.array(shown)[order]
    cut_off, of_all = "", f" of {declared}" if declared else ""
    ends_early = len(times) < declared or lost[-1]
    ends_early |= kind == "asf" and not duration_s  # none where the file is shorter than it says
    if kind.startswith(_STATE_DURATION):  # readers also give up where a part is damaged
        missing_s = duration_s - last_s
        ends_early |= _is_truncated_matroska(path) or _is_gap(missing_s, ordered * unit)
    if ends_early:
        cut_off = f"the file is cut off or damaged: it ends after {len(times)}{of_all} frames"
    lost.append(True)
    unread.append(ends_early)
    count = _count_if_untimed(ordered, first)
    if count is not None:
        numbers = np.arange(len(times))
        start = numbers == 0
        return PacketIndex(times, None, numbers, numbers[:count], start, np.array(lost), cut_off)
    all_lost, all_unread = np.array(lost), np.array(unread)
    if kind.startswith(_NO_INDEX):  # a hole in regular times is the only sign of what is missing
        steps = np.diff(ordered, prepend=ordered[0]) / max(float(np.median(np.diff(ordered))), 1)
        if (np.abs(steps - np.rint(steps)) < _SAME_STEP_TOLERANCE).all():
            all_unread[places[steps > _HOLE_STEPS]] = True
    known = _frame_numbers(ordered, places, all_unread, all_lost, certain=certain)
    every = np.arange(known[-1] + 1)
    times_s = np.interp(every, known, (ordered - ordered[0]) * unit)
    numbers, every_place = np.full(len(times), -1), np.full(len(every), -1)
    numbers[places], every_place[known] = known, places
    return PacketIndex(times, times_s, numbers, every_place, np.array(keys), all_lost, cut_off)


def _read_packets(container: InputContainer, stream: VideoStream) -> _Packets:
    """Read what a container says of the packets of a stream."""
    found, end, skipped, last_s = _Packets([], [], [], [], [], 0.0), 0, False, 0.0
    contiguous = container.format.name.startswith(("matroska", "avi"))
    for packet in _packets(container):
        begin = packet.pos or 0
        skipped |= contiguous and 0 < end < begin - _PACKET_OVERHEAD_BYTES
        end = max(end, begin + packet.size)
        last_s = max(last_s, _end_s(packet))
        if packet.stream_index != stream.index:
            continue
        # An edit list hides packets; VP8 has pictures that are only referred to.
        hidden = stream.codec_context.name == "vp8" and not bytes(packet)[0] & 0x10
        if not hidden and not packet.is_discard:
            found.shown.append(len(found.times))
        found.keys.append(packet.is_keyframe or not found.times)
        found.times.append(packet.pts)
        found.lost.append(packet.is_corrupt)
        found.unread.append(skipped or packet.is_corrupt)
        skipped = False
    return found._replace(last_s=last_s)


def _end_s(packet: AnyPacket[Any]) -> float:
    """Return when a packet's presentation ends, s; 0 without a time."""
    if packet.pts is None or packet.time_base is None:
        return 0.0
    return float((packet.pts + (packet.duration or 0)) * packet.time_base)


def _is_gap(duration_s: float, times_s: FloatArray) -> bool:
    """Return whether a time is clearly longer than a frame of a video with these times."""
    step_s = float(np.median(np.diff(times_s))) if len(times_s) > 1 else 0.0
    return duration_s > max(_HOLE_STEPS * step_s, _ROUNDING_S)


def _frame_numbers(
    times: FloatArray, places: _Indices, unread: _Flags, lost: _Flags, *, certain: bool
) -> _Indices:
    """(n,) numbers of frames by their ascending times (n,), those left open that are missing where
    packets could not be read; adds to ``lost`` (packets + 1,) what may depend on these, or may be
    another frame. Places (n,) are the packets of the frames; unread (packets + 1,) says whether
    packets before each could not be read; certain, that times can be relied on after such a gap.
    """
    missing, regular = _missing_frames_before(times, places, unread)
    if missing.any() or not certain:
        gaps = np.flatnonzero(unread[:-1])
        lost[gaps - 1] = True  # what follows may be predicted from what is in the gap
        if not (regular and certain):  # any frame may follow
            begin = gaps[0] if len(gaps) else max(0, len(unread) - 1 - _MAX_REORDER)
            lost[begin:], missing[:] = True, 0
    return np.arange(len(places)) + np.cumsum(missing)


def _missing_frames_before(
    times: FloatArray, places: _Indices, unread: _Flags
) -> tuple[_Indices, np.bool_]:
    """Return how many frames are missing before each: there are packets nearby that could not be
    read, and room for frames by the usual step of the times; and whether all steps are multiples of
    that."""
    near = np.convolve(unread, np.ones(2 * _MAX_REORDER + 1))[_MAX_REORDER:-_MAX_REORDER] > 0
    steps = np.diff(times, prepend=times[0])
    steps = steps / max(float(np.median(steps)), 1)
    whole = np.rint(steps)
    missing = np.where(near[places], (whole - 1).clip(0), 0).astype(np.int64)
    return missing, (np.abs(steps - whole) < _SAME_STEP_TOLERANCE).all()


def _count_if_untimed(times: FloatArray, first: list[int | None]) -> int | None:
    """Return how many frames there seem to be, if times do not number them: unknown (nan), shared
    by several, in another order than the first frames, or of fields, two for each frame."""
    ascending = all(a is not None and b is not None and a < b for a, b in pairwise(first))
    if not (len(times) == 1 or (np.diff(times) > 0).all()) or not ascending:
        return len(times)
    if first and np.searchsorted(times, float(first[-1] or 0), side="right") > 1.5 * len(first):
        return len(times) // 2
    return None


def _is_truncated_matroska(path: Path) -> bool:
    """Return whether a Matroska file ends before its segment does."""
    head, end = read_head(path, 1 << 12), 0
    for name in (b"\x1a\x45\xdf\xa3", b"\x18\x53\x80\x67"):  # EBML header, segment
        begin = end + len(name)
        if head[end:begin] != name or begin + 8 > len(head):
            return False
        width = 9 - head[begin].bit_length()  # of the length, which begins with so many bits
        most = (1 << 7 * width) - 1
        length = int.from_bytes(head[begin : begin + width], "big") & most
        end = begin + width + length
    return length != most and end > path.stat().st_size  # all ones: unknown, as of a live recording


class FrameReader:
    """Decodes frames by number; for one thread at a time."""

    def __init__(self, path: Path, index: PacketIndex) -> None:
        """Open the file. `ImageError` as of `open_container`."""
        self._path, self._index = path, index
        self._frames: dict[int, VideoFrame | None] = {}  # those that came out; None: not needed
        self._wanted = self._judged = self._next = self._oldest = 0
        self._packets: Iterator[Packet] = iter(())
        self._open()

    def close(self) -> None:
        """Close the file."""
        self._container.close()

    def frame(self, number: int) -> PixelArray | None:
        """(H, W, 4) BGRA; None if it is damaged. `ImageError` if the file cannot be opened any
        more."""
        index, is_backwards, self._wanted = self._index, number < self._wanted, number
        if index.is_damaged(number):
            return None
        if self._frames.get(number) is None:
            self._oldest = number - self._kept_back if is_backwards else number
            if not 0 <= number - self._next < _NEARBY_PACKETS:
                self._begin(number)
        while self._next <= index.reach[index.places[number]] and self._advance():
            pass
        missing = [n for n in range(self._judged, self._next) if n not in self._frames]
        index.lost[index.places[missing]] = True
        self._judged = self._next
        self._frames = {n: frame for n, frame in self._frames.items() if n >= self._oldest}
        frame = self._frames.get(number)
        return None if frame is None or index.is_damaged(number) else bgra_from_frame(frame)

    def _begin(self, number: int) -> None:
        """Go to the key frame before a frame, and decode it."""
        index = self._index
        while True:
            key = index.decode_start(number)
            self._seek(key)
            first = max(0, int(index.numbers[key]))
            self._frames, self._judged, self._next = {}, first, first
            if not key:
                return
            while self._next == first and self._advance():
                pass
            # One that does not come out needs what is before it, or is damaged: so is what follows.
            index.keys[key] &= first in self._frames
            if index.keys[key]:
                return

    def _seek(self, key: int) -> None:
        """Go to a packet: by the container's index, or from the start where that leads past it."""
        packet_at_time, target = self._index.packet_at_time, self._index.times[key] or 0
        for back_s in () if self._index.times_s is None else _STEPS_BACK_S:
            landed = self._land(target - round(back_s / self._unit))
            if landed is not None and packet_at_time.get(landed.pts, key + 1) <= key:
                self._packets = chain((landed,), self._packets)
                break
        else:
            self._container.close()
            self._open()
        if key:
            self._packets = dropwhile(
                lambda packet: packet_at_time.get(packet.pts) != key, self._packets
            )

    def _land(self, time: int) -> Packet | None:
        """The first packet after a seek."""
        import av

        try:
            self._container.seek(time, stream=self._stream)
        except av.FFmpegError:
            return None
        self._packets = _packets(self._container, self._stream)
        return next(self._packets, None)

    def _open(self) -> None:
        self._container, self._stream = open_container(self._path)
        self._unit = float(self._stream.time_base or 1)
        pixels = self._stream.codec_context.width * self._stream.codec_context.height
        self._kept_back = int(_BACKWARD_BYTES / _BYTES_PER_PIXEL / max(pixels, 1))
        self._packets = _packets(self._container, self._stream)

    def _advance(self) -> bool:
        """Decode one more packet; False at the end."""
        index = self._index
        packet = next(self._packets, None)
        frames = decode_packet(self._stream, packet)
        for frame in frames or ():
            self._take(frame)
        if packet is not None:
            if frames is None and index.times_s is None:
                index.lost[self._next :] = True  # whatever comes now may be any frame
            return True
        if index.times_s is None:
            index.places = index.places[: self._next]  # now it is known how many there are
        self._next = len(index.places)
        return False

    def _take(self, frame: VideoFrame) -> None:
        """Note a frame that came out."""
        index = self._index
        place = self._next if index.times_s is None else index.packet_at_time.get(frame.pts, -1)
        if not 0 <= place < len(index.numbers) or index.numbers[place] < self._next:
            return  # not shown, or shown before the frame at which decoding began
        number = int(index.numbers[place])
        self._next = number + 1
        if index.keys[place] and place and frame.pict_type not in _INTRA_PROFILES:
            index.keys[place] = False
        if not frame.is_corrupt:
            self._frames[number] = frame if number >= self._oldest else None
