"""SoccerNet game-state ``Labels-GameState.json``: pitch annotations of one clip.

Facts: the paper "SoccerNet Game State Reconstruction" (figure S3) and https://github.com/SoccerNet/
sn-gamestate. ``images`` have ``image_id``, ``file_name``, ``width`` and ``height``; an annotation
of the category pitch (5) has ``lines``: {class: [{x, y}]}, normalised as in SoccerNet-calibration.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from procc_annotator.annotation import Point
from procc_annotator.errors import AnnotationError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.exchange import (
    EXTRA_KEY,
    ExchangedFrame,
    FrameReader,
    ReadContext,
    WriteContext,
    readers_by_image,
    require_objects,
    size_from_file,
)
from procc_annotator.formats.annotations.shape_joining import ShapeCollector, extra_of
from procc_annotator.formats.annotations.soccernet import annotation_of, point_object
from procc_annotator.formats.frame_names import frame_of_picture, picture_name
from procc_annotator.formats.strict_json import decode_strict, json_kind, json_text

FILE_NAME = "Labels-GameState.json"
PITCH_CATEGORY = 5
_OBJECTS = {1: "player", 2: "goalkeeper", 3: "referee", 4: "ball", 7: "other"}
_OWN_KEYS = frozenset({
    "id", "image_id", "video_id", "supercategory", "category_id", "lines", EXTRA_KEY,
})  # fmt: skip


def sniff(content: Any) -> bool:
    """Return whether decoded JSON is such a file."""
    if type(content) is not dict or type(content.get("images")) is not list:
        return False
    entries = content.get("annotations")
    of_images = any(type(i) is dict and "image_id" in i for i in content["images"][:10])
    return of_images and type(entries) is list


def frames_of(
    data: bytes, path: str, reading: ReadContext
) -> tuple[Sequence[Any], Sequence[FrameReader]]:
    """Every picture that has a pitch annotation; see `FramesOf`."""
    content = decode_existing(data, path)
    pitches = _pitches(content["annotations"])
    if sum(map(len, pitches.values())) < len(content["annotations"]):
        reading.remarks.add("players, ball, cameras and other annotations are left out")
    return readers_by_image(content["images"], pitches, _image_id, _read, path, reading)


def decode_existing(data: bytes, path: str) -> dict[str, Any]:
    """The content of a file, with its lists of images and annotations checked. `AnnotationError` if
    it is of another kind."""
    content = decode_strict(data, path=path, error=AnnotationError)
    content = require_objects(content, ("images", "annotations"), path, FILE_NAME)
    for key in ("images", "annotations"):
        for i, entry in enumerate(content[key]):
            if type(entry.get("image_id")) not in (str, int):
                problem, place = "expected an object with image_id", f"{key}[{i}]"
                raise AnnotationError(path, problem, place=place, advice="correct or remove it")
    return content


def _image_id(entry: dict[str, Any]) -> str:
    return str(entry["image_id"])


def _pitches(entries: list[dict[str, Any]]) -> dict[str, list[tuple[int, dict[str, Any]]]]:
    found: dict[str, list[tuple[int, dict[str, Any]]]] = {}
    for i, entry in enumerate(entries):
        if "lines" in entry:
            found.setdefault(_image_id(entry), []).append((i, entry))
    return found


def _read(
    image: dict[str, Any],
    place: str,
    found: list[tuple[int, dict[str, Any]]],
    path: str,
    reading: ReadContext,
) -> ExchangedFrame:
    picture = image.get("file_name")
    frame = reading.frame_of_picture(picture, path, f"{place}.file_name")
    size = size_from_file(image.get("width"), image.get("height"), path, f"{place}.width, height")
    pieces = ShapeCollector(path, f"annotations[{found[0][0]}].lines", reading, size, frame)
    extra: dict[str, Any] = {}
    for i, entry in found:
        where = f"annotations[{i}]"
        for name, points in _lines(entry["lines"], path, where, reading.field).items():
            pieces.add(name, points, where)
        extra |= dict(extra_of(entry.get(EXTRA_KEY), path, f"{where}.{EXTRA_KEY}", reading.field))
        if entry.keys() - _OWN_KEYS:
            pieces.remark("further keys of pitch annotations are left out")
    annotation = pieces.annotation(tuple(extra.items()))
    return ExchangedFrame(
        frame, annotation, size or reading.size_of(frame), picture_name(str(picture))
    )


def _lines(lines: Any, path: str, place: str, field: Field) -> dict[str, tuple[Point, ...]]:
    if lines is None or lines == []:
        return {}
    try:
        annotation = annotation_of(lines, path, field)
    except AnnotationError as error:
        inner = f"{place}.lines" + ("" if error.place == "top level" else f"[{error.place}]")
        raise AnnotationError(path, error.problem, place=inner, advice=error.advice) from error
    if annotation.extra:
        raise AnnotationError(
            path,
            f"expected a list of points, found {json_kind(annotation.extra[0][1])}",
            place=f"{place}.lines[{annotation.extra[0][0]}]",
            advice="correct or remove it",
        )
    return {p.class_name: p.points for p in annotation.polylines}


def write_many(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """One file; the other annotations of an existing one stay as they are."""
    content = writing.into if writing.into is not None else _start(writing.field)
    images, entries = content["images"], content["annotations"]
    by_frame: dict[str, list[dict[str, Any]]] = {}
    for i, image in enumerate(images):
        name = frame_of_picture(image.get("file_name"), FILE_NAME, f"images[{i}]")
        by_frame.setdefault(name, []).append(image)
    pitches = _pitches(entries)
    taken = set(map(_image_id, images))
    taken_ids = {str(entry.get("id")) for entry in entries}
    for frame in frames:
        there = by_frame.get(frame.name, [])
        if not writing.only_one(frame, [image["file_name"] for image in there]):
            continue
        image = there[0] if there else _new_image(frame, writing, taken)
        if not there:
            images.append(image)
        found = pitches.get(_image_id(image), [])
        if found:
            entry = found[0][1]
            for _, further in found[1:]:
                further["lines"] = {}
                further.pop(EXTRA_KEY, None)
        else:
            entry = {
                "id": _new_id(taken_ids),
                "image_id": image["image_id"],
                "supercategory": "pitch",
                "category_id": PITCH_CATEGORY,
            }
            entries.append(entry)
        if "has_labeled_pitch" in image:
            image["has_labeled_pitch"] = True
        polylines = frame.annotation.polylines
        entry["lines"] = {p.class_name: list(map(point_object, p.points)) for p in polylines}
        entry.pop(EXTRA_KEY, None)
        if frame.annotation.extra:
            entry[EXTRA_KEY] = dict(frame.annotation.extra)
        writing.count(polylines)
    writing.put_only_file(FILE_NAME, f"{json_text(content, 2)}\n".encode())


def _start(field: Field) -> dict[str, Any]:
    objects = [{"supercategory": "object", "id": i, "name": n} for i, n in _OBJECTS.items()]
    lines = [element.name for element in field.elements if not element.optional]
    pitch = {"supercategory": "pitch", "id": PITCH_CATEGORY, "name": "pitch", "lines": lines}
    camera = {"supercategory": "camera", "id": 6, "name": "camera"}
    return {
        "info": {"version": "1.3", "im_dir": "img1"},
        "images": [],
        "annotations": [],
        "categories": sorted([*objects, pitch, camera], key=lambda c: int(str(c["id"]))),
    }


def _new_image(frame: ExchangedFrame, writing: WriteContext, taken: set[str]) -> dict[str, Any]:
    image: dict[str, Any] = {
        "is_labeled": True,
        "image_id": _new_id(taken),
        "file_name": writing.picture_of_frame(frame),
    }
    if frame.size is not None:
        image |= {"height": frame.size[1], "width": frame.size[0]}
    else:
        writing.remarks.add("the size of the pictures is not known and not written", frame.name)
    return image | {
        "has_labeled_person": False,
        "has_labeled_pitch": True,
        "has_labeled_camera": False,
        "ignore_regions_y": [],
        "ignore_regions_x": [],
    }


def _new_id(taken: set[str]) -> str:
    number = 1_000_000_001 + len(taken)
    while str(number) in taken:
        number += 1
    taken.add(str(number))
    return str(number)
