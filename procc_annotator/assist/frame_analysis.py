"""Fit, ghosts and label findings of one annotated frame, and remedies for findings."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.check import check_labels
from procc_annotator.calibration.label_check.finding import Finding, Remedy, RemedyKind
from procc_annotator.calibration.prediction.ghosts import MAX_SD_PX, Ghost, find_ghosts
from procc_annotator.calibration.prediction.suggestions import (
    AnnotationSuggestion,
    suggest_annotations,
    unlikely_in_sight,
)
from procc_annotator.calibration.prediction.visible_elements import visible_spots, visible_stretches
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.base import Camera
from procc_annotator.camera.models import HomographyCamera
from procc_annotator.dataset.editing import delete_point
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.setup import EvaluationSetup


@dataclass(frozen=True, eq=False)
class FrameAnalysis:
    """Everything that follows from one annotation of a frame.

    Attributes:
        annotation: what it was made from.
        fit: the camera, or why it failed.
        ghosts: elements not annotated yet, where the camera expects them.
        findings: what may be wrong with the labels, the surest first.
        suggestions: what to annotate next, the most helpful first.
        visible_optional: the optional elements that the camera has in the picture; they may be
            there or not, and few are suggested.
        unlikely: without a camera, the elements that are hardly in the picture.
        from_clicks: whether the camera is that of the annotation; else it was found without.
    """

    annotation: FrameAnnotation
    fit: FitResult
    ghosts: tuple[Ghost, ...] = ()
    findings: tuple[Finding, ...] = ()
    suggestions: tuple[AnnotationSuggestion, ...] = ()
    visible_optional: frozenset[str] = frozenset()
    unlikely: frozenset[str] = frozenset()
    from_clicks: bool = True

    def out_of_sight(self, field: Field) -> frozenset[str]:
        """The classes without points that the camera has nowhere in the picture, or the unlikely
        ones without a camera; a homography says nothing of what is off the ground."""
        fit, annotation = self.fit, self.annotation
        if fit.camera is None or fit.covariance is None or fit.error_px is None:
            return self.unlikely
        known = {p.class_name for p in (*annotation.polylines, *annotation.unconfirmed)}
        known |= {suggestion.name for suggestion in self.suggestions} | self.visible_optional
        known |= {ghost.name for ghost in self.ghosts}  # of a camera found without clicks
        flat = isinstance(fit.camera, HomographyCamera)
        shown = (e.name for e in field.elements if not flat or e.on_ground)
        return frozenset(shown) - known


def analyse_frame(
    annotation: FrameAnnotation,
    field: Field,
    *,
    size: tuple[int, int],
    model: str = "R",
    start: Camera | None = None,
    not_visible: frozenset[str] = frozenset(),
    go_on: Callable[[], None] = lambda: None,
) -> FrameAnalysis:
    """Fit a camera to an annotation and see what follows; safe from any thread.

    Args:
        size: (width, height) px of the picture.
        model: see `fit_camera`.
        start: the camera before the last edit.
        not_visible: classes a person said are not to be seen here.
        go_on: called between the steps; raises whatever it likes when no one wants the rest.
    """
    go_on()
    fit = fit_camera(annotation, field, model=model, size=size, start=start)
    go_on()
    ghosts = find_ghosts(annotation, field, fit, without=not_visible)
    suggestions = suggest_annotations(annotation, field, fit, without=not_visible)
    go_on()
    findings = check_labels(annotation, field, size=size, fit=fit, go_on=go_on)
    optional, unlikely = _optional_in_sight(field, fit), frozenset[str]()
    if fit.camera is None:
        known = {p.class_name: points_px(p, size) for p in annotation if p.points}
        unlikely = unlikely_in_sight(field, size, known)
    return FrameAnalysis(annotation, fit, ghosts, findings, suggestions, optional, unlikely)


def _optional_in_sight(field: Field, fit: FitResult) -> frozenset[str]:
    if fit.camera is None:
        return frozenset()
    needed = {e.name for e in field.elements if not e.optional}
    stretches = visible_stretches(field, fit.camera, fit.size, needed)
    spots = visible_spots(field, fit.camera, fit.size, needed)
    return frozenset(spots).union(stretch.name for stretch in stretches)


_MOST_APART = 0.015  # of the width, in the middle of an element's points
# Clicks agree with a camera within two standard deviations of the least certain ghost offered.
_AGREES = 2 * MAX_SD_PX / 960
_CONTRADICTED = "the clicks lie elsewhere than the proposed camera shows them"


def ghosts_without_clicks(
    annotation: FrameAnnotation,
    field: Field,
    fit: FitResult,
    not_visible: frozenset[str] = frozenset(),
    fitted: FrameAnalysis | None = None,
    *,
    go_on: Callable[[], None] = lambda: None,
) -> FrameAnalysis:
    """Find the ghosts of a camera; none of one that the clicks contradict. Safe from any thread.

    Args:
        fit: the camera, found in the picture or by following the shot.
        fitted: what follows from the clicks alone. It is returned once the clicks give a camera,
            unless they agree with the camera that was found, and that one knows more elements.
        not_visible, go_on: as of `analyse_frame`.
    """
    go_on()
    by_clicks = fitted if fitted is not None and fitted.fit.camera is not None else None
    if contradicts(annotation, field, fit, _MOST_APART if by_clicks is None else _AGREES):
        if by_clicks is not None:
            return by_clicks
        none = FitResult(fit.model, fit.size, None, _CONTRADICTED)
        return FrameAnalysis(annotation, none, from_clicks=False)
    go_on()
    ghosts = find_ghosts(annotation, field, fit, without=not_visible)
    if by_clicks is not None and len(ghosts) <= len(by_clicks.ghosts):
        return by_clicks
    return FrameAnalysis(annotation, fit, ghosts, from_clicks=False)


def contradicts(
    annotation: FrameAnnotation, field: Field, fit: FitResult, most_apart: float = _MOST_APART
) -> bool:
    """Return whether an annotated element lies elsewhere than a camera shows it: the median of its
    points farther than ``most_apart`` picture widths."""
    if fit.camera is None:
        return False
    found = measure(annotation, fit.camera, EvaluationSetup(field, size=fit.size)).plain
    most = most_apart * fit.size[0]
    for row, distances in zip(found.rows, found.distances, strict=True):
        if row >= 0 and (distances is None or not np.median(distances) <= most):
            return True
    return False


def apply_remedy(
    annotation: FrameAnnotation, finding: Finding, remedy: Remedy, field: Field | None = None
) -> FrameAnnotation:
    """The annotation with a finding of it fixed; its points stay where they are.

    Without a field messages name the classes of the file. `LOOK`, which is for eyes, and `FOLLOW`,
    which wants the picture, change nothing.

    Raises:
        UsageError: the annotation is another one by now, or two elements would get one class.
    """
    if remedy.kind in (RemedyKind.LOOK, RemedyKind.FOLLOW):
        return annotation
    if remedy.kind is RemedyKind.REMOVE_POINT:
        return _without_point(annotation, finding, field)
    return rename_classes(annotation, dict(remedy.renamed), field)


def rename_classes(
    annotation: FrameAnnotation, names: Mapping[str, str], field: Field | None = None
) -> FrameAnnotation:
    """Give classes other names, all at once, so that they may exchange them; the order stays.

    A class without points gives way, and so does an unconfirmed element of a new name. Without a
    field messages name the classes of the file.

    Raises:
        UsageError: a class is not annotated, or would be annotated twice.
    """
    for name in names:
        if name not in annotation.annotated:
            raise UsageError(f"{_title(name, field)} is not annotated any more; look again")
    becoming = list(names.values())
    for name in becoming:
        if becoming.count(name) > 1 or (name in annotation.annotated and name not in names):
            raise UsageError(
                f"{_title(name, field)} is annotated already, and an element is annotated once;"
                " remove one of the two first"
            )
    kept = tuple(
        replace(p, class_name=names.get(p.class_name, p.class_name))
        for p in annotation.polylines
        if p.points or p.class_name not in becoming
    )
    hidden = tuple(p for p in annotation.unconfirmed if p.class_name not in becoming)
    return replace(annotation, polylines=kept, unconfirmed=hidden)


def _without_point(
    annotation: FrameAnnotation, finding: Finding, field: Field | None
) -> FrameAnnotation:
    name = finding.elements[0]
    polyline = annotation.get(name)
    if finding.point is None or polyline is None or finding.point >= len(polyline.points):
        raise UsageError(f"{_title(name, field)} has no such point any more; look again")
    return delete_point(annotation, name, finding.point)


def _title(name: str, field: Field | None) -> str:
    return name.strip() if field is None else field.title_of(name)
