"""COCO keypoints: one JSON file with images and a keypoint list per element.

Facts: https://cocodataset.org/#format-data. Keypoints are [x, y, v, ...] with v = 0 not labelled
(x = y = 0), 1 labelled but not visible, 2 visible; a category has a fixed list of them.

The layout here: a category a class, its keypoints named "1", "2", ... up to the longest polyline
of the class in the set; the points of a polyline in order, then as many unlabelled ones as are
left. A point outside the picture has v = 1. There is no ``segmentation``: readers take a list of
none for a mask that is damaged.

A category of others may hold a template instead: places of a field. What is known of those is in
`keypoint_templates`; they are never read as one polyline.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from procc_annotator.annotation import Point, Polyline
from procc_annotator.errors import AnnotationError
from procc_annotator.formats.annotations.exchange import (
    EXTRA_KEY,
    ExchangedFrame,
    FrameReader,
    ReadContext,
    Size,
    WriteContext,
    points_to_px,
    readers_by_image,
    require_objects,
)
from procc_annotator.formats.annotations.label_map import (
    KeypointTemplate,
    TemplateRule,
    has_gaps,
    holds_template,
    known_templates,
    template_named,
    template_of,
)
from procc_annotator.formats.annotations.shape_joining import ShapeCollector, extra_of, labels_for
from procc_annotator.formats.frame_names import picture_name
from procc_annotator.formats.strict_json import decode_strict, json_repr, json_text, parse_number
from procc_annotator.messages import pluralize

DEFAULT_SPLIT = "default"
# As COCO calls the files of its own sets: other programs know the kind of annotation by it.
_FILE = "annotations/person_keypoints_{}.json"
FILE_NAME = _FILE.format(DEFAULT_SPLIT)
_TITLE = "COCO"
_LISTS = ("images", "annotations", "categories")


def sniff(content: Any) -> bool:
    """Return whether decoded JSON is such a file."""
    if type(content) is not dict or any(type(content.get(key)) is not list for key in _LISTS):
        return False
    other = ("image_id", "camera_matrix", "polylines")  # game state, SynLoc's cameras, FiftyOne
    return not any(type(i) is dict and any(k in i for k in other) for i in content["images"][:10])


def frames_of(
    data: bytes, path: str, reading: ReadContext
) -> tuple[Sequence[Any], Sequence[FrameReader]]:
    """Every picture that has annotations with keypoints; see `FramesOf`."""
    content = decode_strict(data, path=path, error=AnnotationError, parse_float=parse_number)
    content = require_objects(content, _LISTS, path, "file of COCO keypoints")
    without = not any(category.get("keypoints") for category in content["categories"])
    if content["images"] and without and not content["annotations"]:
        raise AnnotationError(
            path, f"holds {pluralize(len(content['images']), 'picture')}, no annotation",
            advice="CVAT writes no polylines as COCO: export CVAT for images 1.1 or Datumaro",
        )  # fmt: skip
    kinds = {
        _id(c, "id"): _kind(c, f"categories[{i}]", path, reading)
        for i, c in enumerate(content["categories"])
    }
    found: dict[Any, list[tuple[int, dict[str, Any]]]] = {}
    for i, entry in enumerate(content["annotations"]):
        found.setdefault(_id(entry, "image_id"), []).append((i, entry))
    read = partial(_read, kinds)
    return readers_by_image(content["images"], found, partial(_id, key="id"), read, path, reading)


@dataclass(frozen=True)
class _Kind:
    """Meaning of a category's keypoints: one line, or places of a template, if it is known.

    Attributes:
        is_new: whether the category is no class, and no map says what it stands for.
    """

    name: Any
    is_new: bool
    is_template: bool = False
    template: KeypointTemplate | None = None
    count: int = 0


def _kind(category: dict[str, Any], place: str, path: str, reading: ReadContext) -> _Kind:
    name, places = category.get("name"), category.get("keypoints")
    rule = reading.rule_of(name) if type(name) is str else None
    if isinstance(rule, TemplateRule):
        template = template_named(rule.name)
    elif rule is not None or not holds_template(category):
        return _Kind(name, rule is None, count=len(places) if type(places) is list else 0)
    else:
        template = template_of(category)
    if template is not None and not template.is_of(reading.field):
        raise AnnotationError(
            path,
            f"holds {template.title}, the field is {reading.field.title}",
            place=f"{place}.keypoints",
            advice=f"name the field: --field {template.field}",
        )
    return _Kind(name, True, True, template, len(places) if type(places) is list else 0)


def _unknown_template(kind: _Kind) -> str:
    return (
        f"the category {json_repr(kind.name)} holds {kind.count} keypoints of a template that is"
        " not"
        " known: left out (if it is one of"
        f" {', '.join(known.name for known in known_templates())}, a labels.toml may say so:"
        f' {json_repr(kind.name)} = {{ template = "{known_templates()[0].name}" }})'
    )


def _id(entry: dict[str, Any], key: str) -> Any:
    """An id as a key of a dict; whatever cannot be one matches nothing."""
    value = entry.get(key)
    return value if type(value) in (int, str) else repr(value)


def _read(
    kinds: dict[Any, _Kind],
    image: dict[str, Any],
    place: str,
    entries: list[tuple[int, dict[str, Any]]],
    path: str,
    reading: ReadContext,
) -> ExchangedFrame | None:
    picture = image.get("file_name")
    frame = reading.frame_of_picture(picture, path, f"{place}.file_name")
    size = reading.size_in_file(
        image.get("width"), image.get("height"), path, f"{place}.width, height"
    )
    pieces = ShapeCollector(path, "annotations", reading, size, frame)
    taken = False
    for i, entry in entries:
        taken |= _add(pieces, entry, f"annotations[{i}]", kinds)
    if not taken:
        return None
    extra = extra_of(image.get(EXTRA_KEY), path, f"{place}.{EXTRA_KEY}", reading.field)
    return ExchangedFrame(frame, pieces.annotation(extra), size, picture_name(str(picture)))


def _add(
    pieces: ShapeCollector, entry: dict[str, Any], where: str, kinds: dict[Any, _Kind]
) -> bool:
    """Take over the points of one annotation; False if it has none that mean something here."""
    if "keypoints" not in entry:
        pieces.remark("annotations without keypoints are left out")
        return False
    category = _id(entry, "category_id")
    if category not in kinds:
        problem = f"expected the id of a category, found {json_repr(entry.get('category_id'))}"
        raise pieces.error(problem, f"{where}.category_id", "correct it, or add the category")
    points = _points(pieces, entry["keypoints"], f"{where}.keypoints")
    kind = kinds[category]
    if kind.template is None and (kind.is_template or (kind.is_new and has_gaps(points))):
        pieces.remark(_unknown_template(kind))
        return False
    if kind.template is not None:
        pieces.remark(f"keypoints ({kind.template.title}) are points of the elements they lie on")
        for name, some in kind.template.shapes(points):
            pieces.add(name, some, f"categories[id {category}].keypoints")
    else:
        seen = tuple(point for point in points if point is not None)
        pieces.add(kind.name, seen, f"categories[id {category}].name")
    return True


def _points(pieces: ShapeCollector, values: Any, place: str) -> tuple[Point | None, ...]:
    """The keypoints in their order; None for those that are not labelled."""
    if type(values) is not list or len(values) % 3:
        problem = f"expected keypoints [x, y, v, ...], found {json_repr(values)}"
        raise pieces.error(problem, place, "correct or remove the annotation")
    points: list[Point | None] = []
    for i in range(0, len(values), 3):
        x, y, visible = values[i : i + 3]
        if visible not in (0, 1, 2) or type(visible) is bool:
            problem = f"expected the visibility 0, 1 or 2, found {json_repr(visible)}"
            raise pieces.error(problem, f"{place}[{i + 2}]", "correct it")
        points.append(pieces.point(x, y, f"{place}[{i}]") if visible else None)
    return tuple(points)


def write_many(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """One file that the usual readers of COCO keypoints load."""
    images: list[dict[str, Any]] = []
    entries: list[dict[str, Any]] = []
    ids = {e.name: i for i, e in enumerate(writing.field.elements, start=1)}
    longest: dict[str, int] = dict.fromkeys(ids, 1)
    for frame, size in writing.sized(frames):
        writing.lose_point_keys(frame, _TITLE)
        polylines = frame.annotation.polylines
        if not polylines:
            writing.remarks.add(
                f"{_TITLE} cannot distinguish annotated frames without any element from others",
                frame.name,
            )
        image: dict[str, Any] = {
            "id": len(images) + 1,
            "width": size[0],
            "height": size[1],
            "file_name": writing.picture_of_frame(frame),
        }
        if frame.annotation.extra:
            image[EXTRA_KEY] = dict(frame.annotation.extra)
        images.append(image)
        for label, polyline in zip(labels_for(polylines, writing.field), polylines, strict=True):
            ids.setdefault(label, len(ids) + 1)
            longest[label] = max(longest.get(label, 1), len(polyline.points))
            entries.append(_entry(polyline, label, size, len(entries) + 1, len(images)))
        writing.count(polylines)
    for entry in entries:
        label = entry.pop("label")
        entry["category_id"] = ids[label]
        entry["keypoints"] += [0, 0, 0] * (longest[label] - len(entry["keypoints"]) // 3)
    content = {
        "info": {"description": f"elements of a {writing.field.name} field", "version": "1.0"},
        "licenses": [],
        "images": images,
        "annotations": entries,
        "categories": [_category(name, i, longest[name], writing) for name, i in ids.items()],
    }
    writing.put_only_file(
        _FILE.format(writing.folder or DEFAULT_SPLIT), f"{json_text(content)}\n".encode()
    )


def _entry(polyline: Polyline, label: str, size: Size, number: int, image: int) -> dict[str, Any]:
    points = points_to_px(polyline, size)
    keypoints: list[float] = []
    for x, y in points:
        inside = 0 <= x <= size[0] - 1 and 0 <= y <= size[1] - 1
        keypoints += [x, y, 2 if inside else 1]
    xs, ys = [float(x) for x, _ in points] or [0.0], [float(y) for _, y in points] or [0.0]
    box = [min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys)]
    return {
        "id": number,
        "image_id": image,
        "category_id": 0,
        "label": label,
        "num_keypoints": len(points),
        "keypoints": keypoints,
        "bbox": box,
        "area": box[2] * box[3],
        "iscrowd": 0,
    }


def _category(name: str, number: int, points: int, writing: WriteContext) -> dict[str, Any]:
    return {
        "id": number,
        "name": name,
        "supercategory": writing.field.name,
        "keypoints": [str(i) for i in range(1, points + 1)],
        "skeleton": [[i, i + 1] for i in range(1, points)],
    }
