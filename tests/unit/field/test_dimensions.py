"""Rules that relate two dimensions: read strictly, kept to, told in one clear line."""

from __future__ import annotations

from pathlib import Path

import pytest

from procc_annotator.errors import FieldError
from procc_annotator.field.load import load_field, with_dimensions
from procc_annotator.field.validation import validate_field
from tests.unit.field.test_checks import COURT, written

OPEN = COURT.replace(
    'width = { title = "Width", nominal = 10.0, minimum = 10.0, maximum = 10.0 }',
    'width = { title = "Width", nominal = 10.0, minimum = 8.0, maximum = 20.0 }',
)


def court(tmp_path: Path, relations: str, text: str = OPEN) -> Path:
    line = f"relations = {relations}\n"
    return written(tmp_path, text.replace("symmetries", f"{line}symmetries", 1))


@pytest.mark.parametrize("name", ["soccer", "futsal"])
def test_a_pitch_is_longer_than_wide(name) -> None:
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


def test_every_sign_counts(tmp_path) -> None:
    wanted = '["length >= 2 * width", "width <= length / 2", "width < length", "length > width"]'
    field = load_field(court(tmp_path, wanted))
    assert with_dimensions(field, {"length": 22.0}).dimensions[0].value == 22.0
    with pytest.raises(FieldError, match=r"length >= 2 \* width, and 18 >= 20 does not hold"):
        with_dimensions(field, {"length": 18.0})


def test_equal_but_for_rounding_is_equal(tmp_path) -> None:
    field = load_field(court(tmp_path, '["width * 0.1 * 3 <= 3", "length / 100 + 0.1 >= 0.3"]'))
    assert field.relations[1].sides({"length": 20.0})[0] == pytest.approx(0.3)


@pytest.mark.parametrize(
    ("relations", "told"),
    [
        ('"length > width"', "relations: expected a list"),
        ("[3]", r"relations\[0\]: expected text"),
        ('["length"]', r"relations\[0\]: expected two formulas with one of < <= > >= between"),
        ('["length = width"]', "expected two formulas"),
        ('["20 > length > 5"]', "expected two formulas"),
        ('["length > widht"]', "'widht' is not defined; did you mean 'width'?"),
        (
            '["length > width", "length < width"]',
            r"relations\[1\]: the nominal dimensions break it",
        ),
        ('["length / (width - 10) > 1"]', "division by zero"),
        ('["length > __import__"]', "is not defined"),
        ('["length > (1).__class__"]', "expected a number or a formula"),
        ("[" + 33 * '"length > width",' + "]", "expected a list"),
    ],
)
def test_what_is_no_relation_is_told_with_its_line(tmp_path, relations, told) -> None:
    with pytest.raises(FieldError, match=rf"line 5: .*{told}"):
        load_field(court(tmp_path, relations))


def test_relations_in_the_wrong_table_are_told_where_they_belong(tmp_path) -> None:
    path = written(tmp_path, COURT.replace("[paint]", 'relations = ["length > width"]\n[paint]'))
    with pytest.raises(FieldError, match=r"line 10: .*relations stands above the first \[table\]"):
        load_field(path)


def test_a_value_that_no_others_allow_is_a_remark(tmp_path) -> None:
    # A width of 20 m takes a length over 20 m, which the range of the length has.
    assert validate_field(load_field(court(tmp_path, '["length > width"]'))) == ()
    (remark,) = validate_field(load_field(court(tmp_path, '["length > 1.5 * width"]')))
    assert remark.place == "dimensions.width"
    assert "20 m is never allowed: the rules ask for length > 1.5 * width" in remark.text
