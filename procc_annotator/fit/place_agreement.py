"""How the clicks of several views agree with a place that is known, as from a survey."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.camera.sight_line import projection_jacobian
from procc_annotator.field.geometry import Covariance, Vector
from procc_annotator.fit.triangulation import GATE_SD, MAX_NOISE, ClickedView, click_covariance_px, triangulate


@dataclass(frozen=True)
class SurveyAgreement:
    """How clicks agree with a place that is known.

    Attributes:
        residuals_px: frame -> distance from the click to where its camera shows the place; frames
            that do not show it are left out.
        astray: frames whose click is farther off than chance and the clicks' own noise explain, or
            that do not show the place.
    """

    residuals_px: tuple[tuple[str, float], ...] = ()
    astray: tuple[str, ...] = ()


def compare_with_survey(
    views: Sequence[ClickedView],
    position: Vector,
    covariance: Covariance | None = None,
    *,
    estimate_noise: bool = True,
) -> SurveyAgreement:
    """Compare a place that was surveyed with its clicks.

    Args:
        views: one click each; cameras that know only the ground say nothing.
        position: metres.
        covariance: (3, 3) m^2 of the position, if it is known.
        estimate_noise: as of `triangulate`; the place that the clicks themselves tell says how far
            they are off.
    """
    able = [view for view in views if not projects_only_ground(view.camera)]
    noise = min(max(triangulate(able, estimate_noise=estimate_noise).noise, 1.0), MAX_NOISE)
    place = np.array([position], dtype=np.float64)
    residuals: list[tuple[str, float]] = []
    astray: list[str] = []
    for view in able:
        px, slopes = projection_jacobian(view.camera, place)
        off = px[0] - view.point_px
        if not np.isfinite(slopes).all():
            astray.append(view.name)
            continue
        residuals.append((view.name, float(np.hypot(*off))))
        spread = noise**2 * click_covariance_px(view, place)[0]
        if covariance is not None:
            spread = spread + slopes[0] @ np.array(covariance) @ slopes[0].T
        if float(off @ np.linalg.solve(spread, off)) > GATE_SD**2:
            astray.append(view.name)
    return SurveyAgreement(tuple(residuals), tuple(astray))
