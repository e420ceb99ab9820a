"""Warnings about a readable field file, for its author."""

from __future__ import annotations

import math
import re
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from enum import IntEnum
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from procc_annotator.errors import FieldError
from procc_annotator.field.dimensions import Dimension, allowed_dimensions, violated_relation
from procc_annotator.field.geometry import length_of, middle_of, outline_of, same_geometry
from procc_annotator.field.load import field_names, load_field, with_dimensions
from procc_annotator.field.model import (
    Element,
    Field,
    NoPartnerError,
    colour_difference,
    find_symmetry,
)
from procc_annotator.messages import pluralize

# Of the shipped fields none has colours in a group that differ less.
_MIN_COLOUR_DIFFERENCE = 5.0
_MIN_LENGTH_M = 0.05
_BELOW_GROUND_M = 0.01
_MIN_GROUND_ELEMENTS = 4  # what a camera on a plane needs
_ROTATIONS_DEGREES = (180.0, 90.0, 270.0)
_SAME_DEGREES = 1e-6
_SHORTCUT = re.compile(r"((Ctrl|Shift|Alt)\+)*(F[1-9]|F1[0-2]|[!-~])\Z", re.IGNORECASE)
_MAX_NAMED = 3  # elements a remark names before it counts the others


class WarningSeverity(IntEnum):
    """Severity of a remark."""

    ERROR = 0
    WARNING = 1
    NOTE = 2

    def __str__(self) -> str:
        return self.name.lower()


@dataclass(frozen=True, slots=True)
class FieldWarning:
    """Something about a field.

    Attributes:
        place: where in the file, as errors name it.
        severity: an error fails for a person, a warning is most likely a mistake, a note is not.
    """

    place: str
    text: str
    advice: str
    severity: WarningSeverity = WarningSeverity.WARNING

    def __str__(self) -> str:
        return self.with_location(self.place)

    def with_location(self, place: str) -> str:
        """The whole remark, with the place in other words."""
        return f"{self.severity}: {place}: {self.text} ({self.advice})"


def validate_field(
    field: Field, taken_keys: Mapping[str, str] | None = None
) -> tuple[FieldWarning, ...]:
    """Look for what most likely is a mistake in a field with nominal dimensions, the gravest first.
    ``taken_keys``: keys of the window -> what they do there."""
    found = [
        *_dimension_warnings(field),
        *_size_warnings(field),
        *_placement_warnings(field),
        *_symmetry_warnings(field),
        *_name_warnings(field),
        *_colour_warnings(field),
        *_shortcut_warnings(field, taken_keys or {}),
        *_missing_value_warnings(field),
    ]
    return tuple(sorted(found, key=lambda remark: remark.severity))


# --- dimensions ------------------------------------------------------------------------------


def _dimension_warnings(field: Field) -> Iterator[FieldWarning]:
    """The whole range of the rules must make a field."""
    if field.source is None:
        return
    opened = [d for d in field.dimensions if d.is_open]
    for dimension in opened:
        ends = (dimension.minimum, dimension.maximum)
        for end in ends:
            if allowed_dimensions(field.relations, field.dimensions, dimension.name, end) is None:
                yield _unreachable_limit_warning(field, dimension, end)
        sized = [_resized_or_error(field, {dimension.name: v}) for v in ends]
        broken = next((s for s in sized if isinstance(s, FieldError)), None)
        if broken is not None:
            yield _invalid_dimension_warning(dimension, broken)
        elif all(isinstance(s, Field) and s.elements == field.elements for s in sized):
            yield FieldWarning(
                f"dimensions.{dimension.name}",
                f"may be {dimension.minimum:g} to {dimension.maximum:g} m, but no element changes"
                " with it",
                "use its name in a formula, or leave it out",
            )


def _resized_or_error(field: Field, values: Mapping[str, float]) -> Field | FieldError:
    try:
        return with_dimensions(field, values, related=False)
    except FieldError as error:
        return error


def _unreachable_limit_warning(field: Field, dimension: Dimension, end: float) -> FieldWarning:
    nominal = {d.name: d.nominal for d in field.dimensions}
    return FieldWarning(
        f"dimensions.{dimension.name}",
        f"may be {dimension.minimum:g} to {dimension.maximum:g} m, but {end:g} m is never allowed:"
        f" {violated_relation(field.relations, nominal | {dimension.name: end})}",
        "narrow the range, or mend the relation",
    )


