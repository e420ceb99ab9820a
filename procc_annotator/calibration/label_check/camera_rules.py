"""Findings from the fitted camera: swapped, misplaced and mirrored labels."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import reduce
from itertools import combinations

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, points_px
from procc_annotator.calibration.fitting import AUTO
from procc_annotator.calibration.label_check.candidate_classes import (
    MIRROR_REMEDY_TEXTS,
    MIRROR_X,
    MIRROR_Y,
    distances_to_classes,
    leave_one_out_errors,
    mirrored_names,
    relabelled,
)
from procc_annotator.calibration.label_check.evidence import (
    CORRECT_PX,
    STRAIGHT_TOLERANCE_PX,
    FrameEvidence,
    element_error,
    in_image_px,
    line_residuals,
    suspect_limit,
)
from procc_annotator.calibration.label_check.explanation import (
    MIN_CORRECT,
    Explanation,
    SuspectFrame,
    best_explanation,
)
from procc_annotator.calibration.label_check.finding import (
    LOOK,
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
    outlier_point_finding,
)
from procc_annotator.calibration.optimization.camera_parameters import WIDE_ANGLE_MODELS
from procc_annotator.calibration.optimization.camera_placement import insufficient_reason
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.robust_fit import MIN_ELEMENTS, OUTLIER_PX
from procc_annotator.calibration.result import FitResult, PosedCamera
from procc_annotator.field.landmarks import landmark_covariances
from procc_annotator.field.sampling import touching_elements
from procc_annotator.translation import (
    TranslatableText,
    translatable,
    translatable_all,
    translatable_joined,
)

# A whole frame is called reflected if its reflection fits at least so many times as well.
_MIRROR_FIT_RATIO = 2.0
_MIRROR_MAX_PX = 6.0
# An element counts at most this in the comparison of two labellings.
_MAX_COUNTED_PX = 30.0
# Only a fit this bad makes it worth while to look.
_POOR_FIT_MEDIAN_PX = 4.0
_POOR_FIT_ELEMENTS = 2
_MIN_REPORTED_PX = 0.1
# Exchanges of two points that are fitted. Of all 231 pairs of corners of a panorama the right one
# is the first in 91 %, among these in 95 %.
_MAX_EXCHANGES = 4
_MIRROR_FIT_REASONS = {
    MIRROR_Y: translatable("all labels fit with far and near exchanged"),
    MIRROR_X: translatable("all labels fit with left and right exchanged"),
}
# Carelessly clicked frames have points so many times as far off as elements usually are.
_USUAL_ERROR_RATIO = 3.0


def suspect_elements(fit: FitResult, frame: ImageFrame) -> tuple[str, ...]:
    """The elements that are farther off than the limit, in the order of the fit."""
    limit = suspect_limit(fit, frame)
    return tuple(e.name for e in fit.elements if element_error(e, frame) > limit)


def camera_findings(evidence: FrameEvidence, known: Sequence[Finding]) -> tuple[Finding, ...]:
    """Return what does not fit the camera of the other elements, explained; costs several fits.
    Nothing where all of it fits."""
    fit, frame = evidence.fit, evidence.frame
    if len(evidence.clicked) < MIN_ELEMENTS:
        return ()
    if fit.camera is not None and not suspect_elements(fit, frame):
        return ()
    # A model without distortion leaves lines off that are right; so does one of the ground alone.
    model = fit.model if fit.model in ("R+", *WIDE_ANGLE_MODELS) else "R"
    polylines = evidence.annotation.polylines
    doubted = SuspectFrame(
        FrameAnnotation(polylines), evidence.field, frame, model, go_on=evidence.go_on
    )
    if len(doubted.names) < MIN_ELEMENTS or (fit.camera is None and _has_too_few_clicks(doubted)):
        return ()
    if fit.model != model:
        fit = doubted.fit(doubted.annotation, fit.camera)
    suspects = suspect_elements(fit, frame)
    if fit.camera is not None and not suspects:
        return ()
    reversed_frame = _mirror_finding(doubted, fit)
    if reversed_frame is not None:
        return (reversed_frame,)
    exchanged = _exchanged_points_finding(doubted, fit)
    if exchanged is not None:
        return (exchanged,)
    found = best_explanation(replace(doubted, limit_px=suspect_limit(fit, frame)), fit, suspects)
    if found is None:
        return _contradiction_finding(doubted, fit, suspects)
    return tuple(_mistake_findings(doubted, found))


def _has_too_few_clicks(doubted: SuspectFrame) -> bool:
    """Return whether there is no camera because there are too few clicks: nothing is wrong with
    those."""
    seen = build_observations(doubted.annotation, doubted.field, doubted.frame)
    return insufficient_reason(seen, needed=MIN_ELEMENTS, planar=False) is not None


def _mean_capped_error(fit: FitResult, count: int, frame: ImageFrame) -> float:
    """Mean of the elements' largest distances, solver px, none counting more than a mistake."""
    if fit.camera is None or not fit.elements:
        return _MAX_COUNTED_PX
    worst = [min(element_error(e, frame), _MAX_COUNTED_PX) for e in fit.elements]
    return float(sum(worst) + _MAX_COUNTED_PX * max(count - len(worst), 0)) / max(count, len(worst))


