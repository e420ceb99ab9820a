"""Propose a camera from one image, and classify the proposal as sure, unsure or none."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.line_alignment.expected_lines import marking_points
from procc_annotator.calibration.line_alignment.gaussian_state import GaussianState
from procc_annotator.calibration.line_alignment.refinement import (
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
    camera_from_vector,
    rotated_180,
)
from procc_annotator.calibration.optimization.initialization import SIDES, prior_near
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.solver import GaussianPrior
from procc_annotator.calibration.result import FitResult, ill_conditioned_reason
from procc_annotator.calibration.single_image.field_points import (
    FieldLinePoints,
    field_line_points,
    view_distance_px,
)
from procc_annotator.calibration.single_image.icp_refinement import (
    ImageLinePixels,
    SearchScene,
    chamfer_agreement,
    harmonic_mean,
    line_pixels_for_field,
)
from procc_annotator.calibration.single_image.proposal import (
    NONE,
    SURE,
    UNSURE,
    KnownPosition,
    Proposal,
    ProposalState,
)
from procc_annotator.calibration.single_image.search import (
    SEARCH_STAGES,
    SEARCH_STAGES_KNOWN,
    hypotheses_at_positions,
    hypotheses_on_side,
    search_cameras,
)
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import translatable, translatable_joined

# Below, what was found is no camera of this picture.
_MIN_HARMONIC_SCORE = 0.4
SURE_MIN_COVERAGE, SURE_MIN_EXPLAINED, _SURE_MIN_MARGIN = 0.65, 0.8, 0.18
_CLEAR_COVERAGE, CLEAR_MARGIN = 0.85, 0.1  # where more is found, less has to part it from others
_MAX_PRIOR_COST = 6.0
# Longer by shorter side of the narrowest pictures that cameras make (5:4). In a squeezed picture
# another position and zoom agree with the lines as well as the true ones do with square pixels.
_MIN_VIEW_FACTOR = 1.25
# So many elements give a camera; one less, such as a circle and two lines, where all is found.
_SURE_MIN_ELEMENTS, _ALL_FOUND_SHARE = 4, 0.9


@dataclass(frozen=True, eq=False)
class ProposalEvidence:
    """Evidence for and against a camera.

    Attributes:
        fit: the camera.
        coverage, explained: see `Proposal`.
        margin: see `Proposal`.
        unlikeliness: half the squared deviations from where cameras are expected.
        elements: how many of the field were found on paint.
        beside: which lie next to their paint, in words; "" for none.
    """

    fit: FitResult
    coverage: float
    explained: float
    margin: float
    unlikeliness: float
    elements: int
    beside: str = ""


def rival_camera_reason() -> str:
    """The reason for a camera that is not sure because of another one."""
    return translatable("another camera that shows other lines suits the picture nearly as well")


def classify_proposal(seen: ProposalEvidence) -> tuple[ProposalState, str]:
    """Return whether a camera is sure, unsure or none, and why, in a sentence."""
    shares = translatable(
        "{lines:.0f} % of the lines in sight lie on paint, which explains {paint:.0f} % of the"
        " paint on the ground",
        lines=100 * seen.coverage,
        paint=100 * seen.explained,
    )
    if seen.fit.camera is None:
        return NONE, seen.fit.failure or ""
    if harmonic_mean(seen.coverage, seen.explained) < _MIN_HARMONIC_SCORE:
        return NONE, translatable(
            "no camera suits the paint in this picture: of the best one {shares}", shares=shares
        )
    doubt = _doubt_reason(seen)
    return (
        (UNSURE, translatable_joined("", (doubt, " (", shares, ")"))) if doubt else (SURE, shares)
    )


def _doubt_reason(seen: ProposalEvidence) -> str:
    share = min(seen.coverage, seen.explained)
    if max(seen.fit.size) < _MIN_VIEW_FACTOR * min(seen.fit.size):  # phones stand upright
        return translatable(
            "the picture is nearly square, as a squeezed one is: its pixels may not be square"
        )
    if seen.margin < (_SURE_MIN_MARGIN if share < _CLEAR_COVERAGE else CLEAR_MARGIN):
        return rival_camera_reason()
    if seen.coverage < SURE_MIN_COVERAGE:
        return translatable("lines are missing that should be in sight")
    if seen.explained < SURE_MIN_EXPLAINED:
        return translatable("there is paint where the field has none")
    if seen.unlikeliness > _MAX_PRIOR_COST:
        return translatable("cameras hardly stand there")
    if seen.elements < _SURE_MIN_ELEMENTS - (share >= _ALL_FOUND_SHARE):
        return translatable("too few lines are in sight to tell")
    if seen.beside:
        return seen.beside
    open_ = ill_conditioned_reason(seen.fit)
    return (
        translatable("the lines in sight leave the camera open: {what}", what=open_)
        if open_
        else ""
    )


_MIN_LINE_PIXELS = 60  # places of paint
_REFINED_COUNT, _SEARCH_RADII_PX = 7, (16.0, 8.0, 4.0)
_REFINEMENT_SCORE_SHARE = 0.7  # of the best one's score before any is refined
# Cameras that climb: of the main side, of each other one, at a known position.
_ICP_POINTS, _ICP_POINTS_RIVAL, _ICP_POINTS_KNOWN = 600, 450, 160
_AGREEMENT_PX, _AGREEMENT_POINTS = 3.0, 800
_DISTINCT_CAMERA_PX = 15.0  # farther apart, two cameras show something else
_MIN_ALIGNED_COVERAGE = 0.5  # of an element in sight, for it to be found
_MIN_POSITION_SD_M = 0.05
_MAX_MAHALANOBIS = 3.5  # beyond, the picture contradicts a known position (1 in 400 by chance)


def propose_camera(
    picture: PixelArray,
    field: Field,
    *,
    known: Sequence[KnownPosition] = (),
    elsewhere: bool = True,
    go_on: Callable[[], None] = lambda: None,
) -> Proposal:
    """Find the camera of a picture from the paint on the ground.

    Args:
        picture: (H, W, 4) BGRA.
        field: the elements, metres.
        known: where its camera may be known to stand: more hypotheses, which replace the camera
            found without them only by a better one, and a sure one only by a sure one.
        elsewhere: also search all positions that the field's file allows; always without ``known``.
        go_on: called between steps; what it raises ends the search.

    Returns:
        The camera and how sure it is; state ``none`` without one. Where a field looks the same
        from several sides it is the one on the main camera's.
    """
    size = (picture.shape[1], picture.shape[0])
    lines = field_line_points(field)
    if lines is None:
        return _no_proposal(size, f"{field.title} has no painted lines to look for")
    paint = line_pixels_for_field(picture, field)
    if len(paint.on_ground) < _MIN_LINE_PIXELS:
        why = "there is hardly any paint on the ground in this picture"
        return _with_sport_hint(_no_proposal(size, why), field)
    go_on()

    def search(places: Sequence[KnownPosition | None]) -> Proposal:
        tried = [_best_candidate(picture, field, lines, paint, place, go_on) for place in places]
        found = [best for best in tried if best is not None]
        if not found:
            return _no_proposal(size, "no camera has its lines on the paint of this picture")
        return max(found, key=lambda best: best.score).proposal(picture, field, paint.frame)

    if not known:
        return _with_sport_hint(search((None,)), field)
    at_known = search(known)
    found = better_proposal(search((None,)), at_known, field) if elsewhere else at_known
    return _with_sport_hint(found, field)


def _with_sport_hint(found: Proposal, field: Field) -> Proposal:
    """Ask for the sport: few lines of the field are there, or there is much other paint and other
    cameras suit as well. On grounds of the right sport there may be other paint, too, but the right
    camera stands out."""
    stands_out = found.explained >= SURE_MIN_EXPLAINED or found.margin >= CLEAR_MARGIN
    if found.state == SURE or (found.coverage >= SURE_MIN_COVERAGE and stands_out):
        return found
    hint = translatable(
        "is this {field}, and no other sport? {why}", field=field.title, why=found.reason
    )
    fit = found.fit if found.fit.camera is not None else replace(found.fit, failure=hint)
    return replace(found, fit=fit, reason=hint)


def better_proposal(free: Proposal, at_known: Proposal, field: Field) -> Proposal:
    """Return the better of two proposals for one picture.

    Args:
        free: found anywhere.
        at_known: found at known positions. It replaces a sure camera only if it is sure, one that
            shows the same only if the picture does not contradict its position, and one that shows
            something else only if it agrees better with the line pixels.
        field: the elements, metres.
    """
    if at_known.fit.vector is None or (free.state == SURE and at_known.state != SURE):
        return free
    if free.fit.vector is None:
        return at_known
    lines = field_line_points(field)
    assert lines is not None
    views = free.fit.vector[None]
    if field.half_turn is not None:  # the position tells the side, the picture does not
        views = np.concatenate([views, rotated_180(views)])
    away = view_distance_px(at_known.fit.vector, views, lines, _half_height_px(free.fit.size))
    if away.min() <= _DISTINCT_CAMERA_PX:
        return at_known if _positions_agree(free.fit, views[away.argmin()], at_known.fit) else free
    second, best = sorted(
        (free, at_known), key=lambda one: harmonic_mean(one.coverage, one.explained)
    )
    worth, less = (harmonic_mean(one.coverage, one.explained) for one in (best, second))
    margin = float(min(best.margin, 1 - less / max(worth, 1e-6)))
    other = second.fit.camera
    assert isinstance(other, PinholeCamera)
    if best.state != SURE or margin >= CLEAR_MARGIN:
        return replace(best, margin=margin)
    return replace(best, state=UNSURE, reason=rival_camera_reason(), margin=margin, runner_up=other)


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


def _half_height_px(size: tuple[int, int]) -> float:
    frame = ImageFrame(size)
    return float(round(frame.size[1] * frame.scale / 2))


def warm_up_caches(field: Field, size: tuple[int, int]) -> None:
    """Work out what searches of pictures (width, height) px with nothing known all look up: once
    for a field and a shape of picture, in some seconds, unless a person did."""
    lines = field_line_points(field)
    if lines is None:
        return
    half_height, sides = _half_height_px(size), _allowed_sides(field)
    with ThreadPoolExecutor(len(sides), thread_name_prefix="preparing") as pool:
        list(pool.map(lambda side: hypotheses_on_side(lines, half_height, side), sides))


@dataclass(frozen=True, eq=False)
class _RefinedCandidate:
    """A camera refined on the paint.

    Attributes:
        vector: (11,).
        refined: what it is fitted to.
        explained: share of the paint on the ground that it explains.
        unlikeliness: half the squared deviations from where cameras are expected.
    """

    vector: FloatArray
    refined: LineAlignment
    explained: float
    unlikeliness: float

    @property
    def score(self) -> float:
        both = float(harmonic_mean(self.refined.coverage, self.explained))
        return both - SEARCH_STAGES[-1].unlikely * self.unlikeliness


@dataclass(frozen=True, eq=False)
class _BestCandidate:
    """The best candidate of a search.

    Attributes:
        candidate: it.
        other: (11,) the best of those that show something else; None without any.
        other_score: its.
    """

    candidate: _RefinedCandidate
    other: FloatArray | None
    other_score: float

    @property
    def score(self) -> float:
        return self.candidate.score

    def proposal(self, picture: PixelArray, field: Field, frame: ImageFrame) -> Proposal:
        """Return what is proposed."""
        best, other = self.candidate, self.other
        margin = min(max(1 - self.other_score / max(self.score, 1e-6), 0.0), 1.0)
        refined = best.refined
        elements = sum(share >= _MIN_ALIGNED_COVERAGE for share in refined.shares.values())
        state, reason = classify_proposal(
            ProposalEvidence(
                refined.fit,
                refined.coverage,
                best.explained,
                margin,
                best.unlikeliness,
                elements,
                displaced_elements_in_image(picture, best.vector, marking_points(field), frame),
            )
        )
        if state == NONE:
            return _no_proposal(frame.size, reason)
        return Proposal(
            state,
            reason,
            refined.fit,
            refined.coverage,
            best.explained,
            refined.residual_px,
            margin,
            None if other is None else camera_from_vector(other, frame),
        )


def _best_candidate(
    picture: PixelArray,
    field: Field,
    lines: FieldLinePoints,
    paint: ImageLinePixels,
    place: KnownPosition | None,
    go_on: Callable[[], None],
) -> _BestCandidate | None:
    half_height = float(round(paint.half_height))
    if place is None:
        scene = SearchScene(lines, paint)
        hypotheses = [
            (
                hypotheses_on_side(lines, half_height, side),
                _ICP_POINTS if side == 0 else _ICP_POINTS_RIVAL,
            )
            for side in _allowed_sides(field)
        ]
    else:
        x, y, z = place.position_m.tolist()
        scene = SearchScene(lines, paint, _prior_at_position(place, lines))
        hypotheses = [
            (hypotheses_at_positions(lines, half_height, ((x, y, z),)), _ICP_POINTS_KNOWN)
        ]
    found = search_cameras(
        scene, hypotheses, go_on, SEARCH_STAGES if place is None else SEARCH_STAGES_KNOWN
    )
    vectors = found.vectors[:_REFINED_COUNT]
    if place is None and field.half_turn is not None:
        # Labels are those of a camera on the main side.
        vectors = np.where(vectors[:, [Y]] < 0, rotated_180(vectors), vectors)
    return _refine_candidates(picture, field, scene, vectors, found.scores[:_REFINED_COUNT])


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


def _refine_candidates(
    picture: PixelArray, field: Field, scene: SearchScene, vectors: FloatArray, scores: FloatArray
) -> _BestCandidate | None:
    """The best of some cameras (B, 11) with their scores (B,), those that come near the first one
    refined; None if there is paint next to none."""
    tried: list[LineAlignment] = []
    kept: list[tuple[FloatArray, float]] = []
    for vector, score in zip(vectors, scores, strict=True):
        if score < _REFINEMENT_SCORE_SHARE * scores[0] and tried:
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
    others = [*((one.vector, one.score) for one in candidates), *kept]
    away = view_distance_px(
        best.vector, np.array([v for v, _ in others]), scene.lines, scene.paint.half_height
    )
    apart = [other for other, px in zip(others, away, strict=True) if px > _DISTINCT_CAMERA_PX]
    vector, score = max(apart, key=lambda other: other[1], default=(None, 0.0))
    return _BestCandidate(best, vector, score)


def _rank_candidates(scene: SearchScene, tried: Sequence[LineAlignment]) -> list[_RefinedCandidate]:
    """Refined cameras, the best first."""
    final = np.array([refined.fit.vector for refined in tried])
    judged = chamfer_agreement(scene, final, _AGREEMENT_PX, places=1, paint=_AGREEMENT_POINTS)
    unlikeliness = scene.unlikeliness(final)
    candidates = [
        _RefinedCandidate(vector, refined, float(explained), float(unlikely))
        for vector, refined, explained, unlikely in zip(
            final, tried, judged.explained, unlikeliness, strict=True
        )
    ]
    return sorted(candidates, key=lambda one: -one.score)


def _prior_mean(prior: GaussianPrior) -> FloatArray:
    """(11,) its mean."""
    return np.concatenate([prior.mean[0], np.zeros(len(PARAMETERS) - prior.mean.shape[1])])


def _no_proposal(size: tuple[int, int], reason: str) -> Proposal:
    fit = FitResult("R", size, None, reason)
    return Proposal(NONE, reason, fit, 0.0, 0.0, None, 0.0, None)
