"""Checking the labels of frames that are not on screen: the whole dataset, and edited frames."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing, contextmanager
from functools import partial
from time import monotonic

from PySide6.QtCore import QObject, QTimer

from procc_annotator.batch.execution.executor import Executor, InProcess, Work
from procc_annotator.batch.label_check import Checked, CheckFrames, FrameToCheck, with_set_findings
from procc_annotator.batch.set_run import frames_in_words
from procc_annotator.dataset.picture_sizes import picture_size
from procc_annotator.dataset.review import FrameCheck
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ImageError, InputError
from procc_annotator.field.model import Field
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.store import Store

FrameToRead = tuple[int, bool]  # a frame's index in the dataset, and whether to fit a camera
_Answer = tuple[int, dict[str, FrameCheck]]  # frames checked; checks with a finding from the set

_CHUNK = 8  # frames a process takes at once: about half a second's work
_FEW = 16  # frames that are checked sooner than a process has started
_PROGRESS_S = 0.25
_DELAY_MS = 400  # the frame on screen is checked before the frames that were left


class CheckRunner(QObject):
    """Checks frames in a process: the whole set on request, edited frames once they were left."""

    def __init__(
        self,
        store: Store,
        live_fit: LiveFit,
        *,
        arrived: Callable[[list[Checked]], None],
        progressed: Callable[[int, int], None],
        finished: Callable[[int, dict[str, FrameCheck]], None],
    ) -> None:
        """Nothing is checked yet.

        Args:
            progressed: receives frames of the set checked, of how many; (0, 0): finished.
            finished: receives frames of the set checked, and checks with a finding from the set.
        """
        super().__init__(store)
        self._store, self._live_fit = store, live_fit
        self._arrived, self._progressed, self._finished = arrived, progressed, finished
        self._edited: dict[str, None] = {}  # frames not checked since
        self._set_task = LatestOnlyTask(self, self._fail)
        self._edited_task = LatestOnlyTask(self, self._fail)
        self._later = QTimer(self, singleShot=True, interval=_DELAY_MS)
        self._later.timeout.connect(self._check_edited)
        store.watch(select.frame, self._later.start)

    @property
    def running(self) -> bool:
        """Return whether the set is being checked."""
        return self._set_task.running

    def check_set(self) -> None:
        """Check every annotated frame, with a camera where one may be fitted."""
        state, workspace = self._store.state, self._store.state.workspace
        if workspace is None:
            return
        self.stop()
        frames = [(i, state.reveals(frame.name)) for i, frame in enumerate(workspace.frames)]
        self._start(self._set_task, frames, self._finish_set, self._progressed)
        self._progressed(0, len(frames))

    def stop(self) -> None:
        """Stop checking the set; what was found so far arrives."""
        if self._set_task.stop_keep_partial():
            self._end_set()

    def add(self, frame: str) -> None:
        """Check an edited frame once it is not on screen, unless `drop` comes first."""
        self._edited[frame] = None
        self._later.start()

    def drop(self, frame: str) -> None:
        """Do not check a frame: it has been checked as it is."""
        self._edited.pop(frame, None)

    def close(self) -> None:
        """Stop everything and forget which frames are waiting."""
        self._edited.clear()
        self._later.stop()
        self._set_task.cancel()
        self._edited_task.cancel()

    def _check_edited(self) -> None:
        state, workspace = self._store.state, self._store.state.workspace
        if workspace is None or self._edited_task.running or self.running:
            return  # the end of either begins anew
        here = state.frame_name or ""
        names = [name for name in self._edited if name != here and name in workspace.index]
        self._edited = {here: None} if here in self._edited else {}
        if names:
            fitted = self._live_fit.wanted
            frames = [(workspace.index[name], fitted and state.reveals(name)) for name in names]
            self._start(self._edited_task, frames, lambda _: self._later.start())

    def _start(
        self,
        task: LatestOnlyTask,
        frames: Sequence[FrameToRead],
        then: Callable[[_Answer], object],
        progress: Callable[[int, int], None] | None = None,
    ) -> None:
        state = self._store.state
        assert state.workspace is not None
        check = CheckFrames(state.field, self._live_fit.model)
        work = partial(
            _check_frames, state.workspace, frames, check, state.field, task is self._set_task
        )
        task.start(work, then, progress=progress, partial=self._arrived)

    def _finish_set(self, answer: _Answer) -> None:
        self._end_set()
        self._finished(*answer)

    def _end_set(self) -> None:
        self._progressed(0, 0)
        self._later.start()

    def _fail(self, text: str) -> None:
        if not self.running:
            self._end_set()
        say(self._store, text, "error")


def _check_frames(
    workspace: Workspace,
    frames: Sequence[FrameToRead],
    check: CheckFrames,
    field: Field,
    whole_set: bool,
    control: JobControl,
) -> _Answer:
    """Check the annotated frames as they are when it is their turn, saved or not; of a whole set
    also what only all frames together say."""
    few = len(frames) <= _FEW
    checks: list[Checked] = []
    passed, reported = 0, monotonic()

    def chunks() -> Iterator[list[FrameToCheck]]:
        """Read the annotated frames when they are needed, some at a time."""
        nonlocal passed
        chunk: list[FrameToCheck] = []
        for index, fitted in frames:
            if control.cancelled:
                return
            if (frame := _read(workspace, index, fitted, control)) is None:
                passed += 1
                continue
            chunk.append(frame)
            if len(chunk) == (1 if few else _CHUNK):
                yield chunk
                chunk = []
        if chunk:
            yield chunk

    with _executor(few) as executor:
        found = executor.map(Work(check, chunks(), frames_in_words))
        with closing(_until_closed(found)) as results:
            for chunk in results:
                for result in chunk:
                    control.emit_partial(result)
                checks += chunk
                if monotonic() - reported > _PROGRESS_S:
                    reported = monotonic()
                    control.progress(passed + len(checks), len(frames))
                if control.cancelled:
                    break
    checked = sum(isinstance(outcome, FrameCheck) for _, outcome in checks)
    if not whole_set or control.cancelled:
        return checked, {}
    index = workspace.index
    return checked, with_set_findings(checks, field, lambda name: workspace.read(index[name]))


def _read(
    workspace: Workspace, index: int, fitted: bool, control: JobControl
) -> FrameToCheck | None:
    """Return a frame; None if it has no annotation, or cannot be read."""
    frame = workspace.frames[index]
    try:
        annotation = workspace.read(index)
        if annotation.annotated:
            picture = frame.image_path
            return FrameToCheck(frame.name, annotation, picture_size(picture), fitted, picture)
    except (InputError, ImageError) as error:
        control.emit_partial((frame.name, str(error)))
    return None


@contextmanager
def _executor(few: bool) -> Iterator[Executor]:
    """A thread would take turns with the interface for as long as it computes."""
    if few:
        yield InProcess()
        return
    from procc_annotator.batch.execution.process_pool import ProcessPool

    with ProcessPool(1) as pool:
        yield pool


def _until_closed(results: Iterator[list[Checked]]) -> Generator[list[Checked], None, None]:
    yield from results
