"""``procc-annotator propose-map``: what the labels of another program may stand for."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.assist.label_matching import cameras_of, labelled_frames
from procc_annotator.assist.label_proposal import (
    LabelProposal,
    better_field,
    propose_labels,
    proposed_text,
)
from procc_annotator.cli import input_files, options, outputs, remarks
from procc_annotator.cli.echo import echo
from procc_annotator.cli.options import chosen_field
from procc_annotator.dataset.annotation_source import read_labels
from procc_annotator.dataset.diagnostics import mismatch_of
from procc_annotator.dataset.layout import annotations_of
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import LABELS_FILE, OrderedClasses, Rule
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.strict_json import printable
from procc_annotator.messages import pluralize

HELP = """\
ANNOTATIONS are of any format that is read. Each label that is no class of the field is compared
with the classes by words (also plurals, numbered copies, other languages) and by geometry: on which
element do its shapes lie, as shown by --cameras or by cameras fitted to the known classes? Labels
that several lines share are ordered from the top down or from left to right, as fits most frames.

The output is a proposal: each line states its certainty and the reason; uncertain lines are
comments to be completed. Use it with --map, or save it as labels.toml in the dataset's folder.

Exit code: 0; 1 if some annotations were unreadable (listed); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator propose-map sample_data/other_names --output labels.toml
  procc-annotator propose-map sample_data/other_names --cameras sample_data/cameras/true \\
      --output again.toml
  procc-annotator evaluate sample_data/other_names sample_data/cameras/true --map labels.toml
"""


def propose_map(
    annotations: options.AnnotatedSet,
    cameras: input_files.Cameras = None,
    output: Annotated[
        Path, typer.Option("--output", "-o", metavar="FILE.toml", help="The file that is written.")
    ] = Path(LABELS_FILE),
    field: options.FieldName = None,
    camera_format: options.CameraFormat = "auto",
    camera_size: options.CameraSize = None,
    overwrite: Annotated[
        bool, typer.Option("--overwrite", help="Replace the file if it is there.")
    ] = False,
) -> None:
    if output.exists() and not overwrite:
        raise UsageError(f"{output}: exists already, choose another name or ask to overwrite it")
    outputs.check_output_folder(output)
    known = chosen_field(field, annotations)
    found = read_labels(annotations_of(annotations), known)
    code = remarks.report_unreadable(found.problems)
    frames = labelled_frames(found, known)
    if not any(frame.shapes for frame in frames):
        every = f"every label of {annotations} is a class of the field {known.title}"
        said = f"; {'; '.join(found.losses)}" if found.losses else ""
        none = f"no frame of {annotations} could be read"
        raise UsageError(f"nothing to do: {every if frames else none}{said}")
    shown = input_files.open_cameras(cameras, camera_format, options.shown_size(camera_size), known)
    unusable: list[str] = []
    given = None if shown is None else cameras_of(shown, unusable.append)
    proposals = propose_labels(frames, known, given)
    code = max(code, remarks.report_unreadable(unusable))
    _print_proposals(proposals, known, annotations)
    text = proposed_text(proposals, annotations.name, known, given_cameras=shown is not None)
    write_atomic(output, text.encode())
    echo(f"written: {output}; look at it, then: --map {output}")
    raise typer.Exit(code)


def _print_proposals(proposals: list[LabelProposal], field: Field, place: Path) -> None:
    labels = [one.count.label for one in proposals]
    mismatch = mismatch_of(labels, field)
    other = mismatch.better.name if mismatch and mismatch.better else better_field(labels, field)
    if other is not None:
        echo(f"note: {place}: these names are more like those of --field {other}", err=True)
    for one in proposals:
        shapes = f"{printable(one.count.label)} ({pluralize(one.count.shapes, 'shape')})"
        echo(f"{one.surety:6} {shapes}: {_words(one.rule)}; {one.why}")
        if one.like:
            echo(f"       may be {', '.join(name.strip() for name in one.like)}")


def _words(rule: Rule) -> str:
    if isinstance(rule, OrderedClasses):
        order = rule.order.replace("_", " ")
        return f"{', '.join(name.strip() for name in rule.classes)} ({order})"
    return rule.strip() if isinstance(rule, str) else "?"
