"""Camera and homography files: what they mean, and damage named with its place."""

import dataclasses
import io
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.camera.matrices import intrinsics_from_matrix
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.cli.options import CAMERA_FORMAT_NAMES
from procc_annotator.errors import CameraError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.cameras.loaded_camera import fit_to_size
from procc_annotator.formats.cameras.registry import CAMERA_FORMATS, read_camera_file
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.formats.file_listing import list_annotations, list_cameras
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

GOOD: dict[str, Any] = {
    "pan_degrees": -18.5,
    "tilt_degrees": 80,
    "roll_degrees": 0.2,
    "position_meters": [-1.2, 71.0, -13.5],
    "x_focal_length": 2592.3,
    "y_focal_length": 2592.3,
    "principal_point": [479.5, 269.5],
    "radial_distortion": [0.1, 0, 0, 0, 0, 0],
    "tangential_distortion": [0, 0],
    "thin_prism_distortion": [0, 0, 0, 0],
    "rotation_matrix": [[1, 0, 0]],
}


def npy(array: Any, **options: Any) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, array, **options)
    return buffer.getvalue()


def problem(data: bytes, path: str = "camera_00001.json", fmt: str = "auto") -> str:
    with pytest.raises(CameraError) as caught:
        read_camera_file(data, path=path, fmt=fmt)
    message = str(caught.value)
    assert message.startswith(path)
    assert "\n" not in message
    return message


def changed(**changes: Any) -> bytes:
    return json.dumps({**GOOD, **changes}).encode()


def test_a_soccernet_camera_is_read_and_its_extra_keys_kept():
    loaded = read_camera_file(changed(), path="camera_1.json")
    assert isinstance(loaded.camera, PinholeCamera)
    assert loaded.camera.pan_rad == pytest.approx(math.radians(-18.5))
    assert loaded.camera.radial[0] == 0.1
    assert loaded.size is None
    assert loaded.extra == {"rotation_matrix": [[1, 0, 0]]}
    assert loaded.notices == ()
    own = loaded.camera.rotation_cam_from_world
    for matrix, said in ((own, []), (own.T, ["rotation_matrix says something else than pan"])):
        data = changed(rotation_matrix=matrix.tolist())
        notices = read_camera_file(data, path="camera_1.json").notices
        assert [notice[:44] for notice in notices] == said
    again = json.loads(write_camera(loaded.camera, loaded.extra))
    assert again.keys() == GOOD.keys()
    for key, value in GOOD.items():
        assert again[key] == pytest.approx(value) if key != "rotation_matrix" else True


def test_saving_keeps_the_order_and_every_number_that_did_not_change():
    loaded = read_camera_file(changed(), path="camera_1.json")
    assert write_camera(loaded.camera, loaded.content) == (
        json.dumps(GOOD, indent=2).encode() + b"\n"
    )
    turned = dataclasses.replace(loaded.camera, pan_rad=0.0)
    content = json.loads(write_camera(turned, loaded.content))
    assert content == {**GOOD, "pan_degrees": 0}
    assert list(content) == list(GOOD)


def test_every_real_camera_comes_back_number_for_number(shared_data):
    files = sorted((shared_data / "wc14").glob("cameras_*/*.json"))
    assert len(files) > 300
    for file in files:
        loaded = read_camera_file(file.read_bytes(), path=str(file))
        again = write_camera(loaded.camera, loaded.content)
        assert json.dumps(json.loads(again)) == json.dumps(json.loads(file.read_bytes())), file


finite = st.floats(allow_nan=False, allow_infinity=False)
angle = st.floats(-720, 720)


def numbers(count: int) -> st.SearchStrategy[tuple[float, ...]]:
    return st.tuples(*[finite] * count)


