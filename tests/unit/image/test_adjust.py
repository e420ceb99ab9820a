"""What is shown changes as asked; what was handed in never does; faint lines come out."""

import threading
import time
from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.errors import ImageError
from procc_annotator.image import decoding as cache_module
from procc_annotator.image.decoding import FrameCache, decode_bgra
from procc_annotator.image.pixels import (
    DisplayAdjustment,
    DownscaledImages,
    PixelArray,
    adjust_image,
    downscaled,
    tone_curve,
)

GRASS = (60, 110, 70)  # b, g, r
LOOKS = [
    DisplayAdjustment(brightness=0.4),
    DisplayAdjustment(contrast=-0.5),
    DisplayAdjustment(gamma=2.2),
    DisplayAdjustment(enhance=True),
    DisplayAdjustment(brightness=-1.0, contrast=1.0, gamma=0.2, enhance=True),
]


def _noise(shape: tuple[int, int], seed: int = 0) -> PixelArray:
    """A read-only picture of random opaque pixels, as the cache hands them out."""
    pixels = np.random.default_rng(seed).integers(0, 256, (*shape, 4), dtype=np.uint8)
    pixels[..., 3] = 255
    pixels.flags.writeable = False
    return pixels


def _faint_line(grass: tuple[int, int, int], strength: int, width: int = 3) -> PixelArray:
    """Noisy grass with mown stripes and a slanted line, hardly lighter than it."""
    rng = np.random.default_rng(7)
    picture = np.empty((540, 960, 3))
    picture[:] = grass
    picture += 6 * ((np.arange(960) // 160) % 2)[None, :, None]
    picture += rng.normal(0, 2, (540, 960, 1))
    ink = np.zeros((540, 960), dtype=np.uint8)
    cv2.line(ink, (0, 180), (959, 330), 255, width, cv2.LINE_AA)
    picture += strength * (ink[..., None] / 255)
    bgra = np.full((540, 960, 4), 255, dtype=np.uint8)
    bgra[..., :3] = np.clip(np.rint(picture), 0, 255)
    return bgra


def _contrast(pixels: PixelArray) -> float:
    """How much lighter the line is than the grass beside it."""
    light = cv2.cvtColor(pixels, cv2.COLOR_BGRA2GRAY).astype(float)
    x = np.arange(100, 860)
    y = 180 + np.rint(x * 150 / 959).astype(int)
    beside = (light[y - 12, x] + light[y + 12, x]) / 2
    return float((light[y, x] - beside).mean())


def test_a_plain_look_gives_the_very_array():
    pixels = _noise((20, 30))
    assert DisplayAdjustment().is_identity
    assert adjust_image(pixels, DisplayAdjustment()) is pixels


@pytest.mark.parametrize("look", LOOKS)
def test_the_array_given_stays_as_it_was(look):
    pixels = _noise((90, 160))
    before = pixels.copy()
    shown = adjust_image(pixels, look)
    np.testing.assert_array_equal(pixels, before)
    assert not look.is_identity
    assert not np.shares_memory(shown, pixels)
    assert shown.shape == pixels.shape
    assert shown.dtype == np.uint8
    assert shown.flags.c_contiguous
    assert not shown.flags.writeable
    assert (shown[..., 3] == 255).all()


@pytest.mark.parametrize("look", LOOKS)
@pytest.mark.parametrize("shape", [(1, 1), (2, 1), (3, 200)])
def test_pictures_of_any_size(look, shape):
    assert adjust_image(_noise(shape), look).shape == (*shape, 4)


def test_a_file_is_not_touched(tmp_path):
    path = tmp_path / "frame.png"
    cv2.imwrite(str(path), _noise((20, 30))[..., :3])
    before = path.read_bytes()
    adjust_image(decode_bgra(path), LOOKS[-1])
    assert path.read_bytes() == before


def test_brightness_shifts_every_value():
    grey = np.full((4, 4, 4), (100, 120, 140, 255), dtype=np.uint8)
    assert adjust_image(grey, DisplayAdjustment(brightness=0.25))[0, 0].tolist() == [
        132,
        152,
        172,
        255,
    ]
    assert adjust_image(grey, DisplayAdjustment(brightness=-0.25))[0, 0].tolist() == [
        68,
        88,
        108,
        255,
    ]


def test_contrast_stretches_about_the_middle():
    more, less = (
        tone_curve(DisplayAdjustment(contrast=0.5)).astype(int),
        tone_curve(DisplayAdjustment(contrast=-0.5)),
    )
    assert more[157] - more[98] == pytest.approx(2 * (157 - 98), abs=1)
    assert int(less[228]) - int(less[28]) == pytest.approx(100, abs=1)
    assert abs(more[127] - 127) <= 1


def test_gamma_lightens_the_dark_and_keeps_black_and_white():
    lighter, darker = (
        tone_curve(DisplayAdjustment(gamma=2.0)),
        tone_curve(DisplayAdjustment(gamma=0.5)),
    )
    assert (lighter[0], lighter[255], darker[0], darker[255]) == (0, 255, 0, 255)
    assert lighter[64] == pytest.approx(128, abs=1)
    assert darker[128] == pytest.approx(64, abs=1)


@pytest.mark.parametrize("look", LOOKS)
def test_order_of_values_is_kept(look):
    assert (np.diff(tone_curve(look).astype(int)) >= 0).all()


@pytest.mark.parametrize("grass", [GRASS, (20, 38, 24), (110, 170, 120)])
@pytest.mark.parametrize("strength", [8, 14, 22])
@pytest.mark.parametrize("width", [2, 3, 6])
def test_a_faint_line_becomes_clear(grass, strength, width):
    picture = _faint_line(grass, strength, width)
    assert (
        _contrast(adjust_image(picture, DisplayAdjustment(enhance=True)))
        >= 2 * _contrast(picture)
        > 0
    )


def test_a_faint_line_beside_boards_becomes_clear_too():
    picture = _faint_line(GRASS, 14)
    boards = np.array([(0, 0), (959, 0), (959, 310), (0, 160)])  # 20 px above the line
    cv2.fillPoly(picture, [boards], (200, 40, 30, 255))
    assert _contrast(adjust_image(picture, DisplayAdjustment(enhance=True))) >= 1.8 * _contrast(
        picture
    )


def test_a_line_comes_out_in_its_place_and_no_wider():
    picture = _faint_line(GRASS, 20, 5)
    shown = adjust_image(picture, DisplayAdjustment(enhance=True))

    def profile(pixels: PixelArray) -> np.ndarray:
        light = cv2.cvtColor(pixels, cv2.COLOR_BGRA2GRAY).astype(float)
        x = np.arange(100, 860)
        y = 180 + np.rint(x * 150 / 959).astype(int)
        across = np.array([light[y + d, x].mean() for d in range(-10, 11)])
        return np.clip(across - across[[0, 1, 2, -3, -2, -1]].mean(), 0, None)

    offsets = np.arange(-10, 11)
    before, after = profile(picture), profile(shown)
    centres = [float((p * offsets).sum() / p.sum()) for p in (before, after)]
    widths = [float((p > p.max() / 2).sum()) for p in (before, after)]
    assert centres[1] == pytest.approx(centres[0], abs=0.1)
    assert widths[1] <= widths[0] + 1


def test_what_differs_much_already_is_left_almost_alone():
    checks = np.kron(np.indices((30, 40)).sum(axis=0) % 2, np.ones((8, 8))) * 100 + 80
    picture = np.full((240, 320, 4), 255, dtype=np.uint8)
    picture[..., :3] = checks[..., None]
    shown = adjust_image(picture, DisplayAdjustment(enhance=True)).astype(int)
    assert np.abs(shown - picture).mean() < 12


@pytest.mark.parametrize(
    "values",
    [
        {"brightness": 1.1},
        {"contrast": -2.0},
        {"gamma": 0.0},
        {"gamma": 6.0},
        {"brightness": float("nan")},
    ],
)
def test_values_beyond_their_range_are_refused(values):
    with pytest.raises(ValueError, match="expected"):
        DisplayAdjustment(**values)


# Pictures made smaller: as they are when made at once, and ready when they were foreseen.


def picture(seed: int) -> PixelArray:
    return np.random.default_rng(seed).integers(0, 255, (90, 160, 4), dtype=np.uint8)


def test_what_was_foreseen_is_there_and_is_what_would_be_made():
    pictures, first, second = DownscaledImages(), picture(1), picture(2)
    pictures.foresee(first)  # nobody knows how small yet
    assert pictures.of(first, 0.4).shape == (36, 64, 4)
    pictures.foresee(second)
    small = pictures.of(second, 0.4)
    assert pictures.of(second, 0.4) is small
    np.testing.assert_array_equal(small, downscaled(second, (64, 36)))


def test_another_size_or_picture_is_made_anew():
    pictures, first = DownscaledImages(), picture(1)
    assert pictures.of(first, 0.4).shape == (36, 64, 4)
    assert pictures.of(first, 0.7).shape == (63, 112, 4)
    np.testing.assert_array_equal(pictures.of(picture(3), 0.7), downscaled(picture(3), (112, 63)))


def test_only_a_few_are_kept():
    pictures, first = DownscaledImages(), picture(1)
    small = pictures.of(first, 0.4)
    others = [picture(seed) for seed in range(2, 8)]
    for other in others:
        pictures.of(other, 0.4)
    assert pictures.of(first, 0.4) is not small


def test_thin_lines_stay_below_a_half():
    line = np.zeros((90, 160, 4), dtype=np.uint8)
    line[:, 77] = 255
    assert downscaled(line, (40, 22))[..., 0].max(axis=1).min() > 40


def test_what_is_looked_at_stays_while_others_are_foreseen():
    pictures, first = DownscaledImages(), picture(1)
    small = pictures.of(first, 0.4)
    for seed in range(2, 9):
        pictures.foresee(picture(seed))
    np.testing.assert_array_equal(small, downscaled(first, (64, 36)))
    later = picture(9)
    np.testing.assert_array_equal(pictures.of(later, 0.4), downscaled(later, (64, 36)))


# Going back is instant, memory stays bounded, and threads do not trip over each other.

PICTURE_BYTES = 20 * 10 * 4


@pytest.fixture
def pictures(tmp_path) -> list[Path]:
    paths = []
    for i in range(5):
        path = tmp_path / f"{i}.png"
        cv2.imwrite(str(path), np.full((10, 20, 3), i, dtype=np.uint8))
        paths.append(path)
    return paths


@pytest.fixture
def cache() -> Iterator[FrameCache]:
    cache = FrameCache(3 * PICTURE_BYTES, kept_at_least=1)
    yield cache
    cache.close()


@pytest.fixture
def decoded(monkeypatch) -> list[Path]:
    """The paths that were decoded, in order."""
    paths: list[Path] = []

    def decode(path: Path) -> PixelArray:
        paths.append(path)
        return decode_bgra(path)

    monkeypatch.setattr(cache_module, "decode_bgra", decode)
    return paths


def _wait_for(cache: FrameCache, path: Path) -> None:
    deadline = time.monotonic() + 60
    while cache.peek(path) is None:
        assert time.monotonic() < deadline, f"{path.name} was not prefetched"
        threading.Event().wait(0.001)


def test_a_picture_is_decoded_once(cache, pictures, decoded):
    assert cache.peek(pictures[0]) is None
    first = cache.get(pictures[0])
    assert cache.get(pictures[0]) is first
    assert cache.peek(pictures[0]) is first
    assert decoded == pictures[:1]


def test_the_least_recently_used_picture_leaves_first(cache, pictures):
    for path in pictures[:3]:
        cache.get(path)
    cache.get(pictures[0])
    cache.get(pictures[3])
    assert cache.peek(pictures[1]) is None
    assert cache.peek(pictures[0]) is not None
    assert cache.used_bytes == 3 * PICTURE_BYTES


def test_the_newest_pictures_are_kept_even_if_they_exceed_the_limit(pictures):
    cache = FrameCache(10, kept_at_least=2)
    for path in pictures[:3]:
        cache.get(path)
    assert cache.peek(pictures[0]) is None
    assert cache.peek(pictures[1]) is not None
    assert cache.peek(pictures[2]) is not None
    assert cache.used_bytes == 2 * PICTURE_BYTES
    cache.close()


def test_prefetched_pictures_are_there_without_asking(cache, pictures, decoded):
    cache.prefetch([pictures[1], pictures[1], pictures[2]])
    _wait_for(cache, pictures[2])
    assert decoded == [pictures[1], pictures[2]]
    cache.get(pictures[1])
    assert decoded == [pictures[1], pictures[2]]


def test_prefetching_passes_over_damaged_pictures(cache, pictures, tmp_path):
    broken = tmp_path / "broken.png"
    broken.write_bytes(b"nothing")
    cache.prefetch([broken, pictures[0]])
    _wait_for(cache, pictures[0])
    with pytest.raises(ImageError):
        cache.get(broken)
    cv2.imwrite(str(broken), np.zeros((4, 4, 3), dtype=np.uint8))
    assert cache.get(broken).shape == (4, 4, 4)


def test_asking_for_a_picture_on_its_way_waits_for_it(cache, pictures, monkeypatch):
    started, go_on = threading.Event(), threading.Event()
    decoded: list[Path] = []

    def slow(path: Path) -> PixelArray:
        decoded.append(path)
        started.set()
        assert go_on.wait(5)
        return decode_bgra(path)

    monkeypatch.setattr(cache_module, "decode_bgra", slow)
    cache.prefetch(pictures[:1])
    assert started.wait(5)
    results: list[PixelArray] = []
    thread = threading.Thread(target=lambda: results.append(cache.get(pictures[0])))
    thread.start()
    go_on.set()
    thread.join(5)
    assert results[0].shape == (10, 20, 4)
    assert decoded == pictures[:1]


def test_a_closed_cache_holds_nothing_but_still_reads(cache, pictures):
    cache.prefetch(pictures)
    cache.close()
    cache.prefetch(pictures)
    assert cache.used_bytes == 0
    assert cache.get(pictures[0]).shape == (10, 20, 4)
    assert cache.used_bytes == 0


def test_a_picture_that_was_replaced_is_read_again(cache, pictures, decoded):
    cache.get(pictures[0])
    cv2.imwrite(str(pictures[0]), np.zeros((4, 6, 3), dtype=np.uint8))
    assert cache.get(pictures[0]).shape == (4, 6, 4)
    assert cache.used_bytes == 4 * 6 * 4
    pictures[0].unlink()  # or out of reach
    assert cache.get(pictures[0]).shape == (4, 6, 4)
    assert decoded == [pictures[0]] * 2
