"""Cameras from matrices and functions, and cameras of others whose answers are checked."""

import pickle
from dataclasses import replace

import cv2
import numpy as np
import pytest

from procc_annotator import (
    FisheyeCamera,
    FitResult,
    MatrixCamera,
    PinholeCamera,
    UsageError,
    camera_from_function,
    camera_from_homography,
    camera_from_krt,
    camera_from_projection,
    disagreement,
    evaluate,
    evaluate_set,
    fit_camera,
    jac_curve,
    load_annotation,
    load_camera,
    project_field,
    save_camera,
)
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.matrices import calibration_matrix, translation

SIZE = (960, 540)
CAMERA = PinholeCamera(
    0.3, np.deg2rad(77), 0.01, (3.0, 62.0, -17.0), (1480.0, 1470.0), (479.5, 269.5)
)
WIDE = replace(CAMERA, focal_px=(500.0, 500.0))
K, R, T = calibration_matrix(CAMERA), CAMERA.rotation_cam_from_world, translation(CAMERA)
P = K @ np.column_stack((R, T))
PLACES = np.random.default_rng(5).uniform((-60, -40, -5), (60, 40, 0), (200, 3))


def the_same(camera, places=PLACES) -> None:
    (px, valid), (expected, seen) = camera.project(places), CAMERA.project(places)
    assert valid.tolist() == seen.tolist()
    np.testing.assert_allclose(px[valid], expected[seen], atol=1e-6)


def test_a_camera_from_opencv_s_matrices():
    the_same(camera_from_krt(K, R, T, size=SIZE))
    the_same(camera_from_krt(K.tolist(), cv2.Rodrigues(R)[0], T[:, None]))
    bent = camera_from_krt(K, R, T, distortion=(-0.1, 0.02, 0.001, 0.002))
    expected = cv2.projectPoints(PLACES, R, T, K, np.array((-0.1, 0.02, 0.001, 0.002)))[0][:, 0]
    px, valid = bent.project(PLACES)
    np.testing.assert_allclose(px[valid], expected[valid], atol=1e-6)
    assert camera_from_krt(K, R, T, distortion=(0.1, 0, 0, 0), fisheye=True).coefficients[0] == 0.1


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ((K[:2], R, T), "K is not 3 x 3"),
        ((K, 2 * R, T), "R is no rotation"),
        ((K, R, T[:2]), "t is not 3"),
        (("K", R, T), "k: expected numbers, found str"),
        ((K + np.array([[0, 5, 0], [0, 0, 0], [0, 0, 0]]), R, T), "skew"),
    ],
)
def test_matrices_that_are_no_camera(given, says):
    with pytest.raises(UsageError, match=says):
        camera_from_krt(*given)


@pytest.mark.parametrize("fisheye", [False, True])
def test_the_distortion_as_opencv_gives_it(fisheye):
    row = np.array([[-0.1, 0.02, 0.0, 0.0]])
    expected = camera_from_krt(K, R, T, distortion=row[0].tolist(), fisheye=fisheye)
    for given in (row, row.T):
        assert camera_from_krt(K, R, T, distortion=given, fisheye=fisheye) == expected
    assert camera_from_krt(K, R, T, distortion=None) == camera_from_krt(K, R, T)
    for wrong in (np.nan, np.inf):
        with pytest.raises(UsageError, match="distortion is not finite"):
            camera_from_krt(K, R, T, distortion=[wrong, 0, 0, 0], fisheye=fisheye)


@pytest.mark.parametrize("factor", [1.0, -1.0, 1e-4, -3e5])
def test_a_camera_from_a_projection_matrix_of_any_scale(factor):
    camera = camera_from_projection(factor * P)
    the_same(camera)
    the_same(camera, CAMERA.position_world + PLACES / 40)  # all about it, behind it too
    px = np.array([[480.0, 400.0], [100.0, 500.0], [480.0, -9000.0]])
    np.testing.assert_allclose(ground_from_px(camera, px), ground_from_px(CAMERA, px), atol=1e-6)
    assert isinstance(camera, PinholeCamera)
    np.testing.assert_allclose(camera.position_world, CAMERA.position_world, atol=1e-6)
    np.testing.assert_allclose(camera.focal_px, CAMERA.focal_px, atol=1e-6)
    assert (camera.pan_rad, camera.tilt_rad, camera.roll_rad) == pytest.approx(
        (CAMERA.pan_rad, CAMERA.tilt_rad, CAMERA.roll_rad)
    )
    larger = camera.scaled(SIZE, (1920, 1080)).project(PLACES)[0]
    np.testing.assert_allclose(larger, CAMERA.scaled(SIZE, (1920, 1080)).project(PLACES)[0])


