"""Bands and lines of a map: closed, complete, blank where the map is."""

from __future__ import annotations

import math

import numpy as np
import pytest

from procc_annotator.metrics.error_maps import (
    DISAGREEMENT_LEVELS_M,
    ContourBand,
    contour_lines,
    filled_contours,
)

X, Y = np.linspace(0.0, 40.0, 81), np.linspace(0.0, 20.0, 41)
GRID_X, GRID_Y = np.meshgrid(X, Y)


def area(points):
    x, y = points[:, 0], points[:, 1]
    return 0.5 * abs(float(x[:-1] @ y[1:] - x[1:] @ y[:-1]))


def area_of(band: ContourBand) -> float:
    return sum(area(p[0]) - sum(area(hole) for hole in p[1:]) for p in band.polygons)


def test_bands_of_a_slope():
    """Values are the x coordinate, so a band is a vertical stripe."""
    bands = filled_contours(GRID_X, X, Y, (0.0, 10.0, 25.0, math.inf))
    assert [(b.low, b.high) for b in bands] == [(0.0, 10.0), (10.0, 25.0), (25.0, math.inf)]
    assert [area_of(b) for b in bands] == pytest.approx([200.0, 300.0, 300.0])
    (polygon,) = bands[1].polygons
    assert polygon[0].min(axis=0).tolist() == [10.0, 0.0]
    assert polygon[0].max(axis=0).tolist() == [25.0, 20.0]


def test_polygons_are_closed_and_rings_have_holes():
    radius = np.hypot(GRID_X - 20.0, GRID_Y - 10.0)
    disc, ring, _ = filled_contours(radius, X, Y, (0.0, 3.0, 8.0, math.inf))
    assert [len(polygon) for polygon in disc.polygons] == [1]
    assert [len(polygon) for polygon in ring.polygons] == [2]
    assert area_of(disc) == pytest.approx(math.pi * 9, rel=0.02)
    assert area_of(ring) == pytest.approx(math.pi * (64 - 9), rel=0.02)
    for band in (disc, ring):
        for polygon in band.polygons:
            for outline in polygon:
                assert outline[0].tolist() == outline[-1].tolist()


def test_two_identical_cameras_fill_the_first_band():
    bands = filled_contours(np.zeros(GRID_X.shape), X, Y, DISAGREEMENT_LEVELS_M)
    assert area_of(bands[0]) == pytest.approx(800.0)
    assert all(not band.polygons for band in bands[1:])


def test_the_bands_together_are_the_map():
    rng = np.random.default_rng(1)
    values = 6.0 * np.abs(np.sin(GRID_X / 5) * np.cos(GRID_Y / 4)) + rng.uniform(0, 0.2, (41, 81))
    bands = filled_contours(values, X, Y, DISAGREEMENT_LEVELS_M)
    assert sum(map(area_of, bands)) == pytest.approx(800.0)
    assert all(band.polygons for band in bands)


def test_blank_stays_blank():
    values = GRID_X.copy()
    values[GRID_Y < 10.0] = np.nan  # as above a horizon
    bands = filled_contours(values, X, Y, (0.0, 20.0, math.inf))
    assert [area_of(b) for b in bands] == pytest.approx([200.0, 200.0])
    assert min(outline[:, 1].min() for b in bands for p in b.polygons for outline in p) >= 10.0
    (line,) = contour_lines(values, X, Y, 20.0)
    assert line[:, 1].min() >= 10.0
    assert line[:, 0] == pytest.approx(20.0)


def test_a_map_that_is_all_blank_has_no_polygon():
    blank = np.full(GRID_X.shape, np.nan)
    assert all(not b.polygons for b in filled_contours(blank, X, Y, DISAGREEMENT_LEVELS_M))
    assert contour_lines(blank, X, Y, 0.5) == ()
    assert contour_lines(np.zeros((1, 81)), X, Y[:1], 0.5) == ()


def test_a_bent_grid_as_of_the_field_map():
    """The same stripes on a sheared and stretched grid whose places are unknown where blank."""
    places_x, places_y = 2.0 * GRID_X + GRID_Y, 3.0 * GRID_Y
    values = GRID_X.copy()
    blank = GRID_Y < 5.0
    values[blank] = np.nan
    places_x[blank] = np.nan
    places_y[blank] = np.inf
    bands = filled_contours(values, places_x, places_y, (0.0, 10.0, math.inf))
    assert [area_of(b) for b in bands] == pytest.approx([10 * 15 * 6.0, 30 * 15 * 6.0])
    (line,) = contour_lines(values, places_x, places_y, 10.0)
    assert line[:, 0] - line[:, 1] / 3 == pytest.approx(20.0)
    assert line[:, 1].min() == pytest.approx(15.0)


def test_a_closed_line_repeats_its_first_point():
    radius = np.hypot(GRID_X - 20.0, GRID_Y - 10.0)
    (line,) = contour_lines(radius, X, Y, 5.0)
    assert line[0].tolist() == line[-1].tolist()
    assert np.hypot(*(line - (20.0, 10.0)).T) == pytest.approx(5.0, abs=0.02)


def test_levels_and_shapes_are_checked():
    with pytest.raises(ValueError, match="ascend"):
        filled_contours(GRID_X, X, Y, (0.0, 1.0, 1.0))
    with pytest.raises(ValueError, match="ascend"):
        filled_contours(GRID_X, X, Y, (0.0,))
    with pytest.raises(ValueError, match="shapes"):
        filled_contours(GRID_X, X[:-1], Y, (0.0, 1.0))
