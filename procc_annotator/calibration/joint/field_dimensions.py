"""Estimate field dimensions from many frames of one stadium."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.joint.adjustment import (
    FrameObservations,
    ReducedFrame,
    SharedParameterPrior,
    SharedSolution,
    frame_observations,
    reduce_frame,
    solve_shared,
    unbounded_parameters,
)
from procc_annotator.calibration.optimization.camera_parameters import (
    FREE_PARAMETERS,
    POSITION_SLICE,
    lower_bounded_parameter,
)
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.optimization.closest_points import (
    ClosestPoints,
    find_closest_points,
)
from procc_annotator.calibration.optimization.initialization import prior_near
from procc_annotator.calibration.optimization.observations import Observations
from procc_annotator.calibration.optimization.projection import Lens, project
from procc_annotator.calibration.optimization.residuals import (
    Residuals,
    pinhole_residuals,
    project_out_tangent,
    with_folded_hidden,
)
from procc_annotator.calibration.optimization.solver import FINAL_LOSS, Problem, solve
from procc_annotator.calibration.result import FitResult
from procc_annotator.errors import UsageError
from procc_annotator.field.dimensions import Dimension, violated_relation
from procc_annotator.field.load import with_dimensions
from procc_annotator.field.model import Field


@dataclass(frozen=True, eq=False)
class GeometryDerivatives:
    """Derivatives of some elements' geometry by D dimensions, metres a metre.

    Attributes:
        line_ends: (D, 3, 2 L).
        curve_frames: (D, 3, 3 C).
        spots: (D, 3, S).
    """

    line_ends: FloatArray
    curve_frames: FloatArray
    spots: FloatArray

    @classmethod
    def of(
        cls, seen: Observations, around: list[tuple[Field, Field, float]]
    ) -> GeometryDerivatives:
        pairs = [(seen.on(less).parts, seen.on(more).parts, d) for less, more, d in around]
        return cls(
            np.array([(b.line_ends - a.line_ends) / d for a, b, d in pairs]),
            np.array([(b.curve_frames - a.curve_frames) / d for a, b, d in pairs]),
            np.array([(b.spots - a.spots) / d for a, b, d in pairs]),
        )

    def of_points(self, seen: Observations, feet: ClosestPoints) -> FloatArray:
        """Return how the feet of one camera move, each staying at its place on its element: (D, 3,
        N)."""
        world = feet.world[0]
        pair = np.arange(world.shape[1]) if feet.pair is None else feet.pair[0]
        parts, part = seen.parts, seen.candidates.part[pair]
        moved = np.zeros((len(self.line_ends), *world.shape))
        lines, curves = parts.lines, parts.curves
        on_line, on_spot = part < lines, part >= lines + curves
        if on_line.any():
            row = part[on_line]
            begin, end = parts.line_ends[:, row], parts.line_ends[:, lines + row]
            span = end - begin
            share = ((world[:, on_line] - begin) * span).sum(axis=0) / (span**2).sum(axis=0)
            first, second = self.line_ends[:, :, :lines], self.line_ends[:, :, lines:]
            moved[:, :, on_line] = first[:, :, row] * (1 - share) + second[:, :, row] * share
        on_curve = ~(on_line | on_spot)
        if on_curve.any():
            row = part[on_curve] - lines
            frames = parts.curve_frames.reshape(3, 3, curves)[:, :, row]
            rates = self.curve_frames.reshape(-1, 3, 3, curves)[:, :, :, row]
            off = world[:, on_curve] - frames[:, 0]
            squares = (frames[:, 1] ** 2).sum(axis=0)
            ahead = (off * frames[:, 1]).sum(axis=0) / squares
            aside = (off * frames[:, 2]).sum(axis=0) / squares
            moved[:, :, on_curve] = rates[:, :, 0] + rates[:, :, 1] * ahead + rates[:, :, 2] * aside
        moved[:, :, on_spot] = self.spots[:, :, part[on_spot] - lines - curves]
        return moved


def residuals_by_dimensions(
    vector: FloatArray,
    seen: Observations,
    half_diagonal: float,
    free: int,
    rates: GeometryDerivatives,
) -> Residuals:
    """Residuals of one camera (11,), with derivatives by D dimensions of the field, then by the
    first ``free`` of its own parameters; ``half_diagonal`` is the picture's, solver px."""
    lens = Lens.of(vector[None], half_diagonal)
    feet = with_folded_hidden(
        find_closest_points(lens.linear, lens.undistorted(seen.points), seen), lens
    )
    ahead = (lens.rotation[:, 2] + vector[POSITION_SLICE])[:, :, None]
    world = np.where(feet.hidden[:, None], ahead, feet.world)
    pixels, along, by_camera = project(lens, world, feet.along, free)
    moved = rates.of_points(seen, feet)
    by_dimension = [project(lens, world, step[None], free)[1] for step in moved]
    derivatives = np.concatenate([np.stack(by_dimension, axis=1), by_camera], axis=1)
    return project_out_tangent(seen, pixels, along, derivatives, feet)


