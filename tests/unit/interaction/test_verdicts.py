"""What the score says is drawn where the score found it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.overlay import (
    GestureContent,
    OverlayBuilder,
    OverlayContent,
    gesture_overlay,
)
from procc_annotator.interaction.overlay_primitives import (
    Draft,
    Overlay,
    ScoredFrame,
    ScoredProjection,
    scored_frame,
)
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field()
SIZE = (1280, 720)
CAMERAS = {
    "main": PinholeCamera(
        0, math.radians(76), 0, (0, 60, -15), (1300, 1300), (479.5, 269.5)
    ),
    "towards the right end": PinholeCamera(
        math.radians(35), math.radians(76), 0, (0, 60, -15), (1300, 1300), (479.5, 269.5)
    ),
    "distorted": PinholeCamera(
        math.radians(20), math.radians(78), 0, (0, 60, -15), (900, 900), (479.5, 269.5),
        (-0.15, 0.02, 0, 0, 0, 0),
    ),
}  # fmt: skip
RIGHT = CAMERAS["towards the right end"]
# A part of the right goal line, which runs across the picture.
GOAL_LINE = np.array([[52.5, -18.0, 0], [52.5, 5.0, 0]])


def setup(protocol: str = "soccernet") -> EvaluationSetup:
    return EvaluationSetup(FIELD, protocol=protocol)


def annotated(name: str, world: np.ndarray, shift_px: float = 0.0) -> FrameAnnotation:
    px, _ = RIGHT.project(world)
    points = tuple(point_from_px(x, y + shift_px, (960, 540)) for x, y in px)
    return FrameAnnotation((Polyline(name, points),))


def judged(
    annotation: FrameAnnotation, tau: float = 5.0, protocol: str = "soccernet", **options: object
) -> Overlay:
    measurement = measure(annotation, RIGHT, setup(protocol))
    return OverlayBuilder().build(
        OverlayContent(
            annotation=annotation,
            size=(960, 540),
            field=FIELD,
            measurement=measurement,
            score=score(measurement, tau),
            picture_size=SIZE,
            **options,
        )
    )


def layer(found: Overlay, name: str, colour: str) -> np.ndarray:
    return np.concatenate(
        [s.segments for s in found.strokes if (s.layer, s.colour) == (name, colour)]
    )


@pytest.mark.parametrize("protocol", ["soccernet", "procc"])
@pytest.mark.parametrize("camera", CAMERAS)
def test_every_visible_piece_is_drawn_and_no_gap_is_bridged(camera, protocol) -> None:
    measurement = measure(FrameAnnotation(), CAMERAS[camera], setup(protocol))
    found = scored_frame(measurement, score(measurement, 5.0), SIZE)
    pieces = measurement.projected.pieces
    assert set(found.projection.by_element) == set(pieces)
    factor = np.array([1279 / 959, 719 / 539])
    for name, parts in pieces.items():
        if FIELD.element(name).is_spot:
            continue
        expected = [np.hstack([p[:-1], p[1:]]) * np.tile(factor, 2) for p in parts]
        np.testing.assert_allclose(found.projection.by_element[name], np.concatenate(expected))


def test_spots_are_crosses_and_optional_elements_without_clicks_are_unjudged() -> None:
    measurement = measure(FrameAnnotation(), CAMERAS["main"], setup("procc"))
    found = scored_frame(measurement, score(measurement, 5.0), SIZE)
    across, down = found.projection.by_element["Centre mark"]
    (place,), factor = measurement.projected.pieces["Centre mark"], (1279 / 959, 719 / 539)
    for stroke in (across, down):
        assert (stroke[:2] + stroke[2:]) / 2 == pytest.approx(place[0] * factor)
        assert np.hypot(*(stroke[2:] - stroke[:2])) == pytest.approx(15.36)
    overlay = judged(FrameAnnotation(), protocol="procc")
    drawn = layer(overlay, "projection", tones.UNKNOWN_CLASS)
    pieces = measure(FrameAnnotation(), RIGHT, setup("procc")).projected.pieces
    assert len(drawn) >= sum(FIELD.element(name).optional for name in pieces) > 1
    assert not len(layer(judged(FrameAnnotation()), "projection", tones.UNKNOWN_CLASS))


def test_mirrored_labels_emphasise_the_element_they_are_judged_against() -> None:
    annotation = annotated("Side line left", GOAL_LINE)
    plain = judged(FrameAnnotation(), highlight="Side line right")
    found = judged(annotation, highlight="Side line left", selection="Side line left")
    np.testing.assert_array_equal(
        layer(found, "projection", tones.PASSES), layer(plain, "highlight", tones.HALO)
    )
    assert len(layer(plain, "highlight", tones.HALO)) > 0
    under = layer(found, "highlight", tones.HALO)
    assert len(under) == len(layer(found, "projection", tones.PASSES)) + 1


def test_whiskers_of_mirrored_labels_end_on_the_projection() -> None:
    found = judged(annotated("Side line left", GOAL_LINE, shift_px=9.0))
    whiskers = layer(found, "whisker", tones.TOO_FAR)
    lengths = np.hypot(*(whiskers[:, 2:] - whiskers[:, :2]).T)
    texts = [float(t) for t in found.labels[0].texts]
    assert len(texts) == 2
    np.testing.assert_allclose(lengths, np.array(texts) * 1279 / 959, atol=0.15)


def test_each_point_of_a_failing_element_has_its_own_verdict() -> None:
    px, _ = RIGHT.project(GOAL_LINE)
    points = (point_from_px(*px[0], (960, 540)), point_from_px(px[1, 0], px[1, 1] + 12, (960, 540)))
    # Nothing passes, so that the official protocol would prefer the mirrored labels.
    found = judged(FrameAnnotation((Polyline("Side line right", points),)), protocol="procc")
    crosses = [m.centres for m in found.marks if m.shape == "cross" and len(m.centres)]
    dots = [m.centres for m in found.marks if m.shape == "dot" and len(m.centres)]
    assert [len(c) for c in crosses] == [1]
    assert [len(d) for d in dots] == [1]
    assert len(found.labels[0].texts) == 1
    assert len(layer(found, "annotation", tones.TOO_FAR)) == 1


def test_the_selected_element_shows_all_its_distances() -> None:
    annotation = annotated("Side line right", GOAL_LINE, shift_px=1.0)
    assert judged(annotation).labels[0].texts == ()
    assert len(judged(annotation, selection="Side line right").labels[0].texts) == 2


def test_the_threshold_decides_and_nothing_else_moves() -> None:
    annotation = annotated("Side line right", GOAL_LINE, shift_px=3.0)
    strict, loose = (judged(annotation, tau, "procc") for tau in (1.0, 8.0))
    np.testing.assert_array_equal(
        layer(strict, "whisker", tones.TOO_FAR), layer(loose, "whisker", tones.PASSES)
    )
    assert len(layer(loose, "whisker", tones.TOO_FAR)) == 0


def test_a_projected_element_that_is_not_annotated_can_be_selected() -> None:
    found = judged(FrameAnnotation(), selection="Side line right")
    halo, rim = (layer(found, "selection", c) for c in (tones.HALO, tones.OUTLINE))
    assert len(halo) > 0
    np.testing.assert_array_equal(halo, rim)
    blind = judged(FrameAnnotation(), selection="Side line right", with_projection=False)
    assert len(layer(blind, "selection", tones.HALO)) == 0


def test_the_halo_lies_under_every_line() -> None:
    found = judged(annotated("Side line right", GOAL_LINE), selection="Side line right")
    layers = [s.layer for s in found.strokes]
    last_halo = max(i for i, name in enumerate(layers) if name in ("selection", "highlight"))
    assert last_halo < min(layers.index("projection"), layers.index("annotation"))


def test_a_point_without_a_distance_fails_without_a_whisker() -> None:
    nowhere = np.full((1, 2), np.nan)
    found = ScoredFrame(
        {"Middle line": "too_far"}, {}, ScoredProjection({}, {}), np.ones((1, 2)), nowhere,
        np.array([np.nan]), np.array([False]), ("Middle line",),
    )  # fmt: skip
    assert len(found.failing) == 1
    assert len(found.failing_error_vectors) == 0
    assert found.labelled(None)[1] == ("no distance",)


def test_a_draft_continues_where_the_element_ends() -> None:
    annotation = annotated("Side line right", GOAL_LINE)
    end = annotation.polylines[0].points[-1]
    shown = OverlayContent(annotation=annotation, size=(960, 540), field=FIELD, picture_size=SIZE)

    def drafted(*points: tuple[float, float]) -> Overlay:
        draft = Draft("Side line right", points, (50.0, 60.0))
        return gesture_overlay(shown, GestureContent(annotation, draft))

    (band,) = [s.segments for s in drafted().strokes if s.dash == (4, 4)]
    np.testing.assert_allclose(band, [[end.u * 1279, end.v * 719, 50, 60]])
    element = FIELD.element("Side line right")
    drawn = layer(drafted((70.0, 80.0)), "draft", element.colour)
    np.testing.assert_allclose(drawn, [[end.u * 1279, end.v * 719, 70, 80], [70, 80, 50, 60]])


def test_the_states_differ_without_colour() -> None:
    """In lines or in marks: a passing and a failing line differ by dots and crosses."""
    dashes = tones.STATUS_DASHES
    assert dashes["tp"] == dashes["too_far"] == ()
    assert len({dashes["tp"], dashes["not_annotated"], dashes["missed"]}) == 3
    assert len(set(tones.STATUS_COLOURS.values())) == 4


def test_a_distance_line_to_a_foot_outside_the_picture_is_drawn_as_it_is() -> None:
    """A click on the picture's border, where the projection is just beyond it."""
    touchline = np.array([[x, 34.0, 0] for x in np.linspace(-52.5, 52.5, 2001)])
    camera = PinholeCamera(
        math.radians(4), math.radians(76), 0, (0, 90, -18), (1300, 1300), (479.5, 450.0)
    )
    px, seen = camera.project(touchline)
    outside = px[seen & (px[:, 1] > 540) & (px[:, 1] < 545) & (px[:, 0] > 50) & (px[:, 0] < 900)]
    x, y = outside[len(outside) // 2]
    annotation = FrameAnnotation(
        (Polyline("Side line bottom", (point_from_px(x, 539, (960, 540)),)),)
    )
    measurement = measure(annotation, camera, setup("procc"))
    found = scored_frame(measurement, score(measurement, 10.0), (960, 540))
    assert found.status == {"Side line bottom": "tp"}
    (whisker,) = found.passing_error_vectors
    assert whisker[3] > 539.5
    assert np.hypot(*(whisker[2:] - whisker[:2])) == pytest.approx(found.distances[0], abs=1e-6)
    assert found.distances[0] <= y - 539 + 1e-6
