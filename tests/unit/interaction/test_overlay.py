"""What is drawn tells the truth: colours by verdict, whiskers to the projection, nothing blind."""

from __future__ import annotations

import math

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.overlay import OverlayBuilder, OverlayContent
from procc_annotator.interaction.overlay_primitives import Draft, Overlay
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field()
SETUP = EvaluationSetup(FIELD)
SIZE = (1280, 720)
CAMERA = PinholeCamera(0, math.radians(76), 0, (0, 60, -15), (1300, 1300), (479.5, 269.5))


def middle_line(shift_px: float) -> Polyline:
    """The halfway line as the camera sees it, moved sideways by evaluation pixels."""
    px, _ = CAMERA.project(np.array([[0, -20.0, 0], [0, 0.0, 0]]))
    points = tuple(point_from_px(x + shift_px, y, SETUP.size) for x, y in px)
    return Polyline("Middle line", points)


def overlay(
    annotation: FrameAnnotation, camera: PinholeCamera = CAMERA, **options: object
) -> Overlay:
    measurement = measure(annotation, camera, SETUP)
    found = score(measurement, 5.0)
    return OverlayBuilder().build(
        OverlayContent(
            annotation=annotation,
            size=SETUP.size,
            field=FIELD,
            measurement=measurement,
            score=found,
            picture_size=SIZE,
            **options,
        )
    )


def segments(found: Overlay, layer: str, colour: str) -> np.ndarray:
    parts = [s.segments for s in found.strokes if s.layer == layer and s.colour == colour]
    return np.concatenate(parts) if parts else np.empty((0, 4))


def marks(found: Overlay, shape: str, colour: str) -> np.ndarray:
    parts = [m.centres for m in found.marks if m.shape == shape and m.colour == colour]
    return np.concatenate(parts)


def test_a_passing_element_is_green_with_dots() -> None:
    found = overlay(FrameAnnotation((middle_line(2.0),)))
    assert len(segments(found, "annotation", tones.PASSES)) == 1
    assert len(marks(found, "dot", tones.PASSES)) == 2
    assert len(marks(found, "cross", tones.TOO_FAR)) == 0
    assert len(segments(found, "projection", tones.NOT_ANNOTATED)) > 0


def test_a_failing_element_has_crosses_whiskers_and_distances() -> None:
    found = overlay(FrameAnnotation((middle_line(7.2),)))
    assert len(segments(found, "annotation", tones.TOO_FAR)) == 1
    whiskers = segments(found, "whisker", tones.TOO_FAR)
    lengths = np.hypot(whiskers[:, 2] - whiskers[:, 0], whiskers[:, 3] - whiskers[:, 1])
    np.testing.assert_allclose(lengths, 7.2 * 1279 / 959, atol=0.01)
    assert len(marks(found, "cross", tones.TOO_FAR)) == 2
    assert found.labels[0].texts == ("7.2", "7.2")


def test_an_element_the_camera_does_not_show_is_purple_dots() -> None:
    goal = Polyline("Goal left crossbar", (point_from_px(10, 10, SIZE), point_from_px(60, 9, SIZE)))
    found = overlay(FrameAnnotation((goal,)))
    (stroke,) = [s for s in found.strokes if len(s.segments) and s.layer == "annotation"]
    assert (stroke.colour, stroke.dash) == (tones.MISSED, tones.STATUS_DASHES["missed"])
    assert len(marks(found, "ring", tones.MISSED)) == 2


def test_the_projection_is_scaled_to_the_picture() -> None:
    found = overlay(FrameAnnotation((middle_line(0.0),)))
    projected = segments(found, "projection", tones.PASSES)
    annotated = segments(found, "annotation", tones.PASSES)
    np.testing.assert_allclose(projected[:, [0, 2]].mean(), annotated[:, [0, 2]].mean(), atol=1e-3)
    assert projected.max() <= 1279


def test_blind_shows_nothing_of_the_camera() -> None:
    annotation = FrameAnnotation((middle_line(7.2),))
    blind = overlay(annotation, with_projection=False)
    assert not any(len(s.segments) for s in blind.strokes if s.layer in ("projection", "whisker"))
    assert blind.labels[0].texts == ()
    element = FIELD.elements[FIELD.index["Middle line"]]
    assert len(segments(blind, "annotation", element.colour)) == 1
    assert len(marks(blind, "handle", element.colour)) == 2


