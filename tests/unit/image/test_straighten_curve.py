"""The surroundings of a curve, cut out of a picture."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.image.line_profiles import straighten_curve


def ramp(width: int = 60, height: int = 40) -> np.ndarray:
    """Blue tells x, green tells y."""
    picture = np.zeros((height, width, 4), dtype=np.uint8)
    picture[..., 0] = np.arange(width)[None]
    picture[..., 1] = np.arange(height)[:, None]
    picture[..., 2], picture[..., 3] = 200, 255
    return picture


def test_rows_are_places_and_columns_offsets() -> None:
    angle = 0.4
    along, across = (np.cos(angle), np.sin(angle)), (-np.sin(angle), np.cos(angle))
    course = np.array([20.0, 12.0]) + np.arange(15)[:, None] * along
    strip = straighten_curve(ramp(), course, np.tile(across, (15, 1)), 5.0)
    assert strip.offsets_px == pytest.approx(np.arange(-5.0, 5.5, 0.5))
    for place, offset in ((0, 0.0), (7, -3.5), (14, 5.0)):
        expected = course[place] + offset * np.array(across)
        column = strip.columns(offset, offset)
        assert strip.colours[place, column][0, :2] == pytest.approx(expected, abs=0.55)
    assert (strip.colours[..., 2] == 200).all()


def test_beyond_the_picture_its_edge_goes_on() -> None:
    course = np.array([[30.0, 1.0], [31.0, 0.0], [32.0, -1.0]])
    strip = straighten_curve(ramp(), course, np.tile([0.0, 1.0], (3, 1)), 4.0)
    assert strip.colours[1, :, 1] == pytest.approx(np.maximum(strip.offsets_px, 0.0), abs=0.55)
    far = straighten_curve(ramp(), course + 500.0, np.tile([0.0, 1.0], (3, 1)), 2.0)
    assert far.colours[..., :2].min(axis=(0, 1)) == pytest.approx([59.0, 39.0])


def test_columns_stay_inside() -> None:
    strip = straighten_curve(
        ramp(), np.array([[20.0, 20.0], [21.0, 20.0]]), np.tile([0, 1], (2, 1)), 3.0
    )
    assert len(strip.offsets_px[strip.columns(-9.0, -8.0)]) == 1
    assert strip.offsets_px[strip.columns(-1.0, 1.0)] == pytest.approx([-1, -0.5, 0, 0.5, 1])
