"""``procc-annotator render`` and the headless job: pictures with the overlay of the window."""

import json
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import av
import cv2
import numpy as np
import pytest

from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.field.load import load_field
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.overlay_scene import Rendered, Rendering, caption

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
    assert "5 pictures" in done.stdout
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


def test_a_damaged_picture_is_listed(cli, dataset, tmp_path):
    (dataset.root / "2.jpg").write_bytes(b"not a picture")
    done = cli("render", dataset.root, tmp_path / "out", code=1)
    assert "4 pictures" in done.stdout
    assert "2.jpg" in done.stderr


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

    cameras = CameraSet.open(dataset.cameras)
    rendering = Rendering(Workspace.open(dataset.root, field), EvaluationSetup(field), 5.0, cameras)
    for scene in rendering.scenes(Rendered(tmp_path)):
        said[scene.title] = caption(scene)
        assert scene.measurement is not None  # its camera is drawn all the same
    assert said["1"] == ""
    assert "JaC@5 0.000" in said["2"]
    assert "JaC@5 1.000" in said["3"]


def frames_of(video: Path) -> list[np.ndarray]:
    with av.open(str(video)) as container:
        return [frame.to_ndarray(format="bgr24") for frame in container.decode(video=0)]


def test_a_video_of_the_overlays_and_one_of_a_video(cli, dataset, tmp_path):
    out = tmp_path / "overlay.mp4"
    done = cli("render", dataset.root, out, "--cameras", dataset.cameras, "--fps", 10)
    assert "5 frames written" in done.stdout
    frames = frames_of(out)
    assert [frame.shape for frame in frames] == [(540, 960, 3)] * 5
    greenish = np.abs(frames[0][..., ::-1].astype(int) - PASS).max(axis=2) < 60
    assert greenish.sum() > 300
    again = cli("render", dataset.root, out, "--cameras", dataset.cameras, code=2)
    assert "exists already" in again.stderr
    shown = json.loads((dataset.cameras / "camera_3.json").read_text())
    dataset.write_camera("overlay_000003", shown)  # a frame of the video
    cli("render", out, tmp_path / "twice.mp4", "--cameras", dataset.cameras)
    with av.open(str(tmp_path / "twice.mp4")) as container:
        assert container.streams.video[0].average_rate == 10
        assert len(list(container.decode(video=0))) == 5


def test_a_top_view_has_the_field_where_it_is(cli, dataset, tmp_path):
    """A picture that is white where the camera shows x > 0 is white there from above."""
    camera = CameraSet.open(dataset.cameras).camera("3", (960, 540))
    assert camera is not None
    u, v = np.meshgrid(np.arange(960.0), np.arange(540.0))
    ground = ground_from_px(camera.camera, np.column_stack((u.ravel(), v.ravel())))
    white = np.nan_to_num(ground[:, 0]).reshape(540, 960) > 0
    for name in ("1", "2", "10", "11"):
        (dataset.root / f"{name}.jpg").unlink()
    cv2.imwrite(str(dataset.root / "3.jpg"), np.where(white, 255, 60).astype(np.uint8))
    positions = tmp_path / "positions.csv"
    positions.write_text("frame,X,Y\n3,-10,20\n3,,\n")
    out, table = tmp_path / "field.png", ("--positions", positions)
    cli("render", dataset.root, out, "--cameras", dataset.cameras, "--top-view", *table)
    drawn = cv2.imread(str(out)).astype(int)
    assert drawn.shape == (780, 1150, 3)
    row = drawn[500, :, 0]  # y = 11 m; the field starts 5 m from the edge, 10 px per metre
    assert row[580:620].min() > 240
    assert row[480:560].max() < 80
    orange = (np.abs(drawn[..., ::-1] - (0xE6, 0x9F, 0x00)).max(axis=2) < 30).nonzero()
    assert np.median(orange[1]) == pytest.approx((-10 + 57.5) * 10, abs=1)
    assert np.median(orange[0]) == pytest.approx((20 + 39) * 10, abs=1)
    positions.write_text("frame,X,Y,axes\n3,1,2,corner\n")
    again = ("--cameras", dataset.cameras, "--top-view", "--overwrite")
    px = tmp_path / "px.csv"
    px.write_text("frame,x,y\n3,1,2\n")
    refused = cli("render", dataset.root, out, *again, "--positions", px, code=2)
    assert "x, y in px alone" in refused.stderr
    assert "in the axes corner" in cli("render", dataset.root, out, *again, *table, code=2).stderr
    for name in ("a.png", "a.mkv", "a.pdf"):
        refused = cli("render", dataset.root, tmp_path / name, code=2)
        assert "expected a folder, or a name that ends in .mp4; with --top-view" in refused.stderr


@pytest.mark.parametrize("suffix", [".svg", ".pdf", ".png"])
def test_a_figure_of_frames_and_methods(cli, dataset, tmp_path, suffix):
    bad = tmp_path / "bad"
    bad.mkdir()
    camera = json.loads((dataset.cameras / "camera_3.json").read_text())
    (bad / "camera_3.json").write_text(json.dumps(camera | {"pan_degrees": 1.0}))
    out = tmp_path / f"figure{suffix}"
    methods = ("--cameras", f"good={dataset.cameras}", "--cameras", f"bad={bad}")
    done = cli("figure", dataset.root, out, *methods, "--frame", "3", "--frame", "1")
    assert "frames 3, 1" in done.stdout
    data = out.read_bytes()
    if suffix == ".svg":
        root = ElementTree.fromstring(data)
        texts = ["".join(t.itertext()) for t in root.iter("{http://www.w3.org/2000/svg}text")]
        assert {"good", "bad", "3", "1", "JaC@5 100.0 %", "no camera"} <= set(texts)
        assert any(text.startswith("passes:") for text in texts)
    else:
        assert data.startswith({".pdf": b"%PDF", ".png": b"\x89PNG"}[suffix])
    none = cli("figure", dataset.root, tmp_path / "x.png", *methods, "--frame", "7", code=2)
    assert "has no frame '7'" in none.stderr
    nine = ["--frame", "3"] * 9
    long = cli("figure", dataset.root, tmp_path / "x.png", *methods[:2], *nine, code=2)
    assert "9 frames make a figure of 7 x 36 inches" in long.stderr
    assert "at most 8 frames (--count)" in long.stderr
