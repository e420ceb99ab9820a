"""Pictures made smaller: as they are when made at once, and ready when they were foreseen."""

from __future__ import annotations

import numpy as np

from procc_annotator.image.pixels import DownscaledImages, PixelArray, downscaled


def picture(seed: int) -> PixelArray:
    return np.random.default_rng(seed).integers(0, 255, (90, 160, 4), dtype=np.uint8)


def test_what_was_foreseen_is_there_and_is_what_would_be_made() -> None:
    pictures, first, second = DownscaledImages(), picture(1), picture(2)
    pictures.foresee(first)  # nobody knows how small yet
    assert pictures.of(first, 0.4).shape == (36, 64, 4)
    pictures.foresee(second)
    small = pictures.of(second, 0.4)
    assert pictures.of(second, 0.4) is small
    np.testing.assert_array_equal(small, downscaled(second, (64, 36)))


def test_another_size_or_picture_is_made_anew() -> None:
    pictures, first = DownscaledImages(), picture(1)
    assert pictures.of(first, 0.4).shape == (36, 64, 4)
    assert pictures.of(first, 0.7).shape == (63, 112, 4)
    np.testing.assert_array_equal(pictures.of(picture(3), 0.7), downscaled(picture(3), (112, 63)))


def test_only_a_few_are_kept() -> None:
    pictures, first = DownscaledImages(), picture(1)
    small = pictures.of(first, 0.4)
    others = [picture(seed) for seed in range(2, 8)]
    for other in others:
        pictures.of(other, 0.4)
    assert pictures.of(first, 0.4) is not small


def test_thin_lines_stay_below_a_half() -> None:
    line = np.zeros((90, 160, 4), dtype=np.uint8)
    line[:, 77] = 255
    assert downscaled(line, (40, 22))[..., 0].max(axis=1).min() > 40


def test_what_is_looked_at_stays_while_others_are_foreseen() -> None:
    pictures, first = DownscaledImages(), picture(1)
    small = pictures.of(first, 0.4)
    for seed in range(2, 9):
        pictures.foresee(picture(seed))
    np.testing.assert_array_equal(small, downscaled(first, (64, 36)))
    later = picture(9)
    np.testing.assert_array_equal(pictures.of(later, 0.4), downscaled(later, (64, 36)))