DEFAULT_DIMENSIONS = ("length", "width")
_DIFFERENCE_STEP_M = (
    0.02  # for derivatives of the field's geometry, which is nearly linear in its dimensions
)
# What is expected before any frame is examined: anywhere in the range of the rules.
_PRIOR_RANGE_SHARE = 0.5  # of the range, standard deviation
# A dimension is not determined that is known less surely than to this share of the field's length,
# or of the range of the rules, which alone would determine it to half of that.
_MAX_SD_SHARE, _MAX_SD_OF_RANGE = 0.005, 0.25
_AT_LIMIT_TOLERANCE_M = 1e-3
# What the frames leave out depends on the field they were fitted on: decided anew until it stays.
_MAX_ROUNDS = 8
_CONVERGED_M = 0.005
# Of the elements, left out on the best field: in frames of one stadium hardly any are.
_MAX_OUTLIER_SHARE = 0.04
# A frame says something of a dimension if it alone, at an error of 1 px, would know it to this
# share of the field's length.
_MIN_INFORMATION_SHARE = 0.1


@dataclass(frozen=True)
class FittedDimension:
    """One dimension of a stadium.

    Attributes:
        dimension: its title, nominal value and range; its value is the one that was found.
        sd_m: standard deviation, metres.
        frames: number of frames that say something of it.
        max_sd_m: what it must be known to, metres.
    """

    dimension: Dimension
    sd_m: float
    frames: int
    max_sd_m: float

    @property
    def is_determined(self) -> bool:
        """Return whether the frames say enough to use the value."""
        return self.sd_m <= self.max_sd_m

    @property
    def is_at_limit(self) -> bool:
        """Return whether it would leave the range of the rules."""
        d = self.dimension
        return min(d.value - d.minimum, d.maximum - d.value) < _AT_LIMIT_TOLERANCE_M

    @property
    def remark(self) -> str:
        """Return what keeps the value from being used as it is; empty if nothing does."""
        title = self.dimension.title.lower()
        if self.is_at_limit:
            return f"{title} is at the limit of the rules: is it this field?"
        if not self.is_determined:
            return f"{title} is not determined (sd {self.sd_m:.2f} m): {self._why_not}"
        return ""

    @property
    def _why_not(self) -> str:
        if self.frames == 0:
            return "no frame shows what moves with it"
        return "the frames hardly show what moves with it"


@dataclass(frozen=True, eq=False)
class StadiumFit:
    """Dimensions of a stadium.

    Attributes:
        frames: number of frames that took part.
        elements, left_out: number of their elements, and of those that fit even the best field so
            badly that they had no say.
        relation_violation: which relation between dimensions those that are determined break; empty
        if
            none.
    """

    dimensions: tuple[FittedDimension, ...]
    frames: int
    elements: int = 0
    left_out: int = 0
    relation_violation: str = ""

    @property
    def values(self) -> dict[str, float]:
        """The dimensions that are determined, metres, to the centimetre."""
        return {
            d.dimension.name: round(d.dimension.value, 2)
            for d in self.dimensions
            if d.is_determined
        }

    @property
    def doubt(self) -> str:
        """Why the frames may not be of one stadium; empty if nothing says so."""
        if self.left_out <= _MAX_OUTLIER_SHARE * self.elements:
            return ""
        return (
            f"{self.left_out} of {self.elements} elements do not lie on the best field: are these"
            " frames of several stadiums, which need groups, or labels wrong?"
        )

    @property
    def remarks(self) -> tuple[str, ...]:
        """Return what keeps it from being used as it is, one line each."""
        said = (d.remark for d in self.dimensions)
        return tuple(filter(None, [*said, self.relation_violation, self.doubt]))


