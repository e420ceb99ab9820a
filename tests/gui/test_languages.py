"""The window in other languages."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from procc_annotator import language
from procc_annotator.language import kept, spoken, tr, tr_count


@pytest.fixture
def pseudo() -> Iterator[None]:
    """A language that puts brackets around whatever is translated, so that the rest shows."""

    def look_up(text: str, about: str, count: int) -> str:
        return f"⟦{text}⟧"

    language.speak(look_up)
    yield
    language.speak(None)


def test_texts_are_english_where_no_language_is_taken_up() -> None:
    assert tr("{a} of {b}", a=1, b=2) == "1 of 2"
    assert tr("100 % {of it}") == "100 % {of it}"
    assert tr_count(1, "{n} frame of {all}", "{n} frames of {all}", all=3) == "1 frame of 3"
    assert tr_count(2, "{n} frame of {all}", "{n} frames of {all}", all=3) == "2 frames of 3"


def test_texts_and_their_values_go_through_the_language(pseudo: None) -> None:
    assert tr("{a} of {b}", a=1, b=2) == "⟦1 of 2⟧"
    assert tr_count(1, "{n} frame", "{n} frames") == "⟦1 frames⟧"


def test_what_is_kept_in_a_file_is_english_and_shown_in_the_language(pseudo: None) -> None:
    step = kept(lambda: tr("drop {what}", what=tr_count(1, "{n} line", "{n} lines")))
    assert step == "drop 1 line"
    assert spoken(step) == "⟦drop ⟦1 lines⟧⟧"
    assert spoken("saved") == "⟦saved⟧"
    assert tr("saved") == "⟦saved⟧"