@given(
    st.builds(
        PinholeCamera,
        pan_rad=angle,
        tilt_rad=angle,
        roll_rad=angle,
        position_world=numbers(3),
        focal_px=st.tuples(*[finite.filter(bool)] * 2),
        principal_point_px=numbers(2),
        radial=numbers(6),
        tangential=numbers(2),
        thin_prism=numbers(4),
    ),
    st.dictionaries(st.text(max_size=3), st.text(max_size=3), max_size=3),
)
def test_a_camera_of_ours_comes_back_as_it_was(camera, extra):
    loaded = read_camera_file(write_camera(camera, extra), path="camera_1.json")
    found = loaded.camera
    assert isinstance(found, PinholeCamera)
    assert loaded.extra == extra
    for name in ("pan_rad", "tilt_rad", "roll_rad"):
        assert getattr(found, name) == pytest.approx(getattr(camera, name), rel=1e-15)
        camera = dataclasses.replace(camera, **{name: getattr(found, name)})
    assert found == camera
    assert write_camera(found, extra) == write_camera(camera, extra)


@pytest.mark.parametrize(
    "change", [{"focal_px": (0.0, 1.0)}, {"radial": (math.nan,) * 6}, {"pan_rad": math.inf}]
)
def test_a_camera_nobody_could_read_again_is_not_written(change):
    good = PinholeCamera(0, 0, 0, (0, 0, 0), (1, 1), (0, 0))
    with pytest.raises(ValueError, match="not a camera"):
        write_camera(dataclasses.replace(good, **change))


def test_a_byte_order_mark_is_accepted():
    bom = b"\xef\xbb\xbf"
    assert read_camera_file(bom + changed(), path="camera_1.json").model == "pinhole"
    assert read_camera_file(bom + b"1,0,0\r\n0,1,0\r\n0,0,1", path="1.txt").model == "homography"


def test_extreme_but_finite_numbers_only_miss_the_picture():
    points = np.random.default_rng(0).uniform((-52, -34, -3), (52, 34, 0), (50, 3))
    for change in (
        {"position_meters": [1e300, -1e300, 1e300]},
        {"x_focal_length": 1e308, "radial_distortion": [1e300] * 6},
        {"position_meters": [0, 0, 10**200], "radial_distortion": [0, 0, 0, -1e9, 0, 0]},
    ):
        camera = read_camera_file(changed(**change), path="camera_1.json").camera
        assert camera.project(points)[0].shape == (50, 2)
        assert camera.project_float32(points)[0].shape == (50, 2)
    large = npy(np.array([[0.05, 0, 1], [0, 0.05, 1], [0, 1e-4, 1]]) * 1e308)
    px, _ = read_camera_file(large, path="1.npy", fmt="world").camera.project(np.ones((1, 3)) * 0)
    assert np.isfinite(px).all()


def test_absent_distortion_is_none():
    content = {k: v for k, v in GOOD.items() if "distortion" not in k}
    loaded = read_camera_file(json.dumps(content).encode(), path="camera_1.json")
    assert not loaded.camera.is_distorted


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        (changed(tilt_degrees="80"), "tilt_degrees: expected a finite number"),
        (changed(roll_degrees=True), "roll_degrees: expected a finite number"),
        (changed(position_meters=[1, 2]), "position_meters: expected 3 numbers, found 2 values"),
        (changed(thin_prism_distortion=[0, 0, 0, math.inf]), "thin_prism_distortion[3]"),
        (changed(x_focal_length=0), "x_focal_length: expected a focal length"),
        (changed(y_focal_length=-math.inf), "y_focal_length: expected a finite number"),
        (b"{}", "the key 'pan_degrees' is missing"),
        (b"[]", "expected an object with the keys of a SoccerNet camera, found a list"),
        (changed(principal_point="479.5"), "principal_point: expected 2 numbers"),
        (changed(width=960.5, height=540), "width and height: expected whole pixels"),
        (changed(meta={"a": 1}).replace(b'"a"', b'"a": 0, "a"'), "'a' occurs twice"),
        (json.dumps({**GOOD, "ä": 1}, ensure_ascii=False).encode("latin-1"), "is not UTF-8"),
        (changed()[:-20], "may be cut off"),
        (b"", "is empty"),
        (changed().decode().encode("utf-16"), "is not UTF-8 text"),
    ],
)
def test_damage_in_a_soccernet_camera(data, expected):
    assert expected in problem(data)


