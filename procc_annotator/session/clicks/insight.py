"""What the clicks of one frame tell: the camera they fit, what it predicts, what is wrong."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.field.model import Field
from procc_annotator.fit.fitting import fit_camera
from procc_annotator.fit.labels.check import check_labels
from procc_annotator.fit.labels.finding import Finding
from procc_annotator.fit.predict.ghosts import Ghost, find_ghosts
from procc_annotator.fit.predict.sight import visible_spots, visible_stretches
from procc_annotator.fit.predict.suggestion import AnnotationSuggestion, suggest_annotations
from procc_annotator.fit.result import FitResult


@dataclass(frozen=True, eq=False)
class FrameAnalysis:
    """Everything that follows from one annotation of a frame.

    Attributes:
        annotation: what it was made from.
        fit: the camera, or why there is none.
        ghosts: elements not annotated yet, where the camera expects them.
        findings: what may be wrong with the labels, the surest first.
        suggestions: what to annotate next, the most helpful first.
        optional_in_sight: the optional elements that the camera has in the picture; they may be
            there or not, and few are suggested.
        from_clicks: whether the camera is that of the annotation; else it was found without.
    """

    annotation: FrameAnnotation
    fit: FitResult
    ghosts: tuple[Ghost, ...] = ()
    findings: tuple[Finding, ...] = ()
    suggestions: tuple[AnnotationSuggestion, ...] = ()
    visible_optional: frozenset[str] = frozenset()
    from_clicks: bool = True

    def out_of_sight(self, field: Field) -> frozenset[str]:
        """The classes without points that the camera has nowhere in the picture.

        None without a camera; a homography says nothing of what is off the ground.
        """
        fit, annotation = self.fit, self.annotation
        if fit.camera is None or fit.covariance is None or fit.error_px is None:
            return frozenset()
        known = {p.class_name for p in (*annotation.polylines, *annotation.unconfirmed)}
        known |= {suggestion.name for suggestion in self.suggestions} | self.visible_optional
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
        annotation: of the frame.
        field: its elements.
        size: (width, height) px of the picture.
        model: see `fit_camera`.
        start: the camera before the last edit.
        not_visible: classes somebody said are not to be seen here.
        go_on: called between the steps; raises whatever it likes when nobody wants the rest.
    """
    go_on()
    fit = fit_camera(annotation, field, model=model, size=size, start=start)
    go_on()
    ghosts = find_ghosts(annotation, field, fit, without=not_visible)
    suggestions = suggest_annotations(annotation, field, fit, without=not_visible)
    go_on()
    findings = check_labels(annotation, field, size=size, fit=fit, go_on=go_on)
    optional = _optional_in_sight(field, fit)
    return FrameAnalysis(annotation, fit, ghosts, findings, suggestions, optional)


def _optional_in_sight(field: Field, fit: FitResult) -> frozenset[str]:
    if fit.camera is None:
        return frozenset()
    needed = {e.name for e in field.elements if not e.optional}
    stretches = visible_stretches(field, fit.camera, fit.size, needed)
    spots = visible_spots(field, fit.camera, fit.size, needed)
    return frozenset(spots).union(stretch.name for stretch in stretches)
