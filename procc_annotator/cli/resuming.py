"""Runs that may be stopped, and gone on with by ``--resume``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import typer

from procc_annotator.batch.unit_store import UnitStore
from procc_annotator.cli.echo import echo
from procc_annotator.errors import UsageError
from procc_annotator.messages import pluralize
from procc_annotator.report.outputs import Interrupted, is_archive


def is_resuming(left: Path, table: Path, out: Path, *, resume: bool, overwrite: bool) -> bool:
    """Return whether a run goes on with what another one left.

    Args:
        left: see `procc_annotator.batch.unit_store.unfinished_path`.
        table: what is written last; an archive is written as a whole.
        out: of the command.

    Raises:
        UsageError: both was asked for; or neither, and a person's work would be lost.
        typer.Exit: a run was finished here, nothing is to be gone on with.
    """
    if resume and overwrite:
        raise UsageError("--resume goes on and --overwrite begins anew: give one of them")
    if not left.exists():
        done = out if is_archive(out) else table
        if resume and done.exists():
            echo(
                f"{out}: already complete: {done.name} is there and no run was stopped here;"
                " --overwrite begins anew, with other options for example"
            )
            raise typer.Exit
        return False
    if not resume and not overwrite:
        raise UsageError(
            f"{out}: a run was stopped here; --resume goes on with it, --overwrite begins anew"
        )
    return resume


@contextmanager
def resumable(
    left: Path, settings: Mapping[str, str], out: Path, table: str, noun: str, *, resume: bool
) -> Iterator[UnitStore]:
    """The unit store of a run with these settings; a person who stops it learns how many of its
    files (such as ``sure camera``) are in OUT without the table, and how to go on."""
    try:
        with UnitStore(left, settings, resume=resume) as kept:
            yield kept
            kept.finish()
    except Interrupted as stopped:
        if is_archive(out):
            said = f"{out} was not written"
        elif not stopped.written:
            said = f"no {noun} was written"
        else:
            done = f"{pluralize(stopped.written, noun)} of {pluralize(stopped.total, 'frame')}"
            said = f"{done} written to {out}, {table} not"
        raise KeyboardInterrupt(f"{said}; run it again with --resume to go on") from None
