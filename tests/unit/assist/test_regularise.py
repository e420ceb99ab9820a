"""Two clicks make a straight element, five a curve; hidden stretches get no points."""

from functools import partial

import cv2
import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px, points_px
from procc_annotator.assist.regularise import MOST_MOVED_PX, close_gaps, regularise
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.field.load import load_field
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.line_snapping import snap_points_to_lines
from procc_annotator.image.pixels import PixelArray

FIELD = load_field()
SIZE = (960, 540)
GRASS, PAINT = (50, 120, 55), (235, 240, 238)


def pitch(*curves: np.ndarray, width: int = 4) -> PixelArray:
    picture = np.full((SIZE[1], SIZE[0], 3), GRASS, dtype=np.uint8)
    for curve in curves:
        fixed = np.round((curve + 0.0) * 16).astype(np.int32)
        cv2.polylines(picture, [fixed], False, PAINT, width, cv2.LINE_AA, 4)
    blurred = cv2.GaussianBlur(picture, (0, 0), 0.7)
    return cv2.cvtColor(blurred, cv2.COLOR_BGR2BGRA)


def polyline(name: str, points: np.ndarray) -> Polyline:
    return Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in points.tolist()))


def away(found: np.ndarray, curve: np.ndarray) -> np.ndarray:
    """(n,) px from each point to a densely sampled curve."""
    return np.array([np.hypot(*(curve - point).T).min() for point in found])


BENT = np.column_stack(
    [np.linspace(60, 900, 4000), 300 + 9 * ((np.linspace(-1, 1, 4000)) ** 2 - 1)]
)  # a line as a lens bends it: 9 px off its chord
ANGLES = np.linspace(0, 2 * np.pi, 8000)
CIRCLE = np.column_stack([480 + 260 * np.cos(ANGLES), 280 + 90 * np.sin(ANGLES)])


def regularised(drawn, picture, *, curved=False, size=SIZE):
    """As the window does it: points snap to the lines of the picture."""
    snap = partial(snap_points_to_lines, picture)
    return regularise(drawn, curved=curved, size=size, snap=snap)


def test_two_clicks_follow_a_bent_line():
    clicked = BENT[[0, -1]] + [[0, 2.0], [0, -1.5]]
    found = regularised(polyline("Middle line", clicked), pitch(BENT)).polyline
    points = points_px(found, SIZE)
    assert len(points) > 8
    assert np.median(away(points, BENT)) < 0.3
    assert away(points, BENT)[1:-1].max() < 0.8
    assert points[[0, -1], 0] == pytest.approx(clicked[:, 0], abs=0.5)  # the ends stay the ends
    assert (np.diff(points[:, 0]) > 0).all()


def test_the_direction_of_the_clicks_is_kept():
    backwards = polyline("Middle line", BENT[[-1, 0]])
    found = regularised(backwards, pitch(BENT)).polyline
    assert (np.diff(points_px(found, SIZE)[:, 0]) < 0).all()


@pytest.mark.parametrize("shuffled", [False, True])
def test_five_clicks_make_an_arc(shuffled):
    arc = CIRCLE[500:4800]
    clicked = arc[[0, 1000, 2100, 3300, -1]] + np.random.default_rng(3).normal(0, 1.5, (5, 2))
    if shuffled:
        clicked = clicked[[3, 0, 4, 1, 2]]
    found = regularised(polyline("Circle central", clicked), pitch(arc), curved=True)
    # A click farther off than the program may move it is the hand's own, and stays.
    own = points_px(Polyline("Circle central", found.unconfirmed), SIZE)
    assert away(own, CIRCLE).min(initial=np.inf) > MOST_MOVED_PX
    made = tuple(p for p in found.polyline.points if p not in found.unconfirmed)
    points = points_px(Polyline("Circle central", made), SIZE)
    assert len(points) > 12
    assert np.median(away(points[1:-1], CIRCLE)) < 0.3
    assert away(points[1:-1], CIRCLE).max() < 1.0


