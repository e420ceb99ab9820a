"""Order frames by error, and re-score triage verdicts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.audit import FrameAudit
from procc_annotator.dataset.camera_set import CameraSet, FrameCameras
from procc_annotator.dataset.records import Verdict, path_of
from procc_annotator.errors import CameraError, InputError, UsageError
from procc_annotator.metrics.error_maps import disagreement
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import display_score
from procc_annotator.metrics.setup import EvaluationSetup


def largest_error(audit: FrameAudit) -> float | None:
    """The largest distance of a frame's points, px; None where no point has one."""
    errors = audit.errors_px
    known = errors[np.isfinite(errors)]
    return float(known.max()) if len(known) else None


def worst_frames_first(
    values: Mapping[str, float], index: Mapping[str, int], *, low: bool
) -> list[int]:
    """Positions of frames, the worst first; frames alike keep the dataset's order.

    Args:
        values: by frame name.
        index: a frame's position by its name; others are left out.
        low: whether low values are bad.
    """
    sign = 1.0 if low else -1.0
    ranked = ((sign * value, index[name]) for name, value in values.items() if name in index)
    return [position for _, position in sorted(ranked)]


def next_worst(order: Sequence[int], last: int, here: int) -> int | None:
    """The place in an order to go to next; after its end it begins again with the worst.

    Args:
        order: positions of frames, the worst first.
        last: the place in it that was visited last, -1 at the beginning of a walk; where a person
            went meanwhile does not matter.
        here: the position of the frame on screen, which is no place to go to.

    Returns:
        the place; None when there is nowhere to go to.
    """
    for step in range(1, len(order) + 1):
        place = (last + step) % len(order)
        if order[place] != here:
            return place
    return None


@dataclass(frozen=True)
class SetDisagreement:
    """Disagreement of two sources over a set.

    Attributes:
        metres: the median disagreement on the ground by frame name, of frames in which it is known.
        skipped: frames in which one of them has no camera, or none that can be compared.
        finished: False when it was stopped.
    """

    metres: dict[str, float]
    skipped: int
    finished: bool


def set_disagreement(
    frames: Sequence[str],
    a: FrameCameras,
    b: FrameCameras,
    setup: EvaluationSetup,
    progress: Callable[[int, int], None] = lambda done, total: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> SetDisagreement:
    """The median disagreement in metres of two sources in every frame, as the map of
    that frame has it."""
    metres: dict[str, float] = {}
    skipped = 0
    for done, name in enumerate(frames, start=1):
        if cancelled():
            return SetDisagreement(metres, skipped, False)
        median = _median_disagreement(name, a, b, setup)
        if median is None:
            skipped += 1
        else:
            metres[name] = median
        if done % 20 == 0 or done == len(frames):
            progress(done, len(frames))
    return SetDisagreement(metres, skipped, True)


def _median_disagreement(
    name: str, a: FrameCameras, b: FrameCameras, setup: EvaluationSetup
) -> float | None:
    try:
        first, second = a.camera(name, setup.size), b.camera(name, setup.size)
        if first is None or second is None:
            return None
        found = disagreement(first.camera, second.camera, setup.of_frame(name).field, setup.size)
    except (CameraError, InputError, UsageError):  # told when somebody opens this frame
        return None
    return found.statistics.metres.median


@dataclass(frozen=True, slots=True)
class JudgedVerdict:
    """A verdict with the figures it is about; None where there are none any more.

    Attributes:
        jac: at the threshold.
        largest_px: the largest reprojection error.
        worst_element: the class, as annotated, of the point with that error.
        problem: why there are no figures; empty where there are.
    """

    verdict: Verdict
    jac: float | None = None
    largest_px: float | None = None
    worst_element: str = ""
    problem: str = ""


def judge_verdict(
    verdict: Verdict,
    cameras: CameraSet | None,
    read: Callable[[str], FrameAnnotation | None],
    setup: EvaluationSetup,
    tau: float,
) -> JudgedVerdict:
    """Score the frame of a verdict again.

    Args:
        cameras: of the verdict's source, by its place; None when it is not loaded.
        read: the annotation of a frame by its name, None when it has none or is gone.
        setup, tau: as the table says.
    """
    if cameras is None:
        path = path_of(verdict.place)
        which = f"the source {path}" if path else "the source"
        return JudgedVerdict(verdict, problem=f"{which} is not loaded")
    verdict = replace(verdict, source=cameras.name)  # as it is called now
    try:
        camera = cameras.camera(verdict.frame, setup.size)
        annotation = read(verdict.frame)
    except (CameraError, InputError) as error:
        return JudgedVerdict(verdict, problem=str(error))
    if camera is None:
        return JudgedVerdict(verdict, problem="no camera for this frame")
    if annotation is None:
        return JudgedVerdict(verdict, problem="the frame is not annotated")
    found = display_score(measure(annotation, camera.camera, setup.of_frame(verdict.frame)), tau)
    known = [e for e in found.elements if e.max_distance is not None]
    worst = max(known, key=lambda e: e.max_distance or 0.0, default=None)
    return JudgedVerdict(
        verdict,
        found.jac,
        worst.max_distance if worst is not None else None,
        worst.annotated_name if worst is not None else "",
    )
