"""The result of a fit: camera or failure, residuals, covariance; ill-conditioned fits."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from procc_annotator.annotation import Polyline
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_parameters import (
    LOG_FOCAL,
    PAN,
    ROLL,
    TILT,
    X,
    Z,
    camera_from_vector,
    fisheye_from_vector,
    homography_camera,
    is_fisheye,
    parameter_names,
    vector_from_camera,
)
from procc_annotator.calibration.optimization.camera_placement import (
    camera_placement_prior,
    implausible_reason,
)
from procc_annotator.calibration.optimization.covariance import (
    DISPLACEMENT_M,
    estimate_noise,
    is_opposite_end_possible,
    max_direction_sd,
    parameter_information,
    picture_distances,
    projected_covariance,
)
from procc_annotator.calibration.optimization.observations import ImageFrame, used_point_indices
from procc_annotator.calibration.optimization.residuals import homographies_from_corrections
from procc_annotator.calibration.optimization.robust_fit import OUTLIER_PX, CameraSolution
from procc_annotator.camera.backprojection import ground_covariance, ground_from_px
from procc_annotator.camera.base import ElementProjections
from procc_annotator.camera.models import FisheyeCamera, HomographyCamera, PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.translation import translatable, translatable_joined, word

PosedCamera = PinholeCamera | FisheyeCamera


@dataclass(frozen=True, slots=True)
class ElementResidual:
    """Residuals of one element's points under the fitted camera.

    Attributes:
        name: the class.
        distances_px: of its points, px of the picture; repeated points are listed once, and of very
            many points some.
        left_out: whether it was taken for a mistake and had no say.
        counted_px: the same distances as they count, px: those of a landmark are smaller the less
            its own place is known, and where pixels are not square they are multiples of their
            height; None where they count as they are.
    """

    name: str
    distances_px: tuple[float, ...]
    left_out: bool
    counted_px: tuple[float, ...] | None = None

    @property
    def mean_px(self) -> float:
        """Mean of the distances, px."""
        return sum(self.distances_px) / len(self.distances_px)

    @property
    def max_px(self) -> float:
        """Largest of the distances, px."""
        return max(self.distances_px)

    @property
    def most_counted_px(self) -> float:
        """Largest of the distances as they count, px."""
        return max(self.distances_px if self.counted_px is None else self.counted_px)

    def distances_of(self, polyline: Polyline, size: tuple[int, int]) -> dict[int, float]:
        """Place in the polyline -> distance, px of a picture of this size, of the points that have
        one; nothing for another polyline than the fitted one, which has more points or fewer."""
        places = used_point_indices(polyline, ImageFrame(size)).tolist()
        if len(places) != len(self.distances_px):
            return {}
        return dict(zip(places, self.distances_px, strict=True))


@dataclass(frozen=True, slots=True)
class PoseStandardDeviations:
    """Standard deviations of a fitted camera with a pose: rad, metres, px of the picture."""

    pan_rad: float
    tilt_rad: float
    roll_rad: float
    position_m: tuple[float, float, float]
    focal_px: float


@dataclass(frozen=True, eq=False)
class FitResult:
    """A fit, or the reason why there is none.

    Attributes:
        model: H, P, R, R+, R2 or F; auto if the model was to be chosen and there is no camera.
        size: (width, height) px of the picture.
        camera: in px of the picture; None if the fit failed.
        failure: why there is no camera, in words; None if there is one.
        elements: residuals of the elements that took part, straight ones first.
        deviations: of the pose; None for a homography.
        error_px: standard deviation of a point across its element, px of the picture.
        parameters: names of the n free parameters.
        covariance: (n, n) of those, in the units of `camera_parameters`: by clicks, prior and what
            the points of an element share.
        warm: whether the camera was found from the start that was given.
        vector: (11,) the solver's parameters of a pinhole, (13,) of a strong lens, or (8,)
            corrections of `basis`.
        basis: (3, 3) the homography that was corrected; None for a pinhole.
        chosen_because: why this model, in a sentence; None if it was asked for.
        other_end: whether the points may as well be seen from the other end of the field, half a
            turn about its centre; standard deviations say nothing of that.
        offset_px: standard deviation of what all points of an element share, across, px of the
            picture; mean over the points.
        of_clicks: (n, n) the part of the covariance by clicks and prior alone.
        information: (n, n) of points and prior, the points weighed as in the fit.
        if_shared: (n, n) the covariance if elements share errors at all, as annotated ones do.
        shared_if_any: standard deviations of these, on the ground, m, and across, px of the
            picture.
        fitted_on: `annotation_digest` of what it was fitted to, where that is kept.
        pixel_aspect: width over height of the picture's pixels that it was fitted for; ``error_px``
            and ``offset_px`` are then multiples of their height.
    """

    model: str
    size: tuple[int, int]
    camera: PosedCamera | HomographyCamera | None
    failure: str | None = None
    elements: tuple[ElementResidual, ...] = field(default=(), repr=False)
    deviations: PoseStandardDeviations | None = None
    error_px: float | None = None
    parameters: tuple[str, ...] = ()
    covariance: FloatArray | None = field(default=None, repr=False)
    warm: bool = False
    vector: FloatArray | None = field(default=None, repr=False)
    basis: FloatArray | None = field(default=None, repr=False)
    chosen_because: str | None = None
    other_end: bool = False
    offset_px: float = 0.0
    of_clicks: FloatArray | None = field(default=None, repr=False)
    information: FloatArray | None = field(default=None, repr=False)
    if_shared: FloatArray | None = field(default=None, repr=False)
    shared_if_any: tuple[float, float] = (0.0, 0.0)
    fitted_on: str | None = None
    pixel_aspect: float = 1.0

    @property
    def frame(self) -> ImageFrame:
        """The picture whose solver px the parameters belong to."""
        return ImageFrame(self.size, self.pixel_aspect)

    @property
    def mean_px(self) -> float | None:
        """Mean distance of all points that had a say, px; None without a camera."""
        distances = [d for e in self.elements if not e.left_out for d in e.distances_px]
        return sum(distances) / len(distances) if distances else None

    @property
    def left_out(self) -> tuple[str, ...]:
        """Elements that were taken for mistakes."""
        return tuple(e.name for e in self.elements if e.left_out)

    def projected_covariance(self, points_world: FloatArray) -> FloatArray:
        """Return how surely the fit knows where field points appear.

        Args:
            points_world: (N, 3) metres, world frame.

        Returns:
            (N, 2, 2) px squared; NaN for points that the camera does not show, and for all of them
            without a camera.
        """
        if self.covariance is None or self.vector is None:
            return np.full((len(points_world), 2, 2), np.nan)
        frame = self.frame
        found = projected_covariance(
            self.vector, self.basis, frame.half_diagonal, self.covariance, points_world
        )
        return np.asarray(found / np.outer(frame.scales, frame.scales))

    def projected_sd(
        self, points_world: FloatArray, normals: FloatArray | None = None
    ) -> FloatArray:
        """Standard deviation of where field points appear.

        Args:
            points_world: (N, 3) metres, world frame.
            normals: (N, 2) unit vectors in the picture; the direction in question, such as across
                an element. Without them the direction with the largest deviation counts.

        Returns:
            (N,) px; NaN as for `projected_covariance`.
        """
        covariance = self.projected_covariance(points_world)
        if normals is None:
            return max_direction_sd(covariance)
        squares = np.einsum("ni,nij,nj->n", normals, covariance, normals)
        return np.asarray(np.sqrt(np.maximum(squares, 0.0)))

    def ground_from_px(self, points_px: FloatArray) -> FloatArray:
        """(N, 2) px of ``size`` -> (N, 2) metres on the ground; NaN for pixels that do not show it,
        and for all of them without a camera."""
        return ground_from_px(self.camera or ElementProjections({}), points_px)

    def ground_covariance(self, ground: FloatArray, *, pixel_sd: float = 0.0) -> FloatArray:
        """Covariance of the ground points that pixels mean.

        To first order: near the horizon, where it comes to many metres, it says that little is
        known rather than how much.

        Args:
            ground: (N, 2) metres, world frame: the points, as of `ground_from_px`.
            pixel_sd: standard deviation, along each axis of the picture, of the pixel itself: 0 for
                what the camera alone contributes, ``error_px`` for a point clicked as well as those
                that were fitted.

        Returns:
            (N, 2, 2) square metres; NaN for points that the camera does not show, and for all of
            them without a camera.
        """
        ground = np.asarray(ground, dtype=np.float64)
        if self.camera is None:
            return np.full((len(ground), 2, 2), np.nan)
        covariance_px = self.projected_covariance(np.column_stack((ground, np.zeros(len(ground)))))
        return ground_covariance(self.camera, ground, covariance_px + pixel_sd**2 * np.eye(2))

    @property
    def uncertainty(self) -> dict[str, Any] | None:
        """Plain numbers that `restored` makes standard deviations of; None for homographies and
        failed fits."""
        if self.basis is not None or self.vector is None or self.covariance is None:
            return None
        numbers = {"vector": self.vector.tolist(), "covariance": self.covariance.tolist()}
        return {"size": list(self.size), "pixel_aspect": self.pixel_aspect, **numbers}

    @classmethod
    def restored(cls, camera: PosedCamera, record: Any) -> FitResult | None:
        """A fit with its covariance from `uncertainty`, as a file holds it; None if it is none. The
        camera is in px of the record's size."""
        try:
            width, height, aspect = (float(v) for v in (*record["size"], record["pixel_aspect"]))
            if "vector" not in record and isinstance(camera, PinholeCamera):
                frame = ImageFrame((int(width), int(height)), aspect)
                record = {**record, "vector": vector_from_camera(camera, frame)}
            vector = np.array(record["vector"], dtype=np.float64)
            covariance = np.array(record["covariance"], dtype=np.float64)
        except (KeyError, TypeError, ValueError, ArithmeticError):
            return None
        known = np.isfinite((width, height, aspect)).all() and min(width, height, aspect) > 0
        free = len(covariance) if covariance.ndim == 2 else 0
        if not known or vector.shape not in ((11,), (13,)) or not 0 < free <= len(vector):
            return None
        if covariance.shape != (free, free) or not np.isfinite(covariance).all():
            return None
        size = int(width), int(height)
        return cls("", size, camera, covariance=covariance, vector=vector, pixel_aspect=aspect)

    def annotated_sd(self, points_world: FloatArray, normals: FloatArray) -> FloatArray:
        """Standard deviation of where elements are annotated that took no part: of the camera, of
        what all points of such an element share, and of a click.

        Args:
            points_world: (N, 3) metres, world frame.
            normals: (N, 2) unit vectors in the picture, the directions in question.

        Returns:
            (N,) px; NaN as for `projected_covariance`.
        """
        assert self.camera is not None  # for callers to check
        here = self.camera.project(points_world)[0]
        shared_m, shared_px = self.shared_if_any
        by_camera = self if self.if_shared is None else replace(self, covariance=self.if_shared)
        squares = by_camera.projected_sd(points_world, normals) ** 2
        squares += (self.error_px or 0.0) ** 2 + shared_px**2
        for step in DISPLACEMENT_M * np.eye(3)[:2]:
            moved = self.camera.project(points_world + step)[0] - here
            squares += (shared_m / DISPLACEMENT_M * (moved * normals).sum(axis=1)) ** 2
        return np.asarray(np.sqrt(squares))


