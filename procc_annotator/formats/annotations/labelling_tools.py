"""Annotations of labelling tools that are read and not written: a row of `TOOLS` each.

A row names the places of pictures, shapes, labels and points in a file; all else is common. A place
is keys and indices with dots between; ``*`` is every entry. Facts: the export pages of Datumaro,
Label Studio, VIA 2, Labelbox and FiftyOne; https://github.com/AtomScott/SoccerTrack-v2 (keypoints
in metres from the far left corner, y towards the camera); TennisCourtDetector (1280x720).
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any
from urllib.parse import unquote

import numpy as np

from procc_annotator.annotation import Point
from procc_annotator.errors import AnnotationError, InputError
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.formats.annotations.exchange import (
    ExchangedFrame,
    FrameReader,
    ReadContext,
    Size,
)
from procc_annotator.formats.annotations.label_map import template_named
from procc_annotator.formats.annotations.shape_joining import ShapeCollector
from procc_annotator.formats.csv_tables import read_table
from procc_annotator.formats.frame_names import PICTURE_SUFFIX, picture_name
from procc_annotator.formats.strict_json import (
    decode_strict,
    is_finite_number,
    parse_number,
    printable,
)
from procc_annotator.messages import pluralize

_KINDS = frozenset({
    "polyline", "line", "vector", "Polyline", "point", "points", "keypoint", "Keypoint",
})  # fmt: skip
_NAMED = {*_KINDS, "polygon"}
_ON_ELEMENT_M = 0.06  # a line's middle lies up to half its width from its edge
_SPACING_M = 0.05
_PLACE = re.compile(r"\(\s*(-?\d+(?:\.\d+)?)\s*,\s*(-?\d+(?:\.\d+)?)\s*\)", re.ASCII)
# How Label Studio names files: by address, uploads with a number in front.
_ADDRESS, _UPLOADED = re.compile(r"/data/|\w+://"), re.compile(r".*/upload/.*?/?[0-9a-f]{8}-(?=.)")
_MOST_SNIFFED = 20
_TASK = ("annotations", "data")  # of Label Studio, alone in a file
_SKIPPED = ("was_cancelled", "performance_details.skipped")
_AUTHORS = ("completed_by.email", "completed_by", "label_details.created_by")
_BLANK = b"\xef\xbb\xbf \t\r\n"
_VIA_HEADER = b"filename,file_size,file_attributes,region_count,region_id"
_VIA_REGION = ("region_shape_attributes", "region_attributes")


@dataclass(frozen=True)
class Tool:
    """A format of a labelling tool.

    Attributes:
        name, title: as of `AnnotationFormat`.
        example: a usual name of its file.
        marks: sets of places; a file is of this tool if it has all of one set.
        pictures: the places of the pictures; all others are relative to a picture or a shape.
        picture, width, height: its name and size, the first place that holds one.
        annotations: of its lists of annotations; of each list the first one that was not skipped
            counts. Empty where a picture has one annotation.
        shapes: of the shapes of an annotation, the first place that holds any.
        kind, label, points: of a shape; points are pairs, numbers, or objects of x and y.
        names: of the file, what labels that are numbers stand for.
        unit: 1 for pixels, 100 for percent of the picture, 0 for shares of it.
        usual: the size of its pictures where neither the file nor a picture says it.
        template: whose keypoints the points of a shape are, in their order.
    """

    name: str
    title: str
    example: str
    marks: tuple[tuple[str, ...], ...]
    pictures: tuple[str, ...]
    picture: tuple[str, ...]
    shapes: tuple[str, ...]
    label: tuple[str, ...]
    points: tuple[str, ...]
    kind: str = ""
    width: tuple[str, ...] = ()
    height: tuple[str, ...] = ()
    names: str = ""
    unit: float = 1
    usual: Size | None = None
    template: str = ""
    annotations: str = ""

    def sniff(self, content: Any) -> bool:
        """Return whether decoded content is of this tool."""
        if self.name == _SOCCERTRACK and type(content) is dict and len(content) > 2:
            return all(map(_PLACE.fullmatch, content))
        return any(all(_all(content, m, _MOST_SNIFFED) for m in marks) for marks in self.marks)

    def frames_of(
        self, data: bytes, path: str, reading: ReadContext
    ) -> tuple[Sequence[Any], Sequence[FrameReader]]:
        """Every picture that has a shape; see `FramesOf`."""
        own, content = reading.at.rpartition("/")[2], decode_lines(data, path, reading.note)
        names = _all(content, self.names) if self.names else []
        pictures = _placed(content, self.pictures)
        held = [self._shapes(one, place) for place, one in pictures]
        if held and not any(shapes for shapes, _ in held):
            problem = f"holds {pluralize(len(held), 'picture')}, no annotation"
            problem += " but skipped ones" if any(remarks for _, remarks in held) else ""
            advice = "export it when it is annotated; drafts and predictions are not read"
            raise AnnotationError(path, problem, advice=advice)
        called = [self._picture(one) or own for _, one in pictures]
        readers = [
            partial(self._read, one, *shapes, picture, names, path, place, reading)
            for (place, one), shapes, picture in zip(pictures, held, called, strict=True)
        ]
        return called, readers

    def _shapes(self, one: Any, place: str) -> tuple[list[tuple[str, Any]], list[str]]:
        """Return (place, shape) of those that count, and remarks on what is left out."""
        lists = _all(one, self.annotations) if self.annotations else []
        is_task = type(one) is dict and _TASK[1] in one  # of predictions alone
        shapes, remarks = [] if lists or is_task else self._shapes_of(one, place), list[str]()
        where = f"{place}.{self.annotations.replace('.*', '[]')}"
        for several in lists:
            taken = False
            for i, each in enumerate(several if type(several) is list else ()):
                if not (found := self._shapes_of(each, f"{where}[{i}]")):
                    continue
                author = _first(each, _AUTHORS)
                by = f" (by {printable(str(author))})" if author is not None else ""
                if _first(each, _SKIPPED) is True:
                    remarks.append(f"annotations that were skipped are left out{by}")
                elif taken:
                    remarks.append(f"further annotations of a picture are left out{by}")
                else:
                    shapes, taken = shapes + found, True
        return shapes, remarks

    def _shapes_of(self, annotation: Any, place: str) -> list[tuple[str, Any]]:
        return [
            (f"{place}.{at}", shape) for at, shape in _placed(annotation, self.shapes)
            if type(shape) is dict or not self.label
        ]  # fmt: skip

    def _picture(self, one: Any) -> str:
        found = [v for way in self.picture for v in _all(one, way) if type(v) is str and v]
        texts = [_of_address(text) if _ADDRESS.match(text) else text for text in found]
        return next((t for t in texts if PICTURE_SUFFIX.search(t)), [*texts, ""][0])

    def _read(
        self, one: Any, shapes: list[tuple[str, Any]], remarks: list[str], picture: str,
        names: list[Any], path: str, place: str, reading: ReadContext,
    ) -> ExchangedFrame | None:  # fmt: skip
        frame = reading.frame_of_picture(picture, path, place)
        for remark in remarks:
            reading.remarks.add(remark, frame)
        if not shapes:
            return None
        sides = _first(one, self.width), _first(one, self.height)
        if self.usual and sides[0] is None and reading.size_of(frame) is None:
            size, usual = self.usual, f"{self.usual[0]}x{self.usual[1]}"
            reading.remarks.add(f"the file states no picture size: {usual} is assumed", frame)
        else:
            size = reading.size_in_file(*sides, path, f"{place}: size")
        pieces = ShapeCollector(path, place, reading, size, frame)
        if self.name == _SOCCERTRACK:
            clicks = [self._point(pieces, px, key) for key, px in one.items()]
            taken = [_add_places(pieces, [*one], [p for p in clicks if p is not None])]
        else:
            taken = [self._add(pieces, shape, names, at) for at, shape in shapes]
        if not any(taken):
            return None
        return ExchangedFrame(frame, pieces.annotation(), size, picture_name(picture))

    def _add(self, pieces: ShapeCollector, shape: Any, names: list[Any], place: str) -> bool:
        found = (v for way in self.points for v in _all(shape, way))
        points = next(filter(_may_be_points, found), None)
        objects = [one for one in (*_all(shape, "value"), shape) if type(one) is dict]
        own = _first(shape, (self.kind,)) if self.kind else None
        named = [str(own)] if own is not None else [key for one in objects for key in one]
        kinds = [stem for key in named if (stem := key.removesuffix("labels")) in _NAMED]
        if (own is not None or kinds) and not pieces.takes([*kinds, own][0], _KINDS):
            return False
        if points is None:
            return False
        if rotation := _first(shape, ("image_rotation",)):
            problem = f"points of a picture rotated by {printable(str(rotation))} degrees"
            advice = "rotate it back in the tool, or rotate its file and annotate that"
            raise pieces.error(problem, f"{place}.image_rotation", advice)
        if any(type(p) is dict and p.get("isBezier") for p in points if type(points) is list):
            pieces.remark("Bezier curves are taken for straight lines between their vertices")
        label = _first(shape, self.label)
        if type(label) is int and 0 <= label < len(names):
            label = names[label]
        seen, template = _first(shape, ("visibility",)), template_named(self.template)
        for run in _runs(points):
            if type(seen) is list and len(seen) == len(run):
                run = [pair for pair, visible in zip(run, seen, strict=True) if visible]
            clicks = [self._point(pieces, pair, f"{place}[{i}]") for i, pair in enumerate(run)]
            if template is None:
                pieces.add(label, tuple(p for p in clicks if p is not None), place)
                continue
            if len(clicks) != template.count:
                problem = f"expected {template.count} keypoints, found {len(clicks)}"
                raise pieces.error(problem, place)
            pieces.remark(f"keypoints ({template.title}) are points of the elements they lie on")
            for name, some in template.shapes(clicks):
                pieces.add(name, some, place)
        return True

    def _point(self, pieces: ShapeCollector, pair: Any, place: str) -> Point | None:
        if self.template and pair in (None, [-1, -1]):  # a keypoint out of sight
            return None
        if isinstance(pair, Mapping):
            pair = [pair.get("x"), pair.get("y")]
        if self.unit != 1 and type(pair) is list and all(map(is_finite_number, pair)):
            pair = [v / (self.unit or 1) * n for v, n in zip(pair, pieces.size, strict=False)]
        return pieces.course([pair], place)[0]


def _add_places(pieces: ShapeCollector, keys: list[str], clicks: list[Point]) -> bool:
    """Make keypoints at places ``(x, y)`` of the field points of every element that they lie on, in
    their order along it."""
    field = pieces.reading.field
    found = [_PLACE.fullmatch(key) for key in keys]
    places = np.array([[float(m[1]), float(m[2])] for m in found if m is not None])
    samples = sample_evenly(field, _SPACING_M)
    if places.min() > -_ON_ELEMENT_M:  # from a corner
        places = places - np.abs(samples.points_world[:, :2]).max(axis=0)
    design = np.column_stack((places, np.ones(len(places))))
    turn = np.linalg.lstsq(design, np.array([(p.u, p.v) for p in clicks]), rcond=None)[0][:2]
    if np.linalg.det(turn) < 0:  # a camera above the ground sees y as x, y towards it
        places = places * (1, -1)
        pieces.remark("places count y away from the camera: turned")
    used = np.zeros(len(clicks), bool)
    for i, element in enumerate(field.elements):
        if element.optional or not element.on_ground:
            continue
        apart = np.linalg.norm(places[:, None] - samples.of(i)[:, :2], axis=2)
        nearest, near = apart.argmin(axis=1), apart.min(axis=1) < _ON_ELEMENT_M
        order = [k for k in np.argsort(nearest, kind="stable") if near[k]]
        if len(order) > (2 if element.is_curved else 0):  # two say nothing of a curve
            pieces.add(element.name, tuple(clicks[k] for k in order), element.name)
            used |= near
    pieces.remark("keypoints at places of the field are points of the elements they lie on")
    if not used.all():
        first = printable(keys[int(np.argmin(used))])
        left = pluralize(int((~used).sum()), "place")
        pieces.remark(f"{left} on no element of the field left out (first: {first})")
    return bool(used.any())


def _placed(content: Any, ways: Sequence[str]) -> list[tuple[str, Any]]:
    """(place, value) of all that is at the first of some places that holds anything."""
    for way in ways:
        if found := _all(content, way):
            where = way.replace(".*", "[]").replace("*", "[]")
            return [(f"{where}[{i}]".replace("[][", "["), v) for i, v in enumerate(found)]
    return []


def _all(content: Any, way: str, most: int | None = None) -> list[Any]:
    """All that is at a place, of each ``*`` the first entries alone; [] where there is nothing."""
    found = [content]
    for step in way.split(".") if way else ():
        below: list[Any] = []
        for value in found:
            if step == "*" and type(value) in (dict, list):
                below += [*(value.values() if type(value) is dict else value)][:most]
            elif type(value) is dict and step in value:
                below.append(value[step])
            elif type(value) is list and step.isdecimal() and int(step) < len(value):
                below.append(value[int(step)])
        found = below
    return found


def _first(content: Any, ways: Sequence[str]) -> Any:
    """The first value at some places that is no object; of one that was ticked its key."""
    for value in (v for way in ways for v in _all(content, way)):
        ticked = [k for k, v in value.items() if v] if type(value) is dict else [value]
        if ticked and ticked[0] not in (None, "") and (len(ways) < 2 or ticked[0] != []):
            return ticked[0]
    return None


def _of_address(text: str) -> str:
    path, _, query = text.partition("?")
    return _UPLOADED.sub("", unquote(query.removeprefix("d=") if query[:2] == "d=" else path))


def _may_be_points(value: Any) -> bool:
    return type(value) is not dict or bool(value.keys() & {"x", "cx", "all_points_x"})


def _runs(points: Any) -> list[list[Any]]:
    """Pairs of points, line by line, whichever way a tool writes them."""
    if type(points) is dict:
        xs, ys = points.get("all_points_x"), points.get("all_points_y")
        if type(xs) is list and type(ys) is list and len(xs) == len(ys):
            return [[list(pair) for pair in zip(xs, ys, strict=True)]]
        return [[[points.get("cx"), points.get("cy")] if "cx" in points else points]]
    if type(points) is not list or not points:
        return []
    if type(points[0]) in (int, float) or isinstance(points[0], float):
        return [[points[i : i + 2] for i in range(0, len(points), 2)]]
    nested = type(points[0]) is list and points[0] and type(points[0][0]) is list
    return [run if type(run) is list else [run] for run in points] if nested else [points]


def decode_lines(data: bytes, path: str, note: Callable[[InputError], None]) -> Any:
    """Decoded JSON; a list of the lines of a file with one value a line, damaged ones noted; VIA's
    CSV as its JSON. `AnnotationError` if it is damaged."""
    text = data.lstrip(_BLANK)
    if is_via_table(data):
        return _via_csv(text, path)
    lines = [(n, line.strip()) for n, line in enumerate(text.split(b"\n"), 1) if line.strip()]
    whole = sum(line[:1] + line[-1:] == b"{}" for _, line in lines)
    if text[:1] != b"[" and len(lines) > 1 and 2 * whole >= len(lines):
        found = []
        for n, line in lines:
            try:
                found.append(decode_strict(line, path=f"{path}: line {n}", error=AnnotationError))
            except AnnotationError as error:
                note(error)
        return found
    content = decode_strict(data, path=path, error=AnnotationError, parse_float=parse_number)
    is_one = type(content) is dict and ("data_row" in content or content.keys() >= {*_TASK})
    return [content] if is_one else content


def is_via_table(data: bytes) -> bool:
    """Return whether a file is VIA's CSV, damaged or not."""
    return data[:999].lstrip(_BLANK).replace(b", ", b",", 4).startswith(_VIA_HEADER)


