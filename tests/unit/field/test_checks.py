"""What `field check` says of a field that can be read: mistakes are found, right fields pass."""

import time
from pathlib import Path

import pytest

from procc_annotator.errors import FieldError
from procc_annotator.field.file_reader import line_number_of
from procc_annotator.field.load import field_names, load_field
from procc_annotator.field.validation import WarningSeverity, validate_field
from procc_annotator.resources import resources_dir

COURT = """
name = "court"
title = "Court"
rules = "House rules, 1st edition"
symmetries = [180]
[dimensions]
length = { title = "Length", nominal = 20.0, minimum = 18.0, maximum = 22.0 }
width = { title = "Width", nominal = 10.0, minimum = 10.0, maximum = 10.0 }
line = { title = "Line width", nominal = 0.05, minimum = 0.05, maximum = 0.05 }
[paint]
line_width = "line"
[cameras]
distance = [2, 5, 10]
height = [2, 4, 8]
[[elements]]
name = "End left"
title = "Left end line"
group = "Court"
colour = "#112233"
shortcut = "7"
kind = "line"
start = ["-length / 2", "-width / 2", "0"]
end = ["-length / 2", "width / 2", "0"]
[[elements]]
name = "End right"
title = "Right end line"
group = "Court"
colour = "#FF0000"
shortcut = "8"
kind = "line"
start = ["length / 2", "-width / 2", "0"]
end = ["length / 2", "width / 2", "0"]
[[elements]]
name = "Side near"
title = "Near side line"
group = "Court"
colour = "#00FF00"
shortcut = "Shift+K"
kind = "line"
start = ["-length / 2", "width / 2", "0"]
end = ["length / 2", "width / 2", "0"]
[[elements]]
name = "Side far"
title = "Far side line"
group = "Court"
colour = "#FFFFFF"
shortcut = "I"
kind = "line"
start = ["-length / 2", "-width / 2", "0"]
end = ["length / 2", "-width / 2", "0"]
[[elements]]
name = "Net"
title = "Net"
group = "Net"
colour = "#FFFFFF"
shortcut = "T"
kind = "line"
start = ["0", "-width / 2", "-0.9"]
end = ["0", "width / 2", "-0.9"]
"""
NET = 'start = ["0", "-width / 2", "-0.9"]\nend = ["0", "width / 2", "-0.9"]'


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "court.toml"
    path.write_text(text, encoding="utf-8")
    return path


def remarks(tmp_path: Path, old: str = "", new: str = "", **taken: str) -> list[str]:
    assert old in COURT
    field = load_field(written(tmp_path, COURT.replace(old, new, 1)))
    return [str(remark) for remark in validate_field(field, taken)]


@pytest.mark.parametrize("name", field_names())
def test_the_shipped_fields_give_no_warning(name):
    found = [r for r in validate_field(load_field(name)) if r.severity is not WarningSeverity.NOTE]
    assert not found


def test_a_right_field_gives_no_remark(tmp_path):
    assert remarks(tmp_path) == []


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            NET,
            NET.replace("-0.9", "0.9"),
            "warning: element 'Net': lies 0.9 m below the ground (z points down: a height of 0.9 m"
            " is z = -0.9)",
        ),
        (
            "symmetries = [180]",
            "symmetries = []",
            "warning: symmetries: a turn by 180 degrees takes the field to itself, but is not"
            " listed (symmetries = [180], unless the sides can be distinguished)",
        ),
        (
            'colour = "#00FF00"',
            'colour = "#FF0105"',
            "warning: element 'Side near'.colour: #FF0105 is hard to distinguish from 'Right end"
            " line', #FF0000, in the group 'Court' (choose colours that differ)",
        ),
        (
            'shortcut = "T"',
            'shortcut = "S"',
            "warning: element 'Net'.shortcut: the key S is taken by the window: Snap to lines"
            " (choose another key)",
        ),
        (
            'shortcut = "T"',
            'shortcut = "Shft+T"',
            "warning: element 'Net'.shortcut: 'Shft+T' is no key (expected e.g. \"7\", \"K\" or"
            ' "Shift+K")',
        ),
        (
            'shortcut = "T"',
            'shortcut = ""',
            "note: elements: 1 element has no shortcut: 'Net' (they are chosen in the list, on"
            " the field map, or with /)",
        ),
        (
            'title = "Left end line"',
            'title = "Net"',
            "warning: element 'Net'.title: 'Net' is the title of 'End left', 'Net' (people choose"
            " an element by its title)",
        ),
        (
            'name = "court"',
            'name = "tennis"',
            "warning: name: 'tennis' is the name of a field that comes with the program (give it"
            " a name of its own)",
        ),
        (
            'rules = "House rules, 1st edition"\n',
            "",
            "note: rules: is not given (name the rule book and its edition)",
        ),
        (
            "[cameras]\ndistance = [2, 5, 10]\nheight = [2, 4, 8]\n",
            "",
            "note: cameras: is not given (where cameras stand is taken from the size of the field)",
        ),
        (
            '[paint]\nline_width = "line"\n',
            "",
            "note: paint: no line has a width (painted width cannot be shown: add [paint] with a"
            " line_width)",
        ),
    ],
)
def test_a_doubt_is_named_with_its_place_and_what_to_do(tmp_path, old, new, expected):
    assert expected in remarks(tmp_path, old, new, S="Snap to lines")


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            NET,
            NET.replace('"0"', '"length"'),
            "warning: element 'Net': lies up to 10 m outside the field of 20 x 10 m (coordinates"
            " are counted from the centre of the field)",
        ),
        (
            'start = ["-length / 2", "width / 2", "0"]\nend = ["length / 2", "width / 2", "0"]',
            'start = ["-length / 2", "-width / 2", "0"]\nend = ["length / 2", "-width / 2", "0"]',
            "warning: element 'Side far': lies where 'Near side line' lies (they cannot be"
            " distinguished: is one of them on the other side?)",
        ),
    ],
)
def test_misplaced_elements_are_named(tmp_path, old, new, expected):
    assert old in COURT
    text = COURT.replace("symmetries = [180]", "symmetries = []").replace(old, new)
    found = [str(remark) for remark in validate_field(load_field(written(tmp_path, text)))]
    assert expected in found


