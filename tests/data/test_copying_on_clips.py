"""Over ten frames of a real clip copies stay on their paint and keep their bends."""

from pathlib import Path

import numpy as np

from procc_annotator.annotation import Polyline, points_px
from procc_annotator.assist.copying import copy_moved
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.image.video import open_shared_video
from tests.bench.paint.truth import TruthFrame, truth_frames

_COPIES = 10
_BESIDE_PX = 16.0  # of a place measured by eye: elsewhere the truth says nothing of bends


def copied(before: TruthFrame, after: TruthFrame, clip: Path) -> tuple[list[Polyline], set]:
    """Every element of a frame carried to another one, and which points no paint confirms."""
    paint = ExpectedLines(before.field, before.size[0])
    elements = before.field.elements
    curved = frozenset(e.name for e in elements if e.is_curved)
    names = [e.name for e in before.elements]
    lines = tuple(
        before.polyline(e.name, e.points) for e in before.elements if names.count(e.name) == 1
    )
    video = open_shared_video(clip)
    numbers = np.linspace(before.number, after.number, _COPIES + 1).round().astype(int).tolist()
    picture, unseen = video.frame(numbers[0]), frozenset()
    for number in numbers[1:]:
        previous, picture = picture, video.frame(number)
        done = copy_moved(lines, previous, picture, curved, paint)
        assert done.moved
        lines, unseen = done.polylines, done.unseen
    return list(lines), set(unseen)


def test_ten_copies(shared_data):
    """Dark lines on wood, players on many of them, a three-point line and a free-throw circle."""
    frames = {f.number: f for f in truth_frames() if f.clip == "basketball_nba"}
    before, after = frames[40], frames[60]
    lines, unseen = copied(before, after, shared_data / "clips" / f"{before.clip}.mp4")
    away: list[float] = []
    bends = 0
    for line in lines:
        for element in after.elements:
            if element.name != line.class_name or not len(element.points):
                continue
            places = points_px(line, after.size)
            apart = np.hypot(*(places[:, None] - element.points[None]).transpose(2, 0, 1))
            seen = np.array([(p.u, p.v) not in unseen for p in line.points])
            off = element.away(places)[seen & (apart.min(axis=1) < _BESIDE_PX)]
            away.extend(off[~np.isnan(off)].tolist())
            bends += float((element.along @ element.along[0]).min()) < 0.9 and len(off) >= 3
    assert len(away) >= 20
    assert bends >= 1
    assert np.median(away) < 0.4
    assert max(away) <= 2.5
