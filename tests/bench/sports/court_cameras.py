"""Fits to what real basketball cameras show: annotations made from them, with 1 px noise.

The pictures of these cameras are cut out of larger ones: their principal points lie anywhere, up to
1,400 px from the centre.
"""

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.camera.base import Camera
from procc_annotator.formats.cameras.published_sets import deepsportradar_records
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from tests.bench.sports.views import Views


def read_cameras(folder: Path) -> list[Camera]:
    """All cameras of a folder of DeepSportRadar."""
    found = []
    for part in ("val", "test"):
        path = folder / f"ground_truth_{part}.json"
        records = deepsportradar_records(json.loads(path.read_text("utf-8")), str(path))
        found += [records.read(frame).camera for frame in records.entries]
    return found


def fitted_back(
    views: Views,
    cameras: Sequence[Camera],
    model: str,
    *,
    clicked: Views | None = None,
    noise_px: float = 1.0,
) -> tuple[np.ndarray, np.ndarray]:
    """Median errors over the visible court, px, and JaC@5, of fits to clicks on the elements that
    cameras show; infinite and 0 where a fit finds none. The clicks may lie on another field."""
    rng = np.random.default_rng(1)
    errors, jacs = [], []
    for camera in cameras:
        annotation = (clicked or views).clicks(camera, rng, noise_px)
        found = fit_camera(annotation, views.field, model=model).camera
        errors.append(views.median_error(camera, found))
        jacs.append(0.0 if found is None else score(measure(annotation, found, views.setup), 5).jac)
    return np.array(errors), np.array(jacs)
