"""Write automatic annotations into a dataset with the origins of their points."""

from __future__ import annotations

import os
import time
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.auto_annotation import AnnotatedPicture, AnnotationRun
from procc_annotator.batch.execution.executor import Progress
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.records import OriginKind, default_author, new_origins
from procc_annotator.errors import ChangedOnDiskError
from procc_annotator.formats.annotations.soccernet import write_annotation
from procc_annotator.formats.atomic import make_folder, write_atomic


@dataclass
class Annotated:
    """Result for a set of pictures.

    Attributes:
        frames: those that got an annotation.
        elements, points: in those.
        bare: frames in which no paint was found where their cameras show some.
        kept: frames that had got an annotation meanwhile, which stays.
        errors: pictures and cameras that cannot be used, one line each.
        remarks: on the workspace, one line each.
    """

    frames: list[str] = field(default_factory=list)
    elements: int = 0
    points: int = 0
    bare: list[str] = field(default_factory=list)
    kept: list[str] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)


def annotate_pictures(
    run: AnnotationRun,
    frames: Sequence[Frame],
    datasets: Mapping[Path, bool],
    progress: Progress[AnnotatedPicture],
    done: Annotated,
) -> None:
    """Write what a run finds as it comes: each file at once and whole, never over another one.

    Before a file is there its points are in the workspaces as proposed: a file without that would
    pass for a person's own. What a person clicked or accepted stays theirs in a workspace that is
    not that of the files, be a proposed point at the very same place.

    Args:
        frames: with the files their annotations belong in.
        datasets: folders whose workspaces are updated, and whether the files are theirs.
        done: filled on the way, so that it is right also when a person stops the work.

    Raises:
        SaveError: a file could not be written.
    """
    files = {frame.name: frame.annotation_path for frame in frames}
    author = default_author()
    for folder in {path.parent for path in files.values()}:
        make_folder(folder)
    with ExitStack() as closing:
        databases = []
        for dataset, own in datasets.items():
            database = WorkspaceDatabase.open(dataset, author)
            databases.append((database, own))
            closing.callback(_close, database, done)
            done.remarks += [n for n in database.notices if n not in done.remarks]
        for found in progress(run, run.total, "annotating"):
            done.remarks += [n for n in found.notices if n not in done.remarks]
            _write(found, files[found.name], databases, author, done)


def _write(
    found: AnnotatedPicture,
    path: Path,
    databases: Sequence[tuple[WorkspaceDatabase, bool]],
    author: str,
    done: Annotated,
) -> None:
    if found.error:
        done.errors.append(found.error)
        return
    if not found.annotation.annotated:
        done.bare.append(found.name)
        return
    if os.path.lexists(path):  # since the work began
        done.kept.append(found.name)
        return
    origins = new_origins(
        FrameAnnotation(()), found.annotation, OriginKind.PROPOSED, author, time.time()
    )
    before = []
    for database, own in databases:
        known = database.origins(found.name)
        before.append((database, {key: known[key] for key in origins if key in known}))
        put = origins if own else {key: o for key, o in origins.items() if key not in known}
        database.put_origins(found.name, put)
        database.flush()

    def none_there() -> None:
        if path.exists():
            raise ChangedOnDiskError(f"{path}: is there by now, not replaced")

    try:
        write_atomic(path, write_annotation(found.annotation), look_again=none_there)
    except ChangedOnDiskError:
        for database, known in before:
            database.put_origins(found.name, known)
        done.kept.append(found.name)
        return
    done.frames.append(found.name)
    done.elements += len(found.annotation.annotated)
    done.points += sum(len(polyline.points) for polyline in found.annotation.polylines)


def _close(database: WorkspaceDatabase, done: Annotated) -> None:
    if not database.close() or database.problem:
        why = database.problem or "it does not take them"
        done.remarks.append(f"that the points are proposed could not be kept: {why}")
