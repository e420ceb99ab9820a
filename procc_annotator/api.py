"""The front door for other programs: read an annotation, fit a camera to it, find one in a picture,
follow it through a shot, score it.

Importing `procc_annotator` is cheap; these functions and what they need are loaded when they are
first asked for. Nothing here needs Qt or a display. A request that makes no sense is a
`UsageError`, a file that cannot be used an `InputError`; both are a `ProccError`
(`procc_annotator.errors`), whose text is one line for the user.
"""

from __future__ import annotations

import operator
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.annotation import FrameAnnotation, pixel_like
from procc_annotator.camera.base import Camera
from procc_annotator.camera.projections import CameraOrProjections, ElementProjections
from procc_annotator.camera.scaling import scaled
from procc_annotator.errors import AnnotationError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.fit import fitting
from procc_annotator.fit.from_picture import proposing
from procc_annotator.fit.from_picture.proposal import KnownPosition, Proposal
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.through_shot import following_shot
from procc_annotator.fit.through_shot.track import Track, TrackedFrame
from procc_annotator.image.decode import decode_bgra
from procc_annotator.image.pixels import PixelArray, bgra
from procc_annotator.image.video import open_shared
from procc_annotator.io.annotation_files.annotation_formats import find_annotations
from procc_annotator.io.annotation_files.exchange import Reading
from procc_annotator.io.collections import CAMERA_PREFIX
from procc_annotator.io.source import open_source
from procc_annotator.metric.measure import measure
from procc_annotator.metric.score import FrameScore, score_to_read
from procc_annotator.metric.setup import EvaluationSetup, check_thresholds

DEFAULT_SIZE = fitting.DEFAULT_SIZE


class _Strict(Reading):
    """Of a set a reader skips what is damaged; a caller who asks for one frame is to hear of it."""

    @contextmanager
    def going_on(self) -> Iterator[None]:
        yield


def load_annotation(path: str | Path, field: Field | str | None = None) -> FrameAnnotation:
    """Read what is annotated in one frame.

    Args:
        path: a file of any annotation format the program reads, or a folder or zip archive with
            one such file; it must hold exactly one frame.
        field: knows the official spellings of the classes; or its name, see `load_field`; the
            usual one if None.

    Returns:
        The polylines by class, in the order of the file. Points are normalised: (0, 0) is the
        centre of the picture's first pixel, (1, 1) that of its last one (pixel = u * (width - 1)).
        Whatever the numbers are, they are kept; a `UserWarning` tells if they look like pixels.

    Raises:
        InputError: the file cannot be read; the message names it, the place and what was expected.
        UsageError: there is nothing at the path, no annotation, or more than one frame.
    """
    place = _path(path)
    if place.name.startswith(CAMERA_PREFIX) and place.is_file():
        raise UsageError(
            f"{place}: is a camera file ({CAMERA_PREFIX}*), expected an annotation"
            " (those are named after their frame: 00037.json)"
        )
    reading = _Strict(_field(field))
    with open_source(place) as source:
        known, files = find_annotations(source)
        if known.read is None:
            raise UsageError(f"{place}: {known.title} cannot be read")
        frames = list(known.read(source, files, reading))
    if len(frames) == 1 and not reading.problems:
        strange = pixel_like(frames[0].annotation)
        if strange is not None:
            warnings.warn(f"{place}: {fitting.pixels_words(strange)}", stacklevel=2)
        return frames[0].annotation
    if reading.problems:
        raise AnnotationError(str(place), reading.problems[0])
    names = ", ".join(frame.name for frame in frames[:3])
    more = ", ..." if len(frames) > 3 else ""
    raise UsageError(
        f"{place}: holds {len(frames)} frames ({names}{more}), one is needed"
        if frames
        else f"{place}: holds no frame"
    )