def _invalid_dimension_warning(dimension: Dimension, error: FieldError) -> FieldWarning:
    where = f"{error.place}: " if error.place else ""
    return FieldWarning(
        f"dimensions.{dimension.name}",
        f"the field cannot be read with every value of {dimension.minimum:g} to"
        f" {dimension.maximum:g} m: {where}{error.problem}",
        "narrow the range, or mend the formula",
        WarningSeverity.ERROR,
    )


# --- where elements are ----------------------------------------------------------------------


def _size_warnings(field: Field) -> Iterator[FieldWarning]:
    painted = [e for e in field.elements if e.on_ground and not e.is_spot]
    if len(painted) < _MIN_GROUND_ELEMENTS:
        yield FieldWarning(
            "elements",
            f"{pluralize(len(painted), 'line lies', 'lines lie')} on the ground",
            f"a camera can hardly be found with fewer than {_MIN_GROUND_ELEMENTS}",
        )
    if not painted:
        return
    least, most = _bounds([e for e in painted if not e.optional] or painted)
    middle, span = (least + most) / 2, most - least
    for axis, off, extent in zip("xy", middle, span, strict=True):
        if abs(off) > max(0.05, extent / 100):
            yield FieldWarning(
                "elements",
                f"the lines on the ground reach from {axis} = {off - extent / 2:.4g} to"
                f" {off + extent / 2:.4g} m: their middle is {abs(off):.3g} m away from the origin",
                "the origin is the centre of the field",
            )
    yield from _outside(field, span)


def _outside(field: Field, span: NDArray[np.float64]) -> Iterator[FieldWarning]:
    sides = [field.dimension(name) for name in ("length", "width")]
    if None in sides:
        yield FieldWarning(
            "dimensions",
            "there is no length and width of these names",
            "the size of the field is shown, changed and estimated by them",
        )
        return
    size = np.array([side.value for side in sides if side is not None])
    for name, extent, side in zip(("length", "width"), span, size, strict=True):
        if extent < 0.8 * side:
            yield FieldWarning(
                f"dimensions.{name}",
                f"is {side:g} m, but the lines on the ground span {extent:.4g} m only",
                "half of a dimension is taken where the whole is meant, or the other way round",
            )
    room = size / 2 + 1 + size.max() / 10
    for element in field.elements:
        reach = np.abs(outline_of(element.geometry)[:, :2]).max(axis=0)
        if (reach > room).any():
            beyond = float((reach - size / 2).max())
            yield FieldWarning(
                _place(element),
                f"lies up to {beyond:.3g} m outside the field of {size[0]:g} x {size[1]:g} m",
                "coordinates are counted from the centre of the field",
            )


def _placement_warnings(field: Field) -> Iterator[FieldWarning]:
    for element in field.elements:
        deepest = float(outline_of(element.geometry)[:, 2].max())
        if deepest > _BELOW_GROUND_M:
            yield FieldWarning(
                _place(element),
                f"lies {deepest:.3g} m below the ground",
                f"z points down: a height of {deepest:.3g} m is z = {-deepest:.3g}",
            )
        length = length_of(element.geometry)
        if not element.is_spot and length < _MIN_LENGTH_M:
            yield FieldWarning(
                _place(element),
                f"is {length * 100:.2g} cm long",
                'too short to be clicked along: make it kind = "point"',
            )
    middles = {e.name: np.array(middle_of(e.geometry)) for e in field.elements}
    for one, other in combinations(field.elements, 2):
        near = np.abs(middles[one.name] - middles[other.name]).max() < _BELOW_GROUND_M
        if near and same_geometry(one.geometry, other.geometry, within_m=_BELOW_GROUND_M):
            yield FieldWarning(
                _place(other),
                f"lies where {one.title!r} lies",
                "they cannot be distinguished: is one of them on the other side?",
            )


