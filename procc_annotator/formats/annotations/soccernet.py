"""Read and write SoccerNet annotation files: class name -> normalised points."""

from __future__ import annotations

import json
import math
from typing import Annotated, Any

import msgspec

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.errors import AnnotationError
from procc_annotator.field.model import Field
from procc_annotator.formats.strict_json import (
    decode_strict,
    has_only_keys,
    is_finite_number,
    json_kind,
    json_repr,
    printable,
    strip_bom,
)

CAMERA_KEY = "pan_degrees"


# Points may lie outside the picture, but not a million pictures away: there squares overflow.
MAX_COORDINATE = 1e6
_Bounds = msgspec.Meta(ge=-MAX_COORDINATE, le=MAX_COORDINATE)
_Coordinate = (
    Annotated[int, msgspec.Meta(ge=-int(MAX_COORDINATE), le=int(MAX_COORDINATE))]
    | Annotated[float, _Bounds]
)


class _PlainPoint(msgspec.Struct, forbid_unknown_fields=True, gc=False):
    x: _Coordinate
    y: _Coordinate


_DECODER = msgspec.json.Decoder(dict[str, list[_PlainPoint]])


def read_annotation(data: bytes, *, path: str, field: Field) -> FrameAnnotation:
    """Read an annotation; numbers, order, unknown classes and unknown keys are kept as they are.

    Class names get the official spelling where only white space at their ends differs. A list is a
    class's points; a top-level value that cannot be one (a text, an object, a list of plain
    values) is kept in ``extra`` and written back, unless the field knows a class of that name.

    Raises:
        AnnotationError: names the place (``Circle left[3].x``) and what was expected.
    """
    annotation = _read_plain(data, field)
    if annotation is None:
        content = decode_strict(data, path=path, error=AnnotationError)
        annotation = annotation_of(content, path, field)
    return annotation


def write_annotation(annotation: FrameAnnotation) -> bytes:
    """An annotation as file content: one class a line, UTF-8, ending in a newline.

    Raises:
        ValueError: a coordinate is not finite; no reader would take the file.
    """
    entries: list[tuple[str, object]] = [
        *((p.class_name, [point_object(q) for q in p.points]) for p in annotation.polylines),
        *annotation.extra,
    ]
    lines = [f"  {_json(key)}: {_json(value)}" for key, value in entries]
    body = "{\n" + ",\n".join(lines) + "\n}\n" if lines else "{}\n"
    return body.encode()


def _read_plain(data: bytes, field: Field) -> FrameAnnotation | None:
    """The annotation of a file that holds nothing but classes and points, which nearly all do.

    None where anything is unusual; the slow way then finds out whether it is an error.
    """
    try:
        content = _DECODER.decode(strip_bom(data))
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return None
    keys = len(content) + 2 * sum(map(len, content.values()))
    canonical = field.canonical_name
    new = tuple.__new__  # Point(...) takes twice as long, and there are 40 of them a file
    polylines = tuple(
        [
            Polyline(canonical(key), tuple([new(Point, (p.x, p.y, ())) for p in points]))
            for key, points in content.items()
        ]
    )
    if not has_only_keys(data, keys) or len({p.class_name for p in polylines}) < len(polylines):
        return None
    return FrameAnnotation(polylines)


def annotation_of(content: Any, path: str, field: Field) -> FrameAnnotation:
    """The annotation of a decoded file; arguments and errors as for `read_annotation`."""
    if type(content) is not dict:
        raise AnnotationError(
            path,
            f"expected an object of class names, found {json_kind(content)}",
            place="top level",
            advice="is this an annotation?",
        )
    if CAMERA_KEY in content:
        raise AnnotationError(
            path,
            "is a camera, expected an annotation",
            place=CAMERA_KEY,
            advice="cameras are named camera_*.json, or kept in a folder of their own",
        )
    polylines: list[Polyline] = []
    extra: list[tuple[str, Any]] = []
    names: dict[str, str] = {}
    for key, value in content.items():
        name = field.canonical_name(key)
        if not field.knows(name) and not may_be_points(value):
            extra.append((key, value))
            continue
        if type(value) is not list:
            raise AnnotationError(
                path,
                f"expected a list of points, found {json_kind(value)}",
                place=printable(key),
                advice="an absent class has an empty list",
            )
        if name in names:
            raise AnnotationError(
                path,
                f"the class occurs twice, as {printable(names[name])!r} and {printable(key)!r}",
                place=repr(printable(key)),
                advice="keep one of them",
            )
        names[name] = key
        place = printable(key)
        points = tuple([_point(p, path, f"{place}[{i}]") for i, p in enumerate(value)])
        polylines.append(Polyline(name, points))
    return FrameAnnotation(tuple(polylines), tuple(extra))


def may_be_points(value: object) -> bool:
    """Return whether the value of an unknown key is taken for the points of a class."""
    return type(value) is list and (
        not value or any(type(item) is dict or type(item) is list for item in value)
    )


def _point_error(path: str, place: str, problem: str) -> AnnotationError:
    return AnnotationError(path, problem, place=place, advice="correct or remove the point")


def _point(value: Any, path: str, place: str) -> Point:
    if type(value) is not dict:
        problem = f'expected a point {{"x": .., "y": ..}}, found {json_kind(value)}'
        raise _point_error(path, place, problem)
    for axis in ("x", "y"):
        if axis not in value:
            problem = f"the coordinate {axis!r} is missing, expected a number"
            raise _point_error(path, place, problem)
        at, number = f"{place}.{axis}", value[axis]
        if not is_finite_number(number):
            raise _point_error(path, at, f"expected a finite number, found {json_repr(number)}")
        if abs(number) > MAX_COORDINATE:
            problem = f"expected a normalised coordinate, 0 to 1 in the picture, found {number:g}"
            raise _point_error(path, at, problem)
    if len(value) == 2:
        return Point(value["x"], value["y"])
    rest = tuple((k, v) for k, v in value.items() if k not in ("x", "y"))
    return Point(value["x"], value["y"], rest)


def point_object(point: Point) -> dict[str, Any]:
    """A point as an object of a file. `ValueError` if a coordinate is not finite."""
    if not (math.isfinite(point.u) and math.isfinite(point.v)):
        raise ValueError(f"a point is not finite: {point}")
    return {"x": point.u, "y": point.v, **dict(point.extra)}


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)
