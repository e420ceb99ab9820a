"""An earlier version in place of a file that cannot be read."""

from __future__ import annotations

from procc_annotator.errors import AnnotationError
from procc_annotator.io.atomic import write_atomic
from procc_annotator.io.source import read_optional
from procc_annotator.language import word
from procc_annotator.session.dataset.workspace import Workspace


def restore_version(workspace: Workspace, index: int, data: bytes) -> None:
    """Write what a version holds over a frame's file, which stays a version.

    Raises:
        InputError: what is there cannot be looked at.
        SaveError: it could not be written.
    """
    frame = workspace.frames[index]
    if (found := read_optional(frame.annotation_path, AnnotationError)) is not None:
        workspace.memory.keep(frame.name, found, word("as it was found"))
    write_atomic(frame.annotation_path, data, inside=workspace.root)
