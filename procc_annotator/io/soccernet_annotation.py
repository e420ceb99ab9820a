"""SoccerNet annotation files: class name -> list of ``{"x": u, "y": v}``, normalised."""

from __future__ import annotations

import json
from typing import Any

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.errors import AnnotationError
from procc_annotator.field.model import Field
from procc_annotator.io.json_text import decode_fast, decode_strict, is_finite_number


def read_annotation(data: bytes, *, path: str, field: Field) -> FrameAnnotation:
    """Read an annotation; numbers, order, unknown classes and unknown keys are kept as they are.

    Class names get the official spelling where only white space at their ends differs. A list is a
    class's points; any other top-level value is kept in ``extra`` and written back.

    Args:
        data: the file's bytes, UTF-8.
        path: for error messages.
        field: knows the official spellings.

    Raises:
        AnnotationError: names the place (``Circle left[3].x``) and what was expected.
    """
    content = decode_fast(data, path=path, error=AnnotationError)
    # A key that occurs twice is silently dropped by the fast decoder and would take clicks with it:
    # then fewer "x" come out than went in, and the strict decoder has the last word.
    annotation, points = _convert(content, path, field)
    if points != data.count(b'"x"'):
        annotation, _ = _convert(decode_strict(data, path=path, error=AnnotationError), path, field)
    return annotation


def write_annotation(annotation: FrameAnnotation) -> bytes:
    """An annotation as file content: one class a line, UTF-8, ending in a newline."""
    lines = [
        f"  {_json(key)}: {_json(value)}"
        for key, value in [
            *((p.class_name, [_point_object(q) for q in p.points]) for p in annotation.polylines),
            *annotation.extra,
        ]
    ]
    body = "{\n" + ",\n".join(lines) + "\n}\n" if lines else "{}\n"
    return body.encode()


def _convert(content: Any, path: str, field: Field) -> tuple[FrameAnnotation, int]:
    if type(content) is not dict:
        raise AnnotationError(
            path, f"expected an object of class names, found {_kind(content)}", place="top level"
        )
    polylines: list[Polyline] = []
    extra: list[tuple[str, Any]] = []
    names: dict[str, str] = {}
    points = 0
    for key, value in content.items():
        if type(value) is not list:
            extra.append((key, value))
            continue
        name = field.canonical_name(key)
        if name in names:
            raise AnnotationError(
                path,
                f"the class occurs twice, as {names[name]!r} and {key!r}",
                place=repr(key),
                advice="keep one of them",
            )
        names[name] = key
        polylines.append(
            Polyline(name, tuple([_point(p, path, key, i) for i, p in enumerate(value)]))
        )
        points += len(value)
    return FrameAnnotation(tuple(polylines), tuple(extra)), points


def _point(value: Any, path: str, key: str, i: int) -> Point:
    place = f"{key}[{i}]"
    if type(value) is not dict:
        raise AnnotationError(path, f'expected {{"x", "y"}}, found {_kind(value)}', place=place)
    for axis in ("x", "y"):
        if axis not in value:
            raise AnnotationError(path, f"the coordinate {axis!r} is missing", place=place)
        if not is_finite_number(value[axis]):
            raise AnnotationError(
                path,
                f"expected a finite number, found {_shown(value[axis])}",
                place=f"{place}.{axis}",
            )
    if len(value) == 2:
        return Point(value["x"], value["y"])
    rest = tuple((k, v) for k, v in value.items() if k not in ("x", "y"))
    return Point(value["x"], value["y"], rest)


def _point_object(point: Point) -> dict[str, Any]:
    return {"x": point.u, "y": point.v, **dict(point.extra)}


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)


def _kind(value: object) -> str:
    names = {
        dict: "an object",
        list: "a list",
        str: "text",
        bool: "true or false",
        type(None): "null",
    }
    return names.get(type(value), "a number")


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 40 else f"{text[:37]}..."
