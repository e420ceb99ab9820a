"""Turned labels are found in a set, told with a remedy, and only where they can be turned."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.assist.frame_analysis import rename_classes
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.candidate_classes import relabelled
from procc_annotator.calibration.label_check.check import (
    FittedPosition,
    OppositeSideFrame,
    find_opposite_frames,
    fitted_position,
    opposite_side_finding,
)
from procc_annotator.calibration.label_check.finding import RemedyKind, Rule, Severity
from procc_annotator.camera.models import PinholeCamera

STAND = FittedPosition((0.0, -70.0, -16.0), ((0.1, 0, 0), (0, 1.0, 0), (0, 0, 0.1)), "R", True)
FOUND = OppositeSideFrame(5, 9, STAND)


@pytest.fixture(scope="module")
def frames(views) -> dict[str, FrameAnnotation]:
    rng = np.random.default_rng(8)
    made = {}
    for i, pan in enumerate(np.deg2rad([-28, -15, 4, 17, 30])):
        tilt = float(np.arctan2(np.hypot(70, 60 * np.tan(pan)), 16))
        camera = PinholeCamera(pan, tilt, 0.0, (0, 70, -16), (1700, 1700), (479.5, 269.5))
        made[f"f{i}"] = views.clicks(camera, rng)
    return made


def test_turned_frames_are_found_and_turned_back(frames, field) -> None:
    turned = {name: field.half_turn.name_of(name) for name in field.index}
    given = {n: relabelled(a, turned) if n == "f3" else a for n, a in frames.items()}
    stands = {name: fitted_position(fit_camera(a, field)) for name, a in given.items()}
    found = find_opposite_frames(stands, field)
    assert set(found) == {"f3"}
    finding = opposite_side_finding(given["f3"], field, found["f3"])
    assert (finding.rule, finding.severity) == (Rule.OTHER_SIDE, Severity.ERROR)
    (remedy,) = finding.remedies
    assert remedy.kind is RemedyKind.RELABEL
    mended = rename_classes(given["f3"], dict(remedy.renamed), field)
    assert mended == frames["f3"]


def test_a_homography_and_a_failed_fit_stand_nowhere(frames, field) -> None:
    assert fitted_position(fit_camera(frames["f1"], field, model="H")) is None
    assert fitted_position(fit_camera(FrameAnnotation(()), field)) is None


def test_a_field_whose_sides_differ_tells_by_itself(frames, field) -> None:
    stands = {name: fitted_position(fit_camera(a, field)) for name, a in frames.items()}
    stands["f0"] = replace(stands["f0"], position_m=(0.0, -70.0, -16.0))
    assert find_opposite_frames(stands, replace(field, symmetries=())) == {}


def test_labels_that_half_a_turn_leaves_as_they_are_say_nothing(field) -> None:
    middle = FrameAnnotation((Polyline("Middle line", (Point(0.2, 0.2), Point(0.3, 0.6))),))
    assert opposite_side_finding(middle, field, FOUND) is None


@pytest.mark.parametrize(
    ("found", "severity"),
    [
        (replace(FOUND, stand=replace(STAND, is_sure=False)), Severity.WARNING),
        (replace(FOUND, opposite=0), Severity.HINT),
    ],
)
def test_how_sure_it_is(frames, field, found, severity) -> None:
    finding = opposite_side_finding(frames["f2"], field, found)
    assert finding.severity is severity
    assert RemedyKind.RELABEL in {remedy.kind for remedy in finding.remedies}
