"""Paint under an annotation, beside it and none, by a drawn picture."""

import cv2
import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.assist.line_evidence import line_evidence, line_evidence_by_class
from procc_annotator.assist.visible_line import BESIDE_PX, runs_seen
from procc_annotator.calibration.label_check.evidence import LinePresence
from procc_annotator.field.load import load_field
from procc_annotator.image.line_profiles import straighten_curve
from procc_annotator.image.pixels import PixelArray

FIELD = load_field("soccer")
SIZE = (960, 540)
LINE = "Side line top"


@pytest.fixture(scope="module")
def picture() -> np.ndarray:
    """Grass with a line that is hidden in its middle third, and a bent one below."""
    rng = np.random.default_rng(1)
    grass = np.full((SIZE[1], SIZE[0], 3), (60, 120, 70), dtype=np.uint8)
    cv2.line(grass, (100, 100), (900, 130), (235, 240, 238), 4, cv2.LINE_AA)
    grass[:, 400:600] = (60, 120, 70)
    x = np.arange(100, 901)
    y = 300 + 5.0 * (1 - ((x - 500) / 400.0) ** 2)
    course = np.column_stack([x, y])
    cv2.polylines(
        grass, [np.round(course * 8).astype(int)], False, (235, 240, 238), 4, cv2.LINE_AA, 3
    )
    noisy = np.clip(grass + rng.normal(0, 3, grass.shape), 0, 255).astype(np.uint8)
    return np.dstack([noisy, np.full(SIZE[::-1], 255, dtype=np.uint8)])


def clicked(*places: tuple[float, float], name: str = LINE) -> FrameAnnotation:
    points = tuple(point_from_px(x, y, SIZE) for x, y in places)
    return FrameAnnotation((Polyline(name, points),))


def test_a_hidden_stretch_is_told_from_paint(picture):
    seen = line_evidence_by_class(clicked((100, 100), (500, 115), (900, 130)), picture, FIELD)[LINE]
    hidden = (seen.places_px[:, 0] > 410) & (seen.places_px[:, 0] < 590)
    assert (seen.paint[hidden] == LinePresence.NONE).all()
    clear = (seen.places_px[:, 0] < 385) | (seen.places_px[:, 0] > 615)
    assert (seen.paint[clear] == LinePresence.UNDER).mean() > 0.9
    assert seen.missing_share == pytest.approx(0.25, abs=0.07)
    assert seen.longest_gap_px == pytest.approx(200, abs=60)


def test_bent_paint_lies_to_one_side(picture):
    seen = line_evidence_by_class(clicked((100, 300), (900, 300)), picture, FIELD)[LINE]
    assert set(seen.paint.tolist()) == {LinePresence.UNDER, LinePresence.RIGHT}
    back = line_evidence_by_class(clicked((900, 300), (100, 300)), picture, FIELD)[LINE]
    assert set(back.paint.tolist()) == {LinePresence.UNDER, LinePresence.LEFT}
    assert np.nanmax(seen.steady) == pytest.approx(5.0, abs=0.5)


def test_bare_grass_has_none_and_ends_are_looked_at_beyond(picture):
    bare = line_evidence_by_class(clicked((100, 450), (900, 470)), picture, FIELD)[LINE]
    assert bare.missing_share > 0.9
    short = line_evidence_by_class(clicked((140, 101.5), (370, 110.1)), picture, FIELD)[LINE]
    assert not short.ends_at(0, 30.0)  # it goes on to 100
    whole = line_evidence_by_class(clicked((102, 100.1), (370, 110.1)), picture, FIELD)[LINE]
    assert whole.ends_at(0, 30.0)


def test_a_post_before_a_white_board_is_not_missing_and_one_in_the_crowd_is():
    rng = np.random.default_rng(2)
    scene = rng.integers(20, 120, (SIZE[1], SIZE[0], 3)).astype(np.uint8)
    cv2.line(scene, (400, 100), (400, 300), (240, 240, 240), 7)
    scene[150:270] = 240
    picture = np.dstack([scene, np.full(SIZE[::-1], 255, dtype=np.uint8)])
    name = "Goal left post right"
    for x, most in ((400, 0.5), (460, 1.0)):
        post = clicked((x, 100), (x, 300), name=name)
        missing = line_evidence_by_class(post, picture, FIELD)[name].missing_share
        assert most - 0.5 < missing <= most


