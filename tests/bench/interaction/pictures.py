"""Pictures of 1920x1080 with twelve elements each, annotated for this program and for labelme."""

import json
import os
import shutil
from pathlib import Path

import cv2

SIZE = (1920, 1080)
ORIGINALS = ("00002", "00007", "00008")  # of the sample; twelve elements each
_QUALITY = 93  # gives some 380 kB


def make_datasets(sample: Path, folder: Path, frames: int) -> tuple[Path, Path, Path]:
    """Datasets of links to a few pictures: for this program, for labelme; and cameras for all."""
    ours, theirs, cameras = (folder / name for name in ("ours", "labelme", "cameras"))
    for made in (ours, theirs, cameras):
        made.mkdir()
    labels = []
    for name in ORIGINALS:
        pixels = cv2.imread(str(sample / f"{name}.jpg"))
        enlarged = cv2.resize(pixels, SIZE, interpolation=cv2.INTER_CUBIC)
        cv2.imwrite(str(folder / f"{name}.jpg"), enlarged, [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])
        labels.append(json.loads((sample / f"{name}.json").read_text()))
    for i in range(frames):
        original, name = ORIGINALS[i % len(ORIGINALS)], f"{i + 1:05d}"
        for made in (ours, theirs):
            os.link(folder / f"{original}.jpg", made / f"{name}.jpg")
        shutil.copy(sample / f"{original}.json", ours / f"{name}.json")
        (theirs / f"{name}.json").write_text(_labelme(name, labels[i % len(ORIGINALS)]))
        camera = sample / "cameras" / "bad" / f"camera_{original}.json"
        (cameras / f"camera_{name}.json").symlink_to(camera.resolve())
    return ours, theirs, cameras


def _labelme(name: str, elements: dict[str, list[dict[str, float]]]) -> str:
    shapes = [
        {
            "label": label,
            "points": [[p["x"] * (SIZE[0] - 1), p["y"] * (SIZE[1] - 1)] for p in points],
            "group_id": None,
            "description": "",
            "shape_type": "linestrip" if len(points) > 1 else "point",
            "flags": {},
        }
        for label, points in elements.items()
    ]
    return json.dumps(
        {
            "version": "6.3.1",
            "flags": {},
            "shapes": shapes,
            "imagePath": f"{name}.jpg",
            "imageData": None,
            "imageHeight": SIZE[1],
            "imageWidth": SIZE[0],
        }
    )
