"""Pictures that are not 16:9: their own shape is what cameras are fitted and labels checked in."""

import json
import shutil

import cv2
import numpy as np
import pytest

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.dataset_field import ASPECT_SETTING
from tests.cli.conftest import rows_in

FOUR_THIRDS = (1024, 768)


@pytest.fixture
def square(dataset):
    """The same frames, of a camera with 4:3 pictures."""
    for name, pan in dataset.pans.items():
        dataset.write_frame(name, pan, FOUR_THIRDS)
    return dataset


def rows(path) -> dict[str, dict[str, str]]:
    return {row["name"]: row for row in rows_in(path)}


@pytest.mark.parametrize("given", ["root", "annotations"])
def test_cameras_have_the_shape_of_the_pictures(cli, square, tmp_path, given):
    out = tmp_path / "out"
    done = cli("calibrate", getattr(square, given), out, "-m", "P", "-t", 1)
    assert "note: pictures are 1024x768: fitted at 960x720\n" in done.stderr
    assert "soccernet, 960x720" in done.stdout
    for name, row in rows(out / "calibration.csv").items():
        assert (row["width"], row["height"], row["left_out"]) == ("960", "720", "")
        assert float(row["mean_reprojection_error"]) < 0.1
        camera = json.loads((out / f"camera_{name}.json").read_text())
        assert (camera["image_width"], camera["image_height"]) == (960, 720)
        assert camera["principal_point"] == [479.5, 359.5]
        assert camera["pan_degrees"] == pytest.approx(square.pans[name], abs=0.5)


def test_each_frame_has_its_own_shape(cli, dataset, tmp_path):
    dataset.write_frame("2", dataset.pans["2"], FOUR_THIRDS)
    done = cli("calibrate", dataset.root, tmp_path / "out", "-m", "P", "-t", 1)
    assert "pictures are 1024x768 (1 frame): fitted at 960x720" in done.stderr
    found = rows(tmp_path / "out" / "calibration.csv")
    assert {name: row["height"] for name, row in found.items()} == {
        "1": "540", "2": "720", "3": "540", "10": "540", "11": "540",
    }  # fmt: skip
    assert all(float(row["jac_1"]) == 1.0 for row in found.values())
    together = cli("calibrate", dataset.root, tmp_path / "one", "-m", "P", "--shared-position")
    assert "pictures are 1024x768 (1 frame): fitted at 960x720" in together.stderr
    assert rows(tmp_path / "one" / "calibration.csv")["2"]["height"] == "720"


def test_squeezed_pictures_have_cameras_with_wide_pixels(cli, dataset, tmp_path):
    for path in dataset.root.glob("*.jpg"):
        cv2.imwrite(str(path), np.zeros((640, 640, 3), np.uint8))

    def check_cameras(*options: object) -> None:
        out = tmp_path / "out"
        done = cli("calibrate", dataset.root, out, "-m", "P", "--overwrite", *options)
        assert "pixels are 1.778 times as wide as high, as stated" in done.stdout
        for name, pan in dataset.pans.items():
            camera = json.loads((out / f"camera_{name}.json").read_text())
            assert camera["y_focal_length"] / camera["x_focal_length"] == pytest.approx(1.7778)
            assert camera["pan_degrees"] == pytest.approx(pan, abs=0.5)

    check_cameras("--pixel-aspect", "1.7778")
    check_cameras("--pixel-aspect", "1.7778", "--shared-position")
    strict = ("check", dataset.root, "--fail-on", "error", "--no-line-evidence")
    cli(*strict, "--pixel-aspect", "1.7778")
    database = WorkspaceDatabase.open(dataset.root, "one")
    database.set_setting(ASPECT_SETTING, "1.7778 1.0")
    assert database.close()
    check_cameras()
    check_cameras("--field", "soccer", "--shared-position")
    done = cli("calibrate", dataset.root, tmp_path / "out", "--pixel-aspect", "wide", code=None)
    assert done.exit_code
    assert "expected auto" in done.stderr


def test_a_frame_without_a_picture_is_like_the_others(cli, square, tmp_path):
    (square.root / "3.jpg").unlink()
    cli("calibrate", square.root, tmp_path / "out")
    assert rows(tmp_path / "out" / "calibration.csv")["3"]["height"] == "720"


