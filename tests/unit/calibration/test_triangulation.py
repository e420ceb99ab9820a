"""Places in space from clicks: against scipy, against chance, with a reason where there is none."""

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest
import scipy
from numpy.typing import NDArray

from procc_annotator.calibration.prediction.uncertainty import project_error_ellipses
from procc_annotator.calibration.triangulation import (
    ClickedView,
    Triangulation,
    compare_with_survey,
    default_click_sd_px,
    pooled_noise_factor,
    triangulate,
)
from procc_annotator.camera.backprojection import projection_jacobian, viewing_ray
from procc_annotator.camera.base import ScaledCamera
from procc_annotator.camera.models import FisheyeCamera, HomographyCamera, PinholeCamera

FloatArray = NDArray[np.float64]
SEAT = np.array([18.0, -47.0, -9.5])


def _looking_at(
    position: tuple[float, float, float], target: FloatArray, focal: float = 1400.0
) -> PinholeCamera:
    """A camera that has the target near the middle of a picture of 960 x 540, with some lens."""
    x, y, z = target - np.array(position)
    pan, tilt = math.atan2(x, -y), math.atan2(math.hypot(x, y), z)
    return PinholeCamera(
        pan,
        tilt,
        0.01,
        position,
        (focal, focal * 1.01),
        (480.0, 270.0),
        (-0.2, 0.05, 0.0, 0.0, 0.0, 0.0),
        (0.001, -0.002),
    )


CAMERAS = (
    _looking_at((0.0, 70.0, -18.0), SEAT + np.array([3, 0, 1])),
    _looking_at((-52.0, 55.0, -15.0), SEAT + np.array([0, 2, -1]), 1800.0),
    _looking_at((60.0, 30.0, -10.0), SEAT + np.array([-1, 0, 0])),
    _looking_at((70.0, -20.0, -25.0), SEAT, 900.0),
)