def test_points_are_denser_where_it_bends():
    clicked = CIRCLE[[0, 900, 2000, 3100, 4000]]
    found = regularise(
        polyline("Circle central", clicked), curved=True, size=SIZE, snap=None
    ).polyline
    points = points_px(found, SIZE)
    steps = np.hypot(*np.diff(points, axis=0).T)
    tight = np.abs(points[:-1, 0] - 480) > 220  # the ends of the long axis
    assert steps[tight].mean() < 0.75 * steps[~tight].mean()


def test_a_whole_circle_closes():
    clicked = CIRCLE[[0, 1300, 2700, 4000, 5300, 6600, 7980]]
    found = regularised(polyline("Circle central", clicked), pitch(CIRCLE), curved=True).polyline
    points = points_px(found, SIZE)
    assert np.hypot(*(points[0] - points[-1])) < 2.0
    turns = np.unwrap(np.arctan2(points[:, 1] - 280, points[:, 0] - 480))
    assert abs(turns[-1] - turns[0]) == pytest.approx(2 * np.pi, abs=0.1)


def test_hidden_stretches_get_no_points():
    picture = pitch(BENT).copy()
    picture[200:400, 400:560] = (*GRASS, 255)
    found = regularised(polyline("Middle line", BENT[[0, -1]]), picture).polyline
    points = points_px(found, SIZE)
    assert not ((points[:, 0] > 404) & (points[:, 0] < 556)).any()
    assert (points[:, 0] < 400).sum() > 3
    assert (points[:, 0] > 560).sum() > 3


def test_a_neighbouring_line_does_not_catch_points():
    crossing = np.column_stack([np.linspace(300, 700, 2000), np.linspace(270, 320, 2000)])
    found = regularised(polyline("Middle line", BENT[[0, -1]]), pitch(BENT, crossing)).polyline
    assert away(points_px(found, SIZE), BENT).max() < 1.5


def test_without_a_line_the_clicks_stay():
    plain = polyline("Middle line", BENT[[0, -1]])
    grass = partial(snap_points_to_lines, pitch())
    assert regularise(plain, curved=False, size=SIZE, snap=grass).polyline == plain
    single = polyline("Middle line", BENT[:1])
    assert regularise(single, curved=False, size=SIZE, snap=grass).polyline == single


def test_what_a_file_says_about_the_ends_is_kept():
    first = Point(BENT[0, 0] / 959, BENT[0, 1] / 539, (("sure", True),))
    last = Point(BENT[-1, 0] / 959, BENT[-1, 1] / 539)
    found = regularised(Polyline("Middle line", (first, last)), pitch(BENT)).polyline
    assert found.points[0].extra == first.extra


def test_on_drawn_frames_it_lies_on_the_exact_geometry(sample_data):
    cameras = CameraSet.open(sample_data / "cameras" / "true", camera_size=(960, 540))
    samples = sample_evenly(FIELD, 0.01)
    rng = np.random.default_rng(4)
    errors: dict[bool, list[float]] = {True: [], False: []}
    for name in sorted(cameras.frames)[::4]:
        picture = decode_bgra(sample_data / f"{name}.jpg")
        size = picture.shape[1], picture.shape[0]
        loaded = cameras.camera(name, size)
        for i, element in enumerate(FIELD.elements):
            places, seen = loaded.camera.project(samples.of(i))
            inside = seen & (places > 1).all(axis=1) & (places < np.array(size) - 2).all(axis=1)
            runs = np.split(rows := np.flatnonzero(inside), np.flatnonzero(np.diff(rows) > 1) + 1)
            run = places[max(runs, key=len)]
            if len(run) < 10 or np.hypot(*np.diff(run, axis=0).T).sum() < 60:
                continue
            chosen = np.linspace(0, len(run) - 1, 2 if element.is_straight else 5)
            clicked = run[chosen.round().astype(int)] + rng.normal(0, 2, (len(chosen), 2))
            clicked = np.clip(clicked, 0, np.array(size) - 1)
            drawn = Polyline(
                element.name, tuple(point_from_px(x, y, size) for x, y in clicked.tolist())
            )
            found = regularised(drawn, picture, curved=not element.is_straight, size=size)
            assert set(found.unconfirmed) <= set(drawn.points)
            if found.polyline != drawn:
                # A click far off the paint is the hand's own, and stays: the others are judged.
                made = tuple(p for p in found.polyline.points[1:-1] if p not in found.unconfirmed)
                inner = points_px(Polyline(drawn.class_name, made), size)
                errors[element.is_straight] += away(inner, places[seen]).tolist()
    for found_errors in errors.values():
        assert len(found_errors) > 20
        assert np.median(found_errors) <= 0.3
        assert np.quantile(found_errors, 0.98) <= 1.5


