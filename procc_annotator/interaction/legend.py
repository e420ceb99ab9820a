"""Legends of overlays and of the picture corner."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.overlay import ColourBy
from procc_annotator.metrics.measurement import Measurement
from procc_annotator.metrics.score import FrameScore
from procc_annotator.translation import tr, word


@dataclass(frozen=True, slots=True)
class LegendLine:
    """A stroke's look: colour, width and dash in points."""

    colour: str
    width: float
    dash: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Mark:
    """A point's look: shape, colour and size in points."""

    shape: str
    colour: str
    size: float


@dataclass(frozen=True, slots=True)
class LegendEntry:
    """A sample and what it means; lines are drawn first to last, the mark on them."""

    text: str
    lines: tuple[LegendLine, ...]
    mark: Mark | None = None


def legend_of(
    annotation: FrameAnnotation,
    field: Field,
    measurement: Measurement | None = None,
    score: FrameScore | None = None,
    size: tuple[int, int] | None = None,
    *,
    with_paint: bool = False,
) -> tuple[LegendEntry, ...]:
    """Return what is to be explained of a frame: only what is on the picture.

    Args:
        measurement, score: of this annotation against a camera; without them elements have the
            colours of their classes.
        size: px of the evaluation, which distances are in.
        with_paint: whether the borders of painted lines are drawn.
    """
    if score is None or measurement is None:
        entries = _classes(annotation, field)
        if measurement is not None:
            colour, dash = (
                tones.STATUS_COLOURS["not_annotated"],
                tones.STATUS_DASHES["not_annotated"],
            )
            line = LegendLine(colour, tones.ANNOTATION_WIDTH, dash)
            entries.append(LegendEntry("the projection", (line,)))
    else:
        entries = _verdicts(annotation, measurement, score, size)
    if with_paint:
        border = LegendLine(tones.LABEL, tones.LINE_MARKING_WIDTH)
        entries.append(LegendEntry("hairlines: the painted width", (border,)))
    if annotation.unconfirmed:
        entries.append(_unconfirmed())
    return tuple(entries)


def _verdicts(
    annotation: FrameAnnotation,
    measurement: Measurement,
    score: FrameScore,
    evaluated: tuple[int, int] | None,
) -> list[LegendEntry]:
    present = {element.status for element in score.elements}
    tau = f"{score.threshold:g} px"
    size, width = tones.HANDLE_SIZE, tones.ANNOTATION_WIDTH
    known: tuple[tuple[str, str, Mark | None], ...] = (
        ("tp", f"passes: every point closer than {tau}", Mark("dot", tones.PASSES, size)),
        (
            "too_far",
            f"too far: a point {tau} or more away",
            Mark("cross", tones.TOO_FAR, size + 2),
        ),
        ("missed", "missed: annotated, not projected", Mark("ring", tones.MISSED, size)),
        ("not_annotated", "not annotated: projected only", None),
    )
    entries = [
        LegendEntry(
            text,
            (LegendLine(tones.STATUS_COLOURS[status], width, tones.STATUS_DASHES[status]),),
            mark,
        )
        for status, text, mark in known
        if status in present
    ]
    judged = {element.annotated_name for element in score.elements}
    if any(p.points and p.class_name not in judged for p in annotation.polylines):
        grey = tones.UNKNOWN_CLASS
        entries.append(
            LegendEntry("takes no part", (LegendLine(grey, width),), Mark("handle", grey, size))
        )
    if measurement.projected.polylines.detected.any():
        thin = LegendLine(tones.LABEL, tones.PROJECTION_WIDTH)
        entries.append(LegendEntry("thin lines: the projection", (thin,)))
    if evaluated is not None:
        width_px, height_px = evaluated
        entries.append(LegendEntry(f"distances: px of {width_px}x{height_px}", ()))
    return entries


def _classes(annotation: FrameAnnotation, field: Field) -> list[LegendEntry]:
    entries = []
    for name in annotation.annotated:
        element = field.element(name)
        colour = tones.UNKNOWN_CLASS if element is None else element.colour
        dash = tones.UNKNOWN_CLASS_DASH if element is None else ()
        entries.append(
            LegendEntry(
                field.title_of(name),
                (LegendLine(colour, tones.ANNOTATION_WIDTH, dash),),
                Mark("handle", colour, tones.HANDLE_SIZE),
            )
        )
    return entries


def _unconfirmed() -> LegendEntry:
    width = tones.ANNOTATION_WIDTH
    return LegendEntry(
        "unconfirmed: never counted",
        (
            LegendLine(tones.HALO, width + 1.5),
            LegendLine(tones.UNCONFIRMED, width, tones.UNCONFIRMED_DASH),
        ),
        Mark("ring", tones.UNCONFIRMED, tones.HANDLE_SIZE),
    )


_STATUSES: tuple[tuple[str, str, Mark | None], ...] = (
    ("tp", word("passes"), Mark("dot", tones.PASSES, tones.HANDLE_SIZE)),
    ("too_far", word("too far"), Mark("cross", tones.TOO_FAR, tones.HANDLE_SIZE + 2)),
    ("missed", word("annotated, not projected"), Mark("ring", tones.MISSED, tones.HANDLE_SIZE)),
    ("not_annotated", word("projected, not annotated"), None),
)


@dataclass(frozen=True, slots=True)
class OnPicture:
    """Content of an overlay, for its legend.

    Attributes:
        annotated: whether there is an element, drawn in the colour of its class or its verdict.
        statuses: of elements that a camera is held against; None without a camera.
        colour_by: what the colours of annotated elements say.
        origins: how points came to be.
        ghosts: whether ghosts are; "unsure" if their camera may be wrong.
        unconfirmed: whether copied elements wait.
        second: whether those of a second annotator are shown.
        others: names and colours of camera sources drawn next to the judged one.
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
        entries.append(_line(tr("to be confirmed"), tones.UNCONFIRMED, *_UNCONFIRMED))
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
