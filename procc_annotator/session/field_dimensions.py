"""The dimensions of a dataset's field: kept in its workspace, found from all of its frames."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import FieldError, InputError
from procc_annotator.field.load import resized
from procc_annotator.field.model import Field
from procc_annotator.fit.fitting import fit_camera
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.together.stadium import StadiumFit, fit_dimensions
from procc_annotator.session.workspace_database.database import WorkspaceDatabase

SETTING = "field_dimensions"
# About how often the frames are looked at while dimensions are searched, for the progress shown.
_PASSES = 5


@dataclass(frozen=True)
class KeptDimensions:
    """What a workspace keeps of its field.

    Attributes:
        values: metres, by name; empty where all are nominal.
        problem: why what is kept cannot be used; empty if it can.
    """

    values: Mapping[str, float]
    problem: str = ""


def kept_dimensions(database: WorkspaceDatabase, field: Field) -> KeptDimensions:
    """The dimensions that a dataset was given.

    Args:
        database: of its workspace.
        field: the one that is annotated; what was kept for another field is none.
    """
    return kept_dimensions_of(database.settings(), field)


def kept_dimensions_of(settings: Mapping[str, str], field: Field) -> KeptDimensions:
    """The same from the settings of a workspace, by key."""
    text = settings.get(SETTING)
    if text is None:
        return KeptDimensions({})
    try:
        kept = json.loads(text)
        name, values = kept["field"], {str(k): float(v) for k, v in kept["dimensions"].items()}
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        said = f"the dimensions of the field kept with the dataset cannot be read: {error!r}"
        return KeptDimensions({}, said)
    if name != field.name:
        return KeptDimensions({})
    try:
        resized(field, values)
    except FieldError as error:
        said = f"the dimensions of the field kept with the dataset are not used: {error}"
        return KeptDimensions({}, said)
    return KeptDimensions(values)


def keep_dimensions(database: WorkspaceDatabase, field: Field) -> None:
    """Let a dataset have the dimensions of this field; nominal ones are kept as nothing."""
    own = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
    text = json.dumps({"field": field.name, "dimensions": own}) if own else None
    database.set_setting(SETTING, text)


def add_dimensions(database: WorkspaceDatabase, field: Field, found: Mapping[str, float]) -> Field:
    """Let a dataset have dimensions that were found, and otherwise those it was given before.

    Args:
        database: of its workspace.
        field: what they were found with; dimensions of it that are not nominal were asked for.
        found: metres, by name.

    Returns:
        The dataset's field.

    Raises:
        FieldError: together they are no field.
    """
    asked_for = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
    before = kept_dimensions(database, field).values
    sized = resized(field, {**before, **asked_for, **found})
    keep_dimensions(database, sized)
    return sized


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
    total = (1 + _PASSES) * len(read)
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
    steps = Steps(progress, len(read), total)
    stadium = fit_dimensions(annotations, alone, field, names=names, on_step=steps.step)
    return Estimate(stadium, tuple(unreadable))


class Steps:
    """Progress of a search whose end nobody knows: it never passes the total."""

    def __init__(self, progress: Callable[[int, int], None], done: int, total: int) -> None:
        self._progress, self._done, self._total = progress, done, total

    def step(self) -> None:
        """One frame more was looked at."""
        self._done = min(self._done + 1, self._total - 1)
        self._progress(self._done, self._total)