def fittable_dimensions(field: Field, names: Sequence[str] | None = None) -> tuple[str, ...]:
    """Those of the named dimensions that can be fitted; without names length and width, where the
    rules leave them open, else all that they leave open.

    Raises:
        UsageError: no such dimension, or the rules leave it no range.
    """
    free = [d.name for d in field.dimensions if d.is_open]
    if names is None:
        names = [name for name in DEFAULT_DIMENSIONS if name in free] or free
        if not names:
            raise UsageError(f"the rules fix all dimensions of the field {field.name!r}")
    for name in names:
        if name not in free:
            there = ", ".join(free) or "none"
            raise UsageError(
                f"the dimension {name!r} cannot be fitted; those that the rules leave open: {there}"
            )
    return tuple(dict.fromkeys(names))


def fit_dimensions(
    annotations: Mapping[str, FrameAnnotation],
    alone: Mapping[str, FitResult],
    field: Field,
    *,
    names: Sequence[str] | None = None,
    on_step: Callable[[], None] = lambda: None,
) -> StadiumFit:
    """Find dimensions of the field that frames of one stadium show.

    Every frame keeps a camera of its own, which is the best one for whatever dimensions are tried.
    What a frame leaves out as a mistake is decided anew on the field that was found, until neither
    changes any more: an element that lies far off on a wrong field is none.

    Args:
        annotations: frame -> normalised points.
        alone: frame -> its own fit (P, R or R+), on the field as it is.
        field: the elements; the dimensions start from its values.
        on_step: called every few milliseconds; may raise to stop.

    Raises:
        UsageError: no frame has a pinhole camera, or a dimension that cannot be fitted.
        FieldError: the field's description cannot be read again.
    """
    names = fittable_dimensions(field, names)
    fits = {name: fit for name, fit in alone.items() if _is_informative_fit(fit)}
    if not fits:
        raise UsageError("no frame has a camera that determines the field's dimensions")
    for _ in range(_MAX_ROUNDS):
        sightings = [
            frame_observations(annotations[name], fit, field) for name, fit in fits.items()
        ]
        shared = _solve_dimensions(sightings, field, names, on_step)
        fields = _FieldVariants(field, names)
        moved = float(np.abs(shared.values - fields.start).max())
        field = fields.at(shared.values)
        again = {}  # what is left out, and whether there is a camera, changes with the field
        for name, fit in alone.items():
            on_step()
            refitted = fit_camera(annotations[name], field, model=fit.model, size=fit.size)
            if _is_informative_fit(refitted):
                again[name] = refitted
        again = again or fits
        same = {n: f.left_out for n, f in again.items()} == {n: f.left_out for n, f in fits.items()}
        fits = again
        if same and moved < _CONVERGED_M:
            break
    return _build_stadium_fit(shared, fits.values(), field, names)


def _is_informative_fit(fit: FitResult) -> bool:
    return fit.camera is not None and fit.model in FREE_PARAMETERS


class _FieldVariants:
    """The field, and how its geometry moves with its dimensions, for whatever is tried."""

    def __init__(self, field: Field, names: tuple[str, ...]) -> None:
        self._field, self._names = field, names
        self._fixed = {d.name: d.value for d in field.dimensions}
        chosen = [d for d in field.dimensions if d.name in names]
        ordered = sorted(chosen, key=lambda d: names.index(d.name))
        self.start = np.array([d.value for d in ordered])
        self.nominal = np.array([d.nominal for d in ordered])
        self.lowest = np.array([d.minimum for d in ordered])
        self.highest = np.array([d.maximum for d in ordered])

    def at(self, values: FloatArray) -> Field:
        """The field with these dimensions."""
        chosen = dict(zip(self._names, values.tolist(), strict=True))
        return with_dimensions(self._field, self._fixed | chosen, related=False)

    def around(self, values: FloatArray) -> list[tuple[Field, Field, float]]:
        """For each dimension: a slightly smaller and a larger field, and metres between them."""
        found = []
        for row in range(len(values)):
            less, more = values.copy(), values.copy()
            less[row] = max(values[row] - _DIFFERENCE_STEP_M, self.lowest[row])
            more[row] = min(values[row] + _DIFFERENCE_STEP_M, self.highest[row])
            found.append((self.at(less), self.at(more), float(more[row] - less[row])))
        return found


