"""Loading a field: soccer is complete, and every mistake in a file is named with its place."""

from __future__ import annotations

import contextlib
import json
import math
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.errors import FieldError
from procc_annotator.field.geometry import Arc, Line
from procc_annotator.field.load import field_names, load_field, with_dimensions
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.resources import resources_dir

SOCCER = (resources_dir() / "field" / "soccer.toml").read_text(encoding="utf-8")


def load_changed(tmp_path: Path, old: str, new: str) -> str:
    """The error text after one change to the soccer file."""
    assert old in SOCCER
    path = tmp_path / "mine.toml"
    path.write_text(SOCCER.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(FieldError) as caught:
        load_field(path)
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_soccer_has_the_26_official_classes_in_order() -> None:
    names = [e.name for e in load_field("soccer").elements if not e.optional]
    assert len(names) == 26
    assert names == sorted(names)
    assert names == [e.name for e in load_field("soccer").elements[:26]]
    assert "Goal left post left " in names
    assert load_field().classes_without_geometry == ("Goal unknown", "Line unknown")
    assert "soccer" in field_names()


def test_measures_are_those_of_the_rules() -> None:
    field = load_field("soccer")

    def line(name: str) -> Line:
        geometry = field.elements[field.index[name]].geometry
        assert isinstance(geometry, Line)
        return geometry

    assert line("Goal left post left ").start == (-52.5, 3.66, -2.44)
    assert line("Goal right post left").end == (52.5, -3.66, 0.0)
    assert line("Big rect. left main").start == (-36.0, -20.16, 0.0)
    assert line("Small rect. right top").start == (47.0, -9.16, 0.0)
    assert line("Side line bottom").start[1] == 34.0
    arc = field.elements[field.index["Circle right"]].geometry
    assert isinstance(arc, Arc)
    end = arc.centre[0] + arc.radius * math.cos(arc.end_rad)
    assert end == pytest.approx(36.0)


def test_other_legal_dimensions_move_the_field() -> None:
    field = load_field("soccer", length=100, width=64)
    geometry = field.elements[field.index["Side line right"]].geometry
    assert geometry == Line((50.0, -32.0, 0.0), (50.0, 32.0, 0.0))


def test_dimensions_outside_the_rules_are_refused() -> None:
    with pytest.raises(FieldError, match="130 m is outside the range of the rules, 90 to 120 m"):
        load_field("soccer", length=130)
    with pytest.raises(FieldError, match="did you mean 'length'"):
        load_field("soccer", lenght=100)


def test_an_unknown_field_is_named() -> None:
    with pytest.raises(FieldError, match=r"no such field; did you mean 'soccer'.*known: .*soccer"):
        load_field("socer")
    with pytest.raises(FieldError, match="no such field"):
        load_field("")


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('name = "soccer"\n', 'name = "soccer"\nflavour = 1\n', "flavour: unknown key"),
        ("\ncolour = ", "\ncolor = ", "did you mean 'colour'"),
        ('start = ["-half_length"', 'start = ["-half_lenght"', "did you mean 'half_length'"),
        ('radius = "circle_radius"', 'radius = "circle_radius *"', "bad formula"),
        ('radius = "circle_radius"', 'radius = "circle_radius / 0"', "bad formula"),
        ('radius = "circle_radius"', 'radius = "-circle_radius"', "expected a positive radius"),
        ('radius = "circle_radius"', 'radius = "__import__(1)"', "bad formula"),
        ("symmetries = [180]", "symmetries = 180", "expected a list of turns in degrees"),
        ("symmetries = [180]", "symmetries = [180, 180]", "symmetries[1]: expected another turn"),
        ("symmetries = [180]", "symmetries = [0]", "expected another turn between 0 and 360"),
        (
            "symmetries = [180]",
            "symmetries = [180, 90]",
            "symmetries[1]: a turn by 90 degrees does not take the field to itself",
        ),
        ('name = "Circle left"', 'name = "Circle right"', "'Circle right' is used twice"),
        ('shortcut = "3"', 'shortcut = "2"', "'2' is used twice, by '"),
        (
            'line_width = "line_width"',
            'line_width = "width"',
            "line 35: paint.line_width: expected",
        ),
        ('measured = "outer"', 'measured = "inner"', "line 36: paint.measured: expected one of"),
        ("[formulas]", '[formulas]\nearly = "half_length"', "defined further down: move it above"),
        ("[formulas]", '[formulas]\nown = "own + 1"', "a formula cannot name itself"),
        ('"length / 2"', '"lenght / 2"', "'lenght / 2': 'lenght' is not defined; did you mean"),
        ('"length / 2"', '"root(2)"', "there is no function 'root'"),
        ("[[elements]]", "[elements]", "elements begin with [[elements]], two brackets"),
        ('kind = "circle"', 'kind = "ellipse"', "expected one of line, arc, circle"),
        ('title = "Centre circle"\n', "", "the key 'title' is missing"),
        ('colour = "#FFFFFF"', 'colour = "white"', "expected #rrggbb"),
        ("nominal = 105.0", "nominal = 205.0", "dimensions.length: expected 0 < minimum"),
        ("nominal = 105.0", "nominal = nan", "expected a finite number"),
        ("nominal = 105.0", "nominal = true", "expected a number or a formula"),
        ("nominal = 105.0", "nominal = 1" + "0" * 400, "expected a finite number"),
        ("nominal = 105.0", "nominal = 1" + "0" * 5000, "is not valid TOML"),
        ("[dimensions]", "[dimensions", "is not valid TOML"),
        ("[dimensions]", "x = " + "[" * 5000 + "\n[dimensions]", "is not valid TOML"),
        ('kind = "circle"', 'kind = ["circle"]', "expected one of line, arc, circle"),
        ('name = "Circle left"', 'name = " "', "element ' '.name: expected text"),
        ('shortcut = "3"', 'shortcut = "k"', "'K' is used twice"),
        (
            '"Line unknown"]',
            '"Line unknown ", "Line unknown"]',
            "[2]: 'Line unknown' is used twice",
        ),
        ('"Line unknown"]', '"Middle line "]', "[1]: 'Middle line ' is used twice"),
        ('half_length = "length / 2"', 'length = "1"', "'length' is taken already"),
        ("[formulas]", '[formulas]\n"two words" = "1"', "expected a plain word"),
        (
            'end = "acos((penalty_area_depth - penalty_mark) / circle_radius)"',
            'end = "acos((penalty_area_depth - penalty_mark) / circle_radius) + radians(1)"',
            "symmetries[0]: a turn by 180 degrees does not take the field to itself: the element"
            " 'Circle left' has no partner",
        ),
    ],
)
def test_a_mistake_is_named_with_its_place(tmp_path, old, new, expected) -> None:
    assert expected in load_changed(tmp_path, old, new)


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        ("sqr(4)", "did you mean 'sqrt'"),
        ("9.15; 3", "invalid syntax"),
        ("r = 9.15", "invalid syntax"),
        ("", "invalid syntax"),
        ("'abc'[5]", "expected a number or a formula"),
        ("10**400", "expected a finite number"),
        ("(-1)**0.5", "expected a number or a formula"),
        ("1 == 1", "expected a number or a formula"),
        ("-" * 20000 + "1", "longer than 200 characters"),
    ],
)
def test_a_formula_gives_one_number_or_a_clear_error(tmp_path, formula, expected) -> None:
    error = load_changed(tmp_path, 'radius = "circle_radius"', f'radius = "{formula}"')
    assert "element 'Circle central'.radius: " in error
    assert expected in error


