"""``procc-annotator status``: how far a run over a season is."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.unit_store import SOURCE, MatchUnits, UnitStore
from procc_annotator.cli import outputs, remarks
from procc_annotator.cli.console import stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.cli.tracked_matches import set_aside
from procc_annotator.dataset.remote_files import working_folder
from procc_annotator.dataset.season import STORE_FILE, list_matches
from procc_annotator.errors import ProccError, UsageError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.report.page.status import status_bytes, status_kind
from procc_annotator.report.tracking import season_progress, season_table

HELP = """\
OUT is the output folder of track; the run may still be active. One row per match: state, frames,
units of work, frames per second of one process, mean coverage (0 in frames without a camera), last
change. Then the progress, the speed of the last half hour, the remaining work, and units that were
set aside, with the reason.

Exit code: 0; 1 if units were set aside.
"""

EXAMPLE = """\
  procc-annotator track sample_data/shot/ tracked/
  procc-annotator status tracked/
  procc-annotator status tracked/ --price 0.05 --output status.html
"""


def status(
    out: Annotated[Path, typer.Argument(help="Folder that track writes to.")],
    price: Annotated[
        float | None,
        typer.Option(
            min=0.0, metavar="COST", help="Of an hour of work in one process, for the costs."
        ),
    ] = None,
    output: Annotated[
        list[Path] | None,
        typer.Option(
            "--output", "-o", metavar="FILE", help="Write .html, .csv or .json; repeatable."
        ),
    ] = None,
) -> None:
    files = outputs.output_files(output, status_kind)
    out = working_folder(out)
    if not (out / STORE_FILE).exists():
        raise UsageError(f"{out}: holds no {STORE_FILE} (expected a folder that track writes to)")
    with UnitStore.read(out / STORE_FILE) as store:
        matches = _listed(store)
        sheet, progress = season_table(matches), season_progress(matches, store, time.time(), price)
        failed = set_aside(store, {one.match for one in matches})
    stdout_console().print(sheet)
    echo(progress[0])
    for file in files:
        write_atomic(file, status_bytes(file, out.name, sheet, progress, failed))
        echo(f"written: {file}")
    raise typer.Exit(remarks.report_unreadable(failed, "set aside"))


def _listed(store: UnitStore) -> list[MatchUnits]:
    """The matches of the season as it is now; all, if it was moved."""
    try:
        source = store.terms.get(SOURCE)
        names = {match.name for match in (source and list_matches(Path(source))) or ()}
    except ProccError:
        names = set()
    return [one for one in store.matches() if one.match in names] or store.matches()
