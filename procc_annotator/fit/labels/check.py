"""Check the labels of a frame, with a fitted camera and without one."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.landmarks import known_covariances
from procc_annotator.field.model import Field
from procc_annotator.fit.labels.clicked import Clicked, clicked_elements
from procc_annotator.fit.labels.finding import Finding, Rule, Severity
from procc_annotator.fit.labels.limits import limit_of, off_px
from procc_annotator.fit.labels.mistakes import mistakes, suspects_of
from procc_annotator.fit.labels.overlap import overlap_findings
from procc_annotator.fit.labels.shape import shape_findings
from procc_annotator.fit.labels.short import short_findings
from procc_annotator.fit.labels.sides import side_findings
from procc_annotator.fit.labels.unknown import pixel_findings, unknown_findings
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.observations import Frame
from procc_annotator.fit.solving.search import MINIMUM_ELEMENTS

_RULES = {
    rule: rank
    for rank, rule in enumerate(
        (
            Rule.PIXELS,
            Rule.UNKNOWN_CLASS,
            Rule.REFLECTED,
            Rule.SWAPPED,
            Rule.RESIDUAL,
            Rule.POINT,
            Rule.SIDE,
            Rule.COINCIDENT,
            Rule.BENT,
            Rule.REPEATED,
            Rule.MANY_POINTS,
            Rule.FEW_POINTS,
            Rule.SHORT,
        )
    )
}


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
    pixels = pixel_findings(annotation)
    if pixels:
        return pixels
    frame = Frame(size)
    clicked = clicked_elements(annotation, field, frame)
    found = list(by_camera(annotation, field, frame, fit, clicked, go_on))
    found.extend(unknown_findings(annotation, field))
    found.extend(by_eye(field, frame, fit, clicked, found))
    return tuple(sorted(_once(found), key=_sureness))


def by_camera(
    annotation: FrameAnnotation,
    field: Field,
    frame: Frame,
    fit: FitResult,
    clicked: Sequence[Clicked],
    go_on: Callable[[], None] = lambda: None,
) -> tuple[Finding, ...]:
    """What does not fit the camera of the other elements; nothing where all of it does."""
    if len(clicked) < MINIMUM_ELEMENTS:
        return ()
    if fit.camera is not None and not suspects_of(fit, frame):
        return ()
    return mistakes(annotation, field, frame, fit, go_on)


def by_eye(
    field: Field,
    frame: Frame,
    fit: FitResult,
    clicked: Sequence[Clicked],
    known: Sequence[Finding],
) -> list[Finding]:
    """What can be seen without a camera.

    Args:
        field: the elements.
        frame: the picture.
        fit: of the annotation; what it explains is in order.
        clicked: annotated elements.
        known: what the camera found; not to be told again.
    """
    limit = limit_of(fit, frame)
    fits = {e.name for e in fit.elements if off_px(e, frame) <= limit}
    sure = {name for f in known if f.severity is Severity.ERROR for name in f.elements}
    reflected = any(f.rule is Rule.REFLECTED for f in known)
    found = [
        finding
        for one in clicked
        for finding in shape_findings(one, frame)
        if finding.rule is not Rule.BENT or one.name not in fits | sure
    ]
    if not reflected:
        found.extend(
            f for f in overlap_findings(clicked, field, frame, fits) if sure.isdisjoint(f.elements)
        )
    # A pinhole that fits everything is above the ground and sees nothing the wrong way round.
    whole = isinstance(fit.camera, PinholeCamera) and len(fits) == len(fit.elements)
    if not whole and not any(f.severity is Severity.ERROR for f in known):
        mended = {name for f in known for r in f.remedies for name, _ in r.renamed}
        # Which side something lies on is known of what is known exactly.
        uncertain = known_covariances(field)
        exact = [one for one in clicked if one.name not in uncertain]
        sides = side_findings(exact, field, frame)
        found.extend(f for f in sides if mended.isdisjoint(f.elements))
    return [*found, *short_findings(clicked, field, frame, fit if whole else None, sure)]


def _once(found: Sequence[Finding]) -> list[Finding]:
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


def _sureness(finding: Finding) -> tuple[int, int, float]:
    return finding.severity.rank, _RULES[finding.rule], -(finding.error_px or 0.0)
