"""A camera written from Python is one that the program reads, and what is in the way is told."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator import (
    FrameAnnotation,
    PinholeCamera,
    SaveError,
    UsageError,
    camera_from_function,
    camera_from_homography,
    evaluate,
    fit_camera,
    load_annotation,
    load_camera,
    save_camera,
)
from procc_annotator.camera.matrices import calibration_matrix, translation

SIZE = (960, 540)
CAMERA = PinholeCamera(
    0.3, np.deg2rad(77), 0.01, (3.0, 62.0, -17.0), (1480.0, 1480.0), (479.5, 269.5)
)
GROUND = np.random.default_rng(5).uniform((-60, -40, 0), (60, 40, 0), (50, 3))


@pytest.mark.parametrize(
    ("format", "name"),
    [("soccernet", "camera_1.json"), ("opencv", "1.yml"), ("krt", "1.json"),
     ("wc14", "1.homographyMatrix"), ("carwc", "1.npy"), ("world", "1.txt")],
)  # fmt: skip
def test_what_is_written_is_read_again(tmp_path, format, name) -> None:
    lost = save_camera(CAMERA, tmp_path / name, format=format, size=SIZE)
    read = load_camera(tmp_path / name, format="auto" if format in ("soccernet", "krt") else format)
    again = read.camera
    if read.size not in (None, SIZE):
        again = again.scaled(read.size, SIZE)
    (px, valid), (expected, seen) = again.project(GROUND), CAMERA.project(GROUND)
    assert valid[seen].all()
    np.testing.assert_allclose(px[seen], expected[seen], atol=1e-6)
    assert ("everything off the ground" in lost) == (read.model == "homography")


def test_a_fit_is_written_with_its_size_and_the_clicks_it_explains(sample_data, tmp_path) -> None:
    annotation = load_annotation(sample_data / "00002.json")
    fit = fit_camera(annotation, size=(1280, 720))
    assert save_camera(fit, tmp_path / "camera_00002.json", fitted_to=annotation) == ()
    read = load_camera(tmp_path / "camera_00002.json")
    assert read.size == (1280, 720)
    assert read.fitted_on is not None
    assert evaluate(annotation, read).jac == evaluate(annotation, fit).jac == 1.0
    smaller = tmp_path / "small.json"
    save_camera(fit, smaller, size=SIZE)
    assert load_camera(smaller).size == SIZE
    assert load_camera(smaller).fitted_on == read.fitted_on
    for fmt, name in (("opencv", "2.yml"), ("krt", "3.json")):
        fitted = {"size": fit.size, "fitted_to": annotation}
        assert save_camera(fit.camera, tmp_path / name, format=fmt, **fitted) == ()
        assert load_camera(tmp_path / name, format=fmt).fitted_on == read.fitted_on
    with pytest.raises(UsageError, match="the fit failed: 2 elements"):
        save_camera(
            fit_camera(FrameAnnotation(annotation.polylines[:2])), tmp_path / "camera_3.json"
        )


def test_a_camera_from_a_file_keeps_what_the_file_said(sample_data, tmp_path) -> None:
    given = load_camera(sample_data / "cameras" / "true" / "camera_00002.json")
    given = replace(given, content={**given.content, "note": "by hand"})
    save_camera(given, tmp_path / "camera_2.json")
    assert load_camera(tmp_path / "camera_2.json").extra["note"] == "by hand"


def test_what_cannot_be_written_is_told_and_nothing_is(tmp_path) -> None:
    file = tmp_path / "camera_1.json"
    homography = camera_from_homography(
        calibration_matrix(CAMERA)
        @ np.column_stack((CAMERA.rotation_cam_from_world, translation(CAMERA)))[:, [0, 1, 3]],
        SIZE,
    )
    for wrong, says, further in (
        (homography, "cannot hold a homography", {}),
        (camera_from_function(CAMERA.project), "cannot hold a camera model", {}),
        (np.eye(3), "expected a camera", {}),
        (CAMERA, "no format 'csv' for one camera", {"format": "csv"}),
        (CAMERA, "no format 'submission'", {"format": "submission"}),
        (CAMERA, r"expected a name that ends in \.yml", {"format": "opencv"}),
    ):
        with pytest.raises(UsageError, match=says):
            save_camera(wrong, file, **further)
    with pytest.raises(UsageError, match="names no picture size"):
        save_camera(homography, tmp_path / "1.txt", format="world")
    assert not list(tmp_path.iterdir())
    file.write_text("mine")
    with pytest.raises(UsageError, match="is there already"):
        save_camera(CAMERA, file)
    assert file.read_text() == "mine"
    save_camera(CAMERA, file, overwrite=True)
    assert isinstance(load_camera(file).camera, PinholeCamera)
    with pytest.raises(SaveError, match="nowhere"):
        save_camera(CAMERA, tmp_path / "nowhere" / "camera_1.json")
