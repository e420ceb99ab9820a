"""Check the labels of a frame, with a fitted camera and without one."""

from __future__ import annotations

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.labels.finding import Finding, Remedy, RemedyKind, Rule, Severity
from procc_annotator.fit.result import FitResult


def check_labels(
    annotation: FrameAnnotation, field: Field, *, size: tuple[int, int], fit: FitResult
) -> tuple[Finding, ...]:
    """What may be wrong with a frame's labels, the surest first.

    Args:
        annotation: normalised points; unconfirmed elements take no part.
        field: the elements.
        size: (width, height) px of the picture.
        fit: the camera fitted to this annotation, or its failure.
    """
    return tuple(
        Finding(
            Rule.RESIDUAL,
            Severity.ERROR,
            (element.name,),
            f"{field.title_of(element.name)} is {element.max_px:.0f} px off where the camera of the"
            " other elements shows it",
            (Remedy(RemedyKind.LOOK, "look at it"),),
            error_px=element.max_px,
        )
        for element in fit.elements
        if element.left_out and annotation.get(element.name) is not None
    )
