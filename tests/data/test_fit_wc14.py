"""What fits reach on real annotations: scored on the points they were fitted to, and on others."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.field.load import load_field
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field("soccer")
SETUP = EvaluationSetup(FIELD, off_plane="left_out")


def on_the_ground(annotation: FrameAnnotation) -> FrameAnnotation:
    return FrameAnnotation(
        tuple(
            p
            for p in annotation
            if (element := FIELD.element(p.class_name)) is not None and element.on_ground
        )
    )


# Floors on the whole set are those of `tests/bench/test_fit.py`.
@pytest.mark.parametrize(
    ("model", "frames", "at_2", "at_5"),
    [
        ("R", slice(0, None, 9), 0.90, 0.975),
        ("H", slice(0, None, 18), 0.72, 0.93),
        ("P", slice(1, None, 18), 0.60, 0.92),
        ("R+", slice(1, None, 9), 0.95, 0.98),
        ("auto", slice(0, None, 24), 0.92, 0.96),
    ],
)
def test_jac_and_completeness(world_cup, model, frames, at_2, at_5) -> None:
    jacs = []
    for annotation in world_cup[frames]:
        used = on_the_ground(annotation) if model == "H" else annotation
        fit = fit_camera(used, FIELD, model=model)
        assert fit.failure is None
        measurement = measure(used, fit.camera, SETUP)
        jacs.append([score(measurement, tau).jac for tau in (2, 5)])
    jac_2, jac_5 = np.mean(jacs, axis=0)
    assert jac_2 >= at_2
    assert jac_5 >= at_5


@pytest.mark.parametrize(
    ("every", "enough"), [(60, 20), pytest.param(10, 130, marks=pytest.mark.soak)]
)
def test_held_out_elements(world_cup, every, enough) -> None:
    """Some frames, every element left out in turn (all frames: 1.0 px)."""
    means: list[float] = []
    for annotation in world_cup[::every]:
        whole = fit_camera(annotation, FIELD)
        for polyline in annotation:
            fit = fit_camera(annotation.without(polyline.class_name), FIELD, start=whole.camera)
            if fit.camera is None:
                assert len(annotation.annotated) <= 3
                continue
            labelling = measure(annotation, fit.camera, SETUP).plain
            distances = labelling.distances[labelling.annotated_names.index(polyline.class_name)]
            means.append(np.inf if distances is None else distances.mean())
    assert len(means) > enough
    assert np.median(means) <= 1.05


@pytest.mark.parametrize(
    ("every", "enough"), [(72, 15), pytest.param(24, 50, marks=pytest.mark.soak)]
)
def test_the_chosen_model_predicts_no_worse(world_cup, every, enough) -> None:
    """Some frames, every element left out in turn: the choice does not overfit."""
    means: dict[str, list[float]] = {"R": [], "auto": []}
    for annotation in world_cup[::every]:
        starts = {model: fit_camera(annotation, FIELD, model=model).camera for model in means}
        for polyline in annotation:
            rest = annotation.without(polyline.class_name)
            for model, found in means.items():
                fit = fit_camera(rest, FIELD, model=model, start=starts[model])
                if fit.camera is None:
                    continue
                labelling = measure(annotation, fit.camera, SETUP).plain
                row = labelling.annotated_names.index(polyline.class_name)
                distances = labelling.distances[row]
                found.append(np.inf if distances is None else distances.mean())
    assert len(means["R"]) == len(means["auto"]) > enough
    assert np.median(means["auto"]) <= np.median(means["R"])
    assert np.mean(np.array(means["auto"]) < 5) >= np.mean(np.array(means["R"]) < 5) - 0.01


@pytest.mark.parametrize(("every", "enough"), [(8, 8), pytest.param(2, 30, marks=pytest.mark.soak)])
def test_predicted_deviations_gate_predictions(world_cup, every, enough) -> None:
    """Where the fit to 5 random elements promises 2.5 px, a held-out element is within 5 px."""
    rng = np.random.default_rng(2)
    kept_promises = []
    for annotation in world_cup[::every]:
        names = list(annotation.annotated)
        if len(names) < 7:
            continue
        chosen = set(rng.choice(names, 5, replace=False).tolist())
        fit = fit_camera(
            FrameAnnotation(tuple(p for p in annotation if p.class_name in chosen)), FIELD
        )
        if fit.camera is None:
            continue
        labelling = measure(annotation, fit.camera, SETUP).plain
        for name, distances in zip(labelling.annotated_names, labelling.distances, strict=True):
            element = FIELD.element(name)
            if name in chosen or distances is None or element is None or not element.is_straight:
                continue
            ends = np.array([element.geometry.start, element.geometry.end])
            if np.nanmax(fit.projected_sd(ends)) <= 2.5:
                kept_promises.append(distances.mean() < 5)
    assert len(kept_promises) > enough
    assert np.mean(kept_promises) >= 0.97
