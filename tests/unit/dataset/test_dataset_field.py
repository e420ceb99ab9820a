"""Which field a dataset shows: its own file, what it keeps, the default; across several sets."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.dataset_field import (
    FIELD_SETTING,
    field_of_dataset,
    field_of_datasets,
    store_field,
)
from procc_annotator.dataset.layout import FIELD_FILE
from procc_annotator.errors import FieldError, UsageError
from procc_annotator.field.load import builtin_field_file, load_field, with_dimensions, with_lines

OTHER = """
name = "yard"
title = "Yard"
[dimensions]
length = { title = "Length", nominal = 20, minimum = 18, maximum = 22 }
width = { title = "Width", nominal = 10, minimum = 10, maximum = 10 }
[[elements]]
name = "fence"
title = "Fence"
group = "Lines"
colour = "#ff0000"
shortcut = "1"
kind = "line"
start = ["-length / 2", "0", "0"]
end = ["length / 2", "0", "0"]
"""


def keep(folder: Path, *, field: str | Path = "soccer", **dimensions: float) -> None:
    database = WorkspaceDatabase.open(folder, "one")
    store_field(database, folder, load_field(field, **dimensions))
    assert database.close()


def test_a_dataset_that_says_nothing_shows_the_default_field(tmp_path) -> None:
    found = field_of_dataset(tmp_path)
    assert (found.field, found.chosen, found.notices) == (load_field(None), False, ())
    assert not list(tmp_path.iterdir())  # asking leaves nothing behind
    assert not field_of_dataset(tmp_path / "nowhere.zip").chosen


def test_a_dataset_remembers_its_field_with_the_dimensions(tmp_path) -> None:
    keep(tmp_path, length=101.3)
    folder = tmp_path / "annotations"
    folder.mkdir()
    (folder / "1.json").write_text("{}")
    for place in (tmp_path, folder, folder / "1.json"):
        found = field_of_dataset(place)
        assert found.chosen
        assert found.field.described == "soccer 101.3 x 68 m"


def test_frames_of_a_video_are_a_dataset_of_their_own(tmp_path) -> None:
    video, frames = tmp_path / "match.mp4", tmp_path / "match_frames"
    frames.mkdir()
    video.write_bytes(b"")
    (frames / "match_000001.json").write_text("{}")
    keep(frames, length=101.3)
    (tmp_path / FIELD_FILE).write_text(OTHER)  # of nothing: no picture or annotation lies here
    for place in (video, tmp_path, frames, frames / "match_000001.json"):
        assert field_of_dataset(place).field.described == "soccer 101.3 x 68 m"
    (tmp_path / "1.json").write_text("{}")
    assert field_of_dataset(tmp_path).field.name == "yard"
    assert field_of_dataset(video).field.name == "soccer"


def test_a_file_inside_the_dataset_moves_with_it(tmp_path) -> None:
    before = tmp_path / "before"
    (before / "fields").mkdir(parents=True)
    (before / "fields" / "yard.toml").write_text(OTHER)
    keep(before, field=before / "fields" / "yard.toml", length=21)
    moved = before.rename(tmp_path / "after")
    found = field_of_dataset(moved).field
    assert found.described == "yard 21 x 10 m"
    assert found.source == moved / "fields" / "yard.toml"


def test_the_file_in_the_dataset_decides(tmp_path) -> None:
    keep(tmp_path)
    (tmp_path / FIELD_FILE).write_text(OTHER)
    assert field_of_dataset(tmp_path).field.name == "yard"
    (tmp_path / FIELD_FILE).write_text("name = 3")
    with pytest.raises(FieldError, match=FIELD_FILE):  # never another field in its place
        field_of_dataset(tmp_path)


def test_a_field_that_is_gone_is_told(tmp_path) -> None:
    own = tmp_path / "yard.toml"
    own.write_text(OTHER)
    keep(tmp_path, field=own)
    own.unlink()
    with pytest.raises(FieldError, match=r"yard\.toml: no such file"):
        field_of_dataset(tmp_path)
    database = WorkspaceDatabase.open(tmp_path, "one")
    database.set_setting(FIELD_SETTING, json.dumps(["soccer"]))
    assert database.close()
    with pytest.raises(FieldError, match="cannot be read"):
        field_of_dataset(tmp_path)


def test_dimensions_of_another_field_are_left(tmp_path) -> None:
    keep(tmp_path, length=101.3)
    (tmp_path / FIELD_FILE).write_text(OTHER)
    assert field_of_dataset(tmp_path).field.is_nominal


def test_a_dataset_remembers_where_its_lines_are(tmp_path) -> None:
    database = WorkspaceDatabase.open(tmp_path, "one")
    store_field(database, tmp_path, with_lines(load_field("soccer", length=101.3), "middle"))
    assert database.close()
    found = field_of_dataset(tmp_path)
    assert found.chosen
    assert found.field.described == "soccer 101.3 x 68 m, lines at their middle"
    keep(tmp_path)
    assert field_of_dataset(tmp_path).field == load_field("soccer")
    own = tmp_path / FIELD_FILE
    own.write_text('lines = "middle"' + OTHER)  # the file may say so, and be overruled
    assert field_of_dataset(tmp_path).field.lines == "middle"
    database = WorkspaceDatabase.open(tmp_path, "one")
    store_field(database, tmp_path, with_lines(load_field(own), "measured"))
    assert database.close()
    assert field_of_dataset(tmp_path).field.lines == "measured"
    database = WorkspaceDatabase.open(tmp_path, "one")
    database.set_setting("field_lines", '{"field": "yard", "lines": "edge"}')
    assert database.close()
    found = field_of_dataset(tmp_path)
    assert found.field.lines == "middle"
    assert "cannot be read" in found.notices[0]


def test_a_workspace_that_cannot_be_read_is_told(tmp_path) -> None:
    keep(tmp_path)
    kept = field_of_dataset(tmp_path)
    (tmp_path / ".procc" / "workspace.db").write_bytes(b"no database at all" * 100)
    found = field_of_dataset(tmp_path)
    assert (found.field, found.chosen) == (kept.field, True)
    assert "its backup of 20" in found.notices[0]
    (tmp_path / ".procc" / "workspace.db.backup").unlink()
    found = field_of_dataset(tmp_path)
    assert not found.chosen
    assert "workspace cannot be read" in found.notices[0]


def test_several_datasets_show_one_field(tmp_path) -> None:
    one, two, three = (tmp_path / name for name in "abc")
    for folder in (one, two, three):
        folder.mkdir()
    keep(one, length=101.3)
    assert field_of_datasets([one, two]).field.described == "soccer 101.3 x 68 m"
    (three / FIELD_FILE).write_text(OTHER)
    with pytest.raises(UsageError, match="different fields"):
        field_of_datasets([one, three])


def test_a_copy_of_a_shipped_description_is_a_file_of_its_own(tmp_path) -> None:
    copy = tmp_path / "soccer.toml"
    copy.write_text(builtin_field_file("soccer").read_text(encoding="utf-8"), encoding="utf-8")
    keep(tmp_path, field=copy)
    found = field_of_dataset(tmp_path).field
    assert found.source == copy
    assert with_dimensions(found, {"length": 100}).source == copy
