"""``procc-annotator assign``: give out the frames of a dataset to annotators, blind."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli import chance_options, datasets
from procc_annotator.cli.console import stdout_console, with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.field_option import chosen_field
from procc_annotator.errors import SaveError, UsageError
from procc_annotator.field.load import is_shipped
from procc_annotator.field.model import Field
from procc_annotator.io.frame_names import FrameTable
from procc_annotator.report.assigning import PLAN_FILE, counts_sheet, write_assignments
from procc_annotator.session.database.database import WorkspaceDatabase
from procc_annotator.session.dataset.dataset_field import (
    field_of_dataset,
    keep_dimensions,
    keep_field,
    keep_lines,
    own_field_file,
)
from procc_annotator.session.dataset.dataset_folder import FIELD_FILE, OWN_THINGS
from procc_annotator.session.dataset.gold_file import GOLD_FILE, read_gold
from procc_annotator.session.facts.origins import default_author
from procc_annotator.session.runs.assignments import StudyTerms, assign_frames
from procc_annotator.words import count_of, listed

HELP = """\
OUT gets a folder of pictures for each annotator, a dataset of their own without any annotation, and
plan.csv, which says who got which frame and why: it is for whoever runs the study.

Frames are dealt out evenly, in number and over matches or shots (--tags and --balance; else shots
by frames.csv or names). --overlap is the share of them that --copies annotators get, every group of
annotators as often. Frames that DATASET/gold.csv names (a column 'frame') are gold: the annotations
of DATASET are their answers. They lie among the others, nothing marks them, and everybody gets as
many. `agree` then compares the annotators, `gold` says how far each is from the answers.

Exit code: 0; 2 if there was nothing to do.
"""

EXAMPLE = """
Example:

\b
  procc-annotator assign match/ study/ --annotators anna,ben,cleo --overlap 0.3 --gold-each 10
"""


@dataclass(frozen=True)
class AskedToAssign:
    """What `assign` is asked for."""

    dataset: datasets.Dataset
    out: Annotated[Path, typer.Argument(help="Folder to write.")]
    annotators: Annotated[
        str, typer.Option(metavar="A,B,...", help="Names of the annotators, and of their folders.")
    ]
    overlap: Annotated[
        float,
        typer.Option(
            min=0.0, max=1.0, metavar="SHARE", help="Share of the frames that several get."
        ),
    ] = 0.2
    copies: Annotated[
        int, typer.Option(min=2, metavar="N", help="Annotators who get such a frame.")
    ] = 2
    gold: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.csv", show_default=False, help="Gold frames.  [default: the dataset's]"
        ),
    ] = None
    gold_each: Annotated[
        int | None,
        typer.Option(
            min=0, metavar="N", show_default=False, help="Gold frames for each.  [default: all]"
        ),
    ] = None
    tags: chance_options.TagsFile = None
    balance: Annotated[
        str | None,
        typer.Option(
            metavar="TAG|shot|none", show_default=False, help="What to deal out evenly over."
        ),
    ] = None
    seed: Annotated[int, typer.Option(min=0, metavar="N", help="Of the draw.")] = 1


def assign(given: AskedToAssign) -> None:
    terms = StudyTerms(
        _names(given.annotators), given.overlap, given.copies, given.gold_each, given.seed
    )
    workspace = datasets.open_dataset(given.dataset, chosen_field(None, given.dataset))
    folder = workspace.folder
    if given.out.resolve().is_relative_to(folder.resolve()):
        raise UsageError(f"{given.out}: lies in the dataset, write to another place")
    frames = [frame.name for frame in workspace.frames]
    marked = _gold_frames(given.gold or folder / GOLD_FILE, given.gold is not None, workspace.index)
    alike = chance_options.clustering(given.tags, given.balance, [folder])(frames)
    # Where every frame stands for itself there is nothing to be even over.
    parts = dict(zip(frames, map(str, alike.numbers), strict=True)) if alike.by != "none" else {}
    assigned = assign_frames(frames, parts, marked, terms)
    own = {name: folder / name for name in OWN_THINGS if (folder / name).is_file()}
    shown = field_of_dataset(folder)
    source = shown.field.source
    if source is not None and not is_shipped(source):
        own[FIELD_FILE] = source
    pictures = {frame.name: frame.image_path for frame in workspace.frames}
    write_assignments(assigned, pictures, own, given.out, progress=with_progress)
    if shown.chosen:
        for name in terms.annotators:
            _remember_field(given.out / name, shown.field)
    stdout_console().print(counts_sheet(assigned, parts, terms))
    even = "" if not parts else f", even over {alike.described}"
    echo(f"{count_of(len(frames), 'frame')}, {len(marked)} of them gold{even}, seed {given.seed}")
    echo(f"written: {given.out} (keep {PLAN_FILE} to yourself)")


def _remember_field(folder: Path, field: Field) -> None:
    """An annotator's dataset shows the field that the dataset shows."""
    database = WorkspaceDatabase.open(folder, default_author())
    try:
        if own_field_file(folder) is None:
            keep_field(database, folder, field)
        else:
            keep_dimensions(database, field)
            keep_lines(database, field)
    finally:
        kept = database.close()
    if not kept:
        raise SaveError(f"{folder}: its field cannot be kept: {database.problem}")


def _names(text: str) -> tuple[str, ...]:
    names = tuple(name.strip() for name in text.split(","))
    for name in names:
        if (
            not name
            or name in (".", "..", PLAN_FILE)
            or any(mark in name for mark in '/\\:*?"<>|\0')
        ):
            raise UsageError(f"--annotators: {name!r} is not the name of a folder")
    return names


def _gold_frames(path: Path, asked: bool, frames: FrameTable[int]) -> tuple[str, ...]:
    if not asked and not path.is_file():
        return ()
    found = read_gold(path)
    if strange := [name for name in found if name not in frames]:
        raise UsageError(f"{path}: {listed(strange, 'frame')} not in the dataset")
    return tuple(dict.fromkeys(filter(None, map(frames.name_there, found))))
