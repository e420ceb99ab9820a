"""World Cup 2014: which difference between two published methods is real."""

from functools import partial

import numpy as np
import pytest

from procc_annotator.batch.evaluation import run_evaluation
from procc_annotator.batch.frame_sums import ClickNoise, SourceSums, frame_sums
from procc_annotator.batch.grouping import clusters_of
from procc_annotator.batch.inference import Inference
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.metrics.statistics.intervals import INTERVAL_METHODS

TAUS = (2.0, 5.0)
SETUP = EvaluationSetup(load_field("soccer"), (960, 540), "soccernet")


@pytest.fixture(scope="module")
def sources(shared_data) -> tuple[SourceSums, ...]:
    found = []
    for name in ("pnlcalib", "nbjw"):
        with (
            open_source(shared_data / "wc14" / "annotations") as annotations,
            CameraCollection.open(shared_data / "wc14" / f"cameras_{name}") as cameras,
        ):
            run = run_evaluation(
                annotations, cameras, SETUP, TAUS, partial(frame_sums, thresholds=TAUS)
            )
            found.append(SourceSums.of(name, TAUS, list(run)))
            for tau, summary in run.summary().items():
                at = TAUS.index(tau)
                ratios = {key: found[-1].ratios(key) for key in ("mean_jac", "final_score")}
                for key, own in ratios.items():
                    mean = own.parts[:, at].sum() / own.denominators[:, at].sum()
                    assert mean == pytest.approx(getattr(summary, key), abs=1e-12)
                errors = found[-1].ratios("mean_error")
                mean = errors.parts[:, at].sum() / errors.denominators[:, at].sum()
                assert mean == pytest.approx(summary.mean_error, abs=1e-9)
    return tuple(found)


@pytest.mark.parametrize("method", INTERVAL_METHODS)
def test_undecided_at_2_px_and_real_at_5(sources, method):
    clusters = clusters_of(sources[0].names, None, {})
    assert "not clustered" in clusters.described
    certainty = Inference(sources, clusters, method=method)
    (pair,) = certainty.pairs
    assert (pair.shared, len(pair.only_a), len(pair.only_b)) == (184, 2, 0)
    at_2, at_5 = (pair.differences["mean_jac", tau] for tau in TAUS)
    assert 100 * at_2.value == pytest.approx(0.86, abs=0.005)
    assert 100 * at_2.interval.low == pytest.approx(-2.2, abs=0.35)
    assert 100 * at_2.interval.high == pytest.approx(4.0, abs=0.15)
    assert not at_2.beyond_chance
    assert 100 * at_5.value == pytest.approx(4.2, abs=0.05)
    assert 100 * at_5.interval.low == pytest.approx(1.3, abs=0.15)
    assert 100 * at_5.interval.high == pytest.approx(7.0, abs=0.15)
    assert at_5.beyond_chance
    assert certainty.best("mean_jac", 2.0) is None
    assert certainty.best("mean_jac", 5.0) == 0


def test_every_point_is_moved_alike_for_every_source(shared_data):
    moved = []
    for name in ("pnlcalib", "nbjw"):
        with (
            open_source(shared_data / "wc14" / "annotations") as annotations,
            CameraCollection.open(shared_data / "wc14" / f"cameras_{name}") as cameras,
        ):
            noise = ClickNoise(1e-6, repeats=2)
            digest = partial(frame_sums, thresholds=TAUS, noise=noise)
            run = run_evaluation(annotations, cameras, SETUP, TAUS, digest)
            frames = [f for f in run if f.moved is not None]
            still = np.array([f.figures[:, 0] for f in frames])
            moved.append(np.array([f.moved[:, : len(TAUS)] for f in frames]))
            # Moved by nothing to speak of, every frame has the JaC it had.
            assert np.abs(moved[-1] - still[:, None]).max() < 1e-6