def fit_camera(
    annotation: FrameAnnotation,
    field: Field | str | None = None,
    *,
    model: str = "R",
    size: tuple[int, int] = DEFAULT_SIZE,
    start: Camera | None = None,
) -> FitResult:
    """Fit a camera to annotated elements; no picture and no start is needed.

    **Give the size of the picture**, or any size of its shape, unless it is 16:9. Annotations are
    normalised and do not tell their picture's shape: fitted as 960x540, those of a 4:3 picture give
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

    Returns:
        The camera in px of ``size``, with residuals (px) and standard deviations (rad, metres, px);
        see `procc_annotator.fit.fitting.fit_camera` and docs/fitting.md for how it is found.

    Raises:
        UsageError: an argument of another kind, no such model, or a size without pixels.
        FieldError: no such field.
    """
    given = _annotation(annotation), _field(field)
    if isinstance(start, FitResult):
        raise UsageError("start: expected a camera, found a fit (its `camera` is one)")
    if start is not None:
        _check_camera(start, "start")
    return fitting.fit_camera(*given, model=model, size=_size(size), start=start)


def evaluate(
    annotation: FrameAnnotation,
    camera: Camera | FitResult,
    *,
    field: Field | str | None = None,
    size: tuple[int, int] | None = None,
    tau: float = 5.0,
    protocol: str = "soccernet",
    allow_mirrored: bool = False,
    off_plane: str = "missed",
) -> FrameScore:
    """Score a camera: an annotated element passes if all its points are closer than tau to it.

    The protocol is that of Magera et al., A Universal Protocol to Benchmark Camera Calibration for
    Sports, CVsports 2024; ``soccernet`` follows the official evaluation in every count. See
    docs/metrics.md for every number.

    A fit knows its picture size. **A plain camera does not**: it is taken to be in px of ``size``,
    960x540 unless told otherwise, and a camera in px of another size scores nearly 0.

    Args:
        annotation: what is annotated, points normalised.
        camera: what `fit_camera` gave; or anything that projects world points (metres) to pixels of
            ``size``.
        field: the elements, metres; or a field's name, see `load_field`; the usual one (SoccerNet's
            classes, nominal size) if None.
        size: (width, height) px at which annotation and camera are compared; if None that of the
            fit, and 960x540 (the official size) for a plain camera. A fit is scaled to it.
        tau: the threshold, px; compared strictly.
        protocol: ``soccernet`` or ``procc``.
        allow_mirrored: whether labels of the turned field may count, where they fit better; for
            ``procc`` only, ``soccernet`` always considers them.
        off_plane: how elements off the ground count for a camera that knows only the ground:
            ``missed`` or ``left_out``.

    Returns:
        The score: ``jac`` = tp / (tp + fp + fn), the counts ``tp``, ``fp``, ``fn`` of elements,
        ``precision``, ``recall``, ``mean_error``, ``median_error`` and ``max_error`` (px; None
        where nothing is compared), ``mirrored`` (whether labels of the turned field fit better) and
        ``elements``, each with its verdict and distances (px).

    Raises:
        UsageError: an argument of another kind, a fit that failed (with its reason), a threshold
            that is no positive number, an unknown protocol or choice, or a size without pixels.
        FieldError: no such field.
    """
    (threshold,) = check_thresholds((tau,))
    used, at = _camera_at(camera, None if size is None else _size(size))
    setup = EvaluationSetup(_field(field), at, protocol, allow_mirrored, off_plane)
    return score_to_read(measure(_annotation(annotation), used, setup), threshold)


def propose_camera(
    picture: PixelArray | str | Path,
    field: Field | str | None = None,
    *,
    known: Sequence[KnownPosition] = (),
) -> Proposal:
    """Find the camera of a picture from the paint in it, without a click.

    Args:
        picture: a picture's file; or its pixels, (H, W, 3) or (H, W, 4) uint8, BGR as OpenCV reads
            them.
        field: the elements, metres; or a field's name, see `load_field`; the usual one (SoccerNet's
            classes, nominal size) if None.
        known: where its camera may be known to stand (`KnownPosition`: metres and covariance), as
            on the tripod of other frames; that is faster and surer.

    Returns:
        ``state`` (``sure``, ``unsure`` or ``none``), the ``reason`` in words, and ``fit``: the
        camera in px of the picture with its standard deviations; its ``camera`` is None if there is
        none. ``coverage`` is the share of the visible model found on paint, ``explained`` the share
        of the paint that the model explains, ``margin`` how much better it is than the
        ``runner_up``, each 0 to 1. Rely on those that are sure only.

    Raises:
        UsageError: an argument of another kind.
        ImageError: the file cannot be read.
        FieldError: no such field.
    """
    pixels = decode_bgra(_path(picture)) if isinstance(picture, str | Path) else _pixels(picture)
    return proposing.propose_camera(pixels, _field(field), known=known)


