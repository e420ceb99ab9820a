"""Annotations of labelling tools that are read and not written: a row of `TOOLS` each.

A row says how its files are recognised and where pictures, shapes and labels stand in them; all
else (names of frames, sizes, joining, remarks) is common. Facts: the export pages of Datumaro,
Label Studio, VIA 2 and 3, Labelbox and FiftyOne; https://github.com/AtomScott/SoccerTrack-v2
(keypoints in metres from the far left corner, y towards the camera) and TennisCourtDetector (14
keypoints of pictures of 1280x720).
"""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from procc_annotator.annotation import Point
from procc_annotator.errors import AnnotationError
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.formats.annotations.exchange import ExchangedFrame, ReadContext, Size
from procc_annotator.formats.annotations.label_map import template_named
from procc_annotator.formats.annotations.shape_joining import ShapeCollector
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.frame_names import picture_name
from procc_annotator.formats.strict_json import (
    decode_strict,
    json_kind,
    parse_number,
    printable,
)
from procc_annotator.messages import pluralize

LINE, POLYGON, POINT = "polyline", "polygon", "point"
_TENNIS = "tennis_14"
_ON_ELEMENT_M = 0.06  # a line's middle lies up to half its width from its edge
_SPACING_M = 0.05
_PLACE = re.compile(r"\(\s*([-+0-9.eE]+)\s*,\s*([-+0-9.eE]+)\s*\)", re.ASCII)


class Shape(NamedTuple):
    """A shape of a picture.

    Attributes:
        label: what its tool calls it.
        kind: one of `LINE`, `POLYGON`, `POINT`; any other one is left out and named.
        points: pairs of numbers, in px or in the unit of the row.
        place: in the file.
    """

    label: Any
    kind: str
    points: list[Any]
    place: str


class Picture(NamedTuple):
    """A picture of a file: its name, its shapes, and its size where the file says it."""

    name: Any
    place: str
    shapes: Iterable[Shape]
    width: Any = None
    height: Any = None


@dataclass(frozen=True)
class Tool:
    """A format of a labelling tool.

    Attributes:
        name, title: as of `AnnotationFormat`.
        example: a usual name of its file. keys: by which it is recognised, for the documentation.
        sniff: whether decoded content is of this tool.
        pictures: the pictures of decoded content; the second argument is the file's frame.
        unit: 1 for pixels, 100 for percent of the picture, 0 for shares of it.
        usual: the size of its pictures where neither the file nor a picture says it.
        template: of whose keypoints the points of a shape are, in their order.
        in_metres: whether labels are places of the field, in metres from its far left corner.
    """

    name: str
    title: str
    example: str
    keys: str
    sniff: Callable[[Any], bool]
    pictures: Callable[[Any, str], Iterator[Picture]]
    unit: float = 1
    usual: Size | None = None
    template: str = ""
    in_metres: bool = False

    def read_many(
        self, source: FileSource, files: Sequence[str], reading: ReadContext
    ) -> Iterator[ExchangedFrame]:
        """Every picture that has a shape."""
        for name in files:
            with reading.going_on():
                path = source.display(name)
                frame = reading.frame_of_file(name)
                content = decode_lines(source.read(name), path)
                pictures = list(self.pictures(content, frame.rpartition("/")[2]))
                reading.begin(name, (picture.name for picture in pictures))
                reading.total = (reading.total or 0) + len(pictures)
                for picture in pictures:
                    with reading.going_on():
                        found = self._read(picture, path, reading)
                        if found is not None:
                            yield found

    def _read(self, picture: Picture, path: str, reading: ReadContext) -> ExchangedFrame | None:
        frame = reading.frame_of_picture(picture.name, path, picture.place)
        shapes = list(picture.shapes)
        if not shapes:
            return None
        where = f"{picture.place}: size"
        if self.usual and picture.width is None and reading.size_of(frame) is None:
            size = self.usual
            usual = f"{size[0]}x{size[1]}"
            reading.remarks.add(f"the file tells no size of its pictures: {usual} is taken", frame)
        else:
            size = reading.size_in_file(picture.width, picture.height, path, where)
        pieces = ShapeCollector(path, picture.place, reading, size, frame)
        taken = [self._add(pieces, shape) for shape in shapes]
        if self.in_metres:
            taken = [_add_places(pieces, shapes)]
        if not any(taken):
            return None
        return ExchangedFrame(frame, pieces.annotation(), size, picture_name(str(picture.name)))

    def _add(self, pieces: ShapeCollector, shape: Shape) -> bool:
        if shape.kind not in (LINE, POLYGON, POINT):
            pieces.remark(f"shapes of the type {printable(str(shape.kind))} are left out")
            return False
        if shape.kind == POLYGON:
            pieces.remark("polygons are taken for open lines through their points")
        template = template_named(self.template)
        points = [
            None if template is not None and pair in (None, [-1, -1])
            else self._point(pieces, pair, f"{shape.place}[{i}]")
            for i, pair in enumerate(shape.points)
        ]  # fmt: skip
        if self.in_metres:
            return True
        if template is None:
            pieces.add(shape.label, tuple(p for p in points if p is not None), shape.place)
            return True
        if len(points) != template.count:
            problem = f"expected {template.count} keypoints, found {len(points)}"
            raise pieces.error(problem, shape.place)
        pieces.remark(f"keypoints ({template.title}) are points of the elements they lie on")
        if not template.is_of(pieces.reading.field):
            pieces.remark(f"their field is another one: --field {template.field}")
        for name, some in template.shapes(points):
            pieces.add(name, some, shape.place)
        return True

    def _point(self, pieces: ShapeCollector, pair: Any, place: str) -> Point:
        if isinstance(pair, Mapping):
            pair = [pair.get("x"), pair.get("y")]
        if type(pair) not in (list, tuple) or len(pair) != 2:
            raise pieces.error(f"expected a point of two numbers, found {json_kind(pair)}", place)
        if self.unit != 1:
            whole = self.unit or 1.0
            if not all(type(v) is int or isinstance(v, float) for v in pair):
                raise pieces.error("expected a point of two numbers", place)
            pair = [v / whole * n for v, n in zip(pair, pieces.size, strict=True)]
        return pieces.point(pair[0], pair[1], place)