def test_coordinates_from_a_corner_are_noticed(tmp_path):
    text = COURT.replace("-length / 2", "0").replace("length / 2", "length")
    text = text.replace("-width / 2", "0").replace("width / 2", "width")
    text = text.replace("symmetries = [180]", "symmetries = []")
    found = [str(r) for r in validate_field(load_field(written(tmp_path, text)))]
    assert any("their middle is 10 m away from the origin" in r for r in found)
    assert any("their middle is 5 m away from the origin" in r for r in found)
    assert any("element 'End right': lies up to 10 m outside" in r for r in found)


def test_half_a_field_is_noticed(tmp_path):
    found = [
        str(r)
        for r in validate_field(
            load_field(written(tmp_path, COURT.replace("length / 2", "length / 4")))
        )
    ]
    assert any(
        "dimensions.length: is 20 m, but the lines on the ground span 10 m" in r for r in found
    )


def test_every_size_the_rules_allow_must_make_a_field(tmp_path):
    found = remarks(tmp_path, 'line_width = "line"', 'line_width = "line * sqrt(length - 19)"')
    assert len(found) == 1
    assert found[0].startswith(
        "error: dimensions.length: the field cannot be read with every value of 18 to 22 m: line"
    )


def test_a_dimension_that_nothing_follows_is_noticed(tmp_path):
    found = remarks(
        tmp_path,
        "[paint]",
        'net = { title = "Net", nominal = 0.9, minimum = 0.8, maximum = 1.0 }\n[paint]',
    )
    assert found == [
        "warning: dimensions.net: may be 0.8 to 1 m, but no element changes with it (use its name"
        " in a formula, or leave it out)"
    ]


@pytest.mark.parametrize(
    ("old", "new", "line_with"),
    [
        ('end = ["length / 2", "width / 2", "0"]', 'end = ["lenght", "0", "0"]', "lenght"),
        ('shortcut = "8"', 'shortcut = "7"', 'shortcut = "7"\nkind = "line"\nstart = ["length'),
        ("nominal = 20.0", "nominal = 30.0", "nominal = 30.0"),
        ("height = [2, 4, 8]", "height = [4, 2, 8]", "height = [4"),
        ("symmetries = [180]", "symmetries = [90]", "symmetries = [90]"),
        ('colour = "#FF0000"\n', "", 'name = "End right"'),
        ('kind = "line"', 'kind = "lime"', 'kind = "lime"'),
        ('name = "Net"', 'name = "Side far"', 'name = "Side far"\ntitle = "Net"'),
    ],
)
def test_an_error_says_its_line(tmp_path, old, new, line_with):
    text = COURT.replace(old, new, 1)
    line = text[: text.index(line_with)].count("\n") + 1
    with pytest.raises(FieldError) as caught:
        load_field(written(tmp_path, text))
    # A key that is missing is told at the head of its element.
    expected = line - 1 if not new else line
    assert caught.value.place.startswith(f"line {expected}: ")


def test_lines_of_a_real_file():
    text = (resources_dir() / "field" / "soccer.toml").read_text(encoding="utf-8")
    lines = text.splitlines()
    line = line_number_of(text, "element 'Goal left post left '.start[2]")
    assert line is not None
    assert lines[line - 1].startswith('start = ["-half_length", "goal_width / 2"')
    assert line_number_of(text, "element 'no such element'.start") is None
    assert line_number_of(text, "the file") is None


def test_a_hostile_line_costs_no_time():
    """A quarter of a megabyte of blanks: by its square it would take minutes."""
    started = time.process_time()
    assert line_number_of("[" + " " * 250_000 + "x", "dimensions.length") is None
    assert time.process_time() - started < 5
