"""Score one frame, project the field, compare two cameras."""

from __future__ import annotations

import warnings

import numpy as np
from numpy.typing import ArrayLike

from procc_annotator.annotation import FrameAnnotation, as_size
from procc_annotator.api.inputs import (
    AnyCamera,
    as_annotation,
    as_field,
    as_optional_size,
    camera_at_size,
    evaluated_camera,
    position_remarks,
)
from procc_annotator.arrays import FloatArray
from procc_annotator.batch.scoring import NOTHING_SHOWN
from procc_annotator.calibration.fitting import DEFAULT_SIZE
from procc_annotator.calibration.result import FitResult
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.metrics import error_maps as two_cameras
from procc_annotator.metrics import projection, score
from procc_annotator.metrics.error_maps import Disagreement
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import FrameScore, display_score
from procc_annotator.metrics.setup import EvaluationSetup, check_thresholds

Size = tuple[int, int]


def evaluate(
    annotation: FrameAnnotation,
    camera: AnyCamera,
    *,
    field: Field | str | None = None,
    size: Size | None = None,
    camera_size: Size | None = None,
    threshold: float = 5.0,
    protocol: str = "soccernet",
    allow_mirrored: bool = False,
    off_plane: str = "missed",
    planar_only: bool = False,
) -> FrameScore:
    """Score a camera: an annotated element passes if all its points are closer than the threshold.

    The protocol is that of Magera et al., A Universal Protocol to Benchmark Camera Calibration for
    Sports, CVsports 2024; ``soccernet`` follows the official evaluation in every count. See
    docs/explanation/metric.md for every number.

    A fit knows its picture size, and so do most camera files. **A plain camera does not**: it is
    taken to be in px of ``size``, 960x540 unless stated otherwise, and a camera in px of another
    size scores nearly 0.

    Args:
        annotation: what is annotated, points normalised.
        camera: what `fit_camera`, `load_camera` or a ``camera_from_...`` gave; or anything that
            projects world points (metres) to pixels, see `Camera`.
        field: the elements, metres; or a field's name, see `load_field`; the usual one (SoccerNet's
            classes, nominal size) if None.
        size: (width, height) px at which annotation and camera are compared; if None that of the
            fit, and 960x540 (the official size) for any other camera. Cameras are scaled to it.
        camera_size: (width, height) px that the camera belongs to, where it is no fit and its file
            does not say it; ``size`` if None (1280x720 for files of homographies).
        threshold: px; compared strictly.
        protocol: ``soccernet`` or ``procc``.
        allow_mirrored: whether labels of the turned field may count, where they fit better; for
            ``procc`` only, ``soccernet`` always considers them.
        off_plane: how elements off the ground count for a camera that knows only the ground:
            ``missed`` or ``left_out``.
        planar_only: whether elements off the ground are left out for every camera.

    Returns:
        The score: ``jac`` = tp / (tp + fp + fn), the counts ``tp``, ``fp``, ``fn`` of elements,
        ``precision``, ``recall``, ``mean_error``, ``median_error`` and ``max_error`` (px; None
        where nothing is compared), ``mirrored`` (whether labels of the turned field fit better) and
        ``elements``, each with its verdict and distances (px).

    Raises:
        UsageError: an argument of another kind, a fit that failed (with its reason), a camera whose
            answers are no projection, a threshold that is no positive number, an unknown protocol
            or choice, or a size without pixels.
        FieldError: no such field.
    """
    (chosen,) = check_thresholds(threshold)
    at = _size_of_camera(camera, size)
    setup = EvaluationSetup(as_field(field), at, protocol, allow_mirrored, off_plane, planar_only)
    used = evaluated_camera(camera, setup, as_optional_size(camera_size))
    measurement = measure(as_annotation(annotation), used.camera, setup)
    nothing = [] if measurement.projected.shows_any else [f"the camera {NOTHING_SHOWN}"]
    for line in (*position_remarks([used]), *nothing):
        warnings.warn(line, stacklevel=2)
    return display_score(measurement, chosen)


