"""A run goes on only with results of what it is asked for."""

from __future__ import annotations

from dataclasses import replace

import pytest

from procc_annotator.batch.checkpoint import Checkpoint, field_settings
from procc_annotator.errors import UsageError
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.load import load_field
from procc_annotator.field.model import DARKER, CameraPlacement, Field, Landmark

SEAT = Landmark(
    "Seat",
    position=(60.0, 0.0, -10.0),
    covariance=((0.01, 0.0, 0.0), (0.0, 0.01, 0.0), (0.0, 0.0, 0.01)),
    surveyed=False,
)
BALL = Landmark("Ball", position=(0.0, 0.0, 0.0), instant="7", moving=True)


def field_with(*landmarks: Landmark) -> Field:
    return with_landmarks(load_field(), landmarks, None, {"1": "7"})


def darker(field: Field) -> Field:
    return replace(
        field,
        elements=tuple(
            replace(e, appearance=replace(e.appearance, tone=DARKER)) for e in field.elements
        ),
    )


@pytest.mark.parametrize(
    "change",
    [
        darker,
        lambda field: replace(field, cameras=CameraPlacement((1, 2, 3), (1, 2, 3))),
        lambda _: field_with(replace(SEAT, covariance=None), BALL),
        lambda _: field_with(SEAT, replace(BALL, position=(20.0, 0.0, 0.0))),
    ],
)
def test_results_of_another_field_are_not_gone_on_with(tmp_path, change) -> None:
    field = field_with(SEAT, BALL)
    file = tmp_path / ".propose.unfinished"
    with Checkpoint(file, {"field": field_settings(field)}, resume=False) as kept:
        kept.add("0" * 64, [1.0])
    with Checkpoint(file, {"field": field_settings(field)}, resume=True) as kept:
        assert len(kept) == 1
    with pytest.raises(UsageError, match="begun with another field"):
        Checkpoint(file, {"field": field_settings(change(field))}, resume=True)


def test_what_no_fit_looks_at_keeps_no_run_from_going_on() -> None:
    noted = field_with(replace(SEAT, note="row 12", colour="#ff0000"), BALL)
    assert field_settings(noted) == field_settings(field_with(SEAT, BALL))
