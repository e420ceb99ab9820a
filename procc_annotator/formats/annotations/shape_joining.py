"""Join several shapes of one class into the single polyline an annotation can hold.

Pieces that plainly are parts of one course are joined, with a remark. Where joining would be a
guess, the frame is refused with an explanation. Classes without geometry (``Line unknown``) may
well occur several times: their shapes stay apart, as ``Line unknown``, ``Line unknown (2)``.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.arrays import FloatArray
from procc_annotator.errors import AnnotationError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.exchange import ReadContext, Size, normalised
from procc_annotator.formats.annotations.soccernet import CAMERA_KEY, MAX_COORDINATE, may_be_points
from procc_annotator.formats.strict_json import is_finite_number, json_kind, json_repr, printable

# Ends this near each other, in widths or heights of the picture, are one place clicked twice.
_TOUCH = 0.002
# What a lens may bend a straight line by, as a share of its length: plenty for broadcast cameras.
_BOW = 0.05
# How far clicks may lie next to the bent line, as a share of the picture's longer side.
_BESIDE = 0.005
_USUAL_SIZE = (1920, 1080)  # where nobody knows the picture's
_NUMBERED = re.compile(r"(.*) \((\d{1,4})\)")

Points = tuple[Point, ...]


class ShapeCollector:
    """The shapes of one frame as they come, in the order of the file.

    Attributes:
        size: of the frame's picture, px; the usual one if unknown.
    """

    def __init__(
        self, path: str, place: str, reading: ReadContext, size: Size | None, frame: str
    ) -> None:
        self.path, self.frame = path, frame
        self._place = place
        self.reading = reading
        self._field = reading.field
        self.size = size or _USUAL_SIZE
        self._shapes: list[tuple[str, Points]] = []

    def error(
        self, problem: str, place: str, advice: str = "correct or remove the point"
    ) -> AnnotationError:
        """The error for a place in the file."""
        return AnnotationError(self.path, problem, place=place, advice=advice)

    def remark(self, what: str) -> None:
        """Note what is left out of the frame."""
        self.reading.remarks.add(what, self.frame)

    def point(self, x: Any, y: Any, place: str) -> Point:
        """The point of a pixel position.

        Raises:
            AnnotationError: no finite numbers, or absurdly far from the picture.
        """
        values = []
        for axis, value, length in zip("xy", (x, y), self.size, strict=True):
            # A float with more digits than usual is a float all the same.
            plain = float(value) if isinstance(value, float) else value
            if not is_finite_number(plain) or abs(plain) > MAX_COORDINATE * (length - 1):
                expected = f"{axis} in px of a picture of {self.size[0]}x{self.size[1]}"
                raise self.error(f"expected {expected}, found {json_repr(value)}", place)
            values.append(normalised(value, length - 1))
        return Point(values[0], values[1])

    def takes(self, kind: object, lines: Collection[str]) -> bool:
        """Return whether shapes of a kind are lines or points; polygons, and what is left out, are
        noted."""
        if kind == "polygon":
            self.remark("polygons are taken for open lines through their points")
        elif type(kind) is not str or kind not in lines:
            what = printable(kind) if type(kind) is str else json_kind(kind)
            self.remark(f"shapes of the type {what} are left out")
            return False
        return True

    def course(self, pairs: Sequence[Any], place: str) -> Points:
        """The points of pairs [x, y]. `AnnotationError` if they are none."""
        found = []
        for i, pair in enumerate(pairs):
            at = f"{place}[{i}]"
            if type(pair) is not list or len(pair) != 2:
                raise self.error(f"expected a point [x, y], found {json_kind(pair)}", at)
            found.append(self.point(pair[0], pair[1], at))
        return tuple(found)

    def add(self, label: Any, points: Points, place: str) -> None:
        """One more shape. `AnnotationError` if the label cannot be a class."""
        if type(label) is not str or label == CAMERA_KEY:
            found = json_kind(label) if type(label) is not str else repr(label)
            raise self.error(
                f"expected the name of a class, found {found}",
                place,
                "name the shape after a class",
            )
        self._shapes.append((label, points))

    def annotation(self, extra: tuple[tuple[str, Any], ...] = ()) -> FrameAnnotation:
        """The frame's annotation.

        Raises:
            AnnotationError: shapes of one class that cannot be joined without a guess.
        """
        polylines: list[Polyline] = []
        by_class: dict[str, list[Points]] = {}
        for name, points in self.reading.classed(self._shapes, self.frame):
            by_class.setdefault(name, []).append(points)
        taken = set(by_class)
        for name, pieces in by_class.items():
            if len(pieces) == 1:
                polylines.append(Polyline(name, pieces[0]))
            elif self._field.element(name) is None:
                self.remark("shapes of one unknown class stay apart, numbered")
                polylines.extend(_separate_labels(name, pieces, taken))
            else:
                polylines.append(Polyline(name, self._join(name, pieces)))
                self.remark("shapes of one class were joined end to end")
        return FrameAnnotation(tuple(polylines), extra)

    def _join(self, name: str, pieces: list[Points]) -> Points:
        element = self._field.element(name)
        joined = join_shapes(
            pieces, self.size, straight=element is not None and element.is_straight
        )
        if joined is None:
            raise self.error(
                f"{len(pieces)} shapes are called {printable(name)!r} and do not continue one"
                " another, expected one polyline a class",
                self._place,
                "make one shape of them, or remove the wrong ones; the frame is left out",
            )
        return joined


def join_shapes(pieces: list[Points], size: Size, *, straight: bool) -> Points | None:
    """One polyline with all clicks of the pieces, or None where that would be a guess.

    Single points are joined in their order. Pieces of a straight element are joined along their
    line unless they overlap there or do not lie on one; pieces of a curved one where their ends
    touch.
    """
    pieces = [piece for piece in pieces if piece]
    if not pieces:
        return ()
    if all(len(piece) == 1 for piece in pieces):
        return tuple(point for piece in pieces for point in piece)
    return _along_line(pieces, size) if straight else _end_to_end(pieces)


def labels_for(polylines: tuple[Polyline, ...], field: Field) -> list[str]:
    """Return what shapes are called where a class may have several: ``Line unknown (2)`` is ``Line
    unknown`` again if reading would number it the same way."""
    labels: list[str] = []
    met: dict[str, int] = {}
    for polyline in polylines:
        name = polyline.class_name
        found = _NUMBERED.fullmatch(name)
        if found and field.element(found[1]) is None and met.get(found[1], 0) == int(found[2]) - 1:
            name = found[1]
        met[name] = met.get(name, 0) + 1
        labels.append(name)
    return labels


def extra_of(value: Any, path: str, place: str, field: Field) -> tuple[tuple[str, Any], ...]:
    """Further entries of an annotation, kept under a key of their own in foreign files.
    `AnnotationError` for no object, or an entry that an annotation file would take for a class."""
    if value is None:
        return ()
    wrong = None if type(value) is dict else json_kind(value)
    if wrong is None:
        for key, entry in value.items():
            if field.knows(field.canonical_name(key)) or may_be_points(entry) or key == CAMERA_KEY:
                wrong = f"the entry {printable(key)!r}"
    if wrong is not None:
        raise AnnotationError(
            path,
            f"expected an object of entries next to the classes, found {wrong}",
            place=place,
            advice="remove this key",
        )
    return tuple(value.items())


def _separate_labels(name: str, pieces: list[Points], taken: set[str]) -> list[Polyline]:
    found = [Polyline(name, pieces[0])]
    number = 2
    for points in pieces[1:]:
        while f"{name} ({number})" in taken:
            number += 1
        found.append(Polyline(f"{name} ({number})", points))
        taken.add(f"{name} ({number})")
    return found


def _along_line(pieces: list[Points], size: Size) -> Points | None:
    extent = np.array(size, dtype=np.float64) - 1
    px = [np.array([(p.u, p.v) for p in piece], dtype=np.float64) * extent for piece in pieces]
    everything = np.concatenate(px)
    middle = everything.mean(axis=0)
    _, _, axes = np.linalg.svd(everything - middle, full_matrices=False)
    if not _is_one_line(*((everything - middle) @ axes.T).T, beside_px=_BESIDE * max(size)):
        return None
    along = [points @ axes[0] for points in px]
    if along[0][-1] < along[0][0]:  # the first piece of the file keeps its direction
        along = [-t for t in along]
    order = sorted(range(len(pieces)), key=lambda i: float(along[i].min()))
    for before, after in pairwise(order):
        if along[before].max() > along[after].min() + _TOUCH * max(size):
            return None
    return _without_repeats(
        [pieces[i] if along[i][-1] >= along[i][0] else pieces[i][::-1] for i in order]
    )


def _is_one_line(along: FloatArray, across: FloatArray, *, beside_px: float) -> bool:
    """Return whether points lie on one line, straight or bent a little by a lens; px."""
    length = float(np.ptp(along))
    if length <= beside_px:
        return True
    bent = np.polynomial.Polynomial.fit(along, across, 2)
    beside = np.abs(across - bent(along)).max()
    return bool(beside <= beside_px and np.abs(across).max() <= max(beside_px, _BOW * length))


def _end_to_end(pieces: list[Points]) -> Points | None:
    chain = [pieces[0]]
    waiting = pieces[1:]
    while waiting:
        found = _next_link(chain, waiting)
        if found is None:
            return None
        index, piece, at_end = found
        chain.insert(len(chain) if at_end else 0, piece)
        del waiting[index]
    return _without_repeats(chain)


def _next_link(chain: list[Points], waiting: list[Points]) -> tuple[int, Points, bool] | None:
    first, last = chain[0][0], chain[-1][-1]
    for index, piece in enumerate(waiting):
        for turned in (piece, piece[::-1]):
            if _touch(last, turned[0]):
                return index, turned, True
            if _touch(first, turned[-1]):
                return index, turned, False
    return None


def _touch(a: Point, b: Point) -> bool:
    return max(abs(a.u - b.u), abs(a.v - b.v)) <= _TOUCH


def _without_repeats(pieces: list[Points]) -> Points:
    """All points in order; a point where two pieces meet exactly is there once."""
    points = list(pieces[0])
    for piece in pieces[1:]:
        points.extend(piece[1:] if points[-1] == piece[0] else piece)
    return tuple(points)
