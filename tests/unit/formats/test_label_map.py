"""Names of other programs: what a labels.toml says, and what is said of one that is wrong."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import InputError
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import known_templates, read_label_map
from procc_annotator.formats.annotations.registry import ReadSet, SetReader
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.setup import EvaluationSetup

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


def test_labels_become_classes_and_some_are_left_out(tmp_path):
    found = read(
        tmp_path, 'middle = "Centre service line"\ncrowd = false\n',
        shape("middle ", (0, 10), (0, 20)), shape("crowd", (5, 5), (6, 6)),
        shape("odd", (7, 7), (8, 8)),
    )  # fmt: skip
    assert first_points(found) == {"Centre service line": (0, 0.1), "odd": (0.07, 0.07)}
    assert found.unknown == {"odd": 1}


def test_numbered_copies_have_classes_of_their_own(tmp_path):
    found = read(
        tmp_path, 'line = "Baseline left"\n"line (2)" = "Baseline right"\n',
        shape("line", (0, 10), (0, 20)), shape("line", (50, 10), (50, 20)),
    )  # fmt: skip
    assert first_points(found) == {"Baseline left": (0, 0.1), "Baseline right": (0.5, 0.1)}


@pytest.mark.parametrize(
    ("order", "left_has"), [("top_down", (0.9, 0.1)), ("left_to_right", (0.1, 0.8))]
)
def test_a_shared_label_is_told_by_places_in_the_picture(tmp_path, order, left_has):
    low_left = shape("baseline", (10, 80), (20, 80))
    high_right = shape("baseline", (90, 10), (95, 10))
    rule = f'baseline = {{ {order} = ["Baseline left", "Baseline right"] }}\n'
    found = read(tmp_path, rule, low_left, high_right)
    assert first_points(found)["Baseline left"] == left_has
    assert len(first_points(found)) == 2


def test_one_shape_where_two_are_ordered_is_left_out_and_told(tmp_path):
    rule = 'baseline = { top_down = ["Baseline left", "Baseline right"] }\n'
    found = read(tmp_path, rule, shape("baseline", (1, 1), (2, 2)), shape("odd", (0, 0)))
    assert set(first_points(found)) == {"odd"}
    assert any("'baseline': 1 shape where labels.toml puts 2 in order" in s for s in found.losses)


def test_a_misspelled_label_of_the_map_is_told(tmp_path):
    found = read(tmp_path, 'basline = "Baseline left"\n', shape("baseline", (1, 1), (2, 2)))
    assert any("'basline'; did you mean 'baseline'?" in line for line in found.losses)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('[labels]\n# one\nnear = "Baseline lefft"', "line 3: label 'near': the field Tennis has"
         " no class 'Baseline lefft'; did you mean 'Baseline left'?"),
        ("[labels]\nx = { sideways = [] }", "line 2: label 'x': expected a class, false, or"),
        ('[labels]\nx = { top_down = ["Baseline left"] }', "top_down: expected two or more"),
        ('[labels]\nx = "Baseline left"\n"x " = false', "the label 'x ' is there twice"),
        ('[labels]\nx = "Baseline left', "is no TOML"),
        ('x = "Baseline left"', "expected one table [labels]"),
    ],
)  # fmt: skip
def test_a_map_that_is_wrong_says_where(tmp_path, text, said):
    path = tmp_path / "labels.toml"
    path.write_text(text)
    with pytest.raises(InputError) as wrong:
        read_label_map(path, TENNIS)
    assert str(wrong.value).startswith(str(path))
    assert said in str(wrong.value)


# COCO categories that hold places of a field: points of the elements they lie on.

SIZE = (1280, 720)
NAMES = [f"{i:02d}" for i in (*range(1, 14), 15, 16, 17, 18, *range(20, 33), 14, 19)]
SKELETON = [[1, 2], [2, 3], [1, 14], [14, 25], [15, 16], [2, 10], [10, 11], [17, 30]]


def pitch() -> np.ndarray:
    """(32, 3) metres, the places of `soccer_32` by the rules' measures."""
    line = [(-52.5, y) for y in (-34, -20.16, -9.16, 9.16, 20.16, 34)]
    goal_area = [(-47, -9.16), (-47, 9.16)]
    front = [(-36, -20.16), (-36, -9.16), (-36, 9.16), (-36, 20.16)]
    half = [(0, -34), (0, -9.15), (0, 9.15), (0, 34)]

    def other(places: list[tuple[float, float]]) -> list[tuple[float, float]]:
        return [(-x, y) for x, y in places]

    places = [
        *line, *goal_area, (-41.5, 0), *front, *half, *other(front), (41.5, 0),
        *other(goal_area), *other(line), (-9.15, 0), (9.15, 0),
    ]  # fmt: skip
    return np.array([(x, y, 0.0) for x, y in places])


def court() -> np.ndarray:
    """(14, 3) metres, the places of `tennis_14`."""
    x, y, singles, service = 23.77 / 2, 10.97 / 2, 8.23 / 2, 6.4
    places = [
        (-x, y), (-x, -y), (x, y), (x, -y), (-x, singles), (x, singles), (-x, -singles),
        (x, -singles), (-service, singles), (-service, -singles), (service, singles),
        (service, -singles), (-service, 0), (service, 0),
    ]  # fmt: skip
    return np.array([(a, b, 0.0) for a, b in places])