HUGE_NPY = npy(np.eye(3)).replace(b"(3, 3), }          ", b"(300000000, 90000)}")


@pytest.mark.parametrize(
    ("data", "path", "expected"),
    [
        (b"1 0 0\n0 1 0\n0 0", "1.homographyMatrix", "expected 9 numbers (3 x 3), found 8"),
        (b"1 0 0\n0 one 0\n0 0 1", "1.homographyMatrix", "line 2: expected a finite number"),
        (b"1 2 3 2 4 6 1 1 1", "1.txt", "cannot be inverted"),
        ("1 0 0 0 1 0 0 0 1".encode("utf-16"), "1.txt", "is not UTF-8 text"),
        (b"", "1.npy", "expected 9 numbers"),
        (HUGE_NPY, "1.npy", "is not a readable .npy file"),
        (npy(np.eye(3, dtype=complex)), "1.npy", "expected an array of real numbers"),
        (npy(np.eye(4)), "1.npy", "holds a pose (a rotation and a translation) without a lens"),
        (npy(np.eye(5)), "1.npy", "expected a 3 x 3 matrix, found 5 x 5"),
        (npy(np.full((3, 3), np.inf)), "1.npy", "row 1 column 1"),
        (b"whatever", "1.dat", "unknown kind of camera file '.dat'"),
    ],
)
def test_damage_in_a_homography(data, path, expected):
    assert expected in problem(data, path)


def test_a_pickle_is_never_run(tmp_path):
    target = tmp_path / "ran"

    class Bomb:
        def __reduce__(self) -> tuple[Any, ...]:
            return (Path.touch, (target,))

    problem(npy(np.array([Bomb()] * 9).reshape(3, 3), allow_pickle=True), "1.npy")
    assert not target.exists()


@pytest.mark.parametrize(
    ("fmt", "origin"), [("wc14", (57.5, 37.0)), ("carwc", (57.415, 37.185)), ("world", (0, 0))]
)
def test_each_convention_puts_its_origin_at_the_centre_mark(fmt, origin):
    """A picture pixel that shows the template's centre projects from the world's origin."""
    unit = 1.0 if fmt == "world" else 0.9144
    shift = np.array([[0.05, 0, origin[0] - 32], [0, 0.05, origin[1] - 18], [0, 0, 1]])
    loaded = read_camera_file(npy(shift), path="1.npy", fmt=fmt)
    px, valid = loaded.camera.project(np.array([[0.0, 0, 0], [unit, 0, 0]]))
    assert valid.all()
    np.testing.assert_allclose(px, [[640, 360], [660, 360]], atol=1e-9)
    assert loaded.size == (1280, 720)
    assert loaded.model == "homography"


def test_the_suffix_chooses_the_convention_unless_one_is_given():
    shift = np.array([[0.05, 0, 25.5], [0, 0.05, 19.0], [0, 0, 1]])
    text = "\n".join(" ".join(str(v) for v in row) for row in shift).encode()

    def centre(data: bytes, path: str, fmt: str = "auto") -> list[float]:
        px, _ = read_camera_file(data, path=path, fmt=fmt).camera.project(np.zeros((1, 3)))
        return [round(float(v), 6) for v in px[0]]

    assert centre(text, "1.homographyMatrix") == centre(text, "1.txt") == [640, 360]
    assert centre(npy(shift), "1.npy") == [638.3, 363.7]
    assert centre(npy(shift), "1.npy", "wc14") == [640, 360]


def test_an_unknown_format_is_refused():
    with pytest.raises(UsageError, match="no camera format 'mat'"):
        read_camera_file(b"", path="1.json", fmt="mat")
    assert ("auto", *CAMERA_FORMAT_NAMES) == CAMERA_FORMATS


