"""The label check of a whole set, beside the window's work."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Generator, Iterator
from contextlib import closing, contextmanager
from time import monotonic

from PySide6.QtCore import QObject

from procc_annotator.errors import ImageError, InputError
from procc_annotator.field.model import Field
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.report.picture_sizes import picture_size
from procc_annotator.session.execution.annotated_set import first_to_last
from procc_annotator.session.execution.executor import Executor, InProcess
from procc_annotator.session.execution.process_pool import ProcessPool
from procc_annotator.session.frame_check import CheckFrames, FrameCheck, FrameToCheck
from procc_annotator.session.workspace import Workspace

Checked = tuple[str, FrameCheck | str]  # a frame's name; what was found, or why nothing could be

_CHUNK = 8  # frames a process takes at once: about half a second's work
_FEW = 16  # frames that are checked sooner than a process has started
_TELL_AFTER_S = 0.25


def check_in_background(
    workspace: Workspace,
    field: Field,
    model: str,
    arrived: deque[Checked],
    *,
    on_progress: Callable[[int, int], None],
    on_done: Callable[[int], None],
    on_error: Callable[[str], None],
    owner: QObject,
) -> Job:
    """Check every annotated frame of a dataset in a process of its own.

    A thread would take turns with the interface for as long as it computes.

    Args:
        workspace: its frames as they are now, saved or not.
        field: its elements.
        model: of the camera that is fitted.
        arrived: gets the outcome of every annotated frame, before its progress is told.
        on_progress: receives (frames looked at, of how many).
        on_done: receives the number of frames that were checked.
        on_error: receives why it could not go on.
        owner: nothing is delivered any more once this object is gone.
    """

    def work(control: JobControl) -> int:
        few = len(workspace.frames) <= _FEW
        walk = _Walk(workspace, arrived, control)
        with _executor(few) as executor:
            found = executor.map(
                CheckFrames(field, model), walk.chunks(1 if few else _CHUNK), name=_frames_of
            )
            with closing(_until_closed(found)) as results:
                for result in results:
                    walk.take(result)
                    if control.cancelled:
                        break
        return walk.checked

    return run_in_background(
        work, on_result=on_done, on_error=on_error, on_progress=on_progress, owner=owner
    )


class _Walk:
    """Reads a dataset's frames as they are wanted and counts what came of them."""

    def __init__(self, workspace: Workspace, arrived: deque[Checked], control: JobControl) -> None:
        self._workspace = workspace
        self._arrived = arrived
        self._control = control
        self._passed = 0  # frames that nobody has to check, or that cannot be read
        self._answered = 0
        self._told = monotonic()
        self.checked = 0

    def chunks(self, size: int) -> Iterator[list[FrameToCheck]]:
        """Annotated frames, some at a time."""
        chunk: list[FrameToCheck] = []
        for index in range(len(self._workspace.frames)):
            if self._control.cancelled:
                return
            frame = self._read(index)
            if frame is None:
                self._passed += 1
                continue
            chunk.append(frame)
            if len(chunk) == size:
                yield chunk
                chunk = []
        if chunk:
            yield chunk

    def _read(self, index: int) -> FrameToCheck | None:
        frame = self._workspace.frames[index]
        try:
            annotation = self._workspace.read(index)
            if annotation.annotated:
                return FrameToCheck(frame.name, annotation, picture_size(frame.image_path))
        except (InputError, ImageError) as error:
            self._arrived.append((frame.name, str(error)))
        return None

    def take(self, results: list[Checked]) -> None:
        """Hand over what was found in a chunk, and say how far it is now and then."""
        self._arrived.extend(results)
        self._answered += len(results)
        self.checked += sum(isinstance(outcome, FrameCheck) for _, outcome in results)
        if monotonic() - self._told > _TELL_AFTER_S:
            self._told = monotonic()
            self._control.progress(self._passed + self._answered, len(self._workspace.frames))


@contextmanager
def _executor(few: bool) -> Iterator[Executor]:
    if few:
        yield InProcess()
        return
    with ProcessPool(1) as pool:
        yield pool


def _until_closed(results: Iterator[list[Checked]]) -> Generator[list[Checked], None, None]:
    yield from results


def _frames_of(chunk: list[FrameToCheck]) -> str:
    return first_to_last(chunk[0].name, chunk[-1].name)
