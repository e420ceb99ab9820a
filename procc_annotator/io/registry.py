"""The table of camera formats: name, suffixes, reader."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from procc_annotator.errors import CameraError, UsageError
from procc_annotator.io.homography_file import CONVENTIONS, read_homography
from procc_annotator.io.loaded_camera import LoadedCamera
from procc_annotator.io.soccernet_camera import read_camera


@dataclass(frozen=True)
class CameraFormat:
    """One way cameras are kept in files; ``default_for`` are the suffixes ``auto`` gives to it."""

    name: str
    title: str
    suffixes: tuple[str, ...]
    default_for: tuple[str, ...]
    read: Callable[..., LoadedCamera]


_HOMOGRAPHY_SUFFIXES = (".homographymatrix", ".txt", ".npy")
_DEFAULTS = {"wc14": (".homographymatrix", ".txt"), "carwc": (".npy",), "world": ()}

FORMATS: tuple[CameraFormat, ...] = (
    CameraFormat("soccernet", "SoccerNet camera JSON", (".json",), (".json",), read_camera),
    *(
        CameraFormat(
            name,
            f"homography, {rule.title}",
            _HOMOGRAPHY_SUFFIXES,
            _DEFAULTS[name],
            partial(read_homography, convention=name),
        )
        for name, rule in CONVENTIONS.items()
    ),
)
CAMERA_FORMATS: tuple[str, ...] = ("auto", *(f.name for f in FORMATS))


def format_of(path: str, fmt: str = "auto") -> CameraFormat:
    """The format to read a file with.

    Raises:
        UsageError: no such format.
        CameraError: ``auto`` does not know the suffix.
    """
    if fmt != "auto":
        for known in FORMATS:
            if known.name == fmt:
                return known
        raise UsageError(f"no camera format {fmt!r}; there are {', '.join(CAMERA_FORMATS)}")
    suffix = os.path.splitext(path)[1].lower()
    for known in FORMATS:
        if suffix in known.default_for:
            return known
    raise CameraError(
        path,
        f"unknown kind of camera file {suffix!r}",
        advice=f"choose a camera format: {', '.join(CAMERA_FORMATS[1:])}",
    )


def suffixes_of(fmt: str = "auto") -> frozenset[str]:
    """Lower-case suffixes of the files that may hold cameras of a format."""
    if fmt == "auto":
        return frozenset(s for known in FORMATS for s in known.default_for)
    return frozenset(format_of("", fmt).suffixes)
