"""Loading a field: soccer is complete, and every mistake in a file is named with its place."""

import contextlib
import gc
import json
import math
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.assist.label_proposal import matching_classes
from procc_annotator.errors import FieldError
from procc_annotator.field.geometry import Arc, Line
from procc_annotator.field.load import builtin_field_file, field_names, load_field, with_dimensions
from procc_annotator.field.model import ANY, BAR, EDGE, LINE, NOTHING, Appearance
from procc_annotator.field.validation import validate_field
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.resources import resources_dir
from tests.unit.field.test_checks import COURT, written

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


def test_soccer_has_the_26_official_classes_in_order():
    names = [e.name for e in load_field("soccer").elements if not e.optional]
    assert len(names) == 26
    assert names == sorted(names)
    assert names == [e.name for e in load_field("soccer").elements[:26]]
    assert "Goal left post left " in names
    assert load_field().classes_without_geometry == ("Goal unknown", "Line unknown")
    assert "soccer" in field_names()


def test_measures_are_those_of_the_rules():
    field = load_field("soccer")

    def line(name: str) -> Line:
        return field.elements[field.index[name]].geometry

    assert line("Goal left post left ").start == (-52.5, 3.66, -2.44)
    assert line("Goal right post left").end == (52.5, -3.66, 0.0)
    assert line("Big rect. left main").start == (-36.0, -20.16, 0.0)
    assert line("Small rect. right top").start == (47.0, -9.16, 0.0)
    assert line("Side line bottom").start[1] == 34.0
    arc = field.elements[field.index["Circle right"]].geometry
    assert isinstance(arc, Arc)
    end = arc.centre[0] + arc.radius * math.cos(arc.end_rad)
    assert end == pytest.approx(36.0)


def test_other_legal_dimensions_move_the_field():
    field = load_field("soccer", length=100, width=64)
    geometry = field.elements[field.index["Side line right"]].geometry
    assert geometry == Line((50.0, -32.0, 0.0), (50.0, 32.0, 0.0))


def test_dimensions_outside_the_rules_are_refused():
    with pytest.raises(FieldError, match="130 m is outside the range of the rules, 90 to 120 m"):
        load_field("soccer", length=130)
    with pytest.raises(FieldError, match="did you mean 'length'"):
        load_field("soccer", lenght=100)


def test_an_unknown_field_is_named():
    with pytest.raises(FieldError, match=r"no such field; did you mean 'soccer'.*known: .*soccer"):
        load_field("socer")
    with pytest.raises(FieldError, match="no such field"):
        load_field("")


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('name = "soccer"\n', 'name = "soccer"\nflavour = 1\n', "flavour: unknown key"),
        ('start = ["-half_length"', 'start = ["-half_lenght"', "did you mean 'half_length'"),
        ('radius = "circle_radius"', 'radius = "circle_radius *"', "bad formula"),
        ('radius = "circle_radius"', 'radius = "circle_radius / 0"', "bad formula"),
        ('radius = "circle_radius"', 'radius = "-circle_radius"', "expected a positive radius"),
        ('radius = "circle_radius"', 'radius = "__import__(1)"', "bad formula"),
        ("symmetries = [180]", "symmetries = 180", "expected a list of turns in degrees"),
        ("symmetries = [180]", "symmetries = [180, 180]", "symmetries[1]: expected another turn"),
        ('name = "Circle left"', 'name = "Circle right"', "'Circle right' is used twice"),
        (
            'line_width = "line_width"',
            'line_width = "width"',
            "line 35: paint.line_width: expected",
        ),
        ('measured = "outer"', 'measured = "inner"', "line 36: paint.measured: expected one of"),
        ("[formulas]", '[formulas]\nearly = "half_length"', "defined further down: move it above"),
        ("[formulas]", '[formulas]\nown = "own + 1"', "a formula cannot name itself"),
        ("[[elements]]", "[elements]", "elements begin with [[elements]], two brackets"),
        ('title = "Centre circle"\n', "", "the key 'title' is missing"),
        ('colour = "#FFFFFF"', 'colour = "white"', "expected #rrggbb"),
        ("nominal = 105.0", "nominal = 205.0", "dimensions.length: expected 0 < minimum"),
        ("nominal = 105.0", "nominal = nan", "expected a finite number"),
        ("nominal = 105.0", "nominal = true", "expected a number or a formula"),
        ("nominal = 105.0", "nominal = 1" + "0" * 400, "expected a finite number"),
        ('kind = "circle"', 'kind = ["circle"]', "expected one of line, arc, circle"),
        ('name = "Circle left"', 'name = " "', "element ' '.name: expected text"),
        (
            '"Line unknown"]',
            '"Line unknown ", "Line unknown"]',
            "[2]: 'Line unknown' is used twice",
        ),
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
def test_a_mistake_is_named_with_its_place(tmp_path, old, new, expected):
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
def test_a_formula_gives_one_number_or_a_clear_error(tmp_path, formula, expected):
    error = load_changed(tmp_path, 'radius = "circle_radius"', f'radius = "{formula}"')
    assert "element 'Circle central'.radius: " in error
    assert expected in error