def _add_places(pieces: ShapeCollector, shapes: Sequence[Shape]) -> bool:
    """Make keypoints at places of the field points of every element that they lie on, in their
    order along it."""
    field = pieces.reading.field
    places = np.array([[*map(float, _PLACE.fullmatch(s.label).groups())] for s in shapes])  # type: ignore[union-attr]
    px = np.array([[*map(float, shape.points[0])] for shape in shapes])
    samples = sample_evenly(field, _SPACING_M)
    half = np.abs(samples.points_world[:, :2]).max(axis=0)
    if places.min() > -_ON_ELEMENT_M:  # from a corner
        places = places - half
    design = np.column_stack((places, np.ones(len(places))))
    turn = np.linalg.lstsq(design, px, rcond=None)[0][:2]
    if np.linalg.det(turn) < 0:  # a camera above the ground sees y as x, y towards it
        places = places * (1, -1)
        pieces.remark("places count y away from the camera: turned")
    used = np.zeros(len(shapes), bool)
    for i, element in enumerate(field.elements):
        own = samples.of(i)
        if element.optional or not element.on_ground:
            continue
        apart = np.linalg.norm(places[:, None] - own[:, :2], axis=2)
        nearest, near = apart.argmin(axis=1), apart.min(axis=1) < _ON_ELEMENT_M
        order = [k for k in np.argsort(nearest, kind="stable") if near[k]]
        if len(order) > (2 if element.is_curved else 0):  # two say nothing of a curve
            points = [
                pieces.point(px[k, 0].item(), px[k, 1].item(), shapes[k].place) for k in order
            ]
            pieces.add(element.name, tuple(points), shapes[order[0]].place)
            used |= near
    pieces.remark("keypoints at places of the field are points of the elements they lie on")
    if not used.all():
        first = printable(shapes[int(np.argmin(used))].label)
        left = pluralize(int((~used).sum()), "place")
        pieces.remark(f"{left} on no element of the field left out (first: {first})")
    return bool(used.any())


