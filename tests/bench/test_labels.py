"""What the label check finds on the World Cup set: ``pytest tests/bench --benchmark-only -s``.

Labels of real frames of at least six elements are made wrong at random; findings of severity error
count, element by element.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import pytest

from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.candidate_classes import (
    MIRROR_Y,
    mirrored_names,
    relabelled,
)
from procc_annotator.calibration.label_check.check import check_labels
from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.field.load import load_field

FIELD = load_field("soccer")
SIZE = (960, 540)
SEEDS = (601, 602, 603)
FLOORS = {
    "swapped": (0.99, 0.97),
    "relabelled": (0.99, 0.97),
    "posts": (0.99, 0.97),
    "point": (0.93, 0.97),
}


@pytest.mark.parametrize("kind", FLOORS)
def test_injected_mistakes(benchmark, world_cup, injected_mistakes, kind) -> None:
    """Recall, precision, right suggestions, and milliseconds of a check that finds something."""

    def run() -> list[Any]:
        return [injected_mistakes(world_cup, kind, seed=seed) for seed in SEEDS]

    for seed, found in zip(SEEDS, benchmark.pedantic(run, rounds=1), strict=True):
        print(
            f"\n{kind}, seed {seed}: {found.frames} frames, recall {found.recall:.3f},"
            f" precision {found.precision:.3f}, right suggestions {found.right_suggestions:.3f},"
            f" {1e3 * found.seconds:.0f} ms (worst {1e3 * found.most_seconds:.0f})"
        )
        assert found.recall >= FLOORS[kind][0]
        assert found.precision >= FLOORS[kind][1]
        assert found.right_suggestions >= 0.95


@pytest.mark.parametrize("reflected", [False, True])
def test_whole_frames(benchmark, world_cup, reflected) -> None:
    """Frames with a finding of each severity, as they are and with far and near exchanged."""
    names = mirrored_names(FIELD, MIRROR_Y) if reflected else {}
    assert names is not None

    seconds: list[float] = []

    def run() -> list[set[str]]:
        severities = []
        for annotation in world_cup:
            given = relabelled(annotation, names)
            fit = fit_camera(given, FIELD)
            began = time.thread_time()
            found = check_labels(given, FIELD, size=SIZE, fit=fit)
            seconds.append(time.thread_time() - began)
            severities.append({"reflected"} & {f.rule for f in found} | {f.severity for f in found})
        return severities

    found = benchmark.pedantic(run, rounds=1)
    what = "reflected" if reflected else "clean"
    for kind in ("reflected", *Severity):
        print(f"\n{what}: {sum(kind in one for one in found)} of {len(found)} frames: {kind}")
    share = float(np.mean([Severity.ERROR in one for one in found]))
    assert share >= 0.85 if reflected else share <= 0.01
    print(
        f"\n{what}: {1e3 * np.median(seconds):.1f} ms of processor time beyond the fit's (median)"
    )
    assert reflected or np.median(seconds) < 0.012
