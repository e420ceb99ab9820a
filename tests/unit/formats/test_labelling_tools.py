"""Annotations of labelling tools: the same two lines and a point as each tool exports them."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.registry import ReadSet, SetReader
from procc_annotator.formats.csv_tables import encode_rows
from procc_annotator.formats.file_source import open_source

W, H = 1280, 720
LINE, MARK = [[100, 200], [640.5, 300]], [300, 400]


def percent(pair: list[float]) -> tuple[float, float]:
    return 100 * pair[0] / W, 100 * pair[1] / H


def studio(task: Any) -> dict[str, Any]:
    (x, y), points = percent(MARK), [percent(p) for p in LINE]
    sides = {"original_width": W, "original_height": H}
    vector = {
        "vertices": [{"x": a, "y": b, "isBezier": False} for a, b in points],
        "vectorlabels": ["Middle line"],
    }
    point = {"x": x, "y": y, "width": 0.3, "keypointlabels": ["Side line top"]}
    if task == "min":
        return {
            "id": 1, "image": "/data/upload/1/0a1b2c3d-7.jpg", "kp": [point | sides],
            "vec": [vector | sides],
        }  # fmt: skip
    brush = {"format": "rle", "rle": [1, 2], "brushlabels": ["Circle central"]}
    result = [
        {"type": "vectorlabels", "value": vector, **sides},
        {"type": "keypointlabels", "value": point, **sides},
        {"type": "brushlabels", "value": brush, **sides},
    ]
    return {
        "id": 1, "data": {"image": "/data/local-files/?d=clip/7.jpg"},
        "annotations": [{"result": [], "was_cancelled": True}, {"result": result}],
    }  # fmt: skip


VIA_LINE = {
    "name": "polyline", "all_points_x": [p[0] for p in LINE], "all_points_y": [p[1] for p in LINE],
}  # fmt: skip
VIA_MARK = {"name": "point", "cx": MARK[0], "cy": MARK[1]}
VIA = {
    "7.jpg123": {"filename": "7.jpg", "size": 123, "regions": [
        {"shape_attributes": VIA_LINE, "region_attributes": {"class": "Middle line"}},
        {"shape_attributes": VIA_MARK, "region_attributes": {"class": {"Side line top": True}}},
    ]},
}  # fmt: skip
VIA_ROWS = [
    ["filename", "file_size", "file_attributes", "region_count", "region_id",
     "region_shape_attributes", "region_attributes"],
    ["7.jpg", 9, "{}", 2, 0, json.dumps(VIA_LINE), '{"class": "Middle line"}'],
    ["7.jpg", 9, "{}", 2, 1, json.dumps(VIA_MARK), '{"class": "Side line top"}'],
]  # fmt: skip


DATUMARO = {
    "categories": {"label": {"labels": [{"name": "Middle line"}, {"name": "Side line top"}]}},
    "items": [{
        "id": "7", "image": {"path": "7.jpg", "size": [H, W]}, "annotations": [
            {"type": "polyline", "label_id": 0, "points": [*LINE[0], *LINE[1]]},
            {"type": "points", "label_id": 1, "points": [*MARK, 0, 0], "visibility": [2, 0]},
            {"type": "bbox", "label_id": 0, "bbox": [1, 2, 3, 4]},
        ],
    }],
}  # fmt: skip
LABELBOX = {
    "data_row": {"external_id": "7.jpg"}, "media_attributes": {"width": W, "height": H},
    "projects": {"p": {"labels": [{"annotations": {"objects": [
        {"name": "Middle line", "line": [{"x": x, "y": y} for x, y in LINE]},
        {"name": "Side line top", "point": {"x": MARK[0], "y": MARK[1]}},
    ]}}]}},
}  # fmt: skip
SHARES = [[x / W, y / H] for x, y in LINE]
FIFTYONE = {"samples": [{
    "filepath": "data/7.jpg", "metadata": {"width": W, "height": H},
    "ground_truth": {"_cls": "Polylines", "polylines": [
        {"label": "Middle line", "points": [SHARES], "closed": False},
    ]},
    "spots": {"_cls": "Keypoints", "keypoints": [
        {"label": "Side line top", "points": [[MARK[0] / W, MARK[1] / H]]},
    ]},
}]}  # fmt: skip
FILES: dict[str, tuple[str, Any]] = {
    "datumaro": ("default.json", DATUMARO),
    "label-studio": ("project.json", [studio("full")]),
    "label-studio, JSON-MIN": ("project.json", [studio("min")]),
    "via": ("via.json", VIA),
    "via project": ("via.json", {"_via_settings": {}, "_via_img_metadata": VIA}),
    "via, CSV": ("via.csv", encode_rows(VIA_ROWS).decode()),
    "labelbox": ("export.ndjson", f"{json.dumps(LABELBOX)}\n"),
    "labelbox lines": ("e.ndjson", f"{json.dumps(LABELBOX)}\n" + json.dumps(
        LABELBOX | {"data_row": {"external_id": "8.jpg"}})),
    "fiftyone": ("samples.json", FIFTYONE),
}  # fmt: skip


def read(file: Path, content: Any, field: str = "soccer") -> tuple[str, ReadSet]:
    file.write_text(content if isinstance(content, str) else json.dumps(content))
    with open_source(file) as source:
        reader = SetReader(source, load_field(field), size_of=lambda _: (W, H))
        return reader.format.name, reader.read_all()


@pytest.mark.parametrize(
    ("image", "frame"),
    [
        ("/data/local-files/?d=set1%2Fimg%2Fframe%207.jpg", "frame 7"),
        ("s3://b/x/frame_7.jpg?X-Amz=1", "frame_7"),
        ("50%25_7.jpg", "50%25_7"),
    ],
)
def test_label_studio_names_pictures_by_address(image, frame, tmp_path):
    _, found = read(tmp_path / "p.json", [task()[-1] | {"data": {"image": image}}])
    assert list(found.frames) == [frame]


@pytest.mark.parametrize("name", FILES)
def test_lines_and_points_of_a_tool(name, tmp_path):
    file_name, content = FILES[name]
    fmt, found = read(tmp_path / file_name, content)
    assert fmt == name.partition(",")[0].split()[0].removesuffix(" project")
    frame = found.frames["7"]
    shown = {
        p.class_name.strip(): [[q.u * (W - 1), q.v * (H - 1)] for q in p.points]
        for p in frame.annotation.polylines
    }
    assert list(shown) == ["Middle line", "Side line top"] or name.endswith("MIN")
    assert np.array(shown["Middle line"]) == pytest.approx(np.array(LINE))
    assert shown["Side line top"] == [pytest.approx(MARK)]
    said = " ".join(found.losses)
    assert name != "label-studio" or "shapes of the type brushlabels are left out" in said
    assert name != "datumaro" or "shapes of the type bbox are left out" in said


def test_keypoints_at_places_are_points_of_elements(tmp_path):
    def px(x: float, y: float) -> list[float]:
        return [200 + 8 * x, 100 + 6 * y]

    places = [(0, 0), (105, 0), (0, 68), (105, 68), (52.5, 0), (52.5, 68), (16.5, 13.84), (60, 30)]
    content = {f"({x}, {y})": px(x, y) for x, y in places}
    _, found = read(tmp_path / "m_keypoints.json", content)
    frame = found.frames["m_keypoints"]
    counts = {p.class_name.strip(): len(p.points) for p in frame.annotation.polylines}
    assert counts["Side line top"] == counts["Side line bottom"] == 3
    assert counts["Big rect. left main"] == counts["Big rect. left top"] == 1
    top = next(p for p in frame.annotation.polylines if p.class_name == "Side line top")
    assert all(q.v * (H - 1) == pytest.approx(100) for q in top.points)
    assert "1 place on no element of the field left out (first: (60, 30))" in " ".join(found.losses)
    away = {f"({x - 52.5}, {34 - y})": px(x, y) for x, y in places}
    _, other = read(tmp_path / "m_keypoints.json", away)
    assert "y away from the camera: turned" in " ".join(other.losses)
    again = other.frames["m_keypoints"].annotation
    assert again.polylines == frame.annotation.polylines


def test_keypoints_of_a_court(tmp_path):
    points: list[Any] = [[10 * i, 5 * i] for i in range(14)]
    points[3] = None
    _, found = read(tmp_path / "data.json", [{"id": "a_1", "kps": points, "metric": 0.1}], "tennis")
    frame = found.frames["a_1"]
    counts = {p.class_name: len(p.points) for p in frame.annotation.polylines}
    assert counts["Baseline left"] == 4
    assert counts["Baseline right"] == 3
    _, found = read(tmp_path / "data.json", [{"id": "a_1", "kps": points[:9]}], "tennis")
    assert "expected 14 keypoints, found 9" in found.problems[0]


def test_coco_without_lines_says_what_to_export(tmp_path):
    content = {
        "images": [{"id": 1, "file_name": "7.jpg", "width": W, "height": H}], "annotations": [],
        "categories": [{"id": 1, "name": "Middle line", "keypoints": []}],
    }  # fmt: skip
    _, found = read(tmp_path / "coco.json", content)
    assert "holds 1 picture, no annotation (CVAT writes no polylines" in found.problems[0]


def line(**more: Any) -> dict[str, Any]:
    vertices = [{"x": x, "y": 20, "isBezier": x == more.get("bezier")} for x in (10, 50)]
    value = {"vertices": vertices, "vectorlabels": ["Middle line"]}
    sides = {"original_width": W, "original_height": H}
    return {"type": "vectorlabels", "value": value} | sides | more


def task(*annotations: Any) -> list[Any]:
    other = {"data": {"image": "8.jpg"}, "annotations": [{"result": [line()]}]}
    return [{"data": {"image": "7.jpg"}, "annotations": list(annotations)}, other]


ROW = json.dumps(LABELBOX | {"data_row": {"external_id": "8.jpg"}})
LABELS = LABELBOX["projects"]["p"]["labels"]
TWO = LABELBOX | {"projects": {"p": {"labels": [
    *LABELS, LABELS[0] | {"label_details": {"created_by": "b@club"}},
]}}}  # fmt: skip
SKIPPED = {"result": [line()], "was_cancelled": True, "completed_by": 3}


@pytest.mark.parametrize(
    ("content", "frames", "said"),
    [
        (task()[-1], "8", ""),
        ([{"data": {"image": "7.jpg"}, "predictions": [{"result": [line()]}]}], "",
         "no annotation (export it when it is annotated; drafts and predictions are not read)"),
        (task(SKIPPED), "8", "annotations that were skipped are left out (by 3) (1 frame: 7)"),
        (task({"result": [line()]}, {"result": [line()], "completed_by": {"email": "b@club"}}),
         "78", "further annotations of a picture are left out (by b@club) (1 frame: 7)"),
        (task({"result": [line(bezier=50)]}), "78", "Bezier curves are taken for straight lines"),
        (task({"result": [line(image_rotation=90)]}), "8", "a picture rotated by 90 degrees"),
        (task(SKIPPED)[:1], "", "holds 1 picture, no annotation but skipped ones"),
        (task()[:1], "", "holds 1 picture, no annotation (export it when it is annotated"),
        (f"{json.dumps(TWO)}\n{ROW}", "78", "a picture are left out (by b@club) (1 frame: 7)"),
        (f"{ROW}\n{ROW[:99]}", "8", "x.ndjson: line 2: line 1 column "),
        (f"{ROW[9:]}\r\n\r\n{ROW}\r\n", "8", "x.ndjson: line 1: line 1 column "),
        (ROW[:99], "", "x.ndjson: line 1 column "),
        (encode_rows(VIA_ROWS).decode()[:-9], "", "x.ndjson: line 3: is no CSV"),
    ],
)  # fmt: skip
def test_nothing_is_dropped_without_a_word(content, frames, said, tmp_path):
    _, found = read(tmp_path / "x.ndjson", content)
    assert "".join(sorted(found.frames)) == frames
    assert said in " ".join((*found.losses, *found.problems))
