"""Frames of one instant from several cameras."""

from __future__ import annotations

import pytest

from procc_annotator.dataset.landmarks.dataset_landmarks import unknown_frames_message
from procc_annotator.dataset.landmarks.view_groups import (
    ViewAssignment,
    ViewGroups,
    load_views,
    replace_views,
    save_views,
)
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError
from procc_annotator.field.load import load_field
from procc_annotator.formats.frame_names import FrameTable

GROUPS = ViewGroups(
    FrameTable(
        {
            "17_left": ViewAssignment("17", "left"),
            "17_right": ViewAssignment("17", "right"),
            "9_left": ViewAssignment("9", "left"),
        }
    )
)


def test_a_file_tells_the_groups(tmp_path) -> None:
    path = tmp_path / "views.csv"
    path.write_text("frame;instant;view;note\na2;t1;wide;x\na10;t1;close;\nb;t2;wide;\nc;;;\n")
    groups = load_views(path)
    assert groups.groups == {"t1": ("a2", "a10"), "t2": ("b",)}
    assert groups.others("a10") == ("a2",)
    assert groups.view_of("a10") == "close"
    assert groups.others("c") == ()
    assert groups.instant_of("c") is None
    assert groups.others("not there") == ()


def test_views_without_a_name_may_be_any_camera(tmp_path) -> None:
    path = tmp_path / "views.csv"
    path.write_text("frame,instant,view\na,1,\nb,1,\nc,2,left\nd,,left\ne,,left\n")
    assert load_views(path).groups == {"1": ("a", "b"), "2": ("c",)}


def test_rows_of_frames_that_there_are_not_are_named(tmp_path) -> None:
    path = tmp_path / "views.csv"
    path.write_text("frame,instant\n17_left,17\n17_rigth,17\n99,\n")
    assert load_views(path).unknown_rows(["17_left", "17_right"]) == (
        "views.csv: line 3: there is neither a picture nor an annotation of '17_rigth'; did you"
        " mean '17_right'?",
        "views.csv: line 4: there is neither a picture nor an annotation of '99'",
    )
    assert load_views(path).unknown_rows(["17_left", "17_rigth", "99"]) == ()


def test_groups_are_written_as_they_are_read(tmp_path) -> None:
    path = tmp_path / "views.csv"
    strange = ViewGroups(FrameTable({**GROUPS.frames, "=1+1": ViewAssignment("-3", 'a "b", c')}))
    save_views(path, strange)
    assert load_views(path) == strange
    assert "\n=1" not in path.read_text()


def test_a_name_that_is_no_utf_8_does_not_keep_the_others_from_being_written(tmp_path) -> None:
    file = tmp_path / "views.csv"
    save_views(file, ViewGroups(FrameTable({**GROUPS.frames, "caf\udce9": ViewAssignment("18")})))
    assert GROUPS.frames.items() < load_views(file).frames.items()


def test_a_dataset_without_the_file_has_no_groups(tmp_path) -> None:
    assert load_views(tmp_path / "views.csv") == ViewGroups()


def test_a_camera_takes_one_frame_at_an_instant(tmp_path) -> None:
    path = tmp_path / "views.csv"
    path.write_text("frame,instant,view\na,1,left\nb,1,right\nc,1,left\n")
    with pytest.raises(InputError, match="line 4: the view 'left' at instant '1' again, after li"):
        load_views(path)


def test_another_file_is_replaced_only_where_it_is_known(tmp_path) -> None:
    path = tmp_path / "views.csv"
    assert replace_views(path, GROUPS) is None
    assert load_views(path) == GROUPS
    same = b"frame;instant;view;note\n9_left;9;left;x\n17_right;17;right;\n17_left;17;left;\n"
    path.write_bytes(same)
    assert replace_views(path, GROUPS) is None
    assert path.read_bytes() == same  # it says so already, and more
    for other in (b"frame,instant\n17_left,1\n", b"damaged"):
        path.write_bytes(other)
        assert replace_views(path, GROUPS, same) == other
        assert path.read_bytes() == other
        assert replace_views(path, GROUPS, other) is None
        assert load_views(path) == GROUPS


def test_only_so_many_strange_rows_are_told() -> None:
    lines = {"a": 2, "b": 3, "c": 4}
    groups = ViewGroups(FrameTable(), "views.csv", lines)
    assert groups.unknown_frames({"b"}) == ("a", "c")
    assert [row.split(":")[1] for row in groups.unknown_rows(["b"], 1)] == [" line 2"]


def test_frames_are_found_however_they_are_spelled(tmp_path) -> None:
    """Letters composed otherwise, as a Mac's file system has them, and folders of pictures."""
    path = tmp_path / "views.csv"
    path.write_text("frame,instant,view\ncaf\u00e9/1,7,left\ncaf\u00e9/2,7,right\n", "utf-8")
    groups = load_views(path)
    there = "cafe\u0301/img1/1"
    assert groups.instant_of(there) == "7"
    assert groups.view_of(there) == "left"
    assert groups.others(there) == ("caf\u00e9/2",)
    assert groups.unknown_frames([there, "cafe\u0301/img1/2"]) == ()
    assert groups.unknown_rows([there])[0].startswith("views.csv: line 3: ")


def test_annotations_of_a_tree_may_have_no_picture(tmp_path) -> None:
    for game in ("game1", "game2"):
        (tmp_path / game / "annotations").mkdir(parents=True)
        (tmp_path / game / "1.png").touch()
    (tmp_path / "game2/annotations/5.json").write_text("{}")
    rows = "game2/img1/5,7\ngame2/5,7\ngame2/6,7\n"
    (tmp_path / "views.csv").write_text(f"frame,instant\ngame1/1,7\n{rows}")
    groups = load_views(tmp_path / "views.csv")
    said = unknown_frames_message(groups, Workspace.open(tmp_path, load_field("soccer")))
    assert said.startswith("views.csv: line 5: there is neither a picture nor an annotation of")
