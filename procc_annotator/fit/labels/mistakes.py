"""What the fitted camera says about the labels, as findings."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.landmarks import known_covariances
from procc_annotator.fit.labels.clicked import ClickedFrame, in_picture, limit_of, off_px
from procc_annotator.fit.labels.explanation import ENOUGH_RIGHT, DoubtedFrame, Explanation, explain
from procc_annotator.fit.labels.finding import (
    LOOK,
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
)
from procc_annotator.fit.labels.orientation import ACROSS, ALONG, reflected_names, renamed
from procc_annotator.fit.labels.relabelling import distances_to_classes, others_with_and_without
from procc_annotator.fit.result import FitResult, PosedCamera
from procc_annotator.fit.solving.models import STRONG
from procc_annotator.fit.solving.observations import PictureFrame, observe
from procc_annotator.fit.solving.plausible import missing
from procc_annotator.fit.solving.search import MINIMUM_ELEMENTS, OUTLIER_PX
from procc_annotator.words import all_of

# A whole frame is called reflected if its reflection fits at least so many times as well.
_TIMES_AS_WELL = 2.0
_REFLECTION_FITS_PX = 6.0
# An element counts at most this in the comparison of two labellings.
_MOST_PX = 30.0
# Only a fit this bad makes it worth while to look.
_BAD_MEDIAN_PX = 4.0
_BAD_ELEMENTS = 2
_NOTICEABLE_PX = 0.1
# Carelessly clicked frames have points so many times as far off as elements usually are.
_TIMES_USUAL = 3.0


def suspects_of(fit: FitResult, frame: PictureFrame) -> tuple[str, ...]:
    """The elements that are farther off than the limit, in the order of the fit."""
    limit = limit_of(fit, frame)
    return tuple(e.name for e in fit.elements if off_px(e, frame) > limit)


def camera_findings(looked_at: ClickedFrame, known: Sequence[Finding]) -> tuple[Finding, ...]:
    """What does not fit the camera of the other elements, explained; costs several fits. Nothing
    where all of it fits."""
    fit, frame = looked_at.fit, looked_at.frame
    if len(looked_at.clicked) < MINIMUM_ELEMENTS:
        return ()
    if fit.camera is not None and not suspects_of(fit, frame):
        return ()
    # A model without distortion leaves lines off that are right; so does one of the ground alone.
    model = fit.model if fit.model in ("R+", *STRONG) else "R"
    polylines = looked_at.annotation.polylines
    doubted = DoubtedFrame(
        FrameAnnotation(polylines), looked_at.field, frame, model, go_on=looked_at.go_on
    )
    if len(doubted.names) < MINIMUM_ELEMENTS or (fit.camera is None and _too_little(doubted)):
        return ()
    if fit.model != model:
        fit = doubted.fit(doubted.annotation, fit.camera)
    suspects = suspects_of(fit, frame)
    if fit.camera is not None and not suspects:
        return ()
    reversed_frame = _reflected(doubted, fit)
    if reversed_frame is not None:
        return (reversed_frame,)
    found = explain(replace(doubted, limit_px=limit_of(fit, frame)), fit, suspects)
    if found is None:
        return _unexplained(doubted, fit, suspects)
    return tuple(_findings(doubted, found))


def _too_little(doubted: DoubtedFrame) -> bool:
    """Whether there is no camera because there are too few clicks: nothing is wrong with those."""
    seen = observe(doubted.annotation, doubted.field, doubted.frame)
    return missing(seen, needed=MINIMUM_ELEMENTS, planar=False) is not None


def _badness(fit: FitResult, count: int, frame: PictureFrame) -> float:
    """Mean of the elements' largest distances, solver px, none counting more than a mistake."""
    if fit.camera is None or not fit.elements:
        return _MOST_PX
    worst = [min(off_px(e, frame), _MOST_PX) for e in fit.elements]
    return float(sum(worst) + _MOST_PX * max(count - len(worst), 0)) / max(count, len(worst))


