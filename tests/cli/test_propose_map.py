"""``propose-map``: what labels may stand for, by name and by geometry."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.geometry import Line
from procc_annotator.field.load import load_field

REAL = Path(__file__).resolve().parents[3] / "shared" / "data" / "foreign"


def as_labelme(cli, dataset, folder: Path, label_of) -> None:
    """The dataset with other labels; those that become None are left out."""
    assert cli("convert", dataset.root, folder, "--to", "labelme").exit_code == 0
    for file in folder.glob("*.json"):
        content = json.loads(file.read_text())
        for shape in content["shapes"]:
            shape["label"] = label_of(shape["label"].strip())
        file.write_text(json.dumps(content))


def test_labels_that_say_nothing_are_told_by_cameras(cli, dataset, tmp_path) -> None:
    names = [e.name.strip() for e in load_field(None).elements]
    as_labelme(cli, dataset, tmp_path / "set", lambda name: f"x{names.index(name)}")
    cameras, labels = dataset.cameras, tmp_path / "labels.toml"
    done = cli("propose-map", tmp_path / "set", "--cameras", cameras, "-o", labels)
    assert done.exit_code in (0, 1), done.stderr
    assert "by geometry alone" in done.stdout
    lines = [line for line in labels.read_text().splitlines() if line.startswith('"x')]
    assert len(lines) >= 10
    for line in lines:
        label, name = (part.strip('"') for part in line.split(" = "))
        assert names[int(label[1:])] == name
    used = cli("check", tmp_path / "set", "--map", labels, "--no-line-evidence")
    assert used.exit_code == 0, used.stderr


def test_labels_that_are_called_alike_need_no_camera(cli, dataset, tmp_path) -> None:
    def label(name: str) -> str:
        found = name.replace("Big rect.", "penalty area").replace("Middle line", "halfway-line")
        return found.replace("Side line", "touchline").replace("Circle", "circles").lower()

    as_labelme(cli, dataset, tmp_path / "set", label)
    labels = tmp_path / "labels.toml"
    done = cli("propose-map", tmp_path / "set", "-o", labels)
    assert done.exit_code in (0, 1), done.stderr
    text = labels.read_text()
    assert '"halfway-line" = "Middle line"' in text
    assert '"penalty area left main" = "Big rect. left main"' in text
    own = cli("evaluate", dataset.annotations, dataset.cameras, "-o", tmp_path / "own.json")
    mapped = cli(
        "evaluate", tmp_path / "set", dataset.cameras, "--map", labels, "-o", tmp_path / "s.json"
    )
    assert own.exit_code == mapped.exit_code
    scores = [
        json.loads((tmp_path / name).read_text())["summary"] for name in ("own.json", "s.json")
    ]
    assert scores[0] == scores[1]


def tennis_frame(number: int) -> dict[str, object]:
    """Seen from behind a baseline, its labels shared by pairs of lines and in any order."""
    field = load_field("tennis")
    camera = PinholeCamera(
        position_world=(24.0, 0.5 * number, -9.0 - number), pan_rad=np.radians(-90 + number),
        tilt_rad=np.radians(68), roll_rad=0.0, focal_px=(1000.0, 1000.0),
        principal_point_px=(480.0, 270.0),
    )  # fmt: skip
    shared = {
        "Baseline": "baseline", "Doubles sideline": "sideline-doubles",
        "Singles sideline": "sideline-singles", "Service line": "service-line",
    }  # fmt: skip
    shapes = []
    for element in field.elements:
        key = next((k for k in shared if element.name.startswith(k)), None)
        label = "service-centerline" if element.name == "Centre service line" else shared.get(key)
        if label is not None:
            ends = np.array([element.geometry.start, element.geometry.end])
            px, _ = camera.project(ends)
            shapes.append({"label": label, "points": px.tolist(), "shape_type": "linestrip"})
    rng = np.random.default_rng(number)
    shapes = [shapes[i] for i in rng.permutation(len(shapes))]
    return {"shapes": shapes, "imageWidth": 960, "imageHeight": 540, "imagePath": f"{number}.jpg"}


def test_lines_that_share_a_label_are_put_in_order(cli, tmp_path) -> None:
    folder = tmp_path / "tennis"
    folder.mkdir()
    for number in range(4):
        (folder / f"{number}.json").write_text(json.dumps(tennis_frame(number)))
    labels = folder / "labels.toml"
    done = cli("propose-map", folder, "--field", "tennis", "-o", labels)
    assert done.exit_code == 0, done.stderr
    assert done.stdout.count("sure") == 5
    text = labels.read_text()
    assert '"baseline" = { top_down = ["Baseline left", "Baseline right"] }' in text
    assert "left_to_right" in text
    found = cli("calibrate", folder, tmp_path / "cameras", "--field", "tennis", "-t", "2")
    assert found.exit_code == 0, found.stderr
    assert "4 cameras" in found.stdout


def test_names_of_another_sport_are_told(cli, tmp_path) -> None:
    (tmp_path / "0.json").write_text(json.dumps(tennis_frame(0)))
    done = cli("propose-map", tmp_path / "0.json", "-o", tmp_path / "labels.toml")
    assert "--field tennis" in done.stderr
    assert "open" in done.stdout
    again = cli("propose-map", tmp_path / "0.json", "-o", tmp_path / "labels.toml")
    assert again.exit_code == 2
    assert "exists already" in again.stderr


def test_what_was_left_out_is_told_where_there_is_nothing_to_propose(cli, tmp_path) -> None:
    content = {
        "images": [{"id": 1, "width": 640, "height": 360, "file_name": "a.jpg"}],
        "annotations": [
            {"id": 1, "image_id": 1, "category_id": 1, "keypoints": [0, 0, 0, 5, 5, 2] * 16}
        ],
        "categories": [{"id": 1, "name": "pitch", "keypoints": [str(i) for i in range(32)]}],
    }
    (tmp_path / "k.json").write_text(json.dumps(content))
    done = cli("propose-map", tmp_path / "k.json", "-o", tmp_path / "labels.toml")
    assert done.exit_code == 2
    assert '"pitch" = { template = "soccer_32" }' in done.stderr
    assert not (tmp_path / "labels.toml").exists()


@pytest.mark.skipif(not REAL.is_dir(), reason="the real files are not here")
@pytest.mark.parametrize("name", ["test", "training"])
def test_a_public_tennis_set(cli, tmp_path, name) -> None:
    labels = tmp_path / "labels.toml"
    source = REAL / f"tennis_cvat_{name}.xml"
    done = cli("propose-map", source, "--field", "tennis", "-o", labels)
    assert done.exit_code == 0, done.stderr
    assert done.stdout.count("sure ") == 5
    text = labels.read_text()
    assert '"service-line" = { top_down = ["Service line left", "Service line right"] }' in text
    assert '"service-centerline" = "Centre service line"' in text


def test_a_field_without_straight_lines(cli, dataset, tmp_path, monkeypatch) -> None:
    field = load_field(None)
    round_ones = tuple(e for e in field.elements if not isinstance(e.geometry, Line))
    as_labelme(cli, dataset, tmp_path / "set", str.lower)
    rings = replace(field, elements=round_ones, symmetries=())
    monkeypatch.setattr("procc_annotator.cli.propose_map.chosen_field", lambda *_: rings)
    done = cli("propose-map", tmp_path / "set", "-o", tmp_path / "labels.toml")
    assert done.exit_code in (0, 1), done.stderr
    assert '"circle central" = "Circle central"' in (tmp_path / "labels.toml").read_text()
