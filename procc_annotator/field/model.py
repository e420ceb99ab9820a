"""The Field as data: elements and their appearance, landmarks, symmetries, cameras, stadiums."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from dataclasses import field as dataclass_field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.dimensions import Dimension, Relation
from procc_annotator.field.geometry import (
    Covariance,
    Geometry,
    Line,
    Spot,
    Vector,
    is_on_ground,
    rotated,
    same_geometry,
)
from procc_annotator.messages import pluralize

# A painted band with ground on both its sides; the border of an area or of a wall, where one side
# differs from the other; something that stands before anything; nothing that could be found.
LINE, EDGE, BAR, NOTHING = KINDS = "line", "edge", "bar", "nothing"
# The paint against what is next to it.
LIGHTER, DARKER, ANY = TONES = "lighter", "darker", "any"
WHITE, BLACK = "white", "black"
RED, ORANGE, YELLOW, BLUE = "red", "orange", "yellow", "blue"
COLOURS = WHITE, BLACK, RED, ORANGE, YELLOW, BLUE, ANY


@dataclass(frozen=True, slots=True)
class Appearance:
    """Look of an element's line marking, as far as its rules say.

    Attributes:
        kind: one of `KINDS`.
        tone: of the paint against the ground next to it, one of `TONES`.
        colour: of the paint, one of `COLOURS`.
        width_m: of the painted band, or the diameter of a bar; 0 if unknown.
    """

    kind: str = LINE
    tone: str = ANY
    colour: str = ANY
    width_m: float = 0.0


ANY_LINE = Appearance()


# sRGB to XYZ under D65 (IEC 61966-2-1).
_XYZ_FROM_RGB = np.array(
    [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
)
_WHITE = np.array([0.9505, 1.0, 1.089])
_LAB_EPSILON, _LAB_KAPPA = 216 / 24389, 24389 / 27


def colour_difference(one: str, other: str) -> float:
    """The distance of two colours ``#rrggbb`` in CIE L*a*b* (1976): about 2 can just be seen."""
    return float(np.linalg.norm(_lab(one) - _lab(other)))


def linear_rgb(colour: str) -> NDArray[np.float64]:
    """(3,) the light of a colour ``#rrggbb``, 0 to 1 each (sRGB made linear)."""
    rgb = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    return np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)


def hex_colour(linear: NDArray[np.float64]) -> str:
    """The colour ``#rrggbb`` of (3,) linear light; what is out of 0 to 1 is cut."""
    light = np.clip(linear, 0.0, 1.0)
    rgb = np.where(light <= 0.0031308, light * 12.92, 1.055 * light ** (1 / 2.4) - 0.055)
    return "#" + "".join(f"{round(255 * float(part)):02x}" for part in rgb)


def _lab(colour: str) -> NDArray[np.float64]:
    xyz = _XYZ_FROM_RGB @ linear_rgb(colour) / _WHITE
    x, y, z = np.where(xyz > _LAB_EPSILON, np.cbrt(xyz), (_LAB_KAPPA * xyz + 16) / 116)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


# Where the elements of a field lie: where the rules measure them, or in the middle of their paint.
MEASURED_LINE, MIDDLE_LINE = LINE_POSITIONS = "measured", "middle"
_SAME_TURN_RAD = 1e-6
_SIDE_NAMES = ("length", "width")  # told as "105 x 68 m"


@dataclass(frozen=True, slots=True)
class Element:
    """One field element, i.e. one annotation class.

    Attributes:
        name: exact class name in files.
        title: shown to people.
        group: what it belongs to, shown to people.
        colour: ``#rrggbb``.
        shortcut: key (sequence) that selects it; "" for none.
        geometry: where it is.
        optional: whether it is judged only where a person annotated it: a mark or a landmark that
            a set need not have. It is never a false positive, and the ``soccernet`` protocol, which
            knows the official classes only, leaves it out.
        line_width: metres of paint; 0 where nothing is painted (a post, a net).
        inside: a place on that side of the element on which the paint lies, where the rules measure
            at the paint's outer edge; None where they measure at its middle. Of a chain it is
            next to the part that is nearest to it; on the other parts the paint lies on the same
            hand of a person who walks along it.
        appearance: what a finder of paint looks for; no part of what the field is.
    """

    name: str
    title: str
    group: str
    colour: str
    shortcut: str
    geometry: Geometry
    optional: bool = False
    line_width: float = 0.0
    inside: Vector | None = None
    appearance: Appearance = dataclass_field(default=ANY_LINE, compare=False)

    @property
    def is_straight(self) -> bool:
        """Return whether it is one straight line."""
        return isinstance(self.geometry, Line)

    @property
    def is_spot(self) -> bool:
        """Return whether it is a single place, annotated with one click."""
        return isinstance(self.geometry, Spot)

    @property
    def is_curved(self) -> bool:
        """Return whether it runs other than straight: an arc, a circle, a chain."""
        return not (self.is_straight or self.is_spot)

    @property
    def on_ground(self) -> bool:
        """Return whether the whole element lies on the plane z = 0."""
        return is_on_ground(self.geometry)


