"""Check the labels of a frame, with a fitted camera and without one.

A rule is a function of a clicked frame, and of what was found before it, that gives findings. A new
one is a member of `Rule`, and a function in the module of its family or in the table below.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.fitting import AUTO, fit_camera
from procc_annotator.fit.labels.clicked import FrameEvidence
from procc_annotator.fit.labels.finding import Finding, Rule, Severity
from procc_annotator.fit.labels.mistakes import camera_findings, suspect_elements
from procc_annotator.fit.labels.overlap import overlap_findings
from procc_annotator.fit.labels.seen_paint import LineEvidence
from procc_annotator.fit.labels.shape import shape_findings
from procc_annotator.fit.labels.short import short_end_findings
from procc_annotator.fit.labels.sides import side_findings
from procc_annotator.fit.labels.unknown import pixel_coordinate_findings, unknown_class_findings
from procc_annotator.fit.labels.unpainted import line_evidence_findings
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.models import WIDE_ANGLE_MODELS
from procc_annotator.fit.solving.observations import ImageFrame
from procc_annotator.fit.solving.strong_lens import MANY_OUTLIERS

LabelRule = Callable[[FrameEvidence, Sequence[Finding]], Iterable[Finding]]
"""A family of rules: the frame, and what is known before: that is not to be told again."""

_CAMERA_RULES: tuple[LabelRule, ...] = (camera_findings, unknown_class_findings)
_CAMERA_FREE_RULES: tuple[LabelRule, ...] = (shape_findings, overlap_findings, side_findings, short_end_findings)
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
    """What may be wrong with a frame's labels, the surest first.

    Costs a few milliseconds where the camera fits; where it does not, several further fits (some
    0.05 s, at most about 0.5 s).

    Args:
        annotation: normalised points; unconfirmed elements take no part.
        field: the elements.
        size: (width, height) px of the picture.
        fit: the camera fitted to this annotation, or its failure.
        go_on: called before each further fit; raises whatever it likes when nobody wants the rest.

    Returns:
        At most one finding about each mistake: what the camera explains is not told again by rules
        that need none.
    """
    frame = ImageFrame(size)
    if len(suspect_elements(fit, frame)) >= MANY_OUTLIERS and fit.model not in WIDE_ANGLE_MODELS:
        go_on()
        other = fit_camera(annotation, field, model=AUTO, size=size)
        if other.model in WIDE_ANGLE_MODELS and len(suspect_elements(other, frame)) < MANY_OUTLIERS:
            fit = other  # the lens is to blame, not the labels
    looked_at = FrameEvidence(annotation, field, frame, fit, go_on)
    return tuple(sorted(_drop_redundant(_apply_rules(looked_at, _CAMERA_RULES, _CAMERA_FREE_RULES)), key=_finding_order))


def add_line_evidence(
    findings: Sequence[Finding],
    annotation: FrameAnnotation,
    field: Field,
    *,
    size: tuple[int, int],
    fit: FitResult,
    paint: Mapping[str, LineEvidence],
) -> tuple[Finding, ...]:
    """What is known once the picture was looked at: the surest first.

    Ends are short only where the picture shows paint beyond them, and what it shows under and
    beside the elements is told.

    Args:
        findings: of this annotation, without the picture.
        annotation, field, size, fit: as of `check_labels`; a failure where no camera was asked for.
        paint: class -> what the picture shows along it.
    """
    if any(f.rule is Rule.PIXELS for f in findings):
        return tuple(findings)
    looked_at = FrameEvidence(annotation, field, ImageFrame(size), fit, paint=paint)
    found = [f for f in findings if f.rule is not Rule.SHORT]
    for rules in (short_end_findings, line_evidence_findings):
        found.extend(rules(looked_at, tuple(found)))
    return tuple(sorted(found, key=_finding_order))


def check_without_camera(
    annotation: FrameAnnotation, field: Field, *, size: tuple[int, int]
) -> tuple[Finding, ...]:
    """What can be seen without a camera to be wrong with a frame's labels, the surest first.

    Args:
        annotation, field, size: as of `check_labels`.
    """
    no_fit = FitResult("", size, None, failure="not asked for")
    looked_at = FrameEvidence(annotation, field, ImageFrame(size), no_fit)
    return tuple(
        sorted(_apply_rules(looked_at, (unknown_class_findings, *_CAMERA_FREE_RULES)), key=lambda f: f.severity.rank)
    )


def _apply_rules(looked_at: FrameEvidence, *stages: tuple[LabelRule, ...]) -> list[Finding]:
    """What rules find; those of one stage know what the stages before found."""
    found = list(pixel_coordinate_findings(looked_at, ()))
    if found:
        return found  # no other rule has anything to say then
    for stage in stages:
        known = tuple(found)
        for rules in stage:
            found.extend(rules(looked_at, known))
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
