"""Which frames' labels are checked next to the window's work: the whole set, and edited ones."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from contextlib import closing, contextmanager
from time import monotonic

from PySide6.QtCore import QObject, QTimer, Signal

from procc_annotator.batch.execution.executor import Executor, InProcess
from procc_annotator.batch.label_check import Checked, CheckFrames, FrameToCheck, with_set_findings
from procc_annotator.batch.set_run import frames_in_words
from procc_annotator.dataset.picture_sizes import picture_size
from procc_annotator.dataset.review import FrameCheck
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ImageError, InputError
from procc_annotator.field.model import Field
from procc_annotator.gui.latest import Latest
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.saying import say
from procc_annotator.gui.state.store import Store
from procc_annotator.gui.worker import JobControl

FrameToRead = tuple[int, bool]  # a frame's place in the dataset, and whether to fit a camera
_Answer = tuple[int, dict[str, FrameCheck]]  # frames checked; see `told`

_CHUNK = 8  # frames a process takes at once: about half a second's work
_FEW = 16  # frames that are checked sooner than a process has started
_TELL_AFTER_S = 0.25


class BackgroundCheck(QObject):
    """Checks frames in a process of its own: a thread would take turns with the interface for as
    long as it computes."""

    arrived = Signal(list)  # what was found: `Checked` each
    progressed = Signal(int, int)  # frames looked at, of how many; (0, 0) when it is over
    finished = Signal(int)  # frames that were checked; not after `stop`
    failed = Signal(str)  # why it could not go on
    told = Signal(dict)  # checks that got a finding from the set: name -> `FrameCheck`

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._work = Latest(self, self._fail)

    @property
    def running(self) -> bool:
        """Return whether frames are being checked."""
        return self._work.running

    def start(
        self,
        workspace: Workspace,
        frames: Sequence[FrameToRead],
        field: Field,
        model: str,
        *,
        together: bool = False,
    ) -> None:
        """Check frames, those that are annotated; whatever is under way is given up.

        Args:
            workspace: its frames as they are when it is their turn, saved or not.
            frames: which of them.
            field: its elements.
            model: of the cameras that are fitted.
            together: whether to look at what only all of them say.
        """
        self.stop()

        def work(control: JobControl) -> _Answer:
            few = len(frames) <= _FEW
            walk = _Walk(workspace, frames, control)
            with _executor(few) as executor:
                chunks = walk.chunks(1 if few else _CHUNK)
                found = executor.map(CheckFrames(field, model), chunks, name=frames_in_words)
                with closing(_until_closed(found)) as results:
                    for result in results:
                        walk.take(result)
                        if control.cancelled:
                            break
            set_tells = together and not control.cancelled
            return walk.checked, walk.told_by_set(field) if set_tells else {}

        self._work.start(work, self._finish, progress=self.progressed.emit, parts=self.arrived.emit)
        self.progressed.emit(0, len(frames))

    def stop(self) -> None:
        """Check no more; what was found so far arrives."""
        if self._work.cut_short():
            self.progressed.emit(0, 0)

    def close(self) -> None:
        """Check no more, and say nothing."""
        self._work.cancel()

    def _finish(self, answer: _Answer) -> None:
        checked, found = answer
        self.progressed.emit(0, 0)
        self.told.emit(found)
        self.finished.emit(checked)

    def _fail(self, text: str) -> None:
        self.progressed.emit(0, 0)
        self.failed.emit(text)


class _Walk:
    """Reads a dataset's frames as they are wanted and counts what came of them."""

    def __init__(
        self,
        workspace: Workspace,
        frames: Sequence[FrameToRead],
        control: JobControl,
    ) -> None:
        self._workspace = workspace
        self._frames = frames
        self._control = control
        self._passed = 0  # frames that nobody has to check, or that cannot be read
        self._answered = 0
        self._told = monotonic()
        self._checks: list[Checked] = []
        self.checked = 0

    def chunks(self, size: int) -> Iterator[list[FrameToCheck]]:
        """Annotated frames, some at a time."""
        chunk: list[FrameToCheck] = []
        for each in self._frames:
            if self._control.cancelled:
                return
            frame = self._read(*each)
            if frame is None:
                self._passed += 1
                continue
            chunk.append(frame)
            if len(chunk) == size:
                yield chunk
                chunk = []
        if chunk:
            yield chunk

    def _read(self, index: int, fitted: bool) -> FrameToCheck | None:
        frame = self._workspace.frames[index]
        try:
            annotation = self._workspace.read(index)
            if annotation.annotated:
                size = picture_size(frame.image_path)
                return FrameToCheck(frame.name, annotation, size, fitted)
        except (InputError, ImageError) as error:
            self._control.hand_over((frame.name, str(error)))
        return None

    def take(self, results: list[Checked]) -> None:
        """Hand over what was found in a chunk, and say how far it is now and then."""
        for result in results:
            self._control.hand_over(result)
        self._answered += len(results)
        self._checks += results
        self.checked += sum(isinstance(outcome, FrameCheck) for _, outcome in results)
        if monotonic() - self._told > _TELL_AFTER_S:
            self._told = monotonic()
            self._control.progress(self._passed + self._answered, len(self._frames))

    def told_by_set(self, field: Field) -> dict[str, FrameCheck]:
        """The checks that get a finding once the frames are examined together."""
        index = self._workspace.index
        return with_set_findings(
            self._checks, field, lambda name: self._workspace.read(index[name])
        )


