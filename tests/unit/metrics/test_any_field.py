"""Scores of fields other than soccer: spots, chains, several turns or none, optional elements."""

import math
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.camera.base import ElementProjections
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.geometry import Arc, Chain, Circle, Line, Spot, parts_of
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.model import Field, Landmark, Symmetry
from procc_annotator.metrics.agreement import compare_annotations
from procc_annotator.metrics.measurement import Measurement, measure
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.score import FrameScore, explain_score, jac_curve, score
from procc_annotator.metrics.sets import SetAccumulator
from procc_annotator.metrics.setup import PROTOCOLS, EvaluationSetup
from tests.unit.metrics.conftest import SIZE, make_field

CENTRE = (50.0, 25.0)

# A corner that is walked along both of its sides, and a rounded one.
CORNER = Chain(
    (Line((-20.0, 10.0, 0.0), (0.0, 10.0, 0.0)), Line((0.0, 10.0, 0.0), (0.0, -5.0, 0.0)))
)
ROUNDED = Chain(
    (
        Line((10.0, 10.0, 0.0), (20.0, 10.0, 0.0)),
        Arc((20.0, 5.0, 0.0), 5.0, 0.0, math.pi / 2),
    )
)


def field_of(shapes, mirror=None, optional=()) -> Field:
    field = make_field(shapes, mirror or {})
    elements = tuple(replace(e, optional=e.name in optional) for e in field.elements)
    return replace(field, elements=elements)


def measured(field, annotation, camera, protocol, **options) -> Measurement:
    return measure(annotation, camera, EvaluationSetup(field, SIZE, protocol, **options))


def statuses(found: FrameScore) -> dict[str, str]:
    return {e.annotated_name: e.status for e in found.elements}


# ------------------------------------------------------------------------------ spots and chains


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_a_spot_is_judged_by_its_distance(protocol, map_camera, annotate):
    field = field_of({"spot": Spot((10.0, 5.0, 0.0)), "line": Line((0.0, 0, 0), (9.0, 0, 0))})
    found = measured(field, annotate({"spot": [(63, 34)]}), map_camera(CENTRE), protocol)
    assert found.plain.all_distances.tolist() == pytest.approx([5.0])
    assert statuses(score(found, 5.1)) == {"spot": "tp", "line": "not_annotated"}
    assert statuses(score(found, 4.9)) == {"spot": "too_far", "line": "not_annotated"}


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_a_spot_out_of_the_picture_or_behind_the_camera_is_missed(protocol, map_camera, annotate):
    field = field_of({"spot": Spot((-60.0, 0.0, 0.0)), "below": Spot((0.0, 0.0, 1.0))})
    annotation = annotate({"spot": [(0, 25)], "below": [(50, 25)]})
    found = score(measured(field, annotation, map_camera(CENTRE), protocol), 20)
    assert statuses(found) == {"spot": "missed", "below": "missed"}


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_a_spot_given_as_a_projection_alone_counts(protocol, annotate):
    field = field_of({"spot": Spot((0.0, 0.0, 0.0)), "line": Line((0.0, 0, 0), (9.0, 0, 0))})
    shown = ElementProjections({"spot": (np.array([[40.0, 20.0]]),)})
    found = measured(field, annotate({"spot": [(43, 24)]}), shown, protocol)
    assert found.plain.all_distances.tolist() == pytest.approx([5.0])
    outside = ElementProjections({"spot": (np.array([[-1.0, 20.0]]),)})
    assert not project_field(outside, EvaluationSetup(field, SIZE, protocol)).pieces


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_a_chain_goes_round_its_corner(protocol, map_camera, annotate):
    """Points near either side, at the joint, and inside the corner."""
    points = [(40, 37), (52, 37), (49, 25), (45, 30)]
    field = field_of({"chain": CORNER})
    found = measured(field, annotate({"chain": points}), map_camera(CENTRE), protocol)
    wanted = [2.0, math.hypot(2, 2), 1.0, 5.0]
    assert found.plain.all_distances.tolist() == pytest.approx(wanted, abs=1e-6)


