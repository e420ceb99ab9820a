"""Mend what a finding is about: pure edits of an annotation, whole classes at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.fit.labels.finding import Finding, Remedy, RemedyKind
from procc_annotator.session.dataset.edits import delete_point


def apply_remedy(
    annotation: FrameAnnotation, finding: Finding, remedy: Remedy, field: Field | None = None
) -> FrameAnnotation:
    """The annotation with a finding mended; its points stay where they are.

    Args:
        annotation: what the finding is about.
        finding: of this annotation.
        remedy: one of the finding's.
        field: for the titles in messages; without it they name the classes of the file.

    Returns:
        The same annotation for `LOOK`, which is for eyes, and `FOLLOW`, which wants the picture.

    Raises:
        UsageError: the annotation is another one by now, or two elements would get one class.
    """
    if remedy.kind in (RemedyKind.LOOK, RemedyKind.FOLLOW):
        return annotation
    if remedy.kind is RemedyKind.REMOVE_POINT:
        return _without_point(annotation, finding, field)
    return rename_classes(annotation, dict(remedy.renamed), field)


def rename_classes(
    annotation: FrameAnnotation, names: Mapping[str, str], field: Field | None = None
) -> FrameAnnotation:
    """Give classes other names, all at once, so that they may exchange them; the order stays.

    A class without points gives way, and so does an unconfirmed element of a new name.

    Args:
        annotation: with all the classes.
        names: class -> class it becomes.
        field: as for `apply_remedy`.

    Raises:
        UsageError: a class is not annotated, or would be annotated twice.
    """
    for name in names:
        if name not in annotation.annotated:
            raise UsageError(f"{_title(name, field)} is not annotated any more; look again")
    becoming = list(names.values())
    for name in becoming:
        if becoming.count(name) > 1 or (name in annotation.annotated and name not in names):
            raise UsageError(
                f"{_title(name, field)} is annotated already, and an element is annotated once;"
                " remove one of the two first"
            )
    kept = tuple(
        replace(p, class_name=names.get(p.class_name, p.class_name))
        for p in annotation.polylines
        if p.points or p.class_name not in becoming
    )
    hidden = tuple(p for p in annotation.unconfirmed if p.class_name not in becoming)
    return replace(annotation, polylines=kept, unconfirmed=hidden)


def _without_point(
    annotation: FrameAnnotation, finding: Finding, field: Field | None
) -> FrameAnnotation:
    name = finding.elements[0]
    polyline = annotation.get(name)
    if finding.point is None or polyline is None or finding.point >= len(polyline.points):
        raise UsageError(f"{_title(name, field)} has no such point any more; look again")
    return delete_point(annotation, name, finding.point)


def _title(name: str, field: Field | None) -> str:
    return name.strip() if field is None else field.title_of(name)
