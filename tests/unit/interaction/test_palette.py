"""Tones of maps in metres are ordered for everybody; those of sources are not the criterion's."""

import itertools
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.field.model import colour_difference, hex_colour, linear_rgb
from procc_annotator.interaction import palette
from procc_annotator.interaction.camera_view import (
    DISAGREEMENT,
    UNCERTAINTY,
    segments_in_sight,
    wireframe_of,
)

GRASS = ("#4F7F35", "#5F8F3F", "#3F6B3A", "#606060")

# Linear sRGB as seen without the red, the green, the blue receptor (Vienot, Brettel and Mollon
# 1999 for the first two, Brettel, Vienot and Mollon 1997 for the third, as one matrix each).
SEEN_BY = {
    "all": np.eye(3),
    "no red": np.array([[0.11238, 0.88762, 0.0], [0.11238, 0.88762, 0.0], [0.00401, -0.00401, 1]]),
    "no green": np.array(
        [[0.29275, 0.70725, 0.0], [0.29275, 0.70725, 0.0], [-0.02234, 0.02234, 1]]
    ),
    "no blue": np.array([[1.0, 0.1446, -0.1446], [0.0, 0.8592, 0.1408], [0.0, 0.8592, 0.1408]]),
}


def over(colour: str, opacity: float, ground: str) -> np.ndarray:
    """Linear sRGB of a tone on a ground, mixed as painters do: in sRGB."""
    parts = [
        opacity * int(colour[i : i + 2], 16) + (1 - opacity) * int(ground[i : i + 2], 16)
        for i in (1, 3, 5)
    ]
    return linear_rgb("#" + "".join(f"{round(p):02x}" for p in parts))


def lightness(rgb: np.ndarray) -> float:
    """CIE L*, 0 to 100."""
    y = float(np.clip(rgb, 0, 1) @ (0.2126, 0.7152, 0.0722))
    return 116 * y ** (1 / 3) - 16 if y > 0.008856 else 903.3 * y


@pytest.mark.parametrize("look", [DISAGREEMENT, UNCERTAINTY], ids=lambda look: look.name)
class TestMapLooks:
    def test_a_tone_a_band(self, look):
        assert len(look.colours) == len(look.levels_m) - 1

    def test_lines_are_at_levels_and_need_no_colour(self, look):
        assert {line.metres for line in look.lines} <= set(look.levels_m)
        assert len({line.dash for line in look.lines}) == len(look.lines)

    @pytest.mark.parametrize("ground", GRASS)
    @pytest.mark.parametrize("eyes", SEEN_BY)
    def test_more_is_darker_for_every_eye(self, look, eyes, ground):
        found = [lightness(SEEN_BY[eyes] @ over(c, look.opacity, ground)) for c in look.colours]
        steps = [light - dark for light, dark in itertools.pairwise(found)]
        assert min(steps) > 3.0, [round(v, 1) for v in found]


def as_seen(colour: str, eyes: str) -> str:
    """A colour as other eyes see it, #rrggbb."""
    return hex_colour(SEEN_BY[eyes] @ linear_rgb(colour))


class TestSources:
    @pytest.mark.parametrize(("eyes", "least"), [("all", 35), ("no red", 20), ("no green", 20)])
    @pytest.mark.parametrize("colour", [*palette.SOURCE_COLOURS, palette.FIT])
    def test_none_is_taken_for_a_tone_of_the_criterion(self, colour, eyes, least):
        """About 2 can just be seen when two tones lie side by side."""
        near = {
            word: colour_difference(as_seen(colour, eyes), as_seen(tone, eyes))
            for word, tone in palette.STATUS_COLOURS.items()
        }
        assert min(near.values()) >= least, near

    @pytest.mark.parametrize("eyes", ["all", "no red", "no green"])
    def test_they_are_told_apart(self, eyes):
        tones = [as_seen(c, eyes) for c in palette.SOURCE_COLOURS]
        assert min(colour_difference(a, b) for a, b in itertools.combinations(tones, 2)) >= 30


# What of a camera's wireframe is under the cursor.

SIZE = (1280, 720)
FIELD = load_field()
CAMERA = PinholeCamera(
    0.1, 1.3, 0.01, (2.0, 60.0, -16.0), (1500.0, 1500.0), (639.5, 359.5), (0.05, 0, 0, 0, 0, 0)
)


def at(world: tuple[float, float, float]) -> tuple[float, float]:
    x, y = CAMERA.project(np.array([world]))[0][0].tolist()
    return x, y


def test_a_corner_goes_before_the_lines_through_it():
    frame = wireframe_of(CAMERA, FIELD, SIZE)
    x, y = at((0.0, -34.0, 0.0))
    found = frame.at((x + 5.0, y + 1.0), 10.0)
    assert found.along is None
    assert found.px == pytest.approx((x, y))


def test_between_corners_it_is_the_nearest_place_of_the_nearest_line():
    frame = wireframe_of(CAMERA, FIELD, SIZE)
    world = (0.0, -20.0, 0.0)
    x, y = at(world)
    found = frame.at((x + 3.0, y), 10.0)
    assert found.name == "Middle line"
    assert abs(found.along[1]) == pytest.approx(1.0)
    px = CAMERA.project(np.array([found.world]))[0][0]
    assert found.px == pytest.approx(tuple(px))
    assert np.hypot(*(px - (x + 3.0, y))) <= 3.0
    assert found.world[0] == pytest.approx(0.0, abs=1e-9)


def test_beyond_reach_and_out_of_the_picture_there_is_nothing():
    frame = wireframe_of(CAMERA, FIELD, SIZE)
    x, y = at((0.0, -20.0, 0.0))
    assert frame.at((x + 30.0, y), 5.0) is None
    away = replace(CAMERA, pan_rad=CAMERA.pan_rad + np.pi)
    assert wireframe_of(away, FIELD, SIZE).at((600.0, 300.0), 1e4) is None
    assert segments_in_sight(away, FIELD, SIZE).shape == (0, 4)


def test_segments_follow_the_lines_in_the_picture():
    segments = segments_in_sight(CAMERA, FIELD, SIZE)
    frame = wireframe_of(CAMERA, FIELD, SIZE)
    middles = (segments[:, :2] + segments[:, 2:]) / 2
    inside = ((middles > 0) & (middles < np.array(SIZE) - 1)).all(axis=1)
    for place in middles[inside].tolist():
        assert frame.at((place[0], place[1]), 1.5) is not None
