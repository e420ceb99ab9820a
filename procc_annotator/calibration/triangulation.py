"""Triangulate a point from clicks in several calibrated views; compare it with a surveyed one."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.camera.backprojection import ViewingRay, projection_jacobian, viewing_ray
from procc_annotator.camera.base import Camera, projects_only_ground
from procc_annotator.field.formulas import MAX_COORDINATE_M
from procc_annotator.field.geometry import Covariance, Vector
from procc_annotator.translation import translatable

_PRIOR_WEIGHT = 4.0  # how many residuals the usual error of a click is worth
# A place whose residuals say more than so many times the usual error, beyond three standard
# deviations of what chance makes of it, has a mistake among its clicks.
_MAX_NOISE, _MAX_QUANTILE = 2.0, 3.0


def noise_factor(squares: float, spare: int) -> float:
    """Return how many times as far off as expected clicks are, drawn towards 1 if there is little
    data: the squares of residuals, in standard deviations of a click, have ``spare`` more than
    unknowns."""
    return math.sqrt((_PRIOR_WEIGHT + squares) / (_PRIOR_WEIGHT + spare))


def pooled_noise_factor(places: Sequence[tuple[float, int]]) -> float:
    """The same from places that were clicked by the same hand: of each one its squares and how many
    it has to spare, which of one that was not found are none."""
    squares = sum(min(squares, _max_squares(spare)) for squares, spare in places)
    return noise_factor(squares, sum(spare for _, spare in places))


def _max_squares(spare: int) -> float:
    # The sum of so many squares has this mean and standard deviation (chi-squared distribution).
    return _MAX_NOISE**2 * (spare + _MAX_QUANTILE * math.sqrt(2 * spare))


CameraCovariance = Callable[[FloatArray], FloatArray]

DEFAULT_CLICK_SD_PX = 1.5
"""What a click is off by along each axis of a picture 960 px wide, where nobody says."""
MIN_ANGLE_DEGREES = 1.0
"""Lines of sight that meet at less say next to nothing of the distance."""

_REFERENCE_WIDTH_PX = 960
# Beyond so many standard deviations a click is on another place, or its camera is wrong; of honest
# ones 1 in 3000 is.
GATE_SD = 4.0
_RAYLEIGH_MEDIAN = (
    1.1774  # of the length of a vector whose two parts have a standard deviation of 1
)
MAX_NOISE = 3.0
_MAX_PAIRS = 400
_REFINEMENT_ITERATIONS = 50
_OUTLIER_ROUNDS = 5
_CONVERGED_M = 1e-9


@dataclass(frozen=True, eq=False)
class ClickedView:
    """A click on the place in one view.

    Attributes:
        camera: of the frame, px of the picture size that the point is in.
        point_px: (2,) px.
        click_px: standard deviation of the click along each axis, px.
        covariance: (N, 3) metres -> (N, 2, 2) px^2, how surely the camera knows where it shows
            places (`FitResult.projected_covariance`); None for a camera that is taken as it is.
    """

    name: str
    camera: Camera
    point_px: FloatArray
    click_px: float
    covariance: CameraCovariance | None = None


@dataclass(frozen=True)
class Triangulation:
    """A place, or the reason why there is none.

    Attributes:
        position: metres, world frame; None if it could not be found.
        covariance: (3, 3) m^2.
        residuals_px: frame -> distance from the click to where its camera shows the place.
        left_out: frames that disagree with the others and had no say.
        angle_degrees: the largest angle at which two lines of sight meet.
        noise: how many times as far off as the views say the clicks are.
        squares: of the residuals that had a say, in standard deviations as the views say: the sum.
        spare: how many of them there are more than unknowns.
        failure: why there is no position, in words; None if there is one.
    """

    position: Vector | None = None
    covariance: Covariance | None = None
    residuals_px: tuple[tuple[str, float], ...] = ()
    left_out: tuple[str, ...] = ()
    angle_degrees: float = 0.0
    noise: float = 1.0
    squares: float = 0.0
    spare: int = 0
    failure: str | None = None

    @property
    def deviations_m(self) -> Vector | None:
        """Standard deviations along x, y and z, metres."""
        if self.covariance is None:
            return None
        x, y, z = (float(np.sqrt(self.covariance[i][i])) for i in range(3))
        return x, y, z


def default_click_sd_px(width: int) -> float:
    """Return what a click is usually off by along each axis of a picture that many px wide."""
    return DEFAULT_CLICK_SD_PX * width / _REFERENCE_WIDTH_PX


def triangulate(
    views: Sequence[ClickedView], *, estimate_noise: bool = True, noise: float | None = None
) -> Triangulation:
    """Find the place that was clicked in several views.

    Robust: with three views and more those that contradict the majority are left out and named.

    Args:
        views: one click each.
        estimate_noise: let the residuals say how far clicks are off, drawn towards what the views
            say where there are few of them; else the views' own standard deviations count.
        noise: how many times as far off they are, where it is known from other places.

    Returns:
        The position with its covariance, or why there is none: fewer than two views with a camera
        that can say, lines of sight that are nearly parallel, meet behind a camera or do not meet.
    """
    lines: list[ViewingRay] = []
    usable: list[ClickedView] = []
    for view in views:
        if projects_only_ground(view.camera):
            continue
        line = viewing_ray(view.camera, view.point_px)
        if line is not None:
            lines.append(line)
            usable.append(view)
    if len(usable) < 2:
        return Triangulation(failure=_too_few_views_reason(views, usable))
    known = 1.0 if not estimate_noise else noise
    return _RobustTriangulation(usable, lines, known).run()


def _too_few_views_reason(views: Sequence[ClickedView], usable: Sequence[ClickedView]) -> str:
    ground = sum(projects_only_ground(view.camera) for view in views)
    if len(views) < 2:
        if views:
            return translatable("clicked in one view only")
        return translatable("clicked in no view that has a camera")
    if ground and len(views) - ground < 2:
        return translatable(
            "cameras that know only the ground (homographies) have no position in space"
        )
    return translatable(
        "{count} of {total} clicks lie where the camera shows nothing",
        count=len(views) - len(usable),
        total=len(views),
    )


class _RobustTriangulation:
    """One triangulation of n views."""

    def __init__(
        self, views: list[ClickedView], lines: list[ViewingRay], noise: float | None
    ) -> None:
        self.views = views
        self.lines = lines
        self.noise = noise  # None: to be estimated

    def run(self) -> Triangulation:
        starts = _ray_intersections(self.lines)
        if not len(starts):
            return Triangulation(failure=_parallel_rays_reason(_max_ray_angle(self.lines)))
        place = self._best(starts)
        if place is None:
            return Triangulation(failure=self._behind(starts))
        used = self._agreeing(place)
        for _ in range(_OUTLIER_ROUNDS):
            place = self._refined(place, used)
            now = self._agreeing(place)
            if (now == used).all():
                break
            used = now
        return self._judged(place, used)

    def _judged(self, place: FloatArray, used: BoolArray) -> Triangulation:
        names = [view.name for view in self.views]
        away_px, away, covariances = self._residuals(place[None])
        residuals = tuple(zip(names, away_px[:, 0].tolist(), strict=True))
        least = max(2, len(names) // 2 + 1)
        agreeing = int((away[used, 0] < self._gate(away[:, 0])).sum())
        if agreeing < least:
            far = " and ".join(f"{px:.1f}" for _, px in residuals[:4])
            more = " ..." if len(names) > 4 else ""
            return Triangulation(
                residuals_px=residuals,
                failure=translatable(
                    "the views do not agree: {far} px off (is it the same place in all of them, and"
                    " are the cameras right?)",
                    far=far + more,
                ),
            )
        if float(np.abs(place).max()) > MAX_COORDINATE_M:
            far_off = translatable(
                "would be farther than {metres:g} m from the field", metres=MAX_COORDINATE_M
            )
            return Triangulation(failure=far_off)
        slopes = np.array([projection_jacobian(v.camera, place[None])[1][0] for v in self.views])
        angle = _max_ray_angle([ViewingRay(place, np.linalg.svd(s)[2][2]) for s in slopes[used]])
        if angle < MIN_ANGLE_DEGREES:
            return Triangulation(residuals_px=residuals, failure=_parallel_rays_reason(angle))
        squares, spare = float((away[used, 0] ** 2).sum()), 2 * int(used.sum()) - 3
        noise = noise_factor(squares, spare) if self.noise is None else self.noise
        grown = self._grown(covariances[:, 0], noise)[used]
        information = np.einsum("nki,nkl,nlj->ij", slopes[used], np.linalg.inv(grown), slopes[used])
        covariance = np.linalg.inv(information)
        x, y, z = place.tolist()
        a, b, c = ((covariance + covariance.T) / 2).tolist()
        return Triangulation(
            (x, y, z),
            (tuple(a), tuple(b), tuple(c)),
            residuals,
            tuple(name for name, counts in zip(names, used, strict=True) if not counts),
            angle,
            noise,
            squares,
            spare,
        )

    def _grown(self, covariances: FloatArray, noise: float) -> FloatArray:
        """(n, 2, 2) px^2 of clicks so many times as far off as the views say.

        Clicks that are better than usual make no camera better; if they are worse, the views cannot
        decide whether the clicks or the cameras are.
        """
        if noise >= 1:
            return noise**2 * covariances
        clicks = np.array([view.click_px**2 for view in self.views])[:, None, None] * np.eye(2)
        return covariances - (1 - noise**2) * clicks

    def _best(self, starts: FloatArray) -> FloatArray | None:
        """The meeting point that most views agree with; None where none is in front of two."""
        _, away, _ = self._residuals(starts)
        seen = np.isfinite(away)
        cost = np.where(seen, np.minimum(away, 4 * GATE_SD) ** 2, (8 * GATE_SD) ** 2).sum(axis=0)
        cost[seen.sum(axis=0) < 2] = np.inf
        best = int(np.argmin(cost))
        return starts[best] if np.isfinite(cost[best]) else None

    def _behind(self, starts: FloatArray) -> str:
        _, away, _ = self._residuals(starts)
        hidden = [v.name for v, row in zip(self.views, away, strict=True) if np.isnan(row).any()]
        names = ", ".join(hidden[:3])
        return translatable("the lines of sight meet behind the camera of {names}", names=names)

    def _agreeing(self, place: FloatArray) -> BoolArray:
        """(n,) whether each view agrees with a place; the nearest two have a say anyhow."""
        _, away, _ = self._residuals(place[None])
        second = float(np.sort(away[:, 0])[1])  # NaN comes last
        return np.asarray(away[:, 0] <= max(self._gate(away[:, 0]), second), dtype=bool)

    def _gate(self, away: FloatArray) -> float:
        """Return how many standard deviations off a view may be.

        Where the noise is not known all views may be noisier than usual, up to a limit.
        """
        count = len(away)
        if self.noise is not None:
            return GATE_SD * min(max(self.noise, 1.0), MAX_NOISE)
        if count < 3:
            return GATE_SD
        fitted = math.sqrt(2 * count / (2 * count - 3))
        noise = float(np.nanmedian(away)) / _RAYLEIGH_MEDIAN * fitted
        return GATE_SD * min(max(noise, 1.0), MAX_NOISE)

    def _residuals(self, places: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Of n views and P places: (n, P) px, (n, P) standard deviations, (n, P, 2, 2) px^2; NaN
        where the camera does not show the place."""
        away_px = np.full((len(self.views), len(places)), np.nan)
        away = np.full_like(away_px, np.nan)
        covariances = np.empty((*away.shape, 2, 2))
        for i, view in enumerate(self.views):
            px, shown = view.camera.project(places)
            shown = shown & np.isfinite(px).all(axis=1)
            covariances[i] = click_covariance_px(view, places)
            off = px - view.point_px
            weighted = np.einsum("pi,pij,pj->p", off, np.linalg.inv(covariances[i]), off)
            away_px[i] = np.where(shown, np.hypot(off[:, 0], off[:, 1]), np.nan)
            away[i] = np.where(shown, np.sqrt(np.maximum(weighted, 0.0)), np.nan)
        return away_px, away, covariances

    def _refined(self, place: FloatArray, used: BoolArray) -> FloatArray:
        """Levenberg and Marquardt's method on the views that have a say."""
        views = [view for view, counts in zip(self.views, used, strict=True) if counts]
        weights = [
            np.linalg.inv(np.linalg.cholesky(click_covariance_px(v, place[None])[0])) for v in views
        ]

        def linear(at: FloatArray) -> tuple[FloatArray, FloatArray]:
            parts = [projection_jacobian(v.camera, at[None]) for v in views]
            off = [
                w @ (p[0][0] - v.point_px) for w, p, v in zip(weights, parts, views, strict=True)
            ]
            slopes = [w @ p[1][0] for w, p in zip(weights, parts, strict=True)]
            return np.concatenate(off), np.concatenate(slopes)

        off, slopes = linear(place)
        damping = 1e-6
        for _ in range(_REFINEMENT_ITERATIONS):
            if not np.isfinite(slopes).all():
                return place
            normal = slopes.T @ slopes
            damped = normal + damping * np.diag(np.diag(normal)) + 1e-12 * np.eye(3)
            step = -np.linalg.solve(damped, slopes.T @ off)
            tried, tried_slopes = linear(place + step)
            if float(tried @ tried) <= float(off @ off):  # False for NaN
                place, off, slopes = place + step, tried, tried_slopes
                damping = max(damping / 10, 1e-12)
                if float(np.abs(step).max()) < _CONVERGED_M:
                    break
            else:
                damping *= 10
                if damping > 1e12:
                    break
        return place


