"""The label check of many frames, next to the window's work."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from contextlib import closing, contextmanager
from time import monotonic

from PySide6.QtCore import QObject, Signal

from procc_annotator.batch.execution.executor import Executor, InProcess
from procc_annotator.batch.label_check import Checked, CheckFrames, FrameToCheck, with_set_findings
from procc_annotator.batch.set_run import frames_in_words
from procc_annotator.dataset.picture_sizes import picture_size
from procc_annotator.dataset.review import FrameCheck
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ImageError, InputError
from procc_annotator.field.model import Field
from procc_annotator.gui.latest import Latest
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
