"""Charts show the frames' own figures, and stay readable however many frames there are."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from procc_annotator.batch.audit import TAU_GRID, FrameAudit, Pose
from procc_annotator.batch.frame_sums import FrameSums
from procc_annotator.field.load import load_field
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.page import charts
from procc_annotator.report.page.chart_style import (
    Chart,
    Panel,
    charted_sources,
    draw_chart,
    panel_figure,
)
from procc_annotator.report.page.report_data import (
    AuditReport,
    FrameMetrics,
    ReportedFrame,
    ReportedSource,
)

COLOURS = ("#aa0000", "#0000aa")
TAU = 5.03  # the curves have no such place


@pytest.fixture
def drawn(monkeypatch) -> dict[str, SimpleNamespace]:
    """The axes of charts that were drawn, by title, as matplotlib has them."""
    figures: dict[str, SimpleNamespace] = {}

    def kept(number: int, title: str, text: str, panels: list[Panel]) -> Chart:
        axes = [panel_figure(panel).axes[0] for panel in panels]
        figures[title] = SimpleNamespace(axes=axes)
        return draw_chart(number, title, text, panels)

    monkeypatch.setattr(charts, "draw_chart", kept)
    return figures


def reported(frame: str, jac: float | None, pan: float = 0.0) -> ReportedFrame:
    """A frame that has the same JaC at every tau; None: no camera."""
    if jac is None:
        return ReportedFrame(frame, {}, None, None, True, (), FrameSums(frame, _NONE, None))
    curve = np.full(len(TAU_GRID), jac, dtype=np.float32)
    nothing = np.empty((0, 2), np.float32)
    pose = Pose(pan, 80.0, 0.0, 2000.0, (0.0, 70.0, -15.0))
    audit = FrameAudit(frame, "pinhole", curve, np.empty(0, np.int16), nothing, nothing, pose)
    sums = FrameSums(frame, np.array([[jac, jac, jac, 0.0, 0.0]]), curve, 8, "pinhole")
    figures = FrameMetrics(jac, 0, 0, 0, False, None, None, None, None)
    return ReportedFrame(frame, {TAU: figures}, audit, None, True, (), sums)


_NONE = np.full((1, 5), np.nan)


def report_of(*sources: list[ReportedFrame]) -> AuditReport:
    setup = EvaluationSetup(load_field("soccer"))
    named = [
        # Whoever has a summary has figures; what they are is of no interest here.
        ReportedSource(f"source {at}", "folder", "auto", {TAU: None}, "", frames=tuple(frames))
        for at, frames in enumerate(sources)
    ]
    return AuditReport("set", setup, (TAU,), tuple(named))


def several(jacs: list[float | None]) -> list[ReportedFrame]:
    return [reported(f"{at:05d}", jac, pan=at % 7) for at, jac in enumerate(jacs)]


A: list[float | None] = [0.5, 1.0, 0.25, None, 1.0, 0.75]
B: list[float | None] = [0.5, 0.8, 0.75, 0.1, 1.0, None]
BOTH = [(50, 50), (100, 80), (25, 75), (100, 100)]


def test_the_ordered_curve_has_the_frames_values(drawn):
    report = report_of(several(A), several(B))
    charts.frame_charts(report, charted_sources(report, COLOURS))
    violins, curves = drawn["How the JaC of frames is distributed"].axes
    for line, jacs in zip(curves.lines, (A, B), strict=True):
        known = sorted(100 * jac for jac in jacs if jac is not None)
        np.testing.assert_allclose(np.asarray(line.get_ydata()), known, atol=1e-4)
        np.testing.assert_allclose(np.asarray(line.get_xdata()), [10, 30, 50, 70, 90])
    for bar, jacs in zip(violins.lines[::2], (A, B), strict=True):
        quarters = np.percentile([100 * jac for jac in jacs if jac is not None], (25, 75))
        np.testing.assert_allclose(np.asarray(bar.get_ydata()), quarters, atol=1e-4)
    medians = [float(np.asarray(mark.get_ydata())[0]) for mark in violins.lines[1::2]]
    np.testing.assert_allclose(medians, [75, 75], atol=1e-4)


def test_the_scatter_has_the_pairs_and_the_curve_their_differences(drawn):
    report = report_of(several(A), several(B))
    charts.frame_charts(report, charted_sources(report, COLOURS))
    scatter, ordered = drawn["Two methods, frame by frame"].axes
    (marks,) = scatter.collections
    shown = np.asarray(marks.get_offsets())
    np.testing.assert_allclose(sorted(map(tuple, shown.tolist())), sorted(BOTH), atol=1e-4)
    zero, differences = ordered.lines
    assert set(np.asarray(zero.get_ydata()).tolist()) == {0}
    expected = sorted(a - b for a, b in BOTH)
    np.testing.assert_allclose(np.asarray(differences.get_ydata()), expected, atol=1e-4)


@pytest.mark.parametrize("copies", [1, 10, 400])
def test_marks_of_many_frames_do_not_hide_each_other(drawn, copies):
    report = report_of(several(copies * A + [0.9]), several(copies * B + [0.9]))
    charts.frame_charts(report, charted_sources(report, COLOURS))
    marks = drawn["Two methods, frame by frame"].axes[0].collections
    areas = np.concatenate([of_size.get_sizes() for of_size in marks])
    assert areas.max() <= 120
    assert areas.min() >= 2
    assert (areas.max() > areas.min()) == (copies > 1)  # what several frames share is larger


@pytest.mark.parametrize(("frames", "beside_each_other"), [(300, True), (301, False)])
def test_frames_are_beside_each_other_only_where_they_can_be_told_apart(
    drawn, frames, beside_each_other
):
    rng = np.random.default_rng(1)
    values = rng.integers(0, 11, frames) / 10
    found = charts.draw_charts(report_of(several(values.tolist())), COLOURS)
    titles = [chart.title for chart in found]
    assert ("JaC of every frame" in titles) == beside_each_other
    assert "How the JaC of frames is distributed" in titles
    assert ("stretches" in found[-1].text) == (not beside_each_other)
    if beside_each_other:
        line: Any = drawn["JaC of every frame"].axes[0].lines[0]
        np.testing.assert_allclose(line.get_ydata(), 100 * values, atol=1e-4)
    pan: Any = drawn["Where the cameras stand and look"].axes[0].lines[0]
    assert len(pan.get_xdata()) == (frames if beside_each_other else 100)


def test_no_outlier_is_lost_in_a_stretch(drawn):
    frames = several([1.0] * 1454)
    frames[700] = reported("00700", 1.0, pan=-90.0)
    charts.draw_charts(report_of(frames), COLOURS)
    (band,) = drawn["Where the cameras stand and look"].axes[0].collections
    corners: Any = band.get_paths()[0].vertices
    assert corners[:, 1].min() == pytest.approx(-90)
    assert corners[:, 1].max() == pytest.approx(6)


def test_frames_have_the_score_of_the_threshold_that_is_named(drawn):
    frames = several(A)
    exact = [
        replace(f, figures={TAU: replace(f.figures[TAU], jac=0.125)}) if f.figures else f
        for f in frames
    ]
    report = report_of(exact, several(B))
    found = report.jac_of_frames(report.sources[0])
    np.testing.assert_equal(found, [np.nan if jac is None else 0.125 for jac in A])
    charts.frame_charts(report, charted_sources(report, COLOURS))
    _, curves = drawn["How the JaC of frames is distributed"].axes
    np.testing.assert_allclose(np.asarray(curves.lines[0].get_ydata()), 12.5)
