"""A ghost becomes points on its painted line, and none where no paint is to be seen."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px, points_px
from procc_annotator.assist.ghost_points import (
    LEAST_SUPPORT,
    GhostPoints,
    accept,
    accept_all,
    find_points,
    retry,
)
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.prediction.ghosts import Ghost, GhostPiece, find_ghosts
from procc_annotator.calibration.prediction.visible_elements import visible_stretches
from procc_annotator.camera.base import Camera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.line_snapping import snap_to_line
from procc_annotator.image.pixels import PixelArray
from tests.drawn_shots import scenery, soccer, solids

FIELD = load_field()
SIZE = (1280, 720)
LIMITS = np.array(SIZE) - 1.0


def away(points: np.ndarray, courses: list[np.ndarray]) -> np.ndarray:
    """(n,) px from each point to the nearest of some dense courses."""
    dense = np.concatenate([_dense(course) for course in courses])
    return np.array([np.hypot(*(dense - point).T).min() for point in points])


def _dense(course: np.ndarray) -> np.ndarray:
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(course, axis=0).T))])
    at = np.linspace(0.0, lengths[-1], 2 + int(lengths[-1] * 5))
    return np.column_stack([np.interp(at, lengths, course[:, k]) for k in (0, 1)])


def exact_courses(camera: Camera, size: tuple[int, int] = SIZE) -> dict[str, list[np.ndarray]]:
    found: dict[str, list[np.ndarray]] = {}
    for stretch in visible_stretches(FIELD, camera, size):
        found.setdefault(stretch.name, []).append(stretch.points_px)
    return found


def placed(found: GhostPoints, size: tuple[int, int] = SIZE) -> np.ndarray:
    return points_px(Polyline(found.name, found.points), size)


def ghost_along(name: str, course: np.ndarray, sd_px: float = 1.5) -> Ghost:
    return Ghost(name, (GhostPiece(course, np.full(len(course), sd_px)),))


def straight(first: tuple[float, float], last: tuple[float, float]) -> np.ndarray:
    return np.linspace(first, last, 200)


def moved(course: np.ndarray, x: float, y: float) -> np.ndarray:
    return course + np.array([x, y])


class Drawn:
    """The sample's frames with their true cameras."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.cameras = CameraSet.open(folder / "cameras" / "true", camera_size=(960, 540))

    def picture(self, name: str) -> PixelArray:
        return decode_bgra(self.folder / f"{name}.jpg")

    def annotation(self, name: str) -> FrameAnnotation:
        path = self.folder / f"{name}.json"
        return read_annotation(path.read_bytes(), path=str(path), field=FIELD)

    def exact(self, name: str) -> dict[str, list[np.ndarray]]:
        loaded = self.cameras.camera(name, SIZE)
        return exact_courses(loaded.camera)


@pytest.fixture(scope="module")
def drawn(sample_data) -> Drawn:
    return Drawn(sample_data)


def some(annotation: FrameAnnotation, names: set[str]) -> FrameAnnotation:
    return FrameAnnotation(tuple(p for p in annotation if p.class_name in names))


def all_accepted(
    annotation: FrameAnnotation, picture: PixelArray, not_visible: frozenset[str] = frozenset()
) -> tuple[FrameAnnotation, tuple[str, ...], tuple[str, ...]]:
    """An annotation with its ghosts accepted; the names of those that were, and were not."""
    fit = fit_camera(annotation, FIELD, size=SIZE)
    ghosts = find_ghosts(annotation, FIELD, fit, without=not_visible)
    done = accept_all(annotation, [find_points(g, picture, FIELD, SIZE) for g in ghosts])
    return done.annotation, *(tuple(f.name for f in some) for some in (done.accepted, done.left))


