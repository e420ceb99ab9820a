"""``procc-annotator agree``: compare two annotators of the same frames, or more."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager, ExitStack, nullcontext
from dataclasses import dataclass
from pathlib import Path
from string import ascii_uppercase
from typing import Annotated

import typer

from procc_annotator.batch.agreement import (
    MAX_ANNOTATORS,
    AgreementRun,
    ConsensusRun,
    agreement_run,
)
from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.set_run import WORTH_WORKERS, ambiguous_folders
from procc_annotator.cli import inference_options, options, outputs
from procc_annotator.cli.console import stdout_console, with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.options import chosen_field
from procc_annotator.cli.remarks import report_remarks, report_set, report_unreadable
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.layout import annotations_of, folder_of_dataset
from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.csv_tables import read_frame_table
from procc_annotator.formats.file_listing import list_annotations, qualify_by_folder
from procc_annotator.messages import list_names
from procc_annotator.report import agreement
from procc_annotator.report.agreement import (
    AgreementReport,
    compare_annotators,
    sample_size_table,
)
from procc_annotator.report.consensus import (
    consensus_line,
    consensus_tables,
    short_names,
    write_agreement,
    write_consensus,
)
from procc_annotator.report.reference import AgainstReference

HELP = """\
ANNOTATORS are two to 26 dataset folders, or folders or zip archives of annotation files, paired by
frame name: A, B, C, ...

Each point of one annotator is compared with the other's curve of the same element. The median and
95 % of the distances are the inter-annotator distance: no camera can agree better with such
annotations. JaC is that of one annotator evaluated against the other's curves.

Points beyond the other's ends (5 % of its length, at least 3 px) are left out and counted as
"beyond". An element with (almost) no common stretch is "apart": often its class was swapped.

--reference compares each annotator with annotations that are known to be right, of the frames in
the reference's gold.csv, of --frames, or of all. --power adds the number of frames needed for a
given precision.

Three or more annotators are compared in pairs, and each with the consensus of the others: the
median of their curves, for elements that more than half of them have. Confidence intervals are 95
%.

Exit code: 0; 1 if some files were unreadable (listed, one line each); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator agree sample_data sample_data/second_annotator --tau 5 --tau 2
  procc-annotator agree sample_data sample_data/second_annotator --output agreement.json
