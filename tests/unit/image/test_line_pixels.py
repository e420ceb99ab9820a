"""The paint of a whole picture, and the ground it lies on."""

import cv2
import numpy as np
import pytest

from procc_annotator.image.line_pixels import LinePixels, detect_line_pixels, field_mask
from procc_annotator.image.line_profiles import straighten_curve

SIZE = (960, 540)
GRASS, PAINT = (50, 130, 60), (225, 230, 228)


def _grass() -> np.ndarray:
    picture = np.empty((SIZE[1], SIZE[0], 3), dtype=np.uint8)
    picture[:] = GRASS
    # A crowd above: every pixel another colour.
    crowd = np.random.default_rng(1).integers(0, 255, (140, SIZE[0], 3))
    picture[:140] = crowd.astype(np.uint8)
    return picture


def _beside(found: LinePixels, first: tuple[float, float], last: tuple[float, float]) -> np.ndarray:
    """(N,) px across from the paint that was found to a line."""
    way = np.subtract(last, first) / np.hypot(*np.subtract(last, first))
    apart = found.points - np.array(first)[:, None]
    return np.abs(way[0] * apart[1] - way[1] * apart[0])


def test_a_line_is_found_at_its_middle_with_its_direction():
    picture = _grass()
    cv2.line(picture, (100, 200), (800, 480), PAINT, 3, cv2.LINE_AA)
    found = detect_line_pixels(picture)
    assert found.points.shape[1] > 500
    assert np.median(_beside(found, (100, 200), (800, 480))) < 0.3
    off = np.abs(found.along - np.arctan2(280, 700))
    assert np.percentile(off, 95) < 0.05  # at its ends it may turn
    assert found.on_ground.mean() > 0.95


def test_the_same_place_in_a_larger_picture():
    picture = _grass()
    cv2.line(picture, (100, 200), (800, 480), PAINT, 3, cv2.LINE_AA)
    larger = cv2.resize(picture, (1920, 1080), interpolation=cv2.INTER_LINEAR)
    found = detect_line_pixels(np.asarray(larger, dtype=np.uint8))
    assert found.size == (1920, 1080)
    assert np.median(_beside(found, (200.5, 400.5), (1600.5, 960.5))) < 0.6


def test_the_edge_of_a_mown_stripe_is_no_paint():
    picture = _grass()
    picture[300:] = (70, 160, 80)
    assert not detect_line_pixels(picture).points.shape[1]


def test_what_does_not_go_on_is_no_paint():
    picture = _grass()
    for x in range(100, 900, 60):
        cv2.line(picture, (x, 300), (x + 14, 300), PAINT, 3, cv2.LINE_AA)
    assert not detect_line_pixels(picture).points.shape[1]


def test_dark_paint_is_found_where_it_is_asked_for():
    picture = np.full((SIZE[1], SIZE[0], 3), 220, dtype=np.uint8)
    cv2.line(picture, (100, 200), (800, 480), (60, 60, 200), 4, cv2.LINE_AA)
    assert not detect_line_pixels(picture).points.shape[1]
    assert detect_line_pixels(picture, light=False, dark=True).points.shape[1] > 500


def test_the_ground_is_what_is_smooth_and_large_with_players_on_it():
    picture = _grass()
    cv2.rectangle(picture, (400, 300), (420, 350), (30, 30, 200), -1)
    ground = field_mask(picture)
    assert ground.shape == (180, 320)
    assert not ground[:40].any()
    assert ground[55:].all()


def test_noise_has_no_ground():
    crowd = np.random.default_rng(2).integers(0, 255, (540, 960, 3))
    assert not field_mask(crowd.astype(np.uint8)).any()


def _court() -> np.ndarray:
    """A court in a larger floor of another colour, with a lighter line between them; a dark hall
    above and below."""
    picture = np.full((SIZE[1], SIZE[0], 3), (40, 36, 34), dtype=np.uint8)
    picture[60:500] = (122, 112, 34)
    cv2.rectangle(picture, (300, 150), (1000, 420), (52, 108, 204), -1)
    cv2.rectangle(picture, (300, 150), (1000, 420), PAINT, 3, cv2.LINE_AA)
    cv2.line(picture, (600, 150), (600, 420), PAINT, 3, cv2.LINE_AA)
    return picture


def test_a_floor_has_the_colours_that_lines_part_and_no_others():
    ground = detect_line_pixels(_court(), floor=True).ground > 0
    assert ground[24:160].mean() > 0.97  # court and what is around it
    assert not ground[:15].any()
    assert not ground[172:].any()


def test_a_line_between_two_colours_of_a_floor_lies_on_it():
    found = detect_line_pixels(_court(), floor=True)
    side = np.abs(found.points[1] - 150) < 2
    assert side.sum() > 400
    assert found.on_ground[side].all()