def test_a_projection_matrix_may_have_a_skew():
    skewed = K + np.array([[0.0, 9.0, 0.0], [0, 0, 0], [0, 0, 0]])
    camera = camera_from_projection(skewed @ np.column_stack((R, T)), size=SIZE)
    assert isinstance(camera, MatrixCamera)
    px, valid = camera.project(PLACES)
    moved = px[valid] - CAMERA.project(PLACES)[0][valid]
    assert np.abs(moved[:, 0]).max() > 1
    np.testing.assert_allclose(moved[:, 1], 0.0, atol=1e-9)
    for wrong in (P[:, :3], np.full((3, 4), np.nan), np.zeros((3, 4)), "P"):
        with pytest.raises(UsageError, match="matrix: "):
            camera_from_projection(wrong)


def test_a_camera_from_a_homography_either_way():
    ground = PLACES * (1, 1, 0)
    matrix = P[:, [0, 1, 3]]
    for camera in (
        camera_from_homography(-2 * matrix, SIZE),
        camera_from_homography(np.linalg.inv(matrix), SIZE, to_ground=True),
    ):
        the_same(camera, ground)
        assert not camera.project(PLACES)[1].any()
    for wrong in (np.zeros((3, 3)), P, np.full((3, 3), np.inf)):
        with pytest.raises(UsageError, match="matrix: no homography"):
            camera_from_homography(wrong, SIZE)


def through_opencv(points: np.ndarray) -> np.ndarray:
    px = cv2.projectPoints(points, R, T, K, None)[0][:, 0]
    px[(points @ R.T + T)[:, 2] <= 0] = np.nan
    return px


def test_a_function_is_judged_as_the_camera_it_is(sample_data):
    annotation = load_annotation(sample_data / "00002.json")
    true = load_camera(sample_data / "cameras" / "true" / "camera_00002.json")
    found = evaluate(annotation, true)
    assert found.jac > 0.9
    for function in (
        lambda points: true.camera.project(points),
        lambda points: np.where(
            true.camera.project(points)[1][:, None], true.camera.project(points)[0], np.nan
        ),
    ):
        camera = camera_from_function(function)
        told = evaluate(annotation, camera, camera_size=true.size)
        assert (told.tp, told.fp, told.fn) == (found.tp, found.fp, found.fn)
        assert told.mean_error == pytest.approx(found.mean_error, abs=1e-3)
    the_same(camera_from_function(through_opencv))
    assert (
        disagreement(camera_from_function(through_opencv), CAMERA).statistics.metres.median < 1e-4
    )


class Custom:
    """A camera as others write one."""

    def __init__(self, answer) -> None:
        self.answer = answer

    def project(self, points):
        return self.answer(*CAMERA.project(points))


def nan_marked_as_valid(px, valid):
    px[3] = np.nan
    return px, np.ones(len(px), bool)


@pytest.mark.parametrize(
    ("answer", "says"),
    [
        (lambda px, valid: px, r"the pixels and which of them are valid, found \(\d+, 2\) float64"),
        (lambda px, valid: None, "which of them are valid, found nothing"),
        (lambda px, valid: (px.T, valid), r"as \(\d+, 2\) numbers, found \(2, \d+\) float64"),
        (lambda px, valid: (px[:-1], valid), r"the pixels of \d+ points"),
        (lambda px, valid: (px.astype(str), valid), "numbers, found"),
        (lambda px, valid: (px * 1j, valid), "numbers, found .* complex128"),
        (lambda px, valid: (px, valid.astype(float)), r"\(\d+,\) bool, found \(\d+,\) float64"),
        (lambda px, valid: (px, valid[:, None]), r"bool, found \(\d+, 1\) bool"),
        (lambda px, valid: (px, True), "bool, found"),
        (
            nan_marked_as_valid,
            r"1 of \d+ points are said to be valid, but .* shown at \[nan, nan\]",
        ),
    ],
)
def test_answers_that_are_no_projection_are_told(answer, says, sample_data):
    annotation = load_annotation(sample_data / "00002.json")
    for protocol in ("soccernet", "procc"):
        with pytest.raises(UsageError, match=says):
            evaluate(annotation, Custom(answer), protocol=protocol)
    with pytest.raises(UsageError, match=says):
        project_field(Custom(answer))
    with pytest.raises(UsageError, match=says):
        jac_curve(annotation, Custom(answer), [1, 2])
    with pytest.raises(UsageError, match=says):
        disagreement(CAMERA, Custom(answer))
    with pytest.raises(UsageError, match="camera of 00002.* " + says):
        evaluate_set({"00002": annotation}, {"00002": Custom(answer)})
    with pytest.raises(UsageError, match=says):
        evaluate(annotation, Custom(answer), size=(1280, 720), camera_size=SIZE)