def decode_lines(data: bytes, path: str) -> Any:
    """Decoded JSON; a list of the lines of a file with one value a line; VIA's CSV as its JSON.

    Raises:
        AnnotationError: damaged.
    """
    text = data.lstrip(b"\xef\xbb\xbf \t\r\n")
    if text[:1] != b"{" and text.replace(b", ", b",", 4).startswith(_VIA_HEADER):
        return _via_csv(text, path)
    lines = [(n, line) for n, line in enumerate(data.splitlines(), 1) if line.strip()]
    if len(lines) > 1 and all(x[:1] + x.rstrip()[-1:] == b"{}" for _, x in lines):
        return [decode_strict(x, path=f"{path}: line {n}", error=AnnotationError) for n, x in lines]
    return decode_strict(data, path=path, error=AnnotationError, parse_float=parse_number)


def _dicts(value: Any) -> list[dict[str, Any]]:
    """The objects of a list, or of the values of an object; [] for anything else."""
    values = list(value.values()) if type(value) is dict else value
    return [v for v in values if type(v) is dict] if type(values) is list else []


def _pairs(flat: Any) -> list[Any]:
    """[x, y, x, y, ...] as pairs; anything else as it is, for the reader of points to refuse."""
    is_flat = type(flat) is list and len(flat) % 2 == 0
    return [flat[i : i + 2] for i in range(0, len(flat), 2)] if is_flat else [flat]


def _datumaro(content: Any, _: str) -> Iterator[Picture]:
    labels = [entry.get("name") for entry in _dicts(content["categories"]["label"]["labels"])]

    def named(number: Any) -> Any:
        return labels[number] if type(number) is int and 0 <= number < len(labels) else None

    def shapes(item: dict[str, Any], place: str) -> Iterator[Shape]:
        for j, entry in enumerate(_dicts(item.get("annotations"))):
            kind, label = str(entry.get("type")), named(entry.get("label_id"))
            points, at = _pairs(entry.get("points")), f"{place}.annotations[{j}].points"
            if kind == "skeleton":
                for one in _dicts(entry.get("elements")):
                    yield Shape(named(one.get("label_id")), POINT, _pairs(one.get("points")), at)
                continue
            seen = entry.get("visibility")
            if kind == "points" and type(seen) is list and len(seen) == len(points):
                points = [p for p, v in zip(points, seen, strict=True) if v]
            yield Shape(label, POINT if kind == "points" else kind, points, at)

    for i, item in enumerate(_dicts(content.get("items"))):
        image = item.get("image") or item.get("media") or {}
        size = image.get("size")
        height, width = size if type(size) is list and len(size) == 2 else (None, None)
        name = image.get("path") or item.get("id")
        yield Picture(name, f"items[{i}]", shapes(item, f"items[{i}]"), width, height)


_STUDIO = {"vectorlabels": LINE, "vector": LINE, "polygonlabels": POLYGON, "polygon": POLYGON,
           "keypointlabels": POINT, "keypoint": POINT}  # fmt: skip
_UPLOADED = re.compile(r"[0-9a-f]{8}-(?=.)")


def _label_studio(content: Any, _: str) -> Iterator[Picture]:
    for i, task in enumerate(_dicts(content)):
        data = task["data"] if type(task.get("data")) is dict else task
        urls = [data.get(k) for k in ("image", "img", "photo", *data)]
        url = next((u for u in urls if type(u) is str and "." in picture_name(u)), None)
        name = picture_name(url.rpartition("?d=")[2]) if url else url
        name = _UPLOADED.sub("", name, count=1) if name and url and "upload" in url else name
        done = [a for a in _dicts(task.get("annotations")) if not a.get("was_cancelled")]
        if done:
            results = _dicts(done[0].get("result"))
        else:  # JSON-MIN: lists of values under the names of their tags
            results = [v for entries in data.values() if type(entries) is list
                       for v in _dicts(entries)]  # fmt: skip
        size = next((r for r in results if "original_width" in r), {})
        sides = size.get("original_width"), size.get("original_height")
        yield Picture(name, f"[{i}]", _studio_shapes(results, f"[{i}]"), *sides)


def _studio_shapes(results: list[dict[str, Any]], place: str) -> Iterator[Shape]:
    for j, result in enumerate(results):
        value = result["value"] if type(result.get("value")) is dict else result
        kind = result.get("type") or next((k for k in _STUDIO if k in value), "rectanglelabels")
        if kind in ("choices", "relation", "labels", "textarea", "number"):
            continue
        labels = value.get(kind) or value.get("labels") or result.get("from_name")
        label = labels[0] if type(labels) is list and labels else labels
        vertices = value.get("vertices", value.get("points"))
        points = vertices if type(vertices) is list else [[value.get("x"), value.get("y")]]
        yield Shape(label, _STUDIO.get(str(kind), str(kind)), points, f"{place}.result[{j}]")


