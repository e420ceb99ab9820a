"""Datasets, annotations and cameras as values, and what becomes of damaged files."""

import json
import shutil
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator import (
    AnnotationError,
    CameraError,
    FrameAnnotation,
    PinholeCamera,
    SaveError,
    UsageError,
    camera_from_function,
    camera_from_homography,
    evaluate,
    evaluate_set,
    fit_camera,
    load_annotation,
    load_annotations,
    load_camera,
    load_cameras,
    load_dataset,
    load_field,
    save_camera,
)
from procc_annotator.camera.matrices import calibration_matrix, translation
from procc_annotator.report.conversion import convert_annotations
from procc_annotator.report.conversion_output import ConversionRequest


def test_a_dataset_is_its_field_its_annotations_and_its_pictures(sample_data):
    dataset = load_dataset(sample_data)
    assert dataset.field.name == "soccer"
    assert list(dataset.pictures) == [f"{n:05}" for n in range(1, 15)]
    assert list(dataset.annotations) == sorted(p.stem for p in sample_data.glob("*.json"))
    assert dataset.annotations["00002"] == load_annotation(sample_data / "00002.json")
    assert all(path.is_file() for path in dataset.pictures.values())
    assert dataset.field_of("00002") is dataset.field
    ice = load_dataset(str(sample_data / "ice_hockey"))
    assert ice.field.name == "ice_hockey_iihf"
    assert load_dataset(sample_data / "ice_hockey", "soccer").field.name == "soccer"


def test_annotations_may_lie_in_a_folder_of_their_own(sample_data, tmp_path):
    inner = tmp_path / "annotations"
    inner.mkdir()
    shutil.copy(sample_data / "00002.json", inner)
    shutil.copy(sample_data / "00001.jpg", tmp_path)
    assert list(load_annotations(tmp_path)) == ["00002"]
    dataset = load_dataset(tmp_path)
    assert (list(dataset.annotations), list(dataset.pictures)) == (["00002"], ["00001"])
    (inner / "00002.json").unlink()
    assert not load_dataset(tmp_path).annotations
    (tmp_path / "00001.jpg").unlink()
    with pytest.raises(UsageError, match="no annotation"):
        load_dataset(tmp_path)


def test_frames_of_a_tree_are_called_by_their_paths(sample_data, tmp_path):
    for match in ("a/img1", "b/img1"):
        (tmp_path / match).mkdir(parents=True)
        shutil.copy(sample_data / "00002.json", tmp_path / match)
        shutil.copy(sample_data / "00002.jpg", tmp_path / match)
    names = ["a/img1/00002", "b/img1/00002"]
    dataset = load_dataset(tmp_path)
    assert list(dataset.annotations) == list(dataset.pictures) == names
    assert dataset.pictures[names[1]] == tmp_path / "b" / "img1" / "00002.jpg"
    assert list(load_annotations(tmp_path)) == names
    assert dataset.size_of(names[0]) == (1280, 720)


def test_a_dataset_knows_the_sizes_of_its_pictures(sample_data, tmp_path):
    shutil.copy(sample_data / "00005.jpg", tmp_path)  # not annotated
    told = json.loads((sample_data / "00002.json").read_text())
    told |= {"image_width": 1920, "image_height": 1080}
    (tmp_path / "00002.json").write_text(json.dumps(told))
    dataset = load_dataset(tmp_path)
    assert dict(dataset.sizes) == {"00002": (1920, 1080)}
    assert dataset.size_of("00002") == (1920, 1080)
    assert dataset.size_of("00005") == (1280, 720)
    assert dataset.size_of("00009") is None


