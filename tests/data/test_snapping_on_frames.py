"""On real frames clicks land on the paint that an eye found, and none is lost."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, points_px
from procc_annotator.assist.line_evidence import ExpectedLines, line_evidence_by_class
from procc_annotator.batch.auto_annotation import annotate_picture
from procc_annotator.calibration.single_image.propose import propose_camera
from procc_annotator.dataset.review import check_frame
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


@pytest.mark.parametrize(
    ("clip", "numbers"),
    [("16_RealMadrid-Shakhtar_245_253", (0, 209)), ("River-Boca_a", (130, 305))],
)
def test_accepted_points_give_no_finding_and_follow_arcs(clip, numbers, shared_data):
    """A post stands before white boards, arcs are widest where they turn; an element that is moved
    off its paint is named."""
    video, soccer = shared_data / "clips" / f"soccer_{clip}.mp4", load_field("soccer")
    for number in numbers:
        picture = decode_bgra(video / f"{number:08d}")
        size = picture.shape[1], picture.shape[0]
        proposal = propose_camera(picture, soccer)
        assert proposal.fit.camera is not None
        made = annotate_picture(str(number), picture, proposal.fit.camera, soccer).annotation
        assert not _found(made, picture, soccer, size)
        for name in ("Circle left", "Circle right"):
            if (arc := made.get(name)) is not None:
                chords = np.hypot(*np.diff(points_px(arc, size), axis=0).T)
                assert len(arc.points) >= 5
                assert chords.max() < size[0] / 15
        for name in ("Side line top", "Big rect. left top", "Small rect. right main"):
            if (line := made.get(name)) is not None:
                moved = tuple(Point(p.u, p.v + 5 / 540) for p in line.points)
                others = made.with_polyline(Polyline(name, moved))
                assert name in {
                    e for f in _found(others, picture, soccer, size) for e in f.elements
                }


def _found(annotation, picture, soccer, size):
    paint = line_evidence_by_class(annotation, picture, soccer)
    return [own.finding for own in check_frame(annotation, soccer, size=size, paint=paint).found]
