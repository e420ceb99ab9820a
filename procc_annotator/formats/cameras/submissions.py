"""Check SoccerNet camera submissions; write, read and check submissions of projected polylines."""

from __future__ import annotations

import hashlib
import json
import math
import unicodedata
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path, PurePosixPath
from typing import Any

import msgspec
from natsort import natsorted

from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.errors import CameraError, InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.cameras.soccernet import camera_from
from procc_annotator.formats.file_listing import (
    CAMERA_PREFIX,
    MANIFEST_FILE,
    list_cameras,
)
from procc_annotator.formats.file_source import ZipSource
from procc_annotator.formats.frame_names import ByFrame
from procc_annotator.formats.strict_json import decode_as, printable
from procc_annotator.messages import first_names, pluralize
from procc_annotator.metrics.official import fold_back_warnings, folds_into_image, soccernet_tables

OFFICIAL_SIZE = (960, 540)
KEYS = (
    "pan_degrees", "tilt_degrees", "roll_degrees", "position_meters", "x_focal_length",
    "y_focal_length", "principal_point", "radial_distortion", "tangential_distortion",
    "thin_prism_distortion",
)  # fmt: skip
REFUSED, LOWERS, IGNORED = "refused", "lowers the score", "ignored"
_FAR = 0.2


@dataclass(frozen=True)
class SubmissionRemark:
    """Something about a submission its maker should know.

    Attributes:
        kind: ``refused`` (the evaluation stops there), ``lowers the score`` or ``ignored``.
        place: the file in the archive; empty for all of it.
        text: what is wrong, and what to do.
    """

    kind: str
    place: str
    text: str

    def __str__(self) -> str:
        return (
            f"{self.kind}: {self.place}: {self.text}" if self.place else f"{self.kind}: {self.text}"
        )


_refused = partial(SubmissionRemark, REFUSED)
_lowers = partial(SubmissionRemark, LOWERS)
_ignored = partial(SubmissionRemark, IGNORED)


def check_submission(
    path: Path, frames: Collection[str] | None = None, split: str = "test"
) -> list[SubmissionRemark]:
    """Look for everything that would go wrong; the evaluation looks into the folder of the split.

    Raises:
        UsageError: nothing there, or no zip archive by its name.
        InputError: the archive cannot be opened.
    """
    if path.is_dir():
        raise UsageError(
            f"{path}: is a folder, a submission is a zip archive (procc-annotator convert {path}"
            " test.zip --to submission makes one)"
        )
    if not path.is_file():
        raise UsageError(f"{path}: no such file")
    if path.suffix.lower() != ".zip":
        raise UsageError(f"{path}: a submission is a zip archive")
    with ZipSource(path) as archive:
        names = archive.names()
        cameras = {
            PurePosixPath(name).stem.removeprefix(CAMERA_PREFIX): name
            for name in names
            if _is_camera(name, split)
        }
        findings = list(_names_findings(names, split, bool(cameras)))
        findings += _frames_remarks(cameras, frames, "have no camera")
        folded = []
        for frame, name in cameras.items():
            if frames is None or frame in frames:
                camera, found = _check_camera(archive, name)
                findings += found
                if camera is not None and folds_into_image(
                    camera, soccernet_tables(), OFFICIAL_SIZE
                ):
                    folded.append(printable(frame))
        findings += [_lowers("", line) for line in fold_back_warnings(natsorted(folded))]
    return findings


def _is_camera(name: str, split: str) -> bool:
    folder, _, file = name.rpartition("/")
    return folder == split and file.startswith(CAMERA_PREFIX) and file.endswith(".json")


def _names_findings(names: list[str], split: str, any_camera: bool) -> Iterator[SubmissionRemark]:
    for name, count in Counter(names).items():
        if count > 1 and _is_camera(name, split):
            yield _ignored(printable(name), f"is there {count} times, the last one counts")
    others = [n for n in dict.fromkeys(names) if not n.endswith("/") and not _is_camera(n, split)]
    if not any_camera:
        found = f"; there is, for example, {printable(others[0])}" if others else ""
        if others and others[0].startswith("./"):
            found += " (./ is not looked past: pack the files without it)"
        yield _refused(
            "", f"holds no camera: expected files named {split}/camera_FRAME.json{found}"
        )
    elif others:
        yield _ignored(
            "", f"{_listed(others)}: only files named {split}/camera_FRAME.json are read"
        )


def _frames_remarks(
    given: Collection[str], frames: Collection[str] | None, lacking: str
) -> Iterator[SubmissionRemark]:
    if frames is None or not given:
        return
    if missing := [frame for frame in natsorted(frames) if frame not in given]:
        share = 100 * (1 - len(missing) / len(frames))
        yield _lowers(
            "",
            f"{len(missing)} of {len(frames)} annotated frames {lacking} ({_names(missing)}):"
            f" completeness {share:.1f} %",
        )
    there = ByFrame.fromkeys(frames)
    if unknown := natsorted(frame for frame in given if frame not in there):
        yield _ignored("", f"{_listed(unknown)}: no such frame is annotated")


