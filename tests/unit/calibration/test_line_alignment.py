"""A camera that is nearly right is made right on the paint of its picture, and told how surely."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from procc_annotator.calibration.line_alignment.control_points import (
    ControlPoint,
    align_with_control_points,
    control_point_errors,
    fit_control_points,
    rotated_camera,
)
from procc_annotator.calibration.line_alignment.expected_lines import (
    expected_line_points,
    marking_points,
)
from procc_annotator.calibration.line_alignment.gaussian_state import (
    edge_point_errors,
    geman_mcclure_weights,
)
from procc_annotator.calibration.line_alignment.refinement import (
    align_with_lines,
    displaced_elements,
    displaced_elements_in_image,
    edge_point_residuals,
    found_shares,
    measure_lines,
    search_nearby,
)
from procc_annotator.calibration.optimization.camera_parameters import vector_from_camera
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Appearance, Field
from tests.drawn_shots import draw as draw_scene
from tests.drawn_shots import looking_at, stage_of
from tests.unit.calibration.plain_pictures import FIELD, FRAME, SIZE, apart_px, camera, draw

TRUE = camera()
VECTOR = vector_from_camera(TRUE, FRAME)


def test_a_camera_beside_its_paint_is_put_on_it():
    beside = replace(TRUE, pan_rad=TRUE.pan_rad + 0.006, tilt_rad=TRUE.tilt_rad - 0.003)
    assert apart_px(TRUE, beside) > 5
    found = align_with_lines(draw(TRUE), FIELD, beside)
    assert isinstance(found.fit.camera, type(TRUE))
    assert apart_px(TRUE, found.fit.camera) < 0.7
    assert found.coverage > 0.9
    assert found.residual_px is not None
    assert found.residual_px < 0.3
    assert found.shares["Big rect. right main"] > 0.9
    assert not found.fit.left_out


def test_what_is_said_of_its_sureness_is_true():
    offs = []
    for seed in range(6):
        found = align_with_lines(draw(TRUE, noise=6.0, seed=seed), FIELD, TRUE).fit
        assert found.vector is not None
        assert found.covariance is not None
        off = (found.vector - VECTOR)[:8]
        offs.append(off / np.sqrt(np.diag(found.covariance)))
    assert 0.1 < np.sqrt(np.mean(np.square(offs))) < 2.0


def test_a_picture_without_lines_has_no_camera():
    found = align_with_lines(draw(TRUE, lines=False), FIELD, TRUE)
    assert found.fit.camera is None or found.coverage < 0.3
    blank = np.full((SIZE[1], SIZE[0], 4), 90, dtype=np.uint8)
    found = align_with_lines(blank, FIELD, TRUE)
    assert found.fit.camera is None
    assert found.fit.failure
    assert found.residual_px is None


def test_a_camera_that_sees_nothing_of_the_field_expects_nothing():
    away = vector_from_camera(replace(TRUE, pan_rad=TRUE.pan_rad + np.pi), FRAME)
    assert not len(expected_line_points(away, marking_points(FIELD), FRAME, 5.0).rows)
    assert align_with_lines(draw(TRUE), FIELD, away).fit.camera is None


def test_paint_darker_than_its_ground_is_found_as_such():
    dark = replace(
        FIELD,
        elements=tuple(
            replace(e, appearance=Appearance("line", "darker", "any", e.line_width))
            for e in FIELD.elements
            if e.line_width
        ),
    )
    picture = draw(TRUE)
    inverted = picture.copy()
    inverted[..., :3] = 255 - picture[..., :3]
    for field, shown, found in (
        (dark, inverted, True),
        (dark, picture, False),
        (FIELD, inverted, False),
    ):
        painted = marking_points(field)
        seen = measure_lines(shown, VECTOR, painted, FRAME, 4.0)
        share, _ = found_shares(seen, np.ones(len(seen.marks)), painted)
        assert (share > 0.8) == found


def test_derivatives_of_marks_are_those_of_where_they_appear():
    marks = measure_lines(draw(TRUE), VECTOR, marking_points(FIELD), FRAME, 4.0).marks
    _, by = edge_point_errors(VECTOR[None], marks, FRAME.half_diagonal)
    for parameter, step in enumerate((1e-6, 1e-6, 1e-6, 1e-4, 1e-4, 1e-4, 1e-6, 1e-5)):
        ahead, back = VECTOR.copy(), VECTOR.copy()
        ahead[parameter] += step
        back[parameter] -= step
        off = edge_point_errors(np.array([ahead, back]), marks, FRAME.half_diagonal)[0]
        assert (off[1] - off[0]) / (2 * step) == pytest.approx(
            by[0, :, parameter], rel=1e-3, abs=1e-3
        )


def _with_a_line_elsewhere(name: str, metres: float) -> Field:
    """The field as a file has it that puts one of its lines beside where it is painted."""
    changed = []
    for element in FIELD.elements:
        if element.name == name:
            line = element.geometry
            (ax, ay, az), (bx, by, bz) = line.start, line.end
            moved = replace(line, start=(ax + metres, ay, az), end=(bx + metres, by, bz))
            element = replace(element, geometry=moved)
        changed.append(element)
    return replace(FIELD, elements=tuple(changed))


@pytest.mark.parametrize("metres", [0.35, -0.35])
def test_a_line_that_lies_beside_its_paint_is_named(metres):
    picture, moved = draw(TRUE), _with_a_line_elsewhere("Big rect. right main", metres)
    assert not displaced_elements_in_image(picture, VECTOR, marking_points(FIELD), FRAME)
    said = displaced_elements_in_image(picture, VECTOR, marking_points(moved), FRAME)
    assert said.startswith("Right penalty front is ")
    assert said.endswith(" px off its line")


def test_a_line_that_is_not_painted_lies_beside_nothing():
    """Somebody forgot it, or it is worn: that is no other place."""
    assert not displaced_elements_in_image(
        draw(TRUE, lines=False), VECTOR, marking_points(FIELD), FRAME
    )


@pytest.mark.parametrize("behind", ["grass", "board"])
def test_the_edge_of_a_board_is_no_paint_of_a_worn_touchline(behind):
    """A white stripe with grass on both sides is paint that lies elsewhere."""
    picture, painted = draw(TRUE), marking_points(FIELD)
    line, stripe, top = (
        TRUE.project(np.column_stack([x, np.full(60, -34.0 - away), np.zeros(60)]))[0]
        for x, away in ((np.linspace(-20, 50, 60), out) for out in (0.0, 1.5, 8.0))
    )

    def fill(points: np.ndarray, colour: tuple[int, ...], width: int) -> None:
        places = [(16 * points).round().astype(np.int32)]
        if width:
            cv2.polylines(picture, places, False, colour, width, cv2.LINE_AA, shift=4)
        else:
            cv2.fillPoly(picture, places, colour, cv2.LINE_AA, shift=4)

    fill(line, (40, 110, 50, 255), 5)
    if behind == "board":
        fill(np.concatenate([stripe, top[::-1]]), (200, 60, 20, 255), 0)
    fill(stripe, (225, 235, 230, 255), 2)
    seen = measure_lines(picture, VECTOR, painted, FRAME, 5.0)
    weights = geman_mcclure_weights(edge_point_residuals(VECTOR, seen.marks, FRAME))
    around = search_nearby(picture, VECTOR, painted, FRAME, seen, weights, on_ground=True)
    found = displaced_elements(
        VECTOR, seen.marks.chosen(np.zeros(0, int)), np.zeros(0), around, FRAME
    )
    named = {painted.names[number] for number in found}
    assert named == ({"Side line top"} if behind == "grass" else set())


def test_a_narrow_line_between_two_colours_is_found_in_its_middle():
    """Its brightest place lies towards the lighter of the two."""
    stage, size = stage_of("basketball_fiba"), (960, 540)
    shown = looking_at((0, 21.5, -6.5), (-6, 0, 0), 640, size, kappa=0.03)
    painted, frame = marking_points(stage.field), ImageFrame(size)
    seen = measure_lines(
        draw_scene(stage, shown, size), vector_from_camera(shown, frame), painted, frame, 5
    )
    own = painted.element[seen.expected.rows] == painted.names.index("Court edge bottom")
    off = seen.offsets.px[own & seen.offsets.found]
    assert len(off) > 50
    assert np.median(seen.expected.width_px[own]) < 1
    assert abs(np.median(off)) < 0.25


def test_an_edge_between_two_areas_is_found_where_no_line_is_painted():
    stage, size = stage_of("basketball_fiba"), (960, 540)
    shown = looking_at((0, 21.5, -6.5), (-6, 0, 0), 640, size)
    painted, frame = marking_points(stage.field), ImageFrame(size)
    vector = vector_from_camera(shown, frame)
    corners = np.array(
        [(x, y, 0.0) for x, y in ((-14, -2.45), (-8.2, -2.45), (-8.2, 2.45), (-14, 2.45))]
    )
    picture = np.full((*size[::-1], 4), (120, 180, 210, 255), dtype=np.uint8)
    cv2.fillPoly(picture, [np.rint(shown.project(corners)[0]).astype(np.int32)], (150, 80, 20, 255))
    seen = measure_lines(picture, vector, painted, frame, 4)
    _, shares = found_shares(seen, np.ones(len(seen.marks)), painted)
    for side in ("top", "front", "bottom"):
        assert shares[f"Key area left {side}"] > 0.8
    assert shares["Court edge top"] == 0


def test_what_hides_lines_and_optional_lines_are_not_missing():
    """The nearer half of the goal area is behind a crowd; nobody painted the optional lines."""
    picture, painted = draw(TRUE), marking_points(FIELD)
    whole = measure_lines(picture, VECTOR, painted, FRAME, 4.0)
    rng = np.random.default_rng(3)
    behind = whole.expected.px[1] > np.percentile(whole.expected.px[1], 60)
    top = int(whole.expected.px[1][behind].min() / FRAME.scale + SIZE[1] / 2)
    crowd = rng.integers(0, 255, (-(-(SIZE[1] - top) // 6), -(-SIZE[0] // 6), 3), dtype=np.uint8)
    crowd = np.kron(crowd, np.ones((6, 6, 1), dtype=np.uint8))
    picture[top:, :, :3] = crowd[: SIZE[1] - top, : SIZE[0]]
    seen = measure_lines(picture, VECTOR, painted, FRAME, 4.0)
    share, _ = found_shares(seen, np.ones(len(seen.marks)), painted)
    assert share > 0.85
    blank = measure_lines(np.full_like(picture, 90), VECTOR, painted, FRAME, 4.0)
    assert found_shares(blank, np.ones(len(blank.marks)), painted)[0] == 0
    optional = marking_points(
        replace(FIELD, elements=tuple(replace(e, optional=True) for e in FIELD.elements))
    )
    assert not optional.required.any()


# Places put where they belong turn and zoom a camera, which stays where it stands.

PLAIN = PinholeCamera(0.1, 1.3, 0.01, (2.0, 60.0, -16.0), (1500.0, 1500.0), (639.5, 359.5))
BENT = replace(
    PLAIN,
    radial=(0.3, 0.2, 0.05, 0.1, 0.02, 0.01),
    tangential=(0.003, -0.002),
    thin_prism=(0.001, 0.0, 0.002, 0.0),
    focal_px=(1500.0, 1480.0),
)
CORNERS = ((0.0, 0.0, 0.0), (0.0, -34.0, 0.0), (9.15, 0.0, 0.0), (0.0, 9.15, 0.0))


def shown(of: PinholeCamera, world: tuple[float, float, float]) -> tuple[float, float]:
    x, y = of.project(np.array([world]))[0][0].tolist()
    return x, y


def put(of: PinholeCamera, row: int, by: tuple[float, float], **more: object) -> ControlPoint:
    x, y = shown(of, CORNERS[row])
    return ControlPoint(CORNERS[row], (x + by[0], y + by[1]), **more)


@pytest.mark.parametrize("start", [PLAIN, BENT], ids=["plain", "bent"])
@pytest.mark.parametrize("by", [(3.0, -2.0), (40.0, 25.0), (-300.0, 180.0)])
def test_one_place_turns_the_camera(start, by):
    hand = put(start, 1, by)
    found = fit_control_points(start, (), hand)
    assert control_point_errors(found, [hand])[0] < 0.01
    assert found.position_world == start.position_world
    assert found.roll_rad == start.roll_rad
    assert found.focal_px == pytest.approx(start.focal_px)


@pytest.mark.parametrize("start", [PLAIN, BENT], ids=["plain", "bent"])
@pytest.mark.parametrize("by", [(3.0, -2.0), (30.0, 25.0), (-80.0, 40.0)])
def test_two_places_zoom_and_roll_it_and_the_first_one_stays(start, by):
    first = put(start, 0, (12.0, -7.0))
    hand = put(start, 1, by)
    found = fit_control_points(fit_control_points(start, (), first), (first,), hand)
    assert control_point_errors(found, [hand])[0] < 0.01
    assert control_point_errors(found, [first])[0] < 0.1
    assert found.position_world == start.position_world


def test_of_more_places_the_one_in_hand_is_met_and_the_others_share_what_is_left():
    turned_away = rotated_camera(PLAIN, np.array([0.01, -0.004, 0.05, 0.002]))
    rng = np.random.default_rng(3)
    pegs = [ControlPoint(world, shown(turned_away, world)) for world in CORNERS]
    noisy = [replace_px(peg, rng.normal(0, 0.5, 2)) for peg in pegs[:3]]
    found = fit_control_points(PLAIN, noisy, pegs[3])
    assert control_point_errors(found, [pegs[3]])[0] < 0.01
    assert control_point_errors(found, noisy).max() < 2.0
    assert found.focal_px == pytest.approx(turned_away.focal_px, rel=0.01)


def replace_px(peg: ControlPoint, off: np.ndarray) -> ControlPoint:
    return ControlPoint(peg.world, (peg.px[0] + off[0], peg.px[1] + off[1]), peg.along, peg.sd_px)


def test_a_place_on_a_line_stays_on_its_line_only():
    on_line = put(PLAIN, 0, (5.0, 8.0), along=(1.0, 0.0, 0.0))
    hand = put(PLAIN, 1, (40.0, 3.0))
    start = fit_control_points(PLAIN, (), on_line)
    found = fit_control_points(start, (on_line,), hand)
    assert control_point_errors(found, [on_line, hand]).max() < 0.1
    x, _ = shown(found, on_line.world)
    assert abs(x - on_line.px[0]) > 1.0  # along the line it went where it had to


def test_what_no_camera_there_can_show_leaves_the_camera_alone():
    behind = ControlPoint((2.0, 200.0, 0.0), (600.0, 300.0))
    assert fit_control_points(PLAIN, (), behind) is PLAIN
    assert fit_control_points(PLAIN, ()) is PLAIN
    assert control_point_errors(PLAIN, [behind])[0] == np.inf


def test_a_camera_that_looks_straight_down_turns_too():
    down = replace(PLAIN, pan_rad=0.0, tilt_rad=0.0, roll_rad=0.0, position_world=(0.0, 0.0, -50.0))
    hand = ControlPoint((5.0, 4.0, 0.0), tuple(np.add(shown(down, (5.0, 4.0, 0.0)), (6.0, -4.0))))
    assert control_point_errors(fit_control_points(down, (), hand), [hand])[0] < 0.01


def test_zoom_leaves_the_bend_of_the_lens_in_the_picture():
    twice = rotated_camera(BENT, np.array([0.0, 0.0, np.log(2.0), 0.0]))
    rays = np.array([[0.2, 0.1, 1.0], [-0.15, 0.18, 1.0]])
    stand, turn = np.array(BENT.position_world), BENT.rotation_cam_from_world
    before, _ = BENT.project(stand + rays @ turn)
    after, _ = twice.project(stand + rays * (0.5, 0.5, 1.0) @ turn)
    assert after == pytest.approx(before)


PLACES = ((36.0, 20.16, 0.0), (36.0, -20.16, 0.0), (52.5, 9.16, 0.0))


def test_one_dragged_place_and_the_paint_give_the_camera():
    picture = draw(TRUE, noise=4.0)
    place = next(p for p in PLACES if _in_sight(p))
    wrong = rotated_camera(TRUE, np.array([0.02, 0.008, 0.08, 0.0]))
    assert apart_px(TRUE, wrong) > 15
    hand = ControlPoint(place, shown(TRUE, place), None, 1.0)
    found, why_not = align_with_control_points(
        picture, FIELD, fit_control_points(wrong, (), hand), [hand]
    )
    assert why_not == ""
    assert apart_px(TRUE, found.fit.camera) < 1.0
    assert control_point_errors(found.fit.camera, [hand])[0] < 2.0


def _in_sight(place: tuple[float, float, float]) -> bool:
    (x, y), seen = shown(TRUE, place), TRUE.project(np.array([place]))[1][0]
    return bool(seen) and 0 < x < 959 and 0 < y < 539


def test_paint_that_would_take_a_peg_away_has_no_say():
    place = next(p for p in PLACES if _in_sight(p))
    x, y = shown(TRUE, place)
    hand = ControlPoint(place, (x + 8.0, y), None, 0.3)
    found, why_not = align_with_control_points(
        draw(TRUE), FIELD, fit_control_points(TRUE, (), hand), [hand]
    )
    assert found is None
    assert why_not


def test_without_paint_it_is_said_why():
    place = next(p for p in PLACES if _in_sight(p))
    hand = ControlPoint(place, shown(TRUE, place))
    found, why_not = align_with_control_points(draw(TRUE, lines=False), FIELD, TRUE, [hand])
    assert found is None
    assert why_not
