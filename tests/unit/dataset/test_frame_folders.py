"""The folders of a tree as rows of a list."""

from __future__ import annotations

from procc_annotator.dataset.frames import folders_of, rows_of

NAMES = [
    *("epl/a/img1/1", "epl/a/img1/2", "epl/b/img1/1"),
    *("liga/x/1", "liga/x/deep/1", "liga/x/deep/2"),
]


def test_a_folder_that_holds_nothing_but_another_is_one_with_it() -> None:
    folders = folders_of(NAMES)
    assert [(f.label, f.depth) for f in folders] == [
        ("epl", 0),
        ("a/img1", 1),
        ("b/img1", 1),
        ("liga/x", 0),
        ("deep", 1),
    ]
    assert [(f.first, f.own_past, f.past) for f in folders] == [
        (0, 0, 3),
        (0, 2, 2),
        (2, 3, 3),
        (3, 4, 6),
        (4, 6, 6),
    ]


def test_a_flat_dataset_has_no_folders() -> None:
    assert folders_of(["1", "2"]) == ()
    assert folders_of([]) == ()


def test_rows_are_folders_and_the_frames_in_those_that_are_open() -> None:
    folders = folders_of(NAMES)
    assert rows_of(folders, (), None) == [-1, -2, 0, 1, -3, 2, -4, 3, -5, 4, 5]
    assert rows_of(folders, {"epl"}, None) == [-1, -4, 3, -5, 4, 5]
    assert rows_of(folders, {"epl/a/img1", "liga/x"}, None) == [-1, -2, -3, 2, -4]


def test_folders_without_a_frame_that_is_shown_are_left_out() -> None:
    folders = folders_of(NAMES)
    assert rows_of(folders, (), [1, 5]) == [-1, -2, 1, -4, -5, 5]
    assert rows_of(folders, {"liga/x/deep"}, [1, 5]) == [-1, -2, 1, -4, -5]
    assert rows_of(folders, (), []) == []