def test_a_file_may_tell_the_size_of_its_picture(cli, dataset, tmp_path):
    dataset.write_frame("1", dataset.pans["1"], FOUR_THIRDS)
    for picture in dataset.root.glob("*.jpg"):
        picture.unlink()
    file = dataset.annotations / "1.json"
    told = {**json.loads(file.read_text()), "image_width": 1024, "image_height": 768}
    file.write_text(json.dumps(told))
    done = cli("calibrate", dataset.root, tmp_path / "out", "-m", "P", "-t", 1)
    found = rows(tmp_path / "out" / "calibration.csv")
    assert (found["1"]["height"], found["2"]["height"]) == ("720", "540")
    assert float(found["1"]["jac_1"]) == 1.0
    assert "1024x768" in done.stderr


def test_no_right_label_is_accused(cli, square, tmp_path):
    out = tmp_path / "found.json"
    done = cli("check", square.root, "-o", out)
    content = json.loads(out.read_text())
    assert content["size"] == [960, 720]
    assert {f["rule"] for f in content["findings"]} <= {"few points", "short"}
    assert "pictures are 1024x768: fitted at 960x720" in done.stderr
    # What happens in the wrong shape, if somebody insists on it.
    wrong = cli("check", square.root, "-o", out, "--size", "960x540")
    assert "which has another shape" in wrong.stderr
    assert {tuple(f["size"]) for f in json.loads(out.read_text())["findings"]} == {(960, 540)}


def test_a_size_of_another_shape_is_warned_of(cli, square, tmp_path):
    done = cli("calibrate", square.root, tmp_path / "out", "--size", "1920x1080")
    assert "pictures are 1024x768, but fitted at 1920x1080, which has another shape" in done.stderr
    same = cli("calibrate", square.root, tmp_path / "same", "--size", "2048x1536")
    assert "pictures are" not in same.stderr
    sized = cli("field-size", square.root, "--size", "1920x1080")
    assert "another shape" in sized.stderr
    assert "fitted at 960x720" in cli("field-size", square.root).stderr


def test_sixteen_by_nine_is_nothing_to_tell(cli, dataset, tmp_path):
    assert "pictures" not in cli("calibrate", dataset.root, tmp_path / "out").stderr
    assert "pictures" not in cli("check", dataset.root).stderr


def test_the_official_size_stays_but_is_warned_of(cli, square, tmp_path):
    cli("calibrate", square.root, tmp_path / "out")
    done = cli("evaluate", square.annotations, tmp_path / "out")
    assert "note: pictures are 1024x768, compared at 960x540, which has another" in done.stderr
    assert "soccernet, 960x540" in done.stdout
    again = cli("evaluate", square.annotations, tmp_path / "out", "--size", "960x720")
    assert "pictures are" not in again.stderr


@pytest.mark.parametrize(("width", "height"), [(1, 1), (2, 4000)])
def test_a_picture_of_no_shape_ends_no_set(cli, dataset, tmp_path, width, height):
    odd = np.zeros((height, width, 3), np.uint8)
    cv2.imwrite(str(dataset.root / "2.jpg"), odd)
    for asked in (
        ("check", dataset.root, "-o", tmp_path / "f.json"),
        ("calibrate", dataset.root, tmp_path / "fits", "--model", "auto"),
    ):
        done = cli(*asked, code=None)
        assert done.exit_code in (0, 1), done.output
    assert (tmp_path / "fits" / "camera_2.json").exists()
    released = cli("release", dataset.root, tmp_path / "released", "--no-check", code=1)
    assert "expected a picture" in released.stderr
    few = tmp_path / "few"
    few.mkdir()
    shutil.copy(dataset.root / "2.jpg", few)
    for command in ("propose", "track"):
        done = cli(command, few, tmp_path / command, code=1)
        assert "expected a picture" in done.stderr


def test_a_size_of_no_shape_ends_no_set(cli, dataset, tmp_path):
    path = dataset.annotations / "2.json"
    told = json.loads(path.read_text()) | {"width": 2, "height": 4000}
    (dataset.root / "2.jpg").unlink()
    path.write_text(json.dumps(told))
    done = cli("calibrate", dataset.root, tmp_path / "fits", "--model", "auto")
    assert (tmp_path / "fits" / "camera_2.json").exists()
    done = cli("calibrate", dataset.root, tmp_path / "out", "--size", "2x4000", code=2)
    assert "no shape of a picture" in done.stderr