def _reflected(doubted: DoubtedFrame, fit: FitResult) -> Finding | None:
    field, frame = doubted.field, doubted.frame
    if fit.camera is not None:
        worst = [off_px(e, frame) for e in fit.elements]
        if np.median(worst) < _BAD_MEDIAN_PX and len(suspects_of(fit, frame)) < _BAD_ELEMENTS:
            return None
    ways = [(names, signs) for signs in (ACROSS, ALONG)
            if (names := reflected_names(field, signs, doubted.names)) is not None]  # fmt: skip
    if not ways:
        return None
    before = _badness(fit, len(doubted.names), frame)
    better = doubted.fit(renamed(doubted.annotation, ways[0][0]))
    after = _badness(better, len(doubted.names), frame)
    if after * _TIMES_AS_WELL > before or after > _REFLECTION_FITS_PX:
        return None
    # Both reflections fit alike; the main camera stands on the near side.
    near = isinstance(better.camera, PosedCamera) and better.camera.position_world[1] > 0
    words = {ACROSS: "far and near", ALONG: "left and right"}
    remedies = [
        Remedy(
            RemedyKind.RELABEL,
            f"exchange {words[signs]} in the whole frame",
            _pairs(doubted.names, names),
        )
        for names, signs in ways
    ]
    if not near:
        remedies.reverse()
        ways.reverse()
    old = "no camera fits the labels as they are" if fit.camera is None else (
        f"{in_picture(before, frame):.1f} px as they are"
    )  # fmt: skip
    return Finding(
        Rule.REFLECTED,
        Severity.ERROR,
        doubted.names,
        f"all labels fit with {words[ways[0][1]]} exchanged: elements are"
        f" {in_picture(after, frame):.1f} px off on average, {old}",
        tuple(remedies),
        model=doubted.model,
    )


def _pairs(names: Collection[str], becomes: Mapping[str, str]) -> tuple[tuple[str, str], ...]:
    return tuple((name, becomes[name]) for name in names if becomes[name] != name)


def _findings(doubted: DoubtedFrame, found: Explanation) -> Iterator[Finding]:
    severity = Severity.ERROR if found.right >= ENOUGH_RIGHT else Severity.WARNING
    done: set[str] = set()
    for name in sorted(found.off_px, key=lambda name: -found.off_px[name]):
        if name in done:
            continue
        group = _cycle(name, found.names)
        done.update(group)
        if len(group) > 1:
            yield _exchanged(doubted, found, group, severity)
        elif name in found.points:
            yield _point(doubted, found, name, severity)
        else:
            yield _misplaced(doubted, found, name, severity)


def _cycle(name: str, names: Mapping[str, str]) -> tuple[str, ...]:
    """The classes that exchange their labels, beginning with this one; it alone if none do."""
    group = [name]
    while (following := names.get(group[-1])) is not None and following != name:
        if following in group or following not in names:
            return (name,)
        group.append(following)
    return tuple(group) if following == name else (name,)


def _exchanged(
    doubted: DoubtedFrame, found: Explanation, group: Sequence[str], severity: Severity
) -> Finding:
    titles = [doubted.field.title_of(name) for name in group]
    renames = tuple((name, found.names[name]) for name in group)
    off = max(_shown_px(doubted, found, name) for name in group)
    if len(group) == 2:
        fact = f"{titles[0]} and {titles[1]} fit with each other's label"
        remedy = Remedy(RemedyKind.SWAP, f"swap {titles[0]} and {titles[1]}", renames)
    else:
        fact = f"{all_of(titles)} fit with each other's labels"
        steps = ", ".join(f"{doubted.field.title_of(a)} to {doubted.field.title_of(b)}"
                          for a, b in renames)  # fmt: skip
        remedy = Remedy(RemedyKind.RELABEL, f"relabel {steps}", renames)
    return Finding(
        Rule.SWAPPED,
        severity,
        tuple(group),
        fact + _others(doubted, found),
        (remedy, LOOK),
        error_px=off,
        model=doubted.model,
    )


def _point(doubted: DoubtedFrame, found: Explanation, name: str, severity: Severity) -> Finding:
    bad = found.points[name]
    if bad.off_px <= max(_usual(found), _TIMES_USUAL * bad.rest_px):
        severity = Severity.WARNING
    title, number = doubted.field.title_of(name), bad.index + 1
    polyline = doubted.annotation.get(name)
    count = 0 if polyline is None else len(polyline.points)
    remedies: tuple[Remedy, ...] = (Remedy(RemedyKind.LOOK, f"look at point {number}"),)
    if count > 2:
        remedies = (Remedy(RemedyKind.REMOVE_POINT, f"remove point {number}"), *remedies)
    off = in_picture(bad.off_px, doubted.frame)
    rest = in_picture(bad.rest_px, doubted.frame)
    other = "its other point" if count == 2 else "its other points"
    return Finding(
        Rule.POINT,
        severity,
        (name,),
        f"point {number} of {title} is {off:.0f} px off, {other} at most {rest:.1f} px",
        remedies,
        point=bad.index,
        error_px=off,
        model=doubted.model,
    )


