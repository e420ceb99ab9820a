"""What is drawn tells the truth: colours by verdict, whiskers to the projection, nothing blind."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px
from procc_annotator.calibration.label_check.finding import Finding, Rule, Severity
from procc_annotator.calibration.prediction.ghosts import Ghost, GhostPiece
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.dataset.review import StoredFinding, store_check
from procc_annotator.field.load import load_field
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.label_placement import place_apart
from procc_annotator.interaction.overlay import (
    GestureContent,
    LastCallCache,
    OverlayBuilder,
    OverlayContent,
    gesture_overlay,
)
from procc_annotator.interaction.overlay_lines import build_wireframes
from procc_annotator.interaction.overlay_predictions import (
    build_ghosts,
    ghost_extent,
    nearest_ghost,
)
from procc_annotator.interaction.overlay_primitives import Box, Draft, Labels, Overlay
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.projection import project_field
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


def content(
    annotation: FrameAnnotation, camera: PinholeCamera = CAMERA, **options: object
) -> OverlayContent:
    measurement = measure(annotation, camera, SETUP)
    return OverlayContent(
        annotation=annotation,
        size=SETUP.size,
        field=FIELD,
        measurement=measurement,
        score=score(measurement, 5.0),
        picture_size=SIZE,
        **options,
    )


def overlay(
    annotation: FrameAnnotation, camera: PinholeCamera = CAMERA, **options: object
) -> Overlay:
    return OverlayBuilder().build(content(annotation, camera, **options))


def segments(found: Overlay, layer: str, colour: str) -> np.ndarray:
    parts = [s.segments for s in found.strokes if s.layer == layer and s.colour == colour]
    return np.concatenate(parts) if parts else np.empty((0, 4))


def marks(found: Overlay, shape: str, colour: str) -> np.ndarray:
    parts = [m.centres for m in found.marks if m.shape == shape and m.colour == colour]
    return np.concatenate(parts)


def test_a_passing_element_is_green_with_dots():
    found = overlay(FrameAnnotation((middle_line(2.0),)))
    assert len(segments(found, "annotation", tones.PASSES)) == 1
    assert len(marks(found, "dot", tones.PASSES)) == 2
    assert len(marks(found, "cross", tones.TOO_FAR)) == 0
    assert len(segments(found, "projection", tones.NOT_ANNOTATED)) > 0


def test_a_failing_element_has_crosses_whiskers_and_distances():
    found = overlay(FrameAnnotation((middle_line(7.2),)))
    assert len(segments(found, "annotation", tones.TOO_FAR)) == 1
    whiskers = segments(found, "whisker", tones.TOO_FAR)
    lengths = np.hypot(whiskers[:, 2] - whiskers[:, 0], whiskers[:, 3] - whiskers[:, 1])
    np.testing.assert_allclose(lengths, 7.2 * 1279 / 959, atol=0.01)
    assert len(marks(found, "cross", tones.TOO_FAR)) == 2
    assert found.labels[0].texts == ("7.2", "7.2")


def test_an_element_the_camera_does_not_show_is_purple_dots():
    goal = Polyline("Goal left crossbar", (point_from_px(10, 10, SIZE), point_from_px(60, 9, SIZE)))
    found = overlay(FrameAnnotation((goal,)))
    (stroke,) = [s for s in found.strokes if len(s.segments) and s.layer == "annotation"]
    assert (stroke.colour, stroke.dash) == (tones.MISSED, tones.STATUS_DASHES["missed"])
    assert len(marks(found, "ring", tones.MISSED)) == 2


def test_the_projection_is_scaled_to_the_picture():
    found = overlay(FrameAnnotation((middle_line(0.0),)))
    projected = segments(found, "projection", tones.PASSES)
    annotated = segments(found, "annotation", tones.PASSES)
    np.testing.assert_allclose(projected[:, [0, 2]].mean(), annotated[:, [0, 2]].mean(), atol=1e-3)
    assert projected.max() <= 1279


def test_blind_shows_nothing_of_the_camera():
    annotation = FrameAnnotation((middle_line(7.2),))
    blind = overlay(annotation, with_projection=False)
    assert not any(len(s.segments) for s in blind.strokes if s.layer in ("projection", "whisker"))
    assert blind.labels[0].texts == ()
    element = FIELD.elements[FIELD.index["Middle line"]]
    assert len(segments(blind, "annotation", element.colour)) == 1
    assert len(marks(blind, "handle", element.colour)) == 2


def test_two_overlays_can_be_compared_row_by_row():
    one = overlay(FrameAnnotation((middle_line(7.2),)), selection="Middle line")
    two = overlay(FrameAnnotation((middle_line(1.0),)), highlight="Circle left")
    assert len(one.strokes) == len(two.strokes)
    assert len(one.marks) == len(two.marks)
    plain = overlay(FrameAnnotation(), with_projection=False, colour_by="class")
    assert len(plain.labels) == len(one.labels)


def test_selection_highlight_draft_and_the_name_at_the_cursor():
    annotation = FrameAnnotation((middle_line(1.0),))
    shown = content(annotation, selection=("Middle line", 1), highlight="Middle line")
    found = OverlayBuilder().build(shown)
    assert len(segments(found, "selection", tones.HALO)) == 1
    assert len(segments(found, "selection", tones.OUTLINE)) == 1
    assert len(marks(found, "ring", tones.HALO)) == 1
    (title,) = gesture_overlay(shown, GestureContent(annotation, pointer=(5.0, 6.0))).labels
    assert title.texts == ("Halfway line",)
    assert title.positions.tolist() == [[5.0, 6.0]]
    draft = Draft("Circle left", ((1, 2), (3, 4)), (9, 9))
    drawing = gesture_overlay(shown, GestureContent(annotation, draft))
    assert drawing.labels[0].texts == ("Left penalty arc",)
    band = [s for s in drawing.strokes if s.layer == "draft" and s.dash]
    assert band[0].segments.tolist() == [[3, 4, 9, 9]]


@pytest.mark.parametrize("colour_by", ["criterion", "class"])
@pytest.mark.parametrize("camera", [CAMERA, None])
def test_a_dragged_element_looks_as_it_does_at_rest(colour_by, camera):
    annotation = FrameAnnotation(
        (middle_line(7.2), Polyline("Corner flag", middle_line(90).points))
    )
    shown = content(
        annotation,
        highlight="Middle line",
        selection=("Middle line", 1),
        colour_by=colour_by,
        with_projection=camera is not None,
    )
    whole = OverlayBuilder().build(shown)
    dragged = replace(shown, dragged=frozenset({"Middle line", "Corner flag"}))
    parts = OverlayBuilder().build(dragged), gesture_overlay(dragged, GestureContent(annotation))
    assert _looks(whole) == sorted(look for part in parts for look in _looks(part))


def _looks(found: Overlay) -> list[tuple[object, ...]]:
    """Each line and point with its look."""
    lines = [
        (s.layer, s.colour, s.width, s.dash, *row) for s in found.strokes for row in s.segments
    ]
    points = [(m.shape, m.colour, m.size, (), *at) for m in found.marks for at in m.centres]
    return sorted(lines + points)


def test_mirrored_labels_colour_what_the_annotator_drew():
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
def test_an_unknown_class_is_drawn_too(colour_by):
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


def test_what_stays_is_the_very_same_in_the_next_overlay():
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


# Findings over a picture: which signs, where, and with which names.

SMALL = (101, 51)
FRAME = FrameAnnotation(
    (
        Polyline("Middle line", (Point(0.5, 0.0), Point(0.5, 0.5), Point(0.5, 1.0))),
        Polyline("Side line top", (Point(0.0, 0.2), Point(1.0, 0.2))),
    )
)


def found(*findings: Finding) -> tuple[StoredFinding, ...]:
    return store_check(FRAME, findings, FitResult("R", SMALL, None)).found


def finding(name: str, severity: Severity, point: int | None = None) -> Finding:
    return Finding(Rule.POINT, severity, (name,), "it is off", (), point)


def drawn(*findings: Finding, **more: object) -> Overlay:
    annotation = more.pop("annotation", FRAME)
    assert isinstance(annotation, FrameAnnotation)
    return OverlayBuilder().build(
        OverlayContent(
            annotation=annotation,
            size=SMALL,
            field=FIELD,
            picture_size=SMALL,
            found=found(*findings),
            **more,
        )
    )


def signs(overlay: Overlay) -> dict[str, Labels]:
    return {labels.sign: labels for labels in overlay.labels if labels.sign}


def test_an_element_bears_the_sign_of_its_surest_finding():
    shown = signs(
        drawn(
            finding("Middle line", Severity.WARNING, 0),
            finding("Middle line", Severity.ERROR, 2),
            finding("Side line top", Severity.WARNING),
        )
    )
    assert shown["error"].texts == ("Halfway line",)
    np.testing.assert_allclose(shown["error"].positions, [[50, 50]])
    assert shown["warning"].texts == ("Far touchline",)
    assert shown["hint"].texts == ()


def test_a_hint_is_named_only_where_somebody_looks():
    hint = finding("Middle line", Severity.HINT)
    assert signs(drawn(hint))["hint"].texts == ("",)
    assert signs(drawn(hint, selection="Middle line"))["hint"].texts == ("Halfway line",)


def test_a_sign_beside_the_picture_is_brought_to_its_edge():
    beside = FRAME.with_polyline(Polyline("Side line top", (Point(1.4, 0.2),)))
    overlay = drawn(finding("Side line top", Severity.ERROR, 0), annotation=beside)
    np.testing.assert_allclose(signs(overlay)["error"].positions, [[100, 10]])
    np.testing.assert_allclose(overlay.marks[-1].centres, [[140, 10]])  # the point itself


def test_only_a_point_that_is_wrong_by_itself_is_ringed():
    ring = drawn(
        finding("Middle line", Severity.ERROR, 1), finding("Side line top", Severity.ERROR)
    ).marks[-1]
    assert (ring.shape, ring.colour) == ("ring", tones.FINDING)
    np.testing.assert_allclose(ring.centres, [[50, 25]])


def test_overlays_have_the_same_groups_whatever_was_found():
    bare, full = drawn(), drawn(finding("Middle line", Severity.ERROR, 1))
    for groups in ("strokes", "marks", "labels"):
        assert len(getattr(bare, groups)) == len(getattr(full, groups))


def test_a_point_that_a_gesture_takes_away_loses_its_sign():
    shorter = FRAME.with_polyline(Polyline("Middle line", (Point(0.5, 0.0),)))
    overlay = drawn(finding("Middle line", Severity.ERROR, 2), annotation=shorter)
    assert signs(overlay)["error"].texts == ()
    assert not len(overlay.marks[-1].centres)


# Ghosts as curves in their bands; the current one stands out and says what it is.

ACROSS = np.column_stack((np.linspace(100, 300, 21), np.full(21, 50.0)))
LEVEL = Ghost("Side line top", (GhostPiece(ACROSS, np.full(21, 1.5)),))
PARTS = Ghost(
    "Middle line",
    (
        GhostPiece(np.array([[10.0, 10], [10, 20]]), np.array([0.5, 1.0])),
        GhostPiece(np.array([[10.0, 40], [10, 80], [10, 120]]), np.array([1.0, 1.0, 2.0])),
    ),
)


def test_the_curve_is_dash_dot_on_a_rim_and_pieces_are_not_joined():
    overlay = build_ghosts([LEVEL, PARTS])
    rim, line = overlay.strokes
    assert (line.colour, line.dash) == (tones.GHOST, tones.GHOST_DASH)
    assert len(line.dash) == 4
    assert rim.width > line.width
    assert len(line.segments) == 20 + 1 + 2
    lengths = np.hypot(*(line.segments[:, 2:] - line.segments[:, :2]).T)
    assert lengths.max() == pytest.approx(40.0)
    assert not overlay.marks
    assert not overlay.labels


def test_the_band_reaches_two_standard_deviations_to_both_sides():
    (patch,) = build_ghosts([LEVEL]).patches
    assert set(np.round(patch.outline[:, 1], 9)) == {47.0, 53.0}
    assert patch.outline[:, 0].min() == 100
    assert patch.outline[:, 0].max() == 300
    first, second = build_ghosts([PARTS]).patches
    assert np.ptp(first.outline[[1, 2], 0]) == pytest.approx(4 * 1.0)
    assert np.ptp(second.outline[[2, 3], 0]) == pytest.approx(4 * 2.0)


def test_the_current_one_is_stronger_named_and_shows_its_points():
    points = np.array([[110.0, 50.0], [200.0, 50.0]])
    overlay = build_ghosts(
        [LEVEL, PARTS], current=PARTS, label="Halfway line  ±2.0 px", points_px=points
    )
    _, faint, _, strong = overlay.strokes
    assert strong.width > faint.width
    assert strong.colour == faint.colour
    assert len(strong.segments) == 3
    assert len(faint.segments) == 20
    (marks,) = overlay.marks
    assert np.array_equal(marks.centres, points)
    (labels,) = overlay.labels
    assert labels.texts == ("Halfway line  ±2.0 px",)
    assert labels.positions[0].tolist() == [10.0, 80.0]  # of the longest stretch
    assert overlay.patches[-1].opacity > overlay.patches[0].opacity


def test_a_course_with_a_point_twice_has_a_band_all_the_same():
    course = np.array([[0.0, 0], [5, 0], [5, 0], [5, 0], [9, 0]])
    (patch,) = build_ghosts([Ghost("x", (GhostPiece(course, np.ones(5)),))]).patches
    assert np.isfinite(patch.outline).all()


def test_extent_is_that_of_all_pieces():
    assert ghost_extent(PARTS) == (10, 10, 10, 120)


@pytest.mark.parametrize(
    ("position", "found"),
    [
        ((205.0, 53.0), "Side line top"),  # between two points of the course
        ((12.0, 60.0), "Middle line"),
        ((12.0, 30.0), None),  # in the gap
        ((205.0, 70.0), None),
    ],
)
def test_what_lies_under_the_cursor(position, found):
    assert nearest_ghost([LEVEL, PARTS], position, 5.0) == found


def test_a_dense_curve_is_drawn_with_few_points_and_hardly_off():
    angle = np.linspace(0, np.pi, 4000)
    course = 30 * np.column_stack((np.cos(angle), np.sin(angle)))
    overlay = build_ghosts([Ghost("Circle left", (GhostPiece(course, np.ones(4000)),))])
    segments = overlay.strokes[-1].segments
    assert len(segments) < 40
    assert np.allclose(segments[[0, -1]][[0, 1], [0, 2]], course[[0, -1], 0])
    middles = (segments[:, :2] + segments[:, 2:]) / 2
    assert np.abs(np.hypot(*middles.T) - 30).max() < 0.1


# What further sources show of the field, as lines in their colours.

FRAME_SETUP = EvaluationSetup(load_field())
# The field from straight above, 8 px a metre, its centre in the middle of the picture.
ABOVE = HomographyCamera(np.array([[8.0, 0, 479.5], [0, 7.0, 269.5], [0, 0, 1.0]]))


def test_lines_lie_where_the_camera_shows_the_elements():
    projected = project_field(ABOVE, FRAME_SETUP)
    overlay = build_wireframes([(projected, "#e4572e")], FRAME_SETUP.size, (1919, 1079))
    rim, line = overlay.strokes
    assert (line.colour, line.dash) == ("#e4572e", ())
    assert rim.width > line.width
    assert np.array_equal(rim.segments, line.segments)
    # Centres of the corner pixels coincide: 1918 steps between them where there were 959.
    pieces = [p for parts in projected.pieces.values() for p in parts]
    ends = np.concatenate([np.hstack([p[:-1], p[1:]]) for p in pieces]) * 2
    assert np.allclose(line.segments, ends)
    halfway = line.segments[np.abs(line.segments[:, 0] - 959).argmin()]
    assert np.isclose(halfway[0], 959.0, atol=1e-6)


def test_every_source_has_its_own_lines_the_last_on_top():
    projected = project_field(ABOVE, FRAME_SETUP)
    overlay = build_wireframes(
        [(projected, "#111111"), (projected, "#222222")], FRAME_SETUP.size, (960, 540)
    )
    assert [s.colour for s in overlay.strokes][1::2] == ["#111111", "#222222"]
    assert not overlay.marks
    assert build_wireframes([], FRAME_SETUP.size, (960, 540)).strokes == ()


# Texts on a picture do not cover each other as long as there is room.

ROOM = (0.0, 0.0, 400.0, 300.0)


def covers(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def test_what_is_free_stays_where_it_would_go():
    assert place_apart((10, 10, 50, 22), [(60, 10, 90, 22)], ROOM) == (10, 10, 50, 22)


@given(st.lists(st.tuples(st.floats(0, 360), st.floats(0, 280)), min_size=2, max_size=12))
def test_none_covers_another(points):
    taken: list[Box] = []
    for x, y in points:
        taken.append(place_apart((x, y, x + 30, y + 12), taken, ROOM))
    for number, box in enumerate(taken):
        assert all(not covers(box, other) for other in taken[:number])


def test_without_room_it_stays():
    box = (0.0, 0.0, 10.0, 10.0)
    assert place_apart(box, [box], box) == box


# A result is given again only for the same arguments.


def test_the_same_arguments_give_the_very_same_result():
    join = LastCallCache(lambda *parts, end="": [*parts, end])
    first = join("a", (1, 2), end=".")
    assert join("a", (1, 2), end=".") is first
    assert join("a", (1, 3), end=".") == ["a", (1, 3), "."]
    assert join("a", (1, 2), end=".") is not first  # only the last one is kept


def test_other_keywords_are_other_arguments():
    join = LastCallCache(lambda *parts, end="": [*parts, end])
    assert join("a", end="!") == ["a", "!"]
    assert join("a") == ["a", ""]
