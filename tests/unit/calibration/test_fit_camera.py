"""Cameras come back from clicks; bad input is declined in words, and nothing is guessed."""

import warnings
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.optimization.camera_parameters import MODELS
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import PixelAspect
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

PICTURE_SIZES = [(960, 540), (1920, 1080), (1280, 720)]


def only(annotation: FrameAnnotation, count: int) -> FrameAnnotation:
    return FrameAnnotation(annotation.polylines[:count])


def turned(annotation: FrameAnnotation, field) -> FrameAnnotation:
    return FrameAnnotation(
        tuple(Polyline(field.symmetries[0].name_of(p.class_name), p.points) for p in annotation)
    )


@pytest.mark.parametrize(
    ("model", "count", "elements"),
    [
        ("R", 16, 3),
        ("R+", 20, 4),
        ("auto", 20, 4),
        pytest.param("R", 50, 3, marks=pytest.mark.soak),
    ],
)
def test_cameras_on_all_sides_come_back(views, field, median_error, model, count, elements):
    rng = np.random.default_rng(20)
    errors, sides = [], []
    for _ in range(count):
        view = views.random(rng, at_least=elements)
        found = fit_camera(view.annotation, field, model=model).camera
        errors.append(np.inf if found is None else median_error(view.camera, found))
        sides.append(view.side)
    assert set(sides) == {0, 1, 2, 3}
    assert np.mean(np.array(errors) < 5) >= 0.95


@pytest.mark.parametrize(
    ("position", "focal", "pan", "tilt"),
    [
        ((-6.0, -52.0, -20.0), 2958.0, 170, 73),
        ((17.0, 63.0, -24.0), 3696.0, -14, 76),
        ((-28.0, 48.0, -20.0), 1543.0, 47, 58),
        ((-23.0, 49.0, -23.0), 2800.0, 15, 71),
    ],
)
def test_the_middle_of_the_field_is_enough(views, field, median_error, position, focal, pan, tilt):
    """Centre circle, middle line and one side line: what a broadcast shows most of the time."""
    camera = PinholeCamera(
        np.deg2rad(pan), np.deg2rad(tilt), 0.0, position, (focal, focal), (479.5, 269.5),
        (0.1, 0, 0, 0, 0, 0),
    )  # fmt: skip
    clicks = views.clicks(camera, np.random.default_rng(0), 0.5)
    names = {"Circle central", "Middle line", "Side line top", "Side line bottom"}
    middle = FrameAnnotation(tuple(p for p in clicks if p.class_name in names))
    assert len(middle.polylines) == 3
    assert median_error(camera, fit_camera(middle, field).camera) < 5


@pytest.mark.parametrize("model", ["H", "P", "R", "R+"])
def test_exact_clicks_give_the_exact_camera(views, field, median_error, model):
    view = views.main(
        np.random.default_rng(1), noise_px=0.0, k1=0.08 if model.startswith("R") else 0.0
    )
    found = fit_camera(view.annotation, field, model=model)
    assert found.failure is None
    assert found.left_out == ()
    assert median_error(view.camera, found.camera) < 0.3
    assert found.mean_px < 0.1


@pytest.mark.parametrize("model", ["H", "P", "R", "R+"])
def test_the_camera_is_for_the_size_asked_for(views, field, model):
    """The same annotation at other picture sizes: the same camera, scaled."""
    view = views.main(np.random.default_rng(2))
    cameras = [
        fit_camera(view.annotation, field, model=model, size=s).camera for s in PICTURE_SIZES
    ]
    world = np.array([(-40.0, 10.0, 0.0), (-30.0, -10.0, 0.0), (-45.0, 0.0, 0.0)])
    first, _ = cameras[0].project(world)
    for camera, size in zip(cameras[1:], PICTURE_SIZES[1:], strict=True):
        shown, valid = camera.project(world)
        assert valid.all()
        share = (np.array(size) - 1) / (959, 539)
        # 1919:1079 and 1279:719 are not quite 959:539.
        np.testing.assert_allclose(shown / share, first, atol=0.3)