@settings(deadline=None)
@given(st.text(st.sampled_from("19+-*/().,;=<[]{}eE: \n\x00lengthpi_"), max_size=40))
def test_no_formula_brings_the_program_down(tmp_path_factory, formula) -> None:
    path = tmp_path_factory.getbasetemp() / "formula.toml"
    quoted = json.dumps(formula)  # a JSON text is a TOML basic string as well
    path.write_text(
        SOCCER.replace('half_length = "length / 2"', f"half_length = {quoted}"), encoding="utf-8"
    )
    with contextlib.suppress(FieldError):
        assert load_field(path).elements


def test_a_missing_file_and_a_binary_file(tmp_path) -> None:
    with pytest.raises(FieldError, match="no such file"):
        load_field(tmp_path / "absent.toml")
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(FieldError, match="UTF-8"):
        load_field(tmp_path / "binary.toml")


def test_names_of_third_parties_get_the_official_spelling() -> None:
    field = load_field()
    assert field.canonical_name("Goal left post left") == "Goal left post left "
    assert field.canonical_name(" Line unknown") == "Line unknown"
    assert field.canonical_name("Corner flag ") == "Corner flag "
    assert field.knows("Goal unknown")
    assert not field.knows("Corner flag ")


def test_a_file_with_the_name_of_a_shipped_field_is_told_apart(tmp_path) -> None:
    mine = tmp_path / "field.toml"
    mine.write_text(SOCCER, encoding="utf-8")
    assert load_field(mine).described == "soccer"  # it is the same field
    mine.write_text(
        SOCCER.replace('half_width = "width / 2"', 'half_width = "width / 2 + 0.1"'),
        encoding="utf-8",
    )
    changed = load_field(mine)
    assert changed != load_field("soccer")
    assert changed.described == "soccer (field.toml)"
    assert with_dimensions(changed, {"length": 100.0}).described == "soccer (field.toml) 100 x 68 m"
    assert EvaluationSetup(changed).describe() == "soccernet, 960x540, soccer (field.toml)"


@pytest.mark.parametrize(
    "name", ["my padel", "padel/2", "padel:length", "../padel", "a=b", "p\\u0009"]
)
def test_names_are_plain(tmp_path, name) -> None:
    mine = tmp_path / "mine.toml"
    mine.write_text(SOCCER.replace('name = "soccer"', f'name = "{name}"'), encoding="utf-8")
    with pytest.raises(FieldError, match="name: expected"):
        load_field(mine)


def test_a_single_table_of_elements_is_told(tmp_path) -> None:
    mine = tmp_path / "mine.toml"
    mine.write_text('name = "a"\ntitle = "A"\n\n[elements]\nname = "b"\n', encoding="utf-8")
    with pytest.raises(FieldError, match=r"line 4: elements: expected \[\[elements\]\]"):
        load_field(mine)


def test_the_mark_some_editors_put_in_front_of_a_file_is_no_mistake(tmp_path) -> None:
    mine = tmp_path / "mine.toml"
    mine.write_text(SOCCER, encoding="utf-8-sig")
    assert load_field(mine) == load_field("soccer")
