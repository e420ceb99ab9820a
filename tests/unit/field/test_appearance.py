"""Field files say how paint looks; a mistake is told with its place; no figure depends on it."""

from __future__ import annotations

import pytest

from procc_annotator.errors import FieldError
from procc_annotator.field.load import builtin_field_file, field_names, load_field
from procc_annotator.field.model import ANY, BAR, EDGE, LINE, NOTHING, Appearance

MIDDLE = 'measured = "centre"\n'  # of soccer's halfway line


def looks(sport: str, name: str) -> Appearance:
    field = load_field(sport)
    return field.elements[field.index[name]].appearance


@pytest.mark.parametrize(
    ("sport", "name", "expected"),
    [
        ("soccer", "Side line top", Appearance(LINE, "lighter", "white", 0.12)),
        ("soccer", "Goal left post left ", Appearance(BAR, "lighter", "white", 0.12)),
        ("soccer", "Centre mark", Appearance(NOTHING)),
        ("ice_hockey_nhl", "Line goal left", Appearance(LINE, "darker", "red", 0.0508)),
        ("ice_hockey_nhl", "Line blue left", Appearance(LINE, "darker", "blue", 0.3048)),
        ("ice_hockey_nhl", "Circle centre", Appearance(LINE, "darker", "blue", 0.0508)),
        ("ice_hockey_nhl", "Goal left crossbar", Appearance(BAR, ANY, "red", 0.0603)),
        ("ice_hockey_nhl", "Board side top", Appearance(EDGE)),
        ("ice_hockey_iihf", "Rail side top", Appearance(EDGE)),
        ("basketball_fiba", "3-points left arc", Appearance(LINE, ANY, ANY, 0.05)),
        ("basketball_fiba", "Rim left", Appearance(BAR, ANY, "orange", 0.018)),
        ("american_football", "Side line top", Appearance(EDGE, "lighter", "white", 1.8288)),
        ("american_football", "Hash marks top", Appearance(NOTHING)),
        ("volleyball", "Net top band", Appearance(BAR, ANY, "white", 0.07)),
        ("futsal", "Goal left crossbar", Appearance(BAR, ANY, ANY, 0.08)),
    ],
)
def test_shipped_fields_say_how_paint_looks(sport, name, expected) -> None:
    assert looks(sport, name) == expected


@pytest.mark.parametrize("sport", field_names())
def test_every_painted_line_of_a_shipped_field_has_a_width_and_a_tone(sport) -> None:
    text = builtin_field_file(sport).read_text(encoding="utf-8")
    assert "\ntone = " in text.split("[[elements]]")[0]
    for element in load_field(sport).elements:
        own = element.appearance
        assert (own.kind == NOTHING) >= element.is_spot
        if own.kind == LINE:
            assert own.width_m == element.line_width > 0, element.name


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('tone = "lighter"', 'tone = "bright"', "line 38: paint.tone: expected one of lighter,"),
        ("[bars]", '[bars]\npaint_colour = "mauve"', "bars.paint_colour: expected one of white,"),
        ("diameter = 0.12", "diameter = 3", "bars.diameter: expected 0 to 2 m, found 3"),
        ("diameter = 0.12", 'diameter = "wide"', "bars.diameter: bad formula"),
        ("[bars]", "[bars]\nline_width = 1", "bars.line_width: unknown key"),
        (MIDDLE, MIDDLE + "tone = 1\n", "element 'Middle line'.tone: expected one of"),
        (MIDDLE, MIDDLE + 'seen_as = "curb"\n', "'Middle line'.seen_as: expected one of line,"),
        (MIDDLE, MIDDLE + "diameter = 1\n", "is of use only with seen_as"),
    ],
)
def test_a_mistake_is_told_with_its_place(tmp_path, old, new, expected) -> None:
    text = builtin_field_file("soccer").read_text(encoding="utf-8")
    if new.startswith("[bars]\npaint_colour"):
        text = text.replace('paint_colour = "white"\n\n# Where', "\n# Where")
    path = tmp_path / "field.toml"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(FieldError) as caught:
        load_field(path)
    assert expected in str(caught.value)
    assert "line " in str(caught.value)


def test_what_paint_looks_like_is_no_part_of_what_a_field_is(tmp_path) -> None:
    """A copy of a shipped field made before it said so is that field still."""
    text = builtin_field_file("soccer").read_text(encoding="utf-8")
    path = tmp_path / "field.toml"
    path.write_text(text.replace('tone = "lighter"\n', ""), encoding="utf-8")
    field = load_field(path)
    assert field.full_name == "soccer"
    assert field == load_field("soccer")
    assert field.elements[0].appearance.tone == ANY
