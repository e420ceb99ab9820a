"""What colours, dashes and marks of an overlay mean: the lines of its legend."""

from __future__ import annotations

from dataclasses import dataclass

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.interact import palette as tones
from procc_annotator.metric.measure import Measurement
from procc_annotator.metric.score import FrameScore


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
    """What is to be explained of a frame: only what is on the picture.

    Args:
        annotation: what is drawn.
        field: titles and colours.
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
