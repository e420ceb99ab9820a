"""What a camera file gives: the camera, its model's name, and what else the file said."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.io.camera_files.held_out_table import LeftOutResult


@dataclass(frozen=True, eq=False)
class LoadedCamera:
    """A camera as read.

    Attributes:
        camera: expressed in pixels of ``size``.
        model: ``pinhole``, ``fisheye``, ``homography``, ``projections``, or what a plug-in
            calls its own; for people.
        size: (width, height) of the picture the pixels refer to; None when the file does not say,
            which for SoccerNet cameras means the evaluation size. Projections are given as shares
            of the picture, whatever its size; their ``size`` is the one that makes these pixels.
        extra: keys of the file that are not part of the model, written back on saving.
        notices: remarks a person should see.
        assumed_field: name of the field whose world these pixels belong to, where the format alone
            says so and nobody named it; empty otherwise.
        content: all of the file's keys and values, so that saving spells unchanged numbers alike.
        fitted_on: `annotation_digest` of the annotation it was fitted to, where that is told.
        held_out: how well the elements it was fitted to are shown by the cameras of the others,
            where that is told.
        size_is_usual: whether no file says ``size``, which is the usual one of the format.
    """

    camera: CameraOrProjections
    model: str
    size: tuple[int, int] | None = None
    extra: Mapping[str, Any] = field(default_factory=dict)
    notices: tuple[str, ...] = ()
    content: Mapping[str, Any] = field(default_factory=dict)
    fitted_on: str | None = None
    held_out: LeftOutResult | None = None
    assumed_field: str = ""
    size_is_usual: bool = False

    def size_where(self, told: tuple[int, int] | None) -> tuple[int, int] | None:
        """(width, height) of the picture the pixels refer to; None where nothing says it.

        Args:
            told: what a person says; the file knows better, what is usual for its format does not.
        """
        return (told or self.size) if self.size_is_usual else (self.size or told)


def with_notices(loaded: LoadedCamera, notices: Iterable[str]) -> LoadedCamera:
    """The same with more remarks for a person."""
    return replace(loaded, notices=(*loaded.notices, *notices))