_VIA_HEADER = b"filename,file_size,file_attributes,region_count,region_id"
_VIA_SHAPES = {1: POINT, 2: "rect", 3: "circle", 4: "ellipse", 5: LINE, 6: LINE, 7: POLYGON}


def _via_csv(text: bytes, path: str) -> dict[str, Any]:
    found: dict[str, Any] = {}
    reader = csv.DictReader(io.StringIO(text.decode("utf-8", "replace")), skipinitialspace=True)
    for row in reader:
        try:
            shape, named = (
                json.loads(row.get(k) or "{}") for k in ("region_shape_attributes",
                                                         "region_attributes")
            )  # fmt: skip
        except ValueError as error:
            place, why = f"line {reader.line_num}", "expected JSON in the columns of regions"
            raise AnnotationError(path, why, place=place) from error
        name = str(row.get("filename"))
        picture = found.setdefault(name, {"filename": name, "regions": []})
        if shape:
            picture["regions"].append({"shape_attributes": shape, "region_attributes": named})
    return found


def _is_via(content: Any) -> bool:
    if type(content) is dict and "file" in content and "metadata" in content:
        return any("fname" in entry for entry in _dicts(content["file"]))
    own = content.get("_via_img_metadata", content) if type(content) is dict else None
    return any("filename" in e and "regions" in e for e in _dicts(own)[:20])


def _via(content: Any, _: str) -> Iterator[Picture]:
    if "_via_img_metadata" not in content and "metadata" in content:
        files, views = content["file"], content.get("view", {})
        entries: dict[str, list[Shape]] = {}
        for key, entry in content["metadata"].items():
            view = views.get(entry.get("vid"), {}).get("fid_list", [entry.get("vid")])
            kind, *flat = entry.get("xy") or [0]
            label = _only(entry.get("av"))
            shape = Shape(label, _VIA_SHAPES.get(kind, str(kind)), _pairs(flat), f"metadata.{key}")
            entries.setdefault(str(view[0]), []).append(shape)
        for key, file in files.items():
            yield Picture(file.get("fname"), f"file.{key}", entries.get(str(key), []))
        return
    for i, entry in enumerate(_dicts(content.get("_via_img_metadata", content))):
        place = f"picture {i + 1}"
        yield Picture(entry.get("filename"), place, _via_shapes(entry, place))


def _via_shapes(entry: dict[str, Any], place: str) -> Iterator[Shape]:
    for j, region in enumerate(_dicts(entry.get("regions"))):
        own = region.get("shape_attributes") or {}
        kind, label = str(own.get("name")), _only(region.get("region_attributes"))
        points = [[own.get("cx"), own.get("cy")]]
        if kind != POINT:
            xs, ys = own.get("all_points_x") or [], own.get("all_points_y") or []
            points = [list(pair) for pair in zip(xs, ys, strict=len(xs) != len(ys))]
        yield Shape(label, kind, points, f"{place}.regions[{j}]")


def _only(attributes: Any) -> Any:
    """The label among the attributes of a region: the likeliest of them, ticked or written."""
    own = attributes if type(attributes) is dict else {}
    key = next((k for k in ("class", "label", "name", "type", "element") if own.get(k)), None)
    value = own[key] if key else next((v for v in own.values() if v), None)
    return next((k for k, v in value.items() if v), None) if type(value) is dict else value


def _labelbox(content: Any, _: str) -> Iterator[Picture]:
    for i, row in enumerate([content] if type(content) is dict else _dicts(content)):
        data, media = row.get("data_row") or {}, row.get("media_attributes") or {}
        name = data.get("external_id") or data.get("global_key") or data.get("id")
        labels = [one for p in _dicts(row.get("projects")) for one in _dicts(p.get("labels"))]
        objects = _dicts((labels[0].get("annotations") or {}).get("objects")) if labels else []
        place = f"line {i + 1}"
        sides = media.get("width"), media.get("height")
        yield Picture(name, place, _box_shapes(objects, place), *sides)