@pytest.mark.parametrize("fmt", ["labelme", "cvat", "coco", "soccernet-v3", "soccernet-gsr"])
def test_every_format_is_read_as_the_commands_do(sample_data, tmp_path, fmt):
    """Sizes that a file leaves out are those of the pictures around it."""
    own = load_annotations(sample_data)
    convert_annotations(sample_data, tmp_path / "out", ConversionRequest(fmt), load_field())
    read = load_annotations(tmp_path / "out")
    assert list(read) == list(own)
    for name, annotation in own.items():
        assert {p.class_name: len(p.points) for p in read[name]} == {
            p.class_name: len(p.points) for p in annotation if p.points
        }


def test_a_second_annotation_of_a_frame_is_told(tmp_path):
    shape = '<polyline label="Middle line" points="0.0,0.0;10.0,10.0" occluded="0"></polyline>'
    images = "".join(
        f'<image id="{n}" name="1.{suffix}" width="960" height="540">{shape}</image>'
        for n, suffix in enumerate(("jpg", "png"))
    )
    (tmp_path / "a.xml").write_text(f"<annotations><version>1.1</version>{images}</annotations>")
    told: list[Exception] = []
    assert list(load_annotations(tmp_path, on_damaged=told.append)) == ["1"]
    assert [str(problem).partition(":")[2].strip() for problem in told] == [
        "a second annotation of this frame, of 1.png beside 1.jpg (rename one of the pictures)"
    ]
    with pytest.raises(AnnotationError, match="a second annotation"):
        load_annotations(tmp_path)


def test_a_real_set_of_another_program_is_read(shared_data):
    found = load_annotations(shared_data / "foreign" / "tennis_cvat_test.xml", "tennis")
    assert len(found) == 23
    assert load_dataset(shared_data / "foreign" / "tennis_cvat_test.xml").sizes["01"][0] > 100


def test_damaged_annotations_are_raised_or_told(sample_data, tmp_path):
    shutil.copy(sample_data / "00002.json", tmp_path)
    (tmp_path / "00003.json").write_text('{"Middle line": [{"x": 0.5}]}')
    with pytest.raises(AnnotationError, match=r"00003.json: Middle line\[0\]"):
        load_annotations(tmp_path)
    told: list[Exception] = []
    assert list(load_annotations(tmp_path, on_damaged=told.append)) == ["00002"]
    (problem,) = told
    assert isinstance(problem, AnnotationError)
    assert "the coordinate 'y'" in str(problem)


def test_cameras_know_the_picture_size_of_their_files(sample_data, tmp_path):
    cameras = load_cameras(sample_data / "cameras" / "homography")
    assert {camera.model for camera in cameras.values()} == {"homography"}
    assert {camera.size for camera in cameras.values()} == {(1280, 720)}
    file = next((sample_data / "cameras" / "pinhole").iterdir())
    assert isinstance(load_camera(file).camera, PinholeCamera)
    with pytest.raises(UsageError, match=r"no such format|unknown|camera format"):
        load_camera(file, format="nonsense")
    (tmp_path / "camera_1.json").write_text("{}")
    with pytest.raises(CameraError, match=r"camera_1\.json"):
        load_cameras(tmp_path)
    told: list[Exception] = []
    assert load_cameras(tmp_path, on_damaged=told.append) == {}
    assert len(told) == 1
    (tmp_path / "camera_1.json").unlink()
    with pytest.raises(UsageError, match="holds no camera"):
        load_cameras(tmp_path)
    with pytest.raises(UsageError, match=r"holds \d+ cameras .* one is needed"):
        load_camera(sample_data / "cameras" / "homography")


