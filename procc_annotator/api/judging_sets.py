"""How well the cameras of a method and the annotations of a set agree."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation, as_size
from procc_annotator.api.given import (
    AnyCamera,
    CameraInPixels,
    as_annotation,
    as_field,
    as_optional_size,
    evaluated_camera,
    kind_of,
)
from procc_annotator.api.reading import Dataset, load_cameras, load_dataset
from procc_annotator.api.set_score import SetScore, score_set
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.fit.fitting import DEFAULT_SIZE
from procc_annotator.fit.result import FitResult
from procc_annotator.io.frame_names import FrameTable
from procc_annotator.metric.setup import EvaluationSetup, check_thresholds

Size = tuple[int, int]


def evaluate_set(
    annotations: Mapping[str, FrameAnnotation] | Dataset | str | Path,
    cameras: Mapping[str, AnyCamera | None] | str | Path,
    *,
    field: Field | str | None = None,
    size: Size = DEFAULT_SIZE,
    camera_size: Size | None = None,
    thresholds: tuple[float, ...] = (5.0,),
    protocol: str = "soccernet",
    allow_mirrored: bool = False,
    off_plane: str = "missed",
    planar_only: bool = False,
) -> SetScore:
    """Score the cameras of a method on a set: the figures of ``procc-annotator evaluate``.

    Args:
        annotations: frame name -> what is annotated in it; or a dataset, or the path of one.
        cameras: frame name -> its camera, as `evaluate` takes it; or the path of camera files.
            Annotated frames without a camera, or whose camera is None or a fit that failed, lower
            the completeness; cameras of frames that are not annotated are not counted.
        field: the elements, metres; or a field's name, see `load_field`; if None that of the
            dataset, and the usual one (SoccerNet's classes, nominal size) for other annotations.
        size: (width, height) px at which annotations and cameras are compared; cameras are scaled
            to it.
        camera_size: (width, height) px that the cameras belong to, where they are no fits and their
            files do not say it; ``size`` if None (1280x720 for files of homographies).
        thresholds: px; compared strictly.
        protocol: ``soccernet`` or ``procc``.
        allow_mirrored: whether labels of the turned field may count, where they fit better; for
            ``procc`` only, ``soccernet`` always considers them.
        off_plane: how elements off the ground count for a camera that knows only the ground:
            ``missed`` or ``left_out``.
        planar_only: whether elements off the ground are left out for every camera.

    Returns:
        The figures of the set by threshold, the scores of its frames, and both as tables.

    Raises:
        UsageError: nothing to score, an argument of another kind, a camera whose answers are no
            projection, or a choice that there is not, see `evaluate`.
        InputError: a file cannot be used.
    """
    if not isinstance(thresholds, Iterable):
        raise UsageError(f"thresholds: expected numbers of pixels, found {thresholds!r}")
    if isinstance(annotations, str | Path):
        annotations = load_dataset(annotations, field)
    if isinstance(annotations, Dataset):
        known = annotations.field if field is None else as_field(field)
        annotations = annotations.annotations
    else:
        known = as_field(field)
    if isinstance(cameras, str | Path):
        cameras = load_cameras(cameras)
    _require_by_frame("annotations", annotations)
    _require_by_frame("cameras", cameras)
    if not isinstance(cameras, FrameTable):
        cameras = FrameTable(cameras)
    at, own = as_size(size), as_optional_size(camera_size)
    setup = EvaluationSetup(known, at, protocol, allow_mirrored, off_plane, planar_only)
    frames: dict[str, tuple[FrameAnnotation, CameraInPixels | None]] = {}
    for name, annotation in annotations.items():
        camera = cameras.get(name)
        if isinstance(camera, FitResult) and camera.camera is None:
            camera = None
        used = None
        if camera is not None:
            used = evaluated_camera(camera, setup, own, f"camera of {name}")
        frames[name] = as_annotation(annotation), used
    return score_set(frames, setup, check_thresholds(tuple(thresholds)))


def _require_by_frame(what: str, given: object) -> None:
    if not isinstance(given, Mapping):
        found = kind_of(given)
        raise UsageError(f"{what}: expected values by frame name, or a path, found {found}")