def _box_shapes(objects: list[dict[str, Any]], place: str) -> Iterator[Shape]:
    for j, entry in enumerate(objects):
        kind = next((k for k in ("line", "polygon", "point") if k in entry), None)
        points = entry.get(kind) if kind else None
        yield Shape(
            entry.get("name"), {"line": LINE}.get(str(kind), kind or "box or mask"),
            points if type(points) is list else [points], f"{place}: objects[{j}]",
        )  # fmt: skip


def _is_places(content: Any) -> bool:
    return (
        type(content) is dict
        and len(content) > 2
        and all(_PLACE.fullmatch(key) and type(v) is list for key, v in content.items())
    )


def _places(content: Any, frame: str) -> Iterator[Picture]:
    yield Picture(frame, "", [Shape(key, POINT, [pair], key) for key, pair in content.items()])


def _is_keypoints(content: Any) -> bool:
    return any("kps" in entry and "id" in entry for entry in _dicts(content)[:20])


def _keypoints(content: Any, _: str) -> Iterator[Picture]:
    for i, entry in enumerate(_dicts(content)):
        points = entry.get("kps")
        shape = Shape("court", POINT, points if type(points) is list else [points], f"[{i}].kps")
        yield Picture(str(entry.get("id")), f"[{i}]", [shape])


def _is_fiftyone(content: Any) -> bool:
    own = content if type(content) is dict else {}
    samples = _dicts(own.get("samples"))[:20]
    return any("filepath" in s for s in samples) or any(
        "polylines" in i or "keypoints" in i for i in _dicts(own.get("images"))[:20]
    )


def _fiftyone(content: Any, _: str) -> Iterator[Picture]:
    samples = _dicts(content.get("samples", content.get("images")))
    for i, sample in enumerate(samples):
        size, place = sample.get("metadata") or {}, f"samples[{i}]"
        shapes: list[Shape] = []
        for key, value in sample.items():
            for kind in ("polylines", "keypoints"):
                found = value.get(kind) if type(value) is dict else None
                for entry in _dicts(found):
                    points = entry.get("points")
                    runs = points if kind == "polylines" and type(points) is list else [points]
                    label = entry.get("label") or entry.get("name")
                    shapes += (
                        Shape(label, LINE, run if type(run) is list else [run], f"{place}.{key}")
                        for run in runs
                    )
        name = sample.get("filepath", sample.get("filename"))
        yield Picture(name, place, shapes, size.get("width"), size.get("height"))


TOOLS: tuple[Tool, ...] = (
    Tool(
        "datumaro", "Datumaro JSON", "default.json", "items[].annotations, categories.label",
        lambda c: type(c) is dict and type(c.get("items")) is list and "label" in c.get(
            "categories", ()), _datumaro,
    ),
    Tool(
        "label-studio", "Label Studio JSON", "project-1.json",
        "[].annotations[].result", lambda c: type(c) is list and any(
            {"data", "annotations"} <= t.keys() or any(
                "original_width" in v for x in t.values() for v in _dicts(x)[:1] if type(x) is list
            ) for t in _dicts(c)[:20]), _label_studio, unit=100,
    ),
    Tool(
        "via", "VGG Image Annotator (VIA), JSON or CSV", "via_project.json",
        "_via_img_metadata, regions[]", _is_via, _via,
    ),
    Tool(
        "labelbox", "Labelbox NDJSON", "export.ndjson", "data_row, projects",
        lambda c: any({"data_row", "projects"} <= r.keys() for r in _dicts(
            [c] if type(c) is dict else c)[:20]), _labelbox,
    ),
    Tool(
        "fiftyone", "FiftyOne dataset", "samples.json", "samples[].filepath", _is_fiftyone,
        _fiftyone, unit=0, usual=(1920, 1080),
    ),
    Tool(
        "soccertrack", "SoccerTrack keypoints", "MATCH_keypoints.json", '"(x, y)": [u, v]',
        _is_places, _places, usual=(6500, 1000), in_metres=True,
    ),
    Tool(
        "tennis-keypoints", "TennisCourtDetector keypoints", "data_train.json", "[].id, [].kps",
        _is_keypoints, _keypoints, usual=(1280, 720), template=_TENNIS,
    ),
)  # fmt: skip