"""


GOLD_FILE = "gold.csv"  # of a reference: frames whose annotation is known to be right


@dataclass(frozen=True, kw_only=True)
class AgreeOptions:
    """Options of `agree`."""

    annotators: Annotated[
        list[Path], typer.Argument(metavar="A [B]...", help="Annotations of each annotator.")
    ]
    threshold: Annotated[
        list[float] | None,
        typer.Option(
            "--tau",
            "--threshold",
            "-t",
            metavar="PX",
            help="A point agrees if it is closer than this many pixels; repeat for several."
            "  [default: 5]",
        ),
    ] = None
    size: options.Size = "960x540"
    field: options.FieldName = None
    alike: inference_options.ClusterOptions
    power: Annotated[
        bool, typer.Option("--power", help="Also how many frames such a study needs to be surer.")
    ] = False
    reference: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Annotations that are known to be right.")
    ] = None
    frames: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.csv",
            help="Frames of --reference to compare, in a column 'frame'."
            "  [default: its gold.csv, else all]",
        ),
    ] = None
    consensus: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="Write the consensus of every frame, as annotations, to a folder or .zip; of three"
            " or more.",
        ),
    ] = None
    overwrite: Annotated[
        bool, typer.Option("--overwrite", help="Replace files of --consensus that are there.")
    ] = False
    labels: options.LabelsFile = None
    workers: options.FitWorkers = None
    output: options.FigureFiles = None


def agree(given: AgreeOptions) -> None:
    if given.reference is not None:
        if given.consensus is not None or given.power:
            raise UsageError("--reference goes without --consensus and --power")
        raise typer.Exit(_against_reference(given, given.reference))
    if given.frames is not None:
        raise UsageError("--frames needs --reference")
    files = outputs.output_files(given.output)
    run, agreed = _compared(given, files)
    for path in files:  # before the tables: a reader may stop after the first (`| head`)
        write_agreement(agreed, path)
    of_two = len(run.sources) == 2
    console = stdout_console()
    for sheet in agreement.agreement_tables(agreed) if of_two else consensus_tables(agreed):
        console.print(sheet)
    if of_two:
        console.print(agreement.inter_annotator_line(agreed))
    if given.power:
        console.print(sample_size_table(agreed.floor, agreed.described, agreed.known))
    if not of_two:
        console.print(consensus_line(agreed))
    for path in filter(None, (given.consensus, *files)):
        echo(f"written: {path}")
    for letter, names_alone in zip(ascii_uppercase, run.alone, strict=False):
        if names_alone:
            where = f"only in {letter}, not compared"
            echo(f"note: {where}: {list_names(names_alone, 'frame')}", err=True)
    if of_two and agreed.summary.mirrored:
        echo(
            "note: left and right seem to be swapped between A and B, counted as they are:"
            f" {list_names(agreed.summary.mirrored, 'frame')}",
            err=True,
        )
    raise typer.Exit(report_unreadable(agreed.errors))


def _compared(given: AgreeOptions, files: Sequence[Path]) -> tuple[ConsensusRun, AgreementReport]:
    """Compare the annotators; the consensus is written, if asked for."""
    count = len(given.annotators)
    if not 2 <= count <= MAX_ANNOTATORS:
        raise UsageError(f"annotations of {count} given, expected those of 2 to {MAX_ANNOTATORS}")
    if count == 2 and given.consensus is not None:
        raise UsageError("a consensus is that of three annotators or more")
    thresholds = options.thresholds_or_default(given.threshold)
    shown = chosen_field(given.field, *given.annotators)
    names = options.label_map(given.labels, shown)
    with ExitStack() as opened:
        sources = [
            opened.enter_context(open_annotations(annotations_of(path), shown, names))
            for path in given.annotators
        ]
        outputs.check_not_inputs(files, sources)
        for source, letter in zip(sources, ascii_uppercase, strict=False):
            report_set(source, shown, f"{letter}: ")
        lists = qualify_by_folder([list_annotations(source) for source in sources])
        report_remarks(ambiguous_folders(zip(given.annotators, lists, strict=True)))
        alike = given.alike.of(source.path for source in sources)
        run = agreement_run(sources, shown, options.parse_size(given.size), thresholds)
        opened.enter_context(_replacing(given, run))
        run.executor = opened.enter_context(
            make_executor(given.workers, frames=run.total, worth_from=WORTH_WORKERS)
        )
        agreed = compare_annotators(run, alike, with_progress)
        if given.consensus is not None:
            write_consensus(agreed, given.consensus)
    return run, agreed


def _replacing(given: AgreeOptions, run: ConsensusRun) -> AbstractContextManager[None]:
    """Guard of the folder of the consensus, if one is written."""
    if given.consensus is None:
        return nullcontext()
    outputs.check_place(given.consensus, run.sources)
    names = [f"{name}.json" for name in run.names]
    return outputs.replacing_nothing(given.consensus, names, "agree", overwrite=given.overwrite)


def _against_reference(given: AgreeOptions, reference: Path) -> int:
    files = outputs.output_files(given.output)
    places = (reference, *given.annotators)
    shown = chosen_field(given.field, *places)
    names = options.label_map(given.labels, shown)
    call = shown, options.parse_size(given.size), options.thresholds_or_default(given.threshold)
    described = f"{shown.described}, {call[1][0]}x{call[1][1]}"
    with ExitStack() as opened:
        answers, *sources = (
            opened.enter_context(open_annotations(annotations_of(path), shown, names))
            for path in places
        )
        outputs.check_not_inputs(files, (answers, *sources))
        answered = list_annotations(answers)
        lists = qualify_by_folder([answered, *map(list_annotations, sources)])
        report_remarks(ambiguous_folders(zip(places, lists, strict=True)))
        marked = _frames_of(reference, given.frames) or tuple(answered)
        if lacking := sorted(name for name in marked if name not in answered):
            raise UsageError(
                f"{list_names(lacking, 'frame')} without an annotation in {answers.path}"
            )
        among = frozenset(filter(None, map(answered.name_there, marked)))
        against = AgainstReference(answers.path)
        clusters_of, run = given.alike.of([answers.path]), None
        for source, place, name in zip(
            sources, given.annotators, short_names(given.annotators), strict=True
        ):
            own = list_annotations(source)
            if not any(own.called_in(answered, frame) in among for frame in own):
                echo(f"note: {name} has annotated none of the reference frames", err=True)
                continue
            run = AgreementRun(source, answers, *call, among=among)
            against.add(name, place, run, clusters_of, with_progress)
    if run is None or not against.rows:
        raise UsageError(
            "nothing to do: there is no annotation of any of"
            f" {list_names(sorted(among), 'reference frame')}"
        )
    for path in files:  # before the tables: whoever reads them may stop after the first
        against.write(run, described, path)
    stdout_console().print(against.sheet(described))
    for path in files:
        echo(f"written: {path}")
    return report_unreadable(against.errors)


def _frames_of(reference: Path, file: Path | None) -> tuple[str, ...]:
    """Names of the frames that a file, or else the reference's own, names; empty without one."""
    folder = folder_of_dataset(reference)
    if file is None and folder is not None and (folder / GOLD_FILE).is_file():
        file = folder / GOLD_FILE
    if file is None:
        return ()
    advice = "the file needs a header with a column 'frame', and a row for each frame"
    _, rows = read_frame_table(file, (), advice)
    if not rows:
        raise InputError(file, "names no frame", advice=advice)
    return tuple(row["frame"] for _, row in rows)
