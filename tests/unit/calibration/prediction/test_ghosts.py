"""What is offered besides the clicks: only what is in sight, missing, and known well enough."""

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px, points_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.prediction.ghosts import MAX_SD_PX, find_ghosts
from procc_annotator.calibration.prediction.suggestions import suggest_annotations
from procc_annotator.calibration.prediction.visible_elements import visible_stretches
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.metrics.polylines import Polylines
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field("soccer")
SIZE = (960, 540)
LIMITS = np.array(SIZE) - 1.0


def only(annotation: FrameAnnotation, names: set[str]) -> FrameAnnotation:
    return FrameAnnotation(tuple(p for p in annotation if p.class_name in names))


def looking(pan: float, tilt: float, focal: float, k1: float = 0.0) -> PinholeCamera:
    return PinholeCamera(
        np.deg2rad(pan),
        np.deg2rad(tilt),
        0.0,
        (0.0, 65.0, -15.0),
        (focal, focal),
        (479.5, 269.5),
        (k1, 0.0, 0.0, 0.0, 0.0, 0.0),
    )


def distances(points: np.ndarray, courses: list[np.ndarray]) -> np.ndarray:
    """(n,) px to the nearest of some courses."""
    vertices = np.concatenate(courses)
    is_end = np.zeros(len(vertices), dtype=bool)
    is_end[np.cumsum([len(c) for c in courses]) - 1] = True
    lines = Polylines(vertices, np.zeros(len(vertices), dtype=np.intp), is_end, 1)
    return lines.segments.distances(points, np.zeros(len(points), dtype=np.intp))


@pytest.mark.parametrize("k1", [0.0, 0.4])
@pytest.mark.parametrize("pan", [-45.0, -20.0, 0.0, 30.0])
def test_in_sight_is_what_the_camera_projects_and_nothing_else(pan, k1):
    camera = looking(pan, 78.0, 1300.0, k1)
    expected = project_field(camera, EvaluationSetup(FIELD, SIZE, "procc")).pieces
    found: dict[str, list[np.ndarray]] = {}
    for stretch in visible_stretches(FIELD, camera, SIZE):
        found.setdefault(stretch.name, []).append(stretch.points_px)
    assert found.keys() >= {n for n, p in expected.items() if sum(map(len, p)) > 2}
    for name, courses in found.items():
        inside = np.concatenate(courses)
        assert (inside >= -1e-9).all()
        assert (inside <= LIMITS + 1e-9).all()
        assert distances(inside, list(expected[name])).max() < 0.3
        # The other way round: nothing is missing, up to the picture's very edge.
        assert distances(np.concatenate(expected[name]), courses).max() < 0.5


def test_an_element_cut_off_ends_at_the_edge_and_keeps_its_direction():
    camera = looking(-20.0, 78.0, 1300.0)
    (top,) = [s for s in visible_stretches(FIELD, camera, SIZE) if s.name == "Side line top"]
    element = FIELD.element("Side line top")
    way = np.array(element.geometry.end) - np.array(element.geometry.start)
    assert (np.diff(top.points_world @ way) > 0).all()
    cut = min(top.points_px.min(), (LIMITS - top.points_px).min())
    assert cut == pytest.approx(0.0, abs=1e-6)
    again, _ = camera.project(top.points_world)
    assert np.abs(again - top.points_px).max() < 0.05


def test_a_circle_in_sight_is_one_stretch_wherever_it_is_cut():
    whole = looking(0.0, 76.0, 1000.0)
    (circle,) = [s for s in visible_stretches(FIELD, whole, SIZE) if s.name == "Circle central"]
    assert np.hypot(*(circle.points_px[0] - circle.points_px[-1])) < 1e-6
    for pan in (-12.0, 12.0):  # its left or its right part is outside
        cut = looking(pan, 76.0, 2400.0)
        (circle,) = [s for s in visible_stretches(FIELD, cut, SIZE) if s.name == "Circle central"]
        assert np.hypot(*np.diff(circle.points_px, axis=0).T).max() < 40.0


def test_nothing_behind_the_camera_is_in_sight():
    camera = replace(looking(-40.0, 80.0, 900.0), position_world=(30.0, 10.0, -6.0))
    names = {s.name for s in visible_stretches(FIELD, camera, SIZE)}
    assert "Side line top" in names
    assert not names & {"Side line bottom", "Side line right", "Big rect. right main"}


@pytest.fixture(scope="module")
def clicked(views):
    return views.main(np.random.default_rng(4)).annotation


def test_ghosts_are_what_is_missing_and_the_line_lies_in_their_band(clicked, views):
    rng = np.random.default_rng(4)
    view = views.main(rng)
    exact = project_field(view.camera, views.setup).pieces
    names = {"Big rect. left main", "Big rect. left top", "Circle left", "Side line left"}
    fit = fit_camera(only(clicked, names), FIELD, size=SIZE)
    ghosts = find_ghosts(only(clicked, names), FIELD, fit)
    assert len(ghosts) >= 3
    for ghost in ghosts:
        assert ghost.name not in names
        assert ghost.sd_px <= MAX_SD_PX
        for piece in ghost.pieces:
            away = distances(piece.points_px, list(exact[ghost.name]))
            assert (away <= 2 * piece.sd_px + 0.5).mean() > 0.9
    order = [FIELD.index[ghost.name] for ghost in ghosts]
    assert order == sorted(order)


