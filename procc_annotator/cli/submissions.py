"""Scoring a submission of polylines: what `evaluate --submission` asks of it first."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.field.fingerprint import field_fingerprint
from procc_annotator.io.camera_files.polyline_submission import (
    POLYLINES,
    method_of,
    read_manifest,
    require_made_for,
)
from procc_annotator.metric.setup import EvaluationSetup

Submission = Annotated[
    Path | None,
    typer.Option(
        "--submission",
        metavar="ZIP",
        show_default=False,
        help="A submission of polylines in place of CAMERAS; one that was made for another"
        " protocol, field, size or other frames is refused.",
    ),
]


def submitted_source(path: Path) -> str:
    """The submission as a source of cameras, named as its manifest says.

    Raises:
        InputError: it is no submission of polylines.
    """
    return f"{method_of(read_manifest(path))}:{POLYLINES}={path}"


def require_submitted_for(
    path: Path, setup: EvaluationSetup, frames: Mapping[str, Collection[str]]
) -> None:
    """Refuse a submission that was made for something else.

    Args:
        setup: what it is to be evaluated with.
        frames: names of the annotated frames of the set.

    Raises:
        UsageError: what differs.
    """
    every = [name for names in frames.values() for name in names]
    require_made_for(
        path, read_manifest(path), protocol=setup.protocol,
        field_sha256=field_fingerprint(setup.field), size=setup.size, frames=every,
    )  # fmt: skip
