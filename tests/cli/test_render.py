"""``procc-annotator render`` and the headless job: pictures with the overlay of the window."""

import json
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.field.load import load_field
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.overlay_scene import Scene, caption, render_pictures

PASS = (0x00, 0x9E, 0x73)
TOO_FAR = (0xD5, 0x5E, 0x00)


pytestmark = pytest.mark.usefixtures("qapp")


def pixels_of(path: Path, rgb: tuple[int, int, int]) -> int:
    """How many pixels have about this colour."""
    picture = cv2.imread(str(path))
    return int((np.abs(picture[..., ::-1].astype(int) - rgb).max(axis=2) < 24).sum())


def test_colours_say_which_camera_agrees(cli, dataset, tmp_path):
    bad = json.loads((dataset.cameras / "camera_3.json").read_text())
    dataset.write_camera("3", bad | {"pan_degrees": 1.0})
    out = tmp_path / "out"
    done = cli("render", dataset.root, out, "--cameras", dataset.cameras)
    assert "5 overlay pictures" in done.stdout
    assert sorted(p.name for p in out.iterdir()) == ["1.png", "10.png", "11.png", "2.png", "3.png"]
    assert cv2.imread(str(out / "1.png")).shape == (540, 960, 3)
    assert pixels_of(out / "1.png", PASS) > 300
    assert pixels_of(out / "1.png", TOO_FAR) == 0
    assert pixels_of(out / "3.png", TOO_FAR) > 300


def test_without_cameras_the_annotation_is_drawn(cli, dataset, tmp_path):
    out = tmp_path / "out"
    cli("render", dataset.root, out, "--format", "jpg")
    grey = cv2.imread(str(dataset.root / "1.jpg")).astype(int)
    drawn = cv2.imread(str(out / "1.jpg")).astype(int)
    assert (np.abs(drawn - grey).max(axis=2) > 40).sum() > 300


def test_a_camera_without_an_annotation_is_drawn(cli, dataset, tmp_path):
    (dataset.annotations / "1.json").unlink()
    (dataset.annotations / "2.json").unlink()
    next(dataset.cameras.glob("camera_2.*")).unlink()
    out = tmp_path / "out"
    done = cli("render", dataset.root, out, "--cameras", dataset.cameras)
    assert "nothing is drawn: 1 frame (2)" in done.stderr
    changed = {}
    for name in ("1", "2"):
        before, after = (
            cv2.imread(str(dataset.root / f"{name}.jpg")),
            cv2.imread(str(out / f"{name}.png")),
        )
        changed[name] = int((np.abs(after.astype(int) - before).max(axis=2) > 40).sum())
    assert changed["1"] > 300
    assert changed["2"] == 0


def test_svg_at_a_scale_with_a_legend(cli, dataset, tmp_path):
    out = tmp_path / "out"
    cli(
        "render", dataset.root, out, "--cameras", dataset.cameras,
        "--format", "svg", "--scale", 2, "--legend",
    )  # fmt: skip
    root = ElementTree.parse(out / "3.svg").getroot()
    assert root.get("width") == "1920"
    texts = ["".join(text.itertext()) for text in root.iter("{http://www.w3.org/2000/svg}text")]
    assert any(text.startswith("passes: every point closer than 5 px") for text in texts)
    assert any("JaC@5 1.000" in text and "soccernet, 960x540" in text for text in texts)


def test_a_scale_that_is_none(cli, dataset, tmp_path):
    done = cli("render", dataset.root, tmp_path / "out", "--scale", 0, code=2)
    assert "scale" in done.stderr


def test_a_damaged_picture_is_listed(cli, dataset, tmp_path):
    (dataset.root / "2.jpg").write_bytes(b"not a picture")
    done = cli("render", dataset.root, tmp_path / "out", code=1)
    assert "4 overlay pictures" in done.stdout
    assert "2.jpg" in done.stderr


def test_pictures_of_the_dataset_are_never_replaced(cli, dataset):
    cli("render", dataset.root, dataset.root, "--format", "jpg", code=2)


def test_pictures_are_not_drawn_among_the_cameras(cli, dataset):
    for folder in (dataset.cameras, dataset.annotations):
        done = cli("render", dataset.root, folder, "--cameras", dataset.cameras, code=2)
        assert "holds the files to be read" in done.stderr
        assert not list(folder.glob("*.png"))


def test_the_painted_width_is_drawn_on_demand(cli, dataset, tmp_path):
    drawn = {}
    for more in ([], ["--painted-width"]):
        out = tmp_path / f"out{len(more)}"
        cli("render", dataset.root, out, "--cameras", dataset.cameras, "--legend", *more)
        drawn[len(more)] = pixels_of(out / "3.png", PASS)
    assert drawn[1] > drawn[0] * 1.1


def test_pictures_that_are_there_are_replaced_only_on_request(cli, dataset, tmp_path):
    kept = tmp_path / "out" / "3.png"
    kept.parent.mkdir()
    kept.write_text("somebody's")
    refused = cli("render", dataset.root, kept.parent, code=2)
    assert "holds 3.png already" in refused.stderr
    assert [path.name for path in kept.parent.iterdir()] == ["3.png"]
    assert kept.read_text() == "somebody's"
    cli("render", dataset.root, kept.parent, "--overwrite")
    assert kept.read_bytes().startswith(b"\x89PNG")


def test_frames_nobody_annotated_have_no_score(dataset, tmp_path):
    (dataset.annotations / "1.json").unlink()
    (dataset.annotations / "2.json").write_text("{}")  # annotated: there is nothing to see
    field = load_field("soccer")
    said: dict[str, str] = {}

    def paint(scene: Scene) -> bytes:
        said[scene.title] = caption(scene)
        assert scene.measurement is not None  # its camera is drawn all the same
        return b""

    pictures = render_pictures(
        Workspace.open(dataset.root, field),
        tmp_path / "out",
        paint,
        setup=EvaluationSetup(field),
        threshold=5.0,
        cameras=CameraSet.open(dataset.cameras),
    )
    assert sum(1 for _ in pictures) == 5
    assert said["1"] == ""
    assert "JaC@5 0.000" in said["2"]
    assert "JaC@5 1.000" in said["3"]
