"""Check the labels of a frame, and across a set for frames rotated by 180 degrees."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.fitting import AUTO, fit_camera
from procc_annotator.calibration.joint.position_clusters import find_opposite_side_frames
from procc_annotator.calibration.label_check.camera_rules import camera_findings, suspect_elements
from procc_annotator.calibration.label_check.element_rules import (
    overlap_findings,
    pixel_coordinate_findings,
    shape_findings,
    unknown_class_findings,
)
from procc_annotator.calibration.label_check.evidence import FrameEvidence, LineEvidence
from procc_annotator.calibration.label_check.extent_rules import (
    line_evidence_findings,
    short_end_findings,
)
from procc_annotator.calibration.label_check.finding import (
    LOOK,
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
)
from procc_annotator.calibration.label_check.side_rules import side_findings
from procc_annotator.calibration.optimization.camera_parameters import (
    POSITION_SLICE,
    WIDE_ANGLE_MODELS,
)
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.optimization.lens_models import MANY_OUTLIERS
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.result import FitResult, PosedCamera, ill_conditioned_reason
from procc_annotator.field.model import Field
from procc_annotator.translation import translatable, translatable_count

LabelRule = Callable[[FrameEvidence, Sequence[Finding]], Iterable[Finding]]
"""A family of rules: the frame, and what is known before: that is not to be told again."""

_CAMERA_RULES: tuple[LabelRule, ...] = (camera_findings, unknown_class_findings)
_CAMERA_FREE_RULES: tuple[LabelRule, ...] = (
    shape_findings,
    overlap_findings,
    side_findings,
)
_END_RULES: tuple[LabelRule, ...] = (short_end_findings,)  # once all other errors are known
# Of findings of one severity the surest come first.
_RULE_ORDER = (
    Rule.PIXELS,
    Rule.UNKNOWN_CLASS,
    Rule.REFLECTED,
    Rule.OTHER_SIDE,
    Rule.SWAPPED,
    Rule.RESIDUAL,
    Rule.POINT,
    Rule.SIDE,
    Rule.COINCIDENT,
    Rule.BENT,
    Rule.REPEATED,
    Rule.MANY_POINTS,
    Rule.FEW_POINTS,
    Rule.NO_PAINT,
    Rule.BESIDE_PAINT,
    Rule.SHORT,
)


def check_labels(
    annotation: FrameAnnotation,
    field: Field,
    *,
    size: tuple[int, int],
    fit: FitResult,
    go_on: Callable[[], None] = lambda: None,
) -> tuple[Finding, ...]:
    """Return what may be wrong with a frame's labels, the surest first.

    Costs a few milliseconds where the camera fits; where it does not, several further fits (some
    0.05 s, at most about 0.5 s).

    Args:
        annotation: normalised points; unconfirmed elements take no part.
        size: (width, height) px of the picture.
        fit: the camera fitted to this annotation, or its failure.
        go_on: called before each further fit; raises whatever it likes when no one wants the rest.

    Returns:
        At most one finding about each mistake: what the camera explains is not reported again by
        rules that need none.
    """
    frame = ImageFrame(size, field.pixel_aspect)
    if len(suspect_elements(fit, frame)) >= MANY_OUTLIERS and fit.model not in WIDE_ANGLE_MODELS:
        go_on()
        other = fit_camera(annotation, field, model=AUTO, size=size)
        if other.model in WIDE_ANGLE_MODELS and len(suspect_elements(other, frame)) < MANY_OUTLIERS:
            fit = other  # the lens is to blame, not the labels
    evidence = FrameEvidence(annotation, field, frame, fit, go_on)
    return tuple(
        sorted(
            _drop_redundant(_apply_rules(evidence, _CAMERA_RULES, _CAMERA_FREE_RULES, _END_RULES)),
            key=_finding_order,
        )
    )


def add_line_evidence(
    findings: Sequence[Finding],
    annotation: FrameAnnotation,
    field: Field,
    *,
    size: tuple[int, int],
    fit: FitResult,
    paint: Mapping[str, LineEvidence],
) -> tuple[Finding, ...]:
    """Return what is known once the picture was examined: the surest first.

    Ends are short only where the picture shows paint beyond them, a point that paint leads to is
    right, and what is seen under and next to the elements is reported.

    Args:
        findings: of this annotation, without the picture.
        fit: as of `check_labels`; a failure where no camera was asked for.
        paint: class -> what the picture shows along it.
    """
    if any(f.rule is Rule.PIXELS for f in findings):
        return tuple(findings)
    frame = ImageFrame(size, field.pixel_aspect)
    evidence = FrameEvidence(annotation, field, frame, fit, paint=paint)
    found = [f for f in findings if f.rule is not Rule.SHORT and not _is_on_line(f, paint)]
    for rules in (short_end_findings, line_evidence_findings):
        found.extend(rules(evidence, tuple(found)))
    return tuple(sorted(found, key=_finding_order))


def _is_on_line(finding: Finding, paint: Mapping[str, LineEvidence]) -> bool:
    """Return whether one point is in doubt, and paint leads to it: grass is no plane."""
    seen = paint.get(finding.elements[0]) if finding.rule is Rule.POINT else None
    if seen is None or finding.point is None:
        return False
    near = (seen.segments == finding.point) | (seen.segments == finding.point - 1)
    return bool(near.any() and not seen.missing[near].any())


def check_without_camera(
    annotation: FrameAnnotation, field: Field, *, size: tuple[int, int]
) -> tuple[Finding, ...]:
    """Return what can be seen without a camera to be wrong with a frame's labels, surest first."""
    no_fit = FitResult("", size, None, failure="not asked for")
    evidence = FrameEvidence(annotation, field, ImageFrame(size, field.pixel_aspect), no_fit)
    return tuple(
        sorted(
            _apply_rules(evidence, (unknown_class_findings, *_CAMERA_FREE_RULES), _END_RULES),
            key=lambda f: f.severity.rank,
        )
    )


