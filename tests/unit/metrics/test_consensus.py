"""The middle of several annotators' courses: near the truth, and moved little by who strays."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.field.load import load_field
from procc_annotator.metrics.agreement import compare_annotations
from procc_annotator.metrics.consensus import build_consensus, compare_to_consensus

FIELD = load_field("soccer")
SIZE = (960, 540)
TOP, MIDDLE, CIRCLE = "Side line top", "Middle line", "Circle central"
LINE = np.array([(100.0, 100.0), (300.0, 110.0), (500.0, 120.0), (700.0, 130.0)])


def moved(down: float):
    return LINE + np.array((0.0, down))


def of(name: str, points) -> FrameAnnotation:
    return FrameAnnotation.from_dict({name: points}, size=SIZE)


def middle(annotations, name: str):
    found = build_consensus(annotations, FIELD, SIZE)[0].annotation.get(name)
    return None if found is None else points_px(found, SIZE)


def test_of_three_lines_it_is_the_one_between_however_far_the_third_strays():
    for far in (3.0, 60.0):
        lines = [of(TOP, moved(off)) for off in (0.0, 2.0, far)]
        found = middle(lines, TOP)
        assert len(found) == 4
        off = found[:, 1] - np.interp(found[:, 0], LINE[:, 0], LINE[:, 1])
        assert off == pytest.approx(2.0, abs=0.02)


def test_a_line_that_bears_anothers_name_moves_nothing():
    across = np.array([(400.0, 20.0), (405.0, 200.0), (410.0, 400.0)])
    found = middle([of(TOP, LINE), of(TOP, moved(1)), of(TOP, across)], TOP)
    off = found[:, 1] - np.interp(found[:, 0], LINE[:, 0], LINE[:, 1])
    assert np.abs(off - 0.5).max() < 0.02


def test_it_runs_where_more_than_half_run():
    parts = [LINE[:2], LINE, LINE[1:]]
    found = middle([of(TOP, part) for part in parts], TOP)
    assert (found[:, 0].min(), found[:, 0].max()) == pytest.approx((100.0, 700.0), abs=1.0)
    two = middle([of(TOP, LINE[:3]), of(TOP, LINE[1:])], TOP)
    assert (two[:, 0].min(), two[:, 0].max()) == pytest.approx(
        (300.0, 500.0), abs=21.0
    )  # 5 % beyond clicks


def test_elements_of_exactly_half_are_undecided_and_of_fewer_are_none():
    both, one = {TOP: LINE, MIDDLE: moved(200)}, {TOP: LINE}
    frames = [FrameAnnotation.from_dict(own, size=SIZE) for own in (both, both, one, one)]
    of_all, of_others = build_consensus(frames, FIELD, SIZE)
    assert of_all.annotation.annotated == (TOP,)
    assert of_all.undecided == (MIDDLE,)
    # Of three others two have the middle line: the third and fourth annotator miss it.
    assert [others.undecided for others in of_others] == [(), (), (), ()]
    assert [
        compare_to_consensus(own, others, FIELD, SIZE).only_b
        for own, others in zip(frames, of_others, strict=True)
    ] == [(), (), (MIDDLE,), (MIDDLE,)]
    added = compare_to_consensus(frames[0], of_others[0], FIELD, SIZE)
    assert added.only_a == (MIDDLE,)


def test_two_lines_far_apart_along_have_no_middle():
    of_all, _ = build_consensus(
        [of(TOP, LINE[:2]), of(TOP, LINE[2:] + np.array((60, 3)))], FIELD, SIZE
    )
    assert of_all.annotation.annotated == ()
    assert of_all.undecided == (TOP,)


def test_a_circle_that_leaves_the_picture_gets_no_points_where_nobody_clicked():
    angles = np.deg2rad(np.linspace(-60, 240, 16))
    circle = np.column_stack((480 + 200 * np.cos(angles), 270 + 60 * np.sin(angles)))
    rng = np.random.default_rng(1)
    several = [of(CIRCLE, circle + rng.normal(0, 1, circle.shape)) for _ in range(5)]
    found = middle(several, CIRCLE)
    clicks = np.concatenate([points_px(a.get(CIRCLE), SIZE) for a in several])
    nearest = np.hypot(*(found[:, None] - clicks).transpose(2, 0, 1)).min(axis=1)
    assert nearest.max() < 5.0
    assert len(found) >= 8


def test_single_clicks_meet_at_their_median():
    places = [(100.0, 100.0), (103.0, 101.0), (400.0, 102.0)]
    found = middle([of(TOP, [place]) for place in places], TOP)
    assert found.tolist() == [[pytest.approx(103.0), pytest.approx(101.0)]]


def test_the_consensus_of_five_is_nearer_the_truth_than_any_of_them():
    angles = np.deg2rad(np.linspace(10, 350, 14))
    truth = {
        TOP: LINE,
        CIRCLE: np.column_stack((480 + 200 * np.cos(angles), 300 + 60 * np.sin(angles))),
    }
    rng = np.random.default_rng(2)
    exact = FrameAnnotation.from_dict(truth, size=SIZE)
    alone, agreed = [], []
    for _ in range(15):
        several = [
            FrameAnnotation.from_dict(
                {name: at + rng.normal(0, 2, at.shape) for name, at in truth.items()}, size=SIZE
            )
            for _ in range(5)
        ]
        alone.append(compare_annotations(several[0], exact, FIELD, SIZE).distances)
        of_all = build_consensus(several, FIELD, SIZE)[0].annotation
        agreed.append(compare_annotations(of_all, exact, FIELD, SIZE).distances)
    # A median of five normal errors has 0.54 of the deviation of one.
    ratio = np.median(np.concatenate(agreed)) / np.median(np.concatenate(alone))
    assert 0.4 < ratio < 0.68


def odd_points(rng: np.random.Generator) -> np.ndarray:
    """Clicks as nobody should make them: in one place, anywhere, in a row, around, heaped."""
    count = int(rng.integers(1, 12))
    base = rng.uniform(-200, 1200, (1, 2))
    angles = np.linspace(0, 2 * np.pi, count)
    return [
        np.repeat(base, count, axis=0),
        rng.uniform(-300, 1300, (count, 2)),
        base + np.outer(np.arange(count), rng.normal(0, 30, 2)),
        base + np.column_stack((100 * np.cos(angles), 30 * np.sin(angles))),
        base + np.round(rng.normal(0, 2, (count, 2))),
    ][int(rng.integers(5))]


@pytest.mark.parametrize("sport", ["soccer", "basketball_nba", "athletics"])
def test_whatever_was_clicked_distances_are_numbers(sport):
    field, rng = load_field(sport), np.random.default_rng(6)
    names = [element.name for element in field.elements]
    for _ in range(25):
        several = [
            FrameAnnotation.from_dict(
                {str(name): odd_points(rng) for name in rng.choice(names, 4, replace=False)},
                size=SIZE,
            )
            for _ in range(int(rng.integers(2, 6)))
        ]
        of_all, of_others = build_consensus(several, field, SIZE)
        for line in of_all.annotation:
            assert line.points
            assert np.isfinite(points_px(line, SIZE)).all()
        for own, others in zip(several, of_others, strict=True):
            found = compare_to_consensus(own, others, field, SIZE)
            assert np.isfinite(found.distances).all()
            assert 0.0 <= found.jac(5.0) <= 1.0