@settings(deadline=None)
@given(st.text(st.sampled_from("19+-*/().,;=<[]{}eE: \n\x00lengthpi_"), max_size=40))
def test_no_formula_brings_the_program_down(tmp_path_factory, formula):
    path = tmp_path_factory.getbasetemp() / "formula.toml"
    quoted = json.dumps(formula)  # a JSON text is a TOML basic string as well
    path.write_text(
        SOCCER.replace('half_length = "length / 2"', f"half_length = {quoted}"), encoding="utf-8"
    )
    with contextlib.suppress(FieldError):
        assert load_field(path).elements


def test_a_field_like_a_shipped_one_says_what_differs(tmp_path):
    path, soccer = tmp_path / "field.toml", load_field("soccer")
    text = """name = "small"
title = "Small"
like = "soccer"
symmetries = []
[dimensions]
length = { title = "Length", nominal = 90.0, minimum = 80.0, maximum = 95.0 }
[[elements]]
name = "Middle line"
title = "Centre"
[[elements]]
name = "Own"
title = "Own line"
group = "Own"
colour = "#112233"
shortcut = ""
kind = "line"
start = ["0", "0", "0"]
end = ["length / 4", "0", "0"]
measured = "centre"
"""
    path.write_text(text)
    field = load_field(path)
    assert [e.name for e in field.elements] == [*(e.name for e in soccer.elements), "Own"]
    assert field.element("Middle line").title == "Centre"
    assert field.element("Middle line").colour == soccer.element("Middle line").colour
    assert (field.dimension("length").value, field.dimension("width").value) == (90.0, 68.0)
    for old, new, expected in (
        ('"soccer"', '"socer"', "line 3: like: no such field; did you mean 'soccer'"),
        ('title = "Centre"', "titel = 1", "line 9: element 'Middle line'.titel: unknown key"),
        ("[[elements]]", "[elements]", "elements begin with [[elements]], two brackets"),
    ):
        path.write_text(text.replace(old, new))
        with pytest.raises(FieldError) as caught:
            load_field(path)
        assert expected in str(caught.value)


def test_a_missing_file_and_a_binary_file(tmp_path):
    with pytest.raises(FieldError, match="no such file"):
        load_field(tmp_path / "absent.toml")
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(FieldError, match="UTF-8"):
        load_field(tmp_path / "binary.toml")


def test_names_of_third_parties_get_the_official_spelling():
    field = load_field()
    assert field.canonical_name("Goal left post left") == "Goal left post left "
    assert field.canonical_name(" Line unknown") == "Line unknown"
    assert field.canonical_name("Corner flag ") == "Corner flag "
    assert field.knows("Goal unknown")
    assert not field.knows("Corner flag ")