HIGH = PinholeCamera(0.0, np.radians(60), 0.0, (0.0, 60.0, -35.0), (640.0, 640.0), (639.5, 359.5))
BEHIND = PinholeCamera(
    np.radians(-90), np.radians(65), 0.0, (30.0, 0.0, -12.0), (900.0, 900.0), (639.5, 359.5)
)


def written(tmp_path: Path, category: dict[str, Any], px: np.ndarray, hidden: set[int]) -> Path:
    keypoints: list[float] = []
    for i, (x, y) in enumerate(px.tolist()):
        keypoints += [0, 0, 0] if i in hidden else [x, y, 2]
    content = {
        "images": [{"id": 1, "width": SIZE[0], "height": SIZE[1], "file_name": "a.jpg"}],
        "annotations": [{"id": 1, "image_id": 1, "category_id": 1, "keypoints": keypoints}],
        "categories": [{"id": 1, "name": "pitch", **category}],
    }
    folder = tmp_path / "set"
    folder.mkdir(exist_ok=True)
    (folder / "keypoints.json").write_text(json.dumps(content))
    return folder


def read_set(folder: Path, field: Field, labels: str = "") -> ReadSet:
    names = None
    if labels:
        (folder.parent / "labels.toml").write_text(f"[labels]\n{labels}\n")
        names = read_label_map(folder.parent / "labels.toml", field)
    with open_source(folder) as source:
        return SetReader(source, field, names).read_all()


@pytest.mark.parametrize(
    ("category", "labels"),
    [
        ({"keypoints": NAMES}, ""),
        ({"keypoints": [f"p{i}" for i in range(32)], "skeleton": SKELETON}, ""),
        ({"keypoints": [str(i) for i in range(32)]}, 'pitch = { template = "soccer_32" }'),
    ],
)
def test_places_of_a_pitch_are_points_of_its_elements(tmp_path, category, labels):
    field = load_field("soccer")
    px, _ = HIGH.project(pitch())
    found = read_set(written(tmp_path, category, px, {8, 30}), field, labels)
    annotation = found.frames["a"].annotation
    assert len(annotation.polylines) == 19  # but for the penalty mark that is hidden
    circle = annotation.get("Circle central")
    assert len(circle.points) == 3
    measured = measure(annotation, HIGH, EvaluationSetup(field, SIZE, "procc")).plain
    assert measured.max_error is not None
    assert measured.max_error < 0.5


def test_places_of_a_court(tmp_path):
    field = load_field("tennis")
    px, _ = BEHIND.project(court())
    skeleton = [[1, 2], [3, 4], [1, 3], [9, 13], [13, 14]]
    names = [f"kp{i}" for i in range(14)]
    category = {"keypoints": names, "skeleton": skeleton}
    found = read_set(written(tmp_path, category, px, {0}), field)
    annotation = found.frames["a"].annotation
    measured = measure(annotation, BEHIND, EvaluationSetup(field, SIZE, "procc")).plain
    assert measured.max_error is not None
    assert measured.max_error < 0.5
    assert {p.class_name for p in annotation.polylines} >= {"Centre service line", "Baseline left"}


@pytest.mark.parametrize(
    "category",
    [
        {"keypoints": ["nose", "eye", *(f"k{i}" for i in range(30))]},
        {"keypoints": ["a"] * 32, "skeleton": [[1, 30], [2, 31]]},
        {"keypoints": [str(i) for i in range(1, 33)]},
    ],
)
def test_places_that_nobody_knows_are_no_polyline(tmp_path, category):
    px, _ = HIGH.project(pitch())
    found = read_set(written(tmp_path, category, px, {3}), load_field("soccer"))
    assert not found.frames
    assert any("soccer_32" in line and "left out" in line for line in found.losses)


def test_a_polyline_stays_one(tmp_path):
    px, _ = HIGH.project(pitch())
    numbered = [str(i) for i in range(1, 33)]
    chain = [[i, i + 1] for i in range(1, 32)]
    folder = written(tmp_path, {"keypoints": numbered, "skeleton": chain}, px, set(range(9, 32)))
    found = read_set(folder, load_field("soccer"))
    assert [len(p.points) for p in found.frames["a"].annotation.polylines] == [9]


def test_a_template_of_another_sport_is_one_problem(tmp_path):
    px, _ = HIGH.project(pitch())
    found = read_set(written(tmp_path, {"keypoints": NAMES}, px, set()), load_field("tennis"))
    assert len(found.problems) == 1
    assert "categories[0].keypoints" in found.problems[0]
    assert "--field soccer" in found.problems[0]


def test_a_map_names_a_template_that_is_there(tmp_path):
    with pytest.raises(InputError, match=r"did you mean 'soccer_32'\?"):
        read_set(tmp_path, load_field("soccer"), 'pitch = { template = "soccer32" }')


def test_templates_are_of_the_fields_they_name():
    assert len(known_templates()) >= 2
    for template in known_templates():
        assert template.is_of(load_field(template.field))
        assert all(0 <= i < template.count for some in template.elements.values() for i in some)
