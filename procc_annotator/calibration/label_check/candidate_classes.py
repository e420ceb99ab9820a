"""Classes whose elements are close to a polyline under a camera; leave-one-element-out refits."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache, partial

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.label_check.evidence import FITS_PX, SUSPECT_LIMIT_PX
from procc_annotator.calibration.optimization.camera_parameters import (
    FREE_PARAMETERS,
    lower_bounded_parameter,
)
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.optimization.initialization import prior_near
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.residuals import (
    linear_map,
    pinhole_residuals,
    projected_spot_covariance,
    whitened,
)
from procc_annotator.calibration.optimization.solver import FINAL_LOSS, Problem, RobustLoss, solve
from procc_annotator.field.geometry import Arc, Chain, Geometry, Line, Spot, Vector, same_geometry
from procc_annotator.field.landmarks import landmark_covariances
from procc_annotator.field.model import Element, Field
from procc_annotator.translation import translatable

# Two or three points along a straight line lie on many a curve as well.
_MIN_CURVE_POINTS = 4


@dataclass(frozen=True, slots=True)
class CandidateClass:
    """Mean distance of one polyline's points to one class, solver px."""

    class_name: str
    mean_px: float


def distances_to_classes(
    polyline: Polyline,
    names: Iterable[str],
    field: Field,
    frame: ImageFrame,
    vector: FloatArray,
    *,
    as_counted: bool = False,
) -> dict[str, FloatArray]:
    """Distances (n,), solver px, of a polyline's n distinct points to each class of the field as a
    camera (11,) shows it; empty without a usable point. With ``as_counted`` those to landmarks that
    are not known exactly count less, as in a fit."""
    disguised = FrameAnnotation(tuple(Polyline(name, polyline.points) for name in names))
    seen = build_observations(disguised, field, frame)
    if seen is None:
        return {}
    if as_counted:
        seen = whitened(seen, linear_map(vector))
    found = pinhole_residuals(
        vector[None], seen, frame.half_diagonal, FREE_PARAMETERS["P"]
    ).distances[0]
    parts = dict(zip(seen.elements, np.split(found, seen.starts[1:]), strict=True))
    return {element.name: part for element, part in parts.items()}


def candidate_classes(
    polyline: Polyline,
    field: Field,
    frame: ImageFrame,
    vector: FloatArray,
    within_px: float = FITS_PX,
) -> tuple[CandidateClass, ...]:
    """The classes that all points of a polyline are near enough to, the nearest first.

    Its own class is among them if it fits. A curve is offered for what was drawn as something else
    only where there are points enough to say; a spot for a single point and for what was clicked
    as one; and nothing but spots for a single point clicked as one.
    """
    own, count = field.element(polyline.class_name), len(polyline.points)
    names = [e.name for e in field.elements if _is_possible_class(e, own, count)]
    distances = distances_to_classes(polyline, names, field, frame, vector)
    near = [
        CandidateClass(name, float(d.mean()))
        for name, d in distances.items()
        if d.max() <= within_px
    ]
    return tuple(sorted(near, key=lambda place: place.mean_px))


def _is_possible_class(element: Element, own: Element | None, count: int) -> bool:
    """Return whether so many points that were clicked as ``own`` may be those of another
    element."""
    was_spot = own is not None and own.is_spot
    if element.is_spot:
        return was_spot or count == 1
    if was_spot and count == 1:
        return False
    was_curved = own is not None and own.is_curved
    return element.is_straight or was_curved or count >= _MIN_CURVE_POINTS


def farthest_point(
    polyline: Polyline, field: Field, frame: ImageFrame, vector: FloatArray
) -> tuple[int, float, float] | None:
    """The index of the point of a polyline that is farthest from its element, its distance, and the
    largest distance of the other points (0 without others), solver px as they count; None for a
    polyline without usable points."""
    known = [i for i, p in enumerate(polyline.points) if np.isfinite((p.u, p.v)).all()]
    name = polyline.class_name
    alone = (Polyline(name, (polyline.points[i],)) for i in known)
    found = [
        distances_to_classes(one, [name], field, frame, vector, as_counted=True) for one in alone
    ]
    each = [float(d[name][0]) for d in found if d]
    if not each:
        return None
    order = np.argsort(each)
    worst = int(order[-1])
    rest = each[int(order[-2])] if len(each) > 1 else 0.0
    return known[worst], each[worst], rest


def uncertain_landmarks(field: Field, vector: FloatArray) -> frozenset[str]:
    """Landmarks that a camera (11,) may show anywhere within more than what a label is judged by:
    that they fit says nothing for it."""
    spreads = landmark_covariances(field)
    marks = [e for e in field.elements if e.name in spreads and isinstance(e.geometry, Spot)]
    if not marks:
        return frozenset()
    spots = np.array([e.geometry.position for e in marks if isinstance(e.geometry, Spot)]).T
    known = np.array([spreads[e.name] for e in marks])
    variances = np.linalg.eigvalsh(projected_spot_covariance(spots, known, linear_map(vector)))[
        :, -1
    ]
    vague = variances > SUSPECT_LIMIT_PX**2
    return frozenset(e.name for e, far in zip(marks, vague, strict=True) if far)


