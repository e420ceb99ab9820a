"""Lenses of two coefficients and fisheyes: projected, differentiated, fitted and chosen."""

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator import load_annotation
from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.calibration import camera_file
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.joint.shared_position import fit_shared_position
from procc_annotator.calibration.label_check.check import check_labels
from procc_annotator.calibration.label_check.finding import Rule, Severity
from procc_annotator.calibration.optimization.camera_parameters import (
    FREE_PARAMETERS,
    KAPPA,
    SECOND_KAPPA,
    camera_from_vector,
    fisheye_from_vector,
    wide_angle_vector_from_camera,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.projection import Lens, project
from procc_annotator.calibration.prediction.ghosts import find_ghosts
from procc_annotator.calibration.result import ill_conditioned_reason
from procc_annotator.camera.models import FisheyeCamera, PinholeCamera
from procc_annotator.field.load import load_field
from tests.unit.calibration.conftest import SIZE, Views

COURT = load_field("basketball_fiba")
VIEWS = Views(COURT)
FRAME = ImageFrame(SIZE)
GROUND = np.array([(x, y, 0.0) for x in np.linspace(-13, 13, 27) for y in np.linspace(-7, 7, 15)])
POSE = (0.15, 1.2, 0.005, (2.0, 14.0, -6.0))
FISHEYE = FisheyeCamera(*POSE, (520, 520), (483, 265), (-0.03, 0.01, 0, 0))
RADIAL = PinholeCamera(*POSE, (520, 520), (483, 265), (-0.28, 0.09, 0, 0, 0, 0))
CAMERAS = {"F": FISHEYE, "R2": RADIAL}


def clicks(camera, seed: int = 0) -> FrameAnnotation:
    return VIEWS.clicks(camera, np.random.default_rng(seed), 0.7)


def off(camera, other) -> float:
    """Median distance over the court in view, px."""
    (a, seen), (b, also) = camera.project(GROUND), other.project(GROUND)
    inside = seen & also & (a > 0).all(axis=1) & (a < np.array(SIZE) - 1).all(axis=1)
    return float(np.median(np.hypot(*(a - b)[inside].T)))


@pytest.mark.parametrize("model", CAMERAS)
def test_the_solver_sees_what_the_camera_shows(model):
    vector = wide_angle_vector_from_camera(CAMERAS[model], FRAME)
    of_vector = fisheye_from_vector if model == "F" else camera_from_vector
    again = of_vector(vector, FRAME)
    shown, valid = CAMERAS[model].project(GROUND)
    assert again.project(GROUND)[0][valid] == pytest.approx(shown[valid])
    lens = Lens.of(vector[None], FRAME.half_diagonal)
    world = GROUND.T[None]
    pixels, _, _ = project(lens, world, np.zeros_like(world), FREE_PARAMETERS[model])
    expected = (shown - np.array(FRAME.centre_px)) * FRAME.scale
    near = valid & (np.abs(expected) < 1000).all(axis=1)
    assert pixels[0].T[near] == pytest.approx(expected[near], abs=1e-6)
    straight = lens.undistorted(expected[near].T)[0]
    place = lens.linear[0, :, :3] @ GROUND[near].T + lens.linear[0, :, 3:]
    assert straight == pytest.approx(place[:2] / place[2], abs=1e-3)


@pytest.mark.parametrize("model", CAMERAS)
def test_derivatives_are_those_of_differences(model):
    vector = wide_angle_vector_from_camera(CAMERAS[model], FRAME)
    world = GROUND[(np.abs(GROUND[:, 0] - 2) < 6)].T[None]
    along = np.broadcast_to(np.array([0.6, -0.8, 0.0])[:, None], world.shape[1:])[None]

    def at(changed, place=world):
        lens = Lens.of(changed[None], FRAME.half_diagonal)
        return project(lens, place, along, FREE_PARAMETERS[model])

    _, moved, found = at(vector)
    for i in range(FREE_PARAMETERS[model]):
        step = np.zeros(len(vector))
        step[i] = 1e-5
        difference = (at(vector + step)[0] - at(vector - step)[0]) / 2e-5
        assert found[:, i] == pytest.approx(difference, rel=1e-4, abs=1e-3)
    difference = (at(vector, world + 1e-4 * along)[0] - at(vector, world - 1e-4 * along)[0]) / 2e-4
    assert moved == pytest.approx(difference, rel=1e-4, abs=1e-3)


@pytest.mark.parametrize("model", CAMERAS)
def test_a_strong_lens_is_found_where_one_coefficient_is_not_enough(model):
    annotation = clicks(CAMERAS[model])
    plain = fit_camera(annotation, COURT, model="R+")
    fit = fit_camera(annotation, COURT, model=model)
    assert off(CAMERAS[model], fit.camera) < 1.0
    assert not fit.left_out
    assert fit.mean_px < 0.7 * plain.mean_px
    assert len(fit.parameters) == len(fit.covariance) == FREE_PARAMETERS[model]
    chosen = fit_camera(annotation, COURT, model="auto")
    assert chosen.model in CAMERAS
    assert off(CAMERAS[model], chosen.camera) < 1.5
    assert "brings the points from" in chosen.chosen_because


def test_a_strong_lens_is_looked_for_where_many_elements_fit_no_pinhole():
    """Few points an element: none of them is seen to be bent."""
    pitch = load_field("soccer")
    pose = (0.726, 1.358, -0.004, (-26.2, 48.9, -16.1))
    camera = FisheyeCamera(*pose, (454, 454), (473.8, 269.1), (-0.0366, 0.0089, 0, 0))
    annotation = Views(pitch).clicks(camera, np.random.default_rng(3), 0.7)
    assert len(fit_camera(annotation, pitch, model="R+").left_out) >= 3
    fit = fit_camera(annotation, pitch, model="auto")
    assert (fit.model, fit.left_out) == ("F", ())
    assert fit.mean_px < 1.0
    without = fit_camera(annotation, pitch, model="R")
    findings = check_labels(annotation, pitch, size=without.size, fit=without)
    assert Rule.RESIDUAL not in {finding.rule for finding in findings}


def test_a_panorama_is_a_fisheye_and_its_labels_are_right(shared_data):
    annotation = load_annotation(shared_data / "inputs" / "pano_auto" / "pano.json")
    pitch, size = load_field("soccer"), (6500, 1000)
    fit = fit_camera(annotation, pitch, model="auto", size=size)
    assert (fit.model, fit.left_out) == ("F", ())
    assert fit.mean_px == pytest.approx(5.0, abs=0.1)
    without = fit_camera(annotation, pitch, model="R", size=size)
    findings = check_labels(annotation, pitch, size=size, fit=without)
    assert {finding.severity for finding in findings} <= {Severity.HINT}


@pytest.mark.parametrize("model", [*CAMERAS, "auto"])
def test_it_goes_on_from_the_camera_before(model):
    camera = CAMERAS.get(model, FISHEYE)
    fit = fit_camera(clicks(camera), COURT, model=model)
    again = fit_camera(clicks(camera, 1), COURT, model=model, start=fit.camera)
    assert again.warm
    assert again.model == fit.model
    assert off(camera, again.camera) < 1.0


def test_an_ordinary_lens_stays_ordinary():
    camera = replace(RADIAL, focal_px=(900, 900), radial=(0.05, 0, 0, 0, 0, 0))
    fit = fit_camera(clicks(camera), COURT, model="auto")
    assert fit.model in ("P", "R", "R+")
    after_fisheye = fit_camera(clicks(camera), COURT, model="auto", start=FISHEYE)
    assert after_fisheye.model == fit.model


@pytest.mark.parametrize("model", CAMERAS)
def test_what_it_says_of_itself_holds(model):
    camera = CAMERAS[model]
    shown, valid = camera.project(GROUND)
    inside = valid & (shown > 0).all(axis=1) & (shown < np.array(SIZE) - 1).all(axis=1)
    shares = []
    for seed in range(24):
        fit = fit_camera(clicks(camera, seed), COURT, model=model, start=camera)
        sd = fit.projected_sd(GROUND[inside])
        error = np.hypot(*(fit.camera.project(GROUND[inside])[0] - shown[inside]).T)
        shares.append((error < 2 * sd).mean())
        assert ill_conditioned_reason(fit) == ""
    assert np.mean(shares) > 0.9


@pytest.mark.parametrize("model", CAMERAS)
def test_ghosts_and_the_label_check_go_by_it(model):
    camera, annotation = CAMERAS[model], clicks(CAMERAS[model])
    hidden = annotation.annotated[3]
    kept = FrameAnnotation(tuple(p for p in annotation.polylines if p.class_name != hidden))
    fit = fit_camera(kept, COURT, model=model, start=camera)
    assert hidden in {ghost.name for ghost in find_ghosts(kept, COURT, fit)}
    told = {f.rule for f in check_labels(annotation, COURT, size=SIZE, fit=fit)}
    assert not told & {Rule.BENT, Rule.RESIDUAL, Rule.POINT, Rule.REFLECTED}


def test_positions_are_shared_by_fisheyes_too():
    cameras = {f"f{i}": replace(FISHEYE, pan_rad=p) for i, p in enumerate((-0.1, 0.05, 0.2, 0.3))}
    frames = {name: clicks(c, i) for i, (name, c) in enumerate(cameras.items())}
    alone = {n: fit_camera(a, COURT, model="F", start=cameras[n]) for n, a in frames.items()}
    shared = fit_shared_position(frames, alone, COURT)
    assert [len(tripod.frames) for tripod in shared.groups] == [4]
    assert np.abs(shared.groups[0].position_m - np.array(POSE[3])).max() < 0.15
    for name, fit in shared.fits.items():
        assert off(cameras[name], fit.camera) < 1.0


def test_lenses_that_fold_show_nothing_twice():
    vector = wide_angle_vector_from_camera(RADIAL, FRAME)
    vector[KAPPA], vector[SECOND_KAPPA] = -0.4, 0.0
    lens = Lens.of(vector[None], FRAME.half_diagonal)
    world = GROUND.T[None]
    beyond = lens.is_beyond_fold(world)
    folded = ~camera_from_vector(vector, FRAME).project(GROUND)[1]
    depth = (lens.linear[0, 2, :3] @ world[0] + lens.linear[0, 2, 3]) > 0.001
    assert (beyond[0][depth] == folded[depth]).all()


def test_a_fisheye_is_written_so_that_it_is_read_again():
    from procc_annotator.formats.cameras.registry import read_camera_file

    fit = fit_camera(clicks(FISHEYE), COURT, model="F", start=FISHEYE)
    name, data = camera_file("00001", fit)
    assert name == "00001.yml"
    again = read_camera_file(data, path=name).camera
    assert isinstance(again, FisheyeCamera)
    assert again.project(GROUND)[0] == pytest.approx(fit.camera.project(GROUND)[0], abs=1e-6)