@contextmanager
def _executor(few: bool) -> Iterator[Executor]:
    if few:
        yield InProcess()
        return
    from procc_annotator.batch.execution.process_pool import ProcessPool

    with ProcessPool(1) as pool:
        yield pool


def _until_closed(results: Iterator[list[Checked]]) -> Generator[list[Checked], None, None]:
    yield from results


_PATIENCE_MS = 400  # what is on screen is worked out before the frames that were left


class CheckQueue(QObject):
    """Has the whole set checked when asked, and edited frames once they were left.

    The frame on screen is not its business.
    """

    arrived = Signal(list)  # what was found: `Checked` each
    progressed = Signal(int, int)  # frames of the set checked, of how many; (0, 0): it is over
    told = Signal(dict)  # checks that got a finding from the set: name -> `FrameCheck`
    finished = Signal(int)  # frames of the set that were checked

    def __init__(self, store: Store, live_fit: LiveFit, parent: QObject) -> None:
        super().__init__(parent)
        self._store, self._live_fit = store, live_fit
        self._edited: dict[str, None] = {}  # frames that nobody has checked since
        self._set_run, self._edited_run = BackgroundCheck(self), BackgroundCheck(self)
        self._soon = QTimer(self, singleShot=True, interval=_PATIENCE_MS)
        self._soon.timeout.connect(self._check_edited)
        for run in (self._set_run, self._edited_run):
            run.arrived.connect(self.arrived)
            run.failed.connect(self._say_failed)
            run.progressed.connect(self._go_on)
        self._set_run.progressed.connect(self.progressed)
        self._set_run.told.connect(self.told)
        self._set_run.finished.connect(self.finished)
        store.watch(select.frame, self._soon.start)

    @property
    def running(self) -> bool:
        """Return whether the set is being checked."""
        return self._set_run.running

    def check_set(self) -> None:
        """Check every annotated frame, with a camera where one may be fitted."""
        state, workspace = self._store.state, self._store.state.workspace
        if workspace is not None:
            names = enumerate(frame.name for frame in workspace.frames)
            frames = [(index, state.reveals(name)) for index, name in names]
            model = self._live_fit.model
            self._set_run.start(workspace, frames, state.field, model, together=True)

    def stop(self) -> None:
        """Stop checking the set; what was found so far arrives."""
        self._set_run.stop()

    def add(self, frame: str) -> None:
        """A frame was edited: it is checked once it is not on screen, unless `drop` comes first."""
        self._edited[frame] = None
        self._soon.start()

    def drop(self, frame: str) -> None:
        """A frame has been checked as it is."""
        self._edited.pop(frame, None)

    def close(self) -> None:
        """Stop everything and forget which frames are waiting."""
        self._edited.clear()
        self._soon.stop()
        self._set_run.close()
        self._edited_run.close()

    def _go_on(self, _: int, total: int) -> None:
        if not total:
            self._soon.start()

    def _check_edited(self) -> None:
        state, workspace = self._store.state, self._store.state.workspace
        if workspace is None or self._edited_run.running or self._set_run.running:
            return  # the end of either begins anew
        here = state.frame_name or ""
        names = [name for name in self._edited if name != here and name in workspace.index]
        self._edited = {here: None} if here in self._edited else {}
        if names:
            wanted = self._live_fit.wanted
            frames = [(workspace.index[name], wanted and state.reveals(name)) for name in names]
            self._edited_run.start(workspace, frames, state.field, self._live_fit.model)

    def _say_failed(self, text: str) -> None:
        say(self._store, text, "error")
