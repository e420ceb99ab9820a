"""Other programs read what is written here, and are read: those that `make clients` installs."""

import json
import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

CLIENT = Path(__file__).resolve().parents[1] / "clients" / "client.py"
Client = Callable[..., dict[str, Any]]


@pytest.fixture(scope="module")
def client() -> Client:
    """Calls a command of `client.py` in the environment of the other programs."""
    place = os.environ.get("PROCC_CLIENTS")
    if not place:
        pytest.skip("the other programs are in an environment of their own: make clients")
    python = Path(place) / ("Scripts/python.exe" if os.name == "nt" else "bin/python")

    def call(*arguments: object) -> dict[str, Any]:
        done = subprocess.run(
            [python, CLIENT, *map(str, arguments)], capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        read = json.loads(done.stdout)
        assert isinstance(read, dict)
        return read

    return call


@pytest.fixture
def written(cli, sample_data, tmp_path) -> Callable[[str], Path]:
    """Writes the sample in a format, with its pictures."""

    def write(fmt: str) -> Path:
        out = tmp_path / fmt
        cli("convert", sample_data, out, "--to", fmt, "--pictures")
        return out

    return write


def _expected(sample_data: Path) -> dict[str, dict[str, np.ndarray]]:
    """Frame -> class -> (N, 2) px, of all that have points."""
    frames = {}
    for file in sorted(sample_data.glob("0*.json")):
        content = json.loads(file.read_text()).items()
        frames[file.stem] = {
            name.strip(): np.array([[p["x"] * 1279, p["y"] * 719] for p in points])
            for name, points in content
            if points
        }
    return frames


def _require_same(read: dict[str, Any], expected: dict[str, dict[str, np.ndarray]]) -> None:
    assert read["pictures"] == len(expected)
    for (frame, shapes), own in zip(sorted(read["frames"].items()), expected.values(), strict=True):
        assert sorted(name.strip() for name, _ in shapes) == sorted(own), frame
        for name, points in shapes:
            np.testing.assert_allclose(points, own[name.strip()], atol=0.001, err_msg=frame)


@pytest.mark.parametrize(
    ("fmt", "called"),
    [("coco", "coco_person_keypoints"), ("cvat", "cvat"), ("cvat-video", "cvat")],
)
def test_datumaro_reads_every_point_and_picture(client, written, sample_data, fmt, called):
    _require_same(client("datumaro-read", called, written(fmt)), _expected(sample_data))


def test_labelme_reads_every_point_and_picture(client, written, sample_data):
    _require_same(client("labelme-read", written("labelme")), _expected(sample_data))


def test_what_labelme_saves_is_read_back(client, written, cli, sample_data, tmp_path):
    folder, saved = written("labelme"), tmp_path / "saved"
    saved.mkdir()
    for picture in folder.glob("*.jpg"):
        shutil.copy(picture, saved)
    client("labelme-write", folder, saved)
    _require_no_difference(cli, sample_data, saved)


@pytest.mark.parametrize(("fmt", "called"), [("coco", "coco_person_keypoints"), ("cvat", "cvat")])
def test_what_datumaro_exports_is_read_back(
    client, written, cli, sample_data, tmp_path, fmt, called
):
    exported = tmp_path / "exported"
    client("datumaro-write", called, written(fmt), called, exported)
    _require_no_difference(cli, sample_data, exported)


def _require_no_difference(cli, own: Path, other: Path) -> None:
    """All frames are there, and no point lies elsewhere."""
    table = other.with_name("agree.csv")
    done = cli("agree", own, other, "-t", "0.01", "-o", table)
    assert f"Agreement of {len(_expected(own))} frames" in done.stdout
    assert "100.00" in done.stdout


@pytest.mark.parametrize("program", ["pandas", "duckdb"])
def test_tables_are_read(client, cli, sample_data, tmp_path, program):
    table = tmp_path / "scores.csv"
    cli("evaluate", sample_data, sample_data / "cameras" / "bad", "-o", table)
    read = client(program, table)
    assert read["rows"] == len(_expected(sample_data))
    assert {"frame", "jac"} <= {name.lower() for name in read["columns"]}


# Exports as the libraries of others read them, where those are installed.


@pytest.fixture
def coco_set(cli, sample_data, tmp_path) -> Path:
    """The sample as COCO keypoints with its pictures, for training."""
    out = tmp_path / "coco"
    cli("convert", sample_data, out, "--to", "coco", "--split", "train", "--pictures")
    return out


def test_pycocotools_indexes_every_point_and_finds_the_pictures(coco_set, sample_data):
    coco = pytest.importorskip("pycocotools.coco", reason="pycocotools is not installed").COCO
    read = coco(str(coco_set / "annotations" / "person_keypoints_train.json"))
    for image in read.loadImgs(read.getImgIds()):
        assert (coco_set / "images" / "train" / image["file_name"]).is_file()
        written = json.loads((sample_data / image["file_name"]).with_suffix(".json").read_text())
        found = {}
        for annotation in read.loadAnns(read.getAnnIds(image["id"])):
            (category,) = read.loadCats(annotation["category_id"])
            points = np.reshape(annotation["keypoints"], (-1, 3))
            assert len(points) == len(category["keypoints"])
            shown = points[points[:, 2] > 0, :2]
            found[category["name"]] = shown / (image["width"] - 1, image["height"] - 1)
        assert {name.strip() for name in found} == {
            name.strip() for name, points in written.items() if points
        }
        for name, points in written.items():
            if points:
                own = [[point["x"], point["y"]] for point in points]
                np.testing.assert_allclose(found[name], own, atol=1e-12)


def test_pycocotools_scores_the_set_against_itself(coco_set, capsys):
    module = pytest.importorskip("pycocotools.coco", reason="pycocotools is not installed")
    from pycocotools.cocoeval import COCOeval

    truth = module.COCO(str(coco_set / "annotations" / "person_keypoints_train.json"))
    told = [{**entry, "score": 0.9} for entry in truth.loadAnns(truth.getAnnIds())]
    category = next(c for c in truth.loadCats(truth.getCatIds()) if c["name"] == "Middle line")
    scores = []
    for shift in (0.0, 400.0):
        moved = [dict(entry, keypoints=_moved(entry["keypoints"], shift)) for entry in told]
        judged = COCOeval(truth, truth.loadRes(moved), "keypoints")
        judged.params.catIds = [category["id"]]
        judged.params.kpt_oks_sigmas = np.full(len(category["keypoints"]), 0.05)
        judged.evaluate()
        judged.accumulate()
        judged.summarize()
        scores.append(judged.stats[0])
    assert scores == [pytest.approx(1.0), pytest.approx(0.0)]


def _moved(keypoints: list[float], shift: float) -> list[float]:
    return [value + shift if index % 3 == 0 else value for index, value in enumerate(keypoints)]