# Standard deviations beyond which a camera is hardly determined: about twice what the worst of the
# 186 frames of World Cup 2014 have (model R: 0.5 degrees, 6.4 % of the way, 7 % of the focal
# length).
MAX_ANGLE_SD_DEGREES = 1.0
MAX_POSITION_SD_SHARE = 0.15  # of the way to the centre of the field
MAX_FOCAL_SD_SHARE = 0.1
_LOOKING_DOWN_COSINE = 0.35  # sine of the tilt
ILL_CONDITIONED_LIMITS = translatable(
    "pan, tilt or roll ± more than {degrees:g}°, position ± more than {way:g} % of the way to the"
    " field's centre, or focal length ± more than {focal:g} %, or clicks that are the same from the"
    " other end",
    degrees=MAX_ANGLE_SD_DEGREES,
    way=100 * MAX_POSITION_SD_SHARE,
    focal=100 * MAX_FOCAL_SD_SHARE,
)


def ill_conditioned_reason(fit: FitResult) -> str:
    """Return what the points leave open beyond the limits, in words: ``pan ± 1.4°, position ± 12
    m``.

    Empty where they determine the camera, and for fits without a pose: homographies, and those
    that failed.
    """
    known, camera = fit.deviations, fit.camera
    if known is None or not isinstance(camera, PosedCamera):
        return ""
    pan, roll = _pan_roll_deviations(fit)
    angles = (
        (word("pan ± {degrees:.1f}°"), pan),
        (word("tilt ± {degrees:.1f}°"), known.tilt_rad),
        (word("roll ± {degrees:.1f}°"), roll),
    )
    words = [
        translatable(text, degrees=math.degrees(sd))
        for text, sd in angles
        if not math.degrees(sd) <= MAX_ANGLE_SD_DEGREES
    ]
    away = math.hypot(*known.position_m)
    if not away <= MAX_POSITION_SD_SHARE * math.hypot(*camera.position_world):
        words.append(translatable("position ± {metres:.0f} m", metres=away))
    share = known.focal_px / camera.focal_px[1]
    if not share <= MAX_FOCAL_SD_SHARE:
        words.append(translatable("focal length ± {percent:.0f} %", percent=100 * share))
    if fit.other_end:
        words.append(translatable("the same from the other end"))
    return translatable_joined(", ", words) if words else ""


