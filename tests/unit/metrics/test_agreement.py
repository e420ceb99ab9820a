"""Two annotators of one frame: distances, what is left out, JaC, mirrored labels, sets."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px, points_px
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.metrics.agreement import (
    AgreementAccumulator,
    compare_annotations,
    sorted_quantile,
)

SIZE = (960, 540)


def annotation(**polylines) -> FrameAnnotation:
    """Class name (spaces as in the field) -> points in px."""
    return FrameAnnotation(
        tuple(
            Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in points))
            for name, points in polylines.items()
        )
    )


def on_ellipse(angles, half=(220.0, 50.0), centre=(480.0, 270.0), tilt=0.1) -> np.ndarray:
    c, s = np.cos(tilt), np.sin(tilt)
    flat = np.column_stack((half[0] * np.cos(angles), half[1] * np.sin(angles)))
    return flat @ np.array(((c, s), (-s, c))) + centre


def agreement(field, class_name, first, second):
    a, b = annotation(**{class_name: first}), annotation(**{class_name: second})
    return compare_annotations(a, b, field, SIZE).by_class[class_name]


# ---------------------------------------------------------------------------------- straight


def test_distances_are_taken_both_ways_in_pixels_of_the_size(small_field) -> None:
    a, b = annotation(middle=[(100, 100), (500, 100)]), annotation(middle=[(200, 103), (400, 103)])
    found = compare_annotations(a, b, small_field, SIZE).by_class["middle"]
    # The first's ends are 100 px past the second's: left out.
    assert found.distances == pytest.approx([3.0, 3.0])
    assert found.left_out == 2
    larger = compare_annotations(a, b, small_field, (1919, 1079)).by_class["middle"]
    assert larger.distances == pytest.approx([6.0, 6.0])


def test_exchanging_the_annotators_changes_nothing_else(small_field) -> None:
    rng = np.random.default_rng(3)
    a, b = (
        annotation(
            middle=rng.normal([(100, 100), (300, 101), (500, 100)], 2),
            Circle=rng.normal(on_ellipse(np.linspace(0, 4, 8)), 2),
            **{extra: [(10, 10), (10, 200)]},
        )
        for extra in ("left", "right")
    )
    one, other = (
        compare_annotations(a, b, small_field, SIZE),
        compare_annotations(b, a, small_field, SIZE),
    )
    for name in ("middle", "Circle"):
        assert sorted(one.by_class[name].distances) == sorted(other.by_class[name].distances)
    assert (one.only_a, one.only_b) == (other.only_b, other.only_a) == (("left",), ("right",))


def test_clicks_a_little_beyond_an_end_are_compared_across(small_field) -> None:
    found = agreement(small_field, "middle", [(100, 100), (500, 100)], [(85, 102), (515, 102)])
    # 15 px are less than 5 % of 400, seen along the line, not from its end.
    assert found.distances == pytest.approx([2.0] * 4)
    found = agreement(small_field, "middle", [(100, 100), (500, 100)], [(75, 102), (515, 102)])
    assert found.distances == pytest.approx([2.0] * 3)
    assert found.left_out == 1


def test_a_short_line_reaches_three_pixels_on(small_field) -> None:
    found = agreement(small_field, "middle", [(100, 100), (110, 100)], [(97.5, 101), (112.5, 101)])
    assert found.left_out == 0
    found = agreement(small_field, "middle", [(100, 100), (110, 100)], [(96.5, 101), (113.5, 101)])
    assert found.left_out == 2


def test_the_direction_beyond_an_end_does_not_hang_on_two_close_clicks(small_field) -> None:
    hooked = [(100, 100), (499, 100), (500, 101)]
    found = agreement(small_field, "middle", hooked, [(100, 100), (515, 100)])
    assert found.largest < 1.5


def test_order_of_clicks_on_a_line_means_nothing(small_field) -> None:
    jumbled = [(500, 100), (100, 100), (300, 100), (200, 100)]
    found = agreement(small_field, "middle", jumbled, [(90, 100), (510, 100)])
    assert found.distances == pytest.approx([0.0] * 6, abs=1e-9)


def test_lines_with_no_stretch_in_common_are_apart_and_do_not_agree(small_field) -> None:
    a, b = annotation(middle=[(100, 100), (200, 100)]), annotation(middle=[(400, 100), (500, 100)])
    frame = compare_annotations(a, b, small_field, SIZE)
    found = frame.by_class["middle"]
    assert found.apart
    assert (found.median, found.p95, found.largest, found.left_out) == (None, None, None, 4)
    assert frame.jac(1000.0) == 0.0


# A corner of more than 90 degrees: all of one line but the corner is beyond the other's end.
CORNER = {
    "Big rect. right bottom": [(300, 400), (450, 402), (600, 404)],
    "Big rect. right main": [(600, 404), (700, 330), (800, 256)],
}


def swapped(polylines) -> dict:
    return dict(zip(polylines, reversed(polylines.values()), strict=True))


def test_classes_swapped_at_a_corner_are_apart(soccer) -> None:
    rng = np.random.default_rng(5)
    for _ in range(50):
        noisy = {name: rng.normal(points, 2.0) for name, points in swapped(CORNER).items()}
        frame = compare_annotations(annotation(**CORNER), annotation(**noisy), soccer, SIZE)
        for found in frame.by_class.values():
            assert found.apart
            assert found.left_out == 6  # the corner, which is near, says nothing about clicking
        assert frame.jac(50.0) == 0.0


@pytest.mark.parametrize("seen", [0.6, 0.75, 1.0])
@pytest.mark.parametrize("noise", [0.5, 2.0])
def test_who_saw_less_of_a_line_still_agrees(soccer, seen, noise) -> None:
    rng = np.random.default_rng(6)
    course = np.linspace((200, 100), (700, 300), 101)
    arc = on_ellipse(np.linspace(0.3, 3.0, 101))
    for name, points in (("Middle line", course), ("Circle right", arc)):
        whole = points[::20]
        part = np.linspace(0, 100 * seen, 6).astype(int)
        first, last = points[part], points[100 - part]
        for a, b in ((whole, first), (last, whole), (first, last)):
            for _ in range(10):
                found = agreement(soccer, name, rng.normal(a, noise), rng.normal(b, noise))
                assert not found.apart
                assert found.median < 4 * noise


def test_lines_that_share_a_small_part_of_the_shorter_are_apart(small_field) -> None:
    line = [(100, 100), (500, 100)]
    assert agreement(small_field, "middle", line, [(485, 102), (700, 102)]).apart
    found = agreement(small_field, "middle", line, [(460, 102), (700, 102)])
    assert found.distances == pytest.approx([2.0, 2.0])


def test_arcs_that_meet_at_an_end_are_apart(soccer) -> None:
    a, b = on_ellipse(np.linspace(0.0, 1.5, 6)), on_ellipse(np.linspace(1.48, 3.0, 6))
    assert agreement(soccer, "Circle left", a, b).apart
    # The whole of a circle has no ends to go beyond.
    around = on_ellipse(np.linspace(0, 6, 12))
    assert not agreement(soccer, "Circle central", around, a).apart


def _meeting(polylines: dict) -> list[tuple[str, str]]:
    """Pairs of classes with clicks within 6 px of each other."""
    names = list(polylines)
    return [
        (one, other)
        for i, one in enumerate(names)
        for other in names[i + 1 :]
        if np.hypot(*(polylines[one][:, None] - polylines[other]).T).min() <= 6
    ]


@pytest.mark.parametrize("every", [8, pytest.param(1, marks=pytest.mark.soak)])
def test_on_real_frames_noise_is_agreement_and_a_swap_is_not(soccer, shared_data, every) -> None:
    rng = np.random.default_rng(0)
    elements = swaps = agreeing = 0
    for path in sorted((shared_data / "wc14" / "annotations").glob("*.json"))[::every]:
        read = read_annotation(path.read_bytes(), path=str(path), field=soccer)
        clicked = {p.class_name: points_px(p, SIZE) for p in read if soccer.element(p.class_name)}
        noisy = {name: rng.normal(points, 1.0) for name, points in clicked.items()}
        half = {name: points[: -(len(points) // 2) or None] for name, points in noisy.items()}
        for other in (noisy, half):
            found = compare_annotations(read, annotation(**other), soccer, SIZE)
            assert not any(c.apart for c in found.by_class.values()), path.name
            elements += len(found.by_class)
        for one, two in _meeting(clicked):
            exchanged = swapped({one: noisy[one], two: noisy[two]})
            pair = annotation(**{name: clicked[name] for name in (one, two)})
            swaps += 2
            agreeing += compare_annotations(pair, annotation(**exchanged), soccer, SIZE).agreeing(
                5.0
            )
    assert elements > 3000 / every
    assert swaps > 1000 / every
    assert agreeing < 0.02 * swaps  # lines a few px long, and arcs of three clicks


@pytest.mark.parametrize("name", ["middle", "Circle"])
def test_a_single_click_is_measured_and_measures_nothing_longer(small_field, name) -> None:
    line = [(100, 100), (500, 100)]
    assert agreement(small_field, name, [(300, 104)], line).distances == pytest.approx([4.0])
    assert agreement(small_field, name, line, [(300, 104)]).distances == pytest.approx([4.0])
    assert agreement(small_field, name, [(0, 0)], [(3, 4)]).distances == pytest.approx([5.0, 5.0])
    twice = [(3, 4), (3, 4)]
    assert agreement(small_field, name, [(0, 0)], twice).distances == pytest.approx([5.0] * 3)


# ------------------------------------------------------------------------------------ curves


@pytest.mark.parametrize(("first", "second"), [(5, 5), (5, 8), (6, 7), (8, 8)])
@pytest.mark.parametrize("stretch", [(0.0, 2 * np.pi), (0.3, 3.5), (-0.6, 0.9), (2.0, 4.0)])
@pytest.mark.parametrize("class_name", ["Circle central", "Circle left"])
def test_different_clicks_on_one_ellipse_agree(soccer, first, second, stretch, class_name) -> None:
    rng = np.random.default_rng(first * 10 + second)
    for _ in range(10):
        clicks = []
        for count in (first, second):
            angles = np.linspace(*stretch, count, endpoint=stretch[1] - stretch[0] < 6)
            angles += rng.uniform(-0.3, 0.3, count) * (angles[1] - angles[0])
            clicks.append(on_ellipse(angles))
        found = agreement(soccer, class_name, *clicks)
        assert found.largest <= 0.05
        if stretch[1] - stretch[0] < 6:
            assert found.left_out <= 4


def test_a_shift_of_a_whole_ellipse_is_found(soccer) -> None:
    a = on_ellipse(np.linspace(0, 6, 8))
    lower = on_ellipse(np.linspace(0.3, 6.3, 9), centre=(480.0, 273.0))
    found = agreement(soccer, "Circle central", a, lower)
    assert 2.5 < found.p95 <= found.largest == pytest.approx(3.0, abs=0.05)


def test_order_of_clicks_around_an_ellipse_means_nothing(soccer) -> None:
    a, b = on_ellipse(np.linspace(0, 6, 9)), on_ellipse(np.linspace(0.2, 5.8, 7))
    mixed = np.random.default_rng(0).permutation(a)
    found = agreement(soccer, "Circle central", mixed, b)
    assert found.largest < 0.05
    assert found.left_out == 0


def test_a_circle_clicked_all_round_has_no_ends_and_an_arc_has(soccer) -> None:
    round_about, gap = on_ellipse(np.arange(6) * np.pi / 3), on_ellipse([np.pi / 6, 0.2, 0.6, 1, 2])
    assert agreement(soccer, "Circle central", round_about, gap).left_out > 0  # the gap is one's
    a, b = on_ellipse(np.linspace(0.0, 2.0, 6)), on_ellipse(np.linspace(1.0, 3.0, 6))
    found = agreement(soccer, "Circle left", a, b)
    assert found.largest < 0.05
    assert found.left_out >= 4


def test_a_curve_of_few_clicks_is_measured_by_the_other_only(soccer) -> None:
    few, many = on_ellipse([0.2, 1.5, 2.8]), on_ellipse(np.linspace(0, 3, 8))
    for found in (
        agreement(soccer, "Circle left", few, many),
        agreement(soccer, "Circle left", many, few),
    ):
        assert len(found.distances) == 3
        assert found.largest < 0.05


def test_a_spline_bends_where_a_chord_would_cut(soccer) -> None:
    few, other = on_ellipse(np.linspace(1.0, 2.2, 4)), on_ellipse(np.linspace(1.2, 2.0, 3))
    found = agreement(soccer, "Circle left", few, other)
    assert len(found.distances) >= 5
    assert found.largest < 0.15  # chords of the first are up to 1 px off


def test_noise_comes_out_as_it_went_in(soccer) -> None:
    rng = np.random.default_rng(7)
    sums = AgreementAccumulator([5.0])
    for frame in range(150):
        pair = [
            annotation(
                **{
                    "Circle central": rng.normal(on_ellipse(np.linspace(0, 5.8, 12)), noise),
                    "Middle line": rng.normal([(200, 100), (400, 150), (600, 200)], noise),
                }
            )
            for noise in (0.0, 2.0)
        ]
        sums.add(str(frame), compare_annotations(*pair, soccer, SIZE))
    found = sums.summary().overall
    # The absolute value of a normal variable: median 0.674 sigma, 95 % 1.96 sigma.
    assert found.median == pytest.approx(0.674 * 2, rel=0.1)
    assert found.p95 == pytest.approx(1.96 * 2, rel=0.1)


@pytest.mark.laps
@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e6])
def test_clicks_that_determine_no_ellipse_are_followed_all_the_same(soccer, scale, lap) -> None:
    # On a line an ellipse fit finds rounding errors; on a hyperbola, an ellipse that is none.
    rng = np.random.default_rng((11, lap))
    for _ in range(25):
        x = rng.uniform(1, 50, 7)
        for y in (4 / 3 * x + 50, 100 / x, x * x, 0 * x, rng.integers(0, 3, 7)):
            clicks = np.column_stack((x, y)) * scale
            found = agreement(soccer, "Circle left", clicks, clicks)
            assert found.left_out == 0
            assert found.largest < 1e-9 * max(1.0, scale)


# ---------------------------------------------------------------------------- frames and sets


def test_jac_counts_elements_all_of_whose_clicks_are_below_tau(small_field) -> None:
    a = annotation(
        middle=[(100, 100), (500, 100)], left=[(10, 10), (10, 200)], bar=[(0, 300), (50, 300)]
    )
    b = annotation(
        middle=[(100, 102), (500, 106)], left=[(11, 10), (11, 200)], right=[(900, 9), (900, 90)]
    )
    frame = compare_annotations(a, b, small_field, SIZE)
    assert (frame.only_a, frame.only_b) == (("bar",), ("right",))
    assert frame.jac(7.0) == 2 / 4
    assert frame.jac(5.0) == 1 / 4
    assert frame.jac(0.5) == 0.0
    exact = max(c.largest for c in frame.by_class.values())
    assert frame.jac(exact) == 1 / 4  # strictly below, as for cameras


def test_only_classes_with_geometry_and_clicks_count(small_field) -> None:
    line = [(0, 0), (9, 9)]
    a = annotation(**{"Line unknown": line, "never heard of": line, "left": []})
    frame = compare_annotations(a, annotation(middle=[]), small_field, SIZE)
    assert frame.element_count == 0
    assert frame.jac(5.0) == 0.0
    assert not len(frame.distances)


SIDE = {
    "Side line left": [(100, 100), (50, 400)],
    "Big rect. left main": [(300, 150), (280, 450)],
    "Big rect. left top": [(90, 160), (300, 150)],
    "Middle line": [(900, 100), (905, 500)],
}


def test_mirrored_labels_are_hinted_at_and_not_corrected(soccer) -> None:
    turned = {soccer.symmetries[0].name_of(name): points for name, points in SIDE.items()}
    frame = compare_annotations(annotation(**SIDE), annotation(**turned), soccer, SIZE)
    assert frame.mirrored_hint
    assert list(frame.by_class) == ["Middle line"]
    assert len(frame.only_a) == len(frame.only_b) == 3
    assert frame.jac(5.0) == 1 / 7


def test_no_hint_where_labels_agree_or_nothing_does(soccer) -> None:
    a = annotation(**SIDE)
    elsewhere = {name: [(x + 200, y + 30) for x, y in points] for name, points in SIDE.items()}
    fewer = {name: SIDE[name] for name in ("Side line left", "Middle line")}
    for b in (SIDE, elsewhere, fewer, {}):
        assert not compare_annotations(a, annotation(**b), soccer, SIZE).mirrored_hint


def test_sums_of_a_set(small_field) -> None:
    line, moved = [(100, 100), (500, 100)], [(100, 104), (500, 104)]
    sums = AgreementAccumulator([5, 2], only_a=["7"], only_b=["8", "9"])
    pairs = {
        "1": ({"middle": line}, {"middle": line}),
        "2": ({"middle": line}, {"middle": moved, "left": line}),
        "3": ({}, {}),
        "4": ({"middle": line}, {"middle": [(800, 100), (900, 100)]}),
    }
    for name, (a, b) in pairs.items():
        sums.add(name, compare_annotations(annotation(**a), annotation(**b), small_field, SIZE))
    found = sums.summary()
    assert found.frames == 4
    assert (found.frames_only_a, found.frames_only_b) == (("7",), ("8", "9"))
    # Nobody annotated anything in frame 3: it has no JaC.
    assert found.mean_jac == {5.0: pytest.approx(1.5 / 3), 2.0: pytest.approx(1 / 3)}
    assert list(found.per_class) == ["left", "middle"]
    middle = found.per_class["middle"]
    assert (middle.common, middle.apart, middle.only_a, middle.only_b) == (3, 1, 0, 0)
    assert (middle.points, middle.left_out) == (8, 4)
    assert (middle.median, middle.largest) == (pytest.approx(2.0), pytest.approx(4.0))
    left = found.per_class["left"]
    assert (left.common, left.only_b, left.median, left.p95) == (0, 1, None, None)
    assert (found.overall.common, found.overall.only_b, found.overall.points) == (3, 1, 8)


def test_an_empty_set_has_no_figures() -> None:
    found = AgreementAccumulator([5.0]).summary()
    assert found.mean_jac == {5.0: None}
    assert (found.frames, found.overall.points, found.overall.median) == (0, 0, None)


def test_quantile_is_the_usual_one() -> None:
    values = np.sort(np.random.default_rng(1).normal(size=37))
    for share in (0.0, 0.5, 0.95, 1.0):
        assert sorted_quantile(values, share) == pytest.approx(np.quantile(values, share))
    assert sorted_quantile(np.empty(0), 0.5) is None