def test_one_click_beside_the_paint_of_its_neighbours_is_measured(picture):
    """Farther off than clicks are snapped, on a straight line and on a curve."""
    seen = line_evidence_by_class(
        clicked((100, 100), (200, 112.75), (300, 107.5), (400, 111.25)), picture, FIELD
    )[LINE]
    assert seen.click_offsets_px[1:3] == pytest.approx([-9.0, 0.0], abs=0.4)
    places = [(x, 300 + 5 * (1 - ((x - 500) / 400) ** 2)) for x in range(100, 901, 100)]
    places[4] = 500, 314
    seen = line_evidence_by_class(clicked(*places, name="Circle central"), picture, FIELD)
    assert seen["Circle central"].click_offsets_px[3:6] == pytest.approx([0, -9, 0], abs=0.5)


def test_what_did_not_change_is_not_looked_at_again(picture, monkeypatch):
    first = clicked((100, 100), (900, 130))
    known = line_evidence(first, picture, FIELD)
    both = FrameAnnotation((*first.polylines, *clicked((100, 300), (900, 300), name="Middle line")))
    again = line_evidence(both, picture, FIELD, known)
    assert again[first.polylines[0]] is known[first.polylines[0]]
    assert len(again) == 2


def test_spots_unknown_classes_and_single_clicks_are_left_out(picture):
    for name, places in (
        ("Penalty mark left", ((200, 200), (300, 200))),
        ("Line unknown", ((200, 200), (300, 200))),
        (LINE, ((200, 200),)),
        (LINE, ((200, 200), (200, 200))),
        (LINE, ((-500, 200), (-300, 200))),
    ):
        assert line_evidence(clicked(*places, name=name), picture, FIELD) == {}


# A line is seen along its course whatever its colour and its ground's; what hides it is not.

PATCH_SIZE = (400, 120)
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


def painted(ground: tuple[int, ...], paint: tuple[int, ...], below: tuple[int, ...]) -> PixelArray:
    """A line over a ground (or the edge of another one below it), a player before its middle."""
    pixels = np.full((PATCH_SIZE[1], PATCH_SIZE[0], 3), ground, dtype=np.uint8)
    pixels[LEVEL + 1 :] = below
    if below == ground:
        pixels[LEVEL - 1 : LEVEL + 2] = paint
    pixels[LEVEL - 30 : LEVEL + 30, HIDDEN[0] : HIDDEN[1]] = SHIRT
    blurred = cv2.GaussianBlur(pixels, (0, 0), 0.8).astype(np.float64)
    noisy = blurred + np.random.default_rng(3).normal(0, 2, pixels.shape)
    return np.dstack(
        [np.clip(noisy, 0, 255).astype(np.uint8), np.full(PATCH_SIZE[::-1], 255, dtype=np.uint8)]
    )


@pytest.mark.parametrize(
    ("ground", "paint"),
    [(WOOD, BLACK), (ICE, RED), (GRASS, WHITE)],
    ids=["black on wood", "red on ice", "white on grass"],
)
def test_a_line_of_any_colour_is_seen_but_where_it_is_hidden(ground, paint):
    strip = straighten_curve(painted(ground, paint, ground), COURSE, ACROSS, BESIDE_PX)
    runs = runs_seen(strip, HITS, on_ground=True)
    assert len(runs) == 2
    assert runs[0] == pytest.approx((0, HIDDEN[0] - BEGIN), abs=4)
    assert runs[1] == pytest.approx((HIDDEN[1] - BEGIN, END - BEGIN), abs=4)


def test_the_edge_of_an_area_is_seen_but_where_it_is_hidden():
    strip = straighten_curve(painted(ICE, RED, (90, 190, 210)), COURSE, ACROSS, BESIDE_PX)
    runs = runs_seen(strip, HITS, on_ground=True, edge=True)
    assert len(runs) == 2
    assert runs[0][1] == pytest.approx(HIDDEN[0] - BEGIN, abs=4)
    assert runs[1][0] == pytest.approx(HIDDEN[1] - BEGIN, abs=4)


def test_bare_ground_shows_no_line():
    strip = straighten_curve(painted(WOOD, WOOD, WOOD), COURSE, ACROSS, BESIDE_PX)
    assert runs_seen(strip, HITS, on_ground=True) == ()
