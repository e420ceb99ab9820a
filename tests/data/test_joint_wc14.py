"""On real frames: games of one stadium are told by their camera, pitches are 105 x 68 m."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.joint.field_dimensions import fit_dimensions
from procc_annotator.calibration.joint.shared_position import (
    SharedPositionResult,
    fit_shared_position,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation

FIELD = load_field("soccer")
# Numbers of frames that follow each other are of one game.
RUNS = (range(97, 111), range(111, 126), range(126, 143))


@pytest.fixture(scope="module")
def frames(shared_data) -> dict[str, FrameAnnotation]:
    folder = shared_data / "wc14" / "annotations"
    paths = [folder / f"{number}.json" for run in RUNS for number in run]
    return {p.stem: read_annotation(p.read_bytes(), path=str(p), field=FIELD) for p in paths}


@pytest.fixture(scope="module")
def alone(frames) -> dict[str, FitResult]:
    return {name: fit_camera(a, FIELD, model="R") for name, a in frames.items()}


@pytest.fixture(scope="module")
def shared(frames, alone) -> SharedPositionResult:
    return fit_shared_position(frames, alone, FIELD)


def test_every_game_has_a_position_of_its_own(shared):
    expected = sorted(({str(n) for n in run} for run in RUNS), key=len, reverse=True)
    assert [set(t.frames) for t in shared.groups] == expected
    for tripod in shared.groups:
        assert (tripod.deviations_m < 0.25).all()
        assert tripod.scatter_m[1] > 3 * tripod.deviations_m[1]


def test_the_points_are_still_met(shared, alone):
    before = np.mean([fit.mean_px for fit in alone.values()])
    after = np.mean([fit.mean_px for fit in shared.fits.values()])
    assert before < after < 1.6 * before


@pytest.mark.parametrize("run", [RUNS[1], pytest.param(RUNS[2], marks=pytest.mark.soak)])
def test_world_cup_pitches_have_their_size(frames, alone, run):
    names = [str(number) for number in run]
    found = fit_dimensions({n: frames[n] for n in names}, {n: alone[n] for n in names}, FIELD)
    for dimension in found.dimensions:
        off = abs(dimension.dimension.value - dimension.dimension.nominal)
        assert dimension.is_determined
        assert off < 0.4
        assert off < 2.5 * dimension.sd_m
