"""Building the overlay of a frame in which everything in sight is annotated, 4 px off."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.interaction.overlay import OverlayBuilder, OverlayContent
from procc_annotator.metrics.measurement import Measurement, measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field()
SETUP = EvaluationSetup(FIELD, protocol="procc")
CAMERA = PinholeCamera(0, math.radians(76), 0, (0, 60, -15), (1300, 1300), (479.5, 269.5))


@pytest.fixture(scope="module")
def crowded() -> FrameAnnotation:
    """Every element the camera shows, five points along its projection."""
    pieces = measure(FrameAnnotation(), CAMERA, SETUP).projected.pieces
    clicked = []
    for name, parts in pieces.items():
        places = np.concatenate(parts)[:: max(1, sum(map(len, parts)) // 4)]
        points = tuple(point_from_px(x + 4, y, SETUP.size) for x, y in places)
        clicked.append(Polyline(name, points))
    return FrameAnnotation(tuple(clicked))


@pytest.mark.parametrize("what", ["after a move of the mouse", "after an edit"])
def test_speed_of_a_crowded_frame(benchmark: Any, crowded: FrameAnnotation, what: str) -> None:
    def fresh() -> tuple[tuple[Measurement], dict[str, Any]]:
        return (measure(crowded, CAMERA, SETUP),), {}

    def build(measurement: Measurement) -> None:
        shown = OverlayContent(
            annotation=crowded,
            size=SETUP.size,
            field=FIELD,
            measurement=measurement,
            score=score(measurement, 5.0),
            picture_size=(1280, 720),
        )
        marks = OverlayBuilder().build(shown).marks
        assert sum(len(m.centres) for m in marks) == sum(len(p.points) for p in crowded.polylines)

    if what == "after an edit":
        benchmark.pedantic(build, setup=fresh, rounds=200)
    else:
        benchmark(build, measure(crowded, CAMERA, SETUP))
