"""Check the labels of one frame."""

from __future__ import annotations

from pathlib import Path

from procc_annotator.annotation import FrameAnnotation, as_size
from procc_annotator.api.inputs import as_annotation, as_field, as_picture
from procc_annotator.calibration import fitting
from procc_annotator.calibration.fitting import DEFAULT_SIZE
from procc_annotator.calibration.label_check.check import add_line_evidence
from procc_annotator.calibration.label_check.check import check_labels as findings_of
from procc_annotator.calibration.label_check.finding import Finding
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray


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
        annotation: what is annotated, points normalised.
        field: the elements, metres; or a field's name, see `load_field`; the usual one if None.
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
