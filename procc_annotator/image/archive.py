"""Pictures in zip and tar archives, read where they are packed; each is read through a file of its
own, so that threads share no handle."""

from __future__ import annotations

import os
import struct
import tarfile
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path, PurePosixPath
from typing import BinaryIO

from procc_annotator.errors import ImageError
from procc_annotator.image.headers import PICTURE_SUFFIXES
from procc_annotator.image.pixels import MAX_PIXELS
from procc_annotator.regular_file import open_regular

ARCHIVE_SUFFIXES = frozenset({".zip", ".tar"})
_MOST_BYTES = 4 * MAX_PIXELS  # of a picture: as many as once it is decoded
_LOCAL_HEADER, _BLOCK = 30, 512  # bytes before the name in front of a member of a zip; of a tar
# What zipfile and tarfile raise for damage in one place or another.
_DAMAGE = (
    OSError, zipfile.BadZipFile, tarfile.TarError, zlib.error, struct.error, EOFError, LookupError,
    NotImplementedError, ValueError, OverflowError,
)  # fmt: skip
# Where a picture begins (in a zip with a header), its bytes as stored and as unpacked, their CRC-32
# (None in a tar), and why it cannot be read.
_Member = tuple[int, int, int, int | None, str]


def is_archive_file(path: Path) -> bool:
    """Return whether a path is a file with the suffix of an archive."""
    return path.suffix.lower() in ARCHIVE_SUFFIXES and path.is_file()


def archive_of_path(path: Path) -> tuple[Path, str] | None:
    """The archive and the member that a path like ``frames.zip/a/00001.jpg`` means, if it does."""
    archive = next(filter(is_archive_file, path.parents), None)
    return None if archive is None else (archive, path.relative_to(archive).as_posix())


def pictures_in_archive(path: Path) -> tuple[Mapping[str, _Member], str]:
    """The pictures of an archive by name, without hidden ones, and what is missing of it, if that
    is known. `ImageError` if it cannot be read."""
    try:
        found = os.stat(path)
        return _listed(os.path.abspath(path), found.st_mtime_ns, found.st_size)
    except _DAMAGE as error:
        why = f"is not a readable archive: {error}"
        raise ImageError(path, why, advice="make or download it again") from error


@lru_cache(maxsize=4)  # a file that was replaced is listed anew
def _listed(path: str, _changed_ns: int, _size: int) -> tuple[Mapping[str, _Member], str]:
    found: dict[str, _Member] = {}
    problem = ""
    with open_regular(path) as file:
        try:
            for stored, member in (_in_zip if path.lower().endswith("zip") else _in_tar)(file):
                parts = PurePosixPath(stored.lstrip("/")).parts
                hidden = any(part.startswith((".", "__MACOSX")) for part in parts)
                if os.path.splitext(stored)[1].lower() in PICTURE_SUFFIXES and not hidden:
                    found["/".join(parts)] = member
        except tarfile.ReadError as error:
            if not found:
                raise
            problem = f"is cut off or damaged ({error}): what follows is missing"
    return found, problem


def _in_zip(file: BinaryIO) -> Iterator[tuple[str, _Member]]:
    with zipfile.ZipFile(file) as archive:
        for one in archive.infolist():
            usual = one.compress_type in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
            why = "" if usual else "is packed by an unusual method: pack it as an ordinary zip"
            why = "is encrypted: pack it without a password" if one.flag_bits & 1 else why
            yield one.filename, (one.header_offset, one.compress_size, one.file_size, one.CRC, why)


def _in_tar(file: BinaryIO) -> Iterator[tuple[str, _Member]]:
    with tarfile.open(fileobj=file, mode="r:") as archive:
        while (one := archive.next()) is not None:
            archive.members.clear()  # type: ignore[attr-defined]  # a kilobyte each
            why = "" if one.isreg() and not one.issparse() else "is a link or sparse"
            yield one.name, (one.offset_data, one.size, one.size, None, why)
        file.seek(archive.offset)  # a damaged header ends the list without an error
        if file.read(_BLOCK).strip(b"\0"):
            raise tarfile.ReadError(f"no header at byte {archive.offset}")


def read_member(archive: Path, name: str) -> bytes:
    """The bytes of a picture; `ImageError` if there is no such one, or it is damaged, encrypted or
    too large."""
    path, nothing = archive / name, (0, 0, 0, None, "is no picture in the archive")
    offset, packed, size, checksum, why = pictures_in_archive(archive)[0].get(name, nothing)
    if why or max(size, packed) > _MOST_BYTES:
        raise ImageError(path, why or f"holds {size} bytes, expected at most {_MOST_BYTES}")
    try:
        with open_regular(archive) as file:
            file.seek(offset)
            if checksum is not None:
                file.seek(sum(struct.unpack("<HH", file.read(_LOCAL_HEADER)[-4:])), os.SEEK_CUR)
            data = file.read(packed)
        if packed != size:  # never more than announced, which may be a lie
            data = zlib.decompressobj(-zlib.MAX_WBITS).decompress(data, size + 1)
    except _DAMAGE as error:
        raise ImageError(path, f"cannot be read: {error}") from error
    if len(data) != size or checksum not in (None, zlib.crc32(data)):
        raise ImageError(path, "is damaged: another length or check sum than the archive says")
    return data
