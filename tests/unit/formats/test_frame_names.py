"""Frames are found whatever their folders are called and however their letters are composed."""

from __future__ import annotations

import unicodedata

import pytest

from procc_annotator.formats.frame_names import ByFrame, FrameTable

COMPOSED = unicodedata.normalize("NFC", "café")
APART = unicodedata.normalize("NFD", "café")


@pytest.mark.parametrize("here", [COMPOSED, APART])
@pytest.mark.parametrize("asked", [COMPOSED, APART])
def test_letters_and_folders_may_differ_at_once(here, asked) -> None:
    table = FrameTable({f"{here}/1": "a"})
    assert [table.get(f"{asked}/{inner}1") for inner in ("", "img1/", "images/")] == ["a"] * 3
    assert f"{asked}/2" not in table
    within = FrameTable({f"{here}/img1/1": "a"})
    assert within[f"{asked}/1"] == "a"
    flat = ByFrame({f"{here}_1": "a"})
    flat.only_folder = f"{here}/"
    assert flat[f"{asked}/{asked}_1"] == "a"
    assert f"other/{asked}_1" not in flat


def test_a_frame_is_called_in_other_lists_with_the_folder_it_lies_in() -> None:
    tree = ByFrame({"g1/1": "a", "g2/1": "b"})
    one = ByFrame({"1": "c"})
    one.only_folder = "g2/"
    assert one.called_in(tree, "1") == "g2/1"
    assert [tree.called_in(one, name) for name in tree] == [None, "1"]
