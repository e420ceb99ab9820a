"""Where an evaluation that knows of no folds, as the official one, shows what a lens folds back."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.field.load import load_field
from procc_annotator.metric.setup import FieldTables
from procc_annotator.words import count_words

_MAX_NAMED = 5


@cache
def soccernet_tables() -> FieldTables:
    """The field that the official evaluation knows."""
    return FieldTables.of(load_field())


def folds_into_image(
    camera: CameraOrProjections, tables: FieldTables, size: tuple[int, int]
) -> bool:
    """Whether the official evaluation would show field points in the picture that a lens folds
    back into it: they lie beyond `PinholeCamera.fold_radius`, and no lens shows them there.

    Args:
        camera: in px of ``size``; only pinholes fold.
        tables: the field, whose official samples are looked at.
        size: (width, height) px.
    """
    if not isinstance(camera, PinholeCamera) or camera.fold_radius == np.inf:
        return False
    points_px, in_front = camera.project_float32(tables.points_world)
    _, shown = camera.project(tables.points_world)
    folded = points_px[in_front & ~shown]
    return bool(((folded >= 0) & (folded < np.array(size))).all(axis=1).any())


def fold_back_warnings(frames: Sequence[str]) -> tuple[str, ...]:
    """One line for all frames whose cameras do so; nothing without any."""
    if not frames:
        return ()
    shown = ", ".join(frames[:_MAX_NAMED]) + (", ..." if len(frames) > _MAX_NAMED else "")
    cameras = count_words(len(frames), "camera folds", "cameras fold")
    return (
        f"{cameras} lines from far outside back into the picture in the official evaluation, which"
        f" does not know of folds; they may count as false positives there: {shown}",
    )
