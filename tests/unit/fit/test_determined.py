"""When a camera counts as hardly determined."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from procc_annotator.api import fit_camera, load_annotation
from procc_annotator.field.load import load_field
from procc_annotator.fit.determined import hardly_determined
from procc_annotator.fit.solving.models import Z
from procc_annotator.fit.solving.plausible import objection
from procc_annotator.fit.solving.surroundings import surroundings_of

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
def test_what_is_left_open_is_told(changes, says) -> None:
    fit = fit_camera(FRAME)
    assert hardly_determined(replace(fit, deviations=replace(fit.deviations, **changes))) == says


def test_the_focal_length_counts_as_a_share() -> None:
    fit = fit_camera(FRAME)
    wide = replace(fit.deviations, focal_px=0.2 * fit.camera.focal_px[0])
    assert hardly_determined(replace(fit, deviations=wide)) == "focal length ± 20 %"
    assert hardly_determined(fit_camera(FRAME, model="H")) == ""


def test_a_height_of_nothing_is_not_below_the_ground() -> None:
    vector = fit_camera(FRAME).vector.copy()
    for z, says in ((0.01, "on the ground"), (-0.01, "on the ground"), (1.0, "1.0 m below")):
        vector[Z] = z
        assert says in objection(vector, surroundings_of(load_field()))
