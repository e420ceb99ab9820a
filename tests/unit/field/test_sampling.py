"""Sampling: the official spacing with its quirks, even spacing, and the symmetry of the field."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.field.geometry import Circle, Line, middle_of, points_at_angles
from procc_annotator.field.load import load_field
from procc_annotator.field.sampling import sample_evenly, sample_official


def test_official_sampling_of_a_straight_element() -> None:
    field = load_field()
    points = sample_official(field).of(field.index["Goal left crossbar"])
    length = 7.32
    gaps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert len(points) == int(length / 0.9 - 1) + 2
    np.testing.assert_allclose(gaps[:-1], 0.9)
    assert 0.9 <= gaps[-1] < 1.8
    np.testing.assert_allclose(points[0], (-52.5, -3.66, -2.44))
    np.testing.assert_allclose(points[-1], (-52.5, 3.66, -2.44))


def test_official_sampling_of_the_circles() -> None:
    field = load_field()
    samples = sample_official(field)
    circle = samples.of(field.index["Circle central"])
    assert len(circle) == int(2 * math.pi * 9.15 / 0.2)
    np.testing.assert_allclose(circle[0], (9.15, 0, 0))
    assert not np.allclose(circle[0], circle[-1])
    arc = samples.of(field.index["Circle left"])
    half = math.acos(5.5 / 9.15)
    assert len(arc) == int(2 * half * 9.15 / 0.2) + 2
    assert arc[0, 1] < 0 < arc[-1, 1]
    np.testing.assert_allclose(arc[[0, -1], 0], -36.0)
    right = samples.of(field.index["Circle right"])
    assert right[0, 1] > 0 > right[-1, 1]


def test_the_official_elements_are_1187_points() -> None:
    field = load_field()
    samples = sample_official(field)
    official = sum(not e.optional for e in field.elements)
    assert samples.offsets[official] == 1187
    assert samples.offsets[-1] == len(samples.points_world) > 1187


@given(st.floats(0.05, 20))
def test_even_sampling_keeps_ends_and_closes_circles(spacing) -> None:
    field = load_field()
    samples = sample_evenly(field, spacing)
    for i, element in enumerate(field.elements):
        points = samples.of(i)
        if element.is_spot:
            assert points.tolist() == [list(middle_of(element.geometry))]
            continue
        gaps = np.linalg.norm(np.diff(points, axis=0), axis=1)
        assert gaps.max() <= spacing * (1 + 1e-9)
        np.testing.assert_allclose(gaps, gaps[0], rtol=1e-6)
        if isinstance(element.geometry, Line):
            assert tuple(points[0]) == element.geometry.start
            assert tuple(points[-1]) == element.geometry.end
        assert bool(samples.closed[i]) == (element.name == "Circle central")
    circle = samples.of(field.index["Circle central"])
    assert (circle[0] == circle[-1]).all()


@given(length=st.floats(90.1, 120), width=st.floats(45, 90))
def test_the_symmetry_maps_the_field_onto_itself(length, width) -> None:
    field = load_field("soccer", length=length, width=width)
    samples = sample_evenly(field, 0.5)
    for i, element in enumerate(field.elements):
        partner = field.symmetries[0].name_of(element.name)
        assert field.symmetries[0].name_of(partner) == element.name
        turned = samples.of(i) * (-1, -1, 1)
        target = samples.of(field.index[partner])
        distances = np.linalg.norm(turned[:, None] - target[None], axis=2).min(axis=1)
        assert distances.max() < 1e-6 if element.is_straight else distances.max() < 0.26


@pytest.mark.parametrize("spacing", [0, -1, math.nan, math.inf])
def test_a_senseless_spacing_is_refused(spacing) -> None:
    with pytest.raises(ValueError, match="positive spacing"):
        sample_evenly(load_field(), spacing)


def test_a_rim_is_round_even_at_the_official_spacing() -> None:
    field = load_field("basketball_fiba")
    rim = sample_official(field).of(field.index["Rim left"])
    geometry = field.elements[field.index["Rim left"]].geometry
    assert isinstance(geometry, Circle)
    circle = points_at_angles(geometry, np.linspace(0, 2 * math.pi, 721))
    apart = np.linalg.norm(circle[:, None] - rim[None], axis=2).min(axis=1)
    assert apart.max() < 0.025
