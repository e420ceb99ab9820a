"""``procc-annotator gold``: how far annotators are from gold frames."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.agreement import AgreementRun
from procc_annotator.batch.agreement_statistics import ReferenceErrors, reference_errors
from procc_annotator.batch.set_run import ambiguous_folders
from procc_annotator.cli import inference_options, options, outputs
from procc_annotator.cli.console import stdout_console, with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.input_files import report_remarks, report_unreadable
from procc_annotator.cli.options import chosen_field
from procc_annotator.dataset.annotation_source import (
    REFERENCE_FRAMES_FILE,
    open_annotations,
    read_reference_frames,
)
from procc_annotator.dataset.database.location import read_times
from procc_annotator.dataset.layout import annotations_of, folder_of_dataset
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.file_listing import list_annotations, qualify_by_folder
from procc_annotator.formats.file_source import FileSource
from procc_annotator.messages import list_names
from procc_annotator.metrics.statistics.bootstrap import BootstrapSettings
from procc_annotator.report.agreement import intervals_described
from procc_annotator.report.consensus import short_names
from procc_annotator.report.reference_agreement import (
    ReferenceComparison,
    reference_tables,
    write_reference_comparison,
)

HELP = """\
DATASET holds the answers: the annotations of the frames that its gold.csv (or --gold) names in a
column 'frame'. Every annotator's clicks on these frames are compared with them as `agree` does,
with 95 % intervals. Each annotator's dataset knows when points were put: the error over the order
of work is told in thirds, and as a trend.

--output takes a .json with all tables, or a .csv with a row a frame and annotator.

Exit code: 0; 1 if some files were unreadable (listed, one line each); 2 if there was nothing to do.
"""

EXAMPLE = """
Example:

\b
  procc-annotator gold match/ study/anna study/ben study/cleo --tau 5 --output gold.json
"""


@dataclass(frozen=True, kw_only=True)
class GoldOptions:
    """What `gold` is asked for."""

    dataset: Annotated[Path, typer.Argument(help="The dataset with the answers.")]
    annotators: Annotated[
        list[Path], typer.Argument(metavar="A [B]...", help="Annotations of each annotator.")
    ]
    gold_file: Annotated[
        Path | None,
        typer.Option(
            "--gold",
            metavar="FILE.csv",
            show_default=False,
            help="Gold frames.  [default: the dataset's]",
        ),
    ] = None
    threshold: Annotated[
        list[float] | None,
        typer.Option(
            "--tau",
            "--threshold",
            "-t",
            metavar="PX",
            help="A point is right if it is closer than this; repeat for several.  [default: 5]",
        ),
    ] = None
    size: options.Size = "960x540"
    field: options.FieldName = None
    labels: options.LabelsFile = None
    alike: inference_options.ClusterOptions
    output: options.FigureFiles = None


def gold(given: GoldOptions) -> None:
    files = outputs.figure_files(given.output)
    marked = _reference_frames(given.dataset, given.gold_file)
    shown = chosen_field(given.field, given.dataset, *given.annotators)
    names = options.label_map(given.labels, shown)
    terms = shown, options.parse_size(given.size), options.thresholds_or_default(given.threshold)
    with ExitStack() as opened:
        answers, *sources = (
            opened.enter_context(open_annotations(annotations_of(path), shown, names))
            for path in (given.dataset, *given.annotators)
        )
        outputs.check_not_inputs(files, (answers, *sources))
        answered = list_annotations(answers)
        places = (given.dataset, *given.annotators)
        lists = qualify_by_folder([answered, *map(list_annotations, sources)])
        report_remarks(ambiguous_folders(zip(places, lists, strict=True)))
        unanswered = sorted(name for name in marked if name not in answered)
        if unanswered:
            raise UsageError(
                f"{list_names(unanswered, 'gold frame')} without an annotation in {answers.path}"
            )
        named = (answered.name_there(name) for name in marked)
        known = tuple(dict.fromkeys(name for name in named if name is not None))
        against = _compared(answers, sources, given.annotators, known, terms, given.alike)
    for path in files:  # before the tables: whoever reads them may stop after the first
        write_reference_comparison(against, path)
    for sheet in reference_tables(against):
        stdout_console().print(sheet)
    for name, found in zip(against.names, against.found, strict=True):
        if found is None:
            echo(f"note: {name} has annotated none of the gold frames", err=True)
    for path in files:
        echo(f"written: {path}")
    raise typer.Exit(report_unreadable(list(against.errors)))


def _reference_frames(dataset: Path, gold_file: Path | None) -> tuple[str, ...]:
    if not dataset.exists():
        raise UsageError(f"{dataset}: does not exist")
    folder = folder_of_dataset(dataset)
    path = gold_file
    if path is None and folder is not None and (folder / REFERENCE_FRAMES_FILE).is_file():
        path = folder / REFERENCE_FRAMES_FILE
    if path is None:
        raise UsageError(
            f"nothing to do: {dataset} has no {REFERENCE_FRAMES_FILE}; write one with a column"
            " 'frame', or name"
            " a file with --gold"
        )
    return read_reference_frames(path)


def _compared(
    answers: FileSource,
    sources: list[FileSource],
    places: list[Path],
    marked: tuple[str, ...],
    terms: tuple[Field, tuple[int, int], tuple[float, ...]],
    alike: inference_options.ClusterOptions,
) -> ReferenceComparison:
    """All annotators against the answers to the frames ``marked``, by the names of these."""
    clusters_of = alike.of([answers.path])
    errors: list[str] = []
    found: list[ReferenceErrors | None] = []
    known: dict[str, None] = {}
    draws = BootstrapSettings()
    answered = list_annotations(answers)
    for source, place in zip(sources, places, strict=True):
        own = list_annotations(source)
        if not any(own.called_in(answered, name) in marked for name in own):
            found.append(None)
            continue
        run = AgreementRun(source, answers, *terms, among=frozenset(marked))
        results = list(with_progress(run, run.total, "comparing"))
        errors += [error for result in results for error in result.errors]
        clusters = clusters_of(run.names)
        known[intervals_described(draws, clusters)] = None
        times = read_times(folder_of_dataset(place) or place)
        found.append(reference_errors(results, times, terms[2], clusters, draws))
    if not any(found):
        raise UsageError(
            f"nothing to do: nobody has annotated any of {list_names(marked, 'gold frame')}"
        )
    return ReferenceComparison(
        answers.path,
        tuple(places),
        short_names(places),
        tuple(found),
        len(marked),
        terms[2],
        terms[0],
        terms[1],
        "; ".join(known),
        tuple(errors),
    )
