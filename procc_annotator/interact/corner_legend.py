"""What the colours, dashes and marks over the picture mean, in a few words each: only of what is
there."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from procc_annotator.interact import palette as tones
from procc_annotator.interact.legend import LegendEntry, LegendLine, Mark
from procc_annotator.interact.overlay import ColourBy
from procc_annotator.language import tr, word

_STATUSES: tuple[tuple[str, str, Mark | None], ...] = (
    ("tp", word("passes"), Mark("dot", tones.PASSES, tones.HANDLE_SIZE)),
    ("too_far", word("too far"), Mark("cross", tones.TOO_FAR, tones.HANDLE_SIZE + 2)),
    ("missed", word("annotated, not projected"), Mark("ring", tones.MISSED, tones.HANDLE_SIZE)),
    ("not_annotated", word("projected, not annotated"), None),
)


@dataclass(frozen=True, slots=True)
class OnPicture:
    """What is drawn over a picture.

    Attributes:
        annotated: whether there is an element, drawn in the colour of its class or its verdict.
        statuses: of elements that a camera is held against; None without a camera.
        colour_by: what the colours of annotated elements say.
        origins: how points came to be.
        authors: whose points there are.
        ghosts: whether ghosts are; "unsure" if their camera may be wrong.
        unconfirmed: whether copied elements wait.
        second: whether those of a second annotator are shown.
        others: names and colours of camera sources drawn beside the judged one.
    """

    annotated: bool = False
    statuses: Collection[str] | None = None
    colour_by: ColourBy = "criterion"
    origins: Collection[str] = ()
    authors: Sequence[str] = ()
    ghosts: str = ""
    unconfirmed: bool = False
    second: bool = False
    others: tuple[tuple[str, str], ...] = ()


def corner_legend(there: OnPicture) -> tuple[LegendEntry, ...]:
    """A line for everything that is there, in the order of how often one asks."""
    entries = [*_elements(there)]
    if there.unconfirmed:
        entries.append(_line(tr("copied, to be confirmed"), tones.UNCONFIRMED, *_UNCONFIRMED))
    if there.ghosts:
        unsure = there.ghosts == "unsure"
        text = tr("ghost of an unsure camera") if unsure else tr("ghost: expected here")
        tone = tones.UNSURE_GHOST if unsure else tones.GHOST
        entries.append(_line(text, tone, tones.GHOST_WIDTH, tones.GHOST_DASH))
    if there.statuses is not None:
        entries.append(_line(tr("projection"), tones.LABEL, tones.PROJECTION_WIDTH))
    entries += (_line(name, tone, tones.WIREFRAME_WIDTH) for name, tone in there.others)
    if there.second:
        entries.append(_line(tr("second annotator"), tones.SECOND, tones.PROJECTION_WIDTH))
    return tuple(entries)


_UNCONFIRMED = tones.ANNOTATION_WIDTH, tones.UNCONFIRMED_DASH


def _elements(there: OnPicture) -> list[LegendEntry]:
    width = tones.ANNOTATION_WIDTH
    if there.colour_by == "origin" and there.annotated:
        known = [name for name in tones.ORIGINS if name in there.origins]
        return [_mark(tr(name, "points"), *tones.ORIGINS[name]) for name in known]
    if there.colour_by == "annotator" and there.annotated:
        looks = zip(there.authors, tones.AUTHORS, strict=False)
        return [_mark(name, *look) for name, look in looks]
    if there.colour_by == "criterion" and there.statuses is not None:
        present = set(there.statuses)
        if present & {"tp", "too_far"}:
            present |= {"tp", "too_far"}  # points pass or are too far one by one
        return [
            LegendEntry(
                tr(text),
                (LegendLine(tones.STATUS_COLOURS[status], width, tones.STATUS_DASHES[status]),),
                mark,
            )
            for status, text, mark in _STATUSES
            if status in present
        ]
    if not there.annotated:
        return []
    mark = Mark("handle", tones.LABEL, tones.HANDLE_SIZE)
    line = LegendLine(tones.LABEL, width)
    return [LegendEntry(tr("annotated, in its class's colour"), (line,), mark)]


def _line(text: str, colour: str, width: float, dash: tuple[float, ...] = ()) -> LegendEntry:
    return LegendEntry(text, (LegendLine(colour, width, dash),))


def _mark(text: str, colour: str, shape: str) -> LegendEntry:
    return LegendEntry(text, (), Mark(shape, colour, tones.HANDLE_SIZE + 1))