def test_pixels_of_whole_numbers_and_single_precision_will_do(sample_data):
    annotation = load_annotation(sample_data / "00002.json")
    camera = load_camera(sample_data / "cameras" / "true" / "camera_00002.json").camera
    exact = evaluate(annotation, camera)

    class Single:
        def project(self, points):
            px, valid = camera.project(points)
            return np.float32(px), valid

    assert evaluate(annotation, Single()).jac == exact.jac


def test_what_a_camera_offers_besides_is_used():
    class Ground(Custom):
        ground_only = True
        model = "of the ground"

        def scaled(self, from_size, to_size):
            return CAMERA.scaled(from_size, to_size)

        def project(self, points):
            return WIDE.project(points)

    pieces = project_field(Ground(None))
    assert not any("Goal" in name for name in pieces)
    assert any("Goal" in name for name in project_field(WIDE))
    pieces = project_field(CAMERA)
    twice = project_field(Ground(None), size=(1919, 1079), camera_size=SIZE)
    name = next(iter(pieces))
    np.testing.assert_allclose(twice[name][0][0], 2 * pieces[name][0][0], atol=1.0)


def test_what_is_no_camera_says_what_would_be():
    for wrong, says in (
        (np.eye(3), "camera_from_homography"),
        (through_opencv, "camera_from_function"),
        (None, "no camera to evaluate"),
        ("camera.json", "found str"),
    ):
        with pytest.raises(UsageError, match=says):
            project_field(wrong)
    with pytest.raises(UsageError, match="expected a function"):
        camera_from_function(CAMERA)


def test_a_matrix_camera_travels():
    skewed = (K + np.array([[0.0, 9.0, 0.0], [0, 0, 0], [0, 0, 0]])) @ np.column_stack((R, T))
    camera = camera_from_projection(skewed)
    assert isinstance(camera, MatrixCamera)
    again = pickle.loads(pickle.dumps(camera))  # noqa: S301
    assert [a.tolist() for a in again.project(PLACES)] == [
        a.tolist() for a in camera.project(PLACES)
    ]


BENT = replace(CAMERA, radial=(-0.12, 0.02, 0, 0, 0, 0), tangential=(0.001, 0.002))
FISHEYE = FisheyeCamera(
    0.3, np.deg2rad(77), 0.01, (3.0, 62.0, -17.0), (900.0, 900.0), (479.5, 269.5), (0.05, 0, 0, 0)
)


@pytest.mark.parametrize(
    "camera",
    [
        CAMERA, BENT, FISHEYE, camera_from_projection(P @ np.diag((1, 1, 1, 1.0))),
        camera_from_homography(P[:, [0, 1, 3]], SIZE), camera_from_function(BENT.project),
        camera_from_function(lambda points: FISHEYE.project(points)[0]),
    ],
)  # fmt: skip
def test_every_camera_goes_back_to_the_ground(camera):
    px = np.array([(100.0, 200.0), (480.0, 270.0), (900.0, 500.0), (480.0, -3000.0)])
    ground = camera.ground_from_px(px)
    assert np.isfinite(ground).all(axis=1).tolist() == [True, True, True, False]
    there = np.column_stack((ground[:3], np.zeros(3)))
    np.testing.assert_allclose(camera.project(there)[0], px[:3], atol=1e-4)


def test_a_fit_knows_how_surely_it_goes_back_also_from_its_file(sample_data, tmp_path):
    fit = fit_camera(load_annotation(sample_data / "00002.json"))
    ground = fit.ground_from_px(np.array([(480.0, 300.0), (480.0, 5.0)]))
    alone, clicked = (fit.ground_covariance(ground, pixel_sd=sd)[0] for sd in (0.0, 2.0))
    assert 0 < alone[0, 0] < clicked[0, 0] < 4
    save_camera(fit, tmp_path / "camera_00002.json")
    read = load_camera(tmp_path / "camera_00002.json")
    again = FitResult.restored(read.camera, read.extra["fit"]["uncertainty"])
    np.testing.assert_allclose(again.ground_covariance(ground)[0], alone, rtol=1e-6)
