"""Fits in which every element has its say, whatever it is off: they tell what a label does."""

from __future__ import annotations

from collections.abc import Collection
from functools import partial

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.solving.models import FREE, KAPPA
from procc_annotator.fit.solving.noise import softened
from procc_annotator.fit.solving.observations import FloatArray, Frame, observe
from procc_annotator.fit.solving.residual import linear_map, pinhole_residuals
from procc_annotator.fit.solving.solver import FINAL_LOSS, Loss, Problem, solve
from procc_annotator.fit.solving.starts import prior_near
from procc_annotator.fit.solving.surroundings import surroundings_of

# A mistake pulls the camera as far as it can.
SQUARED = Loss("squared", 1.0)
# Points that lie a little beside their element do not: as in the last step of `fit_camera`.
HUBER = FINAL_LOSS
_ITERATIONS = 30


def refit(
    annotation: FrameAnnotation,
    field: Field,
    frame: Frame,
    vector: FloatArray,
    model: str,
    *,
    loss: Loss = HUBER,
    without: Collection[str] = (),
) -> dict[str, float]:
    """Fit a pinhole from a camera that is nearly right; nothing is taken for a mistake.

    Args:
        annotation: normalised points.
        field: the elements.
        frame: the picture.
        vector: (11,) where to begin.
        model: P, R or R+.
        loss: of a point's distance.
        without: classes that have no say; their distances are given all the same.

    Returns:
        Class -> the largest distance of its points, solver px, as it counts; nothing without usable
        points.
    """
    seen = observe(annotation, field, frame)
    if seen is None:
        return {}
    seen = softened(seen, linear_map(vector))
    names = [element.name for element in seen.elements]
    used = seen.leaving_out(np.array([name in without for name in names]))
    around = surroundings_of(field)
    residuals = partial(
        pinhole_residuals, seen=used, half_diagonal=frame.half_diagonal, free=FREE[model]
    )
    prior = prior_near(vector, around, FREE[model])
    problem = Problem(residuals, used.weights, loss, prior, bounded=KAPPA)
    # A mistake at the other end of the field may send a step anywhere; it is not taken then.
    with np.errstate(over="ignore", invalid="ignore"):
        found = solve(problem, vector[None].copy(), iterations=_ITERATIONS)
    worst = seen.worst_of_element(found.distances[0])
    return dict(zip(names, worst.tolist(), strict=True))


def others_with_and_without(
    annotation: FrameAnnotation,
    wrong: Collection[str],
    field: Field,
    frame: Frame,
    vector: FloatArray,
    model: str,
) -> tuple[float, float] | None:
    """Leave-one-out: how far the other elements are off when all count, and without some.

    Both fits are plain least squares: a robust fit would hardly notice the mistake.

    Args:
        annotation: normalised points.
        wrong: the classes in question.
        field: the elements.
        frame: the picture.
        vector: (11,) the camera without the mistakes, where both fits begin.
        model: P, R or R+.

    Returns:
        Mean over the other elements of each one's largest distance, solver px, with and without
        ``wrong``; None where nothing else is left.
    """
    means = []
    for without in ((), wrong):
        found = refit(annotation, field, frame, vector, model, loss=SQUARED, without=without)
        others = [distance for name, distance in found.items() if name not in wrong]
        if not others:
            return None
        means.append(sum(others) / len(others))
    return means[0], means[1]