@pytest.mark.parametrize("model", ["H", "P", "R", "R+"])
def test_turned_labels_give_the_turned_camera(views, field, model):
    """Half a turn of field and labels is a symmetry of everything, so also of the fit."""
    rng = np.random.default_rng(5)
    for side in range(4):
        annotation = views.random(rng, side=side, at_least=6).annotation
        one = fit_camera(annotation, field, model=model)
        other = fit_camera(turned(annotation, field), field, model=model)
        if one.failure is not None:
            assert (model, other.failure) == ("H", one.failure)
            continue
        world = np.array([(x, y, 0.0) for x in (-50, -20, 20, 50) for y in (-30, 0, 30)], float)
        a, seen = one.camera.project(world)
        b, also = other.camera.project(world * (-1, -1, 1))
        near = seen & also & (np.abs(a - 500).max(axis=1) < 1500)
        np.testing.assert_allclose(a[near], b[near], atol=0.5)
        assert one.mean_px == pytest.approx(other.mean_px, abs=1e-3)


def test_order_of_elements_and_points_does_not_matter(views, field):
    view = views.main(np.random.default_rng(6))
    shuffled = FrameAnnotation(
        tuple(Polyline(p.class_name, p.points[::-1]) for p in reversed(view.annotation.polylines))
    )
    one, other = fit_camera(view.annotation, field), fit_camera(shuffled, field)
    world = np.array([(-45.0, 0.0, 0.0), (-36.0, 20.0, 0.0), (-20.0, -20.0, 0.0)])
    # To within what the solver leaves undone.
    shown, again = one.camera.project(world)[0], other.camera.project(world)[0]
    np.testing.assert_allclose(shown, again, atol=0.02)


@pytest.mark.parametrize("model", ["R", "auto"])
def test_a_wrong_label_is_left_out_and_named(views, field, median_error, model):
    view = views.main(np.random.default_rng(7))
    points = view.annotation.get("Small rect. left main").points
    wrong = view.annotation.without("Small rect. left main").with_polyline(
        Polyline("Middle line", points)
    )
    found = fit_camera(wrong, field, model=model)
    assert found.left_out == ("Middle line",)
    assert median_error(view.camera, found.camera) < 3


def test_swapped_labels_are_left_out(views, field, median_error):
    view = views.main(np.random.default_rng(8))
    a, b = "Big rect. left top", "Small rect. left top"
    one, other = view.annotation.get(a), view.annotation.get(b)
    swapped = view.annotation.with_polyline(Polyline(a, other.points))
    swapped = swapped.with_polyline(Polyline(b, one.points))
    found = fit_camera(swapped, field)
    assert set(found.left_out) == {a, b}
    assert median_error(view.camera, found.camera) < 3


def test_warm_start_comes_to_the_same_camera(views, field):
    view = views.main(np.random.default_rng(9))
    for model in (*MODELS, "auto"):
        cold = fit_camera(view.annotation, field, model=model)
        polyline = view.annotation.polylines[0]
        moved = Point(polyline.points[0].u + 0.003, polyline.points[0].v - 0.003)
        edited = view.annotation.with_polyline(
            Polyline(polyline.class_name, (moved, *polyline.points[1:]))
        )
        warm = fit_camera(edited, field, model=model, start=cold.camera)
        again = fit_camera(edited, field, model=model)
        assert (cold.warm, warm.warm, again.warm) == (False, True, False)
        assert warm.model == again.model
        world = np.array([(-45.0, 0.0, 0.0), (-36.0, 20.0, 0.0), (-36.0, -20.0, 0.0)])
        np.testing.assert_allclose(
            warm.camera.project(world)[0], again.camera.project(world)[0], atol=0.2
        )


@pytest.mark.parametrize("model", ["H", "R", "auto"])
def test_a_start_that_is_wrong_does_no_harm(views, field, median_error, model):
    view = views.main(np.random.default_rng(10), k1=0.0)
    cold = fit_camera(view.annotation, field, model=model).camera
    elsewhere = views.random(np.random.default_rng(3), side=2).camera
    nonsense = HomographyCamera(np.eye(3))
    broken = replace(elsewhere, position_world=(np.nan, 0.0, 0.0))
    for start in (elsewhere, nonsense, broken):
        found = fit_camera(view.annotation, field, model=model, start=start)
        assert median_error(view.camera, found.camera) < 3
        assert median_error(cold, found.camera) < 0.3