@dataclass(frozen=True, slots=True)
class Landmark:
    """A place that can be clicked, in the frame of the field.

    Attributes:
        name: exact class name in files.
        title: shown to people; "" for the name.
        position: metres, world frame (z down); None until it is known.
        covariance: (3, 3) m^2 of the position; None if unknown.
        instant: when a moving object was there, as frames are grouped; None for what stays.
        moving: whether it has another position each instant.
        surveyed: whether a person gave the position; triangulated otherwise.
        colour: ``#rrggbb``; "" for one of its own choosing.
        shortcut: key that selects it; "" for none.
        note: for people.
        frames: those it was triangulated from.
        extra: keys of the file that we do not know.
    """

    name: str
    title: str = ""
    position: Vector | None = None
    covariance: Covariance | None = None
    instant: str | None = None
    moving: bool = False
    surveyed: bool = True
    colour: str = ""
    shortcut: str = ""
    note: str = ""
    frames: tuple[str, ...] = ()
    extra: tuple[tuple[str, Any], ...] = dataclass_field(default=(), hash=False)

    @property
    def shown_title(self) -> str:
        """Return what people call it."""
        return self.title or self.name.strip()


@dataclass(frozen=True)
class Symmetry:
    """A turn about the vertical through the centre that takes the field to itself.

    Attributes:
        turn_rad: from +x towards +y.
        partner: element name -> the element it becomes.
    """

    turn_rad: float
    partner: Mapping[str, str]

    def name_of(self, class_name: str) -> str:
        """The class that a label becomes on the turned field; those without a partner stay."""
        return self.partner.get(class_name, class_name)


@dataclass(frozen=True, slots=True)
class CameraPlacement:
    """Camera-placement prior of a sport, metres: from the edge of the field, and above the ground.

    Each is (least, usual, most). ``ceiling`` is the height of cameras under the roof that look
    down; 0 where there are none.
    """

    distance: tuple[float, float, float]
    height: tuple[float, float, float]
    ceiling: float = 0.0


@dataclass(frozen=True)
class Stadiums:
    """The stadiums that frames of one set were taken in.

    Attributes:
        frames: frame -> its stadium.
        dimensions: stadium -> metres by name; dimensions that it does not name are the field's.
    """

    frames: Mapping[str, str]
    dimensions: Mapping[str, Mapping[str, float]]


@dataclass(frozen=True)
class PixelAspect:
    """The width of a picture's pixels over their height.

    Attributes:
        value: 1 for square ones.
        probability: that it is this one, 0 to 1.
    """

    value: float
    probability: float