def test_all_ghosts_after_four_elements_lie_on_their_lines(drawn):
    rng = np.random.default_rng(6)
    medians, distances = [], []
    for name in ("00002", "00006", "00009", "00011", "00012"):
        picture, annotation, exact = drawn.picture(name), drawn.annotation(name), drawn.exact(name)
        four = set(rng.choice(list(annotation.annotated), 4, replace=False).tolist())
        before = some(annotation, four)
        after, accepted, left = all_accepted(before, picture)
        assert not set(accepted) & set(left)
        assert set(after.annotated) == four | set(accepted)
        assert all(after.get(n) == before.get(n) for n in four)
        for new in accepted:
            polyline = after.get(new)
            assert polyline is not None
            distances.extend(apart := away(points_px(polyline, SIZE), exact[new]))
            medians.append(np.median(apart))
    assert len(medians) >= 12
    assert np.median(medians) < 0.3
    assert np.mean(np.array(medians) <= 1.0) >= 0.9
    assert max(distances) < 5.0  # along the line, where it meets another


def test_the_points_are_regular_in_order_and_reach_the_edge(drawn):
    (course,) = drawn.exact("00003")["Side line top"]
    found = find_points(
        ghost_along("Side line top", moved(course, 0.0, 1.2)), drawn.picture("00003"), FIELD, SIZE
    )
    points = placed(found)
    assert found.support > 0.7
    assert away(points, [course]).max() < 0.8
    edge = np.minimum(points, LIMITS - points).min(axis=1)
    assert min(edge[0], edge[-1]) == pytest.approx(0.0, abs=1e-6)
    along = (points - course[0]) @ (course[-1] - course[0])
    assert (np.diff(along) > 0).all()
    steps = np.hypot(*np.diff(points, axis=0).T)
    assert steps.max() < 3 * np.median(steps)
    assert all(0 <= p.u <= 1 and 0 <= p.v <= 1 for p in found.points)


def test_a_circle_gets_points_all_round(drawn):
    courses = drawn.exact("00001")["Circle central"]
    pieces = tuple(GhostPiece(moved(c, 0.8, -0.8), np.full(len(c), 1.5)) for c in courses)
    found = find_points(Ghost("Circle central", pieces), drawn.picture("00001"), FIELD, SIZE)
    points = placed(found)
    assert found.support > 0.6
    assert len(points) > 12
    assert np.median(away(points, courses)) < 0.3
    assert away(points, courses).max() < 1.0


CLUTTER = np.random.default_rng(8).integers(40, 230, (240, 240, 3)).astype(np.uint8)


