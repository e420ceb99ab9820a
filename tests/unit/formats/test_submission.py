"""What the official evaluation would make of a submission."""

import json
import warnings
import zipfile
from pathlib import Path
from typing import Any

import pytest

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.formats.cameras.submissions import check_submission
from procc_annotator.formats.cameras.writers import write_cameras

CAMERA = PinholeCamera(0.1, 1.3, 0.01, (2.0, 60.0, -15.0), (1400.0, 1410.0), (479.5, 269.5))
GOOD: dict[str, Any] = json.loads(write_camera(CAMERA))


def archive(folder: Path, members: list[tuple[str, Any]]) -> Path:
    path = folder / "test.zip"
    with zipfile.ZipFile(path, "w") as file, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for name, content in members:
            data = content if isinstance(content, bytes) else json.dumps(content).encode()
            file.writestr(name, data)
    return path


def findings(folder: Path, content: Any) -> list[str]:
    path = archive(folder, [("test/camera_1.json", content)])
    return [str(finding) for finding in check_submission(path, ["1"])]


def test_nothing_is_said_of_a_submission_written_here(tmp_path):
    path = tmp_path / "s.zip"
    cameras = [(str(i), LoadedCamera(CAMERA, "pinhole", (960, 540))) for i in range(3)]
    write_cameras(cameras, path, "submission")
    assert check_submission(path, ["0", "1", "2"]) == []
    assert check_submission(path) == []
    (wrong,) = check_submission(path, split="challenge")
    assert str(wrong) == (
        "refused: holds no camera: expected files named challenge/camera_FRAME.json; there is,"
        " for example, test/camera_0.json"
    )


def without(key: str) -> dict[str, Any]:
    return {k: v for k, v in GOOD.items() if k != key}


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (GOOD, None),
        (GOOD | {"rotation_matrix": [1]}, None),
        (without("thin_prism_distortion"), "refused: {}: lacks thin_prism_distortion; every key"),
        ({}, "refused: {}: lacks pan_degrees, tilt_degrees"),
        ([], "refused: {}: is not an object"),
        (b"{", "refused: {}: is not JSON in UTF-8"),
        (b"", "refused: {}: is not JSON in UTF-8"),
        (b"\xef\xbb\xbf" + json.dumps(GOOD).encode(), "refused: {}: is not JSON in UTF-8"),
        (json.dumps(GOOD).encode("utf-16"), "refused: {}: is not JSON in UTF-8"),
        (b"[" * 100_000, "refused: {}: is not JSON in UTF-8"),
        (GOOD | {"pan_degrees": float("nan")}, "lowers the score: {}: pan_degrees is not finite"),
        (
            GOOD | {"position_meters": [0, float("inf"), 0]},
            "lowers the score: {}: position_meters is not finite",
        ),
        (GOOD | {"radial_distortion": [0.1, 0]}, "refused: {}: radial_distortion: expected 6"),
        (GOOD | {"principal_point": "middle"}, "refused: {}: principal_point: expected 2 numbers"),
        (GOOD | {"x_focal_length": 0}, "refused: {}: x_focal_length: expected a focal length"),
        (
            GOOD | {"principal_point": [960, 540]},
            "lowers the score: {}: principal point (960, 540) far from the middle of 960x540",
        ),
        (
            GOOD | {"image_width": 1920, "image_height": 1080},
            "lowers the score: {}: is for pictures of 1920x1080",
        ),
    ],
)
def test_each_camera_is_looked_at(tmp_path, content, expected):
    found = findings(tmp_path, content)
    if expected is None:
        assert found == []
    else:
        assert len(found) == 1
        assert found[0].startswith(expected.format("test/camera_1.json"))


def test_names_and_frames(tmp_path):
    path = archive(
        tmp_path,
        [
            ("test/camera_1.json", GOOD),
            ("test/camera_2.json", b"{"),
            ("test/camera_2.json", GOOD),
            ("test/camera_9.json", b"never read"),
            ("test/3.json", GOOD),
            ("camera_4.json", GOOD),
            ("deep/test/camera_5.json", GOOD),
            ("__MACOSX/test/._camera_1.json", b"x"),
        ],
    )
    found = [str(f) for f in check_submission(path, [str(i) for i in range(1, 9)])]
    assert found == [
        "ignored: test/camera_2.json: is there 2 times, the last one counts",
        "ignored: 4 files (test/3.json, camera_4.json, deep/test/camera_5.json,"
        " __MACOSX/test/._camera_1.json): only files named test/camera_FRAME.json are read",
        "lowers the score: 6 of 8 annotated frames have no camera (3, 4, 5, 6, 7, ...):"
        " completeness 25.0 %",
        "ignored: 1 file (9): no such frame is annotated",
    ]
    (tmp_path / "empty").mkdir()
    (empty,) = check_submission(archive(tmp_path / "empty", []))
    assert empty.kind == "refused"


def test_what_is_no_archive(tmp_path):
    with pytest.raises(UsageError, match="no such file"):
        check_submission(tmp_path / "absent.zip")
    (tmp_path / "a.json").write_text("{}")
    with pytest.raises(UsageError, match="is a zip archive"):
        check_submission(tmp_path / "a.json")
    (tmp_path / "bad.zip").write_bytes(b"PK")
    with pytest.raises(InputError, match="not a readable zip archive"):
        check_submission(tmp_path / "bad.zip")


def test_a_damaged_member_is_refused_and_the_others_are_read(tmp_path):
    path = archive(tmp_path, [("test/camera_1.json", GOOD), ("test/camera_2.json", without("x"))])
    data = bytearray(path.read_bytes())
    at = data.index(b'"pan_degrees"')
    data[at + 1] ^= 0xFF  # stored uncompressed: the checksum no longer fits
    path.write_bytes(bytes(data))
    (found,) = check_submission(path)
    assert found.place == "test/camera_1.json"
    assert "cannot be read" in found.text


def test_names_that_begin_with_a_dot_are_not_found_by_the_evaluation(tmp_path):
    (found,) = check_submission(archive(tmp_path, [("./test/camera_1.json", GOOD)]))
    assert found.kind == "refused"
    assert "./ is not looked past" in found.text
