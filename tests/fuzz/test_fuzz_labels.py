"""Damaged maps of labels, COCO files with templates, and camera files of further formats."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.label_map import OrderedClasses, read_label_map
from procc_annotator.formats.annotations.registry import read_set
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_source import open_source

Damage = Callable[[str, Sequence[bytes], int], Iterator[bytes]]
FIELD = load_field("soccer")
LABELS = b"""# names
[labels]
"halfway" = "Middle line"   # sure
crowd = false
"goal line" = { left_to_right = ["Side line left", "Side line right"] }
pitch = { template = "soccer_32" }
"""
TEMPLATE = {
    "images": [{"id": 1, "width": 640, "height": 360, "file_name": "a.jpg"}],
    "annotations": [
        {"id": 1, "image_id": 1, "category_id": 1,
         "keypoints": [v for i in range(32) for v in (10 * i, 5 * i, 2 if i % 3 else 0)]}
    ],
    "categories": [
        {"id": 1, "name": "p", "keypoints": [f"k{i}" for i in range(32)],
         "skeleton": [[1, 2], [2, 3], [1, 14]]}
    ],
}  # fmt: skip


@pytest.mark.laps
def test_maps_changed_in_bytes(judge: Any, damage: Damage, tmp_path: Path) -> None:
    path = tmp_path / "labels.toml"

    def read(data: bytes) -> Any:
        path.write_bytes(data)
        return read_label_map(path, FIELD)

    assert len(read(LABELS).rules) == 4
    shapes = [("halfway", ()), ("goal line", ()), ("goal line", ()), ("x", ())]
    for data in damage("labels", [LABELS], 11):
        found = judge("labels", str(path), lambda d=data: read(d))
        if found is None:
            continue
        for rule in found.rules.values():
            for name in rule.classes if isinstance(rule, OrderedClasses) else (rule,):
                assert not isinstance(name, str) or FIELD.knows(name)
        classes, _ = found.classes(shapes)
        assert len(classes) == len(shapes)


@pytest.mark.laps
def test_templates_changed_in_bytes(judge: Any, damage: Damage, tmp_path: Path) -> None:
    def read(data: bytes) -> Any:
        (tmp_path / "k.json").write_bytes(data)
        with open_source(tmp_path) as source:
            return read_set(source, FIELD, fmt="coco")

    seed = json.dumps(TEMPLATE).encode()
    assert len(read(seed).frames["a"].annotation.polylines) > 5
    for data in damage("template", [seed], 12):
        found = judge("annotation", str(tmp_path), lambda d=data: read(d))
        for problem in found.problems if found is not None else ():
            assert "\n" not in problem


TRANSFORMS = {
    "w": 1280, "h": 720, "fl_x": 1000.0, "cx": 640.0, "cy": 360.0,
    "frames": [{"file_path": "1.jpg", "transform_matrix": np.eye(4).tolist()}],
}  # fmt: skip
PROJECTION = {"1": {"P": [[1000, 0, 640, 0], [0, 1000, 360, 0], [0, 0, 1, 60]]}}
DOME = {
    "cameras": [
        {"name": "00_01", "K": np.diag([1000.0, 1000, 1]).tolist(), "R": np.eye(3).tolist(),
         "t": [[0], [0], [50]], "distCoef": [0.0] * 5, "resolution": [1280, 720]}
    ]
}  # fmt: skip


@pytest.mark.laps
@pytest.mark.parametrize("content", [TRANSFORMS, PROJECTION, DOME], ids=["w", "p", "d"])
def test_further_cameras_changed_in_bytes(
    judge: Any, damage: Damage, tmp_path: Path, content: dict[str, Any]
) -> None:
    def read(data: bytes) -> list[Any]:
        (tmp_path / "c.json").write_bytes(data)
        with CameraCollection.open(tmp_path / "c.json") as cameras:
            return [cameras.read(frame) for frame in cameras.frames]

    seed = json.dumps(content).encode()
    assert len(read(seed)) == 1
    for data in damage("further", [seed], 13):
        judge("camera", str(tmp_path), lambda d=data: read(d))
