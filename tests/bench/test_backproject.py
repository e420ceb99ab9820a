"""How long the way back to the ground takes for a picture's worth of pixels."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.models import FisheyeCamera, PinholeCamera

BASE = (0.1, 1.28, 0.01, (2.0, 60.0, -15.0), (1400.0, 1410.0), (640.0, 360.0))
CAMERAS = {
    "plain": PinholeCamera(*BASE),
    "radial": PinholeCamera(*BASE, (0.2, -0.05, 0.0, 0.0, 0.0, 0.0)),
    "tangential": PinholeCamera(*BASE, (0.2, -0.05, 0.0, 0.0, 0.0, 0.0), (0.002, -0.001)),
    "fisheye": FisheyeCamera(*BASE, (0.02, -0.01, 0.003, -0.001)),
}


@pytest.mark.parametrize("name", CAMERAS)
def test_a_grid_of_320_by_180_pixels(benchmark: Any, name: str) -> None:
    x, y = np.meshgrid(np.linspace(0, 1279, 320), np.linspace(0, 719, 180))
    px = np.column_stack((x.ravel(), y.ravel()))
    ground = benchmark(ground_from_px, CAMERAS[name], px)
    assert np.isfinite(ground).all(axis=1).mean() > 0.9
    assert benchmark.stats.stats.min < 0.015
