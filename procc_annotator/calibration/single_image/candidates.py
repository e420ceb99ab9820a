"""Candidate cameras of one picture: searched, refined, ranked, with the evidence for the best."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.line_alignment.expected_lines import marking_points
from procc_annotator.calibration.line_alignment.gaussian_state import GaussianState
from procc_annotator.calibration.line_alignment.refinement import (
    POINT_SPACING_PX,
    LineAlignment,
    align_with_lines,
    displaced_elements_in_image,
)
from procc_annotator.calibration.optimization.camera_parameters import (
    FREE_PARAMETERS,
    KAPPA,
    PARAMETERS,
    POSITION_SLICE,
    ROLL,
    Y,
    rotated_180,
    vector_from_camera,
)
from procc_annotator.calibration.optimization.initialization import SIDES, prior_near
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.solver import GaussianPrior
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.field_points import (
    FieldLinePoints,
    field_line_points,
    view_distance_px,
    visible_line_points,
)
from procc_annotator.calibration.single_image.icp_refinement import (
    AGREEMENT_POINTS,
    AGREEMENT_PX,
    ImageLinePixels,
    SearchScene,
    chamfer_agreement,
    harmonic_mean,
)
from procc_annotator.calibration.single_image.probability import (
    ProposalEvidence,
)
from procc_annotator.calibration.single_image.proposal import (
    KnownPosition,
)
from procc_annotator.calibration.single_image.search import (
    SEARCH_STAGES,
    SEARCH_STAGES_KNOWN,
    SEARCH_STAGES_WIDE,
    RankedCameras,
    hypotheses_at_positions,
    hypotheses_on_side,
    search_cameras,
    with_hypothesis,
)
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray

_REFINED_COUNT, _SEARCH_RADII_PX = 7, (16.0, 8.0, 4.0)
_REFINEMENT_SCORE_SHARE = 0.7  # of the best one's score before any is refined
# Cameras that climb: of the main side, of each other one, at a known position.
_ICP_POINTS, _ICP_POINTS_RIVAL, _ICP_POINTS_KNOWN = 600, 450, 160
_WIDE_SEARCH = 4  # times as many, where none of these is right
_DISTINCT_CAMERA_PX = 15.0  # farther apart, two cameras show something else
_MIN_ALIGNED_COVERAGE = 0.5  # of an element in sight, for it to be found
_MIN_POSITION_SD_M = 0.05
_SD_POINTS, _UNKNOWN_SD_PX = 40, 1e3  # points; of those that a camera does not show
_MAX_MAHALANOBIS = 3.5  # beyond, the picture contradicts a known position (1 in 400 by chance)


_MAX_RIVAL_PRIOR_COST = 6.0  # no camera is expected there: 3.5 standard deviations


@dataclass(frozen=True, eq=False)
class RefinedCandidate:
    """A camera refined on the paint.

    Attributes:
        vector: (11,).
        refined: what it is fitted to.
        explained: share of the paint on the ground that it explains.
        explained_on_field: of that which it has on the field.
        unlikeliness: half the squared deviations from where cameras are expected.
    """

    vector: FloatArray
    refined: LineAlignment
    explained: float
    explained_on_field: float
    unlikeliness: float

    @property
    def score(self) -> float:
        both = float(harmonic_mean(self.refined.coverage, self.explained))
        return both - SEARCH_STAGES[-1].unlikely * self.unlikeliness


@dataclass(frozen=True, eq=False)
class BestCandidate:
    """The best candidate of a search.

    Attributes:
        other: (11,) the best of those that show something else; None without any.
        support: share of the search's last starts that ended at it, 0 to 1.
    """

    candidate: RefinedCandidate
    other: FloatArray | None
    other_score: float
    support: float

    @property
    def score(self) -> float:
        return self.candidate.score

    def evidence(self, picture: PixelArray, field: Field) -> ProposalEvidence:
        """The evidence for and against it in a picture (H, W, 4)."""
        best, refined = self.candidate, self.candidate.refined
        lines = field_line_points(field)
        assert lines is not None
        frame = ImageFrame(refined.fit.size)
        return ProposalEvidence(
            refined.coverage,
            best.explained_on_field,
            min(max(1 - self.other_score / max(self.score, 1e-6), 0.0), 1.0),
            refined.marks * POINT_SPACING_PX,
            sum(share >= _MIN_ALIGNED_COVERAGE for share in refined.shares.values()),
            self.support,
            best.unlikeliness,
            _projected_sd_px(refined.fit, best.vector, lines, frame),
            displaced_elements_in_image(picture, best.vector, marking_points(field), frame),
        )


def _projected_sd_px(
    fit: FitResult, vector: FloatArray, lines: FieldLinePoints, frame: ImageFrame
) -> float:
    """Standard deviation of where line points in sight appear, 90 % quantile, solver px."""
    half_height = half_height_px(frame.size)
    places = visible_line_points(vector[None], lines.coarsest, half_height, _SD_POINTS).places[0]
    sd = fit.projected_sd(lines.coarsest.world[:, places].T) * frame.scale
    return float(np.quantile(np.nan_to_num(sd, nan=_UNKNOWN_SD_PX), 0.9))


def best_candidate(
    picture: PixelArray,
    field: Field,
    lines: FieldLinePoints,
    paint: ImageLinePixels,
    *,
    known: Sequence[KnownPosition],
    elsewhere: bool,
    wide: bool,
    go_on: Callable[[], None],
) -> BestCandidate | None:
    """The best camera of a picture (H, W, 4) with square pixels, at known positions and elsewhere,
    ``wide`` from more starts; None if there is paint next to none."""

    def search(places: Sequence[KnownPosition | None]) -> BestCandidate | None:
        found = []
        for place in places:
            scene, cameras = search_scene(field, lines, paint, place, go_on, wide=wide)
            found.append(refine_candidates(picture, field, scene, cameras))
        there = [best for best in found if best is not None]
        return max(there, key=lambda best: best.score, default=None)

    at_known = search(known) if known else None
    return better_candidate(search((None,)), at_known, field, lines) if elsewhere else at_known


def search_scene(
    field: Field,
    lines: FieldLinePoints,
    paint: ImageLinePixels,
    place: KnownPosition | None,
    go_on: Callable[[], None],
    *,
    wide: bool = False,
) -> tuple[SearchScene, RankedCameras]:
    """The cameras that suit the line pixels of a picture best."""
    half_height = float(round(paint.half_height))
    if place is None:
        scene = SearchScene(lines, paint)
        stages, more = (SEARCH_STAGES_WIDE, _WIDE_SEARCH) if wide else (SEARCH_STAGES, 1)
        hypotheses = [
            (
                hypotheses_on_side(lines, half_height, side),
                more * (_ICP_POINTS if side == 0 else _ICP_POINTS_RIVAL),
            )
            for side in _allowed_sides(field)
        ]
    else:
        x, y, z = place.position_m.tolist()
        scene = SearchScene(lines, paint, _prior_at_position(place, lines))
        stages = SEARCH_STAGES_KNOWN
        hypotheses = [
            (hypotheses_at_positions(lines, half_height, ((x, y, z),)), _ICP_POINTS_KNOWN)
        ]
    found = search_cameras(scene, hypotheses, go_on, stages)
    if place is not None and place.camera is not None:
        found = with_hypothesis(scene, found, vector_from_camera(place.camera, paint.frame))
    if place is None and field.half_turn is not None:
        # Labels are those of a camera on the main side.
        vectors, ends = (
            np.where(some[:, [Y]] < 0, rotated_180(some), some)
            for some in (found.vectors, found.ends)
        )
        found = RankedCameras(vectors, found.scores, ends)
    return scene, found


def _allowed_sides(field: Field) -> tuple[int, ...]:
    """The sides of the field that cameras may stand on; one of two from which it looks the same."""
    names = ("near", "right") if field.half_turn is not None else ("near", "far", "left", "right")
    return tuple(SIDES.index(name) for name in names)


def _prior_at_position(place: KnownPosition, lines: FieldLinePoints) -> GaussianPrior:
    vector = np.zeros(len(PARAMETERS))
    vector[POSITION_SLICE] = place.position_m
    wide = prior_near(vector, lines.around, FREE_PARAMETERS["R"])
    mean, inverse = wide.mean.copy(), wide.inverse_sd.copy()
    mean[:, POSITION_SLICE] = place.position_m
    inverse[:, POSITION_SLICE] = 1 / np.maximum(
        np.sqrt(np.diag(place.covariance)), _MIN_POSITION_SD_M
    )
    if place.usual is not None:
        for index, (usual, sd) in ((ROLL, place.usual.roll), (KAPPA, place.usual.kappa)):
            mean[:, index], inverse[:, index] = usual, 1 / sd
    return GaussianPrior(mean, inverse)


def refine_candidates(
    picture: PixelArray,
    field: Field,
    scene: SearchScene,
    found: RankedCameras,
) -> BestCandidate | None:
    """The best of some cameras, of the first ones those refined that come near the best; None if
    there is paint next to none."""
    tried: list[LineAlignment] = []
    kept: list[tuple[FloatArray, float]] = []
    for vector, score in zip(found.vectors[:_REFINED_COUNT], found.scores, strict=False):
        if score < _REFINEMENT_SCORE_SHARE * found.scores[0] and tried:
            kept.append((vector, float(score)))
            continue
        prior = scene.prior(vector[None], FREE_PARAMETERS["R"])
        belief = GaussianState(_prior_mean(prior), np.diag(prior.inverse_sd[0] ** 2))
        refined = align_with_lines(
            picture, field, vector, belief=belief, reaches_px=_SEARCH_RADII_PX
        )
        if refined.fit.vector is not None:
            tried.append(refined)
    if not tried:
        return None
    candidates = _rank_candidates(scene, tried)
    best = candidates[0]
    plausible = [one for one in candidates if one.unlikeliness <= _MAX_RIVAL_PRIOR_COST]
    others = [*((one.vector, one.score) for one in (best, *plausible)), *kept]
    away = _distance_px(best.vector, np.array([v for v, _ in others]), scene, field)
    apart = [other for other, px in zip(others, away, strict=True) if px > _DISTINCT_CAMERA_PX]
    vector, score = max(apart, key=lambda other: other[1], default=(None, 0.0))
    ends = _distance_px(best.vector, found.ends, scene, field)
    return BestCandidate(best, vector, score, float((ends <= _DISTINCT_CAMERA_PX).mean()))


def _distance_px(
    vector: FloatArray, others: FloatArray, scene: SearchScene, field: Field
) -> FloatArray:
    """(B,) solver px between what a camera (11,) and others (B, 11) show; from the other side, too,
    of a field that looks the same from there."""
    half_height = scene.paint.half_height
    away = view_distance_px(vector, others, scene.lines, half_height)
    if field.half_turn is None:
        return away
    turned = view_distance_px(vector, rotated_180(others), scene.lines, half_height)
    return np.minimum(away, turned)


def _rank_candidates(scene: SearchScene, tried: Sequence[LineAlignment]) -> list[RefinedCandidate]:
    """Refined cameras, the best first."""
    final = np.array([refined.fit.vector for refined in tried])
    judged = chamfer_agreement(scene, final, AGREEMENT_PX, places=1, paint=AGREEMENT_POINTS)
    unlikeliness = scene.unlikeliness(final)
    candidates = [
        RefinedCandidate(
            vector, refined, float(explained), float(explained / max(on, 1e-9)), float(unlikely)
        )
        for vector, refined, explained, on, unlikely in zip(
            final, tried, judged.explained, judged.on_field, unlikeliness, strict=True
        )
    ]
    return sorted(candidates, key=lambda one: -one.score)


def _prior_mean(prior: GaussianPrior) -> FloatArray:
    return np.concatenate([prior.mean[0], np.zeros(len(PARAMETERS) - prior.mean.shape[1])])


def better_candidate(
    free: BestCandidate | None,
    at_known: BestCandidate | None,
    field: Field,
    lines: FieldLinePoints,
) -> BestCandidate | None:
    """Return the better of the cameras found anywhere and at known positions.

    One that shows the same is taken from the known position unless the picture contradicts that
    position; of two that show something else the one that agrees better with the line pixels. A
    free camera that is better is as sure as it is without any known position.
    """
    if free is None or at_known is None:
        return free or at_known
    views = free.candidate.vector[None]
    if field.half_turn is not None:  # the position tells the side, the picture does not
        views = np.concatenate([views, rotated_180(views)])
    known = at_known.candidate
    half_height = half_height_px(known.refined.fit.size)
    away = view_distance_px(known.vector, views, lines, half_height)
    if away.min() <= _DISTINCT_CAMERA_PX:
        agree = _positions_agree(
            free.candidate.refined.fit, views[away.argmin()], known.refined.fit
        )
        return at_known if agree else free
    if free.score >= at_known.score:
        return free
    if free.score <= at_known.other_score:
        return at_known
    return replace(at_known, other=free.candidate.vector, other_score=free.score)


def _positions_agree(free: FitResult, vector: FloatArray, at_known: FitResult) -> bool:
    """Return whether the position that a picture alone gives, seen from the side of ``vector``,
    agrees with the known one within the uncertainty of both."""
    assert free.vector is not None
    assert free.covariance is not None
    assert at_known.vector is not None
    assert at_known.covariance is not None
    turned = np.where(vector[POSITION_SLICE] == free.vector[POSITION_SLICE], 1.0, -1.0)
    spread = free.covariance[POSITION_SLICE, POSITION_SLICE] * np.outer(turned, turned)
    away = vector[POSITION_SLICE] - at_known.vector[POSITION_SLICE]
    spread = spread + at_known.covariance[POSITION_SLICE, POSITION_SLICE]
    return bool(away @ np.linalg.solve(spread, away) <= _MAX_MAHALANOBIS**2)


def half_height_px(size: tuple[int, int]) -> float:
    frame = ImageFrame(size)
    return float(round(frame.size[1] * frame.scale / 2))
