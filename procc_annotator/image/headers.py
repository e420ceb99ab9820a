"""Suffixes of image and video files, and image sizes read from headers without decoding."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO, Literal

from procc_annotator.errors import ImageError
from procc_annotator.regular_file import read_head

PICTURE_SUFFIXES = frozenset({
    ".jpg", ".jpeg", ".png", ".bmp", ".webp", ".tif", ".tiff", ".jp2", ".avif", ".gif", ".ppm",
    ".pgm",
})  # fmt: skip
VIDEO_SUFFIXES = frozenset({
    ".mp4", ".mov", ".mkv", ".avi", ".m4v", ".ts", ".mts", ".m2ts", ".mxf", ".webm", ".mpg",
    ".mpeg", ".flv", ".wmv", ".3gp", ".vob",
})  # fmt: skip


_MAX_ASPECT_RATIO = 20  # times the shorter side: more than any panorama
_TIFF_SIGNATURES = (b"II*\0", b"MM\0*")
_NETPBM = re.compile(rb"P[2356]\s" + 2 * rb"(?:\s|#[^\n]*\n)*(\d+)")
_MOST_PAGES = 1000
_PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
# Enough for every header but those with a large thumbnail in front.
_HEADER_BYTES = 1 << 16
# Markers without a length, and those that start a frame (C4, C8 and CC are tables).
_JPEG_MARKERS_WITHOUT_LENGTH = frozenset({0x01, *range(0xD0, 0xD8)})
_JPEG_FRAME_MARKERS = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}


def is_valid_size(width: int, height: int) -> bool:
    """Return whether a size in px can be that of a picture of a field."""
    return min(width, height) >= 2 and max(width, height) <= _MAX_ASPECT_RATIO * min(width, height)


def require_valid_size(path: Path, width: int, height: int) -> None:
    """Refuse what is no picture of a field, before a camera is looked for in it. `ImageError` if a
    side is too short next to the other one, or for any camera."""
    if not is_valid_size(width, height):
        raise ImageError(
            path, f"is {width} x {height} px, expected a picture of a field",
            advice="replace or remove it",
        )  # fmt: skip


def header_size(data: bytes | memoryview) -> tuple[int, int] | None:
    """(width, height) px as stored, before any turn; None unless of `PICTURE_SUFFIXES`."""
    if bytes(data[:8]) == _PNG_SIGNATURE and len(data) >= 24:
        return _big_endian(data[16:20]), _big_endian(data[20:24])
    if bytes(data[:2]) == b"\xff\xd8":
        return _jpeg_size(data)
    if bytes(data[:2]) == b"BM" and len(data) >= 26:
        return _bmp_size(data)
    if bytes(data[:4]) == b"RIFF" and bytes(data[8:12]) == b"WEBP" and len(data) >= 30:
        return _webp_size(data)
    if bytes(data[:4]) in _TIFF_SIGNATURES:
        tags, _ = _tiff_tags(data)
        return (tags[256], tags[257]) if {256, 257} <= tags.keys() else None
    if bytes(data[:4]) == b"GIF8" and len(data) >= 10:
        return _little_endian(data[6:8]), _little_endian(data[8:10])
    if (netpbm := _NETPBM.match(data[:_HEADER_BYTES])) is not None:
        return int(netpbm[1]), int(netpbm[2])
    if bytes(data[4:8]) in (b"ftyp", b"jP  "):
        return _box_size(bytes(data[:_HEADER_BYTES]))
    return None


def count_gif_frames(data: bytes | memoryview) -> int:
    """Return how many pictures a GIF shows one after another; 0 for any other file."""
    if bytes(data[:4]) != b"GIF8" or len(data) < 13:
        return 0
    at, count = 13 + _color_table(data[10]), 0
    while at < len(data) - 10 and data[at] in b"\x21\x2c":  # an extension, an image
        is_image = data[at] == 0x2C
        count += is_image
        at += 11 + _color_table(data[at + 9]) if is_image else 2
        while at < len(data) and data[at]:  # blocks with their lengths
            at += 1 + data[at]
        at += 1
    return count


def _color_table(flags: int) -> int:
    return 6 << (flags & 7) if flags & 0x80 else 0


def count_tiff_pages(data: bytes | memoryview) -> int:
    """Return how many pictures a TIFF holds, without smaller ones and masks; 0 for other files."""
    if bytes(data[:4]) not in _TIFF_SIGNATURES:
        return 0
    places, count = [0], 0
    while len(places) < _MOST_PAGES:
        tags, following = _tiff_tags(data, places[-1])
        count += not tags.get(254, 0) & 5
        if not following or following in places:
            break
        places.append(following)
    return count


def displayed_size(file: BinaryIO) -> tuple[int, int] | None:
    """(width, height) px of a picture as it is shown; None where only decoding says, as where EXIF
    data may turn it.

    Of a png or webp the heads of all chunks are read, as EXIF may follow the pixels.

    Raises:
        OSError: it cannot be read.
    """
    file.seek(0)
    start = file.read(_HEADER_BYTES)
    if start[:8] == _PNG_SIGNATURE:
        turned = _may_have_exif(file, 8, _png_chunk)
    elif start[:4] == b"RIFF":
        turned = _may_have_exif(file, 12, _webp_chunk)
    elif start[:4] in _TIFF_SIGNATURES or start[4:8] == b"ftyp":
        turned = True  # both have a tag for it
    else:
        turned = b"Exif" in start
    return None if turned else header_size(start)


def is_turned_jpeg(path: Path) -> bool:
    """Return whether EXIF data turn a JPEG, which is decoded as they say; False if unreadable."""
    try:
        start = read_head(path, _HEADER_BYTES)
    except OSError:  # told where it is decoded
        return False
    at = start.find(b"Exif\0\0", 0, 1 << 12) if start[:2] == b"\xff\xd8" else -1
    return at > 0 and _tiff_tags(start[at + 6 :])[0].get(274, 1) > 1


def _may_have_exif(file: BinaryIO, place: int, chunk: Callable[[bytes], tuple[bytes, int]]) -> bool:
    """Return whether a chunk from a place of the file on is EXIF, or lies beyond its end."""
    end = file.seek(0, os.SEEK_END)
    while place + 8 <= end:
        file.seek(place)
        kind, length = chunk(file.read(8))
        if kind == b"IEND":  # some programs append their own data
            return False
        if kind.upper() == b"EXIF":
            return True
        place += length
    return place != end


def _png_chunk(head: bytes) -> tuple[bytes, int]:
    """Its kind, and its length with head and checksum."""
    return head[4:], 12 + _big_endian(head[:4])


def _webp_chunk(head: bytes) -> tuple[bytes, int]:
    """Its kind, and its length with head and the byte that makes it even."""
    length = _little_endian(head[4:])
    return head[:4], 8 + length + length % 2


def is_truncated_png(data: bytes | memoryview) -> bool:
    """Return whether a png announces more than the file holds.

    Decoders make room for what is announced: 41 bytes can ask for 2 GB and seconds of time.
    """
    if bytes(data[:8]) != _PNG_SIGNATURE:
        return False
    place = 8
    while place + 8 <= len(data):
        if bytes(data[place + 4 : place + 8]) == b"IEND":  # some programs append their own data
            return False
        place += 12 + _big_endian(data[place : place + 4])  # length, kind, content, checksum
    return place > len(data)


def _big_endian(part: bytes | memoryview) -> int:
    return int.from_bytes(part, "big")


def _little_endian(part: bytes | memoryview) -> int:
    return int.from_bytes(part, "little")


def _jpeg_size(data: bytes | memoryview) -> tuple[int, int] | None:
    place = 2
    while place + 9 < len(data):
        if data[place] != 0xFF:
            return None
        marker = data[place + 1]
        if marker == 0xFF:  # filling
            place += 1
        elif marker in _JPEG_MARKERS_WITHOUT_LENGTH:
            place += 2
        elif marker in _JPEG_FRAME_MARKERS:
            return _big_endian(data[place + 7 : place + 9]), _big_endian(
                data[place + 5 : place + 7]
            )
        else:
            place += 2 + max(2, _big_endian(data[place + 2 : place + 4]))
    return None


def _bmp_size(data: bytes | memoryview) -> tuple[int, int]:
    if _little_endian(data[14:18]) == 12:  # the oldest kind has 16 bit sizes
        return _little_endian(data[18:20]), _little_endian(data[20:22])
    width = int.from_bytes(data[18:22], "little", signed=True)
    height = int.from_bytes(data[22:26], "little", signed=True)  # negative: top row first
    return abs(width), abs(height)


def _webp_size(data: bytes | memoryview) -> tuple[int, int] | None:
    kind = bytes(data[12:16])
    if kind == b"VP8X":
        return _little_endian(data[24:27]) + 1, _little_endian(data[27:30]) + 1
    if kind == b"VP8L":
        bits = _little_endian(data[21:25])
        return (bits & 0x3FFF) + 1, (bits >> 14 & 0x3FFF) + 1
    if kind == b"VP8 ":
        return _little_endian(data[26:28]) & 0x3FFF, _little_endian(data[28:30]) & 0x3FFF
    return None


def _tiff_tags(data: bytes | memoryview, place: int = 0) -> tuple[dict[int, int], int]:
    """A picture's directory, which may stand at the end, and the place of the next one; 0: none."""
    order: Literal["little", "big"] = "little" if bytes(data[:2]) == b"II" else "big"

    def number(place: int, count: int) -> int:
        return int.from_bytes(data[place : place + count], order)

    place = place or number(4, 4)
    found = dict[int, int]()
    for entry in range(place + 2, min(place + 2 + 12 * number(place, 2), len(data) - 11), 12):
        tag, kind = number(entry, 2), number(entry + 2, 2)
        found[tag] = number(entry + 8, 2 if kind == 3 else 4)
    end = place + 2 + 12 * number(place, 2)
    return found, number(end, 4) if end + 4 <= len(data) else 0


def _box_size(data: bytes) -> tuple[int, int] | None:
    """Of AVIF, the largest ``ispe`` (others are of thumbnails); of JPEG 2000, ``ihdr``."""
    sizes = [
        (_big_endian(data[at + 8 : at + 12]), _big_endian(data[at + 12 : at + 16]))
        for at in (match.start() for match in re.finditer(b"ispe.{12}", data, re.DOTALL))
    ]
    if 0 < (at := data.find(b"ihdr")) <= len(data) - 12:
        sizes = [(_big_endian(data[at + 8 : at + 12]), _big_endian(data[at + 4 : at + 8]))]
    return max(sizes, key=lambda size: size[0] * size[1], default=None)