def test_a_chain_that_is_cut_by_the_picture_is_there_on_both_sides(map_camera, annotate):
    """Its corner is outside: nothing along the border, but the other side counts beyond it."""
    field = field_of({"chain": CORNER})
    camera = map_camera((50.0, 45.0))  # the corner at y = 55, below the picture's 50
    found = measured(field, annotate({"chain": [(50, 42), (40, 50)]}), camera, "procc")
    assert len(found.projected.pieces["chain"]) == 1
    in_sight = found.projected.polylines.segments
    row = np.zeros(2, np.intp)
    assert in_sight.distances(found.points_px, row).tolist() == pytest.approx([0.0, 10.0])
    assert found.plain.all_distances.tolist() == pytest.approx([0.0, 5.0])


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_distances_are_those_to_a_dense_projection(protocol, annotate):
    """A real camera, curves in other planes, against brute force over many samples."""
    rim = Circle((3.0, 0.0, -3.05), 0.9, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    upright = Arc((-4.0, 0.0, 0.0), 2.0, math.pi, 2 * math.pi, (1.0, 0, 0), (0.0, 0.0, 1.0))
    shapes = {
        "rim": rim,
        "upright": upright,
        "rounded": ROUNDED,
        "spot": Spot((1.0, 2.0, -1.0)),
    }
    camera = PinholeCamera(0.2, 1.25, 0.01, (-3.0, 32.0, -11.0), (60.0, 60.0), (50.0, 25.0))
    rng = np.random.default_rng(5)
    annotation = annotate({name: rng.uniform((5, 5), (95, 45), (6, 2)).tolist() for name in shapes})
    found = measured(field_of(shapes), annotation, camera, protocol)
    assert all(found.plain.projected)
    for shape, polyline, distances in zip(
        shapes.values(), annotation, found.plain.distances, strict=True
    ):
        dense = np.concatenate([_dense(part) for part in parts_of(shape)])
        px, seen = camera.project(dense)
        assert seen.all()
        points = np.array([(p.u * 100, p.v * 50) for p in polyline.points])
        brute = np.hypot(*(points[:, None] - px).transpose(2, 0, 1)).min(axis=1)
        # The official samples lie 0.2 m apart, and leave a circle's end open.
        assert distances == pytest.approx(brute, abs=0.01 if protocol == "procc" else 0.4)


def _dense(part) -> np.ndarray:
    t = np.linspace(0, 1, 4001)[:, None]
    if isinstance(part, Spot):
        return np.array([part.position])
    if isinstance(part, Line):
        return np.array(part.start) * (1 - t) + np.array(part.end) * t
    first, last = (part.start_rad, part.end_rad) if isinstance(part, Arc) else (0, 2 * math.pi)
    angle = first + t * (last - first)
    along = np.cos(angle) * np.array(part.ahead) + np.sin(angle) * np.array(part.aside)
    return np.array(part.centre) + part.radius * along


def test_sets_count_the_points_of_what_nobody_annotated_by_shape(map_camera, annotate):
    """Names say nothing: the devkit's nine points for what is round, two for what is straight."""
    shapes = {
        "Circle by name": Line((-9.0, 0.0, 0.0), (9.0, 0.0, 0.0)),
        "arc": Arc((0.0, 0.0, 0.0), 9.0, 0.0, 1.0),
        "chain": CORNER,
        "spot": Spot((5.0, 5.0, 0.0)),
    }
    setup = EvaluationSetup(field_of(shapes), SIZE)
    sums = SetAccumulator(setup, (5,))
    nothing = measure(annotate({}), map_camera(CENTRE), setup)
    sums.add("f", nothing, {5.0: score(nothing, 5)})
    per_class = sums.summary()[5.0].per_class
    assert {name: c.fp for name, c in per_class.items()} == {
        "Circle by name": 2, "arc": 9, "chain": 9, "spot": 1,
    }  # fmt: skip


# ------------------------------------------------------------------------------------ symmetries

FOUR = {
    "east": Line((20.0, -5.0, 0.0), (20.0, 5.0, 0.0)),
    "south": Line((-5.0, 20.0, 0.0), (5.0, 20.0, 0.0)),
    "west": Line((-20.0, -5.0, 0.0), (-20.0, 5.0, 0.0)),
    "north": Line((-5.0, -20.0, 0.0), (5.0, -20.0, 0.0)),
}
SIDES = tuple(FOUR)


def square_field() -> Field:
    """A square that quarter turns take to itself; x to y: from east to south."""
    turns = tuple(
        Symmetry(i * math.pi / 2, {s: SIDES[(k + i) % 4] for k, s in enumerate(SIDES)})
        for i in (1, 2, 3)
    )
    return replace(make_field(FOUR, {}), symmetries=turns)


# Labels as somebody would give them who sees the field turned so often by 90 degrees.
CLICKS = {"east": (71, 25), "south": (50, 46), "west": (29, 25), "north": (50, 4)}


@pytest.mark.parametrize("protocol", PROTOCOLS)
@pytest.mark.parametrize("turns", [1, 2, 3])
def test_of_several_turns_the_best_counts(protocol, turns, map_camera, annotate):
    labelled = {SIDES[(k - turns) % 4]: [CLICKS[s]] for k, s in enumerate(SIDES[:3])}
    found = measured(
        square_field(), annotate(labelled), map_camera(CENTRE), protocol, allow_mirrored=True
    )
    assert len(found.mirrored) == 3
    result = score(found, 2)
    assert (result.mirrored, result.tp, result.fp, result.fn) == (True, 3, 1, 0)
    assert result.labelling is found.mirrored[turns - 1]
    assert jac_curve(found, [2]).tolist() == [0.75]
    assert dict(zip(result.labelling.annotated_names, result.labelling.names, strict=True)) == {
        SIDES[(k - turns) % 4]: s for k, s in enumerate(SIDES[:3])
    }
    # What was not annotated, as this annotator would have called it.
    (missing,) = (e for e in result.elements if e.status == "not_annotated")
    assert (missing.name, missing.annotated_name) == ("north", SIDES[(3 - turns) % 4])


def test_annotators_who_took_one_turn_for_another_are_told(annotate):
    field = square_field()
    points = {s: [(x - 2, y - 2), (x + 2, y + 2)] for s, (x, y) in CLICKS.items()}
    turned = {SIDES[(k + 1) % 4]: points[s] for k, s in enumerate(SIDES)}
    assert compare_annotations(annotate(points), annotate(turned), field, (960, 540)).mirrored_hint
    alone = replace(field, symmetries=())
    assert not compare_annotations(
        annotate(points), annotate(turned), alone, (960, 540)
    ).mirrored_hint


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_a_field_without_symmetry_has_one_labelling(protocol, map_camera, annotate):
    field = make_field(FOUR, {})
    setup = EvaluationSetup(field, SIZE, protocol, allow_mirrored=True)
    assert not setup.considers_mirrored
    assert "mirrored" not in setup.describe()
    found = measure(annotate({"east": [CLICKS["west"]]}), map_camera(CENTRE), setup)
    assert found.mirrored == ()
    assert not score(found, 2).mirrored


def test_annotators_are_compared_on_spots_and_round_corners(annotate):
    """Distances of a spot's clicks; along a chain from click to click, whoever has more of them."""
    spots = field_of({"spot": Spot((0.0, 0.0, 0.0)), "corner": CORNER})
    size = (101, 51)
    clicks = {"spot": [(40, 20)], "corner": [(10, 40), (40, 40), (60, 40), (60, 25), (60, 5)]}
    again = {"spot": [(43, 24)], "corner": [(12, 41), (30, 41), (61, 41), (61, 30), (61, 6)]}
    found = compare_annotations(annotate(clicks), annotate(again), spots, size)
    assert found.by_class["spot"].distances == pytest.approx([5.0, 5.0])
    corner = found.by_class["corner"].distances
    assert len(corner) == 10
    assert corner.max() == pytest.approx(math.sqrt(2))  # outside the corner itself
    assert sorted(corner)[:9] == pytest.approx([1.0] * 9, abs=0.15)
    same = compare_annotations(annotate(clicks), annotate(clicks), spots, size)
    assert same.distances == pytest.approx(0.0, abs=1e-9)


# -------------------------------------------------------------------------------------- optional

MARKED = {
    "line": Line((-20.0, 0.0, 0.0), (20.0, 0.0, 0.0)),
    "mark": Spot((0.0, 10.0, 0.0)),
    "arc": Arc((-20.0, 0.0, 0.0), 5.0, 0.0, math.pi / 2),
}
MARKS = ("mark", "arc")


def test_the_paper_judges_optional_elements_where_they_are_annotated(map_camera, annotate):
    field, camera = field_of(MARKED, optional=MARKS), map_camera(CENTRE)
    line = {"line": [(40, 25)]}
    nothing = score(measured(field, annotate(line), camera, "procc"), 3)
    assert statuses(nothing) == {"line": "tp"}  # neither of the others is a false positive
    near = annotate({**line, "mark": [(51, 35)], "arc": [(35, 25)]})
    assert statuses(score(measured(field, near, camera, "procc"), 3)) == {
        "line": "tp", "mark": "tp", "arc": "tp",
    }  # fmt: skip
    far = score(measured(field, annotate({**line, "mark": [(60, 35)]}), camera, "procc"), 3)
    assert (far.tp, far.fp, far.fn) == (1, 1, 0)
    hidden = score(measured(field, near, map_camera((50.0, 42.0)), "procc"), 3)
    assert statuses(hidden)["mark"] == "missed"
    assert hidden.fn == 1


def test_the_official_evaluation_knows_no_optional_elements(map_camera, annotate):
    """Whatever is done to them, every count is as without them."""
    field, camera = field_of(MARKED, optional=MARKS), map_camera(CENTRE)
    bare = field_of({"line": MARKED["line"]})
    line = {"line": [(40, 26), (60, 27)]}
    alone = measured(bare, annotate(line), camera, "soccernet")
    for more in ({}, {"mark": [(51, 35)]}, {"mark": [(90, 5)], "arc": [(35, 25)]}):
        found = measured(field, annotate({**more, **line}), camera, "soccernet")
        assert found.plain.names == ("line",)
        assert score(found, 5).elements[0].status == "tp"
        assert jac_curve(found, range(1, 9)).tolist() == jac_curve(alone, range(1, 9)).tolist()
        assert set(found.projected.pieces) == {"line"}
    shown = ElementProjections({"mark": (np.array([[50.0, 35.0]]),)})
    setup = EvaluationSetup(field, SIZE)
    assert not project_field(shown, setup).pieces
    assert "mark" in project_field(shown, setup).left_out


def test_optional_elements_are_judged_under_turned_labels_too(map_camera, annotate):
    shapes = {
        "left": Spot((-20.0, 0.0, 0.0)),
        "right": Spot((20.0, 0.0, 0.0)),
        "bar": MARKED["line"],
    }
    mirror = {"left": "right", "right": "left", "bar": "bar"}
    field = field_of(shapes, mirror, optional=("left", "right"))
    annotation = annotate({"bar": [(50, 25)], "left": [(71, 25)]})
    found = measured(field, annotation, map_camera(CENTRE), "procc", allow_mirrored=True)
    result = score(found, 3)
    assert (result.mirrored, result.tp, result.fp, result.fn) == (True, 2, 0, 0)
    sentences = [e.sentence for e in explain_score(result, found, field)]
    assert sentences[1].startswith("left (judged as right, labels mirrored) agrees")


@pytest.mark.parametrize("protocol", PROTOCOLS)
@pytest.mark.parametrize("planar", [False, True])
def test_a_field_of_nothing_but_optional_elements_scores_nothing(
    protocol, planar, map_camera, annotate
):
    shapes = {"mark": MARKED["mark"], "pole": Line((0.0, 0.0, 0.0), (0.0, 0.0, -2.0))}
    field = field_of(shapes, optional=tuple(shapes))
    setup = EvaluationSetup(field, SIZE, protocol, planar_only=planar)
    for polylines in ({}, {"mark": [(51, 35)]}, {"pole": [(50, 25), (50, 20)]}):
        found = measure(annotate(polylines), map_camera(CENTRE), setup)
        result = score(found, 5)
        counts_it = protocol == "procc" and (polylines.keys() - ({"pole"} if planar else set()))
        assert (result.tp + result.fp + result.fn > 0) == bool(counts_it)
        sums = SetAccumulator(setup, (5,))
        sums.add("f", found, {5.0: result})
        assert sums.summary()[5.0].images == 1


# --------------------------------------------------------------------- landmarks without a place


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_landmarks_without_a_place_take_no_part(protocol, map_camera, annotate):
    plain = field_of({"line": Line((0.0, 0, 0), (9.0, 0, 0))})
    known = (
        Landmark("Clock"),
        Landmark("Ball", moving=True),
        Landmark("Ball", position=(3.0, 3.0, 0.0), instant="17"),
    )
    camera = map_camera(CENTRE)
    line = {"line": [(50, 25), (59, 25)]}
    alone = measured(plain, annotate(line), camera, protocol)
    clicked = annotate({**line, "Clock ": [(1, 1)], "Ball": [(53, 28)]})
    for instant in (None, "18"):
        found = measured(with_landmarks(plain, known, instant), clicked, camera, protocol)
        assert statuses(score(found, 5)) == {"line": "tp"}
        assert found.plain.all_distances.tolist() == alone.plain.all_distances.tolist()
    placed = measured(with_landmarks(plain, known, "17"), clicked, camera, "procc")
    assert statuses(score(placed, 5)) == {"line": "tp", "Ball": "tp"}


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_classes_without_geometry_of_the_field_count_beside_landmarks(
    protocol, map_camera, annotate
):
    field = with_landmarks(field_of({"line": Line((0.0, 0, 0), (9.0, 0, 0))}), [Landmark("Clock")])
    annotation = annotate({"line": [(50, 25)], "Line unknown": [(1, 1)], "Clock": [(2, 2)]})
    found = score(measured(field, annotation, map_camera(CENTRE), protocol), 5)
    assert statuses(found) == {"line": "tp", "Line unknown": "missed"}
