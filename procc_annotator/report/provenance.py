"""Provenance of a dataset's points: who or what made each of them, and when."""

from __future__ import annotations

import json
from collections.abc import Callable, Container
from pathlib import Path
from typing import Any

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.review import read_commit, setting_of
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.report.export import Exported

_FORMAT = "procc-annotator provenance 1"


def export_provenance(
    workspace: Workspace,
    database: WorkspaceDatabase | None,
    path: Path,
    progress: Callable[[int, int], None] | None = None,
    *,
    only: Container[str] | None = None,
) -> Exported:
    """Write a JSON file of the origins of all points, or of those in ``only`` some frames.

    ``frames``: one entry a frame and class, in the order of the points: ``[origin, author, unix
    time]``. Points that nothing is known of are ``null``: they come from a file. ``blind``: one
    entry a frame that was committed in blind mode: whether it still is as it was then, or edited
    after the cameras were shown, who committed it, and when.

    Raises:
        InputError: the database cannot be read, as once another dataset was opened.
        SaveError: it could not be written.
    """
    exported = Exported(path)
    frames: dict[str, Any] = {}
    blind: dict[str, Any] = {}
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
        if not annotation.annotated:
            continue
        exported.annotations += 1
        origins = {}
        if database is not None:
            origins = database.read_origins(frame.name)
            commit = read_commit(database.setting(setting_of(frame.name)))
            if commit is not None:
                blind[frame.name] = [commit.work(annotation).value, commit.author, commit.time]
        found = {
            line.class_name: [origins.get((point.u, point.v)) for point in line.points]
            for line in annotation.polylines
            if line.points
        }
        frames[frame.name] = {
            name: [one and [one.kind.value, one.author, one.time] for one in points]
            for name, points in found.items()
        }
    entries = ",\n".join(f'  "{key}": {_object(own)}' for key, own in
                         (("frames", frames), ("blind", blind)))  # fmt: skip
    write_atomic(path, f'{{\n  "format": "{_FORMAT}",\n{entries}\n}}\n'.encode())
    return exported


def _object(entries: dict[str, Any]) -> str:
    """A JSON object with one entry a line."""
    lines = (f"  {_json(key)}: {_json(value)}" for key, value in entries.items())
    return "{{\n{}\n  }}".format(",\n".join(lines))


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)
