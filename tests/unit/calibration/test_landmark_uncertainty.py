"""Landmarks whose place is not known exactly: what they say of a camera, and how surely."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.joint.adjustment import LensAndRollPrior
from procc_annotator.calibration.joint.shared_position import PositionGroup, fit_at_known_position
from procc_annotator.calibration.optimization.camera_parameters import vector_from_camera
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.projection import Lens
from procc_annotator.calibration.optimization.residuals import pinhole_residuals, whitened
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.model import Landmark

SIZE = (960, 540)
CLOSE_UP = PinholeCamera(
    np.deg2rad(5.8), np.deg2rad(83), 0.0, (0.0, 60.0, -15.0),
    (3500.0, 3500.0), (479.5, 269.5), (0.0, 0, 0, 0, 0, 0),
)  # fmt: skip
STAND = np.array(
    [(9, -38, -1), (2, -40, -2), (18, -41, -3), (12, -45, -8), (5, -44, -7), (15, -39, -1.0)]
)
SD_M = np.array([0.17, 0.45, 0.16])  # as two wide views a few degrees apart tell it
BESIDE = np.array([(10.0, -34.0, 0.0), (5.0, -40.0, -2.0), (18.0, -41.0, -3.0)])


def field_of(field, places: np.ndarray, sd_m: np.ndarray | None):
    covariance = None if sd_m is None else tuple(map(tuple, np.diag(sd_m**2).tolist()))
    return with_landmarks(
        field,
        [Landmark(f"L{i}", position=tuple(p), covariance=covariance) for i, p in enumerate(places)],
    )


def clicks(rng: np.random.Generator, noise_px: float = 1.0) -> FrameAnnotation:
    shown, _ = CLOSE_UP.project(STAND)
    off = shown + rng.normal(0, noise_px, shown.shape)
    return FrameAnnotation(
        tuple(Polyline(f"L{i}", (point_from_px(*p, SIZE),)) for i, p in enumerate(off))
    )


def squares(fit) -> np.ndarray:
    """(3,) squared Mahalanobis distances of where the fit shows places beside the landmarks."""
    off = fit.camera.project(BESIDE)[0] - CLOSE_UP.project(BESIDE)[0]
    return np.einsum("ni,nij,nj->n", off, np.linalg.inv(fit.projected_covariance(BESIDE)), off)


@pytest.mark.parametrize(("model", "warm"), [("P", False), ("auto", False), ("P", True)])
def test_ellipses_hold_what_the_landmarks_are_off(field, model, warm):
    rng = np.random.default_rng(0)
    found = []
    for _ in range(30):
        known = field_of(field, STAND + rng.normal(size=STAND.shape) * SD_M, SD_M)
        start = CLOSE_UP if warm else None
        fit = fit_camera(clicks(rng), known, model=model, size=SIZE, start=start)
        assert fit.camera is not None, fit.failure
        assert not fit.left_out
        found.append(squares(fit))
    assert 1.3 < np.mean(found) < 2.8  # 2 of two independent coordinates
    assert 0.9 <= np.mean(np.array(found) < 5.99) <= 0.99


def test_a_place_known_badly_hardly_moves_the_camera(field):
    """Five exact landmarks, and one that may be metres off and is."""
    rng = np.random.default_rng(1)
    annotation = clicks(rng, 0.3)
    places = STAND.copy()
    places[2] += (3.0, 0.0, -2.0)
    landmarks = list(field_of(field, places, None).landmarks)
    exact = with_landmarks(field, [m for m in landmarks if m.name != "L2"])
    landmarks[2] = field_of(field, places, np.full(3, 3.0)).landmarks[2]
    both = with_landmarks(field, landmarks)
    alone = fit_camera(annotation.without("L2"), exact, model="P", size=SIZE)
    fit = fit_camera(annotation, both, model="P", size=SIZE)
    shown = [f.camera.project(BESIDE[:2])[0] for f in (alone, fit)]
    assert np.abs(shown[0] - shown[1]).max() < 1.0
    # It is no mistake; how far off it is in the picture is told all the same.
    assert not fit.left_out
    (far,) = (e for e in fit.elements if e.name == "L2")
    at, _ = fit.camera.project(places[2:3])
    point = np.array(annotation.get("L2").points[0][:2]) * (np.array(SIZE) - 1)
    assert far.max_px == pytest.approx(float(np.hypot(*(at[0] - point))), rel=0.01)
    assert far.max_px > 50


def test_derivatives_are_those_of_the_softened_residual(field):
    rng = np.random.default_rng(2)
    frame = ImageFrame(SIZE)
    vector = vector_from_camera(CLOSE_UP, frame)
    seen = build_observations(clicks(rng, 5.0), field_of(field, STAND, SD_M), frame)
    seen = whitened(seen, Lens.of(vector[None], frame.half_diagonal).linear[0])
    found = pinhole_residuals(vector[None], seen, frame.half_diagonal, 7)
    for i, step in enumerate((1e-7, 1e-7, 1e-7, 1e-4, 1e-4, 1e-4, 1e-7)):
        ends = []
        for way in (step, -step):
            moved = vector.copy()
            moved[i] += way
            ends.append(pinhole_residuals(moved[None], seen, frame.half_diagonal, 7).values[0])
        slope = (ends[0] - ends[1]) / (2 * step)
        np.testing.assert_allclose(found.derivatives[0, i], slope, rtol=1e-3, atol=0.05)


def test_so_it_is_with_the_position_known(field):
    """A camera on its tripod: pan, tilt and zoom are told by landmarks."""
    rng = np.random.default_rng(3)
    sd_m = np.full(3, 0.01)
    usual = LensAndRollPrior((0.0, 0.001), (0.0, 0.02))
    place = np.array(CLOSE_UP.position_world)
    tripod = PositionGroup(("a", "b", "c"), place, np.diag(sd_m**2), sd_m, sd_m, usual)
    found = []
    for _ in range(30):
        known = field_of(field, STAND + rng.normal(size=STAND.shape) * SD_M, SD_M)
        fit = fit_at_known_position(clicks(rng), known, tripod, model="P", size=SIZE)
        assert fit.camera is not None, fit.failure
        found.append(squares(fit))
    # Held at a position the fit counts seven parameters all the same: it says rather too little.
    assert 0.8 < np.mean(found) < 2.5
    assert np.mean(np.array(found) < 5.99) >= 0.9