def _solve_dimensions(
    sightings: Sequence[FrameObservations],
    field: Field,
    names: tuple[str, ...],
    on_step: Callable[[], None],
) -> SharedSolution:
    fields = _FieldVariants(field, names)
    expected = 1 / (_PRIOR_RANGE_SHARE * (fields.highest - fields.lowest))
    prior = SharedParameterPrior(fields.nominal, expected, fields.lowest, fields.highest)

    def profiler(values: FloatArray, vectors: Sequence[FloatArray]) -> list[ReducedFrame]:
        tried, around = fields.at(values), fields.around(values)
        found = []
        for sighting, vector in zip(sightings, vectors, strict=True):
            on_step()
            seen = sighting.seen.on(tried)
            there = replace(sighting, seen=seen, vector=vector)
            found.append(
                _reduce_frame_by_dimensions(there, tried, GeometryDerivatives.of(seen, around))
            )
        return found

    return solve_shared(profiler, fields.start, [s.vector for s in sightings], prior)


def _informative_frame_counts(shared: SharedSolution, length_m: float) -> list[int]:
    """Return how many frames say something of each dimension."""
    least = 1 / (_MIN_INFORMATION_SHARE * length_m) ** 2
    return [
        sum(bool(p.normal[row, row] > least) for p in shared.profiles)
        for row in range(len(shared.values))
    ]


def _reduce_frame_by_dimensions(
    sighting: FrameObservations, field: Field, rates: GeometryDerivatives
) -> ReducedFrame:
    """A frame with the camera that is best on a field of these dimensions."""
    free, half = FREE_PARAMETERS[sighting.model], sighting.frame.half_diagonal
    around = camera_placement_prior(field)
    kept = sighting.kept
    prior = prior_near(sighting.vector, around, free)
    problem = Problem(
        partial(pinhole_residuals, seen=kept, half_diagonal=half, free=free),
        kept.weights,
        FINAL_LOSS,
        prior,
        bounded=lower_bounded_parameter(sighting.vector),
    )
    vector = solve(problem, sighting.vector[None], iterations=20, tolerance=1e-5).vectors[0]
    residuals = residuals_by_dimensions(vector, kept, half, free, rates)
    own = unbounded_parameters(vector, free)
    count = len(rates.line_ends)
    order = np.concatenate([np.arange(count), count + own])
    ordered = replace(residuals, derivatives=residuals.derivatives[:, order])
    return reduce_frame(vector, ordered, kept.weights, prior, own)


def _build_stadium_fit(
    shared: SharedSolution, fits: Collection[FitResult], field: Field, names: tuple[str, ...]
) -> StadiumFit:
    sd = np.sqrt(np.diag(shared.covariance))
    length_m = 2 * camera_placement_prior(field).half_length
    telling = _informative_frame_counts(shared, length_m)
    fitted = []
    for row, name in enumerate(names):
        dimension = field.dimension(name)
        assert dimension is not None  # it can be fitted
        own = replace(dimension, value=float(shared.values[row]))
        most_m = min(_MAX_SD_SHARE * length_m, _MAX_SD_OF_RANGE * (own.maximum - own.minimum))
        fitted.append(FittedDimension(own, float(sd[row]), telling[row], most_m))
    found = StadiumFit(
        tuple(fitted),
        len(shared.profiles),
        sum(len(fit.elements) for fit in fits),
        sum(len(fit.left_out) for fit in fits),
    )
    values = {d.name: d.value for d in field.dimensions} | found.values
    return replace(found, relation_violation=violated_relation(field.relations, values))
