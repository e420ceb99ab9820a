"""Check the labels of a frame, with a fitted camera and without one."""

from __future__ import annotations

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.labels.finding import Finding, Severity
from procc_annotator.fit.labels.mistakes import mistakes, suspects_of
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.observations import Frame
from procc_annotator.fit.solving.search import MINIMUM_ELEMENTS

_ORDER = {severity: rank for rank, severity in enumerate(Severity)}


def check_labels(
    annotation: FrameAnnotation, field: Field, *, size: tuple[int, int], fit: FitResult
) -> tuple[Finding, ...]:
    """What may be wrong with a frame's labels, the surest first.

    Costs a few milliseconds where nothing is wrong, up to some 0.3 s where the camera does not fit.

    Args:
        annotation: normalised points; unconfirmed elements take no part.
        field: the elements.
        size: (width, height) px of the picture.
        fit: the camera fitted to this annotation, or its failure.
    """
    frame = Frame(size)
    found: list[Finding] = []
    known = [name for name in annotation.annotated if field.element(name) is not None]
    if len(known) >= MINIMUM_ELEMENTS and (fit.camera is None or suspects_of(fit, frame)):
        found.extend(mistakes(annotation, field, frame, fit))
    return tuple(sorted(found, key=lambda f: (_ORDER[f.severity], -(f.error_px or 0.0))))
