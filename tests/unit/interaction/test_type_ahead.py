"""A few letters find what is meant, and little else."""

from __future__ import annotations

import pytest

from procc_annotator.interaction.class_choice import loose_rank, match_rank, misspelt


@pytest.mark.parametrize(
    ("query", "name", "found"),
    [
        ("regall", "Regularise all elements", True),
        ("expover", "Export overview…", True),
        ("egall", "Regularise all elements", False),  # begins within a word
        ("rz", "Regularise all elements", False),
        ("open", "Zoom in", False),
    ],
)
def test_letters_in_order(query: str, name: str, found: bool) -> None:
    assert (loose_rank(query, name) is not None) is found
    assert match_rank(query, name) is None


def test_what_fits_closer_comes_first() -> None:
    names = ["Snap", "Snap to lines", "Do snap", "Unsnap", "Send map"]
    ranks = [loose_rank("snap", name) for name in names]
    assert all(rank is not None for rank in ranks)
    assert ranks == sorted(ranks, key=lambda rank: -1 if rank is None else rank)
    assert len(set(ranks)) == len(names)


@pytest.mark.parametrize(
    ("query", "name", "found"),
    [
        ("regulraise", "Regularise all elements", True),
        ("dissagreement", "Next by disagreement", True),
        ("zoom", "Boom", False),
        ("undo", "Redo", False),
        ("regulraise qq", "Regularise all elements", False),
    ],
)
def test_misspelt_words(query: str, name: str, found: bool) -> None:
    assert misspelt(query, name) is found
