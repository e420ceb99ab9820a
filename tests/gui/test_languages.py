"""The window in other languages."""

from __future__ import annotations

import copy
from collections.abc import Iterator

import numpy as np
import pytest

from procc_annotator import language
from procc_annotator.field.load import load_field
from procc_annotator.fit.labels.clicked import Clicked
from procc_annotator.fit.labels.shape import few_points
from procc_annotator.language import (
    kept,
    said,
    said_all,
    said_count,
    said_joined,
    spoken,
    tr,
    tr_count,
)
from procc_annotator.report.sheet.as_json import json_bytes


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


def test_what_rooms_below_say_is_english_until_the_window_says_it(pseudo: None) -> None:
    titles = [said("Left line"), said("Arc"), said("Goal")]
    lines = said_count(1, "{n} line of {titles}", "{n} lines of {titles}", titles=said_all(titles))
    found = said_joined("; ", [lines, said("{px:.1f} px off", px=2)])
    assert found == "1 line of Left line, Arc and Goal; 2.0 px off"
    assert (
        json_bytes({"found": found})
        == b'{\n "found": "1 line of Left line, Arc and Goal; 2.0 px off"\n}\n'
    )
    for words in (found, copy.copy(found)):  # taken apart as on the way out of a process
        shown = tr("why: {found}", found=words)
        assert shown.count("⟦") == shown.count("⟧") == 9
        assert "⟦1 lines of ⟦⟦⟦Left line⟧, ⟦Arc⟧⟧ and ⟦Goal⟧⟧⟧" in shown
        assert "⟦2.0 px off⟧" in shown


def test_a_finding_is_said_with_the_titles_of_its_elements(pseudo: None) -> None:
    element = load_field("soccer").element("Middle line")
    assert element is not None
    found = few_points(Clicked(element, np.array([[1.0, 2.0]]), (0,)))
    assert found is not None
    assert found.reason == "Halfway line has 1 point, a line takes two"
    assert tr(found.reason) == "⟦⟦Halfway line⟧ has 1 points, a line takes two⟧"
    assert tr(found.remedies[0].text) == "⟦look at it⟧"