def _bounds(elements: list[Element]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    places = np.concatenate([outline_of(e.geometry)[:, :2] for e in elements])
    return places.min(axis=0), places.max(axis=0)


def _symmetry_warnings(field: Field) -> Iterator[FieldWarning]:
    listed = [math.degrees(s.turn_rad) for s in field.symmetries]
    missing = [
        turn
        for turn in _ROTATIONS_DEGREES
        if not any(abs(turn - own) < _SAME_DEGREES for own in listed) and _is_symmetric(field, turn)
    ]
    if missing:
        turns = " and ".join(f"{turn:g}" for turn in missing)
        whole = ", ".join(f"{turn:g}" for turn in sorted([*listed, *missing]))
        yield FieldWarning(
            "symmetries",
            f"a turn by {turns} degrees takes the field to itself, but is not listed",
            f"symmetries = [{whole}], unless the sides can be distinguished",
        )


def _is_symmetric(field: Field, turn_degrees: float) -> bool:
    try:
        find_symmetry(field.elements, turn_degrees)
    except NoPartnerError:
        return False
    return True


# --- what people see -------------------------------------------------------------------------


def _name_warnings(field: Field) -> Iterator[FieldWarning]:
    shipped = field.name in field_names()
    if shipped and field.source is not None and field.source != load_field(field.name).source:
        yield FieldWarning(
            "name",
            f"{field.name!r} is the name of a field that comes with the program",
            "give it a name of its own",
        )
    for title, elements in _grouped_by(field.elements, lambda e: e.title).items():
        if len(elements) > 1:
            names = ", ".join(repr(e.name) for e in elements)
            yield FieldWarning(
                f"{_place(elements[-1])}.title",
                f"{title!r} is the title of {names}",
                "people choose an element by its title",
            )


def _colour_warnings(field: Field) -> Iterator[FieldWarning]:
    for group, elements in _grouped_by(field.elements, lambda e: e.group).items():
        for one, other in combinations(elements, 2):
            if colour_difference(one.colour, other.colour) < _MIN_COLOUR_DIFFERENCE:
                yield FieldWarning(
                    f"{_place(other)}.colour",
                    f"{other.colour} is hard to distinguish from {one.title!r}, {one.colour}, in"
                    f" the group {group!r}",
                    "choose colours that differ",
                )


def _shortcut_warnings(field: Field, taken: Mapping[str, str]) -> Iterator[FieldWarning]:
    used = {key.casefold(): does for key, does in taken.items()}
    for element in field.elements:
        place = f"{_place(element)}.shortcut"
        if not element.shortcut:
            continue
        if (does := used.get(element.shortcut.casefold())) is not None:
            yield FieldWarning(
                place,
                f"the key {element.shortcut} is taken by the window: {does}",
                "choose another key",
            )
        elif not _SHORTCUT.match(element.shortcut):
            yield FieldWarning(
                place,
                f"{element.shortcut!r} is no key",
                'expected e.g. "7", "K" or "Shift+K"',
            )
    without = [e for e in field.elements if not e.shortcut]
    if without:
        named = ", ".join(repr(e.title) for e in without[:_MAX_NAMED])
        more = f" and {len(without) - _MAX_NAMED} more" if len(without) > _MAX_NAMED else ""
        yield FieldWarning(
            "elements",
            f"{pluralize(len(without), 'element has', 'elements have')} no shortcut: {named}{more}",
            "they are chosen in the list, on the field map, or with /",
            WarningSeverity.NOTE,
        )


def _missing_value_warnings(field: Field) -> Iterator[FieldWarning]:
    if not field.rules:
        yield FieldWarning(
            "rules", "is not given", "name the rule book and its edition", WarningSeverity.NOTE
        )
    if field.cameras is None:
        yield FieldWarning(
            "cameras",
            "is not given",
            "where cameras stand is taken from the size of the field",
            WarningSeverity.NOTE,
        )
    painted = [e for e in field.elements if e.on_ground and not e.is_spot]
    if painted and not any(e.line_width for e in painted):
        yield FieldWarning(
            "paint",
            "no line has a width",
            "painted width cannot be shown: add [paint] with a line_width",
            WarningSeverity.NOTE,
        )


def _grouped_by(
    elements: tuple[Element, ...], key: Callable[[Element], str]
) -> dict[str, list[Element]]:
    found: defaultdict[str, list[Element]] = defaultdict(list)
    for element in elements:
        found[key(element)].append(element)
    return found


def _place(element: Element) -> str:
    return f"element {element.name!r}"
