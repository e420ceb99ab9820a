"""Pinholes are told apart by what is free in them."""

from __future__ import annotations

from dataclasses import replace

import pytest

from procc_annotator.camera.models import HomographyCamera, PinholeCamera, model_name

SIZE = (960, 540)
PLAIN = PinholeCamera(0.1, 1.3, 0.0, (0.0, 60.0, -15.0), (1200.0, 1200.0), (479.5, 269.5))


@pytest.mark.parametrize(
    ("changes", "name"),
    [
        ({}, "pinhole P"),
        ({"principal_point_px": (480.0, 270.0)}, "pinhole P"),
        ({"radial": (0.1, 0.0, 0.0, 0.0, 0.0, 0.0)}, "pinhole R"),
        ({"focal_px": (1200.0, 1210.0)}, "pinhole R+"),
        ({"principal_point_px": (490.0, 269.5)}, "pinhole R+"),
        ({"radial": (0.1, 0.02, 0.0, 0.0, 0.0, 0.0)}, "pinhole R2"),
        ({"tangential": (0.001, 0.0)}, "pinhole full"),
        ({"radial": (0.1, 0.0, 0.0, 0.01, 0.0, 0.0)}, "pinhole full"),
    ],
)
def test_pinholes_are_named_as_fits_are(changes, name) -> None:
    assert model_name(replace(PLAIN, **changes), "pinhole", SIZE) == name


def test_the_name_is_the_same_at_another_size() -> None:
    camera = replace(PLAIN, principal_point_px=(639.5, 359.5))
    assert model_name(camera.scaled((1280, 720), SIZE), "pinhole", SIZE) == "pinhole P"


def test_other_models_keep_their_names() -> None:
    flat = HomographyCamera([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    assert model_name(flat, "homography", SIZE) == "homography"
