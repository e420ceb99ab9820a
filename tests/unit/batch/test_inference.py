"""Sources side by side on drawn figures: what is compared on which frames, clusters, strata."""

import math
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.batch.audit import TAU_GRID, Pose
from procc_annotator.batch.frame_sums import SPARSE_TAUS, ClickNoise, FrameSums, SourceSums
from procc_annotator.batch.grouping import NONE, SHOT, FrameOrder, clusters_of
from procc_annotator.batch.inference import (
    MAX_COMPARED,
    Inference,
    click_noise_spread,
    pairs_under_click_noise,
    restrict_to_common_frames,
)
from procc_annotator.batch.strata import strata, values_of_frames
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.fit_record import FitCounts
from procc_annotator.metrics.statistics.intervals import BootstrapSettings
from procc_annotator.report.scores.inference_tables import (
    annotation_noise_tables,
    differences_table,
    power_table,
    strata_metrics_table,
)
from procc_annotator.report.tables.table import records

FIELD = load_field("soccer")
TAUS = (2.0, 5.0)
DRAWS = BootstrapSettings(2000)

ANOTHER = FitCounts(another=1)


def frame(name: str, jac: float | None, *, elements: int = 8):
    if jac is None:
        return FrameSums(name, np.full((2, 5), np.nan), None)
    figures = np.array([[jac * tau / 5, 0.9, 0.8, 10 * (2 - jac), 10.0] for tau in TAUS])
    curve = (jac * TAU_GRID / TAU_GRID[-1]).astype(np.float32)
    rng = np.random.default_rng(list(name.encode()))
    moved = (jac - 0.1 + 0.05 * rng.standard_normal((6, 2 + len(SPARSE_TAUS)))).astype(np.float32)
    return FrameSums(name, figures, curve, elements, "pinhole", moved)


def source(name: str, jacs, names=None, **more) -> SourceSums:
    names = names or [f"{n:03}" for n in range(len(jacs))]
    return SourceSums.of(
        name, TAUS, [frame(n, j, **more) for n, j in zip(names, jacs, strict=True)]
    )


@pytest.fixture
def three() -> tuple[SourceSums, ...]:
    rng = np.random.default_rng(1)
    jacs = rng.uniform(0.3, 0.9, 60)
    better = [None if n in (3, 9) else j + 0.05 + 0.02 * rng.random() for n, j in enumerate(jacs)]
    alike = jacs + rng.normal(0, 0.03, 60)
    return source("plain", jacs), source("better", better), source("alike", alike)


def certain(sources, by=NONE, tags=None, order=None) -> Inference:
    return Inference(sources, clusters_of(sources[0].names, by, tags or {}, order), DRAWS)


def test_tables_of_few_clusters_say_what_they_cannot_tell(three):
    def said(clusters: int, method: str) -> str:
        tags = {f"{n:03}": f"match {n % clusters}" for n in range(60)}
        numbers = clusters_of(three[0].names, "match", tags)
        notes = differences_table(Inference(three, numbers, DRAWS, method), "").notes
        return " ".join(notes)

    assert "no interval is to be relied on" in said(4, "t")
    assert "Of 5 clusters no p is below 0.062" in said(5, "t")
    assert "relied on" not in said(5, "t")
    assert "in 88 to 93 of 100 sets" in said(9, "bca")
    for many in (said(9, "t"), said(10, "percentile")):
        assert "100 sets" not in many
        assert "no p is below" not in many
    alone = Inference(three[:1], clusters_of(three[0].names, NONE, {}), DRAWS)
    assert alone.cautions == ()


def test_frames_needed_are_no_fewer_than_the_test_can_tell_anything_of(three):
    def needed(clusters: int) -> list[dict]:
        tags = {f"{n:03}": f"match {n % clusters}" for n in range(60)}
        numbers = clusters_of(three[0].names, "match", tags)
        return list(records(power_table(Inference(three, numbers, DRAWS), "")))

    for row in needed(10):
        assert row["frames_for_5"] >= 6 * row["frames"] / 10
        assert row["least_difference"] > 0
    for row in needed(5):
        assert row["frames_for_5"] > row["frames"]
        assert row["least_difference"] is None


