"""What can be seen: the elements of a sports field, as data.

World frame: metres, origin at the field's centre, x along the length, y across towards the main
camera, z down (a crossbar lies at z = -2.44).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from dataclasses import field as dataclass_field
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Vector = tuple[float, float, float]

_SIDES = ("length", "width")  # told as "105 x 68 m"


@dataclass(frozen=True, slots=True)
class Line:
    """A straight segment; points in metres, world frame."""

    start: Vector
    end: Vector


@dataclass(frozen=True, slots=True)
class Arc:
    """A horizontal arc from ``start_rad`` increasing to ``end_rad``; 0 is +x, a quarter turn +y."""

    centre: Vector
    radius: float
    start_rad: float
    end_rad: float


@dataclass(frozen=True, slots=True)
class Circle:
    """A horizontal circle; sampled from angle 0 (+x) towards +y."""

    centre: Vector
    radius: float


Geometry = Line | Arc | Circle


@dataclass(frozen=True, slots=True)
class Dimension:
    """A measure of the field, metres: its value here, the nominal one, the range of the rules."""

    name: str
    title: str
    value: float
    nominal: float
    minimum: float
    maximum: float

    @property
    def is_open(self) -> bool:
        """Whether the rules leave it a range."""
        return self.minimum < self.maximum


@dataclass(frozen=True, slots=True)
class Element:
    """One field element, i.e. one annotation class."""

    name: str  # exact class name in files
    title: str  # shown to people
    group: str
    colour: str  # "#rrggbb"
    shortcut: str  # key (sequence) that selects it; "" for none
    geometry: Geometry

    @property
    def is_straight(self) -> bool:
        return isinstance(self.geometry, Line)

    @property
    def on_ground(self) -> bool:
        """Whether the whole element lies on the plane z = 0."""
        if isinstance(self.geometry, Line):
            return self.geometry.start[2] == 0 and self.geometry.end[2] == 0
        return self.geometry.centre[2] == 0


@dataclass(frozen=True)
class Field:
    """A sports field: elements in a fixed order, its half-turn symmetry, and extra classes.

    ``mirror`` maps every element name to the element it becomes when the field is turned by 180
    degrees about the vertical. ``classes_without_geometry`` may occur in files (``Line unknown``).
    ``source`` is the file it was read from, which can be read again for other dimensions.
    """

    name: str
    title: str
    dimensions: tuple[Dimension, ...]
    elements: tuple[Element, ...]
    mirror: Mapping[str, str]
    classes_without_geometry: tuple[str, ...] = ()
    source: Path | None = dataclass_field(default=None, compare=False)

    @property
    def is_nominal(self) -> bool:
        """Whether every dimension has its nominal value."""
        return all(d.value == d.nominal for d in self.dimensions)

    @property
    def described(self) -> str:
        """Its name, with the dimensions that are not nominal: ``soccer 101.3 x 66.2 m``."""
        if self.is_nominal:
            return self.name
        own = {d.name: d for d in self.dimensions if d.value != d.nominal}
        sides = [d for d in self.dimensions if d.name in _SIDES]
        words = []
        if len(sides) == len(_SIDES) and not own.keys().isdisjoint(_SIDES):
            words.append(" x ".join(f"{d.value:.10g}" for d in sides) + " m")
            own = {name: d for name, d in own.items() if name not in _SIDES}
        words += [f"{d.title.lower()} {d.value:.10g} m" for d in own.values()]
        return f"{self.name} {', '.join(words)}"

    def dimension(self, name: str) -> Dimension | None:
        """A dimension by name."""
        return next((d for d in self.dimensions if d.name == name), None)

    @cached_property
    def index(self) -> dict[str, int]:
        """Element name -> its position in `elements`."""
        return {e.name: i for i, e in enumerate(self.elements)}

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
        """What people call a class; its name in files where it has no other."""
        element = self.element(class_name)
        return element.title if element is not None else class_name.strip()

    def knows(self, class_name: str) -> bool:
        """Whether the class belongs to this field, with or without geometry."""
        return class_name in self.index or class_name in self.classes_without_geometry

    def mirrored_name(self, class_name: str) -> str:
        """The class a label becomes on the turned field; classes without geometry stay."""
        return self.mirror.get(class_name, class_name)

    def element(self, class_name: str) -> Element | None:
        """The element of a class, or None when the class has no geometry."""
        i = self.index.get(class_name)
        return None if i is None else self.elements[i]