def _pan_roll_deviations(fit: FitResult) -> tuple[float, float]:
    """Standard deviations, rad. A camera that looks down turns about the vertical by either: what
    counts is their sum, and of their difference what it tilts the camera by."""
    known, covariance, vector = fit.deviations, fit.covariance, fit.vector
    assert known is not None  # asked for pinholes only
    if covariance is None or vector is None or abs(math.sin(vector[TILT])) > _LOOKING_DOWN_COSINE:
        return known.pan_rad, known.roll_rad
    both = np.zeros(len(covariance))
    both[PAN], both[ROLL] = 1.0, math.cos(vector[TILT])
    together = math.sqrt(max(float(both @ covariance @ both), 0.0))
    return together, abs(math.sin(vector[TILT])) * known.pan_rad


# What a given camera may show an element next to its paint by, px at 960 px width: such cameras
# come from paint or from points, not from a guess.
_ASSUMED_SD_PX = 1.5


@dataclass(frozen=True, eq=False)
class ExternalCameraFit(FitResult):
    """A camera that was not fitted: elements are annotated within `error_px` of it."""

    def projected_covariance(self, points_world: FloatArray) -> FloatArray:
        """(N, 2, 2) px squared: none."""
        return np.zeros((len(points_world), 2, 2))


def external_camera_fit(
    camera: PinholeCamera | HomographyCamera, size: tuple[int, int]
) -> ExternalCameraFit:
    """A camera in px of a picture, with what it may be off by in this picture."""
    return ExternalCameraFit("given", size, camera, error_px=_ASSUMED_SD_PX * (size[0] - 1) / 959)