def track(
    frames: Sequence[PixelArray] | str | Path,
    field: Field | str | None = None,
    *,
    anchors: Mapping[int, Camera] | None = None,
    on_frame: Callable[[TrackedFrame], None] | None = None,
) -> Track:
    """Follow the camera through a video or through consecutive pictures.

    Cuts end a shot; where no camera is known in one, it is found in the picture, as
    `propose_camera` does.

    Args:
        frames: a video's file; or pictures of one size, each as `propose_camera` takes its pixels.
            Of a sequence only one picture at a time is asked for, perhaps more than once, and by
            another thread.
        field: the elements, metres; or a field's name, see `load_field`; the usual one if None.
        anchors: cameras that are known, by number of the frame (0 is the first), px of the
            pictures. The track passes through them.
        on_frame: told of each frame as soon as it was followed; what is returned at the end is
            surer. What it raises ends the work.

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
        video = open_shared(Path(frames))
        count, frame = video.frame_count, video.frame
    else:
        count, frame = _length(frames), lambda number: _pixels(frames[number])
    known = dict(anchors or {})
    for number, camera in known.items():
        _check_camera(camera, f"anchors[{number}]")
    told = on_frame or (lambda _: None)
    return following_shot.track(frame, range(count), _field(field), anchors=known, on_frame=told)


def _length(frames: object) -> int:
    if isinstance(frames, Sequence):
        return len(frames)
    raise UsageError(f"expected a video's path or a sequence of pictures, found {_kind(frames)}")


def _pixels(picture: object) -> PixelArray:
    right = isinstance(picture, np.ndarray) and picture.dtype == np.uint8 and picture.ndim == 3
    if not isinstance(picture, np.ndarray) or not right or picture.shape[2] not in (3, 4):
        raise UsageError(
            "expected a picture: the path of one, or (H, W, 3) or (H, W, 4) uint8 pixels, found"
            f" {_kind(picture)}"
        )
    return bgra(picture) if picture.shape[2] == 3 else picture


def _camera_at(
    camera: Camera | FitResult | None, size: tuple[int, int] | None
) -> tuple[CameraOrProjections, tuple[int, int]]:
    """A camera, and the size that it is in px of."""
    if camera is None:
        raise UsageError("there is no camera to evaluate (a fit that failed says why in `failure`)")
    if not isinstance(camera, FitResult):
        _check_camera(camera, "camera")
        return camera, size or DEFAULT_SIZE
    if camera.camera is None:
        raise UsageError(f"there is no camera to evaluate, the fit failed: {camera.failure}")
    if size is None or size == camera.size:
        return camera.camera, camera.size
    return scaled(camera.camera, camera.size, size), size


def _check_camera(camera: object, name: str) -> None:
    projects = callable(getattr(camera, "project", None))
    if not projects and not isinstance(camera, ElementProjections):
        raise UsageError(
            f"{name}: expected a camera (an object with `project`), found {_kind(camera)}"
        )


def _annotation(annotation: object) -> FrameAnnotation:
    if isinstance(annotation, FrameAnnotation):
        return annotation
    hint = " (load_annotation(path) reads one)" if isinstance(annotation, str | Path) else ""
    raise UsageError(f"expected an annotation (FrameAnnotation), found {_kind(annotation)}{hint}")


def _field(field: object) -> Field:
    if isinstance(field, Field):
        return field
    if field is None:
        return load_field()
    if isinstance(field, str | Path):
        return load_field(field)
    raise UsageError(f"expected a field, its name or its .toml file, found {_kind(field)}")


def _path(path: object) -> Path:
    if isinstance(path, str | Path):
        return Path(path)
    raise UsageError(f"expected the path of an annotation, found {_kind(path)}")


def _size(size: Any) -> tuple[int, int]:
    try:
        width, height = map(operator.index, size)
    except (TypeError, ValueError):  # no whole numbers, or not two of them
        raise UsageError(
            f"expected a size as (width, height) in whole pixels, found {size!r}"
        ) from None
    return width, height


def _kind(value: object) -> str:
    return "nothing" if value is None else type(value).__name__
