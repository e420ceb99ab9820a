"""Names of other programs: what a labels.toml says, and what is said of one that is wrong."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from procc_annotator.errors import InputError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.label_map import read_label_map
from procc_annotator.formats.annotations.registry import ReadSet, SetReader
from procc_annotator.formats.file_source import open_source

TENNIS = load_field("tennis")


def shape(label: str, *points: tuple[float, float]) -> dict[str, object]:
    return {"label": label, "points": [list(p) for p in points], "shape_type": "linestrip"}


def read(tmp_path: Path, labels: str, *shapes: dict[str, object]) -> ReadSet:
    """A labelme file of 101x101 px, by a map."""
    folder = tmp_path / "set"
    folder.mkdir()
    content = {"shapes": list(shapes), "imageWidth": 101, "imageHeight": 101}
    (folder / "1.json").write_text(json.dumps(content))
    names = None
    if labels:
        (tmp_path / "labels.toml").write_text(f"[labels]\n{labels}")
        names = read_label_map(tmp_path / "labels.toml", TENNIS)
    with open_source(folder) as source:
        return SetReader(source, TENNIS, names).read_all()


def first_points(found: ReadSet) -> dict[str, tuple[float, float]]:
    polylines = found.frames["1"].annotation.polylines
    return {p.class_name: (p.points[0].u, p.points[0].v) for p in polylines}


def test_labels_become_classes_and_some_are_left_out(tmp_path) -> None:
    found = read(
        tmp_path, 'middle = "Centre service line"\ncrowd = false\n',
        shape("middle ", (0, 10), (0, 20)), shape("crowd", (5, 5), (6, 6)),
        shape("odd", (7, 7), (8, 8)),
    )  # fmt: skip
    assert first_points(found) == {"Centre service line": (0, 0.1), "odd": (0.07, 0.07)}
    assert found.unknown == {"odd": 1}


def test_numbered_copies_have_classes_of_their_own(tmp_path) -> None:
    found = read(
        tmp_path, 'line = "Baseline left"\n"line (2)" = "Baseline right"\n',
        shape("line", (0, 10), (0, 20)), shape("line", (50, 10), (50, 20)),
    )  # fmt: skip
    assert first_points(found) == {"Baseline left": (0, 0.1), "Baseline right": (0.5, 0.1)}


@pytest.mark.parametrize(
    ("order", "left_has"), [("top_down", (0.9, 0.1)), ("left_to_right", (0.1, 0.8))]
)
def test_a_shared_label_is_told_by_places_in_the_picture(tmp_path, order, left_has) -> None:
    low_left = shape("baseline", (10, 80), (20, 80))
    high_right = shape("baseline", (90, 10), (95, 10))
    rule = f'baseline = {{ {order} = ["Baseline left", "Baseline right"] }}\n'
    found = read(tmp_path, rule, low_left, high_right)
    assert first_points(found)["Baseline left"] == left_has
    assert len(first_points(found)) == 2


def test_one_shape_where_two_are_ordered_is_left_out_and_told(tmp_path) -> None:
    rule = 'baseline = { top_down = ["Baseline left", "Baseline right"] }\n'
    found = read(tmp_path, rule, shape("baseline", (1, 1), (2, 2)), shape("odd", (0, 0)))
    assert set(first_points(found)) == {"odd"}
    assert any("'baseline': 1 shape where labels.toml puts 2 in order" in s for s in found.losses)


def test_a_misspelled_label_of_the_map_is_told(tmp_path) -> None:
    found = read(tmp_path, 'basline = "Baseline left"\n', shape("baseline", (1, 1), (2, 2)))
    assert any("'basline'; did you mean 'baseline'?" in line for line in found.losses)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('[labels]\n# one\nnear = "Baseline lefft"', "line 3: label 'near': the field Tennis has"
         " no class 'Baseline lefft'; did you mean 'Baseline left'?"),
        ('[labels]\nx = "Circle central"', "line 2: label 'x': the field Tennis has no class"),
        ("[labels]\nx = 3", "line 2: label 'x': expected a class, false, or"),
        ("[labels]\nx = { sideways = [] }", "line 2: label 'x': expected a class, false, or"),
        ('[labels]\nx = { top_down = ["Baseline left"] }', "top_down: expected two or more"),
        ('[labels]\nx = "Baseline left"\n"x " = false', "the label 'x ' is there twice"),
        ('[labels]\nx = "Baseline left', "is no TOML"),
        ('x = "Baseline left"', "expected one table [labels]"),
        ("[labels]\n[label]", "found 'label' beside it"),
    ],
)  # fmt: skip
def test_a_map_that_is_wrong_says_where(tmp_path, text, said) -> None:
    path = tmp_path / "labels.toml"
    path.write_text(text)
    with pytest.raises(InputError) as wrong:
        read_label_map(path, TENNIS)
    assert str(wrong.value).startswith(str(path))
    assert said in str(wrong.value)
