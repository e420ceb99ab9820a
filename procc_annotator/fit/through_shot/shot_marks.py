"""The marks of all frames of a shot as arrays, some hundred frames at a time: the rest waits in a
temporary file, its first few megabytes in memory."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.on_paint.marks import Floats, Integers
from procc_annotator.fit.solving.observations import FloatArray, IntArray
from procc_annotator.fit.through_shot.kept_steps import file_of
from procc_annotator.fit.through_shot.stepping import Stepped

_AT_ONCE = 128  # frames


@dataclass(frozen=True, eq=False)
class MarksOfSome:
    """The marks of b frames, m of each.

    Attributes:
        world: (b, 3, m) metres.
        across: (b, m) solver px.
        normal: (b, 2, m).
        trust: (b, m) inverse variances; 0 where a frame has fewer.
        element: (b, m) which element each is on.
    """

    world: Floats
    across: Floats
    normal: Floats
    trust: Floats
    element: Integers


class ShotMarks:
    """What smoothing needs of K frames.

    Attributes:
        vectors: (K, 11) where following left their cameras.
        coverages: (K,).
        elements: (E,) that any mark is on.
    """

    vectors: FloatArray
    coverages: FloatArray
    elements: IntArray

    def __init__(self, steps: Iterable[Stepped]) -> None:
        self._file = file_of(self)
        self._parts: list[tuple[int, int, int]] = []  # where it begins, its frames, marks of each
        vectors, coverages, elements = [], [], set[int]()
        some: list[Stepped] = []
        for step in steps:
            vectors.append(step.belief.vector)
            coverages.append(step.coverage)
            if step.marks is not None:
                elements.update(step.marks.element.tolist())
            some.append(step)
            if len(some) == _AT_ONCE:
                self._put(some)
                some = []
        if some:
            self._put(some)
        self.vectors, self.coverages = np.array(vectors), np.array(coverages)
        self.elements = np.array(sorted(elements), dtype=np.intp)

    def parts(self) -> Iterator[tuple[slice, MarksOfSome]]:
        """All frames, some at a time."""
        first = 0
        for begin, frames, most in self._parts:
            kind = _kind(most)
            self._file.seek(begin)
            rows = np.frombuffer(self._file.read(frames * kind.itemsize), kind)
            yield (
                slice(first, first + frames),
                MarksOfSome(*(rows[name] for name in kind.names or ())),
            )
            first += frames

    def _put(self, steps: list[Stepped]) -> None:
        # One at least, which counts nothing: frames without any would have no length in the file.
        most = max([1, *(len(step.marks) for step in steps if step.marks is not None)])
        rows = np.zeros(len(steps), _kind(most))
        for row, step in zip(rows, steps, strict=True):
            marks = step.marks
            if marks is None:
                continue
            own = len(marks)
            row["world"][:, :own], row["across"][:own] = marks.world, marks.across
            row["normal"][:, :own], row["element"][:own] = marks.normal, marks.element
            # Of the marks that were found some were kept, which stand for all of them.
            row["trust"][:own] = step.standing_for / step.worth.information_px**2
        self._parts.append((self._file.tell(), len(steps), most))
        self._file.write(rows.tobytes())


def _kind(most: int) -> np.dtype[np.void]:
    """How a frame is written, in the order of `MarksOfSome`."""
    return np.dtype(
        [
            ("world", "f4", (3, most)),
            ("across", "f4", (most,)),
            ("normal", "f4", (2, most)),
            ("trust", "f4", (most,)),
            ("element", "i2", (most,)),
        ]
    )
