"""Whether a frame's clicks are still those of its commit in blind mode."""

from __future__ import annotations

from dataclasses import replace

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.session.facts.blind_work import (
    BlindCommit,
    BlindWork,
    read_commit,
    setting_of,
    work_of,
    write_commit,
)
from procc_annotator.session.facts.frame_check import content_of

LINE = Polyline("Middle line", (Point(0.1, 0.2), Point(0.3, 0.4)))
COMMITTED = FrameAnnotation((LINE,))
COMMIT = BlindCommit("Ana Müller", 1.5, content_of(COMMITTED))


def test_a_commit_is_read_as_it_was_written() -> None:
    assert read_commit(write_commit(COMMIT)) == COMMIT
    assert read_commit(None) is None
    assert setting_of("1") != setting_of("2")


def test_the_points_decide() -> None:
    text = write_commit(COMMIT)
    moved = replace(LINE, points=(Point(0.1, 0.2), Point(0.3, 0.41)))
    more = FrameAnnotation((LINE, Polyline("Side line top", (Point(0.5, 0.5),))))
    assert work_of(text, COMMITTED) is BlindWork.BLIND
    assert work_of(text, FrameAnnotation((LINE,), unconfirmed=(moved,))) is BlindWork.BLIND
    assert work_of(text, FrameAnnotation((moved,))) is BlindWork.EDITED
    assert work_of(text, more) is BlindWork.EDITED
    assert work_of(text, FrameAnnotation()) is BlindWork.EDITED
    assert work_of(None, COMMITTED) is BlindWork.UNKNOWN


@pytest.mark.parametrize("text", ["", "{", "[]", '{"author": "x"}', "null"])
def test_of_a_damaged_commit_nothing_is_claimed(text: str) -> None:
    assert work_of(text, COMMITTED) is BlindWork.EDITED
    assert work_of(text, FrameAnnotation()) is BlindWork.EDITED