def crowd(width: int, height: int) -> np.ndarray:
    """People of all colours, a few pixels each."""
    people = CLUTTER[: height // 5 + 1, : width // 4 + 1]
    return cv2.resize(people, (width, height), interpolation=cv2.INTER_LINEAR)


def pitch(*lines: tuple[tuple[int, int], tuple[int, int]], width: int = 4) -> np.ndarray:
    picture = np.full((SIZE[1], SIZE[0], 3), (52, 128, 78), dtype=np.uint8)
    for first, last in lines:
        cv2.line(picture, first, last, (226, 232, 230), width, cv2.LINE_AA)
    noise = np.random.default_rng(1).normal(0, 3, picture.shape)
    blurred = cv2.GaussianBlur(picture, (0, 0), 0.8).astype(float)
    return np.clip(blurred + noise, 0, 255).astype(np.uint8)


def shown(pixels: np.ndarray) -> PixelArray:
    return cv2.cvtColor(pixels, cv2.COLOR_BGR2BGRA)


COURSE = straight((100.0, 302.0), (1179.0, 402.0))  # the line's own course is 2 px above
LINE = ((100, 300), (1179, 400))


@pytest.mark.parametrize("offset", [-3.0, 0.0, 3.0])
def test_a_line_beside_the_prediction_is_found(offset):
    ghost = ghost_along("Side line top", moved(COURSE, 0.0, offset - 2.0), 2.0)
    found = find_points(ghost, shown(pitch(LINE)), FIELD, SIZE)
    assert found.support > 0.95
    assert away(placed(found), [straight(*LINE)]).max() < 0.4


def test_no_points_where_the_crowd_hides_the_line():
    pixels = pitch(LINE)
    pixels[250:450, 500:760] = crowd(260, 200)
    found = find_points(ghost_along("Side line top", COURSE), shown(pixels), FIELD, SIZE)
    x = placed(found)[:, 0]
    assert not ((x > 500) & (x < 760)).any()
    assert (x < 500).sum() >= 4
    assert (x > 760).sum() >= 4
    assert found.support == pytest.approx(1 - 260 / 1080, abs=0.05)


def test_points_end_where_the_line_is_cut_off():
    pixels = pitch(LINE)
    pixels[:, 800:] = crowd(480, 720)
    found = find_points(ghost_along("Side line top", COURSE), shown(pixels), FIELD, SIZE)
    points = placed(found)
    assert points[-1, 0] == pytest.approx(798, abs=8)
    assert points[0] == pytest.approx([100, 300], abs=4)
    assert away(points, [straight(*LINE)]).max() < 0.6


def test_players_on_the_line_get_no_points():
    pixels = pitch(LINE)
    people = [(300, (40, 40, 190)), (620, (235, 235, 235)), (900, (120, 50, 30))]
    for x, shirt in people:
        y = round(300 + (x - 100) * 100 / 1079)
        cv2.rectangle(pixels, (x - 16, y - 60), (x + 16, y - 4), shirt, -1)
        cv2.rectangle(pixels, (x - 16, y - 4), (x + 16, y + 8), (240, 240, 240), -1)
        for leg in (-12, 6):
            cv2.rectangle(pixels, (x + leg, y + 8), (x + leg + 7, y + 40), (235, 235, 235), -1)
    found = find_points(ghost_along("Side line top", COURSE), shown(pixels), FIELD, SIZE)
    points = placed(found)
    for x, _ in people:
        assert not (np.abs(points[:, 0] - x) < 15).any()
    assert away(points, [straight(*LINE)]).max() < 0.6
    assert 0.8 < found.support < 0.97


@pytest.mark.parametrize("blur_px", [1, 18])
def test_a_line_that_motion_makes_wide_is_found(blur_px):
    """By acceptance and by snapping, in a picture of 1920 px."""
    size, line = (1920, 1080), ((800.0, 100.0), (860.0, 1000.0))
    pixels = np.full((1080, 1920, 3), (52, 128, 78), dtype=np.uint8)
    cv2.line(pixels, (800, 100), (860, 1000), (226, 232, 230), 5, cv2.LINE_AA)
    picture = shown(cv2.blur(pixels, (blur_px, 1)))
    course = moved(straight(*line), 4.0, 0.0)
    found = find_points(ghost_along("Middle line", course), picture, FIELD, size)
    assert found.support > 0.9
    assert away(placed(found, size), [straight(*line)]).max() < 1.0
    sought = ExpectedLines(FIELD, size[0]).of("Middle line")
    for beside in (-5.0, 5.0):
        place = snap_to_line(picture, (830.0 + beside, 550.0), sought, direction=(1.0, 15.0))
        assert away(np.array([place]), [straight(*line)]).max() < 1.0


@pytest.mark.parametrize("half_px", [15, 60])
def test_no_chord_cuts_the_bend_of_a_curve_behind_a_player(half_px):
    turn = np.linspace(0.0, 2.0 * np.pi, 900)
    course = np.column_stack([640.0 + 400.0 * np.cos(turn), 360.0 + 60.0 * np.sin(turn)])
    pixels = pitch()
    cv2.polylines(pixels, [course.round().astype(np.int32)], True, (226, 232, 230), 4, cv2.LINE_AA)
    pixels[360 - half_px : 360 + half_px, 220:300] = (40, 40, 190)
    found = placed(find_points(ghost_along("Circle central", course), shown(pixels), FIELD, SIZE))
    assert away(_dense(found), [course]).max() < 3.0
    assert len(found) > 15


@pytest.mark.parametrize("name", ["Side line top", "Goal left crossbar", "Circle left"])
def test_a_ghost_in_the_crowd_or_on_bare_grass_finds_no_line(name):
    pixels = pitch()
    pixels[:360] = crowd(1280, 360)
    rng = np.random.default_rng(3)
    for _ in range(12):
        middle = rng.uniform((300, 100), (980, 260))
        half = rng.uniform(60, 250) * np.array([1.0, rng.normal(0, 0.15)])
        for lower in (0.0, 360.0):
            course = moved(straight(tuple(middle - half), tuple(middle + half)), 0.0, lower)
            found = find_points(ghost_along(name, course, 2.0), shown(pixels), FIELD, SIZE)
            assert found.support < LEAST_SUPPORT
            assert len(found.points) <= 3


def test_a_neighbouring_line_is_not_followed():
    """The line itself shows only half way; the other one converges to it."""
    pixels = pitch(((100, 300), (640, 300)), ((640, 303), (1100, 330)))
    ghost = ghost_along("Side line top", straight((100.0, 300.5), (1100.0, 300.5)), 2.0)
    points = placed(find_points(ghost, shown(pixels), FIELD, SIZE))
    assert (points[:, 0] < 640).sum() >= 5
    assert (points[:, 0] > 760).sum() == 0


def test_a_whole_picture_of_one_colour_and_a_tiny_ghost_do_no_harm():
    blank = shown(np.full((SIZE[1], SIZE[0], 3), 90, dtype=np.uint8))
    found = find_points(ghost_along("Side line top", COURSE), blank, FIELD, SIZE)
    assert found == GhostPoints("Side line top", (), 0.0)
    tiny = ghost_along("Goal left post left ", np.array([[640.0, 300.0], [640.5, 301.0]]))
    assert find_points(tiny, shown(pitch()), FIELD, SIZE).points == ()


def test_accepting_makes_elements_and_keeps_what_is_there():
    points = (Point(0.1, 0.2), Point(0.5, 0.25))
    mine = Polyline("Side line left", (Point(0.3, 0.3), Point(0.3, 0.9)))
    copied = Polyline("Side line top", (Point(0.0, 0.0), Point(1.0, 0.0)))
    before = FrameAnnotation((mine,), unconfirmed=(copied,))
    after = accept(
        before,
        [
            GhostPoints("Side line top", points, 0.9),
            GhostPoints("Side line left", points, 0.9),
            GhostPoints("Middle line", (), 0.0),
        ],
    )
    assert after.polylines == (mine, Polyline("Side line top", points))
    assert after.unconfirmed == ()
    assert accept(before, []) is before


def test_lines_that_a_camera_misses_are_looked_for_where_the_others_show_them(drawn):
    annotation, picture = drawn.annotation("00011"), drawn.picture("00011")
    *seen, last = (
        GhostPoints(p.class_name, p.points, 1.0) for p in annotation if len(p.points) > 1
    )
    missed = GhostPoints(last.name, (), 0.0)
    again = retry(FrameAnnotation(), (*seen, missed), picture, FIELD, SIZE)
    assert again[:-1] == tuple(seen)
    assert again[-1].support > LEAST_SUPPORT


def test_accepting_all_leaves_out_what_is_hardly_seen(drawn):
    annotation, picture = drawn.annotation("00011"), drawn.picture("00011").copy()
    four = {"Big rect. left main", "Big rect. left top", "Big rect. left bottom"}
    four.add("Goal left crossbar")
    ghosts = find_ghosts(
        some(annotation, four), FIELD, fit_camera(some(annotation, four), FIELD, size=SIZE)
    )
    victim = ghosts[0]
    course = np.concatenate([piece.points_px for piece in victim.pieces])
    low, high = course.min(axis=0).astype(int) - 20, course.max(axis=0).astype(int) + 20
    low = np.maximum(low, 0)
    height, width = picture[low[1] : high[1], low[0] : high[0]].shape[:2]
    picture[low[1] : high[1], low[0] : high[0], :3] = crowd(width, height)
    before = some(annotation, four)
    after, accepted, left = all_accepted(before, picture)
    assert victim.name in left
    assert after.get(victim.name) is None
    untouched, accepted_then, left_then = all_accepted(
        before, picture, not_visible=frozenset(accepted)
    )
    assert untouched is before
    assert accepted_then == ()
    assert set(left_then) == set(left)


DrawnTwice = Callable[[int], tuple[Camera, PixelArray, np.ndarray]]
SMALL = (960, 540)


@pytest.fixture(scope="module")
def drawn_twice() -> DrawnTwice:
    """A view of the sample drawn with and without its paint and posts: where they can be seen."""
    bare = replace(soccer.ARENA, strokes=())

    def draw(arena: object, camera: Camera, number: int) -> np.ndarray:
        scene = scenery.draw_scenery(arena, camera, SMALL, number)
        picture = np.clip(scene, 0, 255).astype(np.uint8)
        solids.draw_things(picture, camera, soccer.things(camera, number))
        return cv2.GaussianBlur(picture, (0, 0), 0.7)

    def both(number: int) -> tuple[Camera, PixelArray, np.ndarray]:
        camera = soccer.views()[number - 1].camera
        painted = draw(soccer.ARENA, camera, number)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(soccer, "draw_bar", lambda *_: None)
            without = draw(bare, camera, number)
        paint = np.abs(painted.astype(int) - without).max(axis=2)
        return camera, shown(painted), paint

    return both


@pytest.mark.parametrize("number", [12, pytest.param(14, marks=pytest.mark.soak)])
def test_every_point_lies_where_paint_can_be_seen(drawn_twice, number):
    """Posts and crossbars, players, goals and boards in front of lines: the drawing knows."""
    camera, picture, paint = drawn_twice(number)
    exact = exact_courses(camera, SMALL)
    rng = np.random.default_rng(number)
    checked, hidden = 0, 0
    for name, courses in exact.items():
        if sum(np.hypot(*np.diff(c, axis=0).T).sum() for c in courses) < 12:
            continue
        # The ghost of a fit that is a little off.
        off, turn = rng.normal(0, 1.0, 2), rng.normal(0, 0.002)
        spin = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        pieces = []
        for course in courses:
            about = (course - course.mean(axis=0)) @ spin + course.mean(axis=0) + off
            about = np.clip(about, 0.0, np.array(SMALL) - 1.0)
            pieces.append(GhostPiece(about, np.full(len(about), 1.5)))
        found = find_points(Ghost(name, tuple(pieces)), picture, FIELD, SMALL)
        if found.support < LEAST_SUPPORT:
            continue
        for x, y in placed(found, SMALL):
            column, row = round(float(x)), round(float(y))
            near = paint[max(0, row - 2) : row + 3, max(0, column - 2) : column + 3]
            checked += 1
            hidden += near.max() < 10
    assert checked > 40
    assert hidden == 0


def test_real_lines_of_a_real_frame(shared_data):
    frames = shared_data / "frames"
    picture = decode_bgra(frames / "bra_mex.jpg")
    path = frames / "bra_mex.json"
    annotation = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
    four = {"Big rect. right main", "Circle right", "Side line right", "Big rect. right top"}
    after, accepted, _ = all_accepted(some(annotation, four), picture)
    assert {"Goal right crossbar", "Small rect. right main", "Small rect. right top"} <= set(
        accepted
    )
    for name in accepted:
        new, clicked = after.get(name), annotation.get(name)
        assert new is not None
        assert clicked is not None
        apart = away(points_px(clicked, SIZE), [points_px(new, SIZE)])
        assert np.median(apart) < 1.0
        assert apart.max() < 5.0


def test_points_are_normalised_to_the_size_of_the_picture():
    found = find_points(ghost_along("Side line top", COURSE), shown(pitch(LINE)), FIELD, SIZE)
    first = found.points[0]
    assert (first.u, first.v) == pytest.approx(point_from_px(100, 300, SIZE)[:2], abs=0.005)


def test_a_chain_has_one_point_at_its_corner():
    """A backboard's lower left corner, painted white on dark: two pieces meet there."""
    court = load_field("basketball_fiba")
    corner = (400.0, 500.0)
    picture = np.full((720, 1280, 4), 60, dtype=np.uint8)
    for end in ((400, 250), (800, 520)):
        cv2.line(picture, (400, 500), end, (230, 230, 230, 255), 4, cv2.LINE_AA)
    down, across = straight((400.0, 250.0), corner), straight(corner, (800.0, 520.0))
    sds = np.full(len(down), 1.5)
    ghost = Ghost("Backboard left", (GhostPiece(down, sds), GhostPiece(across, sds)))
    found = find_points(ghost, picture, court, SIZE)
    assert found.support > 0.9
    points = placed(found)
    near = np.hypot(*(points - corner).T)
    assert (near < 5.0).sum() == 1
    assert away(points, [down, across]).max() < 1.5
    assert np.hypot(*np.diff(points, axis=0).T).min() > 3.0
