"""The dimensions of a field, found from all frames of a set."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.field.model import Field
from procc_annotator.fit.fitting import fit_camera
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.together.stadium import StadiumFit, fit_dimensions

# About how often the frames are looked at while dimensions are searched, for the progress shown.
_ESTIMATE_PASSES = 5


@dataclass(frozen=True)
class Estimate:
    """Dimensions found from a set.

    Attributes:
        stadium: the dimensions.
        unreadable: frames whose annotation cannot be read; they take no part.
    """

    stadium: StadiumFit
    unreadable: tuple[str, ...] = ()


def estimate_dimensions(
    read: Mapping[str, Callable[[], FrameAnnotation]],
    field: Field,
    *,
    size: tuple[int, int],
    model: str = "R",
    names: Sequence[str] | None = None,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Estimate:
    """Find dimensions from all frames of a set.

    Args:
        read: frame -> reads its annotation.
        field: the elements.
        size: (width, height) px of the pictures.
        model: P, R or R+.
        names: of dimensions, see `fit_dimensions`.
        progress: takes what is done and the total; may raise to stop.

    Raises:
        UsageError: no frame has a camera to tell dimensions from, or no such dimension.
    """
    annotations: dict[str, FrameAnnotation] = {}
    alone: dict[str, FitResult] = {}
    unreadable: list[str] = []
    total = (1 + _ESTIMATE_PASSES) * len(read)
    for done, (name, read_one) in enumerate(read.items()):
        progress(done, total)
        try:
            annotation = read_one()
        except InputError:
            unreadable.append(name)
            continue
        if annotation.annotated:
            annotations[name] = annotation
            alone[name] = fit_camera(annotation, field, model=model, size=size)
    steps = ProgressSteps(progress, len(read), total)
    stadium = fit_dimensions(annotations, alone, field, names=names, on_step=steps.step)
    return Estimate(stadium, tuple(unreadable))


class ProgressSteps:
    """Progress of a search whose end nobody knows: it never passes the total."""

    def __init__(self, progress: Callable[[int, int], None], done: int, total: int) -> None:
        self._progress, self._done, self._total = progress, done, total

    def step(self) -> None:
        """One frame more was looked at."""
        self._done = min(self._done + 1, self._total - 1)
        self._progress(self._done, self._total)
