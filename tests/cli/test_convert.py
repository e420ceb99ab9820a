"""``procc-annotator convert``: what leaves comes back, and nothing that is read is ever changed."""

import json
import zipfile
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import cv2
import numpy as np
import pytest

from procc_annotator.cli.convert import CAMERA_TARGETS
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.cameras.writers import CAMERA_TARGETS as WRITTEN
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup
from tests.cli.conftest import camera_file


def contents(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


@pytest.mark.parametrize(
    ("to", "folder"),
    [
        ("cvat", "images"),
        ("cvat-video", "images"),
        ("coco", "images/default"),
        ("yolo-pose", "images/train"),
        ("labelme", ""),
        ("soccernet-v3", "v3_frames"),
        ("soccernet-gsr", "img1"),
    ],
)
def test_pictures_go_along_where_readers_look_for_them(cli, dataset, tmp_path, to, folder):
    out = tmp_path / "out"
    cli("convert", dataset.root, out, "--to", to, "--pictures")
    for picture in dataset.root.glob("*.jpg"):
        assert (out / folder / picture.name).read_bytes() == picture.read_bytes()
    cli("convert", dataset.root, tmp_path / "a.zip", "--to", to, "--pictures")
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        names = {p.relative_to(out).as_posix() for p in out.rglob("*") if p.is_file()}
        assert set(archive.namelist()) == names
    if to != "yolo-pose":
        cli("convert", out, tmp_path / "back", "--to", "soccernet")
        for path in dataset.annotations.iterdir():
            there = json.loads((tmp_path / "back" / path.name).read_text())
            assert there == json.loads(path.read_text())


def test_pictures_that_are_not_there_are_told(cli, dataset, tmp_path):
    (dataset.root / "3.jpg").unlink()
    out = tmp_path / "out"
    done = cli("convert", dataset.root, out, "--to", "cvat", "--pictures", "--size", "960x540")
    assert "pictures were not found and are not copied (1 frame: 3)" in done.stderr
    refused = cli("convert", dataset.root, tmp_path / "m", "--to", "masks", "--pictures", code=2)
    assert "goes without pictures" in refused.stderr
    assert not (tmp_path / "m").exists()


def test_sizes_and_names_are_those_of_the_pictures(cli, dataset, tmp_path):
    for source in (dataset.root, dataset.annotations):
        out = tmp_path / "out" / source.name
        cli("convert", source, out, "--to", "labelme")
        content = json.loads((out / "10.json").read_text())
        assert (content["imageWidth"], content["imageHeight"]) == (960, 540)
        assert content["imagePath"] == "10.jpg"


def test_without_pictures_the_size_has_to_be_given(cli, dataset, tmp_path):
    for path in dataset.root.glob("*.jpg"):
        path.unlink()
    done = cli("convert", dataset.annotations, tmp_path / "out", "--to", "cvat", code=2)
    assert len(done.stderr.splitlines()) == 1  # not one a frame
    assert "the size of no picture of" in done.stderr
    assert "name their size: --size WxH" in done.stderr
    assert not (tmp_path / "out").exists()
    done = cli("convert", dataset.annotations, tmp_path / "out", "--to", "cvat", "--size", "96x54")
    assert 'width="96" height="54"' in (tmp_path / "out" / "annotations.xml").read_text()
    assert "note: pictures were not found" in done.stderr


def test_archives_and_single_files(cli, dataset, tmp_path):
    cli("convert", dataset.root, tmp_path / "a.zip", "--to", "cvat")
    cli("convert", dataset.root, tmp_path / "b.zip", "--to", "cvat")
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        assert archive.namelist() == ["annotations.xml", "labels.json"]
        labels = json.loads(archive.read("labels.json"))
    assert {"name", "color", "type", "attributes"} == set(labels[0])
    assert all(label["name"] == label["name"].strip() for label in labels)
    cli("convert", tmp_path / "a.zip", tmp_path / "own.json", "--to", "coco")
    assert len(json.loads((tmp_path / "own.json").read_text())["images"]) == 5
    again = cli("convert", tmp_path / "a.zip", tmp_path / "own.json", "--to", "coco", code=2)
    assert "exists already" in again.stderr
    cli("convert", tmp_path / "a.zip", tmp_path / "own.json", "--to", "coco", "--overwrite")


def test_masks_show_what_was_clicked(cli, dataset, tmp_path):
    done = cli("convert", dataset.root, tmp_path / "m", "--to", "masks", "--line-width", 6,
               "--split", "train")  # fmt: skip
    assert "not read back" in done.stderr
    legend = json.loads((tmp_path / "m" / "classes.json").read_text())
    values = {entry["class"]: entry["value"] for entry in legend["classes"]}
    mask = cv2.imread(str(tmp_path / "m" / "train" / "3.png"), cv2.IMREAD_UNCHANGED)
    annotation = json.loads((dataset.annotations / "3.json").read_text())
    present = {values[name] for name, points in annotation.items() if points}
    assert present <= set(np.unique(mask))
    assert mask.shape == (540, 960)


def test_one_unreadable_file_is_listed_and_the_rest_written(cli, dataset, tmp_path):
    (dataset.annotations / "2.json").write_text('{"Middle line": [{"x": 1}]}')
    done = cli("convert", dataset.root, tmp_path / "out", "--to", "labelme", code=1)
    assert "4 frames" in done.stdout
    (line,) = done.stderr.strip().splitlines()
    assert line.startswith("left out: ")
    assert "Middle line[0]" in line


def test_inputs_are_never_overwritten_even_when_asked(cli, dataset, tmp_path):
    cvat = dataset.root / "annotations.xml"
    cli("convert", dataset.annotations, cvat, "--to", "cvat")
    before = cvat.read_bytes()
    done = cli("convert", cvat, dataset.root, "--to", "cvat", "--overwrite", code=2)
    assert "one of the files that are read" in done.stderr
    assert cvat.read_bytes() == before


def test_a_mask_that_would_fill_the_memory_is_refused(cli, dataset, tmp_path):
    for path in dataset.root.glob("*.jpg"):
        path.unlink()
    done = cli("convert", dataset.annotations, tmp_path / "m", "--to", "masks", "--size",
               "60000x60000", code=2)  # fmt: skip
    assert "1: not written: a mask of 60000x60000 is too large" in done.stderr
    assert not (tmp_path / "m").exists()


def test_masks_never_replace_the_pictures(cli, dataset, tmp_path):
    for path in dataset.root.glob("*.jpg"):
        cv2.imwrite(str(path.with_suffix(".png")), cv2.imread(str(path)))
        path.unlink()
    before = contents(dataset.root)
    done = cli("convert", dataset.annotations, dataset.root, "--to", "masks", "--overwrite", code=2)
    assert "one of the files that are read" in done.stderr
    assert contents(dataset.root) == before


def test_files_that_are_there_stay(cli, dataset, tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "2.json").write_text("mine")
    done = cli("convert", dataset.root, tmp_path / "out", "--to", "labelme", code=1)
    assert "4 frames" in done.stdout
    assert "2.json: exists already" in done.stderr
    assert (tmp_path / "out" / "2.json").read_text() == "mine"


def test_labelme_files_may_lie_beside_the_pictures(cli, dataset, tmp_path):
    """They are another program's way; the dataset's own annotations stay in annotations/."""
    before = contents(dataset.annotations)
    cli("convert", dataset.annotations, dataset.root, "--to", "labelme")
    assert contents(dataset.annotations) == before
    assert (dataset.root / "1.json").exists()


def test_into_keeps_what_the_file_holds(cli, dataset, tmp_path):
    clip = {"info": {"version": "1.3"}, "images": [
        {"image_id": "1", "file_name": "3.jpg", "width": 960, "height": 540}],
        "annotations": [{"id": "9", "image_id": "1", "category_id": 1, "track_id": 4}],
        "categories": []}  # fmt: skip
    own = tmp_path / "Labels-GameState.json"
    own.write_text(json.dumps(clip))
    out = tmp_path / "new.json"
    cli("convert", dataset.root, out, "--to", "soccernet-gsr", "--into", own)
    after = json.loads(out.read_text())
    assert after["annotations"][0] == clip["annotations"][0]
    assert after["images"][0] == clip["images"][0]
    assert len(after["images"]) == 5
    assert json.loads(own.read_text()) == clip
    cli("convert", dataset.root, own, "--to", "soccernet-gsr", "--into", own,
                  "--overwrite", code=2)  # fmt: skip
    assert json.loads(own.read_text()) == clip


def labels_v3(actions: list[str], replays: list[str]) -> dict[str, Any]:
    """Such a file without lines, of pictures of 1920x1080."""

    def entry() -> dict[str, Any]:
        return {"imageMetadata": {"width": 1920, "height": 1080}, "lines": [], "bboxes": []}

    return {
        "GameMetadata": {"list_actions": actions},
        "actions": {name: entry() for name in actions},
        "replays": {name: entry() for name in replays},
    }


def test_a_frame_of_two_pictures_of_the_file_written_into_is_refused(cli, dataset, tmp_path):
    own, out = tmp_path / "Labels-v3.json", tmp_path / "new.json"
    own.write_text(json.dumps(labels_v3(["1.png", "2.png"], ["1.jpg"])))
    done = cli("convert", dataset.root, out, "--to", "soccernet-v3", "--into", own, code=1)
    assert "1: not written" in done.stderr
    assert "1.png in actions, 1.jpg in replays" in done.stderr
    after = json.loads(out.read_text())
    assert after["actions"]["1.png"]["lines"] == after["replays"]["1.jpg"]["lines"] == []
    assert after["actions"]["2.png"]["lines"]


def test_the_file_written_into_tells_the_sizes(cli, dataset, tmp_path):
    for path in dataset.root.glob("*.jpg"):
        path.unlink()
    own, out = tmp_path / "Labels-v3.json", tmp_path / "new.json"
    own.write_text(json.dumps(labels_v3(["1.png"], ["2.png"])))
    done = cli("convert", dataset.annotations, out, "--to", "soccernet-v3", "--into", own, code=1)
    assert "2 frames" in done.stdout
    assert done.stderr.count("the size of its picture is not known") == 3
    after = json.loads(out.read_text())
    name, points = next(iter(json.loads((dataset.annotations / "2.json").read_text()).items()))
    (line,) = (x for x in after["replays"]["2.png"]["lines"] if x["class"] == name)
    assert line["points"][:2] == pytest.approx([1919 * points[0]["x"], 1079 * points[0]["y"]])


def test_pictures_in_several_folders_are_frames_by_their_paths(cli, dataset, tmp_path):
    out = tmp_path / "annotations.xml"
    cli("convert", dataset.root, out, "--to", "cvat")
    out.write_text(out.read_text().replace('name="2.jpg"', 'name="other/1.png"'))
    cli("convert", out, tmp_path / "back", "--to", "soccernet")
    assert (tmp_path / "back" / "other" / "1.json").is_file()
    assert (tmp_path / "back" / "1.json").is_file()


def test_two_pictures_of_one_name_are_told(cli, dataset, tmp_path):
    out = tmp_path / "annotations.xml"
    cli("convert", dataset.root, out, "--to", "cvat")
    out.write_text(out.read_text().replace('name="2.jpg"', 'name="1.png"'))
    done = cli("convert", out, tmp_path / "back", "--to", "soccernet", code=1)
    assert "1: a second annotation of this frame, of 1.png beside 1.jpg" in done.stderr
    assert len(list((tmp_path / "back").iterdir())) == 4


def test_every_target_of_cameras_can_be_asked_for(cli, sample_data, tmp_path):
    assert set(CAMERA_TARGETS.values()) == set(WRITTEN)
    cameras = sample_data / "cameras" / "pinhole"
    for target in CAMERA_TARGETS:
        out = tmp_path / ("a.zip" if target == "submission" else target)
        done = cli("convert", cameras, out, "--to", target, "--camera-size", "960x540")
        assert f"cameras written to {out}" in done.stdout
        assert ("--camera-format world" in done.stderr) == (target == "world")
    back = (
        "evaluate",
        sample_data,
        tmp_path / "carwc",
        "--camera-format",
        "carwc",
        "--planar-only",
    )
    assert cli(*back).stdout.split() == cli(*back[:2], cameras, "--planar-only").stdout.split()


def test_cameras_of_no_stated_size_are_not_scaled_without_a_word(cli, sample_data, tmp_path):
    cameras = sample_data / "cameras" / "pinhole"
    done = cli("convert", cameras, tmp_path / "a", "--to", "krt", "--size", "1280x720")
    assert "note: not scaled to 1280x720: names no picture size" in done.stderr
    sized = ("--size", "1280x720", "--camera-size", "960x540")
    assert "not scaled" not in cli("convert", cameras, tmp_path / "b", "--to", "krt", *sized).stderr
    first = sorted((tmp_path / "b").iterdir())[0]
    assert json.loads(first.read_text())["width"] == 1280


def test_cameras_are_handed_to_their_own_export(cli, dataset, tmp_path, monkeypatch):
    calls: list[Any] = []

    def export_cameras(cameras: Any, out: Path, to: str, **more: Any) -> object:
        calls.append((sorted(cameras.frames), out, to, more["size"], more["split"]))
        return SimpleNamespace(losses={"scaled": 2}, problems=["one"], written=4, folded=["7"])

    monkeypatch.setattr("procc_annotator.cli.convert.export_cameras", export_cameras)
    out = tmp_path / "s.zip"
    done = cli(
        "convert", dataset.cameras, out, "--to", "submission", "--split", "challenge", code=1
    )
    assert calls == [(["1", "10", "11", "2", "3"], out, "submission", None, "challenge")]
    assert "4 cameras written" in done.stdout
    scaled, folded, left_out = done.stderr.splitlines()
    assert (scaled, left_out) == ("note: scaled (2 cameras)", "left out: one")
    assert folded.startswith("note: 1 camera folds lines")
    assert folded.endswith(": 7")
    cli("convert", dataset.cameras, dataset.cameras / "x", "--to", "krt", code=2)
    assert len(calls) == 1


@pytest.fixture
def wide(tmp_path) -> Path:
    """Cameras with barrel distortion near the touchline: b's lens folds what lies beside it back
    into the picture; a's bends, and folds nothing that is there."""
    folder = tmp_path / "wide"
    folder.mkdir()
    near = {
        "position_meters": [0.0, 45.0, -8.0], "x_focal_length": 600.0, "y_focal_length": 600.0,
    }  # fmt: skip
    for frame, k1 in (("a", -0.02), ("b", -0.15)):
        content = camera_file(0.0, **near, radial_distortion=[k1, 0, 0, 0, 0, 0])
        (folder / f"camera_{frame}.json").write_text(json.dumps(content))
    return folder


def test_lines_that_the_official_evaluation_folds_into_the_picture_are_told(cli, wide, tmp_path):
    for target, out in (("soccernet-camera", tmp_path / "out"), ("submission", tmp_path / "s.zip")):
        done = cli("convert", wide, out, "--to", target, "--camera-size", "960x540")
        (told,) = [line for line in done.stderr.splitlines() if "fold" in line]
        assert told.startswith("note: 1 camera folds lines from far outside back into the picture")
        assert told.endswith(": b")
    checked = cli("check-submission", tmp_path / "s.zip", code=1)
    (told,) = checked.stdout.splitlines()
    assert told.startswith("lowers the score: 1 camera folds lines")
    # Nobody else takes the lens for one that shows them.
    assert "fold" not in cli("convert", wide, tmp_path / "k", "--to", "krt").stderr


def test_a_fold_is_told_where_the_official_protocol_shows_more_than_the_other(wide):
    for name, more in (("a", set()), ("b", {"Big rect. left bottom", "Big rect. right bottom"})):
        path = wide / f"camera_{name}.json"
        camera = read_camera_file(path.read_bytes(), path=str(path)).camera
        shown = [
            set(project_field(camera, EvaluationSetup(load_field(), (960, 540), protocol)).pieces)
            for protocol in ("soccernet", "procc")
        ]
        assert shown[0] - shown[1] == more