def test_no_click_is_lost_where_the_bend_is_hidden():
    """Behind a crowd there is no paint: the clicks that a hand made there are all that is known."""
    arc = CIRCLE[500:4800]
    picture = pitch(arc).copy()
    picture[:, :330] = (*GRASS, 255)
    clicked = arc[[0, 900, 1800, 2500, 3000, 3500, -1]]
    drawn = polyline("Circle central", clicked)
    found = regularised(drawn, picture, curved=True)
    hidden = {p for p, x in zip(drawn.points, clicked[:, 0], strict=True) if x < 320}
    assert len(hidden) >= 3
    assert hidden <= set(found.unconfirmed) <= set(found.polyline.points)
    assert len(found.polyline.points) > len(clicked)
    again = regularised(found.polyline, picture, curved=True)
    assert again.polyline == found.polyline
    assert set(again.unconfirmed) == set(found.unconfirmed)


def test_a_line_beside_the_clicks_does_not_draw_them_to_itself():
    beside = polyline("Middle line", BENT[[0, 1000, 2000, 3000, -1]] + [0, 4.0])
    found = regularised(beside, pitch(BENT))
    assert found.polyline == beside
    assert found.unconfirmed == beside.points


def covered(curve: np.ndarray, *places: int) -> PixelArray:
    """A pitch with the curve, and with boxes on it at the rows given."""
    picture = pitch(curve).copy()
    for x, y in curve[list(places)].astype(int):
        picture[y - 14 : y + 14, x - 14 : x + 14] = (*GRASS, 255)
    return picture


@pytest.mark.parametrize(
    "drawing", [*range(6), *(pytest.param(n, marks=pytest.mark.soak) for n in range(6, 24))]
)
def test_what_was_regularised_stays(drawing):
    """A circle clicked all round but for one gap, with players on it: time and again the same."""
    rng = np.random.default_rng(drawing)
    rows = np.sort(rng.integers(0, len(CIRCLE), 8))
    clicked = CIRCLE[rows] + rng.normal(0, 1.0, (8, 2))
    snap = partial(snap_points_to_lines, covered(CIRCLE, *rng.integers(0, len(CIRCLE), 3)))
    drawn = polyline("Circle central", clicked)
    once = regularise(drawn, curved=True, size=SIZE, snap=snap).polyline
    assert regularise(once, curved=True, size=SIZE, snap=snap).polyline == once
    own = points_px(once, SIZE)
    steps = np.linspace(0, 1, 50)[:, None, None]
    chords = ((1 - steps) * own[:-1] + steps * own[1:]).reshape(-1, 2)
    assert away(clicked, chords).max() <= MOST_MOVED_PX + 0.1


def test_what_was_thinned_out_is_regularised_again():
    snap = partial(snap_points_to_lines, pitch(BENT))
    drawn = polyline("Middle line", BENT[[0, -1]])
    once = regularise(drawn, curved=False, size=SIZE, snap=snap).polyline
    thin = Polyline("Middle line", (once.points[0], once.points[5], once.points[-1]))
    again = regularise(thin, curved=False, size=SIZE, snap=snap).polyline
    assert len(again.points) >= len(once.points) - 1
    assert np.median(away(points_px(again, SIZE), BENT)) < 0.3


