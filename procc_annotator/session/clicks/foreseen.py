"""What a camera that was found without clicks tells of a frame: the elements that are missing."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.predict.ghosts import find_ghosts
from procc_annotator.fit.result import FitResult
from procc_annotator.metric.measure import measure
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.clicks.insight import Insight

_MOST_APART = 0.015  # of the width, in the middle of an element's points
_CONTRADICTED = "the clicks lie elsewhere than the proposed camera shows them"


def foresee(
    annotation: FrameAnnotation,
    field: Field,
    fit: FitResult,
    not_visible: frozenset[str] = frozenset(),
    *,
    go_on: Callable[[], None] = lambda: None,
) -> Insight:
    """The ghosts of a camera; none of one that the clicks contradict. Safe from any thread.

    Args:
        annotation: of the frame, if only a few elements that fit no camera by themselves.
        field: its elements.
        fit: the camera, found in the picture or by following the shot.
        not_visible: classes somebody said are not to be seen here.
        go_on: called between the steps; raises whatever it likes when nobody wants the rest.
    """
    go_on()
    if contradicts(annotation, field, fit):
        none = FitResult(fit.model, fit.size, None, _CONTRADICTED)
        return Insight(annotation, none, from_clicks=False)
    go_on()
    ghosts = find_ghosts(annotation, field, fit, without=not_visible)
    return Insight(annotation, fit, ghosts, from_clicks=False)


def contradicts(annotation: FrameAnnotation, field: Field, fit: FitResult) -> bool:
    """Whether an annotated element lies elsewhere than a camera shows it."""
    if fit.camera is None:
        return False
    found = measure(annotation, fit.camera, EvaluationSetup(field, size=fit.size)).plain
    most = _MOST_APART * fit.size[0]
    for row, distances in zip(found.rows, found.distances, strict=True):
        if row >= 0 and (distances is None or not np.median(distances) <= most):
            return True
    return False