def _apply_rules(evidence: FrameEvidence, *stages: tuple[LabelRule, ...]) -> list[Finding]:
    """Return what rules find; those of one stage know what the stages before found."""
    found = list(pixel_coordinate_findings(evidence, ()))
    if found:
        return found  # no other rule has anything to say then
    for stage in stages:
        known = tuple(found)
        for rules in stage:
            found.extend(rules(evidence, known))
    return found


def _drop_redundant(found: Sequence[Finding]) -> list[Finding]:
    """Leave out what is vaguely said by the camera where another rule says it plainly."""
    plain = {
        name
        for f in found
        if f.rule in (Rule.BENT, Rule.SIDE, Rule.COINCIDENT, Rule.REFLECTED)
        for name in f.elements
    }
    return [
        f
        for f in found
        if not (
            f.rule is Rule.RESIDUAL
            and f.severity is not Severity.ERROR
            and plain.intersection(f.elements)
        )
    ]


def _finding_order(finding: Finding) -> tuple[int, int, float]:
    return finding.severity.rank, _RULE_ORDER.index(finding.rule), -(finding.error_px or 0.0)


@dataclass(frozen=True, slots=True)
class FittedPosition:
    """Position of the camera of a frame's own fit.

    Attributes:
        position_m: metres, world frame.
        covariance: rows of the (3, 3) one of it, metres squared.
        is_sure: whether the points determine the camera.
    """

    position_m: tuple[float, ...]
    covariance: tuple[tuple[float, ...], ...]
    model: str
    is_sure: bool


def fitted_position(fit: FitResult) -> FittedPosition | None:
    """Return where a fit has its camera; None without one, and for a homography."""
    if not isinstance(fit.camera, PosedCamera) or fit.covariance is None:
        return None
    covariance = fit.covariance[POSITION_SLICE, POSITION_SLICE].tolist()
    sure = not ill_conditioned_reason(fit)
    return FittedPosition(fit.camera.position_world, tuple(map(tuple, covariance)), fit.model, sure)


@dataclass(frozen=True, slots=True)
class OppositeSideFrame:
    """A frame whose camera stands on the other side from the rest.

    Attributes:
        opposite: how many frames stand where its camera does once its labels are turned; 0 if none
            do, and it merely stands where hardly any does.
        frames: of the set, with a camera.
    """

    opposite: int
    frames: int
    stand: FittedPosition


def find_opposite_frames(
    stands: Mapping[str, FittedPosition], field: Field
) -> dict[str, OppositeSideFrame]:
    """The frames of a set whose camera stands on the other side from the rest. Of a field that
    half a turn does not take to itself none is reported: the labels of one frame give the side."""
    if field.half_turn is None or not stands:
        return {}
    names = list(stands)
    positions = np.array([stand.position_m for stand in stands.values()])
    covariances = np.array([stand.covariance for stand in stands.values()])
    found = find_opposite_side_frames(positions, covariances, camera_placement_prior(field))
    opposite = {**dict.fromkeys(sorted(found.minority), 0), **found.turned}
    return {
        names[i]: OppositeSideFrame(count, len(names), stands[names[i]])
        for i, count in opposite.items()
    }


def opposite_side_finding(
    annotation: FrameAnnotation, field: Field, found: OppositeSideFrame
) -> Finding | None:
    """Return the finding for a frame on the other side; None where its labels say which side it is
    of."""
    turn = field.half_turn
    names = [name for name in annotation.annotated if field.element(name) is not None]
    # A mark before the team benches, or a landmark, is on one side only.
    if turn is None or any(name not in turn.partner for name in names):
        return None
    pairs = tuple((name, turn.name_of(name)) for name in names if turn.name_of(name) != name)
    if not pairs:
        return None
    remedy = Remedy(RemedyKind.RELABEL, translatable("turn the labels by half a turn"), pairs)
    if found.opposite:
        severity = Severity.ERROR if found.stand.is_sure else Severity.WARNING
        return Finding(
            Rule.OTHER_SIDE,
            severity,
            tuple(names),
            translatable_count(
                found.opposite,
                "the camera stands on the other side of the field from the rest; with its labels"
                " turned by half a turn it stands where that of {n} frame does",
                "the camera stands on the other side of the field from the rest; with its labels"
                " turned by half a turn it stands where that of {n} frames does",
            ),
            (remedy,),
            model=found.stand.model,
        )
    return Finding(
        Rule.OTHER_SIDE,
        Severity.HINT,
        tuple(names),
        translatable_count(
            found.frames,
            "the camera stands on a side of the field where hardly any other of {n} frame does: a"
            " camera of its own, or labels turned by half a turn",
            "the camera stands on a side of the field where hardly any other of {n} frames does: a"
            " camera of its own, or labels turned by half a turn",
        ),
        (LOOK, remedy),
        model=found.stand.model,
    )
