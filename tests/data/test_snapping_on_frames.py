"""On real frames clicks land on the paint that an eye found, and none is lost."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.assist.line_evidence import ExpectedLines, line_evidence_by_class
from procc_annotator.field.load import load_field
from procc_annotator.image.decoding import decode_bgra
from tests.bench.paint.measures import accepted, regular, snapping
from tests.bench.paint.truth import truth_frames

# The first ones of clips need no search through a video.
FRAMES = {frame.clip: frame for frame in truth_frames() if frame.number == 0}


def of(clips: str) -> pytest.MarkDecorator:
    names = clips.split()
    return pytest.mark.parametrize("frame", [FRAMES[name] for name in names], ids=names)


@of("bra_mex tennis volleyball")
def test_clicks_beside_paint_land_on_it(frame, shared_data):
    """Light lines; what is harder is printed by the bench."""
    paint = ExpectedLines(frame.field, frame.size[0])
    found = snapping(frame, frame.picture(shared_data), paint, directed=True)
    lines = found["line"]
    away = np.array(lines.away)
    clicks = len(away) + lines.stayed
    assert np.median(away) <= 0.25
    assert (away <= 1.0).sum() >= 0.93 * clicks
    assert (away > 2.5).sum() <= 0.02 * clicks


@of("bra_mex basketball_nba")
def test_regularising_loses_no_click(frame, shared_data):
    found = regular(frame, frame.picture(shared_data), np.random.default_rng(13))
    assert found.clicks >= 10
    assert found.lost == 0
    assert not found.curves or np.median(found.curves) <= 0.6


def test_accepted_ghosts_lie_on_paint(shared_data):
    frame = FRAMES["bra_mex"]
    found = accepted(frame, frame.picture(shared_data), np.random.default_rng(13))
    assert found.ghosts >= 6
    assert not found.wrong
    assert np.median(found.interior) <= 0.3


def test_a_faint_line_that_points_were_put_on_has_paint(shared_data):
    """Seen along the whole line only; a parallel to it on the grass is on none."""
    video = shared_data / "clips" / "soccer_7_Psg-Angers_156_167.mp4"
    picture, soccer, name = decode_bgra(video / "00000140"), load_field("soccer"), "Side line top"

    def missing_share(beside: float) -> float:
        ends = ((0.02186, 0.39050 + beside), (0.28059, 0.35066 + beside))
        clicked = FrameAnnotation((Polyline(name, tuple(Point(*end) for end in ends)),))
        return line_evidence_by_class(clicked, picture, soccer)[name].missing_share

    assert missing_share(0.0) < 0.5
    assert missing_share(0.05) > 0.9
