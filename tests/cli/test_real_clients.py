"""Exports as the libraries of others read them, where those are installed."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest


@pytest.fixture
def coco_set(cli, sample_data, tmp_path) -> Path:
    """The sample as COCO keypoints with its pictures, for training."""
    out = tmp_path / "coco"
    done = cli("convert", sample_data, out, "--to", "coco", "--split", "train", "--pictures")
    assert done.exit_code == 0, done.output
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


def test_pycocotools_scores_the_set_against_itself(coco_set, capsys) -> None:
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