def _is_poor(fit: FitResult, frame: ImageFrame) -> bool:
    if fit.camera is None:
        return True
    middle = np.median([element_error(e, frame) for e in fit.elements])
    many = len(suspect_elements(fit, frame)) >= _POOR_FIT_ELEMENTS
    return bool(middle >= _POOR_FIT_MEDIAN_PX or many)


def _exchanged_points_finding(doubted: SuspectFrame, fit: FitResult) -> Finding | None:
    """Two points, each of several elements that meet there, that were clicked in each other's
    place. The exchanges that bring them nearest to a camera of the others are tried; without one,
    those that shorten the lines most: lines to the wrong point are longer."""
    annotation, field, frame = doubted.annotation, doubted.field, doubted.frame
    at: dict[tuple[float, float], list[str]] = {}
    for polyline in annotation.polylines:
        for place in dict.fromkeys((p.u, p.v) for p in polyline.points):
            at.setdefault(place, []).append(polyline.class_name)
    off = set(suspect_elements(fit, frame)) or set(doubted.names)
    corners = [place for place, names in at.items() if len(names) > 1 and not off.isdisjoint(names)]
    if len(corners) < 2 or not _is_poor(fit, frame):
        return None

    def badness(polylines: Sequence[Polyline]) -> float:
        if fit.vector is None:
            return sum(_length_px(p, frame) for p in polylines)
        distances = (
            distances_to_classes(p, [p.class_name], field, frame, fit.vector) for p in polylines
        )
        return float(sum(d.sum() for found in distances for d in found.values()))

    tried = []
    for one, other in combinations(corners, 2):
        changed = [p for p in annotation.polylines if p.class_name in {*at[one], *at[other]}]
        new = [_with_exchanged_points(p, one, other) for p in changed]
        saved = badness(changed) - badness(new)
        if saved > 0:
            tried.append((saved, at[one], at[other], new))
    before = _mean_capped_error(fit, len(doubted.names), frame)
    trial = doubted if fit.camera is not None else replace(doubted, model=AUTO)
    for _, *groups, new in sorted(tried, key=lambda t: -t[0])[:_MAX_EXCHANGES]:
        better = trial.fit(reduce(FrameAnnotation.with_polyline, new, annotation))
        after = _mean_capped_error(better, len(doubted.names), frame)
        if after * _MIRROR_FIT_RATIO > before or suspect_elements(better, frame):
            continue
        titles = [[translatable(field.title_of(name)) for name in group] for group in groups]
        fact = translatable(
            "two points are exchanged: the one of {some} and the one of {others}",
            some=translatable_all(titles[0]),
            others=translatable_all(titles[1]),
        )
        reason = translatable_joined("; ", (fact, _improvement(fit, before, after, frame)))
        names = tuple(dict.fromkeys(name for group in groups for name in group))
        return Finding(Rule.SWAPPED, Severity.ERROR, names, reason, (LOOK,), model=better.model)
    return None


def _with_exchanged_points(
    polyline: Polyline, one: tuple[float, float], other: tuple[float, float]
) -> Polyline:
    becomes = {one: other, other: one}
    places = [becomes.get((p.u, p.v), (p.u, p.v)) for p in polyline.points]
    return Polyline(polyline.class_name, tuple(Point(u, v) for u, v in places))


def _length_px(polyline: Polyline, frame: ImageFrame) -> float:
    return float(np.hypot(*np.diff(points_px(polyline, frame.size), axis=0).T).sum())


