"""``procc-annotator status``: how far a run over a season is."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.unit_store import FAILED, UnitStore
from procc_annotator.cli import remarks
from procc_annotator.cli.console import stdout_console
from procc_annotator.cli.track import STORE_FILE
from procc_annotator.errors import UsageError
from procc_annotator.report.tracking import season_table

HELP = """\
OUT is a folder that track writes to, or wrote to; the run may go on meanwhile. A row a match: units
of work by state, frames followed, frames per second of work in one process, mean share of the
visible model on paint, when it last changed. Units that were set aside are listed with the reason.

Exit code: 0; 1 if units were set aside.
"""

EXAMPLE = """\
  procc-annotator status tracked/
"""

Out = Annotated[Path, typer.Argument(help="Folder that track writes to.")]


def status(out: Out) -> None:
    if not (out / STORE_FILE).exists():
        raise UsageError(f"{out}: holds no {STORE_FILE} (expected a folder that track writes to)")
    with UnitStore.read(out / STORE_FILE) as store:
        stdout_console().print(season_table(store))
        failed = [f"{unit.key}: {unit.error}" for unit in store.units(FAILED)]
    raise typer.Exit(remarks.report_unreadable(failed, "set aside"))