def test_what_is_there_or_not_wanted_is_not_offered(clicked):
    names = {"Big rect. left main", "Big rect. left top", "Circle left", "Side line left"}
    some = only(clicked, names)
    fit = fit_camera(some, FIELD, size=SIZE)
    offered = [g.name for g in find_ghosts(some, FIELD, fit)]
    first, second, *rest = offered
    copied = clicked.get(first)
    assert copied is not None
    waiting = replace(some, unconfirmed=(copied,))
    assert [g.name for g in find_ghosts(waiting, FIELD, fit, without={second})] == rest


def relabelled(annotation: FrameAnnotation, name: str, other: str) -> FrameAnnotation:
    """The points of one class under another one."""
    polyline = annotation.get(name)
    return annotation.without(name).with_polyline(Polyline(other, polyline.points))


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("Side line left", "Side line right"),
        ("Small rect. left main", "Big rect. right main"),
    ],
)
def test_a_line_annotated_under_a_wrong_class_is_offered_no_second_label(clicked, right, wrong):
    without = clicked.without(right)
    assert right in [g.name for g in find_ghosts(without, FIELD, _fitted(without))]
    mistaken = relabelled(clicked, right, wrong)
    fit = _fitted(mistaken)
    assert fit.left_out == (wrong,)
    assert right not in [g.name for g in find_ghosts(mistaken, FIELD, fit)]
    assert right not in [s.name for s in suggest_annotations(mistaken, FIELD, fit)]


def test_an_element_that_is_merely_off_takes_no_ghost_away(clicked):
    some = clicked.without("Small rect. left main")
    polyline = some.get("Side line left")
    off = tuple(Point(p.u + 0.02, p.v + 0.1) for p in polyline.points)
    moved = some.with_polyline(Polyline("Side line left", off))
    fit = _fitted(moved)
    assert fit.left_out == ("Side line left",)
    assert "Small rect. left main" in [g.name for g in find_ghosts(moved, FIELD, fit)]


def _fitted(annotation: FrameAnnotation) -> FitResult:
    return fit_camera(annotation, FIELD, size=SIZE)


def test_without_a_camera_there_are_no_ghosts(clicked):
    two = only(clicked, {"Big rect. left main", "Side line left"})
    fit = fit_camera(two, FIELD, size=SIZE)
    assert fit.camera is None
    assert find_ghosts(two, FIELD, fit) == ()


def test_the_gate_opens_as_the_camera_becomes_known(clicked):
    offered, names = [], []
    for name in ("Circle left", "Big rect. left top", "Big rect. left main", "Side line left"):
        names.append(name)
        some = only(clicked, set(names))
        fit = fit_camera(some, FIELD, size=SIZE)
        ghosts = {g.name: g.sd_px for g in find_ghosts(some, FIELD, fit, most_sd_px=50.0)}
        offered.append(ghosts.get("Small rect. left main", np.inf))
    assert offered[1] == np.inf
    assert offered[3] < 0.7 * offered[2]


def test_a_homography_offers_nothing_off_the_ground(clicked):
    some = only(clicked, set(clicked.annotated) - {"Small rect. left main", "Small rect. left top"})
    fit = fit_camera(some, FIELD, model="H", size=SIZE)
    ghosts = find_ghosts(
        some.without("Goal left crossbar").without("Goal left post right"), FIELD, fit
    )
    assert {g.name for g in ghosts} >= {"Small rect. left main"}
    assert all(element.on_ground for g in ghosts if (element := FIELD.element(g.name)))


def test_pieces_too_short_to_click_are_left_out():
    far = replace(looking(0.0, 85.0, 300.0), position_world=(0.0, 130.0, -15.0))
    pieces = visible_stretches(FIELD, far, SIZE)
    short = {s.name for s in pieces if s.length_px < 10}
    assert short  # posts of goals far away
    clicks = FrameAnnotation()
    fit = replace(fit_camera(_exact(far), FIELD, size=SIZE), camera=far)
    assert not short & {g.name for g in find_ghosts(clicks, FIELD, fit, most_sd_px=1e6)}


def _exact(camera: PinholeCamera) -> FrameAnnotation:
    polylines = []
    for stretch in visible_stretches(FIELD, camera, SIZE):
        rows = np.linspace(0, len(stretch.points_px) - 1, 5).round().astype(int)
        points = tuple(point_from_px(x, y, SIZE) for x, y in stretch.points_px[rows])
        polylines.append(Polyline(stretch.name, points))
    return FrameAnnotation(tuple({p.class_name: p for p in polylines}.values()))


@pytest.mark.parametrize("every", [12, pytest.param(3, marks=pytest.mark.soak)])
def test_offered_elements_of_real_frames_are_where_they_are_annotated(shared_data, every):
    """Fits to 3 to 6 random elements: what is offered is within 5 px (whole set: 99 %)."""
    rng = np.random.default_rng(0)
    paths = sorted((shared_data / "wc14" / "annotations").glob("*.json"))
    right, offered, missing = 0, 0, 0
    for number, path in enumerate(paths[::every]):
        annotation = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
        names = [n for n in annotation.annotated if n in FIELD.index]
        count = 3 + number % 4
        if len(names) <= count:
            continue
        some = only(annotation, set(rng.choice(names, count, replace=False).tolist()))
        fit = fit_camera(some, FIELD, size=SIZE)
        missing += len(names) - count
        for ghost in find_ghosts(some, FIELD, fit):
            polyline = annotation.get(ghost.name)
            if polyline is not None:
                courses = [p.points_px for p in ghost.pieces]
                offered += 1
                right += distances(points_px(polyline, SIZE), courses).mean() < 5
    assert offered > 0.35 * missing
    assert right >= 0.98 * offered
