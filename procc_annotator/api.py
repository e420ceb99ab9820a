"""The front door for other programs: read an annotation, fit a camera to it, score a camera.

Importing `procc_annotator` is cheap; these functions and what they need are loaded when they are
first asked for. Nothing here needs Qt or a display.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.errors import AnnotationError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.fit import fitting
from procc_annotator.fit.result import FitResult
from procc_annotator.io.annotation_files.annotation_formats import find_annotations
from procc_annotator.io.annotation_files.exchange import Reading
from procc_annotator.io.source import open_source
from procc_annotator.metric.measure import measure
from procc_annotator.metric.score import FrameScore, score_to_read
from procc_annotator.metric.setup import EvaluationSetup

DEFAULT_SIZE = fitting.DEFAULT_SIZE


class _Strict(Reading):
    """Of a set a reader skips what is damaged; a caller who asks for one frame is to hear of it."""

    @contextmanager
    def going_on(self) -> Iterator[None]:
        yield


def load_annotation(path: str | Path, field: Field | None = None) -> FrameAnnotation:
    """Read what is annotated in one frame.

    Args:
        path: a file of any annotation format the program reads, or a folder or zip archive with
            one such file; it must hold exactly one frame.
        field: knows the official spellings of the classes; the soccer field if None.

    Returns:
        The polylines by class, in the order of the file. Points are normalised: (0, 0) is the
        centre of the picture's first pixel, (1, 1) that of its last one (pixel = u * (width - 1)).

    Raises:
        InputError: the file cannot be read; the message names it, the place and what was expected.
        UsageError: there is nothing at the path, no annotation, or more than one frame.
    """
    place = Path(path)
    reading = _Strict(field if field is not None else load_field())
    with open_source(place) as source:
        known, files = find_annotations(source)
        if known.read is None:
            raise UsageError(f"{place}: {known.title} cannot be read")
        frames = list(known.read(source, files, reading))
    if len(frames) == 1 and not reading.problems:
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
    field: Field | None = None,
    *,
    model: str = "R",
    size: tuple[int, int] = DEFAULT_SIZE,
    start: Camera | None = None,
) -> FitResult:
    """Fit a camera to annotated elements; no picture and no start is needed.

    A fit that cannot be is no error: ``camera`` is then None and ``failure`` says why.

    Args:
        annotation: what is annotated, points normalised.
        field: the elements, metres; the soccer field of 105 x 68 m if None.
        model: H (homography of the ground), P (pinhole, one focal length), R (P and one radial
            coefficient), R+ (R, aspect ratio and principal point), or auto (the simplest of P, R
            and R+ that the points support).
        size: (width, height) px of the picture the camera is for.
        start: a camera that is nearly right, px of ``size``.

    Returns:
        The camera in px of ``size``, with residuals (px) and standard deviations (rad, metres, px);
        see `procc_annotator.fit.fitting.fit_camera` and docs/fitting.md for how it is found.

    Raises:
        UsageError: no such model, or a size without pixels.
    """
    used = field if field is not None else load_field()
    return fitting.fit_camera(annotation, used, model=model, size=size, start=start)


def evaluate(
    annotation: FrameAnnotation,
    camera: Camera,
    *,
    field: Field | None = None,
    size: tuple[int, int] = DEFAULT_SIZE,
    tau: float = 5.0,
    protocol: str = "soccernet",
    allow_mirrored: bool = False,
    off_plane: str = "missed",
) -> FrameScore:
    """Score a camera: an annotated element passes if all its points are closer than tau to it.

    The protocol is that of Magera et al., A Universal Protocol to Benchmark Camera Calibration for
    Sports, CVsports 2024; ``soccernet`` follows the official evaluation in every count. See
    docs/metrics.md for every number.

    Args:
        annotation: what is annotated, points normalised.
        camera: anything that projects world points (metres) to pixels of ``size``.
        field: the elements, metres; the soccer field of 105 x 68 m if None.
        size: (width, height) px at which annotation and camera are compared.
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
        UsageError: no camera, an unknown protocol or choice, or a size without pixels.
    """
    if camera is None:
        raise UsageError("there is no camera to evaluate (a fit that failed says why in `failure`)")
    used = field if field is not None else load_field()
    setup = EvaluationSetup(used, size, protocol, allow_mirrored, off_plane)
    return score_to_read(measure(annotation, camera, setup), tau)
