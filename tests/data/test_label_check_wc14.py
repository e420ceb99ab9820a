"""How many injected mistakes the label check finds in real annotations, and what it says of none.

A sample of the frames; all of them in `tests/bench/test_labels.py`.
"""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.candidate_classes import (
    MIRROR_X,
    MIRROR_Y,
    mirrored_names,
    relabelled,
)
from procc_annotator.calibration.label_check.check import (
    check_labels,
    find_opposite_frames,
    fitted_position,
)
from procc_annotator.calibration.label_check.finding import Rule, Severity
from procc_annotator.field.load import load_field

FIELD = load_field("soccer")
SIZE = (960, 540)


@pytest.mark.parametrize(
    ("kind", "every", "recall", "precision"),
    [
        ("swapped", 18, 0.97, 0.97),
        ("relabelled", 18, 0.94, 0.94),
        ("posts", 9, 0.99, 0.97),
        ("point", 18, 0.87, 0.94),
    ],
)
def test_injected_mistakes(world_cup, injected_mistakes, kind, every, recall, precision) -> None:
    found = injected_mistakes(world_cup[::every], kind, seed=9)
    assert found.frames >= 5
    assert found.recall >= recall
    assert found.precision >= precision
    assert found.right_suggestions >= 0.95


@pytest.mark.parametrize("every", [20, pytest.param(5, marks=pytest.mark.soak)])
def test_clean_frames(world_cup, every) -> None:
    findings = []
    for annotation in world_cup[::every]:
        fit = fit_camera(annotation, FIELD)
        findings.append(check_labels(annotation, FIELD, size=SIZE, fit=fit))
    errors = [any(f.severity is Severity.ERROR for f in found) for found in findings]
    warnings = [any(f.severity is Severity.WARNING for f in found) for found in findings]
    assert np.mean(errors) <= 0.01
    assert np.mean(warnings) <= 0.02


@pytest.mark.parametrize("every", [36, pytest.param(12, marks=pytest.mark.soak)])
def test_reflected_frames(world_cup, every) -> None:
    found = []
    enough = [a for a in world_cup if len(a.annotated) >= 5]
    for number, annotation in enumerate(enough[::every]):
        wrong = relabelled(annotation, mirrored_names(FIELD, (MIRROR_X, MIRROR_Y)[number % 2]))
        fit = fit_camera(wrong, FIELD)
        told = check_labels(wrong, FIELD, size=SIZE, fit=fit)
        found.append(bool(told) and told[0].rule is Rule.REFLECTED)
    assert np.mean(found) >= 0.9


@pytest.mark.parametrize(
    ("every", "kind"), [(3, "turned"), pytest.param(1, "across", marks=pytest.mark.soak)]
)
def test_frames_on_the_other_side(world_cup, every, kind) -> None:
    """A sixth of the frames turned, or with far and near exchanged: the others tell, and of the
    frames as they are none is named."""
    frames = dict(enumerate(world_cup[::every]))
    if kind == "turned":
        names = {name: FIELD.half_turn.name_of(name) for name in FIELD.index}
    else:
        names = mirrored_names(FIELD, MIRROR_Y)
    wrong = set(list(frames)[::6])
    given = {i: relabelled(a, names) if i in wrong else a for i, a in frames.items()}
    fits = {i: fit_camera(a, FIELD) for i, a in given.items()}
    stands = {i: stand for i, fit in fits.items() if (stand := fitted_position(fit)) is not None}
    told = find_opposite_frames(stands, FIELD).keys()
    assert told <= wrong
    for i in wrong - told:
        found = check_labels(given[i], FIELD, size=SIZE, fit=fits[i])
        assert kind == "across"
        assert found[0].rule is Rule.REFLECTED
    clean = {i: fitted_position(fit) for i, fit in fits.items() if i not in wrong}
    assert not find_opposite_frames(clean, FIELD)
