"""Ghosts as curves in their bands; the current one stands out and says what it is."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.calibration.prediction.ghosts import Ghost, GhostPiece
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.overlay_predictions import (
    build_ghosts,
    ghost_extent,
    nearest_ghost,
)

ACROSS = np.column_stack((np.linspace(100, 300, 21), np.full(21, 50.0)))
LEVEL = Ghost("Side line top", (GhostPiece(ACROSS, np.full(21, 1.5)),))
PARTS = Ghost(
    "Middle line",
    (
        GhostPiece(np.array([[10.0, 10], [10, 20]]), np.array([0.5, 1.0])),
        GhostPiece(np.array([[10.0, 40], [10, 80], [10, 120]]), np.array([1.0, 1.0, 2.0])),
    ),
)


def test_the_curve_is_dash_dot_on_a_rim_and_pieces_are_not_joined() -> None:
    overlay = build_ghosts([LEVEL, PARTS])
    rim, line = overlay.strokes
    assert (line.colour, line.dash) == (tones.GHOST, tones.GHOST_DASH)
    assert len(line.dash) == 4
    assert rim.width > line.width
    assert len(line.segments) == 20 + 1 + 2
    lengths = np.hypot(*(line.segments[:, 2:] - line.segments[:, :2]).T)
    assert lengths.max() == pytest.approx(40.0)
    assert not overlay.marks
    assert not overlay.labels


def test_the_band_reaches_two_standard_deviations_to_both_sides() -> None:
    (patch,) = build_ghosts([LEVEL]).patches
    assert set(np.round(patch.outline[:, 1], 9)) == {47.0, 53.0}
    assert patch.outline[:, 0].min() == 100
    assert patch.outline[:, 0].max() == 300
    first, second = build_ghosts([PARTS]).patches
    assert np.ptp(first.outline[[1, 2], 0]) == pytest.approx(4 * 1.0)
    assert np.ptp(second.outline[[2, 3], 0]) == pytest.approx(4 * 2.0)


def test_the_current_one_is_stronger_named_and_shows_its_points() -> None:
    points = np.array([[110.0, 50.0], [200.0, 50.0]])
    overlay = build_ghosts(
        [LEVEL, PARTS], current=PARTS, label="Halfway line  ±2.0 px", points_px=points
    )
    _, faint, _, strong = overlay.strokes
    assert strong.width > faint.width
    assert strong.colour == faint.colour
    assert len(strong.segments) == 3
    assert len(faint.segments) == 20
    (marks,) = overlay.marks
    assert np.array_equal(marks.centres, points)
    (labels,) = overlay.labels
    assert labels.texts == ("Halfway line  ±2.0 px",)
    assert labels.positions[0].tolist() == [10.0, 80.0]  # of the longest stretch
    assert overlay.patches[-1].opacity > overlay.patches[0].opacity


def test_a_course_with_a_point_twice_has_a_band_all_the_same() -> None:
    course = np.array([[0.0, 0], [5, 0], [5, 0], [5, 0], [9, 0]])
    (patch,) = build_ghosts([Ghost("x", (GhostPiece(course, np.ones(5)),))]).patches
    assert np.isfinite(patch.outline).all()


def test_extent_is_that_of_all_pieces() -> None:
    assert ghost_extent(PARTS) == (10, 10, 10, 120)


@pytest.mark.parametrize(
    ("position", "found"),
    [
        ((205.0, 53.0), "Side line top"),  # between two points of the course
        ((12.0, 60.0), "Middle line"),
        ((12.0, 30.0), None),  # in the gap
        ((205.0, 70.0), None),
    ],
)
def test_what_lies_under_the_cursor(position, found) -> None:
    assert nearest_ghost([LEVEL, PARTS], position, 5.0) == found


def test_a_dense_curve_is_drawn_with_few_points_and_hardly_off() -> None:
    angle = np.linspace(0, np.pi, 4000)
    course = 30 * np.column_stack((np.cos(angle), np.sin(angle)))
    overlay = build_ghosts([Ghost("Circle left", (GhostPiece(course, np.ones(4000)),))])
    segments = overlay.strokes[-1].segments
    assert len(segments) < 40
    assert np.allclose(segments[[0, -1]][[0, 1], [0, 2]], course[[0, -1], 0])
    middles = (segments[:, :2] + segments[:, 2:]) / 2
    assert np.abs(np.hypot(*middles.T) - 30).max() < 0.1
