"""When a camera counts as hardly determined."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from procc_annotator import fit_camera, load_annotation
from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.optimization.camera_parameters import Z
from procc_annotator.calibration.optimization.camera_placement import (
    camera_placement_prior,
    implausible_reason,
)
from procc_annotator.calibration.result import ill_conditioned_reason
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from tests.bench.sports.views import Views

FRAME = load_annotation(Path(__file__).parents[3] / "sample_data" / "00002.json")


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({}, ""),
        ({"pan_rad": math.radians(1.4)}, "pan ± 1.4°"),
        ({"position_m": (8.0, 0.0, 9.0)}, "position ± 12 m"),
        ({"tilt_rad": math.nan}, "tilt ± nan°"),
    ],
)
def test_what_is_left_open_is_told(changes, says):
    fit = fit_camera(FRAME)
    assert (
        ill_conditioned_reason(replace(fit, deviations=replace(fit.deviations, **changes))) == says
    )


def test_the_focal_length_counts_as_a_share():
    fit = fit_camera(FRAME)
    wide = replace(fit.deviations, focal_px=0.2 * fit.camera.focal_px[0])
    assert ill_conditioned_reason(replace(fit, deviations=wide)) == "focal length ± 20 %"
    assert ill_conditioned_reason(fit_camera(FRAME, model="H")) == ""


def test_a_height_of_nothing_is_not_below_the_ground():
    vector = fit_camera(FRAME).vector.copy()
    for z, says in ((0.01, "on the ground"), (-0.01, "on the ground"), (1.0, "1.0 m below")):
        vector[Z] = z
        assert says in implausible_reason(vector, camera_placement_prior(load_field()))


@pytest.mark.parametrize("seed", range(3))
def test_one_mark_tells_the_ends_of_a_track_apart_and_lanes_alone_do_not(seed):
    """A bend with all its lanes, from behind it; the finish line is the only mark in sight."""
    track = Views(load_field("athletics"))
    true = PinholeCamera(
        1.47, 1.29, -0.02, (-133.0, 5.0, -23.0), (1560.0, 1560.0), (479.5, 269.5), (0.2, *[0.0] * 5)
    )
    annotation = track.clicks(true, np.random.default_rng(seed))
    fit = fit_camera(annotation, track.field)
    assert not fit.left_out
    assert "other end" not in ill_conditioned_reason(fit)
    assert track.median_error(true, fit.camera) < 6

    lanes = tuple(p for p in annotation.polylines if p.class_name != "Finish line")
    assert len(lanes) == len(annotation.polylines) - 1
    fit = fit_camera(FrameAnnotation(lanes), track.field)
    assert "the same from the other end" in ill_conditioned_reason(fit)


def test_a_field_that_is_the_same_from_both_ends_has_none():
    """Its labels go by where the main camera stands."""
    rink = Views(load_field("ice_hockey_iihf"))
    view = rink.random(np.random.default_rng(1))
    assert not fit_camera(view.annotation, rink.field).other_end
