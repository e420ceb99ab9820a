"""What the commands say of sets: reports, many methods, agreement of annotators, two methods."""

from __future__ import annotations

import datetime
import json
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypedDict, Unpack

from procc_annotator.annotation import FrameAnnotation, as_size
from procc_annotator.api.inputs import (
    as_annotation,
    as_frame_names,
    as_optional_size,
    as_path,
    as_whole_number,
    kind_of,
)
from procc_annotator.api.loading import Dataset, as_dataset
from procc_annotator.api.methods import CamerasInMemory, Method, cameras_of
from procc_annotator.batch.agreement import agreement_run
from procc_annotator.batch.comparison import ComparisonRun
from procc_annotator.batch.execution.executor import Executor, make_executor
from procc_annotator.batch.grouping import NotInOrderError, shots_by_name
from procc_annotator.batch.set_run import annotations_for, frames_of_all
from procc_annotator.calibration.fitting import DEFAULT_SIZE
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.errors import ProccError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.figures.disagreement import DisagreementPainter
from procc_annotator.figures.overlay import PlainPictures
from procc_annotator.formats.annotations.soccernet import write_annotation
from procc_annotator.formats.atomic import make_folder
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.frame_names import files_of_frames
from procc_annotator.interaction.palette import SOURCE_COLOURS
from procc_annotator.messages import condensed
from procc_annotator.metrics.setup import EvaluationSetup, check_thresholds
from procc_annotator.metrics.statistics.intervals import BootstrapSettings
from procc_annotator.report.agreement import compare_annotators as agreement_of
from procc_annotator.report.comparison import compare_sources, write_comparison
from procc_annotator.report.consensus import write_agreement
from procc_annotator.report.outputs import open_target
from procc_annotator.report.overlay_scene import OverlayLook
from procc_annotator.report.page import report
from procc_annotator.report.page.report_data import ReportWork, gather_report
from procc_annotator.report.scores.inference import InferenceSettings
from procc_annotator.report.scores.scoring import EvaluationRequest, Evaluations
from procc_annotator.report.temporal import TemporalMetrics, measure_over_time, over_time_entries

_FEWEST_RESAMPLES = 100
Annotations = Mapping[str, FrameAnnotation] | Dataset | str | Path


class SetOptions(TypedDict, total=False):
    """How annotations and methods are compared, as of `evaluate_set`; ``workers``: processes that
    share the work if all methods are files, 1 if not given, 0 for as many as the machine has."""

    field: Field | str | None
    size: tuple[int, int]
    camera_size: tuple[int, int] | None
    protocol: str
    allow_mirrored: bool
    off_plane: str
    planar_only: bool
    workers: int


@dataclass(frozen=True)
class _Opened:
    name: str
    source: FileSource
    cameras: dict[str, CameraCollection]
    setup: EvaluationSetup
    camera_size: tuple[int, int] | None
    pictures: Mapping[str, Path]
    executor: Executor
    folder: Path

    @property
    def sets(self) -> list[CameraSet]:
        return [CameraSet(one, name, self.camera_size) for name, one in self.cameras.items()]

    @property
    def requests(self) -> list[EvaluationRequest]:
        return [
            EvaluationRequest(
                self.name, method, self.source, one, self.setup, camera_size=self.camera_size
            )
            for method, one in self.cameras.items()
        ]

    def over_time(self, threshold: float) -> list[TemporalMetrics]:
        """Of each method, over the shots that the names of all frames tell."""
        tables = [one.frames for one in self.cameras.values()]
        shots = shots_by_name(frames_of_all(annotations_for(tables[0], self.source), tables))
        known = shots, "by the names of frames", dict[str, Path]()
        try:
            return [measure_over_time(r, known, threshold, self.executor) for r in self.requests]
        except NotInOrderError as error:
            warnings.warn(f"nothing is measured over time: {error}", stacklevel=3)
            return []


