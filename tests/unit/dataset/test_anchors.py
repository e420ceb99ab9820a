"""Which annotated frames a track has to pass, and how far pictures follow one another."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from procc_annotator.assist.track_anchors import anchors_of
from procc_annotator.dataset.sequence import FrameSequence
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.field.load import load_field

SIZE = (960, 540)


def test_clicks_that_leave_the_camera_open_are_no_anchor(sample_data) -> None:
    field = load_field("soccer")
    workspace = Workspace.open(sample_data, field=field)
    indices = {n: workspace.index[f"0000{n}"] for n in (1, 2)}

    assert set(anchors_of(workspace, indices, field, size=SIZE)) == {2}  # three lines in the first


def test_pictures_are_missing_between_runs() -> None:
    numbers = np.array([3, 4, 5, 8, 9, 12])
    folder = FrameSequence(numbers, 3, 12, 25.0, None, {})
    found = [folder.unbroken(number) for number in (3, 5, 8, 9, 12)]

    assert found == [range(3, 6), range(3, 6), range(8, 10), range(8, 10), range(12, 13)]
    video = FrameSequence(numbers, 0, 20, 25.0, Path("match.mp4"), {})
    assert video.unbroken(8) == range(21)