def jac_curve(
    annotation: FrameAnnotation,
    camera: AnyCamera,
    thresholds: ArrayLike,
    *,
    field: Field | str | None = None,
    size: Size | None = None,
    camera_size: Size | None = None,
    protocol: str = "soccernet",
    allow_mirrored: bool = False,
    off_plane: str = "missed",
    planar_only: bool = False,
) -> FloatArray:
    """JaC as a function of the threshold; the same numbers as `evaluate` gives one by one.

    Args:
        annotation: what is annotated, points normalised.
        camera: as `evaluate` takes it.
        thresholds: (T,) px, in any order.
        field: and size, camera_size, protocol, allow_mirrored, off_plane, planar_only: as of
            `evaluate`.

    Returns:
        (T,) JaC in [0, 1].

    Raises:
        UsageError, FieldError: as of `evaluate`.
    """
    given = np.asarray(thresholds)
    if given.dtype.kind not in "fiu" or np.isnan(given).any():
        raise UsageError(f"expected thresholds as numbers of pixels, found {thresholds!r}")
    at = _size_of_camera(camera, size)
    setup = EvaluationSetup(as_field(field), at, protocol, allow_mirrored, off_plane, planar_only)
    used = evaluated_camera(camera, setup, as_optional_size(camera_size)).camera
    return score.jac_curve(measure(as_annotation(annotation), used, setup), given)


def project_field(
    camera: AnyCamera,
    field: Field | str | None = None,
    *,
    size: Size | None = None,
    camera_size: Size | None = None,
    protocol: str = "procc",
    clipped: bool = True,
) -> dict[str, tuple[FloatArray, ...]]:
    """Return where a camera shows the elements of a field.

    Args:
        camera: and field, camera_size: as of `evaluate`.
        size: (width, height) px of the picture; as of `evaluate`.
        protocol: ``procc`` for true curves; ``soccernet`` for the points that the official
            evaluation measures to, which always end at the border of the picture.
        clipped: whether curves are cut where they leave the picture, to be drawn. To be judged as
            `ElementProjections` in place of the camera they must not be.

    Returns:
        Class name -> its pieces, each (n, 2) px of ``size``, vertices in order along the element;
        of the elements that have any in the picture.

    Raises:
        UsageError, FieldError: as of `evaluate`.
    """
    at = _size_of_camera(camera, size)
    known = as_field(field)
    used = camera_at_size(camera, at, as_optional_size(camera_size), field=known).camera
    setup = EvaluationSetup(known, at, protocol)
    if clipped:
        return projection.project_field(used, setup).pieces
    return projection.project_measured(used, setup)


def disagreement(
    a: AnyCamera,
    b: AnyCamera,
    field: Field | str | None = None,
    *,
    size: Size = DEFAULT_SIZE,
    camera_size: Size | None = None,
    step_px: int = 4,
) -> Disagreement:
    """Return how far two cameras of one picture disagree about the ground, pixel by pixel.

    Args:
        a: a camera as `evaluate` takes it; not projections alone, which know no ground.
        b: the other one.
        field: the ground that counts, metres, as of `evaluate`.
        size: (width, height) px of the picture.
        camera_size: as of `evaluate`.
        step_px: samples are at most that far apart, px; the picture's border is always sampled.

    Returns:
        Maps (h, w) of the distance in metres between the two ground points that a pixel means, and
        in px of the picture; ``statistics`` of both.

    Raises:
        UsageError: an argument of another kind, projections alone, or a step below one pixel.
        FieldError: no such field.
    """
    at, own, known = as_size(size), as_optional_size(camera_size), as_field(field)
    first = camera_at_size(a, at, own, "a", field=known).camera
    second = camera_at_size(b, at, own, "b", field=known).camera
    return two_cameras.disagreement(first, second, known, at, step_px=step_px)


def _size_of_camera(camera: object, size: Size | None) -> Size:
    if size is not None:
        return as_size(size)
    return camera.size if isinstance(camera, FitResult) else DEFAULT_SIZE