# A mistake pulls the camera as far as it can.
SQUARED_LOSS = RobustLoss("squared", 1.0)
# Points that lie a little next to their element do not: as in the last step of `fit_camera`.
HUBER_LOSS = FINAL_LOSS
_ITERATIONS = 30


def refit_all_points(
    annotation: FrameAnnotation,
    field: Field,
    frame: ImageFrame,
    vector: FloatArray,
    model: str,
    *,
    loss: RobustLoss = HUBER_LOSS,
    without: Collection[str] = (),
) -> dict[str, float]:
    """Fit a pinhole P, R or R+ from a camera (11,) that is nearly right; nothing is taken for a
    mistake.

    Args:
        without: classes that have no say; their distances are given all the same.

    Returns:
        Class -> the largest distance of its points, solver px, as it counts; nothing without usable
        points.
    """
    seen = build_observations(annotation, field, frame)
    if seen is None:
        return {}
    seen = whitened(seen, linear_map(vector))
    names = [element.name for element in seen.elements]
    used = seen.with_excluded(np.array([name in without for name in names]))
    around = camera_placement_prior(field)
    residuals = partial(
        pinhole_residuals, seen=used, half_diagonal=frame.half_diagonal, free=FREE_PARAMETERS[model]
    )
    prior = prior_near(vector, around, FREE_PARAMETERS[model])
    problem = Problem(residuals, used.weights, loss, prior, bounded=lower_bounded_parameter(vector))
    # A mistake at the other end of the field may send a step anywhere; it is not taken then.
    with np.errstate(over="ignore", invalid="ignore"):
        found = solve(problem, vector[None].copy(), iterations=_ITERATIONS)
    worst = seen.max_per_element(found.distances[0])
    return dict(zip(names, worst.tolist(), strict=True))


def leave_one_out_errors(
    annotation: FrameAnnotation,
    wrong: Collection[str],
    field: Field,
    frame: ImageFrame,
    vector: FloatArray,
    model: str,
) -> tuple[float, float] | None:
    """Leave-one-out: mean over the other elements of each one's largest distance, solver px, with
    and without those that are ``wrong``; None where nothing else is left.

    Both fits are plain least squares from the camera (11,) without the mistakes: a robust fit would
    hardly notice them.
    """
    means = []
    for without in ((), wrong):
        found = refit_all_points(
            annotation, field, frame, vector, model, loss=SQUARED_LOSS, without=without
        )
        others = [distance for name, distance in found.items() if name not in wrong]
        if not others:
            return None
        means.append(sum(others) / len(others))
    return means[0], means[1]


_SAME_PLACE_M = 0.01


MIRROR_X = (-1.0, 1.0)  # left for right


MIRROR_Y = (1.0, -1.0)  # top for bottom


MIRROR_REMEDY_TEXTS = {  # the remedies
    MIRROR_Y: translatable("exchange far and near in the whole frame"),
    MIRROR_X: translatable("exchange left and right in the whole frame"),
}


def mirrored_names(
    field: Field, signs: tuple[float, float], needed: Iterable[str] = ()
) -> Mapping[str, str] | None:
    """The class that each class becomes when the field is reflected.

    A frame may be labelled top for bottom or left for right. Reflecting twice, across and along, is
    half a turn: of a field that half a turn takes to itself the two reflections are one mistake. A
    field without symmetry has no reflection either.

    Args:
        signs: factors of x and y: `ALONG` or `MIRROR_Y`.
        needed: classes that must become one.

    Returns:
        None where one of those becomes none: what is given by its place on one side only (a mark
        before the team benches, a landmark) cannot have been taken for its own reflection.
    """
    found = _mirrored_elements(field.elements, signs)
    return found if all(name in found for name in needed) else None


@lru_cache(maxsize=16)
def _mirrored_elements(elements: tuple[Element, ...], signs: tuple[float, float]) -> dict[str, str]:
    free = list(elements)
    found: dict[str, str] = {}
    for element in elements:
        there = _mirrored_geometry(element.geometry, signs)
        twin = next((e for e in free if same_geometry(e.geometry, there, _SAME_PLACE_M)), None)
        if twin is not None:
            free.remove(twin)
            found[element.name] = twin.name
    return found


def _mirrored_geometry(shape: Geometry, signs: tuple[float, float]) -> Geometry:
    if isinstance(shape, Line):
        return Line(_mirrored_point(shape.start, signs), _mirrored_point(shape.end, signs))
    if isinstance(shape, Spot):
        return Spot(_mirrored_point(shape.position, signs))
    if isinstance(shape, Chain):
        parts = (_mirrored_geometry(part, signs) for part in shape.parts)
        return Chain(tuple(part for part in parts if isinstance(part, Line | Arc)))
    places = (shape.centre, shape.ahead, shape.aside)
    centre, ahead, aside = (_mirrored_point(place, signs) for place in places)
    return replace(shape, centre=centre, ahead=ahead, aside=aside)


def _mirrored_point(place: Vector, signs: tuple[float, float]) -> Vector:
    return signs[0] * place[0], signs[1] * place[1], place[2]


def relabelled(annotation: FrameAnnotation, names: Mapping[str, str]) -> FrameAnnotation:
    """An annotation with classes exchanged, all at once; unconfirmed elements are dropped."""
    return FrameAnnotation(
        tuple(
            Polyline(names.get(p.class_name, p.class_name), p.points) for p in annotation.polylines
        )
    )
