"""A submission of projected polylines: an archive of ``FRAME.json`` with a ``manifest.json``.

Each file holds where a method shows the elements in a frame, as shares of the picture; so a
benchmark judges methods of any camera model and asks none for its model. The manifest says what
they were made for. Nothing in such an archive is ever executed or unpacked.
"""

from __future__ import annotations

import hashlib
import unicodedata
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import msgspec
from natsort import natsorted

from procc_annotator.camera.base import FloatArray
from procc_annotator.errors import CameraError, InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.io.camera_files.cameras import read_camera_file
from procc_annotator.io.camera_files.fitted_on import SIDECAR_SUFFIX
from procc_annotator.io.camera_files.submission import IGNORED, LOWERS, REFUSED, SubmissionRemark
from procc_annotator.io.collections import MANIFEST_FILE, CameraFiles, list_cameras
from procc_annotator.io.json_text import decode_as, printable
from procc_annotator.io.source import ZipSource
from procc_annotator.words import count_words, first_names

FORMAT = "procc-annotator polylines 1"
POLYLINES = "polylines"  # the format of the files
_DIGITS = 9  # of shares: a millionth of a pixel
_LONGEST_NAME = 60


@dataclass(frozen=True)
class Manifest:
    """What a submission was made for.

    Attributes:
        method: what it is called in tables.
        version: of the program that wrote it; empty where another one did.
        protocol: ``soccernet`` or ``procc``.
        field: its name; field_sha256: see `field.fingerprint`.
        size: (width, height) px at which it is to be evaluated.
        frames_sha256: of the names of the annotated frames, see `names_sha256`; so many frames.
    """

    format: str
    method: str
    protocol: str
    field: str
    field_sha256: str
    size: tuple[int, int]
    frames: int
    frames_sha256: str
    version: str = ""


def names_sha256(names: Iterable[str]) -> str:
    """SHA-256 of the names of frames, letters composed, sorted, one a line."""
    composed = sorted(unicodedata.normalize("NFC", name) for name in names)
    return hashlib.sha256("\n".join(composed).encode("utf-8", "surrogatepass")).hexdigest()


def encode_manifest(manifest: Manifest) -> bytes:
    """As the file of the archive."""
    return msgspec.json.format(msgspec.json.encode(manifest), indent=1) + b"\n"


def encode_polylines(pieces: Mapping[str, tuple[FloatArray, ...]], size: tuple[int, int]) -> bytes:
    """A frame's file.

    Args:
        pieces: element -> its pieces, each (n, 2) px of ``size``.
        size: (width, height) px.
    """
    largest = (size[0] - 1, size[1] - 1)
    content = {
        name: [
            [{"x": round(x, _DIGITS), "y": round(y, _DIGITS)} for x, y in (px / largest).tolist()]
            for px in parts
        ]
        for name, parts in pieces.items()
    }
    return msgspec.json.encode(content)


def holds_manifest(path: Path) -> bool:
    """Whether an archive is a submission of polylines."""
    if path.suffix.lower() != ".zip" or not path.is_file():
        return False
    with ZipSource(path) as archive:
        return archive.has(MANIFEST_FILE)


def read_manifest(path: Path) -> Manifest:
    """What the archive was made for.

    Raises:
        InputError: the archive cannot be opened, or holds no manifest that can be used.
    """
    with ZipSource(path) as archive:
        if not archive.has(MANIFEST_FILE):
            raise InputError(
                path,
                f"holds no {MANIFEST_FILE}, so it is no submission of polylines",
                advice="procc-annotator convert CAMERAS sub.zip --to polylines makes one",
            )
        data, shown = archive.read(MANIFEST_FILE), archive.display(MANIFEST_FILE)
    found = decode_as(data, Manifest, "manifest", path=shown)
    if found.format != FORMAT:
        raise InputError(shown, f"is of format {printable(found.format)}, expected {FORMAT}")
    return found


def method_of(manifest: Manifest) -> str:
    """The method's name as it may stand in tables and be asked for."""
    plain = "".join(c if c.isprintable() and c not in "=:/\\{}" else " " for c in manifest.method)
    return " ".join(plain.split())[:_LONGEST_NAME] or "submission"


