"""Edits of landmarks: what the window and the command line let a hand write."""

from __future__ import annotations

import pytest

from procc_annotator.dataset.landmarks.dataset_landmarks import (
    parse_position,
    parse_surveyed,
    with_surveyed_position,
)
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Landmark
from procc_annotator.formats.landmark_file import LandmarkFile


def test_a_survey_keeps_what_else_is_known() -> None:
    mark = Landmark("Mast ", "The mast", (1.0, 1.0, 0.0), surveyed=False, frames=("a", "b"))
    (placed,) = with_surveyed_position(LandmarkFile((mark,)), "Mast", (9.0, 9.0, -9.0)).landmarks
    assert (placed.name, placed.title) == ("Mast ", "The mast")
    assert (placed.position, placed.surveyed, placed.frames) == ((9.0, 9.0, -9.0), True, ())
    assert with_surveyed_position(LandmarkFile(), "Flag", (1.0, 2.0, 0.0)).landmarks == (
        Landmark("Flag", position=(1.0, 2.0, 0.0)),
    )


def test_what_moves_is_not_surveyed_for_good() -> None:
    looks = Landmark("Ball", moving=True)
    at_17 = Landmark("Ball", position=(1.0, 2.0, -1.0), instant="17", surveyed=False)
    for file in (LandmarkFile((looks,)), LandmarkFile((at_17,)), LandmarkFile((looks, at_17))):
        with pytest.raises(UsageError, match="Ball moves"):
            with_surveyed_position(file, "Ball", (5.0, 5.0, -1.0))


def test_places_are_read_alike_everywhere() -> None:
    assert parse_surveyed(" Seat=A1 = 1; 2; -3") == ("Seat=A1", parse_position("1, 2, -3"))
    for text in ("Seat", "=1,2,3", "Seat=1,2", "Seat=a,b,c"):
        with pytest.raises(UsageError):
            parse_surveyed(text)
