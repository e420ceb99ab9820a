"""What a fit hands back: the camera or why there is none, its residuals, and how sure it is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.annotation import Polyline
from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.fit.solving.covariance import projected_covariance, max_direction_sd
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame, used_point_indices

PosedCamera = PinholeCamera | FisheyeCamera


@dataclass(frozen=True, slots=True)
class ElementResidual:
    """How far the points of one element are from where the fitted camera shows it.

    Attributes:
        name: the class.
        distances_px: of its points, px of the picture; repeated points are listed once, and of very
            many points some.
        left_out: whether it was taken for a mistake and had no say.
        counted_px: the same distances as they count, px: those of a landmark are smaller the less
            its own place is known; None where they count as they are.
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
        """Place in the polyline -> distance, px, of the points that have one.

        Args:
            polyline: the one that was fitted.
            size: (width, height) px of the picture.

        Returns:
            Nothing for another polyline, which has more points or fewer.
        """
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
        covariance: (n, n) of those, in the units of `fit.models`: what the noise of the clicks
            leaves open, and what elements that lie beside the model as a whole do to it.
        warm: whether the camera was found from the start that was given.
        vector: (11,) the solver's parameters of a pinhole, (13,) of a strong lens, or (8,)
            corrections of `basis`.
        basis: (3, 3) the homography that was corrected; None for a pinhole.
        chosen_because: why this model, in a sentence; None if it was asked for.
        other_end: whether the points may as well be seen from the other end of the field, half a
            turn about its centre; standard deviations tell nothing of that.
        offset_px: standard deviation of what an element lies beside the model by, all its points
            together, px of the picture; see `fit.solving.element_offsets`.
        of_clicks: (n, n) the part of the covariance that the noise of the clicks makes alone.
        fitted_on: `annotation_digest` of what it was fitted to, where that is kept.
    """

    model: str
    size: tuple[int, int]
    camera: PosedCamera | HomographyCamera | None
    failure: str | None = None
    elements: tuple[ElementResidual, ...] = ()
    deviations: PoseStandardDeviations | None = None
    error_px: float | None = None
    parameters: tuple[str, ...] = ()
    covariance: FloatArray | None = None
    warm: bool = False
    vector: FloatArray | None = None
    basis: FloatArray | None = None
    chosen_because: str | None = None
    other_end: bool = False
    offset_px: float = 0.0
    of_clicks: FloatArray | None = None
    fitted_on: str | None = None

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
        """How surely the fit knows where field points appear.

        Args:
            points_world: (N, 3) metres, world frame.

        Returns:
            (N, 2, 2) px squared; NaN for points that the camera does not show, and for all of them
            without a camera.
        """
        if self.covariance is None or self.vector is None:
            return np.full((len(points_world), 2, 2), np.nan)
        frame = ImageFrame(self.size)
        found = projected_covariance(
            self.vector, self.basis, frame.half_diagonal, self.covariance, points_world
        )
        return np.asarray(found / frame.scale**2)

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
