"""Commands read annotations of every format as they read the program's own."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

FORMATS = ("labelme", "cvat", "coco", "soccernet-v3", "soccernet-gsr")


@pytest.mark.parametrize("fmt", FORMATS)
def test_figures_are_those_of_the_annotations_themselves(
    cli, dataset, tmp_path: Path, fmt: str
) -> None:
    cameras = dataset.cameras
    assert cli("convert", dataset.root, tmp_path / fmt, "--to", fmt).exit_code == 0
    scores = {}
    for name, place in (("own", dataset.annotations), (fmt, tmp_path / fmt)):
        file = tmp_path / f"{name}.json"
        done = cli("evaluate", place, cameras, "-o", file)
        assert done.exit_code in (0, 1), done.stderr
        scores[name] = json.loads(file.read_text())["summary"]
    assert scores[fmt] == scores["own"]
    assert ": read as" in done.stderr


@pytest.mark.parametrize("fmt", FORMATS)
def test_annotators_agree_across_formats(cli, dataset, tmp_path: Path, fmt: str) -> None:
    assert cli("convert", dataset.root, tmp_path / fmt, "--to", fmt).exit_code == 0
    done = cli("agree", dataset.annotations, tmp_path / fmt)
    assert done.exit_code == 0, done.stderr
    assert "100.00" in done.stdout


def test_a_tree_of_folders_is_one_set(cli, dataset, sample_data: Path, tmp_path: Path) -> None:
    """Frames of one name in two matches are two frames, and so are their cameras."""
    one = next(iter(sorted((sample_data).glob("0*.json"))))
    camera = sample_data / "cameras" / "pinhole" / f"camera_{one.name}"
    for match in ("a/img1", "b/img1"):
        (tmp_path / "set" / match).mkdir(parents=True)
        (tmp_path / "cameras" / match).mkdir(parents=True)
        (tmp_path / "set" / match / one.name).write_bytes(one.read_bytes())
        (tmp_path / "cameras" / match / camera.name).write_bytes(camera.read_bytes())
    loop = tmp_path / "set" / "a" / "again"
    loop.symlink_to(tmp_path / "set", target_is_directory=True)
    done = cli("evaluate", tmp_path / "set", tmp_path / "cameras", "-o", tmp_path / "s.csv")
    assert done.exit_code == 0, done.stderr
    text = (tmp_path / "s.csv").read_text()
    assert f"a/img1/{one.stem}" in text
    assert f"b/img1/{one.stem}" in text
    assert "again" not in text


def test_a_table_at_the_top_of_a_tree_is_no_frame(cli, sample_data: Path, tmp_path: Path) -> None:
    one = next(iter(sorted((sample_data).glob("0*.json"))))
    (tmp_path / "set" / "game").mkdir(parents=True)
    (tmp_path / "set" / "other").mkdir()
    (tmp_path / "set" / "sequences_info.json").write_text('{"version": "1.3"}')
    (tmp_path / "set" / "game" / one.name).write_bytes(one.read_bytes())
    (tmp_path / "set" / "other" / one.name).write_bytes(one.read_bytes())
    done = cli("check", tmp_path / "set", "--no-paint")
    assert done.exit_code == 0, done.stderr
    assert "2 frames" in done.stdout + done.stderr
