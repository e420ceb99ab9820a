"""The check of a set goes on past damaged frames, and stops reading once it is told to."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.errors import AnnotationError
from procc_annotator.field.load import load_field
from procc_annotator.fit.labels.finding import Rule
from procc_annotator.session.check_run import CheckedFrame, check_frames

FIELD = load_field()
SIZE = (960, 540)
BENT = FrameAnnotation(
    (Polyline("Middle line", (Point(0.2, 0.2), Point(0.3, 0.6), Point(0.6, 0.2))),)
)


def damaged() -> FrameAnnotation:
    raise AnnotationError("b.json", "the class occurs twice", place="Middle line")


def test_frames_come_with_their_findings_and_damaged_ones_with_the_reason() -> None:
    frames = [("a", lambda: BENT), ("b", damaged), ("c", FrameAnnotation)]
    a, b, c = check_frames(frames, FIELD, size=SIZE)
    assert [f.rule for f in a.findings] == [Rule.BENT]
    assert (a.elements, a.error) == (1, None)
    assert (b.name, b.findings) == ("b", ())
    assert "occurs twice" in b.error
    assert c == CheckedFrame("c")


def test_nothing_is_read_once_it_is_cancelled() -> None:
    read: list[str] = []

    def frames() -> Iterator[tuple[str, object]]:
        for name in "abc":
            yield name, lambda name=name: read.append(name) or BENT

    done = [
        frame.name
        for frame in check_frames(frames(), FIELD, size=SIZE, cancelled=lambda: len(read) == 2)
    ]
    assert done == read == ["a", "b"]


@pytest.mark.parametrize("model", ["H", "P", "R", "R+"])
def test_every_model_will_do(model) -> None:
    (found,) = check_frames([("a", lambda: BENT)], FIELD, size=SIZE, model=model)
    assert [f.rule for f in found.findings] == [Rule.BENT]
