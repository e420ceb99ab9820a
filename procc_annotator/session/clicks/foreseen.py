"""Ghosts from a camera that was found without clicks, judged together with the clicks."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.predict.ghosts import MAX_SD_PX, find_ghosts
from procc_annotator.fit.result import FitResult
from procc_annotator.metric.measure import measure
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.clicks.insight import FrameAnalysis

_MOST_APART = 0.015  # of the width, in the middle of an element's points
# Clicks agree with a camera within two standard deviations of the least certain ghost offered.
_AGREES = 2 * MAX_SD_PX / 960
_CONTRADICTED = "the clicks lie elsewhere than the proposed camera shows them"


def ghosts_without_clicks(
    annotation: FrameAnnotation,
    field: Field,
    fit: FitResult,
    not_visible: frozenset[str] = frozenset(),
    fitted: FrameAnalysis | None = None,
    *,
    go_on: Callable[[], None] = lambda: None,
) -> FrameAnalysis:
    """Find the ghosts of a camera; none of one that the clicks contradict. Safe from any thread.

    Args:
        annotation: of the frame.
        field: its elements.
        fit: the camera, found in the picture or by following the shot.
        not_visible: classes somebody said are not to be seen here.
        fitted: what follows from the clicks alone. It is returned once the clicks give a camera,
            unless they agree with the camera that was found, and that one knows more elements.
        go_on: called between the steps; raises whatever it likes when nobody wants the rest.
    """
    go_on()
    by_clicks = fitted if fitted is not None and fitted.fit.camera is not None else None
    if contradicts(annotation, field, fit, _MOST_APART if by_clicks is None else _AGREES):
        if by_clicks is not None:
            return by_clicks
        none = FitResult(fit.model, fit.size, None, _CONTRADICTED)
        return FrameAnalysis(annotation, none, from_clicks=False)
    go_on()
    ghosts = find_ghosts(annotation, field, fit, without=not_visible)
    if by_clicks is not None and len(ghosts) <= len(by_clicks.ghosts):
        return by_clicks
    return FrameAnalysis(annotation, fit, ghosts, from_clicks=False)


def contradicts(
    annotation: FrameAnnotation, field: Field, fit: FitResult, most_apart: float = _MOST_APART
) -> bool:
    """Return whether an annotated element lies elsewhere than a camera shows it: the median of its
    points farther than ``most_apart`` picture widths."""
    if fit.camera is None:
        return False
    found = measure(annotation, fit.camera, EvaluationSetup(field, size=fit.size)).plain
    most = most_apart * fit.size[0]
    for row, distances in zip(found.rows, found.distances, strict=True):
        if row >= 0 and (distances is None or not np.median(distances) <= most):
            return True
    return False