def _misplaced(doubted: DoubtedFrame, found: Explanation, name: str, severity: Severity) -> Finding:
    field, title = doubted.field, doubted.field.title_of(name)
    off = _shown_px(doubted, found, name)
    if name not in found.names and found.off_px[name] <= max(OUTLIER_PX, _usual(found)):
        severity = Severity.WARNING  # the label may be right and the clicks bad
    fact = f"{title} is {_up_to(off, doubted.frame)} where the camera of the others shows it"
    if name in known_covariances(field):
        fact += ", more than its own place is uncertain"
    becomes = found.names.get(name)
    remedies: list[Remedy] = []
    if becomes is not None:
        fact += f"; it lies where {field.title_of(becomes)} should be"
        free = [becomes, *(p.class_name for p in found.places.get(name, ()))]
        taken = {*doubted.names, *found.names.values()} - {becomes}
        for other in dict.fromkeys(free):
            if other not in taken or other == becomes:
                renames = ((name, other),)
                remedies.append(
                    Remedy(RemedyKind.RELABEL, f"relabel to {field.title_of(other)}", renames)
                )
    else:
        twin = next((p.class_name for p in found.places.get(name, ())), None)
        if twin is not None and twin != name:
            fact += f"; it lies on {field.title_of(twin)}, which is annotated as well"
    return Finding(
        Rule.RESIDUAL,
        severity,
        (name,),
        fact + _others(doubted, found),
        (*remedies, LOOK),
        error_px=off,
        model=doubted.model,
    )


def _shown_px(doubted: DoubtedFrame, found: Explanation, name: str) -> float:
    """How far off an element is in the picture, px of it, however much of that counts."""
    polyline = doubted.annotation.get(name)
    assert polyline is not None  # it was found to be off
    distances = distances_to_classes(polyline, [name], doubted.field, doubted.frame, found.vector)
    return in_picture(float(distances[name].max()), doubted.frame)


def _others(doubted: DoubtedFrame, found: Explanation) -> str:
    """The leave-one-out sentence, for all mistakes of the frame together."""
    wrong = tuple(found.off_px)
    means = others_with_and_without(
        doubted.annotation, wrong, doubted.field, doubted.frame, found.vector, doubted.model
    )
    if means is None:
        return ""
    titles = [doubted.field.title_of(name) for name in wrong]
    before, after = (in_picture(mean, doubted.frame) for mean in means)
    if before - after < _NOTICEABLE_PX:
        return f"; the others are {after:.1f} px off with and without it"
    return f"; without {all_of(titles)} the others drop from {before:.1f} to {after:.1f} px"


def _usual(found: Explanation) -> float:
    """How far off a point may be where the right elements lie as far off as they do, solver px."""
    return _TIMES_USUAL * found.right_px


def _up_to(off_px: float, frame: PictureFrame) -> str:
    return f"up to {off_px:.0f} px from" if off_px < frame.size[0] else "nowhere near"


def _unexplained(
    doubted: DoubtedFrame, fit: FitResult, suspects: Collection[str]
) -> tuple[Finding, ...]:
    """The labels contradict each other, and too few are right to say which are wrong."""
    if fit.camera is None:
        return (
            Finding(
                Rule.RESIDUAL,
                Severity.WARNING,
                doubted.names,
                f"{fit.failure or 'no camera fits these labels together'}",
                (LOOK,),
                model=doubted.model,
            ),
        )
    return tuple(
        Finding(
            Rule.RESIDUAL,
            Severity.WARNING,
            (element.name,),
            f"{doubted.field.title_of(element.name)} is up to {element.max_px:.0f} px from where"
            " the camera shows it; too few elements fit to say which are wrong",
            (LOOK,),
            error_px=element.max_px,
            model=doubted.model,
        )
        for element in fit.elements
        if element.name in suspects
    )
