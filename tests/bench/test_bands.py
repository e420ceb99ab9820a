"""Whether bands hold what they promise: ``pytest tests/bench/test_bands.py --benchmark-only -s``.

Every element of World Cup 2014 is left out in turn; its points are to lie within 1.96 standard
deviations of where the fit to the others shows it.
"""

from collections.abc import Iterator

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.optimization.camera_parameters import POSITION_SLICE
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.residuals import (
    Residuals,
    homography_residuals,
    pinhole_residuals,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.field.load import load_field

FIELD = load_field("soccer")
FRAME = ImageFrame((960, 540))


# P knows nothing of the distortion these pictures have, and H of what is off the ground.
@pytest.mark.parametrize(
    ("model", "least"), [("R", 0.93), ("R+", 0.93), ("auto", 0.93), ("H", 0.88), ("P", 0.88)]
)
def test_held_out_points_in_their_bands(benchmark, world_cup, model, least):
    def run() -> dict[str, float]:
        shares: dict[str, list[FloatArray]] = {"clicks": [], "camera": [], "ghost": []}
        for annotation in world_cup:
            for fit, off in _held_out(annotation, model):
                both = np.stack([np.ones_like(off.whole[0]), off.whole[0]])
                slopes, own = off.derivatives[0], fit.error_px**2 + fit.shared_if_any[1] ** 2
                if fit.basis is None:  # an element that moves is a camera that moves the other way
                    moved = slopes[POSITION_SLICE][:2]
                    own = own + fit.shared_if_any[0] ** 2 * (moved**2).sum(axis=0)
                for name, covariance, more in (
                    ("clicks", fit.of_clicks, 0.0),
                    ("camera", fit.covariance, 0.0),
                    ("ghost", fit.if_shared, own),
                ):
                    squares = np.einsum("pkn,pq,qkn->kn", slopes, covariance, slopes) + more
                    shares[name].append((off.values[0] ** 2 <= 1.96**2 * squares)[both])
        return {name: float(np.concatenate(held).mean()) for name, held in shares.items()}

    held = benchmark.pedantic(run, rounds=1)
    print(f"\n{model}: in 95 % bands", ", ".join(f"{k} {v:.1%}" for k, v in held.items()))
    assert least <= held["ghost"] <= 0.97


def _held_out(annotation: FrameAnnotation, model: str) -> Iterator[tuple[FitResult, Residuals]]:
    """Of every element: the fit to the others, and the residuals of its points."""
    start = fit_camera(annotation, FIELD, model=model).camera
    for polyline in annotation:
        own = build_observations(
            FrameAnnotation((polyline,)), FIELD, FRAME, ground_only=model == "H"
        )
        fit = fit_camera(annotation.without(polyline.class_name), FIELD, model=model, start=start)
        if own is None or fit.vector is None or fit.covariance is None:
            continue
        if fit.basis is not None:
            yield fit, homography_residuals(fit.vector[None], own, fit.basis)
        else:
            free = len(fit.parameters)
            yield fit, pinhole_residuals(fit.vector[None], own, FRAME.half_diagonal, free)
