"""Projected polylines as a camera: class -> normalised points, or all that both protocols need.

The protocol needs no more of a camera, so a method that cannot share its model can share these. The
files look like annotations; so they are read only where this format was asked for. Whole
projections have a key ``format`` and are recognised by it.
"""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.base import ElementProjections
from procc_annotator.formats.cameras.fit_record import DIGEST, FIT_KEY
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.loaded_camera import CameraRecord, CameraRecords, LoadedCamera
from procc_annotator.formats.strict_json import is_finite_number, json_kind, json_repr, printable

KIND = "projected polylines (class -> points)"
WHOLE = "procc-annotator projection 1"
_WHOLE_KEYS = ("format", "size", "ground_only", "field_sha256", "pieces", "samples")
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
    if type(content) is not dict or not content or is_whole(content):
        return None
    if not any(type(value) is dict for value in content.values()):
        return None
    found = [(name, CameraRecord(name, value)) for name, value in content.items()]
    return CameraRecords.of(path, found, polylines_from)


def polylines_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read the polylines of one frame. `CameraError` names the place and what was expected."""
    values = JsonValues.of(content, path, inside, KIND)
    if is_whole(content):
        return _whole_from(values)
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


def is_whole(content: object) -> bool:
    """Return whether a decoded value is a whole projection, of any version."""
    said = content.get("format") if type(content) is dict else None
    return type(said) is str and said.startswith(WHOLE.rpartition(" ")[0])


def encode_whole(
    projections: ElementProjections, size: tuple[int, int], fitted_on: str | None
) -> bytes:
    """A frame's file, of projections with samples in px of ``size``, and the digest of the
    annotation that the camera was fitted to; numbers keep all digits."""
    assert projections.samples is not None
    return msgspec.json.encode(
        {
            "format": WHOLE,
            "size": size,
            "ground_only": projections.ground_only,
            "field_sha256": projections.field_sha256,
            **({} if fitted_on is None else {FIT_KEY: {DIGEST: fitted_on}}),
            "pieces": {n: [px.tolist() for px in own] for n, own in projections.pieces.items()},
            "samples": {
                name: [None if x != x or y != y else (x, y) for x, y in px.tolist()]
                for name, px in projections.samples.items()
            },
        }
    )


def _whole_from(values: JsonValues) -> LoadedCamera:
    content = values.content
    if content["format"] != WHOLE:
        advice = "update procc-annotator, or write the file again with this version"
        raise values.error(f"expected {WHOLE!r}, found {content['format']!r}", "format", advice)
    width, height = values.vector("size", 2)
    if min(width, height) < 2 or (width, height) != (int(width), int(height)):
        raise values.error(f"expected (width, height) px, found {width:g} x {height:g}", "size")
    pieces = {
        name: tuple(_pairs(values, part, f"{name}[{i}]") for i, part in enumerate(parts))
        for name, parts in _lists(values, "pieces")
    }
    samples = {
        name: _pairs(values, own, name, gaps=True) for name, own in _lists(values, "samples")
    }
    ground_only, field = content.get("ground_only") is True, str(content.get("field_sha256", ""))
    extra = {key: value for key, value in content.items() if key not in _WHOLE_KEYS}
    found = ElementProjections(pieces, samples, ground_only, field)
    return LoadedCamera(found, "projections", (int(width), int(height)), extra)


def _lists(values: JsonValues, key: str) -> list[tuple[str, list[Any]]]:
    found = values.content.get(key)
    if type(found) is not dict or any(type(own) is not list for own in found.values()):
        raise values.error("expected lists of points [x, y] by class", key)
    return list(found.items())


def _pieces(values: JsonValues, name: str) -> tuple[FloatArray, ...]:
    value, shown = values.content[name], printable(name)
    if type(value) is not list:
        raise values.error(f"expected a list of points, found {json_kind(value)}", shown)
    if value and all(type(part) is list for part in value):
        return tuple(_points(values, part, f"{shown}[{i}]") for i, part in enumerate(value))
    return (_points(values, value, shown),) if value else ()


def _pairs(values: JsonValues, given: Any, name: str, *, gaps: bool = False) -> FloatArray:
    """(n, 2) px of a list of [x, y]; with gaps, NaN for null."""
    points = np.full((len(given) if type(given) is list else 0, 2), np.nan)
    for i, pair in enumerate(given if type(given) is list else [given]):
        if gaps and pair is None:
            continue
        if type(pair) is not list or len(pair) != 2 or not all(map(is_finite_number, pair)):
            place = f"{printable(name)}[{i}]"
            raise values.error(f"expected a point [x, y] in px, found {json_repr(pair)}", place)
        points[i] = pair
    return points


def _points(values: JsonValues, value: list[Any], place: str) -> FloatArray:
    points = np.empty((len(value), 2))
    for i, point in enumerate(value):
        at = f"{place}[{i}]"
        if type(point) is not dict or not {"x", "y"} <= point.keys():
            found = json_repr(point)
            raise values.error(f'expected a point {{"x": ..., "y": ...}}, found {found}', at)
        points[i] = [values.finite(point[axis], f"{at}.{axis}") for axis in ("x", "y")]
    return points


def _is_points(value: list[Any]) -> bool:
    first = value[0] if value else None
    if type(first) is list:
        first = first[0] if first else None
    return first is None or (type(first) is dict and "x" in first and "y" in first)
