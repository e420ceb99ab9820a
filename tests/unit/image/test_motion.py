"""The motion found between two pictures is the camera's, not the players' and not the graphics'."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.motion import CameraMotion, estimate_motion, transfer_points
from tests.drawn_shots import people, scenery, soccer

SIZE = (960, 540)
Pixels = NDArray[np.uint8]
Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Stadium:
    """One view of the sample, drawn again and again while the players run."""

    number: int

    @property
    def camera(self) -> PinholeCamera:
        return soccer.views()[self.number - 1].camera

    def draw(self, camera: PinholeCamera, moment: int) -> Pixels:
        scene = scenery.draw_scenery(soccer.ARENA, camera, SIZE, self.number)
        picture = np.clip(scene, 0, 255).astype(np.uint8)
        random = np.random.default_rng(moment)
        for sign in (-1, 1):
            soccer.draw_goal(picture, camera, sign)
        for person in soccer.people(self.camera, self.number):
            moved = replace(person, spot=person.spot + random.normal(0, 0.3, 2))
            people.draw_person(picture, camera, moved)
        noise = random.normal(0, 1.6, picture.shape)
        return np.clip(picture + noise, 0, 255).astype(np.uint8)


def _bgra(picture: Pixels) -> Pixels:
    return np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2BGRA), dtype=np.uint8)


def _broadcast(picture: Pixels, quality: int, seed: int) -> Pixels:
    """What transmission leaves of a picture."""
    noise = np.random.default_rng(seed).normal(0, 5, picture.shape)
    noisy = np.clip(picture + noise, 0, 255).astype(np.uint8)
    _, data = cv2.imencode(".jpg", noisy, [cv2.IMWRITE_JPEG_QUALITY, quality])
    return np.asarray(cv2.imdecode(data, cv2.IMREAD_COLOR), dtype=np.uint8)


def _with_graphics(picture: Pixels) -> Pixels:
    """A score at the top and a board of names at the bottom, richer in corners than the grass."""
    result = picture.copy()
    height, width = picture.shape[:2]
    font, white = cv2.FONT_HERSHEY_DUPLEX, (255, 255, 255)
    result[height // 18 : height // 5, width // 14 : width * 2 // 7] = (20, 90, 30)
    cv2.putText(result, "HOM 1-0 AWY", (width // 13, height // 8), font, 0.9, white, 2)
    result[height * 31 // 36 : height * 23 // 24, width // 4 : width * 3 // 4] = (120, 40, 30)
    for i in range(3):
        place = (width // 4 + 8, height * 32 // 36 + 15 * i)
        cv2.putText(
            result, "1 ABEL 2 BAUER 3 CRUZ 4 DIAZ 5 EVANS"[3 * i :], place, font, 0.5, white
        )
    return result


def _turned(camera: PinholeCamera, right: float = 0.0, down: float = 0.0) -> PinholeCamera:
    """Turned by parts of the picture's width and height."""
    focal = camera.focal_px[0]
    return replace(
        camera,
        pan_rad=camera.pan_rad + math.atan(right * SIZE[0] / focal),
        tilt_rad=camera.tilt_rad - math.atan(down * SIZE[1] / focal),
    )


def _zoomed(camera: PinholeCamera, factor: float) -> PinholeCamera:
    return replace(camera, focal_px=(camera.focal_px[0] * factor, camera.focal_px[1] * factor))


def _line_error(motion: CameraMotion | None, before: PinholeCamera, now: PinholeCamera) -> Floats:
    """Distances in px between moved and true line points, of those both cameras see."""
    assert motion is not None
    points = sample_evenly(load_field(), 0.5).points_world
    (px_before, front_before), (px_now, front_now) = before.project(points), now.project(points)
    seen = front_before & front_now
    for px in (px_before, px_now):
        seen &= (px >= 0).all(axis=1) & (px <= np.array(SIZE) - 1).all(axis=1)
    assert seen.sum() > 20
    away = transfer_points(motion, px_before[seen]) - px_now[seen]
    return np.hypot(*away.T)


MOVES: list[Callable[[PinholeCamera], PinholeCamera]] = [
    lambda camera: _turned(camera, right=0.1),
    lambda camera: _zoomed(camera, 1.2),
    lambda camera: _turned(camera, down=-0.1),
    lambda camera: _zoomed(_turned(camera, right=-0.05, down=0.04), 1.1),
]


@pytest.fixture(scope="module")
def first_pictures() -> dict[int, Pixels]:
    """Two views before anything moved: one with boards and crowd, one of lines on grass alone."""
    views = (Stadium(2), Stadium(13))
    return {view.number: _bgra(view.draw(view.camera, 1)) for view in views}


@pytest.mark.parametrize(
    ("move", "number"),
    [
        pytest.param(move, number, id=f"{name}-{number}", marks=[pytest.mark.soak] * is_soak)
        for move, name in zip(MOVES, ("pan", "zoom", "tilt", "all"), strict=True)
        for number in (2, 13)
        for is_soak in [(name, number) not in (("pan", 2), ("all", 13))]
    ],
)
def test_lines_are_found_again_after_the_camera_moved(first_pictures, number, move):
    stadium = Stadium(number)
    before, now = stadium.camera, move(stadium.camera)
    motion = estimate_motion(first_pictures[number], _bgra(stadium.draw(now, 2)))
    error = _line_error(motion, before, now)
    assert np.median(error) < 1
    assert np.percentile(error, 95) < 3


