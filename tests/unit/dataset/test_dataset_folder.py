"""Which folder a dataset's own things lie in, however the dataset is named."""

from __future__ import annotations

from pathlib import Path

import pytest

from procc_annotator.dataset.layout import folder_of_dataset


@pytest.fixture
def match(tmp_path) -> Path:
    folder = tmp_path / "match"
    (folder / "annotations").mkdir(parents=True)
    for name in ("1.png", "annotations/1.json", "match.mp4", "match.zip"):
        (folder / name).write_bytes(b"")
    return folder


def test_pictures_and_annotations_lead_to_their_folder(match) -> None:
    for place in ("", "1.png", "annotations", "annotations/1.json"):
        assert folder_of_dataset(match / place) == match
    assert folder_of_dataset(match / "match.mp4") == match / "match_frames"
    assert folder_of_dataset(match / "match.zip") is None
    assert folder_of_dataset(match / "nothing") is None


@pytest.mark.parametrize("own", ["field.toml", "landmarks.json", "views.csv", "2.png .procc/"])
def test_annotations_with_things_of_their_own_are_a_dataset(match, own) -> None:
    for name in own.split():
        path = match / "annotations" / name
        path.mkdir() if name.endswith("/") else path.write_bytes(b"")
    assert folder_of_dataset(match / "annotations") == match / "annotations"


def test_a_folder_is_that_of_the_one_video_annotated_in_it(tmp_path) -> None:
    for name in ("a.mp4", "b.MOV"):
        (tmp_path / name).write_bytes(b"")
    assert folder_of_dataset(tmp_path) == tmp_path
    for frames in ("a_frames", "b_frames"):
        (tmp_path / frames).mkdir()
    (tmp_path / "a_frames" / "a_000001.json").write_text("{}")
    assert folder_of_dataset(tmp_path) == tmp_path / "a_frames"
    (tmp_path / "b_frames" / "landmarks.json").write_text("{}")  # annotates nothing
    assert folder_of_dataset(tmp_path) == tmp_path / "a_frames"
    (tmp_path / "b_frames" / "b_000001.json").write_text("{}")
    assert folder_of_dataset(tmp_path) == tmp_path
    (tmp_path / "a_frames" / "a_000001.json").unlink()
    (tmp_path / "b_frames" / "b_000001.json").unlink()
    (tmp_path / "1.json").write_text("{}")
    assert folder_of_dataset(tmp_path) == tmp_path
