"""Fit, propose and track cameras; check the labels of a frame."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation, as_size
from procc_annotator.api.inputs import (
    as_annotation,
    as_camera,
    as_field,
    as_path,
    as_picture,
    as_pixels,
    kind_of,
)
from procc_annotator.batch import calibration
from procc_annotator.calibration import fitting
from procc_annotator.calibration.fitting import DEFAULT_SIZE
from procc_annotator.calibration.label_check.check import add_line_evidence
from procc_annotator.calibration.label_check.check import check_labels as findings_of
from procc_annotator.calibration.label_check.finding import Finding
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image import propose
from procc_annotator.calibration.single_image.probability import POSSIBLE_FROM, SURE_FROM
from procc_annotator.calibration.single_image.proposal import KnownPosition, Proposal
from procc_annotator.calibration.tracking import shot_tracker
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.camera.base import Camera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.fit_record import LeftOutElement, annotation_digest
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.video import open_shared_video
from procc_annotator.metrics.setup import EvaluationSetup


def fit_camera(
    annotation: FrameAnnotation,
    field: Field | str | None = None,
    *,
    model: str = "R",
    size: tuple[int, int] = fitting.DEFAULT_SIZE,
    start: Camera | None = None,
    pixel_aspect: float | None = None,
) -> FitResult:
    """Fit a camera to annotated elements; no picture and no start is needed.

    **Give the size of the picture**, or any size of its shape, unless it is 16:9. Annotations are
    normalised and do not give their picture's shape: fitted as 960x540, those of a 4:3 picture give
    a camera that is wrong, and nothing notices.

    A fit that cannot be is no error: ``camera`` is then None and ``failure`` says why.

    Args:
        annotation: what is annotated, points normalised.
        field: the elements, metres; or a field's name, see `load_field`; the usual one (SoccerNet's
            classes, nominal size) if None.
        model: H (homography of the ground), P (pinhole, one focal length), R (P and one radial
            coefficient), R+ (R, aspect ratio and principal point), R2 (R+ and a second radial
            coefficient), F (OpenCV's fisheye), or auto (the simplest of P, R and R+ that the points
            support, or R2 or F).
        size: (width, height) px of the picture the camera is for.
        start: a camera that is nearly right, px of ``size``.
        pixel_aspect: width of the picture's pixels over their height, such as 16 / 9 for one that
            was squeezed to a square; None for what the field says, else 1.

    Returns:
        The camera in px of ``size``, with residuals (px) and standard deviations (rad, metres, px);
        see `procc_annotator.calibration.fitting.fit_camera` and docs/explanation/fitting.md for how
        it is found.

    Raises:
        UsageError: an argument of another kind, no such model, or a size without pixels.
        FieldError: no such field.
    """
    given = as_annotation(annotation), as_field(field, pixel_aspect)
    if isinstance(start, FitResult):
        raise UsageError("start: expected a camera, found a fit (its `camera` is one)")
    if start is not None:
        as_camera(start, "start")
    fit = fitting.fit_camera(*given, model=model, size=as_size(size), start=start)
    return fit if fit.camera is None else replace(fit, fitted_on=annotation_digest(given[0]))


def leave_one_out(
    annotation: FrameAnnotation,
    field: Field | str | None = None,
    *,
    model: str = "R",
    size: tuple[int, int] = fitting.DEFAULT_SIZE,
    protocol: str = "soccernet",
) -> tuple[LeftOutElement, ...]:
    """Predict each element of a frame by a camera fitted to the others (leave-one-element-out).

    What a fit explains is no evidence for its model; what it predicts is.

    Args:
        annotation: and field, model, size: as of `fit_camera`.
        protocol: of the distances, see `evaluate`.

    Returns:
        The elements that the others determine a camera for, with the distance of their farthest
        point (px): ``predicted_px`` under that camera, ``explained_px`` under the fit to all.

    Raises:
        UsageError, FieldError: as of `fit_camera`.
    """
    given, shown = as_annotation(annotation), as_field(field)
    setup = EvaluationSetup(shown, as_size(size), protocol)
    fit = fitting.fit_camera(given, shown, model=model, size=setup.size)
    return calibration.leave_one_out(given, fit, setup, model)


def propose_camera(
    picture: PixelArray | str | Path,
    field: Field | str | None = None,
    *,
    known: Sequence[KnownPosition] = (),
    sure_from: float = SURE_FROM,
    pixel_aspect: float | None = None,
) -> Proposal:
    """Find the camera of a picture from the paint in it, without a click.

    Args:
        picture: a picture's file; or its pixels, (H, W, 3) or (H, W, 4) uint8, BGR as OpenCV reads
            them.
        field: as of `fit_camera`.
        known: where its camera may be known to stand (`KnownPosition`: metres and covariance), as
            on the tripod of other frames: searched in addition to all other positions, and never
            a replacement for a better camera found without it.
        sure_from: the probability of being right from which on a camera is called sure, 0.5 to 1.
        pixel_aspect: see `fit_camera`; None for what the field says, else estimated if the picture
            is nearly square.

    Returns:
        ``probability`` that the camera is right, 0 to 1, and with it ``state`` (``sure``,
        ``unsure`` or ``none``), the ``reason`` in words, and ``fit``: the camera in px of the
        picture with its standard deviations; its ``camera`` is None if there is none. ``coverage``
        is the share of the visible model found on paint, ``explained`` the share of the paint on
        the field that the model explains, ``margin`` how much better it is than the
        ``runner_up``, each 0 to 1. Rely on those that are sure only.

    Raises:
        UsageError: an argument of another kind.
        ImageError: the file cannot be read.
        FieldError: no such field.
    """
    if not isinstance(sure_from, int | float) or not POSSIBLE_FROM <= sure_from <= 1:
        raise UsageError(f"sure_from: expected a probability from {POSSIBLE_FROM} to 1")
    shown = as_field(field, pixel_aspect)
    return propose.propose_camera(as_picture(picture), shown, known=known, sure_from=sure_from)


def track(
    frames: Sequence[PixelArray] | str | Path,
    field: Field | str | None = None,
    *,
    anchors: Mapping[int, Camera] | None = None,
    on_frame: Callable[[TrackedFrame], None] | None = None,
    pixel_aspect: float | None = None,
) -> Track:
    """Follow the camera through a video or through consecutive pictures.

    Cuts end a shot; where no camera is known in one, it is found in the picture, as
    `propose_camera` does.

    Args:
        frames: a video's file; or pictures of one size, each as `propose_camera` takes its pixels.
            Of a sequence only one picture at a time is asked for, perhaps more than once, and by
            another thread.
        field: as of `fit_camera`.
        anchors: cameras that are known, by number of the frame (0 is the first), px of the
            pictures. The track passes through them.
        on_frame: called for each frame as soon as it was followed; what is returned at the end is
            surer. What it raises ends the work.
        pixel_aspect: see `fit_camera`; None for what the video's metadata or the field say, else
            estimated if the pictures are nearly square.

    Returns:
        ``frames``, one a picture: ``number``, ``state`` (``anchor``, ``followed``, ``bridged`` by
        the picture's motion, ``lost``), the ``reason`` in words, ``fit`` with the camera in px of
        the picture and its standard deviations (None if lost), ``coverage``, ``residual_px``,
        ``anchor_distance`` in frames; and ``shots``, the first and last number of each.

    Raises:
        UsageError: an argument of another kind.
        ImageError: a picture or the video cannot be read.
        FieldError: no such field.
    """
    if isinstance(frames, str | Path):
        video = open_shared_video(as_path(frames, "a video"))
        count, frame = video.frame_count, video.frame
        if pixel_aspect is None and video.pixel_aspect != 1:
            pixel_aspect = video.pixel_aspect
    else:
        count, frame = _length(frames), lambda number: as_pixels(frames[number])
    known = dict(anchors or {})
    for number, camera in known.items():
        if number not in range(count):
            raise UsageError(f"anchors: no frame {number!r} among {count}, of which 0 is the first")
        as_camera(camera, f"anchors[{number}]")
    report = on_frame or (lambda _: None)
    shown = as_field(field, pixel_aspect)
    return shot_tracker.track_shot(frame, range(count), shown, anchors=known, on_frame=report)


def _length(frames: object) -> int:
    if isinstance(frames, Sequence):
        return len(frames)
    raise UsageError(f"expected a video's path or a sequence of pictures, found {kind_of(frames)}")


def check_labels(
    annotation: FrameAnnotation,
    field: Field | str | None = None,
    *,
    size: tuple[int, int] = DEFAULT_SIZE,
    picture: PixelArray | str | Path | None = None,
    model: str = "R",
) -> tuple[Finding, ...]:
    """Return what may be wrong with the labels and points of a frame.

    Args:
        annotation: and field: as of `fit_camera`.
        size: (width, height) px of the picture, or any size of its shape; that of ``picture`` if it
            is given.
        picture: a picture's file, or its pixels, (H, W, 3) or (H, W, 4) uint8, BGR: what it shows
            of paint is examined, too.
        model: of the camera that is fitted, see `fit_camera`.

    Returns:
        At most one finding about each mistake, the surest first: its ``severity``, ``elements``,
        ``reason`` in words, ``remedies``, and ``error_px`` (px of ``size``).

    Raises:
        UsageError: an argument of another kind, no such model, or a size without pixels.
        ImageError: the picture cannot be read.
        FieldError: no such field.
    """
    given, known = as_annotation(annotation), as_field(field)
    pixels = None if picture is None else as_picture(picture)
    at = as_size(size) if pixels is None else (pixels.shape[1], pixels.shape[0])
    fit = fitting.fit_camera(given, known, model=model, size=at)
    found = findings_of(given, known, size=at, fit=fit)
    if pixels is None:
        return found
    # What looks for paint takes longer to load than most checks take.
    from procc_annotator.assist.line_evidence import line_evidence_by_class

    paint = line_evidence_by_class(given, pixels, known)
    return add_line_evidence(found, given, known, size=at, fit=fit, paint=paint)
