"""Clicks 4 px beside paint on real frames: on the paint or where they were, hardly elsewhere."""

from __future__ import annotations

from collections import defaultdict

import numpy as np
import pytest

from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.image.line_snapping import snap_to_line
from tests.bench.paint.truth import truth_frames

# Of each sport and kind of paint: the largest share moved over 2.5 px off, the least moved at all.
EXPECTED = {
    ("soccer", "line"): (0.005, 0.95),
    ("soccer", "post"): (0.005, 0.95),
    ("soccer", "crossbar"): (0.01, 0.9),
    ("tennis", "line"): (0.005, 0.8),
    ("tennis", "net"): (0.005, 0.9),
    ("volleyball", "line"): (0.005, 0.95),
    ("volleyball", "net"): (0.0, 0.0),
    ("basketball_nba", "dark line"): (0.01, 0.57),  # in doubt a click stays
    ("ice_hockey_nhl", "dark line"): (0.015, 0.8),
}


@pytest.mark.soak  # data/test_paint_on_frames is the taste
def test_clicks_go_to_the_paint_or_stay(shared_data) -> None:
    moved: dict[tuple[str, str], list[float]] = defaultdict(list)
    clicks: dict[tuple[str, str], int] = defaultdict(int)
    for frame in truth_frames()[::2]:
        picture = frame.picture(shared_data)
        paint = ExpectedLines(frame.field, frame.size[0])
        for element in frame.elements:
            kind = frame.field.name, element.kind
            sought = paint.of(element.name)
            for (x, y), (dx, dy) in zip(element.points[::4], element.along[::4], strict=True):
                for aside in (-4.0, 4.0):
                    click = x - aside * dy, y + aside * dx
                    clicks[kind] += 1
                    placed = snap_to_line(picture, click, sought, direction=(dx, dy))
                    if placed is not None:
                        off = (placed[1] - y) * dx - (placed[0] - x) * dy
                        moved[kind].append(abs(off))
    for kind, (most_wrong, least_moved) in EXPECTED.items():
        off = np.array(moved[kind])
        assert len(off) >= least_moved * clicks[kind], kind
        assert (off > 2.5).sum() <= most_wrong * clicks[kind], kind
        if len(off):
            assert np.median(off) <= 0.45, kind