def test_a_floor_begins_where_paint_is():
    picture = np.full((SIZE[1], SIZE[0], 3), (60, 58, 56), dtype=np.uint8)
    cv2.rectangle(picture, (0, 100), (960, 330), (236, 234, 230), -1)  # ice, less than half
    for x in (200, 400, 600):
        cv2.line(picture, (x, 100), (x, 330), (60, 60, 200), 3, cv2.LINE_AA)
    ground = detect_line_pixels(picture, light=False, dark=True, floor=True).ground > 0
    assert ground[38:105].mean() > 0.95
    assert not ground[120:].any()


def test_edges_between_areas_of_a_floor_are_found_where_they_may_be_lines():
    picture = np.full((SIZE[1], SIZE[0], 3), (110, 170, 205), dtype=np.uint8)
    cv2.rectangle(picture, (300, 180), (700, 360), (160, 90, 20), -1)  # a painted key
    cv2.circle(picture, (150, 300), 30, (60, 60, 220), -1)  # a player's shirt
    args = {"light": True, "dark": True, "floor": True}
    found = detect_line_pixels(picture, **args, edges=True).points
    level = np.abs(found[1] - 180) < 1.5
    assert level.sum() > 350
    assert found.shape[1] > 1000
    assert (np.hypot(found[0] - 150, found[1] - 300) > 40).all()
    assert detect_line_pixels(picture, **args).points.shape[1] < 100


def test_most_of_a_woods_grain_is_no_paint_where_paint_may_be_lighter_or_darker():
    random = np.random.default_rng(3)
    picture = np.full((SIZE[1], SIZE[0], 3), (88, 138, 182), dtype=np.uint8)
    for x, y, long in random.uniform((0, 0, 40), (*SIZE, 120), (2500, 3)).astype(int):
        cv2.line(picture, (x, y), (x + long, y + long // 9), (96, 146, 190), 2, cv2.LINE_AA)
    cv2.line(picture, (100, 200), (800, 480), PAINT, 3, cv2.LINE_AA)

    def on_line(light: bool, dark: bool) -> np.ndarray:
        found = detect_line_pixels(picture, light=light, dark=dark, floor=True)
        return _beside(found, (100, 200), (800, 480)) < 2

    grain = (~on_line(light=True, dark=False)).sum() + (~on_line(light=False, dark=True)).sum()
    both = on_line(light=True, dark=True)
    assert both.sum() > 400
    assert (~both).sum() < 0.6 * grain


def test_a_wide_line_is_found_at_its_middle_where_lines_may_be_wide():
    picture = np.full((SIZE[1], SIZE[0], 3), 220, dtype=np.uint8)
    cv2.line(picture, (100, 200), (800, 480), (160, 85, 35), 15, cv2.LINE_AA)
    cv2.line(picture, (100, 400), (600, 500), (60, 60, 200), 3, cv2.LINE_AA)

    def middle(wide: bool) -> int:
        found = detect_line_pixels(picture, light=False, dark=True, floor=True, wide=wide)
        return int((_beside(found, (100, 200), (800, 480)) < 1).sum())

    assert middle(wide=False) < 20
    assert middle(wide=True) > 150


# The surroundings of a curve, cut out of a picture.


def ramp(width: int = 60, height: int = 40) -> np.ndarray:
    """Blue tells x, green tells y."""
    picture = np.zeros((height, width, 4), dtype=np.uint8)
    picture[..., 0] = np.arange(width)[None]
    picture[..., 1] = np.arange(height)[:, None]
    picture[..., 2], picture[..., 3] = 200, 255
    return picture


def test_rows_are_places_and_columns_offsets():
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


def test_beyond_the_picture_its_edge_goes_on():
    course = np.array([[30.0, 1.0], [31.0, 0.0], [32.0, -1.0]])
    strip = straighten_curve(ramp(), course, np.tile([0.0, 1.0], (3, 1)), 4.0)
    assert strip.colours[1, :, 1] == pytest.approx(np.maximum(strip.offsets_px, 0.0), abs=0.55)
    far = straighten_curve(ramp(), course + 500.0, np.tile([0.0, 1.0], (3, 1)), 2.0)
    assert far.colours[..., :2].min(axis=(0, 1)) == pytest.approx([59.0, 39.0])


def test_columns_stay_inside():
    strip = straighten_curve(
        ramp(), np.array([[20.0, 20.0], [21.0, 20.0]]), np.tile([0, 1], (2, 1)), 3.0
    )
    assert len(strip.offsets_px[strip.columns(-9.0, -8.0)]) == 1
    assert strip.offsets_px[strip.columns(-1.0, 1.0)] == pytest.approx([-1, -0.5, 0, 0.5, 1])
