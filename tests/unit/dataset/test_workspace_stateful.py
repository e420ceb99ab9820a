"""Any mixture of edits, saves that fail, and others changing the files: nothing is ever lost."""

import tempfile
from pathlib import Path
from unittest.mock import patch

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.dataset import editing
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import (
    ChangedOnDiskError,
    InputError,
    SaveError,
    UsageError,
)
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation, write_annotation

FIELD = load_field()
EMPTY = FrameAnnotation()
NAMES = st.sampled_from(["Circle left", "Middle line", "Line unknown"])
POINTS = st.builds(lambda u, v: Point(u, v), st.floats(-0.5, 1.5), st.floats(-0.5, 1.5))
FAILING_CALLS = ("open", "fsync", "replace")


class OneFrame(RuleBasedStateMachine):
    """A frame, the file as it must be, and the annotations undo and redo must give."""

    def __init__(self) -> None:
        super().__init__()
        self._folder = tempfile.TemporaryDirectory()
        self.folder = Path(self._folder.name)
        (self.folder / "1.jpg").write_bytes(b"")
        self.path = self.folder / "1.json"
        self.disk: bytes | None = None

    def teardown(self) -> None:
        self._folder.cleanup()

    @initialize(content=st.sampled_from([None, b"{}", b"{ half", b'{"Circle left": []}']))
    def begin(self, content: bytes | None) -> None:
        self.outside(content)
        self.reopen()

    @rule()
    def reopen(self) -> None:
        """Another session, after a crash or not: it starts from what the file holds."""
        self.work = Workspace.open(self.folder, FIELD)
        state = self.work.state(0)
        self.blocked = state.error is not None
        self.known = None if self.blocked else self.disk
        self.made_here = self.known is None and not self.blocked
        self.steps = [EMPTY if self.blocked else self.parsed(self.disk)]
        self.at = 0

    @rule(content=st.sampled_from([None, b"{}", b"{ half", b'{"Middle line": []}']))
    def outside(self, content: bytes | None) -> None:
        """Somebody else writes, breaks or deletes the file."""
        self.disk = content
        if content is None:
            self.path.unlink(missing_ok=True)
        else:
            self.path.write_bytes(content)

    @rule(name=NAMES, points=st.lists(POINTS, max_size=3))
    def edit(self, name: str, points: list[Point]) -> None:
        edited = editing.set_points(self.current, name, points)
        if self.blocked:
            with pytest.raises(UsageError):
                self.work.edit(0, "edit", edited)
        elif self.work.edit(0, "edit", edited):
            self.steps = [*self.steps[: self.at + 1], edited]
            self.at += 1

    @rule()
    def undo(self) -> None:
        assert (self.work.undo(0) is not None) == (self.at > 0)
        self.at = max(self.at - 1, 0)

    @rule()
    def redo(self) -> None:
        assert (self.work.redo(0) is not None) == (self.at + 1 < len(self.steps))
        self.at = min(self.at + 1, len(self.steps) - 1)

    @rule()
    def save(self) -> None:
        if self.blocked or not self.dirty:
            self.work.save(0)
        elif self.disk is not None and self.disk != self.known:
            with pytest.raises(ChangedOnDiskError):
                self.work.save(0)
        else:
            self.work.save(0)
            self.written()
            if self.made_here and self.current == EMPTY:
                self.disk = self.known = None

    @rule()
    def overwrite(self) -> None:
        if self.blocked:
            with pytest.raises(SaveError):
                self.work.overwrite(0)
        else:
            self.made_here = False
            self.work.overwrite(0)
            self.written()

    @precondition(lambda self: not self.blocked)
    @rule(call=st.sampled_from(FAILING_CALLS))
    def overwrite_fails(self, call: str) -> None:
        """The disk is full, at any of the steps of writing."""
        failure = OSError(28, "No space left on device")
        with (
            patch(f"procc_annotator.formats.atomic.os.{call}", side_effect=failure),
            pytest.raises(SaveError, match="No space left"),
        ):
            self.work.overwrite(0)
        self.made_here = False
        assert self.work.state(0).save_error is not None

    @rule()
    def reload(self) -> None:
        try:
            annotation = self.parsed(self.disk)
        except InputError:
            with pytest.raises(InputError):
                self.work.reload(0)
            return
        self.work.reload(0)
        if self.blocked:
            self.steps, self.at = [annotation], 0
        elif annotation != self.current:
            self.steps = [*self.steps[: self.at + 1], annotation]
            self.at += 1
        self.known, self.blocked = self.disk, False
        self.made_here = self.disk is None

    @invariant()
    def the_file_is_what_it_must_be(self) -> None:
        found = self.path.read_bytes() if self.path.exists() else None
        assert found == self.disk
        assert {p.name for p in self.folder.iterdir()} <= {"1.jpg", "1.json"}

    @invariant()
    def the_screen_and_the_save_state_are_what_they_must_be(self) -> None:
        state = self.work.state(0)
        assert state.history.current == self.current
        assert (state.error is not None) == self.blocked
        assert state.dirty == self.dirty
        assert self.work.dirty_frames() == ([0] if self.dirty else [])

    @property
    def current(self) -> FrameAnnotation:
        return self.steps[self.at]

    @property
    def dirty(self) -> bool:
        return not self.blocked and self.current != self.parsed(self.known)

    def written(self) -> None:
        self.disk = self.known = write_annotation(self.current)
        assert self.work.state(0).save_error is None

    def parsed(self, data: bytes | None) -> FrameAnnotation:
        return EMPTY if data is None else read_annotation(data, path="1.json", field=FIELD)


TestOneFrame = OneFrame.TestCase
TestOneFrame.settings = settings(
    max_examples=60, stateful_step_count=25, deadline=None, derandomize=True
)


def test_two_windows_on_one_dataset_never_overwrite_each_other(tmp_path):
    (tmp_path / "1.jpg").write_bytes(b"")
    one, two = (Workspace.open(tmp_path, FIELD) for _ in range(2))
    first = FrameAnnotation((Polyline("Circle left", (Point(0.1, 0.2),)),))
    second = FrameAnnotation((Polyline("Middle line", (Point(0.3, 0.4),)),))
    one.edit(0, "draw", first)
    two.edit(0, "draw", second)
    one.save(0)
    with pytest.raises(ChangedOnDiskError):
        two.save(0)
    two.reload(0)
    two.edit(0, "draw", editing.set_points(first, "Middle line", second.polylines[0].points))
    two.save(0)
    one.edit(0, "delete", FrameAnnotation())
    with pytest.raises(ChangedOnDiskError):
        one.save(0)
    assert Workspace.open(tmp_path, FIELD).read(0).annotated == ("Circle left", "Middle line")
