"""A command of one source for the matches of a season, one after the other."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import typer

from procc_annotator.cli.echo import echo
from procc_annotator.cli.remarks import report_remarks
from procc_annotator.dataset.layout import holds_annotations
from procc_annotator.dataset.remote_files import remove_copies
from procc_annotator.dataset.season import Match, annotations_beside, list_matches
from procc_annotator.errors import ProccError
from procc_annotator.formats.cameras.packed import PACKED_SUFFIX


def place_of_match(root: Path | None, match: Match, *suffixes: str) -> Path | None:
    """Return where annotations or cameras of a match lie below those of its season, in a folder or
    a file of one of some suffixes (by default ``.npz`` and ``.zip``); None if there are none."""
    if root is None:
        return None
    wanted = suffixes or (PACKED_SUFFIX, "", ".zip")
    return next((own for end in wanted if (own := root / f"{match.name}{end}").exists()), None)


def annotations_of_match(root: Path | None, match: Match) -> Path | None:
    """The same of annotations; those next to the match's video, if the root is its season."""
    own, season = annotations_beside(match), root if root is None or root.is_dir() else root.parent
    is_own = match.name and season and own.resolve().is_relative_to(season.resolve())
    return own if is_own and holds_annotations(own) else place_of_match(root, match)


def for_each_match(source: Path, once: Callable[[Match], None]) -> None:
    """Call a command for each match of a season; a single source is one without a name.

    What one match fails with is said, and the others follow.

    Raises:
        typer.Exit: of a season: 1 if some match had problems.
        UsageError, InputError: as of `list_matches`.
    """
    matches = list_matches(source, lambda text: report_remarks([text]))
    if matches is None:
        once(Match("", source))
        return
    code = 0
    for match in matches:
        echo(f"{match.name}:")
        try:
            once(match)
        except typer.Exit as end:
            code = max(code, min(end.exit_code, 1))
        except ProccError as error:
            echo(f"{match.name}: {error}", err=True)
            code = 1
        remove_copies(match.pictures)
    raise typer.Exit(code)
