"""``procc-annotator release``: publish a dataset."""

from __future__ import annotations

import datetime
import re
import tempfile
from collections import Counter
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.agreement import AgreementRun
from procc_annotator.batch.label_check import CheckRun
from procc_annotator.batch.unit_store import unfinished_path
from procc_annotator.cli import options, outputs, remarks
from procc_annotator.cli.console import progress_bar, with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.options import chosen_field
from procc_annotator.cli.set_fits import fit_sizes
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.database.location import database_path, fallback_path_of, read_settings
from procc_annotator.dataset.layout import (
    FIELD_FILE,
    STADIUMS_FILE,
    annotations_of,
    folder_of_dataset,
)
from procc_annotator.dataset.picture_sizes import PictureSizes
from procc_annotator.dataset.records import default_author
from procc_annotator.dataset.review import ignored_keys
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.load import field_fingerprint
from procc_annotator.field.model import Field
from procc_annotator.formats.csv_tables import read_frame_table
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import RELEASE_FILE, FileSource, read_file
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.messages import list_names, pluralize
from procc_annotator.report import agreement, label_check
from procc_annotator.report.outputs import is_archive
from procc_annotator.report.provenance import export_provenance
from procc_annotator.report.release import (
    AGREEMENT_FILE,
    FIELD_COPY,
    FINDINGS_FILE,
    PROVENANCE_FILE,
    Release,
    ReleaseDescription,
    count_origins,
    gather_frames,
    write_release,
)

HELP = """\
OUT, a folder or .zip, gets the annotations, splits, the SHA-256 of every annotation and picture
(index.csv), provenance, findings of the label check, a dataset card (README.md), Croissant metadata
and a changelog since --previous. Pictures are included only with --pictures, since footage often
must not be redistributed. DATASET is not changed.

Exit code: 0; 1 if some files were left out (listed); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator release sample_data match-1.0/ --version 1.0 --licence CC-BY-4.0
  procc-annotator release sample_data match-1.1/ --version 1.1 --licence CC-BY-4.0 \\
      --second-annotator sample_data/second_annotator --previous match-1.0/
"""

_AGREEMENT_TAU = 5.0
_SPLIT = re.compile(r"[\w][\w .\-]{0,60}")


@dataclass(frozen=True)
class ReleaseOptions:
    """Options of `release`."""

    dataset: options.AnnotatedSet
    out: Annotated[Path, typer.Argument(help="Folder or .zip to write.")]
    name: Annotated[str | None, typer.Option(metavar="TEXT", help="Of the dataset.")] = None
    version: Annotated[str, typer.Option("--version", metavar="X.Y.Z", help="Of this release.")] = (
        "1.0.0"
    )
    licence: Annotated[
        str,
        typer.Option("--licence", "--license", metavar="ID", help="Such as CC-BY-4.0, or a URL."),
    ] = ""
    by: Annotated[
        list[str] | None, typer.Option("--creator", metavar="NAME", help="Who made it; repeat.")
    ] = None
    url: Annotated[str, typer.Option(metavar="URL", help="Where it is found.")] = ""
    description: Annotated[str, typer.Option(metavar="TEXT", help="A paragraph for the card.")] = ""
    citation: Annotated[Path | None, typer.Option(metavar="FILE.bib", help="How it is cited.")] = (
        None
    )
    splits: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.csv", help="Columns 'frame' and 'split'; frames in none are left out."
        ),
    ] = None
    second: Annotated[
        Path | None,
        typer.Option(
            "--second-annotator",
            metavar="DIR",
            help="Annotations of the same frames by somebody else.",
        ),
    ] = None
    before: Annotated[
        Path | None, typer.Option("--previous", metavar="DIR", help="The release before.")
    ] = None
    pictures: Annotated[
        bool, typer.Option("--pictures/--no-pictures", help="Pass pictures on.")
    ] = False
    check: Annotated[bool, typer.Option("--check/--no-check", help="Run the label check.")] = True
    field: options.FieldName = None
    lines: options.Lines = None
    date: Annotated[
        str | None, typer.Option(metavar="YYYY-MM-DD", help="Of the release; today's.")
    ] = None
    overwrite: options.Overwrite = False


