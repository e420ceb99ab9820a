"""Frames that were followed wait in a file, and come back as they were; some at a time or all at
once they give the same cameras."""

from __future__ import annotations

from dataclasses import astuple, replace

import numpy as np
import pytest

from procc_annotator.fit.on_paint.belief import Belief
from procc_annotator.fit.on_paint.beside import FoundAround
from procc_annotator.fit.on_paint.marks import Marks
from procc_annotator.fit.on_paint.result import Worth
from procc_annotator.fit.through_shot import kept_steps, shot_marks
from procc_annotator.fit.through_shot.kept_steps import KeptSteps
from procc_annotator.fit.through_shot.stepping import Stepped
from procc_annotator.fit.through_shot.turning import Turn
from tests.unit.fit.test_through_shot import _followed


def _step(seed: int, marks: int | None, around: int | None, *, turned: bool) -> Stepped:
    random = np.random.default_rng(seed)

    def some(count: int) -> Marks:
        return Marks(
            random.normal(size=(3, count)),
            random.normal(size=count),
            random.normal(size=(2, count)),
            random.integers(0, 20, count),
            random.integers(0, 20, count),
        ).small()

    return Stepped(
        Belief(random.normal(size=11), random.normal(size=(8, 8))),
        None if marks is None else some(marks),
        Worth(0.3, 4.0),
        Turn(random.normal(size=4), random.normal(size=(4, 4))) if turned else None,
        0.8,
        None if marks is None else 0.25,
        1.5,
        "too little paint in sight" if marks is None else "",
        1.7,
        None if around is None else FoundAround(some(around), np.full(around, 15.0)),
    )


STEPS = [
    _step(0, 64, None, turned=False),
    _step(1, None, None, turned=True),
    _step(2, 3, 7, turned=True),
    _step(3, 0, 0, turned=False),
]


def _same(one: object, other: object) -> bool:
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(_same, one, other))
    if isinstance(one, np.ndarray):
        return bool(np.array_equal(one, np.asarray(other)))
    return one == other


@pytest.mark.parametrize("in_memory", [0, 1 << 20])
def test_what_is_kept_comes_back(monkeypatch: pytest.MonkeyPatch, in_memory: int) -> None:
    monkeypatch.setattr(kept_steps, "_IN_MEMORY", in_memory)
    kept = KeptSteps(STEPS)
    assert [_same(astuple(a), astuple(b)) for a, b in zip(kept, STEPS, strict=True)] == [True] * 4
    assert _same(astuple(kept[-2]), astuple(STEPS[2]))
    assert len(kept[1:3]) == 2
    assert _same(astuple(kept[1:3][1]), astuple(STEPS[2]))
    kept.pop()
    kept.pop()
    last = replace(STEPS[0], coverage=0.5)
    kept.append(last)
    assert len(kept) == 3
    assert _same(astuple(kept[2]), astuple(last))


def test_frames_solved_some_at_a_time_have_the_same_cameras(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    whole = _followed()
    monkeypatch.setattr(shot_marks, "_AT_ONCE", 3)
    parts = _followed()
    for one, other in zip(whole.frames, parts.frames, strict=True):
        assert one.fit is not None
        assert other.fit is not None
        np.testing.assert_allclose(other.fit.vector, one.fit.vector, atol=1e-9)
        np.testing.assert_allclose(other.fit.covariance, one.fit.covariance, rtol=1e-6)
        assert (one.state, one.coverage) == (other.state, other.coverage)


def test_frames_without_any_mark_are_gone_through_like_others() -> None:
    marks = shot_marks.ShotMarks([STEPS[1], STEPS[3]])
    ((rows, some),) = marks.parts()
    assert rows == slice(0, 2)
    assert not some.trust.any()
    assert not marks.elements.size