def test_a_part_of_one_cluster_is_warned_of(three):
    tags = {f"{n:03}": str(n // 10) for n in range(60)}
    whole = Inference(three, clusters_of(three[0].names, "match", tags), DRAWS)
    parts = strata(whole, "half", ["first" if n < 10 else "rest" for n in range(60)])
    notes = " ".join(strata_metrics_table(parts, whole, "").notes)
    assert "part with the fewest: of fewer than 5 clusters no interval" in notes
    assert whole.cautions == ()


def test_a_fit_to_the_clicks_is_never_the_best_and_takes_no_place(three):
    plain, better, _ = three
    fitted = SourceSums("fit", TAUS, tuple(replace(f, fitted=ANOTHER) for f in better.frames))
    worse = source("worse", [f.figures[1, 0] - 0.1 for f in plain.frames])
    found = certain((plain, fitted, worse))
    assert certain((plain, better, worse)).best("mean_jac", 5.0) == 1
    assert found.best("mean_jac", 5.0) == 0  # of the methods
    assert found.ranks("mean_jac", 5.0) == [1, None, 2]
    assert found.chances_of_being_best[5.0] == [pytest.approx(1.0), None, pytest.approx(0.0)]
    assert certain((plain, fitted)).best("mean_jac", 5.0) is None  # one method alone
    assert certain((fitted,)).chances_of_being_best[5.0] == [None]
    sheet = differences_table(found, "")
    methods = [{row[1], row[2]} == {"plain", "worse"} for row in sheet.rows]
    assert {row for row, _ in sheet.bold} == {row for row, those in enumerate(methods) if those}
    assert {row[1] for row in sheet.rows} == {"plain", "fit‡"}
    assert all(
        (row[3] == "not tested") is not of for row, of in zip(sheet.rows, methods, strict=True)
    )


def test_the_error_of_fewer_points_is_not_bold(three):
    plain, better, _ = three
    flat = SourceSums("flat", TAUS, tuple(replace(f, ground_only=True) for f in better.frames))
    columns = [c.key for c in differences_table(certain((plain, better)), "").columns]
    error = columns.index("mean_error_difference")
    assert any(at == error for _, at in differences_table(certain((plain, better)), "").bold)
    bold = differences_table(certain((plain, flat)), "").bold
    assert bold
    assert not any(at == error for _, at in bold)


def test_means_are_compared_on_the_frames_both_have_and_scores_on_all(three):
    found = certain(three)
    pair = next(p for p in found.pairs if (p.a, p.b) == (0, 1))
    assert (pair.shared, pair.only_a, pair.only_b) == (58, ("003", "009"), ())
    jac = pair.differences["mean_jac", 5.0]
    assert jac.frames == 58
    assert -0.08 < jac.value < -0.04
    assert jac.beyond_chance
    assert pair.differences["completeness", 5.0].value == pytest.approx(2 / 60)
    score = pair.differences["final_score", 5.0]
    both = [f.figures[1, 0] for f in three[0].frames], [f.figures[1, 0] for f in three[1].frames]
    assert score.value == pytest.approx((np.nansum(both[0]) - np.nansum(both[1])) / 60)


def test_best_and_ranks_only_where_the_data_can_tell(three):
    found = certain(three)
    assert found.best("mean_jac", 5.0) == 1
    assert found.ranks("mean_jac", 5.0) == [2, 1, 2]
    assert found.best("mean_error", 5.0) == 1
    assert found.best("completeness", 5.0) is None
    assert sum(found.chances_of_being_best[5.0]) == pytest.approx(1.0)
    assert found.chances_of_being_best[5.0][1] > 0.99


def test_no_source_is_best_in_sets_that_are_all_the_same_or_empty(three):
    plain, better, _ = three
    nothing = [None, None]
    first = source("first", [plain.frames[0].figures[1, 0], *nothing])
    second = source("second", [better.frames[0].figures[1, 0], *nothing])
    assert certain((first, second)).chances_of_being_best[5.0] == [None, None]  # one frame
    apart = source("apart", [None, 0.5, 0.6])
    assert certain((first, apart)).chances_of_being_best[5.0] == [None, None]  # none in common
    half = [0.2, 0.4, 0.5, 0.1]
    alike = dict.fromkeys(source("a", half).names, "one match")
    pair = source("a", half), source("b", [jac + 0.1 for jac in half])
    assert certain(pair, "match", alike).chances_of_being_best[5.0] == [None, None]
    assert certain(pair).chances_of_being_best[5.0] == [0.0, 1.0]


def test_intervals_hold_the_figures_and_no_share_leaves_its_range(three):
    found = certain(three).intervals[1]
    jac = found["mean_jac", 5.0]
    assert jac.low < np.nanmean([f.figures[1, 0] for f in three[1].frames]) < jac.high
    assert found["completeness", 5.0].high == 1.0
    assert found["mean_error", 2.0].low > 0


def test_frames_of_one_cluster_widen_intervals_and_clusters_of_one_frame_do_not(three):
    rng = np.random.default_rng(2)
    matches = {name: str(n // 6) for n, name in enumerate(three[0].names)}
    alike = rng.uniform(0.2, 0.9, 10).repeat(6)
    one = (source("one", alike),)
    width = {}
    for by, tags in ((NONE, {}), ("match", matches)):
        interval = certain(one, by, tags).intervals[0]["mean_jac", 5.0]
        width[by] = interval.high - interval.low
    assert width["match"] > 2 * width[NONE]


def test_clusters():
    names = ["a_01", "a_02", "b_01", "b_02", "b_03"]
    by_name = clusters_of(names, None, {})
    assert (by_name.count, by_name.by) == (2, SHOT)
    assert by_name.numbers.tolist() == [0, 0, 1, 1, 1]
    assert by_name.described == "2 clusters of one shot each, by names"
    plain = clusters_of(["1", "2", "3"], None, {})
    assert (plain.count, plain.by) == (3, NONE)
    assert "not clustered" in plain.described
    tagged = clusters_of(names, "match", {"a_01": "x", "b_02": "x", "b_03": "y"})
    assert tagged.numbers.tolist() == [0, 1, 2, 0, 3]
    assert tagged.described == "4 clusters by match, 2 frames without"
    order = FrameOrder("frames.csv", {"1": "p", "2": "p", "3": "q"}, {"1": 1, "2": 2, "3": 3})
    assert clusters_of(["1", "2", "3"], SHOT, {}, order).numbers.tolist() == [0, 0, 1]
    one = FrameOrder("frames.csv", {"1": "a", "2": "a"}, {"1": 1, "2": 2})
    assert "all frames are of one shot, by frames.csv" in clusters_of("12", None, {}, one).described
    with pytest.raises(UsageError, match="contain no shots"):
        clusters_of(["1", "2"], SHOT, {})
    with pytest.raises(UsageError, match="no frame has a value of 'match'"):
        clusters_of(["1", "2"], "match", {})


def test_the_difference_is_a_curve_over_tau_with_a_band(three):
    band = certain(three).curve_of_difference(1, 0)
    assert band.values.shape == TAU_GRID.shape
    assert (band.low <= band.values).all()
    assert band.beyond_chance[-1] == 1.0
    assert certain(three).curve(0).values[-1] == pytest.approx(
        np.mean([f.figures[1, 0] for f in three[0].frames]), abs=1e-6
    )


def test_the_same_seed_gives_the_same_and_sources_of_other_frames_are_refused(three):
    first, again = certain(three), certain(three)
    assert first.pairs[0].differences == again.pairs[0].differences
    assert first.chances_of_being_best == again.chances_of_being_best
    short = SourceSums("short", TAUS, three[0].frames[:-1])
    with pytest.raises(UsageError, match="other frames"):
        certain((three[0], short))
    assert [len(s.frames) for s in restrict_to_common_frames((three[0], short))] == [59, 59]


def test_strata_are_corrected_together_and_say_where_sources_differ():
    rng = np.random.default_rng(3)
    jacs = rng.uniform(0.3, 0.7, 80)
    worse = jacs + rng.normal(0, 0.02, 80) - np.where(np.arange(80) < 40, 0.0, 0.2)
    sources = source("a", jacs), source("b", worse)
    tags = {name: "day" if n < 40 else "night" for n, name in enumerate(sources[0].names)}
    found = certain(sources)
    parts = strata(found, "light", values_of_frames("light", sources, FIELD, tags))
    day, night = (part.differences["mean_jac", 5.0][0, 1] for part in parts)
    assert [part.value for part in parts] == ["day", "night"]
    assert not day.beyond_chance
    assert night.beyond_chance
    assert night.corrected == pytest.approx(2 * night.p)
    for key in ("final_score", "mean_error", "completeness"):
        own = [part.differences[key, 2.0][0, 1] for part in parts]
        shares = sorted((d for d in own if d.p is not None), key=lambda d: d.p)
        assert all(d.corrected >= d.p for d in shares)
        if len(shares) == 2:
            assert shares[0].corrected == pytest.approx(min(1.0, 2 * shares[0].p))
    with pytest.raises(UsageError, match="known of no frame"):
        values_of_frames("weather", sources, FIELD, {})


def test_of_many_sources_those_that_lead_are_compared():
    rng = np.random.default_rng(3)
    jacs = rng.uniform(0.2, 0.9, (MAX_COMPARED + 5, 12))
    sources = tuple(source(f"s{n}", own) for n, own in enumerate(jacs))
    worst = set(np.argsort(jacs.mean(axis=1))[:5].tolist())
    found = certain(sources)
    assert set(range(len(sources))) - set(found.compared) == worst
    assert len(found.pairs) == MAX_COMPARED * (MAX_COMPARED - 1) // 2
    ranks = found.ranks("mean_jac", 5.0)
    assert {at for at, rank in enumerate(ranks) if rank is None} == worst
    assert "Of 35 methods the 30 with the highest JaC at" in " ".join(found.cautions)
    halves = strata(found, "half", ["a", "b"] * 6)
    assert {part.certainty.compared for part in halves} == {found.compared}
    fits = replace(sources[0], frames=tuple(replace(f, fitted=ANOTHER) for f in sources[0].frames))
    assert 0 not in certain((fits, *sources[1:])).compared


def test_strata_by_what_cameras_and_annotations_are_like():
    def pose(focal: float, y: float, x: float = 0.0) -> Pose:
        return Pose(0, 80, 0, focal, (x, y, -15))

    poses = [pose(1000, 60), pose(2000, 60), pose(3000, -60), pose(3000, 2.0, 80.0)]
    frames = [frame(str(n), 0.5, elements=n + 3) for n in range(5)]
    sources = (SourceSums("a", TAUS, tuple(frames)),)
    known = {str(n): pose for n, pose in enumerate(poses)}
    zooms = values_of_frames("zoom", sources, FIELD, {}, poses=known)
    assert zooms[0] == "focal 1000 to 2000 px"
    assert zooms[-1] is None
    main, opposite, behind = "main camera's side", "opposite side", "behind the end at x > 0"
    sides = values_of_frames("side", sources, FIELD, {}, poses=known)
    assert sides == [main, main, opposite, behind, None]
    assert values_of_frames("elements", sources, FIELD, {})[0] == "3 to 4 elements"


def test_what_clicks_make_of_figures_and_differences(three):
    found = certain(three)
    spread = click_noise_spread(found, 0)
    assert spread.deviations[1] == pytest.approx(0.05 / math.sqrt(60), rel=0.2)
    assert 0 < spread.shares[1] < 0.5
    pair = next(p for p in pairs_under_click_noise(found) if (p.a, p.b) == (0, 1))
    # The frames' names move the points: alike for both sources.
    assert pair.spread.deviations[1] == pytest.approx(0.0, abs=1e-6)
    assert pair.distinguishable_from is not None


def test_a_source_without_a_camera_has_no_final_score_and_no_difference(three):
    plain = three[0]
    taus = len(TAUS)
    nothing = np.full((taus, 5), np.nan)
    frames = tuple(FrameSums(f.frame, nothing, None) for f in plain.frames)
    found = certain((plain, SourceSums("none", TAUS, frames)))
    assert found.sources[1].ratios("final_score").denominators.sum() == 0
    assert found.pairs[0].differences["final_score", 5.0].value is None
    sheet = annotation_noise_tables(found, ClickNoise(1.0), "")[0]
    assert [row[2] for row in sheet.rows if row[0] == "none"] == [None] * taus
