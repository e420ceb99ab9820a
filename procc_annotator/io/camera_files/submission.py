"""What the official SoccerNet evaluation would make of a submission: refuse, or silently pass over.

It reads ``SPLIT/camera_FRAME.json`` for each annotation ``SPLIT/FRAME.json``; needs every key of a
camera; takes the pixels for those of a 960x540 picture; and stops at the first file it cannot read.
"""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from natsort import natsorted

from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.errors import CameraError, InputError, UsageError
from procc_annotator.io.camera_files.soccernet_camera import camera_from
from procc_annotator.io.collections import CAMERA_PREFIX
from procc_annotator.io.json_text import printable
from procc_annotator.io.source import ZipSource
from procc_annotator.metric.folds import folds_into_image, fold_back_warnings, soccernet_tables
from procc_annotator.words import count_words

OFFICIAL_SIZE = (960, 540)
KEYS = (
    "pan_degrees", "tilt_degrees", "roll_degrees", "position_meters", "x_focal_length",
    "y_focal_length", "principal_point", "radial_distortion", "tangential_distortion",
    "thin_prism_distortion",
)  # fmt: skip
REFUSED, LOWERS, IGNORED = "refused", "lowers the score", "ignored"
_FAR = 0.2
_NAMED = 5


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


def check_submission(
    path: Path, frames: Collection[str] | None = None, split: str = "test"
) -> list[SubmissionRemark]:
    """Look for everything that would go wrong.

    Args:
        path: the archive.
        frames: names of the annotated frames, where they are known.
        split: the folder the evaluation looks into.

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
        findings += _frames_findings(cameras, frames, split)
        folded = []
        for frame, name in cameras.items():
            if frames is None or frame in frames:
                camera, found = _check_camera(archive, name)
                findings += found
                if camera is not None and _folds(camera):
                    folded.append(printable(frame))
        findings += [SubmissionRemark(LOWERS, "", line) for line in fold_back_warnings(natsorted(folded))]
    return findings


def _is_camera(name: str, split: str) -> bool:
    folder, _, file = name.rpartition("/")
    return folder == split and file.startswith(CAMERA_PREFIX) and file.endswith(".json")


def _names_findings(names: list[str], split: str, any_camera: bool) -> Iterator[SubmissionRemark]:
    for name, count in Counter(names).items():
        if count > 1 and _is_camera(name, split):
            yield SubmissionRemark(
                IGNORED, printable(name), f"is there {count} times, the last one counts"
            )
    others = [n for n in dict.fromkeys(names) if not n.endswith("/") and not _is_camera(n, split)]
    if not any_camera:
        found = f"; there is, for example, {printable(others[0])}" if others else ""
        if others and others[0].startswith("./"):
            found += " (./ is not looked past: pack the files without it)"
        yield SubmissionRemark(
            REFUSED,
            "",
            f"holds no camera: expected files named {split}/camera_FRAME.json{found}",
        )
    elif others:
        yield SubmissionRemark(
            IGNORED,
            "",
            f"{_listed(others)}: only files named {split}/camera_FRAME.json are looked at",
        )


def _frames_findings(
    cameras: dict[str, str], frames: Collection[str] | None, split: str
) -> Iterator[SubmissionRemark]:
    if frames is None or not cameras:
        return
    missing = natsorted(set(frames) - set(cameras))
    if missing:
        share = 100 * (1 - len(missing) / len(frames))
        have = "frame has" if len(frames) == 1 else "frames have"
        yield SubmissionRemark(
            LOWERS,
            "",
            f"{len(missing)} of {len(frames)} annotated {have} no camera"
            f" ({_names(missing)}): completeness {share:.1f} %",
        )
    unknown = natsorted(set(cameras) - set(frames))
    if unknown:
        yield SubmissionRemark(IGNORED, "", f"{_listed(unknown)}: no such frame is annotated")


def _check_camera(
    archive: ZipSource, name: str
) -> tuple[CameraOrProjections | None, list[SubmissionRemark]]:
    """A camera, where it can be read, and what is to say of it alone."""
    place = printable(name, 120)
    try:
        content: Any = json.loads(archive.read(name).decode("utf-8"))
    except InputError as error:
        return None, [SubmissionRemark(REFUSED, place, error.problem)]
    except (ValueError, RecursionError) as error:
        problem = f"is not JSON in UTF-8: {printable(str(error), 120)}"
        return None, [SubmissionRemark(REFUSED, place, problem)]
    if type(content) is not dict:
        return None, [
            SubmissionRemark(REFUSED, place, "is not an object with the keys of a camera")
        ]
    missing = [key for key in KEYS if key not in content]
    if missing:
        problem = f"lacks {', '.join(missing)}; every key is needed"
        return None, [SubmissionRemark(REFUSED, place, problem)]
    endless = [key for key in KEYS if _has_no_end(content[key])]
    if endless:
        problem = f"{endless[0]} is not finite: nothing is projected, JaC 0"
        return None, [SubmissionRemark(LOWERS, place, problem)]
    try:
        loaded = camera_from(content, path=place)
    except CameraError as error:
        problem = f"{error.place}: {error.problem}".removeprefix(": ")
        return None, [SubmissionRemark(REFUSED, place, problem)]
    said = [SubmissionRemark(LOWERS, place, notice) for notice in loaded.notices]
    said += _size_findings(loaded.size, content["principal_point"], place)
    return loaded.camera, said


def _folds(camera: CameraOrProjections) -> bool:
    return folds_into_image(camera, soccernet_tables(), OFFICIAL_SIZE)


def _size_findings(
    size: tuple[int, int] | None, centre: list[float], place: str
) -> Iterator[SubmissionRemark]:
    width, height = OFFICIAL_SIZE
    if size is not None and size != OFFICIAL_SIZE:
        yield SubmissionRemark(
            LOWERS,
            place,
            f"is for pictures of {size[0]}x{size[1]}; the evaluation takes every camera for"
            f" {width}x{height} and scales none",
        )
    elif abs(centre[0] - width / 2) > _FAR * width or abs(centre[1] - height / 2) > _FAR * height:
        yield SubmissionRemark(
            LOWERS,
            place,
            f"principal point ({centre[0]:g}, {centre[1]:g}) far from the middle of"
            f" {width}x{height}: the evaluation scales no camera",
        )


def _has_no_end(value: Any) -> bool:
    numbers = value if type(value) is list else [value]
    return any(type(n) is float and not math.isfinite(n) for n in numbers)


def _listed(names: list[str]) -> str:
    return f"{count_words(len(names), 'file')} ({_names(names)})"


def _names(names: list[str]) -> str:
    shown = ", ".join(printable(name) for name in names[:_NAMED])
    return f"{shown}, ..." if len(names) > _NAMED else shown
