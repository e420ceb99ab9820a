"""Export of a dataset: SoccerNet JSON for every annotated frame, and the JaC of each.

The same functions serve the command line and the window's File menu; the window's unsaved edits are
exported as they stand.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Container, Iterator, Sequence
from contextlib import AbstractContextManager, ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.scoring import FrameInput, FrameResult, Tally, score_frames
from procc_annotator.dataset.camera_set import CameraForFrame, CameraSet
from procc_annotator.dataset.workspace import AnnotatedFrames
from procc_annotator.errors import CameraError, InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.soccernet import write_annotation
from procc_annotator.formats.annotations.soccernet_set import (
    left_out_words,
    official_only,
    require_soccernet,
    without_unknown_to_official,
)
from procc_annotator.formats.atomic import make_folder, open_replacing
from procc_annotator.formats.cameras.loaded_camera import NAME_THE_FORMAT, field_mismatch
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.projection import projections_error
from procc_annotator.metrics.sets import SetAccumulator, SetSummary, annotated_extent
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.outputs import Target, is_archive, open_target
from procc_annotator.report.scores.score_files import (
    CsvScores,
    JsonScores,
    csv_fragment,
    json_fragment,
    score_format,
)

NO_CAMERAS = "no cameras were given: nothing to score against"
JAC_FILES = ("jac.csv", "jac.json")

Progress = Callable[[int, int], None]  # frames done, frames in all


@dataclass
class Exported:
    """Result of an export, with problems.

    Attributes:
        path: the folder, archive or score file.
        annotations: annotation files written.
        scored: frames that were scored.
        hidden: annotated frames that were not to be scored.
        unannotated: frames without any annotation; they have no file, so that they do not count.
        problems: one line each, for files that could not be read.
        summary: figures of the set by threshold; None without cameras.
        ground_only: whether a camera knew only the ground, so that the off-plane choice counted.
        notices: remarks on cameras (scaled from another size), and for how many.
        left_out: what the files written have no place for (optional elements, say), in words, and
            in how many frames.
        others: frames whose annotations lie in the folder from before, and were not written now.
    """

    path: Path
    annotations: int = 0
    scored: int = 0
    hidden: int = 0
    unannotated: int = 0
    problems: list[str] = field(default_factory=list)
    summary: dict[float, SetSummary] | None = None
    ground_only: bool = False
    notices: Counter[str] = field(default_factory=Counter)
    left_out: Counter[str] = field(default_factory=Counter)
    others: tuple[str, ...] = ()


@dataclass(frozen=True)
class Scoring:
    """Settings of scoring; without cameras the score files say that there were none."""

    setup: EvaluationSetup
    thresholds: tuple[float, ...]
    cameras: CameraSet | None = None


def export_dataset(
    frames: AnnotatedFrames,
    out: Path,
    scoring: Scoring | None = None,
    progress: Progress | None = None,
    *,
    split: str = "",
    keep_optional: bool = False,
) -> Exported:
    """Write the annotations of all annotated frames, and their scores.

    With a split only ``SPLIT/FRAME.json`` is written, as the official evaluation reads it: it takes
    every file of an archive, or of a split's folder, for a frame, and stops at a class it does not
    know and at an entry that is no list of points, which are left out. Scores, of exactly what is
    written, then go to `split_scores` where there are cameras.

    Args:
        out: a folder (made if needed), or an archive if it ends in ``.zip``.
        scoring: what to score with, to ``jac.csv`` and ``jac.json``; None writes no scores.
        split: the folder inside OUT.
        keep_optional: whether elements that SoccerNet has no class for are written as well; a
            field of another sport keeps them anyway.

    Raises:
        UsageError: ``out`` is where the dataset itself lies; for a split, a field of another sport,
            a frame in a tree of folders, or a folder that holds another set's files.
        SaveError: writing failed; an archive is then not there at all.
    """
    _require_place(frames, out, split)
    if split and scoring is not None and scoring.cameras is None:
        scoring = None
    exported, written = Exported(out), set[str]()
    with open_target(out) as target, ExitStack() as open_files:
        totals = None
        if scoring is not None:
            streams = [
                (open_files.enter_context(_score_stream(target, path, split)), path)
                for path in (split_scores(out) if split else map(Path, JAC_FILES))
            ]
            totals = _Totals(scoring, exported, [_writer(*stream, scoring) for stream in streams])
        for name, annotation in _annotated(frames, exported, progress):
            leaves = _leaving(annotation, frames.field, exported, keep_optional)
            if split:
                leaves, out_words = without_unknown_to_official(leaves)
                exported.left_out.update(out_words)
            file = f"{split}/{name}.json" if split else f"{name}.json"
            target.write(file, write_annotation(leaves))
            exported.annotations += 1
            written.add(file)
            if totals is not None:
                totals.add(name, leaves if split else annotation)
        if totals is not None:
            totals.finish()
    if scoring is not None and not split and not is_archive(out):
        with open_source(out) as there:
            kept = list_annotations(there).items()
            exported.others = tuple(name for name, file in kept if file not in written)
    return exported


def _require_place(frames: AnnotatedFrames, out: Path, split: str) -> None:
    if split:
        require_soccernet(frames.field, "the official evaluation")
        _require_flat(frames.names)
        if not is_archive(out):
            _require_own(out / split, frames.names)
    own = {folder.resolve() for folder in frames.folders}
    if out.resolve() in own or (split and (out / split).resolve() in own):
        raise UsageError(f"{out}: this is the dataset itself, export to another folder")


def _score_stream(target: Target, path: Path, split: str) -> AbstractContextManager[IO[bytes]]:
    """A score file inside OUT, or beside a split."""
    if not split:
        return target.stream(path.name)
    make_folder(path.parent)
    return open_replacing(path)


def split_scores(out: Path) -> tuple[Path, ...]:
    """Return where the scores of a split go: next to its archive, or next to its folder."""
    if is_archive(out):
        return tuple(out.with_name(f"{out.stem}_{name}") for name in JAC_FILES)
    return tuple(out / name for name in JAC_FILES)


def export_scores(
    frames: AnnotatedFrames,
    out: Path,
    scoring: Scoring,
    progress: Progress | None = None,
    *,
    only: Container[str] | None = None,
) -> Exported:
    """Write the JaC of every annotated frame, or of ``only`` those whose score may be known, to one
    ``.json`` or ``.csv`` file.

    Raises:
        UsageError: another suffix.
        SaveError: writing failed; whatever was there before stays.
    """
    score_format(out)
    exported = Exported(out)
    with open_replacing(out) as stream:
        totals = _Totals(scoring, exported, [_writer(stream, out, scoring)])
        for name, annotation in _annotated(frames, exported, progress):
            if only is None or name in only:
                totals.add(name, annotation)
            else:
                exported.hidden += 1
        totals.finish()
    return exported


# ------------------------------------------------------------------------------------- frames


def _annotated(
    frames: AnnotatedFrames, exported: Exported, progress: Progress | None
) -> Iterator[tuple[str, FrameAnnotation]]:
    total = len(frames.names)
    for index, name in enumerate(frames.names):
        try:
            annotation = frames.read(index)
        except InputError as error:
            exported.problems.append(str(error))
        else:
            if annotation is not None:
                yield name, annotation
            else:
                exported.unannotated += 1
        if progress is not None:
            progress(index + 1, total)


def _leaving(
    annotation: FrameAnnotation, known: Field, exported: Exported, keep_optional: bool
) -> FrameAnnotation:
    """An annotation as it leaves; what is left out of it is counted."""
    if keep_optional:
        return annotation
    annotation, out = official_only(annotation, known)
    exported.left_out.update(left_out_words(known, name) for name in out)
    return annotation


def _writer(stream: IO[bytes], path: Path, scoring: Scoring) -> JsonScores | CsvScores:
    if score_format(path) == "json":
        return JsonScores(stream, scoring.setup, scoring.thresholds)
    return CsvScores(stream)


class _Totals:
    """Scores frames one after the other and writes them to every score file."""

    def __init__(
        self, scoring: Scoring, exported: Exported, writers: Sequence[JsonScores | CsvScores]
    ) -> None:
        self._scoring = scoring
        self._exported = exported
        self._writers = writers
        self._tally = Tally(SetAccumulator(scoring.setup, scoring.thresholds))
        for writer in writers:
            writer.begin()

    def add(self, name: str, annotation: FrameAnnotation) -> None:
        result = self._score(name, annotation)
        for writer in self._writers:
            if isinstance(writer, JsonScores):
                writer.add(json_fragment(result))
            else:
                writer.add(csv_fragment(result, self._scoring.setup, self._scoring.thresholds))

    def finish(self) -> None:
        if self._scoring.cameras is not None:
            self._exported.summary = self._tally.sums.summary()
        self._exported.ground_only = self._tally.ground_only
        for writer in self._writers:
            writer.end(self._exported.summary, ground_only=self._exported.ground_only)

    def _score(self, name: str, annotation: FrameAnnotation) -> FrameResult:
        cameras, setup = self._scoring.cameras, self._scoring.setup
        if cameras is None:
            extent = annotated_extent(annotation, setup.field)
            return FrameResult(name, None, NO_CAMERAS, (), {}, clicked=extent)
        frame = FrameInput(name, annotation)
        try:
            loaded = cameras.camera(name, setup.size)
        except CameraError as error:
            frame = FrameInput(name, annotation, error=str(error))
        else:
            if loaded is not None:
                frame = _input(name, annotation, loaded, cameras.frames[name], setup)
                if frame.camera is not None:
                    self._exported.scored += 1
        self._exported.problems += [frame.error] if frame.error else []
        (evaluated,) = score_frames([frame], self._tally)
        self._exported.notices.update(evaluated.result.notices)
        return evaluated.result


def _input(
    name: str,
    annotation: FrameAnnotation,
    loaded: CameraForFrame,
    place: str,
    setup: EvaluationSetup,
) -> FrameInput:
    problem = projections_error(loaded.camera, setup.of_frame(name))
    if why := field_mismatch(loaded.assumed_field, setup.field):
        problem = f"{why} ({NAME_THE_FORMAT})"
    if problem:
        return FrameInput(name, annotation, error=f"{name}: {problem}")
    notices = (loaded.notice,) if loaded.notice else ()
    return FrameInput(
        name, annotation, loaded.camera, place, loaded.model, notices, loaded.fitted_on
    )


# ------------------------------------------------------------------------------------- targets


def _require_flat(names: Sequence[str]) -> None:
    """The official evaluation has one folder a split, and no name for what is deeper."""
    for name in names:
        if "/" in name:
            raise UsageError(
                f"{name}: lies in a folder of a tree, and the official evaluation knows one folder"
                f" of frames; export the folders one by one, e.g. {name.rpartition('/')[0]}"
            )


def _require_own(folder: Path, names: Sequence[str]) -> None:
    """What is in a split's folder already would be frames of the set to the evaluation."""
    try:
        others = {name for name in os.listdir(folder) if ".json" in name}
    except OSError:  # usually: no such folder yet
        return
    if others := others - {f"{name}.json" for name in names}:
        raise UsageError(
            f"{folder}: holds {min(others)}, which the official evaluation would take for a frame"
            " of this set; choose another folder"
        )