@pytest.mark.parametrize("way", [(0, 2, 0), (0, 1, 2, 1, 0)])
@pytest.mark.parametrize("snap", [None, lambda points, _: points])
def test_clicks_that_come_back_the_way_they_went_stay(way, snap):
    clicks = polyline("Middle line", np.array([[100, 100], [200, 130], [300, 160]])[[*way]])
    assert regularise(clicks, curved=False, size=SIZE, snap=snap).polyline == clicks


def test_an_arc_with_two_clicks_in_nearly_one_place():
    clicks = np.array([[100.0, 100.0], [200.0, 130.0], [200.0, 130.0 + 1e-8], [300.0, 180.0]])
    arc = polyline("Circle left", clicks)
    found = points_px(regularise(arc, curved=True, size=SIZE, snap=None).polyline, SIZE)
    assert away(clicks, found).max() < 40
    np.testing.assert_allclose(found[[0, -1]], clicks[[0, -1]], atol=1e-6)


# Ends that fall a little short reach the corner, the picture's edge, the circle's beginning.

PICTURE_SIZE = (1280, 720)
MAIN, TOP = "Big rect. left main", "Big rect. left top"


def line(name: str, *points: tuple[float, float]) -> Polyline:
    return Polyline(name, tuple(point_from_px(x, y, PICTURE_SIZE) for x, y in points))


def closed(polyline: Polyline, *others: Polyline) -> np.ndarray:
    annotation = FrameAnnotation((polyline, *others))
    return points_px(close_gaps(polyline, annotation, FIELD, PICTURE_SIZE), PICTURE_SIZE)


def test_an_end_reaches_the_corner_with_the_line_it_meets():
    found = closed(line(TOP, (300, 200), (590, 200)), line(MAIN, (600, 212), (600, 500)))
    assert found == pytest.approx(np.array([[300, 200], [600, 200]]), abs=1e-6)


def test_an_end_that_went_too_far_comes_back():
    found = closed(line(TOP, (300, 200), (612, 200)), line(MAIN, (600, 190), (600, 500)))
    assert found[-1] == pytest.approx([600, 200], abs=1e-6)


def test_lines_that_do_not_meet_on_the_field_leave_each_other_alone():
    polyline = line(TOP, (300, 200), (590, 200))
    other = line("Side line top", (600, 190), (600, 500))
    assert closed(polyline, other) == pytest.approx(points_px(polyline, PICTURE_SIZE))


def test_an_end_near_the_edge_reaches_it_along_its_line():
    found = closed(line("Side line top", (10, 100), (640, 90), (1270, 80)))
    assert found[0] == pytest.approx([0, 100 + 10 * 10 / 630], abs=1e-6)
    assert found[1] == pytest.approx([640, 90])
    assert found[-1] == pytest.approx([1279, 80 - 9 * 10 / 630], abs=1e-6)


def test_what_is_far_stays():
    polyline = line("Side line top", (60, 100), (1200, 80))
    assert closed(polyline) == pytest.approx(points_px(polyline, PICTURE_SIZE))


def test_a_circle_closes_with_its_first_point():
    angles = np.linspace(0, 2 * np.pi - 0.1, 9)
    points = [(640 + 200 * np.cos(a), 360 + 80 * np.sin(a)) for a in angles]
    polyline = line("Circle central", *points)
    found = close_gaps(polyline, FrameAnnotation((polyline,)), FIELD, PICTURE_SIZE)
    assert found.points == (*polyline.points, polyline.points[0])
    half = line("Circle central", *points[:5])
    assert close_gaps(half, FrameAnnotation((half,)), FIELD, PICTURE_SIZE) == half


def test_other_elements_and_single_points_come_back_as_they_are():
    for polyline in (line("Line unknown", (2, 2), (9, 9)), line(TOP, (5, 5))):
        assert close_gaps(polyline, FrameAnnotation((polyline,)), FIELD, PICTURE_SIZE) == polyline
