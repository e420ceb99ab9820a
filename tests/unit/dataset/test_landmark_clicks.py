"""What triangulated positions may be written over: never what somebody surveyed."""

from __future__ import annotations

import pytest

from procc_annotator.calibration.triangulation import Triangulation
from procc_annotator.dataset.landmarks.clicks import (
    ClickedLandmark,
    LocatedLandmark,
    why_kept,
    with_positions,
)
from procc_annotator.field.model import Landmark
from procc_annotator.formats.landmark_file import LandmarkFile

PLACE = (1.0, 2.0, -3.0)


def found(name: str, instant: str | None = None) -> LocatedLandmark:
    return LocatedLandmark(ClickedLandmark(name, instant), Triangulation(position=PLACE))


@pytest.mark.parametrize(
    ("known", "instant"),
    [
        (Landmark("Mast", position=(9.0, 9.0, -9.0)), None),
        # It was to be made one that moves: the place that was measured is all there is to know.
        (Landmark("Mast", position=(9.0, 9.0, -9.0)), "17"),
        (Landmark("Mast", position=(9.0, 9.0, -9.0), moving=True, instant="17"), "17"),
        (Landmark("Mast ", position=(9.0, 9.0, -9.0)), None),
        (Landmark("Mast", moving=True), None),
    ],
)
def test_surveyed_places_and_moving_objects_are_left_alone(known, instant) -> None:
    file = LandmarkFile((known,))
    assert why_kept(file, "Mast", instant)
    assert with_positions(file, [found("Mast", instant)]) == file


def test_what_was_triangulated_or_is_not_known_is_placed() -> None:
    old = Landmark("Mast", position=(9.0, 9.0, -9.0), surveyed=False, note="high")
    ball = Landmark("Ball", moving=True)
    there = Landmark("Ball", position=(4.0, 4.0, 0.0), instant="16")
    file = LandmarkFile((old, ball, there))
    located = [found("Mast"), found("Clock"), found("Ball", "17"), found("Ball", "16")]
    placed = {(m.name, m.instant): m for m in with_positions(file, located).landmarks}
    assert not why_kept(file, "Ball", "17")
    assert placed["Mast", None].position == PLACE
    assert placed["Mast", None].note == "high"
    assert (placed["Clock", None].position, placed["Clock", None].surveyed) == (PLACE, False)
    assert placed["Ball", None] == ball
    assert placed["Ball", "17"].position == PLACE
    assert placed["Ball", "16"] == there