def _mirror_finding(doubted: SuspectFrame, fit: FitResult) -> Finding | None:
    field, frame = doubted.field, doubted.frame
    if not _is_poor(fit, frame):
        return None
    ways = [(names, signs) for signs in (MIRROR_Y, MIRROR_X)
            if (names := mirrored_names(field, signs, doubted.names)) is not None]  # fmt: skip
    if not ways:
        return None
    before = _mean_capped_error(fit, len(doubted.names), frame)
    better = doubted.fit(relabelled(doubted.annotation, ways[0][0]))
    after = _mean_capped_error(better, len(doubted.names), frame)
    if after * _MIRROR_FIT_RATIO > before or after > _MIRROR_MAX_PX:
        return None
    # Both reflections fit alike; the main camera stands on the near side.
    near = isinstance(better.camera, PosedCamera) and better.camera.position_world[1] > 0
    remedies = []
    for names, signs in ways:
        renamed = tuple((name, names[name]) for name in doubted.names if names[name] != name)
        remedies.append(Remedy(RemedyKind.RELABEL, MIRROR_REMEDY_TEXTS[signs], renamed))
    if not near:
        remedies.reverse()
        ways.reverse()
    off = _improvement(fit, before, after, frame)
    return Finding(
        Rule.REFLECTED,
        Severity.ERROR,
        doubted.names,
        translatable_joined(": ", (_MIRROR_FIT_REASONS[ways[0][1]], off)),
        tuple(remedies),
        model=doubted.model,
    )


def _improvement(
    fit: FitResult, before: float, after: float, frame: ImageFrame
) -> TranslatableText:
    after_px, before_px = in_image_px(after, frame), in_image_px(before, frame)
    if fit.camera is None:
        return translatable(
            "elements are {after:.1f} px off on average, no camera fits the labels as they are",
            after=after_px,
        )
    return translatable(
        "elements are {after:.1f} px off on average, {before:.1f} px as they are",
        after=after_px,
        before=before_px,
    )


def _mistake_findings(doubted: SuspectFrame, found: Explanation) -> Iterator[Finding]:
    severity = Severity.ERROR if found.right >= MIN_CORRECT else Severity.WARNING
    done: set[str] = set()
    for name in sorted(found.off_px, key=lambda name: -found.off_px[name]):
        if name in done:
            continue
        group = _label_cycle(name, found.names)
        done.update(group)
        if len(group) > 1:
            yield _swap_finding(doubted, found, group, severity)
        elif name in found.points:
            if not _is_on_next_element(doubted, found, name):
                yield _outlier_point_finding(doubted, found, name, severity)
        else:
            yield _misplaced_finding(doubted, found, name, severity)


def _is_on_next_element(doubted: SuspectFrame, found: Explanation, name: str) -> bool:
    """Return whether the one point that is off is in line with its others, and on an element that
    touches its own one: where one straight line leads into another nothing shows the joint."""
    polyline, frame = doubted.annotation.get(name), doubted.frame
    if polyline is None or len(polyline.points) < 3:
        return False
    others = touching_elements(doubted.field, name)
    near = distances_to_classes(polyline, others, doubted.field, frame, found.vector)
    off = np.abs(line_residuals(points_px(polyline, frame.size) * frame.scale)).max()
    on_other = any(px[found.points[name].index] <= CORRECT_PX for px in near.values())
    return on_other and bool(off <= STRAIGHT_TOLERANCE_PX)


def _label_cycle(name: str, names: Mapping[str, str]) -> tuple[str, ...]:
    """The classes that exchange their labels, beginning with this one; it alone if none do."""
    group = [name]
    while (following := names.get(group[-1])) is not None and following != name:
        if following in group or following not in names:
            return (name,)
        group.append(following)
    return tuple(group) if following == name else (name,)


def _swap_finding(
    doubted: SuspectFrame, found: Explanation, group: Sequence[str], severity: Severity
) -> Finding:
    title = {name: translatable(doubted.field.title_of(name)) for name in group}
    renames = tuple((name, found.names[name]) for name in group)
    off = max(_displayed_error_px(doubted, found, name) for name in group)
    if len(group) == 2:
        a, b = title.values()
        fact = translatable("{a} and {b} fit with each other's label", a=a, b=b)
        remedy = Remedy(RemedyKind.SWAP, translatable("swap {a} and {b}", a=a, b=b), renames)
    else:
        fact = translatable(
            "{titles} fit with each other's labels", titles=translatable_all([*title.values()])
        )
        steps = [translatable("{a} to {b}", "labels", a=title[a], b=title[b]) for a, b in renames]
        text = translatable("relabel {steps}", steps=translatable_joined(", ", steps))
        remedy = Remedy(RemedyKind.RELABEL, text, renames)
    return Finding(
        Rule.SWAPPED,
        severity,
        tuple(group),
        translatable_joined("; ", (fact, *_leave_one_out_sentence(doubted, found))),
        (remedy, LOOK),
        error_px=off,
        model=doubted.model,
    )


def _outlier_point_finding(
    doubted: SuspectFrame, found: Explanation, name: str, severity: Severity
) -> Finding:
    bad = found.points[name]
    if bad.off_px <= max(_usual_error_limit(found), _USUAL_ERROR_RATIO * bad.rest_px):
        severity = Severity.WARNING
    polyline = doubted.annotation.get(name)
    return outlier_point_finding(
        name,
        doubted.field.title_of(name),
        bad.index,
        0 if polyline is None else len(polyline.points),
        in_image_px(bad.off_px, doubted.frame),
        in_image_px(bad.rest_px, doubted.frame),
        severity,
        doubted.model,
    )


