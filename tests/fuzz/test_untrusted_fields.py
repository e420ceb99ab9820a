"""Field files made to do harm are refused in one line, before they cost time or memory."""

import json
import time

import pytest

from procc_annotator.errors import FieldError
from procc_annotator.field.load import load_field
from tests.fuzz.readers import SOCCER, in_one_line


@pytest.mark.parametrize(
    "formula",
    [
        "9**9**9",
        "9**3999999",
        "9**3999999//7**2000000",
        "9**3999999*9**3999999*9**3999999",
        "'a'.ljust(10**13)",
        "'a'*99999999",
        "f'{1:>999999999}'",
        "'%0999999999d' % 5",
        "1 << 9999999999",
        "().__class__.__bases__[0].__subclasses__()",
        "pi.hex()",
        "(lambda: 1)()",
        "[0 for _ in 'aaaa']",
        "{1: 2}[1]",
        "hypot(*[1, 2])",
        "sqrt(x=1)",
        "1 if 1 else 2",
        "True",
        "-" * 199 + "x",
        "(" * 99 + "x" + ")" * 99,
        "sqrt(" * 39 + "x" + ")" * 39,
        "1e308*10",
        "1e999 - 1e999",
        "0x1for x in (1,)",
        "1_0__0",
    ],
)
def test_a_formula_takes_no_time_and_runs_nothing(tmp_path, formula):
    path = tmp_path / "f.toml"
    path.write_text(
        SOCCER.replace('radius = "circle_radius"', f"radius = {json.dumps(formula)}", 1)
    )
    started = time.process_time()
    with pytest.raises(FieldError) as caught:
        load_field(path)
    assert "element 'Circle central'.radius: " in in_one_line(caught, str(path))
    assert time.process_time() - started < 5  # seconds to hours before; milliseconds now


@pytest.mark.parametrize(
    "added",
    [
        "x" + ".a" * 100_000 + " = 1",
        "[" + "x." * 50_000 + "x]",
        "x = {" + "a." * 50_000 + "a = 1}",
        "x = " + "[" * 100_000,
        "x = " + "{a=" * 50_000,
        "".join(f"[t{i}{'.a' * 60}]\n" for i in range(1200)),
        "".join(f"[[t{i}]]\n" for i in range(20_000)),
        "[[elements]]\n" * 15_000,
        'x = "' + "a" * 200_000 + '"',
        "x = 1" * 40_000,
    ],
    ids=range(10),
)
def test_a_field_file_takes_no_time_whatever_its_shape(tmp_path, added):
    path = tmp_path / "f.toml"
    path.write_text(SOCCER + "\n" + added)
    started = time.process_time()
    with pytest.raises(FieldError) as caught:
        load_field(path)
    assert time.process_time() - started < 10
    in_one_line(caught, str(path))


@pytest.mark.parametrize("radius", ["1001", "1e15", "1e308", "-1001"])
def test_a_field_larger_than_any_is_refused(tmp_path, radius):
    path = tmp_path / "f.toml"
    for old, new in (
        ('radius = "circle_radius"', f"radius = {radius}"),
        ('centre = ["0", "0", "0"]', f"centre = [{radius}, 0, 0]"),
        ('start = ["0", "-half_width", "0"]', f"start = [0, {radius}, 0]"),
    ):
        path.write_text(SOCCER.replace(old, new, 1))
        with pytest.raises(FieldError) as caught:
            load_field(path)
        in_one_line(caught, str(path))


@pytest.mark.parametrize("tiny", ["1e-320", "1e-9"])
def test_elements_without_extent_are_refused(tmp_path, tiny):
    path = tmp_path / "f.toml"
    for old, new in (
        ('radius = "circle_radius"', f"radius = {tiny}"),
        ('"-half_width", "0"]\nend = ["0", "half_width", "0"]', f"0, 0]\nend = [0, {tiny}, 0]"),
    ):
        assert old in SOCCER
        path.write_text(SOCCER.replace(old, new, 1))
        with pytest.raises(FieldError) as caught:
            load_field(path)
        in_one_line(caught, str(path))


def test_a_range_of_the_rules_wider_than_any_field_is_refused(tmp_path):
    """Whole numbers that long would also lose digits on the way."""
    path = tmp_path / "f.toml"
    path.write_text(SOCCER.replace("maximum = 120.0", "maximum = 2222222222222222222", 1))
    with pytest.raises(FieldError) as caught:
        load_field(path)
    assert "dimensions.length: expected at most 2000 m" in in_one_line(caught, str(path))
