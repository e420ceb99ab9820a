"""Fit and score a camera per annotated frame; leave-one-element-out; save a fit."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.scoring import left_out_settings
from procc_annotator.batch.set_run import (
    AnnotationTask,
    CheckpointedRun,
    FrameFile,
    annotation_files,
    reopenable_source,
)
from procc_annotator.calibration.fitting import AUTO, fit_camera, fit_cameras
from procc_annotator.calibration.result import (
    FitResult,
    PoseStandardDeviations,
    ill_conditioned_reason,
)
from procc_annotator.camera.models import FisheyeCamera, HomographyCamera, PinholeCamera
from procc_annotator.dataset.picture_sizes import FitSizes, FrameSize, SizesUsed
from procc_annotator.errors import InputError, SaveError
from procc_annotator.field.load import field_for_frame
from procc_annotator.formats.atomic import make_folder, write_atomic
from procc_annotator.formats.cameras.fit_record import (
    DIGEST,
    FIT_KEY,
    UNCERTAINTY,
    LeftOutElement,
    LeftOutResult,
    annotation_digest,
)
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.formats.cameras.writers import encode_camera
from procc_annotator.formats.file_listing import camera_name, camera_names
from procc_annotator.formats.file_source import FileSource, read_file
from procc_annotator.formats.frame_names import file_of_frame
from procc_annotator.metrics.measurement import Measurement, measure
from procc_annotator.metrics.official import folds_into_image
from procc_annotator.metrics.score import FrameScore, score
from procc_annotator.metrics.sets import SetAccumulator, SetSummary
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.version import __version__


def leave_one_out(
    annotation: FrameAnnotation, fit: FitResult, setup: EvaluationSetup, model: str
) -> tuple[LeftOutElement, ...]:
    """The elements of a frame that the others predict, fitted without a start.

    An element counts if the others determine a camera (`ill_conditioned_reason` says nothing of
    it); what has no place on the field is none. The setup is the frame's, at the size of the fit.
    """
    if fit.camera is None:
        return ()
    whole = measure(annotation, fit.camera, setup)
    found = []
    for name, element in zip(whole.plain.annotated_names, whole.plain.rows, strict=True):
        if element < 0:
            continue
        rest = fit_camera(annotation.without(name), setup.field, model=model, size=fit.size)
        if rest.camera is None or ill_conditioned_reason(rest):
            continue
        predicted = _worst(measure(annotation, rest.camera, setup), name)
        found.append(LeftOutElement(name, predicted, _worst(whole, name)))
    return tuple(found)


def _worst(measurement: Measurement, name: str) -> float | None:
    plain = measurement.plain
    if name not in plain.annotated_names:
        return None
    distances = plain.distances[plain.annotated_names.index(name)]
    return None if distances is None else float(distances.max())


@dataclass(frozen=True, slots=True)
class Calibrated:
    """Result for one annotated frame.

    Attributes:
        name: the frame.
        model: what was fitted; auto if that was to be chosen and there is no camera.
        error: why its annotation cannot be read; such a frame belongs to no figure of the set.
        failure: why there is no camera.
        file_name, data: the camera's file; empty without a camera.
        elements: number of elements that could be used.
        left_out: those of them that were taken for mistakes.
        scores: by threshold; empty without a camera.
        deviations: standard deviations of the pose; None for a homography or without a camera.
        place: name of the position it shares with other frames; empty if it has its own.
        size: what it was fitted at; None if its annotation cannot be read.
        open: what the points leave open of the camera, in words; empty where they determine it.
        folds: whether the official evaluation would show what the lens folds back.
        digest: `annotation_digest` of what was fitted; empty without a camera.
        held_out: its elements left out in turn, where that was asked for.
    """

    name: str
    model: str
    error: str | None = None
    failure: str | None = None
    file_name: str = ""
    data: bytes = b""
    elements: int = 0
    left_out: tuple[str, ...] = ()
    scores: Mapping[float, FrameScore] = field(default_factory=dict)
    deviations: PoseStandardDeviations | None = None
    place: str = ""
    size: FrameSize | None = None
    open: str = ""
    folds: bool = False
    digest: str = ""
    held_out: LeftOutResult | None = None

    @property
    def has_camera(self) -> bool:
        """Return whether a camera was found."""
        return bool(self.file_name)


@dataclass(frozen=True)
class CalibrateChunk(AnnotationTask):
    """Fits and scores chunks of frames, each at its own size."""

    setup: EvaluationSetup
    sizes: FitSizes
    thresholds: tuple[float, ...]
    model: str
    hold_out: bool = False

    def __call__(self, chunk: Sequence[FrameFile]) -> tuple[list[Calibrated], SetAccumulator]:
        sums = SetAccumulator(self.setup, self.thresholds)
        found: dict[str, Calibrated] = {}
        read: list[tuple[str, FrameAnnotation, FrameSize]] = []
        for name, file in chunk:
            try:
                annotation = self.read(file, self.setup.field)
                read.append((name, annotation, self.sizes.of_frame(name, annotation)))
            except InputError as error:
                found[name] = Calibrated(name, self.model, error=str(error))
        field = self.setup.field
        given = [(clicks, field_for_frame(field, name), size.fitted) for name, clicks, size in read]
        for (name, annotation, size), fit in zip(
            read, fit_cameras(given, model=self.model), strict=True
        ):
            found[name] = self._calibrated(name, annotation, size, fit, sums)
        return [found[name] for name, _ in chunk], sums

    def _calibrated(
        self,
        name: str,
        annotation: FrameAnnotation,
        size: FrameSize,
        fit: FitResult,
        sums: SetAccumulator,
    ) -> Calibrated:
        result = scored(name, annotation, fit, sums, size=size)
        if not self.hold_out:
            return result
        own = self.setup.at(fit.size).of_frame(name)
        elements = leave_one_out(annotation, fit, own, self.model)
        return replace(
            result, held_out=LeftOutResult(left_out_settings(self.setup.at(fit.size)), elements)
        )


def scored(
    name: str,
    annotation: FrameAnnotation,
    fit: FitResult,
    sums: SetAccumulator,
    place: str = "",
    size: FrameSize | None = None,
) -> Calibrated:
    """A frame with its fit, scored at the size it was fitted at, and added to the sums of its set.

    Args:
        sums: their setup, but for its size, and thresholds count.
        place: the position it shares with other frames, if any.
        size: that of its picture too, if it is to be reported.
    """
    used = size or FrameSize(fit.size)
    if fit.camera is None:
        sums.add_missing_camera(name)
        failure = fit.failure or "no camera was found"
        return Calibrated(name, fit.model, failure=failure, size=used)
    digest = annotation_digest(annotation)
    file_name, data = camera_file(name, fit, digest)
    measurement = measure(annotation, fit.camera, sums.setup.at(fit.size).of_frame(name))
    scores = {threshold: score(measurement, threshold) for threshold in sums.thresholds}
    sums.add(name, None, scores)  # each frame at its own size
    return Calibrated(
        name,
        fit.model,
        file_name=file_name,
        data=data,
        elements=len(fit.elements),
        left_out=fit.left_out,
        scores=scores,
        deviations=fit.deviations,
        place=place,
        size=used,
        open=ill_conditioned_reason(fit),
        folds=folds_into_image(fit.camera, sums.setup.tables, fit.size),
        digest=digest,
    )


def camera_file(name: str, fit: FitResult, digest: str | None = None) -> tuple[str, bytes]:
    """File name and content of a frame's fitted camera, with the digest of the annotation if given.

    A pinhole becomes a SoccerNet camera that names the picture size its pixels belong to; a
    fisheye, which these cannot hold, a file of `cv::FileStorage`; a homography a .npy in the
    convention that this suffix stands for (yards, picture of 1280 x 720).
    """
    if isinstance(fit.camera, HomographyCamera):
        loaded = LoadedCamera(fit.camera, "homography", fit.size, fitted_on=digest)
        data, _ = encode_camera(loaded, "carwc")
        return file_of_frame(name, ".npy"), data
    if isinstance(fit.camera, FisheyeCamera):
        loaded = LoadedCamera(fit.camera, "fisheye", fit.size, fitted_on=digest)
        data, _ = encode_camera(loaded, "opencv")
        return file_of_frame(name, ".yml"), data
    if fit.camera is None:
        raise ValueError("a failed fit has no camera")
    more: dict[str, Any] = {"image_width": fit.size[0], "image_height": fit.size[1]}
    known = {} if digest is None else {DIGEST: digest}
    more[FIT_KEY] = {"model": fit.model, **known, UNCERTAINTY: fit.uncertainty}
    return camera_name(name), write_camera(fit.camera, more)


class CalibrationRun(CheckpointedRun[FrameFile, Calibrated, SetAccumulator]):
    """One pass over a set; iterate it once, then ask for the `summary`.

    Attributes:
        counted, with_camera: frames so far whose annotation could be read, and those with a camera.
        models: how many of the cameras so far are of each model.
        sizes: what the frames so far were fitted at.
    """

    task: CalibrateChunk

    def __init__(
        self,
        source: FileSource,
        setup: EvaluationSetup,
        sizes: FitSizes,
        thresholds: tuple[float, ...],
        model: str,
        *,
        hold_out: bool = False,
    ) -> None:
        task = CalibrateChunk(reopenable_source(source), setup, sizes, thresholds, model, hold_out)
        super().__init__(annotation_files(source), task)
        self.counted = self.with_camera = 0
        self.models = Counter[str]()
        self.sizes = SizesUsed(sizes.asked)
        self._sums = SetAccumulator(setup, thresholds)

    @property
    def thresholds(self) -> tuple[float, ...]:
        """Return what the frames are scored at, px."""
        return self.task.thresholds

    def _take(self, results: Sequence[Calibrated], sums: SetAccumulator) -> None:
        self._sums.merge(sums)
        self.counted += sum(result.error is None for result in results)
        self.with_camera += sum(result.has_camera for result in results)
        self.models.update(result.model for result in results if result.has_camera)
        for result in results:
            if result.size is not None:
                self.sizes.add(result.size)

    def _digest(self, chunk: Sequence[FrameFile]) -> str:
        return self.task.input_digest(chunk, self.task.sizes.picture_of)

    def _sums_of(self, results: Sequence[Calibrated]) -> SetAccumulator:
        sums = SetAccumulator(self.task.setup, self.task.thresholds)
        for result in results:
            if result.has_camera:
                sums.add(result.name, None, result.scores)
            elif result.error is None:
                sums.add_missing_camera(result.name)
        return sums

    def summary(self) -> dict[float, SetSummary]:
        """Figures of the frames seen so far, by threshold."""
        return self._sums.summary()

    def describe(self) -> str:
        """Model, protocol, size and what else the figures depend on, in words."""
        described = self.task.setup.describe(self.task.model == "H", self.sizes.describe())
        return f"{model_words(self.task.model, self.models)}, {described}"


def model_words(model: str, chosen: Mapping[str, int]) -> str:
    """Return what was fitted, in words.

    Args:
        model: what was asked for.
        chosen: how many of the cameras are of each model.
    """
    if model != AUTO:
        return f"model {model}"
    counts = ", ".join(f"{name} {count}" for name, count in sorted(chosen.items()) if count)
    return f"model chosen for each frame ({counts or 'no camera'})"


FOLDER = Path("cameras") / "fitted"  # in the dataset's folder


def fitted_folder(dataset: Path) -> Path:
    """Return where the fits of a dataset are kept."""
    return dataset / FOLDER


def save_fit(
    folder: Path, frame: str, annotation: FrameAnnotation, fit: FitResult, *, field: str
) -> Path:
    """Write a fit as its frame's camera; returns the file. A saved fit of the frame is replaced.

    A pinhole becomes ``camera_{frame}.json`` in SoccerNet form with a further key ``fit``; the file
    of any other ends in a comment with the same.

    Raises:
        SaveError: writing failed, or a camera that is no saved fit is in the file's place.
        ValueError: the fit has no camera.
    """
    name, data = camera_file(frame, fit)
    path = folder / name
    others = _cameras_of(folder, frame)
    for there in others:
        if not _is_saved_fit(there):
            raise SaveError(
                f"{there}: is a camera that was not saved as a fit (move it away to save this one)"
            )
    what = _fitted_from(annotation, fit, field)
    make_folder(path.parent)
    if isinstance(fit.camera, PinholeCamera):
        size = {"image_width": fit.size[0], "image_height": fit.size[1]}
        data = write_camera(fit.camera, {**size, FIT_KEY: what})
    else:
        data += f"# {json.dumps({FIT_KEY: what})}\n".encode()
    write_atomic(path, data)
    for there in others:
        if there != path:  # saved with another model; a frame has one camera
            with suppress(OSError):
                there.unlink(missing_ok=True)
    return path


def _fitted_from(annotation: FrameAnnotation, fit: FitResult, field: str) -> dict[str, Any]:
    known: dict[str, Any] = {
        "program": f"procc-annotator {__version__}",
        "model": fit.model,
        "chosen_because": fit.chosen_because,
        "field": field,
        DIGEST: annotation_digest(annotation),
        "image_size": list(fit.size),
        "elements": [element.name for element in fit.elements if not element.left_out],
        "left_out": list(fit.left_out),
        "mean_residual_px": fit.mean_px,
        "point_sd_px": fit.error_px,
        UNCERTAINTY: fit.uncertainty,
    }
    if (sd := fit.deviations) is not None:
        known["standard_deviations"] = {
            "pan_rad": sd.pan_rad,
            "tilt_rad": sd.tilt_rad,
            "roll_rad": sd.roll_rad,
            "position_meters": list(sd.position_m),
            "focal_px": sd.focal_px,
        }
    return known


def _cameras_of(folder: Path, frame: str) -> list[Path]:
    paths = [folder / name for name in camera_names(frame)]
    return [path for path in paths if path.exists()]


def _is_saved_fit(path: Path) -> bool:
    """Return whether a camera's file was written by `save_fit`."""
    try:
        data = read_file(path)
        begin = 0 if path.suffix == ".json" else data.rfind(b'# {"fit"') + 2
        content = json.loads(data[begin:])
    except (InputError, ValueError, RecursionError):
        return False
    found = content.get(FIT_KEY) if isinstance(content, dict) else None
    return isinstance(found, dict) and str(found.get("program", "")).startswith("procc-annotator ")
