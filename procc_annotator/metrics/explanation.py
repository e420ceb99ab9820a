"""Explain the score of a frame: one sentence per element."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from procc_annotator.arrays import BoolArray
from procc_annotator.field.model import Field
from procc_annotator.metrics.measurement import Measurement
from procc_annotator.metrics.polylines import Polylines
from procc_annotator.metrics.projection import project_unclipped
from procc_annotator.metrics.score import ElementScore, FrameScore, Status
from procc_annotator.translation import tr, word

_MAX_DIGITS = 6
_AGREES_TEXT = word(
    "{element} agrees: its farthest point, {number}, is {px} px off; it passes at tau > {px}."
)
_TOO_FAR_TEXT = word(
    "{element} is too far: point {number} is {px} px off; it passes at tau > {px}."
)
_STATUS_ORDER: dict[Status, int] = {"too_far": 0, "missed": 1, "not_annotated": 2, "tp": 3}


@dataclass(frozen=True, slots=True)
class ScoreExplanation:
    """Result of one element at a threshold.

    Attributes:
        name: the class in the labelling that counts; annotated_name: as the annotator labels it.
        status: the verdict.
        deciding_point: index (from 0) in the polyline of the farthest point, or of the first one
            without a distance; None where no point was measured.
        deciding_px: its distance; None if absent.
        passes_above: the element is correct at every threshold above this one, px; None if it is
            at none.
        sentence: for people; points are counted from 1.
    """

    name: str
    annotated_name: str
    status: Status
    deciding_point: int | None
    deciding_px: float | None
    passes_above: float | None
    sentence: str


def explain_score(
    score: FrameScore, measurement: Measurement, field: Field
) -> tuple[ScoreExplanation, ...]:
    """Explain every element of a score, in its order.

    Args:
        score: of the measurement, at any threshold.
        measurement: what was scored.
        field: titles of the elements.
    """
    beyond = _farthest_outside_image(score, measurement)
    return tuple(
        ScoreExplanation(
            judged.name,
            judged.annotated_name,
            judged.status,
            judged.deciding_point,
            judged.max_distance,
            judged.passes_above,
            _sentence(judged, score.threshold, measurement, field)
            + _clipped_note(beyond.get(judged.name), score.threshold),
        )
        for judged in score.elements
    )


def worst_elements_first(explanations: Iterable[ScoreExplanation]) -> tuple[ScoreExplanation, ...]:
    """Return what lowers the score first: too far (farthest first), missed, not annotated, then the
    rest.

    Elements alike keep their order.
    """

    def rank(said: ScoreExplanation) -> tuple[int, bool, float]:
        # A point without a distance is worse than any distance.
        known = said.deciding_px is not None or said.deciding_point is None
        return _STATUS_ORDER[said.status], known, -(said.deciding_px or 0.0)

    return tuple(sorted(explanations, key=rank))


def _sentence(judged: ElementScore, tau: float, measurement: Measurement, field: Field) -> str:
    who = _element_label(judged, field)
    if judged.status == "not_annotated":
        return tr(
            "{element} is not annotated, but the camera shows it: a false positive.", element=who
        )
    if judged.status == "missed":
        return tr(_missed_reason(judged, measurement, field), element=who)
    number = (judged.deciding_point or 0) + 1
    if judged.max_distance is None:
        return tr(
            "{element} is too far: point {number} has no distance, because the projection has"
            " coinciding samples there; it passes at no tau.",
            element=who,
            number=number,
        )
    said = _AGREES_TEXT if judged.status == "tp" else _TOO_FAR_TEXT
    return tr(said, element=who, number=number, px=px_text(judged.max_distance, tau))


def _farthest_outside_image(score: FrameScore, measurement: Measurement) -> dict[str, float]:
    """Of elements that are too far and leave the picture, where only what is in it is measured to:
    the distance of the farthest point to the element as it goes on, px."""
    shown, setup, labels = measurement.projected, measurement.setup, score.labelling
    if not setup.is_official or shown.camera is None:
        return {}
    index = setup.tables.index
    wanted = np.zeros(len(shown.names), dtype=bool)
    wanted[[index[e.name] for e in score.elements if e.status == "too_far"]] = True
    wanted &= _touches_border(shown.polylines, setup.size)
    if not wanted.any():
        return {}
    lines = project_unclipped(shown.camera, setup, wanted)
    points = np.split(measurement.points_px, np.cumsum(labels.point_counts)[:-1])
    return {
        name: float(lines.segments.distances(px, np.full(len(px), row)).max())
        for name, row, px in zip(labels.names, labels.rows.tolist(), points, strict=True)
        if row >= 0 and lines.detected[row]
    }


def _touches_border(lines: Polylines, size: tuple[int, int]) -> BoolArray:
    """(E,) whether an element has a vertex on the border of the picture."""
    on_border = ((lines.vertices == 0) | (lines.vertices == np.array(size) - 1)).any(axis=1)
    leaving = np.zeros(lines.element_count, dtype=bool)
    leaving[lines.element[on_border]] = True
    return leaving


def _clipped_note(farthest: float | None, tau: float) -> str:
    if farthest is None or not farthest < tau:
        return ""
    return " " + tr(
        "As it goes on beyond the picture it is at most {px} px off, but soccernet measures to what"
        " is in the picture alone.",
        px=px_text(farthest, tau),
    )


def _element_label(judged: ElementScore, field: Field) -> str:
    title = tr(field.title_of(judged.annotated_name))
    if judged.name == judged.annotated_name:
        return title
    other = tr(field.title_of(judged.name))
    return tr("{title} (judged as {other}, labels mirrored)", title=title, other=other)


def _missed_reason(judged: ElementScore, measurement: Measurement, field: Field) -> str:
    element = field.element(judged.name)
    if element is None:
        return word(
            "{element} is missed: it is annotated, but the field has no such element to project."
        )
    if measurement.projected.ground_only and not element.on_ground:
        return word(
            "{element} is missed: it is annotated, but it leaves the ground, and the camera knows"
            " only the ground."
        )
    return word(
        "{element} is missed: it is annotated, but the camera does not show it in the picture."
    )


def px_text(distance: float, tau: float) -> str:
    """A distance, px, with one decimal, or as many as it takes to be on its side of the threshold:
    what fails at 5 px does not read as 5.0, nor does what passes."""
    for digits in range(1, _MAX_DIGITS):
        shown = round(distance, digits)
        if (shown < tau, shown > tau) == (distance < tau, distance > tau):
            return f"{distance:.{digits}f}"
    return f"{distance:.{_MAX_DIGITS}f}"