def require_made_for(
    path: Path,
    manifest: Manifest,
    *,
    protocol: str,
    field_sha256: str,
    size: tuple[int, int],
    frames: Collection[str],
) -> None:
    """Refuse to score a submission for something that it was not made for.

    Raises:
        UsageError: what differs.
    """
    for problem in _made_for_another(manifest, protocol, field_sha256, size, frames):
        raise UsageError(f"{path}: {problem}")


def check_polylines(
    path: Path, field: Field, field_sha256: str, frames: Collection[str] | None
) -> list[SubmissionRemark]:
    """Look for everything that would go wrong.

    Args:
        path: the archive.
        field: whose elements count.
        frames: names of the annotated frames, where they are known.

    Raises:
        InputError: the archive cannot be opened.
    """
    try:
        manifest = read_manifest(path)
    except InputError as error:
        return [SubmissionRemark(REFUSED, MANIFEST_FILE, error.problem)]
    found = [
        SubmissionRemark(REFUSED, MANIFEST_FILE, problem)
        for problem in _made_for_another(manifest, None, field_sha256, None, frames)
    ]
    with ZipSource(path) as archive:
        files = list_cameras(archive, POLYLINES)
        found += _frames_remarks(files, frames)
        known = {*files.values(), MANIFEST_FILE, ""}
        others = [
            n for n in archive.names() if not (n.removeprefix("./") in known or n.endswith(SIDECAR_SUFFIX))
        ]
        if others:
            what = f"{count_words(len(others), 'file')} ({first_names(others)}) of no frame"
            found.append(SubmissionRemark(IGNORED, "", what))
        for name in files.values():
            found += _file_remarks(archive, name, field)
    return found


def _made_for_another(
    manifest: Manifest,
    protocol: str | None,
    field_sha256: str,
    size: tuple[int, int] | None,
    frames: Collection[str] | None,
) -> Iterator[str]:
    if protocol is not None and manifest.protocol != protocol:
        yield f"was made for the protocol {printable(manifest.protocol)}, not {protocol}"
    if manifest.field_sha256 != field_sha256:
        yield f"was made for another field ({printable(manifest.field)})"
    if size is not None and manifest.size != size:
        theirs, ours = (f"{s[0]}x{s[1]}" for s in (manifest.size, size))
        yield f"was made for an evaluation at {theirs}, not {ours}"
    if frames is not None and manifest.frames_sha256 != names_sha256(frames):
        count = len(frames)
        yield f"was made for other frames ({manifest.frames}; {count} are annotated)"


def _frames_remarks(
    given: CameraFiles, frames: Collection[str] | None
) -> Iterator[SubmissionRemark]:
    if not given:
        yield SubmissionRemark(REFUSED, "", "holds no polylines: expected files named FRAME.json")
    if frames is None:
        return
    if missing := natsorted(frame for frame in frames if frame not in given):
        what = f"{len(missing)} of {len(frames)} annotated frames are missing ({first_names(missing)})"
        yield SubmissionRemark(LOWERS, "", what)
    if unknown := natsorted(set(given) - {given.name_there(frame) for frame in frames}):
        what = f"{count_words(len(unknown), 'frame')} ({first_names(unknown)}) not annotated"
        yield SubmissionRemark(IGNORED, "", what)


def _file_remarks(archive: ZipSource, name: str, field: Field) -> Iterator[SubmissionRemark]:
    place = printable(name, 120)
    try:
        loaded = read_camera_file(archive.read(name), path=place, fmt=POLYLINES)
    except CameraError as error:
        where = f"{error.place}: " if error.place else ""
        yield SubmissionRemark(LOWERS, place, f"{where}{error.problem}: counts as missing")
        return
    except InputError as error:
        yield SubmissionRemark(LOWERS, place, f"{error.problem}: counts as missing")
        return
    pieces: Mapping[str, object] = getattr(loaded.camera, "pieces", {})
    strange = [n for n in pieces if field.canonical_name(n) not in field.index]
    if strange:
        what = f"no element of the field: {first_names([printable(n) for n in strange])}"
        yield SubmissionRemark(IGNORED, place, what)
