"""What one camera source makes of a frame, small enough to keep for every frame of a set.

Plots, triage and reports are drawn from these; scores themselves are computed as everywhere.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.field.landmarks import element_titles
from procc_annotator.io.camera_files.fitted_on import NOT_FITTED, FitCounts
from procc_annotator.metric.measure import Measurement, nearest_points
from procc_annotator.metric.score import jac_curve, display_score

# Every threshold a slider can take, so that moving it computes nothing: 1.2 KB a frame.
TAU_GRID = np.round(np.arange(0.5, 30.05, 0.1), 1)


@dataclass(frozen=True, slots=True)
class Pose:
    """Where a camera stands and looks; degrees, metres, px of the evaluation size."""

    pan_deg: float
    tilt_deg: float
    roll_deg: float
    focal_px: float
    position_world: tuple[float, float, float]


@dataclass(frozen=True, eq=False, slots=True)
class FrameAudit:
    """One frame under one camera source.

    n points are those of annotated classes that the camera shows, under the better labelling
    at the threshold the frame was audited at.

    Attributes:
        frame: its name.
        model: the camera's model, for people.
        jac: (T,) float32, JaC at each of `TAU_GRID`.
        class_rows: (n,) place of each point's class, as the annotator labelled it, in
            `element_titles`; -1 for one without geometry.
        points_px: (n, 2) float32 px of the evaluation size.
        residuals_px: (n, 2) float32, nearest projected position minus clicked point; NaN where
            the protocol gives a point no distance.
        pose: None for models without one (homographies, projections alone).
        mirrored: whether the better labelling is a mirrored one; not on a tie.
        fitted: whether the camera was fitted to the annotation it is judged by.
        counted_rows: (n,) as ``class_rows``, of the class that the better labelling counts the
            point for, which its JaC is that of; None where these are all the annotator's.
    """

    frame: str
    model: str
    jac: NDArray[np.float32]
    class_rows: NDArray[np.int16]
    points_px: NDArray[np.float32]
    residuals_px: NDArray[np.float32]
    pose: Pose | None
    mirrored: bool = False
    fitted: FitCounts = NOT_FITTED
    counted_rows: NDArray[np.int16] | None = None

    @property
    def errors_px(self) -> NDArray[np.float32]:
        """(n,) distances, px."""
        return np.hypot(self.residuals_px[:, 0], self.residuals_px[:, 1])

    def jac_at(self, tau: float) -> float:
        """JaC at the threshold of `TAU_GRID` nearest to ``tau``."""
        return float(self.jac[int(np.argmin(np.abs(TAU_GRID - tau)))])


def audit_frame(
    frame: str,
    camera: CameraOrProjections,
    model: str,
    measurement: Measurement,
    tau: float,
    *,
    fitted: FitCounts = NOT_FITTED,
) -> FrameAudit:
    """Keep what plots and reports need of a measured frame.

    Args:
        frame: its name.
        camera: in px of the evaluation size.
        model: the camera's model, for people.
        measurement: of the frame's annotation against the camera.
        tau: px, decides whether mirrored labels count; on a tie the labels as they are.
        fitted: whether the camera was fitted to the annotation.
    """
    read = display_score(measurement, tau)
    labelling = read.labelling
    nearest = nearest_points(measurement, labelling)
    counts = np.array(labelling.point_counts, dtype=np.intp)
    starts = np.cumsum(counts) - counts
    kept = [i for i, feet in enumerate(nearest) if feet is not None]
    feet = [f for f in nearest if f is not None]
    points = [measurement.points_px[starts[i] : starts[i] + counts[i]] for i in kept]
    places = {name: i for i, name in enumerate(element_titles(measurement.setup.field))}
    rows, counted = (
        np.repeat(np.array([places.get(names[i], -1) for i in kept], dtype=np.int16), counts[kept])
        for names in (measurement.plain.names, labelling.names)
    )
    residuals = _concatenate_rows([f - p for f, p in zip(feet, points, strict=True)])
    # A foot is found where the protocol knows no distance, too.
    residuals[np.isnan(labelling.all_distances)] = np.nan
    return FrameAudit(
        frame,
        model,
        jac_curve(measurement, TAU_GRID).astype(np.float32),
        rows,
        _concatenate_rows(points),
        residuals,
        pose_in_degrees(camera),
        read.mirrored,
        fitted,
        counted if read.mirrored else None,
    )


def pose_in_degrees(camera: CameraOrProjections) -> Pose | None:
    """A camera's pose, or None for a model that has none."""
    if not isinstance(camera, PinholeCamera | FisheyeCamera):
        return None
    return Pose(
        math.degrees(camera.pan_rad),
        math.degrees(camera.tilt_rad),
        math.degrees(camera.roll_rad),
        camera.focal_px[0],
        camera.position_world,
    )


def _concatenate_rows(parts: list[NDArray[np.float64]]) -> NDArray[np.float32]:
    if not parts:
        return np.empty((0, 2), dtype=np.float32)
    return np.concatenate(parts).astype(np.float32)
