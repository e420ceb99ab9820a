"""Findings about labels, their severity and remedies, as values."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from procc_annotator.errors import UsageError
from procc_annotator.translation import translatable


class Severity(StrEnum):
    """Severity of a finding: wrong, probably wrong, worth a look."""

    ERROR = "error"
    WARNING = "warning"
    HINT = "hint"

    @property
    def rank(self) -> int:
        """The surest is 0."""
        return tuple(Severity).index(self)


def severity_from_name(name: str) -> Severity:
    """The severity of this name; UsageError if there is none."""
    try:
        return Severity(name.strip().lower())
    except ValueError:
        known = ", ".join(Severity)
        raise UsageError(f"unknown severity {name!r}; choose one of {known}") from None


class Rule(StrEnum):
    """Rule behind a finding."""

    PIXELS = "pixels"  # coordinates that are not normalised
    UNKNOWN_CLASS = "unknown class"  # none of the field's
    RESIDUAL = "residual"  # off where the camera of the others shows it
    POINT = "point"  # one point of an element that fits otherwise
    SWAPPED = "swapped"  # two elements that fit with each other's label
    REFLECTED = "reflected"  # the whole frame fits better top for bottom or left for right
    OTHER_SIDE = "other side"  # the camera stands on the other side of the field from the rest
    BENT = "bent"  # a straight element bent more than a lens does
    COINCIDENT = "coincident"  # two classes on top of each other
    SIDE = "side"  # on the wrong side of another element
    FEW_POINTS = "few points"
    MANY_POINTS = "many points"  # of a spot, which takes one
    SHORT = "short"  # an end that stops short of the corner or the picture's edge
    REPEATED = "repeated"  # clicked twice
    NO_PAINT = "no paint"  # the picture shows none under it
    BESIDE_PAINT = "beside paint"  # bent paint beside a straight element's chord


class RemedyKind(StrEnum):
    """Remedy by hand."""

    RELABEL = "relabel"  # also of many classes at once: a reflected frame
    SWAP = "swap"
    REMOVE_POINT = "remove point"
    FOLLOW = "follow paint"  # in the picture, which takes a moment
    LOOK = "look"  # nothing to be done by itself: show the place


@dataclass(frozen=True, slots=True)
class Remedy:
    """A way to fix a finding.

    Attributes:
        text: the same in words ("relabel to Right penalty front"), for buttons and tables; by
            `said`.
        renamed: for `RELABEL` and `SWAP`: (class, class it becomes), all at once.
    """

    kind: RemedyKind
    text: str
    renamed: tuple[tuple[str, str], ...] = ()


LOOK = Remedy(RemedyKind.LOOK, translatable("look at it"))


@dataclass(frozen=True, slots=True)
class Finding:
    """Something that may be wrong with an annotation.

    Attributes:
        rule: what was looked for.
        severity: how sure it is.
        elements: the classes concerned; the first one is to be shown.
        reason: one sentence, elements by their titles, without a full stop at its end; by `said`.
        remedies: ways to fix it, the likeliest first; `LOOK` where nothing else is known.
        point: index of the one bad point in the first element's polyline.
        error_px: largest distance of the first element's points from the fitted camera, px of the
            picture; None for rules that need no fit.
        model: of the fitted camera that had a say; None if none had.
    """

    rule: Rule
    severity: Severity
    elements: tuple[str, ...]
    reason: str
    remedies: tuple[Remedy, ...]
    point: int | None = None
    error_px: float | None = None
    model: str | None = None


def error_classes(found: Iterable[Finding]) -> frozenset[str]:
    """The classes that errors are about."""
    return frozenset(name for f in found if f.severity is Severity.ERROR for name in f.elements)


def outlier_point_finding(
    name: str,
    title: str,
    index: int,
    count: int,
    off: float,
    rest: float,
    severity: Severity,
    model: str | None = None,
) -> Finding:
    """One of ``count`` points of an element is off, px of the picture, its others at most
    ``rest``."""
    number = index + 1
    look = translatable("look at point {number}", number=number)
    remedies: tuple[Remedy, ...] = (Remedy(RemedyKind.LOOK, look),)
    if count > 2:
        remove = translatable("remove point {number}", number=number)
        remedies = (Remedy(RemedyKind.REMOVE_POINT, remove), *remedies)
    values: dict[str, Any] = {
        "number": number,
        "title": translatable(title),
        "off": off,
        "rest": rest,
    }
    reason = translatable(
        "point {number} of {title} is {off:.0f} px off, its other points at most {rest:.1f} px",
        **values,
    )
    if count == 2:
        reason = translatable(
            "point {number} of {title} is {off:.0f} px off, its other point at most {rest:.1f} px",
            **values,
        )
    return Finding(
        Rule.POINT, severity, (name,), reason, remedies, point=index, error_px=off, model=model
    )
