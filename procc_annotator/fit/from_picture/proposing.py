"""A camera from one picture alone, without a click."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.fit.from_picture.climbing import Scene
from procc_annotator.fit.from_picture.deciding import Evidence, decide
from procc_annotator.fit.from_picture.field_lines import FieldLines, lines_of
from procc_annotator.fit.from_picture.hypotheses import anywhere, at_places
from procc_annotator.fit.from_picture.in_view import apart_px
from procc_annotator.fit.from_picture.proposal import NONE, KnownPosition, Proposal
from procc_annotator.fit.from_picture.searching import Found, judged, search
from procc_annotator.fit.from_picture.seen_paint import NearestPaint, SeenPaint, see_paint
from procc_annotator.fit.on_paint.refining import OnPaint, refine_on_paint
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.models import CENTRE, FREE, KAPPA, ROLL, camera_from_vector
from procc_annotator.fit.solving.solver import Prior
from procc_annotator.fit.solving.starts import wide_prior
from procc_annotator.image.pixels import PixelArray

_CELL_PX = 2
_FEWEST = 60  # places of paint
_REFINED, _REACHES_PX = 3, (8.0, 4.0, 4.0)
_OTHER_PX = 15.0  # farther apart, two cameras show something else
_ON_PAINT = 0.5  # of an element in sight, for it to be found
_LEAST_SD_M = 0.05


def _never_stop() -> None:
    """Nobody wants it stopped."""


def propose_camera(
    picture: PixelArray,
    field: Field,
    *,
    known: Sequence[KnownPosition] = (),
    go_on: Callable[[], None] = _never_stop,
) -> Proposal:
    """Find the camera of a picture from the paint on the ground.

    Args:
        picture: (H, W, 4) BGRA.
        field: the elements, metres.
        known: where its camera may be known to stand; none: anywhere the field's file allows.
        go_on: called between steps; what it raises ends the search.

    Returns:
        The camera and how sure it is; state ``none`` without one. Where a field looks the same
        from several sides it is the one on the main camera's.
    """
    size = (picture.shape[1], picture.shape[0])
    lines = lines_of(field)
    if lines is None:
        return _none(size, f"{field.title} has no painted lines to look for")
    paint = see_paint(picture, field)
    if len(paint.on_ground) < _FEWEST:
        return _none(size, "there is hardly any paint on the ground in this picture")
    go_on()
    best = max(
        (_best(picture, field, lines, paint, place, go_on) for place in known or (None,)),
        key=lambda found: found.score,
    )
    return best.proposal(paint)


@dataclass(frozen=True, eq=False)
class _Best:
    """The best camera of a search.

    Attributes:
        refined: on the paint.
        scene: what was searched.
        own: the camera alone, judged.
        others: cameras that show something else.
    """

    refined: OnPaint
    scene: Scene
    own: Found
    others: Found

    @property
    def score(self) -> float:
        return float(self.own.scores[0])

    def proposal(self, paint: SeenPaint) -> Proposal:
        """What is proposed."""
        other = self.others.scores[:1].tolist()
        margin = min(max(1 - other[0] / max(self.score, 1e-6), 0.0), 1.0) if other else 1.0
        coverage, explained = (
            float(of[0]) for of in (self.own.agreement.coverage, self.own.agreement.explained)
        )
        elements = sum(share >= _ON_PAINT for share in self.refined.shares.values())
        unlikeliness = float(self.scene.unlikeliness(self.own.vectors)[0])
        fit = self.refined.fit
        state, reason = decide(Evidence(fit, coverage, explained, margin, unlikeliness, elements))
        if state == NONE:
            return _none(paint.frame.size, reason)
        runner_up: PinholeCamera | None = None
        if other:
            runner_up = camera_from_vector(self.others.vectors[0], paint.frame)
        residual = self.refined.residual_px
        return Proposal(state, reason, fit, coverage, explained, residual, margin, runner_up)


def _best(
    picture: PixelArray,
    field: Field,
    lines: FieldLines,
    paint: SeenPaint,
    place: KnownPosition | None,
    go_on: Callable[[], None],
) -> _Best:
    prior = wide_prior(np.array([0]), lines.around, FREE["R"])
    near = NearestPaint.of(paint, _CELL_PX)
    half_height = float(round(paint.half_height))
    if place is None:
        hypotheses = anywhere(lines, half_height)
    else:
        prior = _prior_at(place, prior)
        x, y, z = place.position_m.tolist()
        hypotheses = at_places(lines, half_height, ((x, y, z),))
    scene = Scene(lines, paint, near, prior)
    found = search(scene, hypotheses, go_on)
    return _refined(picture, field, scene, found)


def _prior_at(place: KnownPosition, wide: Prior) -> Prior:
    mean, inverse = wide.mean.copy(), wide.inverse_sd.copy()
    mean[:, CENTRE] = place.position_m
    inverse[:, CENTRE] = 1 / np.maximum(np.sqrt(np.diag(place.covariance)), _LEAST_SD_M)
    if place.usual is not None:
        for index, (usual, sd) in ((ROLL, place.usual.roll), (KAPPA, place.usual.kappa)):
            mean[:, index], inverse[:, index] = usual, 1 / sd
    return Prior(mean, inverse)


def _refined(picture: PixelArray, field: Field, scene: Scene, found: Found) -> _Best:
    """The best of the first few once they are refined, each as good as it can be."""
    half_height = scene.paint.half_height
    tried = []
    for vector in found.vectors[:_REFINED]:
        refined = refine_on_paint(picture, field, vector, reaches_px=_REACHES_PX)
        if refined.fit.vector is not None:
            tried.append((refined, judged(scene, refined.fit.vector[None])))
    if not tried:
        refined = refine_on_paint(picture, field, found.vectors[0], reaches_px=_REACHES_PX)
        return _Best(refined, scene, found.chosen(np.array([0])), found.chosen(np.zeros(0, int)))
    refined, own = max(tried, key=lambda one: float(one[1].scores[0]))
    vectors = np.concatenate([*(one[1].vectors for one in tried), found.vectors])
    others = judged(scene, vectors)
    away = apart_px(own.vectors[0], vectors, scene.lines, half_height)
    rows = np.flatnonzero(away > _OTHER_PX)
    rows = rows[np.argsort(-others.scores[rows], kind="stable")]
    return _Best(refined, scene, own, others.chosen(rows))


def _none(size: tuple[int, int], reason: str) -> Proposal:
    fit = FitResult("R", size, None, reason)
    return Proposal(NONE, reason, fit, 0.0, 0.0, None, 0.0, None)