def test_fewer_than_three_elements_are_declined(views, field):
    rng = np.random.default_rng(11)
    for _ in range(5):
        annotation = views.random(rng).annotation
        for count in range(3):
            for model in MODELS:
                found = fit_camera(only(annotation, count), field, model=model)
                assert found.camera is None
                assert found.elements == ()
                assert "needed" in found.failure
    assert fit_camera(only(annotation, 2), field, model="auto").failure == "2 elements, 3 needed"
    assert fit_camera(only(annotation, 1), field).failure == "1 element, 3 needed"


def test_what_has_no_place_on_the_field_does_not_count(views, field):
    annotation = only(views.main(np.random.default_rng(12)).annotation, 2)
    points = annotation.polylines[0].points
    for name in ("Line unknown", "Goal unknown", "Advertisement"):
        annotation = annotation.with_polyline(Polyline(name, points))
    annotation = annotation.with_polyline(Polyline("Middle line", ()))
    annotation = replace(annotation, unconfirmed=(Polyline("Side line top", points),))
    assert fit_camera(annotation, field).failure == "2 elements, 3 needed"


def test_goals_do_not_count_for_a_homography(field):
    names = ("Goal left crossbar", "Goal left post right", "Goal left post left ", "Middle line")
    annotation = FrameAnnotation(
        tuple(Polyline(n, (Point(0.1 * i, 0.3), Point(0.5, 0.2 * i))) for i, n in enumerate(names))
    )
    assert fit_camera(annotation, field, model="H").failure == ("1 element on the ground, 3 needed")


NAMES = ("Side line left", "Big rect. left main", "Big rect. left top", "Circle left")


@pytest.mark.parametrize(
    ("points", "why"),
    [
        ([(0.5, 0.5)] * 3, "two different ones"),
        ([(0.5, 0.5), (0.502, 0.5)], "all points lie in one place"),
        ([(0.1, 0.1), (0.5, 0.5), (0.9, 0.9)], "all points lie on one line"),
    ],
)
def test_points_that_say_nothing_are_declined(field, points, why):
    annotation = FrameAnnotation(
        tuple(Polyline(n, tuple(Point(u, v) for u, v in points)) for n in NAMES)
    )
    for model in MODELS:
        found = fit_camera(annotation, field, model=model)
        assert found.camera is None
        assert why in found.failure


def test_repeated_points_change_nothing(views, field):
    view = views.main(np.random.default_rng(13))
    repeated = FrameAnnotation(
        tuple(Polyline(p.class_name, (*p.points, *p.points)) for p in view.annotation)
    )
    one, other = fit_camera(view.annotation, field), fit_camera(repeated, field)
    np.testing.assert_array_equal(one.vector, other.vector)


@pytest.mark.parametrize("far", [1e3, 1e6, 1e300, np.nan, np.inf])
def test_a_point_far_away_or_nowhere_does_no_harm(views, field, median_error, far):
    view = views.main(np.random.default_rng(14))
    polyline = view.annotation.polylines[0]
    broken = view.annotation.with_polyline(
        Polyline(polyline.class_name, (*polyline.points, Point(far, -far)))
    )
    for model in ("R", "R+"):
        found = fit_camera(broken, field, model=model)
        assert median_error(view.camera, found.camera) < 3


