"""The search for cameras that explain a picture's paint: from all to the few best ones."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.from_picture.climbing import (
    ChamferAgreement,
    SearchScene,
    chamfer_agreement,
    refine_by_icp,
)
from procc_annotator.fit.from_picture.hypotheses import CameraHypotheses
from procc_annotator.fit.from_picture.in_view import view_distance_px
from procc_annotator.fit.solving.models import POSITION_SLICE, LOG_FOCAL, Z, rotation_matrices
from procc_annotator.fit.solving.observations import FloatArray, IntArray


@dataclass(frozen=True)
class SearchStage:
    """One round: those that are left climb, and the best of them go on.

    Attributes:
        scales_px: see `climb`.
        places, paint: what they climb by.
        within_px: what counts as on paint, to judge them.
        judged: how many places on lines, and of the paint, judge them.
        unlikely: what unlikeliness costs.
        kept: how many go on.
        apart_px: so far apart at least; 0 for any.
        model: P or R.
        rounds: how often the places in sight are chosen anew.
        away: shares of their distance from what they look at where they are tried as well, zoomed
            as much: that shows nearly the same, and steps hardly lead there.
    """

    scales_px: Sequence[float]
    places: int
    paint: int
    within_px: float
    judged: tuple[int, int]
    unlikely: float
    kept: int
    apart_px: float = 0.0
    model: str = "P"
    rounds: int = 1
    away: tuple[float, ...] = ()


_MIN_DOWNWARD_TILT = 0.03  # of a direction: what looks at the horizon looks so far
_CANCEL_CHECK_INTERVAL = 4  # of so many at most one goes on
SEARCH_STAGES = (
    SearchStage((30, 24, 16, 14), 48, 0, 8.0, (80, 150), 0.02, 70),
    SearchStage((20, 16, 12, 10), 64, 100, 5.0, (120, 300), 0.01, 16, 6.0, "P", 2, (0.7, 1.35)),
    SearchStage((12, 8, 6, 4), 120, 150, 3.0, (240, 800), 0.005, 12, 12.0, "R", 4, (0.85, 1.2)),
)
# Where the position is known, few cameras are left that differ.
SEARCH_STAGES_KNOWN = (
    SearchStage((30, 24, 16), 48, 0, 8.0, (80, 150), 0.02, 40),
    SearchStage((16, 12, 10, 8), 64, 100, 5.0, (120, 300), 0.01, 10, 6.0),
    SearchStage((7, 6, 5, 4), 120, 150, 3.0, (240, 800), 0.005, 3, 12.0, "R", 2),
)


@dataclass(frozen=True, eq=False)
class RankedCameras:
    """The cameras that were found, the best first.

    Attributes:
        vectors: (B, 11).
        scores: (B,) agreement less what their unlikeliness costs.
        agreement: of each.
    """

    vectors: FloatArray
    scores: FloatArray
    agreement: ChamferAgreement

    def chosen(self, rows: IntArray) -> RankedCameras:
        """Some of them."""
        both = ChamferAgreement(self.agreement.coverage[rows], self.agreement.explained[rows])
        return RankedCameras(self.vectors[rows], self.scores[rows], both)


def search_cameras(
    scene: SearchScene,
    hypotheses: Sequence[tuple[CameraHypotheses, int]],
    go_on: Callable[[], None],
    stages: Sequence[SearchStage] = SEARCH_STAGES,
) -> RankedCameras:
    """The best cameras of all hypotheses, led to the paint; so many of each kind climb."""
    vectors = np.concatenate([some.best(scene.paint, most) for some, most in hypotheses])
    for stage in stages:
        go_on()
        found = _search_round(scene, vectors, stage)
        vectors = found.vectors
    return found


def _search_round(scene: SearchScene, vectors: FloatArray, stage: SearchStage) -> RankedCameras:
    vectors = np.concatenate([vectors, *(_dolly_zoom(vectors, share) for share in stage.away)])
    for _ in range(stage.rounds):
        vectors = refine_by_icp(
            scene,
            vectors,
            stage.scales_px,
            places=stage.places,
            paint=stage.paint,
            model=stage.model,
        )
    found = rank_cameras(scene, vectors, stage)
    order = np.argsort(-found.scores, kind="stable")
    most = min(stage.kept, max(len(order) // _CANCEL_CHECK_INTERVAL, 1))
    if not stage.apart_px:
        return found.chosen(order[:most])
    return found.chosen(_distinct_cameras(scene, vectors, order, stage.apart_px, most))


def _dolly_zoom(vectors: FloatArray, share: float) -> FloatArray:
    """Cameras (B, 11) at so many times their distance from what they look at, zoomed as much."""
    ahead = rotation_matrices(vectors)[:, 2]
    distance = -vectors[:, Z] / np.maximum(ahead[:, 2], _MIN_DOWNWARD_TILT)
    moved = vectors.copy()
    moved[:, POSITION_SLICE] += (1 - share) * distance[:, None] * ahead
    moved[:, LOG_FOCAL] += np.log(share)
    return moved


def rank_cameras(scene: SearchScene, vectors: FloatArray, stage: SearchStage = SEARCH_STAGES[-1]) -> RankedCameras:
    """Cameras (B, 11) with what they are worth, in their order."""
    found = chamfer_agreement(
        scene, vectors, stage.within_px, places=stage.judged[0], paint=stage.judged[1]
    )
    return RankedCameras(vectors, found.both - stage.unlikely * scene.unlikeliness(vectors), found)


def _distinct_cameras(
    scene: SearchScene, vectors: FloatArray, order: IntArray, apart: float, most: int
) -> IntArray:
    """The first ones that show lines so many solver px from where those before them do."""
    kept: list[int] = []
    while len(order) and len(kept) < most:
        kept.append(int(order[0]))
        away = view_distance_px(vectors[order[0]], vectors[order], scene.lines, scene.paint.half_height)
        order = order[1:][away[1:] > apart]
    return np.array(kept, dtype=np.intp)