def release(given: ReleaseOptions) -> None:
    place = annotations_of(given.dataset)
    folder = folder_of_dataset(place)
    known = chosen_field(given.field, given.dataset, lines=given.lines)
    called = given.name or (folder or given.dataset).absolute().stem
    citation = b"" if given.citation is None else read_file(given.citation)
    if not given.version.strip():
        raise UsageError("--version: names no version")
    splits = _splits(given.splits)
    terms = ReleaseDescription(
        called, given.version, _date(given.date), given.licence, tuple(given.by or ()), given.url,
        given.description, citation.decode("utf-8", "replace"),
    )  # fmt: skip
    with open_annotations(place, known) as source:
        remarks.report_remarks(source.notices)
        _check_out(given.out, source, given.dataset, overwrite=given.overwrite)
        sizes = PictureSizes.around(given.dataset, place)
        with progress_bar("reading") as progress:
            frames, problems = gather_frames(source, known, splits, sizes, progress)
        if unknown := [frame for frame in splits if frame not in list_annotations(source)]:
            echo(f"note: in a split, but not annotated: {list_names(unknown, 'frame')}", err=True)
        # Nothing is reported of frames that are not released.
        released = FrameTable((frame.name, None) for frame in frames)
        files: dict[str, bytes] = {}
        open_findings = None
        if given.check:
            found = _findings(source, given.dataset, folder, known, released)
            files[FINDINGS_FILE] = label_check.findings_csv(found)
            counts = Counter(one.finding.severity.value for one in found.found)
            open_findings = {n: counts[n] for n in ("error", "warning", "hint") if counts[n]}
        agreed = ""
        if given.second is not None:
            with open_annotations(annotations_of(given.second), known) as other:
                agreed, files[AGREEMENT_FILE] = _agreement(source, other, known, released)
        origins = None
        if folder is not None:
            if provenance := _provenance(given.dataset, folder, known, released):
                files[PROVENANCE_FILE], origins = provenance, count_origins(provenance)
            for name, copy in ((FIELD_FILE, FIELD_COPY), (STADIUMS_FILE, STADIUMS_FILE)):
                if (folder / name).is_file():
                    files[copy] = read_file(folder / name)
        whole = Release(
            terms, frames, known, field_fingerprint(known), open_findings, agreed, origins,
            given.pictures, files,
        )  # fmt: skip
        with (
            outputs.replacing_nothing(given.out, (), "release", overwrite=given.overwrite),
            progress_bar("writing") as progress,
        ):
            changes = write_release(whole, given.out, given.before, sizes.path, progress)
    for split, names in whole.splits.items():
        echo(f"{split}: {pluralize(len(names), 'frame')}")
    if changes is not None:
        counted = (len(changes.added), len(changes.removed), len(changes.changed))
        said = "since {}: {} added, {} removed, {} changed".format(changes.before, *counted)
        pictures = len(changes.pictures)
        echo(said + (f", {pictures} with another picture" if pictures else ""))
    echo(f"release {given.version} of {called} written to {given.out}")
    raise typer.Exit(remarks.report_unreadable(problems, "left out"))


def _check_out(out: Path, source: FileSource, dataset: Path, *, overwrite: bool) -> None:
    outputs.check_place(out, [source])
    if dataset.is_dir() and out.resolve().is_relative_to(dataset.resolve()):
        raise UsageError(f"{out}: lies in what is read, write to another place than {dataset}")
    stopped = unfinished_path(out, "release").exists()
    if is_archive(out):
        outputs.check_replaces_nothing(out, (), overwrite=overwrite)
    elif out.is_dir() and any(out.iterdir()) and not overwrite and not stopped:
        held = "a release" if (out / RELEASE_FILE).exists() else "files"
        raise UsageError(f"{out}: holds {held} already, choose another folder, or --overwrite")


def _splits(path: Path | None) -> FrameTable[str]:
    """Frame -> split."""
    if path is None:
        return FrameTable()
    found: dict[str, str] = {}
    for line, row in read_frame_table(path, ("split",), "")[1]:
        if not _SPLIT.fullmatch(row["split"]):
            problem = f"{row['split']!r} is no name for a split"
            raise InputError(path, problem, place=f"line {line}")
        found[row["frame"]] = row["split"]
    return FrameTable(found)


def _date(text: str | None) -> str:
    """The day of a release; today if None."""
    if text is None:
        return datetime.date.today().isoformat()
    try:
        return datetime.date.fromisoformat(text).isoformat()
    except ValueError:
        raise UsageError(f"--date {text}: expected a day, YYYY-MM-DD") from None


def _findings(
    source: FileSource, dataset: Path, folder: Path | None, known: Field, own: FrameTable[None]
) -> label_check.CheckReport:
    """Findings of the label check, without those that were ignored."""
    sizes = fit_sizes(source, source.path, dataset, None)
    run = CheckRun(source, known, sizes, "R", looks=True)
    run.frames = [frame for frame in run.frames if frame.name in own]
    report = label_check.check_set(run, with_progress)
    ignored = {} if folder is None else ignored_keys(read_settings(folder)[0])
    report.found = [
        one for one in report.found if one.key not in ignored.get(one.frame, frozenset())
    ]
    return report


def _agreement(
    source: FileSource, other: FileSource, known: Field, own: FrameTable[None]
) -> tuple[str, bytes]:
    """Agreement with a second annotator, in one line and as JSON."""
    run = AgreementRun(source, other, known, (960, 540), (_AGREEMENT_TAU,), own=own)
    agreed = agreement.compare_annotators(run)
    return agreement.inter_annotator_line(agreed), agreement.agreement_json(agreed)


def _provenance(dataset: Path, folder: Path, known: Field, own: FrameTable[None]) -> bytes:
    """Origins of the points as JSON; empty where no workspace knows of any."""
    has_database = database_path(folder).exists() or fallback_path_of(folder) is not None
    if not dataset.is_dir() or not has_database:
        return b""
    workspace = Workspace.open(folder, known)
    with (
        closing(WorkspaceDatabase.open(folder, default_author())) as database,
        tempfile.TemporaryDirectory() as place,
    ):
        path = Path(place) / PROVENANCE_FILE
        export_provenance(workspace, database, path, only=own)
        return path.read_bytes()
