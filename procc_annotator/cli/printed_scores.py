"""What ``procc-annotator evaluate`` prints: scores, and what could not be used."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from procc_annotator.cli.console import stdout_console
from procc_annotator.cli.datasets import (
    report_notices,
    report_remarks,
    report_unreadable,
)
from procc_annotator.cli.echo import echo
from procc_annotator.report.scores import tables
from procc_annotator.report.scores.chance import StatisticalResult
from procc_annotator.report.scores.held_out_sheet import left_out_table
from procc_annotator.report.scores.scoring import Scored
from procc_annotator.report.scores.tables import EvaluationRow, evaluations_table
from procc_annotator.words import count_words, list_names


def print_all(scored: list[Scored]) -> None:
    """Everything about one evaluation, or several side by side; then their groups."""
    console = stdout_console()
    if len(scored) == 1:
        print_scores(scored[0])
    else:
        rows = [EvaluationRow((s.set_name, s.method), s.described, s.summaries) for s in scored]
        console.print(evaluations_table("Evaluations", ("set", "method"), rows))
    fits = [(" ".join(filter(None, (s.set_name, s.method))) or "cameras", s) for s in scored]
    for size in dict.fromkeys(s.setup.size for s in scored):
        of_size = [(name, s) for name, s in fits if s.setup.size == size]
        taus = list(of_size[0][1].summaries)
        held_out = left_out_table(of_size, taus, of_size[0][1].setup)
        if held_out is not None:
            console.print(held_out)
    for by in dict.fromkeys(group.by for s in scored for group in s.groups):
        rows = [
            EvaluationRow((group.value or "–", s.set_name, s.method), s.described, group.summaries)
            for s in scored
            for group in s.groups
            if group.by == by
        ]
        console.print(evaluations_table(f"By {by}", (by, "set", "method"), rows))


def print_inference(told: Sequence[StatisticalResult]) -> None:
    """The sheets of every set."""
    console = stdout_console()
    for one in told:
        for sheet in one.sheets:
            named = f"{one.set_name}: {sheet.title}" if len(told) > 1 else sheet.title
            console.print(replace(sheet, title=named))


def print_scores(scored: Scored) -> None:
    """The tables of one set."""
    console = stdout_console()
    frames = count_words(scored.frames, "frame")
    title = f"Summary of {frames}, {scored.with_camera} with a camera"
    console.print(tables.summary_table(scored.summaries, scored.described, title=title))
    if scored.worst:
        console.print(
            tables.worst_frames_table(scored.worst, scored.first_threshold, scored.described)
        )
    console.print(tables.classes_table(scored.summaries, scored.described))


def report_problems(scored: list[Scored]) -> int:
    """Say on stderr what could not be used; returns the exit code."""
    for one in scored:
        of = f"{one.set_name}, {one.method}: " if len(scored) > 1 else ""
        report_notices({f"{of}{notice}": count for notice, count in one.notices.items()})
        if one.unmatched_cameras:
            counted = list_names(one.unmatched_cameras, "camera")
            echo(f"note: {of}without annotation, not counted: {counted}", err=True)
    # The annotations of a set are read for every method and size.
    sets = {one.set_name: one for one in scored}
    for name, one in sets.items():
        of = f"{name}: " if len(sets) > 1 else ""
        report_remarks(f"{of}{note}" for note in one.annotation_notes)
    errors = dict.fromkeys(error for one in scored for error in one.errors)
    return report_unreadable(list(errors))