def _check_camera(
    archive: ZipSource, name: str
) -> tuple[CameraOrProjections | None, list[SubmissionRemark]]:
    place = printable(name, 120)
    try:
        content: Any = json.loads(archive.read(name).decode("utf-8"))
    except InputError as error:
        return None, [_refused(place, error.problem)]
    except (ValueError, RecursionError) as error:
        problem = f"is not JSON in UTF-8: {printable(str(error), 120)}"
        return None, [_refused(place, problem)]
    if type(content) is not dict:
        return None, [_refused(place, "is not an object with the keys of a camera")]
    missing = [key for key in KEYS if key not in content]
    if missing:
        problem = f"lacks {', '.join(missing)}; every key is needed"
        return None, [_refused(place, problem)]
    endless = [key for key in KEYS if _has_no_end(content[key])]
    if endless:
        problem = f"{endless[0]} is not finite: nothing is projected, JaC 0"
        return None, [_lowers(place, problem)]
    try:
        loaded = camera_from(content, path=place)
    except CameraError as error:
        problem = f"{error.place}: {error.problem}".removeprefix(": ")
        return None, [_refused(place, problem)]
    said = [_lowers(place, notice) for notice in loaded.notices]
    said += _size_findings(loaded.size, content["principal_point"], place)
    return loaded.camera, said


def _size_findings(
    size: tuple[int, int] | None, centre: list[float], place: str
) -> Iterator[SubmissionRemark]:
    width, height = OFFICIAL_SIZE
    if size is not None and size != OFFICIAL_SIZE:
        yield _lowers(
            place,
            f"is for pictures of {size[0]}x{size[1]}; the evaluation takes every camera for"
            f" {width}x{height} and scales none",
        )
    elif abs(centre[0] - width / 2) > _FAR * width or abs(centre[1] - height / 2) > _FAR * height:
        yield _lowers(
            place,
            f"principal point ({centre[0]:g}, {centre[1]:g}) far from the middle of"
            f" {width}x{height}: the evaluation scales no camera",
        )


def _has_no_end(value: Any) -> bool:
    numbers = value if type(value) is list else [value]
    return any(type(n) is float and not math.isfinite(n) for n in numbers)


def _listed(names: list[str]) -> str:
    return f"{pluralize(len(names), 'file')} ({_names(names)})"


def _names(names: list[str]) -> str:
    return first_names([printable(name) for name in names])


FORMAT = "procc-annotator polylines 1"
POLYLINES = "polylines"  # the format of the files
_LONGEST_NAME = 60


@dataclass(frozen=True)
class Manifest:
    """Terms that a submission was made for.

    Attributes:
        method: what it is called in tables.
        version: of the program that wrote it; empty where another one did.
        protocol: ``soccernet`` or ``procc``.
        field: its name; field_sha256: see `field.load`.
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


def holds_manifest(path: Path) -> bool:
    """Return whether an archive is a submission of polylines."""
    if path.suffix.lower() != ".zip" or not path.is_file():
        return False
    with ZipSource(path) as archive:
        return archive.has(MANIFEST_FILE)


def read_manifest(path: Path) -> Manifest:
    """Return what the archive was made for. `InputError` if the archive cannot be opened, or holds
    no manifest that can be used."""
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
    """Look for everything that would go wrong. `InputError` if the archive cannot be opened."""
    try:
        manifest = read_manifest(path)
    except InputError as error:
        return [_refused(MANIFEST_FILE, error.problem)]
    found = [
        _refused(MANIFEST_FILE, problem)
        for problem in _made_for_another(manifest, None, field_sha256, None, frames)
    ]
    with ZipSource(path) as archive:
        files = list_cameras(archive, POLYLINES)
        if not files:
            problem = "holds no polylines: expected files named FRAME.json"
            found.append(_refused("", problem))
        found += _frames_remarks(files, frames, "are missing")
        known = {*files.values(), MANIFEST_FILE, ""}
        others = [n for n in archive.names() if n.removeprefix("./") not in known]
        if others:
            found.append(_ignored("", f"{_listed(others)} of no frame"))
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


def _file_remarks(archive: ZipSource, name: str, field: Field) -> Iterator[SubmissionRemark]:
    place = printable(name, 120)
    try:
        loaded = read_camera_file(archive.read(name), path=place, fmt=POLYLINES)
    except InputError as error:
        where = f"{error.place}: " if error.place else ""
        yield _lowers(place, f"{where}{error.problem}: counts as missing")
        return
    pieces: Mapping[str, object] = getattr(loaded.camera, "pieces", {})
    strange = [n for n in pieces if field.canonical_name(n) not in field.index]
    if strange:
        what = f"no element of the field: {_names(strange)}"
        yield _ignored(place, what)