def test_a_file_with_the_name_of_a_shipped_field_is_told_apart(tmp_path):
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
def test_names_are_plain(tmp_path, name):
    mine = tmp_path / "mine.toml"
    mine.write_text(SOCCER.replace('name = "soccer"', f'name = "{name}"'), encoding="utf-8")
    with pytest.raises(FieldError, match="name: expected"):
        load_field(mine)


def test_a_single_table_of_elements_is_told(tmp_path):
    mine = tmp_path / "mine.toml"
    mine.write_text('name = "a"\ntitle = "A"\n\n[elements]\nname = "b"\n', encoding="utf-8")
    with pytest.raises(FieldError, match=r"line 4: elements: expected \[\[elements\]\]"):
        load_field(mine)


def test_the_mark_some_editors_put_in_front_of_a_file_is_no_mistake(tmp_path):
    mine = tmp_path / "mine.toml"
    mine.write_text(SOCCER, encoding="utf-8-sig")
    assert load_field(mine) == load_field("soccer")


# Fields are read in several threads at once: in the window while a dataset is opened.


@pytest.fixture
def threads_in_a_hurry() -> Iterator[None]:
    """Threads take turns, and garbage is collected, as often as can be."""
    interval, thresholds = sys.getswitchinterval(), gc.get_threshold()
    sys.setswitchinterval(1e-7)
    gc.set_threshold(20)
    yield
    sys.setswitchinterval(interval)
    gc.set_threshold(*thresholds)


@pytest.mark.usefixtures("threads_in_a_hurry")
def test_fields_are_the_same_whoever_else_reads_one():
    names = field_names()[:4]
    alone = [load_field(name) for name in names]
    with ThreadPoolExecutor(6) as pool:
        several = [pool.submit(load_field, name) for _ in range(4) for name in names]
        assert [one.result() for one in several] == alone * 4


# Labels of others, and the classes that they are called like.


@pytest.mark.parametrize(
    ("field", "label", "classes"),
    [
        ("tennis", "service-centerline", ["Centre service line"]),
        ("tennis", "Grundlinie links", ["Baseline left"]),
        ("tennis", "sideline-doubles", ["Doubles sideline far", "Doubles sideline near"]),
        ("tennis", "baselines 2", ["Baseline left", "Baseline right"]),
        ("soccer", "penalty_area_left_top", ["Big rect. left top"]),
        ("soccer", "halfwayLine", ["Middle line"]),
        ("soccer", "center circle", ["Circle central"]),
        ("soccer", "circle_centrl", ["Circle central"]),
        ("soccer", "leftGoalCrossbar", ["Goal left crossbar"]),
        ("soccer", "Side line top ", ["Side line top"]),
        ("soccer", "Ligne médiane", ["Middle line"]),
        ("soccer", "player", []),
        ("soccer", "line 2", []),
        ("soccer", "点", []),
    ],
)
def test_labels_and_their_classes(field, label, classes):
    assert list(matching_classes(label, load_field(field)).classes) == classes


def test_the_other_side_is_never_alike():
    field = load_field("soccer")
    for side, other in (("left", "right"), ("top", "bottom")):
        for element in field.elements:
            found = matching_classes(f"{element.name} {side}", field).classes
            assert not any(other in name and side not in name for name in found)


# Field files say how paint looks; a mistake is told with its place; no figure depends on it.

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
def test_shipped_fields_say_how_paint_looks(sport, name, expected):
    assert looks(sport, name) == expected


@pytest.mark.parametrize("sport", field_names())
def test_every_painted_line_of_a_shipped_field_has_a_width_and_a_tone(sport):
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
def test_a_mistake_is_told_with_its_place(tmp_path, old, new, expected):
    text = builtin_field_file("soccer").read_text(encoding="utf-8")
    if new.startswith("[bars]\npaint_colour"):
        text = text.replace('paint_colour = "white"\n\n# Where', "\n# Where")
    path = tmp_path / "field.toml"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(FieldError) as caught:
        load_field(path)
    assert expected in str(caught.value)
    assert "line " in str(caught.value)


