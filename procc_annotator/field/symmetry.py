"""Turns about the vertical that take a field to itself: each element to a partner."""

from __future__ import annotations

import math
from collections.abc import Sequence

from procc_annotator.field.geometry import same_geometry, rotated
from procc_annotator.field.model import Element, Symmetry


class NoPartnerError(ValueError):
    """An element that a turn takes to no other; the text says which."""

    def __init__(self, element: Element) -> None:
        super().__init__(f"the element {element.name.strip()!r} has no partner")
        self.element = element


def find_symmetry(elements: Sequence[Element], turn_degrees: float) -> Symmetry:
    """The symmetry of a turn, each element's partner found by its place.

    Elements that lie at the same place (one the prolongation of none, but drawn over) are told
    apart by their order: the first goes to the first that is free.

    Args:
        elements: of a field.
        turn_degrees: from +x towards +y.

    Raises:
        NoPartnerError: the field is not the same after the turn.
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
