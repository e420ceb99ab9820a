"""Projected polylines as a camera: class -> normalised points.

The protocol needs no more of a camera, so a method that cannot share its model can share these. The
files look like annotations; so they are read only where this format was asked for.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.base import ElementProjections
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.loaded_camera import CameraRecord, CameraRecords, LoadedCamera
from procc_annotator.formats.strict_json import is_finite_number, json_kind, json_repr, printable

KIND = "projected polylines (class -> points)"
# Pixels are (W - 1) times a share: of a picture two pixels wide, pixels are the shares themselves.
SHARES = (2, 2)
_FAR = 4.0


def looks_like_points(content: object) -> bool:
    """Return whether a decoded value is an object of classes with points, as annotations are."""
    return (
        type(content) is dict
        and bool(content)
        and all(type(value) is list for value in content.values())
        and all(_is_points(value) for value in content.values())
    )


def polylines_records(content: object, path: str) -> CameraRecords | None:
    """The frames of a decoded file that holds several: ``{frame: {class: points}}``; else None."""
    if type(content) is not dict or not content:
        return None
    if not any(type(value) is dict for value in content.values()):
        return None
    found = [(name, CameraRecord(name, value)) for name, value in content.items()]
    return CameraRecords.of(path, found, polylines_from)


def polylines_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read the polylines of one frame.

    Raises:
        CameraError: names the place and what was expected.
    """
    values = JsonValues.of(content, path, inside, KIND)
    pieces: dict[str, tuple[FloatArray, ...]] = {}
    for name in values.content:
        own = name.strip()
        if own in pieces:
            raise values.error("stands for a class that is there already", printable(name))
        pieces[own] = _pieces(values, name)
    every = [piece for some in pieces.values() for piece in some if len(piece)]
    if every and all((np.abs(piece - 0.5) > _FAR).any(axis=1).all() for piece in every):
        raise values.error(
            "no point is near the picture, expected shares of its width and height (0 to 1)",
            advice="divide pixels by (width - 1) and (height - 1)",
        )
    return LoadedCamera(ElementProjections(pieces), "projections", SHARES)


def _pieces(values: JsonValues, name: str) -> tuple[FloatArray, ...]:
    value = values.content[name]
    if type(value) is not list:
        raise values.error(f"expected a list of points, found {json_kind(value)}", printable(name))
    if value and all(type(part) is list for part in value):
        return tuple(
            _points(values, part, f"{printable(name)}[{i}]") for i, part in enumerate(value)
        )
    return (_points(values, value, printable(name)),) if value else ()


def _points(values: JsonValues, value: list[Any], place: str) -> FloatArray:
    points = np.empty((len(value), 2))
    for i, point in enumerate(value):
        if type(point) is not dict or not {"x", "y"} <= point.keys():
            raise values.error(
                f'expected a point {{"x": ..., "y": ...}}, found {json_repr(point)}',
                f"{place}[{i}]",
            )
        for axis, key in enumerate(("x", "y")):
            number = point[key]
            if not is_finite_number(number):
                raise values.error(
                    f"expected a finite number, found {json_repr(number)}",
                    f"{place}[{i}].{key}",
                )
            points[i, axis] = number
    return points


def _is_points(value: list[Any]) -> bool:
    first = value[0] if value else None
    if type(first) is list:
        first = first[0] if first else None
    return first is None or (type(first) is dict and "x" in first and "y" in first)