def test_an_annotation_from_and_to_plain_values(sample_data):
    content = json.loads((sample_data / "00002.json").read_text())
    annotation = FrameAnnotation.from_dict(content)
    assert annotation == load_annotation(sample_data / "00002.json")
    assert annotation.to_dict() == content
    assert list(annotation.to_dict()) == list(content)
    line = {"Middle line": [(0.0, 0.5), (1.0, 1.0)]}
    normalised = FrameAnnotation.from_dict(line)
    px = normalised.to_dict(size=(961, 541))
    assert px == {"Middle line": [{"x": 0.0, "y": 270.0}, {"x": 960.0, "y": 540.0}]}
    assert FrameAnnotation.from_dict(px, size=(961, 541)) == normalised
    kept = {"Middle line": [{"x": 0.25, "y": 0.5, "visible": True}], "Circle left": []}
    assert FrameAnnotation.from_dict(kept).to_dict() == kept


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ([("Middle line", [])], "points by class name, found list"),
        ({"Middle line": 3}, "Middle line: expected a list of points, found int"),
        ({"Middle line": [0.5, 0.5]}, r"Middle line\[0\]: expected a point"),
        ({"Middle line": [(0.5, 0.5), (1, 2, 3)]}, r"Middle line\[1\]: expected a point"),
        ({"Middle line": [{"x": 0.5}]}, r"Middle line\[0\]: expected a point"),
        ({"Middle line": [(0.5, float("nan"))]}, r"Middle line\[0\]: expected finite"),
        ({"Middle line": "abc"}, "expected a list of points, found str"),
    ],
)
def test_plain_values_that_are_no_annotation(wrong, says):
    with pytest.raises(UsageError, match=says):
        FrameAnnotation.from_dict(wrong)


def test_names_of_others_are_told_by_a_map(sample_data, tmp_path):
    own = load_annotation(sample_data / "00002.json")
    content = {f"x {p.class_name}": [{"x": q.u, "y": q.v} for q in p.points] for p in own}
    (tmp_path / "00002.json").write_text(json.dumps(content))
    labels = tmp_path / "names.toml"
    rules = [f'"x {p.class_name}" = "{p.class_name.strip()}"' for p in own]
    labels.write_text("\n".join(["[labels]", *rules]))
    assert load_annotations(tmp_path, labels=labels) == {"00002": own}
    assert load_annotations(tmp_path)["00002"] != own
    labels.rename(tmp_path / "labels.toml")
    assert load_annotations(tmp_path)["00002"] == own
    assert load_dataset(tmp_path).annotations["00002"] == own


def test_a_bare_homography_is_of_one_sport(tmp_path):
    np.save(tmp_path / "1.npy", np.diag([0.1, 0.1, 1.0]))
    camera = load_camera(tmp_path / "1.npy")
    annotation = FrameAnnotation.from_dict({"Baseline left": [(0.1, 0.2), (0.3, 0.4)]})
    with pytest.raises(UsageError, match="nothing says which ground"):
        evaluate(annotation, camera, field="tennis")
    with pytest.raises(UsageError, match="camera of 1: nothing says which ground"):
        evaluate_set({"1": annotation}, tmp_path, field="tennis")


# A camera written from Python is one that the program reads, and what is in the way is told.

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
def test_what_is_written_is_read_again(tmp_path, format, name):
    lost = save_camera(CAMERA, tmp_path / name, format=format, size=SIZE)
    read = load_camera(tmp_path / name, format="auto" if format in ("soccernet", "krt") else format)
    again = read.camera
    if read.size not in (None, SIZE):
        again = again.scaled(read.size, SIZE)
    (px, valid), (expected, seen) = again.project(GROUND), CAMERA.project(GROUND)
    assert valid[seen].all()
    np.testing.assert_allclose(px[seen], expected[seen], atol=1e-6)
    assert ("everything off the ground" in lost) == (read.model == "homography")


def test_a_fit_is_written_with_its_size_and_the_clicks_it_explains(sample_data, tmp_path):
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


def test_a_camera_from_a_file_keeps_what_the_file_said(sample_data, tmp_path):
    given = load_camera(sample_data / "cameras" / "true" / "camera_00002.json")
    given = replace(given, content={**given.content, "note": "by hand"})
    save_camera(given, tmp_path / "camera_2.json")
    assert load_camera(tmp_path / "camera_2.json").extra["note"] == "by hand"


def test_what_cannot_be_written_is_told_and_nothing_is(tmp_path):
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
