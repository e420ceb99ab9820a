"""Classes that the field does not know, and coordinates that are none of a picture."""

from __future__ import annotations

import difflib
from collections.abc import Sequence

from procc_annotator.annotation import FrameAnnotation, pixel_like
from procc_annotator.field.model import Field
from procc_annotator.fit.fitting import pixel_coordinates_error
from procc_annotator.fit.labels.clicked import FrameEvidence
from procc_annotator.fit.labels.finding import LOOK, Finding, Remedy, RemedyKind, Rule, Severity
from procc_annotator.language import translatable, translatable_joined

# Of two spellings this alike one is a slip of the pen; 1 is the same.
_MIN_NAME_SIMILARITY = 0.75


def unknown_class_findings(looked_at: FrameEvidence, known: Sequence[Finding]) -> tuple[Finding, ...]:
    """Annotated classes that the field does not know; those without geometry are known.

    Returns:
        An error where a class is nearly called so, with the right name if it is free; else a
        warning, for no fit uses the element and no camera can show it.
    """
    annotation, field = looked_at.annotation, looked_at.field
    return tuple(
        _unknown_class_finding(name, annotation, field)
        for name in annotation.annotated
        if not field.knows(field.canonical_name(name))
    )


def pixel_coordinate_findings(looked_at: FrameEvidence, known: Sequence[Finding]) -> tuple[Finding, ...]:
    """One error if the coordinates look like pixels; then no other rule has anything to say."""
    annotation = looked_at.annotation
    strange = pixel_like(annotation)
    if strange is None:
        return ()
    return (
        Finding(Rule.PIXELS, Severity.ERROR, annotation.annotated, pixel_coordinates_error(strange), (LOOK,)),
    )


def _unknown_class_finding(name: str, annotation: FrameAnnotation, field: Field) -> Finding:
    meant = _most_similar_class(name, field)
    shown = name.strip()
    if meant is None:
        reason = translatable(
            "no such class: {name!r} fits no camera, and counts as missed where it is scored",
            name=shown,
        )
        return Finding(Rule.UNKNOWN_CLASS, Severity.WARNING, (name,), reason, (LOOK,))
    title = translatable(field.title_of(meant))
    words = title if title == meant.strip() else translatable_joined("", (title, f" ({meant.strip()})"))
    reason = translatable("no such class: {name!r}, did you mean {title}?", name=shown, title=words)
    remedies: tuple[Remedy, ...] = (LOOK,)
    if meant in annotation.annotated:
        reason = translatable_joined(" ", (reason, translatable("That is annotated already")))
    else:
        text = translatable("relabel to {title}", title=title)
        relabel = Remedy(RemedyKind.RELABEL, text, ((name, meant),))
        remedies = (relabel, LOOK)
    return Finding(Rule.UNKNOWN_CLASS, Severity.ERROR, (name,), reason, remedies)


def _most_similar_class(name: str, field: Field) -> str | None:
    """The class whose name or title is most alike; None if none is."""
    names = [*(e.name for e in field.elements), *field.classes_without_geometry]
    spellings = {e.title.casefold(): e.name for e in field.elements}
    spellings |= {known.strip().casefold(): known for known in names}
    close = difflib.get_close_matches(name.strip().casefold(), spellings, n=1, cutoff=_MIN_NAME_SIMILARITY)
    return spellings[close[0]] if close else None