@contextmanager
def _opened(
    annotations: Annotations,
    methods: Mapping[str, Any],
    options: SetOptions,
    every_frame: bool = False,
    title: str = "annotations",
) -> Iterator[_Opened]:
    """Annotations and methods as the commands read them; annotations that are given as values are
    written to a folder that is removed afterwards, under ``title``. With ``every_frame`` functions
    are called for the frames of all methods, not only for those annotated."""
    if not isinstance(methods, Mapping) or not all(isinstance(name, str) for name in methods):
        raise UsageError(f"methods: expected them by name, found {kind_of(methods)}")
    if unknown := options.keys() - SetOptions.__annotations__.keys():
        raise UsageError(
            f"no option {min(unknown)!r}; there are {', '.join(SetOptions.__annotations__)}"
        )
    with ExitStack() as opened:
        folder = Path(opened.enter_context(TemporaryDirectory(prefix="procc-")))
        dataset = as_dataset(annotations, options.get("field"), title)
        known, name, frames = dataset.field, dataset.path.name, dataset.annotations
        place = folder / "annotations"
        make_folder(place)
        with open_target(place) as target:
            for frame, file in files_of_frames(frames, ".json").items():
                target.write(file, write_annotation(as_annotation(frames[frame])))
        setup = EvaluationSetup(
            known, as_size(options.get("size", DEFAULT_SIZE)), options.get("protocol", "soccernet"),
            options.get("allow_mirrored", False), options.get("off_plane", "missed"),
            options.get("planar_only", False),
        )  # fmt: skip
        own = as_optional_size(options.get("camera_size"))
        cameras: dict[str, CameraCollection] = {}
        for called, method in sorted(methods.items(), key=lambda item: callable(item[1])):
            if isinstance(method, str | Path):
                there = CameraCollection.open(Path(method), field=known)
                cameras[called] = opened.enter_context(there)
                continue
            names = dict.fromkeys(frames)
            if every_frame and callable(method):
                names = frames_of_all(frames, (one.frames for one in cameras.values()))
            cameras[called] = CamerasInMemory(cameras_of(method, names, called), called, known)
        cameras = {called: cameras[called] for called in methods}
        of_files = not any(isinstance(one, CamerasInMemory) for one in cameras.values())
        workers = as_whole_number(options.get("workers", 1), "workers", 0) or None
        source = opened.enter_context(open_annotations(place, known))
        executor = opened.enter_context(make_executor(workers if of_files else 1))
        try:
            yield _Opened(name, source, cameras, setup, own, dataset.pictures, executor, folder)
        except UsageError as error:  # may name the folder, which no caller knows
            raise UsageError(str(error).replace(str(place), name)) from None


def _require_methods(methods: object) -> None:
    if not methods:
        raise UsageError("there is no method to evaluate")
    if isinstance(methods, Mapping) and not all(str(name).strip() for name in methods):
        raise UsageError("methods: expected a name for each, found an empty one")


def _warn_of(notices: Mapping[str, Mapping[str, int]]) -> None:
    """Warn of the remarks on each method."""
    for name, of_method in notices.items():
        for notice, count in condensed(of_method).items():
            cameras = f" ({count} cameras)" if count > 1 else ""
            warnings.warn(f"{name}: {notice}{cameras}", stacklevel=3)


def _pairs(given: Sequence[Any]) -> tuple[tuple[str, str], ...]:
    """Pairs of names; a single pair is one."""
    pairs = [given] if len(given) == 2 and all(isinstance(name, str) for name in given) else given
    if not all(isinstance(pair, Sequence) and len(pair) == 2 for pair in pairs):
        raise UsageError(f"disagreement: expected pairs of names of methods, found {given!r}")
    return tuple((pair[0], pair[1]) for pair in pairs)


