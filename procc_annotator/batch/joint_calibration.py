"""Fit frames with shared positions and stadium dimensions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.calibration import Calibrated, model_words, scored
from procc_annotator.batch.grouping import Tags
from procc_annotator.batch.set_run import (
    AnnotationTask,
    CheckpointedRun,
    FrameFile,
    annotation_files,
    reopenable_source,
)
from procc_annotator.calibration.fitting import fit_camera, fit_cameras
from procc_annotator.calibration.joint.field_dimensions import StadiumFit, fit_dimensions
from procc_annotator.calibration.joint.shared_position import (
    PositionGroup,
    SharedPositionResult,
    fit_shared_position,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.dataset.picture_sizes import FitSizes, FrameSize, SizesUsed
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.load import (
    field_for_frame,
    field_for_stadium,
    stadium_of,
    with_dimensions,
)
from procc_annotator.field.model import Field
from procc_annotator.formats.file_source import FileSource
from procc_annotator.metrics.sets import SetAccumulator, SetSummary
from procc_annotator.metrics.setup import EvaluationSetup

# About how often the frames are examined while dimensions are searched, for the progress shown.
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
        size: (width, height) px of the pictures.
        model: P, R or R+.
        names: of dimensions, see `fit_dimensions`.
        progress: takes what is done and the total; may raise to stop.

    Raises:
        UsageError: no frame has a camera to say dimensions from, or no such dimension.
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
    """Progress of a search whose end no one knows: it never passes the total."""

    def __init__(self, progress: Callable[[int, int], None], done: int, total: int) -> None:
        self._progress, self._done, self._total = progress, done, total

    def step(self) -> None:
        """One frame more was examined."""
        self._done = min(self._done + 1, self._total - 1)
        self._progress(self._done, self._total)


# About how often each frame is examined, for the progress shown.
_PASSES = 8
Progress = Callable[[int, int], None]


@dataclass(frozen=True, eq=False)
class IndividualFit:
    """A frame with its own fit.

    Attributes:
        name: the frame.
        error: why its annotation cannot be read; there is nothing else then.
        annotation: what was clicked.
        fit: its camera, or why there is none.
        size: what it was fitted at.
    """

    name: str
    error: str | None = None
    annotation: FrameAnnotation | None = None
    fit: FitResult | None = None
    size: FrameSize | None = None


@dataclass(frozen=True)
class FitChunk(AnnotationTask):
    """Fits chunks of frames, each at its own size."""

    field: Field
    sizes: FitSizes
    model: str

    def __call__(self, chunk: Sequence[FrameFile]) -> tuple[list[IndividualFit], None]:
        found = [self._read(name, file) for name, file in chunk]
        given = [
            (one.annotation, field_for_frame(self.field, one.name), one.size.fitted)
            for one in found
            if one.annotation is not None and one.size is not None
        ]
        fits = iter(fit_cameras(given, model=self.model))
        return [one if one.error else replace(one, fit=next(fits)) for one in found], None

    def _read(self, name: str, file: str) -> IndividualFit:
        try:
            annotation = self.read(file, self.field)
        except InputError as error:
            return IndividualFit(name, error=str(error))
        return IndividualFit(name, None, annotation, None, self.sizes.of_frame(name, annotation))


class SetFits(CheckpointedRun[FrameFile, IndividualFit, None]):
    """The own fits of all frames of a set, and the groups they belong to; None for one group of
    all."""

    task: FitChunk

    def __init__(
        self,
        source: FileSource,
        field: Field,
        sizes: FitSizes,
        model: str,
        groups: Mapping[str, str | None] | None = None,
    ) -> None:
        if model == "H":
            raise UsageError("frames are fitted together with a pinhole: choose P, R or R+, not H")
        super().__init__(
            annotation_files(source), FitChunk(reopenable_source(source), field, sizes, model)
        )
        self.groups = groups

    def _digest(self, chunk: Sequence[FrameFile]) -> str:
        return self.task.input_digest(chunk, self.task.sizes.picture_of)

    def _sums_of(self, results: Sequence[IndividualFit]) -> None:
        return None

    def describe(self, fitted: Sequence[IndividualFit]) -> str:
        """Which models the frames got, in words."""
        fits = [frame.fit for frame in fitted if frame.fit is not None]
        chosen = Counter(fit.model for fit in fits if fit.camera is not None)
        return model_words(self.task.model, chosen)

    def sizes_of(self, fitted: Sequence[IndividualFit]) -> SizesUsed:
        """The sizes that the frames were fitted at."""
        used = SizesUsed(self.task.sizes.asked)
        for frame in fitted:
            if frame.size is not None:
                used.add(frame.size)
        return used

    def _group(self, frame: str) -> str | None:
        if self.groups is not None:
            return self.groups.get(frame)
        return stadium_of(self.task.field, frame) or ""

    def grouped(self, fitted: Sequence[IndividualFit]) -> dict[str, list[IndividualFit]]:
        """Group -> its frames that can be read; frames without a group are in none. Where no groups
        were given, each stadium that the field knows is one, and all other frames are another."""
        found: dict[str, list[IndividualFit]] = {}
        for frame in fitted:
            group = self._group(frame.name)
            if group is not None and frame.error is None:
                found.setdefault(group, []).append(frame)
        return found


@dataclass(frozen=True, eq=False)
class SharedCameraPosition:
    """A position that frames of a group share.

    Attributes:
        name: the group's, with a number where it has several positions.
        tripod: the position.
        frames: number of frames that have it, those that had no camera alone included.
    """

    name: str
    tripod: PositionGroup
    frames: int


class JointRun:
    """The frames of a set, fitted together and scored; a `CalibrationRun` to anyone who reports it.

    Attributes:
        setup, thresholds: what the frames are scored with.
        places: the shared positions.
        apart: frame -> why it shares no position.
        gained: frames that had no camera alone.
        before: figures of the frames' own fits, by threshold.
        sizes: what the frames were fitted at.
    """

    def __init__(
        self,
        fits: SetFits,
        fitted: Sequence[IndividualFit],
        setup: EvaluationSetup,
        thresholds: tuple[float, ...],
        progress: Progress = lambda done, total: None,
    ) -> None:
        self.setup, self.thresholds = setup, thresholds
        self.places: list[SharedCameraPosition] = []
        self.apart: dict[str, str] = {}
        self.gained: list[str] = []
        self.counted = self.with_camera = 0
        self._models: Counter[str] = Counter()
        self._model, self._fitted = fits.task.model, fitted
        self.sizes = fits.sizes_of(fitted)
        self._fits: dict[str, FitResult] = {}
        self._place_of: dict[str, str] = {}
        self._sums = SetAccumulator(setup, thresholds)
        groups = fits.grouped(fitted)
        frames = sum(map(len, groups.values()))
        steps = ProgressSteps(progress, 0, _PASSES * frames + 1)
        for group, members in groups.items():
            self._share(group, members, steps)
        if fits.groups is not None:
            for frame in fitted:
                if frame.fit is not None and fits.groups.get(frame.name) is None:
                    self.apart[frame.name] = "it has no group"
        self.before = _summary(fitted, setup, thresholds)

    @property
    def total(self) -> int:
        """Number of frames."""
        return len(self._fitted)

    @property
    def names(self) -> tuple[str, ...]:
        """The frames, in the order they come."""
        return tuple(frame.name for frame in self._fitted)

    def __iter__(self) -> Iterator[Calibrated]:
        for frame in self._fitted:
            if frame.annotation is None or frame.fit is None:
                yield Calibrated(frame.name, self._model, error=frame.error)
                continue
            self.counted += 1
            fit = self._fits.get(frame.name, frame.fit)
            place = self._place_of.get(frame.name, "")
            done = scored(frame.name, frame.annotation, fit, self._sums, place, frame.size)
            self.with_camera += done.has_camera
            self._models.update([done.model] if done.has_camera else [])
            yield done

    def summary(self) -> dict[float, SetSummary]:
        """Figures of the frames seen so far, by threshold."""
        return self._sums.summary()

    def describe(self) -> str:
        """Model, protocol, size and what else the figures depend on, in words."""
        model = model_words(self._model, self._models)
        described = self.setup.describe(sizes=self.sizes.describe())
        return f"{model}, shared positions, {described}"

    def _share(self, group: str, members: Sequence[IndividualFit], steps: ProgressSteps) -> None:
        shared = _shared(members, self.setup.field, steps)
        self._fits.update(shared.fits)
        self.apart.update(shared.apart)
        self.gained += shared.gained
        names = []
        for number, tripod in enumerate(shared.groups, start=1):
            several = len(shared.groups) > 1
            name = " ".join(filter(None, (group, str(number) if several or not group else "")))
            frames = sum(index == number - 1 for index in shared.group_of.values())
            names.append(name)
            self.places.append(SharedCameraPosition(name, tripod, frames))
        self._place_of.update({frame: names[i] for frame, i in shared.group_of.items()})


@dataclass(frozen=True, eq=False)
class FieldSize:
    """The dimensions of one group's stadium.

    Attributes:
        group: its name; empty if all frames are one.
        stadium: the dimensions; None if undetermined.
        failure: why not.
        before, after: figures of the frames' own cameras on the field as given, and with the
            dimensions that are determined, by threshold.
    """

    group: str
    stadium: StadiumFit | None
    failure: str = ""
    before: Mapping[float, SetSummary] = field(default_factory=dict)
    after: Mapping[float, SetSummary] = field(default_factory=dict)


def find_field_sizes(
    fits: SetFits,
    fitted: Sequence[IndividualFit],
    setup: EvaluationSetup,
    thresholds: tuple[float, ...],
    names: Sequence[str] | None = None,
    progress: Progress = lambda done, total: None,
) -> list[FieldSize]:
    """The dimensions of the stadium of every group; frames are scored before and after.

    Args:
        names: of dimensions, see `fit_dimensions`.
        progress: takes what is done and the total.

    Raises:
        UsageError: a dimension that cannot be fitted.
    """
    groups = fits.grouped(fitted)
    steps = ProgressSteps(progress, 0, _PASSES * sum(map(len, groups.values())) + 1)
    return [
        _field_size(group, members, setup, thresholds, names, steps)
        for group, members in groups.items()
    ]


def _field_size(
    group: str,
    members: Sequence[IndividualFit],
    setup: EvaluationSetup,
    thresholds: tuple[float, ...],
    names: Sequence[str] | None,
    steps: ProgressSteps,
) -> FieldSize:
    annotations, alone = _own(members)
    if not any(fit.camera is not None for fit in alone.values()):
        return FieldSize(group, None, "no frame has a camera that determines dimensions")
    # What is kept of the stadium already: a dimension that is not determined stays so.
    known = replace(field_for_stadium(setup.field, group), stadiums=None)
    stadium = fit_dimensions(annotations, alone, known, names=names, on_step=steps.step)
    there = {d.name: d.value for d in known.dimensions} | stadium.values
    sized = with_dimensions(known, there, related=False)
    again = []
    for frame in members:
        steps.step()
        assert frame.annotation is not None  # it can be read
        assert frame.fit is not None
        camera, model = frame.fit.camera, frame.fit.model
        fit = frame.fit
        if camera is not None:
            fit = fit_camera(
                frame.annotation, sized, model=model, size=frame.fit.size, start=camera
            )
        again.append(IndividualFit(frame.name, None, frame.annotation, fit))
    after = EvaluationSetup(
        sized, setup.size, setup.protocol, setup.allow_mirrored, setup.off_plane, setup.planar_only
    )
    return FieldSize(
        group,
        stadium,
        before=_summary(members, setup, thresholds),
        after=_summary(again, after, thresholds),
    )


def read_groups(path: Path, of_set: str) -> dict[str, str | None]:
    """Frame -> its group, from a CSV file of tags; several tags make a group together.

    Raises:
        InputError: it is no such file.
    """
    tags = Tags.read(path)
    grouping = tags.grouping(tags.columns, of_set)
    return {
        frame: " ".join(value for value in values if value) or None
        for frame, values in grouping.values.items()
    }


def _shared(
    members: Sequence[IndividualFit], field: Field, steps: ProgressSteps
) -> SharedPositionResult:
    annotations, alone = _own(members)
    of_stadiums = {stadium_of(field, name) for name in annotations}
    if len(of_stadiums) == 1:
        field = field_for_stadium(field, of_stadiums.pop())
    return fit_shared_position(annotations, alone, field, on_step=steps.step)


def _own(
    members: Sequence[IndividualFit],
) -> tuple[dict[str, FrameAnnotation], dict[str, FitResult]]:
    annotations = {f.name: f.annotation for f in members if f.annotation is not None}
    return annotations, {f.name: f.fit for f in members if f.fit is not None}


def _summary(
    fitted: Sequence[IndividualFit], setup: EvaluationSetup, thresholds: tuple[float, ...]
) -> dict[float, SetSummary]:
    sums = SetAccumulator(setup, thresholds)
    for frame in fitted:
        if frame.annotation is not None and frame.fit is not None:
            scored(frame.name, frame.annotation, frame.fit, sums)
    return sums.summary()
