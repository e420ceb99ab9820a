"""Places of one stadium that a dataset knows next to its field: surveyed or triangulated.

A landmark with a position becomes an element of the field, a spot that is judged only where it is
annotated. One without is a class that may be clicked until its position is known. A moving object
has a position an instant.
"""

from __future__ import annotations

import colorsys
import zlib
from collections.abc import Container, Iterable, Mapping
from dataclasses import replace

from procc_annotator.errors import FieldError
from procc_annotator.field.formulas import short_repr
from procc_annotator.field.geometry import Covariance, Spot
from procc_annotator.field.model import Element, Field, Landmark, Symmetry

LANDMARK_GROUP = "Landmarks"
# Hues that are seen on grass, on wood and on ice: all but the greens, from cyan over red to yellow.
_HUE_START, _HUE_RANGE = 175.0, 240.0  # degrees
_LIGHTNESS = (0.55, 0.7)


def with_landmarks(
    field: Field,
    landmarks: Iterable[Landmark],
    instant: str | None = None,
    instants: Mapping[str, str] | None = None,
) -> Field:
    """The field with a dataset's landmarks, in place of those it may have had.

    Args:
        landmarks: all of the dataset's, those of other instants included.
        instant: of the frame; moving objects are where they were then.
        instants: frame -> when it was taken; kept only where something moves.

    Returns:
        Landmarks with a position at this instant are elements, optional ones; the others are
        classes without geometry. A key that the field uses for itself is not given to them.

    Raises:
        FieldError: a landmark has the name of one of the field's own classes.
    """
    own = without_landmarks(field)
    given = tuple(landmarks)
    if not given:
        return own
    _check_names_free(own, given)
    keys = {e.shortcut.casefold() for e in own.elements if e.shortcut}
    elements: list[Element] = []
    unplaced: list[str] = []
    for name, entries in landmarks_by_name(given).items():
        landmark, looks = landmark_at_instant(entries, instant), entries[0]
        if landmark is None or landmark.position is None:
            unplaced.append(name)
            continue
        shortcut = looks.shortcut if looks.shortcut.casefold() not in keys else ""
        keys.add(shortcut.casefold())
        elements.append(
            Element(
                name,
                looks.shown_title,
                LANDMARK_GROUP,
                looks.colour or _default_colour(name),
                shortcut,
                Spot(landmark.position),
                optional=True,
            )
        )
    return replace(
        own,
        elements=(*own.elements, *elements),
        symmetries=_symmetries_with_landmarks(own.symmetries, [e.name for e in elements]),
        classes_without_geometry=(*own.classes_without_geometry, *unplaced),
        landmarks=given,
        instant=instant,
        instants=instants if instants and any(map(is_moving, given)) else {},
    )


def _check_names_free(field: Field, landmarks: Iterable[Landmark]) -> None:
    taken = {e.name.strip() for e in field.elements}
    taken |= {name.strip() for name in field.classes_without_geometry}
    for number, landmark in enumerate(landmarks):
        if landmark.name.strip() in taken:
            raise FieldError(
                field.name,
                f"the landmark {short_repr(landmark.name)} has the name of a class of the field",
                place=f"landmarks[{number}].name",
                advice="delete the entry, or rename the landmark",
            )


def without_landmarks(field: Field) -> Field:
    """The field as its description has it."""
    if not field.landmarks:
        return field
    names = {landmark.name for landmark in field.landmarks}
    return replace(
        field,
        elements=tuple(e for e in field.elements if e.name not in names),
        symmetries=_symmetries_with_landmarks(field.symmetries, (), names),
        classes_without_geometry=tuple(c for c in field.classes_without_geometry if c not in names),
        landmarks=(),
        instant=None,
        instants={},
    )


def _default_colour(name: str) -> str:
    """``#rrggbb`` of a landmark that names none: the same whatever others there are."""
    number = zlib.crc32(name.strip().encode())
    hue = (_HUE_START + (number >> 1) % 1000 / 1000 * _HUE_RANGE) % 360
    channels = colorsys.hls_to_rgb(hue / 360, _LIGHTNESS[number % 2], 1.0)
    return "#" + "".join(f"{round(255 * channel):02x}" for channel in channels)


def _symmetries_with_landmarks(
    symmetries: Iterable[Symmetry], added: Iterable[str], left_out: Container[str] = ()
) -> tuple[Symmetry, ...]:
    """Turns of the field with landmarks: the stadium does not turn with it, so they stay."""
    more = {name: name for name in added}
    return tuple(
        replace(turn, partner={k: v for k, v in turn.partner.items() if k not in left_out} | more)
        for turn in symmetries
    )


def field_at(field: Field, instant: str | None) -> Field:
    """The field with its landmarks where they are at an instant; itself where nothing moves."""
    if instant == field.instant or not any(map(is_moving, field.landmarks)):
        return field
    return with_landmarks(field, field.landmarks, instant, field.instants)


def landmarks_by_name(landmarks: Iterable[Landmark]) -> Mapping[str, list[Landmark]]:
    """The entries of each landmark, in their order; a moving object has one an instant."""
    found: dict[str, list[Landmark]] = {}
    for landmark in landmarks:
        found.setdefault(landmark.name, []).append(landmark)
    return found


def element_titles(field: Field) -> Mapping[str, str]:
    """Name -> title of what is an element in any frame: the field's own elements in their order,
    then the landmarks that have a place at any time. A dataset's field and that of each of its
    frames have the same ones, while rows of their elements differ where something moves."""
    marks = landmarks_by_name(field.landmarks)
    own = {e.name: e.title for e in field.elements if e.name not in marks}
    placed = {name: e for name, e in marks.items() if any(m.position is not None for m in e)}
    return own | {name: entries[0].shown_title for name, entries in placed.items()}


def landmark_at_instant(known: Iterable[Landmark], instant: str | None) -> Landmark | None:
    """Of one landmark's entries the one that holds at an instant; None where none does."""
    lasting = None
    for landmark in known:
        if landmark.instant is not None and landmark.instant == instant:
            return landmark
        if landmark.instant is None:
            lasting = landmark
    return lasting


def landmark_covariances(field: Field) -> Mapping[str, Covariance]:
    """Name -> (3, 3) m^2 of the landmarks that are elements of the field and have a covariance."""
    found = {}
    for name, known in landmarks_by_name(field.landmarks).items():
        landmark = landmark_at_instant(known, field.instant)
        if name in field.index and landmark is not None and landmark.covariance is not None:
            found[name] = landmark.covariance
    return found


def is_moving(landmark: Landmark) -> bool:
    """Return whether its position holds for an instant only."""
    return landmark.moving or landmark.instant is not None
