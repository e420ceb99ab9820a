"""Actions a frame: the World Cup 2014 annotations clicked again, against labelme's way.

What counts as an action is said in `replay`. With ghosts the real set can only be replayed by its
geometry, since its pictures are not at hand: a ghost is taken to be accepted, with the points that
were really annotated, if these are within 5 px of it on average, and drawn by hand otherwise; one
of an element that nobody annotated is taken to be left for lack of a line. The drawn frames are
replayed with their pictures.
"""

import json
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.calibration.prediction.ghosts import Ghost
from procc_annotator.formats.annotations.soccernet import read_annotation
from tests.bench.interaction.replay import (
    FIELD,
    SIZE,
    AcceptAll,
    accuracy_px,
    drawn_frames,
    labelme_actions,
    our_actions,
    with_ghosts,
)

_NEAR_PX = 5.0


def read_frames(folder: Path) -> list[FrameAnnotation]:
    files = sorted(folder.glob("*.json"), key=lambda p: p.name)
    if not files:
        pytest.skip(f"no annotations in {folder}")
    return [read_annotation(f.read_bytes(), path=str(f), field=FIELD) for f in files]


def test_relabelling_takes_at_most_half_of_the_actions(shared_data):
    frames = read_frames(shared_data / "wc14" / "annotations")
    ours, theirs = [], []
    for frame in frames:
        # The frames of this set are single shots of different moments: nothing is known before.
        ours.append(our_actions(frame, frozenset()))
        theirs.append(labelme_actions(frame))
    with_enter = sum(our_actions(f, frozenset(), two_clicks=False) for f in frames)
    figures = {
        "frames": len(frames),
        "elements": sum(len(f.annotated) for f in frames),
        "actions a frame here": round(sum(ours) / len(ours), 1),
        "actions a frame with labelme": round(sum(theirs) / len(theirs), 1),
        "share": round(sum(ours) / sum(theirs), 3),
        "share with Enter after straight elements too": round(with_enter / sum(theirs), 3),
    }
    print(json.dumps(figures))
    assert sum(ours) <= 0.5 * sum(theirs)


def accepting_by_geometry(frame: FrameAnnotation) -> AcceptAll:
    def accept_all(annotation: FrameAnnotation, ghosts: tuple[Ghost, ...]) -> FrameAnnotation:
        for ghost in ghosts:
            polyline = frame.get(ghost.name)
            if polyline is None:
                continue
            course = np.concatenate([piece.points_px for piece in ghost.pieces])
            apart = [np.hypot(*(course - p).T).min() for p in points_px(polyline, SIZE)]
            if np.mean(apart) < _NEAR_PX * (SIZE[0] - 1) / 959:
                annotation = annotation.with_polyline(polyline)
        return annotation

    return accept_all


# Every third frame tells the share of all of them to a hundredth.
@pytest.mark.parametrize("every", [24, pytest.param(3, marks=pytest.mark.soak)])
def test_ghosts_on_the_real_set_by_geometry(shared_data, every):
    frames = read_frames(shared_data / "wc14" / "annotations")[::every]
    frames = [f for f in frames if f.annotated]
    done = [with_ghosts(frame, accepting_by_geometry(frame)) for frame in frames]
    theirs = sum(labelme_actions(f) for f in frames)
    figures = {
        "frames": len(frames),
        "actions a frame here": round(sum(d.actions for d in done) / len(frames), 1),
        "actions a frame with labelme": round(theirs / len(frames), 1),
        "share": round(sum(d.actions for d in done) / theirs, 3),
        "drawn by hand a frame": round(sum(len(d.drawn) for d in done) / len(frames), 2),
        "accepted a frame": round(sum(len(d.accepted) for d in done) / len(frames), 2),
    }
    print(json.dumps(figures))
    assert sum(d.actions for d in done) < 0.5 * theirs


@pytest.mark.soak  # its figures; what must hold of them is asserted in tests/unit, too
def test_ghosts_on_the_drawn_frames(sample_data):
    rows = []
    for frame in drawn_frames(sample_data):
        done = with_ghosts(frame.clicked, frame.accept_all)
        rows.append(
            {
                "frame": frame.name,
                "elements": len(frame.clicked.annotated),
                "here": done.actions,
                "without ghosts": our_actions(frame.clicked, frozenset()),
                "labelme": labelme_actions(frame.clicked),
                "drawn": len(done.drawn),
                "accepted": len(done.accepted),
                "removed": len(done.removed),
                "median px of accepted": [
                    round(accuracy_px(done.annotation, frame.exact, n), 2) for n in done.accepted
                ],
            }
        )
    for row in rows:
        print(json.dumps(row))
    share = sum(r["here"] for r in rows) / sum(r["labelme"] for r in rows)
    accuracy = [value for r in rows for value in r["median px of accepted"]]
    print(json.dumps({"share": round(share, 3), "median px": round(float(np.median(accuracy)), 2)}))
    assert share <= 1 / 3