@pytest.mark.parametrize(
    "seed", [*range(4), *(pytest.param(n, marks=pytest.mark.soak) for n in range(4, 12))]
)
def test_random_clicks_give_a_camera_or_a_reason(field, seed):
    """Nothing that is clicked ends in an error, a warning or a number that is none."""
    rng = np.random.default_rng(seed)
    names = [e.name for e in field.elements]
    spread = 10.0 ** rng.uniform(-3, 3)
    chosen = rng.choice(names, size=int(rng.integers(3, 12)), replace=False)
    annotation = FrameAnnotation(
        tuple(
            Polyline(
                str(n), tuple(Point(*p) for p in rng.normal(0.5, spread, (rng.integers(1, 6), 2)))
            )
            for n in chosen
        )
    )
    for model in MODELS:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            found = fit_camera(annotation, field, model=model)
        assert (found.camera is None) == (found.failure is not None)
        if isinstance(found.camera, PinholeCamera):
            camera = found.camera
            numbers = (camera.pan_rad, *camera.position_world, *camera.focal_px, *camera.radial)
            assert np.isfinite(numbers).all()
            assert camera.position_world[2] < 0
            assert camera.radial[0] >= 0
        elif found.camera is not None:
            assert np.isfinite(found.camera.image_from_world).all()
        if found.camera is not None:
            assert np.isfinite(found.covariance).all()


def test_a_field_of_another_size(median_error, views):
    """Dimensions come from the field, in the fit as in the metric."""
    from procc_annotator.field.load import load_field

    small = load_field("soccer", length=94.0, width=60.0)
    other = type(views)(small)
    view = other.main(np.random.default_rng(15), noise_px=0.2)
    right, wrong = fit_camera(view.annotation, small), fit_camera(view.annotation, views.field)
    assert median_error(view.camera, right.camera) < 1
    assert right.mean_px < wrong.mean_px


@pytest.mark.parametrize("model", ["R", "auto"])
def test_a_new_mistake_does_not_cost_the_camera(field, views, median_error, model):
    """One wrong label more: the warm fit leaves it out and need not look for a camera anew."""
    rng = np.random.default_rng(16)
    for _ in range(4):
        view = views.main(rng)
        start = fit_camera(view.annotation, field, model=model).camera
        points = view.annotation.polylines[int(rng.integers(len(view.annotation.polylines)))].points
        wrong = view.annotation.with_polyline(Polyline("Side line right", points))
        warm = fit_camera(wrong, field, model=model, start=start)
        assert (warm.warm, warm.left_out) == (True, ("Side line right",))
        assert median_error(view.camera, warm.camera) < 3


def test_unknown_models_are_refused(views, field):
    annotation = views.main(np.random.default_rng(0)).annotation
    with pytest.raises(UsageError, match="did you mean R"):
        fit_camera(annotation, field, model="r")
    with pytest.raises(UsageError, match="choose one of H, P, R, R\\+, R2, F, auto"):
        fit_camera(annotation, field, model="fisheye")
    with pytest.raises(UsageError, match="did you mean auto"):
        fit_camera(annotation, field, model="Auto")
    with pytest.raises(UsageError, match="too small"):
        fit_camera(annotation, field, size=(1, 540))


@pytest.mark.parametrize("model", ["R", "auto"])
def test_a_new_element_far_off_the_start_is_believed_if_all_agree(field, views, model):
    """A camera from few elements may be far off elsewhere: what is clicked there is no mistake."""
    clicked = views.main(np.random.default_rng(4)).annotation
    near = {"Big rect. left main", "Big rect. left top", "Big rect. left bottom", "Circle left"}
    few = FrameAnnotation(tuple(p for p in clicked if p.class_name in near))
    polyline = clicked.get("Side line bottom")
    assert polyline is not None
    start = fit_camera(few, field, model=model).camera
    warm = fit_camera(few.with_polyline(polyline), field, model=model, start=start)
    assert warm.warm
    assert warm.left_out == ()
    assert max(e.mean_px for e in warm.elements) < 2.0


# The tool chooses the simplest model the points support, and says why.

SIZE = (960, 540)


def chosen_for(views, field, cameras, rng, noise_px: float = 1.0) -> Counter[str]:
    fits = [
        fit_camera(views.clicks(camera, rng, noise_px), field, model="auto", size=SIZE)
        for camera in cameras
    ]
    return Counter(fit.model for fit in fits)


def test_without_distortion_a_pinhole_will_do(views, field):
    rng = np.random.default_rng(30)
    cameras = [views.random(rng, k1=0.0).camera for _ in range(12)]
    assert chosen_for(views, field, cameras, rng)["P"] >= 11