# Farther off than this on the median element, a camera explains nothing.
_HOPELESS_ERROR_PX = 2 * OUTLIER_PX


def fit_result_from(
    found: CameraSolution, field: Field, frame: ImageFrame, model: str, warm: bool
) -> FitResult:
    """Return what a fit hands back: its camera with residuals and uncertainty, or what speaks
    against it; ``warm``: whether it came from a start."""
    problem = _failure_reason(found, field)
    if problem is not None:
        return FitResult(model, frame.size, None, problem)
    noise = estimate_noise(found, frame)
    covariance = noise.of_all
    camera: PinholeCamera | HomographyCamera | FisheyeCamera
    if found.basis is not None:
        matrix = homographies_from_corrections(found.vector[None], found.basis)[0]
        camera, deviations = homography_camera(matrix, frame), None
        names = tuple(f"h{row}{column}" for row in range(3) for column in range(3))[:8]
    else:
        of_vector = fisheye_from_vector if is_fisheye(found.vector) else camera_from_vector
        camera = of_vector(found.vector, frame)
        deviations = pose_deviations(found.vector, covariance, frame)
        names = parameter_names(model)
    return FitResult(
        model,
        frame.size,
        camera,
        None,
        _element_residuals(found, frame),
        deviations,
        noise.click_px / frame.scale,
        names,
        covariance,
        warm,
        found.vector,
        found.basis,
        other_end=is_opposite_end_possible(found, field, frame),
        offset_px=noise.offset_px / frame.scale,
        of_clicks=noise.of_clicks,
        information=parameter_information(found, noise.click_px),
        if_shared=noise.if_shared,
        shared_if_any=(noise.shared_if_any[0], noise.shared_if_any[1] / frame.scale),
        pixel_aspect=frame.pixel_aspect,
    )


def _failure_reason(found: CameraSolution, field: Field) -> str | None:
    """Why the best camera that was found is none."""
    if found.basis is None:
        problem = implausible_reason(found.vector, camera_placement_prior(field))
        if problem is not None:
            return problem
    means = found.seen.mean_per_element(found.distances)
    middle = float(np.median(means))
    if not middle <= _HOPELESS_ERROR_PX:
        return translatable(
            "no camera explains these elements together: the best one misses half of them by more"
            " than {px:.0f} px (are the labels right?)",
            px=middle,
        )
    return None


def _element_residuals(found: CameraSolution, frame: ImageFrame) -> tuple[ElementResidual, ...]:
    seen = found.seen
    shown = np.split(picture_distances(found, frame), seen.starts[1:])
    counted = np.split(found.distances / frame.scale, seen.starts[1:])
    uncertain = np.full(len(seen.element_of_point), frame.pixel_aspect != 1)
    if seen.spreads is not None:
        uncertain |= seen.spreads.any(axis=(1, 2))
    return tuple(
        ElementResidual(
            element.name,
            tuple(shown[i].tolist()),
            bool(found.left_out[i]),
            tuple(counted[i].tolist()) if uncertain[seen.starts[i]] else None,
        )
        for i, element in enumerate(seen.elements)
    )


def pose_deviations(
    vector: FloatArray, covariance: FloatArray, frame: ImageFrame
) -> PoseStandardDeviations:
    """Standard deviations of a pinhole camera's pose, from the covariance of its parameters."""
    sd = np.sqrt(np.maximum(np.diag(covariance), 0.0)).tolist()
    focal = float(np.exp(vector[LOG_FOCAL])) / frame.scale
    return PoseStandardDeviations(
        sd[0], sd[1], sd[2], (sd[X], sd[X + 1], sd[Z]), focal * sd[LOG_FOCAL]
    )
