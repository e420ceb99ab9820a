"""The provenance of a dataset as a sidecar file."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.io.atomic import write_atomic
from procc_annotator.report.export import Exported
from procc_annotator.session.origins import Origin, PointKey
from procc_annotator.session.workspace import Workspace
from procc_annotator.session.workspace_database.database import WorkspaceDatabase

FORMAT = "procc-annotator provenance 1"

_Frames = Iterator[tuple[str, FrameAnnotation, Mapping[PointKey, Origin]]]


def export_provenance(
    workspace: Workspace,
    database: WorkspaceDatabase | None,
    path: Path,
    progress: Callable[[int, int], None] | None = None,
) -> Exported:
    """Write how every point of the annotated frames came to be; see `provenance_json`.

    Raises:
        SaveError: it could not be written.
    """
    exported = Exported(path)

    def frames() -> _Frames:
        for index, frame in enumerate(workspace.frames):
            if progress is not None and index % 100 == 0:
                progress(index, len(workspace.frames))
            try:
                annotation = workspace.read(index)
            except InputError as error:
                exported.problems.append(str(error))
                continue
            if annotation.annotated:
                exported.annotations += 1
                yield frame.name, annotation, database.origins(frame.name) if database else {}

    write_atomic(path, provenance_json(frames()))
    return exported


def provenance_json(
    frames: Iterable[tuple[str, FrameAnnotation, Mapping[PointKey, Origin]]],
) -> bytes:
    """One entry a frame and class, in the order of the points: ``[origin, author, unix time]``.

    Points that nothing is known of are ``null``: they come from a file.

    Args:
        frames: name, annotation, and what is known of its points.
    """
    lines = [
        f"  {_json(name)}: {_json(_frame(annotation, origins))}"
        for name, annotation, origins in frames
        if annotation.annotated
    ]
    body = ",\n".join(lines)
    return f'{{\n  "format": {_json(FORMAT)},\n  "frames": {{\n{body}\n  }}\n}}\n'.encode()


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
