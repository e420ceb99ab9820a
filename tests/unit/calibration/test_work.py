"""A fit never takes long: its work is bounded, whatever was clicked."""

from collections import Counter
from dataclasses import replace

import cv2
import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px, points_px
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.calibration.fitting import FitRequest, fit_camera, fit_cameras
from procc_annotator.calibration.optimization import residuals, robust_fit
from procc_annotator.calibration.optimization.observations import (
    MAX_POINTS,
    ImageFrame,
    build_observations,
)
from procc_annotator.calibration.optimization.robust_fit import FitScene, search_cameras
from procc_annotator.camera.base import Camera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.field.load import load_field, with_lines
from procc_annotator.field.model import CameraPlacement, Field
from procc_annotator.image.line_snapping import snap_points_to_lines
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup
from tests.bench.sports.views import Views

# Times that residuals are computed (for any number of cameras at once), at most: 4 + 5 steps of the
# search, 20 robust ones, 20 final ones, one look at the start of each of these four stages, and one
# at who is mistaken.
COLD = 54
# A start that misleads: up to 8 + 3 x 20 steps in vain before; the choice compares two more models,
# and has up to 8 + 20 steps of its own in vain.
MISLED, CHOICE, CHOICE_MISLED = COLD + 73, 42, 73
# Where the picture may be cut out of a larger one: 20 more robust steps, 20 more final ones.
CUT_OUT = 42
# Where there may be barrel distortion: one look at its promise, 20 more robust steps, 20 more final
# ones, and one look at the start of both.
BARREL = 43
# Where lines are bent as by a strong lens: three searches for points made straight again, and a
# fisheye and a radial lens with 40 robust steps and 20 final ones each, with a look at each start.
STRONG = 3 * COLD + 2 * 62


class Work:
    """Counts the residuals that are computed."""

    def __init__(self, monkeypatch) -> None:
        self.calls = self.points = 0
        computed = robust_fit.pinhole_residuals

        def counted(vectors, seen, **options):
            self.calls += 1
            self.points += len(vectors) * seen.points.shape[1]
            return computed(vectors, seen, **options)

        monkeypatch.setattr(robust_fit, "pinhole_residuals", counted)

    def of(self, annotation, field, **options) -> int:
        self.calls = 0
        fit_camera(annotation, field, **options)
        return self.calls


@pytest.fixture
def work(monkeypatch) -> Work:
    return Work(monkeypatch)


def shuffled(annotation: FrameAnnotation, rng: np.random.Generator) -> FrameAnnotation:
    names = rng.permutation([p.class_name for p in annotation])
    return FrameAnnotation(
        tuple(Polyline(str(n), p.points) for n, p in zip(names, annotation, strict=True))
    )


def scattered(annotation: FrameAnnotation, rng: np.random.Generator) -> FrameAnnotation:
    def moved(points: tuple[Point, ...]) -> tuple[Point, ...]:
        return tuple(Point(p.u + rng.normal(0, 0.05), p.v + rng.normal(0, 0.05)) for p in points)

    return FrameAnnotation(tuple(Polyline(p.class_name, moved(p.points)) for p in annotation))


@pytest.mark.parametrize("model", ["R+", "auto"])
def test_the_work_is_bounded_whatever_the_labels_say(views, field, work, model):
    rng = np.random.default_rng(40)
    most = COLD + CUT_OUT + BARREL + (CHOICE + STRONG if model == "auto" else 0)
    for _ in range(3):
        annotation = views.random(rng, at_least=3).annotation
        for spoilt in (annotation, shuffled(annotation, rng), scattered(annotation, rng)):
            assert 0 < work.of(spoilt, field, model=model) <= most


@pytest.mark.parametrize("model", ["R", "auto"])
def test_so_is_that_of_a_start_that_misleads(views, field, work, model):
    rng = np.random.default_rng(41)
    most = MISLED + BARREL + (CUT_OUT + CHOICE_MISLED if model == "auto" else 0)
    counts: list[int] = []
    for _ in range(3):
        view, other = views.random(rng), views.random(rng)
        both = (view.annotation, shuffled(view.annotation, rng))
        counts += [work.of(a, field, model=model, start=other.camera) for a in both]
    assert 0 < max(counts) <= most


def test_a_warm_fit_takes_a_few_steps(views, field, work):
    rng = np.random.default_rng(42)
    counts = {"R": [], "auto": []}
    for _ in range(4):
        view = views.random(rng, at_least=6)
        for model, found in counts.items():
            start = fit_camera(view.annotation, field, model=model).camera
            again = views.clicks(view.camera, rng)
            found.append(work.of(again, field, model=model, start=start))
    assert np.median(counts["R"]) <= 8
    assert np.median(counts["auto"]) <= 18