@pytest.mark.parametrize("shift", [0.012, pytest.param(0.1, marks=pytest.mark.soak)])
def test_noise_compression_and_graphics_do_not_decide(shift):
    stadium = Stadium(2)
    before, now = stadium.camera, _turned(stadium.camera, right=shift)
    pictures = [
        _bgra(_broadcast(_with_graphics(stadium.draw(camera, seed)), 60, seed))
        for seed, camera in enumerate((before, now))
    ]
    error = _line_error(estimate_motion(*pictures), before, now)
    assert np.median(error) < 1.5
    assert np.percentile(error, 95) < 4


def test_another_camera_is_no_motion(sample_data):
    names = ("00001", "00007", "00009", "00013")
    pictures = [decode_bgra(sample_data / f"{name}.jpg") for name in names]
    for i, j in ((0, 1), (1, 2), (2, 3), (3, 0)):
        assert estimate_motion(pictures[i], pictures[j]) is None


def test_the_same_graphics_on_another_camera_are_no_motion(sample_data):
    pictures = [
        _bgra(_with_graphics(np.ascontiguousarray(decode_bgra(path)[..., :3])))
        for path in (sample_data / "00007.jpg", sample_data / "00010.jpg")
    ]
    assert estimate_motion(*pictures) is None


def test_what_has_nothing_to_see_or_is_turned_over_is_no_motion(sample_data):
    picture = decode_bgra(sample_data / "00002.jpg")
    noise = np.random.default_rng(1).integers(0, 255, picture.shape, dtype=np.uint8)
    for other in (
        np.zeros_like(picture),
        noise,
        np.ascontiguousarray(picture[:, ::-1]),
        np.ascontiguousarray(picture[::-1]),
        np.full((1, 1, 4), 90, dtype=np.uint8),
        np.full((4000, 3, 4), 90, dtype=np.uint8),
    ):
        assert estimate_motion(picture, other) is None
        assert estimate_motion(other, picture) is None


@pytest.mark.parametrize("number", ["00002", "00009", "00013"])
def test_a_camera_that_stands_still_does_not_move(sample_data, number):
    picture = decode_bgra(sample_data / f"{number}.jpg")
    motion = estimate_motion(picture, picture)
    np.testing.assert_allclose(motion.current_from_previous, np.eye(3), atol=0.02)
    assert motion.inliers > 0.9 * motion.matches
    plain = np.ascontiguousarray(picture[..., :3])
    noisy = [_bgra(_broadcast(_with_graphics(plain), 70, seed)) for seed in (1, 2)]
    motion = estimate_motion(*noisy)
    assert motion is not None
    corners = np.array([(0, 0), (1279, 0), (0, 719), (1279, 719)], dtype=np.float64)
    np.testing.assert_allclose(transfer_points(motion, corners), corners, atol=2)


def test_pictures_may_differ_in_size(sample_data):
    picture = decode_bgra(sample_data / "00002.jpg")
    small = np.asarray(cv2.resize(picture, (640, 360), interpolation=cv2.INTER_AREA))
    motion = estimate_motion(picture, small)
    assert motion is not None
    points = np.array([(0, 0), (639.5, 359.5), (1279, 719)])
    # The middle of a small pixel is the middle of the four it covers.
    np.testing.assert_allclose(transfer_points(motion, points), (points + 0.5) / 2 - 0.5, atol=0.1)
    cropped = np.ascontiguousarray(picture[:, 200:1100])
    motion = estimate_motion(picture, cropped)
    assert motion is not None
    middle = np.array([(700.0, 300.0)])
    np.testing.assert_allclose(transfer_points(motion, middle), middle - (200, 0), atol=0.3)


def test_points_behind_the_camera_go_nowhere():
    homography = np.array([[1, 0, 5], [0, 1, 0], [-0.01, 0, 1]], dtype=np.float64)
    motion = CameraMotion(homography, 50, 60)
    moved = transfer_points(motion, np.array([(50.0, 10.0), (100.0, 0.0), (200.0, 0.0)]))
    np.testing.assert_allclose(moved[0], (110, 20))
    assert np.isnan(moved[1:]).all()
    assert transfer_points(motion, np.empty((0, 2))).shape == (0, 2)


@pytest.mark.parametrize(
    ("zoom", "right", "down", "turn"),
    [(1, 130, 0, 0), (1, 12, -5, 0), (1, 2, 0, 0), (1.2, -100, -60, 0), (0.85, 60, 30, 0.01)],
)
def test_a_real_picture_under_graphics(shared_data, zoom, right, down, turn):
    path = shared_data / "frames" / "bra_mex.jpg"
    if not path.is_file():
        pytest.skip("the real picture is not here")
    picture = np.ascontiguousarray(decode_bgra(path)[..., :3])
    height, width = picture.shape[:2]
    cosine, sine = zoom * math.cos(turn), zoom * math.sin(turn)
    true = np.array([[cosine, -sine, right], [sine, cosine, down], [1e-5, 0, 1]])
    warped = np.asarray(cv2.warpPerspective(picture, true, (width, height)), dtype=np.uint8)
    motion = estimate_motion(
        _bgra(_broadcast(_with_graphics(picture), 70, 1)),
        _bgra(_broadcast(_with_graphics(warped), 45, 2)),
    )
    assert motion is not None
    x, y = np.meshgrid(np.linspace(0, width - 1, 20), np.linspace(0, height - 1, 12))
    points = np.column_stack([x.ravel(), y.ravel()])
    expected = cv2.perspectiveTransform(points[None], true)[0]
    seen = ((expected >= 0) & (expected <= (width - 1, height - 1))).all(axis=1)
    away = np.hypot(*(transfer_points(motion, points) - expected)[seen].T)
    assert np.median(away) < 0.5
    assert away.max() < 1.5