@dataclass(frozen=True)
class Field:
    """A sports field: elements in a fixed order, its symmetries, and extra classes.

    ``classes_without_geometry`` may occur in files (``Line unknown``). ``rules`` is the rule book
    and its edition. ``source`` is the file it was read from, which can be read again for other
    dimensions; ``own_file`` is that file's name where a shipped field has the same name and is
    another one, else empty. ``cameras`` is None where the file leaves it to the size of the field.
    ``relations`` are what the rules say of several dimensions together. ``landmarks`` are all that
    the dataset knows; some of the elements and classes are theirs, as they are at ``instant``, and
    ``instants`` says when its frames were taken (`field.landmarks.with_landmarks`). ``lines`` is
    one of `LINES`, ``usual_lines`` the one that its file says. ``stadiums`` gives frames dimensions
    of their own (`field.load`). ``pixels`` are those of the dataset's pictures, for which cameras
    are fitted; None where that is not known.
    """

    name: str
    title: str
    dimensions: tuple[Dimension, ...] = dataclass_field(repr=False)
    elements: tuple[Element, ...] = dataclass_field(repr=False)
    symmetries: tuple[Symmetry, ...] = dataclass_field(default=(), repr=False)
    classes_without_geometry: tuple[str, ...] = dataclass_field(default=(), repr=False)
    cameras: CameraPlacement | None = dataclass_field(default=None, repr=False)
    rules: str = ""
    source: Path | None = dataclass_field(default=None, compare=False)
    own_file: str = dataclass_field(default="", compare=False)
    relations: tuple[Relation, ...] = dataclass_field(default=(), repr=False)
    landmarks: tuple[Landmark, ...] = dataclass_field(default=(), repr=False)
    instant: str | None = None
    instants: Mapping[str, str] = dataclass_field(default_factory=dict, repr=False)
    lines: str = MEASURED_LINE
    usual_lines: str = dataclass_field(default=MEASURED_LINE, compare=False)
    stadiums: Stadiums | None = dataclass_field(default=None, repr=False)
    pixels: PixelAspect | None = None

    @property
    def pixel_aspect(self) -> float:
        """The most probable width of pixels over their height; 1 where it is not known."""
        return 1.0 if self.pixels is None else self.pixels.value

    @property
    def is_nominal(self) -> bool:
        """Return whether every dimension has its nominal value, wherever its lines are."""
        return all(d.value == d.nominal for d in self.dimensions)

    @property
    def full_name(self) -> str:
        """Its name, with its file where a shipped field has the same: ``tennis (field.toml)``."""
        return f"{self.name} ({self.own_file})" if self.own_file else self.name

    @cached_property
    def described(self) -> str:
        """Its full name with what is its own: ``futsal 39.8 x 20 m, lines at their middle``."""
        if not self.own_terms:
            return self.full_name
        return f"{self.full_name}{',' if self.is_nominal else ''} {self.own_terms}"

    @cached_property
    def own_terms(self) -> str:
        """The dimensions that are not nominal, both sides if one of them is, and where its lines
        are if that is not where the rules measure, and whether stadiums have their own; empty for a
        field as official evaluations take it."""
        own = {d.name: d for d in self.dimensions if d.value != d.nominal}
        sides = [d for d in self.dimensions if d.name in _SIDE_NAMES]
        words = []
        if len(sides) == len(_SIDE_NAMES) and not own.keys().isdisjoint(_SIDE_NAMES):
            words.append(" x ".join(f"{d.value:.10g}" for d in sides) + " m")
            own = {name: d for name, d in own.items() if name not in _SIDE_NAMES}
        words += [f"{d.title.lower()} {d.value:.10g} m" for d in own.values()]
        if self.lines == MIDDLE_LINE:
            words.append("lines at their middle")
        if self.stadiums is not None:
            words.append(f"dimensions of {pluralize(len(self.stadiums.dimensions), 'stadium')}")
        return ", ".join(words)

    def dimension(self, name: str) -> Dimension | None:
        """A dimension by name."""
        return next((d for d in self.dimensions if d.name == name), None)

    @cached_property
    def index(self) -> dict[str, int]:
        """Element name -> its position in `elements`."""
        return {e.name: i for i, e in enumerate(self.elements)}

    @cached_property
    def of_stadiums(self) -> dict[str, Field]:
        """Return what `field.load` has made of it for each stadium so far."""
        return {}

    @cached_property
    def on_ground(self) -> NDArray[np.bool_]:
        """(E,) whether each element lies on the plane z = 0."""
        return np.array([e.on_ground for e in self.elements], dtype=bool)

    @cached_property
    def _by_stripped(self) -> dict[str, str]:
        names = [*(e.name for e in self.elements), *self.classes_without_geometry]
        return {name.strip(): name for name in names}

    def canonical_name(self, class_name: str) -> str:
        """The official spelling (others drop a trailing space); unknown names unchanged."""
        return self._by_stripped.get(class_name.strip(), class_name)

    def title_of(self, class_name: str) -> str:
        """Return what people call a class; its name in files where it has no other."""
        element = self.element(class_name)
        return element.title if element is not None else class_name.strip()

    def knows(self, class_name: str) -> bool:
        """Return whether the class belongs to this field, with or without geometry."""
        return class_name in self.index or class_name in self.classes_without_geometry

    def symmetric_names(self, class_name: str) -> tuple[str, ...]:
        """The other classes that a label becomes on the turned field, in the order of the turns."""
        names = dict.fromkeys(turn.name_of(class_name) for turn in self.symmetries)
        return tuple(name for name in names if name != class_name)

    @cached_property
    def half_turn(self) -> Symmetry | None:
        """The half turn, if it takes the field to itself."""
        halves = (t for t in self.symmetries if abs(abs(t.turn_rad) - math.pi) < _SAME_TURN_RAD)
        return next(halves, None)

    @cached_property
    def unplaced_landmarks(self) -> frozenset[str]:
        """The landmarks that have no place here: nothing can be judged against them, or by them."""
        return frozenset(mark.name for mark in self.landmarks).difference(self.index)

    def element(self, class_name: str) -> Element | None:
        """The element of a class, or None when the class has no geometry."""
        i = self.index.get(class_name)
        return None if i is None else self.elements[i]


class NoPartnerError(ValueError):
    """An element that a turn takes to no other; the text says which."""

    def __init__(self, element: Element) -> None:
        super().__init__(f"the element {element.name.strip()!r} has no partner")
        self.element = element


def find_symmetry(elements: Sequence[Element], turn_degrees: float) -> Symmetry:
    """The symmetry of a turn, degrees from +x towards +y, each element's partner found by its
    place; `NoPartnerError` if the field is not the same after it.

    Elements that lie at the same place (one the prolongation of none, but drawn over) are reported
    apart by their order: the first goes to the first that is free.
    """
    turn = math.radians(turn_degrees)
    free = dict.fromkeys(range(len(elements)))
    partner: dict[str, str] = {}
    for element in elements:
        there = rotated(element.geometry, turn)
        twin = next((i for i in free if same_geometry(elements[i].geometry, there)), None)
        if twin is None:
            raise NoPartnerError(element)
        del free[twin]
        partner[element.name] = elements[twin].name
    return Symmetry(turn, partner)