def _via_csv(data: bytes, path: str) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for line, row in read_table(path, (*_VIA_REGION, "filename"), "export it from VIA", data)[1]:
        try:
            cells = [json.loads(row[key] or "{}") for key in _VIA_REGION]
        except ValueError as error:
            why = "expected JSON in the columns of regions"
            raise AnnotationError(path, why, place=f"line {line}") from error
        regions = found.setdefault(row["filename"], {"filename": row["filename"], "regions": []})
        regions["regions"].append({"shape_attributes": cells[0], "region_attributes": cells[1]})
    return found


_SOCCERTRACK = "soccertrack"
TOOLS: tuple[Tool, ...] = (
    Tool(
        "datumaro", "Datumaro JSON", "default.json", (("categories.label.labels", "items.*.id"),),
        ("items.*",), ("image.path", "media.path", "id"),
        ("annotations.*",), ("label_id",), ("points",), "type",
        ("image.size.1", "media.size.1"), ("image.size.0", "media.size.0"),
        names="categories.label.labels.*.name",
    ),
    Tool(
        "label-studio", "Label Studio JSON", "project-1.json",
        (("*.annotations", "*.data"), ("*.predictions", "*.data"), _TASK,
         ("*.*.*.original_width",)), ("*",),
        ("data.image", "data.img", "image", "img", "data.*"),
        ("result.*", "*.*"),
        ("value.keypointlabels.0", "value.vectorlabels.0", "value.polygonlabels.0",
         "value.labels.0", "keypointlabels.0", "vectorlabels.0", "polygonlabels.0", "from_name"),
        ("value.vertices", "vertices", "value.points", "points", "value", ""), "type",
        ("annotations.*.result.*.original_width", "*.*.original_width"),
        ("annotations.*.result.*.original_height", "*.*.original_height"), unit=100,
        annotations="annotations",
    ),
    Tool(
        "via", "VGG Image Annotator (VIA) 2, JSON or CSV", "via_project.json",
        (("_via_img_metadata",), ("*.filename", "*.regions")), ("_via_img_metadata.*", "*"),
        ("filename",), ("regions.*",),
        ("region_attributes.class", "region_attributes.label", "region_attributes.name",
         "region_attributes.*"), ("shape_attributes",), "shape_attributes.name",
    ),
    Tool(
        "labelbox", "Labelbox NDJSON", "export.ndjson",
        (("data_row", "projects"), ("*.data_row", "*.projects")), ("*",),
        ("data_row.external_id", "data_row.global_key", "data_row.id"),
        ("annotations.objects.*",), ("name",), ("line", "polygon", "point"),
        "", ("media_attributes.width",), ("media_attributes.height",),
        annotations="projects.*.labels",
    ),
    Tool(
        "fiftyone", "FiftyOne dataset", "samples.json",
        (("samples.*.filepath",), ("images.*.polylines",)), ("samples.*", "images.*"),
        ("filepath", "filename"), ("*.*.*",), ("label", "name"), ("points",), "_cls",
        ("metadata.width",), ("metadata.height",), unit=0, usual=(1920, 1080),
    ),
    Tool(
        _SOCCERTRACK, "SoccerTrack keypoints", "MATCH_keypoints.json", (), ("",), (), ("*",), (),
        (), usual=(6500, 1000),
    ),
    Tool(
        "tennis-keypoints", "TennisCourtDetector keypoints", "data_train.json",
        (("*.id", "*.kps"),), ("*",), ("id",), ("kps",), (), ("",), usual=(1280, 720),
        template="tennis_14",
    ),
)  # fmt: skip