def test_two_overlays_can_be_compared_row_by_row() -> None:
    one = overlay(FrameAnnotation((middle_line(7.2),)), selection="Middle line")
    two = overlay(FrameAnnotation((middle_line(1.0),)), draft=Draft("Circle left", ((1, 2),)))
    assert len(one.strokes) == len(two.strokes)
    assert len(one.marks) == len(two.marks)
    plain = overlay(FrameAnnotation(), with_projection=False, colour_by="class")
    assert len(plain.labels) == len(one.labels)


def test_selection_highlight_draft_and_the_name_at_the_cursor() -> None:
    annotation = FrameAnnotation((middle_line(1.0),))
    found = overlay(
        annotation, selection=("Middle line", 1), highlight="Middle line", pointer=(5.0, 6.0)
    )
    assert len(segments(found, "selection", tones.HALO)) == 1
    assert len(segments(found, "selection", tones.OUTLINE)) == 1
    assert len(marks(found, "ring", tones.HALO)) == 1
    assert found.labels[1].texts == ("Halfway line",)
    assert found.labels[1].positions.tolist() == [[5.0, 6.0]]
    drawing = overlay(annotation, draft=Draft("Circle left", ((1, 2), (3, 4)), (9, 9)))
    assert drawing.labels[1].texts == ("Left penalty arc",)
    band = [s for s in drawing.strokes if s.layer == "draft" and s.dash]
    assert band[0].segments.tolist() == [[3, 4, 9, 9]]


def test_mirrored_labels_colour_what_the_annotator_drew() -> None:
    """The whole frame labelled as the other end: the official evaluation counts it as right."""
    right = PinholeCamera(
        math.radians(35), math.radians(76), 0, (0, 60, -15), (1300, 1300), (479.5, 269.5)
    )
    points_world = np.array([[52.5, -18.0, 0], [52.5, 5.0, 0]])
    px, _ = right.project(points_world)
    points = tuple(point_from_px(x, y, SETUP.size) for x, y in px)
    annotation = FrameAnnotation((Polyline("Side line left", points),))
    assert score(measure(annotation, right, SETUP), 5.0).mirrored
    drawn = overlay(annotation, right)
    assert len(segments(drawn, "annotation", tones.PASSES)) == 1
    assert len(segments(drawn, "projection", tones.PASSES)) > 0


@pytest.mark.parametrize("colour_by", ["criterion", "class"])
def test_an_unknown_class_is_drawn_too(colour_by) -> None:
    flag = Polyline("Corner flag", (point_from_px(10, 10, SIZE), point_from_px(60, 9, SIZE)))
    found = OverlayBuilder().build(
        OverlayContent(
            annotation=FrameAnnotation((flag,)),
            size=SETUP.size,
            field=FIELD,
            picture_size=SIZE,
            colour_by=colour_by,
        )
    )
    assert len(segments(found, "annotation", tones.UNKNOWN_CLASS)) == 1
    assert len(marks(found, "handle", tones.UNKNOWN_CLASS)) == 2


def test_what_stays_is_the_very_same_in_the_next_overlay() -> None:
    """A drag of one element makes its own groups anew, and nothing of the others."""
    builder = OverlayBuilder()

    def build(*polylines: Polyline) -> Overlay:
        annotation = FrameAnnotation(polylines)
        return builder.build(
            OverlayContent(
                annotation=annotation, size=SETUP.size, field=FIELD, picture_size=SIZE, found=()
            )
        )

    side = Polyline("Side line top", (point_from_px(5, 9, SIZE), point_from_px(90, 12, SIZE)))
    one, two = build(middle_line(1.0), side), build(middle_line(4.0), side)
    lines = [(a, b) for a, b in zip(one.seen_strokes, two.seen_strokes, strict=True)]
    assert [a is b for a, b in lines if a.colour == FIELD.element(side.class_name).colour] == [True]
    assert [a is b for a, b in zip(one.seen_marks, two.seen_marks, strict=True)].count(False) == 1
    assert len([a for a, b in lines if a is not b]) == 1
    fresh = OverlayBuilder().build(
        OverlayContent(
            annotation=FrameAnnotation((middle_line(4.0), side)),
            size=SETUP.size,
            field=FIELD,
            picture_size=SIZE,
            found=(),
        )
    )
    for a, b in zip(two.strokes, fresh.strokes, strict=True):
        np.testing.assert_array_equal(a.segments, b.segments)
        assert (a.colour, a.width, a.dash) == (b.colour, b.width, b.dash)
