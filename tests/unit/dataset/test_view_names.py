"""Frames of one instant told by their names: a pattern, and one that fits."""

from __future__ import annotations

import pytest

from procc_annotator.dataset.landmarks.view_groups import (
    ViewAssignment,
    groups_by_name,
    suggested_pattern,
    views_by_name,
)
from procc_annotator.errors import UsageError


@pytest.mark.parametrize(
    ("pattern", "names", "expected"),
    [
        ("{instant}_{view}", ("17_left_high", "17_right"), ("17", "left_high")),
        ("{view}_{instant}", ("left_high_17", "right_17"), ("17", "left_high")),
        ("{view}{instant}", ("left17", "right17"), ("17", "left")),
        ("game.{view}@{instant}s", ("game.left@1.5s", "game.r@1.5s"), ("1.5", "left")),
        (r"(?P<view>[a-z]+)-(?P<instant>\d+)-.*", ("left-17-x", "right-17-y"), ("17", "left")),
        (r"(?P<instant>\d+).", ("17a", "17b"), ("17", "")),
    ],
)
def test_names_tell_the_groups(pattern, names, expected) -> None:
    groups = groups_by_name([*names, "another"], pattern)
    assert groups.frames[names[0]] == ViewAssignment(*expected)
    assert groups.others(names[0]) == (names[1],)
    assert "another" not in groups.frames


@pytest.mark.parametrize(
    ("pattern", "words"),
    [
        ("{view}", "names no instant"),
        ("{instant}_{camera}", "has {camera}"),
        ("{instant}_{instant}", "once each"),
        ("(?P<instant>", "cannot be understood"),
        ("{instant}-{view}", "no name fits it"),
        ("{instant}_left", "1 of 2 names fit it"),
        (r"(?P<instant>\d+)(?P<view>_).*", "takes 17_left and 17_right both for the view '_'"),
    ],
)
def test_a_pattern_that_groups_nothing_is_refused(pattern, words) -> None:
    with pytest.raises(UsageError, match=words):
        groups_by_name(["17_left", "17_right"], pattern)


def test_a_pattern_tells_whom_it_leaves_alone_and_what_is_wrong() -> None:
    found = views_by_name(["17_left", "b", "17_right", "a"], "{instant}_{view}")
    assert (found.alone, found.problem) == (("a", "b"), "")
    assert found.groups.groups == {"17": ("17_left", "17_right")}
    twice = views_by_name(["17_left", "17_right"], r"(?P<instant>\d+)(?P<view>_).*")
    assert "both for the view '_'" in twice.problem
    assert len(twice.groups.frames) == 2  # to be looked at all the same


@pytest.mark.parametrize(
    ("names", "pattern"),
    [
        (["17_left", "17_right", "17_close"], "{instant}_{view}"),
        (["17-cam1", "17-cam2", "18-cam1", "18-cam2"], "{instant}-{view}"),
        (["cam1_17", "cam2_17", "cam1_18", "cam2_18"], "{view}_{instant}"),
        (["left_0001", "right_0001", "left_0002", "right_0002", "left_0003"], "{view}_{instant}"),
        (
            ["final_1_left", "final_1_right", "final_2_left", "final_2_right"],
            "final_{instant}_{view}",
        ),
        (["17L", "17R", "18L", "18R", "poster"], "{instant}{view}"),
        (["left17", "right17", "left18", "right18"], "{view}{instant}"),
        (
            ["05-01_22_a", "05-01_22_b", "05-02_23_a", "05-02_23_b"],
            "(?P<instant>.+)_(?P<view>[^_]+)",
        ),
        ([f"{i:05d}" for i in range(30)], ""),
        ([f"frame_{i}" for i in range(30)], ""),
        ([f"cut{i}_{j:04d}" for i in range(3) for j in range(i * 20, i * 20 + 20)], ""),
        (
            ["{a}_1_left", "{a}_1_right", "{a}_2_left", "{a}_2_right"],
            "(?P<instant>.+)_(?P<view>[^_]+)",
        ),
        (["one"], ""),
        ([], ""),
    ],
)
def test_a_pattern_that_fits_is_suggested(names, pattern) -> None:
    assert suggested_pattern(names) == pattern
    if pattern:
        assert not views_by_name(names, pattern).problem
