"""What further sources show of the field, as lines in their colours."""

from __future__ import annotations

import numpy as np

from procc_annotator.camera.models import HomographyCamera
from procc_annotator.field.load import load_field
from procc_annotator.interaction.overlay_lines import build_wireframes
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

SETUP = EvaluationSetup(load_field())
# The field from straight above, 8 px a metre, its centre in the middle of the picture.
ABOVE = HomographyCamera(np.array([[8.0, 0, 479.5], [0, 7.0, 269.5], [0, 0, 1.0]]))


def test_lines_lie_where_the_camera_shows_the_elements() -> None:
    projected = project_field(ABOVE, SETUP)
    overlay = build_wireframes([(projected, "#e4572e")], SETUP.size, (1919, 1079))
    rim, line = overlay.strokes
    assert (line.colour, line.dash) == ("#e4572e", ())
    assert rim.width > line.width
    assert np.array_equal(rim.segments, line.segments)
    # Centres of the corner pixels coincide: 1918 steps between them where there were 959.
    pieces = [p for parts in projected.pieces.values() for p in parts]
    ends = np.concatenate([np.hstack([p[:-1], p[1:]]) for p in pieces]) * 2
    assert np.allclose(line.segments, ends)
    halfway = line.segments[np.abs(line.segments[:, 0] - 959).argmin()]
    assert np.isclose(halfway[0], 959.0, atol=1e-6)


def test_every_source_has_its_own_lines_the_last_on_top() -> None:
    projected = project_field(ABOVE, SETUP)
    overlay = build_wireframes(
        [(projected, "#111111"), (projected, "#222222")], SETUP.size, (960, 540)
    )
    assert [s.colour for s in overlay.strokes][1::2] == ["#111111", "#222222"]
    assert not overlay.marks
    assert build_wireframes([], SETUP.size, (960, 540)).strokes == ()
