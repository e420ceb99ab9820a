"""A line is seen along its course whatever its colour and its ground's; what hides it is not."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from procc_annotator.assist.visible_line import BESIDE_PX, runs_seen
from procc_annotator.image.line_profiles import straighten_curve
from procc_annotator.image.pixels import PixelArray

SIZE = (400, 120)
BEGIN, END, LEVEL = 40, 360, 60
HIDDEN = (180, 220)
COURSE = np.column_stack([np.arange(BEGIN, END), np.full(END - BEGIN, float(LEVEL))])
ACROSS = np.tile([0.0, 1.0], (len(COURSE), 1))
HITS = np.array([10, 40, 70, 100, 200, 240, 280, 310])
WOOD, BLACK, ICE, RED, GRASS, WHITE = (
    (130, 190, 220),
    (40, 40, 45),
    (225, 215, 210),
    (90, 80, 190),
    (60, 120, 70),
    (235, 240, 238),
)
SHIRT = (180, 60, 40)


def picture(ground: tuple[int, ...], paint: tuple[int, ...], below: tuple[int, ...]) -> PixelArray:
    """A line over a ground (or the edge of another one below it), a player before its middle."""
    pixels = np.full((SIZE[1], SIZE[0], 3), ground, dtype=np.uint8)
    pixels[LEVEL + 1 :] = below
    if below == ground:
        pixels[LEVEL - 1 : LEVEL + 2] = paint
    pixels[LEVEL - 30 : LEVEL + 30, HIDDEN[0] : HIDDEN[1]] = SHIRT
    blurred = cv2.GaussianBlur(pixels, (0, 0), 0.8).astype(np.float64)
    noisy = blurred + np.random.default_rng(3).normal(0, 2, pixels.shape)
    return np.dstack(
        [np.clip(noisy, 0, 255).astype(np.uint8), np.full(SIZE[::-1], 255, dtype=np.uint8)]
    )


@pytest.mark.parametrize(
    ("ground", "paint"),
    [(WOOD, BLACK), (ICE, RED), (GRASS, WHITE)],
    ids=["black on wood", "red on ice", "white on grass"],
)
def test_a_line_of_any_colour_is_seen_but_where_it_is_hidden(ground, paint) -> None:
    strip = straighten_curve(picture(ground, paint, ground), COURSE, ACROSS, BESIDE_PX)
    runs = runs_seen(strip, HITS, on_ground=True)
    assert len(runs) == 2
    assert runs[0] == pytest.approx((0, HIDDEN[0] - BEGIN), abs=4)
    assert runs[1] == pytest.approx((HIDDEN[1] - BEGIN, END - BEGIN), abs=4)


def test_the_edge_of_an_area_is_seen_but_where_it_is_hidden() -> None:
    strip = straighten_curve(picture(ICE, RED, (90, 190, 210)), COURSE, ACROSS, BESIDE_PX)
    runs = runs_seen(strip, HITS, on_ground=True, edge=True)
    assert len(runs) == 2
    assert runs[0][1] == pytest.approx(HIDDEN[0] - BEGIN, abs=4)
    assert runs[1][0] == pytest.approx(HIDDEN[1] - BEGIN, abs=4)


def test_bare_ground_shows_no_line() -> None:
    strip = straighten_curve(picture(WOOD, WOOD, WOOD), COURSE, ACROSS, BESIDE_PX)
    assert runs_seen(strip, HITS, on_ground=True) == ()