@dataclass(frozen=True)
class Plain:
    """A model of which nothing is known but its projection."""

    camera: PinholeCamera | FisheyeCamera

    def project(self, points_world: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
        return self.camera.project(points_world)


def _clicks(
    *cameras: object, off: FloatArray | float = 0.0, place: FloatArray = SEAT
) -> list[ClickedView]:
    views = []
    for i, camera in enumerate(cameras):
        px, shown = camera.project(SEAT[None])
        assert shown.all()
        moved = px[0] + (off[i] if isinstance(off, np.ndarray) else off)
        views.append(ClickedView(f"view{i}", camera, moved, 1.0))
    return views


def _position(found: Triangulation) -> FloatArray:
    assert found.position is not None, found.failure
    return np.array(found.position)


@pytest.mark.parametrize("count", [2, 3, 4])
def test_exact_clicks_give_the_place(count):
    found = triangulate(_clicks(*CAMERAS[:count]))
    assert np.abs(_position(found) - SEAT).max() < 1e-6
    assert found.left_out == ()
    assert max(px for _, px in found.residuals_px) < 1e-5


def test_any_model_will_do():
    fisheye = FisheyeCamera(
        CAMERAS[2].pan_rad,
        CAMERAS[2].tilt_rad,
        CAMERAS[2].roll_rad,
        CAMERAS[2].position_world,
        (500.0, 500.0),
        (480.0, 270.0),
        (0.02, -0.01, 0.0, 0.0),
    )
    for one in (fisheye, Plain(fisheye), Plain(CAMERAS[1]), ScaledCamera(CAMERAS[1], (2.0, 2.0))):
        found = triangulate(_clicks(CAMERAS[0], one))
        assert np.abs(_position(found) - SEAT).max() < 1e-4


def test_a_sight_line_is_the_same_whether_the_model_is_known_or_searched():
    known = viewing_ray(CAMERAS[1], np.array([200.0, 400.0]))
    searched = viewing_ray(Plain(CAMERAS[1]), np.array([200.0, 400.0]))
    assert abs(abs(float(known.direction @ searched.direction)) - 1) < 1e-9
    beside = np.cross(searched.place - known.place, known.direction)
    assert np.linalg.norm(beside) < 1e-5


def test_the_derivatives_agree_with_a_known_camera():
    plain = replace(CAMERAS[0], radial=(0.0,) * 6, tangential=(0.0, 0.0))
    _, slopes = projection_jacobian(plain, SEAT[None])
    x, y, z = plain.rotation_cam_from_world @ (SEAT - plain.position_world)
    fx, fy = plain.focal_px
    exact = np.array([[fx / z, 0, -fx * x / z**2], [0, fy / z, -fy * y / z**2]])
    assert np.abs(slopes[0] - exact @ plain.rotation_cam_from_world).max() < 1e-6


def test_the_least_squares_are_those_of_scipy():
    rng = np.random.default_rng(5)
    views = _clicks(*CAMERAS, off=rng.normal(0, 1.0, (4, 2)))
    views[1] = replace(views[1], click_px=2.5)
    spread = np.array([[3.0, 1.0], [1.0, 2.0]])
    views[2] = replace(views[2], covariance=lambda p: np.broadcast_to(spread, (len(p), 2, 2)))
    roots = [
        np.linalg.cholesky(v.click_px**2 * np.eye(2) + (0 if v.covariance is None else spread))
        for v in views
    ]

    def residuals(place: FloatArray) -> FloatArray:
        return np.concatenate([
            np.linalg.solve(root, v.camera.project(place[None])[0][0] - v.point_px)
            for root, v in zip(roots, views, strict=True)
        ])  # fmt: skip

    second = scipy.optimize.least_squares(residuals, SEAT, xtol=1e-14, ftol=1e-14, gtol=1e-14)
    found = triangulate(views, estimate_noise=False)
    assert np.abs(_position(found) - second.x).max() < 1e-5
    expected = np.linalg.inv(second.jac.T @ second.jac)
    assert np.abs(np.array(found.covariance) - expected).max() < 1e-3 * expected.max()


def _mean_mahalanobis(errors: FloatArray, covariances: FloatArray) -> float:
    return float(np.einsum("ni,nij,nj->n", errors, np.linalg.inv(covariances), errors).mean())


@pytest.mark.parametrize("count", [2, 3])
def test_the_covariance_is_what_noise_does(count):
    rng = np.random.default_rng(11)
    errors, covariances = [], []
    for _ in range(120):
        views = _clicks(*CAMERAS[:count], off=rng.normal(0, 1.0, (count, 2)))
        found = triangulate(views, estimate_noise=False)
        errors.append(_position(found) - SEAT)
        covariances.append(found.covariance)
    # Of three degrees of freedom; its standard error is sqrt(6 / 120) = 0.22.
    assert 2.4 < _mean_mahalanobis(np.array(errors), np.array(covariances)) < 3.6


def test_the_covariance_holds_what_the_cameras_do_not_know():
    rng = np.random.default_rng(12)
    sd_m = 0.6

    def from_position(camera: PinholeCamera, places: FloatArray) -> FloatArray:
        # Moving the camera is moving the place the other way.
        _, slopes = projection_jacobian(camera, places)
        return np.asarray(sd_m**2 * slopes @ slopes.transpose(0, 2, 1))

    errors, covariances = [], []
    for _ in range(120):
        views = []
        for view, camera in zip(_clicks(*CAMERAS[:3]), CAMERAS, strict=False):
            x, y, z = np.array(camera.position_world) + rng.normal(0, sd_m, 3)
            believed = replace(camera, position_world=(x, y, z))
            px = view.point_px + rng.normal(0, 1.0, 2)
            views.append(
                ClickedView(view.name, believed, px, 1.0, lambda p, c=believed: from_position(c, p))
            )
        found = triangulate(views, estimate_noise=False)
        errors.append(_position(found) - SEAT)
        covariances.append(found.covariance)
    assert 2.4 < _mean_mahalanobis(np.array(errors), np.array(covariances)) < 3.6


def test_noise_larger_than_usual_is_seen_in_the_residuals():
    rng = np.random.default_rng(3)
    off = rng.normal(0, 2.5, (4, 2))
    told = triangulate(_clicks(*CAMERAS), estimate_noise=False)
    seen = triangulate(_clicks(*CAMERAS, off=off))
    assert seen.deviations_m[1] > 1.2 * told.deviations_m[1]


@pytest.mark.parametrize("bad", [0, 1, 2, 3])
def test_one_view_that_contradicts_the_others_is_left_out_and_named(bad):
    off = np.zeros((4, 2))
    off[bad] = (70.0, -45.0)
    found = triangulate(_clicks(*CAMERAS, off=off))
    assert found.left_out == (f"view{bad}",)
    assert np.abs(_position(found) - SEAT).max() < 1e-5
    assert dict(found.residuals_px)[f"view{bad}"] > 50


def test_of_three_views_one_may_be_wrong():
    found = triangulate(_clicks(*CAMERAS[:3], off=np.array([[0.0, 0.0], [0.0, 60.0], [0.0, 0.0]])))
    assert found.left_out == ("view1",)
    assert np.abs(_position(found) - SEAT).max() < 1e-5


def test_two_views_that_disagree_are_refused():
    found = triangulate(_clicks(*CAMERAS[:2], off=np.array([[0.0, 0.0], [0.0, 60.0]])))
    assert found.position is None
    assert found.failure is not None
    assert "do not agree" in found.failure


def test_lines_of_sight_from_one_place_are_refused():
    zoomed = replace(CAMERAS[0], focal_px=(2800.0, 2800.0), pan_rad=CAMERAS[0].pan_rad + 0.02)
    found = triangulate(_clicks(CAMERAS[0], zoomed))
    assert found.failure is not None
    assert "nearly the same direction" in found.failure


def test_lines_of_sight_that_meet_behind_a_camera_are_refused():
    # Two cameras side by side that squint outwards: the lines meet behind both.
    left = _looking_at((-10.0, 70.0, -18.0), np.array([-40.0, 0.0, -5.0]))
    right = _looking_at((10.0, 70.0, -18.0), np.array([40.0, 0.0, -5.0]))
    middle = np.array([480.0, 270.0])
    views = [ClickedView("left", left, middle, 1.0), ClickedView("right", right, middle, 1.0)]
    found = triangulate(views)
    assert found.failure is not None
    assert "meet behind the camera of left" in found.failure


def test_what_no_view_can_tell_is_said():
    ground = HomographyCamera(np.array([[8.0, 0.0, 480.0], [0.0, 8.0, 270.0], [0.0, 0.0, 1.0]]))
    middle = np.array([480.0, 270.0])
    folds = FisheyeCamera(0.0, 1.2, 0.0, (0.0, 70.0, -18.0), (500.0, 500.0), (480.0, 270.0))
    folds = replace(folds, coefficients=(-0.3, 0.0, 0.0, 0.0))
    flat = [ClickedView("a", ground, middle, 1.0), ClickedView("b", ground, middle, 1.0)]
    for views, words in (
        ([], "in no view"),
        (_clicks(CAMERAS[0]), "one view only"),
        (flat, "know only the ground"),
        (
            [*_clicks(CAMERAS[0]), ClickedView("c", folds, np.array([4000.0, 0.0]), 1.0)],
            "shows nothing",
        ),
    ):
        failure = triangulate(views).failure
        assert failure is not None
        assert words in failure


def test_a_click_is_as_good_as_its_picture_is_wide():
    assert default_click_sd_px(1920) == pytest.approx(2 * default_click_sd_px(960))


def test_the_ellipse_holds_95_percent_of_where_the_place_may_appear():
    rng = np.random.default_rng(8)
    found = triangulate(_clicks(*CAMERAS[:2]), estimate_noise=False)
    assert found.position is not None
    ellipse = project_error_ellipses(CAMERAS[2], [found.position], [found.covariance])[0]
    assert found.covariance is not None
    places = rng.multivariate_normal(found.position, np.array(found.covariance), 4000)
    px, _ = CAMERAS[2].project(places)
    cosine, sine = math.cos(ellipse.angle_rad), math.sin(ellipse.angle_rad)
    turned = (px - ellipse.centre_px) @ np.array([[cosine, -sine], [sine, cosine]])
    inside = ((turned / ellipse.semi_axes_px) ** 2).sum(axis=1) < 1
    assert 0.935 < inside.mean() < 0.965
    outline = ellipse.outline() - ellipse.centre_px
    own = outline @ np.array([[cosine, -sine], [sine, cosine]])
    assert np.allclose(((own / ellipse.semi_axes_px) ** 2).sum(axis=1), 1.0)
    assert ellipse.semi_axes_px[0] >= ellipse.semi_axes_px[1]


def test_a_place_behind_the_camera_has_no_ellipse():
    away = np.array(CAMERAS[0].position_world) * 2 - SEAT
    assert project_error_ellipses(CAMERAS[0], [tuple(away.tolist())], [None])[0] is None


def test_a_known_place_is_compared_to_its_clicks():
    clicks = _clicks(*CAMERAS[:3])
    near = compare_with_survey(clicks, tuple(SEAT + np.array([0.02, 0.0, 0.0])))
    assert near.astray == ()
    assert max(px for _, px in near.residuals_px) < 1
    off = SEAT + np.array([1.0, 0.0, 0.0])
    far = compare_with_survey(clicks, tuple(off))
    assert far.astray == ("view0", "view1", "view2")
    shown = np.array([view.camera.project(off[None])[0][0] - view.point_px for view in clicks])
    assert [px for _, px in far.residuals_px] == pytest.approx(np.hypot(*shown.T))
    # A place that is only known to a metre contradicts nothing, nor do clicks known to be noisy.
    assert compare_with_survey(clicks, tuple(off), ((1, 0, 0), (0, 1, 0), (0, 0, 1))).astray == ()
    noisy = [replace(view, click_px=20.0) for view in clicks]
    assert compare_with_survey(noisy, tuple(off), estimate_noise=False).astray == ()


def test_a_known_place_behind_a_camera_is_told():
    found = compare_with_survey(_clicks(*CAMERAS[:2]), (0.0, 90.0, -18.0))
    assert "view0" in found.astray
    assert "view0" not in dict(found.residuals_px)


# How far clicks are off, told by all landmarks of a run together.

STAND = np.array([10.0, -40.0, -8.0])
CLICK_PX = 1.5  # as the views say


def camera(x: float) -> PinholeCamera:
    position = (x, 60.0, -15.0)
    dx, dy, dz = STAND - position
    pan, tilt = math.atan2(dx, -dy), math.atan2(math.hypot(dx, dy), dz)
    return PinholeCamera(pan, tilt, 0.0, position, (1800.0, 1800.0), (479.5, 269.5))


def together(found: list[Triangulation]) -> float:
    return pooled_noise_factor([(one.squares, one.spare) for one in found])


def run(
    rng: np.random.Generator, noise_px: float, views: int, places: int
) -> tuple[np.ndarray, list[Triangulation]]:
    cameras = [camera(x) for x in np.linspace(-40, 40, views)]
    truth = STAND + rng.normal(size=(places, 3)) * (6, 4, 2)
    clicked = [
        [
            ClickedView(str(i), c, c.project(p[None])[0][0] + rng.normal(0, noise_px, 2), CLICK_PX)
            for i, c in enumerate(cameras)
        ]
        for p in truth
    ]
    found = [triangulate(one) for one in clicked]
    for _ in range(2):
        noise = together(found)
        found = [triangulate(one, noise=noise) for one in clicked]
    return truth, found


@pytest.mark.parametrize(
    ("noise_px", "views"),
    [
        (1.5, 3),
        (3.0, 2),
        pytest.param(1.5, 2, marks=pytest.mark.soak),
        pytest.param(3.0, 3, marks=pytest.mark.soak),
    ],
)
def test_covariances_hold_for_clicks_as_good_as_usual_and_worse(noise_px, views):
    rng = np.random.default_rng(6)
    squares = []
    for _ in range(3):
        truth, found = run(rng, noise_px, views, 30)
        off = np.array([one.position for one in found]) - truth
        covariances = np.array([one.covariance for one in found])
        squares.append(np.einsum("ni,nij,nj->n", off, np.linalg.inv(covariances), off))
        assert found[0].noise == pytest.approx(noise_px / CLICK_PX, rel=0.35)
    # Of three degrees of freedom; its standard error is sqrt(6 / 90) = 0.26.
    assert 2.3 < np.mean(squares) < 4.2
    assert 0.87 <= np.mean(np.array(squares) < 7.815) <= 0.99


def test_a_single_place_says_little_of_the_noise():
    _, (one,) = run(np.random.default_rng(5), 3.0, 2, 1)
    assert one.noise < 1.5


def test_one_bad_click_does_not_make_all_others_bad():
    rng = np.random.default_rng(6)
    cameras = [camera(x) for x in (-40.0, 0.0, 40.0)]
    found = []
    for number in range(8):
        place = STAND + rng.normal(size=3) * 3
        off = rng.normal(0, 1.5, (3, 2)) + (18.0 if number == 0 else 0.0) * np.eye(3)[:, :2]
        views = [
            ClickedView(str(i), c, c.project(place[None])[0][0] + off[i], CLICK_PX)
            for i, c in enumerate(cameras)
        ]
        found.append(triangulate(views))
    assert together(found[1:]) == pytest.approx(1, abs=0.3)
    assert together(found) < 1.6


def test_good_clicks_do_not_make_cameras_better():
    """Of views that are themselves uncertain the clicks' share alone becomes smaller."""
    place = STAND[None]
    views = [
        ClickedView(
            str(x),
            c,
            c.project(place)[0][0],
            CLICK_PX,
            lambda p: 9.0 * np.eye(2)[None],
        )
        for x, c in ((x, camera(x)) for x in (-40.0, 40.0))
    ]
    usual, good = (np.array(triangulate(views, noise=n).deviations_m) for n in (1.0, 0.5))
    share = np.sqrt((9 + 0.25 * CLICK_PX**2) / (9 + CLICK_PX**2))
    np.testing.assert_allclose(good, share * usual, rtol=1e-6)
