"""What following leaves of every frame, kept in a temporary file: a shot may have many thousands.

The first few megabytes stay in memory, so that shots of seconds need no file.
"""

from __future__ import annotations

import tempfile
import weakref
from collections.abc import Iterable, Iterator, Sequence
from typing import overload

import numpy as np

from procc_annotator.fit.on_paint.belief import Belief
from procc_annotator.fit.on_paint.beside import FoundAround
from procc_annotator.fit.on_paint.marks import PARAMETERS_FREE, Marks
from procc_annotator.fit.on_paint.result import Worth
from procc_annotator.fit.solving.models import PARAMETERS
from procc_annotator.fit.through_shot.stepping import Stepped
from procc_annotator.fit.through_shot.turning import OWN, Turn

_IN_MEMORY = 4 << 20  # bytes
_ONE = np.dtype(
    [
        ("vector", "f8", len(PARAMETERS)),
        ("information", "f8", (PARAMETERS_FREE, PARAMETERS_FREE)),
        ("worth", "f8", 2),
        ("told", "f8", 4),  # coverage, residual, how surely, how many marks each stands for
        ("turn", "f8", len(OWN)),
        ("turn_covariance", "f8", (len(OWN), len(OWN))),
        ("marks", "i4"),  # how many follow; -1 for none
        ("around", "i4"),
    ]
)
_MARK = np.dtype(
    [
        ("world", "f4", 3),
        ("across", "f4"),
        ("normal", "f4", 2),
        ("element", "i2"),
        ("run", "i2"),
        ("length", "f4"),
    ]
)


def file_of(owner: object) -> tempfile.SpooledTemporaryFile[bytes]:
    """An empty file that is gone when its owner is."""
    file = tempfile.SpooledTemporaryFile(_IN_MEMORY)  # noqa: SIM115  # closed with its owner
    weakref.finalize(owner, file.close)
    return file


class KeptSteps(Sequence[Stepped]):
    """Frames in the order they were put here; each is made anew whenever it is asked for."""

    def __init__(self, steps: Iterable[Stepped] = ()) -> None:
        self._file = file_of(self)
        self._begins = [0]
        self._reasons: list[str] = []  # of most frames the same
        for step in steps:
            self.append(step)

    def __len__(self) -> int:
        return len(self._reasons)

    @overload
    def __getitem__(self, at: int) -> Stepped: ...
    @overload
    def __getitem__(self, at: slice) -> Sequence[Stepped]: ...
    def __getitem__(self, at: int | slice) -> Stepped | Sequence[Stepped]:
        if isinstance(at, slice):
            return StepsOf([(self, place) for place in range(*at.indices(len(self)))])
        place = range(len(self))[at]
        self._file.seek(self._begins[place])
        data = self._file.read(self._begins[place + 1] - self._begins[place])
        return _unpacked(data, self._reasons[place])

    def append(self, step: Stepped) -> None:
        """Put a frame behind the others."""
        data = _packed(step)
        self._file.seek(self._begins[-1])
        self._file.write(data)
        self._begins.append(self._begins[-1] + len(data))
        self._reasons.append(step.reason)

    def pop(self) -> None:
        """Forget the last frame."""
        self._begins.pop()
        self._reasons.pop()


class StepsOf(Sequence[Stepped]):
    """Frames of several runs, in an order of their own."""

    def __init__(self, places: Sequence[tuple[Sequence[Stepped], int]]) -> None:
        self._places = places

    def __len__(self) -> int:
        return len(self._places)

    def __iter__(self) -> Iterator[Stepped]:
        return (steps[place] for steps, place in self._places)

    @overload
    def __getitem__(self, at: int) -> Stepped: ...
    @overload
    def __getitem__(self, at: slice) -> Sequence[Stepped]: ...
    def __getitem__(self, at: int | slice) -> Stepped | Sequence[Stepped]:
        if isinstance(at, slice):
            return StepsOf(self._places[at])
        steps, place = self._places[at]
        return steps[place]


def _packed(step: Stepped) -> bytes:
    one = np.zeros((), _ONE)
    one["vector"], one["information"] = step.belief.vector, step.belief.information
    one["worth"] = step.worth.error_px, step.worth.together
    residual = np.nan if step.residual_px is None else step.residual_px
    one["told"] = step.coverage, residual, step.sd_px, step.standing_for
    one["turn"] = np.nan
    if step.turn is not None:
        one["turn"], one["turn_covariance"] = step.turn.step, step.turn.covariance
    marks, around = step.marks, step.around
    one["marks"] = -1 if marks is None else len(marks)
    one["around"] = -1 if around is None else len(around.marks)
    parts = [one.tobytes()]
    if marks is not None:
        parts.append(_rows_of(marks, np.zeros(len(marks))))
    if around is not None:
        parts.append(_rows_of(around.marks, around.length_px))
    return b"".join(parts)


def _rows_of(marks: Marks, length_px: np.ndarray) -> bytes:
    rows = np.empty(len(marks), _MARK)
    rows["world"], rows["across"], rows["normal"] = marks.world.T, marks.across, marks.normal.T
    rows["element"], rows["run"], rows["length"] = marks.element, marks.run, length_px
    return rows.tobytes()


def _unpacked(data: bytes, reason: str) -> Stepped:
    one = np.frombuffer(data, _ONE, 1)[0]
    coverage, residual, sd_px, standing_for = one["told"].tolist()
    turn = None
    if not np.isnan(one["turn"][0]):
        turn = Turn(one["turn"].copy(), one["turn_covariance"].copy())
    marks, around, begin = None, None, _ONE.itemsize
    count = int(one["marks"])
    if count >= 0:
        marks = _marks_of(np.frombuffer(data, _MARK, count, begin))
        begin += count * _MARK.itemsize
    count = int(one["around"])
    if count >= 0:
        rows = np.frombuffer(data, _MARK, count, begin)
        around = FoundAround(_marks_of(rows), rows["length"].astype(np.float64))
    return Stepped(
        Belief(one["vector"].copy(), one["information"].copy()),
        marks,
        Worth(*one["worth"].tolist()),
        turn,
        coverage,
        None if np.isnan(residual) else residual,
        sd_px,
        reason,
        standing_for,
        around,
    )


def _marks_of(rows: np.ndarray) -> Marks:
    return Marks(
        np.ascontiguousarray(rows["world"].T),
        rows["across"].copy(),
        np.ascontiguousarray(rows["normal"].T),
        rows["element"].copy(),
        rows["run"].copy(),
    )