def test_thousands_of_points_cost_no_more_than_many(views, field, work, median_error):
    """Masks and regularised lines may come with a point a pixel."""
    view = views.main(np.random.default_rng(43), noise_px=0.3)

    def dense(polyline: Polyline, count: int) -> Polyline:
        given = np.array([(p.u, p.v) for p in polyline.points])
        at = np.linspace(0, len(given) - 1, count)
        along = np.arange(len(given))
        uv = [np.interp(at, along, given[:, k]) for k in (0, 1)]
        return Polyline(polyline.class_name, tuple(Point(*p) for p in zip(*uv, strict=True)))

    many = FrameAnnotation(tuple(dense(p, 1500) for p in view.annotation))
    seen = build_observations(many, field, ImageFrame((960, 540)))
    assert max(seen.counts) == MAX_POINTS
    ends = seen.points[:, [0, seen.counts[0] - 1]]
    first = many.get(seen.elements[0].name).points
    expected = [[(p.u - 0.5) * 959, (p.v - 0.5) * 539] for p in (first[0], first[-1])]
    np.testing.assert_allclose(ends.T, expected, atol=1e-9)
    assert median_error(view.camera, fit_camera(many, field).camera) < 2


# Frames that are fitted together get the cameras that each of them gets alone.

SIZE, LARGER = (960, 540), (1920, 1080)


@pytest.fixture(scope="module")
def frames(views, field) -> list[FitRequest]:
    """Frames unlike each other: few and many elements, with and without curves, barrel, wrong
    labels, too little for a camera, another size."""
    rng = np.random.default_rng(5)
    seen = [views.random(rng).annotation for _ in range(5)]
    seen.append(views.main(rng, k1=-0.2).annotation)
    straight = [p for p in seen[5] if field.element(p.class_name).is_straight]
    seen.append(FrameAnnotation(tuple(straight)))
    seen.append(swapped(seen[5]))
    seen.append(FrameAnnotation(seen[5].polylines[:1]))
    seen.append(FrameAnnotation(()))
    given = [(annotation, field, SIZE) for annotation in seen]
    return [*given, (seen[0], field, LARGER)]


def swapped(annotation: FrameAnnotation) -> FrameAnnotation:
    first, second, *rest = annotation.polylines
    return FrameAnnotation(
        (
            Polyline(second.class_name, first.points),
            Polyline(first.class_name, second.points),
            *rest,
        )
    )


@pytest.mark.parametrize("model", ["P", "R", "R+", "auto", "H", "F"])
def test_the_same_as_alone(frames, model):
    together = fit_cameras(frames, model=model)
    assert len(together) == len(frames)
    assert sum(fit.camera is not None for fit in together) >= 6
    for (annotation, field, size), fit in zip(frames, together, strict=True):
        alone = fit_camera(annotation, field, model=model, size=size)
        assert (fit.model, fit.failure, fit.left_out) == (
            alone.model,
            alone.failure,
            alone.left_out,
        )
        if alone.camera is None:
            assert fit.camera is None
            continue
        np.testing.assert_allclose(fit.vector, alone.vector, rtol=1e-6, atol=1e-9)
        np.testing.assert_allclose(fit.covariance, alone.covariance, rtol=1e-4, atol=1e-12)
        assert fit.mean_px == pytest.approx(alone.mean_px, rel=1e-6)


