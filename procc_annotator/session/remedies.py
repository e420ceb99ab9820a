"""Do what a finding's remedy says: a pure edit of the annotation."""

from __future__ import annotations

from dataclasses import replace

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.fit.labels.finding import Finding, Remedy, RemedyKind
from procc_annotator.session import edits


def apply_remedy(annotation: FrameAnnotation, finding: Finding, remedy: Remedy) -> FrameAnnotation:
    """The annotation once a finding is mended; `LOOK` changes nothing.

    Points keep their coordinates, hence what is known of where they came from.

    Args:
        annotation: that was checked.
        finding: of it.
        remedy: one of the finding's.
    """
    if remedy.kind is RemedyKind.REMOVE_POINT and finding.point is not None:
        return edits.delete_point(annotation, finding.elements[0], finding.point)
    renamed = dict(remedy.renamed)
    return replace(
        annotation,
        polylines=tuple(
            replace(p, class_name=renamed.get(p.class_name, p.class_name))
            for p in annotation.polylines
        ),
    )
