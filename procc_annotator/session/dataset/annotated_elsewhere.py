"""Whether the pictures of a dataset are annotated in files of another program that lie there."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from procc_annotator.errors import InputError, UsageError
from procc_annotator.io.annotation_files.annotation_formats import PLAIN, detect_formats
from procc_annotator.io.source import open_source
from procc_annotator.session.dataset.dataset_folder import annotations_of


@dataclass(frozen=True)
class ForeignAnnotations:
    """Annotations of another program.

    Attributes:
        place: their folder.
        title: of their format.
    """

    place: Path
    title: str


def find_foreign_annotations(folder: Path) -> ForeignAnnotations | None:
    """What lies in a dataset's folder of another program; None where there is nothing of the kind,
    where it is of several formats, or beside annotations of this program, for then somebody has
    taken it in already."""
    try:
        place = annotations_of(folder)
        with open_source(place) as source:
            told = detect_formats(source)
    except (InputError, UsageError):  # is told by whoever needs it
        return None
    if len(told) != 1 or told[0].name == PLAIN:
        return None
    return ForeignAnnotations(place, told[0].title)