def test_who_is_beside_a_frame_does_not_matter(frames):
    one = fit_cameras([frames[0], frames[5]], model="R")
    other = fit_cameras([frames[5], *frames[6:], frames[0]], model="R")
    np.testing.assert_allclose(one[0].vector, other[-1].vector, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(one[1].vector, other[0].vector, rtol=1e-6, atol=1e-9)


def test_no_frames_get_no_cameras():
    assert fit_cameras([]) == []


def test_residuals_of_several_frames_are_computed_at_once(frames, monkeypatch):
    """As often as the slowest frame needs them, not as often as all of them do."""
    calls: Counter[str] = Counter()
    computed = residuals.find_closest_points

    def counted(*args, **options):
        calls[way] += 1
        return computed(*args, **options)

    monkeypatch.setattr(residuals, "find_closest_points", counted)
    frame = ImageFrame(SIZE)
    seen = [(build_observations(one, field, frame), field) for one, field, _ in frames[:8]]
    scenes = [FitScene(*one, frame) for one in seen]
    way = "alone"
    alone = [search_cameras([one], "R")[0] for one in scenes]
    way = "together"
    for one, other in zip(alone, search_cameras(scenes, "R"), strict=True):
        assert one.solution.steps == other.solution.steps
        np.testing.assert_allclose(one.vector, other.vector, rtol=1e-6, atol=1e-9)
    assert calls["together"] < 0.7 * calls["alone"]


# Which point of a polyline each distance of a fit is of.

FRAME_SIZE = (960, 540)
NAME = "Big rect. left main"


def test_repeated_points_and_points_nowhere_do_not_shift_the_others(views, field):
    clean = views.main(np.random.default_rng(7), noise_px=0.3).annotation
    points = clean.get(NAME).points
    x, y = points_px(clean.get(NAME), FRAME_SIZE)[-1]
    bad = point_from_px(x + 30, y, FRAME_SIZE)
    nowhere = points[0]._replace(u=float("nan"))
    polyline = Polyline(NAME, (points[0], nowhere, points[0], *points[1:-1], bad))
    fit = fit_camera(clean.with_polyline(polyline), field, size=FRAME_SIZE)
    (residual,) = (e for e in fit.elements if e.name == NAME)
    distances = residual.distances_of(polyline, FRAME_SIZE)
    assert max(distances, key=distances.__getitem__) == len(polyline.points) - 1
    assert not {1, 2} & distances.keys()


def test_of_very_many_points_some_have_a_distance(views, field):
    clean = views.main(np.random.default_rng(8), noise_px=0.3).annotation
    first, *_, last = points_px(clean.get(NAME), FRAME_SIZE)
    way = np.linspace(first, last, 3 * MAX_POINTS)
    polyline = Polyline(NAME, tuple(point_from_px(*p, FRAME_SIZE) for p in way))
    fit = fit_camera(clean.with_polyline(polyline), field, size=FRAME_SIZE)
    (residual,) = (e for e in fit.elements if e.name == NAME)
    places = list(residual.distances_of(polyline, FRAME_SIZE))
    assert len(places) == MAX_POINTS
    assert (places[0], places[-1]) == (0, len(way) - 1)
    assert residual.distances_of(clean.get(NAME), FRAME_SIZE) == {}  # another polyline


# Where cameras are looked for, and how far what a field's file says of it is believed.


@pytest.mark.parametrize("model", ["P", "R+", "auto"])
@pytest.mark.parametrize("height", [13.0, 17.0])
def test_a_place_without_a_range_is_believed_but_not_to_the_metre(
    views, field, median_error, model, height
):
    """The camera is at 32 m and 14 m: the file may be right or somewhat off."""
    view = views.main(np.random.default_rng(5), noise_px=0.5, k1=0.0)
    exact = replace(field, cameras=CameraPlacement((30.0, 30.0, 30.0), (height, height, height)))
    fit = fit_camera(view.annotation, exact, model=model)
    assert fit.camera is not None, fit.failure
    assert median_error(view.camera, fit.camera) < 2
    assert abs(fit.camera.position_world[2] - view.camera.position_world[2]) < 1.5


def test_cameras_that_all_stand_at_one_distance_and_height_are_found(field):
    """As a field file may say; the study of every sport draws its cameras from there."""
    exact = Views(replace(field, cameras=CameraPlacement((30.0, 30.0, 30.0), (12.0, 12.0, 12.0))))
    view = exact.random(np.random.default_rng(2))
    assert view.camera.position_world[2] == -12
    fit = fit_camera(view.annotation, exact.field)
    assert exact.median_error(view.camera, fit.camera) < 5


# Clicks that were put on painted lines, in drawn pictures of a hall: fits know where they lie.

DRAWN, DRAWN_SIZE = "00003", (1280, 720)
EVALUATED = (960, 540)
COURT = load_field("volleyball")


def snapped(picture: np.ndarray, camera: Camera) -> FrameAnnotation:
    """Clicks near where the rules measure, put on the painted lines."""
    polylines, paint = [], ExpectedLines(COURT, DRAWN_SIZE[0])
    for name, pieces in project_field(
        camera, EvaluationSetup(COURT, DRAWN_SIZE, "procc")
    ).pieces.items():
        element, piece = COURT.element(name), max(pieces, key=len)
        if not (element.line_width and element.is_straight):
            continue
        clicks = piece[0] + np.linspace(0.1, 0.9, 8)[:, None] * (piece[-1] - piece[0])
        along, sought = np.diff(clicks, axis=0)[[0] * len(clicks)], paint.of(name)
        placed = snap_points_to_lines(picture, clicks, along, sought)
        placed = placed[~np.isnan(placed[:, 0])]
        if len(placed) > 2:
            polylines.append(
                Polyline(name, tuple(point_from_px(x, y, DRAWN_SIZE) for x, y in placed))
            )
    return FrameAnnotation(tuple(polylines))


def distance_px(annotation: FrameAnnotation, camera: Camera, field: Field) -> float:
    setup = EvaluationSetup(field, EVALUATED, "procc")
    return float(np.median(score(measure(annotation, camera, setup), 5).labelling.all_distances))


def test_a_fit_to_the_middle_of_paint_is_the_true_camera(sample_data):
    folder = sample_data / "volleyball"
    cameras = CameraSet.open(folder / "cameras" / "true")
    true = cameras.camera(DRAWN, EVALUATED).camera
    picture = cv2.cvtColor(cv2.imread(str(folder / f"{DRAWN}.jpg")), cv2.COLOR_BGR2BGRA)
    annotation = snapped(picture, true.scaled(EVALUATED, DRAWN_SIZE))
    assert len(annotation.polylines) >= 6
    assert distance_px(annotation, true, COURT) > 0.3
    middle = with_lines(COURT, "middle")
    assert distance_px(annotation, true, middle) < 0.1

    corners = np.array([(x, y, 0.0) for x in (-9, 0, 9) for y in (-4.5, 4.5)])
    here, _ = true.project(corners)

    def off_px(field: Field) -> float:
        fit = fit_camera(annotation, field, model="R+")
        shown, _ = fit.camera.project(corners)
        return float(np.median(np.hypot(*(shown - here).T)))

    assert off_px(middle) < 0.3
    assert off_px(COURT) > 2 * off_px(middle) + 0.3
