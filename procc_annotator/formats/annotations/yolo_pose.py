"""Write YOLO pose labels and ``data.yaml``; recognise such label files.

Facts: https://docs.ultralytics.com/datasets/pose. A line is ``class x y w h`` and ``px py v`` for
each keypoint, all in widths and heights of the picture; v is 0 for what is not labelled, 2 for what
is. Every line has the same number of keypoints, and one coordinate outside 0..1 makes its readers
leave out the whole picture.

The layout here: a class an element, the points of its polyline in order, then as many unlabelled
ones as are left up to the longest polyline of the set. Points outside the picture are not written.
"""

from __future__ import annotations

import json
from collections.abc import Iterable

from procc_annotator.annotation import Polyline
from procc_annotator.formats.annotations.exchange import (
    ExchangedFrame,
    Size,
    WriteContext,
    points_to_px,
)
from procc_annotator.formats.annotations.shape_joining import labels_for

DEFAULT_SPLIT = "train"
_TITLE = "YOLO"
_BOX = 5  # numbers before the keypoints: a class and its box
_DECIMALS = 7  # of a width: a ten thousandth of a pixel


def write_many(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """``labels/SPLIT/{frame}.txt``, and ``data.yaml`` that names classes and folders."""
    split = writing.folder or DEFAULT_SPLIT
    ids = {e.name: i for i, e in enumerate(writing.field.elements)}
    kept: list[tuple[str, list[tuple[int, list[tuple[float, float]]]]]] = []
    for frame in frames:
        size = writing.size(frame)
        if size is None:
            continue
        polylines = writing.without_empty(frame, _TITLE)
        lines = []
        for label, polyline in zip(labels_for(polylines, writing.field), polylines, strict=True):
            inside = _inside(polyline, size)
            if len(inside) < len(polyline.points):
                writing.remarks.add(f"{_TITLE} has no points outside the picture", frame.name)
            if inside:
                lines.append((ids.setdefault(label, len(ids)), inside))
        kept.append((frame.name, lines))
    longest = max((len(points) for _, lines in kept for _, points in lines), default=1)
    for name, lines in kept:
        text = "".join(f"{_line(number, points, longest)}\n" for number, points in lines)
        if writing.put(f"labels/{split}/{name}.txt", text.encode()):
            writing.frames += 1
            writing.elements += len(lines)
            writing.points += sum(len(points) for _, points in lines)
    if writing.frames:
        writing.put("data.yaml", _data(split, longest, ids).encode())


def is_pose_label(data: bytes) -> bool:
    """Return whether a text is one of YOLO pose: a class, a box and keypoints in widths and
    heights, with or without visibility."""
    try:
        lines = [
            [float(word) for word in line.split()] for line in data.decode("ascii").split("\n")
        ]
    except ValueError:  # no numbers, no such text
        return False
    found = [line for line in lines if line]
    return bool(found) and all(
        len(line) >= _BOX + 2
        and ((len(line) - _BOX) % 2 == 0 or (len(line) - _BOX) % 3 == 0)
        and line[0].is_integer()
        and all(0 <= value <= 1 for value in line[1:_BOX])
        for line in found
    )


def _inside(polyline: Polyline, size: Size) -> list[tuple[float, float]]:
    """Points inside the picture, in its widths and heights."""
    return [
        (float(x) / size[0], float(y) / size[1])
        for x, y in points_to_px(polyline, size)
        if 0 <= x <= size[0] - 1 and 0 <= y <= size[1] - 1
    ]


def _line(number: int, points: list[tuple[float, float]], longest: int) -> str:
    low = [min(values) for values in zip(*points, strict=True)]
    high = [max(values) for values in zip(*points, strict=True)]
    middle = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
    size = [b - a for a, b in zip(low, high, strict=True)]
    numbers = [f"{value:.{_DECIMALS}f}" for value in (*middle, *size)]
    for x, y in points:
        numbers += [f"{x:.{_DECIMALS}f}", f"{y:.{_DECIMALS}f}", "2"]
    return " ".join([str(number), *numbers, *["0 0 0"] * (longest - len(points))])


def _data(split: str, longest: int, ids: dict[str, int]) -> str:
    """YAML; strings as JSON writes them are YAML too."""
    folder = json.dumps(f"images/{split}", ensure_ascii=False)
    names = [f"  {i}: {json.dumps(name, ensure_ascii=False)}" for name, i in ids.items()]
    return "\n".join([
        "# Name the folder of another split here to be judged by.",
        f"train: {folder}",
        f"val: {folder}",
        f"kpt_shape: [{longest}, 3]",
        "names:",
        *names,
        "",
    ])  # fmt: skip
