"""How far clicks are off, told by all landmarks of a run together."""

from __future__ import annotations

import math

import numpy as np
import pytest

from procc_annotator.calibration.triangulation import (
    ClickedView,
    Triangulation,
    pooled_noise_factor,
    triangulate,
)
from procc_annotator.camera.models import PinholeCamera

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
def test_covariances_hold_for_clicks_as_good_as_usual_and_worse(noise_px, views) -> None:
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


def test_a_single_place_says_little_of_the_noise() -> None:
    _, (one,) = run(np.random.default_rng(5), 3.0, 2, 1)
    assert one.noise < 1.5


def test_one_bad_click_does_not_make_all_others_bad() -> None:
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


def test_good_clicks_do_not_make_cameras_better() -> None:
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