def click_covariance_px(view: ClickedView, places: FloatArray) -> FloatArray:
    """(P, 2, 2) px^2 of a click against where the camera shows places."""
    own = np.broadcast_to(view.click_px**2 * np.eye(2), (len(places), 2, 2))
    if view.covariance is None:
        return own
    camera = view.covariance(places)
    return own + np.where(np.isfinite(camera), camera, 0.0)


def _ray_intersections(lines: Sequence[ViewingRay]) -> FloatArray:
    """(P, 3) metres: where pairs of lines are nearest to each other; nearly parallel ones left out.

    Of very many pairs an even choice is taken.
    """
    pairs = list(combinations(range(len(lines)), 2))
    pairs = pairs[:: max(1, -(-len(pairs) // _MAX_PAIRS))]
    found = []
    for i, j in pairs:
        one, other = lines[i], lines[j]
        cross = np.cross(one.direction, other.direction)
        if float(np.linalg.norm(cross)) < np.sin(np.radians(MIN_ANGLE_DEGREES)) / 2:
            continue
        along = np.column_stack((one.direction, -other.direction))
        ways = np.linalg.lstsq(along, other.place - one.place, rcond=None)[0]
        here = one.place + ways[0] * one.direction
        there = other.place + ways[1] * other.direction
        found.append((here + there) / 2)
    return np.array(found).reshape(-1, 3)


def _max_ray_angle(lines: Sequence[ViewingRay]) -> float:
    """Largest angle between any two lines, degrees."""
    directions = np.array([line.direction for line in lines])
    least = float(np.abs(directions @ directions.T).min())
    return float(np.degrees(np.arccos(min(least, 1.0))))


def _parallel_rays_reason(angle_degrees: float) -> str:
    return translatable(
        "the views look at it from nearly the same direction ({degrees:.2f} degrees apart, at least"
        " {least:g} are needed)",
        degrees=angle_degrees,
        least=MIN_ANGLE_DEGREES,
    )


@dataclass(frozen=True)
class SurveyAgreement:
    """Agreement of clicks with a known place.

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
    """Compare a place that was surveyed, metres and (3, 3) m^2 if known, with its clicks; cameras
    that know only the ground say nothing.

    The place that the clicks themselves determine shows how far they are off if
    ``estimate_noise``, see `triangulate`.
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
