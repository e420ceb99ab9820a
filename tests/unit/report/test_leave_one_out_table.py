"""Fits beside each other, and what goes for which of them."""

from __future__ import annotations

from dataclasses import dataclass, field

from procc_annotator.batch.scoring import LeftOutMetrics
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.fit_record import FitCounts
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.scores.score_tables import left_out_table

ONE = FitCounts(1)


@dataclass
class Fits:
    ground_only: bool
    fitted: FitCounts = ONE
    held_out: LeftOutMetrics = field(default_factory=LeftOutMetrics)


def test_elements_off_the_ground_that_are_left_out_are_told() -> None:
    setup = EvaluationSetup(load_field("soccer"), (960, 540), off_plane="left_out")
    words = "off-plane elements left out"
    ground, pinholes = ("H", Fits(ground_only=True)), ("R", Fits(ground_only=False))
    method = ("theirs", Fits(ground_only=True, fitted=FitCounts()))
    alone = left_out_table([ground, method], [5.0], setup)
    assert words in alone.described
    both = left_out_table([ground, pinholes], [5.0], setup)
    assert words not in both.described
    assert [note for note in both.notes if words in note] == [f"H: soccernet, 960x540, {words}"]
    assert words not in " ".join(left_out_table([pinholes, method], [5.0], setup).notes)