def test_what_paint_looks_like_is_no_part_of_what_a_field_is(tmp_path):
    """A copy of a shipped field made before it said so is that field still."""
    text = builtin_field_file("soccer").read_text(encoding="utf-8")
    path = tmp_path / "field.toml"
    path.write_text(text.replace('tone = "lighter"\n', ""), encoding="utf-8")
    field = load_field(path)
    assert field.full_name == "soccer"
    assert field == load_field("soccer")
    assert field.elements[0].appearance.tone == ANY


# Rules that relate two dimensions: read strictly, kept to, told in one clear line.

OPEN = COURT.replace(
    'width = { title = "Width", nominal = 10.0, minimum = 10.0, maximum = 10.0 }',
    'width = { title = "Width", nominal = 10.0, minimum = 8.0, maximum = 20.0 }',
)


def court(tmp_path: Path, relations: str, text: str = OPEN) -> Path:
    line = f"relations = {relations}\n"
    return written(tmp_path, text.replace("symmetries", f"{line}symmetries", 1))


@pytest.mark.parametrize("name", ["soccer", "futsal"])
def test_a_pitch_is_longer_than_wide(name):
    field = load_field(name)
    length, width = field.dimension("length"), field.dimension("width")
    assert length is not None
    side = width.maximum
    with pytest.raises(FieldError, match=rf"length > width, and {side:g} > {side:g} does not hold"):
        with_dimensions(field, {"length": side, "width": side})
    assert (
        with_dimensions(field, {"length": side, "width": side - 0.01}).dimensions[1].value
        == side - 0.01
    )


def test_every_sign_counts(tmp_path):
    wanted = '["length >= 2 * width", "width <= length / 2", "width < length", "length > width"]'
    field = load_field(court(tmp_path, wanted))
    assert with_dimensions(field, {"length": 22.0}).dimensions[0].value == 22.0
    with pytest.raises(FieldError, match=r"length >= 2 \* width, and 18 >= 20 does not hold"):
        with_dimensions(field, {"length": 18.0})


def test_equal_but_for_rounding_is_equal(tmp_path):
    field = load_field(court(tmp_path, '["width * 0.1 * 3 <= 3", "length / 100 + 0.1 >= 0.3"]'))
    assert field.relations[1].sides({"length": 20.0})[0] == pytest.approx(0.3)


@pytest.mark.parametrize(
    ("relations", "told"),
    [
        ('"length > width"', "relations: expected a list"),
        ("[3]", r"relations\[0\]: expected text"),
        ('["length"]', r"relations\[0\]: expected two formulas with one of < <= > >= between"),
        ('["length > widht"]', "'widht' is not defined; did you mean 'width'?"),
        (
            '["length > width", "length < width"]',
            r"relations\[1\]: the nominal dimensions break it",
        ),
        ('["length / (width - 10) > 1"]', "division by zero"),
        ('["length > (1).__class__"]', "expected a number or a formula"),
    ],
)
def test_what_is_no_relation_is_told_with_its_line(tmp_path, relations, told):
    with pytest.raises(FieldError, match=rf"line 5: .*{told}"):
        load_field(court(tmp_path, relations))


def test_relations_in_the_wrong_table_are_told_where_they_belong(tmp_path):
    path = written(tmp_path, COURT.replace("[paint]", 'relations = ["length > width"]\n[paint]'))
    with pytest.raises(FieldError, match=r"line 10: .*relations stands above the first \[table\]"):
        load_field(path)


def test_a_value_that_no_others_allow_is_a_remark(tmp_path):
    # A width of 20 m takes a length over 20 m, which the range of the length has.
    assert validate_field(load_field(court(tmp_path, '["length > width"]'))) == ()
    (remark,) = validate_field(load_field(court(tmp_path, '["length > 1.5 * width"]')))
    assert remark.place == "dimensions.width"
    assert "20 m is never allowed: the rules ask for length > 1.5 * width" in remark.text
