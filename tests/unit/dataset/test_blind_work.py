"""Whether a frame's clicks are still those of its commit in blind mode."""

from __future__ import annotations

from dataclasses import replace

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.dataset.review import (
    BlindCommit,
    BlindStatus,
    blind_status,
    content_of,
    read_commit,
    setting_of,
    write_commit,
)

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
    assert blind_status(text, COMMITTED) is BlindStatus.BLIND
    assert blind_status(text, FrameAnnotation((LINE,), unconfirmed=(moved,))) is BlindStatus.BLIND
    assert blind_status(text, FrameAnnotation((moved,))) is BlindStatus.EDITED
    assert blind_status(text, more) is BlindStatus.EDITED
    assert blind_status(text, FrameAnnotation()) is BlindStatus.EDITED
    assert blind_status(None, COMMITTED) is BlindStatus.UNKNOWN


@pytest.mark.parametrize("text", ["", "{", "[]", '{"author": "x"}', "null"])
def test_of_a_damaged_commit_nothing_is_claimed(text) -> None:
    assert blind_status(text, COMMITTED) is BlindStatus.EDITED
    assert blind_status(text, FrameAnnotation()) is BlindStatus.EDITED
