"""The tones of maps in metres: ordered for everybody, and none of them grass."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from procc_annotator.interact.map_looks import DISAGREEMENT, UNCERTAINTY, MapLook

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


def linear(colour: str) -> np.ndarray:
    srgb = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def over(colour: str, opacity: float, ground: str) -> np.ndarray:
    """Linear sRGB of a tone on a ground, mixed as painters do: in sRGB."""
    parts = [
        opacity * int(colour[i : i + 2], 16) + (1 - opacity) * int(ground[i : i + 2], 16)
        for i in (1, 3, 5)
    ]
    return linear("#" + "".join(f"{round(p):02x}" for p in parts))


def lightness(rgb: np.ndarray) -> float:
    """CIE L*, 0 to 100."""
    y = float(np.clip(rgb, 0, 1) @ (0.2126, 0.7152, 0.0722))
    return 116 * y ** (1 / 3) - 16 if y > 0.008856 else 903.3 * y


@pytest.mark.parametrize("look", [DISAGREEMENT, UNCERTAINTY], ids=lambda look: look.name)
class TestMapLooks:
    def test_a_tone_a_band(self, look: MapLook) -> None:
        assert len(look.colours) == len(look.levels_m) - 1

    def test_lines_are_at_levels_and_need_no_colour(self, look: MapLook) -> None:
        assert {line.metres for line in look.lines} <= set(look.levels_m)
        assert len({line.dash for line in look.lines}) == len(look.lines)

    @pytest.mark.parametrize("ground", GRASS)
    @pytest.mark.parametrize("eyes", SEEN_BY)
    def test_more_is_darker_for_every_eye(self, look: MapLook, eyes: str, ground: str) -> None:
        found = [lightness(SEEN_BY[eyes] @ over(c, look.opacity, ground)) for c in look.colours]
        steps = [light - dark for light, dark in itertools.pairwise(found)]
        assert min(steps) > 3.0, [round(v, 1) for v in found]
