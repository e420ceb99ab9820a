"""Each annotated element left out in turn, and judged by the camera of the others."""

from __future__ import annotations

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.fit.determined import ill_conditioned_reason
from procc_annotator.fit.fitting import fit_camera
from procc_annotator.fit.result import FitResult
from procc_annotator.io.camera_files.held_out_table import LeftOutElement
from procc_annotator.metric.measure import Measurement, measure
from procc_annotator.metric.setup import EvaluationSetup


def leave_one_out(
    annotation: FrameAnnotation, fit: FitResult, setup: EvaluationSetup, model: str
) -> tuple[LeftOutElement, ...]:
    """The elements of a frame that the others predict, fitted without a start.

    An element counts if the others determine a camera (`ill_conditioned_reason` says nothing of it);
    what has no place on the field is none.

    Args:
        annotation: what was fitted.
        fit: to all of it.
        setup: of the frame, at the size of the fit.
        model: as it was asked for.
    """
    if fit.camera is None:
        return ()
    whole = measure(annotation, fit.camera, setup)
    found = []
    for name, element in zip(whole.plain.annotated_names, whole.plain.rows, strict=True):
        if element < 0:
            continue
        rest = fit_camera(annotation.without(name), setup.field, model=model, size=fit.size)
        if rest.camera is None or ill_conditioned_reason(rest):
            continue
        predicted = _worst(measure(annotation, rest.camera, setup), name)
        found.append(LeftOutElement(name, predicted, _worst(whole, name)))
    return tuple(found)


def _worst(measurement: Measurement, name: str) -> float | None:
    plain = measurement.plain
    if name not in plain.annotated_names:
        return None
    distances = plain.distances[plain.annotated_names.index(name)]
    return None if distances is None else float(distances.max())
