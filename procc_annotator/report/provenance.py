"""The provenance of a dataset as a sidecar file."""

from __future__ import annotations

import json
from collections.abc import Callable, Container, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.io.atomic import write_atomic
from procc_annotator.report.export import Exported
from procc_annotator.session.database.database import WorkspaceDatabase
from procc_annotator.session.dataset.workspace import Workspace
from procc_annotator.session.facts.blind_work import BlindCommit, read_commit, setting_of
from procc_annotator.session.facts.origins import Origin, PointKey

PROVENANCE_FORMAT = "procc-annotator provenance 1"


@dataclass(frozen=True)
class FrameProvenance:
    """What is known of how a frame's clicks came to be.

    Attributes:
        origins: of its points.
        blind: its first commit, if that was in blind mode.
    """

    name: str
    annotation: FrameAnnotation
    origins: Mapping[PointKey, Origin]
    blind: BlindCommit | None = None


def export_provenance(
    workspace: Workspace,
    database: WorkspaceDatabase | None,
    path: Path,
    progress: Callable[[int, int], None] | None = None,
    *,
    only: Container[str] | None = None,
) -> Exported:
    """Write how every point of the annotated frames came to be; see `provenance_json`.

    Args:
        only: names of frames, where nothing is to be told of others.

    Raises:
        InputError: the database cannot be read, as once another dataset was opened.
        SaveError: it could not be written.
    """
    exported = Exported(path)

    def frames() -> Iterator[FrameProvenance]:
        for index, frame in enumerate(workspace.frames):
            if progress is not None and index % 100 == 0:
                progress(index, len(workspace.frames))
            if only is not None and frame.name not in only:
                continue
            try:
                annotation = workspace.read(index)
            except InputError as error:
                exported.problems.append(str(error))
                continue
            if annotation.annotated:
                exported.annotations += 1
                yield _known(frame.name, annotation, database)

    write_atomic(path, provenance_json(frames()))
    return exported


def _known(
    name: str, annotation: FrameAnnotation, database: WorkspaceDatabase | None
) -> FrameProvenance:
    if database is None:
        return FrameProvenance(name, annotation, {})
    commit = read_commit(database.setting(setting_of(name)))
    return FrameProvenance(name, annotation, database.read_origins(name, complete=True), commit)


def provenance_json(frames: Iterable[FrameProvenance]) -> bytes:
    """``frames``: one entry a frame and class, in the order of the points: ``[origin, author, unix
    time]``. Points that nothing is known of are ``null``: they come from a file. ``blind``: one
    entry a frame that was committed in blind mode: whether it still is as it was then, or edited
    after the cameras were shown, who committed it, and when.
    """
    lines, blind = [], []
    for frame in frames:
        if frame.annotation.annotated:
            lines.append(f"  {_json(frame.name)}: {_json(_frame(frame.annotation, frame.origins))}")
            if (commit := frame.blind) is not None:
                entry = [commit.work(frame.annotation).value, commit.author, commit.time]
                blind.append(f"  {_json(frame.name)}: {_json(entry)}")
    parts = [f'  "format": {_json(PROVENANCE_FORMAT)}']
    for key, entries in (("frames", lines), ("blind", blind)):
        body = ",\n".join(entries)
        parts.append(f'  "{key}": {{\n{body}\n  }}')
    text = ",\n".join(parts)
    return f"{{\n{text}\n}}\n".encode()


def _frame(
    annotation: FrameAnnotation, origins: Mapping[PointKey, Origin]
) -> dict[str, list[list[object] | None]]:
    return {
        polyline.class_name: [_entry(origins.get((p.u, p.v))) for p in polyline.points]
        for polyline in annotation.polylines
        if polyline.points
    }


def _entry(origin: Origin | None) -> list[object] | None:
    return None if origin is None else [origin.kind.value, origin.author, origin.time]


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)