def test_distortion_that_shows_is_fitted(views, field):
    rng = np.random.default_rng(31)
    main = views.main(rng).camera
    bent = [replace(main, radial=(k1, 0, 0, 0, 0, 0)) for k1 in np.linspace(0.2, 0.6, 8)]
    chosen = chosen_for(views, field, bent, rng)
    assert chosen["P"] == 0
    assert chosen["R"] >= 6


def test_pixels_that_are_not_square_are_fitted(views, field):
    rng = np.random.default_rng(32)
    main = views.main(rng, k1=0.3).camera
    wide = [replace(main, focal_px=(1500 * share, 1500.0)) for share in (0.93, 0.95, 1.05, 1.07)]
    assert chosen_for(views, field, wide, rng, noise_px=0.5) == {"R+": 4}


@pytest.mark.parametrize("model", ["H", "R", "R+", "auto"])
def test_squeezed_pictures_have_the_cameras_of_wide_ones(views, field, model):
    view, size = views.main(np.random.default_rng(3), k1=0.1), (640, 640)
    wide = fit_camera(view.annotation, field, model=model)
    narrow = replace(field, pixels=PixelAspect(16 / 9, 1.0))
    found = fit_camera(view.annotation, narrow, model=model, size=size)
    world = np.array([(-40.0, 10.0, 0.0), (-30.0, -10.0, 0.0), (-45.0, 0.0, 0.0)])
    shown, again = (fit.camera.project(world)[0] / fit.size for fit in (wide, found))
    np.testing.assert_allclose(again, shown, atol=1e-3)
    if model != "H":
        assert found.deviations.position_m == pytest.approx(wide.deviations.position_m, rel=0.01)
        y_by_x = found.camera.focal_px[1] / found.camera.focal_px[0]
        assert y_by_x == pytest.approx(16 / 9, rel=0.002 if model == "R" else 0.03)
    measured = measure(view.annotation, found.camera, EvaluationSetup(field, size, "procc"))
    judged = {e.annotated_name: e.max_distance for e in score(measured, 5.0).elements}
    for element in found.elements:  # px of the picture as it is
        assert element.max_px == pytest.approx(judged[element.name], abs=0.05)


@pytest.mark.parametrize(
    ("k1", "model", "why"),
    [(0.0, "P", "without lens distortion"), (0.5, "R", "lens distortion"), (0.5, "R+", "aspect")],
)
def test_the_reason_is_told(views, field, k1, model, why):
    rng = np.random.default_rng(33)
    camera = views.main(rng, k1=k1).camera
    if model == "R+":
        camera = replace(camera, principal_point_px=(520.0, 269.5))
    fit = fit_camera(views.clicks(camera, rng, 0.5), field, model="auto", size=SIZE)
    assert fit.model == model
    assert why in fit.chosen_because
    assert " px" in fit.chosen_because
    assert len(fit.parameters) == {"P": 7, "R": 8, "R+": 11}[model]


def test_it_is_the_fit_of_the_model_that_was_chosen(views, field):
    world = np.array([(-45.0, 0.0, 0.0), (-36.0, 20.0, 0.0), (-20.0, -20.0, 0.0)])
    for k1 in (0.0, 0.1, 0.5):
        annotation = views.main(np.random.default_rng(34), k1=k1).annotation
        chosen = fit_camera(annotation, field, model="auto")
        asked = fit_camera(annotation, field, model=chosen.model)
        assert asked.chosen_because is None
        np.testing.assert_allclose(
            chosen.camera.project(world)[0], asked.camera.project(world)[0], atol=0.05
        )
        assert chosen.deviations.pan_rad == pytest.approx(asked.deviations.pan_rad, rel=0.02)
        assert chosen.left_out == asked.left_out


def test_shuffled_labels_choose_no_model(views, field):
    annotation = views.main(np.random.default_rng(38)).annotation
    names = [p.class_name for p in annotation]
    shuffled = FrameAnnotation(
        tuple(
            Polyline(name, p.points)
            for name, p in zip(names[3:] + names[:3], annotation, strict=True)
        )
    )
    lost = fit_camera(shuffled, field, model="auto")
    assert (lost.model, lost.camera, lost.chosen_because) == ("auto", None, None)
    assert lost.failure
