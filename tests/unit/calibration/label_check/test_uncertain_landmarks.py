"""Landmarks are judged by what their own uncertainty allows where it is seen."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.check import check_labels
from procc_annotator.calibration.label_check.finding import Finding, RemedyKind, Rule, Severity
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.editing import swap_classes
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.model import Field, Landmark
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (960, 540)
CAMERA = PinholeCamera(
    np.deg2rad(25.0), np.deg2rad(79.0), 0.01, (0.0, 55.0, -16.0), (1150.0, 1150.0), (479.5, 269.5)
)
PLACES = {"Clock": (30.0, -44.0, -8.0), "Mast": (42.0, -42.0, -4.0), "Seat": (36.0, -38.0, -1.0)}
SD_M = 2.0  # 20 px


def field_of(field: Field, off_m: np.ndarray, sd_m: float | None = SD_M) -> Field:
    """With landmarks whose places, as they are known, are off by (3, 3) metres."""
    square = None if sd_m is None else tuple(map(tuple, (np.eye(3) * sd_m**2).tolist()))
    known = np.array(list(PLACES.values())) + off_m
    return with_landmarks(
        field,
        [
            Landmark(name, position=tuple(place), covariance=square)
            for name, place in zip(PLACES, known.tolist(), strict=True)
        ],
    )


def clicks(field: Field, rng: np.random.Generator) -> FrameAnnotation:
    """What somebody clicks of the field and of the places where they are, to about a pixel."""
    found = []
    for name, pieces in project_field(CAMERA, EvaluationSetup(field, SIZE, "procc")).pieces.items():
        if (element := field.element(name)) is None or element.is_spot:
            continue
        piece = max(pieces, key=len)
        many = 7 if element.is_curved else 3
        points = piece[np.linspace(0, len(piece) - 1, many).round().astype(int)]
        if np.hypot(*np.ptp(points, axis=0)) > 40:
            found.append((name, points))
    shown, _ = CAMERA.project(np.array(list(PLACES.values())))
    found += [(name, place[None]) for name, place in zip(PLACES, shown, strict=True)]
    return FrameAnnotation(
        tuple(
            Polyline(name, tuple(point_from_px(*p, SIZE) for p in points))
            for name, noisy in found
            for points in [noisy + rng.normal(0, 1.0, noisy.shape)]
        )
    )


def check(annotation: FrameAnnotation, field: Field) -> list[Finding]:
    fit = fit_camera(annotation, field, size=SIZE)
    found = check_labels(annotation, field, size=SIZE, fit=fit)
    return [f for f in found if f.severity is not Severity.HINT]


def test_what_its_own_uncertainty_allows_is_no_mistake(field) -> None:
    rng = np.random.default_rng(0)
    for _ in range(8):
        off = rng.normal(0, SD_M, (3, 3))
        annotation = clicks(field, rng)
        assert check(annotation, field_of(field, off)) == []
    assert check(annotation, field_of(field, off, None))  # off what is said to be exact


def test_more_than_that_is_one(field) -> None:
    rng = np.random.default_rng(1)
    off = np.zeros((3, 3))
    off[0] = (20.0, 0.0, -10.0)
    (finding,) = check(clicks(field, rng), field_of(field, off))
    assert (finding.rule, finding.elements[0]) == (Rule.RESIDUAL, "Clock")
    assert "more than its own place is uncertain" in finding.reason
    places = np.array([PLACES["Clock"], np.array(PLACES["Clock"]) + off[0]])
    seen = CAMERA.project(places)[0]
    # What is told is what one sees, not what counts of it.
    assert finding.error_px == pytest.approx(float(np.hypot(*(seen[0] - seen[1]))), rel=0.05)
    assert f"up to {finding.error_px:.0f} px" in finding.reason


def test_two_that_are_swapped_are_found(field) -> None:
    rng = np.random.default_rng(2)
    off = rng.normal(0, 0.4, (3, 3))
    swapped = swap_classes(clicks(field, rng), "Clock", "Mast")
    (finding,) = check(swapped, field_of(field, off, 0.4))
    assert finding.rule is Rule.SWAPPED
    assert set(finding.elements) == {"Clock", "Mast"}
    assert finding.remedies[0].kind is RemedyKind.SWAP


def test_mistakes_elsewhere_are_found_beside_them(field) -> None:
    rng = np.random.default_rng(3)
    known = field_of(field, rng.normal(0, SD_M, (3, 3)))
    wrong = swap_classes(clicks(field, rng), "Big rect. right top", "Small rect. right top")
    (finding,) = check(wrong, known)
    assert finding.rule is Rule.SWAPPED
    assert finding.severity is Severity.ERROR