def test_a_camera_of_another_size_is_scaled_and_says_so():
    points = np.array([[0.0, 0, 0], [10, -10, 0]])
    sized = read_camera_file(changed(image_width=1920, image_height=1080), path="camera_1.json")
    camera, notice = fit_to_size(sized, (960, 540))
    assert notice == "scaled from 1920x1080 to 960x540"
    own, _ = sized.camera.project(points)
    px, _ = camera.project(points)
    np.testing.assert_allclose(px, own * (959 / 1919, 539 / 1079))
    assert fit_to_size(sized, (960, 540), (1280, 720))[1] == notice  # the file knows better
    plain = read_camera_file(changed(), path="camera_1.json")
    assert fit_to_size(plain, (960, 540)) == (plain.camera, None)
    assert fit_to_size(plain, (960, 540), None, (1280, 720))[1] == "scaled from 1280x720 to 960x540"
    assert fit_to_size(plain, (960, 540), (1920, 1080))[1] == "scaled from 1920x1080 to 960x540"


def test_a_homography_belongs_to_another_size_where_that_is_told():
    usual = read_camera_file(b"1 0 0 0 1 0 0 0 1", path="1.homographyMatrix")
    assert fit_to_size(usual, (1280, 720), None, (960, 540)) == (usual.camera, None)
    taken, notice = fit_to_size(usual, (960, 540), (960, 540))
    assert taken is usual.camera
    assert notice == "taken for 960x540 (usual: 1280x720)"
    notice = fit_to_size(usual, (480, 270), (960, 540))[1]
    assert notice == "scaled from 960x540 (usual: 1280x720) to 480x270"


@pytest.mark.parametrize(
    ("x", "y", "shown"),
    [(-1.0, 1.0, "left for right"), (1.0, -1.0, "upside down"), (-1.0, -1.0, "turned by 180")],
)
def test_negative_focal_lengths_are_taken_and_told(x, y, shown):
    """The official evaluation takes them, so they count; a wrong sign should not go unseen."""
    focal = GOOD["x_focal_length"]
    data = changed(x_focal_length=x * focal, y_focal_length=y * focal)
    loaded = read_camera_file(data, path="camera_1.json")
    assert loaded.camera.focal_px == (x * focal, y * focal)
    (notice,) = loaded.notices
    assert shown in notice
    assert not read_camera_file(changed(), path="camera_1.json").notices
    k = np.diag([x * focal, y * focal, 1.0])
    assert intrinsics_from_matrix(k).notices == loaded.notices


# The published homographies of World Cup 2014 fit its annotations: all conventions are right.

SIZE = (960, 540)


@pytest.mark.parametrize(
    ("off_plane", "expected"),
    [("left_out", (41.3, 83.0, 96.0)), ("missed", (35.5, 74.0, 86.1))],
)
def test_refined_homographies_reach_their_known_scores(shared_data, off_plane, expected):
    field = load_field()
    setup = EvaluationSetup(field, SIZE, off_plane=off_plane)
    annotations = open_source(shared_data / "wc14" / "annotations")
    cameras = open_source(shared_data / "wc14" / "homographies_carwc")
    files = list_cameras(cameras)
    jac: dict[float, list[float]] = {2.0: [], 5.0: [], 10.0: []}
    distances: list[float] = []
    for name, file in list_annotations(annotations).items():
        annotation = read_annotation(annotations.read(file), path=file, field=field)
        loaded = read_camera_file(cameras.read(files[name]), path=files[name])
        camera, notice = fit_to_size(loaded, SIZE)
        assert notice == "scaled from 1280x720 to 960x540"
        measurement = measure(annotation, camera, setup)
        for threshold, values in jac.items():
            result = score(measurement, threshold)
            values.append(result.jac)
            if threshold == 10:
                distances += [d for e in result.elements for d in e.distances]
    assert len(files) == 186
    assert tuple(round(100 * float(np.mean(v)), 1) for v in jac.values()) == expected
    assert round(float(np.mean(distances)), 2) == 1.73