def _misplaced_finding(
    doubted: SuspectFrame, found: Explanation, name: str, severity: Severity
) -> Finding:
    field, title = doubted.field, translatable(doubted.field.title_of(name))
    off = _displayed_error_px(doubted, found, name)
    if name not in found.names and found.off_px[name] <= max(OUTLIER_PX, _usual_error_limit(found)):
        severity = Severity.WARNING  # the label may be right and the clicks bad
    fact = (
        translatable(
            "{title} is up to {px:.0f} px from where the camera of the others shows it",
            title=title,
            px=off,
        )
        if off < doubted.frame.size[0]
        else translatable(
            "{title} is nowhere near where the camera of the others shows it", title=title
        )
    )
    if name in landmark_covariances(field):
        fact = translatable_joined(
            ", ", (fact, translatable("more than its own place is uncertain"))
        )
    facts, remedies = [fact], list[Remedy]()
    if (becomes := found.names.get(name)) is not None:
        meant = translatable(field.title_of(becomes))
        facts.append(translatable("it lies where {title} should be", title=meant))
        free = [becomes, *(p.class_name for p in found.places.get(name, ()))]
        taken = {*doubted.names, *found.names.values()} - {becomes}
        for other in dict.fromkeys(free):
            if other not in taken or other == becomes:
                renames = ((name, other),)
                text = translatable("relabel to {title}", title=translatable(field.title_of(other)))
                remedies.append(Remedy(RemedyKind.RELABEL, text, renames))
    else:
        twin = next((p.class_name for p in found.places.get(name, ())), None)
        if twin is not None and twin != name:
            lies_on = translatable(field.title_of(twin))
            facts.append(
                translatable("it lies on {title}, which is annotated as well", title=lies_on)
            )
    return Finding(
        Rule.RESIDUAL,
        severity,
        (name,),
        translatable_joined("; ", (*facts, *_leave_one_out_sentence(doubted, found))),
        (*remedies, LOOK),
        error_px=off,
        model=doubted.model,
    )


def _displayed_error_px(doubted: SuspectFrame, found: Explanation, name: str) -> float:
    """Return how far off an element is in the picture, px of it, however much of that counts."""
    polyline = doubted.annotation.get(name)
    assert polyline is not None  # it was found to be off
    distances = distances_to_classes(polyline, [name], doubted.field, doubted.frame, found.vector)
    return in_image_px(float(distances[name].max()), doubted.frame)


def _leave_one_out_sentence(
    doubted: SuspectFrame, found: Explanation
) -> tuple[TranslatableText, ...]:
    """The leave-one-out sentence, for all mistakes of the frame together."""
    wrong = tuple(found.off_px)
    means = leave_one_out_errors(
        doubted.annotation, wrong, doubted.field, doubted.frame, found.vector, doubted.model
    )
    if means is None:
        return ()
    titles = [translatable(doubted.field.title_of(name)) for name in wrong]
    before, after = (in_image_px(mean, doubted.frame) for mean in means)
    if before - after < _MIN_REPORTED_PX:
        return (translatable("the others are {px:.1f} px off with and without it", px=after),)
    return (
        translatable(
            "without {titles} the others drop from {before:.1f} to {after:.1f} px",
            titles=translatable_all(titles),
            before=before,
            after=after,
        ),
    )


def _usual_error_limit(found: Explanation) -> float:
    """Return how far off a point may be where the right elements lie as far off as they do, solver
    px."""
    return _USUAL_ERROR_RATIO * found.correct_px


def _contradiction_finding(
    doubted: SuspectFrame, fit: FitResult, suspects: Collection[str]
) -> tuple[Finding, ...]:
    """The labels contradict each other, and too few are right to say which are wrong."""
    if fit.camera is None:
        return (
            Finding(
                Rule.RESIDUAL,
                Severity.WARNING,
                doubted.names,
                fit.failure or translatable("no camera fits these labels together"),
                (LOOK,),
                model=doubted.model,
            ),
        )
    return tuple(
        Finding(
            Rule.RESIDUAL,
            Severity.WARNING,
            (element.name,),
            translatable(
                "{title} is up to {px:.0f} px from where the camera shows it; too few elements fit"
                " to say which are wrong",
                title=translatable(doubted.field.title_of(element.name)),
                px=element.max_px,
            ),
            (LOOK,),
            error_px=element.max_px,
            model=doubted.model,
        )
        for element in fit.elements
        if element.name in suspects
    )