def _content(path: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(path.read_bytes())
    return found


def write_report(
    path: str | Path | Sequence[str | Path],
    annotations: Annotations,
    methods: Mapping[str, Any],
    *,
    thresholds: float | Sequence[float] = (5.0, 2.0, 10.0),
    title: str = "",
    over_time: bool = False,
    disagreement: Sequence[tuple[str, str]] = (),
    seed: int = 1,
    **options: Unpack[SetOptions],
) -> tuple[str, ...]:
    """Write the page, tables and figures of the command ``report``.

    Args:
        path: files that end in .html, .csv, .json or .tex; one or several.
        annotations: as of `evaluate_set`.
        methods: name -> cameras: the path of their files, cameras by frame name, a list of them in
            the order of the frames, or a function of the frame's name.
        thresholds: px, the leading one first.
        title: of the page.
        over_time: whether jitter and jumps are reported, too.
        disagreement: pairs of methods to compare on the ground.
        seed: of random frames and resamples.
        **options: see `SetOptions`.

    Returns:
        One line each: what could not be used.

    Raises:
        UsageError: an argument of another kind, or nothing to report. InputError: a file.
        SaveError: a file cannot be written.
    """
    files = [as_path(one, "a report") for one in ([path] if isinstance(path, str | Path) else path)]
    if not files:
        raise UsageError("path: expected a file to write, found none")
    kinds, chosen = set(map(report.report_kind, files)), check_thresholds(thresholds)
    _require_methods(methods)
    with _opened(annotations, methods, options, over_time) as one:
        today = datetime.date.today().isoformat()
        request = report.ReportRequest(
            title or f"Cameras of {one.name}", today, seed=seed, disagreement=_pairs(disagreement)
        )
        report.check_request(request, list(one.cameras))
        work, settings = (
            ReportWork(one.executor),
            InferenceSettings(draws=BootstrapSettings(seed=as_whole_number(seed, "seed", 0))),
        )
        gathered = gather_report(one.requests, chosen, work, settings)
        steady = tuple(one.over_time(chosen[0])) if over_time else ()
        material = report.ReportInputs(one.source, one.sets, one.pictures, steady)
        look = OverlayLook(widest=960, caption=False, emphasis=1.7)
        painters = report.ReportPainters(
            PlainPictures(".jpg", look), DisagreementPainter(".jpg"), SOURCE_COLOURS
        )
        _warn_of({source.name: source.notices for source in gathered.sources})
        drawn = painters if "html" in kinds else None
        problems = report.write_report(gathered, material, request, drawn, files, work)
        return tuple(dict.fromkeys([*gathered.failures(), *problems]))


def compare_methods(
    annotations: Annotations,
    methods: Mapping[str, Any],
    *,
    thresholds: float | Sequence[float] = (5.0,),
    cluster: str | None = None,
    resamples: int = 10_000,
    seed: int = 1,
    over_time: bool = False,
    **options: Unpack[SetOptions],
) -> dict[str, Any]:
    """Evaluate many methods: intervals, paired tests corrected over all pairs (Holm), ranks, and
    the elements left out of fits where their files have them (leave-one-element-out).

    Args:
        annotations: as of `evaluate_set`.
        methods: as of `write_report`.
        thresholds: px.
        cluster: as of `SetScore.intervals`, by name.
        resamples: how often the set is resampled. seed: of these.
        over_time: whether jitter, jumps and outages over the shots are measured, too; frames of
            a shot are those whose names count on, of all methods together (functions are called
            for all of them).
        **options: see `SetOptions`.

    Returns:
        The content of the JSON that ``evaluate --intervals --output`` writes: of each evaluation
        its frames and summary; ``chance`` with the tables ``intervals``, ``differences`` and
        ``ranks``, whose ``rows`` a DataFrame takes; ``over_time`` with the tables over time.

    Raises:
        UsageError, InputError: as of `write_report`.
    """
    _require_methods(methods)
    as_whole_number(resamples, "resamples", _FEWEST_RESAMPLES)
    draws = BootstrapSettings(resamples, as_whole_number(seed, "seed", 0))
    settings = InferenceSettings(cluster, draws=draws)
    chosen = check_thresholds(thresholds)
    with _opened(annotations, methods, options, over_time) as one:
        file, unwritten = one.folder / "scores.json", dict[Path, ProccError]()
        run = Evaluations(one.requests, chosen, [file], named=True, settings=settings)
        scored = run.score(one.executor, lambda steps, *_: iter(steps), unwritten)
        for error in unwritten.values():
            raise error
        _warn_of({s.method: s.notices for s in scored})
        steady = one.over_time(chosen[0]) if over_time else []
        return _content(file) | ({"over_time": over_time_entries(steady)} if steady else {})


def compare_annotators(
    annotators: Mapping[str, Annotations],
    *,
    thresholds: float | Sequence[float] = (5.0,),
    **options: Unpack[SetOptions],
) -> dict[str, Any]:
    """Compare two or more annotators of the same frames.

    Args:
        annotators: name -> annotations as of `evaluate_set`, in the order a, b, ...
        thresholds: px.
        **options: ``field``, ``size`` and ``workers`` of `SetOptions`.

    Returns:
        The content of the JSON that ``agree --output`` writes.

    Raises:
        UsageError: nothing to compare. InputError: a file cannot be used.
    """
    with ExitStack() as opened:
        every = [
            opened.enter_context(_opened(one, {}, options, title=name))
            for name, one in annotators.items()
        ]
        sources, setup = [one.source for one in every], every[0].setup
        run = agreement_run(sources, setup.field, setup.size, check_thresholds(thresholds))
        run.executor = every[0].executor
        file = every[0].folder / "agreement.json"
        write_agreement(agreement_of(run), file)
        return _content(file)


def compare_cameras(
    a: Method, b: Method, frames: Sequence[str] | None = None, **options: Unpack[SetOptions]
) -> dict[str, Any]:
    """Compare two methods over a set: how far apart is what each pixel means to them?

    Args:
        a: as of `write_report`; the reference of the metrics of earlier papers.
        b: the other method.
        frames: names of those to compare; None for all that both have.
        **options: ``field``, ``size``, ``camera_size`` and ``workers`` of `SetOptions`.

    Returns:
        The content of the JSON that ``compare --output`` writes.

    Raises:
        UsageError, InputError: as of `write_report`.
    """
    frames = as_frame_names(frames)
    given, both = dict.fromkeys(frames or (), FrameAnnotation()), {"a": a, "b": b}
    with _opened(given, both, options, every_frame=frames is None) as one:
        first, second = one.sets
        run = ComparisonRun(first, second, one.setup.field, one.setup.size, frames, one.executor)
        file = one.folder / "comparison.json"
        write_comparison(compare_sources(run), run, file)
        return _content(file)
